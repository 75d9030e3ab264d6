// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PATCH_FILLING_H
#define VCG_EXTRAS_CORE_RUN_PATCH_FILLING_H

#include "prepared.h"

#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/guard/patch_refill.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// A result with patches made anew.
struct Filled {
	HalfEdgeMesh              mesh;
	std::vector<ResultVertex> vertex;
	std::int64_t              madeNum = 0; ///< vertices inside the patches
};

/// Patches of a result, made anew: the input's triangles take their place (refillPatches), and
/// their edges are collapsed under a guard until the result has as many vertices as before
/// (guard/guarded_decimation.h). Then flips and slides make the triangles in and around the
/// patches more regular. The result must stay where it is.
class PatchFilling {
public:
	/// Rings of faces that patches have around faces that touch others.
	static constexpr int ringsAround = 2;

	PatchFilling(RunContext& run, const Prepared& p, const ResultMesh& result) :
			run_(run), p_(p), result_(result)
	{
	}

	/// False where the input's triangles do not fit in. Marks more faces where that is needed.
	/// Cost: that of refillPatches, and about 30 µs a collapse.
	bool fill(std::vector<char>& marked);

	/// Whether the collapses came down to the result's number of vertices, and each face that they
	/// left has an area.
	bool                isSound() const { return isSound_; }
	const HalfEdgeMesh& mesh() const { return refilled_.guarded->mesh; }

	/// Marks the faces of the result around pairs of faces of mesh().
	void markAround(const std::vector<FacePair>& pairs, std::vector<char>& marked) const;

	/// Hands the mesh out, which then is no longer here.
	Filled take();

private:
	RunContext&       run_;
	const Prepared&   p_;
	const ResultMesh& result_;
	RefilledMesh      refilled_;
	bool              isSound_ = false;

	int          oldVertex(int v) const;
	void         freeAround();
	bool         mayFree(int v) const;
	ResultVertex recordOf(int v) const;
};

} // namespace gpr

#endif
