// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/quantities/names.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

/// One normal impact: m d2(delta)/dt2 + eta d(delta)/dt + F(delta) = 0; Dong et al. 2013, Eq. 2.
struct Impact {
    Law law;
    Detachment detachment;
    Damping damping;
    ContactPair contact;
    double velocity;  ///< v_in > 0, approaching [m/s]
};

enum class Outcome { rebound, capture };

template <>
struct Names<Outcome> {
    static constexpr std::string_view kind = "outcome";
    static constexpr std::array<std::string_view, 2> all{"rebound", "capture"};
};

/// Where the energy of an impact went [J]. The ledger of a rebound ends at detachment, that of a capture at
/// the greatest overlap, or at rest in equilibrium if the motion never turns. incident + at_touch = remaining
/// + potential + dissipated + plastic + jumps + residual.
struct EnergyLedger {
    double incident;    ///< m v_in^2/2
    double remaining;   ///< kinetic energy at the end of the ledger
    double at_touch;    ///< potential at first touch; U is 0 at zero contact radius
    double potential;   ///< potential at the end of the ledger
    double dissipated;  ///< work taken by damping
    double plastic;     ///< work spent in yielding less adhesion gained by flattening; may be negative
    double jumps;       ///< lost where the surfaces jump together and apart; law maugis-dugdale only
    double residual;    ///< integration error: what is missing in the balance above
    double minimum;     ///< U_min, potential at static equilibrium: depth of the adhesive well
};

/// What one impact did; a captured particle has restitution 0 and no contact time.
struct ImpactResult {
    Outcome outcome;
    double restitution;                   ///< e_n = v_r/v_in [1]
    double rebound_velocity;              ///< v_r, magnitude [m/s]
    std::optional<double> contact_time;   ///< first touch to detachment [s]
    std::optional<double> approach_time;  ///< first touch to greatest overlap; none if it never turns [s]
    double maximum_overlap;               ///< greatest overlap, or its supremum if it never turns [m]
    bool yielded;                         ///< the contact went beyond its yield pressure
    EnergyLedger energy;
    int steps;  ///< Taylor steps taken
};

/// Why a detachment is not admissible for a law, in words; none if it is admissible. The static potential at
/// an admissible detachment is not below that at first touch; else an undamped impact would gain energy. It
/// is found once per process.
[[nodiscard]] const std::optional<std::string>& refusal(Law law, Detachment detachment);

/// The same for one contact. Law maugis-dugdale admits load-controlled if the greatest tension lies beyond
/// the reach of the cohesion, which depends on the transition parameter.
[[nodiscard]] std::optional<std::string> refusal(Law law, const ContactPair& contact, Detachment detachment);

/// The detachments admissible for a law, "pull-off, load-controlled, ...", for messages.
[[nodiscard]] std::string admissible_detachments(Law law);

/// Checks an impact's numbers. @throws InputError naming quantity, value, unit and what is allowed
void validate(const ContactPair& contact);
void validate(const Impact& impact);

/// Solves one impact to the rounding of extended precision; with Precision::standard impacts by law
/// maugis-dugdale in a third of the time, to that of double. Relative errors of restitution, times and
/// overlap are far below 1e-10 at fly-ash scale; they grow with the condition number 1 + |U_min|/(m v^2/2).
/// @throws InputError for inadmissible input, ConvergenceError at the step limit
[[nodiscard]] ImpactResult solve_impact(const Impact& impact, Precision precision = Precision::extended);

/// Restitution alone, in double precision and without validation: for root finding and fits [1].
[[nodiscard]] double restitution_of(const Impact& impact);

}  // namespace ashimpact
