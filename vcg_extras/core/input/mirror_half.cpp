// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror_half.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/symmetric_matrix.h>
#include <vcg_extras/core/carry_over.h>
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/triangle_tree.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gpr {

namespace {

constexpr int none = -1;
/// Share of the diagonal: a vertex this near to the plane lies on the plane; a plane this near to
/// the origin goes through the origin.
constexpr double onPlane = 1e-6;
/// Most vertices for the comparison of candidate planes.
constexpr int mostCompared = 20000;

Vec3d placeOf(const Surface& surface, int v)
{
	return surface.frame.toCaller(surface.mesh.position[v]);
}

Box<double> boxOf(const Surface& surface)
{
	Box<double> box;
	for (int v = 0; v < surface.mesh.vertexNum; ++v)
		box.add(placeOf(surface, v));
	return box;
}

/// Floats up to `most` hold all multiples of the returned step.
double floatStep(double most)
{
	constexpr int digits   = 24;
	int           exponent = 0;
	std::frexp(most, &exponent);
	return std::ldexp(1.0, exponent - digits);
}

MirrorPlane planeAcross(const Box<double>& box, int axis)
{
	MirrorPlane  plane;
	const double low = coordinate(box.low, axis), high = coordinate(box.high, axis);
	plane.axis         = axis;
	const double exact = 0.5 * (low + high);
	if (std::abs(exact) <= onPlane * box.diagonal()) return plane;
	// A sixteenth more than the box, as room for the moves of the fit.
	plane.step = floatStep(1.0625 * std::max(std::abs(low), std::abs(high)));
	plane.at   = plane.step * std::round(exact / plane.step);
	return plane;
}

// ---- Principal axes.

struct Moments {
	double                    area = 0;
	Vec3d                     first; ///< of the area, relative to the middle of the box
	SymmetricMatrixOf<double> second;

	Moments& operator+=(const Moments& o)
	{
		area += o.area;
		first += o.first;
		second += o.second;
		return *this;
	}
};

/// Moments of the surface of the faces: the triangulation does not matter.
Moments momentsOf(const Surface& surface, const Vec3d& middle, Workers& workers)
{
	return workers.sumEach<Moments>(std::size_t(surface.mesh.faceNum), [&](int f, Moments& sum) {
		Vec3d corner[3];
		for (int k = 0; k < 3; ++k)
			corner[k] = placeOf(surface, surface.mesh.origin[3 * f + k]) - middle;
		const Vec3d  all  = corner[0] + corner[1] + corner[2];
		const double area = 0.5 * length(cross(corner[1] - corner[0], corner[2] - corner[0]));
		sum.area += area;
		sum.first += all * (area / 3);
		for (const Vec3d& p : {corner[0], corner[1], corner[2], all})
			sum.second.addOuter(p, area / 12);
	});
}

using Matrix = std::array<std::array<double, 3>, 3>;

/// Rotates the axes and the matrix so that its entry (p, q) vanishes (Jacobi).
void rotate(Matrix& a, std::array<Vec3d, 3>& axes, std::size_t p, std::size_t q)
{
	if (a[p][q] == 0) return;
	const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
	const double t     = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
	const double c = 1 / std::sqrt(t * t + 1), s = t * c;
	const auto   turn = [c, s](auto& u, auto& v) {
        const auto before = u;
        u                 = before * c - v * s;
        v                 = before * s + v * c;
	};
	for (std::size_t k = 0; k < 3; ++k)
		turn(a[k][p], a[k][q]);
	for (std::size_t k = 0; k < 3; ++k)
		turn(a[p][k], a[q][k]);
	turn(axes[p], axes[q]);
}

std::array<Vec3d, 3> principalAxes(const SymmetricMatrixOf<double>& m)
{
	constexpr int        sweeps = 30; // five are enough
	Matrix               a      = {{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}}};
	std::array<Vec3d, 3> axes   = {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
	for (int sweep = 0; sweep < sweeps; ++sweep) {
		rotate(a, axes, 0, 1);
		rotate(a, axes, 0, 2);
		rotate(a, axes, 1, 2);
	}
	return axes;
}

/// The planes through the centroid, perpendicular to the principal axes.
std::vector<MirrorPlane> principalPlanes(const Surface& surface, const Vec3d& middle,
										 Workers& workers)
{
	const Moments             m      = momentsOf(surface, middle, workers);
	const Vec3d               centre = m.first * (1 / m.area);
	SymmetricMatrixOf<double> spread = m.second;
	spread.addOuter(centre, -m.area);
	const std::array<Vec3d, 3> axes = principalAxes(spread);
	std::vector<MirrorPlane>   planes(3);
	for (std::size_t k = 0; k < 3; ++k) {
		planes[k].axis = none;
		planes[k].row  = {axes[k], axes[(k + 1) % 3], cross(axes[k], axes[(k + 1) % 3])};
		planes[k].at   = dot(axes[k], middle + centre);
	}
	return planes;
}

// ---- Mismatch of a surface and its mirror image.

/// Compares a surface with its mirror images.
class Comparison {
public:
	Comparison(const Surface& surface, Workers& workers) :
			surface_(surface), workers_(workers), tree_(viewOf(surface.mesh), Vec3d(), workers)
	{
	}

	/// The mismatch at every stride-th vertex.
	FoundPlane with(const MirrorPlane& plane, int stride) const
	{
		const int           num = (surface_.mesh.vertexNum + stride - 1) / stride;
		std::vector<double> distance(static_cast<std::size_t>(num));
		workers_.forEach(distance.size(),
						 [&](int i) { distance[i] = ofVertex(plane, i * stride); });
		const auto most = std::max_element(distance.begin(), distance.end());
		return {plane, *most, placeOf(surface_, int(most - distance.begin()) * stride)};
	}

	/// The plane with the least mismatch. A plane with the whole surface nearer than `apart` is the
	/// plane of a flat sheet: no half lies on a side of the plane.
	FoundPlane best(const std::vector<MirrorPlane>& planes, double apart) const
	{
		const int               stride = std::max(1, surface_.mesh.vertexNum / mostCompared);
		std::vector<FoundPlane> found;
		for (const MirrorPlane& plane : planes) {
			if (!isFlatIn(plane, apart)) found.push_back(with(plane, stride));
		}
		if (found.empty()) return with(planes.front(), 1);
		const auto least = std::min_element(
			found.begin(), found.end(),
			[](const FoundPlane& a, const FoundPlane& b) { return a.mismatch < b.mismatch; });
		return with(least->plane, 1);
	}

private:
	const Surface& surface_;
	Workers&       workers_;
	TriangleTree   tree_;

	bool isFlatIn(const MirrorPlane& plane, double apart) const
	{
		for (int v = 0; v < surface_.mesh.vertexNum; ++v) {
			const Vec3d p = plane.toPlane(placeOf(surface_, v));
			if (std::abs(coordinate(p, plane.heightAxis())) > apart) return false;
		}
		return true;
	}

	double ofVertex(const MirrorPlane& plane, int v) const
	{
		const Frame& frame = surface_.frame;
		const Vec3d  image = (plane.imageOf(placeOf(surface_, v)) - frame.origin) * frame.scale;
		return std::sqrt(tree_.nearest(image).squared) / frame.scale;
	}
};

// ---- Cutting.

/// A corner of the kept part of a face.
struct CutCorner {
	std::int32_t vertex;
	std::uint8_t line; ///< of the edge from here to the next corner
};

class HalfCutter {
public:
	HalfCutter(const Surface& surface, const MirrorPlane& plane, Workers& workers) :
			surface_(surface), m_(surface.mesh), plane_(plane), workers_(workers),
			nameOf_(std::size_t(surface.mesh.vertexNum), none)
	{
	}

	MirrorHalf run()
	{
		findPlaces();
		Poller poller(workers_);
		for (int f = 0; f < m_.faceNum; ++f) {
			poller.count();
			cut(f);
		}
		return std::move(out_);
	}

private:
	static constexpr std::uint8_t unmarked = 0;

	const Surface&      surface_;
	const HalfEdgeMesh& m_;
	const MirrorPlane&  plane_;
	Workers&            workers_;
	std::vector<Vec3d>  place_;                 ///< per vertex of the surface, in the plane's
												///< coordinates
	std::vector<std::int32_t>          nameOf_; ///< per vertex of the surface: vertex of the half
	std::map<std::pair<int, int>, int> onEdge_; ///< by the ends of an edge: vertex of the half
	std::vector<CutCorner>             rest_;
	MirrorHalf                         out_;

	double height(int v) const { return coordinate(place_[v], plane_.heightAxis()); }

	void findPlaces()
	{
		const double near = onPlane * boxOf(surface_).diagonal();
		for (int v = 0; v < m_.vertexNum; ++v) {
			place_.push_back(plane_.toPlane(placeOf(surface_, v)));
			if (std::abs(height(v)) <= near) setCoordinate(place_.back(), plane_.heightAxis(), 0.0);
		}
	}

	void cut(int f)
	{
		rest_.clear();
		double highest = 0;
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			highest = std::max(highest, height(m_.origin[h]));
		if (highest == 0) return;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			const int          a = m_.origin[h], b = m_.target(h);
			const std::uint8_t line = m_.isCreaseEdge(h);
			// An edge along the plane becomes border; an edge that leads down from the plane has
			// no part above.
			const bool isBelow = height(a) == 0 && height(b) < 0;
			if (height(a) >= 0) rest_.push_back({nameOfVertex(a), isBelow ? unmarked : line});
			if (height(a) * height(b) < 0)
				rest_.push_back({nameOnEdge(f, a, b), height(b) > 0 ? line : unmarked});
		}
		addFaces(f);
	}

	std::int32_t add(const Vec3d& place, const SurfacePoint& point)
	{
		out_.positions.push_back(place);
		out_.point.push_back(point);
		return std::int32_t(out_.positions.size()) - 1;
	}

	std::int32_t nameOfVertex(int v)
	{
		std::int32_t& name = nameOf_[v];
		if (name == none) name = add(place_[v], pointOfVertex(surface_, v));
		return name;
	}

	std::int32_t nameOnEdge(int f, int a, int b)
	{
		if (b < a) std::swap(a, b);
		const auto [entry, isNew] = onEdge_.try_emplace({a, b}, none);
		if (!isNew) return entry->second;
		const double share = height(a) / (height(a) - height(b));
		Vec3d        place = place_[a] + (place_[b] - place_[a]) * share;
		setCoordinate(place, plane_.heightAxis(), 0.0);
		const Vec3f at       = m_.position[a] + (m_.position[b] - m_.position[a]) * float(share);
		return entry->second = add(place, {at, f});
	}

	/// Adds a triangle, or two triangles of a quadrilateral, cut along its shorter diagonal.
	void addFaces(int f)
	{
		if (rest_.size() == 3) return addFace(f, rest_[0], rest_[1], rest_[2]);
		const auto between = [&](std::size_t a, std::size_t b) {
			return length(out_.positions[rest_[a].vertex] - out_.positions[rest_[b].vertex]);
		};
		if (between(1, 3) < between(0, 2))
			std::rotate(rest_.begin(), rest_.begin() + 1, rest_.end());
		const CutCorner first = {rest_[0].vertex, unmarked}, third = {rest_[2].vertex, unmarked};
		addFace(f, rest_[0], rest_[1], third);
		addFace(f, first, rest_[2], rest_[3]);
	}

	void addFace(int f, const CutCorner& a, const CutCorner& b, const CutCorner& c)
	{
		for (const CutCorner& corner : {a, b, c}) {
			out_.triangles.push_back(corner.vertex);
			out_.line.push_back(corner.line);
		}
		out_.faceOf.push_back(f);
	}
};

/// Carries the input's values of vertices and faces over.
void carryOver(const MeshView& input, const Surface& surface, MirrorHalf& half)
{
	for (const SurfacePoint& point : half.point) {
		if (input.selected == nullptr && input.wantedEdge == nullptr) break;
		const BarycentricPoint at       = barycentricPoint(input, surface, point);
		const auto             vertexAt = [&](int k) {
            return std::size_t(input.vertexOf(3 * std::size_t(at.face) + std::size_t(k)));
		};
		if (input.selected != nullptr)
			half.selected.push_back(input.selected[vertexAt(nearestCorner(at))]);
		if (input.wantedEdge != nullptr) {
			half.wantedEdge.push_back(
				float(meanOfCorners(at, [&](int k) { return input.wantedEdge[vertexAt(k)]; })));
		}
	}
	if (input.region == nullptr) return;
	for (std::int32_t f : half.faceOf)
		half.region.push_back(input.region[surface.sourceFace[f]]);
}

} // namespace

