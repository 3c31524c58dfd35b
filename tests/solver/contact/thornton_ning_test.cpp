// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic-plastic law against its closed form without adhesion, and against quadratures of its branches,
// written in SI units from docs/laws/thornton-ning.md.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/trajectory.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/quadrature.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr double pi = std::numbers::pi;

ContactPair yielding_ash(double w, double yield_pressure) {
    ContactPair pair = ash(w);
    pair.yield_pressure = yield_pressure;
    return pair;
}

Impact undamped(const ContactPair& pair, double velocity, Law law = Law::of<ThorntonNing>(),
                Detachment detachment = Detachment::pull_off) {
    return {law, detachment, {DampingLaw::constant, 0.0}, pair, velocity};
}

/// Thornton & Ning 1998: restitution at velocity V without adhesion, r = V_y/V <= 1.
double closed_form(double r) {
    const double s = r * r;
    return std::sqrt(6.0 * std::sqrt(3.0) / 5.0) * std::sqrt(1.0 - s / 6.0) *
           std::pow(r / (r + 2.0 * std::sqrt(6.0 / 5.0 - s / 5.0)), 0.25);
}

/// The end of what is below, by bisection: @p is_below holds at @p lower and not at @p upper.
double bisected(double lower, double upper, const std::function<bool(double)>& is_below) {
    for (int i = 0; i < 200; ++i) {
        const double middle = (lower + upper) / 2.0;
        (is_below(middle) ? lower : upper) = middle;
    }
    return lower;
}

/// The branches of a yielded contact in SI units, as functions of contact radius.
struct Branches {
    ContactPair pair;

    [[nodiscard]] double stiffness() const { return 4.0 / 3.0 * pair.contact_modulus; }  // K
    /// Tension of the flat punch, sqrt(2 w E*/(pi a)) [Pa].
    [[nodiscard]] double punch(double a) const {
        return std::sqrt(2.0 * pair.work_of_adhesion * pair.contact_modulus / (pi * a));
    }
    [[nodiscard]] double overlap(double a) const {
        return a * a / pair.effective_radius -
               std::sqrt(2.0 * pi * pair.work_of_adhesion * a / pair.contact_modulus);
    }
    [[nodiscard]] double slope(double a) const {
        return 2.0 * a / pair.effective_radius -
               std::sqrt(pi * pair.work_of_adhesion / (2.0 * pair.contact_modulus * a));
    }
    [[nodiscard]] double adhesive(double a) const {
        return std::sqrt(8.0 * pi * pair.work_of_adhesion * pair.contact_modulus * a * a * a);
    }
    [[nodiscard]] double central_pressure(double a) const {
        return 2.0 * pair.contact_modulus * a / (pi * pair.effective_radius) - punch(a);
    }
    /// Contact radius at which the pressure in the centre is p_y.
    [[nodiscard]] double yield_radius() const {
        return bisected(0.0, pair.effective_radius,
                        [&](double a) { return central_pressure(a) < pair.yield_pressure; });
    }
    /// Contact radius at first touch, zero overlap.
    [[nodiscard]] double touch_radius() const {
        const double r = pair.effective_radius;
        return std::cbrt(2.0 * pi * pair.work_of_adhesion * r * r / pair.contact_modulus);
    }
    /// Hertz part of the force: elastic up to yield, then p_y and the punch's tension on each further ring.
    [[nodiscard]] double hertz_part(double a) const {
        const double yield = yield_radius();
        const double elastic = stiffness() * std::pow(std::min(a, yield), 3) / pair.effective_radius;
        if (a <= yield) return elastic;
        // The ring's area is d(pi a^2); the punch integrates to (4/3) sqrt(2 pi w E*) a^(3/2).
        const double rings = pi * pair.yield_pressure * (a * a - yield * yield);
        const double punch_part = 4.0 / 3.0 *
                                  std::sqrt(2.0 * pi * pair.work_of_adhesion * pair.contact_modulus) *
                                  (std::pow(a, 1.5) - std::pow(yield, 1.5));
        return elastic + rings + punch_part;
    }
    /// Work to load from first touch to contact radius a, to 1e-13 of @p size [J].
    [[nodiscard]] double loading_work(double a, double size) const {
        const auto power = [&](double x) { return (hertz_part(x) - adhesive(x)) * slope(x); };
        const double touch = touch_radius();
        const double yield = std::clamp(yield_radius(), touch, a);
        const double elastic = yield > touch ? integral(power, touch, yield, size) : 0.0;
        return elastic + (a > yield ? integral(power, yield, a, size) : 0.0);
    }
    /// Radius R_p of the sphere flattened by loading to a [m].
    [[nodiscard]] double flattened_radius(double a) const { return stiffness() * a * a * a / hertz_part(a); }
    /// Work given back on unloading from a to the fold of the flattened sphere [J].
    [[nodiscard]] double unloading_work(double a, double size) const {
        const double flattened = flattened_radius(a);
        const double fold = std::cbrt(pi * pair.work_of_adhesion * flattened * flattened / stiffness() / 6.0);
        return unloading_work(a, fold, size);
    }
    /// The same from a to the contact radius @p to [J]; the potential where that is none.
    [[nodiscard]] double unloading_work(double a, double to, double size) const {
        const double flattened = flattened_radius(a);
        return integral(
            [&](double x) {
                const double rate = 2.0 * x / flattened -
                                    std::sqrt(pi * pair.work_of_adhesion / (2.0 * pair.contact_modulus * x));
                return (stiffness() * x * x * x / flattened - adhesive(x)) * rate;
            },
            to, a, size);
    }
    /// Contact radius beyond yield and touch at which the loading branch carries no force.
    [[nodiscard]] double loading_equilibrium() const {
        const double least = std::max(touch_radius(), yield_radius());
        return bisected(least, 1e3 * least, [&](double a) { return hertz_part(a) < adhesive(a); });
    }
    /// Contact radius of an overlap on the loading branches.
    [[nodiscard]] double radius_of(double target) const {
        return bisected(touch_radius(), pair.effective_radius, [&](double a) { return overlap(a) < target; });
    }
};

