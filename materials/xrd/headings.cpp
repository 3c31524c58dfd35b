// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/headings.hpp"

#include <utility>

#include "core/tables/vocabulary.hpp"
#include "core/text/text.hpp"
#include "core/text/utf8.hpp"

namespace ashimpact::xrd {

namespace {

std::string key_of(std::string_view text) {
    return word_key(text, "%+");
}

std::string without_per_cent(std::string key) {
    std::erase(key, '%');
    for (const std::string_view word : {"percent", "pct", "prozent"}) {
        const auto found = key.find(word);
        if (found != std::string::npos) key.erase(found, word.size());
    }
    return key;
}

/// @param key without per cent signs; the empty one is a bare "%"
Role role_of(const std::string& key) {
    static const WordLists words("XRD columns", "+");
    if (const auto role = meaning<Role>(words, key)) return *role;
    return is_uncertainty_word(key) ? Role::uncertainty : Role::other;
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

RowMeaning meaning_of_row(std::string_view name) {
    static const WordLists words("XRD rows", "+");
    return meaning<RowMeaning>(words, without_per_cent(key_of(name))).value_or(RowMeaning::phase);
}

std::optional<std::string> phase_of_uncertainty(std::string_view heading) {
    const auto blank = heading.find_last_of(" _");
    if (blank == std::string_view::npos) return std::nullopt;
    if (role_of(without_per_cent(key_of(heading.substr(blank + 1)))) != Role::uncertainty)
        return std::nullopt;
    return std::string(trimmed(heading.substr(0, blank)));
}

}  // namespace ashimpact::xrd
