// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>

#include <doctest/doctest.h>

#include "tests/oracles/contact_force.hpp"
#include "tests/oracles/dem/program.hpp"
#include "tests/oracles/dem/track.hpp"
#include "tests/oracles/time_domain.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::oracles {

using test::relative_difference;

namespace {

constexpr ImpactCase fly_ash{.law = Law::hertz,
                             .detachment = Detachment::zero_overlap,
                             .radius = 44e-6,
                             .mass = 9.3e-10,
                             .contact_modulus = 90e9,
                             .work_of_adhesion = 0.3,
                             .damping = 0.0141,
                             .velocity = 2};

ImpactCase jkr(Detachment detachment) {
    ImpactCase impact = fly_ash;
    impact.law = Law::jkr;
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
    const double pull_off_force = 1.5 * std::numbers::pi * fly_ash.work_of_adhesion * fly_ash.radius;
    const ContactForce load_controlled(jkr(Detachment::load_controlled));
    const ContactForce fold(jkr(Detachment::pull_off));
    CHECK(relative_difference(fold(0), -8. / 9 * pull_off_force) < 1e-12);
    CHECK(relative_difference(fold(fold.end_overlap()), -5. / 9 * pull_off_force) < 1e-6);
    CHECK(relative_difference(load_controlled(load_controlled.end_overlap()), -pull_off_force) < 1e-12);
}

TEST_CASE("the time-domain critical velocity meets the closed forms") {
    const double k = 4. / 3 * fly_ash.contact_modulus * std::sqrt(fly_ash.radius);
    const double hertz = 0.5476175 * std::pow(fly_ash.damping, 5) / (std::pow(fly_ash.mass, 3) * k * k);
    CHECK(relative_difference(time_domain_critical_velocity(fly_ash), hertz) < 2e-7);

    // W_s = 7.092196 (w^5 R^4 / E*^2)^(1/3) to the fold, 3.5026 in the place of 7.09 to the load-controlled
    // end
    const double energy = std::cbrt(std::pow(fly_ash.work_of_adhesion, 5) * std::pow(fly_ash.radius, 4) /
                                    std::pow(fly_ash.contact_modulus, 2));
    for (const auto& [detachment, constant, tolerance] :
         {std::tuple{Detachment::pull_off, 7.092196, 1e-7},
          std::tuple{Detachment::load_controlled, 3.5026, 1e-5}}) {
        ImpactCase impact = jkr(detachment);
        impact.damping = 0;
        CHECK(time_domain_critical_velocity(impact) ==
              doctest::Approx(std::sqrt(2 * constant * energy / impact.mass)).epsilon(tolerance));
    }
}

}  // namespace ashimpact::oracles
