// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/run_context.h>
#include <vcg_extras/core/features/feature_export.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/output/audit.h>
#include <vcg_extras/core/output/hand_out.h>
#include <vcg_extras/core/run/error_goal.h>
#include <vcg_extras/core/run/given_samples.h>
#include <vcg_extras/core/run/improvement.h>
#include <vcg_extras/core/run/preparation.h>
#include <vcg_extras/core/run/sample_stages.h>
#include <vcg_extras/core/run/selected_part.h>
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/result_mesh.h>
#include <vcg_extras/core/surface/sampled_distance.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <new>
#include <random>

namespace gpr {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
	return std::chrono::duration<double>(Clock::now() - start).count();
}

std::uint32_t freshSeed()
{
	std::random_device device;
	return std::max(1u, std::uint32_t(device()));
}

/// One call of the engine: the stages in order, by the parts that know them.
class Run {
public:
	Run(const MeshView& input, const RemeshOptions& options, Workers& workers, RemeshReport& report,
		std::vector<std::string>& notes) :
			run_{input, options, workers, report, notes, StageClock(workers, report)},
			preparation_(run_), stages_(run_)
	{
		if (run_.options.seed == 0) run_.options.seed = freshSeed();
		report.seed    = run_.options.seed;
		report.threads = workers.threadNum();
	}

	/// For one of several runs: the share of all the work that this one is.
	void tellProgressWithin(double from, double to) { run_.clock.tellWithin(from, to); }

	void remesh(RemeshResult& out, bool measuresError = false)
	{
		preparation_.detectRegion();
		Prepared p = preparation_.prepare(0);
		makeRoomForKept(p, out);
		preparation_.findFeatureLines(p);
		if (run_.options.featureMode == FeatureMode::Lines && !followsFeatureLines(run_.options))
			out.notes.push_back(
				"Feature lines are not followed where vertices are removed one by one.");
		Meshed            meshed = sampleAndImprove(p);
		const std::string fault  = faultOfFeatureLines(p, meshed.result);
		if (!fault.empty()) {
			out.notes.push_back(fault + ", so that there are none.");
			preparation_.forgetFeatureLines(p);
			meshed = sampleAndImprove(p);
		}
		if (run_.options.exactCount && meshed.result.mesh.vertexNum != p.targetNum) {
			if (p.kept.empty()) {
				meshed = reachByTopology(p, out);
			}
			else {
				acceptNearest(p, meshed.result.mesh.vertexNum, out);
			}
		}
		if (run_.options.exactCount && p.kept.empty())
			leaveRoomForAreas(p, meshed, p.targetNum, out);
		fitResult(run_, p, meshed.boundary, measuresError, meshed.result);
		if (measuresError) measureError(p, meshed.result);
		handOut(run_, p.surface, meshed.result, {p.targetNum, std::int64_t(p.kept.size())}, out);
	}

	void sample(SamplingResult& out)
	{
		preparation_.detectRegion();
		Prepared p = preparation_.prepare(0);
		requireRoomForKept(p);
		preparation_.findFeatureLines(p);
		const BlockPartition partition = stages_.cut(p);
		BoundaryCurves       boundary;
		const Sampling       sampling = stages_.sampleAll(p, partition, boundary);
		run_.clock.enter("export", "Handing out the samples", 1);
		for (const Sample& s : sampling.samples) {
			out.points.push_back(p.surface.frame.toCaller(s.anchor.position));
			out.anchors.push_back(surfacePoint(run_.input, p.surface, s.anchor));
			out.radii.push_back(run_.report.diskRadius * double(s.size));
		}
		out.diskRadius = run_.report.diskRadius;
	}

