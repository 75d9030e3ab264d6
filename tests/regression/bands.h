// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_REGRESSION_BANDS_H
#define GPR_TESTS_REGRESSION_BANDS_H

#include <vcg_extras/core/options.h>

#include <cstdint>
#include <ostream>
#include <vector>

namespace gpr::test {

/// The size of a result as an option.
struct Target {
	TargetMode   mode;
	double       value;            ///< vertices, or percent of the input's vertices or its diagonal
	std::int64_t mostVertices = 0; ///< TargetMode::MaxError only
};

/// Requirements on a result beside its figures.
enum Trait : unsigned {
	None     = 0,
	Apart    = 1, ///< no two faces touch, and at most a fifth of the vertices were made anew
	NoLines  = 2, ///< the model is smooth: no feature line is found
	Repaired = 4, ///< the model is no manifold: its repairs are counted
};

/// A figure without a requirement.
constexpr double any = -1;

/// A run on a model, and the requirements on its result.
struct Band {
	const char* name;    ///< of the test
	const char* file;    ///< see findModel
	const char* options; ///< words, see applyWords
	Target      target;
	// at least
	double radiusRatio; ///< mean 2r/R
	double aspectRatio; ///< mean
	double angle;       ///< smallest, degrees
	double valence6;    ///< % of the vertices
	// at most
	double below30;   ///< % of the triangles have a smaller angle
	double inverted;  ///< faces against the surface
	double rms;       ///< % of the diagonal, the larger of both ways; so are the next two
	double p999;      ///< 99.9 % of the surface is nearer
	double hausdorff; ///< proven
	double rim;       ///< largest distance of the borders in mean edges, both ways
	double creases; ///< largest distance from the input's crease edges to the result's, mean edges
	unsigned traits;
};

std::ostream& operator<<(std::ostream& out, const Band& band);

/// The table of all runs.
std::vector<Band> bands();

/// Sets options by the words of a row: "fast" and "paper" (presets), "even" and "adapt1" (adapt 0
/// and 1), "keep", "free" and "smooth" (borders), "lines" (every crease edge is a feature line),
/// "region" (a detected feature region). "open" is no option, see isOpened. Throws std::logic_error
/// for another word.
void applyWords(const char* words, RemeshOptions& options);

/// Whether the lowest fifth of the model is cut off before the run, for a model with a border.
bool isOpened(const Band& band);

} // namespace gpr::test

#endif
