#pragma once

#include "solver/calibration/calibration.hpp"
#include "solver/uncertainty/interval.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ashimpact {

/// What the observations say of one calibrated constant when all others are free to follow it.
struct ConstantProfile {
    Interval interval;  ///< 95 %, from the rise of chi^2; an end further than a factor of 10 is missing
    bool identifiable;  ///< both ends are there
    std::vector<std::size_t> traded_with;  ///< constants with which it is correlated by more than 0.95
    std::string statement;                 ///< in words where it is not identifiable, else empty
};

/// Profile-likelihood intervals of the constants of a calibration, in their order.
/// @param summary of that problem @throws ConvergenceError
[[nodiscard]] std::vector<ConstantProfile> profile_constants(const CalibrationProblem& problem,
                                                             const CalibrationSummary& summary);

}  // namespace ashimpact
