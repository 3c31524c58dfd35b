// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"

namespace ashimpact {

/// What a critical velocity of the literature is.
enum class VelocityBasis {
    measured,
    model,        ///< computed by the authors
    second_hand,  ///< measured, as others state it
    extrapolated  ///< by the authors, beyond their impacts
};

template <>
struct Names<VelocityBasis> {
    static constexpr std::string_view kind = "basis";
    static constexpr std::array<std::string_view, 4> all{"measured", "model", "second-hand", "extrapolated"};
};

/// A critical velocity that others published.
struct LiteratureVelocity {
    std::string name, particle, wall, conditions;
    std::optional<double> diameter{};  ///< none: missing where it was read [m]
    std::optional<double> lower{};     ///< none: only the upper bound is known [m/s]
    double upper = 0;                  ///< equal to `lower` for a single value [m/s]
    VelocityBasis basis = VelocityBasis::measured;

    /// A single value [m/s]; none for a range or a bound.
    [[nodiscard]] std::optional<double> value() const { return lower == upper ? lower : std::nullopt; }
};

/// A publication with critical velocities, one file of data/measured.
struct LiteratureSource {
    std::string key;        ///< in data/references.bib, "arffman2015"
    std::string reference;  ///< for readers
    std::string doi;        ///< empty: not known
    std::string read;       ///< what of it was read, and where
    std::vector<std::string> missing{};
    std::optional<double> exponent{};  ///< of v_c over the diameter, as the authors state it [1]
    std::vector<LiteratureVelocity> velocities{};
};

/// All sources that the program carries, in the order of their keys.
[[nodiscard]] const std::vector<LiteratureSource>& literature();

/// The source of that key. @throws InputError naming the others
[[nodiscard]] const LiteratureSource& literature_source(std::string_view key);

}  // namespace ashimpact
