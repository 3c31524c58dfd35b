// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/case/case.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

/// The calibration a case asks for; starts from its modulus and contact artifacts.
/// @throws InputError with the place in the case
[[nodiscard]] CalibrationProblem calibration_problem(const Case& data, const Artifacts& before);

}  // namespace ashimpact
