// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "symmetry.h"

#include <vcg_extras/core/features/given_lines.h>
#include <vcg_extras/core/input/mirror_half.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/output/mirror_joining.h>
#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

namespace gpr {

namespace {

/// The largest mismatch of an input and its mirror image, as a share of the diagonal.
constexpr double mostMismatch = 1e-3;
/// The share of the error bound for the half; the rest is for rounding.
constexpr double shareOfError = 0.98;
/// Shares of the work before and after the remeshing of the half.
constexpr WorkShare ofHalf = {0.21, 0.98};
/// Runs for one count: the number of vertices on an open border is known only after a run.
constexpr int mostRuns = 8;

std::string number(double x)
{
	char text[32];
	std::snprintf(text, sizeof text, "%.3g", x);
	return text;
}

std::string percentOf(double part, double whole)
{
	return number(part) + " (" + number(100 * part / whole) + " % of the diagonal)";
}

std::string nameOf(const MirrorPlane& plane)
{
	if (plane.axis >= 0) return std::string(1, char('x' + plane.axis)) + " = " + number(plane.at);
	const Vec3d& n = plane.row[0];
	return "the plane with the normal (" + number(n.x) + ", " + number(n.y) + ", " + number(n.z) +
		   ") at " + number(plane.at);
}

/// Makes a symmetric result. `run` and `surface` belong to the whole surface.
class SymmetricRun {
public:
	SymmetricRun(const Call& call, RunContext& run, Products& made) :
			call_(call), run_(run), made_(made), surface_(made.surface)
	{
	}

	Told told()
	{
		Told told = tellOf(run_, made_, Decisions());
		if (ofRun_.mesh.faceNum() > 0) told.addHalf(std::move(ofRun_.report));
		return told;
	}

	void go(RemeshResult& out)
	{
		if (call_.input.line != nullptr) markGivenLines(call_.input, run_.workers, surface_);
		countInput(run_, surface_);
		findPlane();
		half_ = cutHalf(call_.input, surface_, found_.plane, run_.workers);
		view_ = half_.view(call_.input, found_.plane);
		requireSameTopology();
		measureBorder();
		reachSize();
		finish(out);
	}

private:
	using Clock = std::chrono::steady_clock;

	const Call&             call_;
	RunContext&             run_;
	Products&               made_;
	WorkingSurface&         surface_;
	const Clock::time_point start_ = Clock::now();
	FoundPlane              found_;
	MirrorHalf              half_;
	MeshView                view_;
	RemeshResult            ofRun_; ///< last result of the half
	// Of the half.
	std::int64_t euler_      = 0;     ///< Euler characteristic
	std::int64_t arcNum_     = 0;     ///< open chains of border on the plane
	double       openLength_ = 0;     ///< of the border off the plane, mesh units
	std::int64_t openEdges_  = 0;     ///< of the same border in the result, about
	bool         isWish_     = false; ///< whether another count may be taken

	const RemeshOptions& options() const { return call_.options; }
	double               diagonal() const { return surface_.figures.diagonal; }

	// ---- the plane and the half

	void findPlane()
	{
		const double allowed = mostMismatch * diagonal();
		found_               = findMirrorPlane(surface_, options().symmetry, allowed, run_.workers);
		if (found_.mismatch <= allowed) return;
		const Vec3d& p = found_.farthest;
		throw Failure(Status::UnusableInput,
					  "The mesh is not symmetric across " + nameOf(found_.plane) +
						  ": the mirror image of the vertex at (" + number(p.x) + ", " +
						  number(p.y) + ", " + number(p.z) + ") is " +
						  percentOf(found_.mismatch, diagonal()) +
						  " from the surface; at most .1 % is allowed.");
	}

	/// Half and mirrored half together must have the topology of the whole.
	void requireSameTopology() const
	{
		const TriangleMesh mesh{half_.positions, half_.triangles};
		const MeshFigures& whole = surface_.figures;
		MeshFigures        joined;
		try {
			const JoinedHalves both = joinHalves(surface_, found_.plane, mesh, {});
			joined                  = figuresOf(both.result.mesh, 1, run_.workers);
		}
		catch (const Failure&) {
		}
		if (joined.components == whole.components && joined.boundaryLoops == whole.boundaryLoops &&
			joined.eulerCharacteristic == whole.eulerCharacteristic)
			return;
		throw Failure(Status::BadOptions,
					  "The surface touches or crosses itself at " + nameOf(found_.plane) +
						  ", so that its mirrored half would have other components, holes or "
						  "handles.");
	}

