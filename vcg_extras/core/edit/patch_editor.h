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

/// A change of the result for a search to try.
struct Operation {
	enum Kind {
		None,
		Move,         ///< origin[halfEdge] moves to the place with the least cost of its faces
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

/// The operations of the given kinds at the edges and corners of a face; moves also at the corners
/// beyond its edges.
std::vector<Operation> operationsAt(const HalfEdgeMesh& mesh, int face,
									const std::vector<Operation::Kind>& kinds);

/// Changes single patches of the result, and can undo the change. Vertices move on the surface, or
/// along their curve, and keep their height above the surface. Corners of curves, cone apexes and
/// pinned vertices never move.
class PatchEditor {
public:
	/// Reserves memory for spareVertexNum vertices.
	PatchEditor(const Surface& surface, const BoundaryCurves& curves, ResultMesh& result,
				Workers& workers, int spareVertexNum);

	/// A vertex with all its data that changes in a move.
	struct VertexState {
		Vec3f        position;
		Vec3f        normal; ///< of the surface there
		ResultVertex record;
	};

	/// A patch before a change.
	struct Snapshot {
		PatchBackup              backup;
		std::vector<VertexState> states; ///< of the backup's vertices
		int                      vertexNum = 0;
	};

	const Surface&      surface() const { return surface_; }
	const ResultMesh&   result() const { return r_; }
	const HalfEdgeMesh& mesh() const { return m_; }
	/// Normal agreement of face f at its corners, and at its feature lines: 1 if f has none.
	float agreement(int f) const;
	float agreementAtCreases(int f) const;

	VertexState stateOf(int v) const { return {m_.position[v], normal_[v], r_.vertex[v]}; }
	void        put(int v, const VertexState& state);
	float       meanEdge(int v) const;
	/// mayCrowd: corners of the border may slide, too.
	bool mayMove(int v, bool mayCrowd = false) const;
	/// The states of v after a step of length `reach`: along its curve, or in eight directions over
	/// the surface. mayCrowd: along the curve, the only limit is the room to the neighbours.
	std::vector<VertexState> statesAround(int v, float reach, bool mayCrowd = false) const;
	/// Whether v at a state is within `share` mean edges of its first place, and the surface normal
	/// at the state has at least the cosine minCosine with the first normal.
	bool isNearStart(int v, const VertexState& state, float share, float minCosine) const;

	/// Whether the flip of h leaves every vertex enough faces for good angles and moves the surface
	/// only a little.
	bool isGentleFlip(int h) const;
	bool mayFlip(int h) const { return m_.opposite[h] >= 0 && canFlip(m_, h); }
	/// The ends of the inner edge h and the apexes of its two faces.
	std::array<int, 4> cornersAt(int h) const;

	/// The vertices whose faces an operation and the settling round it may change.
	std::vector<int> patchOf(const Operation& op) const;
	/// Makes a flip, split or collapse. False if the topology or a curve forbids the operation; the
	/// patch may be half changed then and must be undone.
	bool make(const Operation& op);
	/// A flip is undone by the flip of nextInFace(h).
	void flip(int h) { gpr::flip(m_, h); }

	Snapshot remember(const std::vector<int>& patch) const;
	/// The state before a bare flip of h: far fewer faces if a corner has many.
	Snapshot rememberFlip(int h) const;
	void     undo(const Snapshot& before);
	/// The vertices left of a patch, and the vertices added since there were vertexNum vertices.
	std::vector<int> patchNow(const std::vector<int>& patch, int vertexNum) const;
	std::vector<int> patchNow(const Snapshot& before) const
	{
		return patchNow(before.backup.vertices(), before.vertexNum);
	}

	/// Counts a kept operation in the figures of the result.
	void countDone(const Operation& op);
	/// Ends feature lines at a degenerate face whose edges may all lie on feature lines.
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
	bool        mayGo(int v) const;
	bool        split(int h);
	bool        attach(int h);
	bool        collapseOnBorder(int h, bool forward);
	bool        collapseInside(int h);
};

} // namespace gpr

#endif
