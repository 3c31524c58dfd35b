// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/vocabulary.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/json/document.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"

namespace ashimpact {

namespace {

/// Central intervals of the normal distribution: their half-widths in standard deviations.
struct Coverage {
    std::string_view per_cent;
    double factor;
};
constexpr std::array coverages{Coverage{"68", 1},       Coverage{"68.3", 1},     Coverage{"68.27", 1},
                               Coverage{"90", 1.64485}, Coverage{"95", 1.95996}, Coverage{"95.4", 2},
                               Coverage{"95.45", 2},    Coverage{"95.5", 2},     Coverage{"99", 2.57583},
                               Coverage{"99.7", 3},     Coverage{"99.73", 3}};

/// Words in a heading that announce an interval, or an expanded uncertainty.
const WordLists& special_words() {
    static const WordLists words("uncertainty words");
    return words;
}

/// True if @p holds any word of a text.
template <class Predicate>
bool any_word(std::string_view text, Predicate&& holds) {
    std::string word;
    for (const char c : transliterated(text) + ' ') {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || byte >= 0x80) {
            word += c;
            continue;
        }
        if (!word.empty() && holds(word)) return true;
        word.clear();
    }
    return false;
}

constexpr std::array<std::string_view, 3> plus_minus{"\u00b1", "+-", "+/-"};

bool holds_plus_minus(std::string_view text) {
    return std::ranges::any_of(plus_minus,
                               [&](auto sign) { return text.find(sign) != std::string_view::npos; });
}

bool names_interval(std::string_view text) {
    return any_word(text,
                    [](const std::string& word) { return special_words().list_of(word) == "interval"; });
}

/// Whether a cell has only digits and signs. Most cells in which a heading is looked for have; this test is
/// fast.
bool is_number(std::string_view cell) {
    return cell.find_first_not_of("+-.,0123456789 ") == std::string_view::npos;
}

/// The part of a heading that states a coverage, "2 sigma" or "95 %", and its number.
struct Statement {
    std::size_t begin;
    std::size_t length;
    std::string number;
};

/// Searches a heading. The second group of the expression is the statement, the third one its number.
std::optional<Statement> found(const std::string& heading, const std::regex& expression) {
    constexpr std::size_t longest = 4000;  // matching calls itself once a character, on the stack
    if (heading.size() > longest) return std::nullopt;
    std::smatch match;
    if (!std::regex_search(heading, match, expression)) return std::nullopt;
    std::string number = match.str(3);
    std::replace(number.begin(), number.end(), ',', '.');
    return Statement{static_cast<std::size_t>(match.position(2)), static_cast<std::size_t>(match.length(2)),
                     number};
}

/// A multiple of the standard uncertainty. "2s" may also belong to a name such as "Probe 2s".
std::optional<Statement> multiple_in(const std::string& heading) {
    constexpr auto flags = std::regex::icase | std::regex::ECMAScript;
    static const std::regex factor(
        R"((^|[^a-z])((?:k *=|(?:coverage|erweiterungs)[- ]?fa[ck]tor(?: of| =|:)?) *(\d+(?:[.,]\d+)?)))",
        flags);
    static const std::regex sigmas(
        "(^|[^a-z0-9.,])((\\d(?:[.,]\\d+)?) *(?:[-*x]|\u00b7|\u22c5|\u00d7|times|mal|-?fache[rn]?)? *"
        "(?:\u03c3|s\\. ?d\\.|(?:sigma|sd|std|stdabw|standard deviations?|standardabweichung(?:en)?)"
        "(?![a-z])))",
        flags);
    static const std::regex behind(
        "(^|[^a-z])((?:esds?|sd|sigma|\u03c3) *(?:[x*]|\u00b7|\u22c5|\u00d7|multiplied by) "
        "*(\\d+(?:[.,]\\d+)?))",
        flags);
    static const std::regex marked(
        "((?:[(\\[]|\u00b1|\\+/?-) *=? *)((\\d(?:[.,]\\d+)?) *(?:[-*x]|\u00b7|\u22c5|\u00d7)? "
        "*s)(?![a-z0-9])",
        flags);
    static const std::regex esds(
        "((?:^|[(\\[=]|\u00b1|\\+/?-|\\b(?:are|as|is|sind) ) *)((\\d(?:[.,]\\d+)?) "
        "*(?:esd|e\\.s\\.d\\.?))(?![a-z])",
        flags);
    static const std::regex alone(
        "^( *)((\\d(?:[.,]\\d+)?) *(?:[-*x]|\u00b7|\u22c5|\u00d7)? *s)(?= *(?:$|[(\\[]))", flags);
    static const std::regex after_word(R"(([^ _()\[\],;]+)[ _,]+((\d(?:[.,]\d+)?) *s)(?= *(?:$|[(\[)\]])))",
                                       flags);
    for (const std::regex* expression : {&factor, &sigmas, &behind, &marked, &esds, &alone})
        if (auto statement = found(heading, *expression)) return statement;
    static const std::regex of_word(
        "^( *)((\\d(?:[.,]\\d+)?) *(?:[-*x]|\u00b7|\u00d7|times)? *([^0-9 \\[(].*))", flags);
    std::smatch match;
    if (std::regex_search(heading, match, after_word) && is_uncertainty_word(match.str(1)))
        return found(heading, after_word);
    if (std::regex_search(heading, match, of_word) && is_uncertainty_word(match.str(4)))
        return found(heading, of_word);
    return std::nullopt;
}

/// A coverage in per cent, if the rest of the heading names an uncertainty.
std::optional<Statement> coverage_in(const std::string& heading) {
    constexpr auto flags = std::regex::icase | std::regex::ECMAScript;
    static const std::regex per_cent(R"((^|[^0-9.,])((\d\d(?:[.,]\d+)?) *(?:%|percent|prozent)))", flags);
    static const std::regex of_symbol(R"((^|[^a-z])(?:u)_?((?:0[.,])?(95|99))(?![0-9]))", flags);
    if (auto statement = found(heading, of_symbol)) return statement;
    auto statement = found(heading, per_cent);
    if (!statement) return std::nullopt;
    const std::string rest =
        heading.substr(0, statement->begin) + ' ' + heading.substr(statement->begin + statement->length);
    const bool uncertain =
        holds_plus_minus(rest) || names_interval(rest) || any_word(rest, is_uncertainty_word);
    return uncertain ? statement : std::nullopt;
}

/// The heading without the statement, and without brackets and signs that are left without content.
std::string without(const std::string& heading, const Statement& statement) {
    static const std::regex empty_brackets("[(\\[] *(?:\u00b1|\\+/?-)? *[,;]? *[)\\]]");
    static const std::regex open_sign(R"(([(\[]) *[,;] *)");
    static const std::regex close_sign(R"( *[,;] *([)\]]))");
    static const std::regex close_plus_minus("([^(\\[ ]) *(?:\u00b1|\\+/?-) *([)\\]])");
    static const std::regex blanks(" +");
    std::string rest =
        heading.substr(0, statement.begin) + ' ' + heading.substr(statement.begin + statement.length);
    rest = std::regex_replace(rest, empty_brackets, " ");
    rest = std::regex_replace(rest, open_sign, "$1");
    rest = std::regex_replace(rest, close_sign, "$1");
    rest = std::regex_replace(rest, close_plus_minus, "$1$2");
    rest = std::regex_replace(rest, blanks, " ");
    std::string_view text = trimmed(rest);
    while (text.ends_with(',') || text.ends_with(';')) text = trimmed(text.substr(0, text.size() - 1));
    return std::string(text);
}

/// "FA1 error" of "FA1 % error", and "error" of "% error", "error %" and "Fehler in %"; none of other
/// headings. The sign is the unit of the uncertainties, wherever it stands.
std::optional<std::string> without_per_cent_of_error(std::string_view heading) {
    for (const std::string_view word : {"percent ", "per cent ", "percentage ", "pct ", "pct. "})
        if (lower_case(heading.substr(0, word.size())) == word)
            return without_per_cent_of_error("% " + std::string(heading.substr(word.size())));
    const auto sign = heading.find('%');
    if (sign == std::string_view::npos || heading.find('%', sign + 1) != std::string_view::npos ||
        heading.size() > longest_heading)
        return std::nullopt;
    std::string_view before = trimmed(heading.substr(0, sign));
    const std::string_view after = trimmed(heading.substr(sign + 1));
    if (after.empty()) {
        if (before.ends_with(" in")) before = trimmed(before.substr(0, before.size() - 3));
        return is_uncertainty_word(before) ? std::optional(std::string(before)) : std::nullopt;
    }
    const std::string_view word = before.substr(before.rfind(' ') + 1);
    const bool stands_alone = before.size() < sign || sign == 0;  // unlike that of "wt% error"
    if (!stands_alone || (!before.empty() && is_number(word)) || !is_uncertainty_word(after))
        return std::nullopt;
    return std::string(before) + (before.empty() ? "" : " ") + std::string(after);
}

/// Whether a text has a word for another spread than a standard uncertainty.
bool names_spread(std::string_view text) {
    return any_word(text, [](const std::string& word) {
        return special_words().list_of(word).value_or("expanded") != "expanded";
    });
}

/// The word behind "±" in a heading, "CI" of "v_in ± CI [m/s]", that is no known word for a standard
/// uncertainty, no number and no unit. Behind "±" alone it may be a name: "± FA1".
std::string unknown_behind_plus_minus(std::string_view heading) {
    for (const std::string_view sign : plus_minus) {
        const auto at = heading.find(sign);
        if (at == std::string_view::npos) continue;
        const std::string_view behind = trimmed(heading.substr(at + sign.size()));
        const std::string_view word = trimmed(behind.substr(0, behind.find_first_of("[](),;/")));
        const bool may_be_name = trimmed(heading.substr(0, at)).empty() && word != "U";
        if (word.ends_with('%')) {  // "± %" and "± error %" may be of the value; "± wt%" is a unit
            const std::string_view rest = trimmed(word.substr(0, word.size() - 1));
            if (!may_be_name && (rest.empty() || names_spread(rest) || is_uncertainty_word(rest)))
                return std::string(word);
        }
        const bool is_known = word.empty() || word == "u" || is_digit(word.front()) || word.front() == '.' ||
                              word.find('%') != std::string_view::npos || read_unit(ascii_unit(word));
        const std::string_view unit = trimmed(behind.substr(word.size()));
        const bool of_error = unit == "(%)" || unit == "[%]";  // "wt% ± error (%)" may be of the value
        if (of_error && heading.substr(0, at).find('%') != std::string_view::npos) return std::string(behind);
        if (is_known || may_be_name || (word != "U" && is_uncertainty_word(word))) return {};
        return std::string(word);
    }
    return {};
}

/// Whether the key of a text begins as a word for a mean does.
bool begins_as_mean(const std::string& key) {
    constexpr std::array means{"mean", "aver", "avg",  "arith", "mittel", "mw",     "schnitt", "durchschnitt",
                               "moy",  "medi", "prom", "gem",   "sredni", "prumer", "ortalama"};
    return std::ranges::any_of(means, [&](const char* mean) { return key.starts_with(mean); });
}

/// What a heading names in brackets, "RSD" of "FA1 (RSD) [wt%]", if that is a statistic other than a standard
/// uncertainty or a mean. The cells below may hold it in brackets behind their values.
std::string statistic_in_brackets(std::string_view heading) {
    for (auto open = heading.find('('); open != std::string_view::npos; open = heading.find('(', open + 1)) {
        const auto close = heading.find(')', open);
        if (close == std::string_view::npos) return {};
        const std::string_view inside = trimmed(heading.substr(open + 1, close - open - 1));
        const std::string_view word =
            trimmed(inside.substr(std::min(inside.find_first_not_of("0123456789"), inside.size())));
        const bool is_mean = begins_as_mean(word_key(word));
        const bool is_count = inside.find('=') != std::string_view::npos;  // "n = 3"
        if (inside == "N" || inside == "#") return std::string(inside);    // how many the mean is of
        if (word.empty() || is_mean || is_count || is_total(word) || read_unit(ascii_unit(word))) continue;
        if (word == "U" || (!is_uncertainty_word(word) && (names_spread(word) || is_summary(word))))
            return std::string(inside);
    }
    return {};
}

}  // namespace

