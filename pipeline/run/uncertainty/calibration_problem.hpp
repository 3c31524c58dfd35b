// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// The calibration of a case, starting from its moduli and contacts.
/// @throws InputError with the place in the case
[[nodiscard]] CalibrationProblem calibration_problem(const Case& data, const ModulusResult& moduli,
                                                     const ContactResult& contacts);

}  // namespace ashimpact
