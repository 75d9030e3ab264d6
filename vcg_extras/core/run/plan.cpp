// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan.h"

#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace gpr {

namespace {

/// Above this number of vertices, a few more vertices do not change whether every triangle has an
/// area.
constexpr std::int64_t fewVertices = 64;
/// A wish below the smallest count gets a thirty-second more than the smallest count.
constexpr std::int64_t partForShape = 32;
/// Each searched count is a quarter larger than the count before; the last is about four times the
/// first.
constexpr int maxSearchedCounts = 8;
/// Where sheets that meet in junctions intersect, the count is raised by halves up to this many
/// times the first count: five meshes at most, since sheets at one place never come apart.
constexpr std::int64_t mostForSheets = 8;

/// A part of a count, at least 1.
std::int64_t partOf(std::int64_t num, std::int64_t divisor)
{
	return std::max<std::int64_t>(1, num / divisor);
}

/// A refusal names counts up to these numbers only after a test of the count, with at most this
/// number of attempts.
constexpr std::int64_t mostTriedVertices = 10000, mostTriedFaces = 20000;
constexpr int          maxTriedCounts = 16;

/// Share of the vertices on lines and borders, above which the weaker of close lines are dropped.
constexpr double maxOnCurves = 0.5;
/// Corrections of the radius. Vertices to be kept leave a small number of free samples, which needs
/// more corrections.
constexpr int maxCorrections = 2, maxCorrectionsWithKept = 6;
/// Smaller triangles may touch other triangles; the patches made anew there may again be too far
/// from the input.
constexpr int maxRefinements = 3;

/// Whether to search a count with areas for all triangles.
bool needsSearch(const RelaxationFacts& facts)
{
	return facts.hasZeroAreas && facts.vertexNum <= fewVertices;
}

std::string text(std::int64_t n)
{
	return std::to_string(n);
}

[[noreturn]] void refuse(const std::string& why, const MeshSize& possible)
{
	throw Failure(Status::CountTooSmall, why, possible);
}

std::string cannotBe(const std::string& count)
{
	return "The surface cannot be meshed with " + count;
}

std::string lengthText(double length, double diagonal)
{
	char words[80];
	std::snprintf(words, sizeof words, "%.4g (%.3g %% of the diagonal)", length,
				  100 * length / diagonal);
	return words;
}

/// The sentence about an error bound that no mesh met.
std::string missedText(const ErrorTrial& best, double goal, double diagonal)
{
	return "A largest error of " + lengthText(goal, diagonal) +
		   " was not reached: the best mesh has " + text(best.vertexNum) +
		   " vertices and a proven largest error of " + lengthText(best.error, diagonal) + ".";
}

/// The note about the vertex count for a detail.
std::string forecastText(std::int64_t vertexNum, Detail detail, double diagonal)
{
	const double error = detailError(detail) * diagonal;
	return "About " + text(vertexNum) +
		   " vertices are forecast to keep 99.9 % of the surface within " +
		   lengthText(error, diagonal) + ".";
}

/// Two meshes within the bound: fewer vertices are better. Else the smaller error is better.
bool isBetter(const ErrorTrial& a, const ErrorTrial& b, double largest)
{
	const bool meetsA = a.error <= largest, meetsB = b.error <= largest;
	if (meetsA != meetsB) return meetsA;
	return meetsA ? a.vertexNum < b.vertexNum : a.error < b.error;
}

} // namespace

std::string provenText(std::int64_t vertexNum, double error, double diagonal)
{
	return "With " + text(vertexNum) +
		   " vertices the largest distance between input and result is proven to be at most " +
		   lengthText(error, diagonal) + ".";
}

Plan::Plan(const RemeshOptions& options, std::int64_t vertexNum, const Request& request) :
		options_(options), callersVertexNum_(vertexNum),
		request_(request), tried_{0, options.targetFaceNum}
{
	beginRun(request.purpose, request.goal ? request.goal->start : request.sampleNum);
}

