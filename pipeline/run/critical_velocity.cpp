// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/critical_velocity.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/checks.hpp"
#include "core/text.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/document/regime_json.hpp"
#include "pipeline/document/uncertainty_json.hpp"
#include "pipeline/run/attempt.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/fit.hpp"
#include "pipeline/run/for_each_law.hpp"
#include "pipeline/run/in_parallel.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "pipeline/run/restitution.hpp"
#include "pipeline/run/uncertainty/calibrated_constants.hpp"
#include "pipeline/run/uncertainty/uncertain_contact.hpp"
#include "pipeline/run/uncertainty/velocity_uncertainty.hpp"
#include "solver/damping/damping.hpp"
#include "solver/numeric/gsl/distribution.hpp"

namespace ashimpact {

namespace {

/// Standard uncertainty by the rounding of a number as it is written, at its last digit other than zero.
double rounding_of(double value) {
    double unit = std::pow(10.0, std::floor(std::log10(value)));
    for (int digits = 1; digits < 15 && std::abs(std::round(value / unit) * unit - value) > 1e-12 * value;
         ++digits)
        unit *= 0.1;
    return unit / std::sqrt(12.0);
}

/// The critical velocity a case reports, or else the one that the outcomes of its impacts show.
std::optional<MeasuredCriticalVelocity> measured_velocity(const Sample& sample,
                                                          const RestitutionSeries* series) {
    if (sample.measured_critical_velocity) {
        const Quantity& reported = sample.measured_critical_velocity->quantity;
        MeasuredCriticalVelocity measured;
        measured.value = reported.value;
        const bool stated = reported.standard_uncertainty.value_or(0) > 0;
        measured.note = stated ? "as reported in the case"
                               : "as reported in the case, with the uncertainty of its last digit";
        const double u = stated ? *reported.standard_uncertainty : rounding_of(reported.value);
        measured.standard_uncertainty = u;
        const double half = u * gsl::normal_quantile(0.5 + 0.5 * confidence);
        measured.lower = std::max(0.0, reported.value - half);
        measured.upper = reported.value + half;
        return measured;
    }
    if (series == nullptr || series->origin != "measured") return std::nullopt;
    return measured_critical_velocity(series->impacts);
}

/// The entry of one law, null where there is none, and remarks on it.
struct LawEntry {
    Json json = nullptr;
    std::vector<std::string> notes{};
};

LawEntry law_entry(const VelocityTask& task) {
    LawEntry entry{};
    const CriticalVelocityProblem problem{.law = task.choice.law,
                                          .detachment = task.choice.detachment,
                                          .damping = {task.data.damping_law, task.critical_damping()},
                                          .contact = task.contact.pair};
    const CriticalVelocity result = critical_velocity(problem);
    entry.json = critical_velocity_json(problem, result);
    entry.json.erase("law");
    if (result.value) entry.json.update(velocity_uncertainty_json(task, *result.value, entry.notes));
    if (entry.json["regime"].is_object())
        for (const Json& warning : entry.json["regime"]["warnings"])
            entry.notes.push_back(warning.get<std::string>());
    return entry;
}

Json sample_json(const Case& data, const Sample& sample, const SampleContact& contact,
                 const SampleRestitution& restitution, const SampleFit& fits,
                 const CalibrationResponse& response, std::vector<std::string>& warnings) {
    Json json{{"name", sample.name}};
    const RestitutionSeries* first = restitution.series.empty() ? nullptr : &restitution.series.front();
    std::vector<std::string> notes;
    const auto measured = attempt("measured v_c", notes, [&] {
                              return measured_velocity(sample, first);
                          }).value_or(std::nullopt);
    for (const std::string& note : notes) warnings.push_back(sample.name + ": " + note);
    json["measured"] = measured ? measured_velocity_json(*measured) : Json(nullptr);
    const auto entries = in_parallel(data.laws, [&](const LawChoice& choice) -> LawEntry {
        const LawFit* fit = fits.laws.find(choice.law);
        if (fit == nullptr) return {};
        const RandomContact uncertain = uncertain_contact(data, sample, contact, choice.law, response);
        return law_entry({data, choice, contact, uncertain, response, restitution.of(choice.law), *fit,
                          measured, sample.measured_critical_velocity.has_value()});
    });
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string law(data.laws[i].law.name());
        for (const std::string& note : entries[i].notes)
            warnings.push_back(fmt::format("{}, {}: {}", sample.name, law, note));
        if (!entries[i].json.is_null()) json[law] = entries[i].json;
    }
    return json;
}

}  // namespace