Vec3d MirrorPlane::toPlane(const Vec3d& p) const
{
	if (axis < 0) return {dot(row[0], p) - at, dot(row[1], p), dot(row[2], p)};
	Vec3d q = p;
	setCoordinate(q, axis, coordinate(p, axis) - at);
	return q;
}

Vec3d MirrorPlane::toCaller(const Vec3d& q) const
{
	if (axis < 0) return row[0] * (q.x + at) + row[1] * q.y + row[2] * q.z;
	Vec3d p = q;
	setCoordinate(p, axis, coordinate(q, axis) + at);
	return p;
}

Vec3d MirrorPlane::rounded(Vec3d q) const
{
	const double height = coordinate(q, heightAxis());
	if (step > 0 && height > 0)
		setCoordinate(q, heightAxis(), step * std::max(1.0, std::round(height / step)));
	return q;
}

Vec3d MirrorPlane::mirrored(Vec3d q) const
{
	setCoordinate(q, heightAxis(), -coordinate(q, heightAxis()));
	return q;
}

FoundPlane findMirrorPlane(const Surface& surface, Symmetry symmetry, double allowed,
						   Workers& workers)
{
	const Box<double> box = boxOf(surface);
	const Comparison  comparison(surface, workers);
	if (symmetry != Symmetry::Auto)
		return comparison.with(planeAcross(box, int(symmetry) - int(Symmetry::X)), 1);
	const FoundPlane ofAxes =
		comparison.best({planeAcross(box, 0), planeAcross(box, 1), planeAcross(box, 2)}, allowed);
	if (ofAxes.mismatch <= allowed) return ofAxes;
	const Vec3d      middle = (box.low + box.high) * 0.5;
	const FoundPlane principal =
		comparison.best(principalPlanes(surface, middle, workers), allowed);
	return principal.mismatch < ofAxes.mismatch ? principal : ofAxes;
}

MeshView MirrorHalf::view(const MeshView& input, const MirrorPlane& plane) const
{
	MeshView v = MarkedMesh::view();
	if (input.line == nullptr) v.line = nullptr;
	v.regionNames = input.regionNames;
	v.mirrorAxis  = plane.heightAxis();
	return v;
}

MirrorHalf cutHalf(const MeshView& input, const Surface& surface, const MirrorPlane& plane,
				   Workers& workers)
{
	MirrorHalf half = HalfCutter(surface, plane, workers).run();
	carryOver(input, surface, half);
	return half;
}

} // namespace gpr
