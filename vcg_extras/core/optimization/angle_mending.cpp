// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "angle_mending.h"

#include "patch_mover.h"

#include <vcg_extras/core/mesh/crossing_faces.h>
#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/vain_tries.h>

#include <algorithm>
#include <iterator>

namespace gpr {

namespace {

/// Rounds over all poor faces.
constexpr int mostRounds = 8;
/// Trials that end with crossing faces; then nothing is changed.
constexpr int mostTrials = 4;
/// Above so many poor faces, or this share of all, the triangles are hopelessly large for the
/// surface, and changes one by one mend nothing.
constexpr std::size_t mostPoor      = 500;
constexpr float       mostPoorShare = 0.01f;
/// Faces that are tried in all, and one more for so many faces of the mesh: what takes long on a
/// rough surface is hopeless mostly, and the sharpest come first.
constexpr std::int64_t mostTries       = 2000;
constexpr std::int64_t facesForOneMore = 2000;

class AngleMender : PatchMover {
public:
	AngleMender(const Surface& surface, const BoundaryCurves& curves, float angle,
				ResultMesh& result, Workers& workers, const CellsOfFaces& cells) :
			PatchMover(surface, curves, angle, result, workers, cells)
	{
	}

	/// False if not all could be tried, or if there was no end of crossing faces and nothing is
	/// changed.
	bool run()
	{
		start_ = copyResult(r_, workers_);
		for (int trial = 0; trial < mostTrials; ++trial) {
			mendAll();
			if (!blockNewlyCrossing()) return triesLeft_ > 0;
			r_ = copyResult(start_, workers_);
		}
		return false;
	}

private:
	ResultMesh        start_;
	std::vector<char> touched_; ///< vertices that moved or whose faces were flipped
	std::vector<int>  poor_;    ///< faces, ascending
	std::int64_t      triesLeft_ = 0;
	VainTries         tries_{0};
	std::vector<int>  changed_; ///< vertices touched since these were looked for

	/// Blocks what touched faces cross now. False if no face crosses another that did not before.
	bool blockNewlyCrossing()
	{
		const std::vector<char> changed = touchedFaces();
		if (std::find(changed.begin(), changed.end(), char(1)) == changed.end()) return false;
		const std::vector<int> now = findCrossingFaces(m_, changed, workers_);
		if (now.empty()) return false;
		const std::vector<int> before = findCrossingFaces(start_.mesh, changed, workers_);
		bool                   found  = false;
		for (int f : now) {
			const bool isOld = std::binary_search(before.begin(), before.end(), f);
			for (int k = 0; k < 3; ++k) {
				const int v = m_.origin[3 * f + k];
				if (isOld && !touched_[v]) continue;
				found       = true;
				blocked_[v] = 1;
			}
		}
		return found;
	}

	/// A mark per face: whether a corner of it is touched. Flips do not change which faces these
	/// are.
	std::vector<char> touchedFaces() const
	{
		std::vector<char> faces(m_.faceNum, 0);
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (touched_[v]) forEachOutgoing(m_, v, [&](int h) { faces[h / 3] = 1; });
		}
		return faces;
	}

	void mendAll()
	{
		triesLeft_ = mostTries + m_.faceNum / facesForOneMore;
		touched_.assign(m_.vertexNum, 0);
		poor_ = findPoorFaces(m_, angle_, workers_);
		resetNormals();
		tries_ = VainTries(m_.vertexNum);
		for (bool worstFirst : {false, true, false}) {
			worstFirst_ = worstFirst;
			mendByRounds();
		}
	}

	void mendByRounds()
	{
		for (int round = 0; round < mostRounds; ++round) {
			lookAgain();
			bool better = false;
			for (int f : sharpestFirst(m_, poor_)) {
				workers_.poll();
				if (smallestAngle(m_, f) >= angle_ || tries_.isVain(m_, f, worstFirst_)) continue;
				if (triesLeft_ == 0) return;
				--triesLeft_;
				if (mend(f))
					better = true;
				else
					tries_.noteVain(m_, f, worstFirst_);
			}
			if (!better) return;
		}
	}

