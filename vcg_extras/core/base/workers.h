// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_WORKERS_H
#define VCG_EXTRAS_CORE_BASE_WORKERS_H

#include "buffer.h"

#include <vcg_extras/core/progress.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace gpr {

/// Thrown in the calling thread after the progress callback or another thread asked to stop.
struct CancelledError {};
/// Thrown in the calling thread after the time limit.
struct OutOfTimeError {};

/// Threads that share loops; the only place of progress and cancelling. Every loop ends before its
/// call returns. No result depends on the distribution of work: loops write only to their own
/// indices, and sums are formed over pieces of fixed size.
class Workers {
public:
	/// threads = 0 takes a thread per core; timeLimitSeconds = 0 sets no limit. `stop` may be null;
	/// the flag is read much more often than progress is reported.
	Workers(int threads, ProgressCallback progress, double timeLimitSeconds = 0,
			const StopRequest* stop = nullptr);
	/// A single thread, for a task of thread `worker` in a loop of `owner`. poll() then asks the
	/// owner, so that long tasks end early with the loop.
	Workers(Workers& owner, int worker);
	~Workers();
	Workers(const Workers&)            = delete;
	Workers& operator=(const Workers&) = delete;

	int threadNum() const;

	/// Number of items in a piece for sums, independent of the number of threads.
	static constexpr std::size_t pieceSize = 4096;

	/// Calls body(begin, end) for pieces of [0, n), in any order, in parallel.
	template <class Body>
	void forRange(std::size_t n, const Body& body)
	{
		const std::size_t grain = grainFor(n);
		forTasks((n + grain - 1) / grain, [&](std::size_t piece, int) {
			body(piece * grain, std::min(n, (piece + 1) * grain));
		});
	}

	/// Calls visit(i) for every i in [0, n), in any order, in parallel.
	template <class Visit>
	void forEach(std::size_t n, const Visit& visit)
	{
		forRange(n, [&](std::size_t begin, std::size_t end) {
			for (std::size_t i = begin; i < end; ++i)
				visit(int(i));
		});
	}

	/// Calls body(task, worker) for every task in [0, taskNum); worker in [0, threadNum()).
	template <class Body>
	void forTasks(std::size_t taskNum, const Body& body)
	{
		runTasks(
			taskNum,
			[](void* b, std::size_t task, int worker) {
				(*static_cast<const Body*>(b))(task, worker);
			},
			const_cast<Body*>(&body));
	}

	/// Sum of body(begin, end) over pieces of fixed size, added in order: the same bits for any
	/// number of threads.
	template <class Value, class Body>
	Value sum(std::size_t n, const Body& body)
	{
		const std::size_t  grain    = pieceSize;
		const std::size_t  pieceNum = (n + grain - 1) / grain;
		std::vector<Value> part(pieceNum);
		forEach(pieceNum,
				[&](std::size_t i) { part[i] = body(i * grain, std::min(n, (i + 1) * grain)); });
		Value total = Value();
		for (const Value& p : part)
			total += p;
		return total;
	}

	/// Sum of the values that visit(i, sum) adds for every i in [0, n), as sum().
	template <class Value, class Visit>
	Value sumEach(std::size_t n, const Visit& visit)
	{
		return sum<Value>(n, [&](std::size_t begin, std::size_t end) {
			Value part = Value();
			for (std::size_t i = begin; i < end; ++i)
				visit(int(i), part);
			return part;
		});
	}

	/// The values that body(begin, end, out) appends for pieces of [0, n), joined in order. grain:
	/// the number of items in a piece; 0: small enough for an even share of work. Pieces do not
	/// depend on the number of threads.
	template <class Value, class Body>
	std::vector<Value> collect(std::size_t n, const Body& body, std::size_t grain = 0)
	{
		std::vector<Value> all;
		for (const std::vector<Value>& p : collectParts<Value>(n, body, grain))
			all.insert(all.end(), p.begin(), p.end());
		return all;
	}

	/// The values that visit(i, out) appends for every i in [0, n), joined in order.
	template <class Value, class Visit>
	std::vector<Value> collectEach(std::size_t n, const Visit& visit)
	{
		return collect<Value>(n, [&](std::size_t begin, std::size_t end, auto& out) {
			for (std::size_t i = begin; i < end; ++i)
				visit(int(i), out);
		});
	}

	/// All i in [0, n) for which the test is true, ascending.
	template <class Test>
	std::vector<int> collectIf(std::size_t n, const Test& test)
	{
		return collectEach<int>(n, [&](int i, auto& out) {
			if (test(i)) out.push_back(i);
		});
	}

	/// As collect, for many values: all threads join the parts, in memory written only once.
	template <class Value, class Body>
	Buffer<Value> collectMany(std::size_t n, const Body& body)
	{
		const std::vector<std::vector<Value>> part = collectParts<Value>(n, body, 0);
		std::vector<std::size_t>              start(part.size() + 1, 0);
		for (std::size_t i = 0; i < part.size(); ++i)
			start[i + 1] = start[i] + part[i].size();
		Buffer<Value> all(start.back());
		forEach(part.size(),
				[&](int i) { std::copy(part[i].begin(), part[i].end(), all.data() + start[i]); });
		return all;
	}

	/// Replaces every value by the sum up to and including the value; returns the last sum, 0 if n
	/// is 0.
	int sumUp(int* value, std::size_t n);

	/// Begins a stage whose progress runs from `from` to `to` (shares of 1).
	void enterStage(const char* phrase, double from, double to);
	/// Reports progress, if the last report is a while ago; throws CancelledError or
	/// OutOfTimeError. For long serial loops in the calling thread, or in tasks with Workers of
	/// their own. share: of the stage's work.
	void poll(double share = 0);
	/// poll() for thread `worker` of a loop, within a long task.
	void pollFrom(int worker);

private:
	struct Pool;
	using Task = void (*)(void* body, std::size_t task, int worker);

	template <class Value, class Body>
	std::vector<std::vector<Value>> collectParts(std::size_t n, const Body& body, std::size_t grain)
	{
		if (grain == 0) grain = std::min(pieceSize, grainFor(n));
		const std::size_t               pieceNum = (n + grain - 1) / grain;
		std::vector<std::vector<Value>> part(pieceNum);
		forEach(pieceNum,
				[&](std::size_t i) { body(i * grain, std::min(n, (i + 1) * grain), part[i]); });
		return part;
	}

	static std::size_t grainFor(std::size_t n);
	void               runTasks(std::size_t taskNum, Task task, void* body);

	std::unique_ptr<Pool> pool_;
};

} // namespace gpr

#endif
