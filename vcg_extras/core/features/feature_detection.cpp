// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_detection.h"

#include "boundary_curves.h"
#include "feature_strength.h"

#include <vcg_extras/core/mesh/face_quality.h>
#include <vcg_extras/core/surface/surface_ray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gpr {

namespace {

/// The largest support over the square root of the area. Unlike the size of the bounding box, the
/// area does not change when the surface is turned.
constexpr float largestSupport = 0.05f;
/// A side counts as round if an edge there has at least this share of the strength of the edge at
/// hand.
constexpr float plateauShare = 0.7f;
constexpr int   maxCrossings = 256;
/// The dihedral angle must be at least this share of the strength for a crease of the mesh. Below,
/// the mesh only goes round a bend of the shape.
constexpr float creaseShare = 0.5f;
/// A line turns by at least this at a corner, seen from a support away on either side.
constexpr float cornerTurnDeg = 50;
constexpr float cornerShare   = 0.7f;
/// A gap is bridged along edges that turn by at most 60°.
constexpr float bridgeCosine = 0.5f;

/// A detection. Its parts are written in the order in which they run.
class Detection {
public:
	Detection(HalfEdgeMesh& mesh, const FeatureThresholds& thresholds, Workers& workers,
			  FeatureEdges& out) :
			m_(mesh),
			thresholds_(thresholds), workers_(workers), out_(out)
	{
	}

	void run()
	{
		measure();
		findCandidates();
		bridgeGaps();
		pruneSpurs();
		keepStrongLines();
		markCorners();
		markConeApexes();
	}

private:
	HalfEdgeMesh&            m_;
	const FeatureThresholds& thresholds_;
	Workers&                 workers_;
	FeatureEdges&            out_;
	Buffer<float>            sharpness_; ///< per half-edge, degrees
	Buffer<float>            dihedral_;  ///< per half-edge, degrees
	std::vector<int>         marked_;    ///< one half of each marked edge, ascending at first

	// ---- strength

	void measure()
	{
		EdgeDifferences d = edgeDifferences(m_, out_.support, workers_);
		out_.edgeStrength.swap(d.supported);
		out_.cappedRayNum = d.cappedRayNum;
		dihedral_.swap(d.dihedral);
		measureSharpness();
		out_.vertexStrength.reset(m_.vertexNum);
		workers_.forEach(m_.vertexNum, [&](int v) {
			float strongest = 0;
			forEachOutgoing(m_, v,
							[&](int h) { strongest = std::max(strongest, out_.edgeStrength[h]); });
			out_.vertexStrength[v] = strongest;
		});
	}

	/// Candidates compete by sharpness. The strength of a crease is also felt beside it, up to a
	/// support away; the dihedral angle tells whether the crease lies in this very edge.
	void measureSharpness()
	{
		sharpness_.reset(m_.halfEdgeNum());
		workers_.forEach(m_.halfEdgeNum(), [&](int h) {
			const float s = out_.edgeStrength[h];
			sharpness_[h] = 0.5f * (s + std::min(s, dihedral_[h]));
		});
	}

	bool isCrease(int h) const { return dihedral_[h] >= creaseShare * out_.edgeStrength[h]; }

	// ---- candidates

	void findCandidates()
	{
		m_.crease.reset(m_.halfEdgeNum());
		workers_.forEach(m_.halfEdgeNum(), [&](int h) {
			m_.crease[h] = m_.opposite[h] >= 0 && isCandidate(std::min(h, m_.opposite[h]));
		});
		marked_ = workers_.collectIf(
			m_.halfEdgeNum(), [&](int h) { return m_.isCreaseEdge(h) && m_.opposite[h] > h; });
	}

	/// Whether h is a crease of the mesh, sharper than weakDeg and the sharpest across. If the
	/// dihedral angle is above strongDeg, only edges of the same two faces compete, so that two
	/// creases may lie closer than a support. Otherwise all edges within half a support compete, so
	/// that a crease rounded off over several edges becomes one line, and a side must be flatter.
	bool isCandidate(int h) const
	{
		if (sharpness_[h] < float(thresholds_.weakDeg) || !isCrease(h)) return false;
		const int other = m_.opposite[h];
		if (!isSharpestBeside(h) || !isSharpestBeside(other)) return false;
		if (dihedral_[h] >= float(thresholds_.strongDeg)) return true;
		const Beyond here = lookBeyond(h, h), there = lookBeyond(other, h);
		return !here.isSharper && !there.isSharper && !(here.isRound && there.isRound);
	}

