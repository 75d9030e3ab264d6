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

/// The steps of a run, in the order of a run. Beside each step stand the stages of the step
/// (base/stages.h).
enum class Step {
	Region,       ///< `Detection`
	Input,        ///< `Load`, `Sew`
	Surface,      ///< `SplitLongEdges`, `Order`, `Connect`, `Repair`
	Sizes,        ///< `Sizing`, `SplitLongEdges`, `InputFigures`
	Forecast,     ///< vertex count for a largest error or a detail
	Lines,        ///< `FeatureLines`
	GivenLines,   ///< `FeatureLines`
	Samples,      ///< `Boundary`, `Sampling`
	GivenSamples, ///< `GivenSamples`
	Triangles,    ///< `Retriangulation`, `Flips`
	Count,        ///< `Count`
	Relaxation,   ///< `Relaxation`
	Fit,          ///< `Fit`, `Angles`
	Release,      ///< `Fit`, `Angles`, after crowded feature lines were released
	Angles,       ///< `Angles`, by changes of the count
	Contacts,     ///< `Contacts`
	Refinement,   ///< `Fit`, only for a largest error
	Error,        ///< `Error`
	Check,        ///< `Audit`, `Check`
	Export,       ///< `Export`
	Done
};

/// The way to the wanted count.
enum class Way {
	WithFeatureLines, ///< samples with the right spacing, also on feature lines; then exact count
	WithoutFeatureLines, ///< the same without feature lines
	ByTopology ///< from the fewest samples, by splits and collapses that ignore the shape of faces
};

/// The purpose of the mesh under way.
enum class Purpose {
	Answer,         ///< the mesh is the result
	Forecast,       ///< the local sizes give the vertex count for a largest error or a detail
	Trial,          ///< the mesh is the result if the mesh keeps the error bound
	CountToBeHad,   ///< the mesh proves that the count named by a refusal is possible
	SamplesOnly,    ///< no mesh is made
	OfGivenSamples, ///< the user gives the samples
};

/// The decisions about the mesh under way. The steps depend on the options of the user and on these
/// decisions only.
/// vertexNum and faceNum: of the mesh. vertexNum 0: follows from the area. faceNum 0: vertices are
/// counted; else vertexNum is a forecast until the mesh has the faces.
struct Decisions : MeshSize {
	Purpose      purpose           = Purpose::Answer;
	Sewing       sewing            = Sewing::NotYet;
	Way          way               = Way::WithFeatureLines;
	int          lineLimit         = 0;     ///< a higher limit leaves fewer feature lines
	bool         keepsRaggedBorder = false; ///< the run gave up BoundaryMode::Smooth
	bool         mayEndAbove       = false; ///< the mesh may get more vertices than vertexNum
	std::int64_t addedNum          = 0;     ///< vertices beyond vertexNum, at single places
	/// Disk radius in working units; none: the radius that goes with the count.
	std::optional<float> radius;

	/// All vertices that the result shall have.
	std::int64_t wholeNum() const { return vertexNum + addedNum; }
	/// The count that the mesh shall reach.
	CountTarget countTarget() const { return {vertexNum, faceNum}; }
	/// The number of a mesh that is counted: of faces or of vertices.
	std::int64_t counted(const MeshSize& mesh) const
	{
		return faceNum > 0 ? mesh.faceNum : mesh.vertexNum;
	}
	/// The count for long edges, sizes and sample spacing. For Way::ByTopology the count is 1, so
	/// that the mesh reaches the smallest possible count.
	std::int64_t spacedFor() const { return way == Way::ByTopology ? 1 : vertexNum; }
};

// The facts that the steps return.

struct InputFacts {
	double area  = 0; ///< working units squared
	double scale = 1; ///< from mesh to working units
};
struct SurfaceFacts {
	bool mustSewFirst = false; ///< the mesh has seams to be sewn, and there is no surface yet
};
struct SizeFacts {
	std::int64_t keptNum      = 0; ///< vertices of the input that must stay
	std::int64_t euler        = 0; ///< Euler characteristic; of two halves: of both before joining
	double       borderLength = 0; ///< working units
	/// Half the number of faces for sizes in mesh units, and the number of border edges; 0: no such
	/// sizes.
	double vertexNum = 0, borderEdgeNum = 0;
	bool   followLines = false; ///< sizes follow the error on both sides of feature lines
	/// Possible counts, of faces if faces are counted, are multiples of this number.
	std::int64_t countStep = 1;
};
struct ForecastFacts {
	std::int64_t vertexNum = 0; ///< count with triangles as flat as the error bound needs
};
struct LineFacts {
	double share          = 0; ///< of the vertices, on borders and feature lines; 0: no lines
	int    spareDoublings = 0; ///< see CreaseFindings
};
struct SampleFacts {
	bool         mayMiss    = false; ///< the first sampling often misses the count
	std::int64_t num        = 0;
	std::int64_t onCurveNum = 0; ///< samples on borders and feature lines
	float        radius     = 0; ///< of the largest disks, working units
	float        usual      = 0; ///< radius for the count, working units
};
struct RelaxationFacts : MeshSize {
	bool hasFeatureLines = false;
	bool hasZeroAreas    = false; ///< some triangles have an area of rounding errors only
	bool hasSmoothBorder = false;
	bool isSewn          = false; ///< along seams
};
struct FitFacts {
	bool areLinesCrowded = false; ///< feature lines are too close to each other for good angles
};
/// vertexNum and faceNum: of the mesh now, or of the smallest mesh without contacts.
struct ContactFacts : MeshSize {
	std::int64_t before    = 0;     ///< vertices before the step
	bool         isRefused = false; ///< contacts are left, because the size is not allowed
};
struct RefinementFacts {
	int  addedNum   = 0;     ///< vertices added at single places
	bool hasChanged = false; ///< vertices were added or moved, and may make contacts
};
struct ErrorFacts {
	double error = 0; ///< proven bound of the largest distance, mesh units
	double share = 0; ///< of the area of the input, farther from the result than the error bound
};
struct ExportFacts : MeshSize {};

