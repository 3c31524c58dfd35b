// SPDX-License-Identifier: GPL-3.0-or-later
// Maugis-Dugdale impacts against an integration in time that shares neither coordinates nor series.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <doctest/doctest.h>

#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/scale.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/ode.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::oracles {

using test::Random;
using test::relative_difference;

namespace {

/// One Maugis-Dugdale impact in the units of Maugis, mass 1.
struct MaugisCase {
    double lambda;           ///< transition parameter
    DampingLaw damping_law;  ///< acts only where the spheres touch
    double damping;          ///< eta, eta/a or eta/sqrt(a)
    double velocity;         ///< where the surfaces come into reach
    Detachment detachment = Detachment::pull_off;
};

struct MaugisResult {
    bool rebound = false;
    double restitution = 0;
    std::optional<double> contact_time{};
    double maximum_overlap = 0;
};

using Long = long double;
constexpr Long long_pi = std::numbers::pi_v<Long>;

/// A state of the contact, a > 0, by s = sqrt(m^2 - 1).
struct Touching {
    Long radius;
    Long overlap;
    Long force;
};

/// The static law by Maugis' equations: 1 = A a^2 + B a, quadratic in a for given m.
class MaugisLaw {
  public:
    explicit MaugisLaw(Long lambda)
        : lambda_(lambda), reach_(2 / (long_pi * lambda)), gap_fold_(8 * lambda / (3 * long_pi)) {
        // a = 0: 1 = (long_pi/4) lambda c^2 + (4/3) lambda^2 c (long_pi/2 - 1)
        const Long q = 4 * lambda * lambda / 3 * (long_pi / 2 - 1);
        const Long p = long_pi * lambda / 4;
        join_radius_ = (-q + std::sqrt(q * q + 4 * p)) / (2 * p);
        join_overlap_ = -4 * lambda / 3 * join_radius_;
        fold_in_contact_ = gap_fold_ > join_radius_;
        least_overlap_ = gap_overlap(gap_fold_);
        if (!fold_in_contact_) return;
        const auto overlap_at = [&](Long log_s) { return touching(std::exp(log_s)).overlap; };
        const auto fold = boost::math::tools::brent_find_minima(overlap_at, Long(-16), Long(16), 60);
        fold_s_ = std::exp(fold.first);
        least_overlap_ = fold.second;
    }

    [[nodiscard]] Long reach() const { return reach_; }
    [[nodiscard]] Long join_overlap() const { return join_overlap_; }
    [[nodiscard]] bool fold_in_contact() const { return fold_in_contact_; }
    [[nodiscard]] Long least_overlap() const { return least_overlap_; }

    /// The stable state with a > 0 at that overlap.
    [[nodiscard]] Touching touching_at(Long overlap) const {
        const auto excess = [&](Long log_s) { return touching(std::exp(log_s)).overlap - overlap; };
        Long high = fold_in_contact_ ? std::log(fold_s_) : Long(45);
        if (excess(high) >= 0) return touching(std::exp(high));
        Long low = std::min(high, Long(1)) - 1;
        while (excess(low) < 0) {
            high = low;
            low -= 1;
        }
        std::uintmax_t most = 100;
        const auto [a, b] = boost::math::tools::toms748_solve(
            excess, low, high, boost::math::tools::eps_tolerance<Long>(60), most);
        return touching(std::exp((a + b) / 2));
    }
    [[nodiscard]] Long gap_force_at(Long overlap) const {
        const Long c =
            gap_fold_ + std::sqrt(std::max<Long>(0, gap_fold_ * gap_fold_ + 2 * (overlap + reach_)));
        return -long_pi / 2 * lambda_ * c * c;
    }
    /// Force on the stable branch, whichever it is.
    [[nodiscard]] Long force_at(Long overlap) const {
        return fold_in_contact_ || overlap > join_overlap_ ? touching_at(overlap).force
                                                           : gap_force_at(overlap);
    }
    [[nodiscard]] Long overlap_of_greatest_tension() const {
        const auto force_of = [&](Long log_s) { return touching(std::exp(log_s)).force; };
        const Long high = fold_in_contact_ ? std::log(fold_s_) : Long(10);
        return touching(std::exp(boost::math::tools::brent_find_minima(force_of, Long(-16), high, 60).first))
            .overlap;
    }

  private:
    [[nodiscard]] Touching touching(Long s) const {
        const Long m = std::sqrt(1 + s * s);
        const Long theta = std::atan(s);
        const Long a2 = lambda_ / 2 * (s + (m * m - 2) * theta);
        const Long a1 = 4 * lambda_ * lambda_ / 3 * (s * theta - s * s / (m + 1));
        const Long a = 2 / (a1 + std::sqrt(a1 * a1 + 4 * a2));
        return {a, a * a - 4 * lambda_ / 3 * a * s, a * a * a - lambda_ * a * a * (s + m * m * theta)};
    }
    [[nodiscard]] Long gap_overlap(Long c) const { return c * c / 2 - gap_fold_ * c - reach_; }

