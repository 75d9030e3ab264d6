// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_distance.h"

#include <vcg_extras/core/surface/distance_histogram.h>
#include <vcg_extras/core/surface/even_points.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gpr::app {

namespace {

using Kernel   = CGAL::Simple_cartesian<double>;
using Point    = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;

/// The mesh behind a tree; its points are moved to the origin, so that no digit is lost to an
/// offset.
struct TargetMesh {
	MeshView view;
	Vec3d    origin;

	Point point(std::size_t v) const { return local(view.position(v)); }
	Point local(const Vec3d& p) const { return {p.x - origin.x, p.y - origin.y, p.z - origin.z}; }
};

/// A triangle of the mesh as CGAL's tree wants it: the index here, the corners from the mesh.
class FacePrimitive {
public:
	using Id          = std::int32_t;
	using Point       = gpr::app::Point;
	using Datum       = Triangle;
	using Shared_data = const TargetMesh*;

	FacePrimitive() = default;
	FacePrimitive(std::vector<std::int32_t>::const_iterator face, Shared_data) : face_(*face) {}

	static Shared_data construct_shared_data(Shared_data mesh) { return mesh; }

	const Id& id() const { return face_; }
	Point     reference_point(Shared_data mesh) const { return corner(mesh, 0); }
	Datum     datum(Shared_data mesh) const
	{
		return {corner(mesh, 0), corner(mesh, 1), corner(mesh, 2)};
	}

private:
	Id face_ = -1;

	Point corner(Shared_data mesh, int k) const
	{
		return mesh->point(std::size_t(mesh->view.vertexOf(3 * std::size_t(face_) + k)));
	}
};

using FaceTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, FacePrimitive>>;

/// Sums over some of the points.
struct DistanceSums {
	double sum = 0, squares = 0, max = 0;

	void add(double distance)
	{
		sum += distance;
		squares += distance * distance;
		max = std::max(max, distance);
	}
	DistanceSums& operator+=(const DistanceSums& o)
	{
		sum += o.sum;
		squares += o.squares;
		max = std::max(max, o.max);
		return *this;
	}
};

std::vector<char> usedVertices(const MeshView& mesh)
{
	std::vector<char> used(mesh.vertexNum, 0);
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		if (!isUsableFace(mesh, f)) continue;
		for (int k = 0; k < 3; ++k)
			used[mesh.vertexOf(3 * f + k)] = 1;
	}
	return used;
}

/// Nearest points, one query after the other: the last answer bounds the next search, which is
/// quick where the points follow each other on the surface.
class NearestSearch {
public:
	NearestSearch(const FaceTree& tree, const TargetMesh& mesh) :
			tree_(tree), mesh_(mesh), last_(tree.any_reference_point_and_id())
	{
	}

	double distance(const Vec3d& from)
	{
		const Point p = mesh_.local(from);
		last_         = tree_.closest_point_and_primitive(p, last_);
		return std::sqrt(CGAL::squared_distance(p, last_.first));
	}

private:
	const FaceTree&                  tree_;
	const TargetMesh&                mesh_;
	FaceTree::Point_and_primitive_id last_;
};

FarPoint farthestPointOf(const MeshView& mesh, std::size_t face, NearestSearch& nearest)
{
	const auto  t = mesh.triangle(face);
	const Vec3d a = mesh.position(std::size_t(t[0])), b = mesh.position(std::size_t(t[1])),
				c     = mesh.position(std::size_t(t[2]));
	FarPoint farthest = {a, nearest.distance(a)};
	for (const Vec3d& p :
		 {b, c, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5, (a + b + c) * (1. / 3)}) {
		const double distance = nearest.distance(p);
		if (distance > farthest.distance) farthest = {p, distance};
	}
	return farthest;
}

} // namespace

struct DistanceTarget::Tree {
	TargetMesh                mesh;
	std::vector<std::int32_t> faces;
	FaceTree                  tree;

