// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_goals.h"

#include <vcg_extras/core/mesh/face_quality.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpr {

namespace {

// ---- inverted faces

/// Below this agreement a face is bad, and below that it costs: a face that is about to turn over
/// draws its neighbours along.
constexpr float badAgreement = 0.05f, wantedAgreement = 0.3f;
/// The same for the agreement beside a feature line, where a face may stand on either side of a
/// sharp edge: 60° and 45°.
constexpr float badCreaseAgreement = 0.5f, wantedCreaseAgreement = 0.7f;
/// Poor shapes cost a little, so that a face is not turned by making a needle of its neighbour.
constexpr float wantedShape = 0.35f, shapeWeight = 0.2f;
/// Cost of a face without area: more than that of any two others, as no result may have one.
constexpr float costWithoutArea = 8;

float shortfall(float value, float wanted)
{
	return std::max(0.0f, wanted - value);
}

float costOfOrientation(const PatchEditor& editor, int f)
{
	const HalfEdgeMesh& m = editor.mesh();
	if (hasNoArea(m, f)) return costWithoutArea;
	const float off    = shortfall(editor.agreement(f), wantedAgreement);
	const float across = shortfall(editor.agreementAtCreases(f), wantedCreaseAgreement);
	const int*  c      = &m.origin[3 * f];
	const float shape  = triangleShape(m.position[c[0]], m.position[c[1]], m.position[c[2]]);
	return off * off + across * across + shapeWeight * shortfall(shape, wantedShape);
}

bool isInverted(const PatchEditor& editor, int f)
{
	return editor.agreement(f) < badAgreement || hasNoArea(editor.mesh(), f) ||
		   editor.agreementAtCreases(f) < badCreaseAgreement;
}

// ---- angles

/// Angles are wanted this much larger than asked for, so that none ends just below.
constexpr float angleMargin = 1.06f;

float lackOfAngle(const HalfEdgeMesh& m, int f, float angle, int power)
{
	const float lack = shortfall(smallestAngle(m, f) / (angleMargin * angle), 1);
	return power == 2 ? lack * lack : lack * lack * lack * lack;
}

// ---- the rows of limits

/// The limits of the goals side by side.
Limits limitsFor(float minNormalAgreement, float maxDistance, float rmsGrowth, float maxMove,
				 float maxTurn)
{
	Limits limits;
	limits.minNormalAgreement = minNormalAgreement;
	limits.maxDistance        = maxDistance;
	limits.rmsGrowth          = rmsGrowth;
	limits.maxMove            = maxMove;
	limits.maxTurn            = maxTurn;
	return limits;
}

//                                      agreement, distance, rms,       move, turn
const Limits limitsOfAngles        = limitsFor(0.6f, 0.05f, HUGE_VALF, 0.5f, 0.5f);
const Limits limitsOfCounts        = limitsFor(0.6f, 0.05f, 1.3f, 0.5f, 0.5f);
const Limits limitsOfIntersections = limitsFor(0.3f, 0.1f, 1.3f, 0.5f, 0.5f);
const Limits limitsOfOrientation   = limitsFor(-1, HUGE_VALF, HUGE_VALF, 0.6f, -1);

const std::vector<float> shortSteps = {0.16f, 0.08f, 0.04f, 0.02f};
const std::vector<float> longSteps  = {0.5f, 0.25f, 0.1f};

bool changesCount(const std::vector<Operation::Kind>& operations)
{
	return std::find(operations.begin(), operations.end(), Operation::Split) != operations.end();
}

} // namespace

const std::vector<Operation::Kind> keepingCount  = {Operation::Move, Operation::Flip};
const std::vector<Operation::Kind> changingCount = {Operation::Split, Operation::Attach,
													Operation::Collapse, Operation::CollapseBack};

Goal invertedFaces(LocalSearch& search, Workers& workers, bool mayCollapse)
{
	Goal goal;
	goal.findBad = [&search, &workers] {
		return workers.collect<int>(
			search.mesh().faceNum, [&](std::size_t begin, std::size_t end, auto& out) {
				for (int f = int(begin); f < int(end); ++f) {
					if (!isDeadFace(search.mesh(), f) && isInverted(search.editor(), f))
						out.push_back(f);
				}
			});
	};
	goal.isBad              = [&search](int f) { return isInverted(search.editor(), f); };
	goal.faceCost           = [&search](int f) { return costOfOrientation(search.editor(), f); };
	goal.operations         = keepingCount;
	goal.mostLeft           = 1;
	goal.leastGain          = 0.01f; // less is rounding
	goal.stepLengths        = longSteps;
	goal.limits             = limitsOfOrientation;
	goal.limits.gentleFlips = goal.limits.intersections = false;
	if (mayCollapse)
		goal.operations.insert(goal.operations.end(),
							   {Operation::Collapse, Operation::CollapseBack});
	goal.collapseCost    = 2 * goal.leastGain;
	goal.budget.attempts = 2000 + search.mesh().faceNum; // no result may have a face without area
	goal.settles         = false;                        // shapes come later
	// Where more than single faces look wrong the triangles are too large for the surface, and
	// moving vertices one by one, which costs most, repairs nothing.
	const std::size_t most = std::max<std::size_t>(500, std::size_t(search.mesh().faceNum) / 50);
	if (goal.findBad().size() > most) goal.operations.erase(goal.operations.begin()); // the moves
	return goal;
}

Goal facesWithoutArea(LocalSearch& search, Workers& workers)
{
	const HalfEdgeMesh& m      = search.mesh();
	const auto          isLine = [&m](int f) { return !isDeadFace(m, f) && hasNoArea(m, f); };
	Goal                goal   = invertedFaces(search, workers, false);
	goal.operations            = keepingCount;
	goal.isBad                 = isLine;
	goal.findBad               = [&m, &workers, isLine] {
        return workers.collect<int>(m.faceNum, [&](std::size_t begin, std::size_t end, auto& out) {
            for (int f = int(begin); f < int(end); ++f) {
                if (isLine(f)) out.push_back(f);
            }
        });
	};
	goal.budget.attempts   = std::numeric_limits<std::int64_t>::max();
	goal.budget.limitsWork = false;
	return goal;
}

Goal smallAngles(LocalSearch& search, Workers& workers, float angle, int power,
				 const std::vector<Operation::Kind>& operations, float guardedDistance)
{
	const HalfEdgeMesh& m = search.mesh();
	Goal                goal;
	goal.findBad     = [&m, &workers, angle] { return findPoorFaces(m, angle, workers); };
	goal.isBad       = [&m, angle](int f) { return smallestAngle(m, f) < angle; };
	goal.faceCost    = [&m, angle, power](int f) { return lackOfAngle(m, f, angle, power); };
	goal.operations  = operations;
	goal.takesFirst  = !changesCount(operations);
	goal.mostLeft    = changesCount(operations) ? 0.8f : 0.995f;
	goal.stepLengths = shortSteps;
	goal.limits      = changesCount(operations) ? limitsOfCounts : limitsOfAngles;
	goal.limits.guardedDistance = guardedDistance;
	return goal;
}

Goal selfIntersections(LocalSearch& search, const std::vector<int>& suspects, float angle,
					   const std::vector<Operation::Kind>& operations)
{
	const HalfEdgeMesh& m = search.mesh();
	Goal                goal;
	goal.findBad             = [suspects] { return suspects; };
	goal.isBad               = [&search](int f) { return search.intersects(f); };
	goal.faceCost            = [&m, angle](int f) { return lackOfAngle(m, f, angle, 2); };
	goal.countsIntersections = true;
	goal.mostLeft            = 1;
	goal.leastGain           = 0.49f; // a pair less, whatever the angles
	goal.operations          = operations;
	goal.takesFirst          = !changesCount(operations);
	goal.stepLengths         = longSteps;
	goal.raises              = !changesCount(operations);
	goal.limits              = limitsOfIntersections;
	goal.limits.minAngle     = angle;
	goal.budget.rounds       = 4;
	goal.budget.attempts     = 200;
	return goal;
}

} // namespace gpr