    Long lambda_;
    Long reach_;
    Long gap_fold_;
    Long join_radius_ = 0;
    Long join_overlap_ = 0;
    bool fold_in_contact_ = false;
    Long fold_s_ = 0;
    Long least_overlap_ = 0;
};

constexpr double maugis_tolerance = 1e-13;

enum class MaugisClock { time, velocity, overlap, root_of_overlap_left };

/// State: time, overlap, velocity.
struct MaugisEquation {
    using State = std::array<double, 3>;
    const MaugisLaw& law;
    const MaugisCase& impact;
    const bool& touching;
    const MaugisClock& clock;
    const double& end;

    State operator()(double x, const State& y) const {
        double overlap = y[1];
        if (clock == MaugisClock::overlap) overlap = x;
        if (clock == MaugisClock::root_of_overlap_left) overlap = end + x * x;
        double force = 0;
        double damping = 0;
        if (touching) {
            const Touching now = law.touching_at(overlap);
            force = static_cast<double>(now.force);
            const auto a = static_cast<double>(now.radius);
            const double repulsion = a * a * a;
            damping = impact.damping * (impact.damping_law == DampingLaw::constant         ? 1
                                        : impact.damping_law == DampingLaw::contact_radius ? a
                                        : impact.damping_law == DampingLaw::tsuji          ? std::sqrt(a)
                                                                                           : repulsion);
        } else {
            force = static_cast<double>(law.gap_force_at(overlap));
        }
        const double acceleration = -(force + damping * y[2]);
        double pace = 1;
        if (clock == MaugisClock::velocity) pace = 1 / acceleration;
        if (clock == MaugisClock::overlap) pace = 1 / y[2];
        if (clock == MaugisClock::root_of_overlap_left) pace = 2 * x / y[2];
        return {pace, pace * y[2], pace * acceleration};
    }
};

class MaugisIntegration {
  public:
    explicit MaugisIntegration(const MaugisCase& impact)
        : impact_(impact),
          law_(impact.lambda),
          ode_(MaugisEquation{law_, impact_, touching_, clock_, end_},
               {maugis_tolerance, {maugis_tolerance, maugis_tolerance, maugis_tolerance * impact.velocity}}) {
    }

    MaugisResult run() {
        const bool from_zero = impact_.detachment == Detachment::zero_overlap;
        MaugisEquation::State now{0, from_zero ? 0 : static_cast<double>(-law_.reach()), impact_.velocity};
        const auto join = static_cast<double>(law_.join_overlap());
        if (!law_.fold_in_contact() && now[1] < join) now = until(MaugisClock::overlap, now[1], join, now);
        touching_ = true;
        now = to_rest(now);
        MaugisResult result{.maximum_overlap = now[1]};
        double last = static_cast<double>(law_.least_overlap());
        if (from_zero) last = 0;
        if (impact_.detachment == Detachment::load_controlled)
            last = static_cast<double>(law_.overlap_of_greatest_tension());
        const bool through_gap = !law_.fold_in_contact() && impact_.detachment == Detachment::pull_off;
        const auto left = outward(now, through_gap ? join : last);
        if (!left) return result;
        now = *left;
        if (through_gap && !across_gap(now, last)) return result;
        result.rebound = true;
        result.restitution = -now[2] / impact_.velocity;
        result.contact_time = now[0];
        return result;
    }

  private:
    MaugisEquation::State until(MaugisClock clock, double from, double to, MaugisEquation::State state) {
        clock_ = clock;
        ode_.integrate(from, to, state);
        clock_ = MaugisClock::time;
        return state;
    }

    /// Inward leg, to the turning point.
    MaugisEquation::State to_rest(MaugisEquation::State now) {
        ode_.restart();
        double stride = 1e-3;
        double t = now[0];
        while (true) {
            const MaugisEquation::State before = now;
            ode_.step(t, 1e9, stride, now);
            now[0] = t;
            if (now[2] <= 0) return until(MaugisClock::velocity, before[2], 0, before);
        }
    }

    /// Outward leg in contact, to the overlap @p last; none where the sphere turns back.
    std::optional<MaugisEquation::State> outward(MaugisEquation::State now, double last) {
        ode_.restart();
        double stride = 1e-3;
        double t = now[0];
        end_ = last;
        while (true) {
            const MaugisEquation::State before = now;
            // Short of the end the law is defined; the stride shrinks where a trial step would leave it.
            ode_.step(t, 1e9, stride, now);
            now[0] = t;
            if (now[1] <= last)
                return until(MaugisClock::root_of_overlap_left, std::sqrt(before[1] - last), 0, before);
            if (now[2] > 0) return std::nullopt;
        }
    }

    /// Outward across the gap, from the join to the fold; false where the energy does not suffice.
    bool across_gap(MaugisEquation::State& now, double last) {
        touching_ = false;
        const double work = static_cast<double>(boost::math::quadrature::gauss_kronrod<Long, 31>::integrate(
            [&](Long s) { return law_.gap_force_at(last + s * s) * 2 * s; }, Long(0),
            std::sqrt(static_cast<Long>(now[1] - last)), 10, 1e-16L));
        if (now[2] * now[2] / 2 + work <= 0) return false;
        end_ = last;
        now = until(MaugisClock::root_of_overlap_left, std::sqrt(now[1] - last), 0, now);
        return true;
    }

