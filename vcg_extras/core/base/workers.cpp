// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "workers.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>
#if defined(__x86_64__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace gpr {

namespace {

using Clock = std::chrono::steady_clock;

#ifndef GPR_POLL_MILLISECONDS // 0 in the test that counts the work between two questions
#define GPR_POLL_MILLISECONDS 40
#endif
/// Shorter than a delay that a user feels, long enough that polling costs nothing.
constexpr auto pollPeriod = std::chrono::milliseconds(GPR_POLL_MILLISECONDS);
/// Looks at a flag before a thread sleeps: some tens of microseconds. Stages are chains of short
/// loops, and waking a thread costs as much as many a loop on a small mesh.
constexpr int looksBeforeSleep = 1000;

/// Tells the processor to pause in a waiting loop.
void pause()
{
#if defined(__x86_64__) || defined(_M_X64)
	_mm_pause();
#endif
}

} // namespace

struct Workers::Pool {
	std::vector<std::thread> threads;
	std::mutex               mutex;
	std::condition_variable  wake;
	std::condition_variable  done;
	std::atomic<std::size_t> generation{0}; ///< of loops; changed under the mutex
	std::atomic<int>         busy{0};       ///< threads that still work on the loop
	std::atomic<bool>        quit{false};

	// The loop under way.
	Task                     task    = nullptr;
	void*                    body    = nullptr;
	std::size_t              taskNum = 0;
	std::atomic<std::size_t> next{0};
	std::atomic<bool>        stop{false};
	std::exception_ptr       failure;

	// Progress; touched by the calling thread only.
	ProgressCallback   progress;
	Clock::time_point  lastPoll    = Clock::now();
	const char*        phrase      = "";
	double             stageFrom   = 0;
	double             stageTo     = 0;
	double             told        = 0;
	bool               isLimited   = false;
	const StopRequest* stopRequest = nullptr;
	Clock::time_point  deadline;

	// For Workers in a task of another loop.
	Workers* asked = nullptr; ///< the owner of the loop
	int      asker = 0;       ///< the owner's thread that does the task

	/// poll() for threads other than the calling thread: reads only.
	void pollAside() const
	{
		if (stop || (stopRequest != nullptr && *stopRequest)) throw CancelledError();
		if (isLimited && Clock::now() > deadline) throw OutOfTimeError();
	}

	void fail()
	{
		std::lock_guard<std::mutex> lock(mutex);
		if (!failure) failure = std::current_exception();
		stop = true;
	}

	/// Takes tasks until none is left. Worker 0 is the calling thread and polls between tasks.
	void work(int worker, Workers& owner)
	{
		try {
			for (;;) {
				if (stop.load(std::memory_order_relaxed)) return;
				const std::size_t i = next.fetch_add(1, std::memory_order_relaxed);
				if (i >= taskNum) return;
				task(body, i, worker);
				if (worker == 0) owner.poll(double(i) / double(taskNum));
			}
		}
		catch (...) {
			fail();
		}
	}

	void threadMain(int worker, Workers& owner)
	{
		std::size_t seen = 0;
		for (;;) {
			waitForLoop(seen);
			if (quit) return;
			seen = generation;
			work(worker, owner);
			if (--busy > 0) continue;
			std::lock_guard<std::mutex> lock(mutex);
			done.notify_one();
		}
	}

	void waitForLoop(std::size_t seen)
	{
		for (int look = 0; look < looksBeforeSleep; ++look) {
			if (quit || generation != seen) return;
			pause();
		}
		std::unique_lock<std::mutex> lock(mutex);
		wake.wait(lock, [&] { return quit || generation != seen; });
	}

	void waitForThreads(Workers& owner)
	{
		for (int look = 0; look < looksBeforeSleep; ++look) {
			if (busy == 0) return;
			pause();
		}
		std::unique_lock<std::mutex> lock(mutex);
		while (!done.wait_for(lock, pollPeriod, [&] { return busy == 0; })) {
			lock.unlock();
			try {
				if (!stop) owner.poll();
			}
			catch (...) {
				fail();
			}
			lock.lock();
		}
	}
};

