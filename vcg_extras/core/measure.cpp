// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gpr {

namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

/// Disjoint sets with path halving that threads may join at once (Anderson and Woll 1991): a root
/// is only ever put below a smaller one, by compare and swap, and ways are shortened by any value
/// that lies farther up. Which sets come out does not depend on the order.
class DisjointSets {
public:
	explicit DisjointSets(std::size_t n) : parent_(n)
	{
		std::iota(parent_.begin(), parent_.end(), 0);
	}

	int find(int x)
	{
		for (;;) {
			const int up = load(x);
			if (up == x) return x;
			const int farther = load(up);
			__atomic_store_n(&parent_[x], farther, __ATOMIC_RELAXED);
			x = farther;
		}
	}
	void unite(int a, int b)
	{
		for (;;) {
			a = find(a);
			b = find(b);
			if (a == b) return;
			if (a < b) std::swap(a, b);
			int root = a;
			if (__atomic_compare_exchange_n(&parent_[a], &root, b, false, __ATOMIC_RELAXED,
											__ATOMIC_RELAXED))
				return;
		}
	}
	bool isRoot(int x) const { return parent_[x] == x; }

private:
	Buffer<int> parent_;

	int load(int x) const { return __atomic_load_n(&parent_[x], __ATOMIC_RELAXED); }
};

struct EdgeUse {
	int low, high, face;

	bool operator<(const EdgeUse& o) const
	{
		if (low != o.low) return low < o.low;
		return high != o.high ? high < o.high : face < o.face;
	}
};

std::vector<EdgeUse> sortedEdges(const MeshView& mesh)
{
	std::vector<EdgeUse> edges;
	edges.reserve(3 * mesh.faceNum);
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		const auto t = mesh.triangle(f);
		for (int k = 0; k < 3; ++k) {
			const int a = t[k], b = t[(k + 1) % 3];
			edges.push_back({std::min(a, b), std::max(a, b), int(f)});
		}
	}
	std::sort(edges.begin(), edges.end());
	return edges;
}

/// Fills components, boundaryLoops and eulerCharacteristic.
void measureTopology(const MeshView& mesh, MeshFigures& figures)
{
	const std::vector<EdgeUse> edges = sortedEdges(mesh);
	DisjointSets               faces(mesh.faceNum), rim(mesh.vertexNum);
	std::vector<char>          used(mesh.vertexNum, 0), onRim(mesh.vertexNum, 0);
	std::int64_t               edgeNum = 0;
	for (std::size_t i = 0; i < edges.size();) {
		std::size_t end = i + 1;
		while (end < edges.size() && edges[end].low == edges[i].low &&
			   edges[end].high == edges[i].high) {
			faces.unite(edges[i].face, edges[end].face);
			++end;
		}
		++edgeNum;
		used[edges[i].low] = used[edges[i].high] = 1;
		if (end - i == 1) {
			rim.unite(edges[i].low, edges[i].high);
			onRim[edges[i].low] = onRim[edges[i].high] = 1;
		}
		i = end;
	}
	for (std::size_t f = 0; f < mesh.faceNum; ++f)
		figures.components += faces.isRoot(int(f));
	std::int64_t usedNum = 0;
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		usedNum += used[v];
		figures.boundaryLoops += onRim[v] && rim.isRoot(int(v));
	}
	figures.eulerCharacteristic = usedNum - edgeNum + std::int64_t(mesh.faceNum);
}

struct Extent {
	Vec3d low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
	Vec3d high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

	void add(const Vec3d& p)
	{
		if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) return;
		low  = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
		high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
	}
	Extent& operator+=(const Extent& o)
	{
		add(o.low);
		add(o.high);
		return *this;
	}
	double diagonal() const { return high.x >= low.x ? length(high - low) : 0; }
};

/// 2 inradius / circumradius of a triangle with these edges and this area, two times:
/// inradius = doubled / (a + b + c), circumradius = a b c / (2 doubled).
double ratioOfRadii(double a, double b, double c, double doubled)
{
	return 4 * doubled * doubled / ((a + b + c) * a * b * c);
}