WorkShare Plan::share() const
{
	if (decisions_.purpose == Purpose::Forecast) return {0, 0};
	if (decisions_.purpose == Purpose::CountToBeHad) return {1, 1};
	if (decisions_.purpose != Purpose::Trial) return {0, 1};
	const double length = 1.0 / goal().maxTrials, from = trialNum_ * length;
	return {from, from + length};
}

// ---- The order of the steps.

bool Plan::has(Step step) const
{
	const Purpose purpose        = decisions_.purpose;
	const bool    isOfOwn        = purpose != Purpose::OfGivenSamples;
	const bool    becomesMesh    = purpose != Purpose::SamplesOnly;
	const bool    isTrial        = purpose == Purpose::Trial;
	const bool    mayStillRefine = attempts_.refinementNum < maxRefinements;
	// clang-format off
	switch (step) {
	case Step::Input:
	case Step::Surface:
	case Step::Sizes:
	case Step::Export:       return true;
	case Step::Region:
	case Step::Lines:
	case Step::GivenLines:
	case Step::Samples:      return isOfOwn;
	case Step::GivenSamples: return !isOfOwn;
	case Step::Forecast:     return purpose == Purpose::Forecast;
	case Step::Triangles:
	case Step::Check:        return becomesMesh;
	case Step::Refinement:   return isTrial && mayStillRefine;
	case Step::Error:        return isTrial;
	case Step::Release:      return false; // entered by judge(FitFacts) only
	default:                 return isOfOwn && becomesMesh;
	}
	// clang-format on
}

void Plan::goOn()
{
	beginsRun_ = false;
	do
		step_ = Step(int(step_) + 1);
	while (step_ != Step::Done && !has(step_));
}

std::string Plan::returnTo(Step from, std::string note)
{
	++returnNum_;
	step_ = from;
	return note;
}

std::string Plan::returnIf(bool isNeeded, Step from)
{
	if (isNeeded && mayReturn()) return returnTo(from);
	goOn();
	return "";
}

void Plan::beginRun(Purpose purpose, std::int64_t vertexNum)
{
	decisions_              = Decisions();
	decisions_.purpose      = purpose;
	decisions_.vertexNum    = vertexNum;
	decisions_.mayEndAbove  = mayDiffer();
	attempts_               = Attempts();
	attempts_.isCountChosen = vertexNum > 0;
	trial_                  = ErrorTrial();
	step_                   = Step::Region;
	if (!has(step_)) goOn();
	beginsRun_ = true;
}

/// Whether the result may have another count if the wanted count is not possible.
bool Plan::isWish() const
{
	const bool isByCount = options_.targetMode == TargetMode::VertexNum || asksForFaces() ||
						   decisions_.purpose == Purpose::CountToBeHad;
	return options_.allowNearest || !isByCount;
}

bool Plan::asksForFaces() const
{
	return options_.targetMode == TargetMode::FaceNum;
}

/// Whether the result may have another number of vertices than the options ask for.
bool Plan::mayDiffer() const
{
	return isWish() || isPaper(options_);
}

// ---- The surface and its samples.

void Plan::resolveCount(const InputFacts& facts)
{
	attempts_.area = facts.area;
	if (attempts_.isCountChosen) return;
	RemeshOptions options = options_;
	options.targetFaceNum = tried_.faceNum;
	decisions_.vertexNum  = resolveTarget(callersVertexNum_, options, facts.area, facts.scale);
	if (asksForFaces()) decisions_.faceNum = attempts_.asked.faceNum = tried_.faceNum;
}

/// The next possible count below.
std::int64_t Plan::possible(std::int64_t num) const
{
	return std::max(attempts_.sizes.countStep, num - num % attempts_.sizes.countStep);
}

/// F = 2 V - 2 χ - B, with B vertices on the border.
std::int64_t Plan::verticesOf(double faceNum, double onBorder) const
{
	const double num = std::round(0.5 * (faceNum + onBorder) + double(attempts_.sizes.euler));
	return std::int64_t(std::clamp(num, 1.0, maxResultVertices));
}

