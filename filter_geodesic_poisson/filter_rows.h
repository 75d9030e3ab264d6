// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_FILTER_ROWS_H
#define FILTER_GEODESIC_POISSON_FILTER_ROWS_H

// The parameters of MeshLab's filters: those of the engine, and MeshLab's own. Knows nothing of
// MeshLab, so that the reference can be made without it.

#include <vcg_extras/core/parameters.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gpr_filter {

/// The filters. The numbers are those that the host's actions have.
enum Filter : unsigned {
	RemeshFilter        = gpr::RemeshTool,
	SamplingFilter      = gpr::SamplingTool,
	RetriangulateFilter = gpr::RetriangulateTool,
	FeatureFilter       = gpr::FeatureTool,
	CompareFilter       = 16, ///< remeshing and Quadric Edge Collapse, beside each other
};

/// What the results of a comparison are coloured by.
enum class ComparedBy { Quality, Distance, Nothing };

/// The source of the labels of faces.
enum class RegionSource { Nothing, Texture, Colour, Quality };

/// The meaning of the quality of the vertices for sizes.
enum class QualitySizes {
	Nothing,
	Exact, ///< it is the edge length wanted there
	Scaled ///< it is so up to a factor that the wanted number sets
};

/// The engine's function that a filter runs.
gpr::Tool toolOf(Filter filter);

/// The parameters of a filter, in the order in which its dialog shows them. Those that the engine
/// does not know have no `store`: SampleLayer, NewLayer, Regions, QualitySizes, PeriodX, PeriodY,
/// PeriodZ, ColorBy and SideBySide.
const std::vector<gpr::Parameter>& rowsOf(Filter filter);

/// The row of the remeshing with this key, which must exist.
const gpr::Parameter& remeshRow(const std::string& key);

/// Values of rows by their keys, of a type that goes with the row.
using GivenValues = std::map<std::string, gpr::ParameterValue>;

/// MeshLab's widgets and scripts have numbers only: this one stands for gpr::Automatic.
constexpr double kAutomaticNumber = -1;

/// What a dialog calls a row: its label, and which number is the automatic one.
std::string dialogLabel(const gpr::Parameter& row);

} // namespace gpr_filter

#endif
