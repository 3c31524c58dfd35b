// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/document/case_json.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/results_json.hpp"
#include "pipeline/document/results/uncertainty_json.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

Json reported_json(const ReportedVelocity& reported) {
    Json velocity = nullptr;
    if (reported.velocity)
        velocity =
            reported.velocity->method ? headline_json(*reported.velocity) : velocity_json(*reported.velocity);
    return {{"law", reported.law ? Json(reported.law->name()) : Json(nullptr)},
            {"critical_velocity", std::move(velocity)},
            {"interval", bounds_json(reported.interval, Dimension::velocity)},
            {"reason", reported.reason}};
}

Bounds read_velocity_bounds(const View& node) {
    return read_bounds(node, Dimension::velocity);
}

ReportedVelocity read_reported(const View& node) {
    ReportedVelocity reported{
        .law = read_if(
            node, "law",
            [](const View& law) { return at_place(law.pointer(), [&] { return Law::named(law.text()); }); }),
        .velocity = read_if(node, "critical_velocity", read_velocity),
        .interval = read_if(node, "interval", read_velocity_bounds),
        .reason = node.at("reason").text()};
    if (reported.velocity) reported.velocity->interval = reported.interval;
    return reported;
}

Json assumed_json(const std::vector<AssumedProperty>& assumed) {
    Json list = Json::array();
    for (const AssumedProperty& each : assumed)
        list.push_back({{"quantity", each.quantity},
                        {"value", each.value},
                        {"origin", name_of(each.origin)},
                        {"why", each.why}});
    return list;
}

/// A quantity of any dimension, as artifacts write one.
Quantity read_written_quantity(const View& node) {
    Quantity quantity{.value = node.at("value").number(Dimension::fraction), .unit = node.at("unit").text()};
    quantity.standard_uncertainty = number_if(node, "standard_uncertainty", Dimension::fraction);
    return quantity;
}

AssumedProperty read_assumed(const View& node) {
    return {node.at("quantity").text(), read_written_quantity(node.at("value")),
            named<Origin>(node.at("origin").text()), node.at("why").text()};
}

Json beside_json(const Beside& beside) {
    return {{"ours", quantity_json(beside.ours, beside.published.unit)},
            {"published", beside.published},
            {"relative_difference", beside.relative_difference}};
}

Beside read_beside(const View& node) {
    return {read_written_quantity(node.at("ours")).value, read_written_quantity(node.at("published")),
            node.at("relative_difference").number(Dimension::fraction)};
}

Json published_beside_json(const PublishedBeside& published) {
    Json json{{"source", published.source}};
    if (published.young_modulus) json["young_modulus"] = beside_json(*published.young_modulus);
    for (const auto& [name, beside] : published.volume_fractions)
        json["volume_fractions"][name] = beside_json(beside);
    const auto add = [&](const char* key, const LawMap<Beside>& values) {
        for (const auto& [law, beside] : values) json[key][std::string(law.name())] = beside_json(beside);
    };
    add("critical_damping", published.critical_damping);
    add("critical_velocity", published.critical_velocity);
    add("critical_contact_times", published.critical_contact_times);
    for (const ContactTimeBeside& time : published.contact_times) {
        Json entry{{"law", time.law.name()}, {"velocity", time.velocity}};
        entry.update(beside_json(time.contact_time));
        json["contact_times"].push_back(std::move(entry));
    }
    return json;
}

PublishedBeside read_published_beside(const View& node) {
    PublishedBeside published{
        .source = text_if(node, "source"),
        .young_modulus = read_if(node, "young_modulus", read_beside),
        .critical_damping = by_law_if(node, "critical_damping", read_beside),
        .critical_velocity = by_law_if(node, "critical_velocity", read_beside),
        .critical_contact_times = by_law_if(node, "critical_contact_times", read_beside),
        .contact_times = list_if(node, "contact_times", [](const View& time) {
            return ContactTimeBeside{Law::named(time.at("law").text()),
                                     time.at("velocity").quantity(Dimension::velocity), read_beside(time)};
        })};
    if (const auto fractions = node.find("volume_fractions"))
        for (const auto& [name, value] : fractions->members())
            published.volume_fractions.emplace_back(name, read_beside(value));
    return published;
}

