// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/damping_fit_json.hpp"

#include <cmath>

#include "pipeline/document/quantity_json.hpp"
#include "pipeline/document/statistics_json.hpp"

namespace ashimpact {

namespace {

constexpr auto damping_unit = "kg/s";
constexpr auto velocity_unit = "m/s";

/// The rebounds of a fit as columns.
Json residuals_json(const DampingCurveFit& fit, const std::vector<std::size_t>& numbers) {
    std::vector<double> number, restitution, distance, leverage, deleted, influence, weight;
    for (const FittedRebound& rebound : fit.rebounds) {
        number.push_back(static_cast<double>(numbers.at(rebound.index)));
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

/// The critical damping of a node, with its interval.
Interval damping_interval(const View& node, double value) {
    const auto end = [&](const char* key) -> std::optional<double> {
        const auto interval = node.find("critical_damping_interval");
        const auto found = interval ? interval->find(key) : std::nullopt;
        return found ? std::optional(found->number(Dimension::damping)) : std::nullopt;
    };
    return {.value = value,
            .standard_uncertainty =
                node.at("critical_damping").quantity(Dimension::damping).standard_uncertainty.value_or(0),
            .lower = end("lower"),
            .upper = end("upper")};
}

}  // namespace

Json damping_fit_json(const DampingCurveFit& fit, const std::vector<std::size_t>& numbers) {
    Json excluded = Json::array();
    for (const ExcludedRebound& rebound : fit.excluded) excluded.push_back(numbers.at(rebound.index));
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
            {"residuals", residuals_json(fit, numbers)},
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
    fit.critical_damping = damping_interval(node, fit.damping.critical_damping());
    const auto range = node.at("restitution_range").column(Dimension::fraction);
    if (range.size() != 2) node.at("restitution_range").fail("is not a range", "least and greatest");
    fit.restitutions = {range[0], range[1]};
    return fit;
}

Json damping_estimate_json(const CriticalVelocityEstimate& estimate) {
    const CurveEstimate& curve = estimate.curve;
    return {{"method", estimate_method},
            {"critical_damping", estimate_json(curve.critical_damping, damping_unit)},
            {"critical_damping_interval", interval_json(curve.critical_damping, damping_unit)},
            {"critical_velocity", estimate_json(curve.critical_velocity, velocity_unit)},
            {"critical_velocity_interval", interval_json(curve.critical_velocity, velocity_unit)},
            {"rebounds", estimate.rebounds},
            {"captures", estimate.captures},
            {"noise_known", estimate.noise_known},
            {"scatter", quantity_json(curve.scatter.noise, estimate.noise_known ? "1" : velocity_unit)},
            {"particle_scatter", curve.scatter.damping}};
}

Interval read_critical_damping(const View& node) {
    const double value = node.at("critical_damping").number(Dimension::damping);
    if (!(value > 0)) node.at("critical_damping").fail("the critical damping is not positive", "> 0 kg/s");
    return damping_interval(node, value);
}

Json comparison_json(const FitComparison& comparison) {
    return {{"critical_damping_ratio", finite_json(comparison.critical_damping_ratio)},
            {"critical_velocity_ratio", finite_json(comparison.critical_velocity_ratio)},
            {"consistent", comparison.consistent},
            {"exclude_one_another", comparison.exclude_one_another},
            {"statement", comparison.statement}};
}

}  // namespace ashimpact
