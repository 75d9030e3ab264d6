// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_refill.h"

#include "face_sets.h"
#include "patch_input.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <array>
#include <utility>

namespace gpr {

namespace {

/// Most work of all rounds together, as a multiple of the most work of a round.
constexpr double mostWork = 2;
/// Work of a round on surface collected before, as a share of the work of collecting.
constexpr double shareOfRound = 0.3;
/// Marks that have not settled after this many rounds do not settle.
constexpr int maxRounds = 24;
/// Largest reach; then patches grow instead.
constexpr float mostReach = 8;
/// Rings of vertices of the result beyond a patch with cells, and more rings to grow into.
constexpr int ringsBeyond = 3, ringsToGrow = 3;
/// Largest distance of a vertex merged into a border vertex, in edges of the result there.
constexpr float farthestDrawn = 1;

using Role = PatchRole;

/// Roles of the vertices of the result, with `rings` rings near the marks.
std::vector<Role> findRoles(const HalfEdgeMesh& m, const std::vector<char>& marked, int rings)
{
	std::vector<Role> role(std::size_t(m.vertexNum), Role::Far);
	for (int v = 0; v < m.vertexNum; ++v) {
		int faces = 0, inside = 0;
		forEachOutgoing(m, v, [&](int h) {
			++faces;
			inside += marked[h / 3] != 0;
		});
		if (inside == 0) continue;
		role[v] = inside == faces ? Role::Inside : Role::Border;
	}
	for (int ring = 0; ring < rings; ++ring) {
		const std::vector<Role> before = role;
		for (int v = 0; v < m.vertexNum; ++v) {
			if (before[v] == Role::Far) continue;
			forEachNeighbour(m, v, [&](int w) {
				if (role[w] == Role::Far) role[w] = Role::Near;
			});
		}
	}
	return role;
}

/// A triangle of the combined mesh.
using Triangle = std::array<int, 3>;

/// Combines the rest of the result and the triangles of the working surface.
class Refill {
public:
	/// local: holds the surface near the marks.
	Refill(const Surface& surface, const ResultMesh& result, const std::vector<char>& marked,
		   const PatchInput& local, std::vector<Role> role, Workers& workers) :
			surface_(surface),
			result_(result), marked_(marked), local_(local), workers_(workers),
			role_(std::move(role))
	{
	}

	/// False if the triangles do not fit; culprits() are then vertices of the result near the
	/// misfits.
	bool run()
	{
		label_ = local_.labels(result_.mesh, role_);
		cleanLabels(local_.mesh, role_, label_, workers_);
		workers_.poll();
		blameWideCells();
		nameVertices();
		collectTriangles();
		workers_.poll();
		if (culprits_.empty()) link();
		if (culprits_.empty()) blameFans();
		return culprits_.empty();
	}

	/// Blames border cells that are no disks for a topology that differs from the result's.
	void blameCells()
	{
		const HalfEdgeMesh& m = local_.mesh;
		std::vector<int>    euler(role_.size(), 0);
		const auto          label = [&](int v) { return label_[v]; };
		for (int v = 0; v < m.vertexNum; ++v)
			++euler[label(v)];
		for (int h = 0; h < m.halfEdgeNum(); ++h) {
			const int here = label(m.origin[h]);
			if (here != label(m.target(h))) continue;
			if (m.opposite[h] < h) --euler[here];
			if (h % 3 == 0 && here == label(m.apex(h))) ++euler[here];
		}
		for (std::size_t v = 0; v < role_.size(); ++v) {
			if (role_[v] == Role::Border && euler[v] != 1) culprits_.push_back(int(v));
		}
	}

	const std::vector<int>& culprits() const { return culprits_; }

	void take(const std::vector<int>& keptInput, bool hasContacts, RefilledMesh& to)
	{
		to.guarded = std::make_unique<GuardedMesh>(std::move(mesh_), hasContacts, &workers_);
		// In place of the triangles of the first filling or of the result.
		to.guarded->assign(local_.mesh, nameOfLocal_, &workers_);
		fix(keptInput, *to.guarded);
		to.resultVertex = std::move(resultVertex_);
		to.inputVertex  = std::move(inputVertex_);
		to.label        = std::move(labelOf_);
	}

