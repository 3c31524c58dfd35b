// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#ifdef __SANITIZE_THREAD__
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>
#endif

namespace ashimpact {

#ifndef __SANITIZE_THREAD__

/// Threads that run tasks side by side with the one that starts them.
class Threads {
  public:
    explicit Threads(int count)
        : allowed_(tbb::global_control::max_allowed_parallelism,
                   static_cast<std::size_t>(count) + 1),  // they and the one that waits
          arena_(count, 0) {}

    /// Drops the tasks that have not begun and waits for the others.
    ~Threads() noexcept {
        tasks_.cancel();
        arena_.execute([this] { tasks_.wait(); });
    }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    Threads(Threads&&) = delete;
    Threads& operator=(Threads&&) = delete;

    /// @param task  throws nothing
    template <typename Task>
    void start(Task task) {
        arena_.enqueue(tasks_.defer(std::move(task)));
    }

  private:
    tbb::global_control allowed_;
    tbb::task_arena arena_;
    tbb::task_group tasks_;
};

#else

/// The same for the thread sanitizer, which does not see how the threads of TBB, a library built without it,
/// hand over tasks to one another.
class Threads {
  public:
    explicit Threads(int count) {
        for (int i = 0; i < count; ++i)
            threads_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
    }

    template <typename Task>
    void start(Task task) {
        const std::lock_guard lock(mutex_);
        tasks_.emplace_back(std::move(task));
        changed_.notify_one();
    }

  private:
    void serve(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        while (changed_.wait(lock, stop, [this] { return !tasks_.empty(); }) && !stop.stop_requested()) {
            const auto task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            task();
            lock.lock();
        }
    }

    std::mutex mutex_;  ///< guards the tasks
    std::condition_variable_any changed_;
    std::deque<std::function<void()>> tasks_;
    std::vector<std::jthread> threads_;
};

#endif

}  // namespace ashimpact
