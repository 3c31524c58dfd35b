// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/backward_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "core/text/error.hpp"
#include "solver/motion/legs.hpp"
#include "solver/numeric/gsl/solvers.hpp"

namespace ashimpact {

namespace {

/// Where a critical orbit is followed backward from: at, or just before, the end of contact.
template <class Real>
struct Arrival {
    MotionState<Real> state;
    Real dissipated_after = 0;           ///< work of damping from that state to the end
    std::optional<Real> time_after = 0;  ///< from that state to the end; none if infinite
};

/// Beyond this coordinate, in units of the equilibrium or of the damping length, a backward orbit has
/// escaped. So it has where the coefficients of its series leave the range of numbers, as those of a damping
/// that grows with a high power of the contact radius do before.
constexpr Extended escape = 1e25_ext;

constexpr int backward = -1;  ///< sense of time

/// The turning point of an orbit followed backward in time.
template <class Real>
struct TurnBefore {
    std::optional<MotionState<Real>> state{};  ///< none if the orbit escapes
    bool within_numbers = true;                ///< the orbit escapes while its series still have numbers
};

/// Follows the outward leg on a branch backward in time to its turning point; none if the orbit escapes, so
/// that no velocity is high enough to rebound.
/// @param equilibrium coordinate of static equilibrium
/// @param fastest_return velocity that no return exceeds: a faster one did not begin at rest
/// @throws ConvergenceError
template <class Branch, class Real>
TurnBefore<Real> back_to_turn(const Branch& branch, MotionState<Real> state, Real equilibrium,
                              Real fastest_return) {
    const Real farthest = static_cast<Real>(escape) * std::max({Real(1), equilibrium, state.position});
    const Real too_fast = fastest_return * (1 + 64 * std::numeric_limits<Real>::epsilon());
    int steps = 0;
    while (state.position < farthest && !(-state.velocity > too_fast)) {
        const MotionExpansion<Real> x = counted_expansion(branch, state, steps, backward);
        if (!std::isfinite(x.position.back()) || !std::isfinite(x.velocity.back()))
            return {.within_numbers = false};
        const auto turn = event_within(x, x.step, [](const MotionState<Real>& s) { return -s.velocity; });
        state = x.at(turn.value_or(x.step));
        if (!turn) continue;
        state.velocity = 0;
        return {.state = state};
    }
    return {};
}

/// Follows the inward leg on a branch backward in time to the coordinate @p place; or to rest, where rounding
/// leaves the orbit just short of it. @throws ConvergenceError
template <class Branch, class Real>
MotionState<Real> back_to(const Branch& branch, MotionState<Real> state, Real place) {
    int steps = 0;
    while (true) {
        const MotionExpansion<Real> x = counted_expansion(branch, state, steps, backward);
        const auto rest = event_within(x, x.step, [](const MotionState<Real>& s) { return s.velocity; });
        const Real part = rest.value_or(x.step);
        const auto there = event_within(x, part, way_to(place, Real(-1)));
        state = x.at(there.value_or(part));
        if (there || rest) return state;
    }
}

/// Coefficient of z^power in p(z^2).
template <class Real>
Real coefficient(const Polynomial<Real>& p, int power) {
    const bool present = power >= 0 && power % 2 == 0 && power / 2 <= p.degree;
    return present ? p[power / 2] : 0;
}

/// Integral of z^leading (c_0 + c_1 z + ...) from 0 to @p z.
template <class Real>
Real integral(const Series<Real>& terms, int leading, Real z) {
    Series<Real> integrated = terms;
    for (std::size_t n = 0; n < terms.size(); ++n)
        integrated[n] /= static_cast<Real>(leading + 1 + static_cast<int>(n));
    return value(integrated, z) * std::pow(z, static_cast<Real>(leading + 1));
}

/// The critical orbit just before an end of contact that is a rest point of the regularised motion
/// (delta'(q_end) = 0: zero overlap of DMT, Brach-Dunn and sjkr, the pull-off fold of JKR).
///
/// With z = sqrt(q - q_end) and the speed v it leaves backward along
///
///     v^2/2 = U_end - U + integral of 2 z delta' eta v dz,
///
/// whose solution is a power series in z for every law. Damping may be of the leading order, as in sjkr,
/// whose attraction vanishes as the overlap does. The series gives, each to rounding, the speed, and from it
/// the work of damping and the time up to the end. The time is the integral of 2 z delta'/v dz, none if it
/// diverges.
template <class Real>
class RestPoint {
  public:
    explicit RestPoint(const Motion<Real>& motion)
        : piece_(motion.at(*motion.end)),
          fall_(Real(-1) * piece_.potential.shifted(*motion.end)),
          slope_(piece_.slope.shifted(*motion.end)),
          drag_(piece_.drag.shifted(*motion.end)) {
        fall_[0] = 0;                         // U_end - U at the end itself
        fall_[1] = slope_[0] = drag_[0] = 0;  // delta' = 0 there
        order_ = leading_power();
        expand_speed();
        expand_time();
    }

