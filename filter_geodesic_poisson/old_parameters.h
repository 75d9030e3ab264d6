// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_OLD_PARAMETERS_H
#define FILTER_GEODESIC_POISSON_OLD_PARAMETERS_H

#include "filter_rows.h"
#include "meshlab_api.h"

#include <string>
#include <vector>

namespace gpr_filter {

/// Sentences about former parameters of a script with values other than the present behaviour.
/// Former parameters with their old default need no sentence.
std::vector<std::string> notesOnOldParameters(const RichParameterList& list);

/// Whether a script comes from the time with a parameter for the method of each stage. Its
/// adaptivity of 0.1 means gpr::Automatic.
bool isOldScript(const RichParameterList& list);

} // namespace gpr_filter

#endif
