// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/run/results/deposition.hpp"
#include "pipeline/run/results/note.hpp"
#include "pipeline/run/results/run.hpp"
#include "solver/deposition/deposition.hpp"
#include "solver/deposition/particle_sizes.hpp"

namespace ashimpact {

/// Critical velocity of each class [m/s]: infinite where all is captured, 0 where nothing is.
struct ClassVelocities {
    SizeBasis basis = SizeBasis::adhesion;
    std::vector<double> value{}, lower{}, upper{};  ///< with the ends of the interval, where it is known
    std::vector<bool> outside{};                    ///< whether v_c is above fastest_in_model
};

/// Particles as the deposition takes them.
struct DepositingAsh {
    Law law{};
    std::vector<SizeClass> classes{};
    std::size_t parts = 1;                       ///< consecutive classes that are one row of the result
    std::vector<double> densities{};             ///< [kg/m3]
    std::vector<ClassVelocities> assumptions{};  ///< the first is that of the answer
    std::vector<RestitutionOfVelocity>
        restitutions{};                      ///< of the classes, under the assumption of the answer
    std::optional<SizeRange> measured{};     ///< sizes with a measured v_c
    std::optional<double> fastest_impact{};  ///< that gives the rebounds [m/s]; none: they are solved
};

/// Whether a v_c of ClassVelocities is above fastest_in_model, as it is where every velocity is captured.
[[nodiscard]] bool is_outside_model(double critical_velocity);

/// What a share of the mass that arrives means whose v_c is above fastest_in_model.
[[nodiscard]] std::string outside_model_words(double share);

/// The tube as the solver takes it.
[[nodiscard]] inline CrossedTube crossed_tube(const TubeConditions& tube) {
    return {.diameter = tube.diameter, .velocity = tube.velocity, .gas = {tube.density, tube.viscosity}};
}

/// The ash of a run: density and v_c of each class. Within the measured sizes v_c is as measured. Elsewhere
/// it is solved with the constants of each assumption; where the run states none, or rows that they do not
/// give, it lies on a power law between two rows, beyond them on that of the last two. Between a row where
/// everything, or nothing, is captured and one with a v_c the interval has both.
/// @param basis the assumption of the answer; none: the first there is of contact-radius, tsuji,
/// hunt-crossley, brach-dunn-damping, power-of-size, constant, adhesion-alone
/// @param fastest impact, up to which restitutions are known [m/s]
/// @throws InputError if the run has no v_c by size, or none by that assumption
[[nodiscard]] DepositingAsh ash_of_run(const Run& run, std::vector<SizeClass> classes,
                                       const std::optional<SizeBasis>& basis, double fastest);

/// The doubt about v_c at the temperature of the gas [K], from the glass of the samples; none where it stays
/// elastic during contacts. A remark where the gas is colder than the contacts were, and without its
/// chemistry also where it is hotter.
[[nodiscard]] std::optional<Finding> temperature_finding(const Run& run, Law law, double gas_temperature);

/// What stays on a tube. The span of what stays reaches over all assumptions but that of adhesion alone,
/// which is a lower bound, unless it is the only one.
[[nodiscard]] DepositionResult deposition_on(const TubeConditions& tube, const DepositingAsh& ash,
                                             StageRecord& record);

}  // namespace ashimpact
