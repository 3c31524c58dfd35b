// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/contact/pair.hpp"
#include "solver/damping/registry.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// Units of the scaled impact problem, in which mass and Hertz stiffness are 1: choose a velocity, the rest
/// follows from L = (m V^2/k)^(2/5).
template <class Real>
struct BasicScale {
    Real mass;           ///< [kg]
    Real stiffness;      ///< k [N/m^(3/2)]
    Real velocity;       ///< V [m/s]
    Real length;         ///< L [m]
    Real radius_length;  ///< sqrt(R* L), unit of the contact radius [m]

    /// @param velocity V > 0 [m/s]
    [[nodiscard]] static BasicScale of(const BasicContactPair<Real>& pair, const Real& velocity) {
        const Real stiffness = hertz_stiffness(pair);
        const Real length = two_fifths_power(pair.mass * velocity * velocity / stiffness);
        return {.mass = pair.mass,
                .stiffness = stiffness,
                .velocity = velocity,
                .length = length,
                .radius_length = root<2>(pair.effective_radius * length)};
    }

    /// The same units from their length, for numbers that do not depend on the velocity. @param length L > 0
    /// [m]
    [[nodiscard]] static BasicScale of_length(const BasicContactPair<Real>& pair, const Real& length) {
        const Real stiffness = hertz_stiffness(pair);
        return {.mass = pair.mass,
                .stiffness = stiffness,
                .velocity = root<2>(stiffness * root<2>(length) / pair.mass) * length,
                .length = length,
                .radius_length = root<2>(pair.effective_radius * length)};
    }

    [[nodiscard]] Real time() const { return length / velocity; }             ///< [s]
    [[nodiscard]] Real energy() const { return mass * velocity * velocity; }  ///< [J]
    [[nodiscard]] Real force() const { return energy() / length; }            ///< [N]
    [[nodiscard]] Real momentum() const { return mass * velocity; }           ///< [N s]

    /// The scaled coefficient C of a damping law [1]; beta = eta m^(-3/5) k^(-2/5) V^(-1/5) for constant
    /// damping.
    [[nodiscard]] Real damping_number(const Damping& damping) const {
        return Real(damping.coefficient) / damping_unit(damping.law);
    }
    /// The coefficient of this scaled value, the inverse of damping_number() [unit of the law].
    [[nodiscard]] Real damping_coefficient(DampingLaw law, const Real& number) const {
        return number * damping_unit(law);
    }
    /// The coefficient whose scaled value is 1 [unit of the law].
    [[nodiscard]] Real damping_unit(DampingLaw law) const {
        return RegisteredDampings::visit<Real>(law, [this]<class D>() { return D::units(*this)[0]; });
    }
    /// The scaled coefficients of all terms of a damping law D. @param values those of its parameters
    template <class D>
    [[nodiscard]] DampingNumbers<Real> damping_numbers(double coefficient,
                                                       const ParameterValues<double>& values) const {
        static_assert(terms_of<D> <= most_damping_terms);
        const auto coefficients = coefficients_of<D>(coefficient, values);
        const auto units = D::units(*this);
        DampingNumbers<Real> numbers{};
        for (std::size_t k = 0; k < terms_of<D>; ++k) numbers[k] = Real(coefficients[k]) / units[k];
        return numbers;
    }
    [[nodiscard]] DampingNumbers<Real> damping_numbers(const Damping& damping,
                                                       const ParameterValues<double>& values) const {
        return RegisteredDampings::visit<DampingNumbers<Real>>(
            damping.law, [&]<class D>() { return damping_numbers<D>(damping.coefficient, values); });
    }
};
using Scale = BasicScale<double>;

/// Contact time of an undamped impact by Hertz [s]: 3.218 (m^2/(k^2 v))^(1/5); Johnson 1985, section 11.4.
[[nodiscard]] inline double hertz_contact_time(const ContactPair& pair, double velocity) {
    constexpr double scaled = 3.218065459719045;  // 2 (5/4)^(2/5) sqrt(pi) Gamma(7/5)/Gamma(9/10)
    return scaled * Scale::of(pair, velocity).time();
}

}  // namespace ashimpact
