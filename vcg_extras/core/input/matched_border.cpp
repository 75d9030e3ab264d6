// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "matched_border.h"

#include "load.h"
#include "periodic_border.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/same_place.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace gpr {

namespace {

/// Least turn of a corner: 50°, as 1 - its cosine. The turn is measured over a window in both
/// directions, in edges.
constexpr double cornerTurn = 1 - 0.6427876096865394, cornerWindow = 0.6;
/// A sample this near to a vertex of the border, in edges, is the vertex.
constexpr double nearVertex = 1e-4;
constexpr int    none       = -1;
/// Most samples of a piece of a border.
constexpr double mostSamples = 2e7;

/// A sample inside an edge of the border.
struct Inside {
	double share; ///< of the way from the edge's begin
	Vec3d  place;
};

/// An edge of the border or of a junction, and its neighbours along the line.
struct BorderEdge {
	std::vector<int>      corners;                  ///< of its faces, at the begins of their sides
	int                   begin = none, end = none; ///< places
	int                   next = none, last = none;
	PeriodicBorder::Shift shift = {}; ///< periods from the edge with the computed samples
	std::vector<Inside>   inside;     ///< by share

	bool                 isOfJunction() const { return corners.size() > 1; }
	PeriodicBorder::Edge ends() const { return {begin, end}; }
};

/// Finds the border's samples.
class BorderSampling {
public:
	BorderSampling(const MeshView& input, double edgeLength, const Vec3d& period,
				   Workers& workers) :
			input_(input),
			edge_(edgeLength), workers_(workers)
	{
		numberPlaces();
		findEdges();
		directJunctions();
		findTranslates(period);
		link();
		findStops();
		samplePieces();
	}

private:
	const MeshView&                 input_;
	const double                    edge_;
	Workers&                        workers_;
	std::vector<std::int32_t>       place_; ///< per vertex: the first vertex at the same place
	std::vector<char>               isStop_, isKeptPlace_;
	PeriodicBorder                  periodic_;
	std::map<int, std::vector<int>> edgesAt_; ///< per place

public:
	std::vector<BorderEdge> edge;

	/// Whether a vertex of the input mesh is a border vertex of the future result.
	bool isKept(std::size_t v) const { return isKeptPlace_[place_[v]] != 0; }

	/// Whether the side of edge e from a corner has the direction of the edge.
	bool isAlong(int e, int corner) const { return placeOf(corner) == edge[e].begin; }

	/// Position of a vertex of the input mesh; a translate gets its exact position.
	Vec3d placed(std::size_t v) const
	{
		return periodic_.any() ? translated(place_[v], {}) : input_.position(v);
	}

private:
	int placeOf(int corner) const { return place_[input_.vertexOf(std::size_t(corner))]; }
	/// Begin of an edge; for a translate, begin of the edge with the computed samples.
	Vec3d at(int e) const { return translated(edge[e].begin, edge[e].shift); }
	/// End of an edge, as at().
	Vec3d endOf(int e) const { return translated(edge[e].end, edge[e].shift); }
	/// The next edge, forward or backward, or none.
	int neighbourOf(int e, bool forward) const { return forward ? edge[e].next : edge[e].last; }

	/// The root of a place, moved by the periods of the place minus `back`. So all translates are
	/// computed from the same numbers.
	Vec3d translated(int place, const PeriodicBorder::Shift& back) const
	{
		PeriodicBorder::Shift shift = periodic_.shiftOf(place);
		for (std::size_t axis = 0; axis < 3; ++axis)
			shift[axis] = std::int8_t(shift[axis] - back[axis]);
		return input_.position(std::size_t(periodic_.rootOf(place))) + periodic_.times(shift);
	}

