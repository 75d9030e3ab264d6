// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer_job.h"

#include "parameter_bridge.h"
#include "refusal.h"

namespace gpr_filter {

namespace {

/// Whatever belongs to the old vertices and faces and is not carried over.
constexpr int kStaleMask =
	MeshModel::MM_VERTMARK | MeshModel::MM_VERTFACETOPO | MeshModel::MM_VERTCURV |
	MeshModel::MM_VERTCURVDIR | MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTTEXCOORD |
	MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY | MeshModel::MM_FACEMARK |
	MeshModel::MM_FACEFACETOPO | MeshModel::MM_FACECURVDIR | MeshModel::MM_WEDGTEXCOORD |
	MeshModel::MM_WEDGNORMAL | MeshModel::MM_WEDGCOLOR | MeshModel::MM_VERTFLAGSELECT |
	MeshModel::MM_FACEFLAGSELECT | MeshModel::MM_POLYGONAL;

constexpr int kCarriedMask = MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY;

/// Where samples most likely are: the newest other layer of points, or else the newest other one.
int likelySampleLayer(const MeshDocument& document)
{
	int likely = -1;
	for (const MeshModel* layer : layersOf(document)) {
		if (layer == document.mm()) continue;
		const bool pointsKnown = likely >= 0 && document.getMesh(likely)->cm.fn == 0;
		if (layer->cm.fn == 0 || !pointsKnown) likely = layer->id();
	}
	return likely;
}

bool asksForQuality(const gpr::RemeshOptions& options)
{
	return options.lambda > 0 && options.sizing == gpr::SizingSource::Quality;
}

bool asksForSelection(const gpr::RemeshOptions& options)
{
	return options.featureRegion == gpr::FeatureRegion::Selection;
}

gpr::ParameterSet readValues(gpr::Tool tool, const RichParameterList& list,
							 const MeshDocument& document)
{
	const ReadParameters read = readParameterList(gpr::parametersOf(tool), factsOf(document), list);
	if (!read.complaints.empty()) throw Refusal(read.complaints);
	return read.values;
}

LayerCopy copyOf(const MeshModel& layer, const gpr::RemeshOptions& options)
{
	CopiedParts parts;
	parts.colour    = layer.hasDataMask(MeshModel::MM_VERTCOLOR);
	parts.quality   = layer.hasDataMask(MeshModel::MM_VERTQUALITY);
	parts.selection = asksForSelection(options);
	if (asksForQuality(options) && !parts.quality) {
		throw Refusal("The density shall go with the vertex quality, but the layer has none.");
	}
	LayerCopy copy = copyLayer(layer.cm, parts);
	if (parts.selection && !copy.anySelected()) {
		throw Refusal("The feature region shall be the selection, but nothing is selected.");
	}
	return copy;
}

/// "bunny.ply" gives "bunny": the layer list shows a label up to its first dot only.
QString baseLabel(const MeshModel& layer)
{
	const QString base = layer.label().section('.', 0, 0);
	return base.isEmpty() ? QStringLiteral("layer") : base;
}

/// "0 (bunny)", as the layer list has number and name.
QString numberAndLabel(const MeshModel& layer)
{
	return QStringLiteral("%1 (%2)").arg(layer.id()).arg(baseLabel(layer));
}

[[noreturn]] void refuseMissing(std::int64_t number, const MeshDocument& document)
{
	QStringList layers;
	for (const MeshModel* layer : layersOf(document)) {
		layers << numberAndLabel(*layer);
	}
	throw Refusal(
		QStringLiteral("There is no layer number %1 to take samples from. Layers are: %2.")
			.arg(number)
			.arg(layers.join(", "))
			.toStdString());
}

/// A sentence about what a layer has and the result has not; empty where nothing was lost.
std::string lossesOf(const MeshModel& layer)
{
	QStringList lost;
	if (layer.dataMask() & (MeshModel::MM_VERTTEXCOORD | MeshModel::MM_WEDGTEXCOORD)) {
		lost << "texture coordinates";
	}
	if (layer.hasDataMask(MeshModel::MM_FACECOLOR)) lost << "face colour";
	if (layer.hasDataMask(MeshModel::MM_FACEQUALITY)) lost << "face quality";
	if (layer.hasDataMask(MeshModel::MM_VERTRADIUS)) lost << "vertex radius";
	if (layer.hasDataMask(MeshModel::MM_POLYGONAL)) lost << "polygons";
	if (lost.isEmpty()) return std::string();
	return ("Not carried over to the result: " + lost.join(", ") + ".").toStdString();
}

void fill(MeshModel& layer, CMeshO& built)
{
	layer.clearDataMask(kStaleMask);
	dropTextures(layer);
	replaceContents(layer.cm, built);
	updateBoxAndNormals(layer);
}

} // namespace

gpr::MeshFacts factsOf(const MeshDocument& document)
{
	gpr::MeshFacts   facts;
	const MeshModel* layer = document.mm();
	if (layer != nullptr) {
		const CMeshO& mesh = layer->cm;
		facts.vertexNum    = mesh.vn;
		facts.diagonal     = mesh.bbox.IsNull() ? 0.0 : double(mesh.bbox.Diag());
	}
	const int samples = likelySampleLayer(document);
	if (samples >= 0) facts.sampleLayer = samples;
	return facts;
}

LayerJob::LayerJob(MeshDocument& document, gpr::Tool tool, const RichParameterList& list) :
		_document(document), _layerId(-1)
{
	const MeshModel* const current = document.mm();
	if (current == nullptr) throw Refusal("There is no layer.");
	_layerId = current->id();
	_values  = readValues(tool, list, document);
	_options = _values.options();
	_copy    = copyOf(*current, _options);
}

const MeshModel& LayerJob::sampleModel() const
{
	const std::int64_t     number = _values.sampleLayer();
	const MeshModel* const model  = _document.getMesh(int(number));
	if (model == nullptr) refuseMissing(number, _document);
	const std::string named = "Layer " + numberAndLabel(*model).toStdString();
	if (model->id() == _layerId) {
		throw Refusal(named + " is the surface itself; give the number of the layer with the "
							  "samples, and make the surface the current layer.");
	}
	if (model->cm.vn == 0) throw Refusal(named + " has no vertices to take as samples.");
	return *model;
}

std::vector<gpr::Vec3d> LayerJob::samples() const
{
	const MeshModel& model = sampleModel();
	const Matrix44m& frame = _document.getMesh(_layerId)->cm.Tr;
	if (!canReach(frame, model.cm.Tr)) {
		throw Refusal("The transform of a layer has no inverse, so the samples cannot be brought "
					  "into the frame of the surface.");
	}
	return copyPoints(model.cm, frame);
}

MeshModel& LayerJob::layer() const
{
	MeshModel* const layer = _document.getMesh(_layerId);
	if (layer == nullptr || !copyLayer(layer->cm, CopiedParts()).sameGeometry(_copy)) {
		throw Refusal("The layer was changed or removed while the filter was running.");
	}
	return *layer;
}

MeshModel& LayerJob::addLayer(const MeshModel& source, int mask, const char* suffix) const
{
	const Matrix44m transform = source.cm.Tr;
	MeshModel&      added     = *_document.addNewMesh(QString(), baseLabel(source) + suffix, true);
	added.cm.Tr               = transform;
	added.updateDataMask(mask);
	return added;
}

std::string LayerJob::put(CMeshO& built, const char* suffix) const
{
	MeshModel&  source = layer();
	std::string losses = lossesOf(source);
	MeshModel&  target =
        _values.newLayer() ? addLayer(source, source.dataMask() & kCarriedMask, suffix) : source;
	fill(target, built);
	return losses;
}

void LayerJob::mark(const gpr::FeatureResult& result) const
{
	MeshModel& target = layer();
	target.updateDataMask(MeshModel::MM_VERTQUALITY);
	markFeatures(result, target.cm);
}

void LayerJob::putPoints(CMeshO& built, const char* suffix) const
{
	const MeshModel& source = layer();
	const int        colour = source.dataMask() & MeshModel::MM_VERTCOLOR;
	fill(addLayer(source, MeshModel::MM_VERTQUALITY | colour, suffix), built);
}

} // namespace gpr_filter
