// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/damping.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/counting.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "pipeline/document/inversion_json.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/for_each_law.hpp"
#include "pipeline/run/in_parallel.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "pipeline/run/restitution.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"
#include "solver/damping/damping.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

/// The damping that one law gives for the impacts of a series.
struct Reading {
    std::vector<InvertedImpact> impacts;
    DampingParts parts;
    Json rising;          ///< null where there is no rising branch
    std::string note{};   ///< why there is none
    double accuracy = 0;  ///< of restitutions read from a map; 0: solved [1]
};

/// One impact by solving, for damping laws and contacts that have no map.
InvertedImpact solved(const Measurement& point, std::size_t index, const DampingProblem& problem) {
    InvertedImpact inverted{.index = index, .velocity = point.velocity, .restitution = problem.restitution};
    try {
        const DampingInversion inversion = damping_from_restitution(problem);
        inverted.greatest_restitution = inversion.greatest_restitution;
        inverted.damping = inversion.damping.coefficient;
        inverted.contact_time = inversion.impact.contact_time;
    } catch (const InputError&) {  // no damping gives this restitution: listed with the greatest possible one
        inverted.greatest_restitution = restitution_of(
            {problem.law, problem.detachment, {problem.damping_law, 0}, problem.contact, problem.velocity});
    }
    return inverted;
}

std::vector<InvertedImpact> solved_all(const MeasurementSet& set, const LawChoice& choice,
                                       DampingLaw damping_law, const ContactPair& contact) {
    std::vector<InvertedImpact> impacts;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Measurement& point = set.points[i];
        impacts.push_back(solved(point, i,
                                 {.law = choice.law,
                                  .detachment = choice.detachment,
                                  .damping_law = damping_law,
                                  .contact = contact,
                                  .velocity = point.velocity,
                                  .restitution = point.restitution()}));
    }
    return impacts;
}

/// The points up to the greatest restitution.
Json branch_to_greatest(const MeasurementSet& set) {
    const auto& points = set.points;
    if (points.empty()) return nullptr;
    const auto top = std::max_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
        return a.restitution() < b.restitution();
    });
    const bool beyond = std::any_of(points.begin(), points.end(),
                                    [&](const auto& point) { return point.velocity > top->velocity; });
    return rising_branch_json(top->velocity, beyond);
}

Reading read_by_solving(const RestitutionSeries& series, const LawChoice& choice, const Case& data,
                        const ContactPair& contact) {
    Reading reading{.impacts = solved_all(series.impacts, choice, data.damping_law, contact),
                    .parts = {},
                    .rising = branch_to_greatest(series.impacts)};
    reading.parts = find_parts(DampingSmoothing::of(reading.impacts),
                               {.flatness = data.fit.flatness, .outlier = data.fit.outlier});
    return reading;
}

Reading read_through_model(const RestitutionSeries& series, const LawChoice& choice, const Case& data,
                           const ContactPair& contact) {
    const ContactModel model = contact_model_for(choice, contact, series.impacts);
    Reading reading{.impacts = invert(model, series.impacts), .parts = {}, .rising = nullptr};
    reading.accuracy = model.map().accuracy();
    const auto smoothing = DampingSmoothing::of(reading.impacts);
    reading.parts = find_parts(smoothing, {.flatness = data.fit.flatness, .outlier = data.fit.outlier});
    try {
        const RisingBranch branch = rising_branch(model, series.impacts, smoothing);
        reading.rising = rising_branch_json(branch.upper, branch.falls_beyond);
    } catch (const InputError& error) {
        reading.note = error.problem();
    }
    return reading;
}

Reading read_series(const RestitutionSeries& series, const LawChoice& choice, const Case& data,
                    const ContactPair& contact) {
    const bool measured = series.origin == "measured";
    return measured && has_contact_model(choice, data.damping_law, contact)
               ? read_through_model(series, choice, data, contact)
               : read_by_solving(series, choice, data, contact);
}

