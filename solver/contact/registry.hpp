// SPDX-License-Identifier: GPL-3.0-or-later
// Contact laws as templates, for code that runs the formulas of a law: few sources need this, the others
// include law.hpp.
#pragma once

#include <array>
#include <type_traits>

#include "solver/contact/brach_dunn.hpp"
#include "solver/contact/dmt.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/jkr.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/contact/thornton_ning.hpp"

namespace ashimpact {

/// Whether overlap and force of a law are polynomials of u, as make_motion() takes them.
template <template <class> class L>
inline constexpr bool has_polynomials = requires(const L<double>& law) {
    law.overlap(1.0);
};

/// Attractive part of a law's force at u, never positive [k L^(3/2)]; laws that divide the force otherwise
/// than for damping have a member of that name.
template <template <class> class L, class Real>
[[nodiscard]] Real attractive_force(const L<Real>& law, const Real& u) {
    if constexpr (requires { law.attractive_force(u); })
        return law.attractive_force(u);
    else
        return Real(0) - law.attraction(u);
}

template <template <class> class L, class Result, class Visitor>
Result visit_one(Visitor& visitor) {
    return visitor.template operator()<L>();
}

template <class Result, class Visitor>
Result Law::visit(Visitor&& visitor) const {
    const auto entries = []<template <class> class... L>(LawList<L...>) {
        using Entry = Result (*)(std::remove_reference_t<Visitor>&);
        return std::array<Entry, sizeof...(L)>{&visit_one<L, Result, std::remove_reference_t<Visitor>>...};
    }(RegisteredLaws());
    return entries[index_](visitor);
}

}  // namespace ashimpact