	const HalfEdgeMesh& mesh() const { return mesh_; }

private:
	const Surface&           surface_;
	const ResultMesh&        result_;
	const std::vector<char>& marked_;
	const PatchInput&        local_;
	Workers&                 workers_;
	std::vector<Role>        role_;
	std::vector<int>         label_;        ///< per vertex of the local input
	std::vector<int>         nameOfResult_; ///< per vertex of the result: vertex of the new mesh,
											///< or -1
	std::vector<int> nameOfLocal_;          ///< per vertex of the local input: vertex of the new
											///< mesh, or -1
	std::vector<int>      resultVertex_, inputVertex_, labelOf_;
	std::vector<Triangle> triangle_;
	std::vector<int>      culprits_;
	HalfEdgeMesh          mesh_;

	/// Blames cells that reach too far: a cell may enclose a thin tube that ends in a patch, and
	/// merging the cell would remove the tube.
	void blameWideCells()
	{
		std::vector<float> most(role_.size(), 0);
		for (std::size_t v = 0; v < role_.size(); ++v) {
			if (role_[v] == Role::Border)
				most[v] = farthestDrawn *
						  std::max(result_.idealEdge, longestEdgeAt(result_.mesh, int(v)));
		}
		for (int v = 0; v < local_.mesh.vertexNum; ++v) {
			const int label = label_[v];
			if (roleOf(label) != Role::Border) continue;
			if (length(local_.mesh.position[v] - result_.mesh.position[label]) > most[label])
				culprits_.push_back(label);
		}
	}

	Role roleOf(int resultVertex) const { return role_[resultVertex]; }

	void nameVertices()
	{
		const HalfEdgeMesh& r = result_.mesh;
		reserve(mesh_, r.vertexNum + local_.mesh.vertexNum, 0);
		nameOfResult_.assign(std::size_t(r.vertexNum), -1);
		nameOfLocal_.assign(std::size_t(local_.mesh.vertexNum), -1);
		for (int v = 0; v < r.vertexNum; ++v) {
			if (roleOf(v) == Role::Inside) continue;
			nameOfResult_[v] = addVertex(v, -1, v, r.position[v]);
		}
		for (int v = 0; v < local_.mesh.vertexNum; ++v) {
			const int label = label_[v];
			if (roleOf(label) != Role::Inside) {
				nameOfLocal_[v] = nameOfResult_[label];
				continue;
			}
			if (local_.mesh.outgoing[v] < 0) continue;
			nameOfLocal_[v] = addVertex(-1, local_.inputVertex[v], label, local_.mesh.position[v]);
		}
	}

	int addVertex(int inResult, int inInput, int label, const Vec3f& place)
	{
		const int v       = mesh_.vertexNum++;
		mesh_.position[v] = place;
		mesh_.outgoing[v] = -1;
		resultVertex_.push_back(inResult);
		inputVertex_.push_back(inInput);
		labelOf_.push_back(label);
		return v;
	}

	void collectTriangles()
	{
		const HalfEdgeMesh& r = result_.mesh;
		for (int f = 0; f < r.faceNum; ++f) {
			if (marked_[f]) continue;
			Triangle t;
			for (int k = 0; k < 3; ++k)
				t[k] = nameOfResult_[r.origin[3 * f + k]];
			triangle_.push_back(t);
		}
		for (int f = 0; f < local_.mesh.faceNum; ++f)
			addLocal(&local_.mesh.origin[3 * f]);
	}

	void addLocal(const int* corner)
	{
		Triangle t;
		int      inside = 0, border = 0;
		for (int k = 0; k < 3; ++k) {
			const int v     = corner[k];
			t[k]            = nameOfLocal_[v];
			const Role role = roleOf(label_[v]);
			inside += role == Role::Inside;
			border += role == Role::Border;
		}
		if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
		if (inside + border == 3) {
			if (inside == 0 && isLeft(t)) return;
			// Collapses cannot mend a triangle with three fixed corners.
			if (inside == 0 && isLineOfResult(t)) blameAll(corner);
			triangle_.push_back(t);
			return;
		}
		if (inside == 0) return;
		// The inside meets vertices beyond the border.
		for (int k = 0; k < 3; ++k) {
			const int label = label_[corner[k]];
			if (roleOf(label) != Role::Inside && roleOf(label) != Role::Border)
				culprits_.push_back(label);
		}
	}