    /// The orbit where its series still hold to rounding.
    [[nodiscard]] Arrival<Real> arrival(Real end) const {
        const Real within = radius(speed_) / (std::numbers::e_v<Real> * std::numbers::e_v<Real>);
        const Real z = std::min(within, std::sqrt(piece_.until - end));
        Arrival<Real> arrival;
        arrival.state.position = end + z * z;
        arrival.state.velocity = -std::pow(z, static_cast<Real>(order_)) * value(speed_, z);
        arrival.dissipated_after = integral(work_, order_ + 1 + 2 * drag_.lowest(), z);
        // The time is infinite if the speed vanishes as the overlap does, or faster.
        if (time_order() < 0)
            arrival.time_after = std::nullopt;
        else
            arrival.time_after = integral(pace_, time_order(), z);
        return arrival;
    }

  private:
    [[nodiscard]] int time_order() const { return 1 + 2 * slope_.lowest() - order_; }

    /// Leading power of the speed v in z. In the energy equation U_end - U goes as z^(2 l), the work of
    /// damping at a speed z^p as z^(p + 2 + 2 g), if U_end - U is led by q^l and delta' eta by q^g.
    [[nodiscard]] int leading_power() const {
        const int by_force = fall_.lowest();
        const bool damped = drag_[drag_.lowest()] != 0;
        return damped ? std::min(by_force, 2 + 2 * drag_.lowest()) : by_force;
    }

    /// v = z^order (c_0 + c_1 z + ...) from the energy equation, term by term. If damping is of the leading
    /// order too, c_0 solves c_0^2 = 2 f + 2 d c_0, and each c_n is on both sides.
    void expand_speed() {
        const Real drag = coefficient(drag_, order_ - 2);
        const Real damped = drag / static_cast<Real>(order_);
        speed_[0] = drag == 0 ? std::sqrt(2 * fall_[order_])
                              : damped + std::sqrt(damped * damped + 2 * fall_[order_]);
        for (std::size_t n = 1; n < speed_.size(); ++n) {
            const int power = static_cast<int>(n) + 2 * order_;
            Real square = 2 * coefficient(fall_, power);
            for (int j = 0; j < static_cast<int>(n); ++j)
                square += 4 * coefficient(drag_, power - 2 - order_ - j) *
                          speed_[static_cast<std::size_t>(j)] / static_cast<Real>(power);
            for (std::size_t i = 1; i < n; ++i) square -= speed_[i] * speed_[n - i];
            speed_[n] = square / (2 * speed_[0] - 4 * drag / static_cast<Real>(power));
        }
    }