/// The task of a run.
struct Request {
	Purpose                  purpose   = Purpose::Answer;
	std::int64_t             sampleNum = 0;  ///< with Purpose::OfGivenSamples
	std::optional<ErrorGoal> goal      = {}; ///< error bound, with Purpose::Forecast
	double                   diagonal  = 0;  ///< of the input, mesh units; only with a goal
};

/// The note about a mesh with a proven largest error. Lengths in mesh units.
std::string provenText(std::int64_t vertexNum, double error, double diagonal);

/// Decides on the steps of a run: the next step, the decisions for the step, and the part of the
/// run that begins again. A plan changes no mesh. judge() takes the facts of a step, and returns a
/// sentence for the user or an empty string; a refusal throws Failure. If a fact changes a
/// decision, the run goes on from the first step that depends on the decision:
///
///     fact                                         decision                     from
///     seams are to be sewn                         sewn first                   Input
///     vertices to be kept need more room           count raised, or refused     Input
///     sizes in mesh units need another count       the other count              Input
///     faces are counted, and the surface is not    vertices for its topology
///       a sphere                                     and its border             Input
///     lines and borders take over half the count   drop the weaker of close
///                                                     lines                     Lines
///     lines take more than the whole count         longer lines only            Lines
///     the samples miss the count by much           radius corrected             Samples
///     1 lines, and the count missed or a
///       degenerate face                            no lines                     Lines
///     2 smooth border, and a degenerate face       ragged border                Lines
///     3 sewn seams, and a degenerate face          seams left open              Input
///     4 count missed with vertices to be kept      nearest count, or refused    -
///     5 count missed                               by topology alone            Input
///     6 missed by topology, too                    smallest count, or refused   Input
///     7 at few vertices a degenerate face          the next count, eight times  Input
///     crowded lines after the fit                  lines released               Release
///     no contacts, but above the count             larger count, or refused     -
///     sheets intersect beside a junction           half as many again, up to 8
///                                                    times, or refused          Lines
///     error above the bound at single places       moves and vertices there,
///                                                    3 times      Contacts
///     error above the bound, or far below it       another count, 5 trials      Region
///     refused                                      test of the count in the
///                                                    refusal                    Region
///
/// With a target of faces all rules compare face counts. A closed surface has no odd number of
/// faces: the plan aims at the number below, then refuses, so that the refusal names two possible
/// numbers. The same holds for other multiples (SizeFacts::countStep). On half a symmetric surface
/// all counts and the area are of the whole.
///
/// Rules 5 and 6: samples with the right spacing make better triangles than topology alone, so that
/// a raised count is meshed anew. Above 64 vertices the mesh by topology is taken instead if
/// collapses from such samples stopped above the raised count. Rule 7: with very few vertices some
/// triangles may lie along a slit or a fold and have no area. If the target is a wish, the next
/// count with areas everywhere is taken; else the run refuses the wanted count and names the next
/// count. If no such count is found, the plan accepts the mesh, and the audit withholds the mesh.
///
/// All returns count for the whole run: after mostReturns no rule returns, and the plan takes or
/// refuses the mesh at hand.
class Plan {
public:
	static constexpr int mostReturns = 100;

	/// vertexNum: of the input mesh.
	Plan(const RemeshOptions& options, std::int64_t vertexNum, const Request& request);

	Step             next() const { return step_; }
	const Decisions& decisions() const { return decisions_; }
	/// Whether the next step begins a new mesh from the input.
	bool beginsRun() const { return beginsRun_; }
	/// The share of all work that belongs to the run under way.
	WorkShare share() const;

