// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/inversion_json.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "pipeline/document/quantity_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

using Values = std::vector<double>;

Json unreachable_json(const InvertedImpact& impact) {
    const std::string reason = impact.restitution >= impact.greatest_restitution
                                   ? fmt::format("without any damping the restitution is {} at this velocity",
                                                 readable_number(impact.greatest_restitution))
                                   : "no damping gives this restitution at this velocity";
    return {{"number", impact.index + 1},
            {"velocity", quantity_json(impact.velocity, Dimension::velocity)},
            {"restitution", quantity_json(impact.restitution, Dimension::fraction)},
            {"reason", reason}};
}

}  // namespace

Json inversion_json(const std::vector<InvertedImpact>& impacts, DampingLaw damping_law) {
    Values number, velocity, restitution, greatest, damping, uncertainty, time, captured, capturing;
    Json unreachable = Json::array();
    for (const InvertedImpact& impact : impacts) {
        if (impact.restitution == 0) {
            captured.push_back(impact.velocity);
            if (impact.damping) capturing.push_back(*impact.damping);
            continue;
        }
        if (!impact.damping || !impact.contact_time) {
            unreachable.push_back(unreachable_json(impact));
            continue;
        }
        number.push_back(static_cast<double>(impact.index + 1));
        velocity.push_back(impact.velocity);
        restitution.push_back(impact.restitution);
        greatest.push_back(impact.greatest_restitution);
        damping.push_back(*impact.damping);
        time.push_back(*impact.contact_time);
        if (impact.standard_uncertainty) uncertainty.push_back(*impact.standard_uncertainty);
    }
    const Dimension dimension = dimension_of(damping_law);
    Json json{{"number", column_json(number, Dimension::fraction)},
              {"velocity", column_json(velocity, Dimension::velocity)},
              {"restitution", column_json(restitution, Dimension::fraction)},
              {"greatest_restitution", column_json(greatest, Dimension::fraction)},
              {"damping", column_json(damping, dimension)}};
    if (!uncertainty.empty() && uncertainty.size() == damping.size())
        json["damping_uncertainty"] = column_json(uncertainty, dimension);
    json["contact_time"] = column_json(time, Dimension::time);
    json["captured_at"] = column_json(captured, Dimension::velocity);
    if (!captured.empty() && capturing.size() == captured.size())
        json["capturing_damping"] = column_json(capturing, dimension);
    json["unreachable"] = unreachable;
    return json;
}

Json parts_json(const DampingParts& parts, const std::vector<InvertedImpact>& impacts) {
    Json list = Json::array();
    double slowest = std::numeric_limits<double>::infinity();
    double fastest = 0;
    for (const InvertedImpact& impact : impacts) {
        if (impact.restitution == 0 || !impact.damping) continue;
        slowest = std::min(slowest, impact.velocity);
        fastest = std::max(fastest, impact.velocity);
    }
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
        const auto end = [&](bool outer, double velocity, std::size_t boundary) {
            if (outer) return quantity_json(velocity, Dimension::velocity);
            Json json = quantity_json(parts.boundaries[boundary].velocity, Dimension::velocity);
            json["standard_uncertainty"] = parts.boundaries[boundary].standard_uncertainty;
            return json;
        };
        list.push_back({{"part", name_of(parts.parts[i])},
                        {"from", end(i == 0, slowest, i - 1)},
                        {"to", end(i == parts.boundaries.size(), fastest, i)}});
    }
    Json outliers = Json::array();
    for (const std::size_t index : parts.outliers) outliers.push_back(index + 1);
    Json json{{"parts", list}, {"outliers", outliers}};
    if (!parts.note.empty()) json["parts_note"] = parts.note;
    return json;
}

Json rising_branch_json(double upper, bool falls_beyond) {
    return {{"to", quantity_json(upper, Dimension::velocity)}, {"falls_beyond", falls_beyond}};
}

}  // namespace ashimpact
