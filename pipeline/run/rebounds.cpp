// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/rebounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "pipeline/run/sizes.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

constexpr int solved_sizes = 16;
constexpr int solved_velocities = 48;          ///< of a size
constexpr double slowest_without_v_c = 0.01;   ///< where nothing is captured, over the fastest impact
constexpr std::size_t means_of_rebounds = 10;  ///< of a sample

/// Place of a velocity above v_c, 0 up to it [1].
double place_above_critical(double velocity, double critical) {
    return velocity > critical ? std::sqrt(std::log(velocity / critical)) : 0;
}

/// Restitution of a size, linear between its points and that of the last one beyond.
struct SizeRebounds {
    double diameter = 0;
    std::vector<std::pair<double, double>> points{};  ///< place and restitution, rising

    [[nodiscard]] double operator()(double place) const {
        const auto above = std::ranges::lower_bound(points, place, {}, &std::pair<double, double>::first);
        if (above == points.begin()) return points.front().second;
        if (above == points.end()) return points.back().second;
        const auto& below = above[-1];
        const double part = (place - below.first) / (above->first - below.first);
        return below.second + part * (above->second - below.second);
    }
};
using KnownRebounds = std::shared_ptr<const std::vector<SizeRebounds>>;

/// The restitution of a size, from those around it.
RestitutionOfVelocity between_known(const KnownRebounds& known, double diameter, double critical) {
    if (known->empty() || !(critical > 0))
        return [](double) { return std::numeric_limits<double>::quiet_NaN(); };
    const auto above = std::ranges::lower_bound(*known, diameter, {}, &SizeRebounds::diameter);
    const SizeRebounds& upper = above == known->end() ? known->back() : *above;
    const SizeRebounds& lower = above == known->begin() || above == known->end() ? upper : above[-1];
    const double part = &lower == &upper
                            ? 1
                            : std::log(diameter / lower.diameter) / std::log(upper.diameter / lower.diameter);
    return [known, &lower, &upper, part, critical](double velocity) {
        const double place = place_above_critical(velocity, critical);
        return (1 - part) * lower(place) + part * upper(place);
    };
}

/// The impacts of one size, from its own critical velocity on; none if all are captured.
/// @throws InputError if faster ones up to @p fastest are captured again
std::optional<SizeRebounds> solved_rebounds(double diameter, double fastest, Impact impact) {
    try {
        const CriticalVelocityProblem problem{impact.law, impact.detachment, impact.damping, impact.contact};
        const CriticalVelocity critical =
            impact.law.is_plastic() ? critical_velocity(problem) : quick_critical_velocity(problem);
        if (critical.verdict == CaptureVerdict::always_captured) return std::nullopt;
        const double from = critical.value.value_or(slowest_without_v_c * fastest);
        for (const double again : critical.crossings)
            if (again > from && again <= fastest)
                throw InputError(
                    fmt::format("{} spheres stick below {} and again above {}", readable(diameter, "m"),
                                readable(from, "m/s"), readable(again, "m/s")),
                    "a slower gas, or sizes and a law with one critical velocity each");
        SizeRebounds rebounds{.diameter = diameter};
        const double last = place_above_critical(std::max(fastest, 2 * from), from);
        for (int i = 0; i <= solved_velocities; ++i) {
            const double place = last * i / solved_velocities;
            impact.velocity = from * std::exp(place * place);
            rebounds.points.emplace_back(place, i == 0 && critical.value ? 0 : restitution_of(impact));
        }
        return rebounds;
    } catch (const ConvergenceError&) {
        return std::nullopt;
    }
}

/// Means of neighbouring rebounds of a sample above its critical velocity.
SizeRebounds measured_rebounds(const MeasurementSet& impacts, double diameter, double critical) {
    std::vector<std::pair<double, double>> points;
    for (const Measurement& impact : impacts.points)
        if (!impact.captured() && impact.velocity > critical)
            points.emplace_back(place_above_critical(impact.velocity, critical), impact.restitution());
    std::ranges::sort(points);
    SizeRebounds rebounds{.diameter = diameter, .points = {{0, 0}}};
    const std::size_t count = std::min(means_of_rebounds, points.size());
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t from = k * points.size() / count;
        const std::size_t to = (k + 1) * points.size() / count;
        std::pair<double, double> mean{0, 0};
        for (std::size_t i = from; i < to; ++i) {
            mean.first += points[i].first / static_cast<double>(to - from);
            mean.second += points[i].second / static_cast<double>(to - from);
        }
        rebounds.points.push_back(mean);
    }
    return rebounds;
}

