// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_rounds.h"

#include "patch_changes.h"

#include <vcg_extras/core/mesh/components.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace gpr {

namespace {

/// Most rounds of patches round the remaining contacts.
constexpr int roundNum = 4;
/// Most tries of a patch.
constexpr int mostTries = 8;
/// Largest share of a component in a patch: beyond, making the whole component anew is as good.
constexpr double mostOfComponent = 0.75;
/// A component with at most this many faces may lie in a patch whole: so a speck is made anew
/// together with the part of a large component that it touches, and not with all of that component.
constexpr int smallComponent = 200;
/// Most looks at vertices of the working surface by tries that fail, over the number of its faces.
/// Tries that succeed look at each vertex a few times at most.
constexpr double mostLostWork = 1;
/// This many looks are allowed at any rate: two to five seconds. With half as many, more whole
/// components are made anew instead.
constexpr double leastLostWork = 600'000;

/// Work of flips and moves, see LocalSearch: of all patches of a turn, and the least and most of a
/// patch. Less work removes fewer contacts; more work took longer than making the patches anew.
constexpr std::int64_t workOfChanges = 16'000'000, leastOfPatch = 300'000, mostOfPatch = 2'000'000;

/// A patch by the corners of its faces; corners keep their names while other patches are filled.
struct Patch {
	std::vector<int> vertex; ///< ascending
	int              tries = 0;
};

/// Pairs of touching faces, in ascending order of the first face.
using Partners = std::vector<std::pair<int, int>>;

/// The outcome of a turn of a patch.
struct Try {
	FilledPart       filled;
	std::vector<int> grown; ///< faces of the whole, ascending, for another try
	double           work     = 0;
	bool             isFilled = false;
};

class Rounds {
public:
	Rounds(const MakingOfVertices& making, const InputContacts& ofInput, ResultMesh& result,
		   Workers& workers) :
			making_(making),
			ofInput_(ofInput), result_(result), workers_(workers),
			isLost_(std::size_t(result.mesh.vertexNum), 0)
	{
	}

	PatchOutcome run(std::vector<FacePair> pairs)
	{
		std::size_t before = pairs.size() + 1;
		for (int round = 0; round < roundNum && !pairs.empty() && pairs.size() < before; ++round) {
			before = pairs.size();
			findPatches(pairs, PatchFilling::ringsAround + round);
			fillAll();
			pairs = ofInput_.withoutInputs(result_.mesh, findTouchingPairs(result_.mesh, workers_));
		}
		outcome_.pairs = std::move(pairs);
		return std::move(outcome_);
	}

private:
	const MakingOfVertices& making_;
	const InputContacts&    ofInput_;
	ResultMesh&             result_;
	Workers&                workers_;
	std::vector<char>       isLost_; ///< per vertex: in a patch that was given up
	std::vector<Patch>      waiting_;
	PatchOutcome            outcome_;
	double                  lostWork_ = 0;

	void findPatches(const std::vector<FacePair>& pairs, int rings)
	{
		const HalfEdgeMesh& m = result_.mesh;
		std::vector<char>   marked(std::size_t(m.faceNum), 0);
		for (const FacePair& pair : pairs)
			marked[std::size_t(pair.first)] = marked[std::size_t(pair.second)] = 1;
		widenMarks(m, rings, marked);
		const Partners partners = partnersIn(pairs);
		for (int f = 0; f < m.faceNum; ++f) {
			if (!marked[std::size_t(f)]) continue;
			Patch patch;
			patch.vertex = verticesOf(m, takeConnected(f, partners, marked));
			if (!isLost(patch)) waiting_.push_back(std::move(patch));
		}
		std::stable_sort(waiting_.begin(), waiting_.end(), [](const Patch& a, const Patch& b) {
			return a.vertex.size() > b.vertex.size();
		});
	}

	bool isLost(const Patch& patch) const
	{
		return std::any_of(patch.vertex.begin(), patch.vertex.end(),
						   [&](int v) { return isLost_[std::size_t(v)] != 0; });
	}

	/// The pairs in both orders, ascending.
	static Partners partnersIn(const std::vector<FacePair>& pairs)
	{
		Partners partners;
		for (const FacePair& pair : pairs) {
			partners.push_back({pair.first, pair.second});
			partners.push_back({pair.second, pair.first});
		}
		std::sort(partners.begin(), partners.end());
		return partners;
	}

