// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_EDIT_FAILED_ATTEMPTS_H
#define VCG_EXTRAS_CORE_EDIT_FAILED_ATTEMPTS_H

#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace gpr {

/// Remembers faces at which no change helped. A search tries such a face again only after a change
/// near the face. A face is identified by its vertices: an undone flip may exchange the numbers of
/// two faces.
class FailedAttempts {
public:
	/// maxVertices: the mesh will never have more vertices.
	explicit FailedAttempts(int maxVertices) : changedAt_(maxVertices, 0) {}

	/// Records that the vertices moved, are new, or have other faces now. Returns the work: the
	/// neighbours of the vertices in three rings round these.
	std::int64_t noteChange(const HalfEdgeMesh& mesh, std::vector<int> vertices);
	/// Records that no change helped at f.
	void noteFailure(const HalfEdgeMesh& mesh, int f) { failedAt_[keyOf(mesh, f)] = now_; }
	/// Whether no change helped at f, and since then nothing within three rings of f has changed.
	/// Looks at the three corners only, as questions are far more frequent than changes.
	bool isKnown(const HalfEdgeMesh& mesh, int f) const;

private:
	using Key = std::array<int, 3>; ///< vertices, ascending

	int                now_ = 0;
	std::vector<int>   changedAt_; ///< per vertex: the last change near the vertex
	std::map<Key, int> failedAt_;

	static Key keyOf(const HalfEdgeMesh& mesh, int f);
};

} // namespace gpr

#endif
