// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "certified_distance.h"

#include "cover_bound.h"

#include <vcg_extras/core/mesh/space_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace gpr {

namespace {

/// Share of the extent: far more than the rounding of distances and bounds.
constexpr double roundingShare = 2e-7;
/// Share of the extent: the error of coordinates of points made by cuts.
constexpr double coordinateShare = 1e-14;
/// Levels of groups of triangles above the leaves, and the least level of the groups for the first
/// estimate of the largest distance.
constexpr int groupLevels = 3, fewestGroupLevels = 12;
/// Triangles between two updates of the goal.
constexpr std::size_t batchSize = 1u << 17;
/// Pieces cut at once: at least leastCuts; of many pieces, the quarter with the largest bounds.
constexpr std::size_t leastCuts = 8192, cutShare = 4;

Vec3d centreOf(const Triangle& t)
{
	return (t[0] + t[1] + t[2]) * (1.0 / 3);
}

/// Upper bound of the distance of any point of the piece from `other`: distance from a triangle is
/// a convex function, so a corner of the piece has the largest value.
double convexBound(const Triangle& piece, const Triangle& other)
{
	double squared = 0;
	for (const Vec3d& corner : piece)
		squared = std::max(squared, squaredDistance(corner, other));
	return std::sqrt(squared);
}

Box<float> boxOf(const Triangle& t)
{
	const Box<double> box = Box<double>::ofPoints(t);
	return {Vec3f(box.low), Vec3f(box.high)};
}

std::array<double, 3> squaredEdges(const Triangle& t)
{
	return {squaredLength(t[1] - t[0]), squaredLength(t[2] - t[1]), squaredLength(t[0] - t[2])};
}

/// The place of the largest of three values.
std::size_t largestOf(const std::array<double, 3>& value)
{
	return std::size_t(std::max_element(value.begin(), value.end()) - value.begin());
}

/// Bounds of a group, a triangle or a piece.
struct Finding {
	double bound   = 0;  ///< no point is farther
	double seen    = 0;  ///< distance of a measured point
	int    nearest = -1; ///< triangle of the other surface at, or next to, the nearest point of the
						 ///< middle
};

/// A part of a triangle that may hold the largest distance.
struct Piece {
	Triangle              corner;
	std::array<double, 3> distance;  ///< of the corners
	std::array<int, 3>    nearest;   ///< triangles of the other surface
	int                   candidate; ///< another triangle of the other surface that may bound the
									 ///< piece
	int    depth;
	double bound;

	double farthest() const { return distance[largestOf(distance)]; }
};

bool isBoundSmaller(const Piece& a, const Piece& b)
{
	return a.bound < b.bound;
}

/// Cuts of a triangle after which the triangle counts as near, if no far point was found.
constexpr int maxCutsOfPlace = 200;

/// The bound from which on pieces are cut now: pieces with larger bounds come first.
double boundToCutFrom(const std::vector<Piece>& pieces)
{
	const std::size_t num = std::max(leastCuts, pieces.size() / cutShare);
	if (pieces.size() <= num) return 0;
	std::vector<double> bounds;
	bounds.reserve(pieces.size());
	for (const Piece& p : pieces)
		bounds.push_back(p.bound);
	std::nth_element(bounds.begin(), bounds.begin() + std::ptrdiff_t(num), bounds.end(),
					 std::greater<double>());
	return bounds[num];
}

class BranchAndBound {
public:
	BranchAndBound(const TriangleTree& from, const TriangleTree& to, double rounding,
				   const CertificateSettings& settings, Workers& workers) :
			from_(from),
			to_(to), settings_(settings), workers_(workers), slack_(rounding)
	{
		Box<double> box = from.box();
		box += to.box();
		exact_ = coordinateShare * box.diagonal();
		slack_ += roundingShare * box.diagonal() + settings.coordinateError;
	}

	DistanceBounds run()
	{
		lookAtGroups();
		for (std::size_t begin = 0; begin < faces_.size(); begin += batchSize)
			lookAtFaces(begin, std::min(faces_.size(), begin + batchSize));
		dropBelowGoal();
		while (!pieces_.empty() && cutNum_ < settings_.budget)
			cutWorst();
		return bounds();
	}

