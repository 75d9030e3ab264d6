// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_OLD_PARAMETERS_H
#define FILTER_GEODESIC_POISSON_OLD_PARAMETERS_H

#include "filter_rows.h"
#include "meshlab_api.h"

#include <string>
#include <vector>

namespace gpr_filter {

/// Sentences about parameters of a script that were taken out and ask for something else than what
/// is done now. Those with their old default ask for nothing.
std::vector<std::string> notesOnOldParameters(const RichParameterList& list);

/// Whether a script was written when a method of each stage was a parameter. Its adaptivity of 0.1
/// stands for gpr::Automatic.
bool isOldScript(const RichParameterList& list);

} // namespace gpr_filter

#endif
