// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_MOVE_GUARD_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_MOVE_GUARD_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/result_mesh.h>

#include <vector>

namespace gpr {

/// The corners of a face.
struct Corners {
	Vec3f a, b, c;
};

/// Whether a move of its corners turns a face by more than 60° or makes one poorer that is poor
/// (of a worse shape than 30°-30°-120°).
bool spoilsFace(const Corners& before, const Corners& after);

/// Moves many vertices at once and takes back those that fold the mesh.
///
/// Every vertex that shall move gets its new record in next(); move() puts them in place, then
/// takes moves back, a face's three at a time, until no face has turned by more than 60° or got
/// poorer while poor. Cost: a pass over the faces a round, mostly one or two.
class MoveGuard {
public:
	MoveGuard(ResultMesh& result, Workers& workers);

	/// Where to write a vertex' new record; each by one thread only.
	void propose(int v, const ResultVertex& next)
	{
		next_[v]  = next;
		moved_[v] = 1;
	}

	/// Makes the proposed moves and takes bad ones back. Afterwards moved(v) tells which stand.
	void move();
	bool moved(int v) const { return moved_[v] != 0; }

	/// Forgets all proposals: ready for the next step.
	void clear();

private:
	ResultMesh&          r_;
	Workers&             workers_;
	Buffer<ResultVertex> next_; ///< after move(): the records before it
	Buffer<char>         moved_;

	void             exchange();
	void             takeBack(int v);
	Vec3f            placeBefore(int v) const;
	std::vector<int> findBadFaces();
	bool             isBad(int f) const;
};

} // namespace gpr

#endif
