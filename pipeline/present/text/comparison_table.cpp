// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"

namespace ashimpact {

namespace {

std::string or_dash(std::string_view text) {
    return text.empty() ? "-" : std::string(text);
}

std::string wrapped_line(const std::string& text, std::size_t width, std::size_t hanging = 2) {
    return wrapped(text, width, hanging) + "\n";
}

/// What the chemistry of the glass changes in each sample with oxides.
std::string glass_text(const ComparisonResult& result, std::size_t width) {
    std::string text;
    const auto change = [](const WithEitherGlass& pair, std::string_view unit) {
        return value_text(pair.catalogue, unit) + " -> " + value_text(pair.from_chemistry, unit);
    };
    for (const SampleComparison& sample : result.samples) {
        if (!sample.glass) continue;
        const GlassEffect& effect = *sample.glass;
        std::string line = fmt::format(
            "  {}: E {}, E* {}, v_c of adhesion only {}", sample.name, change(effect.young_modulus, "Pa"),
            change(effect.contact_modulus, "Pa"), change(effect.analytic_velocity, "m/s"));
        if (effect.dynamic_velocity)
            line +=
                fmt::format(", dynamic v_c at the same damping {}", change(*effect.dynamic_velocity, "m/s"));
        text += wrapped_line(
            fmt::format("{}; {} counts", line,
                        effect.used == GlassSource::catalogue ? "the catalogue" : "the chemistry"),
            width);
    }
    if (text.empty()) return text;
    const auto has_dynamic = [](const SampleComparison& sample) {
        return sample.glass && sample.glass->dynamic_velocity;
    };
    if (std::ranges::any_of(result.samples, has_dynamic))
        text += wrapped_line(
            "Where measured impacts give the damping, it follows E* and the dynamic v_c stays.", width);
    return "Glass of the catalogue -> glass from its chemistry:\n" + text + "\n";
}

/// What was assumed, and what no uncertainty was stated of.
std::string assumptions_text(const ComparisonResult& result, std::size_t width) {
    std::vector<std::pair<std::string, std::vector<std::string>>> assumptions;  // with their samples
    std::vector<std::string> exact;
    bool of_impacts = false;
    for (const SampleComparison& sample : result.samples) {
        for (const AssumedProperty& assumed : sample.assumed) {
            const std::string text = fmt::format("{} {}, {}", assumed.quantity, readable(assumed.value),
                                                 assumed.why.empty() ? name_of(assumed.origin) : assumed.why);
            const auto same = std::ranges::find(assumptions, text, &decltype(assumptions)::value_type::first);
            auto& samples =
                (same == assumptions.end() ? assumptions.emplace_back(text, std::vector<std::string>{})
                                           : *same)
                    .second;
            samples.push_back(sample.name);
        }
        if (sample.reported && is_of_impacts(*sample.reported)) {
            of_impacts = true;
            continue;
        }
        if (!std::ranges::any_of(sample.laws, [](const auto& each) {
                return each.second.velocity && each.second.velocity->interval;
            }))
            continue;
        for (const std::string& name : sample.taken_as_exact)
            if (std::ranges::find(exact, name) == exact.end()) exact.push_back(name);
    }
    std::string text;
    for (const auto& [assumption, samples] : assumptions) {
        const bool all = samples.size() == result.samples.size();
        text += wrapped_line("  " + assumption + (all ? "" : " (" + joined(samples) + ")"), width);
    }
    if (!text.empty())
        text.insert(0, text.find("+-") != std::string::npos ? "Not measured (+-: standard uncertainty):\n"
                                                            : "Not measured:\n");
    if (!exact.empty())
        text += wrapped_line(
            "Taken as exact in the intervals, no uncertainty being stated: " + joined(exact) + ".", width);
    if (of_impacts)
        text += wrapped_line(
            "v_c of measured impacts needs no property of the particle; diameter, density, modulus and work "
            "of adhesion decide the damping and other sizes.",
            width);
    return text.empty() ? text : text + "\n";
}

std::string velocity_cell(const LawComparison& law) {
    if (law.velocity) return (is_extrapolated(law) ? "* " : "") + velocity_text(law.velocity->value);
    return law.verdict == LawVerdict::finite ? "-" : std::string(name_of(law.verdict));
}

std::string published_cell(const SampleComparison& sample, Law law) {
    const Beside* beside = sample.published ? sample.published->critical_velocity.find(law) : nullptr;
    return beside == nullptr ? "-" : readable_number(beside->published.value);
}

/// A row of the table: laws that give a sample the same answer.
struct LawRow {
    std::vector<std::string> laws{};
    std::array<std::string, 4> answer{};  ///< velocity, interval, published value, verdict
    std::vector<double> extrapolated{};   ///< [m/s]
};

std::vector<LawRow> law_rows(const SampleComparison& sample) {
    std::vector<LawRow> rows;
    for (const auto& [law, of] : sample.laws) {
        const std::array<std::string, 4> answer{
            velocity_cell(of), or_dash(of.velocity ? bounds_text(of.velocity->interval) : ""),
            published_cell(sample, law), or_dash(verdict_words(of.check))};
        auto row = std::ranges::find(rows, answer, &LawRow::answer);
        if (row == rows.end()) row = rows.insert(row, LawRow{.answer = answer});
        row->laws.emplace_back(law.name());
        if (of.extrapolated) row->extrapolated.push_back(of.extrapolated->value);
    }
    if (rows.size() == 1 && rows.front().laws.size() > 1) rows.front().laws = {"all"};
    return rows;
}

std::string laws_text(const ComparisonResult& result, std::size_t width) {
    const bool reproduced = is_reproduction(result);
    TextTable table({"sample", "law", "dynamic v_c", reproduced ? "by inputs" : "95 % interval",
                     "extrapolated", "published", "verdict"},
                    2);
    bool any_verdict = false;
    bool any_extrapolated = false;
    for (const SampleComparison& sample : result.samples) {
        std::string name = sample.name;
        for (const auto& [laws, answer, extrapolated] : law_rows(sample)) {
            any_verdict = any_verdict || answer[3] != "-";
            any_extrapolated = any_extrapolated || answer[0].starts_with('*');
            std::string range = "-";
            if (!extrapolated.empty()) {
                const auto [least, greatest] = std::minmax_element(extrapolated.begin(), extrapolated.end());
                range = velocity_text(*least);
                if (velocity_text(*greatest) != range) range += " to " + velocity_text(*greatest);
            }
            table.add(
                {std::exchange(name, ""), joined(laws), answer[0], answer[1], range, answer[2], answer[3]});
        }
    }
    table.drop_empty_columns();
    std::string text = "By law [m/s]";
    text += any_verdict ? "; the verdict is that of the measured velocity:\n\n" : ":\n\n";
    text += table.text(0, width);
    if (reproduced)
        text += wrapped_line(
            "by inputs: what the rounding of published numbers and the stated uncertainties of the inputs "
            "leave open.",
            width);
    if (any_extrapolated)
        text += wrapped_line(
            "*: extrapolated from the rebounds, as the impacts gave no estimate with this law.", width);
    return text + "\n";
}

/// Critical dampings and velocities by the paper's steps beside the exact ones; empty if not asked for.
std::string scheme_text(const ComparisonResult& result, std::size_t width) {
    TextTable table({"sample", "law", "c by steps [kg/s]", "exact", "v_c by steps [m/s]", "exact"}, 2);
    const auto velocity = [](const DampingAndVelocity& of) {
        return of.critical_velocity ? velocity_text(*of.critical_velocity) : "-";
    };
    const auto damping = [](const DampingAndVelocity& of) {
        return fmt::format("{:.5f}", of.damping.critical_damping());
    };
    bool any = false;
    for (const SampleComparison& sample : result.samples) {
        std::string name = sample.name;
        for (const auto& [law, of] : sample.paper_explicit) {
            table.add({std::exchange(name, ""), std::string(law.name()), damping(of.scheme),
                       damping(of.exact), velocity(of.scheme), velocity(of.exact)});
            any = true;
        }
    }
    return any ? "By the explicit steps of the paper (Eqs. 31 to 34) beside exact impacts:\n\n" +
                     table.text(0, width) + "\n"
               : "";
}

/// Why laws have no interval, a line for each.
std::string interval_notes(const ComparisonResult& result, std::size_t width) {
    std::string text;
    for (const SampleComparison& sample : result.samples)
        for (const auto& [law, of] : sample.laws)
            if (!of.interval_note.empty())
                text += wrapped_line(fmt::format("{}, {}: {}.", sample.name, law.name(), of.interval_note),
                                     width);
    return text;
}

std::string modulus_cell(const SampleComparison& sample) {
    if (!sample.young_modulus) return "-";
    std::string cell = fmt::format("{:.2f}", sample.young_modulus->value / 1e9);
    if (sample.published && sample.published->young_modulus)
        cell += fmt::format(" ({:.2f})", sample.published->young_modulus->published.value / 1e9);
    return cell;
}

std::string contacts_text(const ComparisonResult& result, std::size_t width) {
    TextTable table({"sample", "E [GPa]", "E* [GPa]", "W_s [fJ]", "v_c, adhesion only [m/s]"});
    bool any_published = false;
    for (const SampleComparison& sample : result.samples) {
        table.add({sample.name, modulus_cell(sample),
                   sample.contact_modulus ? fmt::format("{:.2f}", *sample.contact_modulus / 1e9) : "-",
                   sample.separation_energy ? readable_number(*sample.separation_energy / 1e-15) : "-",
                   velocity_text(sample.analytic_velocity)});
        any_published = any_published || sample.published;
    }
    std::string text = table.text(0, width) +
                       "v_c, adhesion only: Eq. 30 of Dong et al. 2013, without damping and uncertainties.";
    if (any_published) text += " E in brackets: as published.";
    return wrapped_line(text, width, 0) + "\n";
}

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
    bool differs = false;  ///< others of the kind have other numbers
    NameList samples{};
    NameList laws{};
    Severity severity = Severity::remark;
    std::size_t count = 0;
};

/// " (fine; dmt, jkr)": the samples of a kind, "all samples" where it is all of several, and the laws.
std::string of_what(const Kind& kind, std::size_t samples) {
    const auto& names = kind.samples.names();
    const auto& laws = kind.laws.names();
    if (names.empty()) return {};
    const bool all = samples > 1 && names.size() == samples;
    return fmt::format(" ({}{}{})", all ? "all samples" : joined(names), laws.empty() ? "" : "; ",
                       joined(laws));
}

}  // namespace

