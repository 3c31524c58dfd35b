// SPDX-License-Identifier: GPL-3.0-or-later
// Particles across a tube: SciPy's paths, limits, known correlations, conservation, and the case of OpenFOAM
// in docs/exports.
#include "solver/deposition/deposition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/json/document.hpp"
#include "solver/statistics/distribution.hpp"
#include "solver/surrogate/rebound_table.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// Fly ash on a tube of 38 mm in air of 900 C.
const CrossedTube ash_tube{.diameter = 0.038, .velocity = 12, .gas = air_at(1173.15)};

std::vector<ClassImpaction> ash_on_tube(const CrossedTube& tube, const ParticleSizes& sizes, int count) {
    const std::vector<SizeClass> classes = sizes.classes(count);
    return impactions_on(tube, classes, std::vector<double>(classes.size(), 2200));
}

/// v_c falling with the size, as by adhesion [m/s].
std::vector<double> falling_velocities(const std::vector<ClassImpaction>& classes) {
    std::vector<double> critical;
    for (const ClassImpaction& each : classes)
        critical.push_back(2 * std::pow(each.size.diameter() / 20e-6, -5.0 / 6));
    return critical;
}

/// A particle that starts two diameters upstream with the velocity of the jet, by steps of Runge and Kutta:
/// shares no line with the program.
TubePassage jet_passage(const TubeParticle& particle, double offset) {
    using State = std::array<double, 4>;
    const auto rate = [&](const State& s) {
        const double r2 = s[0] * s[0] + s[1] * s[1];
        const double a = 1 - (s[0] * s[0] - s[1] * s[1]) / (r2 * r2) - s[2];
        const double b = -2 * s[0] * s[1] / (r2 * r2) - s[3];
        const double re = particle.reynolds * std::sqrt(a * a + b * b);
        const double k = (1 + particle.drag.coefficient * std::pow(re, 2.0 / 3)) / particle.stokes;
        return State{s[2], s[3], k * a, k * b};
    };
    const auto plus = [](State s, double h, const State& d) {
        for (std::size_t i = 0; i < s.size(); ++i) s[i] += h * d[i];
        return s;
    };
    State s{-4, offset, 1, 0};
    const double h = std::min(0.01, 0.1 * particle.stokes);
    while (s[0] < 1 && s[0] * s[0] + s[1] * s[1] > 1) {
        const State k1 = rate(s);
        const State k2 = rate(plus(s, h / 2, k1));
        const State k3 = rate(plus(s, h / 2, k2));
        const State k4 = rate(plus(s, h, k3));
        for (std::size_t i = 0; i < s.size(); ++i) s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    return {.arrives = s[0] < 1,
            .angle = std::atan2(s[1], -s[0]),
            .normal = -(s[0] * s[2] + s[1] * s[3]) / std::hypot(s[0], s[1])};
}

/// Follows particles one by one by interpolation between the classes around their size, the arrivals of both
/// at the same share of the critical offset; needs no memory beyond the classes.
struct ParticleCount {
    const std::vector<ClassImpaction>& classes;
    const std::vector<double>& critical;  ///< of each class [m/s]
    double gas_velocity;
    std::size_t arrived = 0, stayed = 0;

    void add(double diameter, double offset) {
        const auto above = std::ranges::lower_bound(
            classes, diameter, {}, [](const ClassImpaction& each) { return each.size.diameter(); });
        const auto upper = static_cast<std::size_t>(
            std::min<std::ptrdiff_t>(above - classes.begin(), std::ssize(classes) - 1));
        const std::size_t lower = above == classes.begin() || above == classes.end() ? upper : upper - 1;
        const double small = classes[lower].size.diameter();
        const double large = classes[upper].size.diameter();
        const double part = lower == upper ? 0 : std::log(diameter / small) / std::log(large / small);
        const auto between = [&](double a, double b) { return (1 - part) * a + part * b; };
        const TubeImpaction& first = classes[lower].impaction;
        const TubeImpaction& second = classes[upper].impaction;
        const double most = between(first.efficiency(), second.efficiency());
        if (!(offset < most)) return;
        ++arrived;
        const double share = offset / most;
        const auto normal = [&](const TubeImpaction& impaction) {
            return impaction.any() ? impaction.at_offset(share * impaction.efficiency()).normal : 0;
        };
        if (gas_velocity * between(normal(first), normal(second)) < between(critical[lower], critical[upper]))
            ++stayed;
    }
};

}  // namespace

