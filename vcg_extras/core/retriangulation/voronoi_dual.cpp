// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "voronoi_dual.h"

#include <vcg_extras/core/base/counting_sort.h>
#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gpr {

namespace {

/// Times that bad cells are opened and the rest is contracted anew.
constexpr int maxRounds = 8;
/// Times per round that newly opened cells may spoil other cells.
constexpr int maxSpreads = 32;

using Triple = std::array<int, 3>;

/// Lists the vertices from `first` on that represent no sample.
void listTodo(int first, VoronoiDual& cells)
{
	std::vector<char> stays(cells.label.size(), 0);
	for (int v : cells.sampleVertex) {
		if (v >= 0) stays[v] = 1;
	}
	for (int v = first; v < int(stays.size()); ++v) {
		if (!stays[v]) cells.todo.push_back(v);
	}
}

class VoronoiDualBuilder {
public:
	VoronoiDualBuilder(const Surface& surface, const Sampling& sampling,
					   const BoundaryCurves& boundary, Workers& workers) :
			surface_(surface),
			m_(surface.mesh), sampling_(sampling), boundary_(boundary), workers_(workers),
			sampleNum_(int(sampling.samples.size())), open_(sampleNum_, 0), bad_(sampleNum_, 0)
	{
	}

	VoronoiDual run(const MeshFigures& input)
	{
		VoronoiDual out;
		if (!contractMost(input, out)) openAll(out);
		return out;
	}

private:
	const Surface&        surface_;
	const HalfEdgeMesh&   m_;
	const Sampling&       sampling_;
	const BoundaryCurves& boundary_;
	Workers&              workers_;
	int                   sampleNum_;
	Buffer<int>           label_;        ///< per vertex of the surface: the sample of its cell
	Buffer<char>          owns_;         ///< per sample: whether it has a vertex
	Buffer<int>           cellOrder_;    ///< samples with a cell, in the order of the surface
	Buffer<Triple>        dualFaces_;    ///< three samples a face
	std::vector<char>     open_;         ///< per sample: its cell is left open
	std::vector<char>     bad_;          ///< per sample: its cell is bad and not yet open
	std::vector<int>      openVertices_; ///< vertices of the surface in open cells, ascending

	/// Returns false if all cells are better left open.
	bool contractMost(const MeshFigures& input, VoronoiDual& out)
	{
		takeOverLabels();
		orderCells();
		markCellsThatAreNoDisks();
		giveAwayCutOff();
		findDualFaces();
		markCellsOnCreases();
		markStrayCurveSamples();
		for (int round = 0; round < maxRounds; ++round) {
			if (!openBadCells()) return false;
			if (contract(out)) return figuresOf(out.mesh, 1, workers_).hasTopologyOf(input);
		}
		return false;
	}

	/// Takes over the surface with all its vertices.
	void openAll(VoronoiDual& out)
	{
		takeOverLabels();
		std::fill(open_.begin(), open_.end(), char(1));
		listOpenVertices();
		numberVertices(out);
		out.mesh = copyMesh(m_, workers_);
	}

	void takeOverLabels()
	{
		owns_ = Buffer<char>(sampleNum_, 0);
		label_.reset(m_.vertexNum);
		workers_.forRange(m_.vertexNum, [&](std::size_t begin, std::size_t end) {
			int last = -1;
			for (std::size_t v = begin; v < end; ++v) {
				const int s = sampling_.nearest[v].sample;
				if (s >= 0 && s != last) __atomic_store_n(&owns_[s], char(1), __ATOMIC_RELAXED);
				label_[v] = last = s;
			}
		});
	}

