// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact::report {

namespace {

constexpr std::array<std::pair<std::string_view, double>, 11> prefixes{{{"T", 1e12},
                                                                        {"G", 1e9},
                                                                        {"M", 1e6},
                                                                        {"k", 1e3},
                                                                        {"", 1},
                                                                        {"m", 1e-3},
                                                                        {"µ", 1e-6},
                                                                        {"n", 1e-9},
                                                                        {"p", 1e-12},
                                                                        {"f", 1e-15},
                                                                        {"a", 1e-18}}};

constexpr std::array<std::string_view, 5> prefixed{"Pa", "m", "s", "N", "J"};

/// Position of a phase among all of the run, so that it looks the same in every sample.
std::size_t position(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    names.push_back(name);
    return names.size() - 1;
}

Row fractions_row(const SampleModulus& modulus, double PhaseShare::*fraction, const std::string& label,
                  std::vector<std::string>& names) {
    Row row{.label = label};
    double from = 0;
    for (const PhaseShare& phase : modulus.phases) {
        const double share = phase.*fraction;
        row.items.push_back({RowItem::Kind::bar, from, from + share, Look::of(position(names, phase.name)),
                             fmt::format("{}: {:.4g} %", phase.name, 100 * share), phase.name});
        from += share;
    }
    return row;
}

RowPanel fractions_panel(const RunData& run) {
    RowPanel panel{.title = "Composition",
                   .x = {.label = "fraction", .unit = "%", .scale = 0.01, .from = 0.0, .to = 1.0}};
    std::vector<std::string> names;
    for (const SampleData& sample : run.samples()) {
        panel.rows.push_back({.label = sample.name(), .heading = true});
        panel.rows.push_back(fractions_row(*sample.modulus, &PhaseShare::weight_fraction, "weight", names));
        panel.rows.push_back(fractions_row(*sample.modulus, &PhaseShare::volume_fraction, "volume", names));
    }
    return panel;
}

RowPanel modulus_panel(const RunData& run) {
    using enum RowItem::Kind;
    RowPanel panel{.title = "Young's modulus and its bounds",
                   .x = {.label = "E", .unit = "GPa", .scale = 1e9}};
    for (const SampleData& sample : run.samples()) {
        const Quantity& modulus = sample.modulus->young_modulus;
        panel.rows.push_back({.label = sample.name(), .heading = true});
        Row bounds{.label = "bounds"};
        if (const auto& known = sample.modulus->bounds) {
            const double from = known->lower.value;
            const double to = known->upper.value;
            bounds.items = {{bar, from, to, Look::plain(3),
                             fmt::format("bounds {:.4g} to {:.4g} GPa", from / 1e9, to / 1e9), "bounds"}};
        }
        panel.rows.push_back(std::move(bounds));
        Row own{.label = "E"};
        if (const double u = modulus.standard_uncertainty.value_or(0); u > 0)
            own.items.push_back({interval, modulus.value - u, modulus.value + u, Look::plain(0),
                                 fmt::format("± {:.3g} GPa (standard uncertainty)", u / 1e9)});
        own.items.push_back({mark, modulus.value, modulus.value, Look::plain(0),
                             fmt::format("E = {:.4g} GPa", modulus.value / 1e9),
                             "E by the rule of the case, ± u"});
        panel.rows.push_back(std::move(own));
    }
    return panel;
}

std::string dominant(const RunData& run) {
    std::string text;
    for (const SampleData& sample : run.samples())
        if (const auto& contributions = sample.modulus->contributions; !contributions.empty())
            text += fmt::format(" {}: {} gives {:.3g} % of the variance of E.", sample.name(),
                                contributions.front().what, 100 * contributions.front().share);
    return text.empty() ? " No uncertainty of the phases is known." : text;
}

NumberTable numbers(const RunData& run) {
    NumberTable table{.columns = {"sample", "phase", "weight fraction", "volume fraction", "density [kg/m3]",
                                  "Young's modulus [Pa]"}};
    for (const SampleData& sample : run.samples()) {
        for (const PhaseShare& phase : sample.modulus->phases)
            table.rows.push_back({sample.name(), phase.name, phase.weight_fraction, phase.volume_fraction,
                                  cell_of(phase.density), cell_of(phase.young_modulus)});
        table.rows.push_back({sample.name(), "the whole", 1.0, 1.0, sample.modulus->density.value,
                              sample.modulus->young_modulus.value});
    }
    return table;
}

RowItem velocity_mark(double value, const Look& look, const std::string& name, const std::string& legend) {
    const std::string text = critical_velocity_text(value, fmt::format("{:.4g} m/s", value));
    return {RowItem::Kind::mark, value, value, look, fmt::format("{}: {}", name, text), legend};
}

/// The interval of a value; an open end is drawn a factor 1.5 away.
RowItem velocity_interval(double value, const Bounds& bounds, const Look& look, const std::string& name) {
    const double from = bounds.lower && *bounds.lower > 0 ? *bounds.lower : value / 1.5;
    const double to = bounds.upper.value_or(value * 1.5);
    return {RowItem::Kind::interval, from, to, look,
            fmt::format("{}: from {:.3g} to {}", name, from,
                        critical_velocity_text(to, fmt::format("{:.3g} m/s", to)))};
}

/// A velocity with its interval where there is one, in the row and in the table.
void add_velocity(Row& row, NumberTable& table, const std::string& sample, const std::string& what,
                  double value, const std::optional<Bounds>& interval, const Look& look) {
    const std::string name = sample + ", " + what;
    if (interval) row.items.push_back(velocity_interval(value, *interval, look, name));
    row.items.push_back(velocity_mark(value, look, name, what));
    const Bounds bounds = interval.value_or(Bounds{});
    table.rows.push_back({sample, what, critical_cell(value), cell_of(bounds.lower), cell_of(bounds.upper)});
}

Row law_row(const SampleData& sample, const LawData& law, NumberTable& table) {
    Row row{.label = law.name};
    const auto head = law.headline();
    if (!head) return row;
    add_velocity(row, table, sample.name(), law.name, head->value, head->interval, look_of(law));
    if (!sample.sample->published) return row;
    if (const Quantity* printed = sample.sample->published->critical_velocity.find(law.choice.law)) {
        const std::string what = law.name + ", published";
        row.items.push_back(
            velocity_mark(printed->value, Look::plain(5), sample.name() + ", " + what, "published"));
        row.items.back().shift = 7;
        table.rows.push_back({sample.name(), what, printed->value, "", ""});
    }
    return row;
}

Row measured_row(const SampleData& sample, const MeasuredCriticalVelocity& measured, NumberTable& table) {
    Row row{.label = "measured"};
    std::optional<Bounds> interval;
    if (measured.lower || measured.upper) interval = {measured.lower, measured.upper};
    add_velocity(row, table, sample.name(), row.label, *measured.value, interval, Look::plain(3));
    return row;
}

/// The least dynamic or measured critical velocity of a run; 0 without any [m/s].
double least_velocity(const RunData& run) {
    std::vector<double> velocities;
    for (const SampleData& sample : run.samples()) {
        for (const LawData& law : sample.laws)
            if (const auto head = law.headline()) velocities.push_back(head->value);
        if (const auto& measured = sample.velocity->measured; measured && measured->value)
            velocities.push_back(*measured->value);
    }
    return velocities.empty() ? 0 : *std::ranges::min_element(velocities);
}

/// An input beside its bar: "E of mullite".
std::string short_label(const std::string& factor) {
    constexpr std::string_view modulus = "Young's modulus";
    return factor.starts_with(modulus) ? "E" + factor.substr(modulus.size()) : factor;
}

}  // namespace

const std::vector<FigureMaker>& figure_makers() {
    static const std::vector<FigureMaker> makers{
        {"critical-velocity",
         critical_velocity_figure,
         {analytic_artifact, critical_velocity_artifact, comparison_artifact}},
        {"which-sizes", which_sizes_figure, {contact_artifact, comparison_artifact}},
        {"critical-velocity-by-size", critical_velocity_by_size_figure, {comparison_artifact}},
        {"sensitivity", sensitivity_figure, {critical_velocity_artifact}},
        {"composition", composition_figure, {modulus_artifact}},
        {"static-force", static_force_figure, {}},
        {"regime-map",
         regime_map_figure,
         {contact_artifact, critical_velocity_artifact, comparison_artifact}},
        {"restitution",
         restitution_figure,
         {restitution_artifact, critical_velocity_artifact, histories_artifact, comparison_artifact}},
        {"damping", damping_figure, {restitution_artifact, damping_artifact, histories_artifact}},
        {"damping-fit",
         damping_fit_figure,
         {restitution_artifact, damping_artifact, fit_artifact, critical_velocity_artifact}},
        {"damping-laws", damping_laws_figure, {restitution_artifact, comparison_artifact}},
        {"contact-time", contact_time_figure, {restitution_artifact, damping_artifact, histories_artifact}},
        {"sizes", sizes_figure, {contact_artifact, restitution_artifact, damping_artifact}},
        {"histories", histories_figure, {contact_artifact, histories_artifact}},
        {"energy", energy_figure, {histories_artifact}},
        {"oblique", oblique_figure, {comparison_artifact}, has_oblique},
        {"temperature", temperature_figure, {comparison_artifact}, has_temperatures},
    };
    return makers;
}

const FigureMaker& figure_maker_named(std::string_view id) {
    std::vector<std::string> ids;
    for (const FigureMaker& maker : figure_makers()) {
        if (maker.id == id) return maker;
        ids.emplace_back(maker.id);
    }
    throw InputError("no figure is called " + in_quotes(id) + did_you_mean(id, ids), joined(ids));
}

Axis quantity_axis(std::string label, std::string_view si, double greatest) {
    Axis axis{.label = std::move(label), .unit = std::string(si)};
    const auto in = [&](std::string unit, double scale) {
        axis.unit = std::move(unit);
        axis.scale = scale;
        return axis;
    };
    if (si == "1") return in("", 1);
    if (si == "kg/s" && greatest > 0 && greatest < 0.1)
        return greatest < 1e-4 ? in("mg/s", 1e-6) : in("g/s", 1e-3);
    if (!(greatest > 0) || std::ranges::find(prefixed, si) == prefixed.end()) return axis;
    for (const auto& [name, scale] : prefixes)
        if (greatest >= scale) return in(std::string(name) + axis.unit, scale);
    return axis;
}

double greatest_of(const std::vector<double>& values) {
    double greatest = 0;
    for (const double value : values)
        if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
    return greatest;
}

Look look_of(const LawData& law, bool hollow) {
    return Look::of(law.choice.law.index(), hollow);
}

Cell cell_of(const std::optional<double>& value) {
    return value ? Cell(*value) : Cell(std::string());
}

Cell critical_cell(const std::optional<double>& value) {
    return value && outside_model(*value) ? Cell(outside_model_text()) : cell_of(value);
}

std::string display_name(std::string_view law) {
    const bool spelled = law.find_first_of("aeiou") == std::string_view::npos;  // an abbreviation
    std::string name;
    bool capital = true;
    for (const char c : law) {
        const bool letter = c >= 'a' && c <= 'z';
        name += letter && (capital || spelled) ? static_cast<char>(c - 'a' + 'A') : c;
        capital = !letter;
    }
    return name;
}

std::optional<double> LawData::extrapolated() const {
    if (velocity == nullptr || !velocity->extrapolated) return std::nullopt;
    return velocity->extrapolated->velocity.value;
}

const ModelCurve& LawData::curve() const {
    static const ModelCurve none;
    return drawn != nullptr ? drawn->impacts : none;
}

RunData::RunData(Run run, std::string label) : label_(std::move(label)), run_(std::move(run)) {
    for (std::size_t i = 0; i < run_.data.samples.size(); ++i) {
        SampleData sample{.sample = &run_.data.samples[i],
                          .modulus = &run_.modulus.samples.at(i),
                          .contact = &run_.contact.samples.at(i),
                          .analytic = &run_.analytic.samples.at(i),
                          .velocity = &run_.critical_velocity.samples.at(i),
                          .comparison = &run_.comparison.samples.at(i)};
        for (const LawChoice& choice : run_.data.laws)
            sample.laws.push_back({.choice = choice,
                                   .name = display_name(choice.law.name()),
                                   .measured = run_.restitution.samples.at(i).of(choice.law),
                                   .damping = run_.damping.samples.at(i).laws.find(choice.law),
                                   .fit = run_.fit.samples.at(i).laws.find(choice.law),
                                   .velocity = sample.velocity->laws.find(choice.law),
                                   .compared = sample.comparison->laws.find(choice.law),
                                   .histories = run_.histories.samples.at(i).laws.find(choice.law),
                                   .drawn = run_.histories.samples.at(i).curves.find(choice.law)});
        samples_.push_back(std::move(sample));
    }
}

std::string RunData::damping_unit() const {
    return std::string(unit_of(run_.data.damping_law));
}

Row sobol_row(const std::string& label, const std::string& name, const Look& look, double first, double total,
              const std::optional<double>& total_error) {
    using enum RowItem::Kind;
    Row row{.label = label,
            .items = {{bar, 0, total, look, fmt::format("{}: total {:.3g} %", name, 100 * total)}}};
    if (total_error)
        row.items.push_back({interval, total - *total_error, total + *total_error, look,
                             fmt::format("{}: ± {:.2g} %", name, 100 * *total_error)});
    row.items.push_back({mark, first, first, Look::plain(3),
                         fmt::format("{}: first order {:.3g} %", name, 100 * first),
                         "first order; bar: total"});
    return row;
}

Figure composition_figure(const RunData& run) {
    Figure figure{.id = "composition",
                  .title = "What the ash is made of, and how stiff that makes it",
                  .counterpart = "Table 1",
                  .caption =
                      "Left: the phases of each sample by weight, as the XRD result gives them, and by "
                      "volume, as Eq. 1 needs them. Right: Young's modulus by the mixture rule of the case "
                      "with its standard uncertainty u, and the bounds between which it lies however the "
                      "phases are arranged. The bounds take the moduli of the phases as exact, u does not." +
                      dominant(run),
                  .numbers = numbers(run),
                  .columns = 2};
    figure.panels.emplace_back(fractions_panel(run));
    figure.panels.emplace_back(modulus_panel(run));
    return figure;
}

