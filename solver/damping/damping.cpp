// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/damping/damping.hpp"

#include "solver/damping/registry.hpp"

namespace ashimpact {

Dimension dimension_of(DampingLaw law) {
    return RegisteredDampings::visit<Dimension>(law, []<class D>() { return D::dimension; });
}

std::string_view unit_of(DampingLaw law) {
    return si_unit(dimension_of(law));
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
