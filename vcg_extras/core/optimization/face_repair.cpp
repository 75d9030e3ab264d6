// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_repair.h"

#include "face_goals.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>

namespace gpr {

namespace {

/// A number of faces, or a share of all faces.
struct Few {
	std::size_t num;
	float       share;

	bool holds(std::size_t faces, const HalfEdgeMesh& m) const
	{
		return faces <= std::max(num, std::size_t(share * float(m.faceNum)));
	}
};

/// With more poor faces, the triangles are too large for the surface. Single changes then cost much
/// and help little: twice the time of the whole run on parts with many holes, at the same worst
/// angle. With more inverted faces, moves, which cost most, are left out. Such a mesh has contacts
/// in many places, so changes may then make contacts.
constexpr Few fewPoor = {100, 0.2f}, fewInverted = {500, 0.02f};
/// Operations that change the count are tried at few faces, because each must be compensated at
/// another place. Pairs in a row, which take some hundred trials, are tried only with at most this
/// many faces left.
constexpr Few         fewForCount = {100, 0.001f};
constexpr std::size_t maxForPairs = 8;
/// Rounds of these operations: after each round the angles are raised again, which gives the next
/// round new chances.
constexpr int maxCountRounds = 3;
/// Faces tried in a round, and room for the new vertices.
constexpr int attemptsByCount = 200, attemptsByPairs = 12;
constexpr int roomForTrials = 4 * (attemptsByCount + 2 * attemptsByPairs);
/// Share of the budget for raiseSmallAngles; the rest is for repairPoorFaces.
constexpr double shareOfRaising = 0.67;
/// Budget of pairs of operations in a row, which take some hundred trials a face.
constexpr std::int64_t workOfPairs = 12000000;

/// Shares of maxGap, in order: changes that leave faces near the surface come first.
constexpr float sharesOfMaxGap[] = {0.7f, 1};

/// The poorness of a mesh.
struct Poorness {
	double      lack        = 0; ///< Σ(1 - angle / limit)² over the faces below the limit
	std::size_t poorNum     = 0; ///< faces below the limit
	float       minAngle    = 0;
	int         invertedNum = 0;

	bool beats(const Poorness& before) const
	{
		return minAngle >= before.minAngle && invertedNum <= before.invertedNum &&
			   lack < before.lack;
	}
};

class PoorFaceRepair {
public:
	PoorFaceRepair(const Surface& surface, const BoundaryCurves& curves, const PoorFaces& wanted,
				   double shareOfWork, ResultMesh& result, Workers& workers) :
			surface_(surface),
			curves_(curves), wanted_(wanted), angle_(wanted.angleDeg * radians), map_(*wanted.map),
			mapFace_(numbersBelow(std::size_t(result.mesh.faceNum))),
			work_(
				std::int64_t(shareOfWork * double(workOf(Driver::PoorFaces, result.mesh.faceNum)))),
			r_(result), workers_(workers)
	{
	}

	bool raise() { return isWorthwhile() && raiseAngles(); }

	bool run()
	{
		if (!isWorthwhile()) return false;
		now_ = poorness();
		for (int round = 0; round < maxCountRounds; ++round) {
			if (!changeCountWhereItHelps()) break;
		}
		return lowerLargeAngles();
	}

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	const PoorFaces&      wanted_;
	float                 angle_;
	const ClosestFaceMap& map_;
	std::vector<int>      mapFace_;                   ///< see Assignment
	std::int64_t          work_;                      ///< left to all searches
	std::int64_t          workOfPairs_ = workOfPairs; ///< left to pairs of operations
	Poorness              now_; ///< of the result before the next change of the count
	ResultMesh&           r_;
	Workers&              workers_;

	bool isWorthwhile() const
	{
		return fewPoor.holds(findPoorFaces(r_.mesh, angle_, workers_).size(), r_.mesh);
	}

	/// A goal with limits on distances. An input vertex is guarded close to the largest distance of
	/// the mesh.
	Goal limited(Goal goal) const
	{
		constexpr float share = 0.7f;
		if (wanted_.largestGap > 0) goal.limits.guarded = share * wanted_.largestGap;
		if (wanted_.maxGap > 0) goal.limits.gap = wanted_.maxGap;
		return goal;
	}

