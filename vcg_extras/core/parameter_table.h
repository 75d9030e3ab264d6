// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PARAMETER_TABLE_H
#define VCG_EXTRAS_CORE_PARAMETER_TABLE_H

#include "options.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace gpr {

/// The type of a parameter's value, which decides the widget and the .mlx type.
enum class ParameterKind {
	Count,  ///< whole number (RichInt)
	Number, ///< real number (RichFloat)
	Length, ///< mesh units or PercentOfDiagonal (RichAbsPerc)
	Switch, ///< on/off (RichBool)
	Choice, ///< one of `choices` (RichEnum); the value is its index
};

/// The value of a number that the engine chooses.
struct Automatic {
	bool operator==(Automatic) const { return true; }
	bool operator!=(Automatic) const { return false; }
};

/// A length in percent of the diagonal of the mesh.
struct PercentOfDiagonal {
	double value = 0;
	bool   operator==(PercentOfDiagonal o) const { return value == o.value; }
	bool   operator!=(PercentOfDiagonal o) const { return value != o.value; }
};

/// The name of Automatic in texts.
constexpr const char* automaticName = "auto";

/// The group of the parameters that everybody sees.
constexpr const char* everydayGroup = "Options";

/// A value; std::int64_t for a Choice.
using ParameterValue = std::variant<std::int64_t, double, bool, Automatic, PercentOfDiagonal>;

/// The facts of the input from which defaults are computed.
struct MeshFacts {
	std::int64_t vertexNum           = 0;
	double       diagonal            = 0; ///< mesh units
	bool         hasSelectedVertices = false;
};

/// The functions of remesh.h, as bits: each parameter belongs to some of these.
enum Tool : unsigned {
	RemeshTool        = 1, ///< remesh: all steps
	SamplingTool      = 2, ///< samplePoissonDisks: the samples only
	RetriangulateTool = 4, ///< retriangulate: a mesh from given samples
	FeatureTool       = 8, ///< detectFeatures
};

/// A row of the table from which the hosts make dialogs, scripts, command lines and references.
/// Keys and option names are public: every change needs a changelog line.
struct Parameter {
	const char*              key;      ///< in the filter and .mlx: "TargetVertexNum"
	const char*              option;   ///< on the command line: "--vertices"; "" without an option
	const char*              argument; ///< placeholder in --help: "N"; "" for a bare switch
	ParameterKind            kind;
	const char*              label; ///< in the dialog
	const char*              help;  ///< full sentences with unit and range, for every host
	const char*              dialogOnly              = ""; ///< more help for MeshLab only
	const char*              commandOnly             = ""; ///< more help for the command line only
	const char*              pythonOnly              = ""; ///< more help for Python only
	double                   minimum                 = 0;
	double                   maximum                 = 1;
	std::vector<const char*> choices                 = {}; ///< Choice only
	ParameterValue (*defaultValue)(const MeshFacts&) = nullptr;
	/// Writes a value to the options; null in rows that belong to a single host.
	void (*store)(const ParameterValue&, RemeshOptions&) = nullptr;
	unsigned    tools       = 0;     ///< the Tool bits that offer the parameter
	bool        isExpert    = false; ///< any other group than everydayGroup: shown on demand only
	bool        isAutomatic = false; ///< a Number that is Automatic by default
	const char* group       = everydayGroup; ///< the heading above the parameter in --help-all
};

/// All parameters of all tools, in the order in which dialogs and --help show them.
std::vector<Parameter> makeParameterTable();

/// The help in MeshLab's dialogs.
std::string dialogHelp(const Parameter& p);

/// The text of --help.
std::string commandHelp(const Parameter& p);

/// The help in Python.
std::string pythonHelp(const Parameter& p);

} // namespace gpr

#endif
