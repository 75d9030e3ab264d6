// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_geodesic_poisson.h"

#include "filter_text.h"
#include "mesh_bridge.h"
#include "parameter_bridge.h"
#include "run_report.h"

#include <exception>
#include <new>
#include <vcg_extras/core/parameters.h>
#include <vcg_extras/core/remesh.h>

namespace {

/// Whatever belongs to the old vertices and faces and is not carried over.
constexpr int kStaleMask =
	MeshModel::MM_VERTMARK | MeshModel::MM_VERTFACETOPO | MeshModel::MM_VERTCURV |
	MeshModel::MM_VERTCURVDIR | MeshModel::MM_VERTRADIUS | MeshModel::MM_VERTTEXCOORD |
	MeshModel::MM_FACECOLOR | MeshModel::MM_FACEQUALITY | MeshModel::MM_FACEMARK |
	MeshModel::MM_FACEFACETOPO | MeshModel::MM_FACECURVDIR | MeshModel::MM_WEDGTEXCOORD |
	MeshModel::MM_WEDGNORMAL | MeshModel::MM_WEDGCOLOR | MeshModel::MM_VERTFLAGSELECT |
	MeshModel::MM_FACEFLAGSELECT | MeshModel::MM_POLYGONAL;

/// Sets a flag for the life of the object.
class Flagged {
public:
	explicit Flagged(bool& flag) : _flag(flag) { _flag = true; }
	~Flagged() { _flag = false; }
	Flagged(const Flagged&)            = delete;
	Flagged& operator=(const Flagged&) = delete;

private:
	bool& _flag;
};

gpr::MeshFacts factsOf(const CMeshO& mesh)
{
	gpr::MeshFacts facts;
	facts.vertexNum = mesh.vn;
	facts.diagonal  = mesh.bbox.IsNull() ? 0.0 : double(mesh.bbox.Diag());
	return facts;
}

gpr_filter::LayerCopy copyOf(const MeshModel& layer)
{
	return gpr_filter::copyLayer(layer.cm, layer.hasDataMask(MeshModel::MM_VERTCOLOR),
								 layer.hasDataMask(MeshModel::MM_VERTQUALITY));
}

/// meshlabserver prints the phrases back to back, so each ends its line; the status bar of the
/// window shows one line anyway.
gpr::ProgressCallback progressTo(vcg::CallBackPos* host)
{
	if (host == nullptr) return nullptr;
	return [host](double share, const char* phrase) {
		return host(int(100 * share), (std::string(phrase) + '\n').c_str());
	};
}

/// Whether the layer is still there and as it was copied. Other filters can run inside ours.
bool isUnchanged(const MeshDocument& document, int layerId, const gpr_filter::LayerCopy& copy)
{
	const MeshModel* layer = document.getMesh(layerId);
	return layer != nullptr && gpr_filter::copyLayer(layer->cm, false, false).sameGeometry(copy);
}

/// "bunny.ply" gives "bunny_remeshed": the layer list shows a label up to its first dot only.
QString labelOfResult(const MeshModel& layer)
{
	const QString base = layer.label().section('.', 0, 0);
	return (base.isEmpty() ? QStringLiteral("layer") : base) + "_remeshed";
}

MeshModel& addLayerFor(MeshDocument& document, const MeshModel& source)
{
	const Matrix44m transform = source.cm.Tr;
	const int  kept  = source.dataMask() & (MeshModel::MM_VERTCOLOR | MeshModel::MM_VERTQUALITY);
	MeshModel& added = *document.addNewMesh(QString(), labelOfResult(source), true);
	added.cm.Tr      = transform;
	added.updateDataMask(kept);
	return added;
}

void putInto(MeshModel& layer, CMeshO& built)
{
	layer.clearDataMask(kStaleMask);
	gpr_filter::replaceContents(layer.cm, built);
	layer.UpdateBoxAndNormals();
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

} // namespace

FilterGeodesicPoisson::FilterGeodesicPoisson()
{
	typeList << FP_GEODESIC_POISSON_REMESHING;
	for (FilterIDType filter : types()) {
		actionList << new QAction(filterName(filter), this);
	}
}

QString FilterGeodesicPoisson::pluginName() const
{
	return "FilterGeodesicPoisson";
}

QString FilterGeodesicPoisson::filterName(FilterIDType) const
{
	return gpr_filter::remeshName();
}

QString FilterGeodesicPoisson::filterInfo(FilterIDType) const
{
	return gpr_filter::remeshInfo();
}

MeshFilterInterface::FilterClass FilterGeodesicPoisson::getClass(QAction*)
{
	return Remeshing;
}

int FilterGeodesicPoisson::getPreConditions(QAction*) const
{
	return MeshModel::MM_FACENUMBER;
}

int FilterGeodesicPoisson::postCondition(QAction*) const
{
	return MeshModel::MM_GEOMETRY_AND_TOPOLOGY_CHANGE;
}

MeshFilterInterface::FILTER_ARITY FilterGeodesicPoisson::filterArity(QAction*) const
{
	return SINGLE_MESH;
}

void FilterGeodesicPoisson::initParameterSet(QAction*, MeshModel& layer, RichParameterList& list)
{
	gpr_filter::fillParameterList(gpr::remeshParameters(), factsOf(layer.cm), list);
}

bool FilterGeodesicPoisson::applyFilter(QAction*, MeshDocument& document,
										const RichParameterList& list, vcg::CallBackPos* progress)
try {
	errorMessage.clear();
	if (_running) return refuse("This filter is running already; wait until it has ended.");
	const Flagged running(_running);
	return remeshLayer(document, list, progress);
}
catch (const std::bad_alloc&) {
	return giveUp("There is not enough memory for this.", "");
}
catch (const std::exception& error) {
	return giveUp("Internal error: ", error.what());
}
catch (...) {
	return giveUp("Internal error.", "");
}

bool FilterGeodesicPoisson::remeshLayer(MeshDocument& document, const RichParameterList& list,
										vcg::CallBackPos* progress)
{
	MeshModel* const layer = document.mm();
	if (layer == nullptr) return refuse("There is no layer.");
	const gpr_filter::ReadParameters read =
		gpr_filter::readParameterList(gpr::remeshParameters(), list);
	if (!read.complaints.empty()) return refuse(read.complaints);

	const int                   layerId = layer->id();
	const gpr_filter::LayerCopy copy    = copyOf(*layer);
	const gpr::RemeshResult     result =
		gpr::remesh(copy.view(), read.values.options(), progressTo(progress));
	if (result.status != gpr::Status::Ok) return refuse(result.message);

	CMeshO built;
	gpr_filter::buildMesh(result, copy, built);
	if (!isUnchanged(document, layerId, copy)) {
		return refuse("The layer was changed or removed while the filter was running.");
	}
	std::vector<std::string> lines = gpr_filter::logLines(result);
	lines.push_back(lossesOf(*layer));
	MeshModel& target = read.values.newLayer() ? addLayerFor(document, *layer) : *layer;
	// From here on nothing fails.
	putInto(target, built);
	logAll(lines);
	return true;
}

void FilterGeodesicPoisson::logAll(const std::vector<std::string>& lines)
{
	// As std::string and by itself, a line is never taken for a printf format.
	for (const std::string& line : lines) {
		if (!line.empty()) Log(line);
	}
}

bool FilterGeodesicPoisson::refuse(const std::vector<std::string>& sentences)
{
	// The failure box shows errorMessage as HTML; meshlabserver shows the log only.
	QStringList paragraphs;
	for (const std::string& sentence : sentences) {
		paragraphs << QString::fromStdString(sentence).toHtmlEscaped();
	}
	errorMessage = paragraphs.join("<br>");
	logAll(sentences);
	return false;
}

bool FilterGeodesicPoisson::refuse(const std::string& sentence)
{
	return refuse(std::vector<std::string>{sentence});
}

bool FilterGeodesicPoisson::giveUp(const char* what, const char* why) noexcept
try {
	return refuse(std::string(what) + why);
}
catch (...) {
	// Not even memory for a sentence.
	return false;
}
