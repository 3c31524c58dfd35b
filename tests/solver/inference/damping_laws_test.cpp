// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts made with one damping law are explained by it, with its constants, at every size.
#include "solver/inference/damping_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "solver/contact/maugis_dugdale.hpp"
#include "solver/damping/brach_dunn.hpp"
#include "solver/motion/impact.hpp"
#include "solver/surrogate/rebound_table.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Units of length, mass and time, in SI.
struct UnitsOfFit {
    double length = 1, mass = 1, time = 1;

    [[nodiscard]] double velocity() const { return length / time; }
    [[nodiscard]] double pressure() const { return mass / (length * time * time); }
    [[nodiscard]] double energy_per_area() const { return mass / (time * time); }
};

ContactPair sphere_of(double radius, const UnitsOfFit& units = {}) {
    const double mass = 4.0 / 3.0 * std::numbers::pi * 2300 * radius * radius * radius;
    return {.mass = mass / units.mass,
            .effective_radius = radius / units.length,
            .contact_modulus = 90e9 / units.pressure(),
            .work_of_adhesion = 0.3 / units.energy_per_area()};
}

/// Three samples with impacts from @p slowest to sixty times that, with the same constants.
std::vector<ImpactsOfSample> three_samples(Law law, const Damping& damping, double second, double slowest,
                                           int points) {
    std::vector<ImpactsOfSample> samples;
    for (const double radius : {44e-6, 48e-6, 52e-6}) {
        ImpactsOfSample each{.contact = sphere_of(radius), .impacts = {}};
        ContactPair contact = each.contact;
        if (!parameters_of(damping.law).empty()) contact.parameters.set(adhesion_damping.name, second);
        for (int i = 0; i < points; ++i) {
            const double v = slowest * std::pow(60.0, i / (points - 1.0));
            const double e = restitution_of({law, law.default_detachment(), damping, contact, v});
            each.impacts.push_back({.velocity = v, .rebound = e * v});
        }
        samples.push_back(std::move(each));
    }
    return samples;
}

/// The same with scatter of v_r, 2 % of v_in.
std::vector<ImpactsOfSample> with_scatter(std::vector<ImpactsOfSample> samples, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (ImpactsOfSample& sample : samples)
        for (Measurement& impact : sample.impacts)
            if (impact.rebound > 0)
                impact.rebound = std::max(0.0, impact.rebound + 0.02 * impact.velocity * normal(random));
    return samples;
}

std::vector<FittedDamping> fits_of(Law law, const std::vector<ImpactsOfSample>& samples) {
    return fit_damping_laws(law, law.default_detachment(), samples);
}

const FittedDamping& fit_by(const std::vector<FittedDamping>& all, DampingLaw law) {
    return *std::ranges::find(all, law, &FittedDamping::law);
}

CriticalVelocityProblem problem_of(Law law, const FittedDamping& fitted, double radius) {
    return {law, law.default_detachment(), fitted.damping(), contact_with(fitted, sphere_of(radius))};
}

}  // namespace

TEST_CASE("the damping law that made the impacts explains them, and gives v_c of other sizes") {
    for (const char* name : {"dmt", "jkr"})
        for (const Damping& truth :
             {Damping{DampingLaw::constant, 0.005}, Damping{DampingLaw::contact_radius, 1500.0},
              Damping{DampingLaw::tsuji, 0.4}, Damping{DampingLaw::hunt_crossley, 0.3}}) {
            CAPTURE(name);
            CAPTURE(name_of(truth.law));
            const Law law = Law::named(name);
            const auto all = fits_of(law, three_samples(law, truth, 0, 0.03, 24));
            REQUIRE(all.size() == all_values<DampingLaw>.size());
            const FittedDamping& own = fit_by(all, truth.law);
            CHECK(own.misfit < 1e-7);
            CHECK(own.evidence == DampingEvidence::explains);
            REQUIRE(own.constants.size() == 1);
            for (const FittedDamping& other : all)
                if (other.law != truth.law && other.law != DampingLaw::brach_dunn) {
                    CHECK(other.misfit > 0.02);
                    CHECK(other.evidence == DampingEvidence::rejected);
                }
            for (const double radius : {10e-6, 48e-6, 200e-6}) {
                const CriticalVelocity expected =
                    critical_velocity({law, law.default_detachment(), truth, sphere_of(radius)});
                const CriticalVelocity found = critical_velocity(problem_of(law, own, radius));
                const bool smooth = law == Law::named("dmt");
                CHECK(relative_difference(*found.value, *expected.value) < (smooth ? 1e-9 : 1e-6));
            }
        }
}

