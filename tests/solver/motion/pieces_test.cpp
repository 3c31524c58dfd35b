// SPDX-License-Identifier: GPL-3.0-or-later
// Static laws whose polynomials change along the way.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <doctest/doctest.h>

#include "solver/contact/registry.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/follow.hpp"

using namespace ashimpact;

namespace {

/// JKR as pieces of one polynomial each, from below its pull-off point to beyond its equilibrium.
template <class Real>
struct JkrInPieces : Jkr<Real> {
    [[nodiscard]] std::vector<StaticBranch<Real>> pieces() const {
        const StaticBranch<Real> whole = static_branches<Jkr>(this->adhesion)[0];
        std::vector<StaticBranch<Real>> all;
        for (const double share : {0.5, 0.9, 1.0, 1.1, 2.0}) {
            all.push_back(whole);
            all.back().until = Real(share) * *this->detachment_point(Detachment::zero_force);
        }
        all.push_back(whole);
        return all;
    }
};

/// A table of force over overlap with straight lines between its points; beyond it the slope of the last
/// line.
template <class Real>
struct ForceTable {
    struct Point {
        double overlap;
        double force;
    };
    static constexpr std::array<Point, 5> points{{{0, -0.2}, {0.1, -0.3}, {0.3, -0.1}, {0.5, 0.4}, {1, 2}}};

    Real adhesion{};

    [[nodiscard]] static Real slope(std::size_t i) {
        return Real(points[i + 1].force - points[i].force) / Real(points[i + 1].overlap - points[i].overlap);
    }
    [[nodiscard]] static Real force_at(Real overlap) {
        std::size_t i = 0;
        while (i + 2 < points.size() && overlap > Real(points[i + 1].overlap)) ++i;
        return Real(points[i].force) + slope(i) * (overlap - Real(points[i].overlap));
    }
    [[nodiscard]] std::vector<StaticBranch<Real>> pieces() const {
        const Polynomial<Real> hertz = power<6>(Polynomial<Real>::identity());
        const Polynomial<Real> overlap = power<4>(Polynomial<Real>::identity());
        std::vector<StaticBranch<Real>> all;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Polynomial<Real> force =
                Polynomial<Real>(points[i].force - slope(i) * points[i].overlap) + slope(i) * overlap;
            all.push_back({overlap, {hertz, hertz - force}});
            if (i + 2 < points.size()) all.back().until = root<4>(Real(points[i + 1].overlap));
        }
        return all;
    }
    [[nodiscard]] static Real touch() { return 0; }
    [[nodiscard]] static std::optional<Real> detachment_point(Detachment detachment) {
        if (detachment == Detachment::zero_overlap) return Real(0);
        return root<4>(Real(0.3) + Real(0.1) / slope(2));  // without force, on the third line
    }
};

std::vector<ScaledDamping<Extended>> dampings() {
    std::vector<ScaledDamping<Extended>> all{ScaledDamping<Extended>::none()};
    for (const DampingLaw law : all_values<DampingLaw>)
        for (const Extended number : {0.05_ext, 0.4_ext, 3.0_ext})
            all.push_back(ScaledDamping<Extended>::of(law, {number}));
    return all;
}

/// An impact on the table with constant damping, by the classical method of Runge and Kutta.
struct InTime {
    Extended greatest = 0;  ///< overlap
    Extended rebound = 0;   ///< velocity at zero overlap; 0 of a capture
};
InTime in_time(Extended velocity, Extended damping) {
    constexpr Extended h = 2e-5_ext;
    const auto acceleration = [&](Extended x, Extended v) {
        return -ForceTable<Extended>::force_at(x) - damping * v;
    };
    InTime found;
    Extended x = 0;
    Extended v = velocity;
    for (int i = 0; i < 2'000'000; ++i) {
        const Extended a1 = acceleration(x, v);
        const Extended v2 = v + h / 2 * a1;
        const Extended a2 = acceleration(x + h / 2 * v, v2);
        const Extended v3 = v + h / 2 * a2;
        const Extended a3 = acceleration(x + h / 2 * v2, v3);
        const Extended v4 = v + h * a3;
        const Extended a4 = acceleration(x + h * v3, v4);
        x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        found.greatest = std::max(found.greatest, x);
        if (x <= 0) {
            found.rebound = std::sqrt(std::max(0.0_ext, v * v + 2 * a4 * -x));
            return found;
        }
    }
    return found;
}

}  // namespace

TEST_CASE("a law cut into pieces gives the impacts and the critical velocity of the whole law") {
    int finite = 0;
    for (const ScaledDamping<Extended>& damping : dampings()) {
        for (const Detachment detachment : {Detachment::pull_off, Detachment::load_controlled}) {
            for (const Extended adhesion : {1e-3_ext, 0.2_ext, 1.5_ext}) {
                const auto whole = make_motion<Jkr, Extended>(adhesion, damping, detachment);
                const auto pieces = make_motion<JkrInPieces, Extended>(adhesion, damping, detachment);
                REQUIRE(pieces.beyond.size() == 5);
                const auto near = [](Extended a, Extended b) {
                    CHECK(std::abs(a - b) <= 1e-15L * (1 + std::abs(a)));
                };
                for (const Extended velocity : {0.3_ext, 1.0_ext, 4.0_ext}) {
                    const Orbit<Extended> a = follow(whole, velocity);
                    const Orbit<Extended> b = follow(pieces, velocity, Unobserved(), 50);
                    CHECK(a.outcome == b.outcome);
                    CHECK(a.turned == b.turned);
                    near(a.maximum_overlap, b.maximum_overlap);
                    near(a.turn.dissipation, b.turn.dissipation);
                    near(a.last_potential, b.last_potential);
                    near(a.rest_potential, b.rest_potential);
                    if (a.outcome == Outcome::capture) continue;
                    near(a.end.velocity, b.end.velocity);
                    near(a.end.time, b.end.time);
                }
                const CriticalImpacts a = critical_impacts(whole);
                const CriticalImpacts b = critical_impacts(pieces);
                CHECK(a.verdict == b.verdict);
                REQUIRE(a.impacts.size() == b.impacts.size());
                if (a.impacts.empty()) continue;
                ++finite;
                near(a.impacts[0].velocity, b.impacts[0].velocity);
                near(a.impacts[0].dissipated, b.impacts[0].dissipated);
                near(a.impacts[0].contact_time.value_or(0), b.impacts[0].contact_time.value_or(0));
            }
        }
    }
    CHECK(finite >= 30);
}

TEST_CASE("impacts on a table of force over overlap agree with an integration in time") {
    for (const Extended number : {0.0_ext, 0.05_ext, 0.5_ext}) {
        const auto motion = make_motion<ForceTable, Extended>(
            0, ScaledDamping<Extended>::of(DampingLaw::constant, {number}), Detachment::zero_overlap);
        CHECK(motion.squared);
        for (const Extended velocity : {0.05_ext, 0.4_ext, 1.0_ext, 3.0_ext}) {
            const Orbit<Extended> orbit = follow(motion, velocity);
            const InTime expected = in_time(velocity, number);
            CAPTURE(static_cast<double>(velocity));
            CAPTURE(static_cast<double>(number));
            CHECK(std::abs(orbit.maximum_overlap - expected.greatest) < 1e-8L);
            CHECK(std::abs(orbit.restitution(velocity) * velocity - expected.rebound) < 1e-7L);
        }
    }
}

TEST_CASE("the critical velocity of a table divides capture from rebound") {
    int found = 0;
    for (const ScaledDamping<Extended>& damping : dampings()) {
        const auto motion = make_motion<ForceTable, Extended>(0, damping, Detachment::zero_overlap);
        if (!motion.damped()) continue;
        const CriticalImpacts critical = critical_impacts(motion);
        if (critical.impacts.empty()) {
            CHECK(follow(motion, 1e3_ext).outcome == Outcome::capture);
            continue;
        }
        ++found;
        const Extended velocity = critical.impacts[0].velocity;
        CHECK(follow(motion, velocity * (1 - 1e-9_ext)).outcome == Outcome::capture);
        CHECK(follow(motion, velocity * (1 + 1e-9_ext)).outcome == Outcome::rebound);
    }
    CHECK(found >= 6);
}