/// Sums and extremes of the shapes of some faces.
struct ShapeSums {
	double       radiusRatio = 0, radiusRatioMin = 1;
	double       aspectRatio = 0, aspectRatioMin = 1;
	double       minAngle = 0, minAngleMin = 4, maxAngle = 0;
	double       edgeLen = 0;
	std::int64_t below30 = 0;

	ShapeSums& operator+=(const ShapeSums& o)
	{
		radiusRatio += o.radiusRatio;
		radiusRatioMin = std::min(radiusRatioMin, o.radiusRatioMin);
		aspectRatio += o.aspectRatio;
		aspectRatioMin = std::min(aspectRatioMin, o.aspectRatioMin);
		minAngle += o.minAngle;
		minAngleMin = std::min(minAngleMin, o.minAngleMin);
		maxAngle    = std::max(maxAngle, o.maxAngle);
		edgeLen += o.edgeLen;
		below30 += o.below30;
		return *this;
	}

	void add(const Vec3d& p, const Vec3d& q, const Vec3d& s)
	{
		const double a = length(s - q), b = length(s - p), c = length(q - p);
		const double doubled = length(cross(q - p, s - p)); // two times the area
		const double longest = std::max({a, b, c});
		if (std::isfinite(longest)) edgeLen += (a + b + c) / 3;
		if (!(doubled > 0) || !std::isfinite(doubled)) {
			radiusRatioMin = aspectRatioMin = minAngleMin = 0;
			++below30;
			return;
		}
		const double radius = ratioOfRadii(a, b, c, doubled);
		const double aspect = 2 * std::sqrt(3.0) * doubled / ((a + b + c) * longest);
		radiusRatio += radius;
		radiusRatioMin = std::min(radiusRatioMin, radius);
		aspectRatio += aspect;
		aspectRatioMin         = std::min(aspectRatioMin, aspect);
		const double angles[3] = {std::atan2(doubled, dot(q - p, s - p)),
								  std::atan2(doubled, dot(p - q, s - q)),
								  std::atan2(doubled, dot(p - s, q - s))};
		const double smallest  = std::min({angles[0], angles[1], angles[2]});
		minAngle += smallest;
		minAngleMin = std::min(minAngleMin, smallest);
		maxAngle    = std::max({maxAngle, angles[0], angles[1], angles[2]});
		below30 += smallest * degrees < 30;
	}
};

/// Share of vertices with six faces among those not at a border, in percent.
double valence6Percent(const MeshView& mesh)
{
	// At an inner vertex every neighbour is named twice by the ring's outer edges, once as start
	// and once as end: signed sums over the ring cancel exactly there, and at a border almost
	// surely not.
	std::vector<int>           faces(mesh.vertexNum, 0);
	std::vector<std::uint64_t> balance(mesh.vertexNum, 0);
	const auto hash = [](std::int32_t v) { return (std::uint64_t(v) + 1) * 0x9e3779b97f4a7c15ull; };
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		const auto t = mesh.triangle(f);
		for (int k = 0; k < 3; ++k) {
			++faces[t[k]];
			balance[t[k]] += hash(t[(k + 1) % 3]) - hash(t[(k + 2) % 3]);
		}
	}
	std::int64_t inner = 0, six = 0;
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		if (faces[v] == 0 || balance[v] != 0) continue;
		++inner;
		six += faces[v] == 6;
	}
	return inner > 0 ? 100.0 * double(six) / double(inner) : 0;
}

} // namespace

MeshFigures measureMesh(const MeshView& mesh)
{
	MeshFigures figures;
	figures.vertices = std::int64_t(mesh.vertexNum);
	figures.faces    = std::int64_t(mesh.faceNum);
	measureTopology(mesh, figures);
	Extent extent;
	for (std::size_t i = 0; i < 3 * mesh.faceNum; ++i)
		extent.add(mesh.position(mesh.vertexOf(i)));
	figures.diagonal = extent.diagonal();
	for (std::size_t f = 0; f < mesh.faceNum; ++f) {
		const auto   t    = mesh.triangle(f);
		const Vec3d  a    = mesh.position(t[0]);
		const double area = 0.5 * length(cross(mesh.position(t[1]) - a, mesh.position(t[2]) - a));
		if (std::isfinite(area)) figures.area += area;
	}
	return figures;
}

