#include "solver/damping/damping.hpp"

#include "materials/base/error.hpp"

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
    std::string allowed;
    for (const DampingName& entry : damping_names) {
        if (entry.name == name) return entry.law;
        if (!allowed.empty()) allowed += ", ";
        allowed += entry.name;
    }
    throw InputError("unknown damping law '" + std::string(name) + "'", allowed);
}

}  // namespace ashimpact