std::string velocity_text(double velocity) {
    return critical_velocity_text(velocity, fmt::format("{:#.3g}", velocity));
}

std::string value_text(double value, std::string_view unit) {
    const std::string text = readable(value, unit);
    return unit == "m/s" ? critical_velocity_text(value, text) : text;
}

std::string bounds_text(const std::optional<Bounds>& bounds) {
    if (!bounds || (!bounds->lower && !bounds->upper)) return {};
    const auto end = [](const std::optional<double>& value) {
        return value ? velocity_text(*value) : std::string("open");
    };
    return end(bounds->lower) + " to " + end(bounds->upper);
}

std::string bounds_text(const std::optional<double>& lower, const std::optional<double>& upper,
                        std::string_view unit) {
    const auto end = [&](const std::optional<double>& value) {
        return value ? value_text(*value, unit) : std::string("open");
    };
    return end(lower) + " to " + end(upper);
}

std::string estimate_text(const std::optional<VelocityEstimate>& velocity) {
    if (!velocity) return "no finite value";
    const std::string bounds = bounds_text(velocity->interval);
    return critical_velocity_text(velocity->value, velocity_text(velocity->value) + " m/s") +
           (bounds.empty() ? "" : " (95 %: " + bounds + " m/s)");
}

std::string_view verdict_words(const std::optional<CriticalVelocityCheck>& check) {
    constexpr std::array<std::string_view, 4> words{"agrees", "too low", "too high", ""};  // in their order
    return check ? words.at(static_cast<std::size_t>(check->verdict)) : "";
}