	/// Triangles with a point farther than limit, in the regions, which are relative to the origin
	/// of the mesh.
	std::vector<FarPlace> beyond(double limit, const std::vector<Box<double>>& regions,
								 const Vec3d& origin)
	{
		fixedGoal_ = limit;
		if (!regions.empty()) markRegions(regions, origin);
		lookAtGroups();
		std::vector<FarPlace> places(faces_.size());
		workers_.forEach(faces_.size(), [&](int i) { places[i] = placeOf(faces_[i], limit); });
		const auto isNear = [limit](const FarPlace& p) { return !(p.distance > limit); };
		places.erase(std::remove_if(places.begin(), places.end(), isNear), places.end());
		return places;
	}

private:
	const TriangleTree&        from_;
	const TriangleTree&        to_;
	const CertificateSettings& settings_;
	Workers&                   workers_;
	double                     slack_;     ///< of both bounds, for rounding
	double                     exact_ = 0; ///< error of coordinates

	double                     lower_     = 0; ///< largest distance found so far
	double                     upper_     = 0; ///< of all finished triangles and pieces
	double                     fixedGoal_ = 0; ///< 0: the goal follows the largest distance found
	std::optional<MarkedCells> regions_;       ///< relative to the origin; none: everywhere

	struct Face {
		int triangle, hint;
	};
	std::vector<Face>  faces_;
	std::vector<Piece> pieces_;
	std::int64_t       cutNum_ = 0;

	/// The largest bound as close to the largest distance found as the settings ask.
	double tightBound() const
	{
		return (1 + settings_.relative) * (lower_ - slack_) + settings_.absolute - slack_;
	}

	/// Triangles and pieces with a bound up to the goal are finished.
	double goal() const
	{
		if (fixedGoal_ > 0) return fixedGoal_;
		const double wanted = settings_.wanted - slack_;
		return lower_ <= wanted ? std::min(tightBound(), wanted) : tightBound();
	}

	DistanceBounds bounds() const
	{
		double upper = std::max(lower_, upper_);
		for (const Piece& p : pieces_)
			upper = std::max(upper, p.bound);
		const bool isBudgetSpent = !pieces_.empty() && upper > tightBound();
		return {std::max(0.0, lower_ - slack_), upper + slack_, isBudgetSpent};
	}

	/// Whether a triangle or piece with this bound is finished.
	bool isDone(double bound)
	{
		if (bound > goal()) return false;
		upper_ = std::max(upper_, bound);
		return true;
	}

	void markRegions(const std::vector<Box<double>>& regions, const Vec3d& origin)
	{
		const Box<double>& all = from_.box();
		regions_.emplace(Vec3f(all.low), float(all.largestSide()) + 1e-30f);
		for (const Box<double>& region : regions)
			regions_->mark({Vec3f(region.low - origin), Vec3f(region.high - origin)});
	}

	bool isInRegions(const Box<float>& box) const { return !regions_ || regions_->mayMeet(box); }

	/// A group outside of the regions counts as near.
	Finding ofGroup(int level, int i) const
	{
		const Box<float>& box = from_.groupBox(level, i);
		if (!isInRegions(box)) return {0, 0, 0};
		const Vec3d                 p    = centreOf(from_.triangle(from_.groupBegin(level, i)));
		const TriangleTree::Nearest near = to_.nearest(p);
		const Vec3d  farthest(std::max(double(box.high.x) - p.x, p.x - double(box.low.x)),
							  std::max(double(box.high.y) - p.y, p.y - double(box.low.y)),
							  std::max(double(box.high.z) - p.z, p.z - double(box.low.z)));
		const double distance = std::sqrt(near.squared);
		return {distance + length(farthest), distance, near.triangle};
	}

	/// Bounds groups of neighbouring triangles; puts the triangles of unfinished groups on the
	/// list.
	void lookAtGroups()
	{
		const int            level = std::min(from_.levelNum() - 1,
											  std::max(fewestGroupLevels, from_.levelNum() - 1 - groupLevels));
		const std::size_t    num   = std::size_t(1) << level;
		std::vector<Finding> found(num);
		workers_.forEach(num, [&](int i) { found[i] = ofGroup(level, i); });
		for (const Finding& f : found)
			lower_ = std::max(lower_, f.seen);
		for (std::size_t i = 0; i < num; ++i) {
			if (isDone(found[i].bound)) continue;
			for (int t = from_.groupBegin(level, int(i)); t < from_.groupBegin(level, int(i) + 1);
				 ++t) {
				if (isInRegions(boxOf(from_.triangle(t)))) faces_.push_back({t, found[i].nearest});
			}
		}
	}