TEST_CASE("two constants are found where adhesion counts, and are undetermined where it does not") {
    const Damping truth{DampingLaw::brach_dunn, 0.3};
    const Law law = Law::named("dmt");
    const auto near = fits_of(law, three_samples(law, truth, 2.0, 0.03, 24));
    const FittedDamping& own = fit_by(near, DampingLaw::brach_dunn);
    CHECK(own.misfit < 1e-8);
    REQUIRE(own.constants.size() == 2);
    CHECK(relative_difference(own.constants[0].value, 0.3) < 1e-7);
    CHECK(relative_difference(own.constants[1].value, 2.0) < 1e-7);
    CHECK(std::abs(*own.correlation) < greatest_correlation);
    // Strong attraction beside weak repulsion, whose valley is narrow.
    const auto strong = fits_of(law, three_samples(law, {DampingLaw::brach_dunn, 1}, 70.0, 0.03, 24));
    const FittedDamping& attracted = fit_by(strong, DampingLaw::brach_dunn);
    CHECK(attracted.misfit < 1e-5);
    CHECK(attracted.evidence == DampingEvidence::explains);
    REQUIRE(attracted.constants.size() == 2);
    CHECK(relative_difference(attracted.constants[1].value, 70.0) < 1e-4);
    const Law hertz = Law::named("hertz");
    const auto far = fits_of(hertz, three_samples(hertz, truth, 2.0, 0.03, 12));
    const FittedDamping& untold = fit_by(far, DampingLaw::brach_dunn);
    CHECK(untold.constants.empty());
    CHECK(untold.evidence == DampingEvidence::untold);
    CHECK(untold.correlation);
    CHECK(fit_by(far, DampingLaw::hunt_crossley).misfit < 1e-7);
}

TEST_CASE("no bit of the fits depends on the order of samples and impacts") {
    const Law law = Law::named("jkr");
    auto samples = with_scatter(three_samples(law, {DampingLaw::contact_radius, 1500}, 0, 0.1, 40), 1);
    const auto first = fits_of(law, samples);
    std::mt19937 random(7);
    for (ImpactsOfSample& sample : samples) std::ranges::shuffle(sample.impacts, random);
    std::ranges::rotate(samples, samples.begin() + 1);
    const auto second = fits_of(law, samples);
    REQUIRE(first.size() == second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].misfit == second[i].misfit);
        REQUIRE(first[i].constants.size() == second[i].constants.size());
        for (std::size_t k = 0; k < first[i].constants.size(); ++k) {
            CHECK(first[i].constants[k].value == second[i].constants[k].value);
            CHECK(first[i].constants[k].uncertainty == second[i].constants[k].uncertainty);
        }
    }
}

TEST_CASE("fits go with the units") {
    const UnitsOfFit units{7.3, 0.21, 3.7};
    for (const char* name : {"dmt", "jkr"}) {
        const Law law = Law::named(name);
        auto samples = with_scatter(three_samples(law, {DampingLaw::tsuji, 0.3}, 0, 0.1, 40), 2);
        const auto first = fits_of(law, samples);
        for (ImpactsOfSample& sample : samples) {
            sample.contact = sphere_of(sample.contact.effective_radius, units);
            for (Measurement& impact : sample.impacts) {
                impact.velocity /= units.velocity();
                impact.rebound /= units.velocity();
            }
        }
        const auto second = fits_of(law, samples);
        REQUIRE(first.size() == second.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            CAPTURE(name_of(first[i].law));
            CHECK(relative_difference(first[i].misfit, second[i].misfit) < 1e-12);
            REQUIRE(first[i].constants.size() == second[i].constants.size());
            for (std::size_t k = 0; k < first[i].constants.size(); ++k) {
                double unit = 1;  // of tsuji
                if (first[i].law == DampingLaw::constant) unit = units.mass / units.time;
                if (first[i].law == DampingLaw::contact_radius)
                    unit = units.mass / (units.time * units.length);
                if (first[i].constants[k].dimension == Dimension::inverse_velocity)
                    unit = 1 / units.velocity();
                CHECK(relative_difference(first[i].constants[k].value, second[i].constants[k].value * unit) <
                      1e-12);
            }
        }
    }
}

TEST_CASE("the constant of many scattered impacts is that of the truth within its uncertainty") {
    const Law law = Law::named("dmt");
    const Damping truth{DampingLaw::contact_radius, 1500};
    const auto clean = three_samples(law, truth, 0, 0.1, 1334);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const auto all = fits_of(law, with_scatter(clean, seed));
        const FittedDamping& own = fit_by(all, truth.law);
        REQUIRE(own.constants.size() == 1);
        CHECK(own.evidence == DampingEvidence::explains);
        CHECK(own.misfit == doctest::Approx(0.02).epsilon(0.05));
        CHECK(own.constants[0].uncertainty < 0.003 * truth.coefficient);
        CHECK(std::abs(own.constants[0].value - truth.coefficient) < 3 * own.constants[0].uncertainty);
        CHECK(fit_by(all, DampingLaw::constant).evidence == DampingEvidence::rejected);
    }
}