/// Ammonium fluorescein on silicon (Wall et al. 1990, constants as in Pasha et al. 2014).
ContactPair ammonium_fluorescein() {
    const double radius = 2.45e-6;
    return {.mass = sphere_mass(radius, 1350.0),
            .effective_radius = radius,
            .contact_modulus = contact_modulus({1.2e9, 0.3}, ElasticBody{182e9, 0.3}),
            .work_of_adhesion = 0.2,
            .yield_pressure = 35.3e6};
}

}  // namespace

TEST_CASE("the yield velocity is (pi^2/sqrt40) (p_y^5/(E*^4 rho))^(1/2); without a yield pressure none") {
    const ContactPair pair = yielding_ash(0.0, 2e9);
    const double expected =
        pi * pi / std::sqrt(40.0) * std::sqrt(std::pow(2e9, 5) / (std::pow(90e9, 4) * 2600));
    CHECK(relative_difference(yield_velocity(pair), expected) < 1e-14);
    CHECK(std::isinf(yield_velocity(ash(0.0))));
    CHECK(!solve_impact(undamped(pair, 0.999999 * expected)).yielded);
    CHECK(solve_impact(undamped(pair, 1.000001 * expected)).yielded);
    CHECK(solve_impact(undamped(pair, 0.999999 * expected)).restitution == 1.0);
}

TEST_CASE("without adhesion restitution is Thornton & Ning's closed form in V_y/V") {
    Worst worst;
    for (const double yield_pressure : {3e8, 2e9, 8e9}) {
        const ContactPair pair = yielding_ash(0.0, yield_pressure);
        for (const double ratio : {1.0001, 1.01, 1.5, 3.0, 10.0, 100.0, 3000.0}) {
            const Impact impact = undamped(pair, ratio * yield_velocity(pair));
            worst.see(relative_difference(solve_impact(impact).restitution, closed_form(1.0 / ratio)),
                      describe(impact));
        }
    }
    CHECK(worst.count() == 21);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
    // Far beyond yield e -> 1.185 (V_y/V)^(1/4).
    const ContactPair pair = yielding_ash(0.0, 2e9);
    const double far = solve_impact(undamped(pair, 1e8 * yield_velocity(pair))).restitution;
    CHECK(std::abs(far * 100.0 - 1.185) < 5e-4);
}