/// Adds one column for each property of the laws.
void add_laws(const LawMap<LawComparison>& laws, Json& json) {
    Json velocity = Json::object();
    Json interval = Json::object();
    Json verdict = Json::object();
    for (const auto& [law, each] : laws) {
        const std::string name(law.name());
        velocity[name] = each.velocity ? headline_json(*each.velocity) : Json(nullptr);
        interval[name] =
            each.velocity ? bounds_json(each.velocity->interval, Dimension::velocity) : Json(nullptr);
        verdict[name] = name_of(each.verdict);
    }
    json["dynamic_critical_velocity"] = std::move(velocity);
    json["interval"] = std::move(interval);
    json["verdict"] = std::move(verdict);
}

Json sample_comparison_json(const SampleComparison& sample) {
    Json json{{"name", sample.name}};
    if (sample.reported) json["reported"] = reported_json(*sample.reported);
    const auto number = [&](const char* key, const std::optional<double>& value, Dimension dimension) {
        if (value) json[key] = quantity_json(*value, dimension);
    };
    const auto quantity = [&](const char* key, const std::optional<Quantity>& value) {
        if (value) json[key] = *value;
    };
    number("diameter", sample.diameter, Dimension::length);
    quantity("density", sample.density);
    quantity("work_of_adhesion", sample.work_of_adhesion);
    json["assumed"] = assumed_json(sample.assumed);
    json["taken_as_exact"] = sample.taken_as_exact;
    quantity("young_modulus", sample.young_modulus);
    number("contact_modulus", sample.contact_modulus, Dimension::pressure);
    number("separation_energy", sample.separation_energy, Dimension::energy);
    json["analytic_critical_velocity"] = quantity_json(sample.analytic_velocity, Dimension::velocity);
    add_laws(sample.laws, json);
    json["measured_critical_velocity"] = sample.measured ? stated_json(*sample.measured) : Json(nullptr);
    json["check"] = Json::object();
    for (const auto& [law, each] : sample.laws)
        json["check"][std::string(law.name())] = each.check ? check_json(*each.check) : Json(nullptr);
    if (sample.measured_interval)
        json["measured_interval"] = bounds_json(*sample.measured_interval, Dimension::velocity);
    for (const auto& [law, each] : sample.laws)
        if (each.extrapolated)
            json["extrapolated_critical_velocity"][std::string(law.name())] =
                headline_json(*each.extrapolated);
    for (const auto& [law, each] : sample.laws)
        if (!each.interval_note.empty()) json["interval_note"][std::string(law.name())] = each.interval_note;
    if (sample.published) json["published"] = published_beside_json(*sample.published);
    return json;
}

LawMap<LawComparison> read_law_comparisons(const View& node) {
    LawMap<LawComparison> laws;
    const auto under = [&](const char* key, Law law) {
        const auto column = node.find(key);
        return column ? column->find(law.name()) : std::nullopt;
    };
    for (const auto& [key, value] : node.at("dynamic_critical_velocity").members()) {
        const Law law = at_place(value.pointer(), [&name = key] { return Law::named(name); });
        LawComparison each;
        if (!value.json().is_null()) each.velocity = read_velocity(value);
        if (const auto interval = under("interval", law); each.velocity && interval)
            each.velocity->interval = read_velocity_bounds(*interval);
        if (const auto verdict = under("verdict", law)) each.verdict = named<LawVerdict>(verdict->text());
        if (const auto velocity = under("extrapolated_critical_velocity", law))
            each.extrapolated = read_velocity(*velocity);
        if (const auto note = under("interval_note", law)) each.interval_note = note->text();
        if (const auto check = under("check", law)) each.check = read_check(*check);
        laws.set(law, std::move(each));
    }
    return laws;
}