	NearestSearch search() const { return {tree, mesh}; }

	DistanceSums sumOfSamples(const MeshView& from, std::int64_t num, Workers& workers,
							  DistanceHistogram& histogram) const;
	double       largestOfVertices(const MeshView& from, const std::vector<char>& used,
								   Workers& workers) const;
};

DistanceSums DistanceTarget::Tree::sumOfSamples(const MeshView& from, std::int64_t num,
												Workers&           workers,
												DistanceHistogram& histogram) const
{
	const EvenPoints points(from, num);
	return workers.sum<DistanceSums>(points.num(), [&](std::size_t begin, std::size_t end) {
		NearestSearch nearest = search();
		DistanceSums  part;
		points.forEach(begin, end, [&](const Vec3d& point) {
			const double d = nearest.distance(point);
			part.add(d);
			histogram.add(d);
		});
		return part;
	});
}

double DistanceTarget::Tree::largestOfVertices(const MeshView& from, const std::vector<char>& used,
											   Workers& workers) const
{
	return workers
		.sum<DistanceSums>(from.vertexNum,
						   [&](std::size_t begin, std::size_t end) {
							   NearestSearch nearest = search();
							   DistanceSums  part;
							   for (std::size_t v = begin; v < end; ++v)
								   if (used[v] != 0) part.add(nearest.distance(from.position(v)));
							   return part;
						   })
		.max;
}

DistanceTarget::DistanceTarget(const MeshView& mesh) : tree_(std::make_unique<Tree>())
{
	tree_->mesh.view = mesh;
	for (std::size_t f = 0; f < mesh.faceNum; ++f)
		if (isUsableFace(mesh, f)) tree_->faces.push_back(std::int32_t(f));
	if (tree_->faces.empty()) return;
	tree_->mesh.origin = mesh.position(std::size_t(mesh.vertexOf(3 * tree_->faces.front())));
	const TargetMesh* const shared = &tree_->mesh;
	tree_->tree.insert(tree_->faces.cbegin(), tree_->faces.cend(), shared);
	tree_->tree.do_not_accelerate_distance_queries(); // the last answer is the better hint
	tree_->tree.build();
}

DistanceTarget::~DistanceTarget() = default;

DistanceFigures DistanceTarget::from(const MeshView& mesh, std::int64_t sampleNum,
									 Workers& workers) const
{
	DistanceFigures         figures;
	const std::vector<char> used = usedVertices(mesh);
	figures.vertexNum            = std::count(used.begin(), used.end(), 1);
	if (tree_->faces.empty() || figures.vertexNum == 0) return figures;
	DistanceHistogram  histogram;
	const DistanceSums sums = tree_->sumOfSamples(mesh, sampleNum, workers, histogram);
	figures.sampleNum       = sampleNum;
	figures.mean            = sums.sum / double(sampleNum);
	figures.rms             = std::sqrt(sums.squares / double(sampleNum));
	figures.p999            = histogram.p999(sums.max);
	figures.max             = std::max(sums.max, tree_->largestOfVertices(mesh, used, workers));
	return figures;
}

std::vector<FarPoint> DistanceTarget::farthestPoints(const MeshView&                   mesh,
													 const std::vector<std::uint32_t>& faces,
													 Workers& workers) const
{
	std::vector<FarPoint> points(faces.size());
	if (tree_->faces.empty()) return points;
	workers.forRange(faces.size(), [&](std::size_t begin, std::size_t end) {
		NearestSearch nearest = tree_->search();
		for (std::size_t i = begin; i < end; ++i)
			points[i] = farthestPointOf(mesh, faces[i], nearest);
	});
	return points;
}

std::int64_t distanceSampleNum(std::size_t resultFaceNum)
{
	return std::clamp<std::int64_t>(10 * std::int64_t(resultFaceNum), 200000, 2000000);
}

} // namespace gpr::app