Json critical_velocity_json(const CriticalVelocityProblem& problem, const CriticalVelocity& result) {
    Json regime = nullptr;
    if (result.value)
        regime = regime_json(regime_of({.law = problem.law,
                                        .detachment = problem.detachment,
                                        .damping = problem.damping,
                                        .contact = problem.contact,
                                        .velocity = *result.value},
                                       result.maximum_overlap.value_or(0)));
    return {{"law", problem.law.name()},
            {"detachment", name_of(problem.detachment)},
            {"damping_law", name_of(problem.damping.law)},
            {"damping", quantity_json(problem.damping.coefficient, unit_of(problem.damping.law))},
            {"critical_velocity", quantity_json(result.value, Dimension::velocity)},
            {"verdict", name_of(result.verdict)},
            {"contact_time", quantity_json(result.contact_time, Dimension::time)},
            {"maximum_overlap", quantity_json(result.maximum_overlap, Dimension::length)},
            {"crossings", column_json(result.crossings, Dimension::velocity)},
            {"dissipated", quantity_json(result.dissipated, Dimension::energy)},
            {"plastic", quantity_json(result.plastic, Dimension::energy)},
            {"detachment_energy", quantity_json(result.detachment_energy, Dimension::energy)},
            {"regime", regime}};
}

StageOutput critical_velocity_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const auto contacts = before.read(contact_artifact, read_contacts);
    StageOutput output{.citations = {"dong2013, section 4.3, Table 4"}};
    const PropagationOptions& propagation = data.uncertainty.propagation;
    output.options = {
        {"damping", "critical damping of 6-fit.json: the estimate from all impacts, else eta(0)"},
        {"samples", propagation.samples},
        {"replicates", propagation.replicates},
        {"seed", propagation.seed},
        {"inputs",
         "taken as independent, but inferred constants follow the contact modulus they were calibrated at"}};
    output.result["samples"] = Json::array();
    const auto read = [&](const View& result) { return read_fits(result, dimension_of(data.damping_law)); };
    const auto fits = before.read(fit_artifact, read);
    const auto restitutions = before.read(restitution_artifact, read_restitutions);
    const auto responses = calibrated_constants(data, before, output.warnings);
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        const Sample& sample = data.samples[i];
        output.result["samples"].push_back(
            sample_json(data, sample, entry_named(contacts, sample.name, before, contact_artifact),
                        entry_named(restitutions, sample.name, before, restitution_artifact),
                        entry_named(fits, sample.name, before, fit_artifact), responses[i], output.warnings));
    }
    return output;
}

namespace {

/// The value of a critical velocity [m/s] beside which its interval and its method stand.
Quantity headline_velocity(const View& node) {
    const View unit = node.at("unit");
    if (unit.text() != si_unit(Dimension::velocity))
        unit.fail("is " + in_quotes(unit.text()), std::string(si_unit(Dimension::velocity)));
    const View value = node.at("value");
    const double velocity = value.number(Dimension::velocity);
    at_place(value.pointer(), [&] { require_positive("critical velocity", velocity, Dimension::velocity); });
    return make_quantity(velocity, Dimension::velocity);
}

/// The interval stands beside the velocity and within it; either may be open where an edit dropped it.
void require_one_interval(const Json& headline, const Json& beside, const View& node) {
    if (!headline.is_object() || !headline.contains("interval")) return;
    const auto end = [](const Json& interval, const char* key) {
        return interval.is_object() ? interval.value(key, Json(nullptr)) : Json(nullptr);
    };
    for (const char* key : {"lower", "upper"})
        if (end(headline["interval"], key) != end(beside, key))
            node.at("interval")
                .fail(std::string(key) + " is not that of the interval in critical_velocity",
                      "the same interval in both places");
}

}  // namespace

std::vector<SampleCriticalVelocity> read_critical_velocities(const View& result) {
    std::vector<SampleCriticalVelocity> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleCriticalVelocity entry{.name = sample.at("name").text(), .laws = {}, .measured = nullptr};
        if (const auto measured = sample.find("measured")) {
            if (const auto value = measured->find("critical_velocity"))
                static_cast<void>(headline_velocity(*value));
            entry.measured = measured->json();
        }
        for_each_law(sample, {"name", "measured"}, [&](Law law, const View& node) {
            LawCriticalVelocity velocity{
                .verdict = node.at("verdict").text(),
                .value = {},
                .contact_time = {},
                .dissipated = node.at("dissipated").number(Dimension::energy),
                .plastic = 0.0,
                .detachment_energy = node.at("detachment_energy").number(Dimension::energy),
                .interval = node.has("interval") ? node.at("interval").json() : Json(nullptr),
                .interval_note = node.has("interval_note") ? node.at("interval_note").json() : Json(nullptr),
                .check = node.has("check") ? node.at("check").json() : Json(nullptr),
                .headline = node.json().value("critical_velocity", Json(nullptr)),
                .extrapolated = Json(nullptr)};
            if (const auto extrapolated = node.find("extrapolated")) {
                velocity.extrapolated = extrapolated->json().value("critical_velocity", Json(nullptr));
                velocity.extrapolated["interval"] = extrapolated->at("interval").json();
            }
            if (const auto value = node.find("critical_velocity")) velocity.value = headline_velocity(*value);
            require_one_interval(velocity.headline, velocity.interval, node);
            if (const auto plastic = node.find("plastic"))
                velocity.plastic = plastic->number(Dimension::energy);
            if (const auto time = node.find("contact_time"))
                velocity.contact_time = time->number(Dimension::time);
            entry.laws.set(law, std::move(velocity));
        });
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact
