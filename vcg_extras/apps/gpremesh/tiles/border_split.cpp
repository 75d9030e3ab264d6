// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "border_split.h"

#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace gpr::app {

namespace {

class BorderSplitter {
public:
	BorderSplitter(double maxLength, InputMesh& mesh, std::vector<SharedName>& names,
				   bool sharedOnly) :
			maxLength_(maxLength),
			sharedOnly_(sharedOnly), mesh_(mesh), names_(names)
	{
	}

	void run()
	{
		std::vector<std::size_t> toDo = findLongBorderEdges();
		while (!toDo.empty()) {
			const std::size_t f = toDo.back();
			toDo.pop_back();
			splitFace(f, toDo);
		}
	}

private:
	/// The vertices between the ends of an edge.
	struct Points {
		int          pieceNum = 1;
		std::int32_t first    = 0; ///< first vertex between, from the smaller end on
	};

	double                   maxLength_;
	bool                     sharedOnly_;
	InputMesh&               mesh_;
	std::vector<SharedName>& names_;
	std::map<Edge, Points>   split_;

	std::int32_t corner(std::size_t f, std::size_t k) const
	{
		return mesh_.triangles[3 * f + k % 3];
	}

	double lengthOf(std::int32_t a, std::int32_t b) const
	{
		const MeshView view = mesh_.view();
		return length(view.position(std::size_t(b)) - view.position(std::size_t(a)));
	}

	/// Makes the points of long border edges. Returns the faces at these edges.
	std::vector<std::size_t> findLongBorderEdges()
	{
		std::vector<char> isEnd(mesh_.vertexNum(), 0);
		for (const Edge& e : borderEdges(mesh_.view())) {
			if (!(lengthOf(e.first, e.second) > maxLength_)) continue;
			if (sharedOnly_ && !isShared(e)) continue;
			addPoints(e);
			isEnd[std::size_t(e.first)] = isEnd[std::size_t(e.second)] = 1;
		}
		std::vector<std::size_t> faces;
		for (std::size_t f = 0; f < mesh_.faceNum(); ++f) {
			int endNum = 0;
			for (std::size_t k = 0; k < 3; ++k)
				endNum += isEnd[std::size_t(corner(f, k))];
			if (endNum >= 2) faces.push_back(f); // a face without such an edge is not split
		}
		return faces;
	}

	bool isShared(const Edge& e) const
	{
		return names_[std::size_t(e.first)].isShared() && names_[std::size_t(e.second)].isShared();
	}

	/// By their positions.
	bool isBefore(std::int32_t a, std::int32_t b) const
	{
		const MeshView view = mesh_.view();
		const Vec3d    p = view.position(std::size_t(a)), q = view.position(std::size_t(b));
		return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
	}

	/// Makes the points of an edge from the end with the lower position, so that all tiles, and all
	/// edges at the same place, get equal points.
	void addPoints(const Edge& edge)
	{
		const double pieces = std::ceil(lengthOf(edge.first, edge.second) / maxLength_);
		if (!(pieces < mostPieces)) return; // not a number, or too many pieces
		Points           points{int(pieces), std::int32_t(mesh_.vertexNum())};
		const SharedName a = names_[std::size_t(edge.first)], b = names_[std::size_t(edge.second)];
		const bool       isNamed  = isShared(edge);
		const bool       isTurned = isBefore(edge.second, edge.first);
		const std::int32_t from   = isTurned ? edge.second : edge.first;
		const std::int32_t to     = isTurned ? edge.first : edge.second;
		for (int i = 1; i < points.pieceNum; ++i) {
			const int k = isTurned ? points.pieceNum - i : i; // the k-th point from `from`
			addVertex(from, to, double(k) / points.pieceNum);
			SharedName name;
			if (isNamed) name = {std::min(a.low, b.low), std::max(a.low, b.low), std::uint32_t(k)};
			names_.push_back(name);
		}
		split_[edge] = points;
	}

	static constexpr double mostPieces = 1e6;

	void addVertex(std::int32_t from, std::int32_t to, double share)
	{
		const MeshView view = mesh_.view();
		const Vec3d    a = view.position(std::size_t(from)), b = view.position(std::size_t(to));
		const Vec3d    p = a + (b - a) * share;
		for (double c : {p.x, p.y, p.z}) {
			if (mesh_.doublePrecision)
				mesh_.doubles.push_back(c);
			else
				mesh_.floats.push_back(float(c));
		}
		for (ValueColumn& column : mesh_.attributes.ofVertices) {
			const double u = column.values[std::size_t(from)], v = column.values[std::size_t(to)];
			const double between = u + (v - u) * share;
			column.values.push_back(isInteger(column.type) ? std::round(between) : between);
		}
	}

