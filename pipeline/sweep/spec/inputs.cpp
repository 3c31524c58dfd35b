#include "pipeline/sweep/spec/inputs.hpp"

#include <stdexcept>

#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

struct InputEntry {
    std::string_view name;
    Dimension dimension;  ///< of a damping: that of the constant law
};

constexpr std::array<InputEntry, impact_input_count> input_entries{
    {{"radius", Dimension::length},
     {"density", Dimension::density},
     {"mass", Dimension::mass},
     {"contact_modulus", Dimension::pressure},
     {"work_of_adhesion", Dimension::energy_per_area},
     {"yield_pressure", Dimension::pressure},
     {"damping", Dimension::damping},
     {"velocity", Dimension::velocity}}};

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

}  // namespace

std::string_view name_of(ImpactInput input) {
    return input_entries[static_cast<std::size_t>(input)].name;
}

ImpactInput impact_input_named(std::string_view name) {
    return static_cast<ImpactInput>(position_of(input_entries, name));
}

Dimension dimension_of(ImpactInput input, DampingLaw law) {
    return input == ImpactInput::damping ? dimension_of(law)
                                         : input_entries[static_cast<std::size_t>(input)].dimension;
}

bool may_be_zero(ImpactInput input) {
    return input == ImpactInput::work_of_adhesion || input == ImpactInput::damping;
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
