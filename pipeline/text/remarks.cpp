#include "pipeline/text/remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "materials/base/text.hpp"
#include "solver/contact/registry.hpp"

namespace ashimpact {

namespace {

/// A remark without the sample and the law that it begins with.
struct Parted {
    std::string sample;
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
        if (text.compare(sample.size(), 2, ": ") == 0) return {sample, text.substr(sample.size() + 2)};
        const auto colon = text.find(": ", sample.size());
        if (colon == std::string::npos || text.compare(sample.size(), 2, ", ") != 0) continue;
        if (is_law(text.substr(sample.size() + 2, colon - sample.size() - 2)))
            return {sample, text.substr(colon + 2)};
    }
    return {"", text};
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

/// What a remark says, without reasons and consequences: up to a semicolon, or a colon before words.
std::string statement_of(const std::string& text) {
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (text[i + 1] != ' ') continue;
        const bool words = std::isalpha(static_cast<unsigned char>(text[i + 2])) != 0;
        if (text[i] == ';' || (text[i] == ':' && words)) return text.substr(0, i);
    }
    return text;
}

struct Kind {
    std::string file;
    std::string kind;
    std::string first;
    std::vector<std::string> samples{};
    std::size_t count = 0;
};

}  // namespace

std::vector<std::string> remark_lines(const std::vector<Remark>& remarks,
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
        if (!parts.sample.empty() &&
            std::find(found->samples.begin(), found->samples.end(), parts.sample) == found->samples.end())
            found->samples.push_back(parts.sample);
    }
    std::vector<std::string> lines;
    for (const Kind& kind : kinds) {
        const bool all = samples.size() > 1 && kind.samples.size() == samples.size();
        const std::string of = kind.samples.empty() ? ""
                               : all                ? " (all samples)"
                                                    : " (" + joined(kind.samples) + ")";
        lines.push_back(fmt::format("{} x {}{}: {}", kind.count, kind.file, of, statement_of(kind.first)));
    }
    return lines;
}

}  // namespace ashimpact
