// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"
#include "materials/xrd/xrd.hpp"

namespace ashimpact {

XrdSample with_internal_standard(const XrdSample& sample, std::string_view standard, double added_fraction,
                                 std::optional<double> added_uncertainty) {
    if (!(added_fraction > 0 && added_fraction < 1))
        throw InputError("the weight fraction of the internal standard is " + shortest(added_fraction),
                         "above 0, below 1 (weight of the standard over that of the mixture)");
    if (sample.analysis.basis != FractionBasis::weight)
        throw InputError("an internal standard needs fractions by weight", "weight fractions");
    XrdSample result = sample;
    auto& phases = result.analysis.phases;
    const auto found = std::find_if(phases.begin(), phases.end(), [&](const PhaseFraction& phase) {
        return phase_key(phase.name) == phase_key(standard);
    });
    if (found == phases.end()) {
        std::vector<std::string> names;
        names.reserve(phases.size());
        for (const PhaseFraction& phase : phases) names.push_back(phase.name);
        const std::string owner = sample.name.empty() ? "" : " of " + in_quotes(sample.name);
        throw InputError("the internal standard " + in_quotes(standard) + " is not among the phases" + owner,
                         joined(names));
    }
    const PhaseFraction measured = *found;
    if (!(measured.fraction > 0))
        throw InputError("the internal standard " + in_quotes(standard) + " has no measured fraction",
                         "a fraction above zero");
    phases.erase(found);
    const double scale = added_fraction / (measured.fraction * (1 - added_fraction));
    double crystalline = 0;
    for (const PhaseFraction& phase : phases) crystalline += scale * phase.fraction;
    if (crystalline > 1 + result.analysis.closure_tolerance)
        throw InputError("by the internal standard " + shortest(std::round(crystalline * 1e4) / 100) +
                             " % of the sample are crystalline",
                         "100 % or less: is the added weight right?");
    AmorphousRemainder remainder{.scale = scale};
    // d ln p = d ln w_s + d w_s/(1 - w_s) - d ln c_s
    if (measured.standard_uncertainty || added_uncertainty)
        remainder.standard_uncertainty =
            scale * std::hypot(measured.standard_uncertainty.value_or(0) / measured.fraction,
                               added_uncertainty.value_or(0) / (added_fraction * (1 - added_fraction)));
    result.analysis.amorphous = remainder;
    return result;
}

std::vector<PhaseFraction> adiabatic_fractions(const std::vector<PeakIntensity>& peaks) {
    std::vector<PhaseFraction> fractions;
    double total = 0;
    for (const PeakIntensity& peak : peaks) {
        require_not_negative("intensity of " + peak.name, peak.intensity, Dimension::fraction);
        require_positive("reference intensity ratio of " + peak.name, peak.reference_intensity_ratio,
                         Dimension::fraction);
        const double amount = peak.intensity / peak.reference_intensity_ratio;
        PhaseFraction fraction{.name = peak.name, .fraction = amount};
        if (peak.intensity_uncertainty || peak.ratio_uncertainty)
            fraction.standard_uncertainty =
                std::hypot(peak.intensity_uncertainty.value_or(0) / peak.reference_intensity_ratio,
                           amount * peak.ratio_uncertainty.value_or(0) / peak.reference_intensity_ratio);
        fractions.push_back(std::move(fraction));
        total += amount;
    }
    if (!(total > 0)) throw InputError("all intensities are zero", "at least one peak");
    xrd::normalise(fractions, total);
    return fractions;
}

}  // namespace ashimpact
