// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/figures/law_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace ashimpact::report {

Look look_of(const LawData& law, bool hollow) {
    return Look::of(law.choice.law.index(), hollow);
}

Series curve_series(const SampleData& sample, const LawData& law,
                    const std::function<double(const CurveImpact&)>& y) {
    Series series{
        .name = sample.name() + ", " + law.name + ", model", .legend = law.name, .look = look_of(law)};
    for (const CurveImpact& impact : law.curve()) series.line.push_back({impact.velocity, y(impact)});
    return series;
}

std::vector<Point> velocity_band(const ModelCurve& curve) {
    std::vector<Point> band;
    for (const CurveImpact& impact : curve)
        if (std::isfinite(impact.lower) && std::isfinite(impact.upper))
            band.push_back({impact.upper, impact.restitution});
    std::for_each(curve.rbegin(), curve.rend(), [&](const CurveImpact& impact) {
        if (std::isfinite(impact.lower) && std::isfinite(impact.upper))
            band.push_back({impact.lower, impact.restitution});
    });
    return band;
}

std::vector<Region> capture_region(const SampleData& sample) {
    double least = std::numeric_limits<double>::infinity();
    for (const LawData& law : sample.laws)
        if (const auto head = law.headline()) least = std::min(least, head->value);
    if (!std::isfinite(least)) return {};
    return {{0, least, "captured"}};
}

bool is_reconstructed(const LawData& law) {
    return law.measured != nullptr && law.measured->origin != Origin::measured;
}

std::string origin_of(const DampingSeries& series) {
    return std::string(name_of(series.origin));
}

Cell cell_of(const std::optional<double>& value) {
    return value ? Cell(*value) : Cell(std::string());
}

Row sobol_row(const std::string& label, const std::string& name, const Look& look, double first, double total,
              const std::optional<double>& total_error) {
    Row row{.label = label,
            .items = {{.kind = RowItem::Kind::bar,
                       .from = 0,
                       .to = total,
                       .look = look,
                       .name = fmt::format("{}: total {:.3g} %", name, 100 * total)}}};
    if (total_error)
        row.items.push_back({.kind = RowItem::Kind::interval,
                             .from = total - *total_error,
                             .to = total + *total_error,
                             .look = look,
                             .name = fmt::format("{}: ± {:.2g} %", name, 100 * *total_error)});
    row.items.push_back({.kind = RowItem::Kind::mark,
                         .from = 0,
                         .to = first,
                         .look = Look::plain(3),
                         .name = fmt::format("{}: first order {:.3g} %", name, 100 * first),
                         .legend = "first order; bar: total"});
    return row;
}

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

std::string extrapolation_sentence(const RunData& run) {
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.extrapolated())
                return " The fit to measured impacts is made to the rebounds alone and extrapolated to e_n = "
                       "0: where a curve ends there is the extrapolated v_c of the table, not the answer, "
                       "which is estimated from rebounds and captures together.";
    return {};
}

}  // namespace ashimpact::report