	void numberPlaces()
	{
		const auto positionOf = [&](std::int32_t v) { return input_.position(std::size_t(v)); };
		place_                = numbersBelow(input_.vertexNum);
		std::vector<std::int32_t> order;
		std::copy_if(place_.begin(), place_.end(), std::back_inserter(order),
					 [&](std::int32_t v) { return isFinite(positionOf(v)); });
		std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
			return isBefore(positionOf(a), positionOf(b));
		});
		for (std::size_t i = 1; i < order.size(); ++i) {
			if (positionOf(order[i]) == positionOf(order[i - 1]))
				place_[order[i]] = place_[order[i - 1]];
		}
		isKeptPlace_.assign(place_.size(), 0);
	}

	void findEdges()
	{
		std::vector<EdgeSide> sides;
		Poller                poller(workers_);
		requireVertexNumbers(input_, workers_);
		for (int c = 0; c < int(3 * input_.faceNum); ++c) {
			poller.count();
			const int a = placeOf(c), b = placeOf(nextInFace(c));
			if (a != b && isUsable(c / 3)) sides.push_back(edgeSide(a, b, c));
		}
		std::sort(sides.begin(), sides.end());
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			if (end - begin == 2) return;
			BorderEdge found;
			for (std::size_t i = begin; i < end; ++i)
				found.corners.push_back(sides[i].halfEdge);
			found.begin = placeOf(found.corners[0]);
			found.end   = placeOf(nextInFace(found.corners[0]));
			for (const int place : {found.begin, found.end})
				edgesAt_[place].push_back(int(edge.size()));
			edge.push_back(std::move(found));
		});
	}

	/// Gives the edges of each junction curve one direction: faces at a junction have any.
	void directJunctions()
	{
		std::vector<char> isDirected(edge.size(), 0);
		for (int e = 0; e < int(edge.size()); ++e) {
			if (!edge[e].isOfJunction() || isDirected[e]) continue;
			isDirected[e] = 1;
			for (const bool forward : {true, false})
				directFrom(e, forward, isDirected);
		}
	}

	/// Directs the edges of a junction curve on one side of edge e like edge e.
	void directFrom(int e, bool forward, std::vector<char>& isDirected)
	{
		while (true) {
			const BorderEdge&       from  = edge[e];
			const int               place = forward ? from.end : from.begin;
			const std::vector<int>& here  = edgesAt_.at(place);
			if (here.size() != 2) return;
			e                = here[0] == e ? here[1] : here[0];
			BorderEdge& next = edge[e];
			if (!next.isOfJunction() || isDirected[e]) return;
			isDirected[e] = 1;
			if ((forward ? next.begin : next.end) != place) std::swap(next.begin, next.end);
		}
	}

	/// Faces that are not usable are left out of the run.
	bool isUsable(int f) const
	{
		const auto t = input_.triangle(std::size_t(f));
		return std::all_of(t.begin(), t.end(), [&](std::int32_t v) {
			return isFinite(input_.position(std::size_t(v)));
		});
	}

	void findTranslates(const Vec3d& period)
	{
		if (period == Vec3d()) return;
		std::vector<PeriodicBorder::Edge> ends;
		for (int e = 0; e < int(edge.size()); ++e) {
			if (!edge[e].isOfJunction()) ends.push_back(edge[e].ends());
		}
		periodic_ = PeriodicBorder(input_, ends, period);
		for (BorderEdge& e : edge)
			e.shift = periodic_.shiftOf(e.ends());
	}

	/// Links edges at places with two edges, an end and a begin. All translates of a place are
	/// linked alike.
	void link()
	{
		for (const auto& [place, here] : edgesAt_) {
			const std::vector<int> others = periodic_.neighboursOf(place);
			const bool             isNode =
				isNodeAt(place) || std::any_of(others.begin(), others.end(),
											   [&](int other) { return isNodeAt(other); });
			if (isNode) continue;
			const bool isInOrder = edge[here[0]].end == place;
			const int  a = here[isInOrder ? 0 : 1], b = here[isInOrder ? 1 : 0];
			edge[a].next = b;
			edge[b].last = a;
		}
	}

	/// Whether other edges meet than an end and a begin, with as many faces and the same
	/// translates.
	bool isNodeAt(int place) const
	{
		const auto found = edgesAt_.find(place);
		if (found == edgesAt_.end() || found->second.size() != 2) return true;
		const BorderEdge& a = edge[found->second[0]];
		const BorderEdge& b = edge[found->second[1]];
		return (a.end == place) == (b.end == place) || a.corners.size() != b.corners.size() ||
			   a.shift != b.shift ||
			   periodic_.axesOnward(a.ends()) != periodic_.axesOnward(b.ends());
	}

	/// The place at the length `way` along the border from the begin of edge e, forward or
	/// backward.
	Vec3d walked(int e, bool forward, double way) const
	{
		Vec3d     from  = at(e);
		const int first = e;
		if (!forward) e = neighbourOf(e, false);
		while (e != none) {
			const Vec3d  to  = forward ? endOf(e) : at(e);
			const double len = length(to - from);
			if (len >= way) return from + (to - from) * (way / len);
			way -= len;
			from = to;
			e    = neighbourOf(e, forward);
			if (e == first) break;
		}
		return from;
	}

	/// The turn at the begin of e, as 1 - the cosine of the angle.
	double turnAt(int e) const
	{
		const Vec3d p = at(e), a = p - walked(e, false, cornerWindow * edge_),
					b     = walked(e, true, cornerWindow * edge_) - p;
		const double both = length(a) * length(b);
		return both > 0 ? 1 - dot(a, b) / both : 0;
	}

	bool isLargestTurn(int e, const std::vector<double>& turn) const
	{
		for (const bool forward : {true, false}) {
			double way = 0;
			int    k   = e;
			while (way <= cornerWindow * edge_) {
				const int next = neighbourOf(k, forward);
				if (next == none || next == e) break;
				way += length(at(next) - at(k));
				k                  = next;
				const double other = turn[k], own = turn[e];
				const bool   isOver = other > own || (other == own && isBefore(at(k), at(e)));
				if (way <= cornerWindow * edge_ && isOver) return false;
			}
		}
		return true;
	}

	void findStops()
	{
		std::vector<double> turn;
		for (int e = 0; e < int(edge.size()); ++e) {
			workers_.poll();
			turn.push_back(edge[e].last == none ? 0 : turnAt(e));
		}
		for (int e = 0; e < int(edge.size()); ++e) {
			workers_.poll();
			const bool isNode   = edge[e].last == none;
			const bool isCorner = turn[e] > cornerTurn && isLargestTurn(e, turn);
			isStop_.push_back(isNode || isCorner);
		}
		addStopsOfLoops();
	}

	/// A loop without a stop begins at its first place in the order of places.
	void addStopsOfLoops()
	{
		std::vector<char> isSeen(edge.size(), 0);
		for (int e = 0; e < int(edge.size()); ++e) {
			if (isStop_[e]) firstFrom(e, isSeen);
		}
		for (int e = 0; e < int(edge.size()); ++e) {
			if (!isSeen[e]) isStop_[firstFrom(e, isSeen)] = 1;
		}
	}

	/// The first edge, in the order of places, of the edges from e to the next that was seen.
	int firstFrom(int e, std::vector<char>& isSeen) const
	{
		int first = e;
		for (int k = e; k != none && !isSeen[k]; k = edge[k].next) {
			isSeen[k] = 1;
			if (isBefore(at(k), at(first))) first = k;
		}
		return first;
	}

	/// The edges from e, a stop, to the next stop.
	std::vector<int> pieceFrom(int e) const
	{
		std::vector<int> piece;
		do {
			piece.push_back(e);
			e = edge[e].next;
		} while (e != none && !isStop_[e]);
		return piece;
	}

	/// Two pieces with the same ends get a sample each at least: a loop of two pieces then has
	/// three samples, and no edge of the result coincides with another.
	void samplePieces()
	{
		std::vector<std::vector<int>>       pieces;
		std::map<PeriodicBorder::Edge, int> num; ///< of pieces, by their ends
		const auto endsOf = [&](const std::vector<int>& piece) -> PeriodicBorder::Edge {
			return std::minmax({edge[piece.front()].begin, edge[piece.back()].end});
		};
		for (int e = 0; e < int(edge.size()); ++e) {
			if (!isStop_[e]) continue;
			pieces.push_back(pieceFrom(e));
			++num[endsOf(pieces.back())];
		}
		for (const std::vector<int>& piece : pieces)
			samplePiece(piece, num[endsOf(piece)] > 1 ? 2 : 1);
	}

	/// least: the least number of parts of a piece that is not closed.
	void samplePiece(const std::vector<int>& piece, int least)
	{
		std::vector<Vec3d> point{at(piece.front())};
		for (const int e : piece)
			point.push_back(endOf(e));
		const bool isClosed = point.front() == point.back();
		const bool turns    = isClosed ? isBefore(point[point.size() - 2], point[1])
									   : isBefore(point.back(), point.front());
		if (turns) std::reverse(point.begin(), point.end());
		double whole = 0;
		for (std::size_t i = 1; i < point.size(); ++i)
			whole += length(point[i] - point[i - 1]);
		if (whole > mostSamples * edge_)
			throw Failure(Status::OutOfMemory, "The border would have too many vertices.");
		const int num = std::max(isClosed ? 3 : least, int(std::round(whole / edge_)));
		keep(edge[piece.front()].begin);
		keep(edge[piece.back()].end);
		double arc = 0;
		int    k   = 1;
		for (std::size_t i = 1; i < point.size(); ++i) {
			const double len = length(point[i] - point[i - 1]);
			const int    e   = piece[turns ? piece.size() - i : i - 1];
			for (; k < num && whole * k / num <= arc + len; ++k)
				put(e, point[i - 1], point[i], (whole * k / num - arc) / len, len, turns);
			arc += len;
		}
	}

	void keep(int place) { isKeptPlace_[place] = 1; }

	/// Puts a sample on edge e, at a share of the way from a to b. turns: a is the end of the edge.
	void put(int e, const Vec3d& a, const Vec3d& b, double share, double len, bool turns)
	{
		const auto [begin, end] = edge[e].ends();
		if (share * len < nearVertex * edge_) return keep(turns ? end : begin);
		if ((1 - share) * len < nearVertex * edge_) return keep(turns ? begin : end);
		std::vector<Inside>& on   = edge[e].inside;
		const Inside         made = {turns ? 1 - share : share, moved(a + (b - a) * share, e)};
		on.insert(turns ? on.begin() : on.end(), made);
	}

	/// Moves a sample to edge e from the edge with the computed samples.
	Vec3d moved(Vec3d place, int e) const
	{
		if (!periodic_.any()) return place;
		// The writer of a result rounds to floats, like the writer of the input: the shift by a
		// period must hold in floats too.
		if (!input_.doublePrecision) place = Vec3d(Vec3f(place));
		return place + periodic_.times(edge[e].shift);
	}
};

