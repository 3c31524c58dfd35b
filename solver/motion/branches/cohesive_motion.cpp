// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/branches/cohesive_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "solver/contact/mechanics.hpp"
#include "solver/motion/branches/creep.hpp"
#include "solver/motion/branches/leading_terms.hpp"

namespace ashimpact {

namespace {

CohesiveState end_of(const CohesiveZone& zone, Detachment detachment) {
    switch (detachment) {
        case Detachment::zero_overlap:
            return zone.at_overlap(0);
        case Detachment::load_controlled:
            return zone.greatest_tension();
        case Detachment::zero_force:
            return zone.equilibrium();
        case Detachment::pull_off:
            break;
    }
    return zone.pull_off();
}

}  // namespace

/// The static law of a touching state as power series of any parameter, from that of the contact radius:
/// order by order, each new coefficient from those before it. Names as in CohesiveZone. The first
/// coefficients come from the zone and have its digits, the others those of Real.
template <class Real, class Goal>
class SeriesOfZone {
  public:
    using Terms = Series<Real, Goal>;

    SeriesOfZone(const CohesiveZone& zone, const CohesiveState& state)
        : lambda_(static_cast<Real>(zone.lambda())) {
        angle_[0] = static_cast<Real>(state.angle);
        outer_[0] = static_cast<Real>(state.cohesive_radius);
        sine_[0] = static_cast<Real>(state.sine);
        cosine_[0] = static_cast<Real>(state.cosine);
        quadratic_[0] = static_cast<Real>(zone.quadratic(state));
        linear_[0] = static_cast<Real>(zone.linear(state));
    }
    /// With the leading terms of another number type.
    template <class Other>
    explicit SeriesOfZone(const SeriesOfZone<Other, Goal>& other)
        : lambda_(static_cast<Real>(other.lambda_)) {
        const auto from = other.all();
        const auto to = all();
        for (std::size_t k = 0; k < to.size(); ++k)
            copy_terms(*from[k], *to[k], k < followers ? leading_terms + 1 : leading_terms);
    }

    /// Computes coefficient @p n of overlap_by_radius and force; @p radius is known up to n.
    void advance(const Terms& radius, std::size_t n) {
        const auto product = [n](const Terms& x, const Terms& y) { return product_coefficient(x, y, n); };
        sine_cosine_[n] = product(sine_, cosine_);
        angle_cosine_[n] = product(angle_, cosine_);
        outer_squared_[n] = square_coefficient(outer_, n);
        wall_[n] = product(sine_, outer_squared_);
        pull_[n] = 2 * lambda_ * wall_[n] + 4 * lambda_ * lambda_ / 3 * outer_[n];
        numerator_[n] = product(angle_, pull_);
        denominator_[n] = 2 * product(quadratic_, outer_) + linear_[n];
        m_[n] = quotient_coefficient(numerator_, denominator_, m_, n);
        cosine_m_[n] = product(cosine_, m_);
        turn_[n] = product(cosine_, cosine_m_) + product(outer_, sine_);
        gain_[n] =
            2 * (product(radius, cosine_m_) + wall_[n]) + 4 * lambda_ / 3 * (outer_[n] - product(m_, sine_));
        cosine_gain_[n] = product(cosine_, gain_);
        overlap_by_radius[n] = quotient_coefficient(cosine_gain_, turn_, overlap_by_radius, n);
        radius_squared_[n] = square_coefficient(radius, n);
        spread_[n] = sine_cosine_[n] + angle_[n];
        attraction[n] = lambda_ * product(outer_squared_, spread_);
        force[n] = product(radius_squared_, radius) - attraction[n];
    }

    /// Computes coefficient n + 1 of what follows the contact radius, from the coefficients 0..n of its
    /// derivative @p rate by the parameter.
    void follow(const Terms& rate, std::size_t n) {
        const auto product = [n](const Terms& x, const Terms& y) { return product_coefficient(x, y, n); };
        const Real factor = Real(1) / static_cast<Real>(n + 1);
        radius_fall_[n] = -rate[n];
        angle_rate_[n] = quotient_coefficient(radius_fall_, turn_, angle_rate_, n);  // d(theta)/da = -1/T
        angle_[n + 1] = factor * angle_rate_[n];
        sine_[n + 1] = factor * product(cosine_, angle_rate_);
        cosine_[n + 1] = -factor * product(sine_, angle_rate_);
        outer_[n + 1] = -factor * product(cosine_m_, angle_rate_);
        swing_[n] = product(angle_cosine_, angle_rate_);
        quadratic_[n + 1] = factor * 2 * lambda_ * product(sine_, swing_);
        linear_[n + 1] = factor * 4 * lambda_ * lambda_ / 3 * swing_[n];
    }

    Terms overlap_by_radius;  ///< d(delta)/da
    Terms force;
    Terms attraction;  ///< a^3 - force

  private:
    template <class, class>
    friend class SeriesOfZone;

    /// Every series; first those of which follow() computes a coefficient more than advance().
    [[nodiscard]] auto all() { return all_of(*this); }
    [[nodiscard]] auto all() const { return all_of(*this); }
    template <class Self>
    [[nodiscard]] static auto all_of(Self& self) {
        return std::array{&self.angle_,
                          &self.outer_,
                          &self.sine_,
                          &self.cosine_,
                          &self.quadratic_,
                          &self.linear_,
                          &self.overlap_by_radius,
                          &self.force,
                          &self.attraction,
                          &self.radius_fall_,
                          &self.angle_rate_,
                          &self.swing_,
                          &self.sine_cosine_,
                          &self.angle_cosine_,
                          &self.outer_squared_,
                          &self.wall_,
                          &self.pull_,
                          &self.numerator_,
                          &self.denominator_,
                          &self.m_,
                          &self.cosine_m_,
                          &self.turn_,
                          &self.gain_,
                          &self.cosine_gain_,
                          &self.radius_squared_,
                          &self.spread_};
    }
    static constexpr std::size_t followers = 6;

    Real lambda_;
    // Each series has the coefficients that advance() and follow() have computed, and no others.
    Terms angle_, outer_, sine_, cosine_, quadratic_, linear_;
    Terms radius_fall_, angle_rate_, swing_, sine_cosine_, angle_cosine_, outer_squared_, wall_, pull_;
    Terms numerator_, denominator_, m_, cosine_m_, turn_, gain_, cosine_gain_;
    Terms radius_squared_, spread_;
};

CohesiveMotion::CohesiveMotion(const CohesiveZone& zone, const ScaledDamping<Extended>& damping,
                               Detachment detachment, Precision precision)
    : zone_(zone),
      touching_(zone, damping, precision),
      gap_(zone),
      begin_(zone.touch()),
      end_(end_of(zone, detachment)),
      fastest_return_(damping.fastest_return) {
    too_slow_ = fastest_return_ * fastest_return_ / 2 + rest().potential < potential_at_end();
    if (detachment != Detachment::zero_overlap) return;
    begin_ = end_;
    outside_ = zone.potential(begin_);
}

RestPlace<Extended> CohesiveMotion::rest() const {
    const CohesiveState equilibrium = zone_.equilibrium();
    return {touching_.coordinate(equilibrium), zone_.overlap(equilibrium), zone_.potential(equilibrium)};
}

std::optional<RestPlace<Extended>> CohesiveMotion::creeps_to(const MotionState<Extended>& state) const {
    const RestPlace<Extended> place = rest();
    if (state.position >= place.position) return std::nullopt;
    const Extended damping = touching_.damping(state.position);
    const Extended rounding = 64 * std::numeric_limits<Extended>::epsilon() * place.overlap;
    const bool rests = state.velocity <= damping * rounding;
    const bool overdamped = zone_.stiffness(zone_.equilibrium()) <= damping * damping / 4;
    if (!rests && !overdamped) return std::nullopt;
    const Extended way = place.overlap - touching_.overlap(state.position);
    const bool arrived = rests && std::abs(way) <= rounding;
    const bool creeps = overdamped && state.velocity <= damping / 2 * way;
    if (!arrived && !creeps) return std::nullopt;
    return place;
}

bool CohesiveMotion::captured(const MotionState<Extended>& state) const {
    if (too_slow_) return true;
    const Extended lacking = potential_at_end() - state.velocity * state.velocity / 2;
    if (lacking <= rest().potential) return false;  // the least potential is enough
    return touching_.potential(state.position) < lacking;
}

std::optional<std::string> cohesive_refusal(const CohesiveZone& zone, Detachment detachment) {
    const std::string subject =
        std::string(name_of(detachment)) + " does not end a contact of law maugis-dugdale";
    if (detachment == Detachment::zero_force)
        return subject +
               ": its potential there is below that at first touch, an undamped impact would gain energy";
    const bool gains =
        detachment == Detachment::load_controlled && zone.overlap(zone.greatest_tension()) > -zone.reach();
    if (!gains) return std::nullopt;
    return subject + " of so long a reach (lambda " + std::to_string(static_cast<double>(zone.lambda())) +
           "): the tension is greatest within the reach of the cohesion, an undamped impact would gain "
           "energy";
}

double maugis_velocity(const ContactPair& contact) {
    return std::sqrt(maugis_units(contact).energy() / contact.mass);
}

TouchingBranch::TouchingBranch(const CohesiveZone& zone, const ScaledDamping<Extended>& damping,
                               Precision precision)
    : zone_(zone), precision_(precision) {
    const Polynomial<Extended> hertz = power<6>(Polynomial<Extended>::identity());
    damping_ = damping.on_branch({hertz, {}});
    per_attraction_ = damping.on_branch({hertz, Polynomial<Extended>(1)}) - damping_;
    follows_attraction_ = per_attraction_ != Polynomial<Extended>();
    rooted_ = !damping_.even() || !per_attraction_.even();
    for (Polynomial<Extended>* p : {&damping_, &per_attraction_}) {
        if (!rooted_) *p = p->of_square();
        powers_.require(*p);
    }
}

Extended TouchingBranch::damping(Extended q) const {
    if (!follows_attraction_) return damping_(q);
    const Extended a = state(q).contact_radius();
    return damping_(q) + per_attraction_(q) * (a * a * a - force(q));
}

Extended TouchingBranch::coordinate(const CohesiveState& state) const {
    const Extended a = state.contact_radius();
    return rooted_ ? std::sqrt(a) : a;
}

CohesiveState TouchingBranch::state(Extended q) const {
    return zone_.at_contact_radius(rooted_ ? q * q : q);
}

Extended TouchingBranch::slope(Extended q) const {
    const CohesiveState at = state(q);
    const CohesiveZone::Slopes slopes = zone_.slopes(at);
    const Extended by_radius = at.cosine * slopes.overlap / slopes.radius;
    return rooted_ ? 2 * q * by_radius : by_radius;
}

/// The equation of motion about a state as series of any parameter: coefficient by coefficient, from those of
/// the position. The first coefficients come from the zone and have its digits, the others those of Real.
template <class Real, class Goal>
class TouchingBranch::Terms {
  public:
    /// Fast enough, the motion hardly feels the contact.
    static constexpr bool time_may_converge_least = true;

