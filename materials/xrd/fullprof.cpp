// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/quantities/quantity.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

namespace {

constexpr std::string_view phase_heading = "=> Phase:";
constexpr std::string_view fraction_heading = "Fract(%):";

struct FullProfPhase {
    std::string name;
    int number = 0;
    std::size_t line = 0;
    bool has_fraction = false;
    std::optional<PrintedNumber> fraction{};  ///< [%], the uncertainty in the same unit
};

/// "1     Quartz" behind the heading.
FullProfPhase read_phase_line(std::string_view text, std::size_t line) {
    text = trimmed(text);
    const auto blank = std::min(text.find_first_of(" \t"), text.size());
    const auto number = read_number(text.substr(0, blank));
    const std::string_view name = trimmed(text.substr(blank));
    constexpr double most_phases = 10'000;  // what no refinement has
    if (!number || number->value < 1 || number->value > most_phases || name.empty())
        refuse_line(line, "cannot read " + in_quotes(text), "=> Phase: NUMBER NAME");
    return {.name = std::string(name), .number = static_cast<int>(number->value), .line = line};
}

/// "11.41( 2.25)": the number in brackets is in the unit of the value, not in its last digit.
std::optional<PrintedNumber> read_percentage(std::string_view text, std::size_t line) {
    text = trimmed(text);
    if (text.starts_with('*'))
        refuse_line(line, "the fraction is too wide for its field, " + in_quotes(text), "a number");
    const auto open = std::min(text.find('('), text.size());
    const std::string_view printed = trimmed(text.substr(0, std::min(open, text.find(' '))));
    if (says_no_number(printed)) return std::nullopt;
    auto number = read_number(printed);
    bool closed = true;
    if (number && open < text.size()) {
        const auto close = text.find(')', open);
        closed = close != std::string_view::npos;
        const std::string_view inside = closed ? trimmed(text.substr(open + 1, close - open - 1)) : "";
        const auto deviation = read_number(inside);
        if (deviation && deviation->value > 0) number->standard_uncertainty = deviation->value;
        if (deviation && deviation->value > 0 && inside.find('.') == std::string_view::npos)
            refuse_line(line, "the uncertainty in " + in_quotes(text) + " may be in last places",
                        "as FullProf writes it, in the unit of the value: 11.41( 2.25)");
        const bool readable = deviation && deviation->value >= 0;
        closed = closed && (readable || inside.starts_with('*') || says_no_number(inside));
    } else if (number && trimmed(text.substr(printed.size())).find_first_of("0123456789") == 0) {
        closed = false;
    }
    if (!number || !closed)
        refuse_line(line, "cannot read " + in_quotes(text), "a percentage such as 11.41( 2.25)");
    if (number->value < 0) refuse_line(line, "the fraction is below zero", "zero or more");
    return number;
}

/// The phases of each pattern: their numbers begin anew with it.
std::vector<std::vector<FullProfPhase>> patterns_of(const TextLines& file) {
    std::vector<std::vector<FullProfPhase>> patterns;
    for (const auto& [number, raw] : file.lines()) {
        const auto phase = raw.find(phase_heading);
        const auto fraction = raw.find(fraction_heading);
        if (phase != std::string_view::npos) {
            FullProfPhase read = read_phase_line(raw.substr(phase + phase_heading.size()), number);
            const bool begins = patterns.empty() || read.number <= patterns.back().back().number;
            if (begins) patterns.emplace_back();
            patterns.back().push_back(std::move(read));
        } else if (fraction != std::string_view::npos) {
            if (patterns.empty())
                refuse_line(number, "a fraction stands before the first phase",
                            "=> Phase: NUMBER NAME above it");
            FullProfPhase& current = patterns.back().back();
            if (current.has_fraction)
                refuse_line(number, "the phase " + in_quotes(current.name) + " has two fractions", "one");
            current.has_fraction = true;
            current.line = number;
            current.fraction = read_percentage(raw.substr(fraction + fraction_heading.size()), number);
        }
    }
    return patterns;
}

XrdSample sample_of(const std::vector<FullProfPhase>& phases, const TextLines& file) {
    std::vector<ListedPhase> listed;
    for (const FullProfPhase& phase : phases) {
        if (!phase.has_fraction)
            refuse_line(
                &phase == &phases.back() ? file.last_line() : phase.line,
                "the phase " + in_quotes(phase.name) + " has no Fract(%): the file seems to be cut off",
                "a complete summary");
        listed.push_back({phase.name, phase.line, phase.fraction});
    }
    XrdSample sample;
    const double total =
        add_fractions(sample, listed, "fraction", "Fract(%) above zero", phases.front().line);
    if (std::abs(total - 100) > 100 * default_closure_tolerance)
        refuse_line(phases.back().line,
                    "the fractions add up to " + shortest(std::round(total * 1e3) / 1e3) +
                        " %: a phase may be missing, or the rest be amorphous",
                    "100 % within 0.5 %, the crystalline part as FullProf writes it");
    return sample;
}

}  // namespace

bool looks_like_fullprof(const TextLines& file) {
    return file.text().find(phase_heading) != std::string::npos &&
           (file.text().find(fraction_heading) != std::string::npos ||
            file.text().find("Bragg R-factor") != std::string::npos);
}

XrdResult read_fullprof(const TextLines& file) {
    const auto patterns = patterns_of(file);
    XrdResult result{.format = XrdFormat::fullprof_sum, .samples = {}};
    for (const auto& phases : patterns) {
        result.samples.push_back(sample_of(phases, file));
        if (patterns.size() > 1)
            result.samples.back().name = "pattern " + std::to_string(result.samples.size());
    }
    return result;
}

}  // namespace ashimpact::xrd
