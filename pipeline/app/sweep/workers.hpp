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

#include "pipeline/app/sweep/block.hpp"

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

/// Number of threads for this process: its share of the cores that the job may use on this machine.
[[nodiscard]] int default_threads(int processes_here);

struct Message {
    int rank;  ///< of its sender
    int tag;
    std::string bytes;
};

/// The MPI job of this process; outside mpirun one process of rank 0, without MPI, whose start takes long.
class MpiSession {
  public:
    MpiSession() = default;
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;

    /// Starts MPI if mpirun started this process. @throws InputError if it is of another MPI than ours
    void join();
    /// Leaves the job; a status other than 0 aborts it on all ranks. @returns the status
    int leave(int status);

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    /// Processes of the job on this machine.
    [[nodiscard]] int size_here() const { return size_here_; }
    /// The text of rank 0, on every rank.
    [[nodiscard]] std::string broadcast(const std::string& text) const;
    void send(int rank, int tag, const std::string& bytes) const;
    /// A message from any rank, if one has arrived; does not wait.
    [[nodiscard]] std::optional<Message> receive() const;

  private:
    bool joined_ = false;
    int rank_ = 0;
    int size_ = 1;
    int size_here_ = 1;
};

/// The threads of all processes of an MPI job, as rank 0 sees them.
class RankWorkers : public Workers {
  public:
    /// @param own the threads of rank 0. Every other rank must call serve().
    RankWorkers(Workers& own, const MpiSession& session);

    [[nodiscard]] std::size_t capacity() const override;
    [[nodiscard]] std::size_t vacancies() const override;
    void assign(const Block& block) override;
    [[nodiscard]] std::optional<FinishedBlock> finished(std::chrono::microseconds patience) override;

    /// Tells the others that nothing is left to do.
    void dismiss() const;

  private:
    struct Rank {
        std::size_t capacity = 0;
        std::size_t assigned = 0;
        [[nodiscard]] std::size_t vacancies() const { return capacity - assigned; }
    };
    [[nodiscard]] std::optional<FinishedBlock> received();

    Workers& own_;
    const MpiSession& session_;
    std::vector<Rank> others_;  ///< by rank; the entry of rank 0 is unused
};

/// Work of every rank other than 0: computes blocks until it is dismissed.
void serve(Workers& own, const MpiSession& session);

}  // namespace ashimpact
