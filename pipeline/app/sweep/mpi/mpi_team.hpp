// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/app/sweep/crew/team.hpp"
#include "pipeline/app/sweep/mpi/session.hpp"

namespace ashimpact {

/// The threads of all processes of an MPI job, as rank 0 sees them.
class MpiTeam : public Team {
  public:
    /// @param own the threads of rank 0. Every other rank must call serve().
    MpiTeam(Team& own, const MpiSession& session);

    [[nodiscard]] std::size_t capacity() const override;
    [[nodiscard]] std::size_t vacancies() const override;
    void assign(const Block& block) override;
    [[nodiscard]] std::optional<FinishedBlock> finished(std::chrono::microseconds patience) override;

    /// Tells the others that nothing is left to do.
    void dismiss() const;

  private:
    struct Member {
        std::size_t capacity = 0;
        std::size_t assigned = 0;
    };
    [[nodiscard]] std::optional<FinishedBlock> received();

    Team& own_;
    const MpiSession& session_;
    std::vector<Member> others_;  ///< by rank; the entry of rank 0 is unused
};

/// Work of every rank other than 0: computes blocks until it is dismissed.
void serve(Team& own, const MpiSession& session);

}  // namespace ashimpact
