// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer target for the reader of the format GPR_FORMAT.

#include "reader_check.h"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
	const std::string complaints = gpr::test::complaintsAbout(
		gpr::test::readerOf(GPR_FORMAT), {reinterpret_cast<const char*>(data), size});
	if (complaints.empty()) return 0;
	std::fprintf(stderr, "complaint: %s\n", complaints.c_str());
	std::abort();
}