TEST_CASE("a constant scatters by its standard uncertainty where both velocities are read with error") {
    const Law law = Law::named("jkr");
    const ContactPair contact = sphere_of(30e-6);
    const Damping truth{DampingLaw::constant, 0.004};
    const double critical = *critical_velocity({law, law.default_detachment(), truth, contact}).value;
    const ReboundTable table({law, law.default_detachment(), truth, contact, 1},
                             {0.3 * critical, 5 * critical});
    for (const double noise : {0.1, 0.02}) {  // over v_c: a camera
        std::mt19937 random(11);
        std::normal_distribution<double> normal(0, noise * critical);
        std::uniform_real_distribution<double> velocity(0.6 * critical, 3 * critical);
        constexpr int tables = 30;
        double squares = 0;
        int held = 0;
        for (int i = 0; i < tables; ++i) {
            ImpactsOfSample sample{.contact = contact, .impacts = {}};
            for (int k = 0; k < 40; ++k) {
                const double v = velocity(random);
                const double ratio = table.energy_ratio(std::log(v));
                const double read = v + normal(random);
                const double rebound = ratio > 0 ? std::max(0.0, v * std::sqrt(ratio) + normal(random)) : 0;
                sample.impacts.push_back({.velocity = read, .rebound = rebound});
            }
            const FittedDamping own = fit_by(fits_of(law, {sample}), truth.law);
            REQUIRE(own.constants.size() == 1);
            const double z = (own.constants[0].value - truth.coefficient) / own.constants[0].uncertainty;
            squares += z * z;
            held += std::abs(z) < 1.96 ? 1 : 0;
        }
        CHECK(std::sqrt(squares / tables) < 1.2);
        CHECK(std::sqrt(squares / tables) > 0.7);
        CHECK(held >= 27);
    }
}

TEST_CASE("a capture bounds the damping: it counts only where the law lets the particle rebound") {
    const Law law = Law::named("dmt");
    const Damping truth{DampingLaw::constant, 0.005};
    auto samples = with_scatter(three_samples(law, truth, 0, 0.3, 30), 3);
    const double before = fit_by(fits_of(law, samples), truth.law).constants[0].value;
    const double critical =
        *critical_velocity({law, law.default_detachment(), truth, samples[0].contact}).value;
    for (const double share : {0.2, 0.4, 0.6})
        samples[0].impacts.push_back({.velocity = share * critical, .rebound = 0});
    CHECK(relative_difference(fit_by(fits_of(law, samples), truth.law).constants[0].value, before) < 1e-5);
    for (const double times : {2.0, 3.0, 4.0})
        samples[0].impacts.push_back({.velocity = times * critical, .rebound = 0});
    CHECK(fit_by(fits_of(law, samples), truth.law).constants[0].value > 1.02 * before);
}

TEST_CASE("two impacts, or captures alone, are not compared with damping laws") {
    const Law law = Law::named("dmt");
    std::vector<ImpactsOfSample> samples{{.contact = sphere_of(44e-6), .impacts = {}}};
    samples.front().impacts = {{.velocity = 1, .rebound = 0.5}, {.velocity = 2, .rebound = 1.2}};
    CHECK(fits_of(law, samples).empty());
    samples.front().impacts = {
        {.velocity = 1, .rebound = 0}, {.velocity = 2, .rebound = 0}, {.velocity = 3, .rebound = 0}};
    CHECK(fits_of(law, samples).empty());
}

TEST_CASE("a table of rebounds agrees with solved impacts, beyond yield too") {
    for (const char* name : {"hertz", "dmt", "jkr", "sjkr", "maugis-dugdale", "thornton-ning"})
        for (const Damping& damping :
             {Damping{DampingLaw::constant, 0.005}, Damping{DampingLaw::contact_radius, 1500.0},
              Damping{DampingLaw::tsuji, 0.4}, Damping{DampingLaw::hunt_crossley, 0.3}}) {
            CAPTURE(name);
            CAPTURE(name_of(damping.law));
            const Law law = Law::named(name);
            ContactPair contact = sphere_of(44e-6);
            for (const LawParameter& parameter : law.parameters())
                if (parameter.choice == 0 || parameter.name == cohesion_range.name)
                    contact.parameters.set(parameter.name, parameter.typical);
            if (law.is_plastic()) contact.yield_pressure = 3e9;
            Impact impact{law, law.default_detachment(), damping, contact, 1};
            const ReboundTable table(impact, {0.05, 5});
            double worst = 0;
            for (int i = 0; i <= 60; ++i) {
                impact.velocity = 0.05 * std::pow(100.0, i / 60.0);
                const double ratio = table.energy_ratio(std::log(impact.velocity));
                const double e = ratio > 0 ? std::sqrt(ratio) : 0;
                worst = std::max(worst, std::abs(e - restitution_of(impact)));
            }
            CHECK(worst < 1e-6);
        }
}