/// The measured rebounds of a run by its reported law, of each size.
std::vector<SizeRebounds> sample_rebounds(const Run& run) {
    std::vector<SizeRebounds> known;
    for (std::size_t i = 0; i < run.contact.samples.size() && i < run.restitution.samples.size(); ++i) {
        const double diameter = 2 * run.contact.samples[i].radius.value;
        const RestitutionSeries* series = run.restitution.samples[i].of(run.comparison.sizes->law);
        const auto row = std::ranges::find_if(run.comparison.by_size, [&](const SizeVelocity& each) {
            return each.basis == SizeBasis::measured && each.velocity &&
                   std::abs(each.diameter / diameter - 1) < 1e-9;
        });
        if (series == nullptr || row == run.comparison.by_size.end()) continue;
        known.push_back(measured_rebounds(series->impacts, diameter, *row->velocity));
        if (known.back().points.size() == 1) known.pop_back();
    }
    std::ranges::sort(known, {}, &SizeRebounds::diameter);
    return known;
}

/// The constants of an assumption.
struct AssumedDamping {
    DampingLaw law{};
    std::vector<std::pair<std::string, Quantity>> constants{};
    std::optional<PowerOfDiameter> power{};

    /// The damping of a size; its further constants go into the contact.
    [[nodiscard]] Damping of(double diameter, ContactPair& contact) const {
        if (power)
            return {law, power->damping.value * std::pow(diameter / power->diameter, power->exponent.value)};
        for (std::size_t k = 1; k < constants.size(); ++k)
            contact.parameters.set(constants[k].first, constants[k].second.value);
        return {law, constants.empty() ? 0 : constants.front().second.value};
    }
};

/// None where the run does not state the constants.
std::optional<AssumedDamping> assumed_damping(const Run& run, SizeBasis basis) {
    const SizeSummary& sizes = *run.comparison.sizes;
    if (basis == SizeBasis::adhesion) return AssumedDamping{};
    if (basis == SizeBasis::power_of_size) {
        if (!sizes.power) return std::nullopt;
        return AssumedDamping{run.data.damping_law, {}, sizes.power};
    }
    const auto law = named<DampingLaw>(name_of(basis));
    if (sizes.constants == ConstantsFrom::impacts && run.comparison.dampings)
        for (const ComparedDamping& each : run.comparison.dampings->laws)
            if (each.law == law && !each.constants.empty()) return AssumedDamping{law, each.constants, {}};
    for (const auto& [name, coefficient] : sizes.coefficients)
        if (name == name_of(law) && has_one_number(law))
            return AssumedDamping{law, {{"damping", coefficient}}, {}};
    return std::nullopt;
}

}  // namespace

std::vector<RestitutionOfVelocity> restitutions_by_law(
    const ReboundingSizes& sizes, const std::function<Impact(double diameter)>& impact_of) {
    std::vector<double> rebounding;
    for (std::size_t i = 0; i < sizes.diameters.size(); ++i)
        if (sizes.critical[i] < sizes.fastest) rebounding.push_back(sizes.diameters[i]);
    std::vector<double> chosen;
    for (std::size_t k = 0; k < solved_sizes && !rebounding.empty(); ++k)
        chosen.push_back(rebounding[k * (rebounding.size() - 1) / (solved_sizes - 1)]);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    const auto solved = in_parallel(chosen, [&](double diameter) {
        return solved_rebounds(diameter, sizes.fastest, impact_of(diameter));
    });
    std::vector<SizeRebounds> found;
    for (const auto& each : solved)
        if (each) found.push_back(*each);
    const auto known = std::make_shared<const std::vector<SizeRebounds>>(std::move(found));
    std::vector<RestitutionOfVelocity> all;
    for (std::size_t i = 0; i < sizes.diameters.size(); ++i)
        all.push_back(
            between_known(known, sizes.diameters[i],
                          sizes.critical[i] > 0 ? sizes.critical[i] : slowest_without_v_c * sizes.fastest));
    return all;
}

std::function<Impact(double diameter)> assumed_impacts(const Run& run, SizeBasis basis) {
    const auto damping = assumed_damping(run, basis);
    if (!damping) return {};
    return [&run, damping = *damping, law = run.comparison.sizes->law](double diameter) {
        ContactPair contact = contact_of_size(run.contact, diameter).pair;
        const Damping of_size = damping.of(diameter, contact);
        return Impact{law, run.data.detachment_of(law), of_size, contact, 1};
    };
}

std::optional<double> fastest_impact(const Run& run) {
    std::optional<double> fastest;
    for (const SampleRestitution& sample : run.restitution.samples)
        if (const RestitutionSeries* series = sample.of(run.comparison.sizes->law))
            for (const Measurement& impact : series->impacts.points)
                fastest = std::max(fastest.value_or(0), impact.velocity);
    return fastest;
}

std::vector<RestitutionOfVelocity> restitutions_of_run(const Run& run, SizeBasis basis,
                                                       const ReboundingSizes& sizes) {
    const auto measured = std::make_shared<const std::vector<SizeRebounds>>(sample_rebounds(run));
    if (const auto impact_of = assumed_impacts(run, basis); measured->empty() && impact_of)
        return restitutions_by_law(sizes, impact_of);
    std::vector<RestitutionOfVelocity> all;
    for (std::size_t i = 0; i < sizes.diameters.size(); ++i)
        all.push_back(between_known(measured, sizes.diameters[i], sizes.critical[i]));
    return all;
}

}  // namespace ashimpact
