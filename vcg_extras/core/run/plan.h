// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_PLAN_H
#define VCG_EXTRAS_CORE_RUN_PLAN_H

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/base/stage_clock.h>
#include <vcg_extras/core/input/cleaning.h>
#include <vcg_extras/core/optimization/exact_count.h>
#include <vcg_extras/core/options.h>
#include <vcg_extras/core/sampling/count_search.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gpr {

/// The steps of a run in their order. The stages of base/stages.h that a step goes through stand
/// beside it.
enum class Step {
	Region,       ///< Detection
	Input,        ///< Load, Sew
	Surface,      ///< SplitLongEdges, Order, Connect, Repair
	Sizes,        ///< Sizing, SplitLongEdges, InputFigures
	Forecast,     ///< of the count for a largest error
	Lines,        ///< FeatureLines
	GivenLines,   ///< FeatureLines
	Samples,      ///< Boundary, Sampling
	GivenSamples, ///< GivenSamples
	Triangles,    ///< Retriangulation, Flips
	Count,        ///< Count
	Relaxation,   ///< Relaxation
	Fit,          ///< Fit, Angles
	Release,      ///< Fit, Angles, without crowded feature lines
	Contacts,     ///< Contacts
	Refinement,   ///< Fit, for a largest error
	Error,        ///< Error
	Check,        ///< Audit, Check
	Export,       ///< Export
	Done
};

/// How a mesh gets its count.
enum class Way {
	WithFeatureLines, ///< samples of the right spacing, on feature lines too; then the exact count
	WithoutFeatureLines, ///< the same, but no feature line is followed
	ByTopology           ///< from the fewest samples, splits and collapses whatever the shapes
};

/// Why a mesh is made.
enum class Purpose {
	Answer,         ///< it is the result
	Forecast,       ///< its sizes tell the count for a largest error
	Trial,          ///< it may be the result if it keeps to the largest error
	CountToBeHad,   ///< a refusal shall name a count that can be had
	SamplesOnly,    ///< no mesh is made
	OfGivenSamples, ///< the samples are the caller's
};

/// What was chosen for the mesh under way. Beside the caller's options nothing else steers the
/// steps.
struct Decisions {
	Purpose      purpose   = Purpose::Answer;
	Sewing       sewing    = Sewing::NotYet;
	Way          way       = Way::WithFeatureLines;
	std::int64_t vertexNum = 0; ///< of the mesh; 0: it waits for the area
	/// Of the mesh, where faces are counted; vertexNum is a forecast then until it has them.
	std::int64_t faceNum           = 0;
	int          lineLimit         = 0;     ///< each step higher fewer feature lines are followed
	bool         keepsRaggedBorder = false; ///< BoundaryMode::Smooth was given up
	bool         mayEndAbove       = false; ///< the mesh may get more vertices than vertexNum
	std::int64_t addedNum          = 0;     ///< vertices beyond vertexNum, at single places
	/// Disk radius in working units where the one of the count misses the count by much.
	std::optional<float> radius;

	/// All vertices that the result is to have.
	std::int64_t wholeNum() const { return vertexNum + addedNum; }
	/// What the mesh is to reach.
	CountTarget countTarget() const { return {vertexNum, faceNum}; }
	/// The count that edges are split, sizes are found and samples are placed for. It is the same
	/// for every count that topology alone is to reach, so that the smallest one is.
	std::int64_t spacedFor() const { return way == Way::ByTopology ? 1 : vertexNum; }
};

// Facts that the steps come to.

