// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "pipeline/document/files/sha256.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/page/run_page.hpp"
#include "pipeline/present/text/readable.hpp"

namespace ashimpact::report {

namespace {

/// A text cut at its numbers: words, number, words, ...
std::vector<std::string> cut_at_numbers(const std::string& text) {
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

/// Texts that differ in their numbers alone as one: "1.2" and "1.4" come out as "1.2 to 1.4".
std::string with_ranges(const std::vector<std::string>& texts) {
    std::vector<std::string> pieces = cut_at_numbers(texts.front());
    for (std::size_t at = 1; at < pieces.size(); at += 2) {
        std::string least = pieces[at];
        std::string greatest = pieces[at];
        for (const std::string& text : texts) {
            const auto other = cut_at_numbers(text);
            if (other.size() != pieces.size()) continue;
            if (std::stod(other[at]) < std::stod(least)) least = other[at];
            if (std::stod(other[at]) > std::stod(greatest)) greatest = other[at];
        }
        pieces[at] = least == greatest ? least : fmt::format("{} to {}", least, greatest);
    }
    std::string text;
    for (const std::string& piece : pieces) text += piece;
    return text;
}

/// Things said of several samples: each once, with where it holds, in the order of their first mention.
class Grouped {
  public:
    void add(const std::string& key, const std::string& text, const std::string& where) {
        const auto found = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& entry) { return entry.key == key; });
        Entry& entry = found == entries_.end() ? entries_.emplace_back(Entry{key, {}, {}}) : *found;
        entry.texts.push_back(text);
        if (!where.empty() && std::find(entry.where.begin(), entry.where.end(), where) == entry.where.end())
            entry.where.push_back(where);
    }
    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] std::string html() const {
        std::string html = "<ul class=\"notes\">\n";
        for (const Entry& entry : entries_) {
            html += "<li>" + with_ranges(entry.texts);
            if (!entry.where.empty()) {
                html += " <span class=\"where\">(";
                for (std::size_t i = 0; i < entry.where.size(); ++i)
                    html += (i > 0 ? "; " : "") + html_name(entry.where[i]);
                html += ")</span>";
            }
            html += "</li>\n";
        }
        return html + "</ul>\n";
    }

  private:
    struct Entry {
        std::string key;
        std::vector<std::string> texts;
        std::vector<std::string> where;
    };
    std::vector<Entry> entries_;
};

std::string words_of(std::string key) {
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

bool is_told(const std::string& origin) {
    return origin == "given" || origin == "measured" || origin == "computed";
}

/// Every quantity below @p node whose origin says that it was not simply given.
void collect(const Json& node, const std::string& path, const std::string& where, Grouped& into) {
    if (!node.is_object()) return;
    if (node.contains("value") && node.contains("origin") && node.at("origin").is_string()) {
        const std::string origin = node.at("origin").get<std::string>();
        if (is_told(origin) || !node.at("value").is_number()) return;
        const std::string value = readable(node.at("value").get<double>(), node.value("unit", "1"));
        std::string text = fmt::format("<b>{}</b> {}, {}", escaped(path), escaped(value), escaped(origin));
        if (node.contains("source") && node.at("source").is_string())
            text += ": " + escaped(node.at("source").get<std::string>());
        into.add(text, text, where);
        return;
    }
    for (const auto& [key, value] : node.items())
        if (key != "published")
            collect(value, path.empty() ? words_of(key) : path + ", " + words_of(key), where, into);
}

std::string without_digits(const std::string& text) {
    std::string key;
    for (const char c : text)
        if ((c < '0' || c > '9') && c != '.') key += c;
    return key;
}

/// "88 um, hertz": the sample and the law of a note.
std::string place_of(const Note& note) {
    return note.law ? fmt::format("{}, {}", note.sample, note.law->name()) : note.sample;
}

std::string sentence(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

constexpr std::string_view artifacts_with_notes[]{
    "0-case.json",    "1-modulus.json", "2-contact.json",           "3-analytic.json",  "4-restitution.json",
    "5-damping.json", "6-fit.json",     "7-critical-velocity.json", "8-histories.json", "comparison.json"};

}  // namespace

std::string assumptions_html(const RunData& run) {
    const Json& result = run.artifacts().at("0-case.json").document.at("result");
    Grouped notes;
    for (const auto& [key, value] : result.items())
        if (key != "samples" && key != "phases") collect(value, words_of(key), "", notes);
    for (const Json& sample : result.at("samples"))
        collect(sample, "", sample.at("name").get<std::string>(), notes);
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.measured != nullptr && law.measured->origin != Origin::measured) {
                const std::string text =
                    fmt::format("<b>restitution</b> {}: {}", escaped(name_of(law.measured->origin)),
                                escaped(law.measured->source));
                notes.add(text, text, sample.name);
            }
    if (notes.empty()) return "<p>Nothing: every input was given or measured.</p>\n";
    return "<p>These inputs were not measured. A result is as good as they are.</p>\n" + notes.html();
}

