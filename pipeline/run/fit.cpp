// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "pipeline/run/stage.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/calibration/published_damping.hpp"
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
    ContactModels& models;
};

/// The result of a fit, or the reasons why there is none.
using Fitted = ResultOfLaw<LawFit>;

std::vector<DampingPoint> rising_points(const FitTask& task) {
    const DampingSeries& series = task.inverted;
    std::vector<DampingPoint> points;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        if (series.velocity[i] <= task.rising_to)
            points.push_back({.restitution = series.restitution[i],
                              .damping = series.damping[i],
                              .standard_uncertainty = 0});
    std::ranges::sort(points, {}, [](const auto& p) { return std::pair(p.restitution, p.damping); });
    return points;
}

/// By least squares of the damping on the restitution.
Fitted fit_by_least_squares(const FitTask& task) {
    const auto points = rising_points(task);
    std::set<double> distinct;
    for (const DampingPoint& point : points) distinct.insert(point.restitution);
    if (distinct.size() < 3)
        return {{},
                {{"too-few-restitutions", Severity::doubt,
                  "a quadratic needs three different restitutions on the rising branch"}}};
    const DampingFit fit = fit_damping(points);
    if (fit.damping.critical_damping() < 0)
        return {{},
                {{"no-fit", Severity::doubt,
                  "no fit: the critical damping would be negative, so the data do not say where capture "
                  "begins"}}};
    const double rounding = task.measured.coefficient_uncertainty.value_or(0);
    const double deviation = std::sqrt(std::max(0.0, fit.covariance(0, 0)));
    return {LawFit{.damping = fit.damping,
                   .critical_damping = fit.damping.critical_damping(),
                   .critical_damping_uncertainty = std::hypot(deviation, rounding),
                   .covariance = fit.covariance,
                   .method = FitMethod::least_squares,
                   .origin = task.inverted.origin,
                   .residual_deviation = fit.residual_deviation,
                   .degrees_of_freedom = static_cast<int>(fit.degrees_of_freedom),
                   .points = points.size(),
                   .points_beyond = task.inverted.velocity.size() - points.size(),
                   .restitution_range = std::array{*distinct.begin(), *distinct.rbegin()}}};
}

/// The powers up to the second with their covariance.
void set_quadratic_part(const DampingCurveFit& curve, LawFit& fit) {
    Eigen::Vector3d values = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    const Eigen::Index count = std::min<Eigen::Index>(3, curve.damping.order() + 1);
    values.head(count) = curve.damping.coefficients.head(count);
    covariance.topLeftCorner(count, count) = curve.covariance.topLeftCorner(count, count);
    fit.damping = {values};
    fit.critical_damping = values[0];
    fit.critical_damping_uncertainty = curve.critical_damping.standard_uncertainty;
    fit.covariance = covariance;
}

/// The critical damping of the estimate as a constant damping, for impacts that allow no extrapolation.
void set_constant_part(const Interval& critical_damping, LawFit& fit) {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    covariance(0, 0) = std::pow(critical_damping.standard_uncertainty, 2);
    fit.damping = {Eigen::Vector3d(critical_damping.value, 0, 0)};
    fit.critical_damping = critical_damping.value;
    fit.critical_damping_uncertainty = critical_damping.standard_uncertainty;
    fit.covariance = covariance;
}

/// By analyse_impacts(), through the dynamic model.
Fitted fit_through_model(const FitTask& task) {
    MeasuredDampingOptions options = task.data.fit;
    options.rising_to = task.rising_to;
    const ContactModel model = task.models.model_for(task.choice, task.contact, task.measured.impacts);
    const MeasuredDamping found = analyse_impacts(model, task.measured.impacts, options);
    Fitted fitted{{}, found.findings};
    if (!found.extrapolated && !found.estimate) return fitted;
    LawFit& fit = fitted.value.emplace();
    fit.origin = task.inverted.origin;
    if (found.extrapolated) {
        const DampingCurveFit& curve = *found.extrapolated;
        set_quadratic_part(curve, fit);
        fit.method = FitMethod::closest_curve;
        fit.degrees_of_freedom = curve.degrees_of_freedom;
        fit.points = curve.rebounds.size();
        fit.points_beyond = task.measured.impacts.points.size() - found.rising->set.points.size();
        fit.restitution_range = curve.restitutions;
        fit.extrapolated = with_indices(curve, found.rising->indices);
    } else {
        set_constant_part(found.estimate->curve.critical_damping, fit);
        fit.method = FitMethod::estimate;
        fitted.findings.push_back(
            {"nothing-extrapolated", Severity::remark,
             "nothing can be extrapolated: c is the critical damping of the estimate, a and b are 0"});
    }
    if (found.estimate) fit.estimate = summary_of(*found.estimate);
    fit.comparison = found.comparison;
    if (found.comparison && found.comparison->exclude_one_another)
        fitted.findings.push_back({"fits-disagree", Severity::background, found.comparison->statement});
    return fitted;
}

Fitted fit_law(const FitTask& task) {
    const bool measured = task.inverted.origin == Origin::measured;
    return measured && has_contact_model(task.choice, task.data.damping_law, task.contact)
               ? fit_through_model(task)
               : fit_by_least_squares(task);
}

}  // namespace

FitResult fit_stage(const Case& data, const ContactResult& contacts, const RestitutionResult& restitutions,
                    const DampingStageResult& dampings, ContactModels& models, StageRecord& record) {
    record.citations = {"dong2013, section 4.3, Tables 2 and 3"};
    FitResult result;
    for (std::size_t i = 0; i < dampings.samples.size(); ++i) {
        const SampleDamping& sample = dampings.samples[i];
        const auto fit = [&](const LawChoice& choice) -> Fitted {
            const DampingSeries* inverted = sample.laws.find(choice.law);
            const RestitutionSeries* measured = restitutions.samples[i].of(choice.law);
            if (inverted == nullptr || measured == nullptr || !inverted->rising) return {};
            return fit_law(
                {data, choice, contacts.samples[i].pair, *measured, *inverted, inverted->rising->to, models});
        };
        result.samples.push_back({sample.name, results_by_law<LawFit>(data, sample.name, record, fit)});
    }
    return result;
}

}  // namespace ashimpact