	void blameAll(const int* corner)
	{
		for (int k = 0; k < 3; ++k)
			culprits_.push_back(label_[corner[k]]);
	}

	/// Whether three fixed vertices lie on a line.
	bool isLineOfResult(const Triangle& t) const
	{
		const auto at = [&](std::size_t k) { return result_.mesh.position[resultVertex_[t[k]]]; };
		return isLine(at(0), at(1), at(2), cross(at(1) - at(0), at(2) - at(0)));
	}

	/// Whether the result has an unmarked face between these vertices.
	bool isLeft(const Triangle& t) const
	{
		const int h = result_.mesh.findHalfEdge(resultVertex_[t[0]], resultVertex_[t[1]]);
		return h >= 0 && !marked_[h / 3] && result_.mesh.apex(h) == resultVertex_[t[2]];
	}

	bool mayBeBorder(int v) const
	{
		const int w = resultVertex_[v];
		if (w >= 0) return result_.mesh.isBorderVertex(w);
		return surface_.mesh.isBorderVertex(inputVertex_[v]);
	}

	void blame(int v) { culprits_.push_back(labelOf_[v]); }

	/// Whether the sides of an edge are a pair. Blames the ends if the sides cannot be all sides of
	/// an edge of the result: more than two, or a single side inside of the surface.
	bool isPair(const EdgeSide* side, std::size_t num)
	{
		const int  low = side->low, high = side->high;
		const bool isBorder   = num == 1 && mayBeBorder(low) && mayBeBorder(high);
		const bool isOwnImage = mesh_.isOnMirror(low) && mesh_.isOnMirror(high);
		const bool isInside   = num == 2 && !isOwnImage &&
							  mesh_.origin[side[0].halfEdge] != mesh_.origin[side[1].halfEdge];
		if (!isBorder && !isInside) {
			blame(low);
			blame(high);
		}
		return isInside;
	}

	void link()
	{
		mesh_.faceNum       = int(triangle_.size());
		mesh_.mirrorAxis    = result_.mesh.mirrorAxis;
		mesh_.meetsAtPlaces = result_.mesh.meetsAtPlaces;
		reserve(mesh_, mesh_.vertexNum, mesh_.faceNum);
		for (int h = 0; h < mesh_.halfEdgeNum(); ++h)
			mesh_.origin[h] = triangle_[h / 3][h % 3];
		linkFaces(mesh_, workers_,
				  [&](const EdgeSide* side, std::size_t num) { return isPair(side, num); });
	}

	/// Blames vertices without a single fan of faces.
	void blameFans()
	{
		std::vector<int> faces(std::size_t(mesh_.vertexNum), 0);
		for (int h = 0; h < mesh_.halfEdgeNum(); ++h)
			++faces[mesh_.origin[h]];
		for (int v = 0; v < mesh_.vertexNum; ++v) {
			if (faces[v] != mesh_.valence(v) || faces[v] == 0) blame(v);
		}
	}

	void fix(const std::vector<int>& keptInput, GuardedMesh& g) const
	{
		for (std::size_t v = 0; v < resultVertex_.size(); ++v) {
			if (resultVertex_[v] >= 0) g.vertex[v].isFixed = true;
		}
		for (int v = 0; v < local_.ownNum; ++v) {
			const int name = nameOfLocal_[v];
			if (name >= 0 &&
				std::binary_search(keptInput.begin(), keptInput.end(), local_.inputVertex[v]))
				g.vertex[name].isFixed = true;
		}
	}
};

/// Whether vertices would go at a place shared with other borders.
bool isAnyShared(const ResultMesh& result, const std::vector<Role>& role)
{
	for (std::size_t v = 0; v < role.size(); ++v) {
		if (role[v] == Role::Inside && result.vertex[v].isShared) return true;
	}
	return false;
}

/// The surface near a patch that grows, collected anew only when the patch leaves it.
class GrowingInput {
public:
	GrowingInput(const Surface& surface, const ResultMesh& result, Workers& workers) :
			surface_(surface), result_(result), workers_(workers)
	{
	}

