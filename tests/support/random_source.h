// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_RANDOM_SOURCE_H
#define GPR_TESTS_SUPPORT_RANDOM_SOURCE_H

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace gpr::test {

/// Random numbers that are the same with every standard library: raw output of mt19937, scaled
/// here.
class Random {
public:
	explicit Random(std::uint32_t seed) : seed_(seed), generator_(seed) {}

	std::uint32_t seed() const { return seed_; }
	/// Uniform in [0, 1).
	double unit() { return double(generator_()) * (1 / 4294967296.0); }
	double between(double low, double high) { return low + (high - low) * unit(); }
	/// Uniform in [0, n).
	int  below(int n) { return int(unit() * n); }
	bool chance(double p) { return unit() < p; }

	template <class T>
	void shuffle(std::vector<T>& items)
	{
		for (std::size_t i = items.size(); i > 1; --i)
			std::swap(items[i - 1], items[std::size_t(below(int(i)))]);
	}

private:
	std::uint32_t seed_;
	std::mt19937  generator_;
};

/// The seeds of a random test: n numbers from 1 on, or from the environment variable GPR_TEST_SEED
/// on. GPR_TEST_SEED_FACTOR multiplies n; scripts/soak/random_tests sets the factor.
std::vector<std::uint32_t> testSeeds(int n);

} // namespace gpr::test

#endif
