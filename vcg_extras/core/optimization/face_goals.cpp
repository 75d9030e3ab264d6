// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "face_goals.h"

#include <vcg_extras/core/mesh/face_quality.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace gpr {

namespace {

// ---- inverted faces

/// A face with a smaller agreement is bad; a face below minAgreement costs, so that a face close to
/// inversion pulls its neighbours along.
constexpr float badAgreement = 0.05f;
/// The same for the agreement beside a feature line, with faces on either side of a crease edge:
/// 60° and 45°.
constexpr float badCreaseAgreement = 0.5f, wantedCreaseAgreement = 0.7f;
/// Poor shapes cost a little, so that no face is turned by a needle beside the face.
constexpr float wantedShape = 0.35f, shapeWeight = 0.2f;
/// Cost of a degenerate face: more than the cost of any two other faces, because no result may have
/// a degenerate face.
constexpr float costWithoutArea = 8;

float shortfall(float value, float wanted)
{
	return std::max(0.0f, wanted - value);
}

float costOfOrientation(const PatchEditor& editor, int f)
{
	const HalfEdgeMesh& m = editor.mesh();
	if (hasNoArea(m, f)) return costWithoutArea;
	const float off    = shortfall(editor.agreement(f), minAgreement);
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

/// Factor on the wanted angles, so that no angle ends just below the limit.
constexpr float angleMargin = 1.06f;

/// The squared lack of the smallest angle; squares give the worst faces the most weight.
class LackOfAngle {
public:
	LackOfAngle(const HalfEdgeMesh& m, float angle) :
			wanted_(angleMargin * angle), isPoor_(m, wanted_)
	{
	}

	float operator()(int f) const
	{
		const float lack = shortfall(isPoor_.angleOrLimit(f) / wanted_, 1);
		return lack * lack;
	}

private:
	float        wanted_;
	PoorFaceTest isPoor_;
};

/// The squared excess of the largest angle, on the scale of LackOfAngle: 1 at 180°.
float excessOfAngle(const HalfEdgeMesh& m, int f, float largest)
{
	const float rest = (float(pi) - obtuseAngle(m, f)) / (angleMargin * (float(pi) - largest));
	const float lack = shortfall(rest, 1);
	return lack * lack;
}

// ---- contacts

/// Cost of a contact: the cost of two faces without an angle, so that contacts go at the price of
/// poor angles, but not at any price.
constexpr float costOfContact = 2;
/// Smaller angles cost.
constexpr float wantedBesideContacts = 30 * radians;

// ---- operations

const std::vector<float> shortSteps = {0.12f, 0.03f};
const std::vector<float> longSteps  = {0.5f, 0.25f, 0.1f};

/// Operations that keep the number of vertices.
const std::vector<Operation::Kind> keepingCount = {Operation::Move, Operation::Flip};

} // namespace

Goal invertedFaces(LocalSearch& search, bool mayCollapse)
{
	const PatchEditor& editor = search.editor();
	Goal               goal;
	goal.isBad       = [&editor](int f) { return isInverted(editor, f); };
	goal.faceCost    = [&editor](int f) { return costOfOrientation(editor, f); };
	goal.operations  = keepingCount;
	goal.maxLeft     = 1;
	goal.minGain     = 0.01f; // smaller gains are rounding errors
	goal.stepLengths = longSteps;
	goal.limits      = acceptanceOf(Driver::InvertedFaces);
	if (mayCollapse)
		goal.operations.insert(goal.operations.end(),
							   {Operation::Collapse, Operation::CollapseBack});
	goal.collapseCost    = 2 * goal.minGain;                         // keeps the tips of fingers
	goal.budget.attempts = std::numeric_limits<std::int64_t>::max(); // only work is limited
	goal.settles         = false;                                    // shapes come later
	return goal;
}

Goal facesWithoutArea(LocalSearch& search)
{
	const HalfEdgeMesh& m    = search.mesh();
	Goal                goal = invertedFaces(search, false);
	goal.isBad               = [&m](int f) { return hasNoArea(m, f); };
	goal.limits              = acceptanceOf(Driver::DegenerateFaces);
	goal.budget.limitsWork   = false;
	return goal;
}

Goal smallAngles(LocalSearch& search, float angle)
{
	const HalfEdgeMesh& m = search.mesh();
	Goal                goal;
	goal.isBad          = PoorFaceTest(m, angle);
	goal.faceCost       = LackOfAngle(m, angle);
	goal.operations     = keepingCount;
	goal.takesFirst     = true;
	goal.stepLengths    = shortSteps;
	goal.limits         = acceptanceOf(Driver::PoorFaces, angle);
	goal.budget.maxLeft = 0.95f; // more rounds would cost more than the gain
	return goal;
}

Goal smallAnglesByCount(LocalSearch& search, float angle)
{
	Goal goal       = smallAngles(search, angle);
	goal.operations = {Operation::Split, Operation::Attach, Operation::Collapse,
					   Operation::CollapseBack};
	goal.takesFirst = false;
	goal.maxLeft    = 0.8f;
	return goal;
}

Goal facesInContact(LocalSearch& search, std::function<bool(int face)> isWanted)
{
	Goal goal;
	goal.isBad       = [&search, isWanted](int f) { return isWanted(f) && search.hasContact(f); };
	goal.faceCost    = LackOfAngle(search.mesh(), wantedBesideContacts);
	goal.contactCost = costOfContact;
	goal.operations  = keepingCount;
	goal.maxLeft     = 1;
	goal.minGain     = costOfContact / 4;
	goal.stepLengths = longSteps;
	goal.limits      = acceptanceOf(Driver::Contacts);
	goal.budget.attempts = std::numeric_limits<std::int64_t>::max(); // only work is limited
	goal.settles         = false;
	return goal;
}

Goal splitFaces(std::function<bool(int face)> isWanted)
{
	Goal goal;
	goal.isBad           = std::move(isWanted);
	goal.faceCost        = [](int) { return -1.0f; }; // more faces cost less
	goal.operations      = {Operation::Split};
	goal.maxLeft         = 1;
	goal.takesFirst      = true;
	goal.limits          = acceptanceOf(Driver::Refinement);
	goal.budget.rounds   = 1;
	goal.budget.attempts = std::numeric_limits<std::int64_t>::max(); // only work is limited
	goal.settles         = false;
	return goal;
}

float asPoorAs(float smallestAngle)
{
	constexpr float share = 70.0f / 32; // (180° - 110°) / 32°
	return float(pi) - share * smallestAngle;
}

Goal largeAngles(LocalSearch& search, float angle)
{
	const HalfEdgeMesh& m       = search.mesh();
	const float         largest = asPoorAs(angle);
	Goal                goal    = smallAngles(search, angle);
	goal.isBad                  = [&m, largest](int f) { return obtuseAngle(m, f) > largest; };
	goal.faceCost               = [&m, lack = LackOfAngle(m, angle), largest](int f) {
        return lack(f) + excessOfAngle(m, f, largest);
	};
	goal.limits = acceptanceOf(Driver::LargeAngles, angle);
	return goal;
}

} // namespace gpr
