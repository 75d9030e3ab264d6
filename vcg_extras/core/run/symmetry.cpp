// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "symmetry.h"

#include "result_stages.h"

#include <vcg_extras/core/features/given_lines.h>
#include <vcg_extras/core/input/mirror_half.h>
#include <vcg_extras/core/mesh/face_contact.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/output/export.h>
#include <vcg_extras/core/output/mirror_joining.h>
#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <cstdio>

namespace gpr {

namespace {

/// The largest mismatch of an input and its mirror image, as a share of the diagonal.
constexpr double mostMismatch = 1e-3;
/// The share of the error bound for the half; the rest is for rounding.
constexpr double shareOfError = 0.98;
/// Shares of the work before and after the remeshing of the half.
constexpr WorkShare ofHalf = {0.21, 0.98};

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

	Outcome told()
	{
		if (ofRun_.mesh.faceNum() == 0) return tellOf(run_, made_, Decisions());
		return tellOfWhole(run_, made_, std::move(ofRun_.report));
	}

	void go(RemeshResult& out)
	{
		if (call_.input.line != nullptr) markGivenLines(call_.input, run_.workers, surface_);
		countInput(run_, surface_);
		findPlane();
		half_ = cutHalf(call_.input, surface_, found_.plane, run_.workers);
		view_ = half_.view(call_.input, found_.plane);
		requireSameTopology();
		remeshHalf();
		finish(out);
	}

private:
	const Call&     call_;
	RunContext&     run_;
	Products&       made_;
	WorkingSurface& surface_;
	FoundPlane      found_;
	MirrorHalf      half_;
	MeshView        view_;
	RemeshResult    ofRun_; ///< of the half

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
		MeshFigures joined;
		try {
			const JoinedHalves both = joinHalves(surface_, found_.plane, half_, {}, run_.workers);
			joined                  = figuresOf(both.result.mesh, 1, run_.workers);
		}
		catch (const Failure&) {
		}
		if (joined.hasTopologyOf(surface_.figures)) return;
		throw Failure(Status::BadOptions,
					  "The surface touches or crosses itself at " + nameOf(found_.plane) +
						  ", so that its mirrored half would have other components, holes or "
						  "handles.");
	}

	// ---- the run of the half

	/// The options of the half. Counts are of the whole mesh (CountTarget).
	RemeshOptions optionsOfHalf() const
	{
		RemeshOptions o           = call_.optionsForMesh(view_.vertexNum);
		o.symmetry                = Symmetry::Off;
		o.seed                    = run_.options.seed;
		o.boundary                = BoundaryMode::Resample;
		o.check                   = false;
		o.sew                     = false; // the surface is sewn already
		o.dropComponentsBelow     = 0;
		o.surfacePointsOfVertices = true;
		o.surfacePointsOfFaces    = false;
		setSize(o);
		return o;
	}

	/// The wanted size, where the option refers to the whole input.
	void setSize(RemeshOptions& o) const
	{
		if (o.targetMode == TargetMode::MaxError) o.targetMaxError = errorOfHalf();
		if (o.targetMode != TargetMode::Detail) return;
		RemeshOptions ofWhole = options();
		ofWhole.symmetry      = Symmetry::Off;
		o.targetVertexNum = forecastVertexNum({call_.input, ofWhole, nullptr, call_.stop, nullptr});
		o.targetMode      = TargetMode::VertexNum;
		o.allowNearest    = true;
	}

	double errorOfHalf() const
	{
		const double most = shareOfError * (largestError(options(), diagonal()) - found_.mismatch);
		if (most > 0) return most;
		throw Failure(Status::BadOptions, "The two sides of the mesh are " +
											  percentOf(found_.mismatch, diagonal()) +
											  " from each other's mirror images, more than the "
											  "largest error.");
	}