	/// Bounds a triangle by the surface near its middle, the quick bound first.
	Finding byMiddle(const Triangle& t, int hint, double goal) const
	{
		const TriangleTree::Nearest near = to_.nearest(centreOf(t), hint);
		Finding f = {convexBound(t, to_.triangle(near.triangle)), std::sqrt(near.squared),
					 near.triangle};
		if (f.bound > goal)
			f.bound = std::min(f.bound, coverBound(t, to_, near.triangle, goal, exact_));
		return f;
	}

	Finding ofFace(const Face& face, double goal) const
	{
		const Triangle& t = from_.triangle(face.triangle);
		const Finding   quick{convexBound(t, to_.triangle(face.hint)), 0, face.hint};
		return quick.bound <= goal ? quick : byMiddle(t, face.hint, goal);
	}

	/// Distance 0 if the bound of the triangle is below the limit.
	FarPlace placeOf(const Face& face, double limit) const
	{
		const Finding found = ofFace(face, limit);
		FarPlace      place;
		if (found.bound <= limit) return place;
		const Triangle& t = from_.triangle(face.triangle);
		place = {centreOf(t), found.seen, 0.5 * length(cross(t[1] - t[0], t[2] - t[0]))};
		for (std::size_t k = 0; k < 3; ++k) {
			for (const Vec3d& p : {t[k], (t[k] + t[(k + 1) % 3]) * 0.5})
				takeIfFarther(p, std::sqrt(to_.nearest(p, found.nearest).squared), place);
		}
		if (place.distance <= limit) lookCloser(face.triangle, found, limit, place);
		return place;
	}

	/// Cuts a triangle with seven near points until all pieces are near or a point is far.
	void lookCloser(int triangle, const Finding& found, double limit, FarPlace& place) const
	{
		std::vector<Piece> open = {wholeFace(triangle, found)};
		for (int cutNum = 0; cutNum < maxCutsOfPlace && !open.empty(); ++cutNum) {
			std::swap(open.back(), *std::max_element(open.begin(), open.end(), isBoundSmaller));
			const Piece whole = open.back();
			open.pop_back();
			Piece half[2];
			cut(whole, half[0], half[1]);
			for (Piece& piece : half) {
				for (std::size_t k = 0; k < 3; ++k)
					takeIfFarther(piece.corner[k], piece.distance[k], place);
				if (place.distance > limit) return;
				bound(piece, limit);
				if (piece.bound > limit) open.push_back(piece);
			}
		}
	}

	static void takeIfFarther(const Vec3d& p, double distance, FarPlace& place)
	{
		if (!(distance > place.distance)) return;
		place.distance = distance;
		place.position = p;
	}

	void lookAtFaces(std::size_t begin, std::size_t end)
	{
		const double         goalNow = goal();
		std::vector<Finding> found(end - begin);
		workers_.forEach(end - begin, [&](int i) {
			found[i] = ofFace(faces_[begin + std::size_t(i)], goalNow);
		});
		for (const Finding& f : found)
			lower_ = std::max(lower_, f.seen);
		std::vector<std::size_t> open;
		for (std::size_t i = 0; i < found.size(); ++i)
			if (!isDone(found[i].bound)) open.push_back(i);
		const std::size_t before = pieces_.size();
		pieces_.resize(before + open.size());
		workers_.forEach(open.size(), [&](int k) {
			const std::size_t i              = open[k];
			pieces_[before + std::size_t(k)] = wholeFace(faces_[begin + i].triangle, found[i]);
		});
		for (std::size_t i = before; i < pieces_.size(); ++i)
			lower_ = std::max(lower_, pieces_[i].farthest());
	}

	Piece wholeFace(int triangle, const Finding& found) const
	{
		Piece piece;
		piece.corner    = from_.triangle(triangle);
		piece.candidate = found.nearest;
		piece.depth     = 0;
		for (std::size_t k = 0; k < 3; ++k)
			setCorner(piece, k, piece.corner[k], found.nearest);
		piece.bound = std::min(found.bound, quickBound(piece));
		return piece;
	}