	bool isOnPlane(std::int32_t v, const std::vector<Vec3d>& positions) const
	{
		return coordinate(positions[std::size_t(v)], found_.plane.heightAxis()) == 0;
	}

	/// The border of the half: edges on the plane and other edges.
	struct HalfBorder {
		std::int64_t onPlane = 0, open = 0; ///< edges
		double       openLength = 0;        ///< mesh units
	};

	HalfBorder borderOf(const TriangleMesh& mesh) const
	{
		std::set<std::pair<std::int32_t, std::int32_t>> edges;
		for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
			const std::int32_t a = mesh.triangles[c],
							   b = mesh.triangles[c % 3 == 2 ? c - 2 : c + 1];
			if (edges.erase({b, a}) == 0) edges.insert({a, b});
		}
		HalfBorder border;
		for (const auto& [a, b] : edges) {
			if (isOnPlane(a, mesh.positions) && isOnPlane(b, mesh.positions)) {
				++border.onPlane;
				continue;
			}
			++border.open;
			border.openLength +=
				length(mesh.positions[std::size_t(b)] - mesh.positions[std::size_t(a)]);
		}
		return border;
	}

	std::int64_t planeVertexNum(const TriangleMesh& mesh) const
	{
		std::int64_t num = 0;
		for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
			num += isOnPlane(std::int32_t(v), mesh.positions);
		return num;
	}

	void measureBorder()
	{
		const TriangleMesh mesh{half_.positions, half_.triangles};
		const HalfBorder   border = borderOf(mesh);
		euler_                    = measureMesh(mesh.view()).eulerCharacteristic;
		arcNum_                   = planeVertexNum(mesh) - border.onPlane;
		openLength_               = border.openLength;
		if (border.open > 0 && options().boundary != BoundaryMode::Resample) {
			throw Failure(Status::BadOptions,
						  "A symmetric result of a surface with a border takes the boundary "
						  "'resample' only.");
		}
	}

	// ---- runs of the half

	RemeshOptions optionsOfHalf() const
	{
		RemeshOptions o           = options();
		o.symmetry                = Symmetry::Off;
		o.seed                    = run_.options.seed;
		o.boundary                = BoundaryMode::Resample;
		o.check                   = false;
		o.sew                     = false; // the surface is sewn already
		o.dropComponentsBelow     = 0;
		o.surfacePointsOfVertices = true;
		o.surfacePointsOfFaces    = false;
		const double spent        = std::chrono::duration<double>(Clock::now() - start_).count();
		if (o.timeLimitSeconds > 0) o.timeLimitSeconds = std::max(1e-3, o.timeLimitSeconds - spent);
		return o;
	}

	void remeshHalf(const RemeshOptions& ofHalfOptions)
	{
		ProgressCallback progress;
		if (call_.progress) {
			progress = [this](double share, const char* phrase) {
				return call_.progress(ofHalf.at(share), phrase);
			};
		}
		ofRun_ = RemeshResult();
		run_.clock.finish();
		remeshInput({view_, ofHalfOptions, progress, call_.stop}, ofRun_);
		addTimes(ofRun_, run_.clock);
	}

	std::int64_t wholeVertexNum() const
	{
		return 2 * std::int64_t(ofRun_.mesh.vertexNum()) - planeVertexNum(ofRun_.mesh);
	}

	/// The vertices of the whole for a number of faces of the half: F = 2 V - B - 2 χ, and B -
	/// openEdges + arcs vertices lie on the plane.
	std::int64_t verticesFor(std::int64_t faceNum) const
	{
		return faceNum + 2 * euler_ + openEdges_ - arcNum_;
	}

