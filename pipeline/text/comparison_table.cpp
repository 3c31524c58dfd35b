#include "pipeline/text/comparison_table.hpp"

#include <fmt/format.h>

#include "pipeline/text/readable.hpp"
#include "pipeline/text/table.hpp"

namespace ashimpact {

namespace {

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
std::string interval_cell(const View& sample, const std::string& law) {
    const auto all = sample.find("interval");
    const auto interval = all ? all->find(law) : std::nullopt;
    if (!interval) return "-";
    const auto end = [&](const char* key, const char* open) {
        const auto value = interval->find(key);
        return value ? velocity_text(value->number(Dimension::velocity)) : std::string(open);
    };
    return end("lower", "open") + " to " + end("upper", "open");
}

/// The paper's extrapolation of measured impacts.
std::string extrapolated_cell(const View& sample, const std::string& law) {
    const auto all = sample.find("extrapolated_critical_velocity");
    const auto entry = all ? all->find(law) : std::nullopt;
    return entry ? velocity_text(entry->at("value").number(Dimension::velocity)) : "-";
}

/// Why laws have no interval, a line for each.
std::string interval_notes(const View& result) {
    std::string text;
    for (const View& sample : result.at("samples").elements()) {
        const auto notes = sample.find("interval_note");
        if (!notes) continue;
        for (const auto& [law, note] : notes->members())
            text += fmt::format("{}, {}: {}.\n", sample.at("name").text(), law, note.text());
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

}  // namespace

std::string comparison_text(const View& result) {
    TextTable table({"sample", "E [GPa]", "E* [GPa]", "W_s [fJ]", "v_c Eq. 30", "law", "dynamic v_c",
                     "95 % interval", "extrapolated", "published", "measured", "verdict"});
    bool any_published = false;
    for (const View& sample : result.at("samples").elements()) {
        const auto measured = sample.find("measured_critical_velocity");
        std::vector<std::string> row{
            sample.at("name").text(), modulus_cell(sample),
            fmt::format("{:.2f}", sample.at("contact_modulus").number(Dimension::pressure) / 1e9),
            readable_number(sample.at("separation_energy").number(Dimension::energy) / 1e-15),
            fmt::format("{:#.3g}", sample.at("analytic_critical_velocity").number(Dimension::velocity))};
        for (const auto& law : sample.at("dynamic_critical_velocity").members()) {
            row.insert(row.end(), {law.key, velocity_cell(sample, law), interval_cell(sample, law.key),
                                   extrapolated_cell(sample, law.key),
                                   published(sample, "critical_velocity", law.key).value_or("-"),
                                   measured ? velocity_text(measured->number(Dimension::velocity)) : "-",
                                   check_cell(sample, law.key)});
            table.add(std::move(row));
            row.assign(5, "");  // the sample's own values stand in its first row
        }
        any_published = any_published || sample.has("published");
    }
    const std::string title = result.has("case") ? result.at("case").text() + "\n\n" : "";
    std::string text =
        title + table.text() + "Critical velocities in m/s: analytic (Eq. 30), dynamic by each law";
    text += any_published ? "; E in brackets: as published.\n" : ".\n";
    text += interval_notes(result);
    return text + "\n" + result.at("conclusion").text() + "\n";
}

}  // namespace ashimpact
