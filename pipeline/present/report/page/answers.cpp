// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"

namespace ashimpact::report {

namespace {

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

/// "1.93 m/s", or that it is outside of the model.
std::string value_words(double velocity) {
    return critical_velocity_text(velocity, velocity_text(velocity) + " m/s");
}

/// "DMT and JKR agree with the measured 1.92 m/s; Hertz is too low."
std::string measured_sentence(const SampleData& sample) {
    const auto& measured = sample.comparison->measured;
    if (!measured) return "No measured critical velocity to compare with.";
    const std::string bounds = bounds_text(sample.comparison->measured_interval);
    std::string text = value_words(measured->value()) + (bounds.empty() ? "" : " (95 %: " + bounds + ")");
    if (sample.comparison->measured_by_outcomes) return "Captures and rebounds alone: " + text + ".";
    text.insert(0, "Measured: ");
    const auto add = [&](CriticalVelocityVerdict verdict, const char* one, const char* many) {
        std::vector<std::string> laws;
        for (const LawData& law : sample.laws)
            if (law.compared != nullptr && law.compared->check && law.compared->check->verdict == verdict)
                laws.push_back(law.name);
        if (!laws.empty()) text += fmt::format("; {} {}", listed(laws), laws.size() == 1 ? one : many);
    };
    if (bounds.empty()) text += ", without an uncertainty, so no law is judged by it";
    add(CriticalVelocityVerdict::agrees, "agrees with it", "agree with it");
    add(CriticalVelocityVerdict::model_too_low, "is too low", "are too low");
    add(CriticalVelocityVerdict::model_too_high, "is too high", "are too high");
    return text + ".";
}

/// ", over DMT, JKR and Maugis-Dugdale": the laws over which an interval extends; empty for one.
std::string laws_in_interval(const std::optional<ReportedLaw>& run) {
    if (!run || run->admissible.size() < 2) return {};
    std::vector<std::string> names;
    for (const Law law : run->admissible) names.push_back(display_name(law.name()));
    return ", over " + listed(names);
}

/// "a particle sticks when it is slower than 1.86 m/s (95 %: 1.60 to 2.16 m/s), whatever the contact law."
/// @param run whose law and admissible laws are named
std::string reported_sentence(const ReportedVelocity& reported, std::optional<ContactRegime> relaxing,
                              const std::optional<ReportedLaw>& run) {
    const Answer answer = answer_of(reported);
    if (answer.kind == Answer::Kind::none) return "no critical velocity: " + escaped(reported.reason) + ".";
    const std::string velocity = fmt::format("<span class=\"value\">{}</span>", value_words(answer.velocity));
    if (relaxing)
        return (answer.kind == Answer::Kind::below
                    ? std::string("elastic theory gives no lower bound")
                    : velocity + " is a lower bound that elastic theory gives") +
               fmt::format(": the glass is {} at this temperature", name_of(*relaxing)) +
               escaped((reported.law ? ", by " + display_name(reported.law->name()) : "") + ": " +
                       reported.reason + ".");
    if (answer.kind == Answer::Kind::above)
        return "the critical velocity lies above " + velocity + escaped(": " + reported.reason + ".");
    if (answer.kind == Answer::Kind::below)
        return "the critical velocity lies below " + velocity + escaped(": " + reported.reason + ".");
    const std::string bounds = bounds_text(reported.interval);
    const bool outside = answer.velocity > fastest_in_model;
    if (is_of_impacts(reported) && !outside)
        return fmt::format(
            "a particle sticks when it is slower than {} (95 %: {} m/s), whatever the contact law.", velocity,
            bounds);
    return (outside ? "the critical velocity is " : "a particle sticks when it is slower than ") + velocity +
           escaped((bounds.empty() ? "" : " (95 %: " + bounds + " m/s" + laws_in_interval(run) + ")") +
                   (reported.law ? ", by " + display_name(reported.law->name()) : "") + ": " +
                   reported.reason + ".");
}

/// What the velocity of a reproduced sample leaves open; empty for measured impacts.
std::string reproduction_sentence(const SampleData& sample, const ComparisonResult& result) {
    if (!result.reproduction) return {};
    const Reproduction& reproduction = *result.reproduction;
    const auto open = std::ranges::find(reproduction.samples, sample.name(), &ReproducedSample::name);
    if (open == reproduction.samples.end()) return {};
    const auto span = [](const VelocitySpan& ends) {
        return velocity_text(ends.least) + " to " + velocity_text(ends.greatest);
    };
    std::string text =
        "A reproduction of published fits of damping, so without an interval. It leaves open: " +
        span(open->laws) + " m/s by the other laws with adhesion";
    if (open->fits) text += ", " + span(*open->fits) + " by other ranges and orders of the fit";
    return text + fmt::format(", {} for a diameter {} smaller or larger.", span(open->diameter),
                              readable(reproduction.diameter_change, "m"));
}

/// "Elastic up to 1180 C ...": the temperature limit of the reported law, and what the chemistry changes.
std::string temperature_sentence(const SampleComparison& sample) {
    if (!sample.temperature) return {};
    const TemperatureLimits& limits = *sample.temperature;
    std::string text = limits.particle ? "Particle at " + celsius(limits.particle->value()) + "." : "";
    if (!limits.shear_modulus) {
        if (limits.particle && limits.particle->value() > known_without_chemistry)
            text += " Nothing is known of the glass there without its chemistry.";
        return text;
    }
    const ContactTemperatures* contact = deciding_contact(sample);
    if (contact == nullptr || !contact->giordano2008.elastic_up_to) return text;
    text += (text.empty() ? "" : " ") + fmt::format("The glass is elastic during the contact up to {}",
                                                    celsius(*contact->giordano2008.elastic_up_to));
    if (const auto& urbain = contact->urbain1981.elastic_up_to)
        text += " (" + celsius(*urbain) + " by Urbain)";
    return text + ".";
}

/// "By each law: Hertz 1.10 m/s, JKR ...", where they were computed at all and differ.
std::string by_each_law(const SampleData& sample) {
    if (const auto& reported = sample.comparison->reported; reported && is_of_impacts(*reported)) return {};
    std::vector<std::string> laws;
    for (const LawData& law : sample.laws) {
        if (law.velocity == nullptr) continue;
        auto head = law.headline();
        if (head && law.is_reconstructed()) head->interval = std::nullopt;
        laws.push_back(law.name + " " + estimate_text(head));
    }
    return laws.empty() ? "" : "By each law: " + listed(laws) + ".";
}

/// What was computed with: "Diameter 44 um, density 2300 kg/m3, E* 62.1 GPa, w 0.3 J/m2."
std::string inputs_sentence(const SampleComparison& sample) {
    std::vector<std::string> words;
    const auto add = [&](const char* word, const std::optional<double>& value, const char* unit) {
        if (value) words.push_back(fmt::format("{} {}", word, readable(*value, unit)));
    };
    const auto value_of = [](const std::optional<Quantity>& quantity) {
        return quantity ? std::optional(quantity->value) : std::nullopt;
    };
    add("Diameter", sample.diameter, "m");
    add("density", value_of(sample.density), "kg/m3");
    add("E*", sample.contact_modulus, "Pa");
    add("w", value_of(sample.work_of_adhesion), "J/m2");
    return words.empty() ? "" : listed(words) + ".";
}

/// The summary of a sample: the velocity to report, or why there is none; all laws; the inputs.
std::string answer(const SampleData& sample, const ComparisonResult& result) {
    std::string html = fmt::format("<li><strong>{}</strong>: {}", html_name(sample.name()),
                                   reported_sentence(sample.comparison->reported.value_or(ReportedVelocity{}),
                                                     relaxing_glass(*sample.comparison), result.reported));
    for (const std::string& rest :
         {reproduction_sentence(sample, result), by_each_law(sample), measured_sentence(sample),
          temperature_sentence(*sample.comparison), inputs_sentence(*sample.comparison)})
        if (!rest.empty()) html += fmt::format("<span class=\"rest\">{}</span>", escaped(rest));
    return html + "</li>\n";
}

/// An empty cell.
constexpr std::string_view no_value = "–";

std::string number_cell(double value, double unit = 1) {
    return fmt::format("{:.4g}", value / unit);
}

bool is_extrapolated(const LawData& law) {
    return law.compared != nullptr && ashimpact::is_extrapolated(*law.compared);
}

std::string dynamic_cell(const LawData& law) {
    if (const auto head = law.headline())
        return (is_extrapolated(law) ? "* " : "") + velocity_text(head->value);
    return law.velocity != nullptr ? std::string(name_of(law.velocity->verdict)) : "";
}

/// The measured velocity, and its 95 % interval below where it has one.
std::string measured_html(const SampleComparison& sample) {
    if (!sample.measured) return "";
    const std::string bounds = bounds_text(sample.measured_interval);
    return velocity_text(sample.measured->value()) + (bounds.empty() ? "" : "<br>(" + bounds + ")");
}

struct Column {
    std::string_view head;
    bool text = false;
    bool of_sample = false;  ///< one cell over all laws of the sample
    bool always = true;      ///< false: left out if no cell has a value
};

constexpr std::array<Column, 11> page_columns{
    {{.head = "E [GPa]", .of_sample = true},
     {.head = "E* [GPa]", .of_sample = true},
     {.head = "W<sub>s</sub> [fJ]", .of_sample = true},
     {.head = "v<sub>c</sub>, Eq. 30 [m/s]", .of_sample = true},
     {.head = "law", .text = true},
     {.head = "dynamic v<sub>c</sub> [m/s]"},
     {.head = "95 % interval"},
     {.head = "extrapolated v<sub>c</sub> [m/s]", .always = false},
     {.head = "published", .always = false},
     {.head = "measured (95&nbsp;%)", .of_sample = true, .always = false},
     {.head = "verdict", .text = true, .always = false}}};
constexpr std::size_t interval_column = 6;  ///< of page_columns
constexpr std::size_t measured_column = 9;
using Cells = std::array<std::string, page_columns.size()>;

/// The cells of a law, in the order of the page_columns; empty where there is no value.
Cells cells_of(const SampleData& sample, const LawData& law) {
    const auto head = law.headline();
    const auto extrapolated = law.extrapolated();
    const auto& published = sample.sample->published;
    const Quantity* printed = published ? published->critical_velocity.find(law.choice.law) : nullptr;
    return {number_cell(sample.modulus->young_modulus.value, 1e9),
            number_cell(sample.contact->pair.contact_modulus, 1e9),
            number_cell(sample.analytic->separation_energy, 1e-15),
            critical_velocity_text(sample.analytic->critical_velocity,
                                   number_cell(sample.analytic->critical_velocity)),
            escaped(law.name),
            dynamic_cell(law),
            head ? bounds_text(head->interval) : "",
            extrapolated ? velocity_text(*extrapolated) : "",
            printed != nullptr ? number_cell(printed->value) : "",
            measured_html(*sample.comparison),
            std::string(law.compared != nullptr ? verdict_words(law.compared->check) : "")};
}

/// The head of a column: no 95 % where there is none.
std::string_view head_of(std::size_t column, const ComparisonResult& result) {
    const bool with_interval = std::ranges::any_of(
        result.samples, [](const SampleComparison& sample) { return sample.measured_interval.has_value(); });
    if (column == interval_column && is_reproduction(result)) return "by inputs";
    if (column == measured_column && !with_interval) return "measured";
    return page_columns[column].head;
}

/// Whether a column has a value in this run, or is always shown.
bool is_shown(std::size_t column, const std::vector<std::vector<Cells>>& samples) {
    return page_columns[column].always || std::ranges::any_of(samples, [&](const std::vector<Cells>& laws) {
               return std::ranges::any_of(laws, [&](const Cells& row) { return !row[column].empty(); });
           });
}

/// How extrapolated velocities differ from dynamic ones, below the table.
std::string extrapolation_notes(const RunData& run) {
    bool any = false;
    bool instead = false;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            any = any || law.extrapolated();
            instead = instead || is_extrapolated(law);
        }
    if (!any) return {};
    return with_subscripts(
        std::string("<p class=\"where\">Dynamic v_c: the answer, estimated from rebounds and captures "
                    "together. Extrapolated v_c: where the polynomial η(e_n), fitted to the rebounds alone, "
                    "meets e_n = 0. The two may lie far apart.") +
        (instead ? " *: extrapolated, as the impacts gave no estimate with this law." : "") + "</p>\n");
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

/// Texts that hold for several samples: each once, with the samples, in the order in which they came.
class Grouped {
  public:
    void add(const std::string& key, const std::string& text, const std::string& where) {
        const auto [place, is_new] = places_.try_emplace(key, entries_.size());
        if (is_new) entries_.emplace_back();
        entries_[place->second].texts.push_back(text);
        entries_[place->second].where.add(where);
    }
    [[nodiscard]] bool empty() const { return entries_.empty(); }
    [[nodiscard]] std::string html() const {
        std::vector<std::string> notes;
        for (const Entry& entry : entries_) {
            std::string names;
            for (const std::string& name : entry.where.names())
                names += (names.empty() ? "" : "; ") + html_name(name);
            notes.push_back(with_ranges(entry.texts) +
                            (names.empty() ? "" : " <span class=\"where\">(" + names + ")</span>"));
        }
        return html_notes(notes) + "\n";
    }