	void reachSize()
	{
		const RemeshOptions& o = options();
		isWish_                = o.allowNearest;
		switch (o.targetMode) {
		case TargetMode::VertexNum:
			return reachVertexNum(o.targetVertexNum);
		case TargetMode::FaceNum:
			return reachFaceNum(o.targetFaceNum);
		case TargetMode::Percent:
			isWish_ = true;
			return reachVertexNum(std::max<std::int64_t>(
				4, std::llround(o.targetPercent / 100 * double(call_.input.vertexNum))));
		case TargetMode::Detail: {
			isWish_               = true;
			RemeshOptions ofWhole = o;
			ofWhole.symmetry      = Symmetry::Off;
			return reachVertexNum(
				forecastVertexNum({call_.input, ofWhole, nullptr, call_.stop, nullptr}));
		}
		case TargetMode::MaxError:
			return reachError(largestError(o, diagonal()));
		default:
			return remeshHalf(optionsOfHalf());
		}
	}

	void reachError(double largest)
	{
		RemeshOptions o     = optionsOfHalf();
		o.maxErrorIsPercent = false;
		o.targetMaxError    = shareOfError * (largest - found_.mismatch);
		if (!(o.targetMaxError > 0)) {
			throw Failure(Status::BadOptions, "The two sides of the mesh are " +
												  percentOf(found_.mismatch, diagonal()) +
												  " from each other's mirror images, more than the "
												  "largest error.");
		}
		remeshHalf(o);
	}

	/// Remeshes the half to a number of faces.
	void remeshToFaces(std::int64_t faceNum)
	{
		RemeshOptions o = optionsOfHalf();
		o.targetMode    = TargetMode::FaceNum;
		o.targetFaceNum = std::max<std::int64_t>(1, faceNum);
		o.allowNearest  = isWish_;
		remeshHalf(o);
	}

	/// smallest: vertex count that the topology needs, if the user asked for fewer; else 0.
	[[noreturn]] static void refuse(const std::string& asked, const std::string& what,
									std::int64_t lower, std::int64_t upper, std::int64_t smallest)
	{
		const std::string numbers =
			lower == upper ? " is " + std::to_string(lower)
						   : "s are " + std::to_string(lower) + " and " + std::to_string(upper);
		throw Failure(smallest > 0 ? Status::CountTooSmall : Status::BadOptions,
					  "No symmetric mesh of this surface with " + asked +
						  " was found; the nearest number" + numbers + " " + what + ".",
					  smallest);
	}

	static std::int64_t nextOf(const Failure& failure)
	{
		return failure.nextFaceNum > 0 ? failure.nextFaceNum : failure.smallestFaceNum + 2;
	}

	/// The vertex count of the whole for the smallest count of a refusal; 0 for other refusals.
	std::int64_t smallestOf(const Failure& failure) const
	{
		return failure.status == Status::CountTooSmall ? verticesFor(failure.smallestFaceNum) : 0;
	}

	void reachFaceNum(std::int64_t faceNum)
	{
		const std::string asked = std::to_string(faceNum) + " faces";
		if (faceNum % 2 != 0 && !isWish_)
			refuse(asked, "faces", std::max<std::int64_t>(2, faceNum - 1), faceNum + 1, 0);
		try {
			remeshToFaces(faceNum / 2);
		}
		catch (const Failure& failure) {
			if (failure.smallestFaceNum == 0) throw;
			refuse(asked, "faces", 2 * failure.smallestFaceNum, 2 * nextOf(failure),
				   smallestOf(failure));
		}
	}

	void reachVertexNum(std::int64_t vertexNum)
	{
		openEdges_ = std::llround(openLength_ / double(evenEdge(surface_.figures.area, vertexNum)));
		std::int64_t           faceNum = vertexNum - verticesFor(0);
		std::set<std::int64_t> tried, reached;
		while (int(tried.size()) < mostRuns && tried.insert(faceNum).second) {
			tryVertexNum(faceNum, vertexNum);
			const std::int64_t got = wholeVertexNum();
			if (got == vertexNum) return;
			reached.insert(got);
			faceNum += vertexNum - got;
		}
		if (!isWish_) refuseNear(vertexNum, reached);
	}

	void tryVertexNum(std::int64_t faceNum, std::int64_t vertexNum)
	{
		try {
			remeshToFaces(faceNum);
		}
		catch (const Failure& failure) {
			if (failure.smallestFaceNum == 0) throw;
			refuse(std::to_string(vertexNum) + " vertices", "vertices",
				   verticesFor(failure.smallestFaceNum), verticesFor(nextOf(failure)),
				   smallestOf(failure));
		}
	}

