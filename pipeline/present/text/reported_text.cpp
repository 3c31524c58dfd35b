// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"

namespace ashimpact {

namespace {

std::string paragraph(const std::string& text, std::size_t width) {
    return text.empty() ? text : wrapped(text, width, 2) + "\n";
}

/// "a, b and c"
std::string enumerated(const std::vector<std::string>& words, const char* last = " and ") {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
    return text;
}

std::string enumerated(const std::vector<Law>& laws) {
    std::vector<std::string> names;
    for (const Law law : laws) names.emplace_back(law.name());
    return enumerated(names);
}

/// ", by jkr; at 1100 C the glass is viscoelastic."
std::string relaxing_words(const SampleComparison& sample) {
    return fmt::format("{}; at {} the glass is {}.",
                       sample.reported->law ? ", by " + std::string(sample.reported->law->name()) : "",
                       celsius(sample.temperature->particle->value()), name_of(*relaxing_glass(sample)));
}

/// ", by jkr"; empty where it is the law of the run, which is named once.
std::string other_law(const ReportedVelocity& reported, const ComparisonResult& result) {
    if (!reported.law || (result.reported && *reported.law == result.reported->law)) return {};
    return ", by " + std::string(reported.law->name());
}

/// "Particles of 88 um stick below 1.93 m/s (1.89 to 1.96)."
std::string sticking_sentence(const SampleComparison& sample, const ComparisonResult& result) {
    const ReportedVelocity& reported = *sample.reported;
    const std::string size = sample.diameter ? readable(*sample.diameter, "m") : "";
    std::string text = size == sample.name ? "Particles" : sample.name + ": particles";
    if (!size.empty()) text += " of " + size;
    const Answer answer = answer_of(reported);
    if (answer.velocity > fastest_in_model)
        return text + ": the critical velocity is " + critical_velocity_text(answer.velocity, "") + ".";
    const std::string velocity = velocity_text(answer.velocity) + " m/s";
    if (relaxing_glass(sample) && answer.kind != Answer::Kind::none)
        return text + ": " +
               (answer.kind == Answer::Kind::below
                    ? "elastic theory gives no lower bound"
                    : velocity + " is a lower bound that elastic theory gives") +
               relaxing_words(sample);
    switch (answer.kind) {
        case Answer::Kind::none:
            return text + ": no critical velocity.";
        case Answer::Kind::above:
            return text + " stick below " + velocity + " at least.";
        case Answer::Kind::below:
            return text + " rebound above " + velocity + " at least.";
        case Answer::Kind::velocity:
            break;
    }
    const std::string bounds = bounds_text(reported.interval);
    return text + " stick below " + velocity + (bounds.empty() ? "" : " (" + bounds + ")") +
           other_law(reported, result) + ".";
}

/// The law of the run, and why it is that one.
std::string law_sentence(const ComparisonResult& result) {
    if (!result.reported) return {};
    const bool of_impacts = std::ranges::all_of(
        result.samples, [](const SampleComparison& sample) { return is_of_impacts(*sample.reported); });
    return fmt::format("{} {}{}: {}.",
                       of_impacts ? "The impacts give v_c, whatever the contact law. Other sizes by" : "By",
                       result.reported->law.name(),
                       result.samples.size() > 1 ? ", one law for all sizes" : "", result.reported->reason);
}

/// Reasons that are not those of the law of the run.
std::string other_reasons(const ComparisonResult& result, std::size_t width) {
    std::string text;
    for (const SampleComparison& sample : result.samples)
        if (!result.reported || sample.reported->reason != result.reported->reason)
            text += paragraph(
                sample.name + other_law(*sample.reported, result) + ": " + sample.reported->reason + ".",
                width);
    return text;
}

/// The interval by the reported law alone, where it is not the reported one.
std::string own_interval(const SampleComparison& sample) {
    if (!sample.reported->law) return {};
    const LawComparison* own = sample.laws.find(*sample.reported->law);
    if (own == nullptr || !own->velocity || own->velocity->interval == sample.reported->interval) return {};
    const std::string bounds = bounds_text(own->velocity->interval);
    return bounds == bounds_text(sample.reported->interval) ? std::string() : bounds;
}

/// The samples from small to large, whatever their order in the case.
std::vector<const SampleComparison*> by_size(const ComparisonResult& result) {
    std::vector<const SampleComparison*> samples;
    for (const SampleComparison& sample : result.samples) samples.push_back(&sample);
    std::ranges::sort(samples, {}, [](const SampleComparison* sample) {
        return std::pair(sample->diameter.value_or(0), sample->name);
    });
    return samples;
}

/// What the brackets are, and which part of them is the choice of the law.
std::string bracket_sentence(const ComparisonResult& result) {
    std::vector<std::string> own;
    bool any = false;
    for (const SampleComparison* each : by_size(result)) {
        const SampleComparison& sample = *each;
        if (!sample.reported->velocity || !sample.reported->interval || relaxing_glass(sample)) continue;
        any = true;
        if (const std::string bounds = own_interval(sample); !bounds.empty())
            own.push_back(bounds + (result.samples.size() > 1 ? " (" + sample.name + ")" : ""));
    }
    if (!any) return {};
    const std::string text = "In brackets: the interval that holds the velocity with 95 %";
    if (own.empty() || !result.reported) return text + ".";
    return fmt::format("{}, over {}; by {} alone it is {}.", text, enumerated(result.reported->admissible),
                       result.reported->law.name(), enumerated(own));
}

/// "Captures and rebounds alone: fine 1.60 m/s (1.50 to 1.70)."
std::string measured_text(const ComparisonResult& result) {
    std::vector<std::string> measured;
    std::vector<std::string> outcomes;
    bool bare = false;
    for (const SampleComparison* each : by_size(result)) {
        const SampleComparison& sample = *each;
        if (!sample.measured) continue;
        const std::string bounds = bounds_text(sample.measured_interval);
        const double velocity = sample.measured->value();
        const bool stated = !sample.measured_by_outcomes;
        (stated ? measured : outcomes)
            .push_back(sample.name + " " +
                       critical_velocity_text(velocity, velocity_text(velocity) + " m/s") +
                       (bounds.empty() ? "" : " (" + bounds + ")"));
        bare = bare || (stated && bounds.empty());
    }
    std::string text = outcomes.empty() ? "" : "Captures and rebounds alone: " + enumerated(outcomes) + ".";
    if (!measured.empty())
        text += std::string(text.empty() ? "" : " ") +
                "Measured, for comparison only: " + enumerated(measured) +
                (bare ? "; where no uncertainty is stated, no law is judged by it." : ".");
    return text;
}

std::string span_cell(const VelocitySpan& span) {
    return velocity_text(span.least) + " to " + velocity_text(span.greatest);
}

/// "0.02, 0.05 or 0.1"
std::string alternatives(const std::vector<double>& values) {
    std::vector<std::string> words;
    for (const double value : values) words.push_back(readable_number(value));
    return enumerated(words, " or ");
}

/// The deviations of all laws from the measured velocities, and what would be expected of them.
std::string joint_sentence(const LawMap<JointTest>& tests) {
    if (tests.empty()) return {};
    std::vector<std::string> sums;
    double least = tests.begin()->second.sum_of_squares;
    std::size_t samples = 0;
    for (const auto& [law, test] : tests) {
        const bool digits = test.sum_of_squares < 100;
        sums.push_back(fmt::format("{} {:.{}f}", law.name(), test.sum_of_squares, digits ? 1 : 0));
        least = std::min(least, test.sum_of_squares);
        samples = std::max(samples, test.samples);
    }
    const auto count = static_cast<double>(samples);
    const bool none = least > count + 2 * std::sqrt(2 * count);
    return fmt::format(
        "Each law against the measured velocities, squared deviations over the variances that the inputs "
        "leave, summed over {}: {}. About {} is expected{}.",
        counted(samples, "sample"), enumerated(sums), samples,
        none ? "; no law comes near it, so the inputs alone do not explain the difference" : "");
}

/// What the velocities of a reproduction leave open, beside the measured ones.
std::string reproduction_text(const ComparisonResult& result, std::size_t width) {
    if (!result.reproduction) return {};
    const Reproduction& reproduction = *result.reproduction;
    const std::string change = "d +-" + readable(reproduction.diameter_change, "m");
    TextTable table({"sample", "v_c", "measured", "other laws", "other fits", change});
    for (const SampleComparison& sample : result.samples)
        for (const ReproducedSample& open : reproduction.samples) {
            if (open.name != sample.name || !sample.reported->velocity) continue;
            table.add({sample.name, velocity_text(sample.reported->velocity->value),
                       sample.measured ? velocity_text(sample.measured->value()) : "-", span_cell(open.laws),
                       open.fits ? span_cell(*open.fits) : "-", span_cell(open.diameter)});
        }
    table.drop_empty_columns();
    return "What the velocities leave open, each source alone [m/s]:\n\n" + table.text(0, width) +
           paragraph(fmt::format("Other laws: those with adhesion. Other fits: restitutions from {} to {}, "
                                 "polynomials of order {}. {}: the damping is held.",
                                 alternatives(reproduction.from), alternatives(reproduction.to),
                                 alternatives(reproduction.orders), change),
                     width) +
           paragraph(joint_sentence(reproduction.joint_tests), width) + "\n";
}

}  // namespace

bool is_reproduction(const ComparisonResult& result) {
    return result.reproduction && result.reproduction->samples.size() == result.samples.size();
}

std::string reported_text(const ComparisonResult& result, const std::string& scope, std::size_t width) {
    std::string text;
    for (const SampleComparison& sample : result.samples) {
        if (!sample.reported) return {};
        text += paragraph(sticking_sentence(sample, result), width);
    }
    text += paragraph(law_sentence(result), width) + other_reasons(result, width);
    if (result.reproduction)
        text += paragraph(
            fmt::format("A reproduction: the rebounds{} were not measured here, they follow from published "
                        "fits of damping. No interval holds these velocities with a known probability.",
                        is_reproduction(result) ? "" : " of some samples"),
            width);
    text += paragraph(bracket_sentence(result), width) + paragraph(sizes_sentence(result), width) +
            paragraph(scope, width);
    if (!is_reproduction(result)) text += paragraph(measured_text(result), width);
    return text + "\n" + reproduction_text(result, width);
}

}  // namespace ashimpact
