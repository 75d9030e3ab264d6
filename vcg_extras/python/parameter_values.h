// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_PARAMETER_VALUES_H
#define VCG_EXTRAS_PYTHON_PARAMETER_VALUES_H

#include <vcg_extras/core/parameters.h>

#include <nanobind/nanobind.h>
#include <string>

// The rows of the parameter table as keyword arguments.

namespace gpr::python {

/// The rows of a tool that are keyword arguments, one dictionary each, in the order of the table:
/// name, kind, label, help, minimum, maximum, choices, default (None for a size).
nanobind::list parameterList(Tool tool);

/// Whether the number or the size of the triangles is among the parameters.
bool givesSize(Tool tool, const nanobind::dict& given);

/// The options that keyword arguments come to; those that are not given keep their defaults.
/// Throws ValueError, which names the argument, for a value of another kind or out of range, for
/// more than one size, and for a name that is no parameter of the tool.
RemeshOptions optionsOf(Tool tool, const nanobind::dict& given);

} // namespace gpr::python

#endif
