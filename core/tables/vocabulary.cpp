// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/vocabulary.hpp"

#include <span>
#include <stdexcept>

#include "core/embedded.hpp"
#include "core/json/document.hpp"
#include "core/text/text.hpp"
#include "core/text/utf8.hpp"

namespace ashimpact {

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
    const auto found = words_.find(word_key(text, kept_));
    return found == words_.end() ? std::nullopt : std::optional<std::string_view>(found->second);
}

bool says_no_number(std::string_view text) {
    static const WordLists words("no number", all_marks);
    const std::string_view word = trimmed(text);
    return word.starts_with('<') || words.holds(word);
}

const WordLists& uncertainty_words() {
    static const WordLists words("uncertainty", "+");
    return words;
}

}  // namespace ashimpact
