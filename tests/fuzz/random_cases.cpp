// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// gpr_random_cases TARGET NUM [SEED [SECONDS]]: cases of the corpus with random bytes changed, at
// the speed of an ordinary build and with any compiler; ends at the first fault or after so many
// seconds. TARGET is pipeline, small (the same with small meshes), parts (small
// meshes with labels, junctions, matched borders and periods), ply, obj, off, stl or glb.
// Less cunning than the fuzzer, but a hundred times faster.

#include "corpus.h"
#include "pipeline.h"
#include "reader_check.h"

#include <tests/support/random_source.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

using gpr::test::Random;

std::string mutated(std::string bytes, const std::string& other, Random& random)
{
	if (random.chance(0.2)) // the head of one file, the tail of another file
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

double processorSeconds()
{
	return double(std::clock()) / CLOCKS_PER_SEC;
}

std::string complaintsAbout(const std::string& target, const std::string& bytes)
{
	using namespace gpr;
	if (const test::Reader read = test::readerOf(target)) return test::complaintsAbout(read, bytes);
	const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
	if (target == "parts") return test::complaintsAbout(test::caseOfParts(data, bytes.size()));
	const auto size = target == "small" ? test::CaseSize::Small : test::CaseSize::Any;
	return test::complaintsAbout(test::caseOf(data, bytes.size(), size));
}

} // namespace

int main(int argc, char** argv)
{
	using Clock                = std::chrono::steady_clock;
	const std::string   target = argc > 1 ? argv[1] : "pipeline";
	const long          num    = argc > 2 ? std::atol(argv[2]) : 1000;
	const std::uint32_t seed   = argc > 3 ? std::uint32_t(std::atol(argv[3])) : 1;
	const double        limit  = argc > 4 ? std::atof(argv[4]) : 1e9;

	std::vector<std::string> cases;
	const bool               isOfEngine = target == "small" || target == "parts";
	for (const auto& file : gpr::test::corpusFiles(isOfEngine ? "pipeline" : target))
		cases.push_back(gpr::test::bytesOf(file));
	Random     random(seed);
	const auto start   = Clock::now();
	const auto seconds = [&] {
		return std::chrono::duration<double>(Clock::now() - start).count();
	};
	double longest = 0; // of processor time
	long   slowest = 0, done = 0;
	for (; done < num && seconds() < limit; ++done) {
		const std::string& a      = cases[std::size_t(random.below(int(cases.size())))];
		const std::string& b      = cases[std::size_t(random.below(int(cases.size())))];
		const std::string  bytes  = mutated(a, b, random);
		const double       before = processorSeconds();
		const std::string  found  = complaintsAbout(target, bytes);
		const double       took   = processorSeconds() - before;
		if (took > longest) {
			longest = took;
			slowest = done;
		}
		if (found.empty()) continue;
		std::printf("# %s (%s, case %ld, seed %u)\n", found.c_str(), target.c_str(), done, seed);
		printHex(bytes);
		return 1;
	}
	std::printf("%s: %ld cases without a fault, seed %u, at most %.2f s of processor time each "
				"(case %ld)\n",
				target.c_str(), done, seed, longest, slowest);
	return 0;
}