TEST_CASE("a contact that never yields is JKR's") {
    Worst worst;
    for (const ContactCase& c : elastic_cases()) {
        if (c.law != Law::of<ThorntonNing>()) continue;
        ContactCase jkr = c;
        jkr.law = Law::of<Jkr>();
        for (const double yield_pressure : {std::numeric_limits<double>::infinity(), 1e13}) {
            for (const double number : damping_numbers) {
                Impact impact = impact_of(c, ash(0.3), number, 2.0);
                impact.contact.yield_pressure = yield_pressure;
                const ImpactResult a = solve_impact(impact);
                const ImpactResult b = solve_impact(impact_of(jkr, ash(0.3), number, 2.0));
                CHECK(!a.yielded);
                CHECK(a.energy.plastic == 0.0);
                worst.see(std::abs(a.restitution - b.restitution), describe(impact));
                worst.see(relative_difference(*a.contact_time, *b.contact_time), describe(impact));
                worst.see(relative_difference(a.maximum_overlap, b.maximum_overlap), describe(impact));
            }
        }
    }
    CHECK(worst.count() > 100);
    CHECK_MESSAGE(worst.deviation() < 1e-15, worst.where());
}

TEST_CASE("with adhesion: kinetic energy, plastic work and rebound are quadratures of the branches") {
    Worst loading;
    Worst rebound;
    Worst plastic;
    std::vector<Impact> impacts;
    for (const double w : ash_adhesions) {
        for (const double v : {1.5, 4.0, 30.0}) impacts.push_back(undamped(yielding_ash(w, 2e9), v));
    }
    for (const double v : {2.0, 3.0, 12.0}) impacts.push_back(undamped(ammonium_fluorescein(), v));
    for (const Impact& impact : impacts) {
        const ImpactResult result = solve_impact(impact);
        CAPTURE(describe(impact));
        REQUIRE(result.yielded);
        REQUIRE(result.outcome == Outcome::rebound);
        const Branches branches{impact.contact};
        const double kinetic = 0.5 * impact.contact.mass * impact.velocity * impact.velocity;
        const double a = branches.radius_of(result.maximum_overlap);
        const double loaded = branches.loading_work(a, kinetic);
        const double unloaded = branches.unloading_work(a, kinetic);
        loading.see(relative_difference(loaded, kinetic), describe(impact));
        rebound.see(std::abs(unloaded / kinetic - result.restitution * result.restitution), describe(impact));
        // Ledger: all that is not kinetic or potential any more.
        const double lost =
            kinetic + result.energy.at_touch - result.energy.remaining - result.energy.potential;
        plastic.see(std::abs(lost - result.energy.plastic) / kinetic, describe(impact));
    }
    CHECK_MESSAGE(loading.deviation() < 1e-12, loading.where());
    CHECK_MESSAGE(rebound.deviation() < 1e-12, rebound.where());
    CHECK_MESSAGE(plastic.deviation() < 1e-14, plastic.where());
}

TEST_CASE("plastic work is never negative and restitution never above JKR's") {
    Random random(1999);
    const int times = repetitions(2000);
    int yielded = 0;
    for (int i = 0; i < times; ++i) {
        ContactPair pair = random_pair(random);
        const double velocity = random.log_uniform(1e-3, 1e3);
        const double elastic = solve_impact(undamped(pair, velocity, Law::of<Jkr>())).restitution;
        pair.yield_pressure = pair.contact_modulus * random.log_uniform(1e-3, 0.3);
        const ImpactResult result = solve_impact(undamped(pair, velocity));
        CAPTURE(describe(undamped(pair, velocity)));
        CHECK(result.energy.plastic >= 0.0);
        CHECK(result.restitution <= elastic);
        CHECK(std::abs(result.energy.residual) <
              1e-10 * std::max(result.energy.incident, std::abs(result.energy.minimum)));
        yielded += result.yielded ? 1 : 0;
    }
    CHECK(yielded > times / 4);
}

TEST_CASE("restitution rises from capture by adhesion and falls past yield") {
    const ContactPair pair = yielding_ash(0.3, 2e9);
    const double critical =
        *critical_velocity({Law::of<ThorntonNing>(), Detachment::pull_off, {}, pair}).value;
    const auto e = [&](double v) { return solve_impact(undamped(pair, v)).restitution; };
    CHECK(e(0.99 * critical) == 0.0);
    CHECK(e(2.0 * critical) > 0.8);
    CHECK(e(0.5) > e(2.0 * critical));
    CHECK(e(2.0) < e(0.5));
    CHECK(e(20.0) < e(2.0));
}

