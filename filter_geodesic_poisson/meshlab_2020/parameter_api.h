// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_PARAMETER_API_H
#define FILTER_GEODESIC_POISSON_PARAMETER_API_H

#include "meshlab_api.h"

#include <utility>

namespace gpr_filter {

/// Adds a parameter; the dialogs of 2020.09 show all parameters.
template <class Kind, class... Arguments>
void addParameter(RichParameterList& list, bool /*advanced*/, Arguments&&... arguments)
{
	list.addParam(Kind(std::forward<Arguments>(arguments)...));
}

} // namespace gpr_filter

#endif
