// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/regime_json.hpp"
#include "pipeline/document/results/results_json.hpp"
#include "pipeline/document/results/uncertainty_json.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

Json extrapolated_json(const ExtrapolatedVelocity& extrapolated) {
    Json json{{"critical_velocity", velocity_json(extrapolated.velocity)},
              {"interval", bounds_json(extrapolated.velocity.interval, Dimension::velocity)},
              {"uncertainty", velocity_uncertainty_json(extrapolated.uncertainty)}};
    if (extrapolated.check) json["check"] = check_json(*extrapolated.check);
    return json;
}

ExtrapolatedVelocity read_extrapolated(const View& node) {
    ExtrapolatedVelocity extrapolated{.velocity = read_velocity(node.at("critical_velocity")),
                                      .uncertainty = read_velocity_uncertainty(node.at("uncertainty")),
                                      .check = read_if(node, "check", read_check)};
    extrapolated.velocity.interval = read_if(
        node, "interval", [](const View& interval) { return read_bounds(interval, Dimension::velocity); });
    return extrapolated;
}

Json law_velocity_json(const LawCriticalVelocity& velocity, DampingLaw law) {
    Json json = critical_velocity_json(velocity, law);
    if (!velocity.velocity) return json;
    json["critical_velocity"] = headline_json(*velocity.velocity);
    if (!velocity.interval_note.empty()) json["interval_note"] = velocity.interval_note;
    if (velocity.velocity->interval)
        json["interval"] = bounds_json(*velocity.velocity->interval, Dimension::velocity);
    if (velocity.uncertainty) json["uncertainty"] = velocity_uncertainty_json(*velocity.uncertainty);
    if (velocity.check) json["check"] = check_json(*velocity.check);
    if (velocity.from_impacts)
        json["extrapolated"] =
            velocity.extrapolated ? extrapolated_json(*velocity.extrapolated) : Json(nullptr);
    return json;
}

/// The interval is beside the velocity and within it; either may be open where an edit dropped it.
std::optional<Bounds> one_interval(const std::optional<Bounds>& within, const View& node) {
    const auto beside = read_if(
        node, "interval", [](const View& interval) { return read_bounds(interval, Dimension::velocity); });
    if (!node.at("critical_velocity").has("interval")) return beside;
    const Bounds one = within.value_or(Bounds{});
    const Bounds other = beside.value_or(Bounds{});
    if (one.lower != other.lower || one.upper != other.upper)
        node.at("interval")
            .fail(std::string(one.lower != other.lower ? "lower" : "upper") +
                      " is not that of the interval in critical_velocity",
                  "the same interval in both places");
    return beside;
}

LawCriticalVelocity read_law_velocity(const View& node, DampingLaw law) {
    LawCriticalVelocity velocity{.verdict = named<CaptureVerdict>(node.at("verdict").text()),
                                 .velocity = read_if(node, "critical_velocity", read_velocity),
                                 .contact_time = number_if(node, "contact_time", Dimension::time),
                                 .maximum_overlap = number_if(node, "maximum_overlap", Dimension::length),
                                 .crossings = column_if(node, "crossings", Dimension::velocity),
                                 .dissipated = node.at("dissipated").number(Dimension::energy),
                                 .plastic = number_if(node, "plastic", Dimension::energy).value_or(0),
                                 .detachment_energy = node.at("detachment_energy").number(Dimension::energy),
                                 .regime = read_if(node, "regime", read_regime),
                                 .interval_note = text_if(node, "interval_note"),
                                 .uncertainty = read_if(node, "uncertainty", read_velocity_uncertainty),
                                 .check = read_if(node, "check", read_check),
                                 .from_impacts = node.has("extrapolated"),
                                 .extrapolated = read_if(node, "extrapolated", read_extrapolated)};
    if (const auto detachment = node.find("detachment"))
        velocity.detachment = named<Detachment>(detachment->text());
    velocity.damping = number_if(node, "damping", dimension_of(law)).value_or(0);
    if (velocity.velocity) velocity.velocity->interval = one_interval(velocity.velocity->interval, node);
    return velocity;
}

}  // namespace

Json critical_velocity_json(const LawCriticalVelocity& velocity, DampingLaw law) {
    return {{"detachment", name_of(velocity.detachment)},
            {"damping_law", name_of(law)},
            {"damping", quantity_json(velocity.damping, unit_of(law))},
            {"critical_velocity", velocity.velocity ? velocity_json(*velocity.velocity) : Json(nullptr)},
            {"verdict", name_of(velocity.verdict)},
            {"contact_time", quantity_json(velocity.contact_time, Dimension::time)},
            {"maximum_overlap", quantity_json(velocity.maximum_overlap, Dimension::length)},
            {"crossings", column_json(velocity.crossings, Dimension::velocity)},
            {"dissipated", quantity_json(velocity.dissipated, Dimension::energy)},
            {"plastic", quantity_json(velocity.plastic, Dimension::energy)},
            {"detachment_energy", quantity_json(velocity.detachment_energy, Dimension::energy)},
            {"regime", velocity.regime ? regime_json(*velocity.regime) : Json(nullptr)}};
}

Json to_json(const CriticalVelocityResult& result, DampingLaw law) {
    return samples_json(result.samples, [&](const SampleCriticalVelocity& sample) {
        Json json{{"name", sample.name},
                  {"measured", sample.measured ? measured_velocity_json(*sample.measured) : Json(nullptr)}};
        for (const auto& [each, velocity] : sample.laws)
            json[std::string(each.name())] = law_velocity_json(velocity, law);
        return json;
    });
}

template <>
CriticalVelocityResult from_json<CriticalVelocityResult>(const View& result, DampingLaw law) {
    return {samples_of(result, [&](const View& node) {
        SampleCriticalVelocity sample{.name = node.at("name").text(),
                                      .measured = read_if(node, "measured", read_measured_velocity)};
        for_each_law(node, {"name", "measured"}, [&](Law each, const View& velocity) {
            sample.laws.set(each, read_law_velocity(velocity, law));
        });
        return sample;
    })};
}

}  // namespace ashimpact
