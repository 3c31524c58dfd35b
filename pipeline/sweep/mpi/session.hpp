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
    /// Leaves the job. With a status that is not zero the job ends here and now, with that status, for all.
    /// @returns the status
    int leave(int status);

    [[nodiscard]] bool joined() const { return joined_; }
    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    /// Processes of the job on this machine.
    [[nodiscard]] int size_here() const { return size_here_; }

    /// Text of rank 0, for all.
    [[nodiscard]] std::string broadcast(const std::string& text) const;
    void send(int rank, int tag, const std::string& bytes) const;
    /// A message that has arrived, from any rank; does not wait for one.
    [[nodiscard]] std::optional<Message> receive() const;

  private:
    bool joined_ = false;
    int rank_ = 0;
    int size_ = 1;
    int size_here_ = 1;
};

}  // namespace ashimpact
