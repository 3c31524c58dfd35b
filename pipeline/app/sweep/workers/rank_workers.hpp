// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/app/sweep/workers/mpi_session.hpp"
#include "pipeline/app/sweep/workers/workers.hpp"

namespace ashimpact {

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
