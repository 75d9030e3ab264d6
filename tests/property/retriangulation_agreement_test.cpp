// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Collapse by labels and the paper's vertex removal make the same mesh: on a smooth closed surface
// the same samples have the same edges, except at places with a choice in the Delaunay criterion.

#include <tests/support/mesh_audit.h>
#include <tests/support/mesh_builders.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>

namespace gpr::test {

namespace {

constexpr double pi = 3.14159265358979323846;

/// A result in terms of its samples: the third corners of the faces at each edge.
class Joined {
public:
	Joined(const RemeshResult& result, const std::vector<Vec3d>& points) : p_(points)
	{
		for (std::size_t x = 0; x < result.mesh.triangles.size(); x += 3) {
			std::array<int, 3> corner;
			for (int k = 0; k < 3; ++k)
				corner[k] = result.sampleOf[result.mesh.triangles[x + k]];
			for (int k = 0; k < 3; ++k)
				apexes_[ends(corner[k], corner[(k + 1) % 3])].push_back(corner[(k + 2) % 3]);
		}
		for (auto& edge : apexes_)
			std::sort(edge.second.begin(), edge.second.end());
	}

	using Ends = std::pair<int, int>;
	static Ends ends(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

	const std::map<Ends, std::vector<int>>& edges() const { return apexes_; }
	bool  has(int a, int b) const { return apexes_.count(ends(a, b)) > 0; }
	Vec3d at(int sample) const { return p_[sample]; }

	/// The third corners at an edge in ascending order; empty without this edge.
	std::vector<int> apexesOf(const Ends& ends) const
	{
		const auto found = apexes_.find(ends);
		return found == apexes_.end() ? std::vector<int>() : found->second;
	}

	int valence(int sample) const
	{
		int n = 0;
		for (const auto& edge : apexes_)
			n += edge.first.first == sample || edge.first.second == sample;
		return n;
	}

private:
	const std::vector<Vec3d>&        p_;
	std::map<Ends, std::vector<int>> apexes_;
};

double angleAt(const Vec3d& p, const Vec3d& a, const Vec3d& b)
{
	return std::atan2(length(cross(a - p, b - p)), dot(a - p, b - p));
}

/// Why the other result lacks an edge a-b; c and d are the third corners of both faces at a-b.
enum class Reason {
	CoCircular,   ///< the angles opposite a-b, and opposite c-d, add up to 180° within 1e-3
	BothDelaunay, ///< the corners are not in a plane: a-b and c-d are both Delaunay
	GuardValence, ///< a-b is not Delaunay, but a flip would leave two faces at an end
	GuardDouble,  ///< or c-d is an edge already
	GuardFold,    ///< or a flip would fold the surface
	Follows,      ///< the other result lacks the same four corners, as an edge nearby differs
	None,
};

const char* const reasonNames[] = {"co-circular within 1e-3",
								   "both diagonals Delaunay",
								   "guard: two faces left",
								   "guard: edge there already",
								   "guard: fold",
								   "follows from another",
								   "no reason"};

/// Which guard of flipToDelaunay forbids the flip of a-b to c-d.
Reason guardOf(const Joined& joined, const Joined::Ends& ends, const std::vector<int>& apexes)
{
	const int   c = apexes[0], d = apexes[1];
	const Vec3d pa = joined.at(ends.first), pb = joined.at(ends.second);
	const Vec3d pc = joined.at(c), pd = joined.at(d);
	if (joined.has(c, d)) return Reason::GuardDouble;
	if (joined.valence(ends.first) <= 3 || joined.valence(ends.second) <= 3)
		return Reason::GuardValence;
	const Vec3d n1 = cross(pa - pc, pb - pc), n2 = cross(pb - pd, pa - pd);
	const Vec3d m1 = cross(pa - pc, pd - pc), m2 = cross(pd - pc, pb - pc);
	return dot(m1, n1 + n2) <= 0 || dot(m2, n1 + n2) <= 0 ? Reason::GuardFold : Reason::None;
}

/// Sum of the angles opposite the diagonal a-b of four corners, less 180°: a diagonal with a sum
/// above 0 is not Delaunay.
double excess(const Joined& joined, const Joined::Ends& ends, const std::vector<int>& apexes)
{
	const Vec3d a = joined.at(ends.first), b = joined.at(ends.second);
	return angleAt(joined.at(apexes[0]), a, b) + angleAt(joined.at(apexes[1]), a, b) - pi;
}

Reason reasonFor(const Joined& joined, const Joined& other, const Joined::Ends& ends)
{
	const std::vector<int> apexes    = joined.apexesOf(ends);
	const Joined::Ends     crossing  = Joined::ends(apexes[0], apexes[1]);
	const std::vector<int> endsApart = {ends.first, ends.second};
	const double           own       = excess(joined, ends, apexes);
	const double           others    = excess(joined, crossing, endsApart);
	if (std::abs(own) <= 1e-3 && std::abs(others) <= 1e-3) return Reason::CoCircular;
	if (own > 1e-3) return guardOf(joined, ends, apexes);
	if (other.apexesOf(crossing) != endsApart) return Reason::Follows;
	return others > 1e-3 ? guardOf(other, crossing, endsApart) : Reason::BothDelaunay;
}

using Reasons = std::map<Reason, int>;

/// Reasons of the edges in `joined` but not in `other`.
Reasons differences(const Joined& joined, const Joined& other)
{
	Reasons reasons;
	for (const auto& edge : joined.edges()) {
		const Joined::Ends& ends = edge.first;
		if (!other.has(ends.first, ends.second)) ++reasons[reasonFor(joined, other, ends)];
	}
	return reasons;
}

int total(const Reasons& reasons)
{
	int sum = 0;
	for (const auto& reason : reasons)
		sum += reason.second;
	return sum;
}

RemeshResult retriangulated(const TriangleMesh& mesh, const std::vector<Vec3d>& points, Preset how)
{
	RemeshOptions options;
	options.threads = 2;
	options.preset  = how;
	return retriangulate(mesh.view(), points, options);
}

struct Shape {
	const char*  name;
	TriangleMesh mesh;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
	return out << shape.name;
}

TriangleMesh bumpySphere(int level, double height)
{
	TriangleMesh mesh = icosphere(level);
	for (Vec3d& p : mesh.positions)
		p = p * (1 + height * std::sin(5 * p.x) * std::sin(4 * p.y + 1) * std::cos(3 * p.z));
	return mesh;
}

TriangleMesh ellipsoid(int level)
{
	TriangleMesh mesh = icosphere(level);
	for (Vec3d& p : mesh.positions)
		p = {p.x, 0.7 * p.y, 2 * p.z};
	return mesh;
}

std::vector<Shape> smoothShapes()
{
	return {{"sphere", icosphere(6)},        {"ellipsoid", ellipsoid(6)},
			{"torus", torus(250, 120)},      {"thinTorus", torus(400, 60, 1, 0.15)},
			{"bumpy", bumpySphere(6, 0.08)}, {"bumpier", bumpySphere(6, 0.2)}};
}

class SmoothShape : public ::testing::TestWithParam<Shape> {};

/// Both results of the same samples.
struct Pair {
	SamplingResult sampling;
	RemeshResult   collapsed, removed;

