// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/app/sweep/spec/impacts.hpp"
#include "solver/batch/columns.hpp"

namespace ashimpact {

/// Results wanted in addition to the restitution (others stay empty), and the method to compute them.
struct WantedResults {
    bool contact_time = false;
    bool maximum_overlap = false;
    BatchMethod method = BatchMethod::integration;
};

/// An impact that did not converge.
struct FailedSolution {
    std::uint64_t place;  ///< among the impacts
    std::string reason;
    std::string command;  ///< shell command that computes this impact alone
};

/// Results of the impacts, one entry each; NaN if an impact did not converge.
struct ResultColumns {
    std::vector<double> restitution;      ///< 0 for a capture
    std::vector<double> contact_time;     ///< NaN for a capture [s]
    std::vector<double> maximum_overlap;  ///< [m]
    std::vector<FailedSolution> failed{};
};

/// Solves many impacts. The result of an impact must not depend on the other impacts.
using ImpactSolver =
    std::function<ResultColumns(const ImpactModel&, const ImpactColumns&, const WantedResults&)>;

/// The batch solver, on the calling thread. Impacts that do not converge are listed. @throws InputError
/// naming what a variable may not be
[[nodiscard]] ResultColumns solve_in_batch(const ImpactModel& model, const ImpactColumns& impacts,
                                           const WantedResults& wanted);

}  // namespace ashimpact