	bool isSharper(int h, int than) const
	{
		if (sharpness_[h] != sharpness_[than]) return sharpness_[h] > sharpness_[than];
		return std::min(h, m_.opposite[h]) < std::min(than, m_.opposite[than]);
	}

	/// Whether h is the sharpest edge of its face, among edges that run beside h rather than away.
	bool isSharpestBeside(int h) const
	{
		for (int other : {nextInFace(h), prevInFace(h)}) {
			if (m_.opposite[other] < 0 || !isSharper(other, h)) continue;
			const float cosine =
				dot(normalized(m_.edgeVector(h)), normalized(m_.edgeVector(other)));
			if (std::abs(cosine) > besideCosine) return false;
		}
		return true;
	}

	/// Edges within 60° of each other run side by side; edges that meet at a larger angle do not
	/// compete.
	static constexpr float besideCosine = 0.5f;

	/// The findings of a look across an edge, on one side.
	struct Beyond {
		bool isSharper = false; ///< an edge within half a support is sharper
		bool isRound   = false; ///< an edge further away is about as strong: the surface is round
	};

	Beyond lookBeyond(int start, int h) const
	{
		Beyond      seen;
		const float wanted = plateauShare * out_.edgeStrength[h];
		const auto  look   = [&](int edge, float distance) {
            if (m_.opposite[edge] < 0) return;
            if (distance < 0.5f * out_.support) {
                if (isSharper(edge, h)) seen.isSharper = true;
            }
            else if (out_.edgeStrength[edge] >= wanted) {
                seen.isRound = true;
            }
		};
		traceRay(m_, start, {0, 1}, out_.support, maxCrossings, look);
		return seen;
	}

	// ---- linking

	void mark(int h)
	{
		m_.crease[h] = m_.crease[m_.opposite[h]] = 1;
		marked_.push_back(std::min(h, m_.opposite[h]));
	}

	void unmark(int h) { m_.crease[h] = m_.crease[m_.opposite[h]] = 0; }

	void dropUnmarked()
	{
		const auto isGone = [&](int h) { return !m_.isCreaseEdge(h); };
		marked_.erase(std::remove_if(marked_.begin(), marked_.end(), isGone), marked_.end());
	}

	/// Continues each line from its end along the strongest edges ahead, and marks the path if it
	/// reaches another line within a support.
	void bridgeGaps()
	{
		const std::size_t num = marked_.size();
		for (std::size_t i = 0; i < num; ++i) {
			const int h = marked_[i];
			for (int last : {h, m_.opposite[h]}) {
				if (m_.creaseNum(m_.target(last)) != 1) continue;
				for (int step : bridgeFrom(last))
					mark(step);
			}
		}
	}

	/// The path from the end of half-edge `last` to another marked edge; empty if there is none.
	std::vector<int> bridgeFrom(int last) const
	{
		std::vector<int> path;
		float            lengthLeft = out_.support;
		for (int next = bestStep(last); next >= 0; next = bestStep(next)) {
			lengthLeft -= m_.edgeLength(next);
			if (lengthLeft < 0) break;
			path.push_back(next);
			if (m_.creaseNum(m_.target(next)) > 0) return path;
		}
		return {};
	}

	/// The sharpest edge ahead; -1 if no edge ahead is as strong as weakDeg.
	int bestStep(int last) const
	{
		const Vec3f direction = normalized(m_.edgeVector(last));
		float       best      = float(thresholds_.weakDeg) * bridgeCosine;
		int         step      = -1;
		forEachOutgoing(m_, m_.target(last), [&](int h) {
			if (m_.opposite[h] < 0 || out_.edgeStrength[h] < float(thresholds_.weakDeg)) return;
			const float cosine = dot(direction, normalized(m_.edgeVector(h)));
			if (cosine < bridgeCosine || sharpness_[h] * cosine <= best) return;
			best = sharpness_[h] * cosine;
			step = h;
		});
		return step;
	}