/// A corner of a part of a face, and the samples on the edge to the next corner.
struct PartCorner {
	struct Sample {
		std::int32_t vertex; ///< to insert
		float        share;
	};
	std::int32_t          vertex;
	MatchedBorder::Corner at;
	std::uint8_t          line = 0;
	std::vector<Sample>   samples;
};

using Part = std::array<PartCorner, 3>;

/// Makes the vertices of the samples. The faces at an edge of a junction share them if they share
/// the edge's ends.
class SampleVertices {
public:
	SampleVertices(const MeshView& input, const BorderSampling& border, MatchedBorder& out) :
			input_(input), border_(border), out_(out)
	{
		for (int e = 0; e < int(border.edge.size()); ++e) {
			if (border.edge[e].inside.empty()) continue;
			for (const int corner : border.edge[e].corners)
				edgeAt_[corner] = e;
		}
	}

	/// Names the samples on the edge from a corner of the input mesh, if any.
	void insertAt(int corner, PartCorner& part)
	{
		const auto found = edgeAt_.find(corner);
		if (found == edgeAt_.end()) return;
		const int                  e       = found->second;
		const bool                 isAlong = border_.isAlong(e, corner);
		const std::vector<Inside>& inside  = border_.edge[e].inside;
		const std::int32_t         first   = firstOf(e, corner);
		for (std::size_t i = 0; i < inside.size(); ++i) {
			const std::size_t at = isAlong ? i : inside.size() - 1 - i;
			part.samples.push_back({first + std::int32_t(at),
									float(isAlong ? inside[at].share : 1 - inside[at].share)});
		}
	}

private:
	const MeshView&       input_;
	const BorderSampling& border_;
	MatchedBorder&        out_;
	std::map<int, int>    edgeAt_; ///< by the corner at the begin of a side
	/// The first sample's vertex, by the edge and the vertices at its ends.
	std::map<std::array<std::int32_t, 3>, std::int32_t> first_;

