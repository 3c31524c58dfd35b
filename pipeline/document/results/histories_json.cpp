// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/results_json.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

Json stage_momentum_json(const StageMomentum& stage) {
    return {{"duration", quantity_json(stage.duration, Dimension::time)},
            {"static_impulse", quantity_json(stage.static_impulse, Dimension::impulse)},
            {"damping_impulse", quantity_json(stage.damping_impulse, Dimension::impulse)},
            {"mean_force", quantity_json(stage.mean_force, Dimension::force)},
            {"residual", quantity_json(stage.residual, Dimension::impulse)}};
}

StageMomentum read_stage_momentum(const View& node) {
    return {node.at("duration").number(Dimension::time), node.at("static_impulse").number(Dimension::impulse),
            node.at("damping_impulse").number(Dimension::impulse),
            node.at("mean_force").number(Dimension::force), node.at("residual").number(Dimension::impulse)};
}

Json momentum_json(const HistoryMomentum& momentum) {
    return {{"approach", stage_momentum_json(momentum.approach)},
            {"rebound", stage_momentum_json(momentum.rebound)},
            {"mean_force_ratio", momentum.mean_force_ratio},
            {"equation_44",
             {{"damping_impulse", quantity_json(momentum.damping_impulse, Dimension::impulse)},
              {"momentum_lost", quantity_json(momentum.momentum_lost, Dimension::impulse)},
              {"holds", momentum.damping_exceeds_loss}}},
            {"equation_45",
             {{"approach_time", quantity_json(momentum.approach.duration, Dimension::time)},
              {"rebound_time", quantity_json(momentum.rebound.duration, Dimension::time)},
              {"holds", momentum.rebound_is_longer}}},
            {"verdict", momentum.verdict}};
}

HistoryMomentum read_momentum(const View& node) {
    const View loss = node.at("equation_44");
    return {read_stage_momentum(node.at("approach")),
            read_stage_momentum(node.at("rebound")),
            node.at("mean_force_ratio").number(Dimension::fraction),
            loss.at("damping_impulse").number(Dimension::impulse),
            loss.at("momentum_lost").number(Dimension::impulse),
            loss.at("holds").truth(),
            node.at("equation_45").at("holds").truth(),
            node.at("verdict").text()};
}

struct TrajectoryColumn {
    const char* key;
    double TrajectoryPoint::*member;
    Dimension dimension;
};

constexpr TrajectoryColumn trajectory_columns[]{
    {"time", &TrajectoryPoint::time, Dimension::time},
    {"overlap", &TrajectoryPoint::overlap, Dimension::length},
    {"velocity", &TrajectoryPoint::velocity, Dimension::velocity},
    {"contact_radius", &TrajectoryPoint::contact_radius, Dimension::length},
    {"repulsive_force", &TrajectoryPoint::repulsive_force, Dimension::force},
    {"attractive_force", &TrajectoryPoint::attractive_force, Dimension::force},
    {"damping_force", &TrajectoryPoint::damping_force, Dimension::force}};

Json trajectory_json(const std::vector<TrajectoryPoint>& points) {
    Json json = Json::object();
    for (const TrajectoryColumn& column : trajectory_columns) {
        std::vector<double> values;
        values.reserve(points.size());
        for (const TrajectoryPoint& point : points) values.push_back(point.*column.member);
        json[column.key] = column_json(values, column.dimension);
    }
    return json;
}

std::vector<TrajectoryPoint> read_trajectory(const View& node) {
    std::vector<TrajectoryPoint> points(node.at("time").column(Dimension::time).size());
    for (const TrajectoryColumn& column : trajectory_columns) {
        const auto values = node.at(column.key).column(column.dimension);
        if (values.size() != points.size())
            node.at(column.key).fail("is not as long as the time", "columns of one length");
        for (std::size_t i = 0; i < values.size(); ++i) points[i].*column.member = values[i];
    }
    return points;
}

Json history_json(const History& history, DampingLaw law) {
    Json json{{"part", name_of(history.part)},
              {"velocity", quantity_json(history.velocity, Dimension::velocity)},
              {"damping", quantity_json(history.damping, unit_of(law))},
              {"outcome", name_of(history.outcome)},
              {"restitution", quantity_json(history.restitution, Dimension::fraction)},
              {"contact_time", quantity_json(history.contact_time, Dimension::time)},
              {"maximum_overlap", quantity_json(history.maximum_overlap, Dimension::length)},
              {"greatest_pressure", quantity_json(history.greatest_pressure, Dimension::pressure)},
              {"yield_pressure", quantity_json(history.yield_pressure, Dimension::pressure)}};
    if (history.momentum) json["momentum"] = momentum_json(*history.momentum);
    json["trajectory"] = trajectory_json(history.trajectory);
    return json;
}

History read_history(const View& node, DampingLaw law) {
    History history{
        .part = named<HistoryPart>(node.at("part").text()),
        .velocity = node.at("velocity").number(Dimension::velocity),
        .damping = number_if(node, "damping", dimension_of(law)).value_or(0),
        .restitution = number_if(node, "restitution", Dimension::fraction).value_or(0),
        .contact_time = number_if(node, "contact_time", Dimension::time),
        .maximum_overlap = number_if(node, "maximum_overlap", Dimension::length).value_or(0),
        .greatest_pressure = number_if(node, "greatest_pressure", Dimension::pressure).value_or(0),
        .yield_pressure = number_if(node, "yield_pressure", Dimension::pressure),
        .momentum = read_if(node, "momentum", read_momentum),
        .trajectory = read_trajectory(node.at("trajectory"))};
    if (const auto outcome = node.find("outcome")) history.outcome = named<Outcome>(outcome->text());
    return history;
}

