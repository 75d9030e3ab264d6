// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_MESH_PICTURES_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_MESH_PICTURES_H

#include <vcg_extras/core/mesh_view.h>

#include <string>

namespace gpr::app {

/// Two pictures of a mesh as PNG files in memory; empty: no picture.
struct MeshPictures {
	std::string whole;
	std::string closeUp;
	bool        edgesOfWhole = true; ///< false for edges so short that the lines would cover the
									 ///< whole
};

/// Takes pictures of meshes, all from the same two places, by Debian's f3d run as a program, under
/// xvfb-run if installed. Writes meshes into a folder of its own and removes the folder at the end.
class MeshPhotographer {
public:
	/// Chooses two places for `subject`: one for a picture of the whole, and one for a picture of
	/// about 22 edges of length edgeLen (mesh units) across. workFolder must not exist yet.
	MeshPhotographer(const MeshView& subject, double edgeLen, const std::string& workFolder);
	~MeshPhotographer();
	MeshPhotographer(const MeshPhotographer&)            = delete;
	MeshPhotographer& operator=(const MeshPhotographer&) = delete;

	MeshPictures take(const MeshView& mesh);
	/// The reason for missing pictures; empty after success.
	const std::string& complaint() const { return complaint_; }

private:
	struct Camera {
		Vec3d position, focus;
	};

	std::string folder_, complaint_;
	Vec3d       centre_;
	double      scale_ = 1; ///< the subject's diagonal becomes 1: f3d works in float
	double      width_ = 1; ///< of the picture of the whole, in diagonals
	Camera      whole_, closeUp_;

	Vec3d       local(const Vec3d& p) const { return (p - centre_) * scale_; }
	void        placeCameras(const MeshView& subject, double edgeLen);
	std::string picture(const std::string& meshPath, const Camera& camera, bool edges);
};

} // namespace gpr::app

#endif
