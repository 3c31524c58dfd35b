// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/inference/calibration/calibration_response.hpp"

namespace ashimpact {

/// How the inferred constants of each sample of a case follow its contact modulus: those that the case's
/// calibration leaves free and whose origin is "inferred". All others do not follow.
/// @param warnings why they are taken as independent of the modulus, if the calibration cannot be linearised
[[nodiscard]] std::vector<CalibrationResponse> calibrated_constants(const Case& data, const Artifacts& before,
                                                                    std::vector<std::string>& warnings);

}  // namespace ashimpact