	/// The marked faces connected to f by vertices or by contacts; removes their marks. Touching
	/// walls are made anew together, so that each can follow the other.
	std::vector<int> takeConnected(int f, const Partners& partners, std::vector<char>& marked) const
	{
		std::vector<int> faces;
		const auto       take = [&](int g) {
            if (!marked[std::size_t(g)]) return;
            marked[std::size_t(g)] = 0;
            faces.push_back(g);
		};
		take(f);
		for (std::size_t i = 0; i < faces.size(); ++i) {
			const int face = faces[i];
			for (int h = 3 * face; h < 3 * face + 3; ++h)
				forEachOutgoing(result_.mesh, result_.mesh.origin[h], [&](int g) { take(g / 3); });
			auto pair = std::lower_bound(partners.begin(), partners.end(), std::pair(face, 0));
			for (; pair != partners.end() && pair->first == face; ++pair)
				take(pair->second);
		}
		return faces;
	}

	bool isExhausted() const
	{
		return lostWork_ >
			   std::max(leastLostWork, mostLostWork * double(making_.surface.mesh.faceNum));
	}

	/// Makes turns until no patch waits.
	void fillAll()
	{
		while (!waiting_.empty()) {
			workers_.poll();
			if (isExhausted()) {
				outcome_.isCapped = true;
				waiting_.clear();
				return;
			}
			fillSome();
		}
	}

	/// The faces between the vertices of a patch.
	std::vector<int> facesOf(const Patch& patch) const
	{
		std::vector<int> faces     = facesRound(result_.mesh, patch.vertex);
		const auto       isOutside = [&](int f) {
            const int* corner = &result_.mesh.origin[3 * f];
            return std::any_of(corner, corner + 3, [&](int v) {
                return !std::binary_search(patch.vertex.begin(), patch.vertex.end(), v);
            });
		};
		faces.erase(std::remove_if(faces.begin(), faces.end(), isOutside), faces.end());
		return faces;
	}

	/// Marks the faces as taken, unless some face, or a face next to these, is taken already.
	bool claim(const std::vector<int>& faces, std::vector<char>& isTaken) const
	{
		for (int f : widened(result_.mesh, faces, 1)) {
			if (isTaken[std::size_t(f)]) return false;
		}
		for (int f : faces)
			isTaken[std::size_t(f)] = 1;
		return true;
	}

	/// Fills the patches that do not have to wait for other patches.
	void fillSome()
	{
		std::vector<Patch>            now, later;
		std::vector<std::vector<int>> faces;
		std::vector<char>             isTaken(std::size_t(result_.mesh.faceNum), 0);
		const Components              components = findComponents(result_.mesh, workers_);
		const std::vector<int>        faceNum    = faceNumOf(components);
		for (Patch& patch : waiting_) {
			std::vector<int> own = facesOf(patch);
			if (own.empty()) continue;
			if (areMost(own, components, faceNum) || patch.tries >= mostTries) {
				giveUp(patch);
				continue;
			}
			if (!claim(widened(result_.mesh, own, ringsChanged), isTaken)) {
				later.push_back(std::move(patch));
				continue;
			}
			now.push_back(std::move(patch));
			faces.push_back(std::move(own));
		}
		waiting_ = std::move(later);
		const FaceBoxes    tree(result_.mesh, workers_);
		std::vector<Try>   tries(now.size());
		const std::int64_t work =
			std::clamp(workOfChanges / std::int64_t(now.size() + 1), leastOfPatch, mostOfPatch);
		workers_.forTasks(now.size(), [&](std::size_t i, int worker) {
			Workers inner(workers_, worker);
			fillOne(tree, faces[i], now[i].tries, work, inner, tries[i]);
		});
		take(now, tries);
	}

	void giveUp(const Patch& patch)
	{
		for (int v : patch.vertex)
			isLost_[std::size_t(v)] = 1;
	}

	/// Per component: the number of its faces.
	static std::vector<int> faceNumOf(const Components& components)
	{
		std::vector<int> num(std::size_t(components.num), 0);
		for (int c : components.ofFace)
			++num[std::size_t(c)];
		return num;
	}

