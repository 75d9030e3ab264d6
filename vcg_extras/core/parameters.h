// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PARAMETERS_H
#define VCG_EXTRAS_CORE_PARAMETERS_H

#include "parameter_table.h"

#include <map>
#include <string>
#include <vector>

namespace gpr {

/// The parameters of a tool, in the order in which its dialog shows them.
const std::vector<Parameter>& parametersOf(Tool tool);

/// The parameters of remesh().
inline const std::vector<Parameter>& remeshParameters()
{
	return parametersOf(RemeshTool);
}

/// The row of the tool with this key, or null.
const Parameter* findParameter(const std::string& key, Tool tool = RemeshTool);

/// Whether a row is an alternative of the same choice, the size of the result.
bool isSizeParameter(const Parameter& p);

/// Collects values of rows and makes options. The rows from TargetVertexNum on are alternatives for
/// the size of the result: a single value above 0 replaces the number of vertices; for two values
/// above 0 complaints() returns a sentence.
class ParameterSet {
public:
	/// Stores a value, rows in any order; the variant must hold the type of the row's kind.
	void set(const Parameter& parameter, const ParameterValue& value);

	/// The options, with targetMode chosen.
	RemeshOptions options() const;
	/// A sentence for each value out of range and each conflict; empty if all values are valid.
	std::vector<std::string> complaints() const;

private:
	struct Given {
		const Parameter* parameter;
		ParameterValue   value;
	};
	std::map<std::string, Given> given_; ///< by key

	RemeshOptions raw() const;
};

} // namespace gpr

#endif
