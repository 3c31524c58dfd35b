// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// Orders the samples of a calibration, by size, so that no result depends on their order in the case.
[[nodiscard]] inline auto calibration_key(const Sample& sample) {
    return std::pair(sample.diameter.value(), std::string_view(sample.name));
}

/// The calibration of a case, starting from its moduli and contacts. Samples are those of the case in the
/// order of calibration_key(), constants in descending order of their names.
/// @throws InputError with the place in the case
[[nodiscard]] CalibrationProblem calibration_problem(const Case& data, const ModulusResult& moduli,
                                                     const ContactResult& contacts);

/// Published numbers that a calibration leaves out, and those whose uncertainty it assumes.
[[nodiscard]] std::vector<Finding> doubts_of_published(const Case& data);

/// How the inferred constants of each sample of a case follow its contact modulus: those that the case's
/// calibration leaves free and whose origin is "inferred". All others do not follow.
/// @param record gets a note if the calibration cannot be linearised; they are then taken as independent
[[nodiscard]] std::vector<CalibrationResponse> calibrated_constants(const Case& data,
                                                                    const ModulusResult& moduli,
                                                                    const ContactResult& contacts,
                                                                    StageRecord& record);

}  // namespace ashimpact