	std::int32_t firstOf(int e, int corner)
	{
		const std::int32_t a = input_.vertexOf(std::size_t(corner)),
						   b = input_.vertexOf(std::size_t(nextInFace(corner)));
		const auto found     = first_.insert(
				{{e, std::min(a, b), std::max(a, b)}, std::int32_t(out_.positions.size())});
		if (!found.second) return found.first->second;
		for (const Inside& sample : border_.edge[e].inside) {
			out_.positions.push_back(sample.place);
			out_.isKept.push_back(1);
			if (!out_.selected.empty())
				out_.selected.push_back(out_.selected[a] != 0 && out_.selected[b] != 0);
		}
		return found.first->second;
	}
};

/// Cuts a part from the first sample on its first edge to the opposite corner.
void cut(Part& p, std::vector<Part>& open)
{
	const PartCorner::Sample    first = p[0].samples.front();
	const MatchedBorder::Corner at{p[0].at.from, first.share};
	const PartCorner            made{
        first.vertex, at, p[0].line, {p[0].samples.begin() + 1, p[0].samples.end()}};
	const PartCorner back{first.vertex, at, 0, {}}, across{p[2].vertex, p[2].at, 0, {}};
	p[0].samples.clear();
	open.push_back({made, p[1], across});
	open.push_back({p[0], back, p[2]});
}