TEST_CASE(
    "landmark: ammonium fluorescein on silicon sticks below 1.82 m/s here, about 1.6 measured, elastic "
    "0.57") {
    const ContactPair pair = ammonium_fluorescein();
    const CriticalVelocity plastic =
        critical_velocity({Law::of<ThorntonNing>(), Detachment::pull_off, {}, pair});
    const CriticalVelocity elastic = critical_velocity({Law::of<Jkr>(), Detachment::pull_off, {}, pair});
    CHECK(std::abs(*plastic.value - 1.82) < 0.005);
    CHECK(std::abs(*elastic.value - 0.57) < 0.005);
    CHECK(plastic.plastic > 0.0);
    // It yields by adhesion alone, between first touch and the static equilibrium of JKR.
    CHECK(Branches{pair}.yield_radius() > Branches{pair}.touch_radius());
    CHECK(Branches{pair}.yield_radius() < std::cbrt(2.25) * Branches{pair}.touch_radius());
}

TEST_CASE("a trajectory goes through yield and turn without a jump") {
    for (const ContactCase& c : yielding_cases()) {
        const Impact impact = impact_of(c, ash(0.3), 0.1, 4.0);
        const ImpactResult result = solve_impact(impact);
        CAPTURE(describe(impact));
        REQUIRE(result.yielded);
        const auto path = trajectory(impact, 4001);
        CHECK(relative_difference(path.back().time, *result.contact_time) < 1e-14);
        CHECK(relative_difference(path.back().velocity, -result.rebound_velocity) < 1e-13);
        double greatest = 0.0;
        double force_scale = 0.0;
        double jump = 0.0;
        double radius_jump = 0.0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            greatest = std::max(greatest, path[i].overlap);
            force_scale = std::max(force_scale, path[i].repulsive_force);
            CHECK(path[i].repulsive_force >= 0.0);
            CHECK(path[i].attractive_force <= 0.0);
            if (i == 0) continue;
            const auto force = [](const TrajectoryPoint& p) {
                return p.repulsive_force + p.attractive_force;
            };
            jump = std::max(jump, std::abs(force(path[i]) - force(path[i - 1])));
            if (i + 40 < path.size()) {  // the neck collapses fast at the end
                radius_jump =
                    std::max(radius_jump, std::abs(path[i].contact_radius - path[i - 1].contact_radius));
            }
        }
        CHECK(greatest <= result.maximum_overlap * (1.0 + 1e-15));
        CHECK(relative_difference(greatest, result.maximum_overlap) < 1e-6);
        CHECK(jump < 5e-3 * force_scale);
        CHECK(radius_jump < 2e-2 * std::sqrt(result.maximum_overlap * impact.contact.effective_radius));
    }
}

TEST_CASE("so damped that it never turns, a yielding impact ends at rest on the loading branch") {
    ContactPair by_adhesion = ammonium_fluorescein();
    by_adhesion.yield_pressure = 25e6;  // yields at first touch
    for (const ContactPair& pair : {ammonium_fluorescein(), by_adhesion}) {
        const Branches branches{pair};
        Impact impact = undamped(pair, 0.5);
        impact.damping.coefficient = Scale::of(pair, 0.5).damping_coefficient(DampingLaw::constant, 20.0);
        CAPTURE(describe(impact));
        const ImpactResult result = solve_impact(impact);
        const double a = branches.loading_equilibrium();
        CHECK(result.outcome == Outcome::capture);
        CHECK(result.yielded);
        CHECK(!result.approach_time);
        CHECK(relative_difference(result.maximum_overlap, branches.overlap(a)) < 1e-12);
        const EnergyLedger& energy = result.energy;
        const double size = energy.incident;
        const double loaded = branches.loading_work(a, size);
        const double potential = branches.unloading_work(a, 0.0, size);
        CHECK(energy.remaining == 0.0);
        CHECK(std::abs(energy.potential - potential) < 1e-12 * size);
        CHECK(energy.potential == energy.minimum);
        CHECK(std::abs(energy.dissipated - (energy.incident - loaded)) < 1e-12 * size);
        CHECK(std::abs(energy.plastic - (loaded + energy.at_touch - potential)) < 1e-12 * size);
        CHECK(std::abs(energy.residual) < 1e-15 * size);

        double before = -1.0;
        for (const TrajectoryPoint& point : trajectory(impact, 301)) {
            CHECK(point.overlap > before);
            CHECK(point.velocity > 0.0);
            const double force =
                branches.hertz_part(point.contact_radius) - branches.adhesive(point.contact_radius);
            CHECK(std::abs(point.repulsive_force + point.attractive_force - force) <
                  1e-9 * branches.adhesive(point.contact_radius));
            before = point.overlap;
        }
        CHECK(before < result.maximum_overlap);
        CHECK(before > 0.8 * result.maximum_overlap);
    }
}