	void setCorner(Piece& piece, std::size_t k, const Vec3d& p, int hint) const
	{
		const TriangleTree::Nearest near = to_.nearest(p, hint);
		piece.corner[k]                  = p;
		piece.distance[k]                = std::sqrt(near.squared);
		piece.nearest[k]                 = near.triangle;
	}

	/// A triangle of the other surface, and its bound of a piece.
	struct Alone {
		int    triangle;
		double bound;
	};

	/// The triangle that bounds the piece best by itself, of the triangles near the corners.
	Alone bestAlone(const Piece& piece) const
	{
		Alone best = {piece.candidate, convexBound(piece.corner, to_.triangle(piece.candidate))};
		for (const int t : piece.nearest) {
			if (t == piece.candidate) continue;
			const double bound = convexBound(piece.corner, to_.triangle(t));
			if (bound < best.bound) best = {t, bound};
		}
		return best;
	}

	/// Least of the bounds by the triangles near the corners and by the way to the corners.
	double quickBound(const Piece& piece) const
	{
		const std::array<double, 3> edges   = squaredEdges(piece.corner);
		const double                longest = std::sqrt(edges[largestOf(edges)]);
		// Every point of a triangle is within longest edge/√3 of a corner.
		return std::min(bestAlone(piece).bound, piece.farthest() + longest / std::sqrt(3.0));
	}

	void dropBelowGoal()
	{
		pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(),
									 [this](const Piece& p) { return isDone(p.bound); }),
					  pieces_.end());
	}

	/// Cuts the pieces with the largest bounds.
	void cutWorst()
	{
		const double       from   = boundToCutFrom(pieces_);
		const auto         isKept = [from](const Piece& p) { return p.bound < from; };
		const auto         first  = std::stable_partition(pieces_.begin(), pieces_.end(), isKept);
		std::vector<Piece> whole(first, pieces_.end());
		pieces_.erase(first, pieces_.end());
		const double        goalNow = goal();
		std::vector<Piece>  halves(2 * whole.size());
		std::vector<double> seen(2 * whole.size());
		workers_.forEach(whole.size(), [&](int i) {
			const std::size_t at = 2 * std::size_t(i);
			cut(whole[i], halves[at], halves[at + 1]);
			seen[at]     = bound(halves[at], goalNow);
			seen[at + 1] = bound(halves[at + 1], goalNow);
		});
		cutNum_ += std::int64_t(halves.size());
		for (const double d : seen)
			lower_ = std::max(lower_, d);
		pieces_.insert(pieces_.end(), halves.begin(), halves.end());
		dropBelowGoal();
	}

	/// Sets the bound of a piece and returns the largest distance measured on the piece.
	double bound(Piece& piece, double goal) const
	{
		const double seen = piece.farthest();
		piece.bound       = std::min(piece.bound, quickBound(piece));
		if (piece.bound <= goal) return seen;
		const Finding middle = byMiddle(piece.corner, piece.candidate, goal);
		piece.candidate      = middle.nearest;
		piece.bound          = std::min(piece.bound, middle.bound);
		return std::max(seen, middle.seen);
	}

	/// A cut of a piece at a point of the edge between corners p and q.
	struct Cut {
		std::size_t p, q;
		double      share;    ///< of the way from p to q
		int         atP, atQ; ///< triangles that may bound the two parts
	};

	void cut(const Piece& whole, Piece& one, Piece& two) const
	{
		const Cut   c = cutOf(whole);
		const Vec3d x = whole.corner[c.p] + (whole.corner[c.q] - whole.corner[c.p]) * c.share;
		one = two = whole;
		one.depth = two.depth = whole.depth + 1;
		one.candidate         = c.atP;
		two.candidate         = c.atQ;
		setCorner(one, c.q, x, whole.candidate);
		two.corner[c.p]   = x;
		two.distance[c.p] = one.distance[c.q];
		two.nearest[c.p]  = one.nearest[c.q];
	}

	Cut cutOf(const Piece& piece) const
	{
		// Every third cut goes through the middle, so that pieces become small whatever happens.
		Cut c;
		if (piece.depth % 3 != 2 && findEqualDistance(piece, c)) return c;
		return middleOfLongest(piece);
	}

	Cut middleOfLongest(const Piece& piece) const
	{
		const std::size_t longest = largestOf(squaredEdges(piece.corner));
		return {longest, (longest + 1) % 3, 0.5, piece.candidate, piece.candidate};
	}

	/// How much nearer a point is to the second triangle than to the first.
	double advantage(const Vec3d& p, int first, int second) const
	{
		return std::sqrt(squaredDistance(p, to_.triangle(first))) -
			   std::sqrt(squaredDistance(p, to_.triangle(second)));
	}

	/// A cut of an edge at equal distances from two triangles: the triangle `best`, which bounds
	/// the piece best, and the nearest triangle of the corner farthest from `best`. False if no
	/// edge at this corner has such a point.
	bool findEqualDistance(const Piece& piece, Cut& c) const
	{
		const int             best = bestAlone(piece).triangle;
		std::array<double, 3> squared;
		for (std::size_t k = 0; k < 3; ++k)
			squared[k] = squaredDistance(piece.corner[k], to_.triangle(best));
		const std::size_t q   = largestOf(squared);
		const int         own = piece.nearest[q];
		if (own == best) return false;
		for (const std::size_t p : {(q + 1) % 3, (q + 2) % 3}) {
			const double before = advantage(piece.corner[p], best, own);
			if (!(before < 0)) continue;
			c = {p, q, shareOfEqual(piece.corner[p], piece.corner[q], best, own), best, own};
			return c.share > 0.001 && c.share < 0.999;
		}
		return false;
	}

	/// The share of the way from p to q at which both triangles are equally near. p is nearer to
	/// the first triangle, q to the second.
	double shareOfEqual(const Vec3d& p, const Vec3d& q, int first, int second) const
	{
		constexpr int steps = 4;
		double        low = 0, high = 1;
		double        atLow = advantage(p, first, second), atHigh = advantage(q, first, second);
		if (!(atHigh > 0)) return 1;
		for (int i = 0; i < steps; ++i) {
			const double share        = low + (high - low) * (atLow / (atLow - atHigh));
			const double at           = advantage(p + (q - p) * share, first, second);
			(at < 0 ? low : high)     = share;
			(at < 0 ? atLow : atHigh) = at;
			if (at == 0) return share;
		}
		return low + (high - low) * (atLow / (atLow - atHigh));
	}
};

} // namespace

