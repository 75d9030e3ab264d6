// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_TEXTURE_TRANSFER_H
#define VCG_EXTRAS_CORE_TEXTURE_TRANSFER_H

#include "mesh_view.h"
#include "results.h"

#include <cstdint>
#include <vector>

namespace gpr {

/// Texture coordinates of the corners of faces; the two sides of an edge may differ.
struct CornerTexture {
	std::vector<float>        uv;    ///< six a face: u and v of each corner
	std::vector<std::int32_t> image; ///< one a face: the number of its image; empty: a single image
};

/// The texture of the input with its seams: edges with different coordinates or images on both
/// sides.
class TextureSource {
public:
	/// Needs the mesh during its own lifetime. Vertices at the same place count as a single vertex,
	/// as in a triangle soup and along sewn seams. Cost: O(F log F).
	TextureSource(const MeshView& mesh, CornerTexture texture);

	/// Three a face, 1 if the edge from this corner to the next is a seam: MeshView::line.
	const std::vector<std::uint8_t>& seams() const { return seam_; }
	bool                             hasSeams() const { return seamNum_ > 0; }

	/// Computes the texture at the corners of a result's faces. A face gets the coordinates of that
	/// side of the seams on which its middle lies, so that no face spans a seam; a corner beyond a
	/// seam gets the coordinates of the nearest point on this side. Needs result.facePoints. Cost:
	/// visits about five times the faces of the input.
	CornerTexture carriedTo(const RemeshResult& result) const;

private:
	friend class CornerCarrier;
	const MeshView            mesh_;
	CornerTexture             texture_;
	std::vector<std::uint8_t> seam_;
	std::vector<std::int32_t> beyond_; ///< three a face: the face across; -1: seam or border
	std::int64_t              seamNum_ = 0;

	void connect();
	void link(int a, int b, bool runAlike);
	bool agree(int a, int b, bool runAlike) const;
};

} // namespace gpr

#endif