TEST_CASE("where adhesion alone yields the contact, plastic work counts from first touch") {
    ContactPair pair = ammonium_fluorescein();
    const double at_limit = pair.yield_pressure * 0.5 / 0.5788;  // u_y = touch
    const auto yields_at_touch = [&](double p_y) {
        pair.yield_pressure = p_y;
        return Branches{pair}.yield_radius() < Branches{pair}.touch_radius();
    };
    REQUIRE(yields_at_touch(0.9 * at_limit));
    REQUIRE(!yields_at_touch(1.1 * at_limit));
    const double lower = bisected(0.9 * at_limit, 1.1 * at_limit, yields_at_touch);
    // The ledger is the same on both sides of the limit ...
    const auto ledger_at = [&](double p_y) {
        pair.yield_pressure = p_y;
        return solve_impact(undamped(pair, 3.0)).energy;
    };
    const EnergyLedger below = ledger_at(lower * (1.0 - 1e-9));
    const EnergyLedger above = ledger_at(lower * (1.0 + 1e-9));
    CHECK(relative_difference(below.at_touch, above.at_touch) < 1e-8);
    CHECK(relative_difference(below.plastic, above.plastic) < 1e-7);
    // ... and beyond it starts from the potential of the sphere flattened by the touch.
    for (const double p_y : {0.95 * lower, 0.8 * lower, 0.5 * lower}) {
        pair.yield_pressure = p_y;
        const Branches branches{pair};
        const EnergyLedger energy = solve_impact(undamped(pair, 3.0)).energy;
        const double touch = branches.unloading_work(branches.touch_radius(), 0.0, energy.incident);
        CHECK(std::abs(energy.at_touch - touch) < 1e-12 * energy.incident);
        CHECK(std::abs(energy.residual) < 1e-15 * energy.incident);
    }
}

TEST_CASE("the contact time at v_c is the limit of those just above it") {
    for (const double p_y : {35.3e6, 50e6, 1e9}) {
        ContactPair pair = ammonium_fluorescein();
        pair.yield_pressure = p_y;
        const CriticalVelocity critical = critical_velocity(
            {Law::of<ThorntonNing>(), Detachment::pull_off, {DampingLaw::constant, 1e-7}, pair});
        REQUIRE(critical.contact_time);
        const auto time_above = [&](double excess) {
            Impact above = undamped(pair, *critical.value * (1.0 + excess));
            above.damping.coefficient = 1e-7;
            return *solve_impact(above).contact_time;
        };
        const double coarse = 2.0 * time_above(1e-8) - time_above(4e-8);
        const double fine = 2.0 * time_above(2.5e-9) - time_above(1e-8);
        CHECK(relative_difference((4.0 * fine - coarse) / 3.0, *critical.contact_time) < 1e-6);
    }
}

TEST_CASE("where damping leaves hardly any speed, impacts still tell the upper crossing") {
    // Contact-radius damping just below the one that captures all: rebounds of 1e-6 of the velocity.
    const ContactPair pair{.mass = 1.2082796645224796e-08,
                           .effective_radius = 1.3172696785230338e-4,
                           .contact_modulus = 769.715658657e9,
                           .work_of_adhesion = 0.72974023005461952,
                           .yield_pressure = 20.027470838169163e9};
    const Damping damping{DampingLaw::contact_radius, 109487.54399202552};
    const CriticalVelocity critical =
        critical_velocity({Law::of<ThorntonNing>(), Detachment::load_controlled, damping, pair});
    REQUIRE(critical.crossings.size() == 2);
    CHECK(*critical.value == critical.crossings[0]);
    bool rebounds = true;  // above the lower one
    for (const double crossing : critical.crossings) {
        CAPTURE(crossing);
        const auto outcome_at = [&](double velocity) {
            return solve_impact(
                       {Law::of<ThorntonNing>(), Detachment::load_controlled, damping, pair, velocity})
                .outcome;
        };
        CHECK((outcome_at(crossing * (1.0 + 1e-9)) == Outcome::rebound) == rebounds);
        CHECK((outcome_at(crossing * (1.0 - 1e-9)) == Outcome::rebound) != rebounds);
        rebounds = !rebounds;
    }
}

