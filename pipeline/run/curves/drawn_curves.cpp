// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/curves/drawn_curves.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/text/error.hpp"
#include "pipeline/run/curves/model_curve.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact::curves {

namespace {

/// Curves end at so many times the greatest velocity of the impacts: a fit that needs more for the greatest
/// restitution would take the whole figure.
constexpr double beyond_impacts = 1.25;
constexpr int instants = 41;        ///< of a history that is drawn
constexpr int fine_instants = 641;  ///< of an impact at v_c, which may creep far longer than it is drawn
constexpr double shown_end = 1.02;  ///< of the time axis, in longest times of the other histories

/// One law of one sample; null where there is no such result.
struct CurveSources {
    const Sample* sample;
    LawChoice choice;
    const ContactPair* contact;
    const DampingSeries* damping;
    const LawFit* fit;
    const LawCriticalVelocity* velocity;
};

double greatest_in(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

/// Covariance of the coefficients; of a reconstructed series the rounding of the printed ones.
Eigen::MatrixXd covariance_of(const CurveSources& in) {
    const Eigen::Index count = in.fit->along_rising_branch().coefficients.size();
    const auto* plan =
        in.sample->restitution ? std::get_if<Reconstruction>(&*in.sample->restitution) : nullptr;
    if (plan != nullptr && plan->coefficient_uncertainty) {
        const double u = *plan->coefficient_uncertainty;
        return u * u * Eigen::MatrixXd::Identity(count, count);
    }
    if (in.fit->extrapolated) return in.fit->extrapolated->covariance;
    return Eigen::MatrixXd::Zero(count, count);
}

/// Where the curve begins: v_c of the extrapolated fit, else of the law [m/s].
std::optional<double> start_of(const CurveSources& in) {
    if (in.fit != nullptr && in.fit->extrapolated) return in.fit->extrapolated->critical_velocity.value;
    if (in.velocity == nullptr || !in.velocity->velocity) return std::nullopt;
    return in.velocity->velocity->value;
}

/// Impacts near the rising model curve: where it begins, and the points up to the greatest restitution.
std::vector<CurveKnot> knots_of(const CurveSources& in) {
    std::vector<CurveKnot> knots;
    if (const auto start = start_of(in); start && *start > 0) knots.push_back({0, *start});
    const std::vector<double>& e = in.damping->restitution;
    const std::vector<double>& v = in.damping->velocity;
    if (e.empty()) return knots;
    const double fastest = v[static_cast<std::size_t>(std::ranges::max_element(e) - e.begin())];
    for (std::size_t i = 0; i < v.size(); ++i)
        if (v[i] <= fastest) knots.push_back({e[i], v[i]});
    return knots;
}

ModelCurve curve_of(const Case& data, const CurveSources& in) {
    const bool known = in.velocity != nullptr && in.velocity->velocity;
    if (in.damping == nullptr || in.fit == nullptr || !known) return {};
    return model_curve({.choice = in.choice,
                        .damping_law = data.damping_law,
                        .contact = *in.contact,
                        .damping_fit = in.fit->along_rising_branch(),
                        .covariance = covariance_of(in),
                        .greatest_restitution = greatest_in(in.damping->restitution),
                        .greatest_velocity = beyond_impacts * greatest_in(in.damping->velocity),
                        .knots = knots_of(in)});
}

/// The middle one of the impacts beyond the rising branch.
std::optional<std::size_t> falling_point(const DampingSeries& series) {
    std::vector<std::size_t> beyond;
    for (std::size_t i = 0; i < series.velocity.size() && series.rising; ++i)
        if (series.velocity[i] > series.rising->to) beyond.push_back(i);
    if (beyond.empty()) return std::nullopt;
    return beyond[beyond.size() / 2];
}

/// The points up to a time, no more of them than are drawn.
std::vector<TrajectoryPoint> points_until(double time, const std::vector<TrajectoryPoint>& points) {
    const auto end =
        std::find_if(points.begin(), points.end(), [&](const TrajectoryPoint& p) { return p.time > time; });
    const auto count = static_cast<std::size_t>(end - points.begin());
    const std::size_t every = std::max<std::size_t>(1, count / static_cast<std::size_t>(instants));
    std::vector<TrajectoryPoint> kept;
    for (std::size_t i = 0; i < count; i += every) kept.push_back(points[i]);
    return kept;
}

/// The impact at v_c, and one of the falling branch.
std::vector<History> drawn_histories(const Case& data, const CurveSources& in) {
    std::vector<History> histories;
    const auto add = [&](HistoryPart part, double velocity, double damping, int points) {
        try {
            histories.push_back({.part = part,
                                 .velocity = velocity,
                                 .damping = damping,
                                 .trajectory = trajectory({.law = in.choice.law,
                                                           .detachment = in.choice.detachment,
                                                           .damping = {data.damping_law, damping},
                                                           .contact = *in.contact,
                                                           .velocity = velocity},
                                                          points)});
        } catch (const ConvergenceError&) {  // nothing to draw
            return;
        }
    };
    if (in.velocity != nullptr && in.velocity->velocity)
        add(HistoryPart::at_critical, in.velocity->velocity->value, in.velocity->damping, fine_instants);
    if (in.damping != nullptr)
        if (const auto point = falling_point(*in.damping))
            add(HistoryPart::falling, in.damping->velocity[*point], in.damping->damping[*point], instants);
    return histories;
}

/// Cuts the histories at v_c off where the others of the sample end.
void cut_off(const SampleHistories& sample, std::span<LawCurve> curves) {
    double longest = 0;
    const auto observe = [&](const std::vector<History>& histories) {
        for (const History& history : histories)
            if (history.part != HistoryPart::at_critical && !history.trajectory.empty())
                longest = std::max(longest, history.trajectory.back().time);
    };
    for (const auto& [law, histories] : sample.laws) observe(histories);
    for (const LawCurve& curve : curves) observe(curve.histories);
    for (LawCurve& curve : curves)
        for (History& history : curve.histories)
            if (history.part == HistoryPart::at_critical)
                history.trajectory = points_until(shown_end * longest, history.trajectory);
}

}  // namespace

void add_curves(const Case& data, const ContactResult& contacts, const DampingStageResult& dampings,
                const FitResult& fits, const CriticalVelocityResult& velocities, HistoriesResult& result) {
    std::vector<CurveSources> inputs;
    for (std::size_t i = 0; i < data.samples.size(); ++i)
        for (const LawChoice& choice : data.laws)
            inputs.push_back({.sample = &data.samples[i],
                              .choice = choice,
                              .contact = &contacts.samples[i].pair,
                              .damping = dampings.samples[i].laws.find(choice.law),
                              .fit = fits.samples[i].laws.find(choice.law),
                              .velocity = velocities.samples[i].laws.find(choice.law)});
    std::vector<std::size_t> order(inputs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // The slowest curves first, so that no core waits for one at the end.
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) {
        return is_cohesive(inputs[i].choice.law, *inputs[i].contact);
    });
    auto curves = in_parallel(order, [&](std::size_t i) -> LawCurve {
        return {start_of(inputs[i]), curve_of(data, inputs[i]), drawn_histories(data, inputs[i])};
    });
    std::vector<LawCurve> sorted(curves.size());
    for (std::size_t k = 0; k < order.size(); ++k) sorted[order[k]] = std::move(curves[k]);
    const std::size_t laws = data.laws.size();
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        cut_off(result.samples[i], std::span(sorted).subspan(i * laws, laws));
        for (std::size_t k = 0; k < laws; ++k)
            if (LawCurve& curve = sorted[i * laws + k]; !curve.impacts.empty() || !curve.histories.empty())
                result.samples[i].curves.set(data.laws[k].law, std::move(curve));
    }
}

}  // namespace ashimpact::curves