	/// Orders cells by the faces of their samples. Faces are in spatial order, hence also vertices.
	void orderCells()
	{
		constexpr int facesTogether = 8; // the face of at most one sample in most buckets
		const auto    faceOf        = [&](int s) { return sampling_.samples[s].point.face; };
		const auto    bucketOf      = [&](std::size_t s) {
            return owns_[s] ? faceOf(int(s)) / facesTogether : -1;
		};
		const std::size_t bucketNum = std::size_t(m_.faceNum / facesTogether) + 1;
		Buffer<int>       start;
		sortIntoBuckets(std::size_t(sampleNum_), bucketNum, bucketOf, workers_, start, cellOrder_);
		workers_.forEach(bucketNum, [&](int b) {
			std::sort(&cellOrder_[start[b]], &cellOrder_[start[b + 1]], [&](int s, int t) {
				return faceOf(s) != faceOf(t) ? faceOf(s) < faceOf(t) : s < t;
			});
		});
	}

	/// Marks cells with 2·(vertices - edges + faces) ≠ 2. Half-edges count: a face with three
	/// corners in the cell adds 2 - 3 = -1; a face with two corners in the cell adds -1 for half of
	/// an edge; a border edge lacks its second half, which its vertex adds.
	void markCellsThatAreNoDisks()
	{
		Buffer<int> euler(sampleNum_, 0);
		workers_.forEach(m_.vertexNum, [&](int v) {
			const int s = label_[v];
			if (s < 0) return;
			const int  h       = m_.outgoing[v];
			const bool hasHalf = h >= 0 && m_.opposite[h] < 0 && label_[m_.target(h)] == s;
			__atomic_fetch_add(&euler[s], hasHalf ? 1 : 2, __ATOMIC_RELAXED);
		});
		workers_.forEach(m_.faceNum, [&](int f) {
			const int* v = &m_.origin[3 * f];
			const int  a = label_[v[0]], b = label_[v[1]], c = label_[v[2]];
			const int  shared = a == b || a == c ? a : b == c ? b : -1;
			if (shared >= 0) __atomic_fetch_add(&euler[shared], -1, __ATOMIC_RELAXED);
		});
		for (int s : cellOrder_)
			bad_[s] = euler[s] != 2;
	}

	/// Gives cut-off vertices to neighbouring cells. Most cells that are no disks have a few
	/// vertices that later samples cut off from the rest.
	void giveAwayCutOff()
	{
		std::vector<int>  cutOff  = takeCutOff();
		std::vector<char> touched = bad_;
		for (bool changed = true; changed && !cutOff.empty();) {
			std::size_t left = 0;
			for (int v : cutOff) {
				const int s = nearestAmongNeighbours(v);
				label_[v]   = s;
				if (s >= 0)
					touched[s] = 1;
				else
					cutOff[left++] = v;
			}
			changed = left < cutOff.size();
			cutOff.resize(left);
		}
		std::fill(bad_.begin(), bad_.end(), char(0));
		markBad(touched, [&](const std::vector<int>& cell) { return isDisk(cell); });
	}

	std::vector<int> verticesOf(const std::vector<char>& marked) const
	{
		return workers_.collectEach<int>(m_.vertexNum, [&](int v, auto& out) {
			if (label_[v] >= 0 && marked[label_[v]]) out.push_back(v);
		});
	}

	/// Collects the entries that visit(cell, found) appends for each cell of the given vertices;
	/// `cell` has the vertices of a cell, ascending.
	template <class Visit>
	std::vector<int> collectByCell(const std::vector<int>& vertices, const Visit& visit) const
	{
		std::vector<std::pair<int, int>> inCell; // cell, vertex
		inCell.reserve(vertices.size());
		for (int v : vertices)
			inCell.push_back({label_[v], v});
		sortPolled(inCell.begin(), inCell.end(), workers_); // a cell may be the whole surface
		std::vector<std::size_t> first;                     // of each cell
		for (std::size_t i = 0; i < inCell.size(); ++i) {
			if (i == 0 || inCell[i].first != inCell[i - 1].first) first.push_back(i);
		}
		first.push_back(inCell.size());
		const auto visitCells = [&](std::size_t begin, std::size_t end, auto& found) {
			std::vector<int> cell;
			for (std::size_t c = begin; c < end; ++c) {
				cell.clear();
				for (std::size_t i = first[c]; i < first[c + 1]; ++i)
					cell.push_back(inCell[i].second);
				visit(cell, found);
			}
		};
		return workers_.collect<int>(first.size() - 1, visitCells);
	}

