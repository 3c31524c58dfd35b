// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "core/quantities/names.hpp"

namespace ashimpact {

/// Where a contact ends; part of the physics, so recorded with every result.
enum class Detachment {
    zero_overlap,     ///< the surfaces are back where they first touched: delta = 0
    zero_force,       ///< the total force, damping included, has fallen to zero
    pull_off,         ///< displacement-controlled break: least overlap, the fold of the JKR curve
    load_controlled,  ///< load-controlled break: greatest tension
};

/// Names as on the command line and in artifacts.
template <>
struct Names<Detachment> {
    static constexpr std::string_view kind = "detachment";
    static constexpr std::array<std::string_view, 4> all{"zero-overlap", "zero-force", "pull-off",
                                                         "load-controlled"};
};

}  // namespace ashimpact
