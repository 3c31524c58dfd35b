// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "pipeline/run/curves/model_curve.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// Results of one sample.
struct SampleInputs {
    const Sample& sample;
    const ContactPair& contact;
    const LawMap<DampingSeries>& dampings;
    const LawMap<LawFit>& fits;
    const LawMap<LawCriticalVelocity>& velocities;
};

HistoryMomentum momentum_of(const Impact& impact, const ImpactResult& result) {
    const MomentumBalance balance = momentum_balance(impact);
    return {.approach = balance.approach,
            .rebound = balance.rebound,
            .mean_force_ratio = balance.mean_force_ratio(),
            .damping_impulse = balance.damping_impulse,
            .momentum_lost = balance.momentum_lost,
            .equation_41 =
                Sides<Dimension::impulse>{balance.rebound.static_impulse - balance.approach.static_impulse,
                                          balance.damping_impulse - balance.momentum_lost},
            .equation_42 = Sides<Dimension::energy>{0.5 * balance.damping_impulse *
                                                        (impact.velocity + result.rebound_velocity),
                                                    result.energy.dissipated},
            .equation_43 = Sides<Dimension::energy>{result.energy.dissipated,
                                                    result.energy.incident - result.energy.remaining},
            .damping_exceeds_loss = balance.damping_exceeds_loss(),
            .rebound_is_longer = balance.rebound_is_longer(),
            .verdict = verdict_of(balance)};
}

History history_of(HistoryPart part, const Impact& impact, int points, std::vector<Finding>& findings) {
    const ImpactResult result = solve_impact(impact);
    const Regime regime = regime_of(impact, result.maximum_overlap);
    if (const auto finding = yield_finding(impact, regime)) findings.push_back(*finding);
    History history{.part = part,
                    .velocity = impact.velocity,
                    .damping = impact.damping.coefficient,
                    .outcome = result.outcome,
                    .restitution = result.restitution,
                    .contact_time = result.contact_time,
                    .maximum_overlap = result.maximum_overlap,
                    .greatest_pressure = regime.greatest_pressure,
                    .yield_pressure = regime.yield_pressure,
                    .energy = result.energy,
                    .trajectory = trajectory(impact, points)};
    if (result.outcome == Outcome::rebound) history.momentum = momentum_of(impact, result);
    return history;
}

/// The histories of one law.
ResultOfLaw<std::vector<History>> histories_of(const Case& data, const LawChoice& choice,
                                               const SampleInputs& in) {
    std::vector<History> histories;
    std::vector<Finding> findings;
    Impact impact{.law = choice.law,
                  .detachment = choice.detachment,
                  .damping = {data.damping_law, 0.0},
                  .contact = in.contact,
                  .velocity = 0.0};
    const LawCriticalVelocity* critical = in.velocities.find(choice.law);
    if (critical != nullptr && critical->velocity) {
        impact.damping.coefficient = critical->damping;
        impact.velocity = critical->velocity->value * (1 + data.histories.critical_excess);
        histories.push_back(history_of(HistoryPart::critical, impact, data.histories.points, findings));
    }
    const DampingSeries* series = in.dampings.find(choice.law);
    if (series != nullptr) {
        const double end = series->rising ? series->rising->to : std::numeric_limits<double>::infinity();
        if (const auto middle = curves::median_impact(*series, 0, end)) {
            std::tie(impact.velocity, impact.damping.coefficient) = *middle;
            histories.push_back(history_of(HistoryPart::rising, impact, data.histories.points, findings));
        }
    }
    return {histories, findings};
}

/// Contact times at the velocities of published ones, with the damping eta(e) of the fit.
std::vector<ContactTimeAt> contact_times_of(const Case& data, const SampleInputs& in) {
    std::vector<ContactTimeAt> times;
    if (!in.sample.published || data.damping_law != DampingLaw::constant) return times;
    for (const auto& [law, published_velocity, published_time] : in.sample.published->contact_times) {
        const LawFit* fit = in.fits.find(law);
        if (fit == nullptr) continue;
        const PublishedDamping curve{law, data.detachment_of(law), in.contact, fit->damping};
        const double velocity = published_velocity.value;
        const double e = reconstructed_restitution(curve, velocity);
        const ImpactResult result = solve_impact(
            {law, curve.detachment, {DampingLaw::constant, curve.damping(e)}, in.contact, velocity});
        times.push_back({law, velocity, e, result.contact_time});
    }
    return times;
}

}  // namespace

HistoriesResult histories_stage(const Case& data, const ContactResult& contacts,
                                const DampingStageResult& dampings, const FitResult& fits,
                                const CriticalVelocityResult& velocities, StageRecord& record) {
    record.citations = {"dong2013, section 4.4, Eqs. 35-45, Figures 7 and 9"};
    HistoriesResult result;
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        const SampleInputs in{data.samples[i], contacts.samples[i].pair, dampings.samples[i].laws,
                              fits.samples[i].laws, velocities.samples[i].laws};
        const auto solve = [&](const LawChoice& choice) { return histories_of(data, choice, in); };
        result.samples.push_back(
            {.name = in.sample.name,
             .contact_times = contact_times_of(data, in),
             .laws = results_by_law<std::vector<History>>(data, in.sample.name, record, solve)});
    }
    curves::add_curves(data, contacts, dampings, fits, velocities, result);
    return result;
}

}  // namespace ashimpact