/// The number of border edges that are as long as the edges of vertexNum vertices on the area.
double Plan::borderEdgeNum(std::int64_t vertexNum) const
{
	return attempts_.sizes.borderLength / double(evenEdge(attempts_.area, vertexNum));
}

void Plan::forecastVertices()
{
	constexpr int rounds = 4; // B depends on the edge length, and the edge length on V
	decisions_.faceNum   = possible(decisions_.faceNum);
	for (int round = 0; round < rounds; ++round)
		decisions_.vertexNum =
			verticesOf(double(decisions_.faceNum), borderEdgeNum(decisions_.vertexNum));
	if (isPaper(options_)) decisions_.faceNum = 0; // reaches no exact count
}

/// A count by an edge length or by sizes is at first half the number of faces: right without a
/// border, and with the Euler characteristic 0.
void Plan::addBorder(const SizeFacts& facts)
{
	const bool isByLength =
		options_.targetMode == TargetMode::EdgeLength && !attempts_.isCountChosen;
	if (facts.vertexNum > 0)
		decisions_.vertexNum = verticesOf(2 * facts.vertexNum, facts.borderEdgeNum);
	else if (isByLength && !isPaper(options_))
		decisions_.vertexNum =
			verticesOf(2 * double(decisions_.vertexNum), borderEdgeNum(decisions_.vertexNum));
	else
		return;
	decisions_.vertexNum = std::max<std::int64_t>(decisions_.vertexNum, 4);
}

std::string Plan::judge(const InputFacts& facts)
{
	resolveCount(facts);
	goOn();
	const bool isForecast = options_.targetMode == TargetMode::Detail &&
							decisions_.purpose == Purpose::Answer && attempts_.asked.vertexNum == 0;
	return isForecast ? forecastText(decisions_.vertexNum, options_.targetDetail, request_.diagonal)
					  : std::string();
}

std::string Plan::judge(const SurfaceFacts& facts)
{
	if (facts.mustSewFirst) {
		decisions_.sewing = Sewing::First;
		return returnTo(Step::Input);
	}
	attempts_.preparedFor = decisions_.spacedFor();
	goOn();
	return "";
}

std::string Plan::judge(const SizeFacts& facts)
{
	const bool isFirst      = !attempts_.areSizesKnown;
	attempts_.sizes         = facts;
	attempts_.areSizesKnown = true;
	goOn();
	if (!isFirst) return "";
	const std::int64_t before = decisions_.vertexNum;
	if (decisions_.faceNum > 0) forecastVertices();
	addBorder(facts);
	attempts_.asked.vertexNum = decisions_.vertexNum;
	if (decisions_.faceNum == 0) decisions_.vertexNum = possible(decisions_.vertexNum);
	if (facts.keptNum > attempts_.asked.vertexNum && decisions_.purpose != Purpose::OfGivenSamples)
		return makeRoom();
	attempts_.isCountChosen =
		attempts_.isCountChosen || decisions_.vertexNum != before || decisions_.faceNum > 0;
	const bool isFar = 10 * std::abs(decisions_.vertexNum - before) > before;
	return isFar && mayReturn() ? returnTo(Step::Input) : "";
}

/// If the target is a wish, raises the count for a border or junctions with vertices to be kept, so
/// that vertices are left for the surface between them. Else refuses.
std::string Plan::makeRoom()
{
	const bool isBorder    = options_.boundary == BoundaryMode::Keep;
	const bool isRegion    = !isBorder && !keepsJunctions(options_);
	const bool mayRaise    = !isRegion && isWish() && decisions_.purpose != Purpose::SamplesOnly;
	const std::string fact = std::string(isBorder   ? "The border has "
										 : isRegion ? "The feature region has "
													: "The junctions have ") +
							 text(attempts_.sizes.keptNum) + " vertices to be kept, ";
	const std::int64_t num  = attempts_.sizes.keptNum;
	const MeshSize     kept = {num, std::max<std::int64_t>(1, 2 * (num - attempts_.sizes.euler))};
	if (!mayRaise || !mayReturn()) {
		refuse(fact + "more than " + asked() + " allow; ask for more" +
				   (isRegion ? ", or give a feature disk scale" : "") + ".",
			   kept);
	}
	const std::int64_t wanted = attempts_.asked.vertexNum;
	attempts_.asked           = kept.plus(num / 2 + wanted);
	attempts_.isCountChosen   = true;
	decisions_.vertexNum      = attempts_.asked.vertexNum;
	decisions_.faceNum        = 0;
	return returnTo(Step::Input, fact + "so the wanted number was raised from " + text(wanted) +
									 " to " + text(decisions_.vertexNum) + " vertices.");
}

