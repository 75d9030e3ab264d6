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
	Length, ///< mesh units, shown with percent of the diagonal (RichAbsPerc)
	Switch, ///< on/off (RichBool)
	Choice, ///< one of `choices` (RichEnum); the value is its index
};

using ParameterValue = std::variant<std::int64_t, double, bool>; ///< Choice uses std::int64_t

/// What defaults may depend on.
struct MeshFacts {
	std::int64_t vertexNum           = 0;
	double       diagonal            = 0; ///< mesh units
	bool         hasSelectedVertices = false;
	std::int64_t sampleLayer         = 1; ///< number of the layer in which samples most likely are
};

/// What parameters are for: each is a filter in MeshLab, most are a command of gpremesh.
enum Tool : unsigned {
	RemeshTool        = 1,  ///< the whole way
	SamplingTool      = 2,  ///< the samples only
	RetriangulateTool = 4,  ///< a mesh from given samples
	FeatureTool       = 8,  ///< feature detection
	CompareTool       = 16, ///< the whole way and Quadric Edge Collapse, beside each other
};

/// What the results of a comparison are coloured by.
enum class ComparedBy { Quality, Distance, Nothing };

/// One row of the table from which the dialogs, .mlx scripts, the command line and the reference
/// are made. Keys and option names are public: they change with a changelog line only.
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
	/// Puts a value into the options; null for rows that the host handles itself.
	void (*store)(const ParameterValue&, RemeshOptions&);
	unsigned tools;    ///< the Tool bits it is offered by
	bool     isExpert; ///< a dialog with many parameters shows it only when asked to
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