	/// Drops branches with a free end that are shorter than a support.
	void pruneSpurs()
	{
		for (int h : marked_) {
			for (int first : {h, m_.opposite[h]}) {
				if (!m_.isCreaseEdge(h) || m_.creaseNum(m_.origin[first]) != 1) continue;
				for (int step : spurFrom(first))
					unmark(step);
			}
		}
		dropUnmarked();
	}

	/// The line from half-edge `first`, at a free end, to a fork; empty if no fork is within a
	/// support.
	std::vector<int> spurFrom(int first) const
	{
		std::vector<int> path;
		float            lengthLeft = out_.support;
		for (int h = first; h >= 0; h = nextOnLine(h)) {
			path.push_back(h);
			lengthLeft -= m_.edgeLength(h);
			if (lengthLeft < 0) break;
			if (m_.creaseNum(m_.target(h)) > 2) return path;
		}
		return {};
	}

	/// The next half-edge of the line; -1 at its end or at a fork.
	int nextOnLine(int h) const
	{
		return m_.creaseNum(m_.target(h)) == 2 ? nextOnCrease(m_, h) : -1;
	}

	// ---- lines

	/// Hysteresis: connected candidates stay if at least one is strong and their total length is
	/// enough.
	void keepStrongLines()
	{
		for (const std::vector<int>& line : connectedLines(m_, marked_)) {
			if (isKept(line)) {
				++out_.figures.lineNum;
				continue;
			}
			for (int h : line)
				unmark(h);
		}
		dropUnmarked();
		out_.figures.edgeNum = std::int64_t(marked_.size());
	}

	bool isKept(const std::vector<int>& line) const
	{
		float strongest = 0, lineLength = 0;
		for (int h : line) {
			strongest = std::max(strongest, sharpness_[h]);
			lineLength += m_.edgeLength(h);
		}
		return strongest >= float(thresholds_.strongDeg) && lineLength >= out_.minLength;
	}

	// ---- vertices

	void markCorners()
	{
		out_.vertexFeature = Buffer<std::uint8_t>(m_.vertexNum, 0);
		Buffer<float> turn(m_.vertexNum, 0);
		for (int h : marked_) {
			for (int v : {m_.origin[h], m_.target(h)}) {
				out_.vertexFeature[v] = OnFeatureLine;
				turn[v]               = m_.creaseNum(v) == 2 ? turnAt(v) : 180;
			}
		}
		for (int h : marked_) {
			for (int v : {m_.origin[h], m_.target(h)}) {
				if (out_.vertexFeature[v] & FeatureCorner || !isCorner(v, turn)) continue;
				out_.vertexFeature[v] |= FeatureCorner;
				++out_.figures.cornerNum;
			}
		}
	}

	std::array<int, 2> markedPairAt(int v) const
	{
		std::array<int, 2> pair{-1, -1};
		int                n = 0;
		forEachOutgoing(m_, v, [&](int h) {
			if (m_.isCreaseEdge(h) && n < 2) pair[n++] = h;
		});
		return pair;
	}

	/// The turn of a line at v, degrees. 0 on a round bend: there the turn seen from half a support
	/// away is much less than the turn seen from a support.
	float turnAt(int v) const
	{
		const std::array<int, 2> pair   = markedPairAt(v);
		const auto               turnOf = [&](float reach) {
            return 180 - angleDegBetween(chordFrom(pair[0], reach), chordFrom(pair[1], reach));
		};
		const float near = turnOf(0.5f * out_.support), far = turnOf(out_.support);
		return near < cornerShare * far ? 0 : std::min(near, far);
	}

	Vec3f chordFrom(int first, float reach) const
	{
		return m_.position[lineFrom(first, reach).back()] - m_.position[m_.origin[first]];
	}

	/// The vertices of a line up to the first vertex `reach` away, without the first one.
	std::vector<int> lineFrom(int first, float reach) const
	{
		std::vector<int> line;
		float            distance = 0;
		for (int h = first; h >= 0; h = nextOnLine(h)) {
			distance += m_.edgeLength(h);
			line.push_back(m_.target(h));
			if (distance >= reach || m_.target(h) == m_.origin[first]) break;
		}
		return line;
	}

