// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "pipeline/run/dampings.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/inference/measured_damping.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

/// The law and impacts of one fit.
struct FitTask {
    const Case& data;
    const LawChoice& choice;
    const ContactPair& contact;
    const RestitutionSeries& measured;
    const DampingSeries& inverted;
    std::optional<double> rising_to;  ///< end of the rising branch; none: there is none [m/s]
    const OnsetEstimate* velocity;    ///< of the impacts, if it depends on no law
    ContactModels& models;

    [[nodiscard]] MeasuredDampingOptions options() const {
        MeasuredDampingOptions options = data.fit;
        // Without a rising branch nothing is extrapolated; the estimate takes every impact all the same.
        options.rising_to = rising_to.value_or(0.0);
        options.velocity = velocity;
        return options;
    }
};

/// The result of a fit, or the reasons why there is none.
using Fitted = ResultOfLaw<LawFit>;

std::vector<DampingPoint> rising_points(const FitTask& task) {
    const DampingSeries& series = task.inverted;
    std::vector<DampingPoint> points;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        if (series.velocity[i] <= *task.rising_to)
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
    const ContactModel model = task.models.model_for(task.choice, task.contact, task.measured.impacts);
    const MeasuredDamping found = analyse_impacts(model, task.measured.impacts, task.options());
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
    if (found.comparison && !found.comparison->consistent)
        fitted.findings.push_back({"fits-disagree", Severity::background, found.comparison->statement});
    return fitted;
}

/// Most velocities of a curve whose dampings are solved one by one.
constexpr std::size_t most_solved_dampings = 13;

/// An impact of the task whose damping by its law is sought.
DampingProblem damping_problem(const FitTask& task, double velocity, double restitution) {
    return {.law = task.choice.law,
            .detachment = task.choice.detachment,
            .damping_law = DampingLaw::constant,
            .contact = task.contact,
            .velocity = velocity,
            .restitution = restitution};
}

/// The least damping that captures at a velocity: the one whose v_c it is. @param guess of it, or 0 [kg/s]
double capturing_damping(const FitTask& task, double velocity, double guess) {
    const auto found = ashimpact::capturing_damping({.law = task.choice.law,
                                                     .detachment = task.choice.detachment,
                                                     .damping = {DampingLaw::constant, guess},
                                                     .contact = task.contact},
                                                    velocity);
    return found ? *found : damping_from_restitution(damping_problem(task, velocity, 0)).damping.coefficient;
}

/// Critical dampings at a critical velocity and the ends of its interval. @param similar those of a similar
/// law
Interval capturing_dampings(const FitTask& task, const Interval& velocity, const Interval& similar) {
    const auto at = [&](const std::optional<double>& end, const std::optional<double>& guess) {
        return end && *end > 0 ? std::optional(capturing_damping(task, *end, guess.value_or(0)))
                               : std::nullopt;
    };
    constexpr double up = 1 + 1e-4;
    const double value = capturing_damping(task, velocity.value, similar.value);
    const double slope = (capturing_damping(task, velocity.value * up, value) -
                          capturing_damping(task, velocity.value / up, value)) /
                         (velocity.value * (up - 1 / up));
    return {.value = value,
            .standard_uncertainty = slope * velocity.standard_uncertainty,
            .lower = at(velocity.lower, similar.lower),
            .upper = at(velocity.upper, similar.upper)};
}

/// The dampings by which the law of the task has the rebounds of a curve of another law, at some of its
/// velocities; none where one of them has no damping.
std::optional<EstimatedDamping> translated(const FitTask& task, const ContactModel& model,
                                           const EstimatedDamping& curve, double critical_damping) {
    if (curve.velocity.size() < 2) return std::nullopt;
    const std::size_t stride = 1 + (curve.velocity.size() - 2) / most_solved_dampings;
    std::vector<DampingProblem> problems;
    for (std::size_t i = curve.velocity.size() - 1; i > 0; i -= std::min(i, stride)) {
        const double restitution = model.restitution(curve.velocity[i], curve.damping[i]);
        if (!(restitution > 0)) break;
        problems.push_back(damping_problem(task, curve.velocity[i], restitution));
    }
    const Eigen::ArrayXd near = near_dampings(problems);
    EstimatedDamping own{{curve.velocity.front()}, {critical_damping}};
    for (std::size_t i = problems.size(); i-- > 0;) {
        const double guess = near[static_cast<Eigen::Index>(i)];
        try {
            own.damping.push_back(
                damping_from_restitution(problems[i], std::isnan(guess) ? std::nullopt : std::optional(guess))
                    .damping.coefficient);
        } catch (const InputError&) {
            return std::nullopt;
        }
        own.velocity.push_back(problems[i].velocity);
    }
    return own;
}

