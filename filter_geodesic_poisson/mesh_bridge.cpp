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
std::vector<std::int32_t> copyVertices(const CMeshO& mesh, LayerCopy& copy)
{
	std::vector<std::int32_t> newIndex(mesh.vert.size(), -1);
	copy.positions.reserve(std::size_t(mesh.vn));
	for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
		const CVertexO& vertex = mesh.vert[v];
		if (vertex.IsD()) continue;
		newIndex[v]          = std::int32_t(copy.positions.size());
		const Point3m& point = vertex.cP();
		copy.positions.push_back({point[0], point[1], point[2]});
	}
	return newIndex;
}

/// The unit normal of the face below a point, or zero for a degenerate face.
Point3m normalAt(const gpr::BarycentricPoint& point, const LayerCopy& source)
{
	const std::int32_t* corner = &source.triangles[3 * std::size_t(point.face)];
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

/// Elements and optional components. The elements know their vector: they are told the new one.
template <class Container>
void swapElements(Container& a, Container& b)
{
	std::swap(a, b);
	a._updateOVP(a.begin(), a.end());
	b._updateOVP(b.begin(), b.end());
}

/// The faces of a mesh as the engine numbers them.
std::vector<const CFaceO*> liveFaces(const CMeshO& mesh)
{
	std::vector<const CFaceO*> faces;
	faces.reserve(std::size_t(mesh.fn));
	for (const CFaceO& face : mesh.face) {
		if (!face.IsD()) faces.push_back(&face);
	}
	return faces;
}

/// Gives an empty mesh the optional components that can be carried over.
void enableCarried(const CMeshO& source, bool facesToo, bool textureToo, CMeshO& built)
{
	if (source.vert.IsRadiusEnabled()) built.vert.EnableRadius();
	if (source.vert.IsTexCoordEnabled()) built.vert.EnableTexCoord();
	if (facesToo && source.face.IsColorEnabled()) built.face.EnableColor();
	if (facesToo && source.face.IsQualityEnabled()) built.face.EnableQuality();
	if (facesToo && textureToo) built.face.EnableWedgeTexCoord();
}

void addElements(const gpr::TriangleMesh& mesh, CMeshO& built)
{
	Allocator::AddVertices(built, mesh.vertexNum());
	Allocator::AddFaces(built, mesh.faceNum());
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		built.vert[v].P() = pointOf(mesh.positions[v]);
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		for (int k = 0; k < 3; ++k) {
			const std::int32_t v = mesh.triangles[3 * f + std::size_t(k)];
			built.face[f].V(k)   = &built.vert[std::size_t(v)];
		}
	}
}

void selectNewFaces(const gpr::RemeshResult& result, CMeshO& built)
{
	for (std::size_t f = 0; f < result.callersFace.size(); ++f) {
		if (result.callersFace[f] >= 0) continue;
		built.face[f].SetS();
	}
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
	view.selected     = selected.empty() ? nullptr : selected.data();
	view.selectedFace = selectedFaces.empty() ? nullptr : selectedFaces.data();
	if (texture != nullptr && texture->hasSeams()) view.line = texture->seams().data();
	if (!selectedEdges.empty()) view.line = selectedEdges.data();
	if (!regions.label.empty()) view.region = regions.label.data();
	if (!regions.names.empty()) view.regionNames = &regions.names;
	if (!sizes.empty()) view.wantedEdge = sizes.data();
	return view;
}

bool LayerCopy::sameGeometry(const LayerCopy& other) const
{
	return sameBits(positions, other.positions) && sameBits(triangles, other.triangles);
}

bool LayerCopy::anyFaceSelected() const
{
	return std::find(selectedFaces.begin(), selectedFaces.end(), 1) != selectedFaces.end();
}

