// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_rounds.h"

#include "face_sets.h"
#include "patch_changes.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/base/union_find.h>
#include <vcg_extras/core/edit/acceptance.h>
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

/// The least and most work of flips and moves of a patch.
constexpr std::int64_t leastOfPatch = 300'000, mostOfPatch = 2'000'000;

/// A patch by the corners of its faces; corners keep their names while other patches are filled.
struct Patch {
	std::vector<int> vertex; ///< ascending
	int              tries = 0;
};

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
			ofInput_(ofInput), result_(result), workers_(workers)
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
	std::vector<int>        lost_; ///< vertices of patches that were given up
	std::vector<Patch>      waiting_;
	PatchOutcome            outcome_;
	double                  lostWork_ = 0;

	/// Makes patches of the faces round the pairs. Faces are in the same patch if connected by
	/// vertices or by contacts: touching walls are made anew together, so that each can follow the
	/// other.
	void findPatches(const std::vector<FacePair>& pairs, int rings)
	{
		const HalfEdgeMesh&    m      = result_.mesh;
		const std::vector<int> faces  = widened(m, facesOf(pairs), rings);
		std::vector<int>       parent = numbersBelow(std::size_t(m.faceNum));
		std::vector<int>       faceAt(std::size_t(m.vertexNum), -1);
		for (int f : faces) {
			for (int h = 3 * f; h < 3 * f + 3; ++h) {
				int& first = faceAt[m.origin[h]];
				if (first < 0) first = f;
				joinSets(parent, first, f);
			}
		}
		for (const FacePair& pair : pairs)
			joinSets(parent, pair.first, pair.second);
		std::map<int, std::vector<int>> facesOfPatch; // by the first face
		for (int f : faces)
			facesOfPatch[rootOf(parent, f)].push_back(f);
		sortUnique(lost_);
		for (const auto& own : facesOfPatch) {
			Patch patch;
			patch.vertex = verticesOf(m, own.second);
			if (!isLost(patch)) waiting_.push_back(std::move(patch));
		}
		std::stable_sort(waiting_.begin(), waiting_.end(), [](const Patch& a, const Patch& b) {
			return a.vertex.size() > b.vertex.size();
		});
	}

	/// lost_ must be sorted.
	bool isLost(const Patch& patch) const
	{
		return std::any_of(patch.vertex.begin(), patch.vertex.end(),
						   [&](int v) { return placeIn(lost_, v) >= 0; });
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

	/// Marks the faces as taken, unless some face, or a face next to these, is taken already.
	bool claim(const std::vector<int>& faces, std::vector<char>& isTaken) const
	{
		for (int f : widened(result_.mesh, faces, 1)) {
			if (isTaken[f]) return false;
		}
		for (int f : faces)
			isTaken[f] = 1;
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
			std::vector<int> own = facesBetween(result_.mesh, patch.vertex);
			if (own.empty()) continue;
			if (areMost(own, components, faceNum) || patch.tries >= mostTries) {
				lost_.insert(lost_.end(), patch.vertex.begin(), patch.vertex.end());
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
		const std::int64_t work = std::clamp(
			workOf(Driver::Contacts) / std::int64_t(now.size() + 1), leastOfPatch, mostOfPatch);
		if (now.size() == 1) // all threads work in the patch
			fillOne(tree, faces.front(), now.front().tries, work, workers_, tries.front());
		else
			workers_.forTasks(now.size(), [&](std::size_t i, int worker) {
				Workers inner(workers_, worker);
				fillOne(tree, faces[i], now[i].tries, work, inner, tries[i]);
			});
		take(now, tries);
	}

	/// Per component: the number of its faces.
	static std::vector<int> faceNumOf(const Components& components)
	{
		std::vector<int> num(std::size_t(components.num), 0);
		for (int c : components.ofFace)
			++num[c];
		return num;
	}

	/// Whether a patch has most of the faces of a component that is not small.
	static bool areMost(const std::vector<int>& faces, const Components& components,
						const std::vector<int>& faceNum)
	{
		std::map<int, int> numOf;
		for (int f : faces)
			++numOf[components.ofFace[f]];
		return std::any_of(numOf.begin(), numOf.end(), [&](const std::pair<const int, int>& num) {
			const int all = faceNum[num.first];
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
		if (triesBefore == 0 && making_.finer == 1 &&
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
		const std::vector<FacePair> left =
			ofInput_.othersIn(filling.mesh(), filling.changed(), inner);
		if (left.empty()) return true;
		if (left.size() < ofInput_.othersIn(part.result.mesh, marked, inner).size()) return true;
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
			std::vector<int> grown = verticesOf(result_.mesh, tries[i].grown);
			// A whole component cannot grow, so that every try would end as this one.
			const bool isAll = grown == patches[i].vertex;
			if (!tries[i].isFilled) patches[i].tries += isAll ? mostTries : 1;
			patches[i].vertex = std::move(grown);
			waiting_.push_back(std::move(patches[i]));
		}
		if (filled.empty()) return;
		std::vector<int> newIndex;
		putBack(filled, result_, newIndex);
		rename(newIndex, lost_);
		for (Patch& patch : waiting_)
			rename(newIndex, patch.vertex);
	}

	/// Old vertices keep their order.
	static void rename(const std::vector<int>& newIndex, std::vector<int>& vertices)
	{
		std::vector<int> left;
		for (int v : vertices) {
			if (newIndex[v] >= 0) left.push_back(newIndex[v]);
		}
		vertices = std::move(left);
	}
};

} // namespace

PatchOutcome fillPatches(const MakingOfVertices& making, const InputContacts& ofInput,
						 const std::vector<FacePair>& pairs, ResultMesh& result, Workers& workers)
{
	return Rounds(making, ofInput, result, workers).run(pairs);
}

} // namespace gpr
