// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_changes.h"

#include "face_sets.h"

#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/optimization/face_goals.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace gpr {

namespace {

/// Least work for a contact. Patches with more contacts than the work allows stay as they are:
/// with less work, flips and moves seldom remove all contacts, and the patch is made anew after
/// all.
constexpr std::int64_t workOfContact = 50'000;

/// Per face: whether its corners are others than before, or in other places.
std::vector<char> changedFaces(const HalfEdgeMesh& before, const HalfEdgeMesh& now)
{
	std::vector<char> isChanged(std::size_t(now.faceNum), 0);
	for (int h = 0; h < now.halfEdgeNum(); ++h) {
		const int v = now.origin[h];
		if (v != before.origin[h] || !(now.position[v] == before.position[v])) isChanged[h / 3] = 1;
	}
	return isChanged;
}

/// Whether all changes are where the patch may change: in the marked faces and some rings round.
bool staysWithin(const HalfEdgeMesh& before, const std::vector<char>& marked,
				 const std::vector<char>& isChanged)
{
	const std::vector<int> faces   = widened(before, markedFaces(marked), ringsChanged);
	const std::vector<int> changed = markedFaces(isChanged);
	return std::includes(faces.begin(), faces.end(), changed.begin(), changed.end());
}

} // namespace

bool changePatch(const MakingOfVertices& making, const InputContacts& ofInput, PatchPart& part,
				 const std::vector<char>& marked, std::int64_t work, Workers& workers,
				 FilledPart& out)
{
	const auto isMarked = [&](int f) { return marked[f] != 0; };
	const auto contacts = [&](const HalfEdgeMesh& m) {
		return ofInput.othersIn(m, marked, workers).size();
	};
	const HalfEdgeMesh& before = part.result.mesh;
	const std::size_t   num    = contacts(before);
	if (num == 0 || std::int64_t(num) * workOfContact > work) return false;

	ResultMesh  changed = copyResult(part.result, workers);
	LocalSearch search(making.surface, making.curves, nullptr, work, changed, workers);
	Goal        goal = facesInContact(
			   search, [&](int f) { return isMarked(f) && !ofInput.isNear(changed.mesh, f); });
	for (const bool inPairs : {false, true}) {
		goal.inPairs = inPairs;
		search.run(goal);
	}
	const std::vector<char> isChanged = changedFaces(before, changed.mesh);
	if (contacts(changed.mesh) >= num || !staysWithin(before, marked, isChanged)) return false;

	out.replaced         = part.inWhole(isChanged);
	out.filled.mesh      = std::move(changed.mesh);
	out.filled.vertex    = std::move(changed.vertex);
	out.filled.oldVertex = numbersBelow(part.vertex.size());
	out.part             = std::move(part);
	return true;
}

} // namespace gpr
