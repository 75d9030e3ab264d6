// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_source.h"

#include <cstdlib>

namespace gpr::test {

std::vector<std::uint32_t> testSeeds(int n)
{
	const char*                given = std::getenv("GPR_TEST_SEED");
	const std::uint32_t        first = given == nullptr ? 1 : std::uint32_t(std::atoll(given));
	std::vector<std::uint32_t> seeds;
	for (int i = 0; i < n; ++i)
		seeds.push_back(first + std::uint32_t(i));
	return seeds;
}

} // namespace gpr::test
