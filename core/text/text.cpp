// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

namespace ashimpact {

namespace {

std::string without(char removed, std::string_view number) {
    std::string rest(number);
    std::erase(rest, removed);
    return rest;
}

/// The two readings of a number with commas, both written with a decimal point: with a decimal comma, and
/// with commas between groups of thousands. They are equal if only one is possible.
std::pair<std::string, std::string> readings_of_commas(std::string_view number) {
    const auto comma = number.find(',');
    if (comma == std::string_view::npos) return {std::string(number), std::string(number)};
    const std::string without_commas = without(',', number);
    const auto point = number.rfind('.');
    const bool points_last = point != std::string_view::npos && point > number.rfind(',');
    if (points_last || number.rfind(',') != comma) return {without_commas, without_commas};
    std::string with_point = without('.', number);
    with_point[with_point.find(',')] = '.';
    const bool thousands =
        point == std::string_view::npos && number.size() - comma == 4 && comma <= 3 && number.front() != '0';
    return {with_point, thousands ? without_commas : with_point};
}

/// Whether a number overflowed to infinity, although it has digits ("inf" has none), or underflowed to zero,
/// although its mantissa is not zero.
bool is_out_of_range(std::string_view text, double value) {
    if (std::isinf(value)) return text.find_first_of("0123456789") != std::string_view::npos;
    const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
    return value == 0 && mantissa.find_first_of("123456789") != std::string_view::npos;
}

/// Number of significant digits of a number in decimal notation.
std::size_t significant_digits(std::string text) {
    text.resize(std::min(text.find('e'), text.size()));
    std::erase_if(text, [](char c) { return c == '.' || c == '-'; });
    const auto first = text.find_first_not_of('0');
    return first == std::string::npos ? 1 : text.find_last_not_of('0') + 1 - first;
}

unsigned char byte_of(char c) {
    return static_cast<unsigned char>(c);
}

/// Whether a byte is a continuation byte of a character.
bool continues(char c) {
    return (byte_of(c) & 0xc0U) == 0x80U;
}

using Spelling = std::pair<std::string_view, std::string_view>;

/// Composed letters first, then combining marks as macOS writes them: "u" and U+0308 is "ue", too.
constexpr std::array<Spelling, 77> spellings{{
    {"ä", "ae"},       {"ö", "oe"},       {"ü", "ue"},       {"Ä", "Ae"},       {"Ö", "Oe"},
    {"Ü", "Ue"},       {"ß", "ss"},       {"ẞ", "SS"},       {"æ", "ae"},       {"œ", "oe"},
    {"ø", "o"},        {"å", "a"},        {"à", "a"},        {"á", "a"},        {"â", "a"},
    {"ã", "a"},        {"ç", "c"},        {"è", "e"},        {"é", "e"},        {"ê", "e"},
    {"ë", "e"},        {"ì", "i"},        {"í", "i"},        {"î", "i"},        {"ï", "i"},
    {"ñ", "n"},        {"ò", "o"},        {"ó", "o"},        {"ô", "o"},        {"õ", "o"},
    {"ù", "u"},        {"ú", "u"},        {"û", "u"},        {"À", "A"},        {"Ç", "C"},
    {"È", "E"},        {"É", "E"},        {"Ê", "E"},        {"Î", "I"},        {"Ô", "O"},
    {"a\u0308", "ae"}, {"o\u0308", "oe"}, {"u\u0308", "ue"}, {"A\u0308", "Ae"}, {"O\u0308", "Oe"},
    {"U\u0308", "Ue"}, {"\u0300", ""},    {"\u0301", ""},    {"\u0302", ""},    {"\u0303", ""},
    {"\u0308", ""},    {"\u030a", ""},    {"\u0327", ""},    {"α", "alpha"},    {"β", "beta"},
    {"γ", "gamma"},    {"θ", "theta"},    {"σ", "sigma"},    {"Σ", "sum"},      {"±", "+-"},
    {"²", "2"},        {"³", "3"},        {"₀", "0"},        {"₁", "1"},        {"₂", "2"},
    {"₃", "3"},        {"₄", "4"},        {"₅", "5"},        {"₆", "6"},        {"₇", "7"},
    {"₈", "8"},        {"₉", "9"},        {"ᵢ", "i"},        {"ᵣ", "r"},        {"ₙ", "n"},
    {"·", "."},        {"\u00a0", " "},
}};

/// Capital letters of Latin-1 and Cyrillic as small ones, except "Ø", the sign of a mean.
std::string with_small_letters(std::string text) {
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        const unsigned char second = byte_of(text[i + 1]);
        const bool is_latin =
            byte_of(text[i]) == 0xc3U && second <= 0x9eU && second != 0x97U && second != 0x98U;
        const bool is_cyrillic = byte_of(text[i]) == 0xd0U && (second == 0x81U || second - 0x90U < 0x20U);
        if (is_cyrillic && (second == 0x81U || second >= 0xa0U)) text[i] = '\xd1';
        if (is_cyrillic)
            text[i + 1] = static_cast<char>(second == 0x81U ? 0x91U : second ^ 0x20U);
        else if (is_latin)
            text[i + 1] = static_cast<char>(second | 0x20U);
    }
    return text;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n\f\v";
    const auto first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::string shown = "\"";
    for (const char c : whole_start(text, longest)) shown += byte_of(c) < 0x20 || c == 0x7f ? ' ' : c;
    return shown + (text.size() > longest ? "...\"" : "\"");
}

std::string on_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::vector<std::size_t>> steps(from.size() + 1, std::vector<std::size_t>(to.size() + 1));
    for (std::size_t i = 0; i <= from.size(); ++i) {
        for (std::size_t j = 0; j <= to.size(); ++j) {
            if (i == 0 || j == 0) {
                steps[i][j] = i + j;
                continue;
            }
            const std::size_t replaced = steps[i - 1][j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
            steps[i][j] = std::min({replaced, steps[i - 1][j] + 1, steps[i][j - 1] + 1});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                steps[i][j] = std::min(steps[i][j], steps[i - 2][j - 2] + 1);
        }
    }
    return steps[from.size()][to.size()];
}

std::vector<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates,
                                 std::size_t count) {
    constexpr std::size_t longest = 64;  // no phase or key is longer; keeps the cost of junk bounded
    const std::string wanted = lower_case(word.substr(0, longest));
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (const auto& candidate : candidates) {
        const std::size_t distance = edit_distance(wanted, lower_case(candidate));
        if (2 * distance <= wanted.size()) ranked.emplace_back(distance, candidate);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    ranked.resize(std::min(count, ranked.size()));
    std::vector<std::string> words;
    words.reserve(ranked.size());
    for (auto& [_, candidate] : ranked) words.push_back(std::move(candidate));
    return words;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const auto guess = nearest(word, candidates, 1);
    return guess.empty() ? std::string{} : ", did you mean " + in_quotes(guess.front()) + "?";
}

std::string remedy_for_commas(std::string_view text) {
    const auto digit_at = [&](std::size_t at) { return at < text.size() && is_digit(text[at]); };
    std::string with_point;
    std::string without_groups;
    for (std::size_t at = 0; at < text.size();) {
        if (!digit_at(at)) {
            with_point += text[at];
            without_groups += text[at++];
            continue;
        }
        std::size_t end = at;
        while (digit_at(end) ||
               (end < text.size() && (text[end] == ',' || text[end] == '.') && digit_at(end + 1)))
            ++end;
        const auto [decimal, grouped] = readings_of_commas(text.substr(at, end - at));
        with_point += decimal;
        without_groups += grouped;
        at = end;
    }
    if (with_point == text && without_groups == text) return {};
    if (with_point == without_groups) return "write " + in_quotes(with_point);
    return "write " + in_quotes(without_groups) + " or " + in_quotes(with_point);
}

namespace {

/// Whether a sign stands between digits, as in "80-100".
bool holds_range(std::string_view number) {
    const auto sign = number.find_first_of("+-", 1);
    return sign != std::string_view::npos && number[sign - 1] != 'e' && number[sign - 1] != 'E';
}

}  // namespace

std::string remedy_for_number_in_quotes(std::string_view text) {
    const std::string_view number = trimmed(text);
    if (number.empty() || number.size() > 30 ||
        number.find_first_not_of("+-.,0123456789eE") != std::string_view::npos ||
        number.find_first_of("0123456789") == std::string_view::npos || holds_range(number))
        return {};
    if (const std::string remedy = remedy_for_commas(number); !remedy.empty())
        return ", " + without('"', remedy) + " without quotes";
    return ", write " + std::string(number) + " without quotes";
}

std::string with_article(std::string_view noun) {
    const bool vowel =
        !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
    return (vowel ? "an " : "a ") + std::string(noun);
}

std::vector<std::string> cut_at_numbers(std::string_view text) {
    const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    std::vector<std::string> pieces{""};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool in_number = pieces.size() % 2 == 0;
        const bool belongs = is_digit(i) || (in_number && text[i] == '.' && is_digit(i + 1));
        if (belongs != in_number) pieces.emplace_back();
        pieces.back() += text[i];
    }
    return pieces;
}

std::string without_numbers(std::string_view text) {
    std::vector<std::string> pieces = cut_at_numbers(text);
    bool quoted = false;  // as names are
    for (std::size_t i = 1; i < pieces.size(); i += 2) {
        if (std::ranges::count(pieces[i - 1], '"') % 2 == 1) quoted = !quoted;
        if (!quoted) pieces[i] = "#";
    }
    return fmt::format("{}", fmt::join(pieces, ""));
}

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string joined(std::span<const std::string_view> words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string without_controls(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    for_each_character(text, [&](const Character& character) {
        shown += character.valid && !character.is_control() ? character.bytes : "?";
    });
    return shown;
}

std::string shortened(const std::string& text) {
    constexpr std::size_t longest = 120;
    constexpr std::size_t kept = 50;
    if (text.size() <= longest) return text;
    return std::string(whole_start(text, kept)) + "..." + std::string(whole_end(text, kept));
}

std::string shell_word(const std::string& text) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string numbered(std::string_view word, const std::vector<std::size_t>& numbers) {
    constexpr std::size_t most = 6;
    std::string text = fmt::format("{}{} ", word, numbers.size() == 1 ? "" : "s");
    for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
    return numbers.size() > most ? fmt::format("{} and {} more", text, numbers.size() - most) : text;
}

std::errc take_decimal(std::string_view& text, double& value) {
    double number = 0;
    const auto* const first = text.data();
    const auto [end, status] = fast_float::from_chars(first, first + text.size(), number);
    if (status != std::errc{}) return status;
    const auto length = static_cast<std::size_t>(end - first);
    if (is_out_of_range(text.substr(0, length), number)) return std::errc::result_out_of_range;
    text.remove_prefix(length);
    value = number;
    return status;
}

std::optional<double> whole_decimal(std::string_view text) {
    double value = 0;
    return take_decimal(text, value) == std::errc{} && text.empty() ? std::optional(value) : std::nullopt;
}

std::string shortest(double value) {
    std::string fixed = fmt::format("{}", value);  // in exponential notation below 1e-4 and from 1e16
    if (!std::isfinite(value)) return fixed;
    // Rounded anew to so many digits, a power of two can become its lower neighbour.
    std::string exponential = fixed;
    if (fixed.find('e') == std::string::npos) {
        exponential = fmt::format("{:.{}e}", value, significant_digits(fixed) - 1);
    } else {
        if (std::abs(value) < 1 || std::abs(value) > 1e25) return fixed;
        fixed = fmt::format("{:.0f}", value);
    }
    return fixed.size() <= exponential.size() ? fixed : exponential;
}

bool Character::is_control() const {
    return (code_point < 0x20 && code_point != '\n' && code_point != '\t') ||
           (code_point >= 0x7f && code_point < 0xa0);
}

Character first_character(std::string_view text) {
    const Character invalid{.bytes = text.substr(0, 1)};
    const unsigned char lead = byte_of(text.front());
    if (lead < 0x80U) return {text.substr(0, 1), lead, true};
    const std::size_t length = lead >= 0xf0U ? 4 : lead >= 0xe0U ? 3 : 2;
    if (lead < 0xc2U || lead > 0xf4U || text.size() < length) return invalid;
    char32_t value = lead & (0xffU >> (length + 1));
    for (const char c : text.substr(1, length - 1)) {
        if (!continues(c)) return invalid;
        value = (value << 6U) | (byte_of(c) & 0x3fU);
    }
    const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
    const bool surrogate = value >= 0xd800 && value < 0xe000;
    return overlong || surrogate || value > 0x10ffff ? invalid
                                                     : Character{text.substr(0, length), value, true};
}

bool is_utf8(std::string_view text) {
    bool valid = true;
    for_each_character(text, [&](const Character& character) { valid = valid && character.valid; });
    return valid;
}

bool is_ascii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return byte_of(c) < 0x80U; });
}

std::size_t width_of(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues));
}

std::string_view first_characters(std::string_view text, std::size_t count) {
    std::size_t end = 0;
    while (end < text.size() && (continues(text[end]) || count-- > 0)) ++end;
    return text.substr(0, end);
}

std::string_view whole_start(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text;
    std::size_t end = most;
    while (end > 0 && most - end < 3 && continues(text[end])) --end;
    return text.substr(0, end);
}

std::string_view whole_end(std::string_view text, std::size_t most) {
    std::size_t start = text.size() > most ? text.size() - most : 0;
    for (int i = 0; i < 3 && start < text.size() && continues(text[start]); ++i) ++start;
    return text.substr(start);
}

std::string from_latin1(std::string_view bytes) {
    constexpr unsigned first_of_windows = 0x80;
    constexpr std::array<std::string_view, 32> of_windows{
        "\u20ac", "",       "\u201a", "\u0192", "\u201e", "\u2026", "\u2020", "\u2021",
        "\u02c6", "\u2030", "\u0160", "\u2039", "\u0152", "",       "\u017d", "",
        "",       "\u2018", "\u2019", "\u201c", "\u201d", "\u2022", "\u2013", "\u2014",
        "\u02dc", "\u2122", "\u0161", "\u203a", "\u0153", "",       "\u017e", "\u0178"};
    std::string text;
    for (const char c : bytes) {
        if (byte_of(c) < 0x80U) {
            text += c;
            continue;
        }
        const unsigned place = byte_of(c) - first_of_windows;
        if (place < of_windows.size() && !of_windows[place].empty()) {
            text += of_windows[place];
            continue;
        }
        text += static_cast<char>(0xc0U | (byte_of(c) >> 6U));
        text += static_cast<char>(0x80U | (byte_of(c) & 0x3fU));
    }
    return text;
}

std::string replaced(std::string_view text, Replacements pairs) {
    std::string result;
    while (!text.empty()) {
        const auto found = std::find_if(pairs.begin(), pairs.end(),
                                        [&](const auto& pair) { return text.starts_with(pair.first); });
        result += found != pairs.end() ? found->second : text.substr(0, 1);
        text.remove_prefix(found != pairs.end() ? found->first.size() : 1);
    }
    return result;
}

std::string transliterated(std::string_view text) {
    return is_ascii(text) ? std::string(text) : replaced(text, spellings);
}

std::string word_key(std::string_view text, std::string_view kept) {
    std::string key = lower_case(is_ascii(text) ? std::string(text)
                                                : transliterated(with_small_letters(std::string(text))));
    std::erase_if(key, [&](char c) {
        const bool is_letter_or_digit =
            (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || byte_of(c) >= 0x80U;
        return !is_letter_or_digit && kept.find(c) == std::string_view::npos;
    });
    return key;
}

std::string sample_key(std::string_view name) {
    std::string text(name);
    const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_between_digits = i > 0 && is_digit(i - 1) && is_digit(i + 1);
        if (text[i] == '-' && (i == 0 || text[i - 1] == ' ') && is_digit(i + 1)) text[i] = '<';
        if ((text[i] == '.' || text[i] == ',') && !is_between_digits) text[i] = ' ';
        if (std::string_view("-_ /").find(text[i]) != std::string_view::npos && is_between_digits)
            text[i] = '+';  // "FA11-2" is not "FA1-12"
    }
    return word_key(text, "+<>.,");
}

}  // namespace ashimpact