	void remeshHalf()
	{
		if (surface_.figures.boundaryLoops > 0 && options().boundary != BoundaryMode::Resample) {
			throw Failure(Status::BadOptions,
						  "A symmetric result of a surface with a border takes the boundary "
						  "'resample' only.");
		}
		ProgressCallback progress;
		if (call_.progress) {
			progress = [this](double share, const char* phrase) {
				return call_.progress(ofHalf.at(share), phrase);
			};
		}
		run_.clock.finish();
		try {
			remeshInput({view_, optionsOfHalf(), progress, call_.stop, nullptr}, ofRun_);
		}
		catch (Failure& failure) {
			failure.message = "For a symmetric result: " + failure.message;
			throw;
		}
		addTimes(ofRun_, run_.clock);
		run_.workers.enterStage("Joining the halves", ofHalf.to, ofHalf.to);
	}

	// ---- the whole

	void finish(RemeshResult& out)
	{
		JoinedHalves joined =
			joinHalves(surface_, found_.plane, ofRun_.mesh, ofRun_.region, run_.workers);
		placeOnSurface(surface_, half_, found_.plane, ofRun_, run_.workers, joined);
		made_.result = std::move(joined.result);
		requireNoContacts();
		check();
		AuditFigures& audited = made_.verified.audit;
		made_.quality      = exportResult(run_, surface_, made_.result, false, false, audited, out);
		out.mesh.positions = std::move(joined.positions);
		tell(joined.onPlaneNum);
	}

	/// Neither half has contacts; the joined halves may have.
	void requireNoContacts()
	{
		if (!run_.options.guard) return;
		made_.guarded = GuardedFigures();
		made_.guarded.pairNum =
			std::int64_t(findTouchingPairs(made_.result.mesh, run_.workers).size());
		if (made_.guarded.pairNum == 0) return;
		made_.guarded.inputFaceNum =
			std::int64_t(findTouchingFaces(surface_.mesh, run_.workers, Seams::Apart).size());
		if (made_.guarded.inputFaceNum > 0) return;
		throw Failure(Status::PromiseBroken,
					  "The halves would intersect each other; ask for more vertices.");
	}

	void check()
	{
		if (options().targetMode == TargetMode::MaxError) {
			ErrorGoal goal;
			goal.largest = largestError(options(), diagonal());
			if (measureError(run_, goal, made_).error > goal.largest)
				throw Failure(
					Status::PromiseBroken,
					"The mirrored half is farther from the input than the largest error.");
		}
		const Expected expected{surface_.figures, made_.result.mesh.vertexNum, 0};
		verifyResult(run_, surface_, made_.result, expected, made_.verified);
	}

	/// The last note of the run of the half is about the half.
	void tellProof()
	{
		ofRun_.notes.pop_back();
		run_.tell(provenText(made_.result.mesh.vertexNum,
							 made_.verified.proof.bounds.hausdorff().upper, diagonal()));
	}

	void tell(std::int64_t onPlaneNum)
	{
		if (options().targetMode == TargetMode::MaxError) tellProof();
		for (const std::string& note : ofRun_.notes)
			run_.tell(note);
		const MeshView& in       = call_.input;
		const bool      hasMarks = in.wantedEdge != nullptr || in.selected != nullptr ||
							  in.line != nullptr || in.hasManyRegions();
		if (hasMarks) {
			run_.tell("Wanted edge lengths, selected vertices, given lines and region borders have "
					  "an effect on the remeshed half only.");
		}
		run_.tell("The result is symmetric across " + nameOf(found_.plane) + ": twice " +
				  std::to_string(ofRun_.mesh.vertexNum()) + " vertices less " +
				  std::to_string(onPlaneNum) +
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
	Setup           plain({call.input, ofWhole, call.progress, call.stop, call.cache, call.start},
						  Pipeline::Remeshing);
	SymmetricRun    symmetric(call, plain.run, plain.made);
	const TellAtEnd teller{[&] { return symmetric.told(); }, out};
	{
		InputCache own;
		fillCache(plain.run, call.cache != nullptr ? *call.cache : own, plain.made);
	}
	symmetric.go(out);
}

} // namespace gpr