std::string Plan::judge(const ForecastFacts& facts)
{
	if (options_.targetMode == TargetMode::Detail) {
		beginRun(Purpose::Answer,
				 verticesOf(2 * double(facts.vertexNum), borderEdgeNum(facts.vertexNum)));
		return "";
	}
	request_.goal->start = facts.vertexNum;
	search_.emplace(goal());
	beginRun(Purpose::Trial, search_->first());
	return "";
}

std::string Plan::judge(const LineFacts& facts)
{
	const bool areTooMany = decisions_.lineLimit == 0 ? facts.share > maxOnCurves : facts.share > 1;
	// With each further limit lengths double; limits that drop no line are passed over.
	const int step = decisions_.lineLimit == 0 ? 1 : 1 + facts.spareDoublings;
	decisions_.lineLimit += areTooMany ? step : 0;
	return returnIf(areTooMany, attempts_.sizes.followLines ? Step::Input : Step::Lines);
}

/// Gaps between feature lines and the front cost samples, the more the closer the lines are; the
/// number of missing samples lowers the radius. Vertices to be kept are a fixed number of samples,
/// however close to each other: only the other samples follow the radius.
float Plan::correctedRadius(const SampleFacts& facts) const
{
	constexpr float aim = 0.985f; // of the wanted number
	// A small surplus of samples is soon merged and not worth another sampling. Where the first
	// sampling is usually right, noise and thin parts may still cost a fifth of the samples or
	// more; with far fewer samples, the components and their topology take the vertices.
	const float     fewest = facts.mayMiss ? 0.98f : 0.85f;
	constexpr float most = 1.035f, fewestByNoise = 0.4f;
	constexpr float maxFixed = 0.7f;
	const float     kept     = float(attempts_.sizes.keptNum);
	const float     target   = float(decisions_.spacedFor());
	const float     wanted   = aim * target - kept;
	const float     share    = (float(facts.num) - kept) / wanted;
	if (!(wanted > 0) || (share >= fewest && share <= most)) return facts.radius;
	if (!facts.mayMiss && !(share >= fewestByNoise && share < 1)) return facts.radius;
	if (float(facts.onCurveNum) - kept > maxFixed * (target - kept)) return facts.radius;
	if (attempts_.sizes.keptNum == 0) return facts.radius * std::sqrt(share);
	// Edges are split for this radius; much smaller disks would hold no vertices.
	constexpr float minRadius = 0.8f, minShare = 0.25f, maxShare = 4;
	return std::max(minRadius * facts.usual,
					facts.radius * std::sqrt(std::clamp(share, minShare, maxShare)));
}

std::string Plan::judge(const SampleFacts& facts)
{
	const int   most      = attempts_.sizes.keptNum == 0 ? maxCorrections : maxCorrectionsWithKept;
	const float corrected = correctedRadius(facts);
	const bool  isCorrected = (facts.mayMiss || !isPaper(options_)) &&
							 attempts_.correctionNum < most && corrected != facts.radius;
	attempts_.correctionNum += isCorrected;
	if (isCorrected) decisions_.radius = corrected;
	return returnIf(isCorrected, Step::Samples);
}

// ---- The mesh and its count: the numbered rules of the table.

/// Begins the next attempt, on the surface at hand if the surface fits.
std::string Plan::tryAgain(std::string note)
{
	attempts_.isCountChosen = true;
	attempts_.correctionNum = 0;
	decisions_.radius.reset();
	const bool dropsLines = attempts_.sizes.followLines && decisions_.way != Way::WithFeatureLines;
	const bool fits       = decisions_.spacedFor() == attempts_.preparedFor && !dropsLines;
	return returnTo(fits ? Step::Lines : Step::Input, std::move(note));
}

