// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"
#include "pipeline/run/sizes.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t most_size_rows = 9;
constexpr std::size_t most_velocities_listed = 3;
constexpr double close_sizes = 1.1;  ///< ratio of sizes that may be too close for an exponent

std::string constants_cell(const ComparedDamping& damping) {
    if (damping.constants.empty()) return "-";
    std::vector<std::string> values;
    for (const auto& [name, value] : damping.constants) {
        const bool vanishes = value.value < 1e-3 * value.standard_uncertainty.value_or(0);
        values.push_back(vanishes ? "0" : readable_number(value.value, 3));
    }
    const std::string unit = damping.constants.front().second.unit;
    return joined(values) + (unit == "1" ? "" : " " + unit);
}

/// The velocities of the samples from high to low, of many the range; verdicts of those without one.
std::string velocities_cell(const ComparedDamping& damping) {
    std::vector<double> velocities;
    std::vector<std::string> texts;
    for (const DampedSample& sample : damping.samples) {
        const std::string verdict(sample.verdict ? name_of(*sample.verdict) : "-");
        if (sample.velocity)
            velocities.push_back(*sample.velocity);
        else if (std::ranges::find(texts, verdict) == texts.end())
            texts.push_back(verdict);
    }
    std::ranges::sort(velocities, std::ranges::greater());
    std::ranges::sort(texts);
    if (velocities.size() > most_velocities_listed) {
        texts.insert(texts.begin(),
                     velocity_text(velocities.back()) + " to " + velocity_text(velocities.front()));
    } else {
        std::vector<std::string> listed;
        for (const double velocity : velocities) listed.push_back(velocity_text(velocity));
        texts.insert(texts.begin(), listed.begin(), listed.end());
    }
    return joined(texts);
}

/// Assumptions that the data admit, in the order of the rows.
std::vector<SizeBasis> assumptions_of(const ComparisonResult& result) {
    std::vector<SizeBasis> list;
    for (const SizeVelocity& row : result.by_size)
        if (row.basis != SizeBasis::measured && row.basis != SizeBasis::adhesion &&
            std::ranges::find(list, row.basis) == list.end())
            list.push_back(row.basis);
    return list;
}

/// A number that orders velocities: 0 if nothing is captured, infinite if everything is.
std::optional<double> ordered_velocity(const SizeVelocity& row) {
    switch (row.verdict) {
        case SizeVerdict::finite:
            return row.velocity;
        case SizeVerdict::never_captured:
            return 0;
        case SizeVerdict::outside_model:
        case SizeVerdict::always_captured:
            return std::numeric_limits<double>::infinity();
        case SizeVerdict::unknown:
            break;
    }
    return std::nullopt;
}

std::string size_cell(const SizeVelocity& row) {
    if (row.velocity) return velocity_text(*row.velocity);
    switch (row.verdict) {
        case SizeVerdict::outside_model:
            return fmt::format("> {:g}", fastest_in_model);
        case SizeVerdict::always_captured:
            return "all";
        case SizeVerdict::never_captured:
            return "none";
        default:
            return "-";
    }
}

/// The rows of one size, those of assumptions in rising order.
struct RowsOfSize {
    double diameter = 0;
    const SizeVelocity* measured = nullptr;
    const SizeVelocity* adhesion = nullptr;
    std::vector<const SizeVelocity*> assumed{};
};

std::vector<RowsOfSize> rows_by_size(const ComparisonResult& result) {
    std::vector<RowsOfSize> sizes;
    for (const SizeVelocity& row : result.by_size) {
        auto same = std::ranges::find(sizes, row.diameter, &RowsOfSize::diameter);
        if (same == sizes.end()) same = sizes.insert(sizes.end(), {.diameter = row.diameter});
        if (row.basis == SizeBasis::measured)
            same->measured = &row;
        else if (row.basis == SizeBasis::adhesion)
            same->adhesion = &row;
        else if (ordered_velocity(row))
            same->assumed.push_back(&row);
    }
    std::ranges::sort(sizes, {}, &RowsOfSize::diameter);
    for (RowsOfSize& size : sizes)
        std::sort(size.assumed.begin(), size.assumed.end(),
                  [](const auto* x, const auto* y) { return *ordered_velocity(*x) < *ordered_velocity(*y); });
    return sizes;
}

/// The measured sizes, and others evenly between them.
std::vector<RowsOfSize> shown_sizes(const ComparisonResult& result) {
    std::vector<RowsOfSize> shown;
    std::vector<RowsOfSize> others;
    for (RowsOfSize& size : rows_by_size(result)) {
        const bool of_sample = std::ranges::any_of(
            result.samples, [&](const SampleComparison& sample) { return sample.diameter == size.diameter; });
        (of_sample ? shown : others).push_back(std::move(size));
    }
    const std::size_t room = most_size_rows > shown.size() ? most_size_rows - shown.size() : 2;
    const std::size_t stride = std::max<std::size_t>(1, (others.size() + room - 1) / room);
    for (std::size_t i = 0; i < others.size(); i += stride) shown.push_back(std::move(others[i]));
    std::ranges::sort(shown, {}, &RowsOfSize::diameter);
    return shown;
}

}  // namespace

