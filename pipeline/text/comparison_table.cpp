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

/// "1.93 (1.93)": ours, then the published value.
std::string velocity_cell(const View& sample, const View::Member& law) {
    std::string cell = "-";
    if (!law.value.json().is_null())
        cell = velocity_text(law.value.number(Dimension::velocity));
    else if (sample.at("verdict").at(law.key).text() != "finite")
        cell = sample.at("verdict").at(law.key).text();
    if (const auto printed = published(sample, "critical_velocity", law.key))
        cell += fmt::format(" ({})", *printed);
    return cell;
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
    const auto samples = result.at("samples").elements();
    std::vector<std::string> heading{"sample", "E [GPa]", "E* [GPa]", "W_s", "Eq. 30"};
    for (const auto& law : samples.front().at("dynamic_critical_velocity").members())
        heading.push_back(law.key);
    heading.emplace_back("measured");
    TextTable table(std::move(heading));
    bool any_published = false;
    for (const View& sample : samples) {
        std::vector<std::string> row{
            sample.at("name").text(), modulus_cell(sample),
            readable_number(sample.at("contact_modulus").number(Dimension::pressure) / 1e9),
            readable(sample.at("separation_energy").quantity(Dimension::energy)),
            velocity_text(sample.at("analytic_critical_velocity").number(Dimension::velocity))};
        for (const auto& law : sample.at("dynamic_critical_velocity").members())
            row.push_back(velocity_cell(sample, law));
        const auto measured = sample.find("measured_critical_velocity");
        row.push_back(measured ? velocity_text(measured->number(Dimension::velocity)) : "-");
        table.add(std::move(row));
        any_published = any_published || sample.has("published");
    }
    const std::string title = result.has("case") ? result.at("case").text() + "\n\n" : "";
    std::string text = title + table.text() +
                       "Critical velocities in m/s: analytic (Eq. 30), dynamic by each law, measured.";
    text += any_published ? " In brackets: as published.\n" : "\n";
    return text + "\n" + result.at("conclusion").text() + "\n";
}

}  // namespace ashimpact