    /// Work of damping and time over dz: 2 z delta' eta v and 2 z delta'/v, without their leading powers.
    void expand_time() {
        const int slope_power = 2 * slope_.lowest();
        const int drag_power = 2 * drag_.lowest();
        for (std::size_t n = 0; n < speed_.size(); ++n) {
            Real pace = 2 * coefficient(slope_, slope_power + static_cast<int>(n));
            for (std::size_t i = 0; i < n; ++i) {
                pace -= pace_[i] * speed_[n - i];
                work_[n] += 2 * coefficient(drag_, drag_power + static_cast<int>(n - i)) * speed_[i];
            }
            pace_[n] = pace / speed_[0];
            work_[n] += 2 * coefficient(drag_, drag_power) * speed_[n];
        }
    }

    const MotionPiece<Real>& piece_;  ///< that holds the end
    Polynomial<Real> fall_;           ///< U_end - U
    Polynomial<Real> slope_;          ///< delta'
    Polynomial<Real> drag_;           ///< delta' eta
    int order_ = 0;                   ///< leading power of the speed in z
    Series<Real> speed_{};
    Series<Real> work_{};
    Series<Real> pace_{};
};

/// Hertz with constant damping beta: the critical orbit arrives along v = -beta x + (2/(3 beta)) F(x), where
/// x is the overlap beyond the end; slower and slower, it never gets there.
template <class Real>
Arrival<Real> at_damped_end(const Motion<Real>& motion) {
    const Polynomial<Real>& overlap = motion.at(*motion.end).overlap;
    const Real beta = motion.damping(0);
    const int power = overlap.degree;
    const Real x = static_cast<Real>(1e-12_ext) * std::pow(beta, Real(4));
    Arrival<Real> arrival;
    arrival.state.position = std::pow(x / overlap[power], Real(1) / static_cast<Real>(power));
    arrival.state.velocity = -beta * x + 2 / (3 * beta) * motion.force(arrival.state.position);
    arrival.dissipated_after = beta * beta * x * x / 2;
    arrival.time_after = std::nullopt;
    return arrival;
}

/// The orbit that arrives at the end of contact with no velocity left; none if no orbit does. Without
/// adhesion there is one only if the damping does not vanish with the contact radius.
template <class Real>
std::optional<Arrival<Real>> critical_arrival(const Motion<Real>& motion) {
    const bool adhesive = motion.equilibrium > *motion.end;
    const bool rests =  // whether the end of contact is a rest point of the regularised motion
        std::abs(motion.slope(*motion.end)) <=
        static_cast<Real>(1e-12_ext) * std::abs(motion.slope(motion.equilibrium));
    if (adhesive && rests) return RestPoint<Real>(motion).arrival(*motion.end);
    if (adhesive) return Arrival<Real>{.state = {.position = *motion.end}};
    const Polynomial<Real>& damping = motion.at(*motion.end).damping;
    if (!(damping[0] > 0)) return std::nullopt;
    return damping.degree == 0 ? at_damped_end(motion) : RestPoint<Real>(motion).arrival(*motion.end);
}

/// The critical impact of an orbit followed backward from @p arrival to the state @p touch at first touch.
template <class Real>
CriticalImpact critical_impact(const Arrival<Real>& arrival, const MotionState<Real>& touch, Extended plastic,
                               Extended break_energy, Extended maximum_overlap) {
    CriticalImpact impact{.dissipated = static_cast<Extended>(arrival.dissipated_after - touch.dissipation),
                          .plastic = plastic,
                          .break_energy = break_energy,
                          .contact_time = std::nullopt,
                          .maximum_overlap = maximum_overlap};
    impact.velocity = std::sqrt(2 * (impact.dissipated + plastic + break_energy));
    if (arrival.time_after) impact.contact_time = static_cast<Extended>(*arrival.time_after - touch.time);
    return impact;
}

/// The critical orbit near the fold of the touching branch, where delta'(q) = 0: v is a power series of
/// x = q - q_fold with v dv/dx = -delta' (eta v + F), the root that arrives (v < 0 for x > 0).
class FoldArrival {
    using Terms = Series<Extended>;

