// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/restitution.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/document/measurement_json.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/in_parallel.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "solver/inference/calibration/reconstruction.hpp"

namespace ashimpact {

namespace {

/// The laws of the case that take their data from the fit of @p law.
std::vector<Law> laws_served(const Case& data, const Reconstruction& plan, Law law) {
    std::vector<Law> laws;
    for (const LawChoice& choice : data.laws) {
        const bool own = plan.damping_fits.find(choice.law) != nullptr;
        if (choice.law == law || (!own && law.name() == plan.reference)) laws.push_back(choice.law);
    }
    return laws;
}

RestitutionSeries reconstruct(const PublishedDamping& published, const Reconstruction& plan,
                              const std::string& sample, std::vector<std::string>& warnings) {
    RestitutionSeries series{.origin = "reconstructed"};
    series.source = fmt::format("damping fit of {} in {}", published.law.name(), plan.source);
    series.coefficient_uncertainty = plan.coefficient_uncertainty;
    for (int i = 0; i < plan.points; ++i) {
        const double e = plan.from + (plan.to - plan.from) * i / (plan.points - 1);
        try {
            const double velocity = reconstructed_velocity(published, e);
            series.impacts.points.push_back({.velocity = velocity, .rebound = e * velocity});
        } catch (const InputError& error) {
            warnings.push_back(fmt::format("{}, {}: no point at restitution {}: {}", sample,
                                           published.law.name(), readable_number(e), error.problem()));
        }
    }
    const auto& points = series.impacts.points;
    if (!std::is_sorted(points.begin(), points.end(),
                        [](const auto& a, const auto& b) { return a.velocity < b.velocity; }))
        warnings.push_back(
            fmt::format("{}, {}: the velocity does not rise with restitution over the whole range, so "
                        "this fit is not one of a rising branch there",
                        sample, published.law.name()));
    return series;
}

std::vector<RestitutionSeries> series_of(const Case& data, const Sample& sample, const SampleContact& contact,
                                         std::vector<std::string>& warnings) {
    std::vector<RestitutionSeries> all;
    if (const auto* measured = std::get_if<MeasuredRestitution>(&*sample.restitution)) {
        RestitutionSeries series{.origin = "measured", .source = measured->source};
        for (const LawChoice& choice : data.laws) series.laws.push_back(choice.law);
        series.impacts = measured->impacts;
        all.push_back(std::move(series));
        return all;
    }
    const auto& plan = std::get<Reconstruction>(*sample.restitution);
    for (const auto& [law, fit] : plan.damping_fits) {
        const auto served = laws_served(data, plan, law);
        if (served.empty()) continue;
        Detachment detachment = law.default_detachment();
        for (const LawChoice& choice : data.laws)
            if (choice.law == law) detachment = choice.detachment;
        const PublishedDamping published{law, detachment, contact.pair, fit};
        all.push_back(reconstruct(published, plan, sample.name, warnings));
        all.back().laws = served;
    }
    return all;
}

Json series_json(const RestitutionSeries& series) {
    Json laws = Json::array();
    for (const Law law : series.laws) laws.push_back(law.name());
    Json json{{"laws", laws}, {"origin", series.origin}, {"source", series.source}};
    json.update(measurement_columns(series.impacts));
    if (series.coefficient_uncertainty)
        json["coefficient_uncertainty"] = quantity_json(*series.coefficient_uncertainty, Dimension::damping);
    return json;
}

}  // namespace

const RestitutionSeries* SampleRestitution::of(Law law) const {
    for (const RestitutionSeries& each : series)
        if (std::find(each.laws.begin(), each.laws.end(), law) != each.laws.end()) return &each;
    return nullptr;
}

StageOutput restitution_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const auto contacts = before.read(contact_artifact, read_contacts);
    StageOutput output{.citations = {"dong2013, Eqs. 2 and 31, Table 2"}};
    output.result["samples"] = Json::array();
    struct Entry {
        Json json = nullptr;
        std::vector<std::string> warnings{};
    };
    const auto entries = in_parallel(data.samples, [&](const Sample& sample) {
        Entry entry{.json = {{"name", sample.name}, {"series", Json::array()}}};
        if (!sample.restitution) {
            entry.warnings.push_back(sample.name +
                                     ": no restitution data, so no damping and no dynamic velocity");
            return entry;
        }
        const SampleContact& contact = entry_named(contacts, sample.name, before, contact_artifact);
        for (const auto& series : series_of(data, sample, contact, entry.warnings))
            entry.json["series"].push_back(series_json(series));
        return entry;
    });
    for (const Entry& entry : entries) {
        output.result["samples"].push_back(entry.json);
        output.warnings.insert(output.warnings.end(), entry.warnings.begin(), entry.warnings.end());
    }
    return output;
}

std::vector<SampleRestitution> read_restitutions(const View& result) {
    std::vector<SampleRestitution> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleRestitution entry{.name = sample.at("name").text(), .series = {}};
        for (const View& node : sample.at("series").elements()) {
            RestitutionSeries series{.origin = node.at("origin").text(), .source = node.at("source").text()};
            for (const View& law : node.at("laws").elements()) series.laws.push_back(Law::named(law.text()));
            series.impacts = read_measurement_columns(node);
            series.impacts.source = series.source;
            if (!series.impacts.points.empty())
                at_place(node.pointer(), [&] { check_impacts(series.impacts); });
            if (const auto u = node.find("coefficient_uncertainty"))
                series.coefficient_uncertainty = u->number(Dimension::damping);
            entry.series.push_back(std::move(series));
        }
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact
