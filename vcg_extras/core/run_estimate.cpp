// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_estimate.h"

#include <vcg_extras/core/base/portable_math.h>
#include <vcg_extras/core/input/memory_need.h>
#include <vcg_extras/core/sampling/target.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

namespace gpr {

namespace {

/// Microseconds on one thread per face of the input and per vertex of the result; fitted to runs
/// with 10⁵ to 8·10⁶ faces at 1 to 200 %.
struct Rate {
	double perFace;
	double perVertex;
};
constexpr Rate samplingRate  = {0.6, 6};
constexpr Rate plainRate     = {0.6, 10}; // without the fit
constexpr Rate fittedRate    = {0.9, 25};
constexpr Rate removalRate   = {1.2, 20}; // vertex by vertex
constexpr Rate detectionRate = {2, 0};
/// Runs in a search for the count of an error bound, on average.
constexpr double trialsForError = 5;
/// Least number of faces per vertex of the result after long edges are split.
constexpr double facesPerResultVertex = 6;
/// Exponent of the number of threads in the speed-up.
constexpr double threadPower = 0.9;

Rate rateOf(Tool tool, const RemeshOptions& o)
{
	if (tool == SamplingTool) return samplingRate;
	if (tool == FeatureTool) return detectionRate;
	if (isPaper(o)) return removalRate;
	return tool == RetriangulateTool || !isFittedInRounds(o) ? plainRate : fittedRate;
}

double shareOfSelected(const MeshView& input, const RemeshOptions& o)
{
	if (!o.selectedOnly || input.selectedFace == nullptr || input.faceNum == 0) return 1;
	const auto* const end = input.selectedFace + input.faceNum;
	const auto        num = input.faceNum - std::size_t(std::count(input.selectedFace, end, 0));
	return double(num) / double(input.faceNum);
}

double vertexNumOf(const MeshView& input, const RemeshOptions& o)
{
	const bool isCount = o.targetMode == TargetMode::VertexNum ||
						 o.targetMode == TargetMode::FaceNum || o.targetMode == TargetMode::Percent;
	if (isCount) return wantedVertexNum(std::int64_t(input.vertexNum), o, 0, 1);
	const MeshExtent extent = extentOf(input);
	const double     n =
		wantedVertexNum(std::int64_t(input.vertexNum), inMeshUnits(input, o), extent.area, 1);
	return std::isfinite(n) ? n : 0; // mesh or length of size 0
}

int threadNumOf(const RemeshOptions& o)
{
	return std::max(1, o.threads > 0 ? o.threads : int(std::thread::hardware_concurrency()));
}

} // namespace

RunEstimate estimateRun(const MeshView& input, const RemeshOptions& options, Tool tool) noexcept
{
	const double share = shareOfSelected(input, options);
	const double faces = share * double(input.faceNum);
	const bool   isByCount =
		options.targetMode == TargetMode::VertexNum || options.targetMode == TargetMode::FaceNum;
	const Rate  rate = rateOf(tool, options);
	RunEstimate estimate;
	if (tool != FeatureTool)
		estimate.vertexNum =
			std::min(maxResultVertices, (isByCount ? 1 : share) * vertexNumOf(input, options));
	const double microseconds = rate.perFace * faces + rate.perVertex * estimate.vertexNum;
	estimate.seconds = 1e-6 * microseconds / portable::pow(threadNumOf(options), threadPower);
	if (options.targetMode == TargetMode::MaxError && tool == RemeshTool)
		estimate.seconds *= trialsForError;
	const double split = std::max(faces, facesPerResultVertex * estimate.vertexNum);
	estimate.bytes     = bytesNeeded(split, estimate.vertexNum);
	return estimate;
}

std::string estimateText(const RunEstimate& estimate)
{
	// Two digits, without an exponent.
	const double seconds = std::max(0.1, estimate.seconds);
	double       unit    = 0.01;
	while (seconds >= 100 * unit)
		unit *= 10;
	char text[80];
	std::snprintf(text, sizeof text, "about %.15g s and %.2g GB of memory",
				  unit * std::round(seconds / unit), std::max(0.01, 1e-9 * estimate.bytes));
	return text;
}

} // namespace gpr
