// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer target: any bytes make a mesh and options, and the engine owes a sound result or a
// sentence. The meshes are small: a million executions find more than a few large meshes.

#include "pipeline.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
	using namespace gpr::test;
	const std::string complaints = complaintsAbout(caseOf(data, size, CaseSize::Small));
	if (complaints.empty()) return 0;
	std::fprintf(stderr, "complaint: %s\n", complaints.c_str());
	std::abort();
}
