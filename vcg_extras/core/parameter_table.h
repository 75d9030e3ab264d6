// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PARAMETER_TABLE_H
#define VCG_EXTRAS_CORE_PARAMETER_TABLE_H

#include "parameters.h"

#include <vector>

namespace gpr {

/// All parameters of all tools, in the order in which dialogs and --help show them.
std::vector<Parameter> makeParameterTable();

} // namespace gpr

#endif
