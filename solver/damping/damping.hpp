// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/quantities/names.hpp"
#include "core/quantities/parameter.hpp"
#include "core/units/units.hpp"

namespace ashimpact {

/// How eta of the damping force F_d = eta d(delta)/dt depends on the contact. The type of each value is in
/// the list of registry.hpp, which compares the two.
enum class DampingLaw { constant, contact_radius, tsuji, hunt_crossley, brach_dunn };

/// Names as on the command line and in artifacts.
template <>
struct Names<DampingLaw> {
    static constexpr std::string_view kind = "damping law";
    static constexpr std::array<std::string_view, 5> all{"constant", "contact-radius", "tsuji",
                                                         "hunt-crossley", "brach-dunn-damping"};
};

/// Static forces of a contact in one state, for damping that follows them; scaled as in Hertz.
template <class U>
struct StaticForces {
    U repulsion;   ///< F_r, its Hertzian part: K a^3/R* until a contact yields
    U attraction;  ///< |F_a|, the rest: F = F_r - |F_a|
};

/// Most terms that a damping law has: eta = sum of C_k f_k(a, F_r, |F_a|).
inline constexpr std::size_t most_damping_terms = 2;

/// Scaled coefficients of the terms of a damping law [1].
template <class Real>
using DampingNumbers = std::array<Real, most_damping_terms>;

/// A damping law and its coefficient C >= 0 [SI unit of the law's dimension], from which those of all its
/// terms follow, with the law's parameters where it has any.
struct Damping {
    DampingLaw law = DampingLaw::constant;
    double coefficient = 0.0;
};

/// What the law describes, in some words.
[[nodiscard]] std::string_view summary_of(DampingLaw law);
/// What the coefficient measures.
[[nodiscard]] Dimension dimension_of(DampingLaw law);
/// SI unit of the coefficient.
[[nodiscard]] std::string_view unit_of(DampingLaw law);

/// The parameters that the law declares; their values are among those of the contact pair.
[[nodiscard]] std::span<const LawParameter> parameters_of(DampingLaw law);
/// Whether scaled impacts depend on one damping number: the law has one term. Kernels, tables and maps leave
/// other damping laws to the scalar solver.
[[nodiscard]] bool has_one_number(DampingLaw law);
/// Coefficients of the terms after the first, by the parameter that each of them is.
[[nodiscard]] ParameterValues<double> further_coefficients(const Damping& damping,
                                                           const ParameterValues<double>& values);
/// Whether any term acts, its coefficient being above 0. @param values those of the law's parameters
[[nodiscard]] bool is_damped(const Damping& damping, const ParameterValues<double>& values);
/// Whether the damping vanishes with the contact radius, without adhesion. If it does not, every contact
/// without adhesion that ends at zero overlap has a critical velocity.
[[nodiscard]] bool vanishes_at_touch(DampingLaw law);
/// Square of the scaled coefficient from which on every impact that touches at zero contact radius is
/// captured; infinite if there is none [1].
[[nodiscard]] double overdamped_squared(DampingLaw law);
/// Whether a scaled coefficient reaches overdamped_squared().
template <class Real>
[[nodiscard]] bool is_overdamped(DampingLaw law, const Real& number) {
    return number * number >= Real(overdamped_squared(law));
}
/// Scaled coefficient of a Hertz impact with e = 1 - @p loss, approximately [1].
[[nodiscard]] double hertz_damping_number(DampingLaw law, double loss);

}  // namespace ashimpact