TEST_CASE("paths across a tube are those of SciPy to 1e-6, and curves between 33 of them to 1e-4") {
    std::ifstream file(ASHIMPACT_TEST_DATA "/reference/tube_paths.json");
    const Json rows = Json::parse(file).at("rows");
    Worst exact;
    Worst curves;
    for (const Json& row : rows) {
        const TubeParticle particle{row["stokes"], row["reynolds"], {row["drag"]}};
        const TubeImpaction impaction(particle);
        const double critical = row["critical_offset"];
        const std::string where = row.dump();
        exact.see(relative_difference(impaction.efficiency(), critical), where);
        for (const Json& arrival : row["arrivals"]) {
            const double share = arrival["share"];
            const TubePassage path = tube_passage(particle, share * critical);
            const TubePassage curve = impaction.at_offset(share * impaction.efficiency());
            REQUIRE(path.arrives);
            for (const auto& [name, member] :
                 {std::pair("normal", &TubePassage::normal), std::pair("angle", &TubePassage::angle),
                  std::pair("tangent", &TubePassage::tangent)}) {
                exact.see(relative_difference(path.*member, arrival[name]), where + name);
                curves.see(relative_difference(curve.*member, arrival[name]), where + name);
            }
        }
    }
    CHECK(exact.count() == 100);
    CHECK_MESSAGE(exact.deviation() < 1e-6, exact.where(), exact.deviation());
    CHECK_MESSAGE(curves.deviation() < 1e-4, curves.where(), curves.deviation());
}

TEST_CASE("heavy particles fly straight on, and none of S up to 1/8 meets a tube") {
    const TubeImpaction heavy({.stokes = 1e9, .reynolds = 100});
    CHECK(heavy.efficiency() == doctest::Approx(1).epsilon(1e-7));
    for (const double offset : {0.1, 0.5, 0.9}) {
        const TubePassage arrival = heavy.at_offset(offset);
        CHECK(std::abs(std::sin(arrival.angle) - offset) < 1e-6);
        CHECK(std::abs(arrival.normal - std::cos(arrival.angle)) < 1e-4);
        CHECK(std::abs(arrival.tangent - offset) < 1e-4);
    }
    for (const double stokes : {1e-6, 0.01, 0.1, 0.125})
        CHECK(TubeImpaction({.stokes = stokes}).efficiency() == 0);
    double before = 0;
    for (const double stokes : {0.15, 0.2, 0.3, 0.5, 1.0, 3.0, 10.0, 100.0, 1e4}) {
        const double efficiency = TubeImpaction({.stokes = stokes, .drag = {0}}).efficiency();
        CHECK(efficiency > before);
        before = efficiency;
    }
}

TEST_CASE("efficiencies are those of correlations within 3.5 %, where these hold") {
    // Langmuir & Blodgett 1946, S/(S + pi/2), Stokes' drag.
    for (const double stokes : {2.0, 5.0, 10.0, 20.0, 100.0, 1000.0})
        CHECK(relative_difference(TubeImpaction({.stokes = stokes, .drag = {0}}).efficiency(),
                                  stokes / (stokes + std::numbers::pi / 2)) < 0.03);
    // Israel & Rosner 1982 over the effective Stokes number, at the Reynolds numbers of 100 to 300 behind it.
    // It is closest near 150, there within 2 % but for 0.5 and 1; docs/deposit.md.
    for (const double reynolds : {100.0, 150.0, 300.0})
        for (const double effective : {0.2, 0.3, 0.5, 1.0, 2.0, 5.0, 20.0}) {
            if (effective == 0.2 && reynolds != 150) continue;
            const bool close = reynolds == 150 && effective != 0.5 && effective != 1;
            TubeParticle particle{.stokes = 1, .reynolds = reynolds};
            particle.stokes = effective / particle.effective_stokes();
            CAPTURE(reynolds);
            CAPTURE(effective);
            CHECK(relative_difference(TubeImpaction(particle).efficiency(), israel_rosner(effective)) <
                  (close             ? 0.02
                   : reynolds == 150 ? 0.032
                                     : 0.035));
        }
    // With Stokes' drag it exceeds potential flow, by 8 % at S = 1: docs/deposit.md.
    CHECK(israel_rosner(1) / TubeImpaction({.stokes = 1, .drag = {0}}).efficiency() ==
          doctest::Approx(1.0845).epsilon(1e-3));
    for (const auto& [stokes, value] : {std::pair(0.2, 0.0654), std::pair(0.5, 0.236), std::pair(1.0, 0.415),
                                        std::pair(2.0, 0.601), std::pair(5.0, 0.796), std::pair(10.0, 0.888)})
        CHECK(relative_difference(israel_rosner(stokes), value) < 1e-3);
    const SphereDrag drag;
    double sum = 0;  // the mean of 1/factor by its definition
    for (int i = 0; i < 100'000; ++i) sum += 1 / drag.factor(50 * (i + 0.5) / 100'000) / 100'000;
    CHECK(relative_difference(drag.stopping_ratio(50), sum) < 1e-7);
    CHECK(relative_difference(drag.stopping_ratio(1e-8), drag.stopping_ratio(2e-8)) < 1e-5);
}

TEST_CASE("what stays: nothing without v_c, all with any, and sums over sizes and angles are the same") {
    const std::vector<ClassImpaction> classes =
        ash_on_tube(ash_tube, ParticleSizes::rosin_rammler(20e-6, 1.2), 24);
    const std::vector<double> critical = falling_velocities(classes);
    double arrives = 0;
    double stays = 0;
    double shares = 0;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const ClassImpaction& each = classes[i];
        const double mass = each.size.share * each.impaction.efficiency();
        const double fraction = each.stick_fraction(critical[i], ash_tube.velocity);
        arrives += mass;
        stays += mass * fraction;
        shares += each.size.share;
        CHECK(each.stick_fraction(0, ash_tube.velocity) == 0);
        CHECK(each.stick_fraction(1.001 * fraction * critical[i], ash_tube.velocity) <= fraction + 1e-3);
        if (each.impaction.any()) {
            CHECK(each.stick_fraction(std::numeric_limits<double>::infinity(), ash_tube.velocity) == 1);
            CHECK(each.mean_normal() > 0);
            CHECK(each.mean_normal() < 1);
        }
    }
    CHECK(std::abs(shares - 1) < 1e-12);
    CHECK(stays > 0.05 * arrives);
    CHECK(stays < 0.95 * arrives);
    double arrives_around = 0;
    double stays_around = 0;
    // Restitution as without damping: e^2 v^2 = v^2 - v_c^2.
    std::vector<RestitutionOfVelocity> restitution;
    Rebounds by_size;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        restitution.emplace_back(
            [v_c = critical[i]](double v) { return std::sqrt(1 - v_c * v_c / (v * v)); });
        const Rebounds each = classes[i].rebounds(critical[i], ash_tube.velocity, restitution[i]);
        by_size.add(each, classes[i].size.share);
        CHECK(each.velocity <= ash_tube.velocity);
    }
    CHECK(relative_difference(by_size.share, arrives - stays) < 1e-12);
    Rebounds around;
    for (const ArcImpaction& arc : arcs_of(classes, critical, restitution, ash_tube.velocity, 18)) {
        around.add(arc.rebounds, 1);
        CHECK(std::abs(arc.rebounds.share + arc.stays - arc.arrives) < 1e-13);
        CHECK(arc.stays <= arc.arrives);
        if (arc.arrives > 0) CHECK(arc.incidence * degrees < 90);
        arrives_around += arc.arrives;
        stays_around += arc.stays;
    }
    CHECK(relative_difference(around.restitution, by_size.restitution) < 5e-3);
    CHECK(relative_difference(around.velocity, by_size.velocity) < 5e-3);
    CHECK(relative_difference(arrives_around, arrives) < 1e-12);
    CHECK(relative_difference(stays_around, stays) < 1e-12);

    // One by one, as many as it takes for 0.3 %.
    ParticleCount count{classes, critical, ash_tube.velocity};
    std::mt19937_64 random(41);
    std::uniform_real_distribution<double> uniform;
    constexpr int particles = 200'000;
    for (int i = 0; i < particles; ++i) {
        const double pick = uniform(random);
        double below = 0;
        for (const ClassImpaction& each : classes)
            if ((below += each.size.share) >= pick) {
                count.add(each.size.diameter(), uniform(random));
                break;
            }
    }
    const auto deviations = [](std::size_t counted, double share) {
        return std::abs(static_cast<double>(counted) - particles * share) /
               std::sqrt(particles * share * (1 - share));
    };
    CHECK(deviations(count.arrived, arrives) < 4);
    CHECK(deviations(count.stayed, stays) < 4);
}

