// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing.h"

#include "error_sizes.h"
#include "size_grading.h"
#include "target.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/measure.h>

#include <algorithm>
#include <cmath>

namespace gpr {

namespace {

/// Area mean of 1/size², for sizes at the vertices; 1 if the area is zero. The number of triangles
/// is proportional to this mean.
double meanSquaredStretch(const Surface& surface, const Buffer<float>& size, Workers& workers)
{
	const double area = workers.sumEach<double>(
		size.size(), [&](int v, double& sum) { sum += double(surface.area[v].value()); });
	const double weighted = workers.sumEach<double>(size.size(), [&](int v, double& sum) {
		const double here = size[v];
		sum += double(surface.area[v].value()) / (here * here);
	});
	return area > 0 ? weighted / area : 1;
}

/// Largest growth of sizes over distance, both in units of the largest radius. Faster growth makes
/// small angles.
float gradingSlope(const SizingRequest& request)
{
	const float slope = float(request.options.growth - 1);
	return request.options.targetMode == TargetMode::MaxError
			   ? std::max(slope, rangeWithinError.slope)
			   : slope;
}
/// For λ above 0: the largest triangles are at most this many times larger than the smallest.
constexpr float largestStretch = 4;
/// Smallest 1 + λH of the equations as printed.
constexpr float minPrintedStretch = 0.1f;
/// More ring passes than this would take longer than the remeshing.
constexpr int maxCurvaturePasses = 200;

/// A curvature integrated over faces, and the area of the faces. Both are averaged alike, so that
/// the quotient is an area mean.
struct CurvatureSum {
	float curvature = 0;
	float area      = 0;
};

Buffer<Vec3f> vertexNormals(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<Vec3f> normal(m.vertexNum);
	workers.forEach(m.vertexNum, [&](int v) {
		Vec3f sum;
		forEachOutgoing(m, v, [&](int h) { sum += m.faceCross(h / 3); });
		normal[v] = normalized(sum);
	});
	return normal;
}

/// Mean curvature integrated over a face. Each corner adds half of its normal times the integral of
/// the gradient of its hat function, which is half the opposite edge turned inwards.
float integratedCurvature(const HalfEdgeMesh& m, const Buffer<Vec3f>& normal, int f)
{
	const Vec3f faceNormal = m.faceNormal(f);
	float       sum        = 0;
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		const Vec3f opposite = m.position[m.apex(h)] - m.position[m.target(h)];
		sum += dot(normal[m.origin[h]], cross(faceNormal, opposite));
	}
	return 0.25f * sum;
}

/// Replaces every value by the mean of the vertex and its neighbours.
void averageOverRings(const HalfEdgeMesh& m, Workers& workers, Buffer<CurvatureSum>& value)
{
	Buffer<CurvatureSum> mean(value.size());
	workers.forEach(value.size(), [&](int v) {
		CurvatureSum sum = value[v];
		int          n   = 1;
		forEachNeighbour(m, v, [&](int w) {
			sum.curvature += value[w].curvature;
			sum.area += value[w].area;
			++n;
		});
		mean[v] = {sum.curvature / float(n), sum.area / float(n)};
	});
	value.swap(mean);
}

/// Number of ring averages that cover a disk: n passes spread like a random walk of n steps, each
/// an edge long, and half the radius covers most of a disk.
int passesForRadius(const Surface& surface, float radius, Workers& workers)
{
	const double area  = surfaceArea(surface.mesh, workers);
	const double edge2 = area / std::max(1, surface.mesh.faceNum) * (4 / std::sqrt(3.0));
	const double steps = 0.25 * double(radius) * radius / std::max(edge2, 1e-30);
	return std::clamp(int(std::lround(steps)), 0, maxCurvaturePasses);
}

/// Sums the curvature and the area of the faces over the ring of every vertex.
Buffer<CurvatureSum> sumOverRings(const HalfEdgeMesh& m, Workers& workers)
{
	const Buffer<Vec3f> normal = vertexNormals(m, workers);
	Buffer<float>       amount(m.faceNum);
	workers.forEach(amount.size(), [&](int f) { amount[f] = integratedCurvature(m, normal, f); });
	Buffer<CurvatureSum> ring(m.vertexNum);
	workers.forEach(ring.size(), [&](int v) {
		CurvatureSum sum;
		forEachOutgoing(m, v, [&](int h) {
			sum.curvature += amount[h / 3];
			sum.area += 0.5f * length(m.faceCross(h / 3));
		});
		ring[v] = sum;
	});
	return ring;
}

/// The factor of λ: |H|·r if calibrated; signed H in 1/mesh unit as printed.
Buffer<float> strengthAtVertices(const SizingRequest& request, const Surface& surface,
								 Workers& workers)
{
	const int     passes   = passesForRadius(surface, request.radius, workers);
	Buffer<float> strength = meanCurvature(surface, passes, workers);
	const float   scale    = float(surface.frame.scale);
	for (float& h : strength)
		h = isPaper(request.options) ? h * scale : std::abs(h) * request.radius;
	return strength;
}

/// Lowers sizes until no size grows faster than the slope along any edge.
void grade(const SizingRequest& request, const Surface& surface, float radius, Workers& workers,
		   Buffer<float>& size)
{
	const HalfEdgeMesh& m                       = surface.mesh;
	const float         perUnit                 = gradingSlope(request) / radius;
	const auto          isTooSmallForANeighbour = [&](std::size_t v) {
        return anyNeighbour(m, int(v), [&](int w) {
            const float rise = size[w] - size[v];
            return rise > 0 && rise > perUnit * length(m.position[w] - m.position[v]);
        });
	};
	std::vector<int> small = workers.collectIf(size.size(), isTooSmallForANeighbour);
	gradeSizes(m, perUnit, workers, small, size);
}

/// Divides sizes by the largest size, which may be above or below 1. Returns the largest size.
float normalise(Workers& workers, Buffer<float>& size)
{
	const float largest = *std::max_element(size.begin(), size.end());
	workers.forEach(size.size(), [&](int v) { size[v] /= largest; });
	return largest;
}

bool wantsSmallerDisks(const SizingRequest& request)
{
	return !request.isFeatureVertex.empty() && !keepsRegionVertices(request.options) &&
		   request.options.featureDiskScale < 1;
}

void shrinkFeatures(const SizingRequest& request, Buffer<float>& size)
{
	if (!wantsSmallerDisks(request)) return;
	for (std::size_t v = 0; v < size.size(); ++v) {
		if (request.isFeatureVertex[v]) size[v] *= float(request.options.featureDiskScale);
	}
}

/// Size on flat ground over the size of even triangles. The larger it is, the more vertices are
/// left for bent places.
float largestSizeFor(const RemeshOptions& options)
{
	if (options.targetMode == TargetMode::MaxError) return rangeWithinError.largest;
	return 1 + 0.3f * float(*options.adapt);
}

bool matchesBorder(const SizingRequest& request)
{
	return request.options.boundary == BoundaryMode::Keep;
}

/// Whether anything but the error asks for sizes: as printed, only λ and the region can.
bool wantsOtherSizes(const SizingRequest& request)
{
	const RemeshOptions& o = request.options;
	if (o.lambda > 0 || wantsSmallerDisks(request)) return true;
	if (isPaper(o)) return false;
	const bool atBorder = matchesBorder(request) && !request.kept.empty();
	return atBorder || !request.wantedEdge.empty() || o.minEdge > 0 || o.maxEdge > 0;
}

/// Mean length of the two border edges at every border vertex; 0 inside. Split edges were long:
/// they count as the longest allowed length.
Buffer<float> spacingAtBorder(const SizingRequest& request, const HalfEdgeMesh& m)
{
	std::vector<char> isKept(m.vertexNum, 0);
	for (int v : request.kept)
		isKept[v] = 1;
	Buffer<float> spacing(m.vertexNum, 0.0f);
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (!m.isBorderEdge(h)) continue;
		const int   a = m.origin[h], b = m.target(h);
		const bool  isWhole    = isKept[a] && isKept[b];
		const float edgeLength = length(m.position[a] - m.position[b]);
		const float share = 0.5f * (isWhole ? edgeLength : longestEdgeInRadii * request.radius);
		spacing[a] += share;
		spacing[b] += share;
	}
	return spacing;
}

