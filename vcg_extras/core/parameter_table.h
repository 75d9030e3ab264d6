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

/// What a parameter's value is, and so which widget and which .mlx type stand for it.
enum class ParameterKind {
	Count,  ///< whole number (RichInt)
	Number, ///< real number (RichFloat)
	Length, ///< mesh units or PercentOfDiagonal (RichAbsPerc)
	Switch, ///< on/off (RichBool)
	Choice, ///< one of `choices` (RichEnum); the value is its index
};

/// A number that is not given: the engine chooses it.
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

/// Its name where values are text.
constexpr const char* automaticName = "auto";

/// Of a Choice std::int64_t.
using ParameterValue = std::variant<std::int64_t, double, bool, Automatic, PercentOfDiagonal>;

/// What defaults may depend on.
struct MeshFacts {
	std::int64_t vertexNum           = 0;
	double       diagonal            = 0; ///< mesh units
	bool         hasSelectedVertices = false;
};

/// What parameters are for: the functions of remesh.h.
enum Tool : unsigned {
	RemeshTool        = 1, ///< remesh: the whole way
	SamplingTool      = 2, ///< samplePoissonDisks: the samples only
	RetriangulateTool = 4, ///< retriangulate: a mesh from given samples
	FeatureTool       = 8, ///< detectFeatures
};

/// One row of the table from which the hosts make their dialogs, scripts, command lines and
/// references. Keys and option names are public: they change with a changelog line only.
struct Parameter {
	const char*              key;      ///< in the filter and .mlx: "TargetVertexNum"
	const char*              option;   ///< on the command line: "--vertices"; "" where it has none
	const char*              argument; ///< placeholder in --help: "N"; "" for a bare switch
	ParameterKind            kind;
	const char*              label;       ///< in the dialog
	const char*              help;        ///< full sentences with unit and range, for every host
	const char*              dialogOnly;  ///< what is so in MeshLab only, or ""
	const char*              commandOnly; ///< what is so on the command line only, or ""
	const char*              pythonOnly;  ///< what is so in Python only, or ""
	double                   minimum;
	double                   maximum;
	std::vector<const char*> choices; ///< Choice only
	ParameterValue (*defaultValue)(const MeshFacts&);
	/// Puts a value into the options; null in rows of a host's own.
	void (*store)(const ParameterValue&, RemeshOptions&);
	unsigned tools;       ///< the Tool bits it is offered by
	bool     isExpert;    ///< a dialog with many parameters shows it only when asked to
	bool     isAutomatic; ///< a Number that is Automatic where it is not given
};

/// All parameters of all tools, in the order in which dialogs and --help show them.
std::vector<Parameter> makeParameterTable();

/// What MeshLab's dialogs say of a parameter.
std::string dialogHelp(const Parameter& p);

/// What --help says of it.
std::string commandHelp(const Parameter& p);

/// What Python's help says of it.
std::string pythonHelp(const Parameter& p);

} // namespace gpr

#endif