    Terms(const TouchingBranch& branch, const CohesiveState& state)
        : branch_(&branch),
          zone_(branch.zone_, state),
          damping_(branch.damping_),
          per_attraction_(branch.per_attraction_) {}
    /// With the leading terms of another number type.
    template <class Other>
    explicit Terms(const Terms<Other, Goal>& other)
        : branch_(other.branch_),
          zone_(other.zone_),
          damping_(branch_->damping_),
          per_attraction_(branch_->per_attraction_) {
        branch_->powers_.copy(other.powers_, powers_, leading_terms);
        copy_terms(other.slope, slope, leading_terms);
        copy_terms(other.damping, damping, leading_terms);
        copy_terms(other.drag, drag, leading_terms);
        copy_terms(other.radius_, radius_, leading_terms);
        copy_terms(other.rate_, rate_, leading_terms);
        if (branch_->follows_attraction_) copy_terms(other.share_, share_, leading_terms);
    }

    /// Computes coefficient @p n; @p position is known up to n.
    void advance(const Series<Real, Goal>& position, std::size_t n) {
        const auto product = [n](const auto& a, const auto& b) { return product_coefficient(a, b, n); };
        const bool rooted = branch_->rooted_;
        radius_[n] = rooted ? square_coefficient(position, n) : position[n];
        zone_.advance(radius_, n);
        slope[n] = rooted ? 2 * product(position, zone_.overlap_by_radius) : zone_.overlap_by_radius[n];
        branch_->powers_.advance(powers_, position, n);
        damping[n] = damping_.composed(powers_, n);
        if (branch_->follows_attraction_) {
            share_[n] = per_attraction_.composed(powers_, n);
            damping[n] += product(share_, zone_.attraction);
        }
        stiffness[n] = product(slope, zone_.force);
        drag[n] = product(slope, damping);
    }
    /// Makes ready for coefficient n + 1: @p velocity, the derivative of the position, is known up to n.
    void follow(const Series<Real, Goal>& position, const Series<Real, Goal>& velocity, std::size_t n) {
        rate_[n] = branch_->rooted_ ? 2 * product_coefficient(position, velocity, n) : velocity[n];
        zone_.follow(rate_, n);
    }
    [[nodiscard]] const Series<Real, Goal>& force() const { return zone_.force; }
    [[nodiscard]] bool damped() const { return !damping_.is_zero() || branch_->follows_attraction_; }