/// Takes the mesh. A closed surface has no odd number of faces; the plan aimed at the number below.
std::string Plan::accept(const MeshSize& mesh, std::string note)
{
	const bool isOther =
		!isPaper(options_) && decisions_.counted(mesh) != decisions_.counted(attempts_.asked);
	if (isOther && !isWish()) refuseParity(mesh);
	if (isOther && note.empty()) note = insteadText(mesh) + "the nearest possible number.";
	if (!isPaper(options_)) aimAt(mesh);
	goOn();
	return note;
}

/// The mesh shall have the size, counted as before.
void Plan::aimAt(const MeshSize& mesh)
{
	decisions_.vertexNum = mesh.vertexNum;
	if (decisions_.faceNum > 0) decisions_.faceNum = mesh.faceNum;
}

// ---- Possible sizes, in words that count as the target counts.

/// The next possible size.
MeshSize Plan::above(const MeshSize& possible) const
{
	const std::int64_t step = attempts_.sizes.countStep;
	return possible.plus(asksForFaces() ? partOf(step, 2) : step);
}

std::string Plan::asked() const
{
	return asksForFaces() ? text(attempts_.asked.faceNum) + " faces"
						  : text(attempts_.asked.vertexNum + decisions_.addedNum) + " vertices";
}

/// The size in words, faces first if the target counts faces.
std::string Plan::sizeText(const MeshSize& mesh) const
{
	const std::string vertices = text(mesh.vertexNum) + " vertices";
	return asksForFaces() ? text(mesh.faceNum) + " faces (" + vertices + ")" : vertices;
}

std::string Plan::insteadText(const MeshSize& mesh) const
{
	return "The result has " + sizeText(mesh) + " instead of " + asked() + ", ";
}

/// "; the smallest possible numbers are 14 and 16 (9 and 10 vertices)." One number if both sizes
/// are the same.
std::string Plan::possibleText(const std::string& which, const MeshSize& first,
							   const MeshSize& last) const
{
	const bool areTwo = first.vertexNum != last.vertexNum;
	const auto both   = [areTwo](std::int64_t a, std::int64_t b) {
        return text(a) + (areTwo ? " and " + text(b) : "");
	};
	const std::string vertices = both(first.vertexNum, last.vertexNum);
	return "; " + which + " possible number" + (areTwo ? "s" : "") +
		   (had_.empty() ? "" : " found") + (areTwo ? " are " : " is ") +
		   (asksForFaces() ? both(first.faceNum, last.faceNum) + " (" + vertices + " vertices)"
						   : vertices) +
		   ".";
}

void Plan::refuseBelow(const std::string& fault, const MeshSize& smallest) const
{
	const MeshSize last = asksForFaces() ? above(smallest) : smallest;
	refuse(fault + possibleText("the smallest", smallest, last), smallest);
}

/// Refuses a count that is no multiple of the step: no vertex may enter or leave the border.
void Plan::refuseParity(const MeshSize& lower) const
{
	throw Failure(Status::PromiseBroken,
				  cannotBe(asked()) + possibleText("the nearest", lower, above(lower)), lower);
}

std::string Plan::withoutFeatureLines(const std::string& note)
{
	decisions_.way = Way::WithoutFeatureLines;
	return tryAgain(note);
}

std::string Plan::withRaggedBorder()
{
	decisions_.keepsRaggedBorder = true;
	return withoutFeatureLines(
		"With a smooth border some triangles would be degenerate, so the border is not smoothed.");
}

std::string Plan::withOpenSeams()
{
	decisions_.sewing     = Sewing::Never;
	attempts_.preparedFor = 0; // the surface at hand is sewn
	return withoutFeatureLines(
		"With sewn seams some triangles would be degenerate, so the seams stay open.");
}

