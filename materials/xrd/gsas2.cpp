// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

namespace {

constexpr std::string_view weight_label = "Weight fraction";
constexpr std::string_view in_histogram = " in histogram: ";

bool is_weight_line(std::string_view text) {
    return text.starts_with("Phase fraction") && text.find(weight_label) != std::string_view::npos;
}

/// "LABEL : VALUE, sig VALUE"
PrintedNumber weight_in(std::string_view text, std::size_t line) {
    std::string_view rest = text.substr(text.find(weight_label) + weight_label.size());
    rest = trimmed(rest.substr(std::min(rest.find(':') + 1, rest.size())));
    const auto comma = rest.find(',');
    const auto value = read_number(rest.substr(0, comma));
    std::optional<PrintedNumber> sigma;
    if (comma != std::string_view::npos) {
        std::string_view behind = trimmed(rest.substr(comma + 1));
        if (behind.starts_with("sig")) sigma = read_number(behind.substr(3));
    }
    if (!value || (comma != std::string_view::npos && !(sigma && sigma->value >= 0)))
        refuse_line(line, "cannot read the weight fraction " + in_quotes(rest), "\"NUMBER, sig NUMBER\"");
    PrintedNumber weight = *value;
    if (sigma && sigma->value > 0) weight.standard_uncertainty = sigma->value;
    if (weight.value < 0 || weight.value > 1)
        refuse_line(line, "the weight fraction is " + shortest(weight.value), "0 to 1");
    return weight;
}

/// State of the reader while it goes through the file.
struct Scan {
    std::string phase{};
    std::string histogram{};
    std::string described_phase{};                     ///< under "Result for phase"
    std::map<std::string, PrintedNumber> densities{};  ///< [g/cm3]
    std::vector<XrdSample> samples{};
    std::map<std::string, std::size_t> places{};                  ///< of the samples, by histogram
    std::set<std::pair<std::string, std::string>> known_pairs{};  ///< histogram and phase

    XrdSample& sample() {
        const auto [place, is_new] = places.emplace(histogram, samples.size());
        return is_new ? samples.emplace_back(XrdSample{.name = histogram}) : samples[place->second];
    }
};

void read_scan_heading(Scan& scan, std::string_view text) {
    const std::string_view rest = text.substr(std::string_view("Phase:").size());
    const auto split = rest.find(in_histogram);
    if (split == std::string_view::npos) return;
    scan.phase = trimmed(rest.substr(0, split));
    std::string_view histogram = trimmed(rest.substr(split + in_histogram.size()));
    if (histogram.starts_with("PWDR ")) histogram.remove_prefix(5);
    scan.histogram = histogram;
}

void read_weight_line(Scan& scan, std::string_view text, std::size_t line) {
    if (scan.phase.empty())
        refuse_line(line, "a weight fraction stands before any phase heading",
                    "\"Phase: NAME in histogram: NAME\"");
    const PrintedNumber weight = weight_in(text, line);
    if (!scan.known_pairs.emplace(scan.histogram, scan.phase).second)
        refuse_line(line,
                    "the phase " + in_quotes(scan.phase) + " is there twice in " + in_quotes(scan.histogram),
                    "each phase once");
    scan.sample().analysis.phases.push_back({.name = scan.phase,
                                             .fraction = weight.value,
                                             .standard_uncertainty = weight.standard_uncertainty,
                                             .place = at_line(line)});
}

void read_density(Scan& scan, std::string_view text, std::size_t line) {
    std::string_view value = trimmed(text.substr(std::string_view("Density:").size()));
    value = value.substr(0, value.find(' '));
    const auto density = read_number(value);
    if (!density || !(density->value > 0))
        refuse_line(line, "cannot read the density " + in_quotes(value), "a positive number in g/cm**3");
    scan.densities[scan.described_phase] = *density;
}

/// GSAS-II normalises the fractions of a histogram: any other sum means that blocks are missing.
void require_closed(const XrdSample& sample, const TextLines& file) {
    double total = 0;
    for (const PhaseFraction& phase : sample.analysis.phases) total += phase.fraction;
    if (std::abs(total - 1) > default_closure_tolerance)
        refuse_line(file.last_line(),
                    "the weight fractions of " + in_quotes(sample.name) + " add up to " +
                        shortest(std::round(total * 1e5) / 1e5) + ", the file seems to be cut off or edited",
                    "1 within 0.005");
}

}  // namespace

bool looks_like_gsas2(const TextLines& file) {
    if (file.text().find("GSAS-II") != std::string::npos) return true;
    return std::any_of(file.lines().begin(), file.lines().end(),
                       [](const TextLine& line) { return is_weight_line(trimmed(line.text)); });
}

XrdResult read_gsas2(const TextLines& file) {
    Scan scan;
    for (const auto& [number, raw] : file.lines()) {
        const std::string_view text = trimmed(raw);
        if (text.starts_with("Phase:"))
            read_scan_heading(scan, text);
        else if (text.starts_with("Result for phase:"))
            scan.described_phase = trimmed(text.substr(std::string_view("Result for phase:").size()));
        else if (text.starts_with("Density:") && !scan.described_phase.empty())
            read_density(scan, text, number);
        else if (is_weight_line(text))
            read_weight_line(scan, text, number);
    }
    if (scan.samples.empty())
        refuse_line(file.last_line(), "there is no refined weight fraction",
                    "lines \"Phase fraction : ... Weight fraction : ...\"");
    for (XrdSample& sample : scan.samples) {
        require_closed(sample, file);
        for (PhaseFraction& phase : sample.analysis.phases)
            if (const auto density = scan.densities.find(phase.name); density != scan.densities.end())
                set_density(phase, density->second, sample.warnings);
    }
    return {.format = XrdFormat::gsas2_lst, .samples = std::move(scan.samples)};
}

}  // namespace ashimpact::xrd