  public:
    FoldArrival(const TouchingBranch& branch, Extended fold) : statics_(branch.statics(fold)) {
        statics_.slope[0] = 0;
        // v_1^2 = -delta''(fold) F(fold)
        velocity_[1] = -std::sqrt(-statics_.slope[1] * statics_.force[0]);
        total_[0] = statics_.force[0];
        for (std::size_t n = 2; n < velocity_.size(); ++n) {
            total_[n - 1] = statics_.force[n - 1] + product_coefficient(statics_.damping, velocity_, n - 1);
            Extended rest = -product_coefficient(statics_.slope, total_, n);  // total_[n] meets slope[0] = 0
            for (std::size_t i = 2; i < n; ++i)
                rest -= static_cast<Extended>(n + 1) / 2 * velocity_[i] * velocity_[n + 1 - i];
            velocity_[n] = rest / (static_cast<Extended>(n + 1) * velocity_[1]);
        }
    }

    /// The orbit where its series still hold to rounding.
    [[nodiscard]] Arrival<Extended> arrival(Extended fold) const {
        const Extended e = std::numbers::e_v<Extended>;
        const Extended x = convergence() / (e * e);
        Arrival<Extended> arrival;
        arrival.state.position = fold + x;
        arrival.state.velocity = value(velocity_, x);
        // From x to the fold: work of eta v over d(delta), time of d(delta)/v.
        Terms drag{};
        Terms work{};
        Terms pace{};
        for (std::size_t n = 0; n + 1 < velocity_.size(); ++n) {
            drag[n] = product_coefficient(statics_.damping, velocity_, n);
            work[n + 1] = -product_coefficient(drag, statics_.slope, n) / static_cast<Extended>(n + 1);
        }
        Terms quotient{};  // delta'/v, both without their leading power
        for (std::size_t n = 0; n + 1 < velocity_.size(); ++n) {
            Extended rest = statics_.slope[n + 1];
            for (std::size_t k = 0; k < n; ++k) rest -= quotient[k] * velocity_[n - k + 1];
            quotient[n] = rest / velocity_[1];
            pace[n + 1] = -quotient[n] / static_cast<Extended>(n + 1);
        }
        arrival.dissipated_after = value(work, x);
        arrival.time_after = value(pace, x);
        return arrival;
    }

  private:
    [[nodiscard]] Extended convergence() const {
        Terms pace{};  // without the leading zero, which has no bearing on the radius
        std::copy(velocity_.begin() + 1, velocity_.end(), pace.begin());
        pace.back() = velocity_.back() / radius(statics_.slope);
        return std::min({radius(pace), radius(statics_.slope), radius(statics_.force)});
    }

