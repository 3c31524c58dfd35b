// SPDX-License-Identifier: GPL-3.0-or-later
// Which damping explains the impacts, and which sizes stick.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/text/result_text.hpp"

namespace ashimpact::report {

namespace {

/// The impacts of a sample by the contact law, without the law of damping.
Series compared_impacts(const SampleData& sample, const LawData& law) {
    const bool reconstructed = law.is_reconstructed();
    Series series{.name = sample.name() + (reconstructed ? ", reconstructed" : ", measured"),
                  .legend = reconstructed ? "reconstructed" : "measured",
                  .look = Look::plain(0, reconstructed)};
    constexpr std::size_t most_marks = 120;
    const auto& points = law.measured->impacts.points;
    const std::size_t stride = (points.size() + most_marks - 1) / most_marks;
    for (std::size_t i = 0; i < points.size(); i += stride)
        series.marks.push_back({points[i].velocity, points[i].captured() ? 0 : points[i].restitution()});
    return series;
}

Series damped_series(const std::string& sample, const ComparedDamping& damping, const DampedSample& of) {
    const std::string law(name_of(damping.law));
    Series series{.name = sample + ", " + law,
                  .legend = fmt::format("{} ({}, {:.2g})", law, name_of(damping.evidence), damping.misfit),
                  .look = Look::of(static_cast<std::size_t>(damping.law))};
    series.look.thin = damping.evidence == DampingEvidence::rejected;
    for (const DampedImpact& impact : of.curve) series.line.push_back({impact.velocity, impact.restitution});
    return series;
}

/// What a damping law gives for a sample, if there is a curve; else null.
const DampedSample* drawn_sample(const ComparedDamping& damping, const std::string& sample) {
    const auto found = std::ranges::find(damping.samples, sample, &DampedSample::name);
    return found == damping.samples.end() || found->curve.empty() ? nullptr : &*found;
}

/// A row for each velocity, which all laws share, a column for each law with constants.
void add_numbers(const DampingComparison& comparison, const std::string& sample, NumberTable& table) {
    std::vector<std::vector<Cell>> rows;
    for (const ComparedDamping& damping : comparison.laws)
        if (const DampedSample* of = drawn_sample(damping, sample); of != nullptr && rows.empty())
            for (const DampedImpact& impact : of->curve) rows.push_back({sample, impact.velocity});
    for (const ComparedDamping& damping : comparison.laws) {
        if (damping.constants.empty()) continue;
        const DampedSample* of = drawn_sample(damping, sample);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].push_back(of != nullptr ? Cell(of->curve[i].restitution) : Cell(std::string()));
    }
    table.rows.insert(table.rows.end(), rows.begin(), rows.end());
}

std::string size_words(const ComparisonResult& comparison, SizeBasis basis) {
    if (basis == SizeBasis::measured) return std::string(samples_words(comparison));
    return basis == SizeBasis::adhesion ? "adhesion alone, a lower bound" : std::string(name_of(basis));
}

}  // namespace

Series size_series_of(const ComparisonResult& comparison, SizeBasis basis) {
    const std::vector<SizeVelocity>& rows = comparison.by_size;
    const auto place = static_cast<std::size_t>(basis);
    Series series{.name = size_words(comparison, basis),
                  .legend = size_words(comparison, basis),
                  .look = basis == SizeBasis::measured ? Look::plain(0) : Look::of(place - 1)};
    if (basis == SizeBasis::adhesion) {
        series.look = Look::plain(0);
        series.look.dash = 2;
        series.look.thin = true;
    }
    std::vector<Point> upper;
    for (const SizeVelocity& row : rows) {
        if (row.basis != basis) continue;
        series.line.push_back({row.diameter, row.velocity.value_or(std::nan(""))});
        if (!row.velocity || !row.interval || !row.interval->lower || !row.interval->upper) continue;
        series.band.push_back({row.diameter, *row.interval->lower});
        upper.push_back({row.diameter, *row.interval->upper});
    }
    series.band.insert(series.band.end(), upper.rbegin(), upper.rend());
    if (upper.size() < 2) series.band.clear();
    return series;
}

