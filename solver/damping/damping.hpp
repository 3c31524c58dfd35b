// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/names.hpp"
#include "core/units/units.hpp"
#include "solver/damping/constant.hpp"
#include "solver/damping/contact_radius.hpp"
#include "solver/damping/tsuji.hpp"

namespace ashimpact {

/// How eta of the damping force F_d = eta d(delta)/dt depends on the contact. In the order of
/// RegisteredDampings.
enum class DampingLaw { constant, contact_radius, tsuji };

/// A list of damping laws.
template <class... D>
struct DampingList {
    static constexpr std::size_t size = sizeof...(D);

    /// Calls @p visitor.template operator()<Law>() for the type of @p law.
    template <class Result, class Visitor>
    static Result visit(DampingLaw law, Visitor&& visitor) {
        using Entry = Result (*)(Visitor&);
        static constexpr std::array<Entry, size> entries{&call<D, Result, Visitor>...};
        return entries[static_cast<std::size_t>(law)](visitor);
    }
    /// Applies @p make to the list of types: make.template operator()<D...>().
    template <class Make>
    static constexpr auto apply(Make&& make) {
        return make.template operator()<D...>();
    }

  private:
    template <class One, class Result, class Visitor>
    static Result call(Visitor& visitor) {
        return visitor.template operator()<One>();
    }
};

/// Every damping law. Registering one is its header above, its name in DampingLaw, and its type here.
using RegisteredDampings = DampingList<ConstantDamping, ContactRadiusDamping, TsujiDamping>;

/// A damping law and its coefficient C >= 0 [SI unit of the law's dimension].
struct Damping {
    DampingLaw law = DampingLaw::constant;
    double coefficient = 0.0;
};

/// Names as on the command line and in artifacts.
template <>
struct Names<DampingLaw> {
    static constexpr std::string_view kind = "damping law";
    static constexpr auto all = RegisteredDampings::apply(
        []<class... D>() { return std::array<std::string_view, sizeof...(D)>{D::name...}; });
};

/// What the coefficient measures.
[[nodiscard]] Dimension dimension_of(DampingLaw law);
/// SI unit of the coefficient.
[[nodiscard]] std::string_view unit_of(DampingLaw law);

/// Whether the damping vanishes with the contact radius. If it does not, every contact without adhesion that
/// ends at zero overlap has a critical velocity.
[[nodiscard]] bool vanishes_at_touch(DampingLaw law);
/// Square of the scaled coefficient from which on every impact that touches at zero contact radius is
/// captured; infinite if there is none [1].
[[nodiscard]] double overdamped_squared(DampingLaw law);
/// Whether a scaled coefficient reaches overdamped_squared().
template <class Real>
[[nodiscard]] bool is_overdamped(DampingLaw law, const Real& number) {
    return number * number >= Real(overdamped_squared(law));
}
/// Scaled coefficient of a Hertz impact with e = 1 - @p loss, approximately [1].
[[nodiscard]] double hertz_damping_number(DampingLaw law, double loss);

}  // namespace ashimpact