CertificateSettings usualCertificate(double diagonal)
{
	CertificateSettings settings;
	settings.absolute = 1e-5 * diagonal;
	return settings;
}

DistanceBounds certifiedDistance(const MeasuredSurface& from, const MeasuredSurface& to,
								 const CertificateSettings& settings, Workers& workers)
{
	if (from.tree().size() == 0 || to.tree().size() == 0) return {};
	const double rounding = 1e-15 * length(from.origin()); // of positions relative to the origin
	return BranchAndBound(from.tree(), to.tree(), rounding, settings, workers).run();
}

std::vector<FarPlace> placesBeyond(const MeasuredSurface& from, const MeasuredSurface& to,
								   double limit, Workers& workers,
								   const std::vector<Box<double>>& regions)
{
	if (from.tree().size() == 0 || to.tree().size() == 0) return {};
	const CertificateSettings settings;
	std::vector<FarPlace>     places = BranchAndBound(from.tree(), to.tree(), 0, settings, workers)
									   .beyond(limit, regions, from.origin());
	for (FarPlace& p : places)
		p.position += from.origin();
	return places;
}

MutualBounds certifiedDistances(const MeasuredSurface& input, const MeasuredSurface& result,
								const CertificateSettings& settings, Workers& workers)
{
	return {certifiedDistance(result, input, settings, workers),
			certifiedDistance(input, result, settings, workers)};
}

ComparedDistance compareSurfaces(const MeshView& input, const MeasuredSurface& inputSurface,
								 const MeshView& result, double diagonal, Workers& workers)
{
	const MeasuredSurface surface(result, inputSurface, workers);
	const std::int64_t    pointNum = distanceSampleNum(result.faceNum);
	ComparedDistance      found;
	found.toInput   = inputSurface.from(result, pointNum, workers);
	found.fromInput = surface.from(input, pointNum, workers);
	found.proven = certifiedDistances(inputSurface, surface, usualCertificate(diagonal), workers);
	found.toInput.max   = std::max(found.toInput.max, found.proven.toInput.lower);
	found.fromInput.max = std::max(found.fromInput.max, found.proven.fromInput.lower);
	return found;
}

} // namespace gpr
