// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/motion/scale.hpp"

namespace ashimpact {

/// Contact time of an undamped impact by Hertz [s]: 3.218 (m^2/(k^2 v))^(1/5); Johnson 1985, section 11.4.
[[nodiscard]] inline double hertz_contact_time(const ContactPair& pair, double velocity) {
    constexpr double scaled = 3.218065459719045;  // 2 (5/4)^(2/5) sqrt(pi) Gamma(7/5)/Gamma(9/10)
    return scaled * Scale::of(pair, velocity).time();
}

}  // namespace ashimpact
