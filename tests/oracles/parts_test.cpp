// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/oracles/dem/program.hpp"
#include "tests/oracles/dem/track.hpp"
#include "tests/oracles/impact_case.hpp"
#include "tests/oracles/time_domain.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/ode.hpp"

namespace ashimpact::oracles {

using test::relative_difference;

namespace {

const Impact fly_ash{
    .law = Law::of<Hertz>(),
    .detachment = Detachment::zero_overlap,
    .damping = {DampingLaw::constant, 0.0141},
    .contact = {.mass = 9.3e-10, .effective_radius = 44e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.3},
    .velocity = 2};

Impact jkr_fly_ash(Detachment detachment) {
    Impact impact = fly_ash;
    impact.law = Law::of<Jkr>();
    impact.detachment = detachment;
    return impact;
}

// m = 1, k = pi^2: a contact of duration 1, x = sin(pi t) / pi
Track harmonic(int steps) {
    Track track{.time_step = 1 / (steps - 0.5), .samples = {}};
    for (int i = 0; i < steps + 3; ++i) {
        const double t = i * track.time_step;
        const bool inside = t < 1;
        track.samples.push_back({inside ? std::sin(std::numbers::pi * t) / std::numbers::pi : 1 - t,
                                 inside ? std::cos(std::numbers::pi * t) : -1.5});
    }
    return track;
}

}  // namespace

TEST_CASE("extrapolation finds the value at step zero and brackets its error") {
    const std::array steps{5e-10, 3e-10, 2e-10, 1.4e-10, 1e-10};
    const std::array powers{1., 2., 2.5, 3.};
    std::array<double, 5> values{};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double h = steps[i] * 1e9;
        values[i] = 0.7 + 0.2 * h - 0.4 * h * h + 0.3 * std::pow(h, 2.5) + 0.1 * h * h * h;
    }
    const auto found = extrapolate(steps, values, powers);
    CHECK(relative_difference(found.value, 0.7) < 1e-13);
    CHECK(found.error > 1e-9);
    CHECK(found.error < 1e-2);
}

TEST_CASE("a contact is read between the samples, without the first one outside") {
    const auto contact = read_contact(harmonic(400), 0);
    CHECK(contact.separated);
    CHECK(relative_difference(contact.restitution, 1) < 1e-10);
    CHECK(relative_difference(contact.contact_time, 1) < 1e-11);
    CHECK(relative_difference(contact.maximum_overlap, 1 / std::numbers::pi) < 1e-13);
    CHECK(relative_difference(contact.end_in_steps, 399.5) < 1e-11);

    auto captured = harmonic(400);
    captured.samples.resize(390);
    CHECK_FALSE(read_contact(captured, 0).separated);
    CHECK(relative_difference(read_contact(captured, 0).maximum_overlap, 1 / std::numbers::pi) < 1e-13);
}

TEST_CASE("a deck is filled completely or not at all") {
    CHECK(fill("a @x@ b @y@\n", {{"x", exact(0.1)}, {"y", "2"}}) == "a 0.10000000000000001 b 2\n");
    CHECK_THROWS_AS(fill("@x@ @y@", {{"x", "1"}}), std::runtime_error);
    CHECK_THROWS_AS(fill("@x@ @", {{"x", "1"}}), std::runtime_error);
}

TEST_CASE("a missing oracle fails with the package that has it") {
    CHECK_THROWS_WITH(
        find_program("no-such-dem-code", "lammps"),
        "the independent oracle 'no-such-dem-code' is not installed; on Debian: apt-get install lammps");
}

TEST_CASE("the JKR force has the known values where contact begins and ends") {
    const double pull_off_force =
        1.5 * std::numbers::pi * fly_ash.contact.work_of_adhesion * fly_ash.contact.effective_radius;
    const ContactForce load_controlled(jkr_fly_ash(Detachment::load_controlled));
    const ContactForce fold(jkr_fly_ash(Detachment::pull_off));
    CHECK(relative_difference(fold(0), -8. / 9 * pull_off_force) < 1e-12);
    CHECK(relative_difference(fold(fold.end_overlap()), -5. / 9 * pull_off_force) < 1e-6);
    CHECK(relative_difference(load_controlled(load_controlled.end_overlap()), -pull_off_force) < 1e-12);
}

TEST_CASE("the time-domain critical velocity meets the closed forms") {
    const double k = 4. / 3 * fly_ash.contact.contact_modulus * std::sqrt(fly_ash.contact.effective_radius);
    const double hertz =
        0.5476175 * std::pow(fly_ash.damping.coefficient, 5) / (std::pow(fly_ash.contact.mass, 3) * k * k);
    CHECK(relative_difference(time_domain_critical_velocity(fly_ash), hertz) < 2e-7);

    // W_s = 7.092196 (w^5 R^4 / E*^2)^(1/3) to the fold, 3.5026 in the place of 7.09 to the load-controlled
    // end
    const double energy = std::cbrt(std::pow(fly_ash.contact.work_of_adhesion, 5) *
                                    std::pow(fly_ash.contact.effective_radius, 4) /
                                    std::pow(fly_ash.contact.contact_modulus, 2));
    for (const auto& [detachment, constant, tolerance] :
         {std::tuple{Detachment::pull_off, 7.092196, 1e-7},
          std::tuple{Detachment::load_controlled, 3.5026, 1e-5}}) {
        Impact impact = jkr_fly_ash(detachment);
        impact.damping.coefficient = 0;
        CHECK(time_domain_critical_velocity(impact) ==
              doctest::Approx(std::sqrt(2 * constant * energy / impact.contact.mass)).epsilon(tolerance));
    }
}

}  // namespace ashimpact::oracles

namespace ashimpact::oracles {

using test::relative_difference;

namespace {

double or_nothing(const nlohmann::json& value) {
    return value.is_null() ? 0 : value.get<double>();
}

}  // namespace

TEST_CASE("the time-domain oracle agrees with the reference impacts") {
    std::ifstream file(ASHIMPACT_TEST_DATA "/reference/impacts.json");
    REQUIRE(file);
    const auto reference = nlohmann::json::parse(file);
    const auto& sphere = reference["sphere"];
    for (const auto& row : reference["cases"]) {
        if (row["law"] == "sjkr")
            continue;  // no force of this oracle; its rows come from another integration
        const Impact impact{.law = Law::named(row["law"].get<std::string>()),
                            .detachment = named<Detachment>(row["detachment"].get<std::string>()),
                            .damping = {DampingLaw::constant, row["damping"]},
                            .contact = {.mass = sphere["mass"],
                                        .effective_radius = sphere["radius"],
                                        .contact_modulus = sphere["contact_modulus"],
                                        .work_of_adhesion = row["work_of_adhesion"]},
                            .velocity = row["velocity"]};
        const std::string label = row.dump();
        CAPTURE(label);
        const double tolerance = impact.detachment == Detachment::zero_force ? 1e-7 : 1e-9;
        const auto result = time_domain_impact(impact);
        CHECK(result.rebound == (row["outcome"] == "rebound"));
        CHECK(relative_difference(result.restitution.value, row["restitution"]) <= tolerance);
        CHECK(relative_difference(result.contact_time.value, or_nothing(row["contact_time"])) <= tolerance);
        if (!row["maximum_overlap"].is_null())
            CHECK(relative_difference(result.maximum_overlap.value, row["maximum_overlap"]) <= tolerance);
    }
}

}  // namespace ashimpact::oracles

// The contact at the critical velocity, followed backward in time from its end by GSL, in overlap and
// velocity.