std::optional<double> factor_of_coverage(std::string_view per_cent) {
    const auto* const known = std::ranges::find(coverages, per_cent, &Coverage::per_cent);
    return known == coverages.end() ? std::nullopt : std::optional(known->factor);
}

namespace {

constexpr auto remedy = "write \"1 sigma\", \"2 sigma\" or \"k=2\" into the heading";

std::string problem_of_coverage(const std::string& rest, bool is_known) {
    if (!is_known) return std::string("its coverage is not one that is known here (") + remedy + ")";
    if (names_interval(rest) && !holds_plus_minus(rest))
        return "an interval may be given by its whole width (write \"\u00b1\" into the heading of "
               "half-widths)";
    return {};
}

/// Takes "95 %" beside "k=2", or behind it in brackets, from the rest of a heading; another coverage beside
/// it is a problem.
void take_second_statement(StatedCoverage& coverage) {
    constexpr double rounding = 0.03;  // 2 is written for 1.96
    static const std::regex alone(
        R"((^[ =,;/]*|[(\[] *)((\d\d(?:[.,]\d+)?) *(?:%|percent|prozent))(?= *(?:[)\]]|$)))",
        std::regex::icase | std::regex::ECMAScript);
    const auto multiple = multiple_in(coverage.rest);
    auto second = multiple ? multiple : coverage_in(coverage.rest);
    if (!second) second = found(coverage.rest, alone);
    if (!second) return;
    const auto factor = multiple ? whole_decimal(second->number) : factor_of_coverage(second->number);
    const std::string other = coverage.rest.substr(second->begin, second->length);
    if (!factor || std::abs(*factor - coverage.factor) > rounding * coverage.factor)
        coverage.problem = in_quotes(coverage.stated) + " and " + in_quotes(other) +
                           " are not the same coverage (" + remedy + ")";
    coverage.rest = without(coverage.rest, *second);
}

}  // namespace

namespace vocabulary {
std::span<const EmbeddedFile> embedded_table();  // generated, see cmake/EmbedFiles.cmake
}

namespace {

const Json& vocabulary_file() {
    static const Json file = Json::parse(vocabulary::embedded_table().front().content);
    return file;
}

}  // namespace

WordLists::WordLists(std::string_view group, std::string_view kept) : kept_(kept) {
    for (const auto& [list, words] : vocabulary_file().at(std::string(group)).items())
        for (const Json& word : words)
            if (const auto [found, is_new] = words_.emplace(word_key(word.get<std::string>(), kept), list);
                !is_new && found->second != list)
                throw std::logic_error(word.dump() + " is in two lists of " + std::string(group));
}

std::optional<std::string_view> WordLists::list_of(std::string_view text) const {
    std::string key = word_key(text, kept_);
    auto found = words_.find(key);
    constexpr std::size_t longest_symbol = 4;
    const std::size_t last_word = text.size() - (text.find_last_of(" _-./(") + 1);
    if (found == words_.end() && last_word > longest_symbol && key.ends_with('s')) {  // a plural
        key.pop_back();
        found = words_.find(key);
        if (found == words_.end() && key.ends_with("ie"))
            found = words_.find(key.replace(key.size() - 2, 2, "y"));
    }
    return found == words_.end() ? std::nullopt : std::optional<std::string_view>(found->second);
}

namespace {

/// "FA1Vol" as "FA1 Vol", unlike "CaCl2" and "MgAl2O4".
std::string apart_at_capitals(std::string_view text) {
    const auto is_small = [&](std::size_t i) {
        return i < text.size() && std::islower(static_cast<unsigned char>(text[i])) != 0;
    };
    std::string apart;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_capital = std::isupper(static_cast<unsigned char>(text[i])) != 0;
        if (i > 0 && is_capital && (is_small(i - 1) || is_digit(text[i - 1])) && is_small(i + 1) &&
            is_small(i + 2))
            apart += ' ';
        apart += text[i];
    }
    return apart;
}

}  // namespace

std::vector<std::string> words_in(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : word_key(apart_at_capitals(text), all_marks)) {
        const auto byte = static_cast<unsigned char>(c);
        const bool of_word = std::isalnum(byte) != 0 || byte >= 0x80U;
        if (of_word)
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
        if (c != '%') continue;
        words.back() = c;
        words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

std::vector<Mention> mentions_in(const std::vector<std::string>& words, const WordLists& lists) {
    static const WordLists negations("negations");
    constexpr std::size_t most_words = 4;
    constexpr std::size_t reach = 3;  // of a negation, in words
    std::vector<Mention> mentions;
    std::size_t done = 0;  // words that belong to a mention
    for (std::size_t i = 0; i < words.size(); ++i) {
        for (std::size_t count = std::min(most_words, words.size() - i); count > 0; --count) {
            std::string phrase = words[i];
            for (std::size_t k = 1; k < count; ++k) phrase += ' ' + words[i + k];
            const auto list = phrase.size() > 1 ? lists.list_of(phrase) : std::nullopt;
            if (!list) continue;
            bool negated = i + count < words.size() && negations.holds(words[i + count]);
            for (std::size_t k = std::max(done, i - std::min(i, reach)); k < i; ++k)
                negated = negated || negations.holds(words[k]);
            mentions.push_back({*list, negated, i, count});
            i += count - 1;
            done = i + 1;
            break;
        }
    }
    return mentions;
}

bool says_no_number(std::string_view text) {
    static const WordLists words("no number", all_marks);
    const std::string_view word = trimmed(text);
    const std::string_view limit = "(<";  // of "traces (< 0.5)"
    return word.starts_with('<') || word.starts_with("\u2264") ||
           words.holds(trimmed(word.substr(0, word.find(limit))));
}

namespace {

const WordLists& summary_words() {
    static const WordLists words("summary rows");
    return words;
}

}  // namespace

bool is_total(std::string_view text) {
    return summary_words().list_of(text) == "total";
}

bool is_summary(std::string_view text) {
    const WordLists& words = summary_words();
    text = trimmed(text);
    if (words.holds(text)) return true;
    const auto slash = text.find('/');  // "Σ/4"
    if (slash != std::string_view::npos && is_total(text.substr(0, slash))) {
        const std::string_view divisor = trimmed(text.substr(slash + 1));
        if (divisor == "n" || (!divisor.empty() && std::ranges::all_of(divisor, is_digit))) return true;
    }
    // "SD (n=3)", "n = 3", "Mean ± SD", "Mittel 1-5", but not "S (dry)" and "S 1", which may be samples.
    for (const std::string_view sign : {"(", "[", "\u00b1", "+-", "+/-", "=", ":", "%"}) {
        const auto at = text.find(sign);
        if (at == std::string_view::npos || at == 0) continue;
        const std::string_view before = trimmed(text.substr(0, at));
        return (before.size() > 1 || sign == "=") && is_summary(before);
    }
    const std::string_view word = text.substr(0, text.find(' '));
    const std::string_view rest = trimmed(text.substr(word.size()));
    constexpr std::size_t shortest_word = 4;
    const bool numbered = !rest.empty() && (is_digit(rest.front()) || rest.starts_with("of "));
    return numbered && (word.size() >= shortest_word || !is_ascii(word)) && words.holds(word);
}

bool names_mean(std::string_view text) {
    return is_summary(text) && begins_as_mean(word_key(text));
}

namespace {

bool is_coverage_word(std::string_view heading, std::string_view list) {
    static const WordLists words("coverage factors");
    const auto is_listed = [&](std::string_view marks) {  // "k [-]", "k (95 %)", "coverage factor (k)"
        return words.list_of(trimmed(heading.substr(0, heading.find_first_of(marks)))) == list;
    };
    return is_listed("[") || is_listed("[(");
}

}  // namespace

bool names_coverage_factor(std::string_view heading) {
    return is_coverage_word(heading, "factor");
}

bool may_name_coverages(std::string_view heading) {
    return is_coverage_word(heading, "level");
}

const WordLists& uncertainty_words() {
    static const WordLists words("uncertainty", "+");
    return words;
}

std::string number_behind_plus_minus(std::string_view heading) {
    for (const std::string_view sign : plus_minus) {
        const auto at = heading.find(sign);
        if (at == std::string_view::npos) continue;
        const std::string_view rest = trimmed(heading.substr(at + sign.size()));
        if (rest.find_first_of("0123456789") > 1) return {};  // "± %", and not "± .5"
        return std::string(rest.substr(0, std::min(rest.find_first_not_of("0123456789.,%"), rest.size())));
    }
    return {};
}

StatedCoverage read_coverage(std::string_view heading) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 7> wide_marks{{{"\uff08", "("},
                                                                                       {"\uff09", ")"},
                                                                                       {"\uff05", "%"},
                                                                                       {"\uff0f", "/"},
                                                                                       {"\u3010", "["},
                                                                                       {"\u3011", "]"},
                                                                                       {"\uff0c", ","}}};
    StatedCoverage coverage{.rest = replaced(heading, wide_marks), .stated = {}, .problem = {}};
    if (const auto bare = without_per_cent_of_error(coverage.rest)) coverage.rest = *bare + " [%]";
    if (heading.size() > longest_heading || is_number(heading)) return coverage;
    const auto in_words = [](const std::string& words) {
        return std::regex("\\b(?:" + words + ")[ -]+(?=standard|sigma|\u03c3|sd\\b|(?:e|\u00e9)cart)",
                          std::regex::icase | std::regex::ECMAScript);
    };
    static const std::regex repeats(
        R"([nN] *= *\d+ *[,;] *(?=[^()\[\]]*[)\]])| *[,;] *[nN] *= *\d+(?= *[)\]]))");
    coverage.rest = std::regex_replace(coverage.rest, repeats, "");          // "FA1 (n=3, 2s)"
    static const std::regex probability(R"(\b[Pp] *= *0[.,](\d\d)(?!\d))");  // "P = 0.95"
    coverage.rest = std::regex_replace(coverage.rest, probability, "$1 %");
    static const std::regex percentage(R"(\b[Pp] *= *(\d\d(?:[.,]\d+)?) *%)");  // "P = 95 %"
    coverage.rest = std::regex_replace(coverage.rest, percentage, "$1 %");
    static const std::regex twice = in_words("two|twice the|zwei|doppelte|deux|dos|due|twee");
    static const std::regex thrice = in_words("three|drei|dreifache[nrs]?|trois|tres|tre|drie|trzy");
    coverage.rest = std::regex_replace(coverage.rest, twice, "2 ");
    coverage.rest = std::regex_replace(coverage.rest, thrice, "3 ");
    if (const auto multiple = multiple_in(coverage.rest)) {
        coverage.stated = coverage.rest.substr(multiple->begin, multiple->length);
        coverage.stated_first = multiple->begin == 0;
        coverage.factor = whole_decimal(multiple->number).value_or(1);
        if (!(coverage.factor >= 0.5 && coverage.factor <= 10))
            coverage.problem = std::string("such a multiple is not plausible (") + remedy + ")";
        coverage.rest = without(coverage.rest, *multiple);
        // Cells under "wt% ± 2s" hold values and uncertainties.
        for (const std::string_view sign : plus_minus)
            if (coverage.rest.size() > sign.size() && coverage.rest.ends_with(sign))
                coverage.rest = trimmed(coverage.rest.substr(0, coverage.rest.size() - sign.size()));
        take_second_statement(coverage);
        return coverage;
    }
    if (const auto per_cent = coverage_in(coverage.rest)) {
        coverage.stated = coverage.rest.substr(per_cent->begin, per_cent->length);
        const auto known = factor_of_coverage(per_cent->number);
        coverage.factor = known.value_or(1);
        const bool has_sign = holds_plus_minus(coverage.rest);  // "95 % CI (±)"
        coverage.rest = without(coverage.rest, *per_cent);
        if (has_sign && !holds_plus_minus(coverage.rest)) coverage.rest = "\u00b1 " + coverage.rest;
        coverage.problem = problem_of_coverage(coverage.rest, known.has_value());
        return coverage;
    }
    static const std::regex in_brackets(R"(([(\[] *)((\d\d(?:[.,]\d+)?) *(?:%|percent|prozent))(?= *[)\]]))",
                                        std::regex::icase | std::regex::ECMAScript);
    if (const auto per_cent = found(coverage.rest, in_brackets);
        per_cent && factor_of_coverage(per_cent->number)) {  // "wt% (95 %)"
        std::string rest = without(coverage.rest, *per_cent);
        if (rest.find('%') != std::string::npos) {
            coverage.stated = coverage.rest.substr(per_cent->begin, per_cent->length);
            coverage.factor = *factor_of_coverage(per_cent->number);
            coverage.of_stated_uncertainties = true;
            coverage.rest = std::move(rest);
            return coverage;
        }
    }
    const auto is_expanded = [](const std::string& word) {
        return special_words().list_of(word) == "expanded";
    };
    if (const std::string other = unknown_behind_plus_minus(heading); !other.empty())
        coverage.problem = in_quotes(other) + " behind \"±\" names no standard uncertainty (" + remedy + ")";
    if (const std::string other = statistic_in_brackets(heading); !other.empty())
        coverage.problem = in_quotes(other) + " in brackets names no standard uncertainty (" + remedy + ")";
    const std::string_view symbol = trimmed(heading.substr(0, heading.find_first_of("[(,/")));
    if (symbol == "U" || heading.starts_with("U in ") ||
        (any_word(heading, is_expanded) && any_word(heading, is_uncertainty_word)))
        coverage.problem = std::string("an expanded uncertainty needs its coverage factor (") + remedy + ")";
    return coverage;
}

bool is_uncertainty_word(std::string_view text) {
    return uncertainty_words().holds(text);
}

bool names_uncertainty(std::string_view name) {
    return trimmed(name) != "+" && is_uncertainty_word(name);
}

namespace {

/// Removes the word or sign for a side from the start or end of a text. @return whether it is the upper one
std::optional<bool> take_side(std::string& text) {
    static const WordLists words("uncertainty sides");
    constexpr std::array<std::pair<std::string_view, bool>, 6> signs{
        {{"(+)", true}, {"(-)", false}, {"+", true}, {"-", false}, {"\u2212", false}, {"\u2013", false}}};
    for (const auto& [sign, is_upper] : signs)
        for (const bool in_front : {true, false}) {
            if (text.size() <= sign.size() || !(in_front ? text.starts_with(sign) : text.ends_with(sign)))
                continue;
            text =
                trimmed(std::string_view(text).substr(in_front ? sign.size() : 0, text.size() - sign.size()));
            return is_upper;
        }
    for (const bool in_front : {true, false}) {
        const auto at = in_front ? text.find_first_of(" _") : text.find_last_of(" _(");
        if (at == std::string::npos || at == 0) continue;
        const auto list = words.list_of(in_front ? text.substr(0, at) : text.substr(at + 1));
        if (!list) continue;
        text =
            trimmed(std::string_view(text).substr(in_front ? at + 1 : 0, in_front ? std::string::npos : at));
        return *list == "upper";
    }
    return std::nullopt;
}

}  // namespace

std::optional<UncertaintySide> uncertainty_side(std::string_view heading) {
    heading = trimmed(heading);
    if (heading.size() > longest_heading || holds_plus_minus(heading)) return std::nullopt;
    const auto bracket = heading.ends_with(']') ? heading.rfind('[') : std::string_view::npos;
    std::string text(trimmed(heading.substr(0, bracket)));
    const auto is_upper = take_side(text);
    if (!is_upper) return std::nullopt;
    const StatedCoverage coverage = read_coverage(text);
    const bool is_uncertain =
        coverage.rest.empty() ? !coverage.stated.empty() : any_word(coverage.rest, is_uncertainty_word);
    if (!is_uncertain || !coverage.problem.empty()) return std::nullopt;
    if (bracket != std::string_view::npos) (text += ' ') += heading.substr(bracket);
    return UncertaintySide{std::move(text), *is_upper};
}

namespace {

/// Removes a name, as a whole word, and "(n=3)" from a heading. Empty if the heading does not contain the
/// name.
std::string without_name(std::string_view heading, const std::string& name) {
    const std::string text = lower_case(heading);
    const auto is_apart = [&](std::size_t at) {
        const auto byte = static_cast<unsigned char>(at < text.size() ? text[at] : ' ');
        return std::isalnum(byte) == 0 &&
               (byte < 0x80U || byte == 0xc2U || byte == 0xb1U);  // "\u00b1" is apart
    };
    auto at = name.empty() ? std::string::npos : text.find(name);
    while (at != std::string::npos && !((at == 0 || is_apart(at - 1)) && is_apart(at + name.size())))
        at = text.find(name, at + 1);
    if (at == std::string::npos) return {};
    std::string_view before = heading.substr(0, at);
    std::string_view after = heading.substr(at + name.size());
    if (before.ends_with('(') && after.starts_with(')')) {
        before.remove_suffix(1);
        after.remove_prefix(1);
    }
    constexpr std::string_view dropped = " _.:,;/";
    const auto end = before.find_last_not_of(" _:,;/");
    const auto begin = after.find_first_not_of(dropped);
    std::string rest(before.substr(0, end + 1));  // none: npos + 1 is 0
    if (begin != std::string_view::npos) (rest += rest.empty() ? "" : " ") += after.substr(begin);
    static const std::regex repeats(" *[(\\[] *n *= *[0-9]+ *[)\\]]");
    rest = std::regex_replace(rest, repeats, "");
    return rest.substr(0, rest.find_last_not_of(" _:,;/") + 1);
}

}  // namespace

std::optional<UncertaintyBeside> uncertainty_beside(std::string_view heading, std::string_view name) {
    if (heading.size() > longest_heading) return std::nullopt;
    heading = trimmed(heading);
    auto bracket = heading.ends_with(']') ? heading.rfind('[') : std::string_view::npos;
    if (heading.ends_with("%)")) bracket = heading.rfind('(');  // "FA1 σ (wt%)"
    const std::string unit(bracket == std::string_view::npos ? "" : heading.substr(bracket));
    const std::string said = without_name(trimmed(heading.substr(0, bracket)), lower_case(trimmed(name)));
    if (said.empty()) return std::nullopt;
    const std::string rest = said + (unit.empty() ? "" : " ") + unit;
    const StatedCoverage coverage = read_coverage(said);
    std::string word = coverage.rest;
    for (const std::string_view small : {" of", " von", " de", " der", " des", " for"})
        if (word.ends_with(small)) word.resize(word.size() - small.size());
    if (is_uncertainty_word(word) || !coverage.problem.empty() || (word.empty() && !coverage.stated.empty()))
        return UncertaintyBeside{.text = rest, .problem = {}};
    const bool is_spread = said == "s" || (said.size() > 1 && is_summary(said) && !is_total(said));
    if (!is_spread && !names_spread(said) && !any_word(said, is_uncertainty_word)) return std::nullopt;
    return UncertaintyBeside{rest, in_quotes(said) + " names no standard uncertainty (" + remedy + ")"};
}

}  // namespace ashimpact