	void retriangulate(const std::vector<Vec3d>& points, RemeshResult& out)
	{
		if (points.empty()) throw Failure(Status::BadOptions, "There are no samples.");
		Prepared             p = preparation_.prepare(std::int64_t(points.size()));
		BoundaryCurves       boundary;
		GivenSamples         given(run_);
		const Sampling       sampling  = given.takeOver(p, points);
		const BlockPartition partition = stages_.cut(p);
		run_.clock.enter("retriangulation", "Retriangulating", 0.9);
		ResultMesh result = stages_.retriangulateFrom(p, sampling, boundary, partition);
		run_.clock.enter("flips", "Flipping edges", 0.95);
		flipEdges(run_, result);
		run_.report.targetVertexNum = result.mesh.vertexNum;
		handOut(run_, p.surface, result, {0, std::int64_t(p.kept.size())}, out);
		given.nameSamples(points, result, out);
	}

	void detect(FeatureResult& out)
	{
		Surface            surface;
		const FeatureEdges features = preparation_.detectOn(surface, 0.95);
		preparation_.describeInput(surface);
		run_.clock.enter("export", "Handing out the features", 1);
		exportFeatures(run_.input, surface, features, out);
	}

private:
	/// A mesh under way and the curves that its vertices lie on.
	struct Meshed {
		ResultMesh     result;
		BoundaryCurves boundary;
	};

	RunContext   run_;
	Preparation  preparation_;
	SampleStages stages_;

	bool mayRaise() const
	{
		return run_.options.allowNearest || run_.options.targetMode != TargetMode::VertexNum;
	}

	/// Where the target is a wish it is raised to what vertices to be kept need with some others
	/// between them.
	void makeRoomForKept(Prepared& p, RemeshResult& out)
	{
		const std::int64_t keptNum = std::int64_t(p.kept.size());
		if (keepsBorder() && keptNum > p.targetNum && mayRaise()) {
			const std::int64_t raised = keptNum + keptNum / 2 + p.targetNum;
			out.notes.push_back("The border has " + std::to_string(keptNum) +
								" vertices to be kept, so that " + std::to_string(raised) +
								" vertices were aimed at instead of " +
								std::to_string(p.targetNum) + ".");
			p = preparation_.prepareAgain(raised);
		}
		requireRoomForKept(p);
	}

	void requireRoomForKept(const Prepared& p)
	{
		if (std::int64_t(p.kept.size()) <= p.targetNum) return;
		throw Failure(Status::BadOptions,
					  "The " + whatIsKept() + " " + std::to_string(p.kept.size()) +
						  " vertices to be kept, more than the " + std::to_string(p.targetNum) +
						  " of the result; ask for more vertices" + otherWay() + ".");
	}

	bool        keepsBorder() const { return run_.options.boundary == BoundaryMode::Keep; }
	std::string whatIsKept() const { return keepsBorder() ? "border has" : "feature region has"; }
	std::string otherWay() const
	{
		return keepsBorder() ? "" : ", or have the region sampled by disks";
	}

	/// Why there had better be no feature lines, as the first half of a sentence; empty where all
	/// is well.
	std::string faultOfFeatureLines(const Prepared& p, const ResultMesh& result)
	{
		if (run_.report.featureEdgeNum == 0) return "";
		if (run_.options.exactCount && result.mesh.vertexNum != p.targetNum)
			return "The number of vertices could not be reached with feature lines";
		if (lineFaceNum(result.mesh, run_.workers) > 0)
			return "With feature lines some triangles would have no area";
		return "";
	}

	/// Vertices to be kept leave no way to the count: the nearest one, where that may be.
	void acceptNearest(Prepared& p, std::int64_t nearest, RemeshResult& out)
	{
		if (!mayRaise()) {
			out.smallestVertexNum = nearest;
			throw Failure(Status::CountTooSmall,
						  "The surface cannot be meshed with " + std::to_string(p.targetNum) +
							  " vertices that include the " + std::to_string(p.kept.size()) +
							  " to be kept, but with " + std::to_string(nearest) + ".");
		}
		out.notes.push_back("The result has " + std::to_string(nearest) + " vertices instead of " +
							std::to_string(p.targetNum) +
							", with those to be kept the nearest that could be reached.");
		setTarget(run_, nearest, p);
	}

