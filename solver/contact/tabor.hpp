// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "core/quantities/names.hpp"

namespace ashimpact {

/// Which limit of adhesion a contact is near; Johnson & Greenwood 1997 (J. Colloid Interface Sci. 192:326).
enum class AdhesionRegime {
    none,     ///< no work of adhesion
    dmt,      ///< Tabor parameter below dmt_limit: hard and small, attraction acts around the contact
    between,  ///< neither limit holds
    jkr,      ///< Tabor parameter above jkr_limit: soft and large, attraction acts within the contact
};

template <>
struct Names<AdhesionRegime> {
    static constexpr std::string_view kind = "adhesion regime";
    static constexpr std::array<std::string_view, 4> all{"none", "dmt", "between", "jkr"};
};

/// Tabor parameters between these belong to neither limit (Johnson & Greenwood 1997): DMT below, JKR above.
inline constexpr double dmt_limit = 0.1;
inline constexpr double jkr_limit = 5.0;

/// Whether a Tabor parameter is nearer to the limit of JKR than to that of DMT, in its logarithm.
[[nodiscard]] constexpr bool nearer_to_jkr(double tabor) {
    return tabor * tabor > dmt_limit * jkr_limit;
}

/// How far a law is to be trusted for a contact: the reason, in order of preference. Of several laws the one
/// with the least value is reported.
enum class Trust {
    describes_yield,       ///< the contact yields, and the law describes it
    every_tabor,           ///< the law holds for every Tabor parameter
    no_adhesion,           ///< the contact has no adhesion, nor has the law
    nearer_limit,          ///< the law is the limit that is nearer
    nearer_limit_elastic,  ///< the same, of a law whose yielding is not used
    farther_limit,
    farther_limit_elastic,
    empirical,             ///< its adhesion is empirical, and depends on the work of adhesion
    empirical_parameters,  ///< its adhesion is empirical, and depends on parameters of the law alone
    leaves_adhesion_out,   ///< the contact has adhesion, the law has none
};

}  // namespace ashimpact
