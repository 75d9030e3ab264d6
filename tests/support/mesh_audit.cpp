// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_audit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace gpr::test {

namespace {

using Edge = std::pair<int, int>;

/// An edge of a face.
struct EdgeUse {
	Edge edge; ///< the smaller vertex first
	bool ascending;
	int  face;

	bool operator<(const EdgeUse& o) const
	{
		return edge != o.edge ? edge < o.edge : face < o.face;
	}
};

std::vector<EdgeUse> edgeUses(const TriangleMesh& mesh)
{
	std::vector<EdgeUse> uses;
	for (int f = 0; f < int(mesh.faceNum()); ++f) {
		for (int k = 0; k < 3; ++k) {
			const int a = mesh.triangles[3 * f + k], b = mesh.triangles[3 * f + (k + 1) % 3];
			uses.push_back({{std::min(a, b), std::max(a, b)}, a < b, f});
		}
	}
	std::sort(uses.begin(), uses.end());
	return uses;
}

/// Disjoint sets of numbers below n (union-find).
class Groups {
public:
	explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
	int  find(int x) { return parent_[x] == x ? x : parent_[x] = find(parent_[x]); }
	void join(int a, int b) { parent_[find(a)] = find(b); }

private:
	std::vector<int> parent_;
};

class Auditor {
public:
	explicit Auditor(const TriangleMesh& mesh) : mesh_(mesh), groups_(mesh.faceNum()) {}

	SurfaceFacts run()
	{
		facts_.faces = std::int64_t(mesh_.faceNum());
		for (std::int32_t v : mesh_.triangles)
			facts_.indicesOutOfRange += v < 0 || std::size_t(v) >= mesh_.vertexNum();
		if (facts_.indicesOutOfRange > 0) return facts_;
		checkVertices();
		checkFaces();
		checkEdges();
		checkFans();
		std::set<int> components;
		for (int f = 0; f < int(mesh_.faceNum()); ++f)
			components.insert(groups_.find(f));
		facts_.components = std::int64_t(components.size());
		return facts_;
	}

private:
	const TriangleMesh& mesh_;
	Groups              groups_;
	SurfaceFacts        facts_;

	void checkVertices()
	{
		std::vector<char> used(mesh_.vertexNum(), 0);
		for (std::int32_t v : mesh_.triangles)
			used[v] = 1;
		facts_.usedVertices   = std::count(used.begin(), used.end(), 1);
		facts_.unusedVertices = std::int64_t(mesh_.vertexNum()) - facts_.usedVertices;
		for (const Vec3d& p : mesh_.positions)
			facts_.notFinite += !(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
	}

	void checkFaces()
	{
		std::vector<std::array<int, 3>> sorted;
		for (std::size_t f = 0; f < mesh_.faceNum(); ++f) {
			const std::int32_t* t = &mesh_.triangles[3 * f];
			sorted.push_back({t[0], t[1], t[2]});
			std::sort(sorted.back().begin(), sorted.back().end());
			facts_.repeatedCorners += t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
			const Vec3d  a       = mesh_.positions[t[0]];
			const Vec3d  doubled = cross(mesh_.positions[t[1]] - a, mesh_.positions[t[2]] - a);
			const double area    = 0.5 * length(doubled);
			facts_.area += area;
			facts_.zeroAreaFaces += !(area > 0);
		}
		std::sort(sorted.begin(), sorted.end());
		for (std::size_t i = 1; i < sorted.size(); ++i)
			facts_.duplicateFaces += sorted[i] == sorted[i - 1];
	}

	void checkEdges()
	{
		const std::vector<EdgeUse> uses = edgeUses(mesh_);
		Groups                     rims(mesh_.vertexNum());
		std::set<int>              rimVertices;
		for (std::size_t i = 0; i < uses.size();) {
			std::size_t end = i + 1;
			for (; end < uses.size() && uses[end].edge == uses[i].edge; ++end)
				groups_.join(uses[i].face, uses[end].face);
			++facts_.edges;
			facts_.crowdedEdges += end - i > 2;
			facts_.againstEachOther += end - i == 2 && uses[i].ascending == uses[i + 1].ascending;
			if (end - i == 1) {
				++facts_.borderEdges;
				rims.join(uses[i].edge.first, uses[i].edge.second);
				rimVertices.insert({uses[i].edge.first, uses[i].edge.second});
			}
			i = end;
		}
		std::set<int> loops;
		for (int v : rimVertices)
			loops.insert(rims.find(v));
		facts_.boundaryLoops = std::int64_t(loops.size());
	}

	/// Each face at a vertex leads from one neighbour to the next. The way from the neighbour
	/// without a predecessor must pass all faces.
	void checkFans()
	{
		std::vector<std::vector<Edge>> steps(mesh_.vertexNum());
		for (std::size_t f = 0; f < mesh_.faceNum(); ++f) {
			const std::int32_t* t = &mesh_.triangles[3 * f];
			for (int k = 0; k < 3; ++k)
				steps[t[k]].push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
		}
		for (const std::vector<Edge>& fan : steps)
			facts_.brokenFans += !fan.empty() && !isOneFan(fan);
	}

	static bool isOneFan(const std::vector<Edge>& fan)
	{
		std::map<int, int> next;
		std::set<int>      reached;
		for (const Edge& step : fan) {
			if (!next.insert(step).second || !reached.insert(step.second).second) return false;
		}
		int at = fan.front().first;
		for (const Edge& step : fan) {
			if (!reached.count(step.first)) at = step.first;
		}
		const int   start  = at;
		std::size_t passed = 0;
		for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
			++passed;
			at = step->second;
			if (at == start) break;
		}
		return passed == fan.size();
	}
};

} // namespace

