// SPDX-License-Identifier: GPL-3.0-or-later
// Every impact of data/reference/impacts.json: an independent time-domain integration (DOP853, rtol 1e-12).
// The static JKR law against Dong et al. 2013, Eqs. 15-20 (SI) and 25-27 (normalised), written from the paper
// as corrected in docs/errata.md.
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/published.hpp"
#include "tests/support/quadrature.hpp"

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

/// The contact, law and damping of a row of damped_impacts.json.
Impact damped_impact(const nlohmann::json& row, double velocity) {
    ParameterValues<double> values;
    for (const LawParameter& parameter : law_parameters())
        if (row.contains(parameter.name)) values.set(parameter.name, row.at(parameter.name).get<double>());
    return {
        .law = Law::named(row.at("law").get<std::string>()),
        .detachment = named<Detachment>(row.at("detachment").get<std::string>()),
        .damping = {named<DampingLaw>(row.at("damping_law").get<std::string>()), row.at("damping")},
        .contact = {.mass = row.at("mass"),
                    .effective_radius = row.at("effective_radius"),
                    .contact_modulus = row.at("contact_modulus"),
                    .work_of_adhesion = row.at("work_of_adhesion"),
                    .yield_pressure = row.value("yield_pressure", std::numeric_limits<double>::infinity()),
                    .parameters = values},
        .velocity = velocity};
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

constexpr double pi = std::numbers::pi;

/// Eqs. 25-27 at a normalised contact radius.
struct Published {
    double overlap;
    double repulsive;
    double attractive;
    double total;
};

Published published(double a) {
    Published p{};
    p.overlap = a * a - 2.0 * std::sqrt(2.0 * a / 3.0);
    p.total = std::pow(a, 3.0) - std::sqrt(6.0) * std::pow(a, 1.5);
    if (a > std::cbrt(2.0 / 3.0)) {
        p.attractive = -2.0 * std::pow(2.0 * a / 3.0, 0.75);
        p.repulsive = p.total + 2.0 * std::pow(2.0 * a / 3.0, 0.75);
    } else {
        p.attractive = p.total;
    }
    return p;
}

/// Normalised constants of Eq. 21 for a pair.
struct Units {
    double radius;
    double overlap;
    double force;
};

Units units_of(const ContactPair& pair) {
    const double w = pair.work_of_adhesion;
    const double r = pair.effective_radius;
    const double e = pair.contact_modulus;
    const double k = 4.0 / 3.0 * e;
    return {std::cbrt(pi * w * r * r / k), std::cbrt(9.0 * pi * pi * w * w * r / (16.0 * e * e)), pi * w * r};
}

const StaticCurve& normalised() {
    static const StaticCurve curve = StaticCurve::normalised(Law::of<Jkr>());
    return curve;
}

/// F_a of Eqs. 22-24 at a normalised overlap; F_r is overlap^(3/2) for all three.
double published_attraction(Law law, double overlap) {
    if (law == Law::of<Dmt>()) return -2.0;
    if (law == Law::of<BrachDunn>()) return -std::pow(6.0, 2.0 / 3.0) * std::sqrt(overlap);
    return 0.0;
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

TEST_CASE("every reference impact with damping that follows the force, and every critical velocity") {
    const nlohmann::json data = data_file("reference/damped_impacts.json");
    Deviations worst;
    Worst dissipated;
    Worst velocities;
    std::set<std::string> laws;
    int captures = 0;
    for (const auto& row : data.at("cases")) {
        CAPTURE(row.dump());
        const ImpactResult result = solve_impact(damped_impact(row, row.at("velocity")));
        REQUIRE(std::string(name_of(result.outcome)) == row.at("outcome").get<std::string>());
        captures += result.outcome == Outcome::capture ? 1 : 0;
        laws.insert(row.at("law").get<std::string>() + ' ' + row.at("damping_law").get<std::string>());
        worst.see(row, result);
        dissipated.see(relative_difference(result.energy.dissipated, row.at("dissipated")), row.dump());
    }
    CHECK(worst.restitution.count() == 200);
    CHECK(captures > 20);
    for (std::size_t i = 0; i < Law::count(); ++i)
        for (const std::string_view damping : {"hunt-crossley", "brach-dunn-damping"})
            CHECK(laws.contains(std::string(Law::at(i).name()) + ' ' + std::string(damping)));
    CHECK_MESSAGE(worst.restitution.deviation() < 1e-9, worst.restitution.where());
    CHECK_MESSAGE(worst.contact_time.deviation() < 1e-9, worst.contact_time.where());
    CHECK_MESSAGE(worst.maximum_overlap.deviation() < 1e-9, worst.maximum_overlap.where());
    CHECK_MESSAGE(dissipated.deviation() < 1e-9, dissipated.where());
    for (const auto& row : data.at("critical_velocities")) {
        const Impact impact = damped_impact(row, 1.0);
        const CriticalVelocity found =
            critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
        CAPTURE(row.dump());
        REQUIRE(found.value);
        velocities.see(relative_difference(*found.value, row.at("critical_velocity")), row.dump());
    }
    CHECK(velocities.count() == 60);
    CHECK_MESSAGE(velocities.deviation() < 1e-9, velocities.where());
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

TEST_CASE("normalised: Eqs. 25-27 on both ranges of contact radius") {
    Worst worst;
    for (int i = 0; i < 345; ++i) {
        const double a = std::pow(6.0, -1.0 / 3.0) * (1.0 + 1e-12) + 0.01 * i;
        const StaticPoint point = normalised().at_contact_radius(a);
        const Published p = published(a);
        const double size = a * a * a + std::sqrt(6.0) * std::pow(a, 1.5);
        const std::string where = std::to_string(a);
        worst.see(std::abs(point.overlap - p.overlap) / (a * a + 1.0), where);
        worst.see(std::abs(point.repulsive_force - p.repulsive) / size, where);
        worst.see(std::abs(point.attractive_force - p.attractive) / size, where);
        worst.see(std::abs(point.force() - p.total) / size, where);
    }
    CHECK(worst.count() > 1000);
    CHECK_MESSAGE(worst.deviation() < 1e-14, worst.where());
}

TEST_CASE(
    "SI at fly-ash scale: contact radius of a force (Eq. 15), pressures and their integrals (Eqs. 16-20)") {
    Worst worst;
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const double r = pair.effective_radius;
        const double k = 4.0 / 3.0 * pair.contact_modulus;
        const StaticCurve curve(Law::of<Jkr>(), pair);
        for (const double ratio : {1.2, 1.5, 2.5, 6.0}) {
            const double a = ratio * units_of(pair).radius;
            const StaticPoint point = curve.at_contact_radius(a);
            const double f = point.force();
            const double three = 3.0 * pi * w * r;
            const std::string where = std::to_string(w) + " " + std::to_string(ratio);
            const double cube = r / k * (f + three + std::sqrt(2.0 * three * f + three * three));  // Eq. 15
            worst.see(relative_difference(std::cbrt(cube), a), where);
            const double overlap = (a * a - std::sqrt(8.0 * pi * w * r * r / (3.0 * k) * a)) / r;  // Eq. 16
            worst.see(relative_difference(point.overlap, overlap), where);
            const double p0 = 3.0 * a * k / (2.0 * pi * r);
            const double q0 = std::sqrt(3.0 * w * k / (2.0 * pi * a)) / p0;
            const double area = pi * a * a * p0;
            worst.see(relative_difference(point.attractive_force, -4.0 / 3.0 * std::pow(q0, 1.5) * area),
                      where);
            worst.see(std::abs(f - (2.0 / 3.0 - 2.0 * q0) * area) / area, where);  // Eq. 19
            const double repulsive = (2.0 / 3.0 - 2.0 * q0 + 4.0 / 3.0 * std::pow(q0, 1.5)) * area;
            worst.see(std::abs(point.repulsive_force - repulsive) / area, where);  // Eq. 20
        }
    }
    CHECK_MESSAGE(worst.deviation() < 1e-13, worst.where());
}

TEST_CASE("pull-off: the largest tension is (3/2) pi w R at abar = (3/2)^(1/3)") {
    const double least = normalised().at_contact_radius(std::cbrt(1.5)).force();
    CHECK(relative_difference(least, -1.5) < 1e-15);
    for (const double a : {0.9, 0.999, 1.001, 1.1}) {
        CHECK(normalised().at_contact_radius(a * std::cbrt(1.5)).force() > least);
    }
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const double tension = StaticCurve(Law::of<Jkr>(), pair)
                                   .at_contact_radius(std::cbrt(1.5) * units_of(pair).radius)
                                   .force();
        CHECK(relative_difference(tension, -1.5 * pi * w * 44e-6) < 1e-14);
        CHECK(relative_difference(tension, -jkr_pull_off_force(pair)) < 1e-14);
    }
}

TEST_CASE("the fold: abar = 6^(-1/3), deltabar = -3 6^(-2/3), (5/9) of the pull-off force") {
    const StaticPoint fold = normalised().first();
    CHECK(relative_difference(fold.contact_radius, std::pow(6.0, -1.0 / 3.0)) < 1e-15);
    CHECK(relative_difference(fold.overlap, -3.0 * std::pow(6.0, -2.0 / 3.0)) < 1e-15);
    CHECK(relative_difference(fold.force(), -5.0 / 9.0 * 1.5) < 1e-15);
    CHECK(fold.repulsive_force == 0.0);
    // No static contact is more stretched.
    CHECK(normalised().at_contact_radius(1.01 * fold.contact_radius).overlap > fold.overlap);
    CHECK(published(0.99 * fold.contact_radius).overlap > fold.overlap);
}

TEST_CASE("first touch: abar = (8/3)^(1/3) at zero overlap, (8/9) of the pull-off force") {
    const StaticPoint touch = normalised().at_overlap(0.0);
    CHECK(relative_difference(touch.contact_radius, std::cbrt(8.0 / 3.0)) < 1e-15);
    CHECK(relative_difference(touch.force(), -8.0 / 9.0 * 1.5) < 1e-14);
}

TEST_CASE("the work from first touch to the end is 7.092196, at the largest tension 3.502602") {
    // In SI, by quadrature of the force over the overlap in a variable that is smooth at the fold.
    for (const double w : ash_adhesions) {
        const ContactPair pair = ash(w);
        const StaticCurve curve(Law::of<Jkr>(), pair);
        const double unit = std::cbrt(std::pow(w, 5) * std::pow(44e-6, 4) / (90e9 * 90e9));
        const auto work_to = [&](double end) {
            return integral(
                [&](double x) { return curve.at_overlap(end * (1 - x * x)).force() * 2 * x * end; }, 0.0,
                1.0);
        };
        CAPTURE(w);
        CHECK(relative_difference(work_to(curve.first().overlap) / unit, 7.0921959718639584) < 1e-12);
        const double tension_overlap = published(std::cbrt(1.5)).overlap * units_of(pair).overlap;
        CHECK(relative_difference(work_to(tension_overlap) / unit, 3.5026019718352908) < 1e-12);
    }
}

// Figure 3 of Dong et al. 2013: the normalised curves of Eqs. 22-24, written from the paper, and what the
// text reads off the figure.

TEST_CASE("Hertz, DMT and Brach-Dunn: Eqs. 22-24") {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
        const StaticCurve curve = StaticCurve::normalised(law);
        CAPTURE(law.name());
        CHECK(curve.first().overlap == 0.0);
        for (int i = 0; i < 36; ++i) {
            const double overlap = 0.01 * std::pow(1.2, i);
            CAPTURE(overlap);
            const StaticPoint point = curve.at_overlap(overlap);
            const double repulsion = std::pow(overlap, 1.5);
            const double attraction = published_attraction(law, overlap);
            CHECK(relative_difference(point.overlap, overlap) < 1e-14);
            CHECK(relative_difference(point.contact_radius, std::sqrt(overlap)) < 1e-14);  // Eq. 5
            CHECK(std::abs(point.repulsive_force - repulsion) < 1e-14 * (repulsion - attraction));
            CHECK(relative_difference(point.attractive_force, attraction) < 1e-14);
        }
    }
}