Json contact_time_json(const ContactTimeAt& time) {
    return {{"law", time.law.name()},
            {"velocity", quantity_json(time.velocity, Dimension::velocity)},
            {"restitution", quantity_json(time.restitution, Dimension::fraction)},
            {"contact_time", quantity_json(time.contact_time, Dimension::time)}};
}

ContactTimeAt read_contact_time(const View& node) {
    return {Law::named(node.at("law").text()), node.at("velocity").number(Dimension::velocity),
            number_if(node, "restitution", Dimension::fraction),
            number_if(node, "contact_time", Dimension::time)};
}

struct CurveColumn {
    const char* key;
    double CurveImpact::*member;
    Dimension dimension;  ///< of damping: any, it follows the damping law
};

constexpr CurveColumn curve_columns[]{{"velocity", &CurveImpact::velocity, Dimension::velocity},
                                      {"lower_velocity", &CurveImpact::lower, Dimension::velocity},
                                      {"upper_velocity", &CurveImpact::upper, Dimension::velocity},
                                      {"restitution", &CurveImpact::restitution, Dimension::fraction},
                                      {"damping", &CurveImpact::damping, Dimension::damping},
                                      {"contact_time", &CurveImpact::contact_time, Dimension::time},
                                      {"dissipated", &CurveImpact::dissipated, Dimension::fraction},
                                      {"adhesion", &CurveImpact::adhesion, Dimension::fraction},
                                      {"plastic", &CurveImpact::plastic, Dimension::fraction}};

Dimension dimension_in(const CurveColumn& column, DampingLaw law) {
    return column.member == &CurveImpact::damping ? dimension_of(law) : column.dimension;
}

Json curve_json(const LawCurve& curve, DampingLaw law) {
    Json json{{"start", quantity_json(curve.start, Dimension::velocity)}, {"histories", Json::array()}};
    for (const CurveColumn& column : curve_columns) {
        Json values = Json::array();
        for (const CurveImpact& impact : curve.impacts) {
            const double value = impact.*column.member;
            values.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
        }
        json[column.key] = {{"values", std::move(values)}, {"unit", si_unit(dimension_in(column, law))}};
    }
    for (const History& history : curve.histories)
        json["histories"].push_back({{"part", name_of(history.part)},
                                     {"velocity", quantity_json(history.velocity, Dimension::velocity)},
                                     {"damping", quantity_json(history.damping, unit_of(law))},
                                     {"trajectory", trajectory_json(history.trajectory)}});
    return json;
}

LawCurve read_curve(const View& node, DampingLaw law) {
    LawCurve curve{
        .start = number_if(node, "start", Dimension::velocity),
        .impacts = ModelCurve(node.at("velocity").at("values").elements().size()),
        .histories = list_if(node, "histories", [&](const View& each) { return read_history(each, law); })};
    for (const CurveColumn& column : curve_columns) {
        const View values = node.at(column.key).at("values");
        const auto elements = values.elements();
        if (elements.size() != curve.impacts.size())
            values.fail("is not as long as the velocity", "columns of one length");
        for (std::size_t i = 0; i < elements.size(); ++i)
            curve.impacts[i].*column.member = elements[i].json().is_null()
                                                  ? std::numeric_limits<double>::quiet_NaN()
                                                  : elements[i].number(dimension_in(column, law));
    }
    return curve;
}

}  // namespace

Json to_json(const HistoriesResult& result, DampingLaw law) {
    return samples_json(result.samples, [&](const SampleHistories& sample) {
        Json times = Json::array();
        for (const ContactTimeAt& time : sample.contact_times) times.push_back(contact_time_json(time));
        Json json{{"name", sample.name}, {"contact_times", std::move(times)}};
        for (const auto& [each, histories] : sample.laws) {
            Json list = Json::array();
            for (const History& history : histories) list.push_back(history_json(history, law));
            json[std::string(each.name())] = std::move(list);
        }
        json["curves"] = Json::object();
        for (const auto& [each, curve] : sample.curves)
            json["curves"][std::string(each.name())] = curve_json(curve, law);
        return json;
    });
}

template <>
HistoriesResult from_json<HistoriesResult>(const View& result, DampingLaw law) {
    return {samples_of(result, [&](const View& node) {
        SampleHistories sample{.name = node.at("name").text(),
                               .contact_times = list_if(node, "contact_times", read_contact_time)};
        for_each_law(node, {"name", "contact_times", "curves"}, [&](Law each, const View& list) {
            std::vector<History> histories;
            for (const View& history : list.elements()) histories.push_back(read_history(history, law));
            sample.laws.set(each, std::move(histories));
        });
        sample.curves = by_law_if(node, "curves", [&](const View& curve) { return read_curve(curve, law); });
        return sample;
    })};
}

}  // namespace ashimpact
