// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of impacts: restitution, damping, contact time and energy against velocity.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "pipeline/present/report/figures/figures.hpp"
#include "solver/numeric/gsl/interpolation.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact::report {

namespace {

Axis velocity_axis() {
    return {.label = "v_in", .unit = "m/s", .from_zero = true};
}

Axis restitution_axis() {
    return {.label = "e_n", .from_zero = true};
}

/// A series of a law; @p what follows in the readout.
Series law_series(const SampleData& sample, const LawData& law, const std::string& what) {
    return {.name = sample.name() + ", " + law.name + what, .legend = law.name, .look = look_of(law)};
}

/// The model's curve of a law as a series; @p y gives what is drawn over the velocity.
Series curve_series(const SampleData& sample, const LawData& law, double CurveImpact::*y) {
    Series series = law_series(sample, law, ", model");
    for (const CurveImpact& impact : law.curve()) series.line.push_back({impact.velocity, impact.*y});
    return series;
}

/// "Points reconstructed from published fits" or the like, as a sentence for captions.
std::string origin_sentence(const RunData& run) {
    bool measured = false;
    bool reconstructed = false;
    for (const SampleRestitution& sample : run.run().restitution.samples)
        for (const RestitutionSeries& series : sample.series)
            (series.origin == Origin::measured ? measured : reconstructed) = true;
    if (!reconstructed) return " Points are measured impacts.";
    const std::string hollow =
        " Hollow points are not measured: they are reconstructed from published fits η(e_n).";
    return measured ? hollow + " Filled points are measured impacts." : hollow;
}

/// How extrapolated velocities differ from the answer, for captions; empty for a run without any.
std::string extrapolation_sentence(const RunData& run) {
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.extrapolated())
                return " The fit to measured impacts is made to the rebounds alone and extrapolated to e_n = "
                       "0: it gives the extrapolated v_c of the table, not the answer, which is estimated "
                       "from rebounds and captures together.";
    return {};
}

/// Adds the panel of a sample, unless there is nothing to see in it.
void add_panel(Figure& figure, XyPanel panel) {
    const auto is_drawn = [](const Series& series) {
        return !series.line.empty() || !series.marks.empty() || !series.band.empty();
    };
    if (!panel.regions.empty() || !panel.rules.empty() || std::ranges::any_of(panel.series, is_drawn))
        figure.panels.emplace_back(std::move(panel));
}

/// Gives the panels of a figure one axis y, and one axis x if asked for.
void finish(Figure& figure, bool one_x) {
    if (figure.panels.empty()) figure.caption += " No sample has impacts, so there is nothing to show.";
    share_axes(figure.panels, one_x, true);
}

// Restitution.

/// The velocities below which impacts are captured by every law; ends at the least critical velocity.
std::vector<Region> capture_region(const SampleData& sample) {
    double least = std::numeric_limits<double>::infinity();
    for (const LawData& law : sample.laws)
        if (const auto head = law.headline()) least = std::min(least, head->value);
    if (!std::isfinite(least)) return {};
    return {{0, least, "captured"}};
}

/// The band of the model's curve between its two velocities, closed.
std::vector<Point> velocity_band(const ModelCurve& curve) {
    std::vector<Point> band;
    std::vector<Point> lower;
    for (const CurveImpact& impact : curve)
        if (std::isfinite(impact.lower) && std::isfinite(impact.upper)) {
            band.push_back({impact.upper, impact.restitution});
            lower.push_back({impact.lower, impact.restitution});
        }
    band.insert(band.end(), lower.rbegin(), lower.rend());
    return band;
}

