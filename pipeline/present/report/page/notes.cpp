// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/text.hpp"
#include "pipeline/document/case_json.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/page/run_page.hpp"

namespace ashimpact::report {

namespace {

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

/// Texts that hold for several samples: each once, with the samples, in the order in which they came.
class Grouped {
  public:
    void add(const std::string& key, const std::string& text, const std::string& where) {
        auto entry = std::ranges::find(entries_, key, &Entry::key);
        if (entry == entries_.end()) entry = entries_.insert(entry, {key, {}, {}});
        entry->texts.push_back(text);
        if (!where.empty() && std::ranges::find(entry->where, where) == entry->where.end())
            entry->where.push_back(where);
    }
    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] std::string html() const {
        std::vector<std::string> notes;
        for (const Entry& entry : entries_) {
            std::string names;
            for (const std::string& name : entry.where)
                names += (names.empty() ? "" : "; ") + html_name(name);
            notes.push_back(with_ranges(entry.texts) +
                            (names.empty() ? "" : " <span class=\"where\">(" + names + ")</span>"));
        }
        return html_notes(notes) + "\n";
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

/// Every quantity below @p node whose origin is an assumption, an inference or a publication.
void collect(const Json& node, const std::string& path, const std::string& where, Grouped& into) {
    if (!node.is_object()) return;
    if (node.contains("value") && node.contains("origin") && node.at("origin").is_string()) {
        const std::string origin = node.at("origin").get<std::string>();
        if (origin == name_of(Origin::given) || origin == name_of(Origin::measured) ||
            origin == name_of(Origin::computed) || !node.at("value").is_number())
            return;
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

std::string sentence(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    if (!text.empty() && text.back() != '.') text += '.';
    return text;
}

}  // namespace

std::string assumptions_html(const RunData& run) {
    const Json inputs = case_json(run.data());
    Grouped notes;
    for (const auto& [key, value] : inputs.items())
        if (key != "samples" && key != "phases") collect(value, words_of(key), "", notes);
    for (const Json& sample : inputs.at("samples"))
        collect(sample, "", sample.at("name").get<std::string>(), notes);
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.is_reconstructed()) {
                const std::string text =
                    fmt::format("<b>restitution</b> {}: {}", escaped(name_of(law.measured->origin)),
                                escaped(law.measured->source));
                notes.add(text, text, sample.name());
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
            if (law.velocity == nullptr || !law.velocity->regime) continue;
            const Regime& regime = *law.velocity->regime;
            least = std::min(least, regime.tabor_parameter);
            greatest = std::max(greatest, regime.tabor_parameter);
            yields = yields || regime.yields;
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
        for (const Note& note : record.notes) {
            const std::string law = note.law ? ", " + std::string(note.law->name()) : "";
            notes.add(record.file + without_numbers(note.text), escaped(sentence(note.text)),
                      note.sample + law);
        }
    return notes.empty() ? "<p>None.</p>\n" : notes.html();
}

std::string provenance_html(const RunData& data) {
    const Run& run = data.run();
    std::string rows;
    const auto add = [&](const std::string& file, const std::string& hash) {
        rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"hash text\">{}</td></tr>\n",
                            html_name(file), escaped(hash));
    };
    for (const InputFile& input : run.inputs) add(input.file, input.sha256);
    std::vector<std::string> citations;
    for (const StageRecord& record : run.records) {
        add(record.file, record.sha256);
        for (const std::string& citation : record.citations)
            if (std::ranges::find(citations, escaped(citation)) == citations.end())
                citations.push_back(escaped(citation));
    }
    return fmt::format("<p>ashimpact {}, revision <span class=\"hash\">{}</span>.</p>\n{}\n",
                       escaped(run.version), escaped(run.revision),
                       html_scroll(region_label("Files", data),
                                   "<table><thead><tr><th scope=\"col\">file</th><th scope=\"col\" "
                                   "class=\"text\">SHA-256</th></tr></thead><tbody>\n" +
                                       rows + "</tbody></table>")) +
           "<details><summary>Sources</summary>" + html_notes(citations) + "</details>\n";
}

}  // namespace ashimpact::report
