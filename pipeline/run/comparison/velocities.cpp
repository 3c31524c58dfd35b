// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/velocities.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "solver/batch/parallel.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/impacts/inverted_impacts.hpp"
#include "solver/motion/impact.hpp"
#include "solver/numeric/gsl/interpolation.hpp"

namespace ashimpact {

namespace {

/// Damping over velocity of one sample by one law.
struct DampingOverVelocity {
    const SampleContact* sample;
    LawChoice choice;
    SeriesRange range;
    std::function<double(double)> damping;  ///< within the range
};

/// The smooth curve of measured impacts; none where they are too few for one.
std::optional<DampingSmoothing> smoothed(const DampingSeries& series) {
    std::vector<InvertedImpact> impacts;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        impacts.push_back({.index = i,
                           .velocity = series.velocity[i],
                           .restitution = series.restitution[i],
                           .damping = series.damping[i]});
    return DampingSmoothing::of(impacts);
}

/// The curve through the points, those of one velocity averaged; none through fewer than three.
std::optional<MeasuredCurve> interpolated(const DampingSeries& series) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        points.emplace_back(series.velocity[i], series.damping[i]);
    std::sort(points.begin(), points.end());
    std::vector<double> velocity;
    std::vector<double> damping;
    for (std::size_t i = 0; i < points.size();) {
        double sum = 0.0;
        std::size_t same = i;
        for (; same < points.size() && points[same].first == points[i].first; ++same)
            sum += points[same].second;
        velocity.push_back(points[i].first);
        damping.push_back(sum / static_cast<double>(same - i));
        i = same;
    }
    if (velocity.size() < 3) return std::nullopt;
    return MeasuredCurve(velocity, damping);
}

std::optional<DampingOverVelocity> damping_over_velocity(const SampleContact& sample, const LawChoice& choice,
                                                         const DampingSeries& damping) {
    if (damping.origin == Origin::measured)
        if (auto smooth = smoothed(damping)) {
            const auto curve = std::make_shared<DampingSmoothing>(std::move(*smooth));
            return DampingOverVelocity{
                &sample, choice, {curve->slowest(), curve->fastest()}, [curve](double v) {
                    return curve->at(v).damping;
                }};
        }
    if (auto through = interpolated(damping)) {
        const auto curve = std::make_shared<MeasuredCurve>(std::move(*through));
        return DampingOverVelocity{
            &sample, choice, {curve->lower(), curve->upper()}, [curve](double v) { return (*curve)(v); }};
    }
    return std::nullopt;
}

/// A sample by a law at a velocity; none where no impact rebounds with the damping there.
std::optional<ImpactAtVelocity> impact_at(const DampingOverVelocity& series, DampingLaw damping_law,
                                          double velocity) {
    const double damping = series.damping(velocity);
    if (!(damping >= 0.0)) return std::nullopt;
    const ImpactResult impact = solve_impact({.law = series.choice.law,
                                              .detachment = series.choice.detachment,
                                              .damping = {damping_law, damping},
                                              .contact = series.sample->pair,
                                              .velocity = velocity});
    if (impact.outcome != Outcome::rebound) return std::nullopt;
    return ImpactAtVelocity{series.choice.law, series.sample->name, impact.restitution,
                            damping,           impact.contact_time, impact.maximum_overlap};
}

}  // namespace

std::vector<double> shared_velocities(const std::vector<SeriesRange>& ranges) {
    if (ranges.size() < 2) return {};
    double slowest = ranges.front().slowest;
    double fastest = ranges.front().fastest;
    for (const SeriesRange& range : ranges) {
        slowest = std::min(slowest, range.slowest);
        fastest = std::max(fastest, range.fastest);
    }
    const auto first = static_cast<int>(std::floor(std::log10(slowest)));
    const auto last = static_cast<int>(std::floor(std::log10(fastest)));
    std::vector<double> shared;
    const std::vector<std::vector<double>> steps{
        {1, 2, 5}, {1, 1.5, 2, 3, 4, 5, 6, 8}, {1, 1.2, 1.4, 1.6, 1.8, 2,   2.5, 3,   3.5, 4,  4.5,
                                                5, 5.5, 6,   6.5, 7,   7.5, 8,   8.5, 9,   9.5}};
    for (const std::vector<double>& step : steps) {
        shared.clear();
        for (int decade = first; decade <= last; ++decade)
            for (const double digit : step) {
                // A division gives the decimal number as it is read: 3/10 is 0.3, 3 * 0.1 is not.
                const double power = std::pow(10.0, std::abs(decade));
                const double v = decade < 0 ? digit / power : digit * power;
                const auto within = std::count_if(
                    ranges.begin(), ranges.end(),
                    [&](const SeriesRange& range) { return v >= range.slowest && v <= range.fastest; });
                if (within >= 2) shared.push_back(v);
            }
        if (shared.size() >= 5) break;
    }
    return shared;
}

std::vector<EqualVelocity> equal_velocities(const Case& data, const ContactResult& contacts,
                                            const DampingStageResult& dampings) {
    std::vector<DampingOverVelocity> all;
    std::vector<SeriesRange> ranges;
    for (const LawChoice& choice : data.laws)
        for (std::size_t i = 0; i < dampings.samples.size(); ++i) {
            const DampingSeries* damping = dampings.samples[i].laws.find(choice.law);
            if (damping == nullptr) continue;
            auto series = damping_over_velocity(contacts.samples[i], choice, *damping);
            if (series && series->range.slowest > 0.0) {
                ranges.push_back(series->range);
                all.push_back(std::move(*series));
            }
        }
    auto rows = in_parallel(shared_velocities(ranges), [&](double velocity) {
        EqualVelocity equal{.velocity = velocity};
        for (const DampingOverVelocity& series : all) {
            if (velocity < series.range.slowest || velocity > series.range.fastest) continue;
            if (auto impact = impact_at(series, data.damping_law, velocity))
                equal.impacts.push_back(std::move(*impact));
        }
        return equal;
    });
    std::erase_if(rows, [](const EqualVelocity& equal) { return equal.impacts.size() < 2; });
    return rows;
}

}  // namespace ashimpact
