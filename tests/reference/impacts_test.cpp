// SPDX-License-Identifier: GPL-3.0-or-later

// Every impact of data/reference/impacts.json: an independent time-domain integration (DOP853, rtol 1e-12).
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/published.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Parameters of the law's own, by name; none where the row has none.
ParameterValues<double> parameters_of(const nlohmann::json& row) {
    ParameterValues<double> values;
    for (const LawParameter& parameter : law_parameters())
        if (row.contains("parameters") && row.at("parameters").contains(parameter.name))
            values.set(parameter.name, row.at("parameters").at(parameter.name).get<double>());
    return values;
}

Impact impact_from(const nlohmann::json& sphere, const nlohmann::json& row) {
    return {.law = Law::named(row.at("law").get<std::string>()),
            .detachment = named<Detachment>(row.at("detachment").get<std::string>()),
            .damping = {DampingLaw::constant, row.at("damping")},
            .contact = {.mass = sphere.at("mass"),
                        .effective_radius = sphere.at("radius"),
                        .contact_modulus = sphere.at("contact_modulus"),
                        .work_of_adhesion = row.at("work_of_adhesion"),
                        .parameters = parameters_of(row)},
            .velocity = row.at("velocity")};
}

struct Deviations {
    Worst restitution;
    Worst contact_time;
    Worst maximum_overlap;

    void see(const nlohmann::json& row, const ImpactResult& result) {
        const std::string where = row.dump();
        restitution.see(relative_difference(result.restitution, row.at("restitution")), where);
        if (!row.at("contact_time").is_null()) {
            contact_time.see(relative_difference(result.contact_time.value(), row.at("contact_time")), where);
        }
        if (!row.at("maximum_overlap").is_null()) {
            maximum_overlap.see(relative_difference(result.maximum_overlap, row.at("maximum_overlap")),
                                where);
        }
    }
};

constexpr ContactCase hertz{Law::of<Hertz>(), DampingLaw::constant, Detachment::zero_overlap};

double critical_with(double damping) {
    return critical_velocity({hertz.law, hertz.detachment, {DampingLaw::constant, damping}, ash(0.0)})
        .value.value();
}

/// m^3 k^2/eta^5 [s/m].
double constant_unit(double damping) {
    const double k = hertz_stiffness(ash(0.0));
    return std::pow(ash(0.0).mass, 3) * k * k / std::pow(damping, 5);
}

}  // namespace

TEST_CASE("every reference impact: outcome, restitution, contact time and overlap") {
    const nlohmann::json data = data_file("reference/impacts.json");
    Deviations by_place;
    Deviations by_force;
    std::set<std::string> laws;
    int captures = 0;
    for (const auto& row : data.at("cases")) {
        CAPTURE(row.dump());
        const ImpactResult result = solve_impact(impact_from(data.at("sphere"), row));
        REQUIRE(std::string(name_of(result.outcome)) == row.at("outcome").get<std::string>());
        CHECK(result.contact_time.has_value() == !row.at("contact_time").is_null());
        captures += result.outcome == Outcome::capture ? 1 : 0;
        const auto detachment = row.at("detachment").get<std::string>();
        laws.insert(row.at("law").get<std::string>());
        (detachment == "zero-force" ? by_force : by_place).see(row, result);
    }
    CHECK(by_force.restitution.count() > 0);
    CHECK(by_place.restitution.count() + by_force.restitution.count() ==
          static_cast<int>(data.at("cases").size()));
    CHECK(captures > 0);
    for (std::size_t i = 0; i < Law::count(); ++i) {
        if (Law::at(i) == Law::of<ThorntonNing>()) continue;   // elastic, it is jkr; see its own tests
        if (Law::at(i) == Law::of<MaugisDugdale>()) continue;  // tests/oracles integrates it in time
        CAPTURE(Law::at(i).name());
        CHECK(laws.contains(std::string(Law::at(i).name())));
    }
    CHECK_MESSAGE(by_place.restitution.deviation() < 1e-9, by_place.restitution.where());
    CHECK_MESSAGE(by_place.contact_time.deviation() < 1e-9, by_place.contact_time.where());
    CHECK_MESSAGE(by_place.maximum_overlap.deviation() < 1e-9, by_place.maximum_overlap.where());
    CHECK_MESSAGE(by_force.restitution.deviation() < 1e-7, by_force.restitution.where());
    CHECK_MESSAGE(by_force.contact_time.deviation() < 1e-7, by_force.contact_time.where());
}

