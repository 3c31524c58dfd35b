// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/comparison_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/present/text/table.hpp"

namespace ashimpact {

namespace {

constexpr const char* maugis_dugdale = "maugis-dugdale";
constexpr const char* misses = "off %";

/// Three digits, trailing zeros kept: a column of velocities lines up.
std::string velocity_text(double velocity) {
    return fmt::format("{:#.3g}", velocity);
}

std::optional<std::string> published(const View& sample, const char* kind, const std::string& law) {
    const auto all = sample.find("published");
    const auto values = all ? all->find(kind) : std::nullopt;
    const auto entry = values ? values->find(law) : std::nullopt;
    if (!entry) return std::nullopt;
    return readable_number(entry->at("published").number(Dimension::velocity));
}

std::string velocity_cell(const View& sample, const View::Member& law) {
    if (!law.value.json().is_null()) return velocity_text(law.value.at("value").number(Dimension::velocity));
    const std::string verdict = sample.at("verdict").at(law.key).text();
    return verdict == "finite" ? "-" : verdict;
}

/// "1.85 to 2.01"; an end that the data do not bound is left open.
std::string interval_text(const std::optional<View>& interval) {
    if (!interval || (!interval->find("lower") && !interval->find("upper"))) return "-";
    const auto end = [&](const char* key) {
        const auto value = interval->find(key);
        return value ? velocity_text(value->number(Dimension::velocity)) : std::string("open");
    };
    return end("lower") + " to " + end("upper");
}

std::string interval_cell(const View& sample, const std::string& law) {
    const auto all = sample.find("interval");
    return interval_text(all ? all->find(law) : std::nullopt);
}

/// The velocity to report, or the bound that the impacts give instead: "> 2.31".
std::string reported_cell(const View& reported) {
    if (const auto velocity = reported.find("critical_velocity"))
        return velocity_text(velocity->at("value").number(Dimension::velocity));
    const auto interval = reported.find("interval");
    if (const auto lower = interval ? interval->find("lower") : std::nullopt)
        return "> " + velocity_text(lower->number(Dimension::velocity));
    if (const auto upper = interval ? interval->find("upper") : std::nullopt)
        return "< " + velocity_text(upper->number(Dimension::velocity));
    return "-";
}

/// The measured velocity with the interval that is compared: "1.92 (1.91 to 1.93)".
std::string measured_cell(const View& sample) {
    const auto measured = sample.find("measured_critical_velocity");
    if (!measured) return "-";
    const std::string interval = interval_text(sample.find("measured_interval"));
    const std::string value = velocity_text(measured->number(Dimension::velocity));
    return interval == "-" ? value : fmt::format("{} ({})", value, interval);
}

std::string wrapped_line(const std::string& text, std::size_t width, std::size_t hanging = 2) {
    return wrapped(text, width, hanging) + "\n";
}

/// The paper's extrapolation of measured impacts.
std::string extrapolated_cell(const View& sample, const std::string& law) {
    const auto all = sample.find("extrapolated_critical_velocity");
    const auto entry = all ? all->find(law) : std::nullopt;
    return entry ? velocity_text(entry->at("value").number(Dimension::velocity)) : "-";
}

/// Whether a law has impacts, of which no estimate could be made, so that its velocity is the extrapolation.
bool is_extrapolated(const View& sample, const View::Member& law) {
    if (law.value.json().is_null()) return false;
    const auto method = law.value.find("method");
    return extrapolated_cell(sample, law.key) != "-" && method && method->text().starts_with("eta(e) extra");
}

/// Why laws have no interval, a line for each.
std::string interval_notes(const View& result, std::size_t width) {
    std::string text;
    for (const View& sample : result.at("samples").elements()) {
        const auto notes = sample.find("interval_note");
        if (!notes) continue;
        for (const auto& [law, note] : notes->members())
            text +=
                wrapped_line(fmt::format("{}, {}: {}.", sample.at("name").text(), law, note.text()), width);
    }
    return text;
}

/// What the check against the measured velocity says, in words.
std::string check_cell(const View& sample, const std::string& law) {
    const auto all = sample.find("check");
    const auto check = all ? all->find(law) : std::nullopt;
    if (!check) return "-";
    const std::string verdict = check->at("verdict").text();
    if (verdict == "model-too-low") return "too low";
    if (verdict == "model-too-high") return "too high";
    return verdict == "agrees" ? "agrees" : "-";
}

std::string modulus_cell(const View& sample) {
    std::string cell = fmt::format("{:.2f}", sample.at("young_modulus").number(Dimension::pressure) / 1e9);
    const auto all = sample.find("published");
    const auto entry = all ? all->find("young_modulus") : std::nullopt;
    if (entry) cell += fmt::format(" ({:.2f})", entry->at("published").number(Dimension::pressure) / 1e9);
    return cell;
}

/// Which velocity to report of each sample, and why.
std::string reported_text(const View& result, std::size_t width) {
    TextTable table({"sample", "v_c [m/s]", "95 % interval", "by law", "measured (95 %)"});
    std::string reasons;
    for (const View& sample : result.at("samples").elements()) {
        const auto reported = sample.find("reported");
        if (!reported) return {};  // of an older version
        const auto law = reported->find("law");
        table.add({sample.at("name").text(), reported_cell(*reported),
                   interval_text(reported->find("interval")), law ? law->text() : "-",
                   measured_cell(sample)});
        reasons += wrapped_line(fmt::format("{}{}: {}.", sample.at("name").text(),
                                            law ? " by " + law->text() : "", reported->at("reason").text()),
                                width);
    }
    table.drop_empty_columns();
    return "Report this critical velocity; a slower particle sticks.\n\n" + table.text(0, width) +
           "\nWhy:\n" + reasons + "\n";
}

/// One entry of "assumed" as a line; samples that share it stand together.
struct Assumption {
    std::string text;
    std::vector<std::string> samples;
};

std::string assumption_text(const View& entry) {
    std::string text =
        fmt::format("{} {}", entry.at("quantity").text(), readable(shown_quantity(entry.at("value").json())));
    const std::string why = entry.at("why").text();
    return text + ", " + (why.empty() ? entry.at("origin").text() : why);
}

/// What was assumed, and what no uncertainty was stated of.
std::string assumptions_text(const View& result, std::size_t width) {
    std::vector<Assumption> assumptions;
    std::vector<std::string> exact;
    const auto samples = result.at("samples").elements();
    for (const View& sample : samples) {
        if (const auto assumed = sample.find("assumed"))
            for (const View& entry : assumed->elements()) {
                const std::string text = assumption_text(entry);
                const auto same = std::find_if(assumptions.begin(), assumptions.end(),
                                               [&](const Assumption& each) { return each.text == text; });
                Assumption& assumption = same == assumptions.end() ? assumptions.emplace_back() : *same;
                assumption.text = text;
                assumption.samples.push_back(sample.at("name").text());
            }
        if (const auto names = sample.find("taken_as_exact"))
            for (const View& name : names->elements())
                if (std::find(exact.begin(), exact.end(), name.text()) == exact.end())
                    exact.push_back(name.text());
    }
    std::string text;
    const bool uncertain = std::any_of(assumptions.begin(), assumptions.end(), [](const Assumption& each) {
        return each.text.find("+-") != std::string::npos;
    });
    if (!assumptions.empty())
        text = uncertain ? "Not measured (+-: standard uncertainty):\n" : "Not measured:\n";
    for (const Assumption& assumption : assumptions)
        text += wrapped_line(
            fmt::format(
                "  {}{}", assumption.text,
                assumption.samples.size() == samples.size() ? "" : " (" + joined(assumption.samples) + ")"),
            width);
    if (!exact.empty())
        text += wrapped_line(
            "Taken as exact in the intervals, no uncertainty being stated: " + joined(exact) + ".", width);
    return text.empty() ? text : text + "\n";
}

/// By how much a law misses the v_c of maugis-dugdale, which lies between DMT and JKR.
std::string miss_cell(const View& sample, const View::Member& law) {
    const View velocities = sample.at("dynamic_critical_velocity");
    const auto between = velocities.find(maugis_dugdale);
    if (!between || law.key == maugis_dugdale || law.value.json().is_null()) return "-";
    const auto velocity = [](const View& node) { return node.at("value").number(Dimension::velocity); };
    return fmt::format("{:+.1f}", 100 * (velocity(law.value) / velocity(*between) - 1));
}

std::string laws_text(const View& result, std::size_t width) {
    TextTable table(
        {"sample", "law", "dynamic v_c", "95 % interval", misses, "extrapolated", "published", "verdict"}, 2);
    bool any_miss = false;
    bool any_extrapolated = false;
    for (const View& sample : result.at("samples").elements()) {
        std::string name = sample.at("name").text();
        for (const auto& law : sample.at("dynamic_critical_velocity").members()) {
            const std::string miss = miss_cell(sample, law);
            any_miss = any_miss || miss != "-";
            const bool extrapolated = is_extrapolated(sample, law);
            any_extrapolated = any_extrapolated || extrapolated;
            table.add(
                {std::exchange(name, ""), law.key, (extrapolated ? "* " : "") + velocity_cell(sample, law),
                 interval_cell(sample, law.key), miss, extrapolated_cell(sample, law.key),
                 published(sample, "critical_velocity", law.key).value_or("-"), check_cell(sample, law.key)});
        }
    }
    table.drop_empty_columns();
    std::string text =
        "All laws [m/s]; the verdict is that of the measured velocity:\n\n" + table.text(0, width);
    if (any_miss)
        text += wrapped_line(
            std::string(misses) +
                ": by how much a law misses the v_c of maugis-dugdale, the law between DMT and JKR.",
            width);
    if (any_extrapolated)
        text += wrapped_line(
            "*: extrapolated from the rebounds, as the impacts gave no estimate with this law.", width);
    return text + "\n";
}

std::string contacts_text(const View& result, std::size_t width) {
    TextTable table({"sample", "E [GPa]", "E* [GPa]", "W_s [fJ]", "v_c, adhesion only [m/s]"});
    bool any_published = false;
    for (const View& sample : result.at("samples").elements()) {
        table.add(
            {sample.at("name").text(), modulus_cell(sample),
             fmt::format("{:.2f}", sample.at("contact_modulus").number(Dimension::pressure) / 1e9),
             readable_number(sample.at("separation_energy").number(Dimension::energy) / 1e-15),
             fmt::format("{:#.3g}", sample.at("analytic_critical_velocity").number(Dimension::velocity))});
        any_published = any_published || sample.has("published");
    }
    std::string text =
        table.text(0, width) + "v_c, adhesion only: Eq. 30 of Dong et al. 2013, without damping.";
    if (any_published) text += " E in brackets: as published.";
    return wrapped_line(text, width, 0) + "\n";
}

}  // namespace

std::string comparison_text(const View& result, std::size_t width) {
    const std::string title =
        result.has("case") ? wrapped_line(result.at("case").text(), width, 0) + "\n" : "";
    return title + reported_text(result, width) + assumptions_text(result, width) + laws_text(result, width) +
           interval_notes(result, width) + contacts_text(result, width) +
           wrapped_line(result.at("conclusion").text(), width, 0);
}

}  // namespace ashimpact