	/// From the samples to a mesh of about, or exactly, the wanted count.
	Meshed sampleAndImprove(const Prepared& p)
	{
		Meshed out;
		out.result = stages_.sampleAndRetriangulate(p, out.boundary);
		if (run_.options.exactCount) {
			run_.clock.enter("count", "Reaching the count", 0.87);
			collapseShortEdges(p.surface, out.result, run_.workers);
			reachExactCount(p.surface, out.boundary, p.targetNum, out.result, run_.workers);
		}
		improve(run_, p, out.boundary, out.result);
		return out;
	}

	void measureError(const Prepared& p, const ResultMesh& result)
	{
		run_.clock.enter("error", "Measuring the error", 0.975);
		const float largest = largestSampledDistance(p.surface.mesh, result.mesh, run_.workers);
		run_.report.largestError = double(largest) / p.surface.frame.scale;
	}

	/// The count could not be reached from samples of the right spacing. Starts from the fewest
	/// samples instead and changes the count by topology alone; what even that cannot reach is
	/// refused, or, where the target was a wish, raised to the smallest possible count.
	Meshed reachByTopology(Prepared& p, RemeshResult& out)
	{
		const std::int64_t asked   = p.targetNum;
		Meshed             first   = meshByTopology(p, asked);
		const std::int64_t nearest = first.result.mesh.vertexNum;
		if (nearest == asked) return first;

		if (!mayRaise()) {
			leaveRoomForAreas(p, first, asked, out);
			out.smallestVertexNum = nearest;
			throw Failure(Status::CountTooSmall, "The surface cannot be meshed with " +
													 std::to_string(asked) +
													 " vertices; the smallest possible number is " +
													 std::to_string(nearest) + ".");
		}
		out.notes.push_back("The result has " + std::to_string(nearest) + " vertices instead of " +
							std::to_string(asked) + ", the smallest number that could be reached.");
		// Samples of the right spacing, if they lead there, make better triangles.
		return meshAnew(nearest, p);
	}

	/// With very few vertices some triangles may have no way but along a slit or a fold, where they
	/// have no area. Looks for the next count that does better: takes it where the target was a
	/// wish, else refuses what was asked and names it. Where there is none the audit withholds the
	/// result.
	void leaveRoomForAreas(Prepared& p, Meshed& meshed, std::int64_t asked, RemeshResult& out)
	{
		constexpr std::int64_t mostVertices = 64; // beyond, a few more change nothing
		constexpr int          mostTrials   = 8;
		const std::int64_t     reached      = p.targetNum;
		if (reached > mostVertices || lineFaceNum(meshed.result.mesh, run_.workers) == 0) return;
		std::int64_t n = reached;
		for (int trial = 0; trial < mostTrials; ++trial) {
			meshed = meshAnew(n, p); // without feature lines: even the same count may do better
			if (lineFaceNum(meshed.result.mesh, run_.workers) == 0) {
				tellRaised(asked, p, out);
				return;
			}
			n += std::max<std::int64_t>(1, n / 4);
		}
		meshed = meshAnew(reached, p);
	}

	Meshed meshAnew(std::int64_t targetNum, Prepared& p)
	{
		p          = preparation_.prepareAgain(targetNum);
		Meshed out = sampleAndImprove(p);
		if (out.result.mesh.vertexNum == targetNum) return out;
		return meshByTopology(p, targetNum);
	}

	void tellRaised(std::int64_t asked, const Prepared& p, RemeshResult& out)
	{
		if (p.targetNum == asked) return;
		const std::string taken = std::to_string(p.targetNum), wanted = std::to_string(asked);
		if (!mayRaise()) {
			out.smallestVertexNum = p.targetNum;
			throw Failure(Status::CountTooSmall,
						  "With " + wanted +
							  " vertices some triangles would have no area; the smallest possible "
							  "number is " +
							  taken + ".");
		}
		out.notes.push_back("The result has " + taken + " vertices instead of " + wanted +
							", with which some triangles would have no area.");
	}

	/// Everything before the count is the same for every target, so that the smallest count is.
	Meshed meshByTopology(Prepared& p, std::int64_t targetNum)
	{
		p = preparation_.prepareAgain(1);
		Meshed out;
		out.result = stages_.sampleAndRetriangulate(p, out.boundary);
		setTarget(run_, targetNum, p);
		out.result.idealEdge = idealEdge(p);
		run_.clock.enter("count", "Reaching the count", 0.87);
		reachCountByTopology(p.surface, out.boundary, targetNum, out.result, run_.workers);
		setTarget(run_, out.result.mesh.vertexNum, p);
		improve(run_, p, out.boundary, out.result);
		return out;
	}
};