Json reading_json(const Reading& reading, const std::string& origin, DampingLaw damping_law) {
    Json json{{"origin", origin}};
    json.update(inversion_json(reading.impacts, damping_law));
    json.update(parts_json(reading.parts, reading.impacts));
    json["rising_branch"] = reading.rising;
    if (!reading.note.empty()) json["rising_branch_note"] = reading.note;
    json["map_accuracy"] = reading.accuracy;
    return json;
}

/// " at 0.73 m/s": the velocity of an impact by its number, empty if it has no damping.
std::string velocity_of(const Json& json, const Json& number) {
    const Json& numbers = json["number"]["values"];
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i].get<double>() == number.get<double>())
            return " at " + readable(json["velocity"]["values"][i].get<double>(), "m/s");
    return {};
}

void warn(const std::string& where, const Json& json, std::size_t points,
          std::vector<std::string>& warnings) {
    if (!json["unreachable"].empty())
        warnings.push_back(fmt::format("{}: {} of {} cannot be reached by any damping", where,
                                       json["unreachable"].size(), counted(points, "restitution")));
    if (!json["outliers"].empty())
        warnings.push_back(fmt::format("{}: flagged as outliers and left in: {} of {}, first number {}{}",
                                       where, json["outliers"].size(), counted(points, "impact"),
                                       json["outliers"].front().dump(),
                                       velocity_of(json, json["outliers"].front())));
    if (json.contains("rising_branch_note"))
        warnings.push_back(where + ": " + json["rising_branch_note"].get<std::string>());
    if (json["velocity"]["values"].empty())
        warnings.push_back(where + ": no rebound, so no damping can be read");
}

}  // namespace

StageOutput damping_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const auto contacts = before.read(contact_artifact, read_contacts);
    StageOutput output{.citations = {"dong2013, section 4.2"}};
    output.options = {{"damping_law", name_of(data.damping_law)},
                      {"flatness", data.fit.flatness},
                      {"outlier", data.fit.outlier},
                      {"detachments", Json::object()}};
    for (const LawChoice& choice : data.laws)
        output.options["detachments"][std::string(choice.law.name())] = name_of(choice.detachment);
    output.result["samples"] = Json::array();
    for (const SampleRestitution& sample : before.read(restitution_artifact, read_restitutions)) {
        const SampleContact& contact = entry_named(contacts, sample.name, before, contact_artifact);
        Json json{{"name", sample.name}};
        const auto entries = in_parallel(data.laws, [&](const LawChoice& choice) -> Json {
            const RestitutionSeries* series = sample.of(choice.law);
            if (series == nullptr) return nullptr;
            return reading_json(read_series(*series, choice, data, contact.pair), series->origin,
                                data.damping_law);
        });
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i].is_null()) continue;
            const Law law = data.laws[i].law;
            warn(fmt::format("{}, {}", sample.name, law.name()), entries[i],
                 sample.of(law)->impacts.points.size(), output.warnings);
            json[std::string(law.name())] = entries[i];
        }
        output.result["samples"].push_back(std::move(json));
    }
    return output;
}

std::vector<SampleDamping> read_dampings(const View& result, Dimension dimension) {
    std::vector<SampleDamping> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleDamping entry{.name = sample.at("name").text(), .laws = {}};
        for_each_law(sample, {"name"}, [&](Law law, const View& node) {
            DampingSeries series{.origin = node.at("origin").text(),
                                 .velocity = node.at("velocity").column(Dimension::velocity),
                                 .restitution = node.at("restitution").column(Dimension::fraction),
                                 .damping = node.at("damping").column(dimension),
                                 .contact_time = node.at("contact_time").column(Dimension::time)};
            if (series.velocity.size() != series.restitution.size() ||
                series.velocity.size() != series.damping.size())
                node.fail("the columns differ in length", "columns of one length");
            if (const auto rising = node.find("rising_branch"))
                series.rising_to = rising->at("to").number(Dimension::velocity);
            entry.laws.set(law, std::move(series));
        });
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact
