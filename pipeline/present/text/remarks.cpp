// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/remarks.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// What notes that differ in their numbers and their law alone share.
std::string kind_of(const Note& note) {
    std::string kind = without_numbers(note.text);
    if (!note.law) return kind;
    const std::string name = "law " + std::string(note.law->name());
    const auto at = kind.find(name);
    return at == std::string::npos ? kind : kind.replace(at, name.size(), "law");
}

/// The statement of a remark, without reasons and consequences: up to a semicolon, or a colon before words.
/// Text in quotes or brackets is never cut, nor is a question.
std::string statement_of(const std::string& text) {
    const bool asks = text.ends_with('?');
    bool quoted = false;
    int brackets = 0;
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (text[i] == '"') quoted = !quoted;
        if (text[i] == '(') ++brackets;
        if (text[i] == ')') --brackets;
        if (quoted || brackets > 0 || text[i + 1] != ' ') continue;
        const bool words = std::isalpha(static_cast<unsigned char>(text[i + 2])) != 0;
        if (text[i] == ';' || (text[i] == ':' && words && !asks)) return text.substr(0, i);
    }
    return text;
}

struct Kind {
    std::string file;
    std::string kind;
    std::string first;
    std::vector<std::string> samples{};
    std::vector<std::string> laws{};
    Severity severity = Severity::remark;
    std::size_t count = 0;
};

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// " (fine; dmt, jkr)": the samples of a kind, "all samples" where it is all of several, and the laws.
std::string of_what(const Kind& kind, std::size_t samples) {
    if (kind.samples.empty()) return {};
    const bool all = samples > 1 && kind.samples.size() == samples;
    return fmt::format(" ({}{}{})", all ? "all samples" : joined(kind.samples), kind.laws.empty() ? "" : "; ",
                       joined(kind.laws));
}

}  // namespace

std::vector<RemarkLine> remark_lines(const std::vector<Remark>& remarks, std::size_t samples) {
    std::vector<Kind> kinds;
    for (const Remark& remark : remarks) {
        const Note& note = remark.note;
        const std::string kind = kind_of(note);
        auto found = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& each) {
            return each.file == remark.file && each.kind == kind;
        });
        if (found == kinds.end())
            found = kinds.insert(
                kinds.end(),
                {.file = remark.file, .kind = kind, .first = note.text, .severity = note.severity});
        ++found->count;
        add_once(found->samples, note.sample);
        if (note.law) add_once(found->laws, std::string(note.law->name()));
    }
    std::vector<RemarkLine> lines;
    lines.reserve(kinds.size());
    for (const Kind& kind : kinds)
        lines.push_back({.text = fmt::format("{} x {}{}: {}", kind.count, kind.file, of_what(kind, samples),
                                             statement_of(kind.first)),
                         .decides = kind.severity != Severity::background});
    return lines;
}

}  // namespace ashimpact
