// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_REPORT_JSON_PARTS_H
#define VCG_EXTRAS_IO_REPORT_JSON_PARTS_H

#include <vcg_extras/core/report.h>

#include <nlohmann/json.hpp>
#include <string>

// The common parts of the program's JSON texts.

namespace gpr::app {

using Json = nlohmann::ordered_json; // keeps the keys in the order of writing

Json programJson();
Json figuresJson(const MeshFigures& m);
/// The same, after the file's name and precision.
Json fileJson(const std::string& path, bool doublePrecision, const MeshFigures& figures);
Json qualityJson(const QualityFigures& q);
/// Of one direction, in mesh units and in percent of a diagonal; 0 % for the diagonal 0.
Json distanceJson(const SurfaceDistance& d, double diagonal);

/// Proven bounds of the largest distance, of both directions and of each, in the same units.
Json boundsJson(const MutualBounds& b, double diagonal);

/// The text of a whole file. Invalid UTF-8 from a file name is repaired rather than refused.
std::string textOf(const Json& json);

} // namespace gpr::app

#endif
