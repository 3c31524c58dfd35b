// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/quantities/names.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact {

/// A 95 % interval; an end that the data do not bound is none.
struct Bounds {
    std::optional<double> lower{}, upper{};

    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// How a critical velocity was found.
enum class VelocityMethod {
    estimate,         ///< from all impacts, captures included
    extrapolation,    ///< the paper's polynomial eta(e) at e = 0
    critical_damping  ///< from the critical damping as 6-fit.json states it
};

template <>
struct Names<VelocityMethod> {
    static constexpr std::string_view kind = "method";
    static constexpr std::array<std::string_view, 3> all{
        "posterior of v_c with a smooth curve of damping over velocity, captures by their probability",
        "eta(e) extrapolated to e = 0, a polynomial (Dong et al. 2013)", "critical damping of 6-fit.json"};
};

/// A critical velocity with its interval: the form in which every part of a run states one.
struct VelocityEstimate {
    double value = 0;                              ///< [m/s]
    std::optional<double> standard_uncertainty{};  ///< [m/s]
    std::optional<Bounds> interval{};              ///< [m/s]; none: not known
    std::optional<VelocityMethod> method{};        ///< none: not stated, as of a measured velocity
};

/// A result of the solver with its uncertainty and interval, without ends that are not finite.
[[nodiscard]] inline VelocityEstimate estimate_of(const Interval& interval) {
    const auto finite = [](const std::optional<double>& value) {
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    return {.value = interval.value,
            .standard_uncertainty = finite(interval.standard_uncertainty),
            .interval = Bounds{finite(interval.lower), finite(interval.upper)}};
}

}  // namespace ashimpact