	/// Begins with the smallest edge, so that repeated faces get repeated pieces.
	void splitFace(std::size_t f, std::vector<std::size_t>& toDo)
	{
		auto        at   = split_.end();
		std::size_t side = 0;
		for (std::size_t k = 0; k < 3; ++k) {
			const auto found = split_.find(std::minmax({corner(f, k), corner(f, k + 1)}));
			if (found == split_.end() || (at != split_.end() && at->first < found->first)) continue;
			at   = found;
			side = k;
		}
		if (at == split_.end()) return;
		splitFaceAt(f, side, at->second, corner(f, side) == at->first.first, toDo);
	}

	/// Splits the edge from corner k on. The first piece replaces the face; all other pieces come
	/// at the end.
	void splitFaceAt(std::size_t f, std::size_t k, const Points& points, bool isForward,
					 std::vector<std::size_t>& toDo)
	{
		const std::int32_t         b = corner(f, k + 1), apex = corner(f, k + 2);
		const std::array<float, 6> uv   = textureOf(f);
		std::int32_t               last = corner(f, k);
		for (int i = 1; i <= points.pieceNum; ++i) {
			const int          between         = isForward ? i - 1 : points.pieceNum - 1 - i;
			const std::int32_t next            = i == points.pieceNum ? b : points.first + between;
			const std::size_t  piece           = i == 1 ? f : copyFace(f);
			mesh_.triangles[3 * piece + k % 3] = last;
			mesh_.triangles[3 * piece + (k + 1) % 3] = next;
			mesh_.triangles[3 * piece + (k + 2) % 3] = apex;
			setTexture(piece, k, uv, double(i - 1) / points.pieceNum, double(i) / points.pieceNum);
			toDo.push_back(piece);
			last = next;
		}
	}

	std::size_t copyFace(std::size_t f)
	{
		for (std::size_t k = 0; k < 3; ++k)
			mesh_.triangles.push_back(mesh_.triangles[3 * f + k]);
		for (ValueColumn& column : mesh_.attributes.ofFaces)
			column.values.push_back(column.values[f]);
		CornerTexture& texture = mesh_.attributes.texture;
		if (!texture.uv.empty()) {
			for (std::size_t i = 0; i < 6; ++i)
				texture.uv.push_back(texture.uv[6 * f + i]);
		}
		if (!texture.image.empty()) texture.image.push_back(texture.image[f]);
		return mesh_.faceNum() - 1;
	}

	std::array<float, 6> textureOf(std::size_t f) const
	{
		std::array<float, 6> uv{};
		if (!mesh_.attributes.hasTexture()) return uv;
		std::copy_n(mesh_.attributes.texture.uv.begin() + std::ptrdiff_t(6 * f), 6, uv.begin());
		return uv;
	}

	/// uv: of the whole face; from and to: shares of the edge from corner k on.
	void setTexture(std::size_t piece, std::size_t k, const std::array<float, 6>& uv, double from,
					double to)
	{
		if (!mesh_.attributes.hasTexture()) return;
		const std::size_t a = 2 * (k % 3), b = 2 * ((k + 1) % 3);
		float* const      out = &mesh_.attributes.texture.uv[6 * piece];
		std::copy(uv.begin(), uv.end(), out);
		for (std::size_t i = 0; i < 2; ++i) {
			const double u = double(uv[a + i]), v = double(uv[b + i]);
			out[a + i] = float(u + (v - u) * from);
			out[b + i] = float(u + (v - u) * to);
		}
	}
};

} // namespace

void splitLongBorderEdges(double maxLength, InputMesh& mesh, std::vector<SharedName>& names,
						  bool sharedOnly)
{
	if (maxLength > 0) BorderSplitter(maxLength, mesh, names, sharedOnly).run();
}

std::vector<Edge> borderEdges(const MeshView& mesh)
{
	Workers                workers(1, nullptr);
	const Buffer<EdgeSide> sides = sortedSides(mesh, workers);
	std::vector<Edge>      border;
	const auto             apexOf = [&](const EdgeSide& side) {
        return mesh.vertexOf(std::size_t(prevInFace(side.halfEdge)));
	};
	forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
		const auto isRepeated = [&](const EdgeSide& s) {
			return apexOf(s) == apexOf(sides[begin]);
		};
		if (std::all_of(&sides[begin], &sides[begin] + (end - begin), isRepeated))
			border.push_back({sides[begin].low, sides[begin].high});
	});
	return border;
}

} // namespace gpr::app
