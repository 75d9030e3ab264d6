// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_distance.h"

#include "distance_histogram.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gpr {

namespace {

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
		for (const std::int32_t v : mesh.triangle(f))
			used[v] = 1;
	}
	return used;
}

/// The running area behind each face of a mesh.
std::vector<double> runningArea(const MeshView& mesh)
{
	std::vector<double> behind(mesh.faceNum);
	double              area = 0;
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		if (isUsableFace(mesh, f)) area += 0.5 * length(mesh.faceCross(f));
		behind[f] = area;
	}
	return behind;
}

/// Point number j of the R2 sequence (Roberts 2018: the additive recurrence by the plastic number)
/// in a face; the upper half of the unit square is folded onto the lower.
Vec3d pointInFace(const MeshView& mesh, std::size_t face, std::size_t j)
{
	constexpr double stepU = 0.7548776662466927, stepV = 0.5698402909980532;
	const auto       t = mesh.triangle(face);
	double           u = stepU * double(j), v = stepV * double(j);
	u -= std::floor(u);
	v -= std::floor(v);
	if (u + v > 1) {
		u = 1 - u;
		v = 1 - v;
	}
	const Vec3d a = mesh.position(t[0]);
	return a + (mesh.position(t[1]) - a) * u + (mesh.position(t[2]) - a) * v;
}

/// Seven points of a face: its corners, the middles of its edges, its own middle.
std::array<Vec3d, 7> sevenPoints(const MeshView& mesh, std::size_t face)
{
	const auto  t = mesh.triangle(face);
	const Vec3d a = mesh.position(std::size_t(t[0])), b = mesh.position(std::size_t(t[1])),
				c = mesh.position(std::size_t(t[2]));
	return {a, b, c, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5, (a + b + c) * (1.0 / 3)};
}

/// Origin for the positions, so that no digit is lost to an offset.
Vec3d someCorner(const MeshView& mesh)
{
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		for (const std::int32_t v : mesh.triangle(f)) {
			if (v < 0 || std::size_t(v) >= mesh.vertexNum) continue;
			const Vec3d p = mesh.position(std::size_t(v));
			if (isFinite(p)) return p;
		}
	}
	return {};
}

} // namespace

/// A sequence of searches. The last answer bounds the next search: quick for points that follow
/// each other on the surface.
class MeasuredSurface::Search {
public:
	explicit Search(const MeasuredSurface& to) : to_(to) {}

	double distance(const Vec3d& p)
	{
		const TriangleTree::Nearest nearest = to_.tree_.nearest(p - to_.origin_, last_);
		last_                               = nearest.triangle;
		return std::sqrt(nearest.squared);
	}

	double meanSquare(const std::array<Vec3d, 7>& p)
	{
		double mean = 0;
		for (std::size_t k = 0; k < p.size(); ++k) {
			const double d = distance(p[k]);
			mean += (k < 3 ? 1.0 / 20 : k < 6 ? 2.0 / 15 : 9.0 / 20) * d * d;
		}
		return mean;
	}

	FarthestPoint farthest(const std::array<Vec3d, 7>& points)
	{
		FarthestPoint farthest = {points[0], -1};
		for (const Vec3d& p : points) {
			const double d = distance(p);
			if (d > farthest.distance) farthest = {p, d};
		}
		return farthest;
	}

private:
	const MeasuredSurface& to_;
	int                    last_ = -1;
};

MeasuredSurface::MeasuredSurface(const MeshView& mesh, Workers& workers) :
		origin_(someCorner(mesh)), tree_(mesh, origin_, workers)
{
}

MeasuredSurface::MeasuredSurface(const MeshView& mesh, const MeasuredSurface& other,
								 Workers& workers) :
		origin_(other.origin_),
		tree_(mesh, origin_, workers)
{
}

