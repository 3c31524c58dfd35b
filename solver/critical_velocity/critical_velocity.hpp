// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "solver/motion/impact.hpp"

namespace ashimpact {

enum class CaptureVerdict {
    finite,           ///< captured below the critical velocity, rebounding above it
    always_captured,  ///< captured at every velocity
    never_captured,   ///< rebounding at every velocity
};

template <>
struct Names<CaptureVerdict> {
    static constexpr std::string_view kind = "verdict";
    static constexpr std::array<std::string_view, 3> all{"finite", "always-captured", "never-captured"};
};

/// An impact whose critical velocity is asked for.
struct CriticalVelocityProblem {
    Law law;
    Detachment detachment;
    Damping damping;
    ContactPair contact;
};

struct CriticalVelocity {
    CaptureVerdict verdict = CaptureVerdict::finite;
    std::optional<double> value{};            ///< v_c, where finite [m/s]
    std::optional<double> contact_time{};     ///< first touch to arrival at rest; none: it never ends [s]
    std::optional<double> maximum_overlap{};  ///< greatest overlap at v_c [m]
    double dissipated = 0.0;                  ///< work taken by damping at v_c [J]
    double plastic = 0.0;                     ///< work spent in yielding at v_c [J]
    double detachment_energy = 0.0;           ///< U(end) - U(touch): cost of the break itself [J]
    std::vector<double> crossings{};  ///< every velocity at which capture and rebound change places [m/s]
};

/// The verdict on elastic impacts without adhesion that end at zero overlap, if it is the same at every
/// velocity. Undamped impacts are never captured. Nor are those whose damping vanishes with the contact
/// radius, except from the limit of the damping law on (Tsuji's sqrt(5)), where all are captured. None for
/// damping that does not vanish: then v_c is finite.
[[nodiscard]] std::optional<CaptureVerdict> verdict_without_adhesion(const Damping& damping,
                                                                     const ContactPair& contact);

/// The dynamic critical velocity v_c: an impact at v_c arrives at the end of contact at rest.
///
/// Orbits cannot cross, so rebound speed is monotone in the incident velocity, and one integration backward
/// in time from the end gives v_c without root finding: v_c^2 = 2 (D + U_end - U_touch)/m. The dissipated
/// work D is integrated too, so nothing cancels under weak damping. Hertz with constant damping has v_c =
/// 0.5476175 eta^5/(m^3 k^2). Where the contact yields there may be several critical velocities, of which
/// this is the least by greatest contact; verdicts then hold for overlaps up to R* only.
///
/// Precision::standard follows elastic orbits in double precision, a fifth of the time; contacts that can
/// yield take extended precision in any case.
/// @throws InputError for inadmissible input, ConvergenceError if the step count runs away
[[nodiscard]] CriticalVelocity critical_velocity(const CriticalVelocityProblem& problem,
                                                 Precision precision = Precision::extended);

/// The damping coefficient whose v_c is @p velocity, the least that captures there, to 1e-12; none if it is
/// not within 30 % of that of the problem. Errors: as critical_velocity().
[[nodiscard]] std::optional<double> capturing_damping(CriticalVelocityProblem problem, double velocity);

/// v_c m^3 k^2 / eta^5 of Hertz with constant damping and zero-overlap detachment [1].
inline constexpr double hertz_critical_constant = 0.54761752963804861;

}  // namespace ashimpact
