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

/// Thrown in the calling thread when the progress callback, or another thread, asked to stop.
struct CancelledError {};
/// Thrown in the calling thread when the time limit has passed.
struct OutOfTimeError {};

/// Threads that share loops, and the one place where progress is told and cancelling noticed.
/// Every loop ends before its call returns. Which thread does what never shows in a result: loops
/// write only to their own indices, sums are formed over pieces of fixed size.
class Workers {
public:
	/// threads = 0 takes one per core, timeLimitSeconds = 0 as long as it takes. `stop` may be
	/// null; it is looked at much more often than progress is told.
	Workers(int threads, ProgressCallback progress, double timeLimitSeconds = 0,
			const StopRequest* stop = nullptr);
	/// One thread alone, for a task that thread `worker` does in a loop of `owner`: poll() asks the
	/// owner there, so that long tasks end early with the loop.
	Workers(Workers& owner, int worker);
	~Workers();
	Workers(const Workers&)            = delete;
	Workers& operator=(const Workers&) = delete;

	int threadNum() const;

	/// Sums and collections are formed over pieces of so many items, whatever the threads.
	static constexpr std::size_t pieceSize = 4096;

	/// Calls body(begin, end) for pieces of [0, n), in any order, in parallel.
	template <class Body>
	void forRange(std::size_t n, const Body& body)
	{
		const std::size_t grain = grainFor(n);
		run((n + grain - 1) / grain,
			[&](std::size_t piece, int) { body(piece * grain, std::min(n, (piece + 1) * grain)); });
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
		run(taskNum, body);
	}

	/// Sum of body(begin, end) over pieces of fixed size, added in order: the same bits for any
	/// number of threads.
	template <class Value, class Body>
	Value sum(std::size_t n, const Body& body)
	{
		const std::size_t  grain    = pieceSize;
		const std::size_t  pieceNum = (n + grain - 1) / grain;
		std::vector<Value> part(pieceNum);
		forRange(pieceNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t i = begin; i < end; ++i)
				part[i] = body(i * grain, std::min(n, (i + 1) * grain));
		});
		Value total = Value();
		for (const Value& p : part)
			total += p;
		return total;
	}

	/// The same, of what visit(i, sum) adds for every i in [0, n).
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

	/// What body(begin, end, out) appends for pieces of fixed size, joined in order.
	template <class Value, class Body>
	std::vector<Value> collect(std::size_t n, const Body& body)
	{
		std::vector<Value> all;
		for (const std::vector<Value>& p : collectParts<Value>(n, body))
			all.insert(all.end(), p.begin(), p.end());
		return all;
	}

	/// The same, of what visit(i, out) appends for every i in [0, n).
	template <class Value, class Visit>
	std::vector<Value> collectEach(std::size_t n, const Visit& visit)
	{
		return collect<Value>(n, [&](std::size_t begin, std::size_t end, auto& out) {
			for (std::size_t i = begin; i < end; ++i)
				visit(int(i), out);
		});
	}

	/// All i in [0, n) that pass the test, ascending.
	template <class Test>
	std::vector<int> collectIf(std::size_t n, const Test& test)
	{
		return collectEach<int>(n, [&](int i, auto& out) {
			if (test(i)) out.push_back(i);
		});
	}

	/// The same as collect for much: joined by all threads, in memory that is written to once.
	template <class Value, class Body>
	Buffer<Value> collectMany(std::size_t n, const Body& body)
	{
		const std::vector<std::vector<Value>> part = collectParts<Value>(n, body);
		std::vector<std::size_t>              start(part.size() + 1, 0);
		for (std::size_t i = 0; i < part.size(); ++i)
			start[i + 1] = start[i] + part[i].size();
		Buffer<Value> all(start.back());
		forRange(part.size(), [&](std::size_t begin, std::size_t end) {
			for (std::size_t i = begin; i < end; ++i)
				std::copy(part[i].begin(), part[i].end(), all.data() + start[i]);
		});
		return all;
	}

	/// Replaces every value by the sum of it and all before it; returns the last, 0 if n is 0.
	int sumUp(int* value, std::size_t n);

	/// From here on the work done runs from `from` to `to` (shares of 1).
	void enterStage(const char* phrase, double from, double to);
	/// Tells progress if the last time is a while ago; throws CancelledError or OutOfTimeError.
	/// Long serial loops call it now and then, from the calling thread only, or in tasks (see
	/// above). share: of the stage's own work.
	void poll(double share = 0);

private:
	struct Pool;
	using Task = void (*)(void* body, std::size_t task, int worker);

	template <class Value, class Body>
	std::vector<std::vector<Value>> collectParts(std::size_t n, const Body& body)
	{
		const std::size_t               grain    = pieceSize;
		const std::size_t               pieceNum = (n + grain - 1) / grain;
		std::vector<std::vector<Value>> part(pieceNum);
		forRange(pieceNum, [&](std::size_t begin, std::size_t end) {
			for (std::size_t i = begin; i < end; ++i)
				body(i * grain, std::min(n, (i + 1) * grain), part[i]);
		});
		return part;
	}

	static std::size_t grainFor(std::size_t n);
	void               runTasks(std::size_t taskNum, Task task, void* body);

	template <class Body>
	void run(std::size_t taskNum, const Body& body)
	{
		runTasks(
			taskNum,
			[](void* b, std::size_t task, int worker) {
				(*static_cast<const Body*>(b))(task, worker);
			},
			const_cast<Body*>(&body));
	}

	std::unique_ptr<Pool> pool_;
};

} // namespace gpr

#endif
