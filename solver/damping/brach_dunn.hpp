// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/quantities/parameter.hpp"
#include "solver/damping/hunt_crossley.hpp"

namespace ashimpact {

/// zeta_A of BrachDunnDamping.
inline constexpr LawParameter adhesion_damping{
    .name = "adhesion_damping",
    .dimension = Dimension::inverse_velocity,
    .description = "zeta_A, damping per attractive force",
    .example = "0.1 s/m",
    .typical = 0.1,
    .may_be_zero = true,
    .choice = 2,
    .of_attraction = true,
};
/// zeta_A/zeta_H of BrachDunnDamping.
inline constexpr LawParameter adhesion_damping_ratio{
    .name = "adhesion_damping_ratio",
    .dimension = Dimension::fraction,
    .description = "zeta_A/zeta_H, damping per attractive force over that per repulsive force",
    .example = "1",
    .typical = 1.0,
    .may_be_zero = true,
    .choice = 2,
    .of_attraction = true,
};

/// Repulsion and attraction damped apart, eta = zeta_H F_r + zeta_A |F_a| (Brach & Dunn 1995, Aerosol Sci.
/// Technol. 23:51, the paper's reference [11]; their contact law is BrachDunn). Of an attraction the damping
/// takes the magnitude: read with its sign it would feed energy in.
struct BrachDunnDamping {
    static constexpr DampingLaw law = DampingLaw::brach_dunn;
    static constexpr std::string_view summary = "repulsion and attraction damped apart";
    static constexpr Dimension dimension = Dimension::inverse_velocity;
    static constexpr double overdamped_squared = HuntCrossleyDamping::overdamped_squared;
    static constexpr double error_weight = 1.0;
    static constexpr std::array parameters{adhesion_damping_ratio, adhesion_damping};
    /// What the coefficients after the first are.
    static constexpr std::array further{adhesion_damping};

    /// Terms of eta, each for the scaled coefficient 1.
    template <class U>
    [[nodiscard]] static constexpr std::array<U, 2> shapes(const U& /*u*/, const StaticForces<U>& forces) {
        return {forces.repulsion, forces.attraction};
    }
    /// Coefficients of the terms [s/m]; without a parameter, as beside no attraction, the second is 0.
    [[nodiscard]] static std::array<double, 2> coefficients(double coefficient,
                                                            const ParameterValues<double>& values) {
        if (values.has(adhesion_damping_ratio))
            return {coefficient, coefficient * values[adhesion_damping_ratio]};
        return {coefficient, values.has(adhesion_damping) ? values[adhesion_damping] : 0.0};
    }
    /// Coefficients whose scaled value is 1 [s/m].
    template <class Scale>
    [[nodiscard]] static auto units(const Scale& scale) {
        const auto unit = HuntCrossleyDamping::units(scale)[0];
        return std::array{unit, unit};
    }
    /// As of HuntCrossleyDamping, whose damping is the least that acts here.
    template <class Real>
    [[nodiscard]] static Real fastest_return(const DampingNumbers<Real>& numbers) {
        return HuntCrossleyDamping::fastest_return(numbers);
    }
    /// A Hertz impact feels the repulsive term alone [1].
    [[nodiscard]] static double hertz_restitution(double number) {
        return HuntCrossleyDamping::hertz_restitution(number);
    }
    [[nodiscard]] static double hertz_number(double loss) { return HuntCrossleyDamping::hertz_number(loss); }
};

}  // namespace ashimpact
