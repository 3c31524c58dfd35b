// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"

namespace ashimpact {

namespace {

/// "1180 (1150)": degrees Celsius by Giordano, by Urbain in brackets.
std::string limit_cell(const ContactTemperatures& contact, std::optional<double> GlassTemperatures::*limit) {
    const auto degrees = [](const std::optional<double>& kelvin) {
        if (!kelvin) return std::string("-");
        const std::string text = celsius(*kelvin);
        return text.substr(0, text.find(' '));
    };
    return degrees(contact.giordano2008.*limit) + " (" + degrees(contact.urbain1981.*limit) + ")";
}

std::string regime_cell(const ContactTemperatures& contact) {
    if (!contact.giordano2008.regime) return "-";
    std::string text(name_of(*contact.giordano2008.regime));
    if (contact.urbain1981.regime != contact.giordano2008.regime)
        text += " (" + std::string(name_of(*contact.urbain1981.regime)) + ")";
    return text;
}

std::vector<std::string> limit_cells(const ContactTemperatures& contact) {
    return {readable(contact.contact_time, "s"), limit_cell(contact, &GlassTemperatures::elastic_up_to),
            limit_cell(contact, &GlassTemperatures::liquid_from), regime_cell(contact)};
}

std::string laws_by_temperature(const ComparisonResult& result, std::size_t width) {
    TextTable table({"sample", "law", "contact", "elastic up to", "liquid from", "there"}, 2);
    bool any = false;
    for (const SampleComparison& sample : result.samples) {
        if (!sample.temperature) continue;
        std::string name = sample.name;
        for (const auto& [law, contact] : sample.temperature->laws) {
            std::vector<std::string> cells{std::exchange(name, ""), std::string(law.name())};
            for (std::string& cell : limit_cells(contact)) cells.push_back(std::move(cell));
            table.add(std::move(cells));
            any = true;
        }
    }
    if (!any) return {};
    table.drop_empty_columns();
    return table.text(0, width) + "\n";
}

std::string sizes_by_temperature(const ComparisonResult& result, std::size_t width) {
    TextTable table({"sample", "size", "contact", "elastic up to", "liquid from", "there"});
    for (const SampleComparison& sample : result.samples) {
        if (!sample.temperature) continue;
        std::string name = sample.name;
        for (const auto& [diameter, contact] : sample.temperature->by_size) {
            std::vector<std::string> cells{std::exchange(name, ""), readable(diameter, "m")};
            for (std::string& cell : limit_cells(contact)) cells.push_back(std::move(cell));
            table.add(std::move(cells));
        }
    }
    table.drop_empty_columns();
    return table.text(0, width);
}

}  // namespace

std::string temperature_text(const ComparisonResult& result, std::size_t width) {
    const SampleComparison* first = nullptr;
    bool chemistry = false;
    for (const SampleComparison& sample : result.samples) {
        if (!sample.temperature) continue;
        if (first == nullptr) first = &sample;
        chemistry = chemistry || sample.temperature->shear_modulus;
    }
    if (first == nullptr) return {};
    const auto stated = [](const char* what, const std::optional<Stated>& temperature) {
        return temperature ? fmt::format("{} at {}", what, celsius(temperature->value())) : std::string();
    };
    std::string at = stated("particle", first->temperature->particle);
    const std::string wall = stated("wall", first->temperature->wall);
    at += (at.empty() || wall.empty() ? "" : ", ") + wall;
    if (!chemistry)
        return wrapped("Temperature: " + at +
                           ". Without oxides it is not known up to which temperature the glass is elastic.",
                       width, 0) +
               "\n\n";
    return wrapped("Temperatures in C up to which the answer holds" + (at.empty() ? "" : " (" + at + ")") +
                       "; by Giordano et al. 2008, in brackets by Urbain et al. 1981:",
                   width, 0) +
           "\n" + laws_by_temperature(result, width) + sizes_by_temperature(result, width) +
           wrapped(
               "Elastic: the glass relaxes in 10 contact times or more, and the impact loses less than 10 % "
               "by "
               "it. Liquid: in a tenth of one; a sphere of it does not rebound. The gap of the two models is "
               "the "
               "uncertainty: they are calibrated on magmas and slags. Sizes: Hertzian contact at " +
                   velocity_text(first->temperature->velocity.value_or(1)) + " m/s.",
               width, 0) +
           "\n\n";
}

}  // namespace ashimpact