/// Lowers the sizes at a border with kept vertices to match their spacing, then grades. The
/// matching size depends on the radius, and the radius on all sizes, so a few passes are needed.
void gradeToBorder(const SizingRequest& request, const Surface& surface, Workers& workers,
				   Buffer<float>& size)
{
	// The radius changes by less than the sizes, so each pass removes most of the change.
	constexpr int       passes       = 3;
	constexpr float     smallestSize = 1 / 32.0f;
	const HalfEdgeMesh& m            = surface.mesh;
	const Buffer<float> atBorder     = spacingAtBorder(request, m);
	Buffer<float>       matched      = copyOf(size, workers);
	for (int pass = 0; pass < passes; ++pass) {
		const double factor = std::sqrt(meanSquaredStretch(surface, matched, workers));
		const float  radius = request.radius * float(factor);
		for (std::size_t v = 0; v < size.size(); ++v) {
			matched[v] = size[v];
			if (!(atBorder[v] > 0)) continue;
			const float wanted = atBorder[v] / (borderSpacing * radius);
			matched[v]         = std::min(size[v], std::max(smallestSize, wanted));
		}
		grade(request, surface, radius, workers, matched);
	}
	size.swap(matched);
}

/// The sizes before grading: any difference between neighbours is allowed.
Buffer<float> ungradedSizes(const SizingRequest& request, const Surface& surface, Workers& workers)
{
	const float   lambda = float(request.options.lambda);
	Buffer<float> size(surface.mesh.vertexNum, 1.0f);
	if (lambda > 0) {
		const Buffer<float> strength = strengthAtVertices(request, surface, workers);
		for (std::size_t v = 0; v < strength.size(); ++v)
			size[v] = std::max(1 / largestStretch, 1 / (1 + lambda * strength[v]));
	}
	shrinkFeatures(request, size);
	if (!request.wantedEdge.empty()) {
		for (std::size_t v = 0; v < size.size(); ++v)
			size[v] *= request.wantedEdge[v] / request.evenEdge;
	}
	return size;
}

