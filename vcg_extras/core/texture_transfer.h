// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_TEXTURE_TRANSFER_H
#define VCG_EXTRAS_CORE_TEXTURE_TRANSFER_H

#include "mesh_view.h"
#include "results.h"

#include <cstdint>
#include <vector>

namespace gpr {

/// Texture coordinates of the corners of faces, where the two sides of an edge may differ.
struct CornerTexture {
	std::vector<float>        uv;    ///< six a face: u and v of each corner
	std::vector<std::int32_t> image; ///< one a face: the number of its image; empty: one for all
};

/// The caller's texture, with its seams: edges whose two sides have different coordinates or
/// images.
class TextureSource {
public:
	/// The mesh must outlive this. Vertices at the same place are taken for one, as in a triangle
	/// soup and along seams that are sewn. Cost: O(F log F).
	TextureSource(const MeshView& mesh, CornerTexture texture);

	/// Three a face, 1 where the edge from that corner to the next is a seam: MeshView::line.
	const std::vector<std::uint8_t>& seams() const { return seam_; }
	bool                             hasSeams() const { return seamNum_ > 0; }

	/// The texture at the corners of a result's faces. Every face gets the coordinates of the side
	/// of the seams that its middle lies on, so that no face of the result spans one; a corner
	/// beyond a seam gets those of the nearest point on this side. Needs result.facePoints. Cost:
	/// about five times the faces of the caller's mesh looked at.
	CornerTexture carriedTo(const RemeshResult& result) const;

private:
	friend class CornerCarrier;
	const MeshView            mesh_;
	CornerTexture             texture_;
	std::vector<std::uint8_t> seam_;
	std::vector<std::int32_t> beyond_; ///< three a face: the face across an edge, or -1: none, or
									   ///< a seam lies between
	std::vector<std::int32_t> place_;  ///< per vertex, while faces are linked: see same_place.h
	std::int64_t              seamNum_ = 0;

	std::int32_t placeOf(std::int64_t corner) const
	{
		return place_[std::size_t(mesh_.vertexOf(std::size_t(corner)))];
	}
	void connect();
	void link(std::int64_t a, std::int64_t b);
	bool agree(std::int64_t a, std::int64_t b) const;
};

} // namespace gpr

#endif
