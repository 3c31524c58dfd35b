// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/temperature.hpp"

#include <cmath>

#include <fmt/format.h>

#include "materials/glass/properties.hpp"
#include "pipeline/present/report/figures/figures.hpp"

namespace ashimpact::report {

namespace {

constexpr double zero_celsius = 273.15;  // [K]
constexpr double coolest = 500;          // of the axis [C]
constexpr double hottest = 1700;
constexpr double step = 20;
constexpr double most_viscous = 14;  // of the axis, log10 of Pa s

OxideAmounts oxides_of(const SampleGlass& glass) {
    OxideAmounts amounts = no_oxides();
    for (const auto& [oxide, fraction] : glass.composition)
        if (const auto named = named_oxide(oxide)) amounts[named->index] += fraction.value;
    return amounts;
}

Series viscosity_series(const SampleData& sample, ViscosityModel model, Figure& figure) {
    const bool giordano = model == ViscosityModel::giordano2008;
    const std::string name = giordano ? "Giordano et al. 2008" : "Urbain et al. 1981";
    Series series{.name = name, .legend = name, .look = Look::of(giordano ? 0 : 1)};
    const MeltViscosity viscosity(model, oxides_of(*sample.modulus->glass));
    for (double degrees = coolest; degrees <= hottest; degrees += step) {
        const double temperature = degrees + zero_celsius;
        const double log10 = viscosity.log10_at(temperature);
        if (!(log10 <= most_viscous)) continue;
        series.line.push_back({degrees, std::pow(10.0, log10)});
        figure.numbers.rows.push_back({sample.name(), name, temperature, std::pow(10.0, log10)});
    }
    return series;
}

/// A level line of the viscosity at which relaxation takes @p ratio times the contact.
Series level(const TemperatureLimits& limits, double contact_time, double ratio, const std::string& name,
             const std::string& legend, std::size_t dash) {
    const double viscosity = ratio * *limits.shear_modulus * contact_time;
    Series series{.name = name, .legend = legend, .look = Look::plain(0)};
    series.look.dash = dash;
    series.look.thin = true;
    series.line = {{coolest, viscosity}, {hottest, viscosity}};
    return series;
}

void add_contact_lines(const SampleComparison& compared, XyPanel& panel) {
    const TemperatureLimits& limits = *compared.temperature;
    const auto add = [&](double time, const std::string& what) {
        const std::string text = fmt::format("{}, contact of {}", what, readable(time, "s"));
        panel.series.push_back(
            level(limits, time, elastic_ratio, "elastic above: " + text, "elastic above", 1));
        panel.series.push_back(level(limits, time, liquid_ratio, "liquid below: " + text, "liquid below", 2));
    };
    const auto& law = compared.reported ? compared.reported->law : std::nullopt;
    const bool by_law = law && limits.laws.find(*law) != nullptr;
    if (const ContactTemperatures* contact = deciding_contact(compared))
        add(contact->contact_time, by_law ? std::string(law->name()) : "hertz");
}

}  // namespace

bool has_temperatures(const RunData& run) {
    for (const SampleData& sample : run.samples())
        if (sample.modulus->glass && sample.comparison->temperature) return true;
    return false;
}

Figure temperature_figure(const RunData& run) {
    Figure figure{
        .id = "temperature",
        .title = "Viscosity of the glass against temperature",
        .caption =
            "By two models from the composition of the glass; their gap is the uncertainty, as they are "
            "calibrated on magmas and slags. Above the upper dashed line the glass relaxes in more than 10 "
            "contact times, and elastic theory holds; below the lower one in less than a tenth.",
        .numbers = {.columns = {"sample", "model", "temperature [K]", "viscosity [Pa s]"}}};
    for (const SampleData& sample : run.samples()) {
        if (!sample.modulus->glass || !sample.comparison->temperature) continue;
        XyPanel panel{.title = sample.name(),
                      .x = {.label = "temperature", .unit = "C", .from = coolest, .to = hottest},
                      .y = {.label = "viscosity", .unit = "Pa s", .spacing = Spacing::logarithmic}};
        for (const ViscosityModel model : all_values<ViscosityModel>)
            panel.series.push_back(viscosity_series(sample, model, figure));
        add_contact_lines(*sample.comparison, panel);
        if (const auto& particle = sample.comparison->temperature->particle)
            panel.rules.push_back(
                {.x = particle->value() - zero_celsius, .label = celsius(particle->value())});
        figure.panels.emplace_back(std::move(panel));
    }
    if (figure.panels.empty())
        figure.caption = "The chemistry of the glass is not known: the case has no oxides.";
    share_axes(figure.panels, true, true);
    return figure;
}

}  // namespace ashimpact::report