DistanceFigures MeasuredSurface::from(const MeshView& mesh, std::int64_t sampleNum,
									  Workers& workers) const
{
	DistanceFigures         figures;
	const std::vector<char> used = usedVertices(mesh);
	figures.vertexNum            = std::count(used.begin(), used.end(), 1);
	if (tree_.size() == 0 || figures.vertexNum == 0) return figures;
	const auto ofVertices = [&](std::size_t begin, std::size_t end) {
		Search       search(*this);
		DistanceSums part;
		for (std::size_t v = begin; v < end; ++v)
			if (used[v] != 0) part.add(search.distance(mesh.position(v)));
		return part;
	};
	figures.vertexMax = workers.sum<DistanceSums>(mesh.vertexNum, ofVertices).max;
	figures.max       = figures.vertexMax;
	measureArea(mesh, sampleNum, workers, figures);
	return figures;
}

/// Measures points spread evenly over the area.
void MeasuredSurface::measureArea(const MeshView& mesh, std::int64_t sampleNum, Workers& workers,
								  DistanceFigures& figures) const
{
	const std::vector<double> area = runningArea(mesh);
	if (!(area.back() > 0)) return;
	// Systematic sampling: point j lies at the share (j + 1/2) / num of the running area.
	const double      num = double(sampleNum), spacing = area.back() / num;
	const auto        areaAt = [spacing](std::size_t j) { return (double(j) + 0.5) * spacing; };
	DistanceHistogram histogram;
	const auto        ofPoints = [&](std::size_t begin, std::size_t end) {
        Search       search(*this);
        DistanceSums part;
        auto         face = std::upper_bound(area.begin(), area.end() - 1, areaAt(begin));
        for (std::size_t j = begin; j < end; ++j) {
            while (*face <= areaAt(j) && face != area.end() - 1)
                ++face;
            const std::size_t f = std::size_t(face - area.begin());
            const double      d = search.distance(pointInFace(mesh, f, j));
            part.add(d);
            histogram.add(d);
        }
        return part;
	};
	const DistanceSums sums = workers.sum<DistanceSums>(std::size_t(sampleNum), ofPoints);
	figures.sampleNum       = sampleNum;
	figures.mean            = sums.sum / num;
	figures.rms             = std::sqrt(sums.squares / num);
	figures.p999            = histogram.p999(sums.max);
	figures.max             = std::max(figures.max, sums.max);
}

std::vector<float> MeasuredSurface::ofFaces(const MeshView& mesh, Workers& workers) const
{
	std::vector<float> distances(mesh.faceNum, 0);
	if (tree_.size() == 0) return distances;
	workers.forRange(mesh.faceNum, [&](std::size_t begin, std::size_t end) {
		Search search(*this);
		for (std::size_t f = begin; f < end; ++f)
			if (isUsableFace(mesh, f))
				distances[f] = float(std::sqrt(search.meanSquare(sevenPoints(mesh, f))));
	});
	return distances;
}

std::vector<FarthestPoint> MeasuredSurface::farthestPoints(const MeshView&                   mesh,
														   const std::vector<std::uint32_t>& faces,
														   Workers& workers) const
{
	std::vector<FarthestPoint> points(faces.size());
	if (tree_.size() == 0) return points;
	workers.forRange(faces.size(), [&](std::size_t begin, std::size_t end) {
		Search search(*this);
		for (std::size_t i = begin; i < end; ++i)
			points[i] = search.farthest(sevenPoints(mesh, faces[i]));
	});
	return points;
}

std::int64_t distanceSampleNum(std::size_t resultFaceNum)
{
	return std::clamp<std::int64_t>(10 * std::int64_t(resultFaceNum), 200000, 2000000);
}

SampledDistance sampledDistance(const MeasuredMesh& input, const MeasuredMesh& result,
								int pointsPerFace, Workers& workers)
{
	const std::int64_t sampleNum =
		std::int64_t(pointsPerFace) * std::clamp(result.mesh.faceNum, 2000, 20000);
	const DistanceFigures there = input.surface.from(viewOf(result.mesh), sampleNum, workers);
	const DistanceFigures back  = result.surface.from(viewOf(input.mesh), sampleNum, workers);
	return {{there, back}, there.vertexMax};
}

} // namespace gpr
