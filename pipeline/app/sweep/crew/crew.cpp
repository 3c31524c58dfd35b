// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/crew/crew.hpp"

#include <algorithm>
#include <thread>

#include <oneapi/tbb/info.h>

namespace ashimpact {

Crew::Crew(int threads, Work work)
    : capacity_(2 * static_cast<std::size_t>(threads)), work_(std::move(work)), threads_(threads) {}

void Crew::assign(const Block& block) {
    ++assigned_;
    threads_.start([this, block] { compute(block); });
}

void Crew::compute(const Block& block) {
    FinishedBlock done{.block = block, .seconds = 0, .bytes = {}};
    std::exception_ptr failure;
    const auto start = std::chrono::steady_clock::now();
    try {
        done.bytes = work_(block);
    } catch (...) {
        failure = std::current_exception();
    }
    done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::lock_guard lock(mutex_);
    if (failure)
        failure_ = failure;
    else
        finished_.push_back(std::move(done));
    changed_.notify_one();
}

std::optional<FinishedBlock> Crew::finished(std::chrono::microseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return failure_ != nullptr || !finished_.empty(); });
    if (failure_) std::rethrow_exception(failure_);
    if (finished_.empty()) return std::nullopt;
    FinishedBlock done = std::move(finished_.front());
    finished_.pop_front();
    --assigned_;
    return done;
}

int default_threads(int processes_here) {
    const int allowed = tbb::info::default_concurrency();  // heeds the cores this process is bound to
    const int share = static_cast<int>(std::thread::hardware_concurrency()) / std::max(processes_here, 1);
    return std::max(1, std::min(allowed, share));
}

}  // namespace ashimpact
