// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "acceptance.h"

#include <vcg_extras/core/mesh/face_quality.h>

namespace gpr {

namespace {

constexpr float any = HUGE_VALF;
/// The caller gives the angle.
constexpr float asked = -1;

/// The most work of a search, see workOf; 0: the driver does not search, or has no limit.
struct Work {
	int millions = 0, perFace = 0;
};

struct Row {
	Driver     driver;
	Acceptance limits;
	Work       work = {};
};

/// All limits of the engine side by side.
/// - turn .5: a face that turns by more than 60° would soon become a fold. -2: any.
/// - shape .6: the shape of 30°-30°-120°.
/// - distance .05 of an edge: closer points of the input are near enough.
/// - move .5: a vertex stays close to its place among its neighbours.
/// Work:
/// - PoorFaces: half a second, and a tenth of the run on large meshes; also for LargeAngles. On
///   parts full of needles nothing helps, and the search would last much longer than the rest of
///   the run. With two thirds of this the worst angle of 20 noisy spheres is 1° smaller on the
///   mean; with four thirds the angle is .4° larger and the search a sixth longer.
/// - InvertedFaces: .06 s, and a microsecond for each face. Where this ends a search, most of the
///   surface is thinner than the triangles are wide, and the guard makes most of the mesh anew.
///   More work there takes away thin parts by collapses: with six times as much, the distance from
///   a slab of an MRI head was up to a fifth larger.
/// - Refinement: without a limit, the tests for contacts took half a minute on sheets that lie in
///   each other.
/// - Contacts: of all patches of a turn. Less work removes fewer contacts; more work took longer
///   than making the patches anew.
constexpr Row table[] = {
	// clang-format off
	// driver                turn  shape angle         agreement     distance move normalTurn gentle contacts, work
	{Driver::Relaxation,     {0.5f, 0.6f, 0,            -1,           any,   any,  -2,   false, false}},
	{Driver::Fit,            {0.5f, 0,    asked,        minAgreement, any,   any,  -2,   false, false}},
	{Driver::CurveFit,       {0.5f, 0,    asked,        -1,           any,   any,  -2,   false, false}},
	{Driver::Count,          {0.1f, 0,    0.3f * minFlipAngle, -1,           any,   any,  -2,   false, false}},
	{Driver::InvertedFaces,  {-2,   0,    0,            -1,           any,   0.6f, -2,   false, true},  {3, 50}},
	{Driver::DegenerateFaces, {-2,  0,    0,            -1,           any,   0.6f, -2,   false, false}},
	{Driver::AnglesOnly,     {-2,   0,    0,            0.8f,         any,   0.5f, 0.5f, true,  false}, {30, 20}},
	{Driver::PoorFaces,      {-2,   0,    0,            0.6f,         0.05f, 0.5f, 0.5f, true,  false}, {30, 20}},
	{Driver::LargeAngles,    {-2,   0,    asked,        0.6f,         0.05f, 0.5f, 0.5f, true,  false}},
	{Driver::WorstDistances, {0.5f, 0,    asked,        minAgreement, any,   any,  -2,   false, false}},
	{Driver::Refinement,     {-2,   0,    5 * radians,  0,            any,   any,  -2,   false, true},  {60, 0}},
	{Driver::Contacts,       {-2,   0,    5 * radians,  0.2f,         any,   any,  -2,   false, false}, {16, 0}},
	{Driver::GuardedRelaxation, {0.7f, 0, 0,            0.2f,         0.1f,  any,  -2,   false, true}},
	// clang-format on
};

/// A triangle with smallest angle α has at most the shape √3 sin α / (2 - cos α), if isosceles. So
/// a triangle with at least this shape has no angle below soundAngle.
constexpr float soundShape = 0.86f, soundAngle = 0.61f; // 35°

/// Squared shape of a triangle with the given cross product; see triangleShape. No root.
float squaredShape(const Vec3f& cross, const Corners& f)
{
	const float edges =
		squaredLength(f.b - f.a) + squaredLength(f.c - f.b) + squaredLength(f.a - f.c) + 1e-30f;
	return 12 * squaredLength(cross) / (edges * edges);
}

} // namespace

Acceptance acceptanceOf(Driver driver, float angle)
{
	Acceptance limits = table[std::size_t(driver)].limits;
	if (limits.angle == asked) limits.angle = angle;
	return limits;
}

std::int64_t workOf(Driver driver, int faceNum)
{
	const Work& work = table[std::size_t(driver)].work;
	return std::int64_t(work.millions) * 1'000'000 + std::int64_t(work.perFace) * faceNum;
}

bool spoilsFace(const Acceptance& limits, const Corners& before, const Corners& after)
{
	const Vec3f now = after.cross(), then = before.cross();
	const float turn = dot(now, then), cosine = limits.turn;
	if (cosine > -1 &&
		(turn <= 0 || turn * turn < cosine * cosine * squaredLength(now) * squaredLength(then)))
		return true;
	// Nearly all faces are sound, and angles take long to compute.
	const float shape = squaredShape(now, after);
	if (shape >= soundShape * soundShape && limits.angle <= soundAngle) return false;
	if (shape < limits.shape * limits.shape && shape < squaredShape(then, before)) return true;
	if (limits.angle == 0) return false;
	const float angle = smallestAngle(after.a, after.b, after.c);
	return angle < limits.angle &&
		   angle < limits.falls * smallestAngle(before.a, before.b, before.c);
}

bool spoilsRing(const Acceptance& limits, const HalfEdgeMesh& m, int v, const Vec3f& to,
				int without)
{
	const Vec3f from = m.position[v];
	return anyOutgoing(m, v, [&](int h) {
		if (m.target(h) == without || m.apex(h) == without) return false;
		const Vec3f a = m.position[m.target(h)], b = m.position[m.apex(h)];
		return spoilsFace(limits, {from, a, b}, {to, a, b});
	});
}

} // namespace gpr