    MaugisCase impact_;
    MaugisLaw law_;
    bool touching_ = false;
    MaugisClock clock_ = MaugisClock::time;
    double end_ = 0;
    test::Ode<3, MaugisEquation> ode_;
};

/// Integrates the impact in overlap and velocity over time with GSL (Prince-Dormand 8(9), relative 1e-13).
///
/// The contact force solves Maugis' equations as printed, in m = c/a, for the overlap at hand; the solver's
/// own angle, series and potentials are not used. Turning point, join and break fall on the end of an
/// integration with another clock (Henon, Physica D 5 (1982) 412), in which the fold and the join are smooth.
/// @throws ConvergenceError where GSL gives up
MaugisResult maugis_impact(const MaugisCase& impact) {
    return MaugisIntegration(impact).run();
}

/// The work lost in both jumps without damping, W in units of Maugis, as the integral of -F over the overlap
/// from the fold to -h_0.
double maugis_separation_energy(double lambda) {
    const MaugisLaw law(lambda);
    const Long from = law.least_overlap();
    const auto part = [&](Long low, Long high) {
        return boost::math::quadrature::gauss_kronrod<Long, 61>::integrate(
            [&](Long s) { return -law.force_at(from + s * s) * 2 * s; }, std::sqrt(low - from),
            std::sqrt(high - from), 12, 1e-16L);
    };
    const Long to = -law.reach();
    const Long join = law.join_overlap();
    const bool crosses = !law.fold_in_contact() && join > from && join < to;
    return static_cast<double>(crosses ? part(from, join) + part(join, to) : part(from, to));
}

/// The impact in SI units, of 10 um ash.
Impact in_si(const MaugisCase& c) {
    ContactPair pair{
        .mass = 1.2e-12, .effective_radius = 5e-6, .contact_modulus = 60e9, .work_of_adhesion = 0.25};
    pair.parameters = {{stated_tabor.name, c.lambda / transition_per_tabor()}};
    const double unit = maugis_velocity(pair);
    const Scale scale = Scale::of(pair, unit);
    return {.law = Law::of<MaugisDugdale>(),
            .detachment = c.detachment,
            .damping = {c.damping_law, scale.damping_coefficient(c.damping_law, c.damping)},
            .contact = pair,
            .velocity = c.velocity * unit};
}

MaugisCase random_case(Random& random) {
    constexpr Detachment ends[] = {Detachment::pull_off, Detachment::zero_overlap,
                                   Detachment::load_controlled};
    constexpr DampingLaw one_term[] = {DampingLaw::constant, DampingLaw::contact_radius, DampingLaw::tsuji,
                                       DampingLaw::hunt_crossley};
    MaugisCase c{.lambda = random.log_uniform(0.05, 50.0),
                 .damping_law = one_term[random.below(std::size(one_term))],
                 .damping = random.uniform(0.0, 0.5),
                 .velocity = random.log_uniform(0.5, 50.0),
                 .detachment = ends[random.below(3)]};
    if (cohesive_refusal(CohesiveZone(c.lambda), c.detachment)) c.detachment = Detachment::pull_off;
    return c;
}
}  // namespace

TEST_CASE("200 random Maugis-Dugdale impacts agree with their integration in time to 1e-8") {
    Random random(1992);
    int rebounds = 0;
    int captures = 0;
    for (int i = 0; i < test::repetitions(200); ++i) {
        const MaugisCase c = random_case(random);
        CAPTURE(c.lambda);
        CAPTURE(c.damping);
        CAPTURE(c.velocity);
        CAPTURE(name_of(c.damping_law));
        CAPTURE(name_of(c.detachment));
        const Impact impact = in_si(c);
        const MaugisUnits units = maugis_units(impact.contact);
        const double time = units.overlap / maugis_velocity(impact.contact);
        const ImpactResult solved = solve_impact(impact);
        const MaugisResult integrated = maugis_impact(c);
        REQUIRE((solved.outcome == Outcome::rebound) == integrated.rebound);
        CHECK(relative_difference(solved.maximum_overlap, integrated.maximum_overlap * units.overlap) < 1e-8);
        (integrated.rebound ? rebounds : captures) += 1;
        if (!integrated.rebound) continue;
        CHECK(std::abs(solved.restitution - integrated.restitution) < 1e-8);
        CHECK(relative_difference(*solved.contact_time, *integrated.contact_time * time) < 1e-8);
    }
    CHECK(rebounds >= test::repetitions(200) / 4);
    CHECK(captures >= test::repetitions(200) / 5);
}

TEST_CASE("the work lost in both jumps is the integral of the force from the fold to the reach") {
    for (const double lambda : {0.05, 0.3, 0.65, 0.7, 0.93, 0.95, 2.0, 10.0, 50.0}) {
        CAPTURE(lambda);
        const auto energy = static_cast<double>(CohesiveZone(lambda).separation_energy());
        CHECK(relative_difference(energy, maugis_separation_energy(lambda)) < 1e-12);
    }
}

}  // namespace ashimpact::oracles
