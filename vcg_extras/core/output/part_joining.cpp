// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_joining.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <utility>

namespace gpr {

namespace {

using Edge = std::pair<std::int32_t, std::int32_t>; ///< the smaller vertex first

/// The edges between selected and unselected faces, sorted.
std::vector<Edge> findSeam(const MeshView& input, const std::vector<std::uint8_t>& isInPart)
{
	std::vector<char> ofRest(input.vertexNum, 0), ofPart(input.vertexNum, 0);
	for (std::size_t c = 0; c < 3 * input.faceNum; ++c)
		(isInPart[c / 3] ? ofPart : ofRest)[input.vertexOf(c)] = 1;
	const auto            isOfBoth = [&](std::int32_t v) { return ofRest[v] && ofPart[v]; };
	std::vector<EdgeSide> sides;
	for (std::size_t c = 0; c < 3 * input.faceNum; ++c) {
		const EdgeSide side = edgeSide(input, c);
		if (side.low != side.high && isOfBoth(side.low) && isOfBoth(side.high))
			sides.push_back(side);
	}
	std::sort(sides.begin(), sides.end());
	std::vector<Edge> seam;
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		bool hasSide[2] = {false, false}; // of the rest, of the part
		for (std::size_t i = begin; i < end; ++i)
			hasSide[isInPart[sides[i].halfEdge / 3]] = true;
		if (hasSide[0] && hasSide[1]) seam.push_back({sides[begin].low, sides[begin].high});
	});
	return seam;
}

/// Joins the new faces to the unselected faces.
class Joining {
public:
	Joining(const MeshView& input, const SelectedPart& part, const RemeshResult& made,
			RemeshResult& out) :
			input_(input),
			part_(part), made_(made), out_(out)
	{
	}

	void join()
	{
		findMadeSeam();
		takeRest();
		takeMade();
	}

private:
	const MeshView&           input_;
	const SelectedPart&       part_;
	const RemeshResult&       made_;
	RemeshResult&             out_;
	std::vector<std::int32_t> newIndex_; ///< per input vertex: the vertex of the result, or -1
	std::vector<char>         isOnSeam_; ///< per new vertex

	/// Takes the unselected faces, and their vertices in the order of the input.
	void takeRest()
	{
		std::vector<BarycentricPoint> at(input_.vertexNum);
		for (std::size_t f = 0; f < input_.faceNum; ++f) {
			if (part_.isInPart[f]) continue;
			for (std::size_t k = 0; k < 3; ++k) {
				BarycentricPoint& p = at[input_.vertexOf(3 * f + k)];
				if (p.face < 0) p = BarycentricPoint::ofCorner(f, k);
			}
		}
		newIndex_.assign(input_.vertexNum, -1);
		for (std::size_t v = 0; v < input_.vertexNum; ++v) {
			if (at[v].face < 0) continue;
			newIndex_[v] = std::int32_t(out_.mesh.positions.size());
			out_.mesh.positions.push_back(input_.position(v));
			out_.surfacePoints.push_back(at[v]);
			out_.callersVertex.push_back(std::int32_t(v));
		}
		for (std::size_t f = 0; f < input_.faceNum; ++f) {
			if (!part_.isInPart[f]) addRestFace(f);
		}
	}

	void addRestFace(std::size_t f)
	{
		for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
			out_.mesh.triangles.push_back(newIndex_[input_.vertexOf(c)]);
		out_.facePoints.push_back(BarycentricPoint::ofMiddle(f));
		out_.callersFace.push_back(std::int32_t(f));
		if (input_.region != nullptr) out_.region.push_back(input_.region[f]);
	}

	BarycentricPoint ofCaller(BarycentricPoint at) const
	{
		at.face = part_.faceOf[at.face];
		return at;
	}

	void takeMade()
	{
		std::vector<std::int32_t> index(made_.mesh.vertexNum());
		for (std::size_t v = 0; v < index.size(); ++v)
			index[v] = addMade(v);
		for (std::int32_t v : made_.mesh.triangles)
			out_.mesh.triangles.push_back(index[v]);
		out_.callersFace.resize(out_.mesh.faceNum(), -1);
		out_.region.insert(out_.region.end(), made_.region.begin(), made_.region.end());
		for (const BarycentricPoint& at : made_.facePoints)
			out_.facePoints.push_back(ofCaller(at));
	}

	/// A vertex on the seam is the vertex of the rest. An input vertex away from the seam may be
	/// several new vertices, since the run cuts vertices with several fans of faces.
	std::int32_t addMade(std::size_t v)
	{
		const BarycentricPoint at = ofCaller(made_.surfacePoints[v]);
		if (isOnSeam_[v]) return newIndex_[callerOf(v)];
		out_.mesh.positions.push_back(made_.mesh.positions[v]);
		out_.surfacePoints.push_back(at);
		out_.callersVertex.push_back(callerOf(v));
		return std::int32_t(out_.mesh.positions.size()) - 1;
	}

	/// The input vertex of a new vertex, or -1.
	std::int32_t callerOf(std::size_t v) const
	{
		const std::int32_t inPart = made_.callersVertex.empty() ? -1 : made_.callersVertex[v];
		return inPart < 0 ? -1 : part_.vertexOf[inPart];
	}

	/// Throws Failure unless every edge of the seam is an edge of the new faces too.
	void findMadeSeam()
	{
		const std::vector<Edge> seam = findSeam(input_, part_.isInPart);
		std::vector<Edge>       found;
		isOnSeam_.assign(made_.mesh.vertexNum(), 0);
		const auto& t = made_.mesh.triangles;
		for (std::size_t c = 0; c < t.size(); ++c) {
			const std::int32_t v = t[c], w = t[c % 3 == 2 ? c - 2 : c + 1];
			const std::int32_t a = callerOf(v), b = callerOf(w);
			const Edge         edge = std::minmax(a, b);
			if (a < 0 || b < 0 || !std::binary_search(seam.begin(), seam.end(), edge)) continue;
			isOnSeam_[v] = isOnSeam_[w] = 1;
			found.push_back(edge);
		}
		std::sort(found.begin(), found.end());
		if (std::includes(found.begin(), found.end(), seam.begin(), seam.end())) return;
		throw Failure(
			Status::PromiseBroken,
			"The new faces could not be joined to the rest of the mesh: along the border of "
			"the selection lie edges with more than two faces.");
	}
};

} // namespace

RemeshOptions optionsInside(const RemeshOptions& options)
{
	RemeshOptions inside           = options;
	inside.selectedOnly            = false;
	inside.surfacePointsOfVertices = true; // show the vertices of the seam
	inside.boundary                = BoundaryMode::Keep;
	inside.sew = false; // the rest stays unchanged and is joined vertex by vertex
	return inside;
}

RemeshResult joinPart(const MeshView& input, const SelectedPart& part, const RemeshOptions& options,
					  RemeshResult made)
{
	RemeshResult out;
	Joining(input, part, made, out).join();
	if (!options.surfacePointsOfFaces) out.facePoints.clear();
	out.status = Status::Ok;
	out.notes  = std::move(made.notes);
	if (options.boundary != RemeshOptions().boundary && options.boundary != BoundaryMode::Keep)
		out.notes.push_back("The border mode has no effect: the border of selected faces stays.");
	out.report                  = std::move(made.report);
	out.report.input.diagonal   = extentOf(input).diagonal; // lengths in percent are of the whole
	out.report.untouchedFaceNum = std::int64_t(input.faceNum - part.faceOf.size());
	return out;
}

} // namespace gpr
