// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/histories.hpp"

#include <fmt/format.h>

#include "pipeline/document/quantity_json.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/critical_velocity.hpp"
#include "pipeline/run/damping.hpp"
#include "pipeline/run/fit.hpp"
#include "pipeline/run/for_each_law.hpp"
#include "pipeline/run/in_parallel.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/calibration/reconstruction.hpp"
#include "solver/motion/momentum_balance.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

namespace {

/// The damping at the critical velocity of each law of a sample.
struct CriticalDampings {
    std::string name;
    LawMap<double> laws;
};

std::vector<CriticalDampings> read_critical_dampings(const View& result, Dimension dimension) {
    std::vector<CriticalDampings> samples;
    for (const View& sample : result.at("samples").elements()) {
        CriticalDampings entry{.name = sample.at("name").text(), .laws = {}};
        for_each_law(sample, {"name", "measured"}, [&](Law law, const View& node) {
            entry.laws.set(law, node.at("damping").number(dimension));
        });
        samples.push_back(std::move(entry));
    }
    return samples;
}

/// Results of one sample from the artifacts.
struct SampleInputs {
    const Sample& sample;
    const ContactPair& contact;
    const LawMap<DampingSeries>& dampings;
    const LawMap<LawFit>& fits;
    const LawMap<LawCriticalVelocity>& velocities;
    const LawMap<double>& critical_dampings;  ///< with which `velocities` were found
};

Json stage_json(const StageMomentum& stage) {
    return {{"duration", quantity_json(stage.duration, Dimension::time)},
            {"static_impulse", quantity_json(stage.static_impulse, Dimension::impulse)},
            {"damping_impulse", quantity_json(stage.damping_impulse, Dimension::impulse)},
            {"mean_force", quantity_json(stage.mean_force, Dimension::force)},
            {"residual", quantity_json(stage.residual, Dimension::impulse)}};
}

Json momentum_json(const MomentumBalance& balance) {
    return {{"approach", stage_json(balance.approach)},
            {"rebound", stage_json(balance.rebound)},
            {"mean_force_ratio", balance.mean_force_ratio()},
            {"equation_44",
             {{"damping_impulse", quantity_json(balance.damping_impulse, Dimension::impulse)},
              {"momentum_lost", quantity_json(balance.momentum_lost, Dimension::impulse)},
              {"holds", balance.damping_exceeds_loss()}}},
            {"equation_45",
             {{"approach_time", quantity_json(balance.approach.duration, Dimension::time)},
              {"rebound_time", quantity_json(balance.rebound.duration, Dimension::time)},
              {"holds", balance.rebound_is_longer()}}},
            {"verdict", verdict_of(balance)}};
}

Json trajectory_json(const std::vector<TrajectoryPoint>& points) {
    const auto column = [&](double TrajectoryPoint::*member, Dimension dimension) {
        std::vector<double> values;
        values.reserve(points.size());
        for (const TrajectoryPoint& point : points) values.push_back(point.*member);
        return column_json(values, dimension);
    };
    return {{"time", column(&TrajectoryPoint::time, Dimension::time)},
            {"overlap", column(&TrajectoryPoint::overlap, Dimension::length)},
            {"velocity", column(&TrajectoryPoint::velocity, Dimension::velocity)},
            {"contact_radius", column(&TrajectoryPoint::contact_radius, Dimension::length)},
            {"repulsive_force", column(&TrajectoryPoint::repulsive_force, Dimension::force)},
            {"attractive_force", column(&TrajectoryPoint::attractive_force, Dimension::force)},
            {"damping_force", column(&TrajectoryPoint::damping_force, Dimension::force)}};
}

Json history_json(const char* part, const Impact& impact, int points) {
    const ImpactResult result = solve_impact(impact);
    const Regime regime = regime_of(impact, result.maximum_overlap);
    Json json{{"part", part},
              {"velocity", quantity_json(impact.velocity, Dimension::velocity)},
              {"damping", quantity_json(impact.damping.coefficient, unit_of(impact.damping.law))},
              {"outcome", name_of(result.outcome)},
              {"restitution", quantity_json(result.restitution, Dimension::fraction)},
              {"contact_time", quantity_json(result.contact_time, Dimension::time)},
              {"maximum_overlap", quantity_json(result.maximum_overlap, Dimension::length)},
              {"greatest_pressure", quantity_json(regime.greatest_pressure, Dimension::pressure)},
              {"yield_pressure", quantity_json(regime.yield_pressure, Dimension::pressure)}};
    if (result.outcome == Outcome::rebound) json["momentum"] = momentum_json(momentum_balance(impact));
    json["trajectory"] = trajectory_json(trajectory(impact, points));
    return json;
}

/// The histories of one law.
Json law_json(const Case& data, const LawChoice& choice, const SampleInputs& in) {
    Json histories = Json::array();
    Impact impact{.law = choice.law,
                  .detachment = choice.detachment,
                  .damping = {data.damping_law, 0.0},
                  .contact = in.contact,
                  .velocity = 0.0};
    const LawCriticalVelocity* critical = in.velocities.find(choice.law);
    const double* damping = in.critical_dampings.find(choice.law);
    if (critical != nullptr && critical->value && damping != nullptr) {
        impact.damping.coefficient = *damping;
        impact.velocity = critical->value->value * (1 + data.histories.critical_excess);
        histories.push_back(history_json("critical", impact, data.histories.points));
    }
    const DampingSeries* series = in.dampings.find(choice.law);
    if (series != nullptr && !series->velocity.empty()) {
        const std::size_t middle = series->velocity.size() / 2;
        impact.damping.coefficient = series->damping[middle];
        impact.velocity = series->velocity[middle];
        histories.push_back(history_json("rising", impact, data.histories.points));
    }
    return histories;
}

/// Contact times at the velocities that something was published for, with the damping of the fit there.
Json contact_times_json(const Case& data, const SampleInputs& in) {
    Json times = Json::array();
    if (!in.sample.published || data.damping_law != DampingLaw::constant) return times;
    for (const auto& wanted : in.sample.published->contact_times) {
        const LawFit* fit = in.fits.find(wanted.law);
        if (fit == nullptr) continue;
        Detachment detachment = wanted.law.default_detachment();
        for (const LawChoice& choice : data.laws)
            if (choice.law == wanted.law) detachment = choice.detachment;
        const PublishedDamping curve{wanted.law, detachment, in.contact, fit->damping};
        const double velocity = wanted.velocity.value;
        const double e = reconstructed_restitution(curve, velocity);
        const ImpactResult result = solve_impact(
            {wanted.law, detachment, {DampingLaw::constant, curve.damping(e)}, in.contact, velocity});
        times.push_back({{"law", wanted.law.name()},
                         {"velocity", quantity_json(velocity, Dimension::velocity)},
                         {"restitution", quantity_json(e, Dimension::fraction)},
                         {"contact_time", quantity_json(result.contact_time, Dimension::time)}});
    }
    return times;
}

}  // namespace

