// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// The calibration of a case, starting from its moduli and contacts.
/// @throws InputError with the place in the case
[[nodiscard]] CalibrationProblem calibration_problem(const Case& data, const ModulusResult& moduli,
                                                     const ContactResult& contacts);

/// How the inferred constants of each sample of a case follow its contact modulus: those that the case's
/// calibration leaves free and whose origin is "inferred". All others do not follow.
/// @param record gets a note if the calibration cannot be linearised; they are then taken as independent
[[nodiscard]] std::vector<CalibrationResponse> calibrated_constants(const Case& data,
                                                                    const ModulusResult& moduli,
                                                                    const ContactResult& contacts,
                                                                    StageRecord& record);

}  // namespace ashimpact
