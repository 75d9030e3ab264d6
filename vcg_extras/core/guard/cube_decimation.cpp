// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cube_decimation.h"

#include "face_sets.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/mesh/space_grid.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// Vertices of a cube: a mesh of this size stays in the cache of a processor.
constexpr double vertexNumOfCube = 4000;
/// Along the longest edge of the box. With fewer cubes most vertices are near a side of their cube.
constexpr int fewestCubes = 3, mostCubes = 64;
/// Least share of the vertices that stays, and vertices left for each vertex of the target.
constexpr double leastThatStays = 1 / 16.0, leftForEach = 4;
/// Otherwise the cubes take longer than they save: largest share that stays, and largest mean
/// number of cubes that a face meets.
constexpr double mostThatStays = 0.5, mostCubesOfFace = 3;
/// Cubes that remove a smaller share of the vertices are the last.
constexpr double leastGain = 0.3;

/// The faces in and across a cube.
struct CubePart {
	GuardedMesh      guarded;
	std::vector<int> face, vertex; ///< of the whole, ascending
	int              freeNum = 0;  ///< vertices that may go
};

/// A round of collapses in all cubes.
class CubeRound {
public:
	/// share: of the vertices that may go, those that stay.
	CubeRound(const GuardedSettings& settings, double share, const SpaceGrid& grid,
			  GuardedMesh& whole, Workers& workers) :
			settings_(settings),
			share_(share), grid_(grid), g_(whole), m_(whole.mesh), workers_(workers),
			cube_(std::size_t(m_.vertexNum)), isFree_(std::size_t(m_.vertexNum))
	{
	}

	void run()
	{
		workers_.forEach(cube_.size(), [&](int v) { cube_[v] = grid_.cubeOf(m_.position[v]); });
		workers_.forEach(cube_.size(), [&](int v) { isFree_[v] = mayGo(v); });
		sortFaces();
		std::vector<CubePart> part(std::size_t(grid_.cubeNum()));
		// All parts are cut before the first part changes, since parts have faces in common.
		forEachCube([&](int cube, Workers&) { cut(cube, part[cube]); });
		forEachCube([&](int cube, Workers& inner) { decimate(cube, part[cube], inner); });
		forEachCube([&](int cube, Workers&) { putBack(cube, part[cube]); });
		g_.compact(workers_);
	}

private:
	/// A face in or across a cube.
	struct Place {
		int cube, face;
	};

	const GuardedSettings& settings_;
	double                 share_;
	const SpaceGrid&       grid_;
	GuardedMesh&           g_;
	HalfEdgeMesh&          m_;
	Workers&               workers_;
	std::vector<int>       cube_; ///< per vertex
	std::vector<char>      isFree_;
	std::vector<Place>     place_;  ///< by faces
	Buffer<int>            start_;  ///< per cube: in byCube_
	Buffer<int>            byCube_; ///< places

	bool mayGo(int v) const
	{
		return !g_.isFixed(v) && !anyNeighbour(m_, v, [&](int w) { return cube_[w] != cube_[v]; });
	}

	void sortFaces()
	{
		place_ = workers_.collectEach<Place>(std::size_t(m_.faceNum), [&](int f, auto& out) {
			grid_.forEachCube(boxOfFace(m_, f), [&](int cube) {
				out.push_back({cube, f});
				return true;
			});
		});
		sortIntoBuckets(
			place_.size(), std::size_t(grid_.cubeNum()), [&](int i) { return place_[i].cube; },
			workers_, start_, byCube_);
	}

	template <class Body>
	void forEachCube(const Body& body)
	{
		workers_.forTasks(std::size_t(grid_.cubeNum()), [&](std::size_t cube, int worker) {
			Workers inner(workers_, worker);
			inner.poll();
			body(int(cube), inner);
		});
	}

	/// A part takes the data of its free vertices, which no other part has.
	void cut(int cube, CubePart& part)
	{
		for (int i = start_[cube]; i < start_[cube + 1]; ++i)
			part.face.push_back(place_[byCube_[i]].face);
		part.vertex = verticesOf(m_, part.face);
		for (int v : part.vertex)
			part.freeNum += isFree_[v];
		if (part.freeNum == 0) return;
		part.guarded.mesh        = cutMesh(cube, part);
		part.guarded.hadContacts = g_.hadContacts;
		for (int v : part.vertex) {
			GuardedVertex& from = g_.vertex[v];
			part.guarded.vertex.push_back(isFree_[v] ? std::move(from) : from.withoutPoints());
			part.guarded.vertex.back().isFixed = !isFree_[v];
		}
	}

