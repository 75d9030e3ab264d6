// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_removal.h"

#include "guarded_decimation.h"
#include "guarded_relaxation.h"
#include "input_contacts.h"
#include "made_vertex.h"
#include "patch_rounds.h"

#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/mesh/components.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/mesh/mesh_edit.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// A contact of the result nearer than this to a contact of the input, in edges, comes from the
/// input.
constexpr float nearInputs = 1.5f;
/// With fewer vertices patches hardly ever fit.
constexpr int leastForPatches = 100;

/// The parts of the mesh for decimation: components of the input, to be coarsened, and the
/// remaining components of the result.
struct Parts {
	Components        ofInput, ofResult;
	std::vector<char> isTaken; ///< per component of the input
	std::vector<char> isLeft;  ///< per component of the result
};

/// Takes the components of the given faces of the result. Each component of the result lies on a
/// component of the input.
void takeComponents(const ResultMesh& result, const std::vector<int>& faces, Parts& parts)
{
	const auto inputOf = [&](int f) {
		const int v = result.mesh.origin[3 * f];
		return parts.ofInput.ofFace[std::size_t(result.vertex[std::size_t(v)].point.face)];
	};
	for (int f : faces)
		parts.isTaken[std::size_t(inputOf(f))] = 1;
	for (int f = 0; f < result.mesh.faceNum; ++f) {
		if (parts.isTaken[std::size_t(inputOf(f))])
			parts.isLeft[std::size_t(parts.ofResult.ofFace[std::size_t(f)])] = 0;
	}
}

Parts chooseParts(const Surface& surface, const ResultMesh& result, const std::vector<int>& faces,
				  Workers& workers)
{
	Parts parts;
	parts.ofInput  = findComponents(surface.mesh, workers);
	parts.ofResult = findComponents(result.mesh, workers);
	parts.isTaken.assign(std::size_t(parts.ofInput.num), 0);
	parts.isLeft.assign(std::size_t(parts.ofResult.num), 1);
	takeComponents(result, faces, parts);
	return parts;
}

/// Appends the faces of the wanted components. newIndex: new names of vertices; -1 for vertices of
/// other components.
void append(const HalfEdgeMesh& from, const Components& components, const std::vector<char>& wanted,
			HalfEdgeMesh& to, std::vector<int>& newIndex)
{
	const auto isWanted = [&](int f) {
		return wanted[std::size_t(components.ofFace[std::size_t(f)])] != 0;
	};
	newIndex.assign(std::size_t(from.vertexNum), -1);
	std::vector<int> newFace(std::size_t(from.faceNum), -1);
	int              faceNum = to.faceNum, vertexNum = to.vertexNum;
	for (int f = 0; f < from.faceNum; ++f) {
		if (isWanted(f)) newFace[std::size_t(f)] = faceNum++;
	}
	for (int v = 0; v < from.vertexNum; ++v) {
		if (from.outgoing[v] >= 0 && isWanted(from.outgoing[v] / 3))
			newIndex[std::size_t(v)] = vertexNum++;
	}
	reserve(to, vertexNum, faceNum);
	const auto renamed = [&](int h) {
		return h < 0 ? -1 : 3 * newFace[std::size_t(h / 3)] + h % 3;
	};
	for (int h = 0; h < from.halfEdgeNum(); ++h) {
		if (newFace[std::size_t(h / 3)] < 0) continue;
		to.origin[renamed(h)]   = newIndex[std::size_t(from.origin[h])];
		to.opposite[renamed(h)] = renamed(from.opposite[h]);
	}
	for (int v = 0; v < from.vertexNum; ++v) {
		const int w = newIndex[std::size_t(v)];
		if (w < 0) continue;
		to.position[w] = from.position[v];
		to.outgoing[w] = renamed(from.outgoing[v]);
	}
	to.faceNum   = faceNum;
	to.vertexNum = vertexNum;
}

/// Makes components of the result anew.
class Replacement {
public:
	Replacement(const MakingOfVertices& making, ResultMesh& result, Parts parts, Workers& workers) :
			making_(making), result_(result), workers_(workers), parts_(std::move(parts))
	{
	}

	/// Collapses edges until the number of vertices is the result's, or no collapse is possible.
	void decimate()
	{
		HalfEdgeMesh together = putTogether();
		guarded_              = std::make_unique<GuardedMesh>(std::move(together), hadContacts_);
		fixVertices();
		GuardedSettings settings;
		settings.targetNum        = result_.mesh.vertexNum;
		settings.keepsBorder      = result_.keepsBorder;
		settings.idealEdge        = double(result_.idealEdge);
		settings.lengthWeight     = lengthWeight();
		settings.mayLeaveVertices = making_.mayLeaveSurface;
		decimateGuarded(settings, *guarded_, workers_);
	}

	std::int64_t reached() const { return guarded_->mesh.vertexNum; }
	/// Whether the taken components of the input had contacts.
	bool hadContacts() const { return hadContacts_; }

	/// Makes the decimated mesh more regular. False if degenerate faces are left, as between fixed
	/// vertices.
	bool relax()
	{
		relaxGuarded(double(result_.idealEdge), making_.mayLeaveSurface, *guarded_, workers_);
		return zeroAreaFaceNum(guarded_->mesh, workers_) == 0;
	}

