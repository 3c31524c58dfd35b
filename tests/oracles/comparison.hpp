// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/oracles/column.hpp"

namespace ashimpact::oracles {

/// One impact and what each oracle that covers it found, in the order of the oracles.
struct ComparedImpact {
    struct Answer {
        std::string column;
        ImpactResult result;
    };
    ImpactCase impact;
    std::vector<Answer> answers;
};

/// One set of parameters around its critical velocity.
struct ComparedVerdict {
    struct Answer {
        std::string column;
        bool rebounds_below;  ///< at 0.999 of the critical velocity
        bool rebounds_above;  ///< at 1.001
    };
    ImpactCase impact;
    double critical_velocity;  ///< [m/s]
    std::vector<Answer> answers;
};

std::vector<ComparedImpact> compare_impacts(std::span<const Column> columns,
                                            std::span<const ImpactCase> impacts);

/// @param critical_velocity what is put to the test [m/s]
std::vector<ComparedVerdict> compare_verdicts(
    std::span<const Column> columns, std::span<const ImpactCase> impacts,
    const std::function<double(const ImpactCase&)>& critical_velocity);

/// Returns the largest relative difference of restitution, contact time and maximum overlap [-].
double deviation(const ImpactResult& a, const ImpactResult& b);

/// Returns the largest relative error claimed for restitution, contact time and maximum overlap [-].
double claimed_error(const ImpactResult& result);

/// The comparisons as Markdown tables, deviations from the first oracle.
std::string impacts_table(std::span<const Column> columns, std::span<const ComparedImpact> compared);
std::string verdicts_table(std::span<const Column> columns, std::span<const ComparedVerdict> compared);

}  // namespace ashimpact::oracles