	/// Marks cells as bad if they fail the test isGood(cell); `cell` as in collectByCell.
	template <class Test>
	void markBad(const std::vector<char>& suspects, const Test& isGood)
	{
		const std::vector<int> found = collectByCell(
			verticesOf(suspects), [&](const std::vector<int>& cell, std::vector<int>& bad) {
				if (!isGood(cell)) bad.push_back(label_[cell.front()]);
			});
		for (int s : found)
			bad_[s] = 1;
	}

	/// Removes the label of vertices of bad cells without a path in their cell to the vertex
	/// nearest to the sample, and returns these vertices. Vertices of curves keep their label.
	std::vector<int> takeCutOff()
	{
		Buffer<char>     isReached(std::size_t(m_.vertexNum), 0);
		std::vector<int> cutOff = collectByCell(
			verticesOf(bad_), [&](const std::vector<int>& cell, std::vector<int>& found) {
				addCutOff(cell, isReached, found);
			});
		std::sort(cutOff.begin(), cutOff.end());
		for (int v : cutOff)
			label_[v] = -1;
		return cutOff;
	}

	/// Appends the cut-off vertices of a cell, and marks its other vertices as reached. Other cells
	/// may be looked at by other threads.
	void addCutOff(const std::vector<int>& cell, Buffer<char>& isReached,
				   std::vector<int>& cutOff) const
	{
		const auto isFarther = [&](int v, int w) {
			return sampling_.nearest[v].distance > sampling_.nearest[w].distance;
		};
		int heart = cell.front();
		for (int v : cell) {
			if (isFarther(heart, v)) heart = v;
		}
		std::vector<int> queue;
		const auto       reach = [&](int v) {
            if (isReached[v]) return;
            isReached[v] = 1;
            queue.push_back(v);
		};
		reach(heart);
		while (!queue.empty()) {
			const int v = queue.back();
			queue.pop_back();
			forEachNeighbour(m_, v, [&](int w) {
				if (label_[w] == label_[heart]) reach(w);
			});
		}
		for (int v : cell) {
			if (!isReached[v] && !m_.isCurveVertex(v)) cutOff.push_back(v);
		}
	}

	/// The nearest sample with a cell at v's neighbours; -1 if no neighbour has a cell.
	int nearestAmongNeighbours(int v) const
	{
		int   best     = -1;
		float distance = HUGE_VALF;
		forEachNeighbour(m_, v, [&](int w) {
			const int s = label_[w];
			if (s < 0) return;
			const float d = squaredLength(sampling_.samples[s].point.position - m_.position[v]);
			if (d < distance || (d == distance && s < best)) {
				distance = d;
				best     = s;
			}
		});
		return best;
	}

	/// The test of markCellsThatAreNoDisks for a single cell, given its vertices. Sums
	/// 6·(vertices - edges + faces): an edge adds -3 at each of two vertices, a face 2 at each of
	/// three.
	bool isDisk(const std::vector<int>& cell) const
	{
		const int s     = label_[cell.front()];
		int       euler = 0;
		for (int v : cell) {
			euler += 6;
			forEachNeighbour(m_, v, [&](int w) { euler -= label_[w] == s ? 3 : 0; });
			forEachOutgoing(m_, v, [&](int h) {
				const bool isInside = label_[m_.target(h)] == s && label_[m_.apex(h)] == s;
				euler += isInside ? 2 : 0;
			});
		}
		return euler == 6;
	}

	/// Collects the faces with corners in three cells.
	void findDualFaces()
	{
		dualFaces_ = workers_.collectMany<Triple>(
			m_.faceNum, [&](std::size_t begin, std::size_t end, auto& found) {
				for (std::size_t f = begin; f < end; ++f) {
					const int* v = &m_.origin[3 * f];
					const int  a = label_[v[0]], b = label_[v[1]], c = label_[v[2]];
					const bool differ = a != b && b != c && c != a;
					if (differ && a >= 0 && b >= 0 && c >= 0) found.push_back({a, b, c});
				}
			});
	}

