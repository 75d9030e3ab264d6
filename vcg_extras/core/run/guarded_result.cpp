// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "guarded_result.h"

#include "patch_filling.h"
#include "target.h"

#include <vcg_extras/core/base/box.h>
#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/guard/guarded_decimation.h>
#include <vcg_extras/core/guard/guarded_relaxation.h>
#include <vcg_extras/core/guard/input_contacts.h>
#include <vcg_extras/core/guard/made_vertex.h>
#include <vcg_extras/core/mesh/components.h>
#include <vcg_extras/core/mesh/face_boxes.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/mesh_edit.h>
#include <vcg_extras/core/output/audit.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gpr {

namespace {

/// Contacts of the result nearer than this to one of the input's, in edges, are the input's own.
constexpr float nearInputs = 1.5f;
/// Patches that have grown so often and still do not fit are given up.
constexpr int refillRounds = 4;
/// Patches of a larger share of the faces are no better than whole components made anew.
constexpr double mostInPatches = 0.75;

/// Whether the options ask for a result that is free of contacts.
bool isGuarded(const RemeshOptions& options)
{
	return options.guard && !isPaper(options);
}

/// What a mesh is put together from: some components of the input, that are to be made coarser,
/// and the other ones of the result, which stay.
struct Parts {
	Components        ofInput, ofResult;
	std::vector<char> isTaken; ///< per component of the input
	std::vector<char> isLeft;  ///< per component of the result
};

/// Takes the components that have one of these faces of the result. Each lies on one of the input.
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

/// The faces of some components behind those that are there; newIndex gets the names of their
/// vertices, -1 of the others.
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

/// The faces of some pairs, and the inverted ones: where something is made anew, they shall go,
/// too.
std::vector<int> poorFaces(const Surface& surface, const ResultMesh& result,
						   const std::vector<FacePair>& pairs, Workers& workers)
{
	const Buffer<Vec3f> normals = smoothNormals(surface, result, workers);
	std::vector<int>    faces   = workers.collectIf(std::size_t(result.mesh.faceNum), [&](int f) {
        return normalAgreement(result.mesh, normals, f) < 0;
    });
	for (const FacePair& pair : pairs)
		faces.insert(faces.end(), {pair.first, pair.second});
	return faces;
}

/// Makes components of the result anew.
class Replacement {
public:
	Replacement(RunContext& run, const Prepared& p, ResultMesh& result, Parts parts) :
			run_(run), p_(p), result_(result), parts_(std::move(parts))
	{
	}

	/// Collapses until the count is the result's, or none is possible any more.
	void decimate(bool inputHasContacts)
	{
		guarded_ = std::make_unique<GuardedMesh>(putTogether(), inputHasContacts);
		fixVertices();
		GuardedSettings settings;
		settings.targetNum        = result_.mesh.vertexNum;
		settings.keepsBorder      = result_.keepsBorder;
		settings.idealEdge        = double(result_.idealEdge);
		settings.lengthWeight     = lengthWeight();
		settings.mayLeaveVertices = isFitted(run_.options);
		decimateGuarded(settings, *guarded_, run_.workers);
	}

	std::int64_t reached() const { return guarded_->mesh.vertexNum; }

	/// Makes what was decimated more regular. False where faces without area are left, as between
	/// vertices that have to stay.
	bool relax()
	{
		relaxGuarded(double(result_.idealEdge), isFitted(run_.options), *guarded_, run_.workers);
		return zeroAreaFaceNum(guarded_->mesh, run_.workers) == 0;
	}

	/// Puts what was decimated in the place of the result.
	void take()
	{
		const std::vector<int>    ofAnchor = invertedNames();
		std::vector<ResultVertex> vertex(std::size_t(guarded_->mesh.vertexNum));
		for (std::size_t v = 0; v < vertex.size(); ++v) {
			const int anchor = guarded_->anchor[v], name = ofAnchor[std::size_t(anchor)];
			vertex[v] = anchor >= inputNum_ ? result_.vertex[std::size_t(name)]
											: madeVertex(p_.surface, name, *guarded_, int(v));
			madeNum_ += anchor < inputNum_;
		}
		result_.mesh   = std::move(guarded_->mesh);
		result_.vertex = std::move(vertex);
	}