TEST_CASE("a yield pressure that is none is refused; the law admits pull-off and load-controlled ends") {
    CHECK(input_error_of([] { return solve_impact(undamped(yielding_ash(0.3, 0.0), 2.0)); }) ==
          "yield_pressure is 0 Pa; allowed: a positive pressure [Pa]");
    CHECK(admissible_detachments(Law::of<ThorntonNing>()) == "pull-off, load-controlled");
    CHECK(contains(refusal(Law::of<ThorntonNing>(), Detachment::zero_overlap).value(), "no such point"));
}

TEST_CASE("so damped that it creeps through its yield point, an impact ends at rest on the loading branch") {
    for (const double damping : {0.05, 0.1595, 1.0, 100.0}) {
        CAPTURE(damping);
        const double radius = 12.57e-6;
        const Impact impact{
            .law = Law::of<ThorntonNing>(),
            .detachment = Detachment::pull_off,
            .damping = {DampingLaw::constant, damping},
            .contact = {.mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * 784.0,
                        .effective_radius = radius,
                        .contact_modulus = 7.14e9,
                        .work_of_adhesion = 0.315,
                        .yield_pressure = 92.7e6},
            .velocity = 11.84};
        const ImpactResult result = solve_impact(impact);
        CHECK(result.outcome == Outcome::capture);
        CHECK(result.yielded);
        CHECK_FALSE(result.approach_time.has_value());
        // The place of rest is that of statics: it does not depend on the damping.
        CHECK(std::abs(result.maximum_overlap / 6.032e-9 - 1.0) < 1e-3);
        CHECK(std::abs(result.energy.residual) <= 1e-12 * result.energy.incident);
    }
}

TEST_CASE(
    "a yield pressure far below what adhesion alone yields is refused with the limit, or its energy closes") {
    int refused = 0;
    for (const double pressure : {1e2, 1e4, 362548.64, 1e6, 1e8, 1e10}) {
        CAPTURE(pressure);
        const Impact impact{.law = Law::of<ThorntonNing>(),
                            .detachment = Detachment::pull_off,
                            .damping = {DampingLaw::constant, 0.0},
                            .contact = {.mass = 3.5054099638796742e-18,
                                        .effective_radius = 1.2863186468109448e-10,
                                        .contact_modulus = 142931452779.51965,
                                        .work_of_adhesion = 0.6442932735822301,
                                        .yield_pressure = pressure},
                            .velocity = 103624.64055734755};
        try {
            const ImpactResult result = solve_impact(impact);
            CHECK(std::abs(result.energy.residual) <= 1e-9 * result.energy.incident);
        } catch (const InputError& error) {
            ++refused;
            CHECK(contains(error.problem(), "outside the range of the plastic closure"));
            CHECK(contains(error.allowed(), " Pa"));
        }
    }
    CHECK(refused > 0);
}

TEST_CASE("of the size of atoms, soft and strongly damped, impacts end or are refused with the limit") {
    Random random(8);
    int ended = 0;
    for (int i = 0; i < repetitions(400); ++i) {
        const auto near = [&](double value) { return value * random.log_uniform(0.5, 2.0); };
        const double radius = near(1.6e-10);
        const Impact impact{
            .law = Law::of<ThorntonNing>(),
            .detachment = Detachment::pull_off,
            .damping = {DampingLaw::constant, near(2317.0)},
            .contact = {.mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * 2600.0,
                        .effective_radius = radius,
                        .contact_modulus = near(1.65e5),
                        .work_of_adhesion = near(2.05),
                        .yield_pressure = near(9.46e8)},
            .velocity = random.log_uniform(0.1, 100.0)};
        CAPTURE(describe(impact));
        try {
            const ImpactResult result = solve_impact(impact);
            ++ended;
            CHECK(result.outcome == Outcome::capture);
            CHECK(std::isfinite(result.maximum_overlap));
            CHECK(std::abs(result.energy.residual) <= 1e-9 * std::abs(result.energy.minimum));
        } catch (const InputError& error) {
            CHECK(contains(error.problem(), "outside the range of the plastic closure"));
        }
    }
    CHECK(ended > 0);
}