  private:
    struct Entry {
        std::vector<std::string> texts;
        NameList where;
    };
    std::map<std::string, std::size_t> places_;  ///< of entries, by key
    std::vector<Entry> entries_;
};

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

std::string sentence(const std::string& text) {
    return text.empty() || text.ends_with('.') ? capitalized(text) : capitalized(text) + ".";
}

}  // namespace

std::string answers_html(const RunData& run) {
    std::string html = "<ul class=\"answers\">\n";
    for (const SampleData& sample : run.samples()) html += answer(sample, run.run().comparison);
    html += "</ul>\n";
    const std::string sizes = sizes_sentence(run.run().comparison);
    if (!sizes.empty())
        html += fmt::format("<p class=\"sizes\"><a href=\"#which-sizes\">Other sizes</a>: {}</p>\n",
                            escaped(sizes));
    return html;
}

std::string comparison_html(const RunData& run) {
    std::vector<std::vector<Cells>> samples;
    for (const SampleData& sample : run.samples()) {
        auto& laws = samples.emplace_back();
        for (const LawData& law : sample.laws) laws.push_back(cells_of(sample, law));
    }
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < page_columns.size(); ++i)
        if (is_shown(i, samples)) shown.push_back(i);
    const bool reproduced = is_reproduction(run.run().comparison);
    std::string html = "<table><thead><tr><th scope=\"col\">sample</th>";
    const auto text_class = [](const Column& column) { return column.text ? " class=\"text\"" : ""; };
    for (const std::size_t i : shown)
        html += fmt::format("<th scope=\"col\"{}>{}</th>", text_class(page_columns[i]),
                            head_of(i, run.run().comparison));
    html += "</tr></thead><tbody>\n";
    for (std::size_t s = 0; s < samples.size(); ++s)
        for (const Cells& row : samples[s]) {
            const bool first = &row == &samples[s].front();
            const std::string span = fmt::format(" rowspan=\"{}\"", samples[s].size());
            html += first ? fmt::format("<tr class=\"first\"><th scope=\"rowgroup\"{}>{}</th>", span,
                                        html_name(run.samples()[s].name()))
                          : "<tr>";
            for (const std::size_t i : shown)
                if (first || !page_columns[i].of_sample)
                    html += fmt::format("<td{}{}>{}</td>", text_class(page_columns[i]),
                                        page_columns[i].of_sample ? span : "",
                                        row[i].empty() ? no_value : row[i]);
            html += "</tr>\n";
        }
    html = html_scroll(region_label("Critical velocities", run), html + "</tbody></table>", "scroll wide") +
           "\n";
    html += extrapolation_notes(run);
    if (reproduced)
        html +=
            "<p class=\"where\">By inputs: what the rounding of published numbers and the stated "
            "uncertainties of the inputs leave open.</p>\n";
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.velocity != nullptr && !law.velocity->interval_note.empty())
                html += fmt::format("<p class=\"where\">{}, {}: {}.</p>\n", html_name(sample.name()),
                                    escaped(law.name), escaped(law.velocity->interval_note));
    return html;
}

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
    std::string html =
        fmt::format("<ul class=\"notes\"><li>{} Rotation, charge, liquid and soft ash are not in it.</li>\n",
                    escaped(scope_sentence(run.data())));
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
