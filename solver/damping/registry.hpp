// SPDX-License-Identifier: GPL-3.0-or-later
// Damping laws as types, for code that runs the formulas of a law; other code includes damping.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "solver/damping/brach_dunn.hpp"
#include "solver/damping/constant.hpp"
#include "solver/damping/contact_radius.hpp"
#include "solver/damping/damping.hpp"
#include "solver/damping/hunt_crossley.hpp"
#include "solver/damping/tsuji.hpp"

namespace ashimpact {

/// Shapes of the terms of law D at first touch of a contact without adhesion.
template <class D>
[[nodiscard]] constexpr auto touch_shapes() {
    return D::shapes(0.0, StaticForces<double>{0.0, 0.0});
}

/// How many terms law D has.
template <class D>
inline constexpr std::size_t terms_of = std::tuple_size_v<decltype(touch_shapes<D>())>;

/// Coefficients of the terms of law D [SI], from its coefficient C and its parameters. A law of several terms
/// has a member coefficients() that gives them.
template <class D>
[[nodiscard]] std::array<double, terms_of<D>> coefficients_of(double coefficient,
                                                              const ParameterValues<double>& values) {
    if constexpr (terms_of<D> == 1)
        return {coefficient};
    else
        return D::coefficients(coefficient, values);
}

/// A list of damping laws in the order of DampingLaw.
template <class... D>
struct DampingList {
    static constexpr std::array laws{D::law...};
    static_assert(laws == all_values<DampingLaw>, "every DampingLaw has one type, in the same order");

    /// Calls @p visitor.template operator()<Law>() for the type of @p law.
    template <class Result, class Visitor>
    static Result visit(DampingLaw law, Visitor&& visitor) {
        using Entry = Result (*)(Visitor&);
        static constexpr std::array<Entry, sizeof...(D)> entries{&call<D, Result, Visitor>...};
        return entries[static_cast<std::size_t>(law)](visitor);
    }

  private:
    template <class One, class Result, class Visitor>
    static Result call(Visitor& visitor) {
        return visitor.template operator()<One>();
    }
};

/// Every damping law.
using RegisteredDampings =
    DampingList<ConstantDamping, ContactRadiusDamping, TsujiDamping, HuntCrossleyDamping, BrachDunnDamping>;

}  // namespace ashimpact