/// The impacts of one series: the law's own where reconstructed, shared by all laws where measured.
Series measured_series(const SampleData& sample, const LawData& law) {
    const bool reconstructed = law.is_reconstructed();
    Series series{
        .name = sample.name() + (reconstructed ? ", " + law.name + ", reconstructed" : ", measured"),
        .legend = reconstructed ? law.name + ", reconstructed" : "measured, ± 95 %",
        .look = reconstructed ? look_of(law, true) : Look::plain(0)};
    for (const Measurement& impact : law.measured->impacts.points) {
        const double e = impact.restitution();
        double error = 0;
        if (!reconstructed && impact.noise)
            error = confidence_quantile() *
                    std::sqrt(std::max(0.0, impact.noise->rebound + e * e * impact.noise->incident -
                                                2 * e * impact.noise->covariance)) /
                    impact.velocity;
        series.marks.push_back({impact.velocity, e, 0, std::isfinite(error) ? error : 0});
    }
    return series;
}

XyPanel restitution_panel(const SampleData& sample, NumberTable& table) {
    XyPanel panel{.title = sample.name(),
                  .x = velocity_axis(),
                  .y = restitution_axis(),
                  .regions = capture_region(sample)};
    const RestitutionSeries* drawn = nullptr;
    std::vector<Series> points;
    for (const LawData& law : sample.laws) {
        Series curve = curve_series(sample, law, &CurveImpact::restitution);
        if (!curve.line.empty() && law.drawn->start)
            curve.line.insert(curve.line.begin(), {*law.drawn->start, 0.0});
        curve.band = velocity_band(law.curve());
        panel.series.push_back(std::move(curve));
        for (const CurveImpact& impact : law.curve())
            table.rows.push_back({sample.name(), law.name, "model", impact.velocity, impact.restitution,
                                  impact.lower, impact.upper});
        if (law.measured == nullptr || law.measured == drawn) continue;
        drawn = law.measured;
        points.push_back(measured_series(sample, law));
        for (const Mark& mark : points.back().marks)
            table.rows.push_back({sample.name(), law.is_reconstructed() ? law.name : "",
                                  std::string(name_of(law.measured->origin)), mark.x, mark.y, "", ""});
    }
    for (Series& each : points) panel.series.push_back(std::move(each));
    if (const auto& reported = sample.comparison->reported; reported && reported->velocity) {
        Rule& rule =
            panel.rules.emplace_back(Rule{reported->velocity->value, "v_c",
                                          reported->law ? Look::of(reported->law->index()) : Look::plain(0)});
        if (const auto& ends = reported->interval; ends && ends->lower && ends->upper)
            rule.interval = {*ends->lower, *ends->upper};
    }
    if (const auto& measured = sample.velocity->measured; measured && measured->value)
        panel.rules.push_back({*measured->value, "measured", Look::plain(0)});
    return panel;
}

// Damping and contact time.

using SeriesColumn = std::vector<double> DampingSeries::*;

/// What a figure shows of the impacts that were inverted to dampings.
struct InvertedImpacts {
    Axis x;
    Axis y;
    SeriesColumn x_values;
    SeriesColumn y_values;
    Series (*line)(const SampleData&, const LawData&);
    std::span<const SeriesColumn> listed;  ///< in the table, after sample, law and origin
};

std::optional<double> value_at(const std::vector<double>& values, std::size_t i) {
    return i < values.size() ? std::optional(values[i]) : std::nullopt;
}

/// The panel of a sample with the impacts of each law as points, with their uncertainty where it is known and
/// y is the damping, and a line; adds the numbers to the table.
XyPanel inverted_panel(const SampleData& sample, const InvertedImpacts& shown, NumberTable& table) {
    XyPanel panel{.title = sample.name(), .x = shown.x, .y = shown.y};
    for (const LawData& law : sample.laws) {
        if (law.damping == nullptr) continue;
        panel.series.push_back(shown.line(sample, law));
        panel.series.back().look.thin = true;
        Series points = law_series(sample, law, "");
        points.look.hollow = law.is_reconstructed();
        const std::vector<double>& x = law.damping->*shown.x_values;
        const std::vector<double>& y = law.damping->*shown.y_values;
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
            const bool damping = shown.y_values == &DampingSeries::damping;
            const double u = damping ? value_at(law.damping->damping_uncertainty, i).value_or(0) : 0;
            points.marks.push_back({x[i], y[i], 0, std::isfinite(u) ? u : 0});
            auto& row = table.rows.emplace_back(
                std::vector<Cell>{sample.name(), law.name, std::string(name_of(law.damping->origin))});
            for (const SeriesColumn column : shown.listed)
                row.push_back(cell_of(value_at(law.damping->*column, i)));
        }
        panel.series.push_back(std::move(points));
    }
    return panel;
}

Axis damping_axis(const RunData& run) {
    double greatest = 0;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            if (law.damping != nullptr) greatest = std::max(greatest, greatest_of(law.damping->damping));
            for (const CurveImpact& impact : law.curve()) greatest = std::max(greatest, impact.damping);
        }
    Axis axis = quantity_axis("η", run.damping_unit(), greatest);
    axis.from_zero = true;
    return axis;
}

/// Boundaries between falling, flat and rising eta(v_in), of the first law that has several parts.
std::vector<Rule> boundaries(const SampleData& sample) {
    std::vector<Rule> rules;
    for (const LawData& law : sample.laws) {
        if (law.damping == nullptr) continue;
        for (std::size_t i = 1; i < law.damping->parts.size(); ++i)
            rules.push_back({law.damping->parts[i].from.value,
                             std::string(name_of(law.damping->parts[i].part)), look_of(law)});
        if (!rules.empty()) break;
    }
    return rules;
}

constexpr std::array damping_columns{&DampingSeries::velocity, &DampingSeries::restitution,
                                     &DampingSeries::damping, &DampingSeries::damping_uncertainty};
constexpr std::array time_columns{&DampingSeries::velocity, &DampingSeries::contact_time};

NumberTable damping_table(const RunData& run) {
    const std::string unit = " [" + run.damping_unit() + "]";
    return {.columns = {"sample", "law", "origin", "v_in [m/s]", "e_n", "damping" + unit,
                        "standard uncertainty" + unit}};
}

Series fit_series(const SampleData& sample, const LawData& law) {
    Series fit = law_series(sample, law, ", fit");
    const double end = greatest_of(law.damping->restitution);
    for (int i = 0; i <= 24 && law.fit != nullptr; ++i) {
        const double e = end * i / 24;
        fit.line.push_back({e, law.fit->along_rising_branch()(e)});
    }
    return fit;
}

// Energy.

struct Share {
    std::string_view name;
    double (*of)(const CurveImpact& impact);
};

/// Where the energy goes, from the bottom of the stack up.
constexpr std::array shares{
    Share{"damping", [](const CurveImpact& i) { return i.dissipated; }},
    Share{"yielding", [](const CurveImpact& i) { return i.plastic; }},
    Share{"breaking the contact", [](const CurveImpact& i) { return i.adhesion; }},
    Share{"rebound", [](const CurveImpact& i) { return i.restitution * i.restitution; }}};

XyPanel energy_panel(const SampleData& sample, const LawData& law) {
    XyPanel panel{.title = sample.name() + ", " + law.name,
                  .x = velocity_axis(),
                  .y = {.label = "share", .unit = "%", .scale = 0.01, .from = 0.0, .to = 1.0}};
    panel.x.from_zero = false;
    std::vector<double> sums(law.curve().size(), 0.0);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const auto& [name, share] = shares[k];
        if (std::ranges::all_of(law.curve(),
                                [&share = share](const CurveImpact& i) { return share(i) == 0; }))
            continue;
        Series series{.name = fmt::format("{}, up to {}", panel.title, name),
                      .legend = std::string(name),
                      .look = Look::of(k),
                      .area = true};
        std::vector<Point> below;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const CurveImpact& impact = law.curve()[i];
            below.push_back({impact.velocity, sums[i]});
            sums[i] += share(impact);
            series.line.push_back({impact.velocity, sums[i]});
        }
        series.band = series.line;
        series.band.insert(series.band.end(), below.rbegin(), below.rend());
        panel.series.push_back(std::move(series));
    }
    return panel;
}

/// What breaking the contact takes beside damping, at the velocity where each curve begins.
std::string energy_statement(const RunData& run) {
    double damping = 1;
    double breaking = 0;
    bool any = false;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (!law.curve().empty()) {
                any = true;
                damping = std::min(damping, law.curve().front().dissipated);
                breaking = std::max(breaking, law.curve().front().adhesion);
            }
    if (!any) return " No law has a curve here.";
    return fmt::format(
        " Where the curves begin, at capture, damping takes at least {:.4g} % and breaking the contact at "
        "most {:.2g} %{}.",
        100 * damping, 100 * breaking,
        breaking < 0.1 * damping ? ": the first-contact adhesive loss of Eq. 28 does not explain capture"
                                 : "");
}

// Sizes.

/// Damping of one size at equal velocity, interpolated between its points and never beyond them.
struct SizeCurve {
    const SampleData* sample;
    std::vector<double> velocity{};  ///< increasing
    std::vector<double> damping{};

    [[nodiscard]] bool has_curve() const { return velocity.size() >= 3; }
    [[nodiscard]] MeasuredCurve interpolated() const { return {velocity, damping}; }
};

/// The points of a law by velocity; equal velocities once.
SizeCurve size_curve(const SampleData& sample, const LawData& law) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < law.damping->velocity.size(); ++i)
        points.push_back({law.damping->velocity[i], law.damping->damping[i]});
    std::ranges::sort(points, {}, &Point::x);
    SizeCurve curve{&sample};
    for (const Point& point : points) {
        if (!curve.velocity.empty() && curve.velocity.back() == point.x) continue;
        curve.velocity.push_back(point.x);
        curve.damping.push_back(point.y);
    }
    return curve;
}

/// "damping of 88 um is 1.02 to 1.31 times that of 104 um at equal velocity": smallest and largest size.
std::string sizes_statement(const std::string& law, std::vector<SizeCurve> sizes) {
    if (sizes.size() < 2) return {};
    std::ranges::sort(sizes, {}, [](const SizeCurve& size) { return size.sample->contact->radius.value; });
    const SizeCurve& small = sizes.front();
    const SizeCurve& large = sizes.back();
    if (!small.has_curve() || !large.has_curve()) return {};
    const MeasuredCurve one = small.interpolated();
    const MeasuredCurve other = large.interpolated();
    const double from = std::max(one.lower(), other.lower());
    const double to = std::min(one.upper(), other.upper());
    if (!(to > from))
        return fmt::format(" {}: no velocity is in the range of both {} and {}.", law, small.sample->name(),
                           large.sample->name());
    double least = one(from) / other(from);
    double greatest = least;
    for (int i = 0; i <= 64; ++i) {
        const double v = std::min(to, from + (to - from) * i / 64);
        least = std::min(least, one(v) / other(v));
        greatest = std::max(greatest, one(v) / other(v));
    }
    return fmt::format(
        " {}: from {:.3g} to {:.3g} m/s the damping of {} is {:.3g} to {:.3g} times that of {} at equal "
        "velocity.",
        law, from, to, small.sample->name(), least, greatest, large.sample->name());
}

Series size_series(const SizeCurve& size, const LawData& law, const Look& look) {
    Series series{.name = size.sample->name() + ", " + law.name, .legend = size.sample->name(), .look = look};
    if (size.has_curve()) {
        const MeasuredCurve curve = size.interpolated();
        for (int i = 0; i <= 40; ++i) {
            const double v =
                std::min(curve.upper(), curve.lower() + (curve.upper() - curve.lower()) * i / 40);
            series.line.push_back({v, curve(v)});
        }
    }
    for (std::size_t i = 0; i < size.velocity.size(); ++i)
        series.marks.push_back({size.velocity[i], size.damping[i]});
    return series;
}

}  // namespace