LayerCopy copyLayer(const CMeshO& mesh, const CopiedParts& parts)
{
	LayerCopy                       copy;
	const std::vector<std::int32_t> newIndex = copyVertices(mesh, copy);
	copy.triangles.reserve(3 * std::size_t(mesh.fn));
	for (const CFaceO& face : mesh.face) {
		if (face.IsD()) continue;
		for (int k = 0; k < 3; ++k) {
			copy.triangles.push_back(newIndex[vcg::tri::Index(mesh, face.cV(k))]);
		}
	}
	using namespace vcg::tri::gpr_detail;
	if (parts.facesCorners)
		copy.selected = SelectedVertices(mesh, copy.view());
	else if (parts.selection)
		copy.selected = SelectionOf(mesh.vert);
	if (parts.faceSelection) copy.selectedFaces = SelectionOf(mesh.face);
	if (parts.texture) {
		const std::vector<const CFaceO*> faces = liveFaces(mesh);
		const auto faceOf = [&](std::int32_t f) { return faces[std::size_t(f)]; };
		copy.texture =
			std::make_shared<const gpr::TextureSource>(WedgeTextureOf<CMeshO>(copy.view(), faceOf));
	}
	if (parts.edgeSelection) copy.selectedEdges = SelectedEdges(mesh, copy.view().line);
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

void buildMesh(const gpr::RemeshResult& result, const LayerCopy& copy, const CMeshO& source,
			   CMeshO& built, UserAttributes& user)
{
	const std::vector<const CFaceO*> faces  = liveFaces(source);
	const auto                       faceOf = [&](std::int32_t f) { return faces[std::size_t(f)]; };
	const bool                       facesToo = !result.facePoints.empty();
	enableCarried(source, facesToo, copy.texture != nullptr, built);
	addElements(result.mesh, built);
	selectNewFaces(result, built);

	vcg::tri::gpr_detail::AttributesAtPoints<CMeshO> attributes;
	attributes.ReadVertices(source, built, result.surfacePoints, faceOf);
	user.ReadVertices(source, result.surfacePoints, faceOf);
	if (facesToo) {
		attributes.ReadFaces(source, built, result, copy.texture.get(), faceOf);
		user.ReadFaces(source, result.facePoints, faceOf);
	}
	attributes.Write(built);
}

void buildPoints(const gpr::SamplingResult& result, const LayerCopy& copy, const CMeshO& source,
				 CMeshO& built)
{
	const std::vector<const CFaceO*> faces = liveFaces(source);
	Allocator::AddVertices(built, result.points.size());
	vcg::tri::gpr_detail::AttributesAtPoints<CMeshO> attributes;
	attributes.ReadVertices(source, built, result.surfacePoints,
							[&](std::int32_t f) { return faces[std::size_t(f)]; });
	attributes.Write(built);
	for (std::size_t s = 0; s < result.points.size(); ++s) {
		CVertexO& vertex = built.vert[s];
		vertex.P()       = pointOf(result.points[s]);
		vertex.N()       = normalAt(result.surfacePoints[s], copy);
		vertex.Q()       = Scalarm(result.radii[s]);
	}
}

void buildPlain(const gpr::TriangleMesh& mesh, CMeshO& built)
{
	addElements(mesh, built);
}

void colourFaces(const std::vector<float>& figures, double red, double blue, CMeshO& mesh)
{
	for (std::size_t f = 0; f < figures.size(); ++f) {
		mesh.face[f].Q() = Scalarm(figures[f]);
		mesh.face[f].C().SetColorRamp(float(red), float(blue), figures[f]);
	}
}

Matrix44m movedAside(const CMeshO& mesh, int place)
{
	Box3m box; // as it is shown
	for (int corner = 0; corner < 8; ++corner) {
		box.Add(mesh.Tr * mesh.bbox.P(corner));
	}
	Matrix44m shift;
	shift.SetTranslate(Scalarm(1.1) * Scalarm(place) * box.DimX(), 0, 0);
	return shift * mesh.Tr;
}

void markFeatures(const gpr::FeatureResult& result, CMeshO& mesh)
{
	mesh.svn      = 0;
	std::size_t v = 0;
	for (CVertexO& vertex : mesh.vert) {
		if (vertex.IsD()) continue;
		vertex.Q() = Scalarm(result.vertexStrength[v]);
		setSelected(vertex, result.vertexFeature[v++] != 0, mesh.svn);
	}
}

void replaceContents(CMeshO& layer, CMeshO& built)
{
	dropElementAttributes(layer);
	layer.edge.clear();
	layer.en = 0;
	swapElements(layer.vert, built.vert);
	swapElements(layer.face, built.face);
	layer.vn    = int(layer.vert.size());
	layer.fn    = int(layer.face.size());
	layer.svn   = 0;
	layer.sfn   = int(std::count_if(layer.face.begin(), layer.face.end(),
									[](const CFaceO& f) { return f.IsS(); }));
	layer.imark = 0;
	built.vn    = int(built.vert.size());
	built.fn    = int(built.face.size());
}

bool scalesUnevenly(const Matrix44m& transform)
{
	constexpr double tolerance = 0.02;
	double           gram[3][3]; // of the columns; a multiple of the identity if all scale alike
	for (int i = 0; i < 3; ++i) {
		for (int j = 0; j < 3; ++j) {
			gram[i][j] = 0;
			for (int k = 0; k < 3; ++k)
				gram[i][j] += double(transform[k][i]) * double(transform[k][j]);
		}
	}
	const double mean = (gram[0][0] + gram[1][1] + gram[2][2]) / 3;
	for (int i = 0; i < 3; ++i) {
		for (int j = 0; j < 3; ++j) {
			const double wanted = i == j ? mean : 0;
			if (!(std::abs(gram[i][j] - wanted) <= 2 * tolerance * mean)) return true;
		}
	}
	return false;
}

} // namespace gpr_filter
