// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_PARAMETER_VALUES_H
#define VCG_EXTRAS_PYTHON_PARAMETER_VALUES_H

#include <vcg_extras/core/parameters.h>

#include <nanobind/nanobind.h>
#include <optional>
#include <string>

// The rows of the parameter table as keyword arguments.

namespace gpr::python {

/// A Python or NumPy bool; none for other values.
std::optional<bool> switchOf(nanobind::handle value);

/// The rows of a tool that are keyword arguments, a dictionary each, in the order of the table:
/// name, kind, label, help, minimum, maximum, choices, default (None for a size).
nanobind::list parameterList(Tool tool);

/// Whether the parameters give a number or a size of the triangles.
bool givesSize(Tool tool, const nanobind::dict& given);

/// The options for keyword arguments; missing arguments keep their defaults. Throws ValueError with
/// the name of the argument for a value of another kind or out of range, for more than one size,
/// and for an unknown name.
RemeshOptions optionsOf(Tool tool, const nanobind::dict& given);

} // namespace gpr::python

#endif