SampleComparison read_sample_comparison(const View& node) {
    SampleComparison sample{
        .name = node.at("name").text(),
        .reported = read_if(node, "reported", read_reported),
        .diameter = number_if(node, "diameter", Dimension::length),
        .density = quantity_if(node, "density", Dimension::density),
        .work_of_adhesion = quantity_if(node, "work_of_adhesion", Dimension::energy_per_area),
        .assumed = list_if(node, "assumed", read_assumed),
        .young_modulus = quantity_if(node, "young_modulus", Dimension::pressure),
        .contact_modulus = number_if(node, "contact_modulus", Dimension::pressure),
        .separation_energy = number_if(node, "separation_energy", Dimension::energy),
        .analytic_velocity = node.at("analytic_critical_velocity").number(Dimension::velocity),
        .laws = read_law_comparisons(node),
        .measured = read_if(node, "measured_critical_velocity",
                            [](const View& value) { return read_stated(value, Dimension::velocity); }),
        .measured_interval = read_if(node, "measured_interval", read_velocity_bounds),
        .published = read_if(node, "published", read_published_beside)};
    if (const auto exact = node.find("taken_as_exact")) sample.taken_as_exact = exact->texts();
    return sample;
}

Json equal_velocity_json(const EqualVelocity& equal, DampingLaw law) {
    Json rows = Json::array();
    for (const ImpactAtVelocity& impact : equal.impacts)
        rows.push_back({{"law", impact.law.name()},
                        {"sample", impact.sample},
                        {"restitution", quantity_json(impact.restitution, Dimension::fraction)},
                        {"damping", quantity_json(impact.damping, dimension_of(law))},
                        {"contact_time", quantity_json(impact.contact_time, Dimension::time)},
                        {"maximum_overlap", quantity_json(impact.maximum_overlap, Dimension::length)}});
    return {{"velocity", quantity_json(equal.velocity, Dimension::velocity)}, {"impacts", std::move(rows)}};
}

EqualVelocity read_equal_velocity(const View& node, DampingLaw law) {
    return {node.at("velocity").number(Dimension::velocity), list_if(node, "impacts", [&](const View& row) {
                return ImpactAtVelocity{Law::named(row.at("law").text()),
                                        row.at("sample").text(),
                                        row.at("restitution").number(Dimension::fraction),
                                        row.at("damping").number(dimension_of(law)),
                                        number_if(row, "contact_time", Dimension::time),
                                        row.at("maximum_overlap").number(Dimension::length)};
            })};
}

}  // namespace

Json to_json(const ComparisonResult& result, DampingLaw law) {
    Json json{{"case", result.name}};
    json.update(samples_json(result.samples, sample_comparison_json));
    for (const EqualVelocity& equal : result.equal_velocities)
        json["equal_velocities"].push_back(equal_velocity_json(equal, law));
    if (result.dynamic_over_analytic)
        json["dynamic_over_analytic"] = {{"least", result.dynamic_over_analytic->least},
                                         {"greatest", result.dynamic_over_analytic->greatest}};
    json["conclusion"] = result.conclusion;
    return json;
}

template <>
ComparisonResult from_json<ComparisonResult>(const View& result, DampingLaw law) {
    return {.name = text_if(result, "case"),
            .samples = samples_of(result, read_sample_comparison),
            .equal_velocities = list_if(result, "equal_velocities",
                                        [&](const View& node) { return read_equal_velocity(node, law); }),
            .dynamic_over_analytic = read_if(result, "dynamic_over_analytic",
                                             [](const View& node) {
                                                 return RatioRange{
                                                     node.at("least").number(Dimension::fraction),
                                                     node.at("greatest").number(Dimension::fraction)};
                                             }),
            .conclusion = text_if(result, "conclusion")};
}

}  // namespace ashimpact
