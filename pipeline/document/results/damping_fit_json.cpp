// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results/damping_fit_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/json/view.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/statistics_json.hpp"
#include "pipeline/run/results/velocity.hpp"

namespace ashimpact {

namespace {

constexpr auto damping_unit = "kg/s";
constexpr auto velocity_unit = "m/s";

/// The rebounds of a fit as columns.
Json residuals_json(const DampingCurveFit& fit) {
    std::vector<double> number, restitution, distance, leverage, deleted, influence, weight;
    for (const FittedRebound& rebound : fit.rebounds) {
        number.push_back(static_cast<double>(rebound.index + 1));
        restitution.push_back(rebound.restitution);
        distance.push_back(rebound.distance);
        leverage.push_back(rebound.leverage);
        deleted.push_back(rebound.deleted_distance);
        influence.push_back(rebound.influence);
        weight.push_back(rebound.weight);
    }
    const auto plain = [](const std::vector<double>& values) {
        return column_json(values, Dimension::fraction);
    };
    Json json{{"number", plain(number)},
              {"restitution", plain(restitution)},
              {"distance", plain(distance)},
              {"leverage", plain(leverage)}};
    const auto add = [&](const char* key, const std::vector<double>& values, Dimension dimension) {
        for (const double value : values)
            if (!std::isfinite(value)) return;
        json[key] = column_json(values, dimension);
    };
    add("deleted_distance", deleted, Dimension::fraction);
    add("influence", influence, Dimension::damping);
    if (fit.options.robust) add("weight", weight, Dimension::fraction);
    return json;
}

/// chi^2 and its probability mean nothing where the noise is estimated from the scatter itself.
Json with_known_noise(const DampingCurveFit& fit, double value) {
    return fit.noise_known ? Json(value) : Json(nullptr);
}

/// A critical damping or velocity with its interval; 0 without interval if it is missing.
Interval read_result(const View& node, const std::string& key, Dimension dimension) {
    Interval result{};
    if (const auto member = node.find(key)) {
        const Quantity quantity = member->quantity(dimension);
        result.value = quantity.value;
        result.standard_uncertainty = quantity.standard_uncertainty.value_or(0);
    }
    const auto interval = node.find(key + "_interval");
    const auto end = [&](const char* which) -> std::optional<double> {
        const auto found = interval ? interval->find(which) : std::nullopt;
        return found ? std::optional(found->number(dimension)) : std::nullopt;
    };
    result.lower = end("lower");
    result.upper = end("upper");
    return result;
}

/// A number that is null where it is not finite.
double read_finite(const View& node, const char* key) {
    const auto member = node.find(key);
    return member ? member->number(Dimension::fraction) : std::numeric_limits<double>::quiet_NaN();
}

/// The scatter of the impacts, in the unit that it has.
double read_scatter(const View& node) {
    const auto scatter = node.find("scatter");
    return scatter ? scatter->at("value").number(Dimension::fraction) : 0;
}

bool read_truth(const View& node, const char* key) {
    const auto member = node.find(key);
    return member && member->truth();
}

/// The inverse of residuals_json().
std::vector<FittedRebound> read_residuals(const View& node) {
    const auto column = [&](const char* key, Dimension dimension, std::size_t count, double otherwise) {
        const auto member = node.find(key);
        auto values = member ? member->column(dimension) : std::vector<double>(count, otherwise);
        if (values.size() != count) node.fail("the columns differ in length", "columns of one length");
        return values;
    };
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto number = node.at("number").column(Dimension::fraction);
    const std::size_t count = number.size();
    const auto restitution = column("restitution", Dimension::fraction, count, unknown);
    const auto distance = column("distance", Dimension::fraction, count, unknown);
    const auto leverage = column("leverage", Dimension::fraction, count, unknown);
    const auto deleted = column("deleted_distance", Dimension::fraction, count, unknown);
    const auto influence = column("influence", Dimension::damping, count, unknown);
    const auto weight = column("weight", Dimension::fraction, count, 1);
    std::vector<FittedRebound> rebounds;
    for (std::size_t i = 0; i < count; ++i)
        rebounds.push_back({static_cast<std::size_t>(number[i]) - 1, restitution[i], distance[i], leverage[i],
                            deleted[i], influence[i], weight[i]});
    return rebounds;
}

}  // namespace

Json damping_fit_json(const DampingCurveFit& fit) {
    Json excluded = Json::array();
    for (const ExcludedRebound& rebound : fit.excluded) excluded.push_back(rebound.index + 1);
    return {{"order", fit.options.order},
            {"robust", fit.options.robust},
            {"coefficients", column_json(to_std_vector(fit.damping.coefficients), Dimension::damping)},
            {"covariance", {{"values", matrix_json(fit.covariance)}, {"unit", "(kg/s)2"}}},
            {"critical_damping", estimate_json(fit.critical_damping, damping_unit)},
            {"critical_damping_interval", interval_json(fit.critical_damping, damping_unit)},
            {"critical_velocity", estimate_json(fit.critical_velocity, velocity_unit)},
            {"critical_velocity_interval", interval_json(fit.critical_velocity, velocity_unit)},
            {"rebounds", fit.rebounds.size()},
            {"chi_squared", with_known_noise(fit, fit.chi_squared)},
            {"degrees_of_freedom", fit.degrees_of_freedom},
            {"probability", with_known_noise(fit, fit.probability)},
            {"noise_known", fit.noise_known},
            {"scatter", quantity_json(fit.scatter, fit.noise_known ? "1" : velocity_unit)},
            {"prediction_error", finite_json(fit.prediction_error)},
            {"restitution_range", {fit.restitutions[0], fit.restitutions[1]}},
            {"extrapolation", finite_json(fit.extrapolation)},
            {"residuals", residuals_json(fit)},
            {"excluded", excluded}};
}

DampingCurveFit read_damping_fit(const View& node) {
    DampingCurveFit fit{};
    fit.options = {.order = node.at("order").integer(), .robust = node.at("robust").truth()};
    const auto coefficients = node.at("coefficients").column(Dimension::damping);
    const auto size = static_cast<Eigen::Index>(coefficients.size());
    fit.damping.coefficients = Eigen::Map<const Eigen::VectorXd>(coefficients.data(), size);
    if (size > 0 && !(coefficients.front() > 0))
        node.at("coefficients").fail("the first, the critical damping, is not positive", "> 0 kg/s");
    if (size > 0)
        require_agreement(node.at("critical_damping"), coefficients.front(), Dimension::damping,
                          "is not the first of the coefficients", "these");
    const auto rows = node.at("covariance").at("values").elements();
    if (size != fit.options.order + 1 || rows.size() != coefficients.size())
        node.fail("coefficients and covariance do not belong to the order", "order + 1 of each");
    fit.covariance.resize(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto row = rows[static_cast<std::size_t>(i)].column(Dimension::fraction);
        if (row.size() != coefficients.size())
            node.at("covariance").fail("the matrix is not square", "order + 1 rows and columns");
        fit.covariance.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), size);
    }
    fit.critical_damping = read_result(node, "critical_damping", Dimension::damping);
    fit.critical_damping.value = fit.damping.critical_damping();
    fit.critical_velocity = read_result(node, "critical_velocity", Dimension::velocity);
    fit.restitutions = read_range(node.at("restitution_range"));
    fit.noise_known = read_truth(node, "noise_known");
    if (fit.noise_known) fit.chi_squared = read_finite(node, "chi_squared");
    fit.probability = fit.noise_known ? read_finite(node, "probability") : 1;
    if (const auto degrees = node.find("degrees_of_freedom")) fit.degrees_of_freedom = degrees->integer();
    fit.scatter = read_scatter(node);
    fit.prediction_error = read_finite(node, "prediction_error");
    fit.extrapolation = read_finite(node, "extrapolation");
    if (const auto residuals = node.find("residuals")) fit.rebounds = read_residuals(*residuals);
    if (const auto excluded = node.find("excluded"))
        for (const View& number : excluded->elements())
            fit.excluded.push_back({static_cast<std::size_t>(number.integer()) - 1, Exclusion::above_reach});
    return fit;
}

