// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/damping/damping.hpp"

#include <algorithm>

#include "solver/damping/registry.hpp"

namespace ashimpact {

std::string_view summary_of(DampingLaw law) {
    return RegisteredDampings::visit<std::string_view>(law, []<class D>() { return D::summary; });
}

Dimension dimension_of(DampingLaw law) {
    return RegisteredDampings::visit<Dimension>(law, []<class D>() { return D::dimension; });
}

std::string_view unit_of(DampingLaw law) {
    return si_unit(dimension_of(law));
}

std::span<const LawParameter> parameters_of(DampingLaw law) {
    using Parameters = std::span<const LawParameter>;
    return RegisteredDampings::visit<Parameters>(law, []<class D>() -> Parameters {
        if constexpr (requires { D::parameters; }) return D::parameters;
        return {};
    });
}

bool has_one_number(DampingLaw law) {
    return RegisteredDampings::visit<bool>(law, []<class D>() { return terms_of<D> == 1; });
}

bool is_damped(const Damping& damping, const ParameterValues<double>& values) {
    return RegisteredDampings::visit<bool>(damping.law, [&]<class D>() {
        return std::ranges::any_of(coefficients_of<D>(damping.coefficient, values),
                                   [](double c) { return c != 0.0; });
    });
}

ParameterValues<double> further_coefficients(const Damping& damping, const ParameterValues<double>& values) {
    using Values = ParameterValues<double>;
    return RegisteredDampings::visit<Values>(damping.law, [&]<class D>() {
        Values further;
        if constexpr (requires { D::further; }) {
            static_assert(D::further.size() + 1 == terms_of<D>);
            const auto coefficients = coefficients_of<D>(damping.coefficient, values);
            for (std::size_t k = 0; k < D::further.size(); ++k)
                further.set(D::further[k].name, coefficients[k + 1]);
        }
        return further;
    });
}

bool vanishes_at_touch(DampingLaw law) {
    return RegisteredDampings::visit<bool>(
        law, []<class D>() { return touch_shapes<D>() == std::array<double, terms_of<D>>{}; });
}

double overdamped_squared(DampingLaw law) {
    return RegisteredDampings::visit<double>(law, []<class D>() { return D::overdamped_squared; });
}

double hertz_damping_number(DampingLaw law, double loss) {
    return RegisteredDampings::visit<double>(law, [&]<class D>() { return D::hertz_number(loss); });
}

}  // namespace ashimpact
