// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PARAMETERS_H
#define VCG_EXTRAS_CORE_PARAMETERS_H

#include "parameter_table.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gpr {

/// The parameters of a tool, in the order in which its dialog shows them.
const std::vector<Parameter>& parametersOf(Tool tool);

/// The parameters of the whole remeshing.
inline const std::vector<Parameter>& remeshParameters()
{
	return parametersOf(RemeshTool);
}

/// The row of the tool with this key, or null.
const Parameter* findParameter(const std::string& key, Tool tool = RemeshTool);

/// Whether a row is one of those that stand for one choice, the size of the result.
bool isSizeParameter(const Parameter& p);

/// Collects the values of the rows and makes options of them.
/// TargetVertexNum and the rows below it stand for one choice: one above 0 takes the place of the
/// number of vertices; two above 0 are a mistake that complaints() tells.
class ParameterSet {
public:
	/// Stores one value, rows in any order; the variant must hold the type of the row's kind.
	void set(const Parameter& parameter, const ParameterValue& value);

	/// The options, with targetMode chosen.
	RemeshOptions options() const;
	/// Sentences about values out of range or in conflict; empty when all is well.
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