	[[noreturn]] static void refuseNear(std::int64_t                  vertexNum,
										const std::set<std::int64_t>& reached)
	{
		const auto         above = reached.upper_bound(vertexNum);
		const std::int64_t upper = above == reached.end() ? *reached.rbegin() : *above;
		const std::int64_t lower = above == reached.begin() ? *reached.begin() : *std::prev(above);
		refuse(std::to_string(vertexNum) + " vertices", "vertices", lower, upper, 0);
	}

	// ---- the whole

	void finish(RemeshResult& out)
	{
		JoinedHalves joined = joinHalves(surface_, found_.plane, ofRun_.mesh, ofRun_.region);
		placeOnSurface(surface_, half_, found_.plane, ofRun_, run_.workers, joined);
		requireNoContacts(joined.result.mesh);
		check(joined.result);
		AuditFigures& audited = made_.verified.audit;
		made_.quality = exportResult(run_, surface_, joined.result, false, false, audited, out);
		out.mesh.positions = std::move(joined.positions);
		tell(joined);
		made_.result = std::move(joined.result);
	}

	/// Neither half has contacts; the joined halves may have.
	void requireNoContacts(const HalfEdgeMesh& mesh)
	{
		if (!run_.options.guard) return;
		made_.guarded         = GuardedFigures();
		made_.guarded.pairNum = std::int64_t(findTouchingPairs(mesh, run_.workers).size());
		if (made_.guarded.pairNum == 0) return;
		made_.guarded.inputPairNum =
			std::int64_t(findTouchingPairs(surface_.mesh, run_.workers, Seams::Apart).size());
		if (made_.guarded.inputPairNum > 0) return;
		throw Failure(Status::PromiseBroken,
					  "The halves would intersect each other; ask for more vertices.");
	}

	void check(const ResultMesh& result)
	{
		if (options().targetMode == TargetMode::MaxError) {
			run_.clock.enter(Stage::Error);
			const ComparedSurfaces both(surface_, result, run_.workers);
			made_.verified.proof = proveDistance(run_, surface_, diagonal(), both);
			if (made_.verified.proof.bounds.hausdorff().upper > largestError(options(), diagonal()))
				throw Failure(
					Status::PromiseBroken,
					"The mirrored half is farther from the input than the largest error.");
		}
		const Expected expected{surface_.figures, result.mesh.vertexNum, 0};
		verifyResult(run_, surface_, result, expected, made_.verified);
	}

	void tell(const JoinedHalves& joined)
	{
		for (const std::string& note : ofRun_.notes)
			run_.tell("For the remeshed half: " + note);
		const MeshView& in       = call_.input;
		const bool      hasMarks = in.wantedEdge != nullptr || in.selected != nullptr ||
							  in.line != nullptr || in.hasManyRegions();
		if (hasMarks) {
			run_.tell("Wanted edge lengths, selected vertices, given lines and region borders have "
					  "an effect on the remeshed half only.");
		}
		run_.tell("The result is symmetric across " + nameOf(found_.plane) + ": twice " +
				  std::to_string(ofRun_.mesh.vertexNum()) + " vertices less " +
				  std::to_string(joined.onPlaneNum) +
				  " on the plane. The vertices of the input are at most " +
				  percentOf(found_.mismatch, diagonal()) + " from the mirror image of the input.");
	}
};

} // namespace

void remeshSymmetric(const Call& call, RemeshResult& out)
{
	RemeshOptions ofWhole    = call.options;
	ofWhole.featureRegion    = FeatureRegion::None; // found on the half
	ofWhole.featureDiskScale = 0;
	PlainRun        plain({call.input, ofWhole, call.progress, call.stop, call.cache},
						  Pipeline::Remeshing);
	SymmetricRun    symmetric(call, plain.setup.run, plain.made);
	const TellAtEnd teller{symmetric, out};
	{
		InputCache own;
		fillCache(plain.setup.run, call.cache != nullptr ? *call.cache : own, plain.made);
	}
	symmetric.go(out);
}

} // namespace gpr
