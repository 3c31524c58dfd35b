// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/quantities/checks.hpp"
#include "pipeline/document/results/damping_fit_json.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/results_json.hpp"
#include "pipeline/document/statistics_json.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

/// {"a", "b", "c", "critical_damping"} with the covariance of a, b, c.
Json quadratic_fit_json(const LawFit& fit, std::string_view unit) {
    const auto coefficient = [&](Eigen::Index power) {
        Json json = quantity_json(fit.damping.coefficients[power], unit);
        if (fit.covariance)
            json["standard_uncertainty"] = std::sqrt(std::max(0.0, (*fit.covariance)(power, power)));
        return json;
    };
    Json critical = quantity_json(fit.critical_damping, unit);
    if (fit.critical_damping_uncertainty)
        critical["standard_uncertainty"] = *fit.critical_damping_uncertainty;
    Json json{{"a", coefficient(2)},
              {"b", coefficient(1)},
              {"c", coefficient(0)},
              {"critical_damping", std::move(critical)}};
    if (fit.covariance)
        json["covariance"] = {{"parameters", {"a", "b", "c"}},
                              {"values", matrix_json(fit.covariance->reverse())},
                              {"unit", fmt::format("({})2", unit)}};
    return json;
}

Json law_fit_json(const LawFit& fit, DampingLaw law) {
    Json json = quadratic_fit_json(fit, unit_of(law));
    if (fit.method) json["method"] = name_of(*fit.method);
    if (fit.method != FitMethod::estimate) {
        if (fit.residual_deviation)
            json["residual_deviation"] = quantity_json(*fit.residual_deviation, unit_of(law));
        json["degrees_of_freedom"] = fit.degrees_of_freedom;
        json["points"] = fit.points;
        json["points_beyond_rising_branch"] = fit.points_beyond;
        if (fit.restitution_range) json["restitution_range"] = *fit.restitution_range;
    }
    if (fit.extrapolated) json["extrapolated"] = damping_fit_json(*fit.extrapolated);
    json["origin"] = name_of(fit.origin);
    if (fit.estimate) json["direct"] = damping_estimate_json(*fit.estimate);
    if (fit.comparison) json["comparison"] = comparison_json(*fit.comparison);
    return json;
}

/// Covariance of c, b, a from that of a, b, c.
Eigen::Matrix3d read_covariance(const View& node) {
    const auto rows = node.at("values").elements();
    if (rows.size() != 3) node.at("values").fail("is not the covariance of a, b and c", "three rows");
    Eigen::Matrix3d covariance;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto row = rows[static_cast<std::size_t>(i)].column(Dimension::fraction);
        if (row.size() != 3) rows[static_cast<std::size_t>(i)].fail("is not a row of three", "three numbers");
        for (Eigen::Index j = 0; j < 3; ++j) covariance(2 - i, 2 - j) = row[static_cast<std::size_t>(j)];
    }
    return covariance;
}

/// Checks that a fit has one critical damping, and one polynomial, wherever the artifact repeats them.
void require_one_fit(const View& node, Dimension dimension) {
    const double c = node.at("c").number(dimension);
    require_agreement(node.at("critical_damping"), c, dimension, "is not the c of the same fit", "c");
    if (const auto curve = node.find("extrapolated")) {
        const auto coefficients = curve->at("coefficients").column(Dimension::damping);
        constexpr std::array names{"c", "b", "a"};
        for (std::size_t i = 0; i < std::min(names.size(), coefficients.size()); ++i)
            require_agreement(node.at(names.at(i)), coefficients[i], dimension,
                              "is not that of \"extrapolated\"", "or remove \"extrapolated\" and \"direct\"");
    } else if (const auto estimate = node.find("direct")) {
        require_agreement(node.at("c"), estimate->at("critical_damping").number(dimension), dimension,
                          "is not the critical damping of \"direct\"", "or remove \"direct\"");
    }
}

LawFit read_law_fit(const View& node, DampingLaw law) {
    const Dimension dimension = dimension_of(law);
    require_one_fit(node, dimension);
    const auto value = [&](const char* key) { return node.at(key).number(dimension); };
    const Quantity critical = node.at("critical_damping").quantity(dimension);
    LawFit fit{.damping = DampingPolynomial::quadratic(value("a"), value("b"), value("c")),
               .critical_damping = critical.value,
               .critical_damping_uncertainty = critical.standard_uncertainty,
               .covariance = read_if(node, "covariance", read_covariance)};
    at_place(node.at("critical_damping").pointer(),
             [&] { require_not_negative("critical damping", fit.critical_damping, dimension); });
    fit.method = read_if(node, "method", [](const View& name) { return named<FitMethod>(name.text()); });
    if (const auto origin = node.find("origin")) fit.origin = named<Origin>(origin->text());
    fit.residual_deviation = number_if(node, "residual_deviation", dimension);
    if (const auto degrees = node.find("degrees_of_freedom")) fit.degrees_of_freedom = degrees->integer();
    fit.points = count_if_any(node, "points");
    fit.points_beyond = count_if_any(node, "points_beyond_rising_branch");
    fit.restitution_range = read_if(node, "restitution_range", read_range);
    fit.extrapolated = read_if(node, "extrapolated", read_damping_fit);
    fit.estimate = read_if(node, "direct", read_damping_estimate);
    fit.comparison = read_if(node, "comparison", read_comparison);
    return fit;
}

}  // namespace

Json to_json(const FitResult& result, DampingLaw law) {
    return samples_json(result.samples, [&](const SampleFit& sample) {
        Json json{{"name", sample.name}};
        for (const auto& [each, fit] : sample.laws) json[std::string(each.name())] = law_fit_json(fit, law);
        return json;
    });
}

template <>
FitResult from_json<FitResult>(const View& result, DampingLaw law) {
    return {samples_of(result, [&](const View& node) {
        SampleFit sample{.name = node.at("name").text()};
        for_each_law(node, {"name"},
                     [&](Law each, const View& fit) { sample.laws.set(each, read_law_fit(fit, law)); });
        return sample;
    })};
}

}  // namespace ashimpact
