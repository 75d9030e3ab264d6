// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_FAILED_ATTEMPTS_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_FAILED_ATTEMPTS_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <array>
#include <map>
#include <vector>

namespace gpr {

/// Remembers the faces at which nothing could be improved, so that they are not tried again before
/// something near them has changed. Faces are known by their vertices: a flip that is undone may
/// exchange the numbers of two faces.
class FailedAttempts {
public:
	/// Of a mesh that will never have more vertices.
	explicit FailedAttempts(int mostVertices) : changedAt_(mostVertices, 0) {}

	/// v moved, came in, or its faces changed.
	void noteChange(int v) { changedAt_[v] = ++now_; }
	/// Nothing helped at f.
	void noteFailure(const HalfEdgeMesh& mesh, int f) { failedAt_[keyOf(mesh, f)] = now_; }
	/// Whether nothing helped at f, and nothing within three rings of it has changed since. Cost:
	/// some fifty vertices are looked at.
	bool isKnown(const HalfEdgeMesh& mesh, int f) const;

private:
	using Key = std::array<int, 3>; ///< vertices, ascending

	int                now_ = 0;
	std::vector<int>   changedAt_; ///< per vertex
	std::map<Key, int> failedAt_;

	static Key keyOf(const HalfEdgeMesh& mesh, int f);
};

} // namespace gpr

#endif
