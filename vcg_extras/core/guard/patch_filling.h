// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_FILLING_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_FILLING_H

#include "patch_refill.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <cstdint>
#include <vector>

namespace gpr {

/// The surface, and what is to hold for vertices that are made from it by guarded collapses.
struct MakingOfVertices {
	const Surface&          surface;
	const std::vector<int>& kept; ///< vertices of the surface that stay; ascending
	bool                    mayLeaveSurface = true;  ///< they may lie off the surface
	double                  adapt           = 0;     ///< how much sizes follow the error
	bool                    mayEndAbove     = false; ///< more vertices than before may be left
};

/// A result with patches made anew.
struct Filled {
	HalfEdgeMesh              mesh;
	std::vector<ResultVertex> vertex;
	std::vector<int>          oldVertex; ///< per vertex: the result's, or -1 inside the patches
};

/// Patches of a result, made anew: the input's triangles take their place (refillPatches), and
/// their edges are collapsed under a guard until the result has as many vertices as before
/// (guarded_decimation.h). Then flips and slides make the triangles in and around the
/// patches more regular. The result must stay where it is.
class PatchFilling {
public:
	/// Rings of faces that patches have around faces that touch others.
	static constexpr int ringsAround = 2;

	PatchFilling(const MakingOfVertices& making, const ResultMesh& result, Workers& workers) :
			making_(making), result_(result), workers_(workers)
	{
	}

	/// False where the input's triangles do not fit in (see refillPatches). Marks more faces where
	/// that is needed. Cost: that of refillPatches, and about 30 µs a collapse.
	bool fill(std::vector<char>& marked, const HasRoom& hasRoom = {});

	/// Whether the collapses came down to the result's number of vertices, and each face that they
	/// left has an area.
	bool                isSound() const { return isSound_; }
	const HalfEdgeMesh& mesh() const { return refilled_.guarded->mesh; }
	/// Vertices of the input that were looked at, each as often as that was.
	double work() const { return refilled_.work; }
	/// Whether a face of mesh() is not the result's, or may have been moved.
	bool isChanged(int face) const;

	/// Marks the faces of the result around pairs of faces of mesh().
	void markAround(const std::vector<FacePair>& pairs, std::vector<char>& marked) const;

	/// Hands the mesh out, which then is no longer here.
	Filled take();

private:
	const MakingOfVertices& making_;
	const ResultMesh&       result_;
	Workers&                workers_;
	RefilledMesh            refilled_;
	bool                    isSound_ = false;

	int          oldVertex(int v) const;
	void         freeAround();
	bool         mayFree(int v) const;
	ResultVertex recordOf(int v) const;
};

} // namespace gpr

#endif
