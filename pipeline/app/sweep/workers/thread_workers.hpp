// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "pipeline/app/sweep/workers/workers.hpp"

namespace ashimpact {

/// The threads of this process. Each computes one block while another one waits for it.
class ThreadWorkers : public Workers {
  public:
    ThreadWorkers(int threads, Work work);
    /// Drops the blocks that are not begun and waits for the others.
    ~ThreadWorkers() override;
    ThreadWorkers(const ThreadWorkers&) = delete;
    ThreadWorkers& operator=(const ThreadWorkers&) = delete;
    ThreadWorkers(ThreadWorkers&&) = delete;
    ThreadWorkers& operator=(ThreadWorkers&&) = delete;

    [[nodiscard]] std::size_t capacity() const override { return 2 * threads_.size(); }
    [[nodiscard]] std::size_t vacancies() const override { return capacity() - assigned_; }
    void assign(const Block& block) override;
    [[nodiscard]] std::optional<FinishedBlock> finished(std::chrono::microseconds patience) override;

  private:
    void serve(const std::stop_token& stop);

    Work work_;
    std::size_t assigned_ = 0;  ///< blocks not yet returned by finished()

    std::mutex mutex_;  ///< guards the members below it
    std::condition_variable_any waiting_changed_;
    std::condition_variable finished_changed_;
    std::deque<Block> waiting_;
    std::deque<FinishedBlock> finished_;
    std::exception_ptr failure_;

    std::vector<std::jthread> threads_;  ///< last, so that they end before what they use
};

/// Number of threads for this process: its share of the cores that the processes of the job may use on this
/// machine.
[[nodiscard]] int default_threads(int processes_here);

}  // namespace ashimpact
