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

/// A dialog with more rows than this shows the rows for experts only on request.
constexpr std::size_t kMostEverydayRows = 12;

/// The number of rows of the table, from the first row on, that a dialog always shows.
std::size_t everydayRowNum(const std::vector<gpr::Parameter>& table);

/// Adds one MeshLab parameter for each row of the table, in the table's order, with the given
/// value, or else the default for a mesh of these facts. Lengths range from 0 to the diagonal. Rows
/// for experts are marked as advanced in MeshLab versions with advanced parameters.
void fillParameterList(const std::vector<gpr::Parameter>& table, const gpr::MeshFacts& facts,
					   RichParameterList& list, const GivenValues& given = {});

/// The values of a parameter list, and the complaints about the list.
struct ReadParameters {
	gpr::ParameterSet        values;
	GivenValues              ofHost;     ///< of the rows unknown to the engine
	std::vector<std::string> complaints; ///< one sentence each; empty without faults
	std::vector<std::string> notes;      ///< sentences about former parameters without effect

	/// The value of a row of MeshLab's own; 0 or false for a filter without this row.
	template <class Value>
	Value own(const char* key) const
	{
		const auto found = ofHost.find(key);
		return found != ofHost.end() ? std::get<Value>(found->second) : Value();
	}
};

/// Reads the rows of the table out of a list. A missing row gets its proposal, or else its default
/// for a mesh of these facts, as in the hosts after 2020.09; a row of another type or out of range
/// makes a complaint; parameters outside of the table are passed over, except former parameters
/// (old_parameters.h). Never throws for anything that a user can write into a script.
ReadParameters readParameterList(const std::vector<gpr::Parameter>& table,
								 const gpr::MeshFacts& facts, const RichParameterList& list,
								 const GivenValues& proposed = {});

/// The number that a user meant, if the host has kept its decimal text as float: 12.3f gives 12.3
/// and not 12.300000190734863, so that dialog, script and command line agree. Hosts with double
/// scalars keep floats, too; a number that is no float is returned unchanged.
double typedNumber(double kept);

} // namespace gpr_filter

#endif
