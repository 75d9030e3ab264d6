// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "border_smoothing.h"

#include "loading.h"

#include <vcg_extras/core/input/border_spikes.h>
#include <vcg_extras/core/input/flat_pieces.h>
#include <vcg_extras/core/input/load.h>
#include <vcg_extras/core/mesh/measure.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace gpr {

namespace {

/// Shares below this are not worth a word.
constexpr double leastShare = 5e-4;

/// What part of `before` is gone.
double shareLost(double before, double after)
{
	return before > 0 ? std::max(0.0, 1 - after / before) : 0;
}

std::string sentenceWith(const char* format, double number)
{
	char sentence[160];
	std::snprintf(sentence, sizeof sentence, format, number);
	return sentence;
}

} // namespace

bool cutBorderSpikes(RunContext& run, Prepared& p)
{
	if (run.options.boundary != BoundaryMode::Smooth) return false;
	const double unit             = 1 / p.surface.frame.scale;
	run.report.border             = BorderFigures();
	BorderFigures& border         = run.report.border;
	border.length                 = unit * borderLength(p.surface.mesh);
	border.isSmooth               = border.length > 0;
	border.area                   = unit * unit * p.area;
	const std::vector<int> spikes = findBorderSpikes(p.surface.mesh, idealEdge(p));
	if (spikes.empty()) return false;
	IndexedMesh mesh = withoutFaces(p.surface, spikes, border.cutFaceNum);
	p.area           = measureFaces(mesh, run.workers).area;
	border.cutArea   = border.area - unit * unit * p.area;
	connectOrRepair(run, mesh, p.surface);
	return true;
}

void tellSmoothBorder(RunContext& run, const Surface& surface, const ResultMesh& result)
{
	BorderFigures& border = run.report.border;
	if (!border.isSmooth) return;
	run.report.input.area += border.cutArea; // it has been measured without
	border.resultLength  = borderLength(result.mesh) / surface.frame.scale;
	const double shorter = shareLost(border.length, border.resultLength);
	const double cut     = border.cutArea / border.area;
	if (shorter < leastShare && cut < leastShare) return;
	std::string note =
		sentenceWith("The border is %.2g %% shorter than that of the input.", 100 * shorter);
	if (cut >= leastShare)
		note += sentenceWith(" Spikes narrower than an edge were cut off; they have %.2g %% of the "
							 "area.",
							 100 * cut);
	run.notes.push_back(note);
}

} // namespace gpr