	void markCellsOnCreases()
	{
		if (!m_.hasCreases()) return;
		workers_.forEach(m_.halfEdgeNum(), [&](int h) {
			if (m_.crease[h] == 0) return;
			const int s = label_[m_.origin[h]];
			if (s >= 0) __atomic_store_n(&bad_[s], char(1), __ATOMIC_RELAXED);
		});
	}

	/// Marks cells of curve samples whose vertex lies in another cell.
	void markStrayCurveSamples()
	{
		for (int s = 0; s < sampling_.boundarySampleNum; ++s) {
			const int v = boundary_.samples[s].vertex;
			if (v < 0 || label_[v] == s) continue;
			bad_[s] = 1;
			if (label_[v] >= 0) bad_[label_[v]] = 1;
		}
	}

	/// Opens bad cells and the neighbouring cells that this spoils. Returns false if too many cells
	/// are open then.
	bool openBadCells()
	{
		std::vector<char> fresh;
		for (int i = 0; i < maxSpreads && openMarked(fresh); ++i)
			markSpoiltBy(fresh);
		openMarked(fresh);
		listOpenVertices();
		const auto openNum = std::count(open_.begin(), open_.end(), char(1));
		return 2 * std::size_t(openNum) <= cellOrder_.size();
	}

	void listOpenVertices()
	{
		openVertices_ = workers_.collectIf(m_.vertexNum, [&](int v) { return isOpenVertex(v); });
	}

	/// Opens the bad cells and marks newly open cells in `fresh`. Returns false if no cell is newly
	/// open.
	bool openMarked(std::vector<char>& fresh)
	{
		bool any = false;
		fresh.assign(sampleNum_, 0);
		for (int s = 0; s < sampleNum_; ++s) {
			if (!bad_[s]) continue;
			fresh[s] = !open_[s];
			any      = any || fresh[s];
			open_[s] = 1;
			bad_[s]  = 0;
		}
		return any;
	}

	/// Marks contracted cells that touch an open vertex in two places: such a cell makes no single
	/// fan. The test of cells next to newly opened cells saves a contraction that would fail.
	void markSpoiltBy(const std::vector<char>& fresh)
	{
		std::vector<char> isNear(sampleNum_, 0);
		for (int v : verticesOf(fresh)) {
			forEachNeighbour(m_, v, [&](int w) {
				if (!isOpenVertex(w)) isNear[label_[w]] = 1;
			});
		}
		markBad(isNear, [&](const std::vector<int>& cell) { return isFanWhenContracted(cell); });
	}

	/// Whether the faces round a cell make a single fan after the cell's contraction.
	bool isFanWhenContracted(const std::vector<int>& cell) const
	{
		const int  own    = label_[cell.front()];
		const auto nodeOf = [&](int v) { return isOpenVertex(v) ? sampleNum_ + v : label_[v]; };
		std::vector<std::pair<int, int>> link; // edges opposite the vertex
		for (int v : cell) {
			forEachOutgoing(m_, v, [&](int h) {
				const int a = nodeOf(m_.target(h)), b = nodeOf(m_.apex(h));
				if (a != b && a != own && b != own) link.push_back({a, b});
			});
		}
		return isOneChain(link);
	}

