// SPDX-License-Identifier: GPL-3.0-or-later
// Critical velocities over the sizes of the field: what others measured, laws and the samples of a run.
#include "pipeline/case/literature.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/run/laws_by_size.hpp"

namespace ashimpact::report {

namespace {

constexpr double length_of_bound = 3;  ///< the line below an upper bound ends at the bound over this

/// The velocities of one source. An upper bound is a hollow mark at the top of a line.
std::vector<Series> source_series(const LiteratureSource& source, std::size_t position, NumberTable& table) {
    std::vector<Series> all;
    for (const LiteratureVelocity& each : source.velocities) {
        if (!each.diameter) continue;
        const double lower = each.lower.value_or(each.upper / length_of_bound);
        Series series{.name = fmt::format("{}, {}", source.key, each.name),
                      .legend = fmt::format("{}, {} on {}{}", source.key, each.particle, each.wall,
                                            each.lower ? "" : ", upper bound"),
                      .look = Look::of(position, each.basis != VelocityBasis::measured || !each.lower)};
        series.look.dash = 0;
        series.marks.push_back({*each.diameter, each.upper});
        if (lower < each.upper) series.line = {{*each.diameter, lower}, {*each.diameter, each.upper}};
        all.push_back(std::move(series));
        table.rows.push_back({source.key + ", " + each.name, *each.diameter, each.upper, cell_of(each.lower),
                              each.upper, std::string()});
    }
    return all;
}

std::string exponent_text(double exponent) {
    return fmt::format("{:.2f}", std::abs(exponent) < 0.005 ? 0.0 : exponent);
}

/// "JKR, d^-0.83", or the range of its exponents.
Series line_of_law(const LawBySize& by_size, NumberTable& table) {
    const std::string law = display_name(by_size.law.name());
    const auto [least, greatest] = std::ranges::minmax_element(by_size.curve, {}, &VelocityOfSize::exponent);
    const std::string steepest = exponent_text(least->exponent);
    const std::string flattest = exponent_text(greatest->exponent);
    Series series{
        .name = law,
        .legend = fmt::format("{}, d^{}", law, steepest) + (steepest == flattest ? "" : " to d^" + flattest),
        .look = Look::plain(0)};
    series.look.dash = 1 + by_size.law.index() % 6;
    series.look.thin = true;
    for (const VelocityOfSize& size : by_size.curve) {
        series.line.push_back({size.diameter, size.velocity});
        table.rows.push_back({law + ", a line", size.diameter, size.velocity, "", "", size.exponent});
    }
    return series;
}

/// The velocity of a sample by the reported law, on its interval.
Series sample_series(const SampleData& sample, const ReportedVelocity& reported, NumberTable& table) {
    const double velocity = reported.velocity->value;
    const double diameter = *sample.comparison->diameter;
    Series series{.name = sample.name(), .legend = "this run", .look = Look::plain(2)};
    series.marks.push_back({diameter, velocity});
    const Bounds bounds = reported.interval.value_or(Bounds{});
    if (bounds.lower && bounds.upper && *bounds.lower > 0)
        series.line = {{diameter, *bounds.lower}, {diameter, *bounds.upper}};
    table.rows.push_back(
        {sample.name(), diameter, velocity, cell_of(bounds.lower), cell_of(bounds.upper), std::string()});
    return series;
}

}  // namespace

Figure literature_figure(const std::vector<LawBySize>& laws) {
    Figure figure{
        .id = "critical-velocity-by-size",
        .title = "Critical velocity against size: what others measured",
        .caption =
            "Marks are published critical velocities, each of its own particles and wall; what was read "
            "states no uncertainties. A filled mark was measured, that of silver with impact velocities "
            "from a model of the flow; a hollow one is an upper bound (with a line below it), a model's or "
            "second-hand. Charge holds the glass at 0.15 m/s. SiO2, ice and the ash of Hu et al. were read "
            "without a diameter and are missing. Fine lines are contact laws with one set of constants; "
            "without damping JKR has d^-0.83. ",
        .numbers = {.columns = {"what", "diameter [m]", "v_c [m/s]", "lower [m/s]", "upper [m/s]",
                                "exponent of the line"}},
        .columns = 1,
        .panel_height = 380};
    const std::vector<double>& sizes = sizes_of_the_field();
    XyPanel panel{.title = "",
                  .x = {.label = "diameter",
                        .unit = "µm",
                        .scale = 1e-6,
                        .spacing = Spacing::logarithmic,
                        .from = sizes.front(),
                        .to = sizes.back()},
                  .y = {.label = "v_c", .unit = "m/s", .spacing = Spacing::logarithmic}};
    for (const LawBySize& law : laws) panel.series.push_back(line_of_law(law, figure.numbers));
    std::size_t position = 0;
    for (const LiteratureSource& source : literature()) {
        auto series = source_series(source, position, figure.numbers);
        if (!series.empty()) ++position;
        panel.series.insert(panel.series.end(), series.begin(), series.end());
    }
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

Figure calibrated_velocities_figure(const CalibrationProblem& problem,
                                    const std::vector<CalibratedVelocity>& line,
                                    const std::string& conclusion) {
    const std::string law = display_name(problem.critical_velocities.front().law.name());
    Figure figure{
        .id = "calibrated-velocities",
        .title = "Critical velocity against size: " + law + " with calibrated constants",
        .caption = fmt::format("Marks are the velocities with 95 % intervals of their stated or assumed "
                               "uncertainty. The line is {}; its band is that of the constants, 95 %, "
                               "with their correlation. {}",
                               law, conclusion),
        .numbers = {.columns = {"what", "diameter [m]", "v_c [m/s]", "lower [m/s]", "upper [m/s]"}},
        .columns = 1,
        .panel_height = 380};
    XyPanel panel{.title = "",
                  .x = {.label = "diameter", .unit = "µm", .scale = 1e-6, .spacing = Spacing::logarithmic},
                  .y = {.label = "v_c", .unit = "m/s", .spacing = Spacing::logarithmic}};
    Series fitted{.name = law, .legend = law, .look = Look::of(0)};
    std::vector<Point> upper_ends;
    for (const CalibratedVelocity& each : line) {
        fitted.line.push_back({each.diameter, each.velocity.value_or(std::nan(""))});
        figure.numbers.rows.push_back({law, each.diameter, cell_of(each.velocity),
                                       cell_of(each.interval.lower), cell_of(each.interval.upper)});
        if (!each.interval.lower || !each.interval.upper) continue;
        fitted.band.push_back({each.diameter, *each.interval.lower});
        upper_ends.push_back({each.diameter, *each.interval.upper});
    }
    fitted.band.insert(fitted.band.end(), upper_ends.rbegin(), upper_ends.rend());
    panel.series.push_back(std::move(fitted));
    for (const CriticalVelocityObservation& each : problem.critical_velocities) {
        const double diameter = problem.samples[each.sample].diameter;
        const double factor = std::exp(confidence_quantile() * each.standard_uncertainty / each.value);
        Series mark{.name = "given", .legend = "given velocities", .look = Look::plain(0)};
        mark.marks.push_back({diameter, each.value});
        mark.line = {{diameter, each.value / factor}, {diameter, each.value * factor}};
        panel.series.push_back(std::move(mark));
        figure.numbers.rows.push_back(
            {std::string("given"), diameter, each.value, each.value / factor, each.value * factor});
    }
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

Figure critical_velocity_by_size_figure(const RunData& run) {
    const ComparisonResult& comparison = run.run().comparison;
    Figure figure = literature_figure(comparison.laws_by_size);
    figure.caption +=
        "Here they have the constants of this run's particles, beyond its sizes those of the nearest "
        "sample, and no damping, which raises v_c: no prediction for other materials, and a mark on one of "
        "them is no test of it. JKR is the highest of the elastic ones, and holds for large and soft "
        "spheres alone. Thick lines are the assumptions on damping of the figure which-sizes, over the "
        "sizes for which it has them. Velocities of this run and published ones of the same impacts agree "
        "by calibration.";
    auto& panel = std::get<XyPanel>(figure.panels.front());
    for (const SizeBasis basis : all_values<SizeBasis>) {
        if (basis == SizeBasis::adhesion || basis == SizeBasis::measured) continue;
        Series series = size_series_of(comparison, basis);
        series.band.clear();
        if (!series.line.empty()) panel.series.push_back(std::move(series));
    }
    std::vector<Series> samples;  // below the other marks, which may be of the same impacts
    for (const SampleData& sample : run.samples()) {
        const auto& reported = sample.comparison->reported;
        if (reported && reported->velocity && sample.comparison->diameter)
            samples.push_back(sample_series(sample, *reported, figure.numbers));
    }
    panel.series.insert(panel.series.begin(), samples.begin(), samples.end());
    return figure;
}

}  // namespace ashimpact::report
