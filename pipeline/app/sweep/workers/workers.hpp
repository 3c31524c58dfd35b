// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "pipeline/app/sweep/workers/block.hpp"

namespace ashimpact {

/// A computed block.
struct FinishedBlock {
    Block block;
    double seconds = 0;  ///< computing time of its thread [s]
    std::string bytes;   ///< result of the work

    void transfer(auto& archive) { archive(block, seconds, bytes); }
};

/// Computes a block and returns its result in bytes.
using Work = std::function<std::string(const Block&)>;

/// The workers of a sweep: threads of this process, or those of all processes of an MPI job.
class Workers {
  public:
    Workers() = default;
    virtual ~Workers() = default;
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// Number of blocks that keep all workers busy.
    [[nodiscard]] virtual std::size_t capacity() const = 0;
    /// How many more blocks may be assigned now.
    [[nodiscard]] virtual std::size_t vacancies() const = 0;
    /// Gives a block to a worker; requires vacancies() > 0.
    virtual void assign(const Block& block) = 0;
    /// A finished block; none if none is finished within @p patience. Rethrows what the work threw.
    [[nodiscard]] virtual std::optional<FinishedBlock> finished(std::chrono::microseconds patience) = 0;
};

/// The threads of this process. Each computes one block while another one waits for it.
class ThreadWorkers : public Workers {
  public:
    ThreadWorkers(int threads, Work work);
    /// Drops the blocks that are not begun and waits for the others.
    ~ThreadWorkers() override;
    ThreadWorkers(const ThreadWorkers&) = delete;
    ThreadWorkers& operator=(const ThreadWorkers&) = delete;

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
