// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/quantities/names.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// How the impacts of a batch are solved; both keep the bound of solve_impacts().
enum class BatchMethod {
    integration,  ///< each impact is integrated
    table,  ///< e and contact time come from a table of the law's impacts. Its parts are integrated when they
            ///< are first needed, then kept. Impacts next to the edge of capture are integrated. Faster from
            ///< about 100,000 impacts on, where contacts yield 500,000, with a cohesive zone 2 million.
            ///< Refused where has_tables() is false.
};

template <>
struct Names<BatchMethod> {
    static constexpr std::string_view kind = "method";
    static constexpr std::array<std::string_view, 2> all{"integration", "table"};
};

/// Whether there are tables of a contact law with a damping law: both have kernels.
[[nodiscard]] bool has_tables(Law law, DampingLaw damping_law);
/// The method for many impacts of a contact law: table where there is one. Those of laws of three numbers
/// take longer to make and pay only where it is known that there are @p impacts enough.
[[nodiscard]] BatchMethod method_of_many(Law law, DampingLaw damping_law, std::uint64_t impacts = 0);
/// The same for critical velocities: those of a cohesive zone are tabulated from so many @p velocities on.
[[nodiscard]] BatchMethod method_of_many_velocities(Law law, std::uint64_t velocities);

}  // namespace ashimpact
