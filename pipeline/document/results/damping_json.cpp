// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/inversion_json.hpp"
#include "pipeline/document/results/results_json.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

Json damping_series_json(const DampingSeries& series, DampingLaw law) {
    Json json{{"origin", name_of(series.origin)}};
    json.update(inversion_json(series, law));
    json.update(parts_json(series));
    json["rising_branch"] =
        series.rising ? rising_branch_json(series.rising->to, series.rising->falls_beyond) : Json(nullptr);
    if (!series.rising_note.empty()) json["rising_branch_note"] = series.rising_note;
    json["map_accuracy"] = series.map_accuracy;
    return json;
}

UnreachableImpact read_unreachable(const View& node) {
    return {static_cast<std::size_t>(node.at("number").integer()),
            node.at("velocity").number(Dimension::velocity),
            node.at("restitution").number(Dimension::fraction), text_if(node, "reason")};
}

PartRange read_part(const View& node) {
    return {named<DampingPart>(node.at("part").text()), node.at("from").quantity(Dimension::velocity),
            node.at("to").quantity(Dimension::velocity)};
}

RisingRange read_rising(const View& node) {
    const auto falls = node.find("falls_beyond");
    return {node.at("to").number(Dimension::velocity), falls && falls->truth()};
}

DampingSeries read_damping_series(const View& node, Dimension dimension) {
    DampingSeries series{
        .origin = named<Origin>(node.at("origin").text()),
        .number = column_if(node, "number", Dimension::fraction),
        .velocity = node.at("velocity").column(Dimension::velocity),
        .restitution = node.at("restitution").column(Dimension::fraction),
        .greatest_restitution = column_if(node, "greatest_restitution", Dimension::fraction),
        .damping = node.at("damping").column(dimension),
        .damping_uncertainty = column_if(node, "damping_uncertainty", dimension),
        .contact_time = node.at("contact_time").column(Dimension::time),
        .captured_at = column_if(node, "captured_at", Dimension::velocity),
        .capturing_damping = column_if(node, "capturing_damping", dimension),
        .unreachable = list_if(node, "unreachable", read_unreachable),
        .parts = list_if(node, "parts", read_part),
        .parts_note = text_if(node, "parts_note"),
        .outliers = list_if(node, "outliers",
                            [](const View& number) { return static_cast<std::size_t>(number.integer()); }),
        .rising = read_if(node, "rising_branch", read_rising),
        .rising_note = text_if(node, "rising_branch_note"),
        .map_accuracy = number_if(node, "map_accuracy", Dimension::fraction).value_or(0)};
    if (series.velocity.size() != series.restitution.size() ||
        series.velocity.size() != series.damping.size())
        node.fail("the columns differ in length", "columns of one length");
    return series;
}

}  // namespace

Json to_json(const DampingStageResult& result, DampingLaw law) {
    return samples_json(result.samples, [&](const SampleDamping& sample) {
        Json json{{"name", sample.name}};
        for (const auto& [each, series] : sample.laws)
            json[std::string(each.name())] = damping_series_json(series, law);
        return json;
    });
}

template <>
DampingStageResult from_json<DampingStageResult>(const View& result, DampingLaw law) {
    return {samples_of(result, [&](const View& node) {
        SampleDamping sample{.name = node.at("name").text()};
        for_each_law(node, {"name"}, [&](Law each, const View& series) {
            sample.laws.set(each, read_damping_series(series, dimension_of(law)));
        });
        return sample;
    })};
}

}  // namespace ashimpact
