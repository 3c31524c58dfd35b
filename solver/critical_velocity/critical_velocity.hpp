#pragma once

#include "solver/motion/impact.hpp"

#include <optional>
#include <string_view>
#include <vector>

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

/// An impact whose velocity is asked for.
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
    double detachment_energy = 0.0;           ///< U(end) - U(touch): what the break itself costs [J]
    int steps = 0;                            ///< Taylor steps taken
    std::vector<double> crossings{};  ///< every velocity at which capture and rebound change places [m/s]
};

/// What becomes of elastic impacts without adhesion that end at zero overlap, if velocity does not matter.
/// Undamped they are never captured. With damping that vanishes with the contact radius they are never
/// captured either, unless the damping law has a limit (Tsuji's sqrt(5)) from which on they always are. None
/// for damping that does not vanish.
[[nodiscard]] std::optional<CaptureVerdict> verdict_without_adhesion(const Damping& damping);

/// The dynamic critical velocity v_c: the velocity whose impact arrives at the end of contact at rest.
///
/// One integration backward in time from there gives it, without root finding: orbits cannot cross, so
/// rebound speed is monotone in the incident velocity. v_c^2 = 2 (D + U_end - U_touch)/m. The dissipated work
/// D is integrated as well, so nothing cancels under weak damping. Hertz with constant damping: v_c =
/// 0.5476175 eta^5/(m^3 k^2).
/// @throws InputError for inadmissible input, ConvergenceError if the step count runs away
[[nodiscard]] CriticalVelocity critical_velocity(const CriticalVelocityProblem& problem);

/// v_c m^3 k^2 / eta^5 of Hertz with constant damping and zero-overlap detachment [1].
inline constexpr double hertz_critical_constant = 0.54761752963804861;

}  // namespace ashimpact
