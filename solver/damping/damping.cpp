#include "solver/damping/damping.hpp"

#include "materials/base/checks.hpp"

#include <string>

#include <stdexcept>

namespace ashimpact {

std::string_view name_of(DampingLaw law) {
    return damping_names[static_cast<std::size_t>(law)].name;
}

Dimension dimension_of(DampingLaw law) {
    return RegisteredDampings::visit<Dimension>(law, []<class D>() { return D::dimension; });
}

std::string_view unit_of(DampingLaw law) {
    return si_unit(dimension_of(law));
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

bool vanishes_at_touch(DampingLaw law) {
    return RegisteredDampings::visit<bool>(law, []<class D>() { return D::shape(0.0) == 0.0; });
}

double overdamped_squared(DampingLaw law) {
    return RegisteredDampings::visit<double>(law, []<class D>() { return D::overdamped_squared; });
}

double hertz_damping_number(DampingLaw law, double loss) {
    return RegisteredDampings::visit<double>(law, [&]<class D>() { return D::hertz_number(loss); });
}

}  // namespace ashimpact