	bool isCorner(int v, const Buffer<float>& turn) const
	{
		if (m_.creaseNum(v) != 2) return true;
		if (turn[v] < cornerTurnDeg) return false;
		for (int first : markedPairAt(v)) {
			for (int w : lineFrom(first, out_.support)) {
				if (turn[w] > turn[v] || (turn[w] == turn[v] && w < v)) return false;
			}
		}
		return true;
	}

	// ---- cone apexes

	/// A cone apex has no crease: its faces do not close a full turn.
	void markConeApexes()
	{
		Buffer<float> defect(m_.vertexNum, 0);
		workers_.forEach(m_.vertexNum, [&](int v) {
			if (out_.vertexStrength[v] >= float(thresholds_.strongDeg) && !m_.isBorderVertex(v)) {
				defect[v] = defectAbout(v);
			}
		});
		for (int v = 0; v < m_.vertexNum; ++v) {
			if (defect[v] < float(thresholds_.strongDeg) || !isConeApex(v, defect)) continue;
			out_.vertexFeature[v] |= FeatureConeApex;
			out_.vertexStrength[v] = std::min(180.0f, std::max(out_.vertexStrength[v], defect[v]));
			++out_.figures.coneApexNum;
		}
	}

	/// Calls visit for the vertices nearer to v than `reach`, v included, along edges; bounded.
	template <class Visit>
	void forEachNear(int v, float reach, const Visit& visit) const
	{
		constexpr std::size_t most = 256; // needles could bring in any number
		std::vector<int>      near{v};
		for (std::size_t i = 0; i < near.size(); ++i) {
			visit(near[i]);
			forEachNeighbour(m_, near[i], [&](int w) {
				const bool isNear = length(m_.position[w] - m_.position[v]) < reach;
				if (!isNear || near.size() >= most) return;
				if (std::find(near.begin(), near.end(), w) == near.end()) near.push_back(w);
			});
		}
	}

	/// Sum of the angle defects within half a support, degrees. Bumps of noise cancel out in the
	/// sum.
	float defectAbout(int v) const
	{
		float sum = 0;
		forEachNear(v, 0.5f * out_.support, [&](int w) { sum += defectOf(w); });
		return sum;
	}

	float defectOf(int v) const
	{
		if (m_.isBorderVertex(v)) return 0;
		float angles = 0;
		forEachOutgoing(m_, v, [&](int h) {
			const Vec3f p = m_.position[v];
			angles += angleDegBetween(m_.position[m_.target(h)] - p, m_.position[m_.apex(h)] - p);
		});
		return 360 - angles;
	}

	bool isConeApex(int v, const Buffer<float>& defect) const
	{
		bool isLargest = true, isFree = true;
		forEachNear(v, out_.support, [&](int w) {
			if (out_.vertexFeature[w] & OnFeatureLine) isFree = false;
			if (defect[w] > defect[v] || (defect[w] == defect[v] && w < v)) isLargest = false;
		});
		return isLargest && isFree;
	}
};

} // namespace

float meanEdgeLength(const IndexedMesh& mesh, Workers& workers)
{
	const double sum = workers.sumEach<double>(mesh.faceNum, [&](int f, double& part) {
		const int*  t = &mesh.triangle[3 * f];
		const Vec3f a = mesh.position[t[0]], b = mesh.position[t[1]], c = mesh.position[t[2]];
		part += double(length(b - a)) + double(length(c - b)) + double(length(a - c));
	});
	return mesh.faceNum > 0 ? float(sum / (3.0 * mesh.faceNum)) : 0;
}

FeatureEdges findFeatures(const FeatureThresholds& thresholds, float meanEdge, Workers& workers,
						  Surface& surface)
{
	FeatureEdges out;
	const float  wanted  = float(thresholds.support) * meanEdge;
	const float  largest = largestSupport * float(std::sqrt(surfaceArea(surface.mesh, workers)));
	out.support          = std::min(wanted, largest);
	out.supportCut       = wanted > largest;
	out.minLength        = float(thresholds.minLength) * out.support;
	Detection(surface.mesh, thresholds, workers, out).run();
	return out;
}

} // namespace gpr
