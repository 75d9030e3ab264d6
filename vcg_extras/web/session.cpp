// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "session.h"

#include "machine.h"

#include <vcg_extras/complex/baselines/quadric_collapse.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/run_estimate.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/options/given_options.h>
#include <vcg_extras/io/report/formatted_text.h>
#include <vcg_extras/io/report/remesh_outcome.h>
#include <vcg_extras/io/report/report_json.h>
#include <vcg_extras/viewer/mesh_json.h>

namespace gpr::web {

namespace {

using app::AppError;
using app::ExitCode;

constexpr const char* resultKey  = "result";
constexpr const char* quadricKey = "quadricEdgeCollapse";

RemeshOptions optionsOf(const std::string& text)
{
	RemeshOptions options = app::optionsOfText(text);
	options.threads       = threadNum();
	return options;
}

app::WantedAttributes wantedBy(const RemeshOptions& options)
{
	app::WantedAttributes wanted = app::neededBy(options);
	wanted.carried               = true;
	return wanted;
}

bool sameWishes(const app::WantedAttributes& a, const app::WantedAttributes& b)
{
	return a.selection == b.selection && a.ifSelected == b.ifSelected &&
		   a.faceSelection == b.faceSelection;
}

std::string gigabytes(double bytes)
{
	return app::formatted("%.1f GB", bytes / 1e9);
}

template <class Value>
Json packed(Pack pack, const std::vector<Value>& values)
{
	return pack({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
}

} // namespace

Session::Session(ProgressCallback progress, Pack pack) : progress_(std::move(progress)), pack_(pack)
{
}

Json Session::open(const std::string& path)
{
	path_ = path;
	readAs(RemeshOptions());
	return begin();
}

Json Session::take(app::InputMesh mesh)
{
	path_.clear();
	surface_.reset();
	source_  = app::MeshSource(std::move(mesh), RemeshOptions());
	surface_ = std::make_unique<PreparedSurface>(source_.view());
	return begin();
}

/// Reads the file for these options, which may need more attributes of the file or another form of
/// the texture.
void Session::readAs(const RemeshOptions& options)
{
	const app::WantedAttributes wanted = wantedBy(options);
	surface_.reset();
	measured_.reset();
	source_  = app::MeshSource(app::readMesh(path_, wanted), options);
	wanted_  = wanted;
	isSewn_  = app::isSewn(options);
	surface_ = std::make_unique<PreparedSurface>(source_.view());
}

Json Session::begin()
{
	measured_.reset();
	made_.clear();
	result_                   = RemeshResult();
	const MeshFigures figures = measureMesh(source_.mesh.view());
	diagonal_                 = figures.diagonal;
	Json json                 = app::figuresJson(figures);
	json["double"]            = source_.mesh.doublePrecision;
	json["notes"]             = source_.mesh.notes;
	return json;
}

Json Session::shownInput()
{
	const MeshView view = source_.mesh.view();
	Workers        workers(threadNum(), nullptr);
	Json json       = app::MeshJson(view, diagonal_, workers, pack_).ofMesh("input", "input", view);
	json["figures"] = {{"vertices", view.vertexNum},
					   {"faces", view.faceNum},
					   {"quality", app::qualityJson(measureQuality(view, workers))}};
	return json;
}

void Session::refuseWhatIsTooLarge(const RemeshOptions& options) const
{
	const double needed = estimateRun(source_.view(), options).bytes, left = freeBytes();
	if (needed <= left) return;
	throw AppError(ExitCode::Failure, "this takes about " + gigabytes(needed) +
										  " of memory, and the browser has " + gigabytes(left) +
										  " left. The program has no such limit.");
}

Json Session::estimate(const std::string& text)
{
	const RunEstimate estimate = estimateRun(source_.view(), optionsOf(text));
	return {{"vertices", estimate.vertexNum},
			{"seconds", estimate.seconds},
			{"bytes", estimate.bytes},
			{"freeBytes", freeBytes()}};
}

Json Session::remesh(const std::string& text)
{
	const RemeshOptions options = optionsOf(text);
	if (surface_ == nullptr && path_.empty())
		throw AppError(ExitCode::Usage, "there is no mesh yet.");
	const bool isOther = !sameWishes(wanted_, wantedBy(options)) || isSewn_ != app::isSewn(options);
	if (surface_ == nullptr || (!path_.empty() && isOther)) readAs(options);
	refuseWhatIsTooLarge(options);
	made_.erase(resultKey);
	result_ = surface_->remesh(source_.withPlaces(options), progress_);
	app::requireDone(result_);

	app::RunRecord run;
	run.inputPath    = path_;
	run.inputDouble  = source_.mesh.doublePrecision;
	run.outputDouble = app::needsDoubleOutput(source_.mesh, result_);
	run.options      = options;
	resolveFeatureRegion(source_.view().anySelected(), run.options);
	run.report = result_.report;
	run.notes  = source_.mesh.notes;
	run.notes.insert(run.notes.end(), result_.notes.begin(), result_.notes.end());
	return Json::parse(app::remeshReportJson(run));
}

Json Session::collapse(std::int64_t faceNum)
{
	baselines::QuadricCollapse collapse(source_.mesh.view());
	const app::Stopwatch       clock;
	collapse.run(faceNum, [this] { return !progress_(0, "Quadric Edge Collapse"); });
	made_[quadricKey] = collapse.mesh();
	return {{"seconds", clock.seconds()}, {"faces", made_[quadricKey].faceNum()}};
}

const TriangleMesh& Session::made(const std::string& key) const
{
	if (key == resultKey && !result_.mesh.triangles.empty()) return result_.mesh;
	const auto at = made_.find(key);
	if (at == made_.end()) throw AppError(ExitCode::Usage, "there is no mesh '" + key + "' yet.");
	return at->second;
}

Json Session::shown(const std::string& key, const std::string& name) const
{
	Workers workers(threadNum(), nullptr);
	return app::MeshJson(source_.mesh.view(), diagonal_, workers, pack_)
		.ofMesh(key, name, made(key).view());
}

const MeasuredSurface& Session::measuredInput(Workers& workers)
{
	if (measured_ == nullptr)
		measured_ = std::make_unique<MeasuredSurface>(source_.mesh.view(), workers);
	return *measured_;
}

Json Session::measured(const std::string& key, const std::string& name)
{
	const MeshView         input = source_.mesh.view(), mesh = made(key).view();
	Workers                workers(threadNum(), nullptr);
	const MeasuredSurface& surface = measuredInput(workers);
	const MeasuredSurface  ofMesh(mesh, surface, workers);
	const std::int64_t     sampleNum = distanceSampleNum(mesh.faceNum);
	const MutualDistance   distance  = {surface.from(mesh, sampleNum, workers),
										ofMesh.from(input, sampleNum, workers)};
	Json json = app::MeshJson(input, diagonal_, workers, pack_).ofResult(key, name, mesh, surface);
	json["figures"] = {{"vertices", mesh.vertexNum},
					   {"faces", mesh.faceNum},
					   {"quality", app::qualityJson(measureQuality(mesh, workers))},
					   {"distance", app::distanceJson(distance.larger(), diagonal_)}};
	return json;
}

Json Session::proven(const std::string& key)
{
	Workers                workers(threadNum(), nullptr);
	const MeasuredSurface& input = measuredInput(workers);
	const MeasuredSurface  mesh(made(key).view(), input, workers);
	return app::boundsJson(certifiedDistances(input, mesh, usualCertificate(diagonal_), workers),
						   diagonal_);
}

Json Session::save(const std::string& path) const
{
	const TriangleMesh& mesh   = made(resultKey);
	app::MeshAttributes source = source_.mesh.attributes; // carryAttributes empties the source
	app::MeshAttributes carried =
		app::carryAttributes(source, source_.mesh.view(), source_.texture.get(), result_);
	app::writeMesh(mesh, app::needsDoubleOutput(source_.mesh, result_), carried, path,
				   app::RunLimit());
	return {{"lost", carried.lost}};
}

Json Session::arrays() const
{
	const TriangleMesh& mesh = made(resultKey);
	Json                json = {{"faces", packed(pack_, mesh.triangles)},
								{"double", source_.mesh.doublePrecision}};
	if (source_.mesh.doublePrecision) {
		json["vertices"] = packed(pack_, mesh.positions);
		return json;
	}
	std::vector<Vec3f> floats;
	for (const Vec3d& p : mesh.positions)
		floats.push_back(Vec3f(p));
	json["vertices"] = packed(pack_, floats);
	return json;
}

} // namespace gpr::web
