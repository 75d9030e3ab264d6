// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_GUARD_PATCH_FILLING_H
#define VCG_EXTRAS_CORE_GUARD_PATCH_FILLING_H

#include "patch_refill.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// The surface, and the rules for vertices made from the surface by guarded collapses.
struct MakingOfVertices {
	const Surface&          surface;
	const BoundaryCurves&   curves;
	const std::vector<int>& kept; ///< vertices of the surface that stay; ascending
	bool                    mayLeaveSurface = true;  ///< made vertices may lie off the surface
	double                  adapt           = 0;     ///< weight of the error on sizes
	bool                    mayEndAbove     = false; ///< more vertices than before may be left
	int                     finer           = 1; ///< vertices inside of a patch, over those before
};

/// A result with patches made anew.
struct Filled {
	HalfEdgeMesh              mesh;
	std::vector<ResultVertex> vertex;
	std::vector<int>          oldVertex; ///< per vertex: vertex of the result, or -1 inside the
										 ///< patches
};

/// The settings for collapses to the result's number of vertices.
GuardedSettings settingsFor(const MakingOfVertices& making, const ResultMesh& result,
							double lengthWeight);

/// Takes the mesh out of `made`, with a record for each vertex: new for vertices in the patches,
/// and for vertices that have moved. Cost: a search for each new record.
Filled takeFilled(const Surface& surface, const ResultMesh& result, RefilledMesh& made);

/// Makes patches of a result anew. The triangles of the working surface replace a patch
/// (refillPatches), and guarded collapses reduce them to the result's number of vertices
/// (guarded_decimation.h). Then flips and slides make the triangles in and round the patches more
/// regular. The result must stay in memory.
class PatchFilling {
public:
	/// Rings of faces of a patch round faces with contacts.
	static constexpr int ringsAround = 2;

	PatchFilling(const MakingOfVertices& making, const ResultMesh& result, Workers& workers) :
			making_(making), result_(result), workers_(workers)
	{
	}

	/// False if the triangles of the working surface do not fit in (see refillPatches). Marks more
	/// faces if needed. Cost: as refillPatches, and about 30 µs per collapse.
	bool fill(std::vector<char>& marked, const HasRoom& hasRoom = {});

	/// Whether the collapses reached the result's number of vertices and left no degenerate face.
	bool                isSound() const { return isSound_; }
	const HalfEdgeMesh& mesh() const { return refilled_.guarded->mesh; }
	/// Number of looks at vertices of the working surface.
	double work() const { return refilled_.work; }
	/// Per face of mesh(): whether the face differs from the result's faces, or may have moved.
	std::vector<char> changed() const;

	/// Marks the faces of the result around pairs of faces of mesh().
	void markAround(const std::vector<FacePair>& pairs, std::vector<char>& marked) const;

	/// Returns the mesh; mesh() is empty afterwards.
	Filled take() { return takeFilled(making_.surface, result_, refilled_); }

private:
	const MakingOfVertices& making_;
	const ResultMesh&       result_;
	Workers&                workers_;
	RefilledMesh            refilled_;
	bool                    isSound_ = false;

	void freeAround();
	bool mayFree(int v) const;
};

} // namespace gpr

#endif
