// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/table_headings.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <utility>

#include "core/tables/text_lines.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "materials/xrd/xrd.hpp"

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

/// @param key from key_of(). A word such as "m%" counts with its per cent sign alone, others without it too.
Role role_of(const std::string& key) {
    static const WordLists words("XRD columns", "%+");
    const std::string plain = without_per_cent(key);
    if (plain != key)
        if (const auto role = meaning<Role>(words, plain + '%')) return *role;
    if (const auto role = meaning<Role>(words, plain)) return *role;
    static const WordLists bases("bases");
    const auto base = bases.list_of(plain).value_or("");
    const bool is_share = plain != key || base.ends_with(" share");
    if (is_share && base.starts_with("weight")) return Role::weight;
    if (is_share && base.starts_with("volume")) return Role::volume;
    return is_uncertainty_word(plain) ? Role::uncertainty : Role::other;
}

/// A unit of fractions that is a quotient.
struct FractionUnit {
    std::string_view text;  ///< in ASCII, without blanks and brackets
    HeadingUnit states;
    Scale scale;
};
constexpr std::array fraction_units{
    FractionUnit{"g/g", HeadingUnit::weight, Scale::fraction},
    FractionUnit{"kg/kg", HeadingUnit::weight, Scale::fraction},
    FractionUnit{"w/w", HeadingUnit::weight, Scale::not_stated},
    FractionUnit{"m/m", HeadingUnit::weight, Scale::not_stated},
    FractionUnit{"g/100g", HeadingUnit::weight, Scale::per_cent},
    FractionUnit{"g/kg", HeadingUnit::weight, Scale::per_mille},
    FractionUnit{"gkg-1", HeadingUnit::weight, Scale::per_mille},
    FractionUnit{"mg/g", HeadingUnit::weight, Scale::per_mille},
    FractionUnit{"mgg-1", HeadingUnit::weight, Scale::per_mille},
    FractionUnit{"\u0433/\u043a\u0433", HeadingUnit::weight, Scale::per_mille},
    FractionUnit{"\u043c\u0433/\u0433", HeadingUnit::weight, Scale::per_mille},
    FractionUnit{"kg/t", HeadingUnit::weight, Scale::per_mille},
    FractionUnit{"mg/kg", HeadingUnit::weight, Scale::ppm},
    FractionUnit{"g/t", HeadingUnit::weight, Scale::ppm},
    FractionUnit{"mgkg-1", HeadingUnit::weight, Scale::ppm},
    FractionUnit{"ug/g", HeadingUnit::weight, Scale::ppm},
    FractionUnit{"v/v", HeadingUnit::volume, Scale::not_stated},
    FractionUnit{"m3/m3", HeadingUnit::volume, Scale::fraction},
    FractionUnit{"cm3/cm3", HeadingUnit::volume, Scale::fraction},
    FractionUnit{"mm3/mm3", HeadingUnit::volume, Scale::fraction},
    FractionUnit{"l/l", HeadingUnit::volume, Scale::fraction},
    FractionUnit{"ml/ml", HeadingUnit::volume, Scale::fraction},
    FractionUnit{"vol/vol", HeadingUnit::volume, Scale::not_stated}};

/// The unit of a text such as "g/kg" or "% (m/m)"; null if it is none of these.
const FractionUnit* fraction_unit(std::string_view text) {
    const std::string key = word_key(ascii_unit(text), "/-");
    const auto* const found = std::ranges::find(fraction_units, key, &FractionUnit::text);
    return found == fraction_units.end() ? nullptr : found;
}

/// Whether brackets hold a unit, unlike those of "Mullite (3:2)".
bool is_unit_in_brackets(std::string_view text) {
    const std::string key = key_of(text);
    return holds_per_cent(key) || key.find("m3") != std::string::npos || key == "wt" || key == "vol" ||
           key.find("pp") == 0 || (text.find('/') != std::string_view::npos && read_unit(ascii_unit(text)));
}

}  // namespace

Role role_of_text(std::string_view text) {
    return role_of(key_of(text));
}

bool holds_per_cent(std::string_view text) {
    const std::string key = key_of(text);
    return without_per_cent(key) != key;
}