std::string validity_html(const RunData& run) {
    const bool two_spheres = !run.samples().empty() && run.samples().front().contact->partner;
    std::string html = fmt::format(
        "<ul class=\"notes\"><li>Normal impact of {}; dry, at room temperature. Rotation, roughness, charge, "
        "liquid and soft ash are not in it.</li>\n",
        two_spheres ? "one smooth sphere on another" : "one sphere on a flat, smooth wall");
    double least = 1e300;
    double greatest = 0;
    bool yields = false;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            if (!law.velocity_json.is_object() || !law.velocity_json.contains("regime") ||
                !law.velocity_json.at("regime").is_object())
                continue;
            const Json& regime = law.velocity_json.at("regime");
            if (const auto tabor = number_in(regime, "tabor_parameter")) {
                least = std::min(least, *tabor);
                greatest = std::max(greatest, *tabor);
            }
            yields = yields || (regime.contains("yields") && regime.at("yields") == true);
        }
    if (greatest > 0) {
        const char* meaning = least > 5 ? "above 5 the limit of JKR holds"
                              : greatest < 0.1
                                  ? "below 0.1 the limit of DMT holds"
                                  : "DMT holds below 0.1, JKR above 5, and between them neither exactly";
        html += fmt::format("<li>Tabor parameter {:.3g}{}: {}.</li>\n", least,
                            greatest > 1.001 * least ? fmt::format(" to {:.3g}", greatest) : "", meaning);
    }
    html += yields ? "<li>At v<sub>c</sub> some of these contacts yield: laws without plasticity are then "
                     "too elastic.</li>\n"
                   : "<li>Fits are taken over the rising branch of e<sub>n</sub>(v<sub>in</sub>), before "
                     "plastic deformation takes over.</li>\n";
    html += fmt::format("<li>Damping law: {}. A contact is over, by law:",
                        escaped(name_of(run.data().damping_law)));
    for (const LawChoice& choice : run.data().laws)
        html += fmt::format(" {} at {},", escaped(display_name(choice.law.name())),
                            escaped(name_of(choice.detachment)));
    html.back() = '.';
    return html + "</li></ul>\n";
}

std::string warnings_html(const RunData& run) {
    Grouped notes;
    for (const StageRecord& record : run.run().records)
        for (const Note& note : record.notes)
            notes.add(record.file + without_digits(note.text), escaped(sentence(note.text)), place_of(note));
    return notes.empty() ? "<p>None.</p>\n" : notes.html();
}

std::string provenance_html(const RunData& run) {
    const Json& provenance = run.artifacts().at("0-case.json").document.at("provenance");
    std::string html = fmt::format(
        "<p>{} {}, revision <span class=\"hash\">{}</span>.</p>\n<div class=\"scroll\" role=\"region\" "
        "tabindex=\"0\" aria-label=\"{}\"><table><thead><tr><th scope=\"col\">file</th>"
        "<th scope=\"col\" class=\"text\">SHA-256</th></tr></thead><tbody>\n",
        escaped(provenance.value("program", "")), escaped(provenance.value("version", "")),
        escaped(provenance.value("revision", "")), region_label("Files", run));
    const auto row = [&](const std::string& file, const std::string& hash) {
        html += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"hash text\">{}</td></tr>\n",
                            html_name(file), escaped(hash));
    };
    for (const Json& input : provenance.at("inputs")) row(input.value("file", ""), input.value("sha256", ""));
    std::vector<std::string> citations;
    for (const std::string_view file : artifacts_with_notes) {
        const Artifact& artifact = run.artifacts().at(file);
        row(artifact.file, sha256(artifact.bytes));
        for (const Json& citation : artifact.document.at("citations"))
            if (std::find(citations.begin(), citations.end(), citation) == citations.end())
                citations.push_back(citation);
    }
    html += "</tbody></table></div>\n<details><summary>Sources</summary><ul class=\"notes\">\n";
    for (const std::string& citation : citations) html += "<li>" + escaped(citation) + "</li>\n";
    return html + "</ul></details>\n";
}

}  // namespace ashimpact::report
