// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results/inversion_json.hpp"

#include "core/json/view.hpp"

namespace ashimpact {

Json inversion_json(const DampingSeries& series, DampingLaw damping_law) {
    const Dimension dimension = dimension_of(damping_law);
    Json json{{"number", column_json(series.number, Dimension::fraction)},
              {"velocity", column_json(series.velocity, Dimension::velocity)},
              {"restitution", column_json(series.restitution, Dimension::fraction)},
              {"greatest_restitution", column_json(series.greatest_restitution, Dimension::fraction)},
              {"damping", column_json(series.damping, dimension)}};
    if (!series.damping_uncertainty.empty())
        json["damping_uncertainty"] = column_json(series.damping_uncertainty, dimension);
    json["contact_time"] = column_json(series.contact_time, Dimension::time);
    json["captured_at"] = column_json(series.captured_at, Dimension::velocity);
    if (!series.capturing_damping.empty())
        json["capturing_damping"] = column_json(series.capturing_damping, dimension);
    json["unreachable"] = Json::array();
    for (const UnreachableImpact& impact : series.unreachable)
        json["unreachable"].push_back(
            {{"number", impact.number},
             {"velocity", quantity_json(impact.velocity, Dimension::velocity)},
             {"restitution", quantity_json(impact.restitution, Dimension::fraction)},
             {"reason", impact.reason}});
    return json;
}

Json parts_json(const DampingSeries& series) {
    Json list = Json::array();
    for (const PartRange& part : series.parts)
        list.push_back({{"part", name_of(part.part)}, {"from", part.from}, {"to", part.to}});
    Json json{{"parts", std::move(list)}, {"outliers", series.outliers}};
    if (!series.parts_note.empty()) json["parts_note"] = series.parts_note;
    return json;
}

Json rising_branch_json(double upper, bool falls_beyond) {
    return {{"to", quantity_json(upper, Dimension::velocity)}, {"falls_beyond", falls_beyond}};
}

}  // namespace ashimpact