	/// Vertices that take() has put in the place of others.
	std::int64_t madeNum() const { return madeNum_; }

private:
	RunContext&      run_;
	const Prepared&  p_;
	ResultMesh&      result_;
	Parts            parts_;
	std::vector<int> ofInput_;      ///< per vertex of the input: of the mesh put together, or -1
	std::vector<int> ofResult_;     ///< the same of the result
	int              inputNum_ = 0; ///< vertices of the mesh put together that are the input's
	std::int64_t     madeNum_  = 0;
	std::unique_ptr<GuardedMesh> guarded_;

	/// Where sizes follow the error distance counts more than length.
	double lengthWeight() const { return 0.01 * portable::pow(0.03, *run_.options.adapt); }

	/// Components of the result that touch one of the input, too, are made anew as well.
	HalfEdgeMesh putTogether()
	{
		while (true) {
			HalfEdgeMesh m;
			append(p_.surface.mesh, parts_.ofInput, parts_.isTaken, m, ofInput_);
			inputNum_            = m.vertexNum;
			const int inputFaces = m.faceNum;
			append(result_.mesh, parts_.ofResult, parts_.isLeft, m, ofResult_);
			if (m.faceNum == inputFaces) return m;
			const std::vector<FacePair> pairs =
				findTouchingPairs(m, run_.workers, Seams::Joined, inputFaces);
			if (pairs.empty() || !takeTouching(pairs, inputFaces)) return m;
		}
	}

	/// False where there is none to take.
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
		std::fill(guarded_->isFixed.begin() + inputNum_, guarded_->isFixed.end(), char(1));
		for (int v : p_.kept) {
			const int w = ofInput_[std::size_t(v)];
			if (w >= 0) guarded_->isFixed[std::size_t(w)] = 1;
		}
	}

	/// Per vertex of the mesh put together: which it is of the input, or of the result.
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

Failure refusal(std::int64_t asked, std::int64_t reached)
{
	return {
		Status::CountTooSmall,
		"With " + std::to_string(asked) +
			" vertices the surface would intersect itself. The smallest number of vertices that "
			"was reached without self-intersections is " +
			std::to_string(reached) + ".",
		reached};
}

void tellMade(RunContext& run, const ResultMesh& result)
{
	const std::int64_t num = run.report.audit.guarded.vertexNum;
	if (num == 0) return;
	run.notes.push_back(
		"Triangles would intersect each other where the surface is thinner than they are wide, so "
		"that " +
		std::to_string(num) + " of the " + std::to_string(result.mesh.vertexNum) +
		" vertices were made by guarded edge collapses of the input. The triangles there are less "
		"regular.");
}

/// Another number than was asked for, where that is a wish.
void tellReached(RunContext& run, std::int64_t asked, std::int64_t reached)
{
	if (reached == asked) return;
	run.notes.push_back(
		"The result has " + std::to_string(reached) + " vertices instead of " +
		std::to_string(asked) +
		". This is the smallest number that was reached without self-intersections.");
}

/// Makes components anew where that is possible; what else may be done is up to the options.
void replaceComponents(RunContext& run, const std::vector<int>& faces, bool inputHasContacts,
					   Prepared& p, ResultMesh& result)
{
	const std::int64_t asked = result.mesh.vertexNum;
	Replacement replacement(run, p, result, chooseParts(p.surface, result, faces, run.workers));
	replacement.decimate(inputHasContacts);
	const std::int64_t reached = replacement.reached();
	if (reached > asked && inputHasContacts) return; // nothing is promised
	if (reached > asked && !isTargetWish(run.options)) throw refusal(asked, reached);
	// Where a face of the input has no area its neighbours touch: nothing is promised there either.
	if (!replacement.relax()) return;
	replacement.take();
	if (reached != asked) setTarget(run, reached, p);
	std::int64_t& madeNum = run.report.audit.guarded.vertexNum; // patches may be among these
	madeNum = std::min(madeNum + replacement.madeNum(), std::int64_t(result.mesh.vertexNum));
	tellReached(run, asked, reached);
}

/// What is done about the pairs of a result.
class Repair {
public:
	Repair(RunContext& run, Prepared& p, ResultMesh& result, const InputContacts& ofInput) :
			run_(run), p_(p), result_(result), ofInput_(ofInput)
	{
	}