struct NoFacts {};
struct InputFacts {
	double area  = 0; ///< working units squared
	double scale = 1; ///< from mesh to working units
};
struct SurfaceFacts {
	bool mustSewFirst = false; ///< it has seams that are to be sewn: there is no surface
};
struct SizeFacts {
	std::int64_t keptNum      = 0;     ///< the caller's vertices that are to stay
	std::int64_t euler        = 0;     ///< Euler characteristic of the surface
	double       borderLength = 0;     ///< working units
	double       vertexNum    = 0;     ///< that sizes in mesh units take; 0: the count is another's
	bool         followLines  = false; ///< sizes are by the error on either side of feature lines
};
struct ForecastFacts {
	std::int64_t vertexNum = 0; ///< with which triangles would be as flat as the error asks for
};
struct LineFacts {
	double share = 0; ///< of the vertices, that borders and feature lines take; 0: no lines
};
struct SampleFacts {
	bool         mayMiss    = false; ///< the first go may miss the count by much
	std::int64_t num        = 0;
	std::int64_t onCurveNum = 0; ///< of these, on borders and feature lines
	float        radius     = 0; ///< of the largest disks, working units
	float        usual      = 0; ///< the radius that goes with the count
};
struct CountFacts {
	std::int64_t vertexNum = 0;
	std::int64_t faceNum   = 0;
};
struct MeshFacts {
	std::int64_t vertexNum       = 0;
	bool         hasFeatureLines = false;
	bool         hasZeroAreas    = false; ///< triangles whose area is nothing but rounding
	bool         hasSmoothBorder = false;
	bool         isSewn          = false; ///< along seams
	std::int64_t faceNum         = 0;
};
struct FitFacts {
	bool areLinesCrowded = false; ///< too close to each other for good angles
};
struct ContactFacts {
	std::int64_t before    = 0;     ///< vertices of the mesh that was looked at
	std::int64_t vertexNum = 0;     ///< of the mesh now, or of the least one without contacts
	bool         isRefused = false; ///< contacts are left, since that count may not be taken
	std::int64_t faceNum   = 0;     ///< of the mesh now
};
struct RefinementFacts {
	int addedNum = 0; ///< vertices that came in at single places
};
struct ErrorFacts {
	double error  = 0; ///< proven bound of the largest distance, mesh units
	double share  = 0; ///< of the area of the input, that is farther off than the goal
	double growth = 1; ///< of the count, if triangles get smaller there and stay elsewhere
};
struct ExportFacts {
	std::int64_t vertexNum = 0;
	std::int64_t faceNum   = 0;
};

/// What is asked of a run.
struct Request {
	const RemeshOptions&     options;
	std::int64_t             callersVertexNum; ///< of the input as given
	Purpose                  purpose   = Purpose::Answer;
	std::int64_t             sampleNum = 0;  ///< with Purpose::OfGivenSamples
	std::optional<ErrorGoal> goal      = {}; ///< a largest error, with Purpose::Forecast
	double                   diagonal  = 0;  ///< with a goal: of the input, mesh units
};

/// Decides on the steps of a run: which one comes next, what is chosen for it, and which part of
/// the run begins again. A plan makes nothing itself: facts go in by judge(), which returns a
/// sentence for the user or an empty string, and throws the Failure of a refusal. A fact changes a
/// decision, and the run goes on from the first step that this decision touches:
///
///     fact                                         decision                     from
///     seams are to be sewn                         sewn first                   Input
///     vertices to be kept need more room           count raised, or refused     Input
///     sizes in mesh units take other counts        that count                Input
///     faces are counted, and the surface is not    vertices for its topology
///       a sphere                                     and its border             Input
///     lines and borders take over half the count   of close lines the stronger  Lines
///     they take more than all of it                longer lines only            Lines
///     the samples miss the count by much           radius corrected             Samples
///     1 lines, and the count missed or a face
///       without area                               no lines                     Lines
///     2 smooth border, and a face without area     ragged border                Lines
///     3 sewn seams, and a face without area        seams left open              Input
///     4 count missed with vertices to be kept      nearest count, or refused    -
///     5 count missed                               by topology alone            Input
///     6 missed by topology, too                    smallest count, or refused   Input
///     7 at few vertices a face without area        the next count, eight times  Input
///     crowded lines after the fit                  lines released               Release
///     contacts but above the count                 that count, or refused       -
///     error beyond the goal at single places       vertices there, 3 times      Contacts
///     error beyond the goal, or far within it      another count, 5 trials      Region
///     refused at up to 64 vertices                 is the count that is named
///                                                  to be had?                   Region
///
/// Where faces are counted all rules compare these, and an odd number of a closed surface is
/// refused once the number below it was reached, so that what the refusal names can be had.
///
/// Rules 5 and 6: samples of the right spacing, if they lead to a count, make better triangles than
/// topology alone, so that a raised count is meshed anew. Rule 7: with very few vertices some
/// triangles may have no way but along a slit or a fold, where they have no area. The next count
/// that does better is taken where the target was a wish; else the count that was asked for is
/// refused and the other one named. Where there is none the mesh is accepted, and the audit
/// withholds it.
///
/// All that begins again is counted for the whole run: after mostReturns no rule returns any more,
/// and the mesh at hand is taken or refused.
class Plan {
public:
	static constexpr int mostReturns = 100;

	explicit Plan(const Request& request);

	Step             next() const { return step_; }
	const Decisions& decisions() const { return decisions_; }
	/// Whether the next step begins with the input as given, for a mesh of its own.
	bool beginsRun() const { return beginsRun_; }
	/// Of all the work, what the run under way does.
	WorkShare share() const;

