// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::array ranges{
    PlausibleRange{Dimension::length, 10e-9, 5e-3, "10 nm to 5 mm", {"um", "nm", "mm"}, "diameter"},
    PlausibleRange{Dimension::length,
                   5e-9,
                   2.5e-3,
                   "5 nm to 2.5 mm",
                   {"um", "nm", "mm"},
                   "radius effective_radius at_radius"},
    PlausibleRange{
        Dimension::length, 1e-11, 1e-6, "0.01 nm to 1 um", {"nm", "um", "pm"}, "roughness cohesion_range"},
    PlausibleRange{Dimension::length, 10e-9, 1e-3, "10 nm to 1 mm", {"um", "nm", "mm"}, "pixel_size"},
    PlausibleRange{Dimension::length, 1e-10, 1e-3, "0.1 nm to 1 mm", {"um", "nm", "mm"}, "contact_radius"},
    PlausibleRange{Dimension::force, 1e-15, 100, "1 fN to 100 N", {"mN", "uN", "nN"}, "force"},
    PlausibleRange{Dimension::mass, 1e-23, 2e-3, "1e-23 kg to 2 g", {"ug", "ng", "pg"}, "mass"},
    PlausibleRange{Dimension::pressure,
                   10e6,
                   1.2e12,
                   "10 MPa to 1.2 TPa",
                   {"GPa", "MPa", "kPa"},
                   "young_modulus contact_modulus"},
    PlausibleRange{
        Dimension::pressure, 1e5, 1e11, "100 kPa to 100 GPa", {"MPa", "GPa", "kPa"}, "yield_pressure"},
    PlausibleRange{
        Dimension::pressure, 1e3, 1e12, "1 kPa to 1 TPa", {"MPa", "GPa", "kPa"}, "cohesive_stress"},
    PlausibleRange{Dimension::pressure,
                   100,
                   1e11,
                   "100 J/m3 to 100 GJ/m3",
                   {"MJ/m3", "GJ/m3", "kJ/m3"},
                   "cohesion_energy_density"},
    PlausibleRange{Dimension::density,
                   50,
                   25e3,
                   "50 to 25,000 kg/m3",
                   {"g/cm3", "kg/m3", "mg/cm3"},
                   "density densities"},
    PlausibleRange{Dimension::energy_per_area,
                   1e-5,
                   20,
                   "1e-5 to 20 J/m2",
                   {"mJ/m2", "uJ/m2", "J/m2"},
                   "work_of_adhesion surface_energy surface_energies interfacial_energy"},
    PlausibleRange{Dimension::velocity,
                   1e-6,
                   2000,
                   "1e-6 to 2,000 m/s",
                   {"mm/s", "um/s", "m/s"},
                   "velocity measured_critical_velocity at to_velocity tangential_velocity",
                   true},
    PlausibleRange{
        Dimension::angular_velocity, 0.01, 1e9, "0.01 to 1e9 rad/s", {"rpm", "rad/s", "rad/s"}, "spin", true},
    PlausibleRange{Dimension::temperature,
                   200,
                   2500,
                   "200 to 2,500 K (-73 C to 2,227 C)",
                   {"C", "K", "F"},
                   "temperature gas_temperature"},
    PlausibleRange{Dimension::length, 1e-3, 2, "1 mm to 2 m", {"mm", "cm", "m"}, "tube_diameter"},
    PlausibleRange{
        Dimension::velocity, 0.05, 150, "0.05 to 150 m/s", {"m/s", "cm/s", "mm/s"}, "gas_velocity"},
    PlausibleRange{
        Dimension::viscosity, 5e-6, 2e-4, "5 to 200 uPa s", {"uPa s", "mPa s", "Pa s"}, "gas_viscosity"},
    PlausibleRange{Dimension::density, 1e-9, 1, "1 ug/m3 to 1 kg/m3", {"g/m3", "mg/m3", "ug/m3"}, "ash_load"},
    PlausibleRange{Dimension::fraction, 1e-3, 2, "0.001 to 2", {"%", "%", "%"}, "friction"}};