	/// Whether a patch has most of the faces of a component that is not small.
	static bool areMost(const std::vector<int>& faces, const Components& components,
						const std::vector<int>& faceNum)
	{
		std::map<int, int> numOf;
		for (int f : faces)
			++numOf[components.ofFace[std::size_t(f)]];
		return std::any_of(numOf.begin(), numOf.end(), [&](const std::pair<const int, int>& num) {
			const int all = faceNum[std::size_t(num.first)];
			return all > smallComponent && num.second > int(mostOfComponent * all);
		});
	}

	void fillOne(const FaceBoxes& tree, const std::vector<int>& faces, int triesBefore,
				 std::int64_t work, Workers& inner, Try& out) const
	{
		PatchPart         part = cutPart(result_, tree, faces, triesBefore, inner);
		std::vector<char> marked;
		for (int f : part.face)
			marked.push_back(std::binary_search(faces.begin(), faces.end(), f));
		if (triesBefore == 0 &&
			changePatch(making_, ofInput_, part, marked, work, inner, out.filled)) {
			out.isFilled = true;
			out.grown    = faces;
			return;
		}
		PatchFilling filling(making_, part.result, inner);
		const bool   fits =
			filling.fill(marked, [&](const std::vector<char>& m) { return part.hasRoomFor(m); });
		out.work     = filling.work() + double(part.face.size());
		out.isFilled = fits && filling.isSound() && isBetter(part, filling, inner, marked);
		out.grown    = part.inWhole(marked);
		if (!out.isFilled) {
			const bool hasGrown = out.grown.size() > faces.size();
			out.grown = widened(result_.mesh, out.grown, triesBefore / 2 + (hasGrown ? 0 : 1));
			return;
		}
		out.filled.replaced = widened(result_.mesh, out.grown, ringsChanged);
		out.filled.filled   = filling.take();
		out.filled.part     = std::move(part);
	}

	/// Whether the patch has fewer contacts than before. Marks more faces if not.
	bool isBetter(const PatchPart& part, const PatchFilling& filling, Workers& inner,
				  std::vector<char>& marked) const
	{
		const std::vector<FacePair> left = ofInput_.othersIn(
			filling.mesh(), [&](int f) { return filling.isChanged(f); }, inner);
		if (left.empty()) return true;
		const std::vector<FacePair> before = ofInput_.othersIn(
			part.result.mesh, [&](int f) { return marked[std::size_t(f)] != 0; }, inner);
		if (left.size() < before.size()) return true;
		filling.markAround(left, marked);
		return false;
	}

	/// Puts filled patches back; the rest wait for another turn.
	void take(std::vector<Patch>& patches, std::vector<Try>& tries)
	{
		std::vector<FilledPart> filled;
		std::vector<char>       isTaken(std::size_t(result_.mesh.faceNum), 0);
		for (std::size_t i = 0; i < tries.size(); ++i) {
			if (!tries[i].isFilled) lostWork_ += tries[i].work;
			if (tries[i].isFilled && claim(tries[i].filled.replaced, isTaken)) {
				filled.push_back(std::move(tries[i].filled));
				continue;
			}
			patches[i].vertex = verticesOf(result_.mesh, tries[i].grown);
			if (!tries[i].isFilled) ++patches[i].tries;
			waiting_.push_back(std::move(patches[i]));
		}
		if (filled.empty()) return;
		std::vector<int> newIndex;
		putBack(filled, result_, newIndex);
		rename(newIndex);
	}

	void rename(const std::vector<int>& newIndex)
	{
		std::vector<char> isLost(std::size_t(result_.mesh.vertexNum), 0);
		for (std::size_t v = 0; v < newIndex.size(); ++v) {
			if (newIndex[v] >= 0) isLost[std::size_t(newIndex[v])] = isLost_[v];
		}
		isLost_ = std::move(isLost);
		for (Patch& patch : waiting_) {
			std::vector<int> renamed;
			for (int v : patch.vertex) {
				if (newIndex[std::size_t(v)] >= 0) renamed.push_back(newIndex[std::size_t(v)]);
			}
			patch.vertex = std::move(renamed);
		}
	}
};

} // namespace

PatchOutcome fillPatches(const MakingOfVertices& making, const InputContacts& ofInput,
						 const std::vector<FacePair>& pairs, ResultMesh& result, Workers& workers)
{
	return Rounds(making, ofInput, result, workers).run(pairs);
}

} // namespace gpr