bool may_be_relative(const Heading& heading) {
    return heading.scale == Scale::per_cent && heading.states != HeadingUnit::weight &&
           heading.states != HeadingUnit::volume;
}

bool names_other_basis(const Heading& heading) {
    const bool may_be_amounts = heading.role == Role::other || heading.role == Role::weight;
    if (!may_be_amounts || heading.states == HeadingUnit::volume) return false;
    const bool by_weight = heading.states == HeadingUnit::weight;  // "FA1 volume content %" states none
    if (by_weight && bases_in(heading.written, false).contains("weight")) return false;
    auto bases = bases_in(by_weight ? heading.written : heading.text, false);
    if (by_weight && fraction_unit(heading.unit) != nullptr)  // "Surface [g/kg]"
        std::erase_if(bases, [](std::string_view basis) {
            return basis != "volume" && basis != "mode" && basis != "mole";
        });
    bases.erase("weight");
    bases.erase("number");                                    // "Number 5" is a name
    const bool is_name = words_in(heading.text).size() == 1;  // "Surface", unlike "FA1 area"
    if (is_name && heading.states == HeadingUnit::none && !holds_per_cent(heading.text))
        bases.erase("intensity");
    return !bases.empty();
}

std::string without_fraction_unit(const std::string& cell, HeadingUnit kind) {
    const auto end = cell.find_last_of("0123456789)");
    if (end == std::string::npos || cell.size() > longest_heading) return cell;
    const std::string unit(trimmed(std::string_view(cell).substr(end + 1)));
    if (!holds_per_cent(unit) || unit_of(unit) != kind) return cell;
    std::string number = cell;  // of "20.0 wt% \u00b1 0.5 wt%"
    for (auto at = number.find(unit); at != std::string::npos; at = number.find(unit))
        number.erase(at, unit.size());
    number = trimmed(number);
    const bool is_plain = number.find_first_not_of("+-/.,()0123456789 \u00b1") == std::string::npos;
    const bool of_both = !number_behind_plus_minus(number).empty() && !number.ends_with(')');
    return !is_plain ? cell : of_both ? "(" + number + ") %" : number + '%';
}

bool names_loss(std::string_view text, bool at_any_temperature) {
    static const WordLists words("oxide columns");
    constexpr std::size_t longest_name = 60;  // regular expressions recurse along it
    if (words.list_of(text) == "loss") return true;
    if (text.size() > longest_name) return false;
    static const std::regex high("[ ,_(@-]*(at|bei|à)? *(1[0-9]{3}|[7-9][0-9]{2}) *(°|deg)? *C?[)]?$");
    static const std::regex any("[ ,_(@-]*(at|bei|à)? *(1[0-9]{3}|[1-9][0-9]{2}) *(°|deg)? *C?[)]?$");
    const std::regex& temperature = at_any_temperature ? any : high;
    return words.list_of(std::regex_replace(std::string(text), temperature, "")) == "loss";
}

HeadingUnit unit_of(std::string_view text) {
    if (text.empty()) return HeadingUnit::none;
    if (const FractionUnit* unit = fraction_unit(text)) return unit->states;
    const std::string key = key_of(text);
    const std::string plain = without_per_cent(key);
    if (plain.empty() || plain == "1") return HeadingUnit::fraction;
    const Role role = role_of(key);
    return role == Role::weight   ? HeadingUnit::weight
           : role == Role::volume ? HeadingUnit::volume
                                  : HeadingUnit::other;
}

UncertaintyName uncertainty_name(std::string_view text) {
    if (names_uncertainty(text)) return {.is_uncertainty = true};
    if (text.size() > longest_heading) return {};
    UncertaintyName name;  // the longest word counts: "error of", not "error"
    for (auto at = text.find_first_of(" _("); at != std::string_view::npos;
         at = text.find_first_of(" _(", at + 1)) {
        const std::string_view before = trimmed(text.substr(0, at));
        const std::string_view after = trimmed(text.substr(at + (text[at] == '(' ? 0 : 1)));
        if (before.empty() || after.empty()) continue;
        if (is_uncertainty_word(after) || role_of_text(after) == Role::uncertainty)
            return {.is_uncertainty = true, .of = std::string(before)};
        if (!is_uncertainty_word(before)) continue;
        const bool brackets = after.front() == '(' && after.back() == ')';
        name = {.is_uncertainty = brackets || key_of(before).size() > 2,
                .of = std::string(brackets ? trimmed(after.substr(1, after.size() - 2)) : after)};
    }
    return name;
}

bool is_uncertainty_of_unused(const Heading& heading, const Heading& before, bool holds_numbers) {
    const bool has_name = heading.text.empty() ? !heading.coverage.rest.empty()
                                               : !is_uncertainty_word(without_per_cent(key_of(heading.text)));
    const bool of_amounts = heading.states == HeadingUnit::weight || heading.states == HeadingUnit::volume;
    const bool sums_up =  // "LOD", but not "counts"
        is_summary(before.text) && !bases_in(before.text, false).contains("intensity");
    return holds_numbers && !has_name && !of_amounts && !before.written.empty() && !sums_up;
}

namespace {

bool holds_letter(std::string_view text) {
    return text.find_first_not_of("0123456789+-/ ") != std::string_view::npos;
}

/// "Weight [wt.%]", "content, vol%" and "Gehalt in Mol-%" into text and unit.
void split_unit(Heading& heading, std::string_view text) {
    heading.text = std::string(text);
    if (fraction_unit(text) != nullptr) return;  // "m/m%"
    const auto split = [&](std::size_t end, std::string_view unit) {
        std::string_view name = trimmed(text.substr(0, end));
        while (name.ends_with(',') || name.ends_with(';') || name.ends_with('/'))
            name = trimmed(name.substr(0, name.size() - 1));
        if (name.ends_with(" in")) name = trimmed(name.substr(0, name.size() - 3));
        heading.text = std::string(name);
        heading.unit = std::string(trimmed(unit));
    };
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const auto start = text.rfind(open);
        if (start == std::string_view::npos || start == 0 || !text.ends_with(close)) continue;
        const std::string_view inside = trimmed(text.substr(start + 1, text.size() - start - 2));
        if (open == '[' || is_unit_in_brackets(inside)) return split(start, inside);
    }
    const auto last = text.find_last_of(" /");
    for (auto at = text.find_first_of(" /"); at != std::string_view::npos;
         at = text.find_first_of(" /", at + 1)) {
        const std::string_view rest = trimmed(text.substr(at + 1));
        const std::string_view name = trimmed(text.substr(0, at));
        const Role role = role_of_text(rest);  // "at. %"
        const bool is_unit =
            unit_of(rest) != HeadingUnit::other || role == Role::measure || role == Role::intensity;
        const bool per_cent = holds_per_cent(rest) && (at == last || (is_unit && !rest.starts_with('/')));
        const bool is_quotient = text[at] == '/' || name.ends_with('/');  // "w/%", but not "1/wt%"
        if (!name.empty() && (per_cent || (!is_quotient && fraction_unit(rest) != nullptr)) &&
            (!is_quotient || holds_letter(name)))
            return split(at, rest);
    }
}

/// Removes "± esd" behind a quantity, whose cells hold values with uncertainties.
void take_uncertain_cells(std::string& text) {
    for (const std::string_view sign : {"\u00b1", "+/-", "+-"}) {
        const auto at = text.find(sign);
        if (at == std::string::npos || !is_uncertainty_word(text.substr(at + sign.size()))) continue;
        const Role role = role_of_text(text.substr(0, at));
        if (role == Role::weight || role == Role::volume) text = std::string(trimmed(text.substr(0, at)));
    }
}

/// Removes "(n=3)", the number of repeated measurements.
void take_repeats(std::string& text) {
    for (auto open = text.find_first_of("(["); open != std::string::npos;
         open = text.find_first_of("([", open + 1)) {
        const auto close = text.find_first_of(")]", open);
        if (close == std::string::npos) return;
        const std::string inside = word_key(std::string_view(text).substr(open + 1, close - open - 1), "=");
        if (!inside.starts_with("n=") || inside.find_first_not_of("0123456789", 2) != std::string::npos)
            continue;
        text.erase(open, close - open + 1);
        text = std::string(trimmed(text));
        return;
    }
}

/// Removes "(crystalline)" or "crystalline" behind a quantity. @return whether it was there
bool take_crystalline(std::string& text) {
    for (const std::string_view word :
         {"(crystalline)", "(cryst.)", "(kristallin)", "crystalline", "kristallin"}) {
        const std::string_view whole(text);
        if (whole.size() <= word.size()) continue;
        if (lower_case(text).ends_with(word))
            text = std::string(trimmed(whole.substr(0, whole.size() - word.size())));
        else if (lower_case(text).starts_with(word) &&
                 unit_of(whole.substr(word.size())) != HeadingUnit::other)
            text = std::string(trimmed(whole.substr(word.size())));
        else
            continue;
        return true;
    }
    return false;
}

}  // namespace

Heading read_heading(std::string_view text) {
    Heading heading;
    if (text.size() > longest_heading) {
        heading.text = heading.written = text;
        return heading;
    }
    static const std::regex of_mean("[(\\[](?:mean|average|Mittelwert|Mittel|moyenne) *(?=\u00b1|[+]/?-)",
                                    std::regex::icase);
    const std::string plain = std::regex_replace(std::string(text), of_mean, "(");  // "wt% (mean ± SD)"
    StatedCoverage coverage = read_coverage(trimmed(plain));
    heading.written = text;
    heading.coverage = coverage;
    const HeadingUnit behind = unit_of(coverage.rest);
    if (coverage.stated_first &&  // "2σ (wt%)" behind a column of amounts
        (coverage.rest.starts_with('(') || coverage.rest.starts_with('[') ||
         (behind != HeadingUnit::none && behind != HeadingUnit::other)))
        coverage.rest = "\u00b1 " + coverage.rest;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 1> per_mille{{{"\u2030", "%"}}};
    const bool is_per_mille = coverage.rest.find("\u2030") != std::string::npos;
    coverage.rest = replaced(coverage.rest, per_mille);
    take_uncertain_cells(coverage.rest);
    take_repeats(coverage.rest);
    if (meaning_of_row(coverage.rest) != RowMeaning::crystalline_total)
        heading.of_crystalline = take_crystalline(coverage.rest);
    split_unit(heading, coverage.rest);
    if (heading.unit.empty() && fraction_unit(heading.text) != nullptr) heading.unit = heading.text;
    heading.states = unit_of(heading.unit);
    const std::string key = key_of(heading.text);
    const std::string unit = key_of(heading.unit);
    const FractionUnit* quotient = fraction_unit(heading.unit);
    heading.role = key.empty() ? Role::other : role_of(key);
    if (quotient != nullptr && heading.unit == heading.text)
        heading.role = quotient->states == HeadingUnit::volume ? Role::volume : Role::weight;
    if (heading.role == Role::weight && heading.states == HeadingUnit::volume) heading.role = Role::volume;
    if (heading.role == Role::ratio && heading.states == HeadingUnit::weight)
        heading.role = Role::weight;  // "RIR [wt%]": by the method of that name
    if (heading.role == Role::other && heading.text.ends_with(')')) {  // "Phase ID (3)", "RIR (calc)"
        const std::string name = heading.text.substr(0, heading.text.rfind('('));
        const Role role = role_of(key_of(name));
        if (role == Role::phase || role == Role::ratio || role == Role::intensity) heading.role = role;
    }
    const HeadingUnit contrary = heading.role == Role::weight ? HeadingUnit::volume : HeadingUnit::weight;
    if ((heading.role == Role::weight || heading.role == Role::volume) &&
        (heading.states == HeadingUnit::other || heading.states == contrary))
        heading.role = Role::measure;
    static const WordLists bases("bases");
    if (heading.role == Role::other && heading.states == HeadingUnit::fraction &&
        bases.list_of(heading.text) == "weight")
        heading.role = Role::weight;                      // "масс. %"
    const std::string whole = lower_case(coverage.rest);  // mass in a volume
    const bool is_concentration =
        whole.find("w/v") != std::string::npos || whole.find("m/v") != std::string::npos;
    if (is_concentration) {
        heading.role = Role::measure;
        heading.states = HeadingUnit::other;
    }
    if (heading.role == Role::other && names_loss(heading.text, true)) heading.role = Role::measure;
    // "2 sigma" alone, or behind the name of a phase or sample, is the uncertainty of the column before it.
    if (!coverage.stated.empty() && (heading.text.empty() || heading.role == Role::other))
        heading.role = Role::uncertainty;
    if (holds_per_cent(key) || holds_per_cent(unit))
        heading.scale = is_per_mille ? Scale::per_mille : Scale::per_cent;
    if (key.ends_with("ppm") || unit.ends_with("ppm")) heading.scale = Scale::ppm;
    if ((key.ends_with("fraction") || unit == "fraction") && heading.scale == Scale::not_stated)
        heading.scale = Scale::fraction;
    if (unit == "1" || heading.unit == "-") heading.scale = Scale::fraction;
    if (quotient != nullptr && quotient->scale != Scale::not_stated) heading.scale = quotient->scale;
    if (heading.scale == Scale::per_mille && heading.unit.ends_with('%'))
        heading.unit.replace(heading.unit.size() - 1, 1, "\u2030");
    return heading;
}

Heading read_heading_beside(std::string_view text, std::string_view name) {
    const auto beside = name.empty() ? std::nullopt : uncertainty_beside(text, name);
    if (!beside) return read_heading(text);
    Heading heading = read_heading(beside->text);
    heading.role = Role::uncertainty;
    heading.text.clear();
    heading.written = text;
    if (heading.coverage.problem.empty()) heading.coverage.problem = beside->problem;
    return heading;
}

RowMeaning meaning_of_row(std::string_view name) {
    static const WordLists words("XRD rows", "+");
    const auto open = name.find_last_of("([");  // of a unit, "Total (wt%)"
    if (open != std::string_view::npos && open > 0 && holds_per_cent(name.substr(open)))
        name = name.substr(0, open);
    const std::string key = without_per_cent(key_of(name));
    return is_total(name) ? RowMeaning::total : meaning<RowMeaning>(words, key).value_or(RowMeaning::phase);
}

MarkedPhase read_phase_name(std::string_view text) {
    static const WordLists words("XRD marks");
    const auto mark_of = [](std::string_view part) {
        return meaning<PhaseMark>(words, part).value_or(PhaseMark::none);
    };
    const auto marked = [&](std::string_view name, std::string_view mark) {
        while (!name.empty() && std::string_view(" ,;:-").find(name.back()) != std::string_view::npos)
            name.remove_suffix(1);
        return MarkedPhase{.name = std::string(name), .mark = name.empty() ? PhaseMark::none : mark_of(mark)};
    };
    text = trimmed(text);
    if (text.size() > longest_heading) return {.name = std::string(text)};
    for (const std::string_view sign : footnote_signs)
        if (text.size() > sign.size() && text.ends_with(sign))
            return read_phase_name(text.substr(0, text.size() - sign.size()));
    for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}}) {
        const auto start = text.rfind(open);
        if (start == std::string_view::npos || !text.ends_with(close)) continue;
        const std::string_view before = text.substr(0, start);
        const std::string_view inside = text.substr(start + 1, text.size() - start - 2);
        // "(spike)", "(spike, 15 %)" and "(15 % spike)"
        const auto behind_number = std::min(inside.find_first_not_of("0123456789.,% "), inside.size());
        for (const std::string_view mark :
             {inside, trimmed(inside.substr(0, inside.find_first_of(",;:"))), inside.substr(behind_number)})
            if (auto found = marked(before, mark); found.mark != PhaseMark::none) return found;
        if (auto found = marked(trimmed(inside), before); found.mark == PhaseMark::standard) return found;
    }
    for (auto at = text.find_first_of(" ,:"); at != std::string_view::npos;
         at = text.find_first_of(" ,:", at + 1)) {
        if (text.find_first_of("([") < at && text.find_first_of(")]", at) < text.size())
            break;  // in a bracket
        const auto blank = text[at] == ' ' ? at : at + 1;
        if (auto found = marked(text.substr(0, at), text.substr(blank)); found.mark != PhaseMark::none)
            return found;
        if (text[at] != ':') continue;
        if (auto found = marked(trimmed(text.substr(at + 1)), text.substr(0, at));
            found.mark == PhaseMark::standard)
            return found;
    }
    return {.name = std::string(text)};
}

namespace {

/// Whether a text states what was added: "FA1 + 10 % corundum".
bool states_amount_added(const std::string& text) {
    static const std::regex addition("[+] *[0-9][0-9.,]* *(?:wt|m|Gew\\.-|Ma\\.-)?%");
    return text.size() <= longest_heading && std::regex_search(text, addition);
}

/// Whether words in front of that place state what is in a sample: "with", "mit 10 %", "avec 10 wt %".
bool stands_behind_with(const std::vector<std::string>& words, std::size_t place) {
    static const WordLists small("words of additions");
    while (place > 0) {
        const std::string& word = words[--place];
        if (small.list_of(word) == "with") return true;
        const bool is_number = is_digit(word.front());
        if (!is_number && word != "%" && small.list_of(word) != "between") return false;
    }
    return false;
}

/// Whether a text is on the instrument or the method, which a material "with" it calibrates.
bool is_on_method(const std::vector<std::string>& words) {
    static const WordLists small("words of additions");
    return std::ranges::any_of(words,
                               [](const std::string& word) { return small.list_of(word) == "of methods"; });
}

/// Whether a name has a short mark of a standard apart from its words: "FA1 (IS)", "FA1+IS".
bool has_short_mark(const std::string& name) {
    static const WordLists marks("XRD marks");
    static const std::regex apart("[(\\[+] *([A-Za-z.]+) *(?:[)\\]]|$)");
    std::smatch match;
    return name.size() <= longest_heading && std::regex_search(name, match, apart) &&
           marks.list_of(match.str(1)) == "standard";
}

const WordLists& standard_materials() {
    static const WordLists words("internal standards", " ");
    return words;
}

}  // namespace

void StandardsInTexts::take(const TextBeside& text) {
    static const WordLists marks("XRD marks", " ");
    constexpr std::size_t shortest_mark = 4;  // unlike "is"
    const std::vector<std::string> words = words_in(text.text);
    const auto mentioned = mentions_in(words, standard_materials());
    const std::size_t first =  // word of the name
        text.text.starts_with(sheet_name_mark) ? words_in(sheet_name_mark).size() : 0;
    const auto found = mentions_in(words, marks);
    const auto is_standard = [](const Mention& mention) {
        return mention.list == "standard" && !mention.negated;
    };
    // "ISTD 10 %", unlike "standard cell"
    const bool is_of_any = (text.is_name && has_short_mark(text.text)) ||
                           std::ranges::any_of(found, [&](const Mention& mention) {
                               return is_standard(mention) &&
                                      (mention.count > 1 || (words[mention.first].size() >= shortest_mark &&
                                                             words[mention.first] != "standard"));
                           });
    const bool is_mark =
        is_of_any || (!text.is_name && std::ranges::any_of(found, [&](const Mention& mention) {
            return is_standard(mention) && words[mention.first] == "standard";
        }));
    const auto is_added = [&](const Mention& mention) {  // "FA1 with corundum", unlike "Corundum ash"
        if (mention.negated) return false;
        if (text.is_name) return mention.first > first;
        const bool is_external =
            std::ranges::any_of(found, [](const Mention& m) { return m.list == "none"; });
        return !is_external && !is_on_method(words) && stands_behind_with(words, mention.first);
    };
    if (!is_mark && !states_amount_added(text.text) && !std::ranges::any_of(mentioned, is_added)) return;
    for (const Mention& mention : mentioned) materials_.insert(mention.list);
    any_ = any_ || (mentioned.empty() && (text.is_name || is_of_any));  // "FA1 spiked"
}

void StandardsInTexts::take_named(const TextBeside& text) {
    const bool before = any_;
    take(text);
    any_ = before;
}

bool StandardsInTexts::hold(std::string_view phase) const {
    const auto material = standard_materials().list_of(phase);
    return material && (any_ || materials_.contains(*material));
}

std::optional<Finding> mark_standards(Analysis& analysis, const std::string& sample) {
    StandardsInTexts standards;
    standards.take({.line = 0, .text = sample, .is_name = true});
    for (PhaseFraction& phase : analysis.phases)
        phase.is_standard = phase.is_standard || standards.hold(phase.name) ||
                            read_phase_name(phase.name).mark == PhaseMark::standard;
    if (!standards.any() || std::ranges::any_of(analysis.phases, &PhaseFraction::is_standard)) return {};
    return Finding{
        xrd_code, Severity::doubt,
        "the name " + in_quotes(sample) + " may state an added standard, and no phase is marked as one"};
}

namespace {

/// The scale that a text of one unit states: of "g/kg", "wt%", "Promille", but not of "Al2O3" and "12 %".
Scale scale_in_unit(std::string_view text) {
    const bool is_unit = std::ranges::any_of(text, [](char c) {
        return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '%' || c == '\xe2';
    });
    if (!is_unit || text.size() > longest_heading || is_digit(text.front())) return Scale::not_stated;
    static const WordLists per_mille("per mille");
    if (per_mille.holds(text) || text.find("\u2030") != std::string_view::npos) return Scale::per_mille;
    const Heading unit = read_heading("x [" + std::string(text) + "]");
    const bool by_weight = unit.states == HeadingUnit::weight || unit.states == HeadingUnit::fraction;
    return by_weight ? unit.scale : Scale::not_stated;  // require_basis() refuses volumes
}

}  // namespace

void refuse_other_unit(std::string_view cell, const std::string& column, Scale amounts, std::size_t line,
                       std::size_t place) {
    static const WordLists relative("relative quantities");
    const auto is_relative = [](const std::string& word) { return relative.holds(word); };
    const Scale stated = cell.empty() ? Scale::not_stated : scale_in_unit(cell);
    const bool of_value = holds_per_cent(cell) && read_number(cell, true) == std::nullopt &&
                          std::ranges::any_of(words_in(cell), is_relative);
    if (!of_value && (stated == Scale::not_stated || stated == amounts)) return;
    throw InputError(in_quotes(cell) + " in " + column +
                         " is not the unit of the amounts: it may be theirs, or that of uncertainties",
                     "the unit in the heading of each column")
        .at(at_cell(line, place));
}

void require_scale(const std::vector<TextBeside>& texts, const std::set<Scale>& amounts) {
    constexpr std::string_view ends = " \t,;:()[]\"";
    for (const TextBeside& each : texts) {
        const std::string_view text = each.text;
        std::string other;
        bool agrees = false;
        bool behind_number = false;
        for (auto from = text.find_first_not_of(ends); from != std::string_view::npos;) {
            const auto end = std::min(text.find_first_of(ends, from), text.size());
            const std::string_view word = text.substr(from, end - from);
            const bool is_plain = word == "fraction" && !text.substr(0, from).ends_with('[');
            from = text.find_first_not_of(ends, end);
            const Scale scale = scale_in_unit(word);
            const bool is_name = std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
                                 word.find('=') == std::string_view::npos;  // "FA1"
            const bool of_number = std::exchange(behind_number, is_digit(word.back()) && !is_name);
            if (scale == Scale::not_stated || of_number || is_plain) continue;
            agrees = agrees || amounts.contains(scale);
            if (!amounts.contains(scale)) other = word;
        }
        if (!other.empty() && !agrees)
            refuse_line(
                each.line,
                in_quotes(each.text) + " states " + other + ", and the amounts are read in another unit",
                "the unit in the headings of the amounts, or a file without this text");
    }
}

bool stands_beside(const Heading& heading) {
    constexpr std::array roles{Role::measure, Role::density, Role::intensity, Role::ratio,
                               Role::ratio_uncertainty};
    return heading.sums_up || std::ranges::find(roles, heading.role) != roles.end();
}

}  // namespace ashimpact::xrd
