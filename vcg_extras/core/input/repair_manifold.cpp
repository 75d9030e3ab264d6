// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair_manifold.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/mesh/edge_sides.h>
#include <vcg_extras/core/mesh/half_edge_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gpr {

namespace {

/// Keeps the faces with keep[f] set, in their order.
void keepFaces(IndexedMesh& mesh, const std::vector<char>& keep)
{
	int kept = 0;
	for (int f = 0; f < mesh.faceNum; ++f) {
		if (!keep[f]) continue;
		for (int k = 0; k < 3; ++k)
			mesh.triangle[3 * kept + k] = mesh.triangle[3 * f + k];
		mesh.sourceFace[kept++] = mesh.sourceFace[f];
	}
	mesh.faceNum = kept;
}

void dropDuplicateFaces(IndexedMesh& mesh, Workers& workers, CleanCounts& counts)
{
	using Corners        = std::array<int, 4>; // in order, and the face
	const auto cornersOf = [&](std::size_t f) {
		const int* t = &mesh.triangle[3 * f];
		Corners    c = {t[0], t[1], t[2], int(f)};
		std::sort(c.begin(), c.begin() + 3);
		return c;
	};
	const Buffer<Corners> faces = sortedByBuckets<Corners>(
		std::size_t(mesh.faceNum), std::size_t(mesh.vertexNum), cornersOf,
		[](const Corners& c) { return c[0]; }, workers);
	std::vector<char> keep(mesh.faceNum, 1);
	for (std::size_t i = 1; i < faces.size(); ++i) {
		if (std::equal(faces[i].begin(), faces[i].begin() + 3, faces[i - 1].begin())) {
			keep[faces[i][3]] = 0;
			++counts.duplicateFaces;
		}
	}
	if (counts.duplicateFaces > 0) keepFaces(mesh, keep);
}

Buffer<EdgeSide> sortedSides(const IndexedMesh& mesh, Workers& workers)
{
	const auto side = [&](std::size_t h) {
		const int a = mesh.triangle[h], b = mesh.triangle[std::size_t(nextInFace(int(h)))];
		return edgeSide(a, b, int(h));
	};
	return sortedByBuckets<EdgeSide>(
		std::size_t(3) * mesh.faceNum, std::size_t(mesh.vertexNum), side,
		[](const EdgeSide& s) { return s.low; }, workers);
}

/// Joins faces over edges: link[h] is the half-edge on the other side, or -1.
class Linker {
public:
	Linker(const IndexedMesh& mesh, Workers& workers, CleanCounts& counts) :
			mesh_(mesh), workers_(workers), counts_(counts),
			link_(std::size_t(3) * mesh.faceNum, -1)
	{
	}

	std::vector<int> run()
	{
		const Buffer<EdgeSide> sides = sortedSides(mesh_, workers_);
		Poller                 poller(workers_);
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			poller.count();
			if (end - begin == 2) {
				join(sides[begin].halfEdge, sides[begin + 1].halfEdge);
			}
			else if (end - begin > 2) {
				++counts_.nonManifoldEdges;
				joinSmoothest(sides, begin, end);
			}
		});
		return std::move(link_);
	}

private:
	const IndexedMesh& mesh_;
	Workers&           workers_;
	CleanCounts&       counts_;
	std::vector<int>   link_;

	void join(int g, int h)
	{
		link_[g] = h;
		link_[h] = g;
	}

	/// Small for faces that continue each other smoothly; faces oriented alike come first.
	float bend(int g, int h) const
	{
		const bool sameDirection = mesh_.triangle[g] == mesh_.triangle[h];
		return dot(inward(mesh_, g), inward(mesh_, h)) + (sameDirection ? 2.0f : 0.0f);
	}

	void joinSmoothest(const Buffer<EdgeSide>& sides, std::size_t begin, std::size_t end)
	{
		// Fans of many faces on one edge are rare, but the pairing is quadratic: bound it.
		constexpr std::size_t most = 64;
		const std::size_t     n    = std::min(end - begin, most);
		for (;;) {
			float best  = HUGE_VALF;
			int   bestG = -1, bestH = -1;
			for (std::size_t i = begin; i < begin + n; ++i) {
				for (std::size_t k = i + 1; k < begin + n; ++k) {
					const int g = sides[i].halfEdge, h = sides[k].halfEdge;
					if (link_[g] >= 0 || link_[h] >= 0) continue;
					const float b = bend(g, h);
					if (b < best) {
						best  = b;
						bestG = g;
						bestH = h;
					}
				}
			}
			if (bestG < 0) return;
			join(bestG, bestH);
		}
	}
};