std::string size_range_text(const SizeRange& range) {
    const std::string from = readable(range.from, "m");
    const std::string to = readable(range.to, "m");
    if (from == to) return to;
    const auto number = from.find(' ');
    const bool same_unit = number != std::string::npos && to.ends_with(from.substr(number));
    return (same_unit ? from.substr(0, number) : from) + " to " + to;
}

std::string dampings_text(const DampingComparison& comparison, std::size_t width) {
    TextTable table({"damping law", "constants", "misfit", "evidence", "v_c"}, 1);
    for (const ComparedDamping& damping : comparison.laws)
        table.add({std::string(name_of(damping.law)), constants_cell(damping),
                   fmt::format("{:.2g}", damping.misfit), std::string(name_of(damping.evidence)),
                   velocities_cell(damping)});
    const bool several = comparison.laws.front().samples.size() > 1;
    return wrapped(
               fmt::format("Which damping explains the impacts, by {}: constants {}, the misfit of e, and "
                           "v_c [m/s]{}:",
                           comparison.law.name(),
                           several ? "that are the same for all samples" : "for all velocities",
                           several ? " of the samples, from high to low" : ""),
               width) +
           "\n\n" + table.text(0, width) + "\n";
}

std::string sizes_sentence(const ComparisonResult& result) {
    if (!result.sizes) return {};
    const SizeSummary& sizes = *result.sizes;
    const bool one = sizes.measured.from == sizes.measured.to;
    std::vector<std::string> names;
    for (const SizeBasis basis : assumptions_of(result)) names.emplace_back(name_of(basis));
    const std::string measured = size_range_text(sizes.measured);
    const std::string beyond = (one ? "Beyond " : "Outside of ") + measured;
    if (names.empty())
        return beyond +
               " only a lower bound is known, that of adhesion alone: no damping follows from the "
               "impacts.";
    if (names.size() == 1)
        return fmt::format("{} v_c rests on one assumption on damping, {}.", beyond, names.front());
    if (!sizes.agreement)
        return fmt::format("{} v_c rests on the damping assumed: {} differ by more than a factor of {:g}.",
                           beyond, joined(names), agreement_factor);
    const std::string agree =
        fmt::format("rom {} the assumptions on damping agree within a factor of {:g} ({})",
                    size_range_text(*sizes.agreement), agreement_factor, joined(names));
    if (one) return fmt::format("{} v_c rests on the damping assumed; f{}.", beyond, agree);
    return "F" + agree + "; beyond, v_c rests on which of them holds.";
}

std::string_view samples_words(const ComparisonResult& result) {
    const bool of_impacts = std::ranges::all_of(result.samples, [](const SampleComparison& sample) {
        return !sample.reported || !sample.reported->velocity || is_of_impacts(*sample.reported);
    });
    return of_impacts ? "measured" : "of samples";
}

/// Lines on sizes that several samples share, and on sizes too close for an exponent.
std::string close_sizes_text(const ComparisonResult& result, std::size_t width) {
    std::string text;
    for (const std::string& shared : shared_sizes(result)) text += wrapped(shared + ".", width) + "\n";
    const SizeRange& measured = result.sizes->measured;
    if (measured.from < measured.to && measured.to < close_sizes * measured.from && !result.sizes->power)
        text += wrapped("power-of-size: left out, sizes of " + size_range_text(measured) +
                            " are too close for an exponent.",
                        width) +
                "\n";
    return text;
}

std::string sizes_text(const ComparisonResult& result, std::size_t width) {
    if (!result.sizes) return {};
    TextTable table({"size", std::string(samples_words(result)), "least", "by", "greatest", "by", "adhesion"},
                    1);
    for (const RowsOfSize& size : shown_sizes(result)) {
        const bool any = !size.assumed.empty();
        const SizeVelocity* least = any ? size.assumed.front() : nullptr;
        const SizeVelocity* greatest = any ? size.assumed.back() : nullptr;
        table.add({readable(size.diameter, "m"), size.measured != nullptr ? size_cell(*size.measured) : "-",
                   any ? size_cell(*least) : "-", any ? std::string(name_of(least->basis)) : "-",
                   any ? size_cell(*greatest) : "-", any ? std::string(name_of(greatest->basis)) : "-",
                   size.adhesion != nullptr ? size_cell(*size.adhesion) : "-"});
    }
    table.drop_empty_columns();
    const bool relaxes = std::ranges::any_of(
        result.samples, [](const SampleComparison& sample) { return relaxing_glass(sample).has_value(); });
    std::string text =
        wrapped(
            fmt::format(
                "Which sizes stick, by {}: v_c [m/s] under the assumptions on damping "
                "that the impacts admit, and by adhesion alone, a lower bound{}:",
                result.sizes->law.name(),
                relaxes ? "; as elastic theory gives them, where the glass relaxes lower bounds too" : ""),
            width) +
        "\n\n" + table.text(0, width);
    if (result.sizes->constants == ConstantsFrom::capture)
        text += wrapped(
                    "No damping law with one constant both explains all impacts and gives the v_c of the "
                    "samples within a factor of 2; each has the constant that gives that v_c.",
                    width) +
                "\n";
    if (result.sizes->power)
        text += wrapped(fmt::format("power-of-size: the critical damping of the samples grows as d^({}).",
                                    readable(result.sizes->power->exponent)),
                        width) +
                "\n";
    return text + close_sizes_text(result, width) + "\n";
}

}  // namespace ashimpact