/// Finds the count for a largest error by whole runs, and hands out the best of them.
class ErrorGoalRun {
public:
	ErrorGoalRun(const MeshView& input, const RemeshOptions& options, Workers& workers) :
			input_(input), options_(options), workers_(workers), extent_(extentOf(input))
	{
		const double unit = options.maxErrorIsPercent ? extent_.diagonal / 100 : 1;
		goal_.largest     = options.targetMaxError * unit;
		goal_.most = std::min<std::int64_t>(200000000, 1000 + 2 * std::int64_t(input.vertexNum));
		const double edge = edgePerError * goal_.largest;
		const double n    = edge > 0 ? vertexNumForEdgeLength(extent_.area, edge) : 1;
		goal_.start       = std::int64_t(std::min(double(goal_.most), std::max(1.0, n)));

		options_.targetMode   = TargetMode::VertexNum;
		options_.allowNearest = true;
		if (options_.seed == 0) options_.seed = freshSeed();
	}

	void run(bool allowNearest, RemeshResult& out)
	{
		const bool met = searchCount(goal_, [&](std::int64_t n) { return tryCount(n); }) > 0;
		best_.report.errorGoal     = goal_.largest;
		best_.report.errorTrialNum = trialNum_;
		if (!met && !allowNearest) throw Failure(Status::BadOptions, complaint());
		best_.report.stages.push_back(
			{"otherTrials", stageSeconds_ - secondsOf(best_.report.stages)});
		best_.notes.push_back(note(met));
		out = std::move(best_);
	}

private:
	const MeshView& input_;
	RemeshOptions   options_;
	Workers&        workers_;
	MeshExtent      extent_;
	ErrorGoal       goal_;
	RemeshResult    best_;
	int             trialNum_     = 0;
	double          stageSeconds_ = 0; ///< of all trials

	static double secondsOf(const std::vector<StageTime>& stages)
	{
		double sum = 0;
		for (const StageTime& s : stages)
			sum += s.seconds;
		return sum;
	}

	ErrorTrial tryCount(std::int64_t vertexNum)
	{
		RemeshResult trial;
		options_.targetVertexNum = vertexNum;
		const double share       = 1.0 / goal_.mostTrials;
		Run          run(input_, options_, workers_, trial.report, trial.notes);
		run.tellProgressWithin(trialNum_ * share, (trialNum_ + 1) * share);
		run.remesh(trial, true);
		++trialNum_;
		stageSeconds_ += secondsOf(trial.report.stages);
		const ErrorTrial outcome{std::int64_t(trial.mesh.vertexNum()), trial.report.largestError};
		if (trialNum_ == 1 || isBetter(trial)) best_ = std::move(trial);
		return outcome;
	}

	/// Fewer vertices among those that meet the goal, else the smaller error.
	bool isBetter(const RemeshResult& trial) const
	{
		const double error = trial.report.largestError, least = best_.report.largestError;
		const bool   meets = error <= goal_.largest, met = least <= goal_.largest;
		if (meets != met) return meets;
		return meets ? trial.mesh.vertexNum() < best_.mesh.vertexNum() : error < least;
	}

	std::string lengthText(double length) const
	{
		char text[80];
		std::snprintf(text, sizeof text, "%.4g (%.3g %% of the diagonal)", length,
					  100 * length / extent_.diagonal);
		return text;
	}

	std::string complaint() const
	{
		return "An error of at most " + lengthText(goal_.largest) + " was not reached: with " +
			   std::to_string(best_.mesh.vertexNum()) + " vertices it is " +
			   lengthText(best_.report.largestError) + ".";
	}

