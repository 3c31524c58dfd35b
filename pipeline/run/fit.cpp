// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/checks.hpp"
#include "pipeline/document/damping_fit_json.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/document/statistics_json.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/damping.hpp"
#include "pipeline/run/for_each_law.hpp"
#include "pipeline/run/in_parallel.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "pipeline/run/restitution.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/calibration/damping_fit.hpp"
#include "solver/inference/measured_damping.hpp"

namespace ashimpact {

namespace {

/// The law and impacts of one fit.
struct FitTask {
    const Case& data;
    const LawChoice& choice;
    const ContactPair& contact;
    const RestitutionSeries& measured;
    const DampingSeries& inverted;
    double rising_to;  ///< end of the rising branch [m/s]
};

/// The result of a fit, or the reasons why there is none.
struct Fitted {
    Json json = nullptr;
    std::vector<std::string> notes{};
};

std::vector<DampingPoint> rising_points(const FitTask& task) {
    const DampingSeries& series = task.inverted;
    std::vector<DampingPoint> points;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        if (series.velocity[i] <= task.rising_to)
            points.push_back({.restitution = series.restitution[i],
                              .damping = series.damping[i],
                              .standard_uncertainty = 0});
    return points;
}

/// {"a", "b", "c"} with the covariance in that order. @param ascending, covariance: of c, b, a
Json quadratic_fit_json(const Eigen::Vector3d& ascending, const Eigen::Matrix3d& covariance,
                        double critical_damping_uncertainty, const std::string& unit) {
    const auto coefficient = [&](Eigen::Index power) {
        Json json = quantity_json(ascending[power], unit);
        json["standard_uncertainty"] = std::sqrt(std::max(0.0, covariance(power, power)));
        return json;
    };
    Json critical = quantity_json(ascending[0], unit);
    critical["standard_uncertainty"] = critical_damping_uncertainty;
    return {{"a", coefficient(2)},
            {"b", coefficient(1)},
            {"c", coefficient(0)},
            {"critical_damping", critical},
            {"covariance",
             {{"parameters", {"a", "b", "c"}},
              {"values", matrix_json(covariance.reverse())},
              {"unit", fmt::format("({})2", unit)}}}};
}

/// By least squares of the damping on the restitution.
Fitted fit_by_least_squares(const FitTask& task) {
    const auto points = rising_points(task);
    std::set<double> distinct;
    for (const DampingPoint& point : points) distinct.insert(point.restitution);
    if (distinct.size() < 3)
        return {nullptr, {"a quadratic needs three different restitutions on the rising branch"}};
    const DampingFit fit = fit_damping(points);
    const std::string unit(unit_of(task.data.damping_law));
    if (fit.damping.critical_damping() < 0)
        return {
            nullptr,
            {"no fit: the critical damping would be negative, so the data do not say where capture begins"}};
    const double rounding = task.measured.coefficient_uncertainty.value_or(0);
    const double deviation = std::sqrt(std::max(0.0, fit.covariance(0, 0)));
    Json json =
        quadratic_fit_json(fit.damping.coefficients, fit.covariance, std::hypot(deviation, rounding), unit);
    json["method"] = "least-squares";
    json["residual_deviation"] = quantity_json(fit.residual_deviation, unit);
    json["degrees_of_freedom"] = fit.degrees_of_freedom;
    json["points"] = points.size();
    json["points_beyond_rising_branch"] = task.inverted.velocity.size() - points.size();
    json["restitution_range"] = {*distinct.begin(), *distinct.rbegin()};
    json["origin"] = task.inverted.origin;
    return {json};
}

/// The powers up to the second with their covariance.
Json quadratic_part(const DampingCurveFit& fit) {
    Eigen::Vector3d values = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    const Eigen::Index count = std::min<Eigen::Index>(3, fit.damping.order() + 1);
    values.head(count) = fit.damping.coefficients.head(count);
    covariance.topLeftCorner(count, count) = fit.covariance.topLeftCorner(count, count);
    return quadratic_fit_json(values, covariance, fit.critical_damping.standard_uncertainty, "kg/s");
}

/// The critical damping of the estimate as a constant damping, for impacts that allow no extrapolation.
Json constant_part(const Interval& critical_damping) {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    covariance(0, 0) = std::pow(critical_damping.standard_uncertainty, 2);
    return quadratic_fit_json({critical_damping.value, 0, 0}, covariance,
                              critical_damping.standard_uncertainty, "kg/s");
}

/// By analyse_impacts(), through the dynamic model.
Fitted fit_through_model(const FitTask& task) {
    const FitChoices& choices = task.data.fit;
    MeasuredDampingOptions options;
    options.parts = {.flatness = choices.flatness, .outlier = choices.outlier};
    options.extrapolated = {.order = choices.order, .robust = choices.robust};
    options.size_scatter = choices.size_scatter;
    options.rising_to = task.rising_to;
    const ContactModel model = contact_model_for(task.choice, task.contact, task.measured.impacts);
    const MeasuredDamping found = analyse_impacts(model, task.measured.impacts, options);
    Fitted fitted{};
    fitted.notes = texts_of(found.findings);
    if (!found.extrapolated && !found.estimate) return fitted;
    if (found.extrapolated) {
        const DampingCurveFit& fit = *found.extrapolated;
        std::vector<std::size_t> numbers;
        for (const std::size_t index : found.rising->indices) numbers.push_back(index + 1);
        fitted.json = quadratic_part(fit);
        fitted.json["method"] = "closest-curve";
        fitted.json["degrees_of_freedom"] = fit.degrees_of_freedom;
        fitted.json["points"] = fit.rebounds.size();
        fitted.json["points_beyond_rising_branch"] =
            task.measured.impacts.points.size() - found.rising->set.points.size();
        fitted.json["restitution_range"] = {fit.restitutions[0], fit.restitutions[1]};
        fitted.json["extrapolated"] = damping_fit_json(fit, numbers);
    } else {
        fitted.json = constant_part(found.estimate->curve.critical_damping);
        fitted.json["method"] = "estimate";
        fitted.notes.emplace_back(
            "nothing can be extrapolated: c is the critical damping of the estimate, a and b are 0");
    }
    fitted.json["origin"] = task.inverted.origin;
    if (found.estimate) fitted.json["direct"] = damping_estimate_json(*found.estimate);
    if (found.comparison) {
        fitted.json["comparison"] = comparison_json(*found.comparison);
        if (found.comparison->exclude_one_another) fitted.notes.push_back(found.comparison->statement);
    }
    return fitted;
}

Fitted fit_law(const FitTask& task) {
    const bool measured = task.inverted.origin == "measured";
    return measured && has_contact_model(task.choice, task.data.damping_law, task.contact)
               ? fit_through_model(task)
               : fit_by_least_squares(task);
}

}  // namespace

StageOutput fit_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    StageOutput output{.citations = {"dong2013, section 4.3, Tables 2 and 3"}};
    output.options = {
        {"order", data.fit.order},
        {"robust", data.fit.robust},
        {"measured",
         "closest curve in the plane of both velocities; the estimate from all impacts beside it"},
        {"reconstructed", "least squares, quadratic, equal weights"}};
    output.result["samples"] = Json::array();
    const auto read = [&](const View& result) {
        return read_dampings(result, dimension_of(data.damping_law));
    };
    const auto contacts = before.read(contact_artifact, read_contacts);
    const auto restitutions = before.read(restitution_artifact, read_restitutions);
    for (const SampleDamping& sample : before.read(damping_artifact, read)) {
        const SampleContact& contact = entry_named(contacts, sample.name, before, contact_artifact);
        const SampleRestitution& series =
            entry_named(restitutions, sample.name, before, restitution_artifact);
        Json json{{"name", sample.name}};
        const auto fits = in_parallel(data.laws, [&](const LawChoice& choice) -> Fitted {
            const DampingSeries* inverted = sample.laws.find(choice.law);
            const RestitutionSeries* measured = series.of(choice.law);
            if (inverted == nullptr || measured == nullptr || !inverted->rising_to) return {};
            return fit_law({data, choice, contact.pair, *measured, *inverted, *inverted->rising_to});
        });
        for (std::size_t i = 0; i < fits.size(); ++i) {
            const std::string law(data.laws[i].law.name());
            for (const std::string& note : fits[i].notes)
                output.warnings.push_back(fmt::format("{}, {}: {}", sample.name, law, note));
            if (!fits[i].json.is_null()) json[law] = fits[i].json;
        }
        output.result["samples"].push_back(std::move(json));
    }
    return output;
}

namespace {

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

}  // namespace

std::vector<SampleFit> read_fits(const View& result, Dimension dimension) {
    std::vector<SampleFit> samples;
    for (const View& sample : result.at("samples").elements()) {
        SampleFit entry{.name = sample.at("name").text(), .laws = {}};
        for_each_law(sample, {"name"}, [&](Law law, const View& node) {
            const auto value = [&](const char* key) { return node.at(key).number(dimension); };
            require_one_fit(node, dimension);
            LawFit fit{DampingPolynomial::quadratic(value("a"), value("b"), value("c")),
                       value("critical_damping")};
            at_place(node.at("critical_damping").pointer(),
                     [&] { require_not_negative("critical damping", fit.critical_damping, dimension); });
            fit.critical_damping_uncertainty =
                node.at("critical_damping").quantity(dimension).standard_uncertainty;
            if (const auto curve = node.find("extrapolated")) fit.extrapolated = read_damping_fit(*curve);
            if (const auto estimate = node.find("direct")) fit.estimate = read_critical_damping(*estimate);
            entry.laws.set(law, std::move(fit));
        });
        samples.push_back(std::move(entry));
    }
    return samples;
}

}  // namespace ashimpact
