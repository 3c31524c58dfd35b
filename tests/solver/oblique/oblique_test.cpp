// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts at an angle: identities, limits, and an independent integration with a stiff tangential spring.
#include "solver/oblique/oblique.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "solver/batch/batch.hpp"
#include "solver/oblique/oblique_batch.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::contains;
using test::input_error_of;

namespace {

constexpr double ash_radius = 44e-6;

double solid_mass(double r, double density) {
    return 4.0 / 3.0 * std::numbers::pi * r * r * r * density;
}

/// A fly ash sphere on steel.
ObliqueImpact oblique_ash(const char* name, double normal_velocity, double friction) {
    const double mass = solid_mass(ash_radius, 2300);
    ContactPair pair{
        .mass = mass, .effective_radius = ash_radius, .contact_modulus = 90e9, .work_of_adhesion = 0.3};
    const Law law = Law::named(name);
    return {.normal = {law, law.default_detachment(), {DampingLaw::constant, 2e-3}, pair, normal_velocity},
            .bodies = {.sphere = {ash_radius, mass}},
            .friction = friction};
}

/// The static law of a contact: its radius by the overlap, its attraction by the radius, and where it ends.
struct StaticForces {
    std::function<double(double)> radius;
    std::function<double(double)> attraction;
    double end = 0;  ///< overlap [m]
};

/// The forces of a law, written from its equations in the literature.
StaticForces static_forces(std::string_view law, const ContactPair& pair) {
    const double r = pair.effective_radius;
    const double w = pair.work_of_adhesion;
    const double line = std::cbrt(6 * w * w * r * pair.contact_modulus / std::numbers::pi);
    const double root = std::sqrt(2 * std::numbers::pi * w / pair.contact_modulus);
    StaticForces forces{.radius = [r](double overlap) { return std::sqrt(r * std::max(0.0, overlap)); },
                        .attraction = [](double) { return 0.0; }};
    if (law == "dmt") forces.attraction = [=](double) { return 2 * std::numbers::pi * w * r; };
    if (law == "brach-dunn") forces.attraction = [=](double a) { return 2 * std::numbers::pi * line * a; };
    if (law != "jkr") return forces;
    // overlap = a^2/R - root sqrt(a); the contact breaks where that is least.
    const auto overlap_at = [=](double a) { return a * a / r - root * std::sqrt(a); };
    const double breaks = std::pow(r * root / 4, 2.0 / 3.0);
    forces.end = overlap_at(breaks);
    forces.attraction = [=](double a) {
        return std::sqrt(8 * std::numbers::pi * w * pair.contact_modulus * a * a * a);
    };
    forces.radius = [=, a = std::pow(r * root, 2.0 / 3.0)](double overlap) mutable {
        for (int i = 0; i < 50; ++i) {
            const double step = (overlap_at(a) - overlap) / (2 * a / r - root / (2 * std::sqrt(a)));
            a = std::max(a - step, 0.5 * (a + breaks));
            if (std::abs(step) < 1e-12 * a) break;
        }
        return a;
    };
    return forces;
}

/// v_t, spin and normal velocity by an integration in time of Newton's equations: the normal force of a
/// static law and constant damping; tangentially a spring of @p stiffness times that of the contact that
/// slides where its force exceeds mu times the repulsion. Semi-implicit steps.
struct ByTime {
    double velocity;
    double spin;
    double normal;
    double repulsion;  ///< time integral of the repulsion, damping included [N s]
};
ByTime integrated(const ObliqueImpact& impact, const StaticForces& forces, double stiffness, int steps) {
    const ContactPair& pair = impact.normal.contact;
    const double eta = impact.normal.damping.coefficient;
    const double k = 4.0 / 3.0 * pair.contact_modulus * std::sqrt(pair.effective_radius);
    const double length = std::pow(pair.mass * impact.normal.velocity * impact.normal.velocity / k, 0.4);
    const double spring = stiffness * k * std::sqrt(length);
    const double dt = 4 * length / impact.normal.velocity / steps;
    double overlap = 0;
    double v = impact.normal.velocity;
    double vt = impact.tangential.velocity;
    double omega = impact.tangential.spin;
    double stretch = 0;
    double repulsion = 0;
    while (overlap >= forces.end) {
        const double a = forces.radius(overlap);
        const double push = 4.0 / 3.0 * pair.contact_modulus * a * a * a / pair.effective_radius + eta * v;
        v -= (push - forces.attraction(a)) / pair.mass * dt;
        overlap += v * dt;
        repulsion += push * dt;
        stretch += (vt + impact.bodies.sphere.radius * omega) * dt;
        const double most = impact.friction * std::max(0.0, push);
        stretch = std::clamp(stretch, -most / spring, most / spring);
        const double force = spring * stretch;
        vt -= force / pair.mass * dt;
        omega -= 2.5 * force / (impact.bodies.sphere.mass * impact.bodies.sphere.radius) * dt;
    }
    return {vt, omega, -v, repulsion};
}

}  // namespace

TEST_CASE("oblique: momentum and energy of a million random impacts") {
    std::mt19937_64 random(20261126);
    std::uniform_real_distribution<double> unit(-1, 1);
    double worst_energy = 0;
    double worst_momentum = 0;
    std::array<int, 4> seen{};
    for (int i = 0; i < 1'000'000; ++i) {
        const double r = std::pow(10.0, -5 + unit(random));
        const double m = solid_mass(r, 2000);
        ContactBodies bodies{.sphere = {r, m}};
        double mass = m;
        if (i % 3 == 0) {
            const double r2 = r * std::pow(10.0, unit(random));
            bodies.partner = SphereBody{r2, solid_mass(r2, 3000)};
            mass = 1 / (1 / m + 1 / bodies.partner->mass);
        }
        const TangentialMotion before{.velocity = unit(random), .spin = 2 * unit(random) / r};
        const double push = mass * std::pow(10.0, 2 * unit(random));
        const auto rebound = tangential_rebound(bodies, mass, before, std::abs(unit(random)), push);
        ++seen[static_cast<std::size_t>(rebound.regime)];
        const auto energy = [&](double v, double w, double w2) {
            return 0.5 * mass * v * v + 0.2 * m * r * r * w * w +
                   (bodies.partner ? 0.2 * bodies.partner->mass * std::pow(bodies.partner->radius * w2, 2)
                                   : 0);
        };
        const double was = energy(before.velocity, before.spin, 0);
        const double is = energy(rebound.after.velocity, rebound.after.spin, rebound.partner_spin);
        worst_energy = std::max(worst_energy, std::abs(was - is - rebound.friction_work) / was);
        // The angular momentum about the point of contact does not change.
        const double about = mass * (rebound.after.velocity - before.velocity) -
                             0.4 * m * r * (rebound.after.spin - before.spin);
        worst_momentum = std::max(worst_momentum, std::abs(about) / (mass * (1 + std::abs(r * before.spin))));
    }
    CHECK(worst_energy < 1e-13);
    CHECK(worst_momentum < 1e-13);
    CHECK(seen[static_cast<std::size_t>(SlidingRegime::sliding)] > 100'000);
    CHECK(seen[static_cast<std::size_t>(SlidingRegime::rolling)] > 100'000);
}

TEST_CASE("oblique: limits of rolling, sliding and no slip") {
    ObliqueImpact impact = oblique_ash("hertz", 2, 0.1);
    impact.tangential = {.velocity = 0.3, .spin = 0};
    const ObliqueResult rolling = solve_oblique_impact(impact);
    CHECK(rolling.tangential.regime == SlidingRegime::rolling);
    CHECK(test::relative_difference(*rolling.tangential_restitution, 5.0 / 7.0) < 1e-15);
    const TangentialMotion& after = rolling.tangential.after;
    CHECK(std::abs(after.velocity + ash_radius * after.spin) < 1e-15);  // the contact point rests

    // Without adhesion sliding ends where tan(angle) = (7/2) mu (1 + e).
    const double e = rolling.normal.restitution;
    const double limit = 3.5 * impact.friction * (1 + e) * impact.normal.velocity;
    impact.tangential.velocity = limit * (1 + 1e-9);
    CHECK(solve_oblique_impact(impact).tangential.regime == SlidingRegime::sliding);
    impact.tangential.velocity = limit * (1 - 1e-9);
    CHECK(solve_oblique_impact(impact).tangential.regime == SlidingRegime::rolling);

    impact.tangential = {.velocity = 10, .spin = 0};
    const ObliqueResult sliding = solve_oblique_impact(impact);
    CHECK(test::relative_difference(*sliding.tangential_restitution,
                                    1 - impact.friction * (1 + e) * impact.normal.velocity / 10) < 1e-14);
    CHECK(test::relative_difference(*sliding.impulse_ratio, impact.friction) < 1e-14);

    impact.tangential = {.velocity = 1, .spin = -1 / ash_radius};
    const ObliqueResult none = solve_oblique_impact(impact);
    CHECK(none.tangential.regime == SlidingRegime::none);
    CHECK(*none.tangential_restitution == 1);
    CHECK(none.tangential.after.spin == impact.tangential.spin);

    // Everything turned round gives the same turned round.
    impact.tangential = {.velocity = 3, .spin = 2e4};
    const ObliqueResult one = solve_oblique_impact(impact);
    impact.tangential = {.velocity = -3, .spin = -2e4};
    const ObliqueResult other = solve_oblique_impact(impact);
    CHECK(one.tangential.after.velocity == -other.tangential.after.velocity);
    CHECK(one.tangential.after.spin == -other.tangential.after.spin);
    CHECK(*one.rebound_angle == *other.rebound_angle);

    impact.normal = oblique_ash("jkr", 0.02, 0.1).normal;
    const ObliqueResult captured = solve_oblique_impact(impact);
    CHECK(captured.tangential.regime == SlidingRegime::captured);
    CHECK(*captured.tangential_restitution == 0);
    CHECK_FALSE(captured.rebound_angle);
    impact.friction = -0.1;
    CHECK(contains(input_error_of([&] { return solve_oblique_impact(impact).normal.steps; }),
                   "friction is -0.1"));
    impact.friction = 0.1;
    for (const double wrong : {1e300, -std::numeric_limits<double>::infinity()}) {
        impact.tangential = {.velocity = wrong};
        CHECK(contains(input_error_of([&] { return solve_oblique_impact(impact).normal.steps; }),
                       "magnitude of the tangential velocity is "));
        impact.tangential = {.spin = wrong};
        CHECK(contains(input_error_of([&] { return solve_oblique_impact(impact).normal.steps; }),
                       "magnitude of the spin is "));
    }
}

TEST_CASE("oblique: friction with adhesion against a stiff tangential spring in time") {
    for (const double velocity : {1.2, 4.0})
        for (const double tangential : {0.5, 2.5, 8.0})
            for (const char* law : {"hertz", "dmt", "brach-dunn", "jkr"}) {
                CAPTURE(law);
                CAPTURE(velocity);
                CAPTURE(tangential);
                ObliqueImpact impact = oblique_ash(law, velocity, 0.2);
                impact.tangential = {.velocity = tangential, .spin = 0};
                // With little damping: at the end of a contact a strong one pulls, and the spring slips
                // freely.
                impact.normal.damping.coefficient = 1e-4;
                const ObliqueResult exact = solve_oblique_impact(impact);
                REQUIRE(exact.normal.outcome == Outcome::rebound);
                const ByTime coarse =
                    integrated(impact, static_forces(law, impact.normal.contact), 4000, 400'000);
                CHECK(test::relative_difference(coarse.normal, exact.normal.rebound_velocity) < 1e-3);
                CHECK(test::relative_difference(coarse.repulsion, exact.repulsive_impulse) < 1e-3);
                CHECK(test::relative_difference(coarse.velocity, exact.tangential.after.velocity) < 1e-3);
                CHECK(test::relative_difference(coarse.spin, exact.tangential.after.spin) < 1e-3);
            }
}

TEST_CASE("oblique: a batch gives what single impacts give, whatever the threads") {
    constexpr Eigen::Index count = 200;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const char* name : {"hertz", "dmt", "brach-dunn", "jkr", "sjkr"}) {
        CAPTURE(name);
        const ObliqueImpact base = oblique_ash(name, 1, 0.2);
        ImpactBatch batch{
            base.normal.law,
            base.normal.detachment,
            DampingLaw::constant,
            {Eigen::ArrayXd::Constant(1, base.normal.contact.mass), Eigen::ArrayXd::Constant(1, ash_radius),
             Eigen::ArrayXd::Constant(1, 90e9), Eigen::ArrayXd::Constant(1, 0.3)},
            Eigen::ArrayXd::Constant(1, 2e-3),
            Eigen::ArrayXd::NullaryExpr(count, [&] { return std::pow(10, unit(random)); })};
        const Eigen::ArrayXd energy_density = Eigen::ArrayXd::Constant(1, 1e8);
        if (std::string_view(name) == "sjkr")
            batch.contact.parameters.push_back({batch.law.parameters().front().name, energy_density});
        const Eigen::ArrayXd along = Eigen::ArrayXd::NullaryExpr(count, [&] { return 5 * unit(random); });
        const Eigen::ArrayXd spin = Eigen::ArrayXd::NullaryExpr(count, [&] { return 1e4 * unit(random); });
        const Eigen::ArrayXd mu = Eigen::ArrayXd::Constant(1, 0.2);
        const ImpactBatchResult normal = solve_impacts(batch);
        const TangentialColumns columns{batch.contact.effective_radius, batch.contact.mass, along, spin, mu};
        std::array<Eigen::ArrayXd, 6> one;
        std::array<Eigen::ArrayXd, 6> three;
        for (auto* results : {&one, &three}) {
            for (Eigen::ArrayXd& column : *results) column.resize(count);
            auto& r = *results;
            solve_tangential(batch, normal.restitution.data(), count, columns,
                             {r[0].data(), r[1].data(), r[2].data(), r[3].data(), r[4].data(), r[5].data()},
                             results == &one ? 1 : 3);
        }
        for (Eigen::Index i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < one.size(); ++k)
                CHECK((one[k][i] == three[k][i] || (std::isnan(one[k][i]) && std::isnan(three[k][i]))));
            ObliqueImpact single = base;
            single.normal.velocity = batch.velocity[i];
            if (std::string_view(name) == "sjkr")
                single.normal.contact.parameters.set(batch.law.parameters().front().name, 1e8);
            single.tangential = {along[i], spin[i]};
            const ObliqueResult alone = solve_oblique_impact(single);
            REQUIRE(one[5][i] == static_cast<double>(alone.tangential.regime));
            if (alone.tangential.regime == SlidingRegime::captured) continue;
            CHECK(std::abs(one[0][i] - alone.tangential.after.velocity) < 1e-9);
            CHECK(std::abs(one[1][i] - alone.tangential.after.spin) < 1e-9 * 1e4);
            CHECK(std::abs(one[3][i] - *alone.rebound_angle) < 1e-9);
            CHECK(std::abs(one[4][i] - *alone.impulse_ratio) < 1e-9);
        }
    }
}

TEST_CASE("oblique: alumina on glass as Kharaz, Gorham & Salman 2001 measured it") {
    const auto measured = [](const std::string& quantity) {
        std::vector<std::pair<double, double>> points;
        std::ifstream file(ASHIMPACT_DATA "/measured/kharaz2001.csv");
        REQUIRE(file);
        for (std::string line; std::getline(file, line);) {
            if (!line.starts_with(quantity + ",")) continue;
            std::istringstream cells(line.substr(line.find(',', quantity.size() + 1) + 1));
            double angle = 0;
            double value = 0;
            char comma = 0;
            REQUIRE((cells >> angle >> comma >> value));
            points.emplace_back(angle, value);
        }
        return points;
    };
    const double mu = 0.092;
    const double e = 0.98;
    const ContactBodies bodies{.sphere = {2.5e-3, solid_mass(2.5e-3, 4000)}};
    const auto rebound_at = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        const TangentialMotion before{.velocity = 3.9 * std::sin(angle)};
        return tangential_rebound(bodies, bodies.sphere.mass, before, mu,
                                  bodies.sphere.mass * (1 + e) * 3.9 * std::cos(angle));
    };
    // The rigid sphere slides beyond 32.5 degrees. There e_t is measured within 0.01, spin within 8 %.
    const double limit = std::atan(3.5 * mu * (1 + e)) * 180 / std::numbers::pi;
    CHECK(limit == doctest::Approx(32.5).epsilon(0.002));
    double farthest = 0;
    std::vector<double> frictions;  // of each sliding point, by 1 - e_t = mu (1 + e)/tan A
    for (const auto& [angle, value] : measured("e_t")) {
        const double e_t =
            rebound_at(angle).after.velocity / (3.9 * std::sin(angle * std::numbers::pi / 180));
        if (angle > limit) {
            CHECK(std::abs(e_t - value) < 0.01);
            frictions.push_back((1 - value) * std::tan(angle * std::numbers::pi / 180) / (1 + e));
        } else {
            CHECK(e_t == doctest::Approx(5.0 / 7.0));
            farthest = std::max(farthest, std::abs(e_t - value));
        }
    }
    CHECK(frictions.size() == 8);
    CHECK(std::ranges::min(frictions) == doctest::Approx(0.081).epsilon(0.005));
    CHECK(std::ranges::max(frictions) == doctest::Approx(0.123).epsilon(0.005));
    // Below it the elastic tangential contact, which a rigid sphere lacks, takes and gives back motion.
    CHECK(farthest == doctest::Approx(0.117).epsilon(0.01));
    for (const auto& [angle, value] : measured("spin"))
        if (angle > limit)
            CHECK(test::relative_difference(std::abs(rebound_at(angle).after.spin), value) < 0.08);
}