	std::string judge(const NoFacts& facts);
	std::string judge(const InputFacts& facts);
	std::string judge(const SurfaceFacts& facts);
	std::string judge(const SizeFacts& facts);
	std::string judge(const ForecastFacts& facts);
	std::string judge(const LineFacts& facts);
	std::string judge(const SampleFacts& facts);
	std::string judge(const CountFacts& facts);
	std::string judge(const MeshFacts& facts);
	std::string judge(const FitFacts& facts);
	std::string judge(const ContactFacts& facts);
	std::string judge(const RefinementFacts& facts);
	std::string judge(const ErrorFacts& facts);
	std::string judge(const ExportFacts& facts);
	/// A step failed. Throws the failure that the run ends with, unless a count that can be had is
	/// looked for first.
	void judge(const Failure& failure);

	/// Whether what was exported last is the best so far.
	bool isBest() const { return isBest_; }
	/// With a goal: the goal itself.
	const ErrorGoal& goal() const { return *request_.goal; }
	/// With a goal: meshes that were made for it.
	int trialNum() const { return trialNum_; }
	/// With a goal: what the user reads of it at the end. Throws Failure where it was not met and
	/// that is no wish.
	std::string outcomeForError() const;

private:
	Request                    request_;
	std::optional<CountSearch> search_; ///< with a goal
	Decisions                  decisions_;
	Step                       step_      = Step::Region;
	bool                       beginsRun_ = true;
	int                        returnNum_ = 0; ///< of the whole run

	/// What the rules know of the attempts at one count.
	struct Attempts {
		bool         isCountChosen = false; ///< here; else it follows from the options and the area
		std::int64_t keptNum       = -1; ///< the caller's vertices that are to stay; -1: not known
		std::int64_t preparedFor   = 0;  ///< spacedFor() of the surface at hand
		bool         followLines   = false; ///< the sizes at hand do: see SizeFacts
		std::int64_t asked         = 0; ///< vertices that the result is compared with; 0: not known
		bool         isRaised      = false; ///< to the smallest count that topology came to
		double       area          = 0;     ///< working units squared
		std::int64_t searchedFrom  = 0;     ///< count that the search of rule 7 began with
		int searchedNum   = 0; ///< counts of that search, the one at hand included; 0: no search
		int correctionNum = 0; ///< of the radius
		int refinementNum = 0;
	};
	Attempts attempts_;

	// The trials for an error.
	ErrorTrial trial_, best_;
	int        trialNum_ = 0;
	bool       isBest_   = false;

	// The count that was refused, and what is known of a smaller one that can be had.
	std::optional<Failure> refusal_;
	std::int64_t           smallestNum_ = 0;
	std::int64_t           wantedFaces_ = 0; ///< of the run under way, where faces are counted
	std::string            refused_;         ///< "7 vertices"
	int                    triedNum_ = 0;    ///< counts that were tried for the refusal
	std::vector<ExportFacts>
		hadNums_; ///< of these, where faces are counted: the two that are named

	bool        has(Step step) const;
	void        goOn();
	bool        isWish() const;
	bool        mayDiffer() const;
	bool        asksForFaces() const;
	bool        mayReturn() const { return returnNum_ < mostReturns; }
	std::string returnTo(Step from, std::string note = "");
	std::string returnIf(bool isNeeded, Step from);
	void        beginRun(Purpose purpose, std::int64_t vertexNum);
	std::string tryAgain(std::string note);
	std::string accept(const MeshFacts& facts, std::string note);
	std::string asked() const;
	std::string counted(std::int64_t vertexNum, std::int64_t faceNum) const;

	void              resolveCount(const InputFacts& facts);
	void              forecastVertices(const SizeFacts& facts);
	std::string       makeRoom(std::int64_t euler);
	float             correctedRadius(const SampleFacts& facts) const;
	std::string       withoutFeatureLines(const std::string& fault);
	std::string       withRaggedBorder();
	std::string       withOpenSeams();
	std::string       nearestWithKept(const MeshFacts& reached);
	std::string       byTopology();
	std::string       raiseTo(const MeshFacts& smallest);
	std::string       judgeAreas(const MeshFacts& facts);
	std::string       judgeSmallest(const MeshFacts& facts);
	std::string       search(std::int64_t vertexNum);
	std::string       beginSearch(const MeshFacts& from);
	std::string       goOnSearching();
	std::string       endSearchAt(const MeshFacts& found);
	std::string       tryToHave(std::int64_t vertexNum);
	std::string       tryToHaveFaces(std::int64_t faceNum);
	Failure           refusalAtLast() const;
	[[noreturn]] void refuse(const std::string& why, std::int64_t smallest,
							 std::int64_t faceNum = 0) const;
	[[noreturn]] void refuseBelow(std::int64_t smallest, std::int64_t faceNum) const;
	[[noreturn]] void refuseParity(std::int64_t lower) const;
};

} // namespace gpr

#endif