    TouchingBranch::Statics statics_;
    Terms velocity_{};
    Terms total_{};
};

/// The critical orbit in the gap at cohesive radius @p c: its speed, and the time it takes to rest at the
/// fold of the gap branch, c_f. With U(c_f) - U(c) = (pi lambda/8) (c - c_f)^2 (c^2 + 2 c c_f/3 + c_f^2/3),
/// free of cancellation, the integral of delta'(c)/v is an arsinh.
Arrival<Extended> gap_arrival(const CohesiveZone& zone, Extended c) {
    const Extended fold = zone.pull_off().cohesive_radius;
    const Extended strength = std::numbers::pi_v<Extended> * zone.lambda() / 4;
    const auto primitive = [&](Extended x) {
        return std::asinh((3 * x + fold) / (std::numbers::sqrt2_v<Extended> * fold));
    };
    return {.state = {.velocity = -(c - fold) * std::sqrt(strength * (c * c + fold * (2 * c + fold) / 3))},
            .time_after = (primitive(c) - primitive(fold)) / std::sqrt(strength)};
}

/// The orbit just before the end of contact, on the touching branch.
Arrival<Extended> arrival_of(const CohesiveMotion& motion) {
    const TouchingBranch& branch = motion.touching();
    const CohesiveState& end = motion.end();
    if (!end.touching()) {
        const CohesiveState join = motion.zone().join();
        Arrival<Extended> arrival = gap_arrival(motion.zone(), join.cohesive_radius);
        arrival.state.position = branch.coordinate(join);
        return arrival;
    }
    const Extended place = branch.coordinate(end);
    if (end.angle == motion.zone().pull_off().angle) return FoldArrival(branch, place).arrival(place);
    return {.state = {.position = place}};
}

/// Ratio of successive greatest contacts (in u) searched for a change of verdict.
constexpr double scan_ratio = 1.02;

/// The arrival at rest after unloading from a greatest contact.
struct Unloading {
    Motion<Extended> motion;
    std::optional<Arrival<Extended>> arrival{};
    std::optional<MotionState<Extended>> turn{};
};

/// The arrival of an impact that turns at @p u, with work and time counted from there.
Arrival<Extended> arrival_from(const Unloading& unloading, double u) {
    const Motion<Extended>& motion = unloading.motion;
    constexpr double near = 1e-9;
    const auto& turn = unloading.turn;
    if (turn && std::abs(motion.root_radius(turn->position) / u - 1) < near) {
        Arrival<Extended> arrival = *unloading.arrival;
        arrival.dissipated_after -= turn->dissipation;
        if (arrival.time_after) *arrival.time_after -= turn->time;
        return arrival;
    }
    // Damping draws the orbits together until backward they either turn far below u or escape. Forward they
    // are the same orbit, whose work is the fall of the potential.
    const MotionState<Extended> start{.position = motion.coordinate(u)};
    Orbit<Extended> orbit;
    const Unobserved unobserved;
    Legs(orbit, unobserved).rebound(motion, start, CaptureTest<Extended>(motion));
    return {.state = orbit.end,
            .dissipated_after = motion.potential(start.position) - motion.potential(*motion.end),
            .time_after = orbit.end.time};
}

class PlasticCapture {
  public:
    explicit PlasticCapture(const PlasticMotion<Extended>& motion) : motion_(motion) {}

    /// How far beyond the greatest contact @p u the orbit that just arrives at the end would have to turn:
    /// positive if an impact that turns at u is captured, negative if it rebounds.
    [[nodiscard]] double margin(double u) const {
        const Unloading unloading = from(u);
        if (!unloading.arrival) return motion_.elastic().overdamped ? 1.0 : -1.0;
        if (!unloading.turn) return 1.0;
        return static_cast<double>(unloading.motion.root_radius(unloading.turn->position) / u - 1);
    }

    /// The impact that turns at @p u and arrives at the end at rest.
    [[nodiscard]] CriticalImpact impact_through(double u) const {
        const Unloading unloading = from(u);
        const Motion<Extended>& loading = motion_.loading();
        const Motion<Extended>& elastic = motion_.elastic();
        const Extended yield = motion_.yield();
        MotionState<Extended> state{.position = loading.coordinate(u)};
        Extended plastic_work = 0;
        if (u > yield) {
            state = back_to(loading, state, loading.coordinate(yield));
            plastic_work =
                motion_.loading_potential(u) - unloading.motion.potential(unloading.motion.coordinate(u));
        }
        if (!motion_.yields_at_touch()) {
            state.position = elastic.coordinate(std::min<Extended>(yield, u));
            state = back_to(elastic, state, elastic.touch);
        }
        return critical_impact(arrival_from(unloading, u), state, plastic_work,
                               unloading.motion.potential(*unloading.motion.end) - motion_.touch_potential(),
                               loading.overlap(loading.coordinate(u)));
    }

  private:
    [[nodiscard]] Unloading from(double u) const {
        Unloading unloading{u > motion_.yield() ? motion_.unloading(u) : motion_.elastic()};
        unloading.arrival = critical_arrival(unloading.motion);
        if (unloading.arrival)
            unloading.turn = back_to_turn(unloading.motion, unloading.arrival->state,
                                          unloading.motion.equilibrium, unloading.motion.fastest_return)
                                 .state;
        return unloading;
    }

    const PlasticMotion<Extended>& motion_;
};

/// Every greatest contact, in u, at which captured and rebounding impacts meet, ascending.
std::vector<double> critical_contacts(const PlasticCapture& capture, double yield, double farthest) {
    std::vector<double> contacts;
    double lower = yield;
    double margin = capture.margin(lower);
    if (margin < 0.0 && margin > -1.0) contacts.push_back(lower * (1.0 + margin));  // on the elastic branch
    while (lower < farthest) {
        const double u = lower * scan_ratio;
        const double next = capture.margin(u);
        if ((next > 0.0) != (margin > 0.0))
            contacts.push_back(gsl::brent([&](double x) { return capture.margin(x); }, lower, u).root);
        lower = u;
        margin = next;
    }
    return contacts;
}

}  // namespace

template <class Real>
CriticalImpacts critical_impacts(const Motion<Real>& motion) {
    const std::optional<Arrival<Real>> arrival = critical_arrival(motion);
    if (!arrival) return {.verdict = CaptureVerdict::never_captured};
    const auto [turn, certain] =
        back_to_turn(motion, arrival->state, motion.equilibrium, motion.fastest_return);
    if (!turn) return {.verdict = CaptureVerdict::always_captured, .certain = certain};
    return {.impacts = {critical_impact(*arrival, back_to(motion, *turn, motion.touch), 0,
                                        motion.potential(*motion.end) - motion.potential(motion.touch),
                                        motion.overlap(turn->position))}};
}

template CriticalImpacts critical_impacts(const Motion<double>&);
template CriticalImpacts critical_impacts(const Motion<long double>&);

CriticalImpacts critical_impacts(const CohesiveMotion& motion) {
    const TouchingBranch& branch = motion.touching();
    const Arrival<Extended> arrival = arrival_of(motion);
    const auto [turn, certain] =
        back_to_turn(branch, arrival.state, motion.rest().position, motion.fastest_return());
    if (!turn) return {.verdict = CaptureVerdict::always_captured, .certain = certain};
    const bool begins_in_gap = !motion.begin().touching();
    const CohesiveState first = begins_in_gap ? motion.zone().join() : motion.begin();
    MotionState<Extended> state = back_to(branch, *turn, branch.coordinate(first));
    if (begins_in_gap) {
        state.position = first.cohesive_radius;
        state = back_to(motion.gap(), state, motion.begin().cohesive_radius);
    }
    return {.impacts = {critical_impact(arrival, state, 0,
                                        motion.potential_at_end() - motion.potential_at_begin(),
                                        branch.overlap(turn->position))}};
}

CriticalImpacts critical_impacts(const PlasticMotion<Extended>& motion, Extended farthest) {
    const PlasticCapture capture(motion);
    const Motion<Extended>& loading = motion.loading();
    const auto yield = static_cast<double>(motion.yield());
    double farthest_contact = yield;
    while (loading.overlap(loading.coordinate(farthest_contact)) < farthest) farthest_contact *= scan_ratio;
    CriticalImpacts found;
    for (const double u : critical_contacts(capture, yield, farthest_contact)) {
        try {
            found.impacts.push_back(capture.impact_through(u));
        } catch (const ConvergenceError&) {  // reached at damping numbers of millions alone
            found.impacts.emplace_back().velocity = std::numeric_limits<Extended>::infinity();
        }
    }
    if (found.impacts.empty())
        found.verdict =
            capture.margin(yield) > 0.0 ? CaptureVerdict::always_captured : CaptureVerdict::never_captured;
    return found;
}

}  // namespace ashimpact
