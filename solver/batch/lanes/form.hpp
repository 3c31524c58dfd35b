// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "solver/batch/lanes/zone_form.hpp"
#include "solver/damping/registry.hpp"
#include "solver/numeric/number.hpp"
#include "solver/numeric/polynomial.hpp"

namespace ashimpact {

/// A polynomial in the adhesion number A of a law and the offset B of a PlasticLoading: element i + 3 k is
/// the coefficient of A^i B^k. No law has A^3.
using NumberPolynomial = Polynomial<double, 6>;
inline constexpr int powers_of_adhesion = 3;

/// A polynomial in the state whose coefficients depend on those: what a contact law turns into when it is
/// evaluated at compile time. It lists the powers that occur, so that the vector code of a law holds its
/// products and no others, and is still the law's own line. Powers beyond what it holds do not compile.
using Symbol = Polynomial<NumberPolynomial, 24>;

/// Whether this power of the state occurs, for some numbers.
[[nodiscard]] constexpr bool has(const Symbol& symbol, int power) {
    return symbol[power] != NumberPolynomial();
}

/// A set of powers of one variable; bit k represents x^k.
using PowerSet = std::uint64_t;

[[nodiscard]] constexpr PowerSet power_bit(int power) {
    return PowerSet{1} << power;
}
[[nodiscard]] constexpr bool contains(PowerSet set, int power) {
    return ((set >> power) & 1U) != 0;
}
[[nodiscard]] constexpr int highest(PowerSet set) {
    int power = 0;
    while ((set >> power) > 1) ++power;
    return power;
}

/// The smaller factor i of x^power = x^i x^(power-i) with both in the set, as balanced as possible; 0 if
/// none.
[[nodiscard]] constexpr int factor_of(PowerSet set, int power) {
    for (int i = power / 2; i >= 1; --i)
        if (contains(set, i) && contains(set, power - i)) return i;
    return 0;
}

/// The set, completed so that every member but x is the product of two lower members.
[[nodiscard]] constexpr PowerSet closed(PowerSet set) {
    set = (set | power_bit(1)) & ~power_bit(0);
    for (int power = highest(set); power > 1; --power)
        if (contains(set, power) && factor_of(set, power) == 0)
            set |= power_bit(power / 2) | power_bit(power - power / 2);
    return set;
}

/// The powers with which the state occurs in a polynomial, highest first.
struct Terms {
    std::array<int, Symbol::capacity> power{};
    int count = 0;

    /// Distances of the powers.
    [[nodiscard]] constexpr PowerSet gaps() const {
        PowerSet set = 0;
        for (int i = 1; i < count; ++i) set |= power_bit(at(i - 1) - at(i));
        return set;
    }
    [[nodiscard]] constexpr int at(int i) const { return power[static_cast<std::size_t>(i)]; }
    [[nodiscard]] constexpr int lowest() const { return at(count - 1); }
};

/// A polynomial of the state as lowest power times a monic polynomial.
template <const Symbol& symbol, bool with_constant>
struct Sparse {
    static constexpr Terms terms = [] {
        Terms found;
        for (int i = symbol.degree; i >= (with_constant ? 0 : 1); --i)
            if (has(symbol, i)) found.power[static_cast<std::size_t>(found.count++)] = i;
        return found;
    }();
    static_assert(terms.count > 0);
    /// Leading coefficient; no law has A or B in it.
    static constexpr double leading = symbol[terms.at(0)][0];
    static_assert(leading != 0.0);

    /// Powers of the state that evaluate() needs.
    static constexpr PowerSet powers = [] {
        if (terms.count == 1) {
            const int power = terms.at(0);
            return power == 0 ? PowerSet{0} : power_bit(power - power / 2) | power_bit(power / 2);
        }
        PowerSet set = terms.lowest() > 0 ? power_bit(terms.lowest()) : PowerSet{0};
        if (terms.count > 2 || (set & terms.gaps()) != 0) return set | terms.gaps();
        const int gap = terms.at(0) - terms.at(1);
        return set | power_bit(gap - gap / 2) | power_bit(gap / 2);
    }();
};

/// The scaled equation of motion of a contact law and a damping law, known at compile time but for the
/// numbers of the contact law and the damping number beta; in the coordinate q of Motion:
///
///     dq/dtheta = y - beta g(q),   dy/dtheta = -h(q),   dt/dtheta = delta'(q),   h = delta' F,  g' = delta'
///     eta/beta.
///
/// y = v + beta g(q) is velocity plus the impulse damping has taken since q = 0 (Lienard's variable). In (q,
/// y) no product of two unknowns is left, and each rate depends on one of the two through q alone: the
/// leapfrog's form.
template <template <class> class L, class DampingType>
struct Form {
    template <class Real>
    using ContactLaw = L<Real>;
    using Damping = DampingType;

  private:
    static constexpr L<Symbol> law = [] {
        constexpr NumberPolynomial adhesion = NumberPolynomial::identity();
        if constexpr (requires(const L<Symbol>& l) { l.offset; })
            return L<Symbol>{{Symbol(adhesion)}, Symbol(power<powers_of_adhesion>(adhesion))};
        else
            return L<Symbol>{Symbol(adhesion)};
    }();
    static constexpr Symbol u = Symbol::identity();
    static constexpr Symbol shape_of_u =
        Damping::shapes(u, {law.force(u) + law.attraction(u), law.attraction(u)})[0];

  public:
    /// q = u^2, u = sqrt(contact radius).
    static constexpr bool squared = law.overlap(u).even() && law.force(u).even() && shape_of_u.even();

  private:
    static constexpr Symbol reduced(const Symbol& p) { return squared ? p.of_square() : p; }

  public:
    static constexpr Symbol overlap = reduced(law.overlap(u));         ///< delta(q)
    static constexpr Symbol force = reduced(law.force(u));             ///< F(q)
    static constexpr Symbol force_slope = force.derivative();          ///< F'(q)
    static constexpr Symbol damping_of_state = reduced(shape_of_u);    ///< eta(q)/beta
    static constexpr Symbol slope = overlap.derivative();              ///< delta'(q)
    static constexpr Symbol stiffness = slope * force;                 ///< h(q)
    static constexpr Symbol drag = slope * damping_of_state;           ///< g'(q)
    static constexpr Symbol impulse = drag.antiderivative();           ///< g(q)
    static constexpr Symbol stiffness_slope = stiffness.derivative();  ///< h'(q)
    static constexpr Symbol drag_slope = drag.derivative();            ///< g''(q)
    static constexpr Symbol potential = stiffness.antiderivative();    ///< U(q)

    /// Whether the law leaves this branch where the contact yields.
    static constexpr bool yields = requires { L<double>::is_plastic; };
};

/// The form of the branch that an impact is on from yield on.
template <class F>
using LoadingForm = Form<F::template ContactLaw<double>::template Loading, typename F::Damping>;

/// Calls @p call with the Form of a contact law and a damping law of one term.
template <template <class> class L, class Call>
void with_form(DampingLaw damping_law, const Call& call) {
    if constexpr (requires { L<double>::has_cohesive_zone; })
        call(ZoneForm());
    else
        RegisteredDampings::visit<void>(damping_law, [&]<class Damping>() {
            if constexpr (terms_of<Damping> == 1) call(Form<L, Damping>());
        });
}

}  // namespace ashimpact
