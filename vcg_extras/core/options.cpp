// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.h"

#include <cmath>

namespace gpr {

namespace {

void checkTarget(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	switch (o.targetMode) {
	case TargetMode::VertexNum:
		if (o.targetVertexNum < 1 || o.targetVertexNum > 2147483647) {
			complaints.push_back("The number of vertices must be between 1 and 2147483647.");
		}
		break;
	case TargetMode::FaceNum:
		if (o.targetFaceNum < 1 || o.targetFaceNum > 2147483647) {
			complaints.push_back("The number of faces must be between 1 and 2147483647.");
		}
		break;
	case TargetMode::Percent:
		if (!(o.targetPercent > 0 && o.targetPercent <= 10000)) {
			complaints.push_back("The percentage must be above 0 and at most 10000.");
		}
		break;
	case TargetMode::EdgeLength:
		if (!(o.targetEdgeLen > 0 && std::isfinite(o.targetEdgeLen))) {
			complaints.push_back("The edge length must be a finite number above 0.");
		}
		break;
	case TargetMode::Sizes:
		break;
	case TargetMode::Detail:
		if (o.targetDetail == Detail::None) complaints.push_back("No detail is given.");
		break;
	case TargetMode::MaxError:
		if (!(o.targetMaxError > 0 && std::isfinite(o.targetMaxError))) {
			complaints.push_back("The largest error must be a finite number above 0.");
		}
		break;
	}
}

bool isWithin(double value, double least, double most)
{
	return value >= least && value <= most; // false for NaN
}

void checkDensity(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	if (!isWithin(o.lambda, 0, 1e6)) {
		complaints.push_back("Lambda must be between 0 and 1000000.");
	}
	if (!isWithin(o.minEdge, 0, 1e300) || !isWithin(o.maxEdge, 0, 1e300))
		complaints.push_back("The least and the largest edge must be finite numbers, 0 or above.");
	const bool haveSameUnit = o.minEdgeIsPercent == o.maxEdgeIsPercent;
	if (haveSameUnit && o.maxEdge > 0 && o.minEdge > o.maxEdge)
		complaints.push_back("The least edge must not be longer than the largest edge.");
	if (!isWithin(o.growth, 1.05, 2))
		complaints.push_back("The growth must be between 1.05 and 2.");
	if (o.adapt && !isWithin(*o.adapt, 0, 1)) {
		complaints.push_back("The adaptivity must be between 0 and 1.");
	}
}

void checkFeatures(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	const FeatureThresholds& t = o.featureThresholds;
	if (!isWithin(o.featureAngleDeg, 5, 175)) {
		complaints.push_back("The feature angle must be between 5 and 175 degrees.");
	}
	if (o.featureDiskScale != 0 && !isWithin(o.featureDiskScale, 0.05, 1)) {
		complaints.push_back("The feature disk scale must be between 0.05 and 1, or 0.");
	}
	if (!(t.support > 0 && t.support <= 100)) {
		complaints.push_back("The feature support must be above 0 and at most 100 mean edges.");
	}
	if (!(t.strongDeg > 0 && t.strongDeg <= 180)) {
		complaints.push_back("The strong feature angle must be above 0 and at most 180 degrees.");
	}
	if (!(t.weakDeg > 0 && t.weakDeg <= t.strongDeg)) {
		complaints.push_back(
			"The weak feature angle must be above 0 and at most the strong feature angle.");
	}
	if (!isWithin(t.minLength, 0, 1e6)) {
		complaints.push_back("The least feature length must be between 0 and 1000000 supports.");
	}
}

void checkPeriod(const RemeshOptions& o, std::vector<std::string>& complaints)
{
	for (const double length : {o.period.x, o.period.y, o.period.z}) {
		if (isWithin(length, 0, 1e300)) continue;
		complaints.push_back("The lengths of a periodic cell must be finite numbers, 0 or above.");
		return;
	}
	const bool isOther = o.boundary != BoundaryMode::Resample && o.boundary != BoundaryMode::Match;
	if (isPeriodic(o) && (isOther || o.selectedOnly)) {
		complaints.push_back("A periodic cell needs matched borders and the whole surface.");
	}
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
	switch (detail) {
	case Detail::Coarse:
		return 0.01;
	case Detail::Normal:
		return 0.003;
	default:
		return 0.001;
	}
}

std::vector<std::string> validate(const RemeshOptions& o)
{
	std::vector<std::string> complaints;
	checkTarget(o, complaints);
	if (o.umbrellaSteps < 0 || o.umbrellaSteps > 1000) {
		complaints.push_back("The number of umbrella steps must be between 0 and 1000.");
	}
	if (o.flipPasses < 0 || o.flipPasses > 1000) {
		complaints.push_back("The number of flip passes must be between 0 and 1000.");
	}
	checkDensity(o, complaints);
	checkFeatures(o, complaints);
	checkPeriod(o, complaints);
	if (o.dropComponentsBelow < 0) {
		complaints.push_back("The least number of faces of a component must not be negative.");
	}
	if (!isWithin(o.timeLimitSeconds, 0, 1e9)) {
		complaints.push_back("The time limit must be between 0 and 1000000000 seconds.");
	}
	if (o.symmetry != Symmetry::Off && (o.selectedOnly || isPaper(o))) {
		complaints.push_back("A symmetric result is not possible with the preset paper or for "
							 "selected faces.");
	}
	const bool isMatched = o.boundary == BoundaryMode::Match || isPeriodic(o);
	if (o.symmetry != Symmetry::Off && (isMatched || keepsJunctions(o))) {
		complaints.push_back("A symmetric result is not possible with matched borders, a periodic "
							 "cell or kept junctions.");
	}
	if (o.threads < 0 || o.threads > 1024) {
		complaints.push_back("The number of threads must be between 0 and 1024.");
	}
	return complaints;
}

std::vector<std::string> optionsWithoutEffect(const RemeshOptions& o)
{
	std::vector<std::string> sentences;
	const RemeshOptions      defaults;
	const bool               hasRegion = asksForFeatureRegion(o);
	if (o.adapt > 0 && isPaper(o))
		sentences.push_back("The adaptivity has no effect with the preset paper.");
	if ((o.minEdge > 0 || o.maxEdge > 0) && isPaper(o))
		sentences.push_back("The least and the largest edge have no effect with the preset paper.");
	if (o.junctions == JunctionMode::Keep && isPaper(o))
		sentences.push_back("Junctions are not kept with the preset paper.");
	if (o.umbrellaSteps != defaults.umbrellaSteps && !isPaper(o))
		sentences.push_back("The umbrella steps have no effect without the preset paper.");
	if (o.flipPasses != defaults.flipPasses && !isPaper(o))
		sentences.push_back("The number of flip passes has no effect without the preset paper.");
	if (o.featureDiskScale != defaults.featureDiskScale && !hasRegion)
		sentences.push_back("The feature disk scale has no effect without a feature region.");
	if (hasRegion && o.featureDiskScale == 1)
		sentences.push_back("A feature region has no effect while the feature disk scale is 1.");
	return sentences;
}

} // namespace gpr