bool followsSizes(const SizingRequest& request)
{
	return request.options.targetMode == TargetMode::Sizes;
}

/// The edge, in working units, of size 1.
float unitEdge(const SizingRequest& request, const Surface& surface, const Buffer<float>& size,
			   Workers& workers)
{
	if (followsSizes(request)) return request.evenEdge;
	return request.evenEdge * float(std::sqrt(meanSquaredStretch(surface, size, workers)));
}

/// A length as a size, limited to a range that no mesh exceeds and no float overflows.
float sizeFor(double length, double unit)
{
	constexpr double smallest = 1e-4, largest = 1e4;
	return float(std::clamp(length / unit, smallest, largest));
}

/// Keeps sizes between the smallest and the largest edge. With a given count the other sizes grow
/// or shrink for it, in a few passes.
void limitEdges(const SizingRequest& request, const Surface& surface, Workers& workers,
				Buffer<float>& size)
{
	const RemeshOptions& o = request.options;
	if (!(o.minEdge > 0) && !(o.maxEdge > 0)) return;
	constexpr int passes = 4;
	const double  scale  = surface.frame.scale;
	if (followsSizes(request) && request.wantedEdge.empty()) {
		const float factor = sizeFor(o.maxEdge * scale, double(request.evenEdge));
		workers.forEach(size.size(), [&](int v) { size[v] *= factor; });
	}
	for (int pass = 0; pass < passes; ++pass) {
		const double unit  = double(unitEdge(request, surface, size, workers));
		const float  least = sizeFor(o.minEdge * scale, unit);
		const float  most  = o.maxEdge > 0 ? sizeFor(o.maxEdge * scale, unit) : HUGE_VALF;
		workers.forEach(size.size(), [&](int v) { size[v] = std::clamp(size[v], least, most); });
	}
}