/// Accepts or refuses the count reached with vertices to be kept. There is no other way to the
/// count.
std::string Plan::nearestWithKept(const MeshSize& reached)
{
	if (isWish()) {
		return accept(reached, insteadText(reached) +
								   "the nearest number reached with the vertices to be kept.");
	}
	if (decisions_.faceNum > 0 && std::abs(reached.faceNum - decisions_.faceNum) == 1)
		refuseParity(reached);
	refuse(cannotBe(asked()) + " that include the " + text(attempts_.sizes.keptNum) +
			   " vertices to be kept" + possibleText("a", reached, reached),
		   reached);
}

/// With the smallest count, no vertex is left for the shape of borders between many holes. A few
/// vertices more keep the shape: on a terrain with 1,700 holes the distance falls to a thirtieth.
std::string Plan::raiseTo(const MeshSize& smallest)
{
	attempts_.isRaised = true;
	// Collapses from the right spacing did not come down to this count, and would not from more
	// samples.
	const bool         areMany = smallest.vertexNum > fewVertices;
	const bool         isStuck = areMany && attempts_.reachedNum > smallest.vertexNum;
	const std::int64_t more    = areMany && !isStuck ? smallest.vertexNum / partForShape : 0;
	const MeshSize     raised  = smallest.plus(more);
	std::string        note    = insteadText(raised);
	note += more == 0 ? "the smallest number reached."
					  : "a few more than the smallest number reached, " + sizeText(smallest) + ".";
	attempts_.asked = raised;
	aimAt(raised);
	if (isStuck) return accept(raised, note);
	return withoutFeatureLines(note);
}

std::string Plan::beginSearch(const MeshSize& from)
{
	attempts_.searchedFrom = from;
	attempts_.searchedNum  = 1;
	aimAt(from);
	return withoutFeatureLines("");
}

std::string Plan::endSearchAt(const MeshSize& found)
{
	if (found.vertexNum == attempts_.asked.vertexNum) return accept(found, "");
	if (mayDiffer())
		return accept(found, insteadText(found) + "with which some triangles would be degenerate.");
	refuse("With " + asked() + " some triangles would be degenerate" +
			   possibleText("a", found, found),
		   found);
}

/// After the last count the search returns to its first count. If the first count is not the wanted
/// count, a target that is no wish is refused.
std::string Plan::goOnSearching()
{
	const bool isOver = attempts_.searchedNum == maxSearchedCounts;
	const bool isAnswer =
		mayDiffer() || attempts_.searchedFrom.vertexNum == attempts_.asked.vertexNum;
	if (isOver && !isAnswer) refuseBelow(cannotBe(asked()), attempts_.searchedFrom);
	++attempts_.searchedNum;
	decisions_.faceNum   = 0;
	decisions_.vertexNum = isOver ? attempts_.searchedFrom.vertexNum
								  : decisions_.vertexNum + partOf(decisions_.vertexNum, 4);
	return withoutFeatureLines("");
}

std::string Plan::judgeAreas(const RelaxationFacts& facts)
{
	if (attempts_.searchedNum == 0) {
		if (!needsSearch(facts) || !mayReturn()) return accept(facts, "");
		return beginSearch(facts);
	}
	if (attempts_.searchedNum > maxSearchedCounts) return accept(facts, "");
	if (!facts.hasZeroAreas) return endSearchAt(facts);
	return mayReturn() ? goOnSearching() : accept(facts, "");
}

/// The count reached by topology is the smallest possible count.
std::string Plan::judgeSmallest(const RelaxationFacts& facts)
{
	if (attempts_.isRaised || attempts_.searchedNum > 0) return judgeAreas(facts);
	if (isWish() && mayReturn()) return raiseTo(facts);
	if (decisions_.counted(facts) < decisions_.counted(decisions_)) refuseParity(facts);
	if (!needsSearch(facts) || !mayReturn()) refuseBelow(cannotBe(asked()), facts);
	return beginSearch(facts);
}