/// Orients faces alike over the links, component by component; the side with more area keeps its
/// orientation.
class Orienter {
public:
	Orienter(IndexedMesh& mesh, std::vector<int>& link, Workers& workers, CleanCounts& counts) :
			mesh_(mesh), link_(link), poller_(workers), counts_(counts),
			turned_(mesh.faceNum, unseen)
	{
	}

	void run()
	{
		for (int f = 0; f < mesh_.faceNum; ++f) {
			if (turned_[f] == unseen) orientComponent(f);
		}
		for (int f = 0; f < mesh_.faceNum; ++f) {
			poller_.count();
			if (turned_[f]) turn(f);
		}
	}

private:
	static constexpr char unseen = 2;

	IndexedMesh&      mesh_;
	std::vector<int>& link_;
	Poller            poller_;
	CleanCounts&      counts_;
	std::vector<char> turned_;

	void orientComponent(int seed)
	{
		std::vector<int> faces{seed};
		turned_[seed] = 0;
		for (std::size_t i = 0; i < faces.size(); ++i) {
			poller_.count();
			for (int h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
				visitAcross(h, faces);
			}
		}
		double turnedArea = 0, keptArea = 0;
		for (int f : faces)
			(turned_[f] ? turnedArea : keptArea) += double(length(mesh_.faceCross(f)));
		if (turnedArea <= keptArea) return;
		for (int f : faces)
			turned_[f] = !turned_[f];
	}

	void visitAcross(int h, std::vector<int>& faces)
	{
		const int g = link_[h];
		if (g < 0) return;
		const bool sameDirection = mesh_.triangle[g] == mesh_.triangle[h];
		const char wanted        = char(turned_[h / 3] ^ char(sameDirection));
		char&      neighbour     = turned_[g / 3];
		if (neighbour == unseen) {
			neighbour = wanted;
			faces.push_back(g / 3);
		}
		else if (neighbour != wanted) {
			// The way round came back to the other side: a one-sided surface. Cut here.
			link_[h] = link_[g] = -1;
			++counts_.nonOrientableCuts;
		}
	}

	/// (a, b, c) becomes (a, c, b): half-edge 0 takes the place of 2 and the other way round.
	void turn(int f)
	{
		++counts_.reorientedFaces;
		std::swap(mesh_.triangle[3 * f + 1], mesh_.triangle[3 * f + 2]);
		std::swap(link_[3 * f], link_[3 * f + 2]);
		for (int h = 3 * f; h < 3 * f + 3; h += 2) {
			if (link_[h] >= 0) link_[link_[h]] = h;
		}
	}
};

/// Gives every fan round a vertex a vertex of its own.
void separateFans(IndexedMesh& mesh, const std::vector<int>& link, Workers& workers,
				  CleanCounts& counts)
{
	Poller             poller(workers);
	std::vector<char>  seen(std::size_t(3) * mesh.faceNum, 0);
	std::vector<char>  taken(mesh.vertexNum, 0);
	std::vector<Vec3f> added;
	const auto         after  = [&](int h) { return link[prevInFace(h)]; };
	const auto         before = [&](int h) { return link[h] < 0 ? -1 : nextInFace(link[h]); };

	for (int corner = 0; corner < 3 * mesh.faceNum; ++corner) {
		poller.count();
		if (seen[corner]) continue;
		int first = corner;
		while (before(first) >= 0 && before(first) != corner)
			first = before(first);
		int v = mesh.triangle[corner];
		if (taken[v]) {
			added.push_back(mesh.position[v]);
			v = mesh.vertexNum + int(added.size()) - 1;
			++counts.nonManifoldVertices;
		}
		else {
			taken[v] = 1;
		}
		for (int h = first; h >= 0 && !seen[h]; h = after(h)) {
			seen[h]          = 1;
			mesh.triangle[h] = v;
		}
	}
	if (added.empty()) return;
	mesh.position.resize(mesh.vertexNum + added.size());
	std::copy(added.begin(), added.end(), mesh.position.begin() + mesh.vertexNum);
	mesh.vertexNum += int(added.size());
}