Json damping_estimate_json(const DampingEstimate& estimate) {
    return {{"method", name_of(VelocityMethod::estimate)},
            {"critical_damping", estimate_json(estimate.critical_damping, damping_unit)},
            {"critical_damping_interval", interval_json(estimate.critical_damping, damping_unit)},
            {"critical_velocity", estimate_json(estimate.critical_velocity, velocity_unit)},
            {"critical_velocity_interval", interval_json(estimate.critical_velocity, velocity_unit)},
            {"rebounds", estimate.rebounds},
            {"captures", estimate.captures},
            {"noise_known", estimate.noise_known},
            {"scatter", quantity_json(estimate.scatter, estimate.noise_known ? "1" : velocity_unit)},
            {"particle_scatter", estimate.particle_scatter}};
}

DampingEstimate read_damping_estimate(const View& node) {
    DampingEstimate estimate{.critical_damping = read_result(node, "critical_damping", Dimension::damping),
                             .critical_velocity = read_result(node, "critical_velocity", Dimension::velocity),
                             .rebounds = count_if_any(node, "rebounds"),
                             .captures = count_if_any(node, "captures"),
                             .noise_known = read_truth(node, "noise_known"),
                             .scatter = read_scatter(node)};
    if (!(estimate.critical_damping.value > 0))
        node.at("critical_damping").fail("the critical damping is not positive", "> 0 kg/s");
    if (const auto scatter = node.find("particle_scatter"))
        estimate.particle_scatter = scatter->number(Dimension::fraction);
    return estimate;
}

Json comparison_json(const FitComparison& comparison) {
    return {{"critical_damping_ratio", finite_json(comparison.critical_damping_ratio)},
            {"critical_velocity_ratio", finite_json(comparison.critical_velocity_ratio)},
            {"consistent", comparison.consistent},
            {"exclude_one_another", comparison.exclude_one_another},
            {"statement", comparison.statement}};
}

FitComparison read_comparison(const View& node) {
    return {read_finite(node, "critical_damping_ratio"), read_finite(node, "critical_velocity_ratio"),
            read_truth(node, "consistent"), read_truth(node, "exclude_one_another"),
            node.at("statement").text()};
}

std::array<double, 2> read_range(const View& node) {
    const auto range = node.column(Dimension::fraction);
    if (range.size() != 2) node.fail("is not a range", "least and greatest");
    return {range[0], range[1]};
}

}  // namespace ashimpact
