// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_FILTER_ROWS_H
#define FILTER_GEODESIC_POISSON_FILTER_ROWS_H

// The parameters of MeshLab's filters: parameters of the engine, and MeshLab's own. Independent of
// MeshLab, so that the reference can be made without MeshLab.

#include <vcg_extras/core/parameters.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gpr_filter {

/// The filters, with the numbers of the host's actions.
enum Filter : unsigned {
	RemeshFilter        = gpr::RemeshTool,
	SamplingFilter      = gpr::SamplingTool,
	RetriangulateFilter = gpr::RetriangulateTool,
	FeatureFilter       = gpr::FeatureTool,
	CompareFilter       = 16, ///< remeshing and Quadric Edge Collapse, beside each other
};

/// The colours of the results of a comparison.
enum class ComparedBy { Quality, Distance, Nothing };

/// The source of the labels of faces.
enum class RegionSource { Nothing, Texture, Colour, Quality };

/// The meaning of the quality of the vertices for sizes.
enum class QualitySizes {
	Nothing,
	Exact, ///< the edge length wanted there
	Scaled ///< in proportion to the edge length; the wanted number sets the factor
};

/// The engine's function that a filter runs.
gpr::Tool toolOf(Filter filter);

/// The parameters of a filter, in the order of its dialog. Parameters unknown to the engine have no
/// `store`: SampleLayer, NewLayer, Regions, QualitySizes, PeriodX, PeriodY, PeriodZ, ColorBy and
/// SideBySide.
const std::vector<gpr::Parameter>& rowsOf(Filter filter);

/// The row of the remeshing with this key, which must exist.
const gpr::Parameter& remeshRow(const std::string& key);

/// Values of rows by their keys, of a type that goes with the row.
using GivenValues = std::map<std::string, gpr::ParameterValue>;

/// MeshLab's widgets and scripts have numbers only: this number means gpr::Automatic.
constexpr double kAutomaticNumber = -1;

/// The text of a row in a dialog: its label, and the automatic number.
std::string dialogLabel(const gpr::Parameter& row);

} // namespace gpr_filter

#endif