	/// Raises angles by moves and flips.
	bool raiseAngles()
	{
		Assignment  assignment(surface_, map_, mapFace_);
		LocalSearch search(surface_, curves_, &assignment, work_, r_, workers_);
		Goal        goal = limited(smallAngles(search, angle_));
		if (!(wanted_.maxGap > 0)) return search.run(goal);
		bool isDone = true;
		for (float share : sharesOfMaxGap) {
			goal.limits.gap = share * wanted_.maxGap;
			isDone          = search.run(goal) && isDone;
		}
		return isDone;
	}

	/// Lowers large angles at the end, because large angles are less poor than small angles and
	/// must not take their work.
	bool lowerLargeAngles()
	{
		if (findObtuseFaces(r_.mesh, asPoorAs(angle_), workers_).empty()) return true;
		Assignment  assignment(surface_, map_, mapFace_);
		LocalSearch search(surface_, curves_, &assignment, work_, r_, workers_);
		return search.run(limited(largeAngles(search, angle_)));
	}

	/// Changes the count at poor faces. Returns false and restores the result if this does not
	/// help.
	bool changeCountWhereItHelps()
	{
		if (work_ <= 0 || now_.poorNum == 0) return false;
		const ResultMesh       start   = copyResult(r_, workers_);
		const std::vector<int> mapFace = mapFace_;
		if (changeCount()) {
			const Poorness after = poorness();
			if (after.beats(now_)) {
				now_ = after;
				return true;
			}
		}
		r_       = copyResult(start, workers_);
		mapFace_ = mapFace;
		return false;
	}

	/// False if nothing changed or the wanted count is out of reach.
	bool changeCount()
	{
		if (!changeByTrials()) return false;
		compact();
		const bool isReached = !wanted_.target.isGiven() ||
							   gpr::changeCount(surface_, curves_, wanted_.target, r_, workers_);
		compact();
		if (!isReached) return false;
		raiseAngles();
		return true;
	}

	/// Tries operations that change the count. Leaves dead faces in the mesh. False if nothing
	/// changed.
	bool changeByTrials()
	{
		Assignment   assignment(surface_, map_, mapFace_);
		std::int64_t work = work_;
		LocalSearch  search(surface_, curves_, &assignment, work, r_, workers_, roomForTrials);
		Goal         angles    = limited(smallAnglesByCount(search, angle_));
		angles.budget.attempts = attemptsByCount;
		if (fewForCount.holds(search.findBad(angles).size(), r_.mesh)) search.run(angles);
		work_                  = work;
		work                   = workOfPairs_;
		angles.budget.attempts = attemptsByPairs;
		angles.inPairs         = true;
		if (search.findBad(angles).size() <= maxForPairs) search.run(angles);
		workOfPairs_ = work;
		return search.changeNum() > 0;
	}

	/// Drops dead faces, and assigns the faces of the map to the faces that are left.
	void compact()
	{
		std::vector<int> mapFace;
		for (int f = 0; f < r_.mesh.faceNum; ++f) {
			const bool isNew = f >= int(mapFace_.size());
			if (!isDeadFace(r_.mesh, f)) mapFace.push_back(isNew ? -1 : mapFace_[f]);
		}
		mapFace_ = std::move(mapFace);
		compactResult(r_, workers_);
	}

