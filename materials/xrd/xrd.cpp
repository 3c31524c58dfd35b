// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/xrd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "core/quantities/checks.hpp"
#include "core/tables/text_lines.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

void normalise(std::vector<PhaseFraction>& phases, double total) {
    for (PhaseFraction& phase : phases) {
        phase.fraction /= total;
        if (phase.standard_uncertainty) *phase.standard_uncertainty /= total;
    }
}

std::string file_stem(std::string_view name) {
    name.remove_prefix(name.find_last_of("/\\") + 1);
    const auto dot = name.rfind('.');
    return std::string(dot == 0 ? name : name.substr(0, dot));
}

void set_density(PhaseFraction& phase, const PrintedNumber& density, std::vector<Finding>& findings) {
    phase.density = 1000 * density.value;  // g/cm3
    if (density.standard_uncertainty)
        findings.push_back({xrd_code, Severity::doubt,
                            "the uncertainty of the density of " + in_quotes(phase.name) + ", " +
                                readable_number(*density.standard_uncertainty) + " g/cm3, is not used"});
}

double add_fractions(XrdSample& sample, const std::vector<ListedPhase>& phases, const std::string& amount,
                     const std::string& needed, std::size_t line) {
    double total = 0;
    std::set<std::string> keys;
    for (const ListedPhase& phase : phases) {
        if (!keys.insert(phase_key(phase.name)).second)
            refuse_line(phase.line, "the phase " + in_quotes(phase.name) + " is there twice",
                        "each phase once");
        if (!phase.amount) {
            sample.warnings.push_back({xrd_code, Severity::remark,
                                       "the phase " + in_quotes(phase.name) + " has no " + amount +
                                           " (line " + std::to_string(phase.line) + ") and is left out"});
            continue;
        }
        sample.analysis.phases.push_back({.name = phase.name,
                                          .fraction = phase.amount->value,
                                          .standard_uncertainty = phase.amount->standard_uncertainty,
                                          .place = at_line(phase.line)});
        if (phase.density) set_density(sample.analysis.phases.back(), *phase.density, sample.warnings);
        total += phase.amount->value;
    }
    if (!(total > 0)) refuse_line(line, "no phase has a " + amount, needed);
    normalise(sample.analysis.phases, total);
    return total;
}

}  // namespace ashimpact::xrd

namespace ashimpact {

namespace {

struct Reader {
    bool (*recognises)(const TextLines&);
    XrdResult (*read)(const TextLines&);
};

/// Tried in this order: the formats that are recognised most reliably come first, tables last.
constexpr std::array readers{
    Reader{xrd::looks_like_json, xrd::read_json},   Reader{xrd::looks_like_bgmn, xrd::read_bgmn},
    Reader{xrd::looks_like_gsas2, xrd::read_gsas2}, Reader{xrd::looks_like_fullprof, xrd::read_fullprof},
    Reader{xrd::looks_like_topas, xrd::read_topas},
};

constexpr TextLimits xrd_limits{.content = "an XRD result", .bytes = longest_xrd_file};

XrdResult read_text(const TextLines& file, std::optional<DecimalMark> decimal) {
    for (const Reader& reader : readers) {
        if (!reader.recognises(file)) continue;
        if (decimal) throw InputError("a decimal mark is stated, and the file is no table", "a table");
        return reader.read(file);
    }
    if (xrd::looks_like_table(file)) return xrd::read_table(file, decimal);
    refuse_line(1, "the format is not known", xrd::known_formats);
}

/// A remark on phases without an uncertainty beside others with one.
void note_missing_uncertainties(XrdSample& sample) {
    std::vector<std::string> without;
    for (const PhaseFraction& phase : sample.analysis.phases)
        if (!phase.standard_uncertainty && phase.fraction > 0) without.push_back(in_quotes(phase.name));
    const auto has_one = [](const PhaseFraction& phase) { return phase.standard_uncertainty.has_value(); };
    if (without.empty() || !std::ranges::any_of(sample.analysis.phases, has_one)) return;
    sample.warnings.push_back(
        {xrd_code, Severity::remark,
         fmt::format("{} {} no uncertainty, as other phases do, and {} as exact", joined(without),
                     without.size() == 1 ? "has" : "have", without.size() == 1 ? "counts" : "count")});
}

XrdResult read(std::string_view bytes, const TableOptions& options) {
    const TableFile file(bytes, {.name = options.sheet,
                                 .option = "the name of a sheet (--sheet, in a case \"xrd_sheet\")",
                                 .code = xrd_code,
                                 .limits = xrd_limits,
                                 .holds_table = xrd::looks_like_table});
    return file.read([&](const TextLines& lines) {
        XrdResult result =
            lines.of_sheet() ? xrd::read_table(lines, options.decimal) : read_text(lines, options.decimal);
        file.add_findings(result.warnings);
        for (XrdSample& sample : result.samples) {
            file.name_rows(sample.warnings);
            note_missing_uncertainties(sample);
            for (PhaseFraction& phase : sample.analysis.phases) phase.place = file.place(phase.place);
        }
        return result;
    });
}

}  // namespace

XrdResult read_xrd(std::string_view text, std::string_view name, const TableOptions& options) {
    return at_place(FileName{std::string(name)}, [&] {
        XrdResult result = read(text, options);
        if (result.reading.empty())
            result.reading =
                fmt::format("{}, {}", name_of(result.format), counted(result.samples.size(), "sample"));
        for (XrdSample& sample : result.samples) {
            if (sample.name.empty()) sample.name = xrd::file_stem(name);
            if (auto doubt = xrd::mark_standards(sample.analysis, sample.name))
                sample.warnings.push_back(std::move(*doubt));
        }
        return result;
    });
}

std::optional<Finding> other_sample_finding(std::string_view code, std::string_view data,
                                            const std::string& named, std::string_view file,
                                            const std::string& sample) {
    const auto plain = [](const std::string& name) {  // "FA 1" and "fa1", but not "FA1'" and "FA -45"
        std::string text = lower_case(name);
        std::erase_if(text, [](char c) { return c == ' ' || c == '_'; });
        return text;
    };
    if (named == xrd::file_stem(file) || plain(named) == plain(sample)) return std::nullopt;
    return Finding{code, Severity::remark,
                   fmt::format("the {} are those of the sample {}", data, in_quotes(named))};
}

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
    const double total = std::transform_reduce(phases.begin(), phases.end(), 0.0, std::plus(),
                                               [](const PhaseFraction& phase) { return phase.fraction; });
    const double closure = result.analysis.closure_tolerance;
    if (std::abs(total - 1) > closure && std::abs(measured.fraction - added_fraction) > closure)
        throw InputError("with the internal standard the fractions add up to " +
                             shortest(std::round(total * 1e4) / 100) + " %, and a refinement gives 100 %",
                         "100 % within 0.5 %; or fractions of the whole mixture, of which " +
                             shortest(std::round(added_fraction * 1e4) / 100) + " % are " +
                             std::string(standard));
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
    result.analysis.state_amorphous(remainder);
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
