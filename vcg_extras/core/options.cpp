// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include <initializer_list>
#include <limits>

namespace gpr {

namespace {

/// A condition that options must keep, and the sentence if they do not.
struct Rule {
	bool        isKept;
	const char* complaint;
};

void addComplaints(std::initializer_list<Rule> rules, std::vector<std::string>& complaints)
{
	for (const Rule& rule : rules)
		if (!rule.isKept) complaints.push_back(rule.complaint);
}

bool isWithin(double value, double least, double most)
{
	return value >= least && value <= most; // false for NaN
}

bool isPositive(double value, double most = std::numeric_limits<double>::max())
{
	return value > 0 && value <= most;
}

void checkTarget(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	constexpr double mostCount = 2147483647;
	const TargetMode mode      = o.targetMode;
	addComplaints(
		{{mode != TargetMode::VertexNum || isWithin(double(o.targetVertexNum), 1, mostCount),
		  "The number of vertices must be between 1 and 2147483647."},
		 {mode != TargetMode::FaceNum || isWithin(double(o.targetFaceNum), 1, mostCount),
		  "The number of faces must be between 1 and 2147483647."},
		 {mode != TargetMode::Percent || isPositive(o.targetPercent, 10000),
		  "The percentage must be above 0 and at most 10000."},
		 {mode != TargetMode::EdgeLength || isPositive(o.targetEdgeLen),
		  "The edge length must be a finite number above 0."},
		 {mode != TargetMode::Detail || o.targetDetail != Detail::None, "No detail is given."},
		 {mode != TargetMode::MaxError || isPositive(o.targetMaxError),
		  "The largest error must be a finite number above 0."}},
		complaints);
}

void checkDensity(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	const bool haveSameUnit = o.minEdgeIsPercent == o.maxEdgeIsPercent;
	addComplaints(
		{{isWithin(o.lambda, 0, 1e6), "Lambda must be between 0 and 1000000."},
		 {isWithin(o.minEdge, 0, 1e300) && isWithin(o.maxEdge, 0, 1e300),
		  "The least and the largest edge must be finite numbers, 0 or above."},
		 {!(haveSameUnit && o.maxEdge > 0 && o.minEdge > o.maxEdge),
		  "The least edge must not be longer than the largest edge."},
		 {isWithin(o.growth, 1.05, 2), "The growth must be between 1.05 and 2."},
		 {!o.adapt || isWithin(*o.adapt, 0, 1), "The adaptivity must be between 0 and 1."}},
		complaints);
}

void checkFeatures(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	const FeatureThresholds& t = o.featureThresholds;
	addComplaints({{isWithin(o.featureAngleDeg, 5, 175),
					"The feature angle must be between 5 and 175 degrees."},
				   {o.featureDiskScale == 0 || isWithin(o.featureDiskScale, 0.05, 1),
					"The feature disk scale must be between 0.05 and 1, or 0."},
				   {isPositive(t.support, 100),
					"The feature support must be above 0 and at most 100 mean edges."},
				   {isPositive(t.strongDeg, 180),
					"The strong feature angle must be above 0 and at most 180 degrees."},
				   {isPositive(t.weakDeg, t.strongDeg),
					"The weak feature angle must be above 0 and at most the strong feature angle."},
				   {isWithin(t.minLength, 0, 1e6),
					"The least feature length must be between 0 and 1000000 supports."}},
				  complaints);
}

void checkCombinations(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	const auto isLength = [](double length) { return isWithin(length, 0, 1e300); };
	const bool isOther  = o.boundary != BoundaryMode::Resample && o.boundary != BoundaryMode::Match;
	const bool areLengths  = isLength(o.period.x) && isLength(o.period.y) && isLength(o.period.z);
	const bool isMatched   = o.boundary == BoundaryMode::Match || isPeriodic(o);
	const bool isSymmetric = o.symmetry != Symmetry::Off;
	addComplaints(
		{{areLengths, "The lengths of a periodic cell must be finite numbers, 0 or above."},
		 {!(areLengths && isPeriodic(o) && (isOther || o.selectedOnly)),
		  "A periodic cell needs matched borders and the whole surface."},
		 {o.dropComponentsBelow >= 0,
		  "The least number of faces of a component must not be negative."},
		 {isWithin(o.timeLimitSeconds, 0, 1e9),
		  "The time limit must be between 0 and 1000000000 seconds."},
		 {!(isSymmetric && (o.selectedOnly || isPaper(o))),
		  "A symmetric result is not possible with the preset paper or for selected faces."},
		 {!(isSymmetric && (isMatched || keepsJunctions(o))),
		  "A symmetric result is not possible with matched borders, a periodic cell or kept "
		  "junctions."},
		 {isWithin(o.threads, 0, 1024), "The number of threads must be between 0 and 1024."}},
		complaints);
}

} // namespace

bool asksForFeatureRegion(const RemeshOptions& o)
{
	if (o.featureRegion != FeatureRegion::Auto) return o.featureRegion != FeatureRegion::None;
	return o.featureDiskScale > 0;
}

bool mayUseSelectedVertices(const RemeshOptions& o)
{
	return asksForFeatureRegion(o) && o.featureRegion != FeatureRegion::Detected;
}

void resolveFeatureRegion(bool anySelected, RemeshOptions& o)
{
	constexpr double usualScale = 0.5;
	if (!asksForFeatureRegion(o)) {
		o.featureRegion = FeatureRegion::None;
	}
	else if (o.featureRegion == FeatureRegion::Auto) {
		o.featureRegion = anySelected ? FeatureRegion::Selection : FeatureRegion::Detected;
	}
	if (o.featureDiskScale == 0 && !isPaper(o)) o.featureDiskScale = usualScale;
}

double resolveAdapt(const RemeshOptions& o, bool makesMesh)
{
	constexpr double usual = 0.1;
	if (isPaper(o)) return 0;
	if (o.adapt) return *o.adapt;
	const bool hasOther = o.lambda > 0 || o.targetMode == TargetMode::Sizes;
	const bool hasUse   = makesMesh && isFittedInRounds(o) && !hasOther;
	if (!hasUse) return 0;
	return o.targetMode == TargetMode::MaxError ? 1 : usual;
}

double detailError(Detail detail)
{
	if (detail == Detail::Coarse) return 0.01;
	return detail == Detail::Normal ? 0.003 : 0.001;
}

std::vector<std::string> validate(const RemeshOptions& o)
{
	std::vector<std::string> complaints;
	checkTarget(o, complaints);
	addComplaints({{isWithin(o.umbrellaSteps, 0, 1000),
					"The number of umbrella steps must be between 0 and 1000."},
				   {isWithin(o.flipPasses, 0, 1000),
					"The number of flip passes must be between 0 and 1000."}},
				  complaints);
	checkDensity(o, complaints);
	checkFeatures(o, complaints);
	checkCombinations(o, complaints);
	return complaints;
}

std::vector<std::string> optionsWithoutEffect(const RemeshOptions& o)
{
	std::vector<std::string> sentences;
	const RemeshOptions      defaults;
	const bool               isOfPaper = isPaper(o), hasRegion = asksForFeatureRegion(o);
	addComplaints(
		{{!(o.adapt > 0 && isOfPaper), "The adaptivity has no effect with the preset paper."},
		 {!((o.minEdge > 0 || o.maxEdge > 0) && isOfPaper),
		  "The least and the largest edge have no effect with the preset paper."},
		 {!(o.junctions == JunctionMode::Keep && isOfPaper),
		  "Junctions are not kept with the preset paper."},
		 {o.umbrellaSteps == defaults.umbrellaSteps || isOfPaper,
		  "The umbrella steps have no effect without the preset paper."},
		 {o.flipPasses == defaults.flipPasses || isOfPaper,
		  "The number of flip passes has no effect without the preset paper."},
		 {o.featureDiskScale == defaults.featureDiskScale || hasRegion,
		  "The feature disk scale has no effect without a feature region."},
		 {!(hasRegion && o.featureDiskScale == 1),
		  "A feature region has no effect while the feature disk scale is 1."}},
		sentences);
	return sentences;
}

} // namespace gpr
