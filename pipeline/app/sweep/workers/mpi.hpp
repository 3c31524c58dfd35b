// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/app/sweep/workers/workers.hpp"

namespace ashimpact {

/// A message of another process.
struct Message {
    int rank;
    int tag;
    std::string bytes;
};

/// The MPI job this process belongs to. Outside mpirun there is none: one process, rank 0, and MPI is never
/// started, which takes longer than a small sweep.
class MpiSession {
  public:
    MpiSession() = default;
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;

    /// Starts MPI if this process was started by mpirun or the like.
    /// @throws InputError if that belongs to an MPI other than the one this program is linked with
    void join();
    /// Leaves the job. A status other than 0 aborts the job with that status on all ranks.
    /// @returns the status
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
    };
    [[nodiscard]] std::optional<FinishedBlock> received();

    Workers& own_;
    const MpiSession& session_;
    std::vector<Rank> others_;  ///< by rank; the entry of rank 0 is unused
};

/// Work of every rank other than 0: computes blocks until it is dismissed.
void serve(Workers& own, const MpiSession& session);

}  // namespace ashimpact