Figure restitution_figure(const RunData& run) {
    Figure figure{
        .id = "restitution",
        .title = "Restitution against incident velocity",
        .counterpart = "Figure 5",
        .caption =
            "Below the critical velocity a particle is captured (e_n = 0); just above it e_n rises "
            "steeply. Lines are the model of each law, from its critical velocity on: with the "
            "damping of the estimate where impacts were measured, else with that of the fit η(e_n), "
            "up to the greatest restitution of its data, in a band of what the uncertainty of that "
            "fit leaves open (95 %), the contact taken as known. Dashed: the reported v_c in its 95 % "
            "interval, in the colour of its law. The grey strip that begins at zero: captured by "
            "every law." +
            origin_sentence(run),
        .numbers = {.columns = {"sample", "law", "origin", "v_in [m/s]", "e_n", "v_in, lower end [m/s]",
                                "v_in, upper end [m/s]"}}};
    for (const SampleData& sample : run.samples())
        add_panel(figure, restitution_panel(sample, figure.numbers));
    finish(figure, false);
    return figure;
}

Figure damping_figure(const RunData& run) {
    const InvertedImpacts shown{
        .x = velocity_axis(),
        .y = damping_axis(run),
        .x_values = &DampingSeries::velocity,
        .y_values = &DampingSeries::damping,
        .line = [](const SampleData& sample,
                   const LawData& law) { return curve_series(sample, law, &CurveImpact::damping); },
        .listed = damping_columns};
    Figure figure{.id = "damping",
                  .title = "Damping against incident velocity",
                  .counterpart = "Figure 6",
                  .caption =
                      "The damping coefficient with which each law gives back each restitution, with the "
                      "model's curve where there is a fit. η falls as the velocity rises; with plastic "
                      "deformation it becomes flat and rises again.",
                  .numbers = damping_table(run)};
    bool any_boundary = false;
    for (const SampleData& sample : run.samples()) {
        XyPanel panel = inverted_panel(sample, shown, figure.numbers);
        panel.rules = boundaries(sample);
        any_boundary = any_boundary || !panel.rules.empty();
        add_panel(figure, std::move(panel));
    }
    figure.caption += any_boundary ? " Dashed verticals: where the falling part ends and the flat and the "
                                     "rising part begin, by the first law that has them."
                                   : " These data hold the falling part alone.";
    figure.caption += origin_sentence(run);
    finish(figure, false);
    return figure;
}

Figure damping_fit_figure(const RunData& run) {
    const InvertedImpacts shown{.x = restitution_axis(),
                                .y = damping_axis(run),
                                .x_values = &DampingSeries::restitution,
                                .y_values = &DampingSeries::damping,
                                .line = fit_series,
                                .listed = damping_columns};
    Figure figure{.id = "damping-fit",
                  .title = "Damping against restitution, with the fits",
                  .counterpart = "Table 2",
                  .caption =
                      "The same dampings over the restitution. The fit η(e_n) (line) is taken over the "
                      "rising branch of e_n(v_in) and meets the axis e_n = 0 at the critical damping, from "
                      "which a critical velocity follows." +
                      extrapolation_sentence(run) + origin_sentence(run),
                  .numbers = damping_table(run)};
    for (const SampleData& sample : run.samples())
        add_panel(figure, inverted_panel(sample, shown, figure.numbers));
    finish(figure, true);
    return figure;
}

