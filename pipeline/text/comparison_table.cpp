#include "pipeline/text/comparison_table.hpp"

#include <fmt/format.h>

#include "pipeline/text/readable.hpp"
#include "pipeline/text/table.hpp"

namespace ashimpact {

namespace {

/// A quantity of any dimension that is already SI.
std::string shown(const View& quantity) {
    return readable(quantity.at("value").json().get<double>(), quantity.at("unit").text());
}

std::optional<std::string> published(const View& sample, const char* kind, const std::string& law) {
    const auto all = sample.find("published");
    const auto values = all ? all->find(kind) : std::nullopt;
    const auto entry = values ? values->find(law) : std::nullopt;
    if (!entry) return std::nullopt;
    return readable_number(entry->at("published").at("value").json().get<double>());
}

/// "1.93 (1.93)": ours, then the published value.
std::string velocity_cell(const View& sample, const View::Member& law) {
    std::string cell = "-";
    if (!law.value.json().is_null())
        cell = fmt::format("{:#.3g}", law.value.at("value").json().get<double>());
    else if (sample.at("verdict").at(law.key).text() != "finite")
        cell = sample.at("verdict").at(law.key).text();
    if (const auto printed = published(sample, "critical_velocity", law.key))
        cell += fmt::format(" ({})", *printed);
    return cell;
}

std::string modulus_cell(const View& sample) {
    std::string cell =
        fmt::format("{:.2f}", sample.at("young_modulus").at("value").json().get<double>() / 1e9);
    const auto all = sample.find("published");
    const auto entry = all ? all->find("young_modulus") : std::nullopt;
    if (entry)
        cell += fmt::format(" ({:.2f})", entry->at("published").at("value").json().get<double>() / 1e9);
    return cell;
}

}  // namespace

std::string comparison_text(const View& result) {
    const auto samples = result.at("samples").elements();
    std::vector<std::string> heading{"sample", "E [GPa]", "E*", "W_s", "v_c Eq. 30"};
    for (const auto& law : samples.front().at("dynamic_critical_velocity").members())
        heading.push_back(fmt::format("v_c {} [m/s]", law.key));
    heading.emplace_back("measured");
    TextTable table(std::move(heading));
    bool any_published = false;
    for (const View& sample : samples) {
        std::vector<std::string> row{
            sample.at("name").text(), modulus_cell(sample), shown(sample.at("contact_modulus")),
            shown(sample.at("separation_energy")), shown(sample.at("analytic_critical_velocity"))};
        for (const auto& law : sample.at("dynamic_critical_velocity").members())
            row.push_back(velocity_cell(sample, law));
        const auto measured = sample.find("measured_critical_velocity");
        row.push_back(measured ? shown(*measured) : "-");
        table.add(std::move(row));
        any_published = any_published || sample.has("published");
    }
    std::string text = table.text();
    if (any_published) text += "In brackets: as published.\n";
    return text + "\n" + result.at("conclusion").text() + "\n";
}

}  // namespace ashimpact
