#include "solver/damping/damping.hpp"

#include "materials/base/checks.hpp"

#include <string>

#include <stdexcept>

namespace ashimpact {

namespace {

const DampingName& entry_of(DampingLaw law) {
    return damping_names[static_cast<std::size_t>(law)];
}

}  // namespace

std::string_view name_of(DampingLaw law) {
    return entry_of(law).name;
}

std::string_view unit_of(DampingLaw law) {
    return entry_of(law).unit;
}

Dimension dimension_of(DampingLaw law) {
    switch (law) {
        case DampingLaw::constant:
            return Dimension::damping;
        case DampingLaw::contact_radius:
            return Dimension::viscosity;
        case DampingLaw::tsuji:
            return Dimension::fraction;
    }
    throw std::logic_error("damping law without a dimension");
}

DampingLaw damping_named(std::string_view name) {
    std::vector<std::string> names;
    for (const DampingName& entry : damping_names) {
        if (entry.name == name) return entry.law;
        names.emplace_back(entry.name);
    }
    throw unknown_name("damping law", name, names);
}

}  // namespace ashimpact