Figure critical_velocity_figure(const RunData& run) {
    NumberTable table{
        .columns = {"sample", "what", "critical velocity [m/s]", "lower end [m/s]", "upper end [m/s]"}};
    RowPanel panel{.title = "",
                   .x = {.label = "critical velocity", .unit = "m/s", .spacing = Spacing::logarithmic}};
    const double slowest = least_velocity(run);
    bool with_measured = false;
    bool far = false;
    for (const SampleData& sample : run.samples()) {
        panel.rows.push_back({.label = sample.name(), .heading = true});
        const double analytic = sample.analytic->critical_velocity;
        Row row{.label = "analytic, Eq. 30"};
        // Beside an analytic velocity far below the others, the intervals of these could not be seen.
        if (analytic > 0 && analytic < slowest / 3) {
            far = true;
            row.label = "analytic: " + critical_velocity_text(analytic, fmt::format("{:.3g} m/s", analytic));
        } else if (analytic > 0) {
            row.items.push_back(
                velocity_mark(analytic, Look::plain(2, true), sample.name() + ", analytic", row.label));
        }
        table.rows.push_back({sample.name(), "analytic, Eq. 30", critical_cell(analytic), "", ""});
        panel.rows.push_back(std::move(row));
        const auto& reported = sample.comparison->reported;
        const bool by_any = reported && is_of_impacts(*reported);
        for (const LawData& law : sample.laws) {
            if (by_any && !(law.choice.law == *reported->law)) continue;
            panel.rows.push_back(law_row(sample, law, table));
            if (by_any) panel.rows.back().label = "by any law";
        }
        if (const auto& measured = sample.velocity->measured; measured && measured->value) {
            with_measured = true;
            panel.rows.push_back(measured_row(sample, *measured, table));
        }
    }
    Figure figure{.id = "critical-velocity",
                  .title = "The critical velocity, every way there is",
                  .counterpart = "Table 4",
                  .caption =
                      "A particle slower than its critical velocity sticks. Analytic: the energy to separate "
                      "the surfaces alone (Eq. 30). Dynamic: by each contact law with its damping, with " +
                      std::string(is_reproduction(run.run().comparison)
                                      ? "what the rounding of published numbers and the stated uncertainties "
                                        "of the inputs leave open."
                                      : "the interval that holds it with 95 %."),
                  .numbers = std::move(table),
                  .columns = 1};
    if (far) figure.caption += " The analytic velocities lie far to the left of this axis.";
    if (with_measured) figure.caption += " Measured: as the case reports it, or from which impacts stuck.";
    figure.caption += " " + run.run().comparison.conclusion;
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

Figure sensitivity_figure(const RunData& run) {
    Figure figure{
        .id = "sensitivity",
        .title = "What the interval of the critical velocity comes from",
        .caption =
            "Sobol indices of v_c: the share of its variance that each uncertain input makes by itself "
            "(first order, mark), and with all that it does together with others (total, bar). Only what the "
            "case states to be uncertain is in it; an input without an uncertainty counts as exact.",
        .numbers = {.columns = {"sample", "law", "input", "first order", "its standard error", "total",
                                "its standard error"}},
        .columns = 2};
    bool estimated = false;
    for (const SampleData& sample : run.samples()) {
        RowPanel panel{.title = sample.name(),
                       .x = {.label = "share of the variance of v_c",
                             .unit = "%",
                             .scale = 0.01,
                             .from = -0.02,
                             .to = 1.05}};
        for (const LawData& law : sample.laws) {
            std::vector<Influence> influences;
            if (law.velocity != nullptr && law.velocity->uncertainty)
                influences = law.velocity->uncertainty->influences;
            else if (const auto head = law.headline();
                     head && head->interval && head->method == VelocityMethod::estimate) {
                influences = {{"measured impacts", {1, 0}, {1, 0}}};
                estimated = true;
            }
            if (influences.empty()) continue;
            panel.rows.push_back({.label = law.name, .heading = true});
            for (const auto& [factor, first, total] : influences) {
                figure.numbers.rows.push_back({sample.name(), law.name, factor, first.value,
                                               first.standard_error, total.value, total.standard_error});
                if (!(total.value >= 0.005 || first.value >= 0.005)) continue;  // too small to be seen
                panel.rows.push_back(sobol_row(short_label(factor), law.name + ", " + factor, look_of(law),
                                               first.value, total.value));
            }
        }
        if (!panel.rows.empty()) figure.panels.emplace_back(std::move(panel));
    }
    if (figure.panels.empty())
        figure.caption += " This case has no such indices, so there is nothing to show.";
    if (estimated)
        figure.caption +=
            " Where impacts were measured, v_c is where their curve ends, whatever the contact is: all of "
            "its "
            "interval comes from the scatter of the impacts and from which of them stuck.";
    return figure;
}

}  // namespace ashimpact::report
