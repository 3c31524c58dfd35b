// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/workers/workers.hpp"

#include <algorithm>

#include <sched.h>

namespace ashimpact {

ThreadWorkers::ThreadWorkers(int threads, Work work) : work_(std::move(work)) {
    for (int i = 0; i < threads; ++i)
        threads_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
}

ThreadWorkers::~ThreadWorkers() {
    for (std::jthread& thread : threads_) thread.request_stop();
    for (std::jthread& thread : threads_) thread.join();
}

void ThreadWorkers::assign(const Block& block) {
    ++assigned_;
    const std::lock_guard lock(mutex_);
    waiting_.push_back(block);
    waiting_changed_.notify_one();
}

void ThreadWorkers::serve(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (waiting_changed_.wait(lock, stop, [this] { return !waiting_.empty(); }) &&
           !stop.stop_requested()) {
        FinishedBlock done{.block = waiting_.front(), .seconds = 0, .bytes = {}};
        waiting_.pop_front();
        lock.unlock();
        std::exception_ptr failure;
        const auto start = std::chrono::steady_clock::now();
        try {
            done.bytes = work_(done.block);
        } catch (...) {
            failure = std::current_exception();
        }
        done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        lock.lock();
        if (failure)
            failure_ = failure;
        else
            finished_.push_back(std::move(done));
        finished_changed_.notify_one();
    }
}

std::optional<FinishedBlock> ThreadWorkers::finished(std::chrono::microseconds patience) {
    std::unique_lock lock(mutex_);
    finished_changed_.wait_for(lock, patience, [this] { return failure_ != nullptr || !finished_.empty(); });
    if (failure_) std::rethrow_exception(failure_);
    if (finished_.empty()) return std::nullopt;
    FinishedBlock done = std::move(finished_.front());
    finished_.pop_front();
    --assigned_;
    return done;
}

int default_threads(int processes_here) {
    cpu_set_t bound;  // the cores this process is bound to
    const bool known = sched_getaffinity(0, sizeof(bound), &bound) == 0;
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, std::min(known ? CPU_COUNT(&bound) : cores, cores / std::max(processes_here, 1)));
}

}  // namespace ashimpact
