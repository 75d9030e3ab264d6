// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stray_faces.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/buffer.h>

#include <algorithm>

namespace gpr {

namespace {

/// How much longer the diagonal of the whole mesh is, at least, than that of the others.
constexpr double minSizeRatio = 2;
/// Diagonal of a face's box below which it is not huge, in working units, in which the whole is
/// about one: a face from the others' box to beyond twice its size is longer.
constexpr float minLength = 0.2f;
/// Of all faces.
constexpr double maxStray = 0.01;

/// Box and area of some faces.
struct Extent {
	Box<float> box;
	double     area = 0;

	void add(const IndexedMesh& m, int f)
	{
		for (int c = 3 * f; c < 3 * f + 3; ++c)
			box.add(m.position[m.triangle[c]]);
		area += 0.5 * double(length(m.faceCross(f)));
	}
	// Named so that Workers::sum can join the extents of pieces.
	Extent& operator+=(const Extent& o)
	{
		box += o.box;
		area += o.area;
		return *this;
	}
};

/// Of the faces that are not among those left out, which ascend.
Extent extentWithout(const IndexedMesh& mesh, const std::vector<int>& leftOut, Workers& workers)
{
	return workers.sum<Extent>(mesh.faceNum, [&](std::size_t begin, std::size_t end) {
		Extent extent;
		auto   next = std::lower_bound(leftOut.begin(), leftOut.end(), int(begin));
		for (int f = int(begin); f < int(end); ++f) {
			if (next != leftOut.end() && *next == f)
				++next;
			else
				extent.add(mesh, f);
		}
		return extent;
	});
}

std::vector<int> longerThan(const IndexedMesh& mesh, const std::vector<int>& faces, float least)
{
	std::vector<int> longer;
	for (int f : faces) {
		Extent extent;
		extent.add(mesh, f);
		if (extent.box.diagonal() >= least) longer.push_back(f);
	}
	return longer;
}

} // namespace

StrayFaces findStrayFaces(const IndexedMesh& mesh, const std::vector<int>& longFaces,
						  Workers& workers)
{
	// Working coordinates are of magnitude one, which tells most meshes without stray faces at
	// once.
	StrayFaces       none;
	std::vector<int> faces = longerThan(mesh, longFaces, minLength);
	if (faces.empty() || double(faces.size()) > maxStray * mesh.faceNum) return none;
	const Extent others = extentWithout(mesh, faces, workers);
	Extent       stray, whole = others;
	for (int f : faces)
		stray.add(mesh, f);
	whole += stray;
	if (!(others.box.diagonal() > 0) || whole.box.diagonal() < minSizeRatio * others.box.diagonal())
		return none;
	return {std::int64_t(faces.size()), double(whole.box.diagonal() / others.box.diagonal()),
			stray.area / whole.area};
}

} // namespace gpr