std::vector<float> radiusRatios(const MeshView& mesh, Workers& workers)
{
	std::vector<float> ratios(mesh.faceNum, 0);
	workers.forRange(mesh.faceNum, [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			const auto   t = mesh.triangle(f);
			const Vec3d  p = mesh.position(t[0]), q = mesh.position(t[1]), s = mesh.position(t[2]);
			const double doubled = length(cross(q - p, s - p));
			const double ratio = ratioOfRadii(length(s - q), length(s - p), length(q - p), doubled);
			if (doubled > 0 && std::isfinite(ratio)) ratios[f] = float(ratio);
		}
	});
	return ratios;
}

QualityFigures measureQuality(const MeshView& mesh, int threads)
{
	Workers workers(threads, nullptr);
	return measureQuality(mesh, workers);
}

QualityFigures measureQuality(const MeshView& mesh, Workers& workers)
{
	QualityFigures q;
	if (mesh.faceNum == 0) return q;
	const ShapeSums sums =
		workers.sum<ShapeSums>(mesh.faceNum, [&](std::size_t begin, std::size_t end) {
			ShapeSums part;
			for (std::size_t f = begin; f < end; ++f) {
				const auto t = mesh.triangle(f);
				part.add(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
			}
			return part;
		});
	const double n    = double(mesh.faceNum);
	q.radiusRatioMean = sums.radiusRatio / n;
	q.radiusRatioMin  = sums.radiusRatioMin;
	q.aspectRatioMean = sums.aspectRatio / n;
	q.aspectRatioMin  = sums.aspectRatioMin;
	q.minAngleDeg     = sums.minAngleMin * degrees;
	q.meanMinAngleDeg = sums.minAngle / n * degrees;
	q.maxAngleDeg     = sums.maxAngle * degrees;
	q.below30Percent  = 100 * double(sums.below30) / n;
	q.meanEdgeLen     = sums.edgeLen / n;
	q.valence6Percent = valence6Percent(mesh);
	return q;
}

MeshFigures figuresOf(const HalfEdgeMesh& m, double unit, Workers& workers)
{
	MeshFigures figures;
	figures.vertices = m.vertexNum;
	figures.faces    = m.faceNum;
	DisjointSets       sets(m.vertexNum), rims(m.vertexNum);
	const std::int64_t borderEdges =
		workers.sum<std::int64_t>(m.faceNum, [&](std::size_t begin, std::size_t end) {
			std::int64_t found = 0;
			for (int f = int(begin); f < int(end); ++f) {
				const int* v = &m.origin[3 * f];
				sets.unite(v[0], v[1]);
				sets.unite(v[0], v[2]);
				for (int h = 3 * f; h < 3 * f + 3; ++h) {
					if (m.opposite[h] >= 0) continue;
					++found;
					rims.unite(m.origin[h], m.target(h));
				}
			}
			return found;
		});
	figures.components =
		workers.sum<std::int64_t>(m.vertexNum, [&](std::size_t begin, std::size_t end) {
			std::int64_t roots = 0;
			for (std::size_t v = begin; v < end; ++v)
				roots += sets.isRoot(int(v));
			return roots;
		});
	if (borderEdges > 0) {
		for (int v = 0; v < m.vertexNum; ++v)
			figures.boundaryLoops += m.isBorderVertex(v) && rims.isRoot(v);
	}
	const std::int64_t edges    = (std::int64_t(m.halfEdgeNum()) + borderEdges) / 2;
	figures.eulerCharacteristic = std::int64_t(m.vertexNum) - edges + m.faceNum;
	figures.area =
		unit * unit * workers.sum<double>(m.faceNum, [&](std::size_t begin, std::size_t end) {
			double area = 0;
			for (std::size_t f = begin; f < end; ++f)
				area += 0.5 * double(length(m.faceCross(int(f))));
			return area;
		});
	const Extent extent = workers.sum<Extent>(m.vertexNum, [&](std::size_t begin, std::size_t end) {
		Extent part;
		for (std::size_t v = begin; v < end; ++v)
			part.add(Vec3d(m.position[v]));
		return part;
	});
	figures.diagonal    = unit * extent.diagonal();
	return figures;
}

} // namespace gpr
