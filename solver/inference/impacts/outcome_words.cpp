// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/outcome_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/text.hpp"

namespace ashimpact {

namespace {

constexpr std::array<std::string_view, 36> capture_words{"capture",         "captured",
                                                         "stuck",           "stick",
                                                         "sticks",          "sticking",
                                                         "deposited",       "deposit",
                                                         "adhered",         "adheres",
                                                         "adhesion",        "no rebound",
                                                         "did not rebound", "c",
                                                         "haftet",          "gehaftet",
                                                         "haftend",         "haften",
                                                         "haftung",         "haftet an",
                                                         "bleibt haften",   "haften geblieben",
                                                         "klebt",           "klebte",
                                                         "bleibt",          "bleibt kleben",
                                                         "kein rückprall",  "kein rueckprall",
                                                         "colle",           "collé",
                                                         "collée",          "reste",
                                                         "capturé",         "capturée",
                                                         "adhère",          "pas de rebond"};
constexpr std::array<std::string_view, 13> rebound_words{
    "rebound",    "rebounded", "rebounds",   "bounced", "bounces",  "r",      "prallt ab",
    "abgeprallt", "rückprall", "rueckprall", "rebond",  "rebondit", "rebondi"};
constexpr std::array<std::string_view, 10> unknown_words{"",    "unknown", "?",         "-",       "na",
                                                         "n/a", "nan",     "unbekannt", "inconnu", "k.a."};
constexpr std::array<std::string_view, 28> remark_headings{
    "bemerkung",   "bemerkungen",   "anmerkung",     "anmerkungen",  "befund",      "befunde",
    "status",      "verbleib",      "kommentar",     "notiz",        "notizen",     "hinweis",
    "beobachtung", "beobachtungen", "comment",       "comments",     "remark",      "remarks",
    "note",        "notes",         "observation",   "observations", "commentaire", "commentaires",
    "remarque",    "remarques",     "what happened", "observed"};

template <class Words>
bool is_one_of(const Words& words, std::string_view text) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

}  // namespace

OutcomeWord outcome_word(std::string_view cell) {
    const std::string text = lower_case(trimmed(cell));
    if (is_one_of(capture_words, text)) return OutcomeWord::capture;
    if (is_one_of(rebound_words, text)) return OutcomeWord::rebound;
    return is_one_of(unknown_words, text) ? OutcomeWord::unknown : OutcomeWord::none;
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
    std::string text = lower_case(trimmed(heading));
    while (!text.empty() && std::ispunct(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
    return is_one_of(remark_headings, text);
}

}  // namespace ashimpact