	/// Only what is near the pairs, then whole components.
	void run(std::vector<FacePair> pairs)
	{
		refill(pairs);
		pairs = pairsOf(result_.mesh);
		if (!pairs.empty()) {
			const bool inputHasContacts =
				!findTouchingPairs(p_.surface.mesh, run_.workers, Seams::Apart).empty();
			replaceComponents(run_, poorFaces(p_.surface, result_, pairs, run_.workers),
							  inputHasContacts, p_, result_);
		}
	}

private:
	RunContext&          run_;
	Prepared&            p_;
	ResultMesh&          result_;
	const InputContacts& ofInput_;

	/// Without the input's own.
	std::vector<FacePair> pairsOf(const HalfEdgeMesh& m) const
	{
		return ofInput_.withoutInputs(m, findTouchingPairs(m, run_.workers));
	}

	static std::ptrdiff_t numOf(const std::vector<char>& marked)
	{
		return std::count(marked.begin(), marked.end(), char(1));
	}

	static bool areMost(const std::vector<char>& marked)
	{
		return double(numOf(marked)) > mostInPatches * double(marked.size());
	}

	/// The best of some rounds of patches, each larger than the one before.
	void refill(const std::vector<FacePair>& pairs)
	{
		std::vector<char> marked(std::size_t(result_.mesh.faceNum), 0);
		for (const FacePair& pair : pairs)
			marked[std::size_t(pair.first)] = marked[std::size_t(pair.second)] = 1;
		widenMarks(result_.mesh, PatchFilling::ringsAround, marked);
		std::size_t           fewest = pairs.size();
		std::optional<Filled> best;
		for (int round = 0; round < refillRounds && fewest > 0; ++round) {
			PatchFilling filling(run_, p_, result_);
			if (!filling.fill(marked) || areMost(marked)) break;
			if (!filling.isSound()) {
				widenMarks(result_.mesh, 1, marked);
				continue;
			}
			const std::vector<FacePair> left      = pairsOf(filling.mesh());
			const std::ptrdiff_t        markedNum = numOf(marked);
			filling.markAround(left, marked);
			if (left.size() < fewest) {
				fewest = left.size();
				best   = filling.take();
			}
			if (numOf(marked) == markedNum) break; // the next round would come to the same
		}
		if (!best) return;
		result_.mesh   = std::move(best->mesh);
		result_.vertex = std::move(best->vertex);
		run_.report.audit.guarded.vertexNum += best->madeNum;
	}
};

} // namespace

void removeContacts(RunContext& run, Prepared& p, KnownContacts& contacts, ResultMesh& result)
{
	if (!isGuarded(run.options)) return;
	run.clock.enter(Stage::Contacts);
	GuardedFigures&             figures = run.report.audit.guarded;
	const std::vector<FacePair> pairs   = contacts.find(result.mesh, run.workers);
	figures.isTested                    = true;
	figures.foundPairNum = figures.pairNum = std::int64_t(pairs.size());
	if (pairs.empty()) return;
	const InputContacts ofInput(p.surface.mesh, result.mesh, pairs, nearInputs * result.idealEdge,
								run.workers);
	figures.inputPairNum               = ofInput.pairNum();
	const std::vector<FacePair> others = ofInput.withoutInputs(result.mesh, pairs);
	if (others.empty()) return;
	Repair(run, p, result, ofInput).run(others);
	if (figures.vertexNum == 0) return;
	run.report.largestFitDistance = double(farthestFromSurface(result)) / p.surface.frame.scale;
	figures.pairNum               = std::int64_t(contacts.find(result.mesh, run.workers).size());
	tellMade(run, result);
}

} // namespace gpr
