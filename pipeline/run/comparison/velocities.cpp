// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/velocities.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/impacts/inverted_impacts.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"
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

/// A law that gives a finite velocity, with its rank.
struct Candidate {
    Law law;
    const LawCriticalVelocity* velocity = nullptr;
    Trust trust{};       ///< the least is taken
    std::string reason;  ///< of that trust
    bool contradicted = false;
};

bool is_contradicted(const LawCriticalVelocity& velocity) {
    return velocity.check && (velocity.check->verdict == CriticalVelocityVerdict::model_too_low ||
                              velocity.check->verdict == CriticalVelocityVerdict::model_too_high);
}

std::string tabor_reason(double tabor) {
    const std::string parameter = readable_number(tabor, 3);
    if (tabor < dmt_limit)
        return fmt::format("the contact is hard, as dmt takes it (Tabor parameter {}, below {})", parameter,
                           dmt_limit);
    if (tabor > jkr_limit)
        return fmt::format("the contact is soft, as jkr takes it (Tabor parameter {}, above {})", parameter,
                           jkr_limit);
    return fmt::format(
        "the contact is neither hard as dmt takes it (Tabor parameter below {}) nor soft as jkr does (above "
        "{}): {} is closer to {}; maugis-dugdale holds for all",
        dmt_limit, jkr_limit, parameter, nearer_to_jkr(tabor) ? "soft" : "hard");
}

std::string reason_of(Trust trust, double tabor) {
    switch (trust) {
        case Trust::describes_yield:
            return "the contact deforms plastically, which this law includes";
        case Trust::every_tabor:
            return fmt::format("it holds for hard and soft contacts alike (Tabor parameter {})",
                               readable_number(tabor, 3));
        case Trust::no_adhesion:
            return "no adhesion is given, and it has none";
        case Trust::empirical:
        case Trust::empirical_parameters:
            return "its adhesion is a fit, not a theory";
        case Trust::leaves_adhesion_out:
            return "it leaves adhesion out";
        default:
            return tabor_reason(tabor);
    }
}

Candidate candidate_of(Law law, const LawCriticalVelocity& velocity, const ContactPair& contact) {
    const double tabor = tabor_parameter_of(contact);
    const Trust trust = law.trust(tabor, velocity.plastic > 0);
    return {law, &velocity, trust, reason_of(trust, tabor), is_contradicted(velocity)};
}

/// "jkr and dmt contradict"; empty if none does.
std::string contradiction(const std::vector<Candidate>& passed_over) {
    std::vector<std::string> names;
    for (const Candidate& each : passed_over)
        if (each.contradicted && each.law.is_adhesive()) names.emplace_back(each.law.name());
    if (names.empty()) return {};
    std::string text = names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
        text += (i + 1 == names.size() ? " and " : ", ") + names[i];
    return text + (names.size() == 1 ? " contradicts" : " contradict");
}

std::string measured_words(const std::optional<MeasuredCriticalVelocity>& measured) {
    if (!measured || !measured->value) return "the measured velocity";
    return fmt::format("the measured {:#.3g} m/s", *measured->value);
}

/// The measured velocity or bounds, if no law gives a velocity.
ReportedVelocity measured_alone(const LawEvidence& evidence) {
    std::string verdict = evidence.no_damping;
    for (const LawChoice& choice : evidence.laws)
        if (const LawCriticalVelocity* velocity = evidence.velocities.find(choice.law))
            verdict = "no law gives a finite velocity: " + std::string(name_of(velocity->verdict));
    if (!evidence.measured) return {.reason = verdict};
    const MeasuredCriticalVelocity& measured = *evidence.measured;
    ReportedVelocity reported{.interval = Bounds{measured.lower, measured.upper}};
    if (measured.value) {
        reported.velocity = estimate_of(measured);
        reported.reason = "as measured; " + verdict;
    } else {
        reported.reason = measured.note + "; " + verdict;
    }
    return reported;
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

ReportedVelocity reported_velocity(const LawEvidence& evidence) {
    std::vector<Candidate> candidates;
    for (const LawChoice& choice : evidence.laws) {
        const LawCriticalVelocity* velocity = evidence.velocities.find(choice.law);
        if (velocity != nullptr && velocity->velocity)
            candidates.push_back(candidate_of(choice.law, *velocity, evidence.contact));
    }
    if (candidates.empty()) return measured_alone(evidence);

    const bool all_contradicted = std::all_of(candidates.begin(), candidates.end(), [](const Candidate& c) {
        return c.contradicted || !c.law.is_adhesive();
    });
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Candidate& x, const Candidate& y) {
        if (!all_contradicted && x.contradicted != y.contradicted) return y.contradicted;
        return x.trust < y.trust;
    });
    const Candidate& chosen = candidates.front();
    std::string reason = candidates.size() == 1 ? "the only law with a velocity" : chosen.reason;
    if (chosen.contradicted)
        reason += "; contradicts " + measured_words(evidence.measured) +
                  (candidates.size() > 1 ? ", as every law with adhesion does" : "");
    else if (const std::string others = contradiction({candidates.begin() + 1, candidates.end()});
             !others.empty())
        reason += fmt::format("; {} {}", others, measured_words(evidence.measured));
    return {chosen.law, chosen.velocity->velocity, chosen.velocity->velocity->interval, reason};
}

}  // namespace ashimpact
