// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_removal.h"

#include "cube_decimation.h"
#include "face_sets.h"
#include "guarded_relaxation.h"
#include "input_contacts.h"
#include "patch_rounds.h"

#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/mesh/components.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// A contact of the result nearer than this to a contact of the input, in edges, comes from the
/// input.
constexpr float nearInputs = 1.5f;
/// With fewer vertices patches hardly ever fit.
constexpr int leastForPatches = 100;

/// Appends a mesh without dead faces.
void append(const HalfEdgeMesh& from, HalfEdgeMesh& to)
{
	const int vertexNum = to.vertexNum, halfEdgeNum = to.halfEdgeNum();
	to.vertexNum += from.vertexNum;
	to.faceNum += from.faceNum;
	reserve(to, to.vertexNum, to.faceNum);
	for (int v = 0; v < from.vertexNum; ++v) {
		to.position[vertexNum + v] = from.position[v];
		to.outgoing[vertexNum + v] = halfEdgeNum + from.outgoing[v];
	}
	for (int h = 0; h < from.halfEdgeNum(); ++h) {
		to.origin[halfEdgeNum + h]   = vertexNum + from.origin[h];
		to.opposite[halfEdgeNum + h] = from.isBorderEdge(h) ? -1 : halfEdgeNum + from.opposite[h];
	}
}

/// Makes components of the result anew.
class Replacement {
public:
	/// faces: of the result; their components are made anew.
	Replacement(const MakingOfVertices& making, const std::vector<int>& faces, ResultMesh& result,
				Workers& workers) :
			making_(making),
			result_(result), workers_(workers),
			ofInput_(findComponents(making.surface.mesh, workers)),
			ofResult_(findComponents(result.mesh, workers)), isTaken_(std::size_t(ofInput_.num), 0),
			isLeft_(std::size_t(ofResult_.num), 1)
	{
		takeComponents(faces);
	}

	/// Makes the components anew if possible.
	ContactOutcome run()
	{
		decimate();
		const std::int64_t before  = result_.mesh.vertexNum;
		const std::int64_t reached = made_.guarded->mesh.vertexNum;
		if (reached > before && hadContacts_) return {before}; // no promise for such an input
		if (reached > before && !making_.mayEndAbove) return {reached, true};
		// Degenerate faces of the input have contacts of their neighbours: no promise there either.
		if (!relax()) return {before};
		if (hasNewContacts()) return {before, true};
		Filled filled  = takeFilled(making_.surface, result_, made_);
		result_.mesh   = std::move(filled.mesh);
		result_.vertex = std::move(filled.vertex);
		return {reached};
	}

private:
	const MakingOfVertices& making_;
	ResultMesh&             result_;
	Workers&                workers_;
	Components              ofInput_, ofResult_;
	std::vector<char>       isTaken_; ///< per component of the input: to be coarsened
	std::vector<char>       isLeft_;  ///< per component of the result: to be left
	RefilledMesh            made_;    ///< the combined mesh
	bool hadContacts_ = false;        ///< the taken components of the input had contacts

	/// With sizes by the error, distance counts more than length.
	double lengthWeight() const { return 0.01 * portable::pow(0.03, making_.adapt); }

	/// Takes the components of the given faces of the result. Each component of the result lies on
	/// a component of the input.
	void takeComponents(const std::vector<int>& faces)
	{
		const auto inputOf = [&](int f) {
			const int v = result_.mesh.origin[3 * f];
			return ofInput_.ofFace[result_.vertex[v].point.face];
		};
		for (int f : faces)
			isTaken_[inputOf(f)] = 1;
		for (int f = 0; f < result_.mesh.faceNum; ++f) {
			if (isTaken_[inputOf(f)]) isLeft_[ofResult_.ofFace[f]] = 0;
		}
	}

	/// Collapses edges until the number of vertices is the result's, or no collapse is possible.
	void decimate()
	{
		HalfEdgeMesh together = putTogether();
		made_.guarded = std::make_unique<GuardedMesh>(std::move(together), hadContacts_, &workers_);
		fixVertices();
		decimateGuarded(settingsFor(making_, result_, lengthWeight()), *made_.guarded, workers_);
	}

	/// Makes the decimated mesh more regular. False if degenerate faces are left, as between fixed
	/// vertices.
	bool relax()
	{
		GuardedMesh& guarded = *made_.guarded;
		relaxGuarded(double(result_.idealEdge), making_.mayLeaveSurface, guarded, workers_);
		return zeroAreaFaceNum(guarded.mesh, workers_) == 0;
	}

	/// Whether collapses have made contacts: a kept border counts more than contacts.
	bool hasNewContacts() const
	{
		return result_.keepsBorder && !hadContacts_ &&
			   !findTouchingPairs(made_.guarded->mesh, workers_).empty();
	}

	std::vector<int> facesIn(const Components& components, const std::vector<char>& wanted) const
	{
		return workers_.collectIf(components.ofFace.size(),
								  [&](int f) { return wanted[components.ofFace[f]] != 0; });
	}