std::string Plan::judge(const RelaxationFacts& facts)
{
	const bool isReached = decisions_.counted(facts) == decisions_.counted(decisions_);
	// With a target of faces, the vertex count is known only now.
	if (decisions_.faceNum > 0) attempts_.asked.vertexNum = isReached ? facts.vertexNum : 0;
	if (isReached) decisions_.vertexNum = facts.vertexNum;
	const bool misses = !isPaper(options_) && !isReached;
	if (mayReturn()) {
		if (facts.hasFeatureLines && misses) {
			return withoutFeatureLines(cannotBe(asked()) +
									   " and feature lines, so the result has no feature lines.");
		}
		if (facts.hasFeatureLines && facts.hasZeroAreas)
			return withoutFeatureLines("With feature lines some triangles would be degenerate, so "
									   "the result has no feature lines.");
		if (facts.hasSmoothBorder && facts.hasZeroAreas) return withRaggedBorder();
		if (facts.isSewn && facts.hasZeroAreas) return withOpenSeams();
	}
	if (attempts_.sizes.keptNum > 0) return misses ? nearestWithKept(facts) : accept(facts, "");
	if (!misses) return judgeAreas(facts);
	if (decisions_.way != Way::ByTopology && mayReturn()) {
		attempts_.reachedNum = facts.vertexNum;
		decisions_.way       = Way::ByTopology;
		return tryAgain("");
	}
	return judgeSmallest(facts);
}

// ---- From the mesh to the result.

std::string Plan::judge(const FitFacts& facts)
{
	return returnIf(facts.areLinesCrowded, Step::Release);
}

/// Sheets intersect beside a junction, or faces beside a kept border. If the target is a wish, the
/// next mesh has half as many vertices again; else the run refuses.
std::string Plan::separateByMore(const ContactFacts& facts)
{
	const MeshSize next     = facts.plus(facts.before + partOf(facts.before, 2) - facts.vertexNum);
	const bool     isFirst  = attempts_.separatedFrom == 0;
	attempts_.separatedFrom = isFirst ? attempts_.asked.vertexNum : attempts_.separatedFrom;
	const bool isBesideBorder =
		(options_.boundary == BoundaryMode::Keep || options_.selectedOnly) &&
		!keepsJunctions(options_);
	const std::string fault =
		"With " + asked() +
		(isBesideBorder ? " triangles beside the kept border" : " sheets that meet in junctions") +
		" would intersect each other";
	if (!isWish() || next.vertexNum > mostForSheets * attempts_.separatedFrom || !mayReturn()) {
		refuse(fault + "; smaller triangles there, or about " + sizeText(next) + ", are needed.",
			   next);
	}
	attempts_.asked = next;
	aimAt(next);
	decisions_.addedNum     = 0;
	attempts_.isRaised      = true;
	attempts_.refinementNum = 0;
	return tryAgain(isFirst ? fault + ", so the result has more triangles." : "");
}

std::string Plan::judge(const ContactFacts& facts)
{
	if (facts.isRefused && facts.vertexNum <= facts.before) return separateByMore(facts);
	const std::string fault = "With " + asked() + " the surface would intersect itself";
	if (facts.isRefused) refuseBelow(fault, facts);
	goOn();
	const bool isOther = decisions_.faceNum > 0 ? facts.faceNum != decisions_.faceNum
												: facts.vertexNum != facts.before;
	if (isOther && !mayDiffer()) refuse(fault + ", but not with " + sizeText(facts) + ".", facts);
	// The repair of small angles may have moved vertices to the border, for as many faces inside.
	if (isOther || decisions_.faceNum > 0) aimAt(facts.plus(-decisions_.addedNum));
	return isOther ? insteadText(facts) + "the smallest number reached without self-intersections."
				   : "";
}

std::string Plan::judge(const RefinementFacts& facts)
{
	decisions_.addedNum += facts.addedNum;
	++attempts_.refinementNum;
	return returnIf(facts.hasChanged, Step::Contacts);
}

// ---- Several meshes for one result.

std::string Plan::judge(const ErrorFacts& facts)
{
	trial_.error = facts.error;
	trial_.share = facts.share;
	goOn();
	return "";
}

