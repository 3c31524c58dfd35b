// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/temperature.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "materials/glass/properties.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

constexpr double glass_transition_log10 = 12;  // of the viscosity in Pa s, by definition
constexpr double velocity_without_answer = 1;  // of the table of sizes [m/s]
constexpr std::array table_of_sizes{1e-6, 3e-6, 10e-6, 30e-6, 100e-6, 300e-6};

std::optional<double> if_finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The glass of a sample as a melt.
class GlassMelt {
  public:
    GlassMelt(const SampleGlass& glass, std::optional<double> temperature)
        : temperature_(temperature),
          shear_modulus_(ashimpact::shear_modulus({glass.young_modulus.value, glass.poisson_ratio})),
          giordano_(ViscosityModel::giordano2008, amounts(glass)),
          urbain_(ViscosityModel::urbain1981, amounts(glass)) {}

    [[nodiscard]] double shear_modulus() const { return shear_modulus_; }
    [[nodiscard]] double glass_transition() const { return giordano_.temperature_at(glass_transition_log10); }

    [[nodiscard]] ContactTemperatures of(double contact_time) const {
        return {contact_time, of(giordano_, contact_time), of(urbain_, contact_time)};
    }

  private:
    static OxideAmounts amounts(const SampleGlass& glass) {
        OxideAmounts amounts = no_oxides();
        for (const auto& [oxide, fraction] : glass.composition)
            if (const auto named = named_oxide(oxide)) amounts[named->index] += fraction.value;
        return amounts;
    }

    [[nodiscard]] GlassTemperatures of(const MeltViscosity& viscosity, double contact_time) const {
        const auto at_ratio = [&](double ratio) {
            return if_finite(
                viscosity.temperature_at(log10_viscosity_of_ratio(ratio, shear_modulus_, contact_time)));
        };
        GlassTemperatures temperatures{.elastic_up_to = at_ratio(elastic_ratio),
                                       .relaxation_equals_contact = at_ratio(1),
                                       .liquid_from = at_ratio(liquid_ratio)};
        if (!temperature_) return temperatures;
        const double ratio = std::pow(10.0, viscosity.log10_at(*temperature_) -
                                                log10_viscosity_of_ratio(1, shear_modulus_, contact_time));
        temperatures.relaxation_over_contact = if_finite(ratio);
        temperatures.regime = contact_regime(ratio);
        return temperatures;
    }

    std::optional<double> temperature_;
    double shear_modulus_;
    MeltViscosity giordano_;
    MeltViscosity urbain_;
};

/// The contact of a sphere of another size, of the same material on the same wall. Of two spheres both grow.
ContactPair scaled_to(ContactPair pair, double factor) {
    pair.effective_radius *= factor;
    pair.mass *= factor * factor * factor;
    return pair;
}

void add_glass_limits(const TemperatureEvidence& evidence, const SampleGlass& glass,
                      TemperatureLimits& limits) {
    const auto& particle = evidence.stated.particle;
    const GlassMelt melt(glass, particle ? std::optional(particle->value()) : std::nullopt);
    limits.shear_modulus = melt.shear_modulus();
    limits.glass_transition = if_finite(melt.glass_transition());
    for (const auto& [law, velocity] : evidence.velocities)
        if (velocity.contact_time) limits.laws.set(law, melt.of(*velocity.contact_time));
    const bool answered = evidence.reported && evidence.reported->velocity;
    limits.velocity = answered ? evidence.reported->velocity->value : velocity_without_answer;
    const double own = 2 * evidence.contact.radius.value;
    const auto add = [&](double diameter) {
        const ContactPair pair = scaled_to(evidence.contact.pair, diameter / own);
        limits.by_size.push_back({diameter, melt.of(hertz_contact_time(pair, *limits.velocity))});
    };
    bool own_listed = false;
    for (const double diameter : table_of_sizes) {
        if (!own_listed && own <= diameter) add(own);
        own_listed = own_listed || own <= diameter;
        if (diameter != own) add(diameter);
    }
    if (!own_listed) add(own);
}

}  // namespace

std::optional<TemperatureLimits> temperature_limits(const TemperatureEvidence& evidence) {
    const auto& glass = evidence.modulus.glass;
    if (!glass && !evidence.stated.particle && !evidence.stated.wall) return std::nullopt;
    TemperatureLimits limits{.particle = evidence.stated.particle, .wall = evidence.stated.wall};
    if (glass) add_glass_limits(evidence, *glass, limits);
    return limits;
}

const ContactTemperatures* deciding_contact(const SampleComparison& sample) {
    if (!sample.temperature) return nullptr;
    const auto& law = sample.reported ? sample.reported->law : std::nullopt;
    const ContactTemperatures* contact = law ? sample.temperature->laws.find(*law) : nullptr;
    for (const SizeTemperatures& size : sample.temperature->by_size)
        if (contact == nullptr && size.diameter == sample.diameter) contact = &size.contact;
    return contact;
}

std::optional<ContactRegime> relaxing_glass(const SampleComparison& sample) {
    const ContactTemperatures* contact = deciding_contact(sample);
    if (contact == nullptr || contact->giordano2008.regime == ContactRegime::elastic) return std::nullopt;
    return contact->giordano2008.regime;
}

std::string celsius(double temperature) {
    constexpr double zero_celsius = 273.15;
    return fmt::format("{:.0f} C", temperature - zero_celsius);
}

std::vector<TemperatureNote> temperature_notes(const TemperatureLimits& limits) {
    std::vector<TemperatureNote> notes;
    if (!limits.particle) return notes;
    const double temperature = limits.particle->value();
    const auto add = [&](Severity severity, const std::string& text, const std::optional<Law>& law = {}) {
        notes.push_back({law, {temperature_code, severity, text}});
    };
    if (!limits.shear_modulus && temperature > known_without_chemistry)
        add(Severity::doubt,
            "at " + celsius(temperature) +
                " nothing is known of the glass without its chemistry: the velocities are those "
                "at room temperature, and with \"oxides\" the limit would be known");
    for (const auto& [law, contact] : limits.laws) {
        const auto& regime = contact.giordano2008.regime;
        if (regime && *regime != ContactRegime::elastic)
            add(Severity::doubt,
                fmt::format(
                    "at {} the glass is {} during the contact, elastic up to {}: the velocity is a lower "
                    "bound that elastic theory gives",
                    celsius(temperature), name_of(*regime),
                    celsius(contact.giordano2008.elastic_up_to.value_or(0))),
                law);
        if (regime != contact.urbain1981.regime)
            add(Severity::remark,
                fmt::format("at {} the glass is {} by Giordano et al. 2008 and {} by Urbain et al. 1981",
                            celsius(temperature), name_of(*regime), name_of(*contact.urbain1981.regime)),
                law);
    }
    if (limits.wall && limits.wall->value() > temperature)
        add(Severity::remark, "the wall is hotter than the particle, whose temperature counts for its glass");
    constexpr double warm = 373.15;
    if (temperature > warm)
        add(Severity::background,
            "moduli, work of adhesion and damping are those at room temperature: below the elastic limit no "
            "law "
            "of their change with temperature is used");
    return notes;
}

}  // namespace ashimpact
