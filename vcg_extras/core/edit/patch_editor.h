// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_PATCH_EDITOR_H
#define VCG_EXTRAS_CORE_EDIT_PATCH_EDITOR_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <array>
#include <vector>

namespace gpr {

/// A change of the result that a search tries.
struct Operation {
	enum Kind {
		None,
		Move,         ///< origin[halfEdge] moves to where its faces cost least
		Flip,         ///< halfEdge is flipped
		Split,        ///< a vertex is put in the middle of halfEdge
		Attach,       ///< a split, and the apex of halfEdge is merged into the new vertex
		Collapse,     ///< origin[halfEdge] is merged into its target
		CollapseBack, ///< the target into the origin
	};
	Kind kind     = None;
	int  halfEdge = -1;

	bool isCollapse() const { return kind == Collapse || kind == CollapseBack; }
	bool isSplit() const { return kind == Split || kind == Attach; }
};

/// The operations of these kinds at the edges and corners of a face and, for moves, at the corners
/// beyond its edges.
std::vector<Operation> operationsAt(const HalfEdgeMesh& mesh, int face,
									const std::vector<Operation::Kind>& kinds);

/// Changes single patches of the result in a way that can be undone. Vertices move on the surface,
/// those of curves along these, and keep their height above it; corners of curves, cone apexes
/// and pinned vertices never move.
class PatchEditor {
public:
	/// Room is made for so many more vertices.
	PatchEditor(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result,
				Workers& workers, int spareVertexNum);

	/// A vertex with all that moves along with it.
	struct VertexState {
		Vec3f        position;
		Vec3f        normal; ///< of the surface there
		ResultVertex record;
	};

	/// A patch as it was.
	struct Snapshot {
		PatchBackup              backup;
		std::vector<VertexState> states; ///< of the backup's vertices
		int                      vertexNum = 0;
	};

	const Surface&        surface() const { return surface_; }
	const BoundaryCurves& curves() const { return curves_; }
	const ResultMesh&     result() const { return r_; }
	const HalfEdgeMesh&   mesh() const { return m_; }
	/// Cosine of the angle between a face's normal and the surface's at its corners, and between it
	/// and the surface's beside its feature lines: 1 where it has none.
	float agreement(int f) const;
	float agreementAtCreases(int f) const;

	VertexState stateOf(int v) const { return {m_.position[v], normal_[v], r_.vertex[v]}; }
	void        put(int v, const VertexState& state);
	float       meanEdge(int v) const;
	/// mayCrowd: corners of the border may slide, too.
	bool mayMove(int v, bool mayCrowd = false) const;
	/// Where v gets by a step of this length: along its curve, or in eight directions over the
	/// surface. mayCrowd: along the curve it may come as near to a neighbour, and leave the curve
	/// as far, as there is room.
	std::vector<VertexState> statesAround(int v, float reach, bool mayCrowd = false) const;
	/// The same height of v above its surface point, raised or lowered by `by`.
	VertexState raised(int v, float by) const;
	/// Whether v at a state is within `share` mean edges of where it was at first, and the
	/// surface's normal there has at least this cosine with the one it had at first.
	bool isNearStart(int v, const VertexState& state, float share, float minCosine) const;

	/// Whether the flip of h leaves every vertex enough faces for good angles and moves the surface
	/// little.
	bool isGentleFlip(int h) const;
	bool mayFlip(int h) const { return m_.opposite[h] >= 0 && canFlip(m_, h); }
	/// The ends of the inner edge h and the apexes of its two faces.
	std::array<int, 4> cornersAt(int h) const;

	/// The vertices whose faces an operation may change, with what settles round it.
	std::vector<int> patchOf(const Operation& op) const;
	/// Makes a flip, split or collapse. False where the topology or a curve forbids it; the patch
	/// may be half changed then and must be undone.
	bool make(const Operation& op);
	void flip(int h);
	void flipBack(int h);

	Snapshot remember(const std::vector<int>& patch) const;
	/// Before the flip of h and nothing else: far fewer faces where one of its corners has many.
	Snapshot rememberFlip(int h) const;
	void     undo(const Snapshot& before);
	/// The vertices of a patch that are left, and those that came in since.
	std::vector<int> patchNow(const Snapshot& before) const;

	/// Counts an operation that stays.
	void countDone(const Operation& op);
	/// Feature lines can hold all edges of a face without area. They end here then.
	void forgetLinesAt(int f);

private:
	const Surface&        surface_;
	const BoundaryCurves& curves_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Buffer<Vec3f>         normal_, startNormal_, startPosition_;
	EditScratch           scratch_;

	Snapshot    snapshotOf(PatchBackup backup) const;
	VertexState movedTo(int v, const ResultVertex& record) const;
	Vec3f       normalAt(int v, const SurfacePoint& at) const;
	Vec3f       heightOf(int v) const { return m_.position[v] - r_.vertex[v].point.position; }
	void        addStar(int v, std::vector<int>& patch) const;
	void        addHalfOfEdge(int h, std::vector<int>& patch) const;
	bool        mayGo(int v) const;
	bool        split(int h);
	bool        attach(int h);
	bool        collapseOnBorder(int h, bool forward);
	bool        collapseInside(int h);
};

} // namespace gpr

#endif
