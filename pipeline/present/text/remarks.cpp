// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/remarks.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "core/text.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

namespace {

/// A remark without the sample and the law that it begins with.
struct Parted {
    std::string sample;
    std::string law;
    std::string text;
};

bool is_law(std::string_view word) {
    for (std::size_t i = 0; i < Law::count(); ++i)
        if (Law::at(i).name() == word) return true;
    return false;
}

Parted parted(const std::string& text, const std::vector<std::string>& samples) {
    for (const std::string& sample : samples) {
        if (!text.starts_with(sample)) continue;
        if (text.compare(sample.size(), 2, ": ") == 0) return {sample, "", text.substr(sample.size() + 2)};
        const auto colon = text.find(": ", sample.size());
        if (colon == std::string::npos || text.compare(sample.size(), 2, ", ") != 0) continue;
        const std::string law = text.substr(sample.size() + 2, colon - sample.size() - 2);
        if (is_law(law)) return {sample, law, text.substr(colon + 2)};
    }
    return {"", "", text};
}

/// The text with # for every number and every name of a law: what remarks of one kind share.
std::string kind_of(std::string text) {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const std::string name = "law " + std::string(Law::at(i).name());
        for (auto at = text.find(name); at != std::string::npos; at = text.find(name))
            text.replace(at, name.size(), "#");
    }
    std::string kind;
    for (const char c : text) {
        const bool of_number = std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.';
        if (!of_number)
            kind += c;
        else if (!kind.ends_with('#'))
            kind += '#';
    }
    return kind;
}

/// What a remark says, without reasons and consequences: up to a semicolon, or a colon before words. What
/// stands in quotes or brackets is whole, and so is a question, which is what to look at.
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
    std::size_t count = 0;
};

/// What remarks say that decide nothing: how a file was read where that is plain, which phase was meant, what
/// is assumed of phases, how far a law's limits are, and how the paper's extrapolation differs from the
/// estimate.
constexpr std::array<std::string_view, 12> background{"\" is taken as ",
                                                      "no uncertainty of Young's modulus is known",
                                                      "the Poisson ratio is assumed",
                                                      " of the variance of E",
                                                      " leaves out the adhesion of ",
                                                      "Tabor parameter ",
                                                      "of the estimate over that of the extrapolation",
                                                      "extrapolated fit: ",
                                                      " above the heading not read",
                                                      " is read, not ",
                                                      "was read as Latin-1",
                                                      " is used; the catalogue has "};

bool decides(const std::string& text) {
    return !text.ends_with("\" is not used") &&
           std::none_of(background.begin(), background.end(),
                        [&](std::string_view part) { return text.find(part) != std::string::npos; });
}

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

std::vector<RemarkLine> remark_lines(const std::vector<Remark>& remarks,
                                     const std::vector<std::string>& samples) {
    std::vector<Kind> kinds;
    for (const Remark& remark : remarks) {
        const Parted parts = parted(remark.text, samples);
        const std::string kind = kind_of(parts.text);
        auto found = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& each) {
            return each.file == remark.file && each.kind == kind;
        });
        if (found == kinds.end())
            found = kinds.insert(kinds.end(), {.file = remark.file, .kind = kind, .first = parts.text});
        ++found->count;
        add_once(found->samples, parts.sample);
        add_once(found->laws, parts.law);
    }
    std::vector<RemarkLine> lines;
    lines.reserve(kinds.size());
    for (const Kind& kind : kinds)
        lines.push_back({.text = fmt::format("{} x {}{}: {}", kind.count, kind.file,
                                             of_what(kind, samples.size()), statement_of(kind.first)),
                         .decides = decides(kind.first)});
    return lines;
}

}  // namespace ashimpact