	const PatchInput& around(const std::vector<char>& marked, const std::vector<Role>& role,
							 float reach)
	{
		const bool isNew = reach != reach_ || !covers(role);
		if (isNew) {
			reach_ = reach;
			role_  = findRoles(result_.mesh, marked, ringsBeyond + ringsToGrow);
			input_ = collectPatchInput(surface_, result_, role_, reach, workers_);
		}
		const double part = isNew ? 1 : shareOfRound;
		share_ += part * input_.share;
		looks_ += part * input_.mesh.vertexNum;
		return input_;
	}

	bool   isTooMuch() const { return input_.share > 1 || share_ > mostWork; }
	double looks() const { return looks_; } ///< at vertices of the working surface

private:
	const Surface&    surface_;
	const ResultMesh& result_;
	Workers&          workers_;
	PatchInput        input_;
	std::vector<Role> role_; ///< with which the surface was collected
	float             reach_ = 0;
	double            share_ = 0, looks_ = 0;

	bool covers(const std::vector<Role>& role) const
	{
		for (std::size_t v = 0; v < role.size(); ++v) {
			if (role[v] != Role::Far && role_[v] == Role::Far) return false;
		}
		return true;
	}
};

/// Marks the faces round some vertices and `rings` more rings of faces; further rings until another
/// face is marked. False if there is no other face.
bool markRound(const HalfEdgeMesh& m, const std::vector<int>& vertices, int rings,
			   std::vector<char>& marked)
{
	std::vector<int> here = widened(m, facesRound(m, vertices), rings);
	for (std::size_t before = 0; here.size() > before;) {
		bool isNew = false;
		for (int f : here) {
			isNew     = isNew || !marked[f];
			marked[f] = 1;
		}
		if (isNew) return true;
		before = here.size();
		here   = widened(m, here, 1);
	}
	return false;
}

/// The vertices with an unmarked face.
std::vector<int> notInside(const HalfEdgeMesh& m, std::vector<int> vertices,
						   const std::vector<char>& marked)
{
	const auto isInside = [&](int v) { return hasOnlyMarked(m, v, marked); };
	vertices.erase(std::remove_if(vertices.begin(), vertices.end(), isInside), vertices.end());
	return vertices;
}

} // namespace

bool refillPatches(const Surface& surface, const ResultMesh& result,
				   const std::vector<int>& keptInput, std::vector<char>& marked, Workers& workers,
				   RefilledMesh& refilled, const HasRoom& hasRoom)
{
	float        reach = 1;
	GrowingInput input(surface, result, workers);
	for (int round = 0; round < maxRounds; ++round) {
		workers.poll();
		if (hasRoom && !hasRoom(marked)) return false;
		std::vector<Role> role = findRoles(result.mesh, marked, ringsBeyond);
		if (isAnyShared(result, role)) return false;
		const PatchInput& local = input.around(marked, role, reach);
		refilled.work           = input.looks();
		if (input.isTooMuch()) return false;
		Refill     refill(surface, result, marked, local, std::move(role), workers);
		const bool fits = refill.run();
		if (fits && figuresOf(refill.mesh(), 1, workers)
						.hasTopologyOf(figuresOf(result.mesh, 1, workers))) {
			refill.take(keptInput, !findTouchingPairs(refill.mesh(), workers).empty(), refilled);
			return true;
		}
		if (fits) refill.blameCells();
		// Inside of a patch the input may be farther from the result than the search distance.
		const std::vector<int> outer = notInside(result.mesh, refill.culprits(), marked);
		if (outer.size() < refill.culprits().size() && reach < mostReach) {
			reach *= 2;
			if (outer.empty()) continue;
		}
		if (!markRound(result.mesh, outer.empty() ? refill.culprits() : outer, round / 4, marked))
			reach *= 2;
	}
	return false;
}

} // namespace gpr