/// Two borders, or two joined pairs of faces, may still run between the same two vertices (a slit
/// of one edge; sheets that touch in an edge without ending there). Adjacency is told by vertices
/// from here on, so all but one of them get a vertex in the middle.
class SlitOpener {
public:
	SlitOpener(IndexedMesh& mesh, const std::vector<int>& link, Workers& workers) :
			mesh_(mesh), link_(link), workers_(workers), middle_(link.size(), -1)
	{
	}

	void run()
	{
		findSlits();
		if (slits_.empty()) return;
		sortPolled(slits_.begin(), slits_.end(), workers_);
		const int oldFaces = mesh_.faceNum;
		mesh_.triangle.resize(3 * (std::size_t(oldFaces) + slits_.size()));
		mesh_.sourceFace.resize(std::size_t(oldFaces) + slits_.size());
		mesh_.position.resize(mesh_.vertexNum + slits_.size());
		for (std::size_t i = 0; i < slits_.size();) {
			std::size_t end = i + 1;
			while (end < slits_.size() && slits_[end] / 3 == slits_[i] / 3)
				++end;
			splitFace(slits_[i] / 3, i, end);
			i = end;
		}
	}

private:
	IndexedMesh&            mesh_;
	const std::vector<int>& link_;
	Workers&                workers_;
	std::vector<int>        slits_;  ///< half-edges to get a vertex
	std::vector<int>        middle_; ///< per half-edge: that vertex, the same on both joined sides

	void findSlits()
	{
		const Buffer<EdgeSide> sides = sortedSides(mesh_, workers_);
		Poller                 poller(workers_);
		forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
			poller.count();
			// The first joined pair keeps the plain edge, or else the first border.
			int keeper = sides[begin].halfEdge;
			for (std::size_t i = end; i-- > begin;) {
				if (link_[sides[i].halfEdge] >= 0) keeper = sides[i].halfEdge;
			}
			for (std::size_t i = begin; i < end; ++i) {
				const int h = sides[i].halfEdge;
				if (h != keeper && link_[h] != keeper) slits_.push_back(h);
			}
		});
	}

	/// Fans the face out from a corner, with the new vertices put into its outline.
	void splitFace(int f, std::size_t begin, std::size_t end)
	{
		std::vector<int> outline;
		for (int h = 3 * f; h < 3 * f + 3; ++h) {
			outline.push_back(mesh_.triangle[h]);
			if (std::find(slits_.begin() + begin, slits_.begin() + end, h) !=
				slits_.begin() + end) {
				outline.push_back(middleOf(h));
			}
		}
		// Start the fan at a new vertex, so that no triangle has three points of one edge.
		const std::size_t start = 1 + std::size_t(slits_[begin] - 3 * f);
		std::rotate(outline.begin(), outline.begin() + start, outline.end());
		for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
			const int face               = k == 1 ? f : mesh_.faceNum++;
			mesh_.triangle[3 * face]     = outline[0];
			mesh_.triangle[3 * face + 1] = outline[k];
			mesh_.triangle[3 * face + 2] = outline[k + 1];
			mesh_.sourceFace[face]       = mesh_.sourceFace[f];
		}
	}

	int middleOf(int h)
	{
		const int other = link_[h];
		if (other >= 0 && middle_[other] >= 0) return middle_[other];
		const Vec3f a                   = mesh_.position[mesh_.triangle[h]];
		const Vec3f b                   = mesh_.position[mesh_.triangle[nextInFace(h)]];
		mesh_.position[mesh_.vertexNum] = (a + b) * 0.5f;
		middle_[h]                      = mesh_.vertexNum;
		return mesh_.vertexNum++;
	}
};

} // namespace

void repairManifold(IndexedMesh& mesh, Workers& workers, CleanCounts& counts)
{
	dropDuplicateFaces(mesh, workers, counts);
	std::vector<int> link = Linker(mesh, workers, counts).run();
	Orienter(mesh, link, workers, counts).run();
	separateFans(mesh, link, workers, counts);
	SlitOpener(mesh, link, workers).run();
}

} // namespace gpr
