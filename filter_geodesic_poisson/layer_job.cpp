// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "layer_job.h"

#include "parameter_bridge.h"
#include "refusal.h"

#include <algorithm>

namespace gpr_filter {

namespace {

/// Attributes that are carried over.
constexpr int kCarriedVertexMask = MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY |
								   MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTTEXCOORD;
constexpr int kCarriedFaceMask =
	MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY | MeshModel::MM_WEDGTEXCOORD;

/// Whatever belongs to the old vertices and faces and is not.
constexpr int kStaleMask =
	MeshModel::MM_VERTMARK | MeshModel::MM_VERTFACETOPO | MeshModel::MM_VERTCURV |
	MeshModel::MM_VERTCURVDIR | MeshModel::MM_FACEMARK | MeshModel::MM_FACEFACETOPO |
	MeshModel::MM_FACECURVDIR | MeshModel::MM_WEDGNORMAL | MeshModel::MM_WEDGCOLOR |
	MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT | MeshModel::MM_POLYGONAL;

constexpr int kTextureMask = MeshModel::MM_VERTTEXCOORD | MeshModel::MM_WEDGTEXCOORD;

/// The most likely layer of the samples: the newest other layer of points, or else the newest other
/// layer.
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

ReadParameters readValues(Filter filter, const RichParameterList& list,
						  const MeshDocument& document)
{
	ReadParameters read =
		readParameterList(rowsOf(filter), factsOf(document), list, proposedFor(document));
	if (!read.complaints.empty()) throw Refusal(read.complaints);
	return read;
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

/// A sentence about attributes of a layer that the result lacks; empty without losses.
std::string lossesOf(const MeshModel& layer, std::vector<std::string> lost)
{
	if (layer.dataMask() & (MeshModel::MM_VERTCURV | MeshModel::MM_VERTCURVDIR)) {
		lost.push_back("curvature");
	}
	if (layer.hasDataMask(MeshModel::MM_POLYGONAL)) lost.push_back("polygons");
	return vcg::tri::gpr_detail::SentenceOfLost(lost);
}

std::string warningAbout(const Matrix44m& transform)
{
	if (!scalesUnevenly(transform)) return std::string();
	return "The layer's transform scales unevenly: the triangles are regular in the coordinates of "
		   "the layer, but not on the screen. \"Matrix: Freeze Current Matrix\" before this filter "
		   "makes the triangles on the screen regular.";
}

/// carried: the attributes that `built` has.
void fill(MeshModel& layer, CMeshO& built, int carried)
{
	layer.clearDataMask(kStaleMask | ((kCarriedVertexMask | kCarriedFaceMask) & ~carried));
	if ((carried & kTextureMask) == 0) dropTextures(layer);
	replaceContents(layer.cm, built);
	updateBoxAndNormals(layer);
}

bool anyVertexSelected(const CMeshO& mesh)
{
	return std::any_of(mesh.vert.begin(), mesh.vert.end(),
					   [](const CVertexO& v) { return !v.IsD() && v.IsS(); });
}

bool anyFaceSelected(const CMeshO& mesh)
{
	return std::any_of(mesh.face.begin(), mesh.face.end(),
					   [](const CFaceO& f) { return !f.IsD() && f.IsS(); });
}

} // namespace

gpr::MeshFacts factsOf(const MeshDocument& document)
{
	gpr::MeshFacts   facts;
	const MeshModel* layer = document.mm();
	if (layer != nullptr) {
		const CMeshO& mesh        = layer->cm;
		facts.vertexNum           = mesh.vn;
		facts.diagonal            = mesh.bbox.IsNull() ? 0.0 : double(mesh.bbox.Diag());
		facts.hasSelectedVertices = anyVertexSelected(mesh);
	}
	return facts;
}

GivenValues proposedFor(const MeshDocument& document)
{
	const int samples = likelySampleLayer(document);
	if (samples < 0) return {};
	return {{"SampleLayer", std::int64_t(samples)}};
}

gpr::RemeshOptions optionsFor(const ReadParameters& read, Filter filter, const MeshModel& layer)
{
	gpr::RemeshOptions options = read.values.options();
	options.period             = {read.own<double>("PeriodX"), read.own<double>("PeriodY"),
								  read.own<double>("PeriodZ")};
	if (QualitySizes(read.own<std::int64_t>("QualitySizes")) == QualitySizes::Exact) {
		// The number of vertices always has a value, so only another size is a second choice.
		if (options.targetMode != gpr::TargetMode::VertexNum)
			throw Refusal("Give either exact sizes from the vertex quality or another size, not "
						  "both.");
		options.targetMode = gpr::TargetMode::Sizes;
	}
	const bool makesFaces = filter == RemeshFilter || filter == RetriangulateFilter;
	options.surfacePointsOfFaces =
		makesFaces && ((layer.dataMask() & kCarriedFaceMask) != 0 || !layer.cm.face_attr.empty());
	return options;
}

LayerCopy copyFor(const MeshModel& layer, const ReadParameters& read,
				  const gpr::RemeshOptions& options)
{
	CopiedParts parts;
	parts.selection     = gpr::mayUseSelectedVertices(options);
	parts.facesCorners  = options.featureRegion == gpr::FeatureRegion::Selection;
	parts.faceSelection = options.selectedOnly;
	parts.edgeSelection = options.featureMode == gpr::FeatureMode::Given;
	parts.texture  = options.surfacePointsOfFaces && layer.hasDataMask(MeshModel::MM_WEDGTEXCOORD);
	LayerCopy copy = copyLayer(layer.cm, parts);
	copy.regions   = regionsOf(layer, RegionSource(read.own<std::int64_t>("Regions")));
	if (QualitySizes(read.own<std::int64_t>("QualitySizes")) != QualitySizes::Nothing)
		copy.sizes = wantedSizesOf(layer);
	if (parts.facesCorners && !copy.view().anySelected()) {
		throw Refusal("The feature region is the selection, but nothing is selected.");
	}
	if (parts.edgeSelection && copy.selectedEdges.empty()) {
		throw Refusal("The feature lines are the selected edges, but no edge is selected.");
	}
	if (parts.faceSelection && !copy.anyFaceSelected()) {
		throw Refusal("Cannot apply only on selection: no face is selected.");
	}
	return copy;
}

LayerJob::LayerJob(MeshDocument& document, Filter filter, const RichParameterList& list) :
		_document(document), _layerId(-1)
{
	const MeshModel* const current = document.mm();
	if (current == nullptr) throw Refusal("There is no layer.");
	_layerId         = current->id();
	_read            = readValues(filter, list, document);
	_options         = optionsFor(_read, filter, *current);
	_anyFaceSelected = anyFaceSelected(current->cm);
	_copy            = copyFor(*current, _read, _options);
}

const MeshModel& LayerJob::sampleModel() const
{
	const std::int64_t     number = _read.own<std::int64_t>("SampleLayer");
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

const MeshModel& LayerJob::reachableSampleModel() const
{
	const MeshModel& model = sampleModel();
	if (!canReach(_document.getMesh(_layerId)->cm.Tr, model.cm.Tr)) {
		throw Refusal("The transform of a layer has no inverse, so the samples cannot be brought "
					  "into the frame of the surface.");
	}
	return model;
}

std::vector<gpr::Vec3d> LayerJob::samples() const
{
	return copyPoints(reachableSampleModel().cm, _document.getMesh(_layerId)->cm.Tr);
}

std::int64_t LayerJob::sampleNum() const
{
	return reachableSampleModel().cm.vn;
}

MeshModel& LayerJob::layer() const
{
	MeshModel* const layer = _document.getMesh(_layerId);
	if (layer == nullptr || !copyLayer(layer->cm, CopiedParts()).sameGeometry(_copy)) {
		throw Refusal("The layer was changed or removed while the filter was running.");
	}
	return *layer;
}

std::string LayerJob::sentenceOfSelectedFaces() const
{
	if (_options.selectedOnly || !_anyFaceSelected) return std::string();
	return "Faces are selected, but the whole layer was remeshed. \"Only the selected faces\" "
		   "remeshes the selected faces only.";
}

MeshModel& LayerJob::addLayer(const MeshModel& source, int mask, const char* suffix,
							  bool makeCurrent) const
{
	const Matrix44m transform = source.cm.Tr;
	MeshModel& added = *_document.addNewMesh(QString(), baseLabel(source) + suffix, makeCurrent);
	added.cm.Tr      = transform;
	added.updateDataMask(mask);
	return added;
}

std::vector<std::string> LayerJob::put(const gpr::RemeshResult& result, const char* suffix) const
{
	MeshModel&     source = layer();
	CMeshO         built;
	UserAttributes user;
	buildMesh(result, _copy, source.cm, built, user);
	std::vector<std::string> sentences = {lossesOf(source, user.Lost()),
										  warningAbout(source.cm.Tr)};
	int                      carried   = source.dataMask() & kCarriedVertexMask;
	if (built.face.IsColorEnabled()) carried |= MeshModel::MM_FACECOLOR;
	if (built.face.IsQualityEnabled()) carried |= MeshModel::MM_FACEQUALITY;
	if (built.face.IsWedgeTexCoordEnabled()) carried |= MeshModel::MM_WEDGTEXCOORD;

	MeshModel& target = _read.own<bool>("NewLayer") ? addLayer(source, carried, suffix) : source;
	if (&target != &source && (carried & kTextureMask) != 0) copyTextures(source, target);
	fill(target, built, carried);
	user.Write(target.cm);
	return sentences;
}

void LayerJob::mark(const gpr::FeatureResult& result) const
{
	MeshModel& target = layer();
	target.updateDataMask(MeshModel::MM_VERTQUALITY);
	markFeatures(result, target.cm);
}

void LayerJob::putPoints(const gpr::SamplingResult& result, const char* suffix) const
{
	const MeshModel& source = layer();
	CMeshO           built;
	buildPoints(result, _copy, source.cm, built);
	const int carried = MeshModel::MM_VERTQUALITY | (source.dataMask() & MeshModel::MM_VERTCOLOR);
	fill(addLayer(source, carried, suffix), built, carried);
}

/// place: the distance from the input in widths of the input, for results moved apart.
void LayerJob::addCompared(const MeshModel& source, const ComparedResult& result,
						   const char* suffix, int place, double largestDeviation) const
{
	const auto by = ComparedBy(_read.own<std::int64_t>("ColorBy"));
	CMeshO     built;
	buildPlain(result.mesh, built);
	int mask = 0;
	if (by != ComparedBy::Nothing) {
		mask = MeshModel::MM_FACEQUALITY | MeshModel::MM_FACECOLOR;
		built.face.EnableQuality();
		built.face.EnableColor();
	}
	if (by == ComparedBy::Quality) colourFaces(result.shape, 0, 1, built);
	if (by == ComparedBy::Distance) {
		colourFaces(result.deviation, largestDeviation, 0, built);
	}
	const Matrix44m beside =
		_read.own<bool>("SideBySide") ? movedAside(source.cm, place) : Matrix44m(source.cm.Tr);
	MeshModel& added = addLayer(source, mask, suffix, place == 1);
	fill(added, built, mask);
	added.cm.Tr = beside;
}

void LayerJob::putCompared(const Comparison& comparison) const
{
	const MeshModel& source  = layer();
	double           largest = 0;
	for (const ComparedResult* result : {&comparison.remeshed, &comparison.collapsed}) {
		for (const float deviation : result->deviation)
			largest = std::max(largest, double(deviation));
	}
	addCompared(source, comparison.remeshed, "_geodesic_poisson", 1, largest);
	addCompared(source, comparison.collapsed, "_quadric_collapse", 2, largest);
}

} // namespace gpr_filter