Workers::Workers(int threads, ProgressCallback progress, double timeLimitSeconds,
				 const StopRequest* stop) :
		pool_(new Pool)
{
	const int n     = threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()));
	pool_->progress = std::move(progress);
	pool_->isLimited   = timeLimitSeconds > 0;
	pool_->stopRequest = stop;
	pool_->deadline    = pool_->lastPoll + std::chrono::duration_cast<Clock::duration>(
                                            std::chrono::duration<double>(timeLimitSeconds));
	pool_->lastPoll -= pollPeriod;
	for (int t = 1; t < n; ++t)
		pool_->threads.emplace_back([this, t] { pool_->threadMain(t, *this); });
}

Workers::Workers(Workers& owner, int worker) : pool_(new Pool)
{
	pool_->asked = &owner;
	pool_->asker = worker;
}

Workers::~Workers()
{
	{
		std::lock_guard<std::mutex> lock(pool_->mutex);
		pool_->quit = true;
	}
	pool_->wake.notify_all();
	for (std::thread& t : pool_->threads)
		t.join();
}

int Workers::threadNum() const
{
	return int(pool_->threads.size()) + 1;
}

std::size_t Workers::grainFor(std::size_t n)
{
	// Small enough for an even share of work, large enough that taking a piece costs nothing.
	return std::min<std::size_t>(16384, std::max<std::size_t>(1, n / 64));
}

int Workers::sumUp(int* value, std::size_t n)
{
	constexpr std::size_t grain = 16384; // 64 KB, which stay in a core's own cache between passes
	const std::size_t     pieceNum = (n + grain - 1) / grain;
	std::vector<int>      before(pieceNum + 1, 0);
	forEach(pieceNum, [&](std::size_t i) {
		before[i + 1] = std::accumulate(value + i * grain, value + std::min(n, (i + 1) * grain), 0);
	});
	std::partial_sum(before.begin(), before.end(), before.begin());
	forEach(pieceNum, [&](std::size_t i) {
		int sum = before[i];
		for (std::size_t k = i * grain; k < std::min(n, (i + 1) * grain); ++k)
			value[k] = sum += value[k];
	});
	return before.back();
}

void Workers::runTasks(std::size_t taskNum, Task task, void* body)
{
	Pool& p           = *pool_;
	p.task            = task;
	p.body            = body;
	p.taskNum         = taskNum;
	p.next            = 0;
	p.stop            = false;
	p.failure         = nullptr;
	const bool shared = taskNum > 1 && !p.threads.empty();
	if (shared) {
		{
			std::lock_guard<std::mutex> lock(p.mutex);
			p.busy = int(p.threads.size());
			++p.generation;
		}
		p.wake.notify_all();
	}
	p.work(0, *this);
	if (shared) p.waitForThreads(*this);
	if (p.failure) std::rethrow_exception(p.failure);
}

void Workers::enterStage(const char* phrase, double from, double to)
{
	pool_->phrase    = phrase;
	pool_->stageFrom = from;
	pool_->stageTo   = to;
	poll(0);
}

void Workers::pollFrom(int worker)
{
	if (worker > 0)
		pool_->pollAside();
	else
		poll();
}

void Workers::poll(double share)
{
	Pool& p = *pool_;
	if (p.asked != nullptr) return p.asked->pollFrom(p.asker);
	if (p.stopRequest != nullptr && *p.stopRequest) throw CancelledError();
	if (!p.progress && !p.isLimited) return;
	const Clock::time_point now = Clock::now();
	if (now - p.lastPoll < pollPeriod) return;
	p.lastPoll = now;
	if (p.isLimited && now > p.deadline) throw OutOfTimeError();
	if (!p.progress) return;
	// Several loops make up a stage, so a loop's own share may fall back: never tell less than
	// before.
	p.told = std::max(p.told, p.stageFrom + share * (p.stageTo - p.stageFrom));
	if (!p.progress(p.told, p.phrase)) throw CancelledError();
}

} // namespace gpr