/// Factor by which a number without a unit may lie outside of its range.
constexpr double slip = 1000;

bool is_listed(std::string_view names, std::string_view name) {
    return (' ' + std::string(names) + ' ').find(' ' + std::string(name) + ' ') != std::string::npos;
}

/// How far outside of its range a value is, as a factor; 1 inside.
double factor_outside(const PlausibleRange& range, double value) {
    return std::max({1.0, value / range.greatest, range.least / value});
}

/// "90 um" for 90, by the first unit with which a number lies in its range; none if there is no such unit.
std::optional<std::string> meant_with_unit(const PlausibleRange& range, double number) {
    for (const std::string_view unit : range.units)
        if (range.holds(to_si(number, unit, range.dimension)))
            return fmt::format("{} {}", shortest(number), unit);
    return std::nullopt;
}

/// Whether a number lies in its range with the unit that people write mostly: "2.3" for a density. A fraction
/// needs none.
bool usual_unit_fits(const PlausibleRange& range, double number) {
    return range.dimension != Dimension::fraction &&
           range.holds(to_si(number, range.units.front(), range.dimension));
}

/// How a value of JSON is written; none if it is no positive quantity of this dimension.
std::optional<Writing> writing_of(const Json& node, Dimension dimension) {
    try {
        if (node.is_number()) return Writing{node.get<double>(), node.get<double>()};
        Writing written{read_quantity(node, dimension).value};
        if (!node.is_string()) return written;
        const auto number = read_number(node.get<std::string>());
        if (number && !number->per_cent) written.number = number->value;
        return written;
    } catch (const InputError&) {  // whoever needs the quantity refuses it
        return std::nullopt;
    }
}

/// The doubts about the values under the key of a quantity.
class Doubts {
  public:
    Doubts(std::vector<Finding>& findings, bool bare) : findings_(findings), bare_(bare) {}

    void walk(const Json& node, const std::string& pointer) {
        if (node.is_array())
            for (std::size_t i = 0; i < node.size(); ++i) walk(node[i], child_pointer(pointer, i));
        if (!node.is_object()) return;
        for (const auto& [key, member] : node.items()) {
            if (key == "composition") continue;  // compose() checks its densities, those of XRD files too
            const std::string place = child_pointer(pointer, key);
            if (const PlausibleRange* range = plausible_range(key))
                take(*range, member, place);
            else
                walk(member, place);
        }
    }

  private:
    /// Takes a quantity, a column, or the quantities of a distribution or under names.
    void take(const PlausibleRange& range, const Json& node, const std::string& place) {
        if (node.is_array()) return take_column(range, node, "", place);
        if (!node.is_object() || node.contains("value")) return take_quantity(range, node, place);
        const auto unit = node.contains("unit") && node["unit"].is_string() ? node["unit"].get<std::string>()
                                                                            : std::string();
        for (const auto& [key, member] : node.items()) {
            if (is_listed("points standard_deviation geometric_standard_deviation", key)) continue;
            const std::string inner = child_pointer(place, key);
            if (member.is_array())
                take_column(range, member, unit, inner);
            else
                take(range, member, inner);
        }
    }

    void take_quantity(const PlausibleRange& range, Json node, const std::string& place) {
        if (!bare_ && node.is_number()) return;
        if (node.is_object())
            for (const char* key :
                 {"origin", "source", "range", "citations", "assumed", "interval", "method"})
                node.erase(key);
        if (const auto written = writing_of(node, range.dimension)) add(range, *written, place);
    }