	Pair(const TriangleMesh& mesh, double percent, std::uint32_t seed)
	{
		RemeshOptions options;
		options.threads       = 2;
		options.targetPercent = percent;
		options.seed          = seed;
		sampling              = samplePoissonDisks(mesh.view(), options);
		collapsed             = retriangulated(mesh, sampling.points, Preset::Default);
		removed               = retriangulated(mesh, sampling.points, Preset::Paper);
	}
};

/// At most one edge in a hundred differs, each for a known reason.
void expectAgreement(const Joined& joined, const Joined& other)
{
	Reasons   reasons = differences(joined, other);
	const int all = total(reasons), edgeNum = int(joined.edges().size());
	EXPECT_LE(all, edgeNum / 100);
	EXPECT_EQ(reasons[Reason::None], 0);
	EXPECT_LE(2 * reasons[Reason::Follows], all);
	for (const auto& [reason, n] : reasons) {
		if (n > 0) std::printf("%d of %d edges differ: %s\n", n, edgeNum, reasonNames[int(reason)]);
	}
}

TEST_P(SmoothShape, IsJoinedAlikeByBothRetriangulations)
{
	const TriangleMesh& mesh = GetParam().mesh;
	for (double percent : {4.0, 10.0, 30.0}) {
		for (std::uint32_t seed : testSeeds(2)) {
			SCOPED_TRACE(std::to_string(percent) + " %, seed " + std::to_string(seed));
			const Pair pair(mesh, percent, seed);
			ASSERT_EQ(pair.collapsed.mesh.vertexNum(), pair.sampling.points.size());
			ASSERT_EQ(pair.removed.mesh.vertexNum(), pair.sampling.points.size());
			const Joined a(pair.collapsed, pair.sampling.points);
			const Joined b(pair.removed, pair.sampling.points);
			expectAgreement(a, b);
			expectAgreement(b, a);
		}
	}
}

INSTANTIATE_TEST_SUITE_P(, SmoothShape, ::testing::ValuesIn(smoothShapes()),
						 [](const auto& shape) { return std::string(shape.param.name); });

/// The test finds no reason for a flip of a Delaunay edge.
TEST(RetriangulationsAgree, AndTheTestWouldTell)
{
	Pair                      pair(icosphere(4), 20, 1);
	std::vector<std::int32_t> triangles = pair.collapsed.mesh.triangles;
	const std::int32_t        a = triangles[0], b = triangles[1], c = triangles[2];
	for (std::size_t x = 3; x < triangles.size(); ++x) {
		std::int32_t* face = &triangles[x / 3 * 3];
		if (triangles[x] != b || face[(x + 1) % 3] != a) continue;
		const std::int32_t d         = face[(x + 2) % 3];
		const std::int32_t turned[6] = {a, d, c, d, b, c};
		std::copy(turned, turned + 3, triangles.begin());
		std::copy(turned + 3, turned + 6, face);
		break;
	}
	pair.removed.mesh.triangles = triangles;
	pair.removed.sampleOf       = pair.collapsed.sampleOf;
	const Joined before(pair.collapsed, pair.sampling.points);
	const Joined after(pair.removed, pair.sampling.points);
	EXPECT_EQ(total(differences(before, after)), 1);
	EXPECT_EQ(differences(before, after)[Reason::None], 1);
	EXPECT_EQ(differences(after, before)[Reason::None], 1);
}

} // namespace

} // namespace gpr::test