	/// Whether directed edges make a path, or a cycle of at least three edges, through distinct
	/// nodes.
	static bool isOneChain(std::vector<std::pair<int, int>>& edges)
	{
		if (edges.empty()) return false;
		std::sort(edges.begin(), edges.end());
		std::vector<int> ends;
		ends.reserve(edges.size());
		for (const auto& e : edges)
			ends.push_back(e.second);
		std::sort(ends.begin(), ends.end());
		const auto begin  = std::find_if(edges.begin(), edges.end(), [&](const auto& e) {
            return !std::binary_search(ends.begin(), ends.end(), e.first);
        });
		const bool isPath = begin != edges.end();
		const int  first  = isPath ? begin->first : edges.front().first;
		int        node   = first;
		// Nodes are distinct if the way takes all edges before it ends or closes.
		for (std::size_t steps = 0; steps <= edges.size(); ++steps) {
			const auto next = std::lower_bound(edges.begin(), edges.end(), std::pair(node, 0));
			if (next == edges.end() || next->first != node) return isPath && steps == edges.size();
			node = next->second;
			if (node == first) return steps + 1 == edges.size() && edges.size() >= 3;
		}
		return false;
	}

	bool isOpenVertex(int v) const { return label_[v] < 0 || open_[label_[v]]; }

	/// Makes the mesh. Returns false and marks the bad cells if the mesh is not manifold.
	bool contract(VoronoiDual& out)
	{
		numberVertices(out);
		IndexedMesh mesh;
		mesh.frame     = surface_.frame;
		mesh.vertexNum = int(out.label.size());
		mesh.position.reset(mesh.vertexNum);
		workers_.forEach(mesh.vertexNum, [&](int v) {
			const int u = out.surfaceVertex[v];
			mesh.position[v] =
				u >= 0 ? m_.position[u] : sampling_.samples[out.label[v]].point.position;
		});
		collectFaces(out, mesh);
		Buffer<int> faceStart;
		orderFaces(mesh, workers_, faceStart);
		Surface connected;
		if (connect(mesh, faceStart, workers_, connected)) {
			out.mesh = std::move(connected.mesh);
			carryCreases(out);
			return markWrongBorders(out);
		}
		const Buffer<char> notManifold = findNotManifold(mesh, connected.mesh.opposite, workers_);
		for (int v = 0; v < mesh.vertexNum; ++v) {
			if (notManifold[v] && out.label[v] >= 0) bad_[out.label[v]] = 1;
		}
		return false;
	}

	/// Numbers the contracted cells first, then the vertices of open cells.
	void numberVertices(VoronoiDual& out)
	{
		out.label.clear();
		out.surfaceVertex.clear();
		out.todo.clear();
		out.sampleVertex.assign(sampleNum_, -1);
		for (int s : cellOrder_) {
			if (open_[s]) continue;
			out.sampleVertex[s] = int(out.label.size());
			out.label.push_back(s);
			out.surfaceVertex.push_back(-1);
		}
		for (int v : openVertices_) {
			out.label.push_back(label_[v]);
			out.surfaceVertex.push_back(v);
		}
		chooseRepresentatives(out);
	}

	/// Chooses the vertex of each open cell: the vertex nearest to the sample; curve samples have
	/// theirs.
	void chooseRepresentatives(VoronoiDual& out) const
	{
		const int firstOpen = int(out.label.size() - openVertices_.size());
		for (int s = 0; s < sampling_.boundarySampleNum; ++s) {
			const int v = boundary_.samples[s].vertex;
			if (v >= 0 && isOpenVertex(v)) out.sampleVertex[s] = firstOpen + openIndex(v);
		}
		for (std::size_t i = 0; i < openVertices_.size(); ++i) {
			const int v = openVertices_[i], s = label_[v];
			if (s < sampling_.boundarySampleNum) continue;
			int& best = out.sampleVertex[s];
			if (best < 0 ||
				sampling_.nearest[v].distance < sampling_.nearest[out.surfaceVertex[best]].distance)
				best = firstOpen + int(i);
		}
		listTodo(firstOpen, out);
	}

	int openIndex(int v) const { return placeIn(openVertices_, v); }

