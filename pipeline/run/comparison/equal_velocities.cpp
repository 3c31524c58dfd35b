// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/equal_velocities.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "pipeline/document/quantity_json.hpp"
#include "pipeline/run/in_parallel.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/impacts/damping_smoothing.hpp"
#include "solver/motion/impact.hpp"
#include "solver/numeric/gsl/spline.hpp"

namespace ashimpact {

namespace {

/// Damping over velocity of one sample by one law.
struct Series {
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

std::optional<Series> series_of(const SampleContact& sample, const LawChoice& choice,
                                const DampingSeries& damping) {
    if (damping.origin == "measured")
        if (auto smooth = smoothed(damping)) {
            const auto curve = std::make_shared<DampingSmoothing>(std::move(*smooth));
            return Series{&sample, choice, {curve->slowest(), curve->fastest()}, [curve](double v) {
                              return curve->at(v).damping;
                          }};
        }
    if (auto through = interpolated(damping)) {
        const auto curve = std::make_shared<MeasuredCurve>(std::move(*through));
        return Series{
            &sample, choice, {curve->lower(), curve->upper()}, [curve](double v) { return (*curve)(v); }};
    }
    return std::nullopt;
}

/// One row: a sample by a law at a velocity; null where no impact rebounds with the damping there.
Json row_json(const Series& series, DampingLaw damping_law, double velocity) {
    const double damping = series.damping(velocity);
    if (!(damping >= 0.0)) return nullptr;
    const ImpactResult impact = solve_impact({.law = series.choice.law,
                                              .detachment = series.choice.detachment,
                                              .damping = {damping_law, damping},
                                              .contact = series.sample->pair,
                                              .velocity = velocity});
    if (impact.outcome != Outcome::rebound) return nullptr;
    return {{"law", series.choice.law.name()},
            {"sample", series.sample->name},
            {"restitution", quantity_json(impact.restitution, Dimension::fraction)},
            {"damping", quantity_json(damping, dimension_of(damping_law))},
            {"contact_time", quantity_json(impact.contact_time, Dimension::time)},
            {"maximum_overlap", quantity_json(impact.maximum_overlap, Dimension::length)}};
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

Json equal_velocities_json(const Case& data, const std::vector<SampleContact>& contacts,
                           const std::vector<SampleDamping>& dampings) {
    std::vector<Series> all;
    std::vector<SeriesRange> ranges;
    for (const LawChoice& choice : data.laws)
        for (const SampleDamping& sample : dampings) {
            const DampingSeries* damping = sample.laws.find(choice.law);
            const auto contact = std::find_if(contacts.begin(), contacts.end(),
                                              [&](const auto& entry) { return entry.name == sample.name; });
            if (damping == nullptr || contact == contacts.end()) continue;
            auto series = series_of(*contact, choice, *damping);
            if (series && series->range.slowest > 0.0) {
                ranges.push_back(series->range);
                all.push_back(std::move(*series));
            }
        }
    const auto entries = in_parallel(shared_velocities(ranges), [&](double velocity) -> Json {
        Json rows = Json::array();
        for (const Series& series : all) {
            if (velocity < series.range.slowest || velocity > series.range.fastest) continue;
            if (Json row = row_json(series, data.damping_law, velocity); !row.is_null())
                rows.push_back(std::move(row));
        }
        return {{"velocity", quantity_json(velocity, Dimension::velocity)}, {"impacts", rows}};
    });
    Json list = Json::array();
    for (const Json& entry : entries)
        if (entry.at("impacts").size() >= 2) list.push_back(entry);
    return list;
}

}  // namespace ashimpact