	std::string note(bool met) const
	{
		if (!met) return complaint();
		return "The largest distance from the input that was found with " +
			   std::to_string(best_.mesh.vertexNum()) + " vertices is " +
			   lengthText(best_.report.largestError) + ", in " + std::to_string(trialNum_) +
			   " trials. It was found by sampling, which is no proof.";
	}
};

/// What went wrong, in words.
struct Fault {
	Status      status;
	std::string message;
};

/// Of the exception being handled, if it is a std::exception or one of ours.
Fault faultAtHand()
{
	try {
		throw;
	}
	catch (const Failure& f) {
		return {f.status, f.message};
	}
	catch (const CancelledError&) {
		return {Status::Cancelled, "Cancelled."};
	}
	catch (const OutOfTimeError&) {
		return {Status::OutOfTime, "Not done within the time limit."};
	}
	catch (const std::bad_alloc&) {
		return {Status::OutOfMemory, "There is not enough memory."};
	}
	catch (const std::exception& e) {
		return {Status::InternalError, std::string("Internal error: ") + e.what()};
	}
}

/// Runs body and turns what it throws into status and message; on failure nothing but those, the
/// report and the notes is handed out.
template <class Result, class Body>
Result guarded(const RemeshOptions& options, const ProgressCallback& progress, const Body& body)
{
	const Clock::time_point start = Clock::now();
	Result                  result;
	const auto              fail = [&](const Fault& fault) {
        Result failed;
        failed.status  = fault.status;
        failed.message = fault.message;
        failed.report  = std::move(result.report);
        failed.notes   = std::move(result.notes);
        return failed;
	};
	const std::vector<std::string> complaints = validate(options);
	if (!complaints.empty()) return fail({Status::BadOptions, complaints.front()});
	try {
		{
			Workers workers(options.threads, progress, options.timeLimitSeconds);
			body(workers, result);
		}
		result.status               = Status::Ok;
		result.report.remeshSeconds = secondsSince(start);
		return result;
	}
	catch (...) {
		return fail(faultAtHand());
	}
}

RemeshResult remeshWhole(const MeshView& input, const RemeshOptions& options,
						 const ProgressCallback& progress)
{
	std::int64_t smallest = 0;
	RemeshResult result =
		guarded<RemeshResult>(options, progress, [&](Workers& workers, RemeshResult& r) {
			try {
				if (options.targetMode == TargetMode::MaxError)
					ErrorGoalRun(input, options, workers).run(options.allowNearest, r);
				else
					Run(input, options, workers, r.report, r.notes).remesh(r);
			}
			catch (const Failure&) {
				smallest = r.smallestVertexNum;
				throw;
			}
		});
	result.smallestVertexNum = smallest;
	return result;
}

} // namespace

RemeshResult remesh(const MeshView& input, const RemeshOptions& options,
					const ProgressCallback& progress)
{
	if (!options.selectedOnly) return remeshWhole(input, options, progress);
	try {
		return remeshSelected(input, options, [&](const MeshView& part, const RemeshOptions& o) {
			return remeshWhole(part, o, progress);
		});
	}
	catch (...) {
		const Fault  fault = faultAtHand();
		RemeshResult failed;
		failed.status  = fault.status;
		failed.message = fault.message;
		return failed;
	}
}

SamplingResult samplePoissonDisks(const MeshView& input, const RemeshOptions& options,
								  const ProgressCallback& progress)
{
	return guarded<SamplingResult>(options, progress, [&](Workers& workers, SamplingResult& r) {
		Run(input, options, workers, r.report, r.notes).sample(r);
	});
}

RemeshResult retriangulate(const MeshView& input, const std::vector<Vec3d>& samples,
						   const RemeshOptions& options, const ProgressCallback& progress)
{
	return guarded<RemeshResult>(options, progress, [&](Workers& workers, RemeshResult& r) {
		Run(input, options, workers, r.report, r.notes).retriangulate(samples, r);
	});
}

FeatureResult detectFeatures(const MeshView& input, const RemeshOptions& options,
							 const ProgressCallback& progress)
{
	return guarded<FeatureResult>(options, progress, [&](Workers& workers, FeatureResult& r) {
		Run(input, options, workers, r.report, r.notes).detect(r);
	});
}

} // namespace gpr