	/// Combines the parts. Components of the result in contact with taken components of the input
	/// are taken as well.
	HalfEdgeMesh putTogether()
	{
		while (true) {
			const std::vector<int> taken = facesIn(ofInput_, isTaken_);
			const std::vector<int> left  = facesIn(ofResult_, isLeft_);
			const std::vector<int> kept  = verticesOf(result_.mesh, left);
			made_.inputVertex            = verticesOf(making_.surface.mesh, taken);
			HalfEdgeMesh m               = cutOut(making_.surface.mesh, taken, made_.inputVertex);
			hadContacts_                 = !findTouchingFaces(m, workers_, Seams::Apart).empty();
			made_.resultVertex.assign(std::size_t(m.vertexNum), -1);
			made_.resultVertex.insert(made_.resultVertex.end(), kept.begin(), kept.end());
			append(cutOut(result_.mesh, left, kept), m);
			made_.inputVertex.resize(std::size_t(m.vertexNum), -1);
			if (left.empty()) return m;
			std::vector<char> ofResult(std::size_t(m.faceNum), 1);
			std::fill_n(ofResult.begin(), taken.size(), char(0));
			const std::vector<FacePair> pairs =
				findTouchingPairs(m, workers_, Seams::Joined, ofResult);
			if (!takeTouching(pairs, int(taken.size()), left)) return m;
		}
	}

	/// Takes the components in contact; the faces of `left` follow inputFaces faces of the input.
	/// False if there are no such components.
	bool takeTouching(const std::vector<FacePair>& pairs, int inputFaces,
					  const std::vector<int>& left)
	{
		std::vector<int> faces;
		for (const FacePair& pair : pairs) {
			if (pair.first < inputFaces) faces.push_back(left[pair.second - inputFaces]);
		}
		takeComponents(faces);
		return !faces.empty();
	}

	void fixVertices()
	{
		for (std::size_t v = 0; v < made_.inputVertex.size(); ++v) {
			const int inInput = made_.inputVertex[v];
			made_.guarded->vertex[v].isFixed =
				inInput < 0 ||
				std::binary_search(making_.kept.begin(), making_.kept.end(), inInput);
		}
	}
};

/// The contacts of the input near contacts of the result.
InputContacts contactsOfInput(const MakingOfVertices& making, const std::vector<FacePair>& pairs,
							  const ResultMesh& result, Workers& workers)
{
	return {making.surface.mesh, result.mesh, pairs, nearInputs * result.idealEdge, workers};
}

/// Remakes patches around the contacts, then whole components.
ContactOutcome makeAnew(const MakingOfVertices& making, const InputContacts& ofInput,
						std::vector<FacePair> pairs, ResultMesh& result, Workers& workers)
{
	bool isCapped = false;
	if (result.mesh.vertexNum >= leastForPatches) {
		PatchOutcome patches = fillPatches(making, ofInput, pairs, result, workers);
		pairs                = std::move(patches.pairs);
		isCapped             = patches.isCapped;
	}
	ContactOutcome outcome{result.mesh.vertexNum};
	// Whole sheets made anew would lose their junctions with other sheets.
	outcome.isRefused = !pairs.empty() && result.mesh.meetsAtPlaces;
	if (!pairs.empty() && !result.mesh.meetsAtPlaces)
		outcome = Replacement(making, facesOf(pairs), result, workers).run();
	outcome.isCapped = isCapped;
	return outcome;
}

/// The vertices of the whole mesh made by the guard.
std::int64_t madeNum(const ResultMesh& result)
{
	std::int64_t num = 0;
	for (std::size_t v = 0; v < result.vertex.size(); ++v)
		num += result.vertex[v].isMade ? result.mesh.multiplicity(result.mesh.position[v]) : 0;
	return num;
}

} // namespace

ContactOutcome removeContacts(const MakingOfVertices& making, ResultMesh& result,
							  GuardedFigures& figures, Workers& workers)
{
	const std::vector<FacePair> pairs = findTouchingPairs(result.mesh, workers);
	ContactOutcome              outcome{result.mesh.vertexNum};
	figures.isTested = true;
	figures.pairNum  = std::int64_t(pairs.size());
	figures.foundPairNum += figures.pairNum;
	if (figures.vertexNum > 0) figures.vertexNum = madeNum(result); // changed since the last call
	if (pairs.empty()) return outcome;
	const InputContacts ofInput        = contactsOfInput(making, pairs, result, workers);
	figures.inputFaceNum               = ofInput.faceNum();
	const std::vector<FacePair> others = ofInput.withoutInputs(result.mesh, pairs);
	if (others.empty()) return outcome;
	outcome = makeAnew(making, ofInput, others, result, workers);
	if (outcome.isRefused) return outcome;
	figures.vertexNum = madeNum(result);
	figures.pairNum   = std::int64_t(findTouchingPairs(result.mesh, workers).size());
	return outcome;
}

bool makeFiner(MakingOfVertices making, const std::vector<int>& faces, ResultMesh& result,
			   Workers& workers)
{
	constexpr int finer = 3;
	making.finer        = finer;
	std::vector<FacePair> places; // a patch round each face
	places.reserve(faces.size());
	for (int f : faces)
		places.emplace_back(f, f);
	const InputContacts ofInput =
		contactsOfInput(making, findTouchingPairs(result.mesh, workers), result, workers);
	return !fillPatches(making, ofInput, places, result, workers).isCapped;
}

} // namespace gpr