std::string Plan::judge(const ExportFacts& facts)
{
	goOn();
	isBest_ = true;
	if (decisions_.purpose == Purpose::CountToBeHad) {
		// With the preset paper the mesh has some more or fewer than were asked for.
		had_.push_back(isPaper(options_) ? tried_ : MeshSize(facts));
		tryToHave(above(had_.back()));
	}
	if (decisions_.purpose != Purpose::Trial) return "";
	trial_.vertexNum = facts.vertexNum;
	trial_.addedNum  = decisions_.addedNum;
	++trialNum_;
	isBest_ = trialNum_ == 1 || isBetter(trial_, best_, goal().largest);
	if (isBest_) best_ = trial_;
	const std::int64_t next = search_->after(decisions_.vertexNum, trial_);
	if (next > 0 && mayReturn()) {
		++returnNum_;
		beginRun(Purpose::Trial, next);
	}
	return "";
}

std::string Plan::outcomeForError() const
{
	if (search_->found() > 0) {
		return provenText(best_.vertexNum, best_.error, request_.diagonal) + " The search took " +
			   text(trialNum_) + (trialNum_ == 1 ? " trial." : " trials.");
	}
	std::string missed = missedText(best_, goal().largest, request_.diagonal);
	if (!options_.allowNearest) throw Failure(Status::PromiseBroken, missed);
	return missed;
}

/// A refusal names a possible count. A count that topology allows may still need
/// self-intersections, so that the plan first makes a mesh with the count.
void Plan::judge(const Failure& failure)
{
	const bool namesCount = failure.possible.vertexNum > 0 && options_.guard;
	const bool isFirst    = decisions_.purpose == Purpose::Answer && namesCount;
	if (!isFirst && decisions_.purpose != Purpose::CountToBeHad) throw failure;
	if (!isFirst && (!namesCount || isNamed())) throw refusalAtLast();
	named_ = failure.possible;
	if (isFirst) {
		refusal_ = failure;
		refused_ = asked();
		return tryToHave(named_);
	}
	// On thin parts each number misses by as much as the number before: the steps grow.
	constexpr int      even   = 3; // tries
	const std::int64_t missed = named_.vertexNum - tried_.vertexNum;
	tryToHave(missed > 0 ? named_.plus(std::max(0, triedNum_ - even) * missed)
						 : above(named_.plus(partOf(named_.vertexNum, 20))));
}

/// Begins a mesh with a size.
void Plan::tryToHave(const MeshSize& size)
{
	// More vertices do not help sheets at one place, so a count for sheets is no promise.
	const std::int64_t most = attempts_.separatedFrom > 0 ? fewVertices : mostTriedVertices;
	const bool isSmall = asksForFaces() ? size.faceNum <= mostTriedFaces : size.vertexNum <= most;
	const bool mayTry  = isSmall && triedNum_ < maxTriedCounts;
	if (isNamed() || !mayTry || !mayReturn()) throw refusalAtLast();
	isBest_ = false;
	++triedNum_;
	++returnNum_;
	tried_ = size;
	beginRun(Purpose::CountToBeHad, asksForFaces() ? 0 : size.vertexNum);
}

/// With a target of faces, or where only multiples of a number are possible, two numbers are named.
bool Plan::isNamed() const
{
	const bool areTwo = asksForFaces() || refusal_->status == Status::PromiseBroken;
	return had_.size() == (areTwo ? 2 : 1);
}

Failure Plan::refusalAtLast() const
{
	if (had_.empty() && named_.vertexNum != refusal_->possible.vertexNum) {
		return {refusal_->status,
				cannotBe(refused_) + "; about " + sizeText(named_) + " or more are needed.",
				named_};
	}
	const bool isSmall = refusal_->status == Status::CountTooSmall;
	if (had_.empty() || (!asksForFaces() && had_[0].vertexNum == refusal_->possible.vertexNum))
		return *refusal_;
	return {refusal_->status,
			cannotBe(refused_) +
				possibleText(isSmall ? "the smallest" : "the nearest", had_.front(), had_.back()),
			had_.front()};
}

} // namespace gpr
