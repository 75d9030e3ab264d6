// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces MeshLab's remeshers in a program built without vcglib.
#include "baseline_remeshers.h"

namespace gpr::app {

namespace {

BaselineResult absent()
{
	BaselineResult result;
	result.failure = "Left out: this program was built without vcglib.";
	return result;
}

} // namespace

BaselineResult collapseQuadricEdges(const MeshView&, std::int64_t, const StopQuestion&)
{
	return absent();
}

BaselineResult remeshIsotropically(const MeshView&, double)
{
	return absent();
}

} // namespace gpr::app
