// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_pictures.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/mesh_io.h>
#include <vcg_extras/io/report/formatted_text.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace gpr::app {

namespace {

constexpr double pixels         = 640; ///< width and height of a picture
constexpr double viewAngleDeg   = 30;
constexpr double closeUpEdges   = 22;
constexpr double minEdgePixels  = 3.5; ///< shorter edges would cover the surface
constexpr double secondsAllowed = 600;

/// Tangent of half the view angle.
double viewSlope()
{
	return std::tan(0.5 * viewAngleDeg * pi / 180);
}

/// The three axes of the camera: to the right, up, and from the focus to the camera.
struct Axes {
	Vec3d right, up, back;

	Axes()
	{
		back  = normalized(Vec3d(0.35, 0.25, 1));
		right = normalized(cross(Vec3d(0, 1, 0), back));
		up    = cross(back, right);
	}
	/// Distance from the view axis through the origin, along the picture's axes.
	double aside(const Vec3d& p) const
	{
		return std::max(std::abs(dot(p, right)), std::abs(dot(p, up)));
	}
};

/// Calls visit(position) for the finite corners of all faces.
template <class Visit>
void forEachCorner(const MeshView& mesh, const Visit& visit)
{
	for (std::size_t i = 0; i < 3 * mesh.faceNum; ++i) {
		const Vec3d p = mesh.position(std::size_t(mesh.vertexOf(i)));
		if (isFinite(p)) visit(p);
	}
}

std::string triple(const Vec3d& p)
{
	return formatted("%.6f,%.6f,%.6f", p.x, p.y, p.z);
}

} // namespace

MeshPhotographer::MeshPhotographer(const MeshView& subject, double edgeLen,
								   const std::string& workFolder) :
		folder_(workFolder)
{
	if (!hasProgram("f3d")) {
		complaint_ = "There are no pictures: the program f3d is not installed.";
		folder_.clear();
		return;
	}
	std::error_code error;
	if (!std::filesystem::create_directory(folder_, error)) {
		complaint_ = "There are no pictures: " + folder_ + " cannot be made.";
		folder_.clear();
		return;
	}
	placeCameras(subject, edgeLen);
}

MeshPhotographer::~MeshPhotographer()
{
	std::error_code error;
	if (!folder_.empty()) std::filesystem::remove_all(folder_, error);
}

void MeshPhotographer::placeCameras(const MeshView& subject, double edgeLen)
{
	const Axes  axes;
	Box<double> box;
	forEachCorner(subject, [&](const Vec3d& p) { box.add(p); });
	const double diagonal = box.diagonal();
	if (!(diagonal > 0)) return;
	centre_ = (box.low + box.high) * 0.5;
	scale_  = 1 / diagonal;

	// The whole: far enough back for every corner. Close up: a near point in the middle.
	double away = 0, best = -HUGE_VAL;
	Vec3d  near;
	forEachCorner(subject, [&](const Vec3d& p) {
		const Vec3d  q     = local(p);
		const double depth = dot(q, axes.back), aside = axes.aside(q);
		away = std::max(away, depth + aside / viewSlope());
		if (depth - aside > best) {
			best = depth - aside;
			near = q;
		}
	});
	away *= 1.03;
	const double close = std::min(away, 0.5 * closeUpEdges * edgeLen * scale_ / viewSlope());
	whole_             = {axes.back * away, Vec3d()};
	closeUp_           = {near + axes.back * close, near};
	width_             = 2 * away * viewSlope();
}

MeshPictures MeshPhotographer::take(const MeshView& mesh)
{
	if (folder_.empty()) return {};
	const std::string path  = folder_ + "/mesh.ply";
	TriangleMesh      moved = triangleMeshOf(mesh);
	for (Vec3d& p : moved.positions)
		p = isFinite(p) ? local(p) : Vec3d();
	MeshAttributes none;
	writeMesh(moved, false, none, path, RunLimit());
	MeshPictures pictures;
	const double edgePixels = measureQuality(mesh).meanEdgeLen * scale_ * pixels / width_;
	pictures.edgesOfWhole   = edgePixels >= minEdgePixels;
	pictures.whole          = picture(path, whole_, pictures.edgesOfWhole);
	pictures.closeUp        = picture(path, closeUp_, true);
	return pictures;
}

std::string MeshPhotographer::picture(const std::string& meshPath, const Camera& camera, bool edges)
{
	const std::string  path = folder_ + "/picture.png";
	std::istringstream options(
		formatted("f3d --dry-run --quiet --resolution %.0f,%.0f --color 0.8,0.88,1 --roughness 0.8 "
				  "--bg-color 1,1,1 --camera-view-up 0,1,0 --camera-view-angle %.0f ",
				  pixels, pixels, viewAngleDeg) +
		"--camera-position " + triple(camera.position) + " --camera-focal-point " +
		triple(camera.focus));
	std::vector<std::string> words;
	if (hasProgram("xvfb-run"))
		words = {"xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -nolisten tcp"};
	for (std::string word; options >> word;)
		words.push_back(word);
	words.insert(words.end(), {"--output", path, meshPath});
	if (edges) words.push_back("--edges");
	std::error_code error;
	std::filesystem::remove(path, error);
	if (runProgram(words, secondsAllowed) != 0 || !std::filesystem::exists(path, error)) {
		if (stopRequested()) throw AppError(ExitCode::Stopped, "cancelled.");
		complaint_ = "Pictures are missing: f3d failed.";
		return "";
	}
	const FileContent png(path);
	return std::string(png.view());
}

} // namespace gpr::app
