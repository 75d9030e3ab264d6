// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_source.h"

#include <cstdlib>

namespace gpr::test {

namespace {

std::uint32_t numberInEnvironment(const char* name, std::uint32_t otherwise)
{
	const char* given = std::getenv(name);
	return given == nullptr ? otherwise : std::uint32_t(std::atoll(given));
}

} // namespace

std::vector<std::uint32_t> testSeeds(int n)
{
	const std::uint32_t first = numberInEnvironment("GPR_TEST_SEED", 1);
	const std::uint32_t num   = std::uint32_t(n) * numberInEnvironment("GPR_TEST_SEED_FACTOR", 1);
	std::vector<std::uint32_t> seeds;
	for (std::uint32_t i = 0; i < num; ++i)
		seeds.push_back(first + i);
	return seeds;
}

} // namespace gpr::test