TEST_CASE("slower_than() is the set of offsets with a smaller normal velocity") {
    const TubeImpaction impaction({.stokes = 1, .reynolds = 20});
    for (const double normal : {0.01, 0.1, 0.3, 0.37}) {
        const auto ranges = impaction.slower_than(normal);
        REQUIRE(ranges.size() == 1);
        CHECK(ranges.front().to == impaction.efficiency());
        CHECK(relative_difference(impaction.at_offset(ranges.front().from).normal, normal) < 1e-9);
        CHECK(impaction.offset_of_angle(impaction.at_offset(ranges.front().from).angle) ==
              doctest::Approx(ranges.front().from));
    }
    CHECK(impaction.slower_than(0).empty());
}

TEST_CASE("what flies straight at a tube meets it with the cosine of the angle, as a mean over each part") {
    const auto classes = impactions_on(ash_tube, ParticleSizes::one(4e-3).classes(1), {20000});
    const auto arcs = arcs_of(classes, {0.0}, {[](double) { return 0.5; }}, ash_tube.velocity, 18);
    for (const ArcImpaction& arc : arcs) {
        // Offsets are sines: the mean of the cosine over them.
        const double squares = (arc.to - arc.from) / 2 + (std::sin(2 * arc.to) - std::sin(2 * arc.from)) / 4;
        const double mean = squares / (std::sin(arc.to) - std::sin(arc.from));
        CHECK(arc.normal == doctest::Approx(mean).epsilon(2e-3));
    }
    CHECK(classes.front().mean_normal() == doctest::Approx(std::numbers::pi / 4).epsilon(1e-3));
}