	/// Only faces that were poor, or that changed, can be poor now.
	void lookAgain()
	{
		const std::vector<int> round = facesRound(m_, changed_);
		std::vector<int>       faces;
		std::set_union(poor_.begin(), poor_.end(), round.begin(), round.end(),
					   std::back_inserter(faces));
		changed_.clear();
		poor_.clear();
		for (int f : faces) {
			if (smallestAngle(m_, f) < angle_) poor_.push_back(f);
		}
	}

	void touch(int v)
	{
		touched_[v] = 1;
		changed_.push_back(v);
		tries_.noteChange(v);
	}

	bool mend(int f)
	{
		bool better = false;
		for (int v : patchCorners(f)) {
			if (!moveToBest(v)) continue;
			touch(v);
			better = true;
		}
		for (int k = 0; k < 3 && smallestAngle(m_, f) < angle_; ++k)
			better = flipAndMove(3 * f + k) || better;
		return better;
	}

	/// Corners of f and of the faces beyond its edges.
	std::vector<int> patchCorners(int f) const
	{
		std::vector<int> corners(&m_.origin[3 * f], &m_.origin[3 * f] + 3);
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			if (m_.opposite[h] >= 0) corners.push_back(m_.apex(m_.opposite[h]));
		}
		return corners;
	}

	/// Flips h and lets the vertices round it move; keeps that only if it pays together.
	bool flipAndMove(int h)
	{
		if (!mayFlip(h)) return false;
		const std::array<int, 4> corners  = cornersAt(h);
		const std::vector<int>   faces    = facesRound(m_, {corners.begin(), corners.end()});
		const Quality            before   = patchQuality(faces);
		const float              enough   = farthestOff * meanEdge(corners[0]);
		const Distance           distance = distanceFrom(faces, faces, enough);
		std::array<Place, 4>     places;
		for (int k = 0; k < 4; ++k)
			places[k] = placeOf(corners[k]);
		flip(m_, h);
		for (int v : corners)
			moveToBest(v);
		if (patchQuality(faces).beats(before) && keepsDistance(faces, faces, enough, distance)) {
			for (int v : corners)
				touch(v);
			++r_.flipNum;
			return true;
		}
		for (int k = 0; k < 4; ++k) {
			put(corners[k], places[k]);
			changed_.push_back(corners[k]); // flipping back may exchange the faces' numbers
		}
		flip(m_, nextInFace(h));
		return false;
	}
};

/// Whether there is something to mend, and hope to.
bool isMendable(const HalfEdgeMesh& m, float angle, Workers& workers)
{
	const std::size_t num  = findPoorFaces(m, angle, workers).size();
	const float       most = mostPoorShare * float(m.faceNum);
	return num > 0 && num <= std::max(mostPoor, std::size_t(most));
}

} // namespace

bool mendAngles(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
				ResultMesh& result, Workers& workers, std::unique_ptr<Cells>& cells,
				float largestGap)
{
	const float angle = angleDeg * radians;
	if (!isMendable(result.mesh, angle, workers)) return true;
	if (cells == nullptr) cells.reset(new Cells(surface, result, workers));
	const CellsOfFaces own{*cells, {}, largestGap};
	return AngleMender(surface, curves, angle, result, workers, own).run();
}

bool mendAngles(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
				ResultMesh& result, Workers& workers)
{
	std::unique_ptr<Cells> cells;
	return mendAngles(surface, curves, angleDeg, result, workers, cells);
}

bool mendAngles(const Surface& surface, const BoundaryCurves& curves, float angleDeg,
				ResultMesh& result, Workers& workers, const CellsOfFaces& cells)
{
	const float angle = angleDeg * radians;
	if (!isMendable(result.mesh, angle, workers)) return true;
	return AngleMender(surface, curves, angle, result, workers, cells).run();
}

} // namespace gpr