bool is_extrapolated(const LawComparison& law) {
    return law.velocity && law.extrapolated && law.velocity->method == VelocityMethod::extrapolation;
}

Answer answer_of(const ReportedVelocity& reported) {
    if (reported.velocity) return {Answer::Kind::velocity, reported.velocity->value};
    if (reported.interval && reported.interval->lower)
        return {Answer::Kind::above, *reported.interval->lower};
    if (reported.interval && reported.interval->upper)
        return {Answer::Kind::below, *reported.interval->upper};
    return {};
}

std::string scope_sentence(const Case& data) {
    const auto& [particle, wall] = data.temperature;
    std::vector<std::string> missing;
    std::string temperature;
    if (particle && wall && particle->value() == wall->value())
        temperature = "at " + celsius(particle->value());
    else if (particle || wall)
        temperature = (particle ? "particle at " + celsius(particle->value()) : "") +
                      (particle && wall ? " and " : "") + (wall ? "wall at " + celsius(wall->value()) : "");
    else
        temperature = "at room temperature";
    if (!particle) missing.emplace_back(wall ? "temperature of the particle" : "temperature");
    const std::string surfaces = data.roughness && data.roughness->value() > 0
                                     ? "surfaces with a roughness of " + readable(data.roughness->quantity)
                                     : "smooth surfaces";
    if (!data.roughness) missing.emplace_back("roughness");
    return fmt::format("Holds for normal impact on {}, dry, {}, {}{}.",
                       data.partner ? "another sphere" : "a flat wall", temperature, surfaces,
                       missing.empty() ? "" : "; not stated: " + joined(missing));
}

std::string comparison_text(const ComparisonResult& result, std::size_t width, const std::string& scope) {
    const std::string title = result.name.empty() ? "" : wrapped_line(result.name, width, 0) + "\n";
    return title + reported_text(result, scope, width) + glass_text(result, width) +
           temperature_text(result, width) + assumptions_text(result, width) + laws_text(result, width) +
           scheme_text(result, width) + interval_notes(result, width) + sizes_text(result, width) +
           (result.dampings ? dampings_text(*result.dampings, width) : "") + contacts_text(result, width) +
           wrapped_line(result.conclusion, width, 0);
}

std::string comparison_text(Json result, std::size_t width, const std::string& scope) {
    result.erase("equal_velocities");  // not shown; their units depend on the damping law of the case
    return comparison_text(from_json<ComparisonResult>(View(result), DampingLaw::constant), width, scope);
}

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
        found->differs = found->differs || statement_of(note.text) != statement_of(found->first);
        found->samples.add(note.sample);
        if (note.law) found->laws.add(std::string(note.law->name()));
    }
    std::vector<RemarkLine> lines;
    lines.reserve(kinds.size());
    for (const Kind& kind : kinds)
        lines.push_back({.text = fmt::format("{} x {}{}{}: {}", kind.count, kind.file, of_what(kind, samples),
                                             kind.differs ? ", the first" : "", statement_of(kind.first)),
                         .decides = kind.severity != Severity::background});
    return lines;
}

}  // namespace ashimpact
