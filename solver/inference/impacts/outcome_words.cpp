// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/outcome_words.hpp"

#include <cctype>

#include "core/tables/vocabulary.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

OutcomeWord outcome_word(std::string_view cell) {
    static const WordLists words("outcomes", all_marks);
    return meaning<OutcomeWord>(words, trimmed(cell)).value_or(OutcomeWord::none);
}

OutcomeWord outcome_of_remark(std::string_view remark) {
    constexpr std::string_view dropped = ".!()[] ";
    const auto first = remark.find_first_not_of(dropped);
    if (first == std::string_view::npos) return OutcomeWord::none;
    const std::string_view word = remark.substr(first, remark.find_last_not_of(dropped) - first + 1);
    if (word.size() < 2) return OutcomeWord::none;
    const OutcomeWord meaning = outcome_word(word);
    return meaning == OutcomeWord::unknown ? OutcomeWord::none : meaning;
}

bool announces_remarks(std::string_view heading) {
    static const WordLists words("remark columns", all_marks);
    std::string_view text = trimmed(heading);
    while (!text.empty() && std::ispunct(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
    return words.holds(text);
}

}  // namespace ashimpact