namespace {

/// A row for each diameter, a column for each assumption.
void add_numbers(const ComparisonResult& comparison, NumberTable& table) {
    const std::vector<SizeVelocity>& rows = comparison.by_size;
    std::vector<double> diameters;
    for (const SizeVelocity& row : rows) diameters.push_back(row.diameter);
    std::ranges::sort(diameters);
    const auto repeated = std::ranges::unique(diameters);
    diameters.erase(repeated.begin(), repeated.end());
    for (const double diameter : diameters) table.rows.push_back({diameter});
    for (const SizeBasis basis : all_values<SizeBasis>) {
        if (std::ranges::find(rows, basis, &SizeVelocity::basis) == rows.end()) continue;
        const bool measured = basis == SizeBasis::measured;
        const std::string_view name = measured ? samples_words(comparison) : name_of(basis);
        table.columns.push_back("v_c, " + std::string(name) + " [m/s]");
        if (measured)
            table.columns.insert(table.columns.end(), {"lower end of 95 % [m/s]", "upper end of 95 % [m/s]"});
        for (std::size_t i = 0; i < diameters.size(); ++i) {
            const auto row = std::ranges::find_if(rows, [&](const SizeVelocity& each) {
                return each.basis == basis && each.diameter == diameters[i];
            });
            const bool found = row != rows.end();
            table.rows[i].push_back(cell_of(found ? row->velocity : std::nullopt));
            if (!measured) continue;
            const Bounds bounds = found ? row->interval.value_or(Bounds{}) : Bounds{};
            table.rows[i].push_back(cell_of(bounds.lower));
            table.rows[i].push_back(cell_of(bounds.upper));
        }
    }
}

}  // namespace

Figure damping_laws_figure(const RunData& run) {
    Figure figure{.id = "damping-laws",
                  .title = "Which damping explains the impacts",
                  .caption =
                      "Each damping law with those constants, the same for all samples, that come closest to "
                      "the restitutions. In brackets whether the differences look like scatter, and their "
                      "root mean square, the misfit of e_n.",
                  .numbers = {.columns = {"sample", "v_in [m/s]"}},
                  .panel_height = 250};
    const auto& comparison = run.run().comparison.dampings;
    if (!comparison) {
        figure.caption += " There are too few impacts by the reported law, so there is nothing to show.";
        return figure;
    }
    figure.caption += fmt::format(" All by the contact law {}.", display_name(comparison->law.name()));
    for (const ComparedDamping& damping : comparison->laws)
        if (!damping.constants.empty())
            figure.numbers.columns.push_back("e_n, " + std::string(name_of(damping.law)));
    for (const SampleData& sample : run.samples()) {
        const auto law = std::ranges::find(sample.laws, comparison->law,
                                           [](const LawData& each) { return each.choice.law; });
        if (law == sample.laws.end() || law->measured == nullptr) continue;
        XyPanel panel{.title = sample.name(),
                      .x = {.label = "v_in", .unit = "m/s", .from_zero = true},
                      .y = {.label = "e_n", .from_zero = true}};
        for (const ComparedDamping& damping : comparison->laws)
            if (const DampedSample* of = drawn_sample(damping, sample.name()))
                panel.series.push_back(damped_series(sample.name(), damping, *of));
        add_numbers(*comparison, sample.name(), figure.numbers);
        panel.series.push_back(compared_impacts(sample, *law));
        figure.panels.emplace_back(std::move(panel));
    }
    for (const ComparedDamping& damping : comparison->laws)
        if (damping.constants.empty())
            figure.caption +=
                fmt::format(" The impacts do not determine the constants of {}.", name_of(damping.law));
    share_axes(figure.panels, false, true);
    return figure;
}

Figure which_sizes_figure(const RunData& run) {
    const ComparisonResult& comparison = run.run().comparison;
    Figure figure{.id = "which-sizes",
                  .title = "Which sizes stick: critical velocity against diameter",
                  .caption =
                      "Particles slower than the line stick. Over the measured sizes the velocities of the "
                      "samples, between them on a power law; beyond them each assumption on damping that "
                      "the impacts admit. Bands hold the velocity with 95 % if the assumption is right.",
                  .numbers = {.columns = {"diameter [m]"}},
                  .columns = 1};
    if (!comparison.sizes) {
        figure.caption += " No sample has a velocity by the reported law, so there is nothing to show.";
        return figure;
    }
    figure.caption += fmt::format(" By the contact law {}. ", display_name(comparison.sizes->law.name())) +
                      sizes_sentence(comparison);
    XyPanel panel{.title = "",
                  .x = {.label = "diameter", .unit = "µm", .scale = 1e-6, .spacing = Spacing::logarithmic},
                  .y = {.label = "v_c", .unit = "m/s", .spacing = Spacing::logarithmic}};
    for (const SizeBasis basis : all_values<SizeBasis>) {
        Series series = size_series_of(comparison, basis);
        if (!series.line.empty()) panel.series.push_back(std::move(series));
    }
    for (const SampleData& sample : run.samples()) {
        const LawComparison* law = sample.comparison->laws.find(comparison.sizes->law);
        if (law == nullptr || !law->velocity) continue;
        Series mark{.name = sample.name(), .legend = "", .look = Look::plain(0)};
        mark.marks.push_back({2 * sample.contact->radius.value, law->velocity->value});
        panel.series.push_back(std::move(mark));
    }
    add_numbers(comparison, figure.numbers);
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

}  // namespace ashimpact::report
