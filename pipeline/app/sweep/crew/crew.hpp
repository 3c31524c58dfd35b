// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>

#include "pipeline/app/sweep/crew/team.hpp"
#include "pipeline/app/sweep/crew/threads.hpp"

namespace ashimpact {

/// The threads of this process. Each computes one block while another one waits for it.
class Crew : public Team {
  public:
    Crew(int threads, Work work);

    [[nodiscard]] std::size_t capacity() const override { return capacity_; }
    [[nodiscard]] std::size_t vacancies() const override { return capacity() - assigned_; }
    void assign(const Block& block) override;
    [[nodiscard]] std::optional<FinishedBlock> finished(std::chrono::microseconds patience) override;

  private:
    void compute(const Block& block);

    std::size_t capacity_;
    Work work_;
    std::size_t assigned_ = 0;  ///< blocks not yet returned by finished()

    std::mutex mutex_;  ///< guards the members below it
    std::condition_variable changed_;
    std::deque<FinishedBlock> finished_;
    std::exception_ptr failure_;

    Threads threads_;  ///< last, so that they have ended before what they use goes
};

/// Number of threads for this process: its share of the cores that the processes of the job may use on this
/// machine.
[[nodiscard]] int default_threads(int processes_here);

}  // namespace ashimpact
