// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_PATCH_CHANGER_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_PATCH_CHANGER_H

#include "patch_mover.h"

#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// Splits and collapses in single patches, after which what lies round them settles by flips and
/// moves; all of it can be taken back. What is worth trying, and keeping, is for others to say.
class PatchChanger : protected PatchMover {
protected:
	/// Room for so many more vertices is made.
	PatchChanger(const Surface& surface, const BoundaryCurves& curves, float angle,
				 ResultMesh& result, Workers& workers, const CellsOfFaces& cells, int mostNew);

	/// A change of the number of vertices.
	struct Operation {
		/// Attach: split, and the apex collapsed into the new vertex.
		enum Kind { None, Split, Attach, Collapse, CollapseBack } kind = None;
		int halfEdge = -1; ///< collapsed from its origin to its target, or back

		bool isCollapse() const { return kind == Collapse || kind == CollapseBack; }
		bool isSplit() const { return kind == Split || kind == Attach; }
	};

	/// A patch as it was before a trial.
	struct Snapshot {
		PatchBackup        backup;
		std::vector<Place> places;
		int                vertexNum; ///< of the mesh
	};

	/// All that can be tried at the edges of f.
	std::vector<Operation> operationsAt(int f) const;
	/// The vertices whose faces an operation, and what follows it, may change.
	std::vector<int> patchOf(const Operation& op) const;
	/// Those of all operations at f.
	std::vector<int> patchRound(int f) const;

	Snapshot remember(const std::vector<int>& patch) const;
	void     takeBack(const Snapshot& before);
	/// The patch' vertices that are left, and those that came in.
	std::vector<int> patchNow(const Snapshot& before) const;
	std::vector<int> livingOf(const std::vector<int>& vertices) const;

	/// Makes a change and lets what lies round it settle. Where that cannot be, returns false; the
	/// mesh is to be taken back then.
	bool make(const Operation& op);
	/// Makes some in a row, which all are known to be possible, counts them, and hands on the cells
	/// of the faces that are gone by them. Returns the patch' vertices that are left then, and
	/// those that came in.
	std::vector<int> makeForGood(const std::vector<Operation>& ops, const std::vector<int>& patch);

private:
	EditScratch scratch_;

	std::vector<int>   livingSince(int vertexNum, const std::vector<int>& vertices) const;
	std::vector<Place> placesOf(const std::vector<int>& vertices) const;
	void               addStar(int v, std::vector<int>& patch) const;
	/// The corners of h's face, and those beyond its other edges.
	void               addQuadHalf(int h, std::vector<int>& patch) const;
	std::vector<Vec3f> centresOf(const std::vector<int>& faces) const;
	int                nearestOf(const std::vector<int>& faces, const Vec3f& p) const;

	bool apply(const Operation& op);
	bool split(int h);
	/// The apex into the middle of h: what lies between the two is too narrow for a triangle.
	bool attach(int h);
	/// How a vertex lies above its anchor.
	Vec3f heightOf(int v) const;
	bool  mayGo(int v) const;
	bool  collapseBorder(int h, bool forward);
	bool  collapseInside(int h);
	void  settle(const std::vector<int>& patch);
	void  flipIfBetter(int h, const std::vector<int>& patch);
};

} // namespace gpr

#endif