	/// Vertices in the cube have all their faces in the part. Other vertices are only corners.
	HalfEdgeMesh cutMesh(int cube, const CubePart& part) const
	{
		HalfEdgeMesh to = cutOut(m_, part.face, part.vertex);
		for (int v = 0; v < to.vertexNum; ++v) {
			if (cube_[part.vertex[v]] != cube) to.outgoing[v] = -1;
		}
		return to;
	}

	void decimate(int cube, CubePart& part, Workers& inner) const
	{
		if (part.freeNum == 0) return;
		GuardedSettings settings = settings_;
		settings.targetNum =
			part.guarded.mesh.vertexNum - std::int64_t((1 - share_) * part.freeNum);
		settings.keepsBorder = false; // its other vertices go at last
		settings.grid        = &grid_;
		settings.cube        = cube;
		collapseStrictly(settings, part.guarded, inner);
	}

	/// Each half-edge and vertex that may have changed belongs to one cube.
	void putBack(int cube, CubePart& part)
	{
		if (part.freeNum == 0) return;
		const HalfEdgeMesh& from = part.guarded.mesh;
		const auto inWhole       = [&](int h) { return h < 0 ? -1 : 3 * part.face[h / 3] + h % 3; };
		const auto isIn          = [&](int v) { return cube_[v] == cube; };
		for (int f = 0; f < from.faceNum; ++f) {
			const int  first = 3 * part.face[f];
			const bool in[3] = {isIn(m_.origin[first]), isIn(m_.origin[first + 1]),
								isIn(m_.origin[first + 2])};
			for (int k = 0; k < 3; ++k) {
				if (in[k] && in[(k + 1) % 3])
					m_.opposite[first + k] = inWhole(from.opposite[3 * f + k]);
			}
			for (int k = 0; k < 3 && in[0] && in[1] && in[2]; ++k) {
				const int v          = from.origin[3 * f + k];
				m_.origin[first + k] = v < 0 ? -1 : part.vertex[v];
			}
		}
		for (int v = 0; v < from.vertexNum; ++v) {
			const int own = part.vertex[v];
			if (!isIn(own)) continue;
			m_.outgoing[own] = inWhole(from.outgoing[v]);
			m_.position[own] = from.position[v];
			putBack(part.guarded.vertex[v], g_.vertex[own], isFree_[own]);
		}
	}

	static void putBack(GuardedVertex& from, GuardedVertex& to, bool wasFree)
	{
		from.isFixed = to.isFixed;
		if (!wasFree) from.points.insert(from.points.end(), to.points.begin(), to.points.end());
		to = std::move(from);
	}
};

/// A surface meets about as many cubes as lie on the largest side of the box.
SpaceGrid gridFor(const HalfEdgeMesh& m, Workers& workers)
{
	const Box<float> box = boxOfAll(m, workers);
	int              num = 1;
	while (num < mostCubes &&
		   SpaceGrid(box, num).cubeNumOfSide() * vertexNumOfCube < double(m.vertexNum))
		++num;
	return {box, num};
}

bool areFacesSmall(const HalfEdgeMesh& m, const SpaceGrid& grid, Workers& workers)
{
	const auto num = workers.sumEach<std::int64_t>(
		m.faceNum, [&](int f, std::int64_t& part) { part += grid.cubeNumOf(boxOfFace(m, f)); });
	return double(num) <= mostCubesOfFace * double(m.faceNum);
}

/// Needs a mesh without dead faces, and leaves none.
void decimateInCubes(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers)
{
	for (double gain = 1; gain > leastGain;) {
		const HalfEdgeMesh& m   = guarded.mesh;
		const double        num = m.vertexNum;
		const double        share =
			std::max(leastThatStays, leftForEach * double(settings.targetNum) / num);
		if (share > mostThatStays) return;
		const SpaceGrid grid = gridFor(m, workers);
		if (grid.cubeNumOfEdge() < fewestCubes || !areFacesSmall(m, grid, workers)) return;
		CubeRound(settings, share, grid, guarded, workers).run();
		gain = 1 - m.vertexNum / num;
	}
}

} // namespace

bool decimateGuarded(const GuardedSettings& settings, GuardedMesh& guarded, Workers& workers)
{
	decimateInCubes(settings, guarded, workers);
	const bool isReached = collapseGuarded(settings, guarded, workers);
	guarded.compact(workers);
	return isReached;
}

} // namespace gpr
