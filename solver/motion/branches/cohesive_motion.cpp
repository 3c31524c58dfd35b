// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/branches/cohesive_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/contact/mechanics.hpp"
#include "solver/motion/branches/creep.hpp"

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

/// Radius of convergence, under a name that does not read as a contact radius.
template <class Real>
Extended convergence(const Series<Real>& terms) {
    return static_cast<Extended>(radius(terms));
}

/// The series about @p start, whose first terms keep their digits.
template <class Real>
MotionExpansion<Extended> from_start(const MotionState<Extended>& start, const MotionExpansion<Real>& x,
                                     Extended step) {
    MotionExpansion<Extended> result{};
    const auto take = [](const Series<Real>& series, Extended first, Series<Extended>& to) {
        std::ranges::copy(series, to.begin());
        to[0] = first;
    };
    take(x.position, start.position, result.position);
    take(x.velocity, start.velocity, result.velocity);
    take(x.time, start.time, result.time);
    take(x.dissipation, start.dissipation, result.dissipation);
    result.step = step;
    return result;
}

}  // namespace

/// The static law of a touching state as power series of any parameter, from that of the contact radius:
/// order by order, each new coefficient from those before it. Names as in CohesiveZone. The first
/// coefficients come from the zone and have its digits, the others those of Real.
template <class Real>
class SeriesOfZone {
  public:
    using Terms = Series<Real>;

    SeriesOfZone(const CohesiveZone& zone, const CohesiveState& state)
        : lambda_(static_cast<Real>(zone.lambda())) {
        angle_[0] = static_cast<Real>(state.angle);
        outer_[0] = static_cast<Real>(state.cohesive_radius);
        sine_[0] = static_cast<Real>(std::sin(state.angle));
        cosine_[0] = static_cast<Real>(state.contact_radius() / state.cohesive_radius);
        quadratic_[0] = static_cast<Real>(zone.quadratic(state.angle));
        linear_[0] = static_cast<Real>(zone.linear(state.angle));
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

    Terms overlap_by_radius{};  ///< d(delta)/da
    Terms force{};
    Terms attraction{};  ///< a^3 - force

  private:
    Real lambda_;
    Terms angle_{}, outer_{}, sine_{}, cosine_{}, quadratic_{}, linear_{};
    Terms radius_fall_{}, angle_rate_{}, swing_{}, sine_cosine_{}, angle_cosine_{}, outer_squared_{}, wall_{},
        pull_{};
    Terms numerator_{}, denominator_{}, m_{}, cosine_m_{}, turn_{}, gain_{}, cosine_gain_{};
    Terms radius_squared_{}, spread_{};
};

CohesiveMotion::CohesiveMotion(const CohesiveZone& zone, const ScaledDamping<Extended>& damping,
                               Detachment detachment, Precision precision)
    : zone_(zone),
      touching_(zone, damping, precision),
      gap_(zone),
      begin_(zone.touch()),
      end_(end_of(zone, detachment)) {
    const Extended fastest = damping.fastest_return;
    too_slow_ = fastest * fastest / 2 + rest().potential < potential_at_end();
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
    const Extended way = place.overlap - touching_.overlap(state.position);
    const Extended rounding = 64 * std::numeric_limits<Extended>::epsilon() * place.overlap;
    const bool arrived = std::abs(way) <= rounding && state.velocity <= damping * rounding;
    const bool creeps =
        state.velocity <= damping / 2 * way && zone_.stiffness(zone_.equilibrium()) <= damping * damping / 4;
    if (!arrived && !creeps) return std::nullopt;
    return place;
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
    const Extended by_radius = at.contact_radius() / at.cohesive_radius * slopes.overlap / slopes.radius;
    return rooted_ ? 2 * q * by_radius : by_radius;
}

/// The equation of motion about a state as series of any parameter: coefficient by coefficient, from those of
/// the position. The first coefficients come from the zone and have its digits, the others those of Real.
template <class Real>
class TouchingBranch::Terms {
  public:
    Terms(const TouchingBranch& branch, const CohesiveState& state)
        : branch_(&branch),
          zone_(branch.zone_, state),
          damping_(branch.damping_),
          per_attraction_(branch.per_attraction_) {}

    /// Computes coefficient @p n; @p position is known up to n.
    void advance(const Series<Real>& position, std::size_t n) {
        const auto product = [n](const Series<Real>& a, const Series<Real>& b) {
            return product_coefficient(a, b, n);
        };
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
    void follow(const Series<Real>& position, const Series<Real>& velocity, std::size_t n) {
        rate_[n] = branch_->rooted_ ? 2 * product_coefficient(position, velocity, n) : velocity[n];
        zone_.follow(rate_, n);
    }
    [[nodiscard]] const Series<Real>& force() const { return zone_.force; }

    Series<Real> slope{};      ///< delta'
    Series<Real> damping{};    ///< eta
    Series<Real> stiffness{};  ///< delta' F
    Series<Real> drag{};       ///< delta' eta

  private:
    const TouchingBranch* branch_;
    SeriesOfZone<Real> zone_;
    SparsePolynomial<Real> damping_, per_attraction_;
    PowerSeries<Real> powers_;
    Series<Real> radius_{};
    Series<Real> rate_{};   ///< of the contact radius
    Series<Real> share_{};  ///< of the attraction in the damping
};

MotionExpansion<Extended> TouchingBranch::expand(const MotionState<Extended>& state, int sense) const {
    return precision_ == Precision::extended ? expanded<Extended>(state, sense)
                                             : expanded<double>(state, sense);
}

template <class Real>
MotionExpansion<Extended> TouchingBranch::expanded(const MotionState<Extended>& start, int sense) const {
    const MotionState<Real> begin{.position = static_cast<Real>(start.position),
                                  .velocity = static_cast<Real>(start.velocity)};
    const CohesiveState contact = state(start.position);
    MotionExpansion<Real> x{};
    x.position[0] = begin.position;
    x.velocity[0] = begin.velocity;
    Terms<Real> terms(*this, contact);
    terms.advance(x.position, 0);
    if (sense > 0 && may_creep(begin, terms.stiffness[0], terms.drag[0]))
        if (const auto creep = expand_creep(begin, [&] { return Terms<Real>(*this, contact); }))
            return from_start(start, *creep, static_cast<Extended>(creep->step));
    Series<Real> braking{};  // delta' eta v
    for (std::size_t n = 0; n + 1 < x.position.size(); ++n) {
        terms.advance(x.position, n);
        const Real factor = Real(1) / static_cast<Real>(n + 1);
        braking[n] = product_coefficient(terms.drag, x.velocity, n);
        x.position[n + 1] = factor * x.velocity[n];
        x.velocity[n + 1] = -factor * (terms.stiffness[n] + braking[n]);
        x.time[n + 1] = factor * terms.slope[n];
        x.dissipation[n + 1] = factor * product_coefficient(braking, x.velocity, n);
        terms.follow(x.position, x.velocity, n);
    }
    // Fast enough, the motion hardly feels the contact, and time is the series that converges least. What
    // counts of it is a part of the time that a unit length takes.
    Series<Real> time = x.time;
    time[0] = 1 / (1 + std::abs(x.velocity[0]));
    const Extended within = std::min({convergence(x.position), convergence(x.velocity), convergence(time)});
    return from_start(start, x, sense * within / (std::numbers::e_v<Extended> * std::numbers::e_v<Extended>));
}

TouchingBranch::Statics TouchingBranch::statics(Extended q) const {
    Terms<Extended> terms(*this, state(q));
    Series<Extended> place{};  // q itself
    place[0] = q;
    place[1] = 1;
    Series<Extended> one{};
    one[0] = 1;
    for (std::size_t n = 0; n < place.size(); ++n) {
        terms.advance(place, n);
        if (n + 1 < place.size()) terms.follow(place, one, n);
    }
    return {.slope = terms.slope, .force = terms.force(), .damping = terms.damping};
}

}  // namespace ashimpact
