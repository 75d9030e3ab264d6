// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_PARAMETER_BRIDGE_H
#define FILTER_GEODESIC_POISSON_PARAMETER_BRIDGE_H

// Between the engine's parameter table and MeshLab's parameter lists.

#include "filter_rows.h"
#include "meshlab_api.h"

#include <string>
#include <vector>

namespace gpr_filter {

/// A dialog with more rows than this shows those for experts only when asked to.
constexpr std::size_t kMostEverydayRows = 12;

/// How many rows of the table, its first ones, a dialog always shows.
std::size_t everydayRowNum(const std::vector<gpr::Parameter>& table);

/// Adds one MeshLab parameter for each row of the table, in the table's order, with the value that
/// is given for it, or else its default for a mesh of these facts. Lengths range from 0 to the
/// diagonal. Rows for experts are marked as advanced where MeshLab knows that.
void fillParameterList(const std::vector<gpr::Parameter>& table, const gpr::MeshFacts& facts,
					   RichParameterList& list, const GivenValues& given = {});

/// What a parameter list says, and what is wrong with it.
struct ReadParameters {
	gpr::ParameterSet        values;
	GivenValues              ofHost;     ///< of the rows that the engine does not know
	std::vector<std::string> complaints; ///< one sentence each; empty when all is well
	std::vector<std::string> notes;      ///< sentences about old parameters that were not followed

	/// The value of a row of MeshLab's own; 0 or false where the filter has no such row.
	template <class Value>
	Value own(const char* key) const
	{
		const auto found = ofHost.find(key);
		return found != ofHost.end() ? std::get<Value>(found->second) : Value();
	}
};

/// Reads the rows of the table out of a list. A row that is missing gets what is proposed for it,
/// or else its default for a mesh of these facts, as the hosts after 2020.09 do it; one of another
/// type or out of its range makes a complaint; parameters that are not in the table are passed
/// over, but for those of old scripts (old_parameters.h). Never throws for what a user can write
/// into a script.
ReadParameters readParameterList(const std::vector<gpr::Parameter>& table,
								 const gpr::MeshFacts& facts, const RichParameterList& list,
								 const GivenValues& proposed = {});

/// The number a user meant whose decimal text the host has kept as float: 12.3f gives 12.3 and not
/// 12.300000190734863, so that dialog, script and command line ask for the same. Hosts of double
/// scalars keep floats, too; a number that is no float is as it was meant.
double typedNumber(double kept);

} // namespace gpr_filter

#endif
