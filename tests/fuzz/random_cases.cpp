// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// gpr_random_cases NUM [SEED [SECONDS]]: cases of the corpus with random bytes changed, at the
// speed of an ordinary build and with any compiler; ends at the first fault or after so many
// seconds. Less cunning than the fuzzer, but a hundred times faster.

#include "corpus.h"
#include "pipeline.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <tests/support/random_source.h>

namespace {

using gpr::test::Random;

std::string mutated(std::string bytes, const std::string& other, Random& random)
{
	if (random.chance(0.2)) // the head of one, the tail of another
		bytes = bytes.substr(0, std::size_t(random.below(int(bytes.size()) + 1))) +
				other.substr(std::size_t(random.below(int(other.size()) + 1)));
	const int changes = 1 << random.below(5);
	for (int i = 0; i < changes && !bytes.empty(); ++i) {
		const std::size_t at = std::size_t(random.below(int(bytes.size())));
		switch (random.below(4)) {
		case 0:
			bytes.erase(at, 1);
			break;
		case 1:
			bytes.insert(at, 1, char(random.below(256)));
			break;
		default:
			bytes[at] = char(random.below(256));
		}
	}
	return bytes;
}

void printHex(const std::string& bytes)
{
	for (std::size_t i = 0; i < bytes.size(); ++i)
		std::printf("%02x%s", unsigned(static_cast<unsigned char>(bytes[i])),
					i % 32 == 31 ? "\n" : " ");
	std::printf("\n");
}

} // namespace

int main(int argc, char** argv)
{
	using Clock               = std::chrono::steady_clock;
	const long          num   = argc > 1 ? std::atol(argv[1]) : 1000;
	const std::uint32_t seed  = argc > 2 ? std::uint32_t(std::atol(argv[2])) : 1;
	const double        limit = argc > 3 ? std::atof(argv[3]) : 1e9;

	std::vector<std::string> cases;
	for (const auto& file : gpr::test::corpusFiles("pipeline"))
		cases.push_back(gpr::test::bytesOf(file));
	Random     random(seed);
	const auto start   = Clock::now();
	const auto seconds = [&] {
		return std::chrono::duration<double>(Clock::now() - start).count();
	};
	double longest = 0;
	long   done    = 0;
	for (; done < num && seconds() < limit; ++done) {
		const std::string& a          = cases[std::size_t(random.below(int(cases.size())))];
		const std::string& b          = cases[std::size_t(random.below(int(cases.size())))];
		const std::string  bytes      = mutated(a, b, random);
		const double       before     = seconds();
		const std::string  complaints = gpr::test::complaintsAbout(
			 gpr::test::caseOf(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
		const double took = seconds() - before;
		if (!complaints.empty()) {
			std::printf("# %s (case %ld, seed %u)\n", complaints.c_str(), done, seed);
			printHex(bytes);
			return 1;
		}
		if (took > longest && took > 5) {
			std::printf("# %.1f s (case %ld, seed %u)\n", took, done, seed);
			printHex(bytes);
		}
		longest = took > longest ? took : longest;
	}
	std::printf("%ld cases without a fault, seed %u, at most %.2f s each\n", done, seed, longest);
	return 0;
}