TEST_CASE("Hertz, DMT and Brach-Dunn in SI at fly-ash scale: Eqs. 9-14") {
    for (const double w : ash_adhesions) {
        const double r = 44e-6;
        const double e = 90e9;
        const double line = std::cbrt(6.0 * w * w * r * e / pi);  // Eq. 14
        for (const double overlap : {2e-9, 3e-8, 4e-7}) {
            const double hertz = 4.0 / 3.0 * e * std::sqrt(r) * std::pow(overlap, 1.5);
            const auto point = [&](Law law) { return StaticCurve(law, ash(w)).at_overlap(overlap); };
            CAPTURE(w);
            CAPTURE(overlap);
            CHECK(relative_difference(point(Law::of<Hertz>()).force(), hertz) < 1e-14);
            CHECK(relative_difference(point(Law::of<Dmt>()).attractive_force, -2.0 * pi * w * r) < 1e-14);
            CHECK(relative_difference(point(Law::of<BrachDunn>()).attractive_force,
                                      -2.0 * pi * line * std::sqrt(r * overlap)) < 1e-14);
            for (const Law law : {Law::of<Dmt>(), Law::of<BrachDunn>()}) {
                CHECK(std::abs(point(law).repulsive_force - hertz) <
                      1e-14 * (hertz - point(law).attractive_force));
            }
        }
    }
}