namespace ashimpact::oracles {

using test::relative_difference;

namespace {

struct CriticalContact {
    double velocity;
    double contact_time;
};

// The orbit leaves the end at rest. Over the first overlap x beyond it the force is -pull x^power, so the
// speed is v = a x^((1 + power)/2) + b x with a^2 = 2 pull/(m (1 + power)), b = 2 damping/(m (3 + power)),
// and the time the integral of dx/v.
struct Departure {
    double pull;
    double power;
};

Departure departure_of(const Impact& impact, const ContactForce& force) {
    if (impact.law != Law::of<BrachDunn>()) return {-force(force.end_overlap()), 0.0};
    const double x = 1e-30 * force.overlap_scale();
    return {-force(x) / std::sqrt(x), 0.5};
}

CriticalContact backward_from_the_end(const Impact& impact) {
    using State = std::array<double, 3>;  // overlap beyond the end [m], velocity [m/s], time to the end [s]
    const ContactForce force(impact);
    const double end = force.end_overlap();
    const auto [pull, power] = departure_of(impact, force);
    const double x = 1e-14 * force.overlap_scale();
    const double a = std::sqrt(2 * pull / (impact.contact.mass * (1 + power)));
    const double b = 2 * impact.damping.coefficient / (impact.contact.mass * (3 + power));
    const double way = std::pow(x, (1 - power) / 2);
    const double time = 2 * way / (a * (1 - power)) - b * way * way / (a * a * (1 - power));
    State now{x, -(a * x / way + b * x), time};

    bool by_overlap = false;  // the clock
    const auto derivative = [&](double, const State& y) -> State {
        const double deceleration =
            (force(end + y[0]) + impact.damping.coefficient * y[1]) / impact.contact.mass;
        const double pace = by_overlap ? -1 / y[1] : 1.0;
        return {-pace * y[1], pace * deceleration, pace};
    };
    test::Ode<3, decltype(derivative)> ode(
        derivative,
        {1e-13, {1e-24 * force.overlap_scale(), 1e-16 * impact.velocity, 1e-13 * force.time_scale()}});
    double t = 0;
    double stride = 1e-9 * force.time_scale();
    State before = now;
    while (now[1] < 0 || end + now[0] > 0) {
        before = now;
        ode.step(t, 1e3 * force.time_scale(), stride, now);
    }
    by_overlap = true;
    ode.integrate(end + before[0], 0.0, before);
    return {before[1], before[2]};
}

}  // namespace

TEST_CASE("contact time and velocity of the critical impact agree with GSL, backward in the time domain") {
    for (const double w : {0.05, 0.3, 1.0}) {
        for (const double damping : {0.003, 0.0153}) {
            for (const auto& [law, detachment] : {std::pair{Law::of<Dmt>(), Detachment::zero_overlap},
                                                  std::pair{Law::of<BrachDunn>(), Detachment::zero_overlap},
                                                  std::pair{Law::of<Jkr>(), Detachment::pull_off},
                                                  std::pair{Law::of<Jkr>(), Detachment::load_controlled},
                                                  std::pair{Law::of<Jkr>(), Detachment::zero_overlap}}) {
                const Impact impact{.law = law,
                                    .detachment = detachment,
                                    .damping = {DampingLaw::constant, damping},
                                    .contact = {.mass = sphere_mass(44e-6, 2600),
                                                .effective_radius = 44e-6,
                                                .contact_modulus = 90e9,
                                                .work_of_adhesion = w},
                                    .velocity = 1.0};
                const std::string label = std::string(law.name()) + ", " + std::string(name_of(detachment));
                CAPTURE(label);
                CAPTURE(w);
                CAPTURE(damping);
                const CriticalVelocity critical =
                    critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
                REQUIRE(critical.contact_time);
                const CriticalContact expected = backward_from_the_end(impact);
                CHECK(relative_difference(*critical.value, expected.velocity) < 1e-9);
                CHECK(relative_difference(*critical.contact_time, expected.contact_time) < 1e-9);
                if (w == 0.3 && damping == 0.0153) {
                    MESSAGE(label << ": v_c " << *critical.value << " m/s, contact time "
                                  << *critical.contact_time * 1e9 << " ns, off by "
                                  << relative_difference(*critical.contact_time, expected.contact_time));
                }
            }
        }
    }
}

}  // namespace ashimpact::oracles
