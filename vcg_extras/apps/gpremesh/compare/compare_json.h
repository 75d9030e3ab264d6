// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_JSON_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_JSON_H

#include "compare_record.h"

namespace gpr::app {

/// The comparison as JSON text. The keys are public: they change with a changelog line.
std::string compareJson(const CompareRecord& record);

} // namespace gpr::app

#endif
