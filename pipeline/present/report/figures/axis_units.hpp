// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/present/report/drawing/panel.hpp"

namespace ashimpact::report {

/// A unit as shown.
struct ShownUnit {
    std::string name;  ///< "nm"
    double scale;      ///< of one [SI unit]
};

/// The unit with a prefix in which a value up to @p greatest reads as 1 to 1000; units without prefixes, and
/// 1, stay.
[[nodiscard]] ShownUnit shown_unit(std::string_view si, double greatest);

/// An axis of a quantity in SI with the unit in which @p greatest is a short number.
[[nodiscard]] Axis quantity_axis(std::string label, std::string_view si, double greatest);

/// v_in [m/s], and e_n.
[[nodiscard]] Axis velocity_axis();
[[nodiscard]] Axis restitution_axis();

/// The largest magnitude among numbers that are finite, 0 without any.
[[nodiscard]] double greatest_of(const std::vector<double>& values);

}  // namespace ashimpact::report