// Constants of the Hertz impact, at fly-ash scale.

TEST_CASE("elastic impact: overlap (5/4)^(2/5), contact time 3.21806546 in units of delta0 and delta0/v") {
    const double k = 4.0 / 3.0 * 90e9 * std::sqrt(44e-6);
    // Time by Hertz 1881: 2 (5/4)^(2/5) times the integral of (1 - x^(5/2))^(-1/2), a beta function.
    const double beta = std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
    const double time_constant = 2.0 * std::pow(1.25, 0.4) * 0.4 * beta;
    CHECK(std::abs(time_constant - 3.21806546) < 5e-9);
    CHECK(std::abs(std::pow(1.25, 0.4) - 1.09336207) < 5e-9);
    for (const double v : ash_velocities) {
        const ImpactResult result = solve_impact(impact_of(hertz, ash(0.0), 0.0, v));
        const double delta0 = std::pow(ash(0.0).mass * v * v / k, 0.4);
        CAPTURE(v);
        CHECK(relative_difference(result.maximum_overlap, std::pow(1.25, 0.4) * delta0) < 1e-14);
        CHECK(relative_difference(result.contact_time.value(), time_constant * delta0 / v) < 1e-14);
        CHECK(relative_difference(result.approach_time.value(), 0.5 * time_constant * delta0 / v) < 1e-14);
        CHECK(std::abs(result.restitution - 1.0) < 1e-15);
    }
}

TEST_CASE("v_c = 0.5476175 eta^5/(m^3 k^2); d ln v_c/d ln eta = 5") {
    for (const double damping : {0.005, 0.0153, 0.07}) {
        const double constant = critical_with(damping) * constant_unit(damping);
        CAPTURE(damping);
        CHECK(relative_difference(constant, 0.5476175) < 1e-6);
        // 30 digits arithmetic: Taylor series from the end of contact back to first touch.
        CHECK(relative_difference(constant, 0.54761752963804861) < 1e-13);
        CHECK(relative_difference(constant, hertz_critical_constant) < 1e-13);
        CHECK(relative_difference(critical_with(1.01 * damping) / critical_with(damping), std::pow(1.01, 5)) <
              1e-13);
    }
}

TEST_CASE("capture from beta = 1.1279881 on, where the impact ends at zero overlap") {
    for (const double v : ash_velocities) {
        CAPTURE(v);
        const double critical = 1.12798813552017;
        CHECK(solve_impact(impact_of(hertz, ash(0.0), critical * (1 - 1e-12), v)).outcome ==
              Outcome::rebound);
        CHECK(solve_impact(impact_of(hertz, ash(0.0), critical * (1 + 1e-12), v)).outcome ==
              Outcome::capture);
    }
}

TEST_CASE("Tsuji's damping makes the Hertz impact a linear oscillator: e = exp(-pi zeta/sqrt(1 - zeta^2))") {
    for (const double zeta : {0.01, 0.1, 0.5, 0.9, 0.99}) {
        const Impact impact = impact_of({Law::of<Hertz>(), DampingLaw::tsuji, Detachment::zero_overlap},
                                        ash(0.0), zeta * std::sqrt(5.0), 2.0);
        CAPTURE(zeta);
        CHECK(relative_difference(solve_impact(impact).restitution,
                                  std::exp(-std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta))) < 1e-12);
    }
}