void addFace(const MeshView& input, std::int32_t f, const Part& part, MatchedBorder& out)
{
	out.faceOf.push_back(f);
	for (const PartCorner& corner : part) {
		out.triangles.push_back(corner.vertex);
		out.cornerAt.push_back(corner.at);
		if (input.line != nullptr) out.line.push_back(corner.line);
	}
	if (input.region != nullptr) out.region.push_back(input.region[f]);
}

/// Adds face f, cut at the samples of its edges.
void addParts(const MeshView& input, std::int32_t f, Part whole, MatchedBorder& out)
{
	std::vector<Part> open{std::move(whole)};
	while (!open.empty()) {
		Part p = std::move(open.back());
		open.pop_back();
		for (int k = 0; k < 2 && p[0].samples.empty(); ++k)
			std::rotate(p.begin(), p.begin() + 1, p.end());
		if (p[0].samples.empty())
			addFace(input, f, p, out);
		else
			cut(p, open);
	}
}

BarycentricPoint ofCaller(const MatchedBorder& matched, const BarycentricPoint& at)
{
	BarycentricPoint out;
	out.face      = matched.faceOf[at.face];
	out.weight[0] = 0;
	for (std::size_t k = 0; k < 3; ++k) {
		const MatchedBorder::Corner& c = matched.cornerAt[3 * std::size_t(at.face) + k];
		out.weight[c.from] += at.weight[k] * (1 - c.share);
		out.weight[(c.from + 1) % 3] += at.weight[k] * c.share;
	}
	return out;
}

} // namespace

MeshView MatchedBorder::view() const
{
	MeshView v   = MarkedMesh::view();
	v.keptBorder = isKept.data();
	return v;
}

MatchedBorder matchBorder(const MeshView& input, double edgeLength, const Vec3d& period,
						  Workers& workers)
{
	const BorderSampling border(input, edgeLength, period, workers);
	MatchedBorder        out;
	for (std::size_t v = 0; v < input.vertexNum; ++v) {
		out.positions.push_back(border.placed(v));
		out.isKept.push_back(border.isKept(v));
	}
	if (input.selected != nullptr)
		out.selected.assign(input.selected, input.selected + input.vertexNum);
	SampleVertices samples(input, border, out);
	Poller         poller(workers);
	for (std::size_t f = 0; f < input.faceNum; ++f) {
		poller.count();
		Part part;
		for (std::size_t k = 0; k < 3; ++k) {
			const std::size_t c = 3 * f + k;
			part[k].vertex      = input.vertexOf(c);
			part[k].at.from     = std::uint8_t(k);
			if (input.line != nullptr) part[k].line = input.line[c];
			samples.insertAt(int(c), part[k]);
		}
		addParts(input, std::int32_t(f), std::move(part), out);
	}
	return out;
}

void nameCallers(const MeshView& input, const MatchedBorder& matched, RemeshResult& result)
{
	for (BarycentricPoint& at : result.surfacePoints)
		at = ofCaller(matched, at);
	for (BarycentricPoint& at : result.facePoints)
		at = ofCaller(matched, at);
	for (std::int32_t& v : result.callersVertex) {
		if (std::size_t(v) >= input.vertexNum) v = none;
	}
}

} // namespace gpr
