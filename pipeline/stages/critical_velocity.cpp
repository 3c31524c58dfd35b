#include "pipeline/stages/critical_velocity.hpp"

#include <fmt/format.h>

#include "pipeline/case/laws.hpp"
#include "pipeline/json/quantity_json.hpp"
#include "pipeline/stages/contact.hpp"
#include "pipeline/stages/fit.hpp"
#include "pipeline/stages/read_case_artifact.hpp"

namespace ashimpact {

namespace {

Json law_json(const Case& data, const LawChoice& choice, double damping, const ContactPair& contact) {
    const CriticalVelocityProblem problem{.law = choice.law,
                                          .detachment = choice.detachment,
                                          .damping = {data.damping_law, damping},
                                          .contact = contact};
    Json json = critical_velocity_json(problem, critical_velocity(problem));
    json.erase("law");
    return json;
}

}  // namespace

Json critical_velocity_json(const CriticalVelocityProblem& problem, const CriticalVelocity& result) {
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
            {"detachment_energy", quantity_json(result.detachment_energy, Dimension::energy)}};
}

StageOutput critical_velocity_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const auto contacts = before.read("2-contact.json", read_contacts);
    StageOutput output{.citations = {"dong2013, section 4.3, Table 4"}};
    output.options = {{"damping", "critical damping eta(0) of 6-fit.json"}};
    output.result["samples"] = Json::array();
    const auto read = [&](const View& result) { return read_fits(result, dimension_of(data.damping_law)); };
    for (const SampleFit& sample : before.read("6-fit.json", read)) {
        const SampleContact& contact = entry_named(contacts, sample.name, before, "2-contact.json");
        Json json{{"name", sample.name}};
        for (const LawChoice& choice : data.laws) {
            const LawFit* fit = sample.laws.find(choice.law);
            if (fit == nullptr) continue;
            if (fit->critical_damping < 0) {
                output.warnings.push_back(
                    fmt::format("{}, {}: the fit gives a negative critical damping, so the data "
                                "do not say where capture begins",
                                sample.name, choice.law.name()));
                continue;
            }
            json[std::string(choice.law.name())] =
                law_json(data, choice, fit->critical_damping, contact.pair);
        }
        output.result["samples"].push_back(std::move(json));
    }
    return output;
}

std::vector<SampleCriticalVelocity> read_critical_velocities(const View& result) {
    std::vector<SampleCriticalVelocity> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleCriticalVelocity entry{.name = sample.at("name").text(), .laws = {}};
        for (const auto& [name, node] : sample.members()) {
            if (name == "name") continue;
            const Law law = node.located([&, &key = name] { return Law::named(key); });
            LawCriticalVelocity velocity{
                .verdict = node.at("verdict").text(),
                .value = {},
                .contact_time = {},
                .dissipated = node.at("dissipated").number(Dimension::energy),
                .plastic = 0.0,
                .detachment_energy = node.at("detachment_energy").number(Dimension::energy)};
            if (const auto value = node.find("critical_velocity"))
                velocity.value = value->number(Dimension::velocity);
            if (const auto plastic = node.find("plastic"))
                velocity.plastic = plastic->number(Dimension::energy);
            if (const auto time = node.find("contact_time"))
                velocity.contact_time = time->number(Dimension::time);
            entry.laws.set(law, std::move(velocity));
        }
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact
