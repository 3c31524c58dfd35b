// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quantities/names.hpp"

namespace ashimpact {

/// One group of word lists of data/vocabulary.json, such as the headings of columns of an XRD table.
class WordLists {
  public:
    /// @param kept other characters than letters and digits that count; see word_key()
    /// @throws std::logic_error if the file has no such group, or a word in two of its lists
    explicit WordLists(std::string_view group, std::string_view kept = {});

    /// The name of the list that holds a text or its singular, as compared by word_key(). Nothing if none
    /// does.
    [[nodiscard]] std::optional<std::string_view> list_of(std::string_view text) const;
    [[nodiscard]] bool holds(std::string_view text) const { return list_of(text).has_value(); }

    /// All words as keys, with the names of their lists.
    [[nodiscard]] const std::map<std::string, std::string, std::less<>>& words() const { return words_; }

  private:
    std::string kept_;
    std::map<std::string, std::string, std::less<>> words_;
};

/// The value of an enumeration that has the name of the list with that text, if it is one.
template <Named Enum>
[[nodiscard]] std::optional<Enum> meaning(const WordLists& lists, std::string_view text) {
    const auto list = lists.list_of(text);
    if (!list) return std::nullopt;
    for (const Enum value : all_values<Enum>)
        if (name_of(value) == *list) return value;
    return std::nullopt;
}

/// No heading and no name is longer. Beyond it a text is not searched for units and marks: that takes the
/// square of its length, and regular expressions need stack for each byte.
inline constexpr std::size_t longest_heading = 200;

/// Kept characters for words that count as they are written, apart from case and accents.
inline constexpr std::string_view all_marks = " !\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~";

/// Whether a cell states that there is no number: "", "-", "n.d.", "n/a", "UNDEF", "ERROR", "< 0.5".
[[nodiscard]] bool says_no_number(std::string_view text);

/// Whether a cell names a row that sums up others: "Mittel", "mean", "SD (n=3)", "Total".
[[nodiscard]] bool is_summary(std::string_view text);

/// Whether a cell names the sum of other rows: "Total", "Summe".
[[nodiscard]] bool is_total(std::string_view text);

/// Whether a cell names a mean: "Mittelwert", "average".
[[nodiscard]] bool names_mean(std::string_view text);

/// Whether a heading names coverage factors: "coverage factor k", "k", "Erweiterungsfaktor [-]".
[[nodiscard]] bool names_coverage_factor(std::string_view heading);

/// Whether a heading is a word such as "Level", which names coverages if all its numbers are known ones.
[[nodiscard]] bool may_name_coverages(std::string_view heading);

/// The half-width of the interval of that coverage in per cent, "95", in standard deviations; none if it is
/// not known here.
[[nodiscard]] std::optional<double> factor_of_coverage(std::string_view per_cent);

/// The words of a text as word_key() writes them; "%" is one. "FA1Vol" and "FA1_Vol" are two.
[[nodiscard]] std::vector<std::string> words_in(std::string_view text);

/// A word or some words of a list in a text.
struct Mention {
    std::string_view list;
    bool negated;
    std::size_t first, count;  ///< of its words
};

/// All mentions in words_in(), the longest first at each place. @param lists keep blanks
[[nodiscard]] std::vector<Mention> mentions_in(const std::vector<std::string>& words, const WordLists& lists);

/// Words that name an uncertainty and nothing else: "u", "±", "esd", "std. error", "Messunsicherheit".
[[nodiscard]] const WordLists& uncertainty_words();

/// The coverage of uncertainties that the heading of a column states, as in "Unsicherheit (2s)", "U (k=2)",
/// "error (95 %)" or "v_in ± 2 sigma [m/s]".
struct StatedCoverage {
    std::string rest;           ///< the heading without the statement, "Unsicherheit"
    double factor = 1;          ///< numbers of the column over standard uncertainties: 2, and 1.96 for 95 %
    std::string stated;         ///< "2s"; empty if nothing is stated
    bool stated_first = false;  ///< before the name, "2s v_in"
    /// "wt% (95 %)", which is a coverage only of uncertainties in the cells or in the column behind.
    bool of_stated_uncertainties = false;
    /// Why the uncertainties cannot be read, with the remedy; empty if they can.
    std::string problem;
};

/// Finds a multiple of the standard uncertainty (2s, 2 sigma, 2σ, 2 SD, k = 2), or a coverage (95 %) beside
/// the name of an uncertainty or "±". A bare "2s" counts in brackets, after "±" or a word for an uncertainty,
/// and alone. A confidence interval without "±" and an expanded uncertainty without k are problems. The rest
/// of "% error" and "err%" is "error [%]".
[[nodiscard]] StatedCoverage read_coverage(std::string_view heading);

/// The number that follows "±", as in "v_in ± 0.03": one uncertainty for a whole column. Empty without one.
[[nodiscard]] std::string number_behind_plus_minus(std::string_view heading);

/// Whether a text is a word for an uncertainty and names no quantity: "Fehler", "u", "s.u.", "±".
[[nodiscard]] bool is_uncertainty_word(std::string_view text);

/// Whether the name of a column is such a word; "+" alone is one side of an uncertainty.
[[nodiscard]] bool names_uncertainty(std::string_view name);

/// One side of an asymmetric uncertainty: "-err", "err+", "upper error [wt%]".
struct UncertaintySide {
    std::string text;  ///< the heading without the side, "err", "error [wt%]"
    bool is_upper = false;
};
/// Splits the heading of one side; nothing for another heading, such as "± err".
[[nodiscard]] std::optional<UncertaintySide> uncertainty_side(std::string_view heading);

/// The part of a heading that describes an uncertainty of the named column, without the name.
struct UncertaintyBeside {
    std::string text;     ///< "2s [wt%]" of "FA1 2s [wt%]", "2s(FA1) [wt%]"
    std::string problem;  ///< why the column cannot be read, as "FA1 RSD"; empty: see read_coverage(text)
};
/// Splits "FA1 2s" into the name of another column, "FA1", and the description of its uncertainty. Returns
/// nothing for other headings, such as "FA1 wet" and "FA1 [wt%]".
[[nodiscard]] std::optional<UncertaintyBeside> uncertainty_beside(std::string_view heading,
                                                                  std::string_view name);

}  // namespace ashimpact
