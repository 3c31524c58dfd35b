// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

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
    ~MpiSession() = default;
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;
    MpiSession(MpiSession&&) = delete;
    MpiSession& operator=(MpiSession&&) = delete;

    /// Starts MPI if this process was started by mpirun or the like.
    /// @throws InputError if that belongs to an MPI other than the one this program is linked with
    void join();
    /// Leaves the job. A status other than 0 aborts the job with that status on all ranks.
    /// @returns the status
    int leave(int status);

    [[nodiscard]] bool joined() const { return joined_; }
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

}  // namespace ashimpact
