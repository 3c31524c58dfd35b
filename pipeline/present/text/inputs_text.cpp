// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/result_text.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t most_samples = 6;  // shown; a case may have thousands

/// "1.4 to 4.6 m/s", or one value where the ends print alike. Empty without values.
std::string range_text(const std::vector<double>& values, const std::string& unit) {
    if (values.empty()) return {};
    const auto [least, greatest] = std::ranges::minmax(values);
    const std::string from = readable_number(least, 3), to = readable_number(greatest, 3);
    return from + (from == to ? "" : " to " + to) + (unit.empty() ? "" : " " + unit);
}

std::vector<double> values_of(const std::vector<Measurement>& points,
                              const std::function<double(const Measurement&)>& value) {
    std::vector<double> values(points.size());
    std::transform(points.begin(), points.end(), values.begin(), value);
    return values;
}

std::string impacts_text(const MeasurementSet& set) {
    const auto& points = set.points;
    const std::size_t impacts =
        std::accumulate(points.begin(), points.end(), std::size_t{0},
                        [](std::size_t sum, const Measurement& point) { return sum + point.count; });
    std::string text = impacts == points.size()
                           ? fmt::format("{} impacts", impacts)
                           : fmt::format("{} means of {} impacts", points.size(), impacts);
    if (!set.sheet.empty()) text += " of sheet " + in_quotes(set.sheet);
    text += ", v_in " + range_text(values_of(points, &Measurement::velocity), "m/s");
    std::vector<Measurement> rebounds;
    std::ranges::copy_if(points, std::back_inserter(rebounds), std::not_fn(&Measurement::captured));
    if (!rebounds.empty()) text += ", e_n " + range_text(values_of(rebounds, &Measurement::restitution), "");
    text += fmt::format(", {}{} captured", set.captures(), impacts == points.size() ? "" : " of the means");
    if (!set.has_noise()) return text + ", no uncertainties";
    const auto deviation = [&](double VelocityNoise::*variance, const std::vector<Measurement>& of) {
        return range_text(
            values_of(of, [&](const Measurement& point) { return std::sqrt((*point.noise).*variance); }),
            "m/s");
    };
    text += ", u(v_in) " + deviation(&VelocityNoise::incident, points);
    return rebounds.empty() ? text : text + ", u(v_r) " + deviation(&VelocityNoise::rebound, rebounds);
}

/// The phases, the largest first.
std::string phases_text(std::vector<PhaseShare> phases) {
    std::ranges::sort(phases, [](const PhaseShare& a, const PhaseShare& b) {
        return std::tie(b.weight_fraction, a.phase) < std::tie(a.weight_fraction, b.phase);
    });
    std::string text;
    for (const PhaseShare& share : phases)
        text +=
            (text.empty() ? "" : ", ") + share.phase + " " + readable_number(100 * share.weight_fraction, 3);
    return text + " % by weight";
}

/// "u 0.5 to 2 %"; empty without uncertainties.
std::string uncertainties_text(std::vector<double> stated) {
    if (stated.empty()) return {};
    for (double& each : stated) each *= 100;
    return ", u " + range_text(stated, "%");
}

/// Stated uncertainties of the phases as parts of the whole sample [1].
std::vector<double> uncertainties_of(const std::vector<PhaseFraction>& phases,
                                     const std::vector<PhaseShare>& shares) {
    std::vector<double> uncertainties;
    for (const PhaseFraction& phase : phases) {
        if (!(phase.standard_uncertainty.value_or(0) > 0)) continue;
        const auto share = std::ranges::find(shares, phase.name, &PhaseShare::name);
        const double scale =
            share != shares.end() && phase.fraction > 0 ? share->weight_fraction / phase.fraction : 1;
        uncertainties.push_back(scale * *phase.standard_uncertainty);
    }
    return uncertainties;
}

/// ", u 10 % of the amorphous part": stated, or by an internal standard. Empty without.
std::string amorphous_text(const Analysis& analysis, const std::vector<PhaseShare>& shares) {
    double crystalline = 0;
    for (const PhaseShare& share : shares)
        if (std::ranges::find(analysis.phases, share.name, &PhaseFraction::name) != analysis.phases.end())
            crystalline += share.weight_fraction;
    const double stated = std::visit(
        [&]<class Part>(const Part& part) {
            if constexpr (std::is_same_v<Part, AmorphousRemainder>)
                return part.standard_uncertainty.value_or(0) / part.scale * crystalline;
            else if constexpr (requires { part.standard_uncertainty; })
                return part.standard_uncertainty.value_or(0);
            else
                return 0.0;
        },
        analysis.amorphous);
    return stated > 0 ? uncertainties_text({stated}) + " of the amorphous part" : std::string();
}

/// The phases and oxides of a sample as they were read, with the range of their uncertainties.
std::string composition_text(const Sample& sample, const std::vector<PhaseShare>& shares) {
    const std::string none = ", no uncertainties";
    const std::string of_phases = uncertainties_text(uncertainties_of(sample.analysis.phases, shares)) +
                                  amorphous_text(sample.analysis, shares);
    std::string text = "; " + phases_text(shares) + (of_phases.empty() ? none : of_phases);
    if (!sample.glass.oxides) return text;
    std::vector<double> stated;
    for (const OxideShare& oxide : sample.glass.oxides->oxides)
        if (oxide.standard_uncertainty.value_or(0) > 0) stated.push_back(*oxide.standard_uncertainty);
    return text + fmt::format("; {} oxides", sample.glass.oxides->oxides.size()) +
           (stated.empty() ? none : uncertainties_text(stated));
}

/// A quantity with its uncertainty, however small: "0.05 kg/m3" may have been meant as 5 %.
std::string as_stated(const Quantity& quantity) {
    const std::string text = readable(quantity);
    const double uncertainty = quantity.standard_uncertainty.value_or(0);
    if (!(uncertainty > 0) || text.find("+-") != std::string::npos) return text;
    return fmt::format("{} (u {})", text, readable(uncertainty, quantity.unit));
}

}  // namespace

std::string inputs_text(const Run& run, std::size_t width) {
    std::string text = "What was read of each sample:\n\n";
    const auto& samples = run.data.samples;
    for (std::size_t i = 0; i < std::min(samples.size(), most_samples); ++i) {
        const Sample& sample = samples[i];
        std::string line = sample.name + ": " + as_stated(sample.diameter.quantity);
        if (sample.density) line += ", " + as_stated(sample.density->quantity);
        if (i < run.contact.samples.size() && run.contact.samples[i].work_of_adhesion.quantity.value > 0)
            line += ", w " + as_stated(run.contact.samples[i].work_of_adhesion.quantity);
        if (i < run.modulus.samples.size()) line += composition_text(sample, run.modulus.samples[i].phases);
        const auto* source = sample.restitution ? &*sample.restitution : nullptr;
        if (const auto* measured = source ? std::get_if<MeasuredRestitution>(source) : nullptr)
            line += "; " + impacts_text(measured->impacts);
        text += wrapped(line, width, 2) + "\n";
    }
    if (samples.size() > most_samples)
        text += fmt::format("and {} more samples\n", samples.size() - most_samples);
    return text + "\n";
}

}  // namespace ashimpact