    Series<Real, Goal> slope;      ///< delta'
    Series<Real, Goal> damping;    ///< eta
    Series<Real, Goal> stiffness;  ///< delta' F
    Series<Real, Goal> drag;       ///< delta' eta

  private:
    template <class, class>
    friend class Terms;

    const TouchingBranch* branch_;
    SeriesOfZone<Real, Goal> zone_;
    SparsePolynomial<Real> damping_, per_attraction_;
    PowerSeries<Real, Goal> powers_;
    Series<Real, Goal> radius_;
    Series<Real, Goal> rate_;   ///< of the contact radius
    Series<Real, Goal> share_;  ///< of the attraction in the damping
};

MotionExpansion<Extended> TouchingBranch::expand(const MotionState<Extended>& state, int sense) const {
    return precision_ == Precision::extended ? expanded<Extended>(state, sense)
                                             : expanded<double>(state, sense);
}

template <class Real>
MotionExpansion<Extended> TouchingBranch::expanded(const MotionState<Extended>& start, int sense) const {
    const CohesiveState contact = state(start.position);
    const auto terms_at_start = [&] { return Terms<Real, Real>(*this, contact); };
    const MotionState<Real> begin{static_cast<Real>(start.position), static_cast<Real>(start.velocity),
                                  static_cast<Real>(start.time), static_cast<Real>(start.dissipation)};
    MotionSteps<Terms, Real> steps(begin, *this, contact);
    steps.advance(0, 1);
    const auto widened = [&](const MotionExpansion<Real>& x) {
        MotionExpansion<Extended> digits_of_start;
        digits_of_start.position[0] = start.position;
        digits_of_start.velocity[0] = start.velocity;
        digits_of_start.time[0] = start.time;
        digits_of_start.dissipation[0] = start.dissipation;
        append(x, 1, digits_of_start);
        return digits_of_start;
    };
    if (sense > 0 && may_creep(begin, steps.terms().stiffness[0], steps.terms().drag[0]))
        if (const auto creep = expand_creep(begin, terms_at_start)) return widened(*creep);
    complete_expansion(steps);
    steps.x.step *= sense / (std::numbers::e_v<Real> * std::numbers::e_v<Real>);
    if constexpr (std::is_same_v<Real, Extended>)
        return steps.x;
    else
        return widened(steps.x);
}

TouchingBranch::Statics TouchingBranch::statics(Extended q) const {
    const auto expanded_in = [&]<class Real>() {
        Terms<Real, Extended> terms(*this, state(q));
        Series<Real, Extended> place{};  // q itself
        place[0] = static_cast<Real>(q);
        place[1] = 1;
        Series<Real, Extended> one{};
        one[0] = 1;
        for (std::size_t n = 0; n < place.size(); ++n) {
            terms.advance(place, n);
            if (n + 1 < place.size()) terms.follow(place, one, n);
        }
        Statics statics;
        copy_terms(terms.slope, statics.slope, place.size());
        copy_terms(terms.force(), statics.force, place.size());
        copy_terms(terms.damping, statics.damping, place.size());
        return statics;
    };
    return precision_ == Precision::extended ? expanded_in.template operator()<Extended>()
                                             : expanded_in.template operator()<double>();
}

}  // namespace ashimpact
