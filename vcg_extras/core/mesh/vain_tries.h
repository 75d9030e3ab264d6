// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_MESH_VAIN_TRIES_H
#define VCG_EXTRAS_CORE_MESH_VAIN_TRIES_H

#include "half_edge_mesh.h"

#include <array>
#include <map>
#include <vector>

namespace gpr {

/// Remembers at which faces a treatment failed, so that it is not tried again before something near
/// them has changed. Of several kinds of treatment each is remembered by itself. Faces are known by
/// their vertices: flips to and fro exchange their numbers.
class VainTries {
public:
	/// Of a mesh that will never have more vertices.
	explicit VainTries(int mostVertices) : changedAt_(mostVertices, 0) {}

	/// v moved, came in, or its faces changed.
	void noteChange(int v) { changedAt_[v] = ++now_; }
	/// f was treated in vain.
	void noteVain(const HalfEdgeMesh& mesh, int f, int kind = 0)
	{
		vainAt_[keyOf(mesh, f, kind)] = now_;
	}
	/// Whether f was treated in vain, and within three rings round it nothing changed since. Cost:
	/// some fifty vertices are looked at.
	bool isVain(const HalfEdgeMesh& mesh, int f, int kind = 0) const;

private:
	using Key = std::array<int, 4>; ///< vertices, ascending, and the kind

	int                now_ = 0;
	std::vector<int>   changedAt_; ///< per vertex
	std::map<Key, int> vainAt_;

	static Key keyOf(const HalfEdgeMesh& mesh, int f, int kind);
};

} // namespace gpr

#endif