/// The estimate of a law that has no map of its own, from that of its similar law. What was measured is the
/// curve v_r(v_in). It ends at v_c whatever the law is, and the critical damping is the one that captures
/// there. None without such a law or estimate.
std::optional<Fitted> fit_by_similar_law(const FitTask& task) {
    const LawChoice similar{task.choice.law.similar(), task.choice.detachment};
    if (similar.law == task.choice.law || !has_contact_model(similar, task.data.damping_law, task.contact))
        return std::nullopt;
    const ContactModel model = task.models.model_for(similar, task.contact, task.measured.impacts);
    const MeasuredDamping found = analyse_impacts(model, task.measured.impacts, task.options());
    if (!found.estimate) return std::nullopt;
    DampingEstimate estimate = summary_of(*found.estimate);
    estimate.critical_damping =
        capturing_dampings(task, estimate.critical_velocity, estimate.critical_damping);
    if (estimate.curve)
        estimate.curve = translated(task, model, *estimate.curve, estimate.critical_damping.value);
    LawFit fit{.method = FitMethod::estimate, .origin = task.inverted.origin};
    set_constant_part(estimate.critical_damping, fit);
    fit.estimate = std::move(estimate);
    return Fitted{std::move(fit),
                  {{"estimate-of-similar-law", Severity::background,
                    fmt::format("v_c is the estimate by {}, whose impacts are nearly the same; c is the "
                                "damping of {} that captures there, a and b are 0",
                                similar.law.name(), task.choice.law.name())}}};
}

Fitted fit_law(const FitTask& task) {
    if (task.inverted.origin == Origin::measured) {
        if (has_contact_model(task.choice, task.data.damping_law, task.contact))
            return fit_through_model(task);
        if (auto fitted = fit_by_similar_law(task)) return *std::move(fitted);
    }
    return task.rising_to ? fit_by_least_squares(task) : Fitted{};
}

/// v_c as the impacts of a series tell it to every law that is fitted through a model; none if it depends on
/// the law, or if it does not exist, which each law then reports.
std::optional<OnsetEstimate> estimate_without_law_of(const Case& data, const ContactPair& contact,
                                                     const RestitutionSeries& series) {
    const bool used = series.origin == Origin::measured && series.impacts.rebounds() > 0 &&
                      std::ranges::any_of(data.laws, [&](const LawChoice& choice) {
                          return has_contact_model(choice, data.damping_law, contact);
                      });
    if (!used) return std::nullopt;
    try {
        return estimate_without_law(series.impacts, data.fit.estimate);
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const ConvergenceError&) {
        return std::nullopt;
    }
}

}  // namespace

FitResult fit_stage(const Case& data, const ContactResult& contacts, const RestitutionResult& restitutions,
                    const DampingStageResult& dampings, ContactModels& models, StageRecord& record) {
    record.citations = {"dong2013, section 4.3, Tables 2 and 3"};
    FitResult result;
    for (std::size_t i = 0; i < dampings.samples.size(); ++i) {
        const SampleDamping& sample = dampings.samples[i];
        const SampleRestitution& restitution = restitutions.samples[i];
        const auto velocities = in_parallel(restitution.series, [&](const RestitutionSeries& series) {
            return estimate_without_law_of(data, contacts.samples[i].pair, series);
        });
        const auto fit = [&](const LawChoice& choice) -> Fitted {
            const DampingSeries* inverted = sample.laws.find(choice.law);
            const RestitutionSeries* measured = restitution.of(choice.law);
            if (inverted == nullptr || measured == nullptr) return {};
            const auto& velocity = velocities[static_cast<std::size_t>(measured - restitution.series.data())];
            const auto rising_to = inverted->rising ? std::optional(inverted->rising->to) : std::nullopt;
            return fit_law({data, choice, contacts.samples[i].pair, *measured, *inverted, rising_to,
                            velocity ? &*velocity : nullptr, models});
        };
        result.samples.push_back({sample.name, results_by_law<LawFit>(data, sample.name, record, fit)});
    }
    return result;
}

}  // namespace ashimpact
