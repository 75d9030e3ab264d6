// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// gpr_cancel_latency MESH [PERCENT [PRESET [THREADS]]]: for each phrase of the progress, the
// longest time of the engine between two questions whether to go on, and the time from a refusal to
// the end.

#include <vcg_extras/core/remesh.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

namespace {

/// Wall time, and the processor time of the calling thread, which other programs do not lengthen.
struct Moment {
	double wall = 0, processor = 0;

	static Moment now()
	{
		const auto      wall = std::chrono::steady_clock::now().time_since_epoch();
		struct timespec used;
		clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
		return {std::chrono::duration<double>(wall).count(),
				double(used.tv_sec) + 1e-9 * double(used.tv_nsec)};
	}
	Moment operator-(const Moment& o) const { return {wall - o.wall, processor - o.processor}; }
};

/// Figures of the time in which a phrase was shown; the phrase may come back later.
struct Phase {
	std::string phrase;
	double      seconds = 0;
	Moment      longest; ///< between two questions, seconds
	int         asked = 0;
};

class Observer {
public:
	explicit Observer(const gpr::MeshView& mesh, const gpr::RemeshOptions& options) :
			mesh_(mesh), options_(options)
	{
	}

	/// A run to its end.
	std::vector<Phase> observe()
	{
		std::vector<Phase> phases{{"(start)", 0, {}, 0}};
		Moment             last = Moment::now();
		const auto         note = [&] {
            const Moment here = Moment::now(), gap = here - last;
            Phase&       phase = phases.back();
            last               = here;
            phase.seconds += gap.wall;
            phase.longest = {std::max(phase.longest.wall, gap.wall),
                             std::max(phase.longest.processor, gap.processor)};
		};
		const gpr::RemeshResult r = remesh([&](double, const char* phrase) {
			note();
			if (phases.back().phrase != phrase) phases.push_back({phrase, 0, {}, 0});
			++phases.back().asked;
			return true;
		});
		note();
		if (r.status != gpr::Status::Ok) std::fprintf(stderr, "%s\n", r.message.c_str());
		return phases;
	}

	/// Seconds from a refusal to the end. The refusal comes at question n of entry k of the
	/// phrases, or at a later entry; -1 if the run ended before.
	Moment cancel(std::size_t k, int n)
	{
		std::size_t phase = 0;
		int         asked = 0;
		std::string shown = "(start)";
		Moment      refused;
		bool        isRefused = false;
		remesh([&](double, const char* phrase) {
			if (shown != phrase) {
				shown = phrase;
				++phase;
				asked = 0;
			}
			++asked;
			if (phase < k || (phase == k && asked < n)) return true;
			refused   = Moment::now();
			isRefused = true;
			return false;
		});
		return isRefused ? Moment::now() - refused : Moment{-1, -1};
	}

private:
	gpr::MeshView      mesh_;
	gpr::RemeshOptions options_;

	gpr::RemeshResult remesh(const gpr::ProgressCallback& progress)
	{
		return gpr::remesh(mesh_, options_, progress);
	}
};

gpr::RemeshOptions optionsFrom(int argc, char** argv)
{
	gpr::RemeshOptions options;
	if (argc > 2) options.targetPercent = std::atof(argv[2]);
	if (argc > 3 && std::string(argv[3]) == "fast") options.preset = gpr::Preset::Fast;
	if (argc > 3 && std::string(argv[3]) == "paper") options.preset = gpr::Preset::Paper;
	if (argc > 4) options.threads = std::atoi(argv[4]);
	return options;
}

void run(int argc, char** argv)
{
	const gpr::app::InputMesh mesh = gpr::app::readMesh(argv[1]);
	Observer                  observer(mesh.view(), optionsFrom(argc, argv));
	std::printf("%zu faces; ms of the wall clock, in brackets of the processor\n"
				"%-36s %8s %6s %16s %16s\n",
				mesh.faceNum(), "phrase", "seconds", "asked", "longest gap", "cancelled in");
	const std::vector<Phase> phases = observer.observe();
	for (std::size_t k = 0; k < phases.size(); ++k) {
		const Phase& p     = phases[k];
		const Moment ended = p.asked > 0 ? observer.cancel(k, (p.asked + 2) / 3) : Moment();
		std::printf("%-36s %8.2f %6d %7.0f (%6.0f)", p.phrase.c_str(), p.seconds, p.asked,
					1e3 * p.longest.wall, 1e3 * p.longest.processor);
		if (ended.wall >= 0) std::printf(" %7.0f (%6.0f)", 1e3 * ended.wall, 1e3 * ended.processor);
		std::printf("\n");
		std::fflush(stdout);
	}
}

} // namespace

int main(int argc, char** argv)
{
	if (argc < 2) {
		std::fprintf(stderr, "gpr_cancel_latency MESH [PERCENT [PRESET [THREADS]]]\n");
		return 2;
	}
	try {
		run(argc, argv);
	}
	catch (const std::exception& error) {
		std::fprintf(stderr, "gpr_cancel_latency: %s\n", error.what());
		return 1;
	}
	return 0;
}