TEST_CASE(
    "the figure's table: evenly spaced in contact radius, from the start of the curve to the overlap asked "
    "for") {
    for (std::size_t i = 0; i < Law::count(); ++i) {
        if (!Law::at(i).parameters().empty()) {  // Eq. 21 has no unit for them
            CHECK_THROWS_AS(static_cast<void>(StaticCurve::normalised(Law::at(i))), InputError);
            continue;
        }
        const StaticCurve curve = StaticCurve::normalised(Law::at(i));
        const std::vector<StaticPoint> table = curve.sampled(3.0, 61);
        CAPTURE(Law::at(i).name());
        REQUIRE(table.size() == 61);
        CHECK(table.front().overlap == doctest::Approx(curve.first().overlap).epsilon(1e-14));
        CHECK(relative_difference(table.back().overlap, 3.0) < 1e-14);
        const double spacing = (table.back().contact_radius - table.front().contact_radius) / 60.0;
        for (std::size_t j = 1; j < table.size(); ++j) {
            CHECK(table[j].overlap > table[j - 1].overlap);
            CHECK(std::abs(table[j].contact_radius - table[j - 1].contact_radius - spacing) < 1e-14);
        }
    }
}

TEST_CASE("Brach-Dunn attracts two to three times as much as JKR, as stated below the figure") {
    const auto ratio = [](double overlap) {
        const auto attraction = [&](Law law) {
            return StaticCurve::normalised(law).at_overlap(overlap).attractive_force;
        };
        return attraction(Law::of<BrachDunn>()) / attraction(Law::of<Jkr>());
    };
    CHECK(ratio(1.0) > 1.0);
    CHECK(ratio(3.0) > ratio(1.0));
    CHECK(ratio(3.0) > 1.5);
    CHECK(ratio(3.0) < 3.0);
}
