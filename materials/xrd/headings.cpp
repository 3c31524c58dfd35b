// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/headings.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text.hpp"

namespace ashimpact::xrd {

namespace {

/// Lower-case letters, digits, per cent and plus-minus signs; the rest is dropped.
std::string key_of(std::string_view text) {
    std::string key;
    for (const char c : lower_case(text)) {
        const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '%' || c == '+' ||
                          static_cast<unsigned char>(c) >= 0x80;
        if (kept) key += c;
    }
    return key;
}

std::string without_per_cent(std::string key) {
    std::erase(key, '%');
    for (const std::string_view word : {"percent", "pct", "prozent"}) {
        const auto found = key.find(word);
        if (found != std::string::npos) key.erase(found, word.size());
    }
    return key;
}

struct Alias {
    std::string_view key;
    Role role;
};

/// Headings without per cent signs; the empty one is a bare "%".
constexpr std::array aliases{
    Alias{"sample", Role::sample},
    Alias{"samplename", Role::sample},
    Alias{"sampleid", Role::sample},
    Alias{"specimen", Role::sample},
    Alias{"probe", Role::sample},
    Alias{"probenname", Role::sample},
    Alias{"\u00e9chantillon", Role::sample},
    Alias{"echantillon", Role::sample},
    Alias{"phase", Role::phase},
    Alias{"phasename", Role::phase},
    Alias{"phases", Role::phase},
    Alias{"mineral", Role::phase},
    Alias{"mineralname", Role::phase},
    Alias{"mineralphase", Role::phase},
    Alias{"compound", Role::phase},
    Alias{"compoundname", Role::phase},
    Alias{"component", Role::phase},
    Alias{"structure", Role::phase},
    Alias{"name", Role::phase},
    Alias{"phasenname", Role::phase},
    Alias{"verbindung", Role::phase},
    Alias{"min\u00e9ral", Role::phase},
    Alias{"", Role::weight},
    Alias{"weight", Role::weight},
    Alias{"weights", Role::weight},
    Alias{"weightfraction", Role::weight},
    Alias{"wt", Role::weight},
    Alias{"wtfraction", Role::weight},
    Alias{"w", Role::weight},
    Alias{"mass", Role::weight},
    Alias{"massfraction", Role::weight},
    Alias{"gew", Role::weight},
    Alias{"gewicht", Role::weight},
    Alias{"gewichts", Role::weight},
    Alias{"gewichtsanteil", Role::weight},
    Alias{"masse", Role::weight},
    Alias{"massen", Role::weight},
    Alias{"massenanteil", Role::weight},
    Alias{"anteil", Role::weight},
    Alias{"gehalt", Role::weight},
    Alias{"teneur", Role::weight},
    Alias{"pds", Role::weight},
    Alias{"content", Role::weight},
    Alias{"quantity", Role::weight},
    Alias{"amount", Role::weight},
    Alias{"concentration", Role::weight},
    Alias{"rietveld", Role::weight},
    Alias{"semiquant", Role::weight},
    Alias{"fraction", Role::weight},
    Alias{"volume", Role::volume},
    Alias{"volumefraction", Role::volume},
    Alias{"vol", Role::volume},
    Alias{"volfraction", Role::volume},
    Alias{"uncertainty", Role::uncertainty},
    Alias{"standarduncertainty", Role::uncertainty},
    Alias{"weightuncertainty", Role::uncertainty},
    Alias{"weighterror", Role::uncertainty},
    Alias{"error", Role::uncertainty},
    Alias{"err", Role::uncertainty},
    Alias{"su", Role::uncertainty},
    Alias{"u", Role::uncertainty},
    Alias{"standarderror", Role::uncertainty},
    Alias{"standarddeviation", Role::uncertainty},
    Alias{"fehler", Role::uncertainty},
    Alias{"messfehler", Role::uncertainty},
    Alias{"standardfehler", Role::uncertainty},
    Alias{"abweichung", Role::uncertainty},
    Alias{"standardabweichung", Role::uncertainty},
    Alias{"stdabw", Role::uncertainty},
    Alias{"unsicherheit", Role::uncertainty},
    Alias{"erreur", Role::uncertainty},
    Alias{"incertitude", Role::uncertainty},
    Alias{"esd", Role::uncertainty},
    Alias{"sigma", Role::uncertainty},
    Alias{"sig", Role::uncertainty},
    Alias{"std", Role::uncertainty},
    Alias{"stdev", Role::uncertainty},
    Alias{"stddev", Role::uncertainty},
    Alias{"\u00b1", Role::uncertainty},
    Alias{"\u00b1\u03c3", Role::uncertainty},
    Alias{"\u03c3", Role::uncertainty},
    Alias{"+", Role::uncertainty},
    Alias{"density", Role::density},
    Alias{"xraydensity", Role::density},
    Alias{"intensity", Role::intensity},
    Alias{"netintensity", Role::intensity},
    Alias{"int", Role::intensity},
    Alias{"i", Role::intensity},
    Alias{"area", Role::intensity},
    Alias{"peakarea", Role::intensity},
    Alias{"rir", Role::ratio},
    Alias{"iic", Role::ratio},
    Alias{"referenceintensityratio", Role::ratio},
    Alias{"riruncertainty", Role::ratio_uncertainty},
    Alias{"rirerror", Role::ratio_uncertainty},
    Alias{"riresd", Role::ratio_uncertainty},
    Alias{"standard", Role::standard},
    Alias{"internalstandard", Role::standard},
    Alias{"spike", Role::standard},
    Alias{"added", Role::standard},
};

Role role_of(const std::string& key) {
    const auto* const found =
        std::find_if(aliases.begin(), aliases.end(), [&](const Alias& alias) { return alias.key == key; });
    return found == aliases.end() ? Role::other : found->role;
}

bool says_per_cent(const std::string& key) {
    return key.find('%') != std::string::npos || key.find("percent") != std::string::npos ||
           key.find("pct") != std::string::npos || key.find("prozent") != std::string::npos;
}

/// "Weight [wt.%]" into text and unit; brackets elsewhere, as in "Mullite (3:2)", are part of the text.
void split_unit(Heading& heading, std::string_view text) {
    heading.text = std::string(text);
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const auto start = text.rfind(open);
        if (start == std::string_view::npos || start == 0 || !text.ends_with(close)) continue;
        const std::string_view inside = trimmed(text.substr(start + 1, text.size() - start - 2));
        const std::string key = key_of(inside);
        const bool is_unit = says_per_cent(key) || open == '[' || key.find("cm3") != std::string::npos ||
                             key.find("m3") != std::string::npos || key == "wt" || key == "vol";
        if (!is_unit) continue;
        heading.text = std::string(trimmed(text.substr(0, start)));
        heading.unit = std::string(inside);
        return;
    }
}

}  // namespace