StageOutput histories_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const auto contacts = before.read(contact_artifact, read_contacts);
    const Dimension dimension = dimension_of(data.damping_law);
    const auto dampings =
        before.read(damping_artifact, [&](const View& v) { return read_dampings(v, dimension); });
    const auto fits = before.read(fit_artifact, [&](const View& v) { return read_fits(v, dimension); });
    const auto velocities = before.read(critical_velocity_artifact, read_critical_velocities);
    const auto critical_dampings = before.read(
        critical_velocity_artifact, [&](const View& v) { return read_critical_dampings(v, dimension); });
    StageOutput output{.citations = {"dong2013, section 4.4, Eqs. 35-45, Figures 7 and 9"}};
    output.options = {{"points", data.histories.points}, {"critical_excess", data.histories.critical_excess}};
    output.result["samples"] = Json::array();
    for (const Sample& sample : data.samples) {
        const SampleInputs in{
            sample,
            entry_named(contacts, sample.name, before, contact_artifact).pair,
            entry_named(dampings, sample.name, before, damping_artifact).laws,
            entry_named(fits, sample.name, before, fit_artifact).laws,
            entry_named(velocities, sample.name, before, critical_velocity_artifact).laws,
            entry_named(critical_dampings, sample.name, before, critical_velocity_artifact).laws};
        Json json{{"name", sample.name}, {"contact_times", contact_times_json(data, in)}};
        const auto histories =
            in_parallel(data.laws, [&](const LawChoice& choice) { return law_json(data, choice, in); });
        for (std::size_t i = 0; i < histories.size(); ++i)
            json[std::string(data.laws[i].law.name())] = histories[i];
        output.result["samples"].push_back(std::move(json));
    }
    return output;
}

std::vector<SampleHistories> read_histories(const View& result) {
    std::vector<SampleHistories> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleHistories entry{.name = sample.at("name").text(), .contact_times = {}};
        for (const View& node : sample.at("contact_times").elements()) {
            const auto time = node.find("contact_time");
            if (!time) continue;
            entry.contact_times.push_back({Law::named(node.at("law").text()),
                                           node.at("velocity").number(Dimension::velocity),
                                           time->number(Dimension::time)});
        }
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact
