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
std::vector<std::int32_t> copyVertices(const CMeshO& mesh, const CopiedParts& parts,
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
		if (parts.colour) copy.colours.push_back(vertex.cC());
		if (parts.quality) copy.qualities.push_back(float(vertex.cQ()));
		if (parts.selection) copy.selected.push_back(vertex.IsS());
	}
	return newIndex;
}

void selectCorners(const CFaceO& face, const CMeshO& mesh,
				   const std::vector<std::int32_t>& newIndex, LayerCopy& copy)
{
	for (int k = 0; k < 3; ++k) {
		copy.selected[std::size_t(newIndex[vcg::tri::Index(mesh, face.cV(k))])] = 1;
	}
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

float qualityAt(const gpr::SurfacePoint& anchor, const LayerCopy& source)
{
	return interpolate<float>(anchor, source, [&](std::size_t v) { return source.qualities[v]; });
}

void carryOver(const gpr::SurfacePoint& anchor, const LayerCopy& source, CVertexO& vertex)
{
	if (anchor.face < 0) return;
	if (!source.colours.empty()) vertex.C() = colourAt(anchor, source);
	if (!source.qualities.empty()) vertex.Q() = qualityAt(anchor, source);
}

/// The unit normal of the face on which a point lies, or zero where the face has no area.
Point3m normalAt(const gpr::SurfacePoint& anchor, const LayerCopy& source)
{
	const std::int32_t* corner = &source.triangles[3 * std::size_t(anchor.face)];
	gpr::Vec3d          p[3];
	for (int k = 0; k < 3; ++k) {
		p[k] = gpr::Vec3d(source.positions[std::size_t(corner[k])]);
	}
	const gpr::Vec3d normal = cross(p[1] - p[0], p[2] - p[0]);
	const double     length = gpr::length(normal);
	if (!(length > 0)) return Point3m(0, 0, 0);
	return Point3m(Scalarm(normal.x / length), Scalarm(normal.y / length),
				   Scalarm(normal.z / length));
}

Point3m pointOf(const gpr::Vec3d& p)
{
	return Point3m(Scalarm(p.x), Scalarm(p.y), Scalarm(p.z));
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

/// Of a vertex or a face; counts the selected ones.
template <class Element>
void setSelected(Element& element, bool selected, int& count)
{
	if (selected) {
		element.SetS();
		++count;
	}
	else {
		element.ClearS();
	}
}

} // namespace

gpr::MeshView LayerCopy::view() const
{
	gpr::MeshView view(positions, triangles);
	view.quality  = qualities.empty() ? nullptr : qualities.data();
	view.selected = selected.empty() ? nullptr : selected.data();
	return view;
}

bool LayerCopy::sameGeometry(const LayerCopy& other) const
{
	return sameBits(positions, other.positions) && sameBits(triangles, other.triangles);
}

bool LayerCopy::anySelected() const
{
	return std::find(selected.begin(), selected.end(), 1) != selected.end();
}

LayerCopy copyLayer(const CMeshO& mesh, const CopiedParts& parts)
{
	LayerCopy                       copy;
	const std::vector<std::int32_t> newIndex     = copyVertices(mesh, parts, copy);
	const bool                      cornersCount = parts.selection && !copy.anySelected();
	copy.triangles.reserve(3 * std::size_t(mesh.fn));
	for (const CFaceO& face : mesh.face) {
		if (face.IsD()) continue;
		for (int k = 0; k < 3; ++k) {
			copy.triangles.push_back(newIndex[vcg::tri::Index(mesh, face.cV(k))]);
		}
		if (cornersCount && face.IsS()) selectCorners(face, mesh, newIndex, copy);
	}
	return copy;
}

namespace {

/// From the frame of one transform into that of another.
vcg::Matrix44d changeOfFrame(const Matrix44m& from, const Matrix44m& to)
{
	vcg::Matrix44d a, b;
	a.Import(from);
	b.Import(to);
	return vcg::Inverse(b) * a;
}

bool isFinite(const vcg::Matrix44d& matrix)
{
	const double* entry = matrix.V();
	return std::all_of(entry, entry + 16, [](double e) { return std::isfinite(e); });
}

} // namespace

bool canReach(const Matrix44m& to, const Matrix44m& from)
{
	return to == from || isFinite(changeOfFrame(from, to));
}

std::vector<gpr::Vec3d> copyPoints(const CMeshO& mesh, const Matrix44m& frame)
{
	const bool              sameFrame = mesh.Tr == frame;
	const vcg::Matrix44d    change    = changeOfFrame(mesh.Tr, frame);
	std::vector<gpr::Vec3d> points;
	points.reserve(std::size_t(mesh.vn));
	for (const CVertexO& vertex : mesh.vert) {
		if (vertex.IsD()) continue;
		vcg::Point3d p = vcg::Point3d::Construct(vertex.cP());
		if (!sameFrame) p = change * p;
		points.push_back({p[0], p[1], p[2]});
	}
	return points;
}

void buildMesh(const gpr::RemeshResult& result, const LayerCopy& source, CMeshO& built)
{
	const gpr::TriangleMesh& mesh = result.mesh;
	Allocator::AddVertices(built, mesh.vertexNum());
	Allocator::AddFaces(built, mesh.faceNum());
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		built.vert[v].P() = pointOf(mesh.positions[v]);
		carryOver(result.anchors[v], source, built.vert[v]);
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		for (int k = 0; k < 3; ++k) {
			const std::int32_t v = mesh.triangles[3 * f + std::size_t(k)];
			built.face[f].V(k)   = &built.vert[std::size_t(v)];
		}
	}
}

void buildPoints(const gpr::SamplingResult& result, const LayerCopy& source, CMeshO& built)
{
	Allocator::AddVertices(built, result.points.size());
	for (std::size_t s = 0; s < result.points.size(); ++s) {
		const gpr::SurfacePoint& anchor = result.anchors[s];
		CVertexO&                vertex = built.vert[s];
		vertex.P()                      = pointOf(result.points[s]);
		vertex.N()                      = normalAt(anchor, source);
		carryOver(anchor, source, vertex);
		vertex.Q() = Scalarm(result.radii[s]);
	}
}

void markFeatures(const gpr::FeatureResult& result, CMeshO& mesh)
{
	mesh.svn = mesh.sfn = 0;
	std::size_t v = 0, f = 0;
	for (CVertexO& vertex : mesh.vert) {
		if (vertex.IsD()) continue;
		vertex.Q() = Scalarm(result.vertexStrength[v]);
		setSelected(vertex, result.vertexFeature[v++] != 0, mesh.svn);
	}
	for (CFaceO& face : mesh.face) {
		if (face.IsD()) continue;
		setSelected(face, result.faceMark[f++] != 0, mesh.sfn);
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
