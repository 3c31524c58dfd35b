// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "solver/contact/law.hpp"

namespace ashimpact {

/// The yield pressure of a contact pair, which plastic laws read, declared as parameters of laws are.
inline constexpr LawParameter yield_pressure{
    .name = "yield_pressure",
    .dimension = Dimension::pressure,
    .description = "p_y, yield pressure; a sphere without it never yields",
    .example = "35.3 MPa",
    .typical = 3.53e7,
    .otherwise = std::numeric_limits<double>::infinity(),
};

/// The parameters of a law and, if it is plastic, the yield pressure.
[[nodiscard]] inline std::vector<LawParameter> inputs_of(Law law) {
    std::vector<LawParameter> inputs(law.parameters().begin(), law.parameters().end());
    if (law.is_plastic()) inputs.push_back(yield_pressure);
    return inputs;
}

}  // namespace ashimpact