TEST_CASE("distributions of sizes by mass, and air") {
    CHECK(ParticleSizes::rosin_rammler(20e-6, 1.2).finer_than(20e-6) == doctest::Approx(1 - std::exp(-1)));
    const ParticleSizes log_normal = ParticleSizes::log_normal(10e-6, 1.8);
    CHECK(log_normal.finer_than(10e-6) == doctest::Approx(0.5));
    CHECK(log_normal.finer_than(18e-6) == doctest::Approx(0.841344746));
    // The median by mass of log-normal numbers: the d at which half of the sum of d^3 is below.
    double sum = 0;
    std::vector<double> below;
    for (int i = -4000; i <= 4000; ++i) {
        const double z = i / 500.0;
        sum += std::exp(-z * z / 2 + 3 * z * std::log(1.8));
        below.push_back(sum);
    }
    const auto half = std::ranges::lower_bound(below, sum / 2) - below.begin();
    CHECK(relative_difference(10e-6 * std::exp((static_cast<double>(half) - 4000) / 500 * std::log(1.8)),
                              mass_median(10e-6, 1.8)) < 2e-3);
    const ParticleSizes table = ParticleSizes::tabulated({10e-6, 20e-6, 80e-6}, {0, 0.5, 1});
    CHECK(table.finer_than(40e-6) == doctest::Approx(0.75));
    CHECK(table.classes(7).front().from == 10e-6);
    CHECK(ParticleSizes::one(5e-6).classes(80).size() == 1);
    const auto whole = table.classes(7);
    const auto parts = table.classes(7, 0, 9);
    REQUIRE(parts.size() == 9 * whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        double share = 0;
        for (std::size_t k = 0; k < 9; ++k) share += parts[9 * i + k].share;
        CHECK(std::abs(share - whole[i].share) < 1e-14);
        CHECK(std::abs(parts[9 * i + 4].diameter() / whole[i].diameter() - 1) < 1e-14);
    }
    // U.S. Standard Atmosphere 1976 at 288.15 K.
    CHECK(relative_difference(air_at(288.15).viscosity, 1.7894e-5) < 1e-4);
    CHECK(relative_difference(air_at(288.15).density, 1.2250) < 1e-4);
}

TEST_CASE("the jet of docs/exports: OpenFOAM's 23,380 arrivals and 4,562 at first impact") {
    const auto below = [](double d) { return -std::expm1(-std::pow((d - 2e-6) / 25e-6, 1.2)); };
    const std::vector<double> diameters = logarithmic_grid(2e-6, 120e-6, 61);
    double arrives = 0;
    double stays_in_front = 0;  // within 15 degrees
    double stays = 0;           // beyond
    double far_arrives = 0;
    const Law law = Law::named("brach-dunn");
    const CrossedTube tube{
        .diameter = 0.038, .velocity = 10, .gas = {0.44, 0.44 * 8.2e-5}, .drag = {1.0 / 6}};
    for (std::size_t i = 0; i + 1 < diameters.size(); ++i) {
        const double share = (below(diameters[i + 1]) - below(diameters[i])) / below(120e-6);
        const double d = std::sqrt(diameters[i] * diameters[i + 1]);
        const TubeParticle particle = tube.particle(d, 2179.5);
        if (particle.stokes < 0.125) continue;
        // The contact of the 88 um sample and its critical damping, which goes with d^2 there.
        const ContactPair contact{.mass = std::numbers::pi / 6 * d * d * d * 2179.5,
                                  .effective_radius = d / 2,
                                  .contact_modulus = 89.0741964341e9,
                                  .work_of_adhesion = 0.2984};
        const Damping damping{DampingLaw::constant, 0.0141 * std::pow(d / 88e-6, 2)};
        const double critical =
            quick_critical_velocity({law, law.default_detachment(), damping, contact}).value.value() /
            tube.velocity;
        constexpr int offsets = 50;
        for (int k = 0; k < offsets; ++k) {
            const TubePassage path = jet_passage(particle, (k + 0.5) / offsets);
            if (!path.arrives) continue;
            arrives += share / offsets;
            if (path.normal < critical)
                (path.angle * degrees < 15 ? stays_in_front : stays) += share / offsets;
        }
        far_arrives += share * TubeImpaction(particle).efficiency();
    }
    const double flying = 100'000 * std::sqrt(0.5);  // the jet is sqrt(1/2) diameters high
    CHECK(relative_difference(flying * arrives, 23380) < 0.015);
    // At the front OpenFOAM interpolates the flow between cells of a tenth of the radius, so that particles
    // with S below 1/8 arrive there, and slow ones: 1,629 stay within 15 degrees, where potential flow gives
    // 1,100.
    CHECK(relative_difference(flying * stays, 4562 - 1629) < 0.08);
    CHECK(flying * stays_in_front == doctest::Approx(1100).epsilon(0.05));
    // From infinity the same offsets are 1/16 smaller: at two diameters the gas has widened by that.
    CHECK(relative_difference(far_arrives / arrives, 1 - 1.0 / 16) < 0.02);
}
