// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "solver/inference/calibration/calibration.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

/// Profile of one calibrated constant: its interval when all others are free to follow it.
struct ConstantProfile {
    Interval interval;  ///< 95 %, from the rise of chi^2; an end beyond a factor of 10 is missing
    bool identifiable;  ///< whether both ends were found
    std::vector<std::size_t> traded_with;  ///< constants with which it is correlated by more than 0.95
    std::string statement;                 ///< in words, if it is not identifiable; else empty
};

/// Profile-likelihood intervals of the constants of a calibration, in their order.
/// @param summary of that problem
/// @param on_profile called after each constant with how many are done; may be empty
/// @throws ConvergenceError
[[nodiscard]] std::vector<ConstantProfile> profile_constants(
    const CalibrationProblem& problem, const CalibrationSummary& summary,
    const std::function<void(std::size_t done)>& on_profile = {});

}  // namespace ashimpact
