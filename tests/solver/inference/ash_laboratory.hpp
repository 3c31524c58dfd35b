// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/contact/law.hpp"
#include "tests/solver/inference/synthetic_laboratory.hpp"

namespace ashimpact::test {

/// A true damping curve for the 96 um sample of Dong et al. 2013.
enum class TrueDamping {
    quadratic,    ///< the law's row of Table 2; that of Brach-Dunn for laws without one
    exponential,  ///< c (0.35 + 0.65 exp(-2.4 e))
    bent,         ///< c (1 - 0.7 e - 0.2 tanh(4 e) + 0.2 e^2)
};

/// A contact of the 96 um sample and a map of the law around the velocities of its impacts.
[[nodiscard]] ContactModel ash_model(Law law);

/// 60 impacts between 0.6 and 3 times v_c, seen by the paper's camera (80,000 frames/s) with pixels of 8 um
/// and 5 frames for each velocity: 0.058 m/s.
[[nodiscard]] SyntheticLaboratory ash_laboratory(const ContactModel& model, TrueDamping damping);

}  // namespace ashimpact::test
