// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/figures/law_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ashimpact::report {

Look look_of(const LawData& law, bool hollow) {
    return Look::of(law.choice.law.index(), hollow);
}

Series curve_series(const SampleData& sample, const LawData& law,
                    const std::function<double(const CurveImpact&)>& y) {
    Series series{
        .name = sample.name + ", " + law.name + ", model", .legend = law.name, .look = look_of(law)};
    for (const CurveImpact& impact : law.curve) series.line.push_back({impact.velocity, y(impact)});
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
        if (law.headline.value) least = std::min(least, *law.headline.value);
    if (!std::isfinite(least)) return {};
    return {{0, least, "captured"}};
}

bool is_reconstructed(const LawData& law) {
    return law.measured != nullptr && law.measured->origin != Origin::measured;
}

std::vector<double> column_in(const Json& entry, const char* key) {
    std::vector<double> values;
    if (!entry.is_object() || !entry.contains(key) || !entry.at(key).is_object()) return values;
    for (const Json& value : entry.at(key).at("values"))
        values.push_back(value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
    return values;
}

std::string origin_sentence(const RunData& run) {
    if (!run.any_reconstructed()) return " Points are measured impacts.";
    const std::string hollow =
        " Hollow points are not measured: they are reconstructed from published fits η(e_n).";
    return run.any_measured() ? hollow + " Filled points are measured impacts." : hollow;
}

std::optional<double> extrapolated_velocity(const LawData& law) {
    if (!law.velocity_json.is_object() || !law.velocity_json.contains("extrapolated")) return std::nullopt;
    return number_in(law.velocity_json.at("extrapolated"), "critical_velocity");
}

std::string extrapolation_sentence(const RunData& run) {
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (extrapolated_velocity(law))
                return " The fit to measured impacts is made to the rebounds alone and extrapolated to e_n = "
                       "0: where a curve ends there is the extrapolated v_c of the table, not the answer, "
                       "which is estimated from rebounds and captures together.";
    return {};
}

}  // namespace ashimpact::report