	/// After a step without facts.
	void        goOn();
	std::string judge(const InputFacts& facts);
	std::string judge(const SurfaceFacts& facts);
	std::string judge(const SizeFacts& facts);
	std::string judge(const ForecastFacts& facts);
	std::string judge(const LineFacts& facts);
	std::string judge(const SampleFacts& facts);
	std::string judge(const RelaxationFacts& facts);
	std::string judge(const FitFacts& facts);
	std::string judge(const ContactFacts& facts);
	std::string judge(const RefinementFacts& facts);
	std::string judge(const ErrorFacts& facts);
	std::string judge(const ExportFacts& facts);
	/// Judges the failure of a step. Throws the failure that ends the run, unless the plan first
	/// looks for a possible count.
	void judge(const Failure& failure);

	/// Whether the last export is the best result so far.
	bool isBest() const { return isBest_; }
	/// The error bound. Needs a goal.
	const ErrorGoal& goal() const { return *request_.goal; }
	/// The number of meshes made for the goal.
	int trialNum() const { return trialNum_; }
	/// The sentence about the goal at the end of the run. Throws Failure if no mesh met the goal,
	/// unless the options allow the nearest mesh. Needs a goal.
	std::string outcomeForError() const;

private:
	const RemeshOptions&       options_;
	std::int64_t               callersVertexNum_;
	Request                    request_;
	std::optional<CountSearch> search_; ///< with a goal, after the forecast
	Decisions                  decisions_;
	Step                       step_      = Step::Region;
	bool                       beginsRun_ = true;
	int                        returnNum_ = 0; ///< of the whole run

	/// The attempts at one count.
	struct Attempts {
		bool         isCountChosen = false; ///< by the plan, not by the options and the area
		std::int64_t preparedFor   = 0;     ///< spacedFor() of the surface at hand
		SizeFacts    sizes;                 ///< of the surface at hand
		bool         areSizesKnown = false;
		MeshSize     asked;              ///< to compare the result with; numbers 0: not known
		bool         isRaised   = false; ///< beyond the wanted count, to a possible count
		std::int64_t reachedNum = 0;     ///< vertices reached from the right spacing
		double       area       = 0;     ///< working units squared
		MeshSize     searchedFrom;       ///< first size of the search of rule 7
		int          searchedNum   = 0;  ///< counts of the search so far; 0: no search
		int          correctionNum = 0;  ///< of the radius
		int          refinementNum = 0;
		std::int64_t separatedFrom = 0; ///< count at which sheets would intersect; 0: not so
	};
	Attempts attempts_;

	// The trials for an error bound.
	ErrorTrial trial_, best_;
	int        trialNum_ = 0;
	bool       isBest_   = false;

	// The refused count, and the meshes made to name possible counts.
	std::optional<Failure> refusal_;
	std::string            refused_;      ///< "7 vertices"
	MeshSize               named_;        ///< by the last refusal
	MeshSize               tried_;        ///< in the run under way
	int                    triedNum_ = 0; ///< sizes tried for the refusal
	std::vector<MeshSize>  had_;          ///< sizes of the meshes made

	bool        has(Step step) const;
	bool        isWish() const;
	bool        mayDiffer() const;
	bool        asksForFaces() const;
	bool        mayReturn() const { return returnNum_ < mostReturns; }
	std::string returnTo(Step from, std::string note = "");
	std::string returnIf(bool isNeeded, Step from);
	void        beginRun(Purpose purpose, std::int64_t vertexNum);
	std::string tryAgain(std::string note);
	std::string accept(const MeshSize& mesh, std::string note);
	void        aimAt(const MeshSize& mesh);

	MeshSize    above(const MeshSize& possible) const;
	std::string sizeText(const MeshSize& mesh) const;
	std::string asked() const;
	std::string insteadText(const MeshSize& mesh) const;
	std::string possibleText(const std::string& which, const MeshSize& first,
							 const MeshSize& last) const;
	bool        isNamed() const;

	void              resolveCount(const InputFacts& facts);
	std::int64_t      possible(std::int64_t num) const;
	std::int64_t      verticesOf(double faceNum, double onBorder) const;
	double            borderEdgeNum(std::int64_t vertexNum) const;
	void              forecastVertices();
	void              addBorder(const SizeFacts& facts);
	std::string       makeRoom();
	float             correctedRadius(const SampleFacts& facts) const;
	std::string       withoutFeatureLines(const std::string& note);
	std::string       withRaggedBorder();
	std::string       withOpenSeams();
	std::string       nearestWithKept(const MeshSize& reached);
	std::string       raiseTo(const MeshSize& smallest);
	std::string       judgeAreas(const RelaxationFacts& facts);
	std::string       judgeSmallest(const RelaxationFacts& facts);
	std::string       separateByMore(const ContactFacts& facts);
	std::string       beginSearch(const MeshSize& from);
	std::string       goOnSearching();
	std::string       endSearchAt(const MeshSize& found);
	void              tryToHave(const MeshSize& size);
	Failure           refusalAtLast() const;
	[[noreturn]] void refuseBelow(const std::string& fault, const MeshSize& smallest) const;
	[[noreturn]] void refuseParity(const MeshSize& lower) const;
};

} // namespace gpr

#endif