	Poorness poorness() const
	{
		Poorness poorness = {0, 0, angle_, invertedFaceNum(surface_, r_, workers_)};
		for (int f : findPoorFaces(r_.mesh, angle_, workers_)) {
			++poorness.poorNum;
			const float  own  = smallestAngle(r_.mesh, f);
			const double lack = 1 - double(own) / angle_;
			poorness.lack += lack * lack;
			poorness.minAngle = std::min(poorness.minAngle, own);
		}
		return poorness;
	}
};

void makeMap(const Surface& surface, const ResultMesh& result, Workers& workers,
			 std::unique_ptr<ClosestFaceMap>& map)
{
	if (map == nullptr) map.reset(new ClosestFaceMap(surface, result, workers));
}

bool repairOrientation(LocalSearch& search, Goal goal, std::size_t invertedNum)
{
	if (!fewInverted.holds(invertedNum, search.mesh())) {
		goal.operations.erase(goal.operations.begin()); // the moves
		goal.limits = acceptanceOf(Driver::DegenerateFaces);
	}
	return search.run(goal);
}

/// Repairs degenerate faces. Feature lines side by side on the same straight line, like on a
/// surface folded flat, may hold all edges of a degenerate face, and vertices of curves keep their
/// spacing there. A gap in a line and crowded vertices are better than a degenerate face.
void repairFacesWithoutArea(LocalSearch& search)
{
	Goal goal = facesWithoutArea(search);
	search.run(goal);
	const std::vector<int> left = search.findBad(goal);
	if (left.empty()) return;
	for (int f : left)
		search.editor().forgetLinesAt(f);
	goal.mayCrowd = true;
	search.run(goal);
}

/// Whether f is the first face of a closed component of four.
bool isFirstOfTetrahedron(const HalfEdgeMesh& m, int f)
{
	if (isDeadFace(m, f) || m.valence(m.origin[3 * f]) != 3) return false;
	const std::vector<int> faces = widened(m, {f}, 1);
	return faces.size() == 4 && faces.front() == f && verticesOf(m, faces).size() == 4;
}

/// Whether a tetrahedron looks inside, by the normals of the surface at the corners of its four
/// faces.
bool looksInside(const Surface& surface, const ResultMesh& r, int first)
{
	float sum = 0;
	for (int f : widened(r.mesh, {first}, 1)) {
		const Vec3f n = r.mesh.faceCross(f);
		for (int h = 3 * f; h < 3 * f + 3; ++h)
			sum += dot(n, smoothNormal(surface, r.vertex[r.mesh.origin[h]].point));
	}
	return sum < 0;
}

/// Turns tetrahedra that look inside. Small components become tetrahedra, and four joined samples
/// may look inside as a whole; an exchange of two vertices turns the tetrahedron.
void turnTetrahedra(const Surface& surface, ResultMesh& r, Workers& workers)
{
	HalfEdgeMesh&          m     = r.mesh;
	const std::vector<int> first = workers.collectIf(std::size_t(m.faceNum), [&](int f) {
		const auto isAtCrease = [&](int v) { return m.isCreaseVertex(v); };
		return isFirstOfTetrahedron(m, f) &&
			   std::none_of(&m.origin[3 * f], &m.origin[3 * f] + 3, isAtCrease) &&
			   looksInside(surface, r, f);
	});
	for (int f : first) {
		const int a = m.origin[3 * f], b = m.origin[3 * f + 1];
		std::swap(m.position[a], m.position[b]);
		std::swap(r.vertex[a], r.vertex[b]);
	}
}

} // namespace

bool repairInvertedFaces(const Surface& surface, const BoundaryCurves& curves, bool mayCollapse,
						 ResultMesh& result, Workers& workers)
{
	turnTetrahedra(surface, result, workers);
	std::int64_t work = workOf(Driver::InvertedFaces, result.mesh.faceNum);
	LocalSearch  search(surface, curves, nullptr, work, result, workers);
	const Goal   goal = invertedFaces(search, mayCollapse);
	// Degenerate faces are among these.
	const std::size_t invertedNum = search.findBad(goal).size();
	const bool        isDone = invertedNum == 0 || repairOrientation(search, goal, invertedNum);
	if (mayCollapse)
		compactResult(result, workers);
	else if (invertedNum > 0)
		repairFacesWithoutArea(search);
	return isDone;
}

bool raiseAnglesOnSurface(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
						  ResultMesh& result, Workers& workers)
{
	const float angle = angleDeg * radians;
	if (findPoorFaces(result.mesh, angle, workers).empty()) return true;
	std::int64_t work = workOf(Driver::AnglesOnly, result.mesh.faceNum);
	LocalSearch  search(surface, curves, nullptr, work, result, workers);
	Goal         goal = smallAngles(search, angle);
	// Faces with the normals of the surface are near the surface, and intersect no other faces.
	goal.limits = acceptanceOf(Driver::AnglesOnly);
	return search.run(goal);
}

bool raiseSmallAngles(const Surface& surface, const BoundaryCurves& curves, PoorFaces& wanted,
					  ResultMesh& result, Workers& workers)
{
	if (findPoorFaces(result.mesh, wanted.angleDeg * radians, workers).empty()) return true;
	makeMap(surface, result, workers, wanted.map);
	return PoorFaceRepair(surface, curves, wanted, shareOfRaising, result, workers).raise();
}

bool repairPoorFaces(const Surface& surface, const BoundaryCurves& curves, PoorFaces& wanted,
					 ResultMesh& result, Workers& workers)
{
	const float angle = wanted.angleDeg * radians;
	if (findPoorFaces(result.mesh, angle, workers).empty() &&
		findObtuseFaces(result.mesh, asPoorAs(angle), workers).empty())
		return true;
	makeMap(surface, result, workers, wanted.map);
	return PoorFaceRepair(surface, curves, wanted, 1 - shareOfRaising, result, workers).run();
}

} // namespace gpr