    /// The first value outside gets a doubt; every one may be refused. @param unit of the numbers; empty: SI
    void take_column(const PlausibleRange& range, const Json& values, const std::string& unit,
                     const std::string& place) {
        if (!bare_ && unit.empty()) return;
        std::optional<Finding> first;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Json value = unit.empty() || !values[i].is_number()
                                   ? values[i]
                                   : Json{{"value", values[i]}, {"unit", unit}};
            const auto written = writing_of(value, range.dimension);
            if (!written) continue;
            auto doubt = implausible_at(child_pointer(place, i), range, *written);
            if (!first) first = std::move(doubt);
        }
        if (first) findings_.push_back(*std::move(first));
    }

    void add(const PlausibleRange& range, const Writing& written, const std::string& place) {
        if (auto doubt = implausible_at(place, range, written)) findings_.push_back(*std::move(doubt));
    }

    std::vector<Finding>& findings_;
    bool bare_;  ///< whether numbers without a unit are quantities
};

}  // namespace

const PlausibleRange* plausible_range(std::string_view name) {
    std::string key(name.substr(std::min(name.find_first_not_of('-'), name.size())));
    std::ranges::replace(key, '-', '_');
    for (const char* whose : {"partner_", "wall_", "particle_", "from_", "to_"})
        if (key.starts_with(whose)) key.erase(0, std::string_view(whose).size());
    const auto found = std::ranges::find_if(
        ranges, [&](const PlausibleRange& range) { return is_listed(range.names, key); });
    return found == ranges.end() ? nullptr : &*found;
}

std::optional<Finding> implausible(const PlausibleRange& range, const Writing& written) {
    const double size = range.either_sign ? std::abs(written.value) : written.value;
    if (!(size > 0) || range.holds(size)) return std::nullopt;
    const std::string unit(si_unit(range.dimension));
    if (written.number && (factor_outside(range, size) >= slip || usual_unit_fits(range, *written.number))) {
        const auto meant = meant_with_unit(range, *written.number);
        throw InputError(
            fmt::format("{} has no unit and is {} {}{}", shortest(*written.number), shortest(written.value),
                        unit, meant ? ", did you mean " + *meant + "?" : ""),
            fmt::format("{}; beyond that a number with its unit", range.words));
    }
    const std::string shown = readable(written.value, unit);
    std::string_view rest(shown);
    double number = 0;
    static_cast<void>(take_decimal(rest, number));
    const auto meant = number > 0 ? meant_with_unit(range, number) : std::nullopt;
    return Finding{implausible_code, Severity::doubt,
                   fmt::format("{} is outside of what is plausible, {}: is the unit right?{}", shown,
                               range.words, meant ? " Did you mean " + *meant + "?" : "")};
}

std::optional<Finding> implausible_at(const std::string& place, const PlausibleRange& range,
                                      const Writing& written) {
    auto doubt = at_place(place, [&] { return implausible(range, written); });
    if (doubt) doubt->text.insert(0, place + ": ");
    return doubt;
}

std::vector<Finding> implausible_text(std::string_view option, const std::string& text) {
    const PlausibleRange* range = plausible_range(option);
    const auto written = range == nullptr ? std::nullopt : writing_of(text, range->dimension);
    if (!written) return {};
    const auto doubt = implausible_at(std::string(option), *range, *written);
    return doubt ? std::vector{*doubt} : std::vector<Finding>{};
}

std::vector<Finding> implausible_values(const Json& document, const std::string& pointer, bool bare) {
    std::vector<Finding> findings;
    Doubts(findings, bare).walk(document, pointer);
    return findings;
}

std::string outside_model_text() {
    return fmt::format("above {} m/s, outside the model", shortest(fastest_in_model));
}

std::string critical_velocity_text(double velocity, const std::string& text) {
    return velocity > fastest_in_model ? outside_model_text() : text;
}

std::optional<Finding> outside_model(double critical_velocity) {
    if (!(critical_velocity > fastest_in_model)) return std::nullopt;
    return Finding{outside_model_code, Severity::doubt, "the critical velocity is " + outside_model_text()};
}

}  // namespace ashimpact