/// Edges by the error over the even edge, graded.
Buffer<float> errorSizes(const SizingRequest& request, Surface& surface, Workers& workers)
{
	const ErrorSizeRange range{largestSizeFor(request.options), gradingSlope(request)};
	Buffer<float>        edge =
		sizesByError(surface, request.lines, request.evenEdge, range, workers).edge;
	workers.forEach(edge.size(), [&](int v) { edge[v] /= request.evenEdge; });
	return edge;
}

Sizing makeCalibrated(const SizingRequest& request, Surface& surface, Workers& workers)
{
	Sizing sizing;
	sizing.areByError = !wantsOtherSizes(request);
	if (sizing.areByError) {
		sizing.size = errorSizes(request, surface, workers);
	}
	else {
		sizing.size = ungradedSizes(request, surface, workers);
		if (request.options.adapt > 0) {
			const Buffer<float> byError = errorSizes(request, surface, workers);
			workers.forEach(byError.size(), [&](int v) { sizing.size[v] *= byError[v]; });
		}
		limitEdges(request, surface, workers, sizing.size);
		// The slope depends on the radius, and the radius on the sizes. The sizes before grading
		// give a radius that is good enough.
		const double before = meanSquaredStretch(surface, sizing.size, workers);
		if (matchesBorder(request))
			gradeToBorder(request, surface, workers, sizing.size);
		else
			grade(request, surface,
				  request.radius * (followsSizes(request) ? 1 : float(std::sqrt(before))), workers,
				  sizing.size);
	}
	if (followsSizes(request)) {
		const double area = surface.mesh.sideNum() * surfaceArea(surface.mesh, workers);
		sizing.vertexNum  = vertexNumForEdgeLength(area, request.evenEdge) *
						   meanSquaredStretch(surface, sizing.size, workers);
		sizing.borderEdgeNum = borderLength(surface.mesh, sizing.size) / double(request.evenEdge);
	}
	const float largest = normalise(workers, sizing.size);
	if (!(largest > 0)) throw Failure(Status::InternalError, "The density has no largest size.");
	sizing.radiusFactor = std::sqrt(meanSquaredStretch(surface, sizing.size, workers));
	return sizing;
}

Sizing makePrinted(const SizingRequest& request, const Surface& surface, Workers& workers)
{
	Sizing      sizing;
	const float lambda = float(request.options.lambda);
	sizing.size        = Buffer<float>(surface.mesh.vertexNum, 1.0f);
	double meanStretch = 1;
	if (lambda > 0) {
		const Buffer<float> strength = strengthAtVertices(request, surface, workers);
		double              sum      = 0;
		for (std::size_t v = 0; v < strength.size(); ++v) {
			const float stretch = 1 + lambda * strength[v];
			sum += double(lambda) * strength[v];
			sizing.clampedNum += stretch < minPrintedStretch;
			sizing.size[v] = 1 / std::max(stretch, minPrintedStretch);
		}
		// A surface that is hollow as a whole must not get a radius of zero.
		meanStretch = std::max(double(minPrintedStretch), 1 + sum / double(strength.size()));
	}
	shrinkFeatures(request, sizing.size);
	sizing.radiusFactor = meanStretch * double(normalise(workers, sizing.size));
	return sizing;
}

} // namespace

Buffer<float> meanCurvature(const Surface& surface, int ringPasses, Workers& workers)
{
	Buffer<CurvatureSum> ring = sumOverRings(surface.mesh, workers);
	for (int pass = 0; pass < ringPasses; ++pass)
		averageOverRings(surface.mesh, workers, ring);
	Buffer<float> h(ring.size());
	for (std::size_t v = 0; v < ring.size(); ++v)
		h[v] = ring[v].area > 0 ? ring[v].curvature / ring[v].area : 0.0f;
	return h;
}

Sizing makeSizing(const SizingRequest& request, Surface& surface, Workers& workers)
{
	if (!(request.options.adapt > 0) && !wantsOtherSizes(request)) return Sizing();
	return isPaper(request.options) ? makePrinted(request, surface, workers)
									: makeCalibrated(request, surface, workers);
}

} // namespace gpr
