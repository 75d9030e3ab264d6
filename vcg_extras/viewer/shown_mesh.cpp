// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "shown_mesh.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/surface/triangle_tree.h>

#include <cmath>
#include <unordered_map>

namespace gpr::app {

namespace {

bool isFinite(const Vec3d& p)
{
	return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// For each vertex the number of the drawn vertex.
struct Clusters {
	std::vector<std::uint32_t> ofVertex;
	std::vector<Vec3d>         sum; ///< of the positions, local
	std::vector<std::uint32_t> num; ///< of the vertices
};

/// Every vertex is a cluster by itself.
Clusters singleVertices(const MeshView& mesh, const ShownFrame& frame)
{
	Clusters clusters;
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		clusters.ofVertex.push_back(std::uint32_t(v));
		clusters.sum.push_back(frame.local(mesh.position(v)));
		clusters.num.push_back(1);
	}
	return clusters;
}

/// A number for each cell of a grid of cubes; cellNum cubes are as long as the diagonal.
std::uint64_t cellOf(const Vec3d& p, double cellNum)
{
	const auto part = [&](double x) { return std::uint64_t(std::floor((x + 1) * cellNum)); };
	return part(p.x) << 42 | part(p.y) << 21 | part(p.z);
}

Clusters clustersOfGrid(const MeshView& mesh, const ShownFrame& frame, double cellNum)
{
	Clusters                                         clusters;
	std::unordered_map<std::uint64_t, std::uint32_t> clusterOf;
	clusters.ofVertex.resize(mesh.vertexNum, 0);
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		const Vec3d p = frame.local(mesh.position(v));
		// Unused vertices may be anywhere.
		if (!isFinite(p) || length(p) >= 1) continue;
		const auto [at, isNew] = clusterOf.try_emplace(cellOf(p, cellNum), clusters.num.size());
		if (isNew) {
			clusters.sum.emplace_back();
			clusters.num.push_back(0);
		}
		clusters.ofVertex[v] = at->second;
		clusters.sum[at->second] += p;
		++clusters.num[at->second];
	}
	return clusters;
}

/// Faces drawn with three different vertices.
std::vector<std::uint32_t> remainingFaces(const MeshView& mesh, const Clusters& clusters)
{
	std::vector<std::uint32_t> faces;
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		const auto t = mesh.triangle(f);
		const auto a = clusters.ofVertex[t[0]], b = clusters.ofVertex[t[1]],
				   c = clusters.ofVertex[t[2]];
		if (a != b && b != c && c != a && isUsableFace(mesh, f)) faces.push_back(std::uint32_t(f));
	}
	return faces;
}

ShownMesh drawn(const MeshView& mesh, const Clusters& clusters, std::vector<std::uint32_t> faces)
{
	ShownMesh shown;
	for (std::size_t i = 0; i < clusters.num.size(); ++i) {
		const Vec3d sum  = clusters.sum[i] * (1.0 / clusters.num[i]);
		const Vec3d mean = isFinite(sum) ? sum : Vec3d();
		shown.positions.insert(shown.positions.end(),
							   {float(mean.x), float(mean.y), float(mean.z)});
	}
	for (const std::uint32_t f : faces)
		for (const std::int32_t v : mesh.triangle(f))
			shown.triangles.push_back(clusters.ofVertex[std::size_t(v)]);
	shown.faceOf = std::move(faces);
	return shown;
}

} // namespace

ShownFrame::ShownFrame(const MeshView& mesh)
{
	Box<double> box;
	for (std::size_t c = 0; c < 3 * mesh.faceNum; ++c) {
		const Vec3d p = mesh.position(std::size_t(mesh.vertexOf(c)));
		if (isFinite(p)) box.add(p);
	}
	const double diagonal = box.diagonal();
	if (!(diagonal > 0) || !std::isfinite(diagonal)) return;
	centre = (box.low + box.high) * 0.5;
	scale  = 1 / diagonal;
}

ShownMesh shownMesh(const MeshView& mesh, const ShownFrame& frame, std::size_t mostFaces)
{
	Clusters                   clusters = singleVertices(mesh, frame);
	std::vector<std::uint32_t> faces    = remainingFaces(mesh, clusters);
	// A cell on a smooth surface has about two faces.
	double cellNum = std::min(std::sqrt(double(mostFaces)), 1e6);
	while (faces.size() > mostFaces) {
		clusters = clustersOfGrid(mesh, frame, cellNum);
		faces    = remainingFaces(mesh, clusters);
		cellNum *= 0.97 * std::min(1.0, std::sqrt(double(mostFaces) / double(faces.size() + 1)));
	}
	return drawn(mesh, clusters, std::move(faces));
}

} // namespace gpr::app