	/// Collects the dual faces between contracted cells, and the faces at open vertices.
	void collectFaces(const VoronoiDual& out, IndexedMesh& mesh) const
	{
		const std::size_t    dualNum = dualFaces_.size();
		const Buffer<Triple> faces   = workers_.collectMany<Triple>(
            dualNum + openVertices_.size(), [&](std::size_t begin, std::size_t end, auto& found) {
                for (std::size_t i = begin; i < end; ++i) {
                    if (i < dualNum)
                        addIfContracted(dualFaces_[i], out, found);
                    else
                        addFacesAt(int(i - dualNum), out, found);
                }
            });
		mesh.faceNum = int(faces.size());
		mesh.triangle.reset(3 * faces.size());
		mesh.sourceFace.reset(faces.size());
		workers_.forEach(faces.size(), [&](int f) {
			std::copy(faces[f].begin(), faces[f].end(), &mesh.triangle[3 * f]);
			mesh.sourceFace[f] = f;
		});
	}

	/// Appends a dual face if its cells are contracted.
	void addIfContracted(const Triple& t, const VoronoiDual& out, std::vector<Triple>& found) const
	{
		if (open_[t[0]] || open_[t[1]] || open_[t[2]]) return;
		found.push_back({out.sampleVertex[t[0]], out.sampleVertex[t[1]], out.sampleVertex[t[2]]});
	}

	/// Appends the faces at open vertex i that have three different vertices.
	void addFacesAt(int i, const VoronoiDual& out, std::vector<Triple>& found) const
	{
		const int  v         = openVertices_[i];
		const int  firstOpen = int(out.label.size() - openVertices_.size());
		const auto vertexOf  = [&](int w) {
            return isOpenVertex(w) ? firstOpen + openIndex(w) : out.sampleVertex[label_[w]];
		};
		forEachOutgoing(m_, v, [&](int h) {
			const int a = m_.target(h), b = m_.apex(h);
			// Each open corner of a face finds the face; only the smallest corner counts.
			if ((a < v && isOpenVertex(a)) || (b < v && isOpenVertex(b))) return;
			if (label_[a] == label_[b] && !isOpenVertex(a)) return;
			found.push_back({firstOpen + i, vertexOf(a), vertexOf(b)});
		});
	}

	/// Copies crease marks; both ends of a crease edge are vertices of open cells.
	void carryCreases(VoronoiDual& out) const
	{
		if (!m_.hasCreases()) return;
		HalfEdgeMesh& mesh = out.mesh;
		mesh.crease        = Buffer<char>(mesh.halfEdgeNum(), 0);
		workers_.forEach(mesh.halfEdgeNum(), [&](int h) {
			const int a = out.surfaceVertex[mesh.origin[h]];
			const int b = out.surfaceVertex[mesh.target(h)];
			if (a < 0 || b < 0 || !m_.isCreaseVertex(a)) return;
			const int edge = m_.findEdge(a, b);
			mesh.crease[h] = edge >= 0 && m_.crease[edge];
		});
	}

	/// Marks cells with a wrong border. Exactly the border samples must lie on the border, and
	/// every inner vertex needs three faces.
	bool markWrongBorders(const VoronoiDual& out)
	{
		const std::vector<int> wrong = workers_.collectIf(out.mesh.vertexNum, [&](int v) {
			return out.surfaceVertex[v] < 0 && !isBorderRight(out, v);
		});
		for (int v : wrong)
			bad_[out.label[v]] = 1;
		return wrong.empty();
	}

	bool isBorderRight(const VoronoiDual& out, int v) const
	{
		const int  s          = out.label[v];
		const int  standsFor  = s < sampling_.boundarySampleNum ? boundary_.samples[s].vertex : -1;
		const bool shouldBe   = standsFor >= 0 && m_.isBorderVertex(standsFor);
		const bool isOnBorder = out.mesh.isBorderVertex(v);
		return shouldBe == isOnBorder && (isOnBorder || out.mesh.valence(v) >= 3);
	}
};

} // namespace

VoronoiDual makeVoronoiDual(const Surface& surface, const Sampling& sampling,
							const BoundaryCurves& boundary, const MeshFigures& input,
							Workers& workers)
{
	return VoronoiDualBuilder(surface, sampling, boundary, workers).run(input);
}

} // namespace gpr