bool SurfaceFacts::isManifold() const
{
	return indicesOutOfRange == 0 && repeatedCorners == 0 && crowdedEdges == 0 &&
		   againstEachOther == 0 && brokenFans == 0 && duplicateFaces == 0;
}

std::string SurfaceFacts::complaints() const
{
	std::ostringstream out;
	const auto         add = [&](std::int64_t n, const char* what) {
        if (n != 0) out << (out.tellp() > 0 ? ", " : "") << n << ' ' << what;
	};
	add(indicesOutOfRange, "indices out of range");
	add(repeatedCorners, "faces with a vertex twice");
	add(unusedVertices, "unused vertices");
	add(notFinite, "vertices not finite");
	add(crowdedEdges, "edges of more than two faces");
	add(againstEachOther, "edges between faces turned against each other");
	add(brokenFans, "vertices with more than one fan");
	add(duplicateFaces, "duplicate faces");
	add(zeroAreaFaces, "faces without area");
	return out.str();
}

Vec3d middleOf(const TriangleMesh& mesh, std::size_t f)
{
	Vec3d sum;
	for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
		sum += mesh.positions[std::size_t(mesh.triangles[c])] * (1 / 3.0);
	return sum;
}

SurfaceFacts factsOf(const TriangleMesh& mesh)
{
	return Auditor(mesh).run();
}

::testing::AssertionResult isSoundSurface(const TriangleMesh& mesh)
{
	if (mesh.faceNum() == 0) return ::testing::AssertionFailure() << "no faces";
	const std::string complaints = factsOf(mesh).complaints();
	if (complaints.empty()) return ::testing::AssertionSuccess();
	return ::testing::AssertionFailure() << complaints;
}

::testing::AssertionResult hasSameTopology(const TriangleMesh& a, const TriangleMesh& b)
{
	const SurfaceFacts x = factsOf(a), y = factsOf(b);
	if (x.components == y.components && x.boundaryLoops == y.boundaryLoops &&
		x.euler() == y.euler()) {
		return ::testing::AssertionSuccess();
	}
	return ::testing::AssertionFailure()
		   << "components " << x.components << " and " << y.components << ", boundary loops "
		   << x.boundaryLoops << " and " << y.boundaryLoops << ", Euler characteristic "
		   << x.euler() << " and " << y.euler();
}

namespace {

/// Half-edges of faces in use, by their ends.
std::map<Edge, int> halfEdgesByEnds(const HalfEdgeMesh& m, std::string& complaint)
{
	std::map<Edge, int> byEnds;
	for (int h = 0; h < m.halfEdgeNum(); ++h) {
		if (m.origin[h] < 0) continue;
		if (m.origin[h] >= m.vertexNum || m.target(h) < 0) complaint = "a corner out of range";
		if (!byEnds.insert({{m.origin[h], m.target(h)}, h}).second)
			complaint = "a directed edge twice";
	}
	return byEnds;
}

} // namespace

::testing::AssertionResult isSoundTable(const HalfEdgeMesh& m)
{
	std::string               complaint;
	const std::map<Edge, int> byEnds = halfEdgesByEnds(m, complaint);
	if (!complaint.empty()) return ::testing::AssertionFailure() << complaint;
	std::vector<char> used(m.vertexNum, 0), atBorder(m.vertexNum, 0);
	for (const auto& [ends, h] : byEnds) {
		const auto found  = byEnds.find({ends.second, ends.first});
		const int  wanted = found == byEnds.end() ? -1 : found->second;
		if (m.opposite[h] != wanted) {
			return ::testing::AssertionFailure()
				   << "opposite of " << h << " is " << m.opposite[h] << ", not " << wanted;
		}
		used[ends.first] = 1;
		if (wanted < 0) atBorder[ends.first] = 1;
	}
	for (int v = 0; v < m.vertexNum; ++v) {
		const int out = m.outgoing[v];
		if ((out >= 0) != (used[v] != 0)) {
			return ::testing::AssertionFailure() << "vertex " << v << " has outgoing " << out;
		}
		if (out < 0) continue;
		if (m.origin[out] != v) {
			return ::testing::AssertionFailure()
				   << "outgoing of " << v << " leaves " << m.origin[out];
		}
		if (atBorder[v] && m.opposite[out] >= 0) {
			return ::testing::AssertionFailure()
				   << "outgoing of border vertex " << v << " is no border";
		}
	}
	return ::testing::AssertionSuccess();
}

} // namespace gpr::test
