// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_call.h"

#include "line_marks.h"
#include "parameter_values.h"
#include "python_progress.h"

#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/texture_transfer.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/base/stopwatch.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh/joined_pieces.h>
#include <vcg_extras/io/mesh/precision.h>
#include <vcg_extras/io/report/features_report.h>
#include <vcg_extras/io/report/report_json.h>

#include <memory>
#include <nanobind/stl/string.h>
#include <string>

namespace gpr::python {

namespace {

/// The mesh of the caller with all data; refers to the arrays of the caller.
struct Mesh {
	MeshView                       view;
	std::vector<std::uint8_t>      lines; ///< three a face, or empty
	std::unique_ptr<TextureSource> texture;
	app::FaceRegions               regions;            ///< of a file's attributes
	PreparedSurface*               prepared = nullptr; ///< of these vertices and faces
};

[[noreturn]] void failEdge(const std::int32_t* edges, std::int64_t e)
{
	const std::string number = std::to_string(e);
	const std::string a = std::to_string(edges[2 * e]), b = std::to_string(edges[2 * e + 1]);
	throw nb::value_error(
		("feature_edges[" + number + "], " + a + " to " + b + ", is no edge of a face.").c_str());
}

void takeLines(const Edges& edges, Mesh& mesh)
{
	const std::int64_t missing = markEdges(mesh.view, edges.data(), edges.shape(0), mesh.lines);
	if (missing >= 0) failEdge(edges.data(), missing);
}

/// Adds the seams of the texture to the given lines.
void takeSeams(Mesh& mesh)
{
	if (mesh.texture == nullptr || !mesh.texture->hasSeams()) return;
	mesh.lines.resize(3 * mesh.view.faceNum, 0);
	for (std::size_t c = 0; c < mesh.lines.size(); ++c)
		mesh.lines[c] |= mesh.texture->seams()[c];
	mesh.view.line = mesh.lines.data();
}

void takeTexture(const Extras& extras, Mesh& mesh)
{
	const float* const        uv    = dataOf(extras.texture, mesh.view.faceNum);
	const std::int32_t* const image = dataOf(extras.images, mesh.view.faceNum);
	CornerTexture             texture;
	texture.uv.assign(uv, uv + 6 * mesh.view.faceNum);
	if (image != nullptr) texture.image.assign(image, image + mesh.view.faceNum);
	mesh.texture = std::make_unique<TextureSource>(mesh.view, std::move(texture));
	takeSeams(mesh);
}

/// Collects a mesh from arrays. Touches Python objects only for the data of arrays.
Mesh takeMesh(const Positions& positions, const Triangles& triangles, const Extras& extras)
{
	Mesh mesh;
	mesh.view              = viewOf(positions, triangles);
	mesh.view.selectedFace = dataOf(extras.selectedFaces, mesh.view.faceNum);
	mesh.view.selected     = dataOf(extras.selectedVertices, mesh.view.vertexNum);
	mesh.view.region       = dataOf(extras.regions, mesh.view.faceNum);
	mesh.view.wantedEdge   = dataOf(extras.wantedEdges, mesh.view.vertexNum);
	if (extras.edges) takeLines(*extras.edges, mesh);
	if (extras.texture) takeTexture(extras, mesh);
	if (!mesh.lines.empty()) mesh.view.line = mesh.lines.data();
	mesh.prepared = extras.prepared.get();
	return mesh;
}

/// Takes the regions of a file if the caller gives no regions.
void takeRegions(const app::MeshAttributes& attributes, Mesh& mesh)
{
	if (mesh.view.region != nullptr) return;
	mesh.regions          = app::regionsOf(attributes);
	mesh.view.region      = mesh.regions.label.empty() ? nullptr : mesh.regions.label.data();
	mesh.view.regionNames = &mesh.regions.names;
}

RemeshResult remeshOf(const Mesh& mesh, const RemeshOptions& options,
					  const ProgressCallback& progress)
{
	if (mesh.prepared == nullptr) return remesh(mesh.view, options, progress);
	mesh.prepared->setInput(mesh.view);
	return mesh.prepared->remesh(options, progress);
}

nb::dict outcome(Status status, const std::string& message, std::int64_t smallestCount = 0)
{
	nb::dict out;
	out["status"]         = statusName(status);
	out["message"]        = message;
	out["smallest_count"] = smallestCount;
	return out;
}

/// Whether floats are too coarse for a thousandth of the mean edge; the command line then writes
/// doubles.
bool isCoarse(const RemeshResult& result)
{
	const double largest = app::largestCoordinate(result.mesh.view());
	return !app::floatResolves(largest, result.report.quality.meanEdgeLen);
}

/// The record of a run, with the same words as the report of the command line.
app::RunRecord recordOf(const Mesh& mesh, const RemeshOptions& options, const RemeshResult& result)
{
	app::RunRecord run;
	run.inputDouble = run.outputDouble = mesh.view.doublePrecision;
	run.options                        = options;
	resolveFeatureRegion(mesh.view.anySelected(), run.options);
	run.report = result.report;
	run.notes  = result.notes;
	if (!mesh.view.doublePrecision && result.status == Status::Ok && isCoarse(result)) {
		run.notes.push_back("The coordinates are rounded to float32, which is coarse for edges so "
							"short; float64 would be exact.");
	}
	run.peakMemoryBytes = app::peakMemoryBytes();
	return run;
}

void putTexture(CornerTexture&& texture, nb::dict& out)
{
	const std::size_t faceNum = texture.uv.size() / 6;
	out["uv"]                 = toNumpy<float>(std::move(texture.uv), {faceNum, 3, 2});
	out["image"]              = toNumpy(std::move(texture.image));
}

void putMesh(RemeshResult&& result, nb::dict& out)
{
	const std::size_t faceNum = result.mesh.faceNum();
	out["vertices"]           = toNumpy(std::move(result.mesh.positions));
	out["faces"]       = toNumpy<std::int32_t>(std::move(result.mesh.triangles), {faceNum, 3});
	out["face_index"]  = facesOf(result.surfacePoints);
	out["barycentric"] = weightsOf(result.surfacePoints);
	out["middle_face_index"] = facesOf(result.facePoints);
	out["kept_vertex"]       = toNumpy(std::move(result.callersVertex));
	out["kept_face"]         = toNumpy(std::move(result.callersFace));
	out["regions"]           = toNumpy(std::move(result.region));
}

} // namespace

namespace {

/// A whole run and its record.
struct Run {
	RemeshOptions  options;
	app::RunRecord record;
	RemeshResult   result;
};

Run runOf(const Extras& extras, const nb::dict& given)
{
	Run run;
	run.options              = optionsOf(RemeshTool, given);
	run.options.selectedOnly = extras.selectedFaces.has_value();
	if (extras.wantedEdges && !givesSize(RemeshTool, given))
		run.options.targetMode = TargetMode::Sizes;
	if (!extras.period.empty())
		run.options.period = {extras.period[0], extras.period[1], extras.period[2]};
	run.options.surfacePointsOfFaces = true;
	return run;
}

/// Remeshes and takes the times. carry(mesh) transfers data to the result, if there is a result.
template <class Carry>
void remeshTimed(const Mesh& mesh, const app::Stopwatch& clock, PythonProgress& watch, Run& run,
				 const Carry& carry)
{
	const double read = clock.seconds();
	run.result        = remeshOf(mesh, run.options, watch.callback());
	const double done = clock.seconds();
	if (run.result.status == Status::Ok) carry(mesh);
	run.record       = recordOf(mesh, run.options, run.result);
	run.record.times = {read, done - read, clock.seconds() - done};
}

nb::dict outcomeOf(Run&& run)
{
	const RemeshResult& result = run.result;
	nb::dict            out    = outcome(result.status, result.message, result.smallestVertexNum);
	if (result.status != Status::Ok) return out;
	out["report"]    = app::remeshReportJson(run.record);
	out["is_coarse"] = isCoarse(result);
	putMesh(std::move(run.result), out);
	return out;
}

} // namespace

nb::dict remeshArrays(const Positions& positions, const Triangles& triangles, const Extras& extras,
					  const nb::dict& given, nb::object progress)
{
	const app::Stopwatch clock;
	Run                  run = runOf(extras, given);
	PythonProgress       watch(std::move(progress));
	CornerTexture        texture;
	{
		const nb::gil_scoped_release noLock;
		remeshTimed(takeMesh(positions, triangles, extras), clock, watch, run,
					[&](const Mesh& mesh) {
						if (mesh.texture != nullptr) texture = mesh.texture->carriedTo(run.result);
					});
	}
	watch.rethrow();
	nb::dict out = outcomeOf(std::move(run));
	if (!texture.uv.empty()) putTexture(std::move(texture), out);
	return out;
}

std::vector<nb::dict> remeshPieces(const std::vector<Positions>& positions,
								   const std::vector<Triangles>& triangles,
								   const std::vector<Extras>& extras, const nb::dict& given,
								   nb::object progress)
{
	const app::Stopwatch       clock;
	Run                        run = runOf(extras.front(), given);
	PythonProgress             watch(std::move(progress));
	std::vector<Mesh>          meshes;
	std::vector<RemeshResult>  parts;
	std::vector<CornerTexture> textures;
	{
		const nb::gil_scoped_release noLock;
		std::vector<MeshView>        views;
		for (std::size_t k = 0; k < positions.size(); ++k) {
			meshes.push_back(takeMesh(positions[k], triangles[k], extras[k]));
			views.push_back(meshes.back().view);
		}
		const app::JoinedPieces joined(views);
		Mesh                    whole;
		whole.view = joined.view();
		remeshTimed(whole, clock, watch, run, [&](const Mesh&) {
			for (std::size_t k = 0; k < meshes.size(); ++k) {
				const TextureSource* const texture = meshes[k].texture.get();
				parts.push_back(joined.ofPiece(run.result, k));
				textures.push_back(texture == nullptr ? CornerTexture()
													  : texture->carriedTo(parts.back()));
			}
		});
	}
	watch.rethrow();
	if (parts.empty()) return {outcomeOf(std::move(run))};
	std::vector<nb::dict> out;
	for (std::size_t k = 0; k < parts.size(); ++k) {
		run.result = std::move(parts[k]);
		out.push_back(outcomeOf(std::move(run)));
		if (!textures[k].uv.empty()) putTexture(std::move(textures[k]), out.back());
	}
	return out;
}

nb::dict remeshMeshOfFile(const Positions& positions, const Triangles& triangles,
						  const Extras& extras, const FileAttributes& attributes,
						  const nb::dict& given, nb::object progress)
{
	const app::Stopwatch clock;
	Run                  run = runOf(extras, given);
	PythonProgress       watch(std::move(progress));
	FileAttributes       carried;
	{
		const nb::gil_scoped_release noLock;
		const bool                   isSewn = run.options.sew && !run.options.selectedOnly;
		app::MeshAttributes          source = attributes.values;
		Mesh                         mesh   = takeMesh(positions, triangles, extras);
		mesh.texture                        = app::takeTexture(source, mesh.view, isSewn);
		takeSeams(mesh);
		takeRegions(attributes.values, mesh);
		remeshTimed(mesh, clock, watch, run, [&](const Mesh& taken) {
			carried.values =
				app::carryAttributes(source, taken.view, taken.texture.get(), run.result);
		});
	}
	watch.rethrow();
	nb::dict out      = outcomeOf(std::move(run));
	out["attributes"] = std::move(carried);
	return out;
}

nb::dict sampleArrays(const Positions& positions, const Triangles& triangles, const Extras& extras,
					  const nb::dict& given, nb::object progress)
{
	const RemeshOptions options = optionsOf(SamplingTool, given);
	PythonProgress      watch(std::move(progress));
	SamplingResult      result;
	{
		const nb::gil_scoped_release noLock;
		const Mesh                   mesh = takeMesh(positions, triangles, extras);
		result = samplePoissonDisks(mesh.view, options, watch.callback());
	}
	watch.rethrow();
	nb::dict out = outcome(result.status, result.message);
	if (result.status != Status::Ok) return out;
	out["face_index"]  = facesOf(result.surfacePoints);
	out["barycentric"] = weightsOf(result.surfacePoints);
	out["points"]      = toNumpy(std::move(result.points));
	out["radius"]      = toNumpy(std::move(result.radii));
	out["disk_radius"] = result.diskRadius;
	out["seed"]        = result.report.seed;
	out["notes"]       = nb::list();
	for (const std::string& note : result.notes)
		nb::cast<nb::list>(out["notes"]).append(note);
	return out;
}

namespace {

void putEdges(const std::vector<FeatureEdge>& edges, nb::dict& out)
{
	std::vector<std::int32_t> vertices;
	std::vector<float>        strengths;
	for (const FeatureEdge& e : edges) {
		vertices.insert(vertices.end(), e.vertex, e.vertex + 2);
		strengths.push_back(e.strength);
	}
	out["edges"]         = toNumpy<std::int32_t>(std::move(vertices), {edges.size(), 2});
	out["edge_strength"] = toNumpy(std::move(strengths));
}

app::FeaturesRecord recordOf(const MeshView& view, const RemeshOptions& options,
							 const FeatureResult& found)
{
	app::FeaturesRecord record;
	record.doublePrecision = view.doublePrecision;
	record.thresholds      = options.featureThresholds;
	record.figures         = found.figures;
	record.notes           = found.notes;
	record.report          = found.report;
	return record;
}

} // namespace

nb::dict detectInArrays(const Positions& positions, const Triangles& triangles,
						const nb::dict& given, nb::object progress)
{
	const RemeshOptions options = optionsOf(FeatureTool, given);
	const MeshView      view    = viewOf(positions, triangles);
	PythonProgress      watch(std::move(progress));
	FeatureResult       found;
	{
		const nb::gil_scoped_release noLock;
		found = detectFeatures(view, options, watch.callback());
	}
	watch.rethrow();
	nb::dict out = outcome(found.status, found.message);
	if (found.status != Status::Ok) return out;
	out["report"]   = app::featuresJson(recordOf(view, options, found));
	out["strength"] = toNumpy(std::move(found.vertexStrength));
	out["vertex"]   = toNumpy(std::move(found.vertexFeature));
	out["face"]     = toNumpy(std::move(found.faceMark));
	putEdges(found.edges, out);
	return out;
}

} // namespace gpr::python
