// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_PARAMETER_BRIDGE_H
#define FILTER_GEODESIC_POISSON_PARAMETER_BRIDGE_H

// Between the engine's parameter table and MeshLab's parameter lists.

#include "meshlab_api.h"

#include <vcg_extras/core/parameters.h>

#include <map>
#include <string>
#include <vector>

namespace gpr_filter {

/// A dialog with more rows than this shows those for experts only when asked to.
constexpr std::size_t kMostEverydayRows = 12;

/// How many rows of the table, its first ones, a dialog always shows.
std::size_t everydayRowNum(const std::vector<gpr::Parameter>& table);

/// Values of rows by their keys, of a type that goes with the row.
using GivenValues = std::map<std::string, gpr::ParameterValue>;

/// Adds one MeshLab parameter for each row of the table, in the table's order, with the value that
/// is given for it, or else its default for a mesh of these facts. Lengths range from 0 to the
/// diagonal. Rows for experts are marked as advanced where MeshLab knows that.
void fillParameterList(const std::vector<gpr::Parameter>& table, const gpr::MeshFacts& facts,
					   RichParameterList& list, const GivenValues& given = {});

/// What a parameter list says, and what is wrong with it.
struct ReadParameters {
	gpr::ParameterSet        values;
	std::vector<std::string> complaints; ///< one sentence each; empty when all is well
};

/// Reads the rows of the table out of a list. A row that is missing gets its default for a mesh of
/// these facts, as the hosts after 2020.09 do it; one of another type or out of its range makes a
/// complaint; parameters that are not in the table are passed over. Never throws for what a user
/// can write into a script.
ReadParameters readParameterList(const std::vector<gpr::Parameter>& table,
								 const gpr::MeshFacts& facts, const RichParameterList& list);

/// The number a user meant whose decimal text the host has kept as float: 12.3f gives 12.3 and not
/// 12.300000190734863, so that dialog, script and command line ask for the same. Hosts of double
/// scalars keep floats, too; a number that is no float is as it was meant.
double typedNumber(double kept);

} // namespace gpr_filter

#endif