	/// Replaces the result by the decimated mesh.
	void take()
	{
		const std::vector<int>    ofAnchor = invertedNames();
		std::vector<ResultVertex> vertex(std::size_t(guarded_->mesh.vertexNum));
		for (std::size_t v = 0; v < vertex.size(); ++v) {
			const int anchor = guarded_->vertex[v].anchor, name = ofAnchor[std::size_t(anchor)];
			vertex[v] = anchor >= inputNum_ ? result_.vertex[std::size_t(name)]
											: madeVertex(making_.surface, name, *guarded_, int(v));
		}
		result_.mesh   = std::move(guarded_->mesh);
		result_.vertex = std::move(vertex);
	}

private:
	const MakingOfVertices& making_;
	ResultMesh&             result_;
	Workers&                workers_;
	Parts                   parts_;
	std::vector<int>        ofInput_; ///< per vertex of the input: vertex of the combined mesh, or
									  ///< -1
	std::vector<int> ofResult_;       ///< per vertex of the result: vertex of the combined mesh,
									  ///< or -1
	int                          inputNum_    = 0; ///< vertices of the combined mesh from the input
	bool                         hadContacts_ = false;
	std::unique_ptr<GuardedMesh> guarded_;

	/// With sizes by the error, distance counts more than length.
	double lengthWeight() const { return 0.01 * portable::pow(0.03, making_.adapt); }

	/// Combines the parts. Components of the result in contact with taken components of the input
	/// are taken as well.
	HalfEdgeMesh putTogether()
	{
		while (true) {
			HalfEdgeMesh m;
			m.mirrorAxis = result_.mesh.mirrorAxis;
			append(making_.surface.mesh, parts_.ofInput, parts_.isTaken, m, ofInput_);
			hadContacts_         = !findTouchingPairs(m, workers_, Seams::Apart).empty();
			inputNum_            = m.vertexNum;
			const int inputFaces = m.faceNum;
			append(result_.mesh, parts_.ofResult, parts_.isLeft, m, ofResult_);
			if (m.faceNum == inputFaces) return m;
			const std::vector<FacePair> pairs =
				findTouchingPairs(m, workers_, Seams::Joined, inputFaces);
			if (pairs.empty() || !takeTouching(pairs, inputFaces)) return m;
		}
	}

	/// Takes the components in contact. False if there are no such components.
	bool takeTouching(const std::vector<FacePair>& pairs, int inputFaces)
	{
		std::vector<int> left;
		for (int f = 0; f < result_.mesh.faceNum; ++f) {
			if (parts_.isLeft[std::size_t(parts_.ofResult.ofFace[std::size_t(f)])])
				left.push_back(f);
		}
		std::vector<int> faces;
		for (const FacePair& pair : pairs) {
			if (pair.first < inputFaces)
				faces.push_back(left[std::size_t(pair.second - inputFaces)]);
		}
		takeComponents(result_, faces, parts_);
		return !faces.empty();
	}

	void fixVertices()
	{
		for (std::size_t v = std::size_t(inputNum_); v < guarded_->vertex.size(); ++v)
			guarded_->vertex[v].isFixed = true;
		for (int v : making_.kept) {
			const int w = ofInput_[std::size_t(v)];
			if (w >= 0) guarded_->vertex[std::size_t(w)].isFixed = true;
		}
	}

	/// Per vertex of the combined mesh: its vertex of the input or of the result.
	std::vector<int> invertedNames() const
	{
		std::vector<int> name(guarded_->anchorNum);
		for (const std::vector<int>* of : {&ofInput_, &ofResult_}) {
			for (std::size_t v = 0; v < of->size(); ++v) {
				if ((*of)[v] >= 0) name[std::size_t((*of)[v])] = int(v);
			}
		}
		return name;
	}
};

/// Makes components anew if possible.
ContactOutcome replaceComponents(const MakingOfVertices& making, const std::vector<int>& faces,
								 ResultMesh& result, Workers& workers)
{
	const std::int64_t before = result.mesh.vertexNum;
	Replacement replacement(making, result, chooseParts(making.surface, result, faces, workers),
							workers);
	replacement.decimate();
	const std::int64_t reached = replacement.reached();
	if (reached > before && replacement.hadContacts())
		return {before}; // no promise for such an input
	if (reached > before && !making.mayEndAbove) return {reached, true};
	// Degenerate faces of the input have contacts of their neighbours: no promise there either.
	if (!replacement.relax()) return {before};
	replacement.take();
	return {reached};
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
		outcome = replaceComponents(making, facesOf(pairs), result, workers);
	outcome.isCapped = isCapped;
	return outcome;
}

} // namespace

ContactOutcome removeContacts(const MakingOfVertices& making, ResultMesh& result,
							  GuardedFigures& figures, Workers& workers)
{
	const std::vector<FacePair> pairs = findTouchingPairs(result.mesh, workers);
	ContactOutcome              outcome{result.mesh.vertexNum};
	figures.isTested     = true;
	figures.foundPairNum = figures.pairNum = std::int64_t(pairs.size());
	if (pairs.empty()) return outcome;
	const InputContacts ofInput(making.surface.mesh, result.mesh, pairs,
								nearInputs * result.idealEdge, workers);
	figures.inputPairNum               = ofInput.pairNum();
	const std::vector<FacePair> others = ofInput.withoutInputs(result.mesh, pairs);
	if (others.empty()) return outcome;
	outcome = makeAnew(making, ofInput, others, result, workers);
	if (outcome.isRefused) return outcome;
	figures.vertexNum = 0;
	for (std::size_t v = 0; v < result.vertex.size(); ++v)
		figures.vertexNum +=
			result.vertex[v].isMade ? result.mesh.multiplicity(result.mesh.position[v]) : 0;
	outcome.hasMade = figures.vertexNum > 0;
	figures.pairNum = std::int64_t(findTouchingPairs(result.mesh, workers).size());
	return outcome;
}

} // namespace gpr
