// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_FAILED_ATTEMPTS_H
#define VCG_EXTRAS_CORE_EDIT_FAILED_ATTEMPTS_H

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
	explicit FailedAttempts(int maxVertices) : changedAt_(maxVertices, 0) {}

	/// These vertices moved, came in, or have other faces now. Cost: three rings of faces round
	/// them.
	void noteChange(const HalfEdgeMesh& mesh, std::vector<int> vertices);
	/// Nothing helped at f.
	void noteFailure(const HalfEdgeMesh& mesh, int f) { failedAt_[keyOf(mesh, f)] = now_; }
	/// Whether nothing helped at f, and nothing within three rings of it has changed since. Asked
	/// far more often than something changes, so it looks at the three corners only.
	bool isKnown(const HalfEdgeMesh& mesh, int f) const;

private:
	using Key = std::array<int, 3>; ///< vertices, ascending

	int                now_ = 0;
	std::vector<int>   changedAt_; ///< per vertex: the last change near it
	std::map<Key, int> failedAt_;

	static Key keyOf(const HalfEdgeMesh& mesh, int f);
};

} // namespace gpr

#endif
