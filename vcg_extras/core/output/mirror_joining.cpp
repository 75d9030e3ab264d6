// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror_joining.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>

namespace gpr {

namespace {

class Joining {
public:
	Joining(const Surface& surface, const MirrorPlane& plane, const TriangleMesh& half,
			const std::vector<std::int32_t>& region, Workers& workers) :
			surface_(surface),
			plane_(plane), half_(half), region_(region), workers_(workers), m_(out_.result.mesh)
	{
	}

	JoinedHalves run()
	{
		addVertices();
		addFaces();
		link();
		if (!region_.empty()) markLines();
		return std::move(out_);
	}

private:
	const Surface&                   surface_;
	const MirrorPlane&               plane_;
	const TriangleMesh&              half_;
	const std::vector<std::int32_t>& region_;
	Workers&                         workers_;
	JoinedHalves                     out_;
	HalfEdgeMesh&                    m_;
	std::vector<int>                 imageOf_; ///< per vertex of the half

	int halfFaceNum() const { return int(half_.faceNum()); }

	void addVertices()
	{
		std::vector<Vec3d> images;
		for (const Vec3d& p : half_.positions) {
			const Vec3d q = plane_.rounded(p);
			out_.positions.push_back(plane_.toCaller(q));
			const bool isOn = coordinate(q, plane_.heightAxis()) == 0;
			const int  next = int(half_.vertexNum() + images.size());
			imageOf_.push_back(isOn ? int(out_.positions.size()) - 1 : next);
			out_.onPlaneNum += isOn;
			if (!isOn) images.push_back(plane_.toCaller(plane_.mirrored(q)));
		}
		out_.positions.insert(out_.positions.end(), images.begin(), images.end());
	}

	void addFaces()
	{
		m_.vertexNum = int(out_.positions.size());
		m_.faceNum   = 2 * halfFaceNum();
		reserve(m_, m_.vertexNum, m_.faceNum);
		for (int v = 0; v < m_.vertexNum; ++v) {
			m_.position[v] = surface_.frame.toWorking(out_.positions[v]);
			m_.outgoing[v] = -1;
		}
		for (int f = 0; f < halfFaceNum(); ++f) {
			for (int k = 0; k < 3; ++k) {
				const int v                                      = half_.triangles[3 * f + k];
				m_.origin[3 * f + k]                             = v;
				m_.origin[3 * (f + halfFaceNum()) + (3 - k) % 3] = imageOf_[v];
			}
		}
	}

	void link()
	{
		linkFaces(m_, workers_, [&](const EdgeSide* side, std::size_t num) {
			if (num == 1) return false;
			if (num == 2 && m_.origin[side[0].halfEdge] != m_.origin[side[1].halfEdge]) return true;
			throw Failure(
				Status::PromiseBroken,
				"The halves could not be joined: an edge would have more than two faces.");
		});
	}

	void markLines()
	{
		m_.crease              = Buffer<char>(std::size_t(m_.halfEdgeNum()), 0);
		const auto labelOfFace = [&](int f) { return region_[f % halfFaceNum()]; };
		for (int h = 0; h < m_.halfEdgeNum(); ++h) {
			if (m_.opposite[h] < 0) continue;
			const int  f = h / 3, g = m_.opposite[h] / 3;
			const bool isAtPlane = (f < halfFaceNum()) != (g < halfFaceNum());
			m_.crease[h]         = isAtPlane || labelOfFace(f) != labelOfFace(g);
		}
	}
};

} // namespace

JoinedHalves joinHalves(const Surface& surface, const MirrorPlane& plane, const TriangleMesh& half,
						const std::vector<std::int32_t>& region, Workers& workers)
{
	return Joining(surface, plane, half, region, workers).run();
}

void placeOnSurface(const Surface& surface, const MirrorHalf& half, const MirrorPlane& plane,
					const RemeshResult& made, Workers& workers, JoinedHalves& joined)
{
	const NearestOnMesh        nearest(surface.mesh, workers);
	std::vector<ResultVertex>& vertex = joined.result.vertex;
	vertex.resize(joined.positions.size());
	const std::size_t halfNum   = made.surfacePoints.size();
	const auto        workingOf = [&](const BarycentricPoint& at) {
        Vec3d place;
        for (int k = 0; k < 3; ++k) {
            const auto v = half.triangles[3 * std::size_t(at.face) + std::size_t(k)];
            place += half.positions[v] * double(at.weight[k]);
        }
        return place;
	};
	std::vector<std::size_t> imageOf;
	for (std::size_t v = 0; v < halfNum; ++v) {
		if (coordinate(made.mesh.positions[v], plane.heightAxis()) != 0) imageOf.push_back(v);
	}
	workers.forEach(halfNum, [&](int v) {
		const BarycentricPoint& at = made.surfacePoints[v];
		vertex[v].point            = {surface.frame.toWorking(plane.toCaller(workingOf(at))),
									  half.faceOf[at.face]};
	});
	workers.forEach(imageOf.size(), [&](int i) {
		const Vec3d place = plane.mirrored(workingOf(made.surfacePoints[imageOf[i]]));
		vertex[halfNum + std::size_t(i)].point =
			nearest.nearest(surface.frame.toWorking(plane.toCaller(place)));
	});
	for (ResultVertex& v : vertex)
		v.normal = surface.mesh.faceNormal(v.point.face);
}

} // namespace gpr
