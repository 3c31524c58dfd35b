// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/case/case.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// Constants of one law for all sizes, from critical velocities.
struct SizeCalibration {
    Case data;                   ///< its samples have names alone, the sizes
    CalibrationProblem problem;  ///< from the best start on a grid
};

/// The calibration of `calibrate --sizes`. @throws InputError naming the option or the place in the table
[[nodiscard]] SizeCalibration read_size_calibration(const CommandOptions& options,
                                                    const std::vector<FreeConstant>& free);

/// Whether chi^2 admits the law with the calibrated constants; none without degrees of freedom.
[[nodiscard]] std::optional<bool> fits_the_data(const CalibrationSummary& summary);

/// A probability of chi^2 in words; below one in a million no digit of it means anything.
[[nodiscard]] std::string probability_text(double probability);

/// What a calibration over sizes comes to, in words.
[[nodiscard]] std::string conclusion_of_sizes(const CalibrationSummary& summary);

}  // namespace ashimpact