Figure contact_time_figure(const RunData& run) {
    std::vector<double> times;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.damping != nullptr) times.push_back(greatest_of(law.damping->contact_time));
    InvertedImpacts shown{
        .x = velocity_axis(),
        .y = quantity_axis("contact time", "s", greatest_of(times)),
        .x_values = &DampingSeries::velocity,
        .y_values = &DampingSeries::contact_time,
        .line = [](const SampleData& sample,
                   const LawData& law) { return curve_series(sample, law, &CurveImpact::contact_time); },
        .listed = time_columns};
    shown.y.from_zero = true;
    Figure figure{.id = "contact-time",
                  .title = "Contact time against incident velocity",
                  .counterpart = "Figure 7",
                  .caption =
                      "From first touch to detachment, by each law with the damping of each impact, and "
                      "along the model's curve. The contact lasts the longer the nearer the impact is to "
                      "capture.",
                  .numbers = {.columns = {"sample", "law", "origin", "v_in [m/s]", "contact time [s]"}}};
    bool published = false;
    for (const SampleData& sample : run.samples()) {
        XyPanel panel = inverted_panel(sample, shown, figure.numbers);
        if (sample.sample->published)
            for (const auto& printed : sample.sample->published->contact_times) {
                published = true;
                const std::string name = display_name(printed.law.name());
                panel.series.push_back({.name = sample.name() + ", " + name + ", published",
                                        .legend = "published",
                                        .look = Look::plain(6),
                                        .marks = {{printed.velocity.value, printed.contact_time.value}}});
                figure.numbers.rows.push_back(
                    {sample.name(), name, "published", printed.velocity.value, printed.contact_time.value});
            }
        add_panel(figure, std::move(panel));
    }
    if (published) figure.caption += " Crosses: published values, at about the velocity printed.";
    figure.caption += origin_sentence(run);
    finish(figure, false);
    return figure;
}

Figure energy_figure(const RunData& run) {
    Figure figure{.id = "energy",
                  .title = "Where the incident energy goes",
                  .caption =
                      "Shares of the kinetic energy before impact, along the model's curve e_n(v_in) of each "
                      "law. The rebound keeps e_n² of it." +
                      energy_statement(run),
                  .numbers = {.columns = {"sample", "law", "v_in [m/s]"}},
                  .columns = 4,
                  .narrow_columns = 2,
                  .panel_height = 210};
    for (const Share& share : shares) figure.numbers.columns.emplace_back(share.name);
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            if (law.curve().empty()) continue;
            figure.panels.emplace_back(energy_panel(sample, law));
            for (const CurveImpact& impact : law.curve()) {
                std::vector<Cell> row{sample.name(), law.name, impact.velocity};
                for (const Share& share : shares) row.emplace_back(share.of(impact));
                figure.numbers.rows.push_back(std::move(row));
            }
        }
    return figure;
}

Figure sizes_figure(const RunData& run) {
    Figure figure{.id = "sizes",
                  .title = "Sizes compared: damping against incident velocity",
                  .counterpart = "Figure 8",
                  .caption =
                      "The dampings of all samples over one axis, a panel for each law. Lines interpolate "
                      "the points without overshoot, and only between them.",
                  .numbers = {.columns = {"law", "sample", "diameter [m]", "v_in [m/s]",
                                          "damping [" + run.damping_unit() + "]"}},
                  .columns = 2,
                  .panel_height = 250};
    std::vector<double> dampings;
    for (std::size_t choice = 0; choice < run.data().laws.size(); ++choice) {
        XyPanel panel{
            .title = display_name(run.data().laws[choice].law.name()), .x = velocity_axis(), .y = {}};
        std::vector<SizeCurve> sizes;
        for (std::size_t s = 0; s < run.samples().size(); ++s) {
            const SampleData& sample = run.samples()[s];
            const LawData& law = sample.laws[choice];
            if (law.damping == nullptr || law.damping->velocity.empty()) continue;
            sizes.push_back(size_curve(sample, law));
            panel.series.push_back(size_series(sizes.back(), law, Look::of(s, law.is_reconstructed())));
            for (const Mark& mark : panel.series.back().marks) {
                dampings.push_back(mark.y);
                figure.numbers.rows.push_back(
                    {law.name, sample.name(), 2 * sample.contact->radius.value, mark.x, mark.y});
            }
        }
        figure.caption += sizes_statement(panel.title, std::move(sizes));
        figure.panels.emplace_back(std::move(panel));
    }
    for (Panel& panel : figure.panels) {
        Axis& axis = std::get<XyPanel>(panel).y;
        axis = quantity_axis("η", run.damping_unit(), greatest_of(dampings));
        axis.from_zero = true;
    }
    share_axes(figure.panels, true, true);
    return figure;
}

}  // namespace ashimpact::report
