// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/inputs.hpp"

#include <stdexcept>

#include "core/quantities/checks.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

struct InputEntry {
    std::string_view name;
    Dimension dimension;  ///< of a damping: that of the constant law
};

constexpr std::array<InputEntry, 11> input_entries{{{"radius", Dimension::length},
                                                    {"density", Dimension::density},
                                                    {"mass", Dimension::mass},
                                                    {"contact_modulus", Dimension::pressure},
                                                    {"work_of_adhesion", Dimension::energy_per_area},
                                                    {"yield_pressure", Dimension::pressure},
                                                    {"damping", Dimension::damping},
                                                    {"velocity", Dimension::velocity},
                                                    {"partner_radius", Dimension::length},
                                                    {"partner_density", Dimension::density},
                                                    {"partner_mass", Dimension::mass}}};

constexpr std::array<InputEntry, observable_count> observable_entries{
    {{"captured", Dimension::fraction},
     {"restitution", Dimension::fraction},
     {"rebound_velocity", Dimension::velocity},
     {"contact_time", Dimension::time},
     {"maximum_overlap", Dimension::length}}};

template <class Entries>
std::size_t position_of(const Entries& entries, std::string_view name) {
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (entries[i].name == name) return i;
    throw std::logic_error("the schema of a sweep allows " + std::string(name));
}

/// The parameter of contact laws that an input is, or none.
const LawParameter* parameter_of(ImpactInput input) {
    const auto place = static_cast<std::size_t>(input);
    return place < input_entries.size() ? nullptr : &law_parameters()[place - input_entries.size()];
}

}  // namespace

std::size_t impact_input_count() {
    return input_entries.size() + law_parameters().size();
}

ImpactInput input_of(const LawParameter& parameter) {
    return static_cast<ImpactInput>(input_entries.size() + position_of(law_parameters(), parameter.name));
}

std::string_view name_of(ImpactInput input) {
    if (const LawParameter* parameter = parameter_of(input)) return parameter->name;
    return input_entries[static_cast<std::size_t>(input)].name;
}

ImpactInput impact_input_named(std::string_view name) {
    for (const LawParameter& parameter : law_parameters())
        if (parameter.name == name) return input_of(parameter);
    return static_cast<ImpactInput>(position_of(input_entries, name));
}

Dimension dimension_of(ImpactInput input, DampingLaw law) {
    if (const LawParameter* parameter = parameter_of(input)) return parameter->dimension;
    return input == ImpactInput::damping ? dimension_of(law)
                                         : input_entries[static_cast<std::size_t>(input)].dimension;
}

bool may_be_zero(ImpactInput input) {
    if (const LawParameter* parameter = parameter_of(input)) return parameter->may_be_zero;
    return input == ImpactInput::work_of_adhesion || input == ImpactInput::damping;
}

void require_allowed(ImpactInput input, double value, Dimension dimension) {
    if (const LawParameter* parameter = parameter_of(input)) return require_allowed(*parameter, value);
    (may_be_zero(input) ? require_not_negative : require_positive)(name_of(input), value, dimension);
}

std::string_view name_of(Observable observable) {
    return observable_entries[static_cast<std::size_t>(observable)].name;
}

Observable observable_named(std::string_view name) {
    return static_cast<Observable>(position_of(observable_entries, name));
}

Dimension dimension_of(Observable observable) {
    return observable_entries[static_cast<std::size_t>(observable)].dimension;
}

bool captures_count(Observable observable) {
    return observable != Observable::contact_time;
}

}  // namespace ashimpact
