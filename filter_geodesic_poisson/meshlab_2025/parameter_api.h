// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_PARAMETER_API_H
#define FILTER_GEODESIC_POISSON_PARAMETER_API_H

#include "meshlab_api.h"

#include <utility>

namespace gpr_filter {

/// Adds a parameter; an advanced parameter is shown after a press on the dialog's arrow.
template <class Kind, class... Arguments>
void addParameter(RichParameterList& list, bool advanced, Arguments&&... arguments)
{
	list.addParam(Kind(std::forward<Arguments>(arguments)..., advanced));
}

} // namespace gpr_filter

#endif
