// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture_transfer.h"

#include "carry_over.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/indexed_mesh.h>
#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gpr {

namespace {

/// Largest difference of equal coordinates, as files round coordinates.
constexpr float sameCoordinate = 2e-6f;
/// Radius of the search for the side of a seam, in distances from the middle of a face of the
/// result to its corners.
constexpr double reach = 1.5;
/// Most faces visited for a face of the result.
constexpr std::size_t maxFacesLookedAt = 100000;

/// Numbers the places of vertices. Vertices at the same place, by the rule by which the engine sews
/// and welds, get the same number.
std::vector<std::int32_t> placeNumbers(const MeshView& mesh)
{
	std::vector<std::int32_t> place = numbersBelow(mesh.vertexNum);
	const auto                frame = frameOf(mesh, [](std::size_t) { return true; });
	if (!frame) return place;
	SamePlaceTable table(mesh.vertexNum);
	for (std::size_t v = 0; v < mesh.vertexNum; ++v) {
		const Vec3d p = mesh.position(v);
		if (isFinite(p)) place[v] = table.findOrPut(frame->toWorking(p), std::int32_t(v));
	}
	return place;
}

/// The weights of the nearest point of a triangle to p.
BarycentricPoint nearestPoint(const Vec3d& p, const std::array<Vec3d, 3>& corner,
							  double& squaredMiss)
{
	std::array<double, 3> best{1, 0, 0};
	squaredMiss           = HUGE_VAL;
	const auto tryWeights = [&](const std::array<double, 3>& w) {
		const Vec3d  point = corner[0] * w[0] + corner[1] * w[1] + corner[2] * w[2];
		const double miss  = squaredLength(point - p);
		if (!(miss < squaredMiss)) return;
		best        = w;
		squaredMiss = miss;
	};
	const Vec3d  n    = cross(corner[1] - corner[0], corner[2] - corner[0]);
	const double area = squaredLength(n);
	const double w1   = dot(cross(p - corner[0], corner[2] - corner[0]), n) / area;
	const double w2   = dot(cross(corner[1] - corner[0], p - corner[0]), n) / area;
	if (area > 0 && 1 - w1 - w2 >= 0 && w1 >= 0 && w2 >= 0) {
		tryWeights({1 - w1 - w2, w1, w2});
	}
	else {
		for (int i = 0; i < 3; ++i) {
			const int             j = (i + 1) % 3;
			const Vec3d           d = corner[j] - corner[i];
			const double          l = squaredLength(d);
			std::array<double, 3> w{};
			w[j] = l > 0 ? std::clamp(dot(p - corner[i], d) / l, 0.0, 1.0) : 0.0;
			w[i] = 1 - w[j];
			tryWeights(w);
		}
	}
	return {-1, {float(best[0]), float(best[1]), float(best[2])}};
}

} // namespace

TextureSource::TextureSource(const MeshView& mesh, CornerTexture texture) :
		mesh_(mesh), texture_(std::move(texture))
{
	seam_.assign(3 * mesh.faceNum, 0);
	beyond_.assign(3 * mesh.faceNum, -1);
	connect();
}

/// Finds the two sides of every edge by sorting.
void TextureSource::connect()
{
	const std::vector<std::int32_t> place = placeNumbers(mesh_);
	const auto            placeOf = [&](int corner) { return place[mesh_.vertexOf(corner)]; };
	std::vector<EdgeSide> sides;
	sides.reserve(3 * mesh_.faceNum);
	for (int c = 0; c < int(3 * mesh_.faceNum); ++c) {
		const EdgeSide side = edgeSide(placeOf(c), placeOf(nextInFace(c)), c);
		if (side.low != side.high) sides.push_back(side);
	}
	std::sort(sides.begin(), sides.end());
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		// The engine cuts an edge with more than two faces: a border without a way across.
		if (end - begin != 2) return;
		const int a = sides[begin].halfEdge, b = sides[begin + 1].halfEdge;
		link(a, b, placeOf(a) == placeOf(b));
	});
}

/// Links two corners, the edges of which (to the next corner) are the two sides of an edge.
/// runAlike: both in the same direction, unlike the sides of consistently oriented faces.
void TextureSource::link(int a, int b, bool runAlike)
{
	if (agree(a, b, runAlike)) {
		beyond_[a] = b / 3;
		beyond_[b] = a / 3;
		return;
	}
	seam_[a] = seam_[b] = 1;
	++seamNum_;
}

/// Whether the texture is continuous across the edge with sides a and b.
bool TextureSource::agree(int a, int b, bool runAlike) const
{
	if (!texture_.image.empty() && texture_.image[a / 3] != texture_.image[b / 3]) return false;
	const auto isSameThere = [&](int x, int y) {
		const float *atX = &texture_.uv[2 * std::size_t(x)],
					*atY = &texture_.uv[2 * std::size_t(y)];
		return std::abs(atX[0] - atY[0]) <= sameCoordinate &&
			   std::abs(atX[1] - atY[1]) <= sameCoordinate;
	};
	return isSameThere(a, runAlike ? b : nextInFace(b)) &&
		   isSameThere(nextInFace(a), runAlike ? nextInFace(b) : b);
}

