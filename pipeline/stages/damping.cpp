#include "pipeline/stages/damping.hpp"

#include <fmt/format.h>

#include "pipeline/case/laws.hpp"
#include "pipeline/json/quantity_json.hpp"
#include "pipeline/stages/contact.hpp"
#include "pipeline/stages/read_case_artifact.hpp"
#include "pipeline/stages/restitution.hpp"
#include "pipeline/text/readable.hpp"
#include "solver/damping_inversion.hpp"

namespace ashimpact {

namespace {

struct Inverted {
    DampingSeries series{};
    std::vector<double> captured_at{};  ///< velocities [m/s]
    Json unreachable = Json::array();
};

Inverted invert(const RestitutionSeries& data, const LawChoice& choice, DampingLaw damping_law,
                const ContactPair& contact) {
    Inverted inverted;
    inverted.series.origin = data.origin;
    for (std::size_t i = 0; i < data.velocity.size(); ++i) {
        if (data.restitution[i] == 0) {
            inverted.captured_at.push_back(data.velocity[i]);
            continue;
        }
        try {
            const DampingInversion inversion = damping_from_restitution({.law = choice.law,
                                                                         .detachment = choice.detachment,
                                                                         .damping_law = damping_law,
                                                                         .contact = contact,
                                                                         .velocity = data.velocity[i],
                                                                         .restitution = data.restitution[i]});
            inverted.series.velocity.push_back(data.velocity[i]);
            inverted.series.restitution.push_back(data.restitution[i]);
            inverted.series.damping.push_back(inversion.damping.coefficient);
            inverted.series.contact_time.push_back(inversion.impact.contact_time.value());
        } catch (const InputError& error) {
            inverted.unreachable.push_back(
                {{"velocity", quantity_json(data.velocity[i], Dimension::velocity)},
                 {"restitution", quantity_json(data.restitution[i], Dimension::fraction)},
                 {"reason", error.what()}});
        }
    }
    return inverted;
}

Json inverted_json(const Inverted& inverted, DampingLaw damping_law) {
    const DampingSeries& series = inverted.series;
    return {{"origin", series.origin},
            {"velocity", column_json(series.velocity, Dimension::velocity)},
            {"restitution", column_json(series.restitution, Dimension::fraction)},
            {"damping", column_json(series.damping, dimension_of(damping_law))},
            {"contact_time", column_json(series.contact_time, Dimension::time)},
            {"captured_at", column_json(inverted.captured_at, Dimension::velocity)},
            {"unreachable", inverted.unreachable}};
}

}  // namespace

StageOutput damping_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const auto contacts = before.read("2-contact.json", read_contacts);
    StageOutput output{.citations = {"dong2013, section 4.2"}};
    output.options = {{"damping_law", name_of(data.damping_law)}, {"detachments", Json::object()}};
    for (const LawChoice& choice : data.laws)
        output.options["detachments"][std::string(choice.law.name())] = name_of(choice.detachment);
    output.result["samples"] = Json::array();
    for (const SampleRestitution& sample : before.read("4-restitution.json", read_restitutions)) {
        const SampleContact& contact = entry_named(contacts, sample.name, before, "2-contact.json");
        Json json{{"name", sample.name}};
        for (const LawChoice& choice : data.laws) {
            const RestitutionSeries* series = sample.of(choice.law);
            if (series == nullptr) continue;
            const Inverted inverted = invert(*series, choice, data.damping_law, contact.pair);
            if (!inverted.unreachable.empty())
                output.warnings.push_back(
                    fmt::format("{}, {}: {} of {} restitutions cannot be reached by any damping", sample.name,
                                choice.law.name(), inverted.unreachable.size(), series->velocity.size()));
            json[std::string(choice.law.name())] = inverted_json(inverted, data.damping_law);
        }
        output.result["samples"].push_back(std::move(json));
    }
    return output;
}

std::vector<SampleDamping> read_dampings(const View& result, Dimension dimension) {
    std::vector<SampleDamping> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleDamping entry{.name = sample.at("name").text(), .laws = {}};
        for (const auto& [name, node] : sample.members()) {
            if (name == "name") continue;
            const Law law = node.located([&, &key = name] { return Law::named(key); });
            DampingSeries series{.origin = node.at("origin").text(),
                                 .velocity = node.at("velocity").column(Dimension::velocity),
                                 .restitution = node.at("restitution").column(Dimension::fraction),
                                 .damping = node.at("damping").column(dimension),
                                 .contact_time = node.at("contact_time").column(Dimension::time)};
            if (series.velocity.size() != series.restitution.size() ||
                series.velocity.size() != series.damping.size())
                node.fail("the columns differ in length", "columns of one length");
            entry.laws.set(law, std::move(series));
        }
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact
