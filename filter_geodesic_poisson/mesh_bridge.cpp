// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_bridge.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gpr_filter {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
	return a.size() == b.size() &&
		   (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Copies the vertices and returns the new index of each element of mesh.vert.
std::vector<std::int32_t> copyVertices(const CMeshO& mesh, bool withColour, bool withQuality,
									   LayerCopy& copy)
{
	std::vector<std::int32_t> newIndex(mesh.vert.size(), -1);
	copy.positions.reserve(std::size_t(mesh.vn));
	for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
		const CVertexO& vertex = mesh.vert[v];
		if (vertex.IsD()) continue;
		newIndex[v]          = std::int32_t(copy.positions.size());
		const Point3m& point = vertex.cP();
		copy.positions.push_back({point[0], point[1], point[2]});
		if (withColour) copy.colours.push_back(vertex.cC());
		if (withQuality) copy.qualities.push_back(vertex.cQ());
	}
	return newIndex;
}

/// Sum of weight · value over the corners of the anchor's face; corners of no weight are left out,
/// so that a NaN there does no harm.
template <class Value, class ValueOf>
Value interpolate(const gpr::SurfacePoint& anchor, const LayerCopy& source, const ValueOf& valueOf)
{
	Value sum = 0;
	for (int k = 0; k < 3; ++k) {
		if (anchor.weight[k] == 0) continue;
		const std::int32_t v = source.triangles[3 * std::size_t(anchor.face) + std::size_t(k)];
		sum += Value(anchor.weight[k]) * Value(valueOf(std::size_t(v)));
	}
	return sum;
}

vcg::Color4b colourAt(const gpr::SurfacePoint& anchor, const LayerCopy& source)
{
	vcg::Color4b colour;
	for (int channel = 0; channel < 4; ++channel) {
		const float level = interpolate<float>(
			anchor, source, [&](std::size_t v) { return source.colours[v][channel]; });
		colour[channel] = static_cast<unsigned char>(std::lround(std::clamp(level, 0.f, 255.f)));
	}
	return colour;
}

void carryOver(const gpr::SurfacePoint& anchor, const LayerCopy& source, CVertexO& vertex)
{
	if (anchor.face < 0) return;
	if (!source.colours.empty()) vertex.C() = colourAt(anchor, source);
	if (!source.qualities.empty()) {
		vertex.Q() = interpolate<CVertexO::QualityType>(
			anchor, source, [&](std::size_t v) { return source.qualities[v]; });
	}
}

/// The vectors of a vcg mesh know their elements and the elements their vector: both change sides.
template <class Container>
void takeElements(Container& to, Container& from)
{
	std::vector<typename Container::value_type>& elements = to;
	elements.swap(from);
	to._updateOVP(to.begin(), to.end());
	// A component that was enabled behind the layer's data mask gets the right size, at least.
	to.resize(to.size());
}

void dropElementAttributes(CMeshO& mesh)
{
	while (!mesh.vert_attr.empty()) {
		Allocator::DeletePerVertexAttribute(mesh, mesh.vert_attr.begin()->_name);
	}
	while (!mesh.edge_attr.empty()) {
		Allocator::DeletePerEdgeAttribute(mesh, mesh.edge_attr.begin()->_name);
	}
	while (!mesh.face_attr.empty()) {
		Allocator::DeletePerFaceAttribute(mesh, mesh.face_attr.begin()->_name);
	}
}

} // namespace

bool LayerCopy::sameGeometry(const LayerCopy& other) const
{
	return sameBits(positions, other.positions) && sameBits(triangles, other.triangles);
}

LayerCopy copyLayer(const CMeshO& mesh, bool withColour, bool withQuality)
{
	LayerCopy                       copy;
	const std::vector<std::int32_t> newIndex = copyVertices(mesh, withColour, withQuality, copy);
	copy.triangles.reserve(3 * std::size_t(mesh.fn));
	for (const CFaceO& face : mesh.face) {
		if (face.IsD()) continue;
		for (int k = 0; k < 3; ++k) {
			copy.triangles.push_back(newIndex[vcg::tri::Index(mesh, face.cV(k))]);
		}
	}
	return copy;
}

void buildMesh(const gpr::RemeshResult& result, const LayerCopy& source, CMeshO& built)
{
	const gpr::TriangleMesh& mesh = result.mesh;
	Allocator::AddVertices(built, mesh.vertexNum());
	Allocator::AddFaces(built, mesh.faceNum());
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		const gpr::Vec3d& p = mesh.positions[v];
		built.vert[v].P()   = Point3m(Scalarm(p.x), Scalarm(p.y), Scalarm(p.z));
		if (v < result.anchors.size()) carryOver(result.anchors[v], source, built.vert[v]);
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		for (int k = 0; k < 3; ++k) {
			const std::int32_t v = mesh.triangles[3 * f + std::size_t(k)];
			built.face[f].V(k)   = &built.vert[std::size_t(v)];
		}
	}
}

void replaceContents(CMeshO& layer, CMeshO& built)
{
	dropElementAttributes(layer);
	layer.edge.clear();
	layer.en = 0;
	takeElements(layer.vert, built.vert);
	takeElements(layer.face, built.face);
	layer.vn    = int(layer.vert.size());
	layer.fn    = int(layer.face.size());
	layer.svn   = 0;
	layer.sfn   = 0;
	layer.imark = 0;
	layer.textures.clear();
	layer.normalmaps.clear();
	built.vn = int(built.vert.size());
	built.fn = int(built.face.size());
}

} // namespace gpr_filter