/// Carries the texture to the faces of a result, face by face.
class CornerCarrier {
public:
	CornerCarrier(const TextureSource& source, const RemeshResult& result) :
			source_(source), result_(result), lookedAtFor_(source.mesh_.faceNum, -1)
	{
	}

	/// Writes u and v of the three corners of face f.
	void carry(int f, float* uv)
	{
		const std::int32_t* corner = &result_.mesh.triangles[3 * std::size_t(f)];
		lookRound(f, corner);
		for (int k = 0; k < 3; ++k) {
			BarycentricPoint at = result_.surfacePoints[corner[k]];
			if (!isLookedAt(at.face, f)) at = nearestOnThisSide(result_.mesh.positions[corner[k]]);
			uv[2 * k]     = coordinateAt(at, 0);
			uv[2 * k + 1] = coordinateAt(at, 1);
		}
	}

private:
	const TextureSource&      source_;
	const RemeshResult&       result_;
	std::vector<std::int32_t> lookedAtFor_; ///< per input face: the last result face that came
	std::vector<std::int32_t> found_;       ///< the faces of the input on this side, nearest first

	bool isLookedAt(std::int32_t face, int f) const { return lookedAtFor_[face] == f; }

	std::array<Vec3d, 3> cornersOf(std::int32_t face) const
	{
		const MeshView& mesh = source_.mesh_;
		const auto      t    = mesh.triangle(face);
		return {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])};
	}

	float coordinateAt(const BarycentricPoint& at, int i) const
	{
		const float* uv = &source_.texture_.uv[6 * std::size_t(at.face)];
		return float(meanOfCorners(at, [&](int k) { return uv[2 * k + i]; }));
	}

	/// Finds the faces of the input that are linked to the middle of a face of the result within
	/// the reach and without a seam between; ends early if the faces of all corners are found.
	void lookRound(int f, const std::int32_t* corner)
	{
		const std::vector<Vec3d>& place = result_.mesh.positions;
		const Vec3d               a = place[corner[0]], b = place[corner[1]], c = place[corner[2]];
		const Vec3d               middle = (a + b + c) * (1 / 3.0);
		const double              far    = std::max(
							{squaredLength(a - middle), squaredLength(b - middle), squaredLength(c - middle)});
		const double farthest = reach * reach * far;
		found_.clear();
		add(result_.facePoints[f].face, f);
		for (std::size_t i = 0; i < found_.size() && found_.size() < maxFacesLookedAt; ++i) {
			if (reachesAll(f, corner)) return;
			for (std::size_t k = 0; k < 3; ++k) {
				const std::int32_t next = source_.beyond_[3 * std::size_t(found_[i]) + k];
				if (next < 0 || isLookedAt(next, f)) continue;
				double miss = 0;
				nearestPoint(middle, cornersOf(next), miss);
				if (miss <= farthest) add(next, f);
			}
		}
	}

	void add(std::int32_t face, int f)
	{
		lookedAtFor_[face] = f;
		found_.push_back(face);
	}

	bool reachesAll(int f, const std::int32_t* corner) const
	{
		return std::all_of(corner, corner + 3, [&](std::int32_t v) {
			return isLookedAt(result_.surfacePoints[v].face, f);
		});
	}

	BarycentricPoint nearestOnThisSide(const Vec3d& p) const
	{
		BarycentricPoint best;
		double           least = HUGE_VAL;
		for (std::int32_t face : found_) {
			double           miss = 0;
			BarycentricPoint at   = nearestPoint(p, cornersOf(face), miss);
			if (best.face >= 0 && !(miss < least)) continue;
			best      = at;
			best.face = face;
			least     = miss;
		}
		return best;
	}
};

CornerTexture TextureSource::carriedTo(const RemeshResult& result) const
{
	CornerTexture     carried;
	const std::size_t faceNum = result.mesh.faceNum();
	carried.uv.resize(6 * faceNum);
	CornerCarrier carrier(*this, result);
	for (std::size_t f = 0; f < faceNum; ++f) {
		const std::int32_t own = result.callersFace.empty() ? -1 : result.callersFace[f];
		if (own >= 0)
			std::copy_n(&texture_.uv[6 * std::size_t(own)], 6, &carried.uv[6 * f]);
		else
			carrier.carry(int(f), &carried.uv[6 * f]);
		if (!texture_.image.empty())
			carried.image.push_back(texture_.image[result.facePoints[f].face]);
	}
	return carried;
}

} // namespace gpr