Heading read_heading(std::string_view text) {
    Heading heading;
    StatedCoverage coverage = read_coverage(trimmed(text));
    if (!coverage.stated.empty() && coverage.rest.size() > 2 && coverage.rest.ends_with("\u00b1"))
        coverage.rest.resize(coverage.rest.size() -
                             std::string_view("\u00b1").size());  // "wt% +- 2s": both stand in the cell
    heading.written = text;
    heading.coverage = coverage;
    split_unit(heading, coverage.rest);
    const std::string key = key_of(heading.text);
    const std::string unit = key_of(heading.unit);
    heading.role = role_of(key.empty() ? "\u2400" : without_per_cent(key));
    if (heading.role == Role::weight && unit.starts_with("v")) heading.role = Role::volume;
    // "2 sigma" alone, or behind the name of a phase or sample, is the uncertainty of the column before it.
    if (!coverage.stated.empty() && (heading.text.empty() || heading.role == Role::other))
        heading.role = Role::uncertainty;
    if (says_per_cent(key) || says_per_cent(unit)) heading.scale = Scale::per_cent;
    if (heading.role == Role::other && heading.text.ends_with('%')) {  // "Quartz wt%": a phase with its unit
        const auto blank = heading.text.find_last_of(' ');
        heading.text.resize(blank == std::string::npos ? heading.text.size() - 1 : blank);
        heading.text = std::string(trimmed(heading.text));
    }
    if (key.ends_with("fraction") && heading.scale == Scale::not_stated) heading.scale = Scale::fraction;
    if (unit == "1" || unit == "gg" || unit == "kgkg" || unit == "m3m3") heading.scale = Scale::fraction;
    return heading;
}

bool means_total(std::string_view name) {
    const std::string key = without_per_cent(key_of(name));
    return key == "total" || key == "sum" || key == "summe" || key == "\u03c3" || key == "\u03a3" ||
           key == "checksum";
}

bool means_crystalline_total(std::string_view name) {
    const std::string key = without_per_cent(key_of(name));
    constexpr std::array<std::string_view, 7> words{
        "crystalline",      "crystallinetotal", "totalcrystalline",  "totalcrystallinephase",
        "crystallinephase", "crystallinity",    "totalcrystallinity"};
    return std::find(words.begin(), words.end(), key) != words.end();
}

std::optional<std::string> phase_of_uncertainty(std::string_view heading) {
    const auto blank = heading.find_last_of(" _");
    if (blank == std::string_view::npos) return std::nullopt;
    if (role_of(without_per_cent(key_of(heading.substr(blank + 1)))) != Role::uncertainty)
        return std::nullopt;
    return std::string(trimmed(heading.substr(0, blank)));
}

}  // namespace ashimpact::xrd
