// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quantities/parameter.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "solver/batch/batch.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/sjkr.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/errors.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr LawParameter with_default{.name = "with_default",
                                    .dimension = Dimension::fraction,
                                    .description = "a parameter",
                                    .example = "2",
                                    .typical = 2.0,
                                    .otherwise = 7.0};

Impact sjkr_impact() {
    return {.law = Law::of<Sjkr>(),
            .detachment = Detachment::zero_overlap,
            .damping = {DampingLaw::constant, 0.002},
            .contact = ash(0.0),
            .velocity = 2.0};
}

}  // namespace

TEST_CASE("values of parameters are found by name; a default stands for one that is not given") {
    ParameterValues<double> values{{"cohesion_energy_density", 3.0}};
    CHECK(values.has(cohesion_energy_density));
    CHECK(values[cohesion_energy_density] == 3.0);
    CHECK_FALSE(values.has(with_default));
    CHECK(values[with_default] == 7.0);
    values.set("with_default", 5.0);
    CHECK(values[with_default] == 5.0);
    values.set("cohesion_energy_density", 4.0);
    CHECK(values[cohesion_energy_density] == 4.0);
    CHECK(std::distance(values.begin(), values.end()) == 2);
    CHECK(std::isnan(ParameterValues<double>()[cohesion_energy_density]));
    values.set("third", 0.0);
    values.set("fourth", 0.0);
    CHECK_THROWS_AS(values.set("fifth", 0.0), std::logic_error);
}

TEST_CASE("every declared parameter is consistent, and one pair has room for those of all laws") {
    for (const LawParameter& parameter : law_parameters()) {
        CAPTURE(parameter.name);
        CHECK(parse_quantity(parameter.example, parameter.dimension) == doctest::Approx(parameter.typical));
        CHECK_NOTHROW(require_allowed(parameter, parameter.typical));
        for (std::size_t i = 0; i < Law::count(); ++i)
            for (const LawParameter& other : Law::at(i).parameters())
                if (other.name == parameter.name) CHECK(other.dimension == parameter.dimension);
    }
    CHECK_NOTHROW(static_cast<void>(parameters_like(0.3)));
}

TEST_CASE("an impact without a parameter of its law, or with one out of bounds, is refused") {
    Impact impact = sjkr_impact();
    impact.contact.parameters = {};
    CHECK(
        input_error_of([&] { static_cast<void>(solve_impact(impact)); }) ==
        "cohesion_energy_density is missing; allowed: k_c, cohesion energy per volume (J/m3 is Pa), such as "
        "\"100 MJ/m3\"");
    for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
        impact.contact.parameters = {{"cohesion_energy_density", wrong}};
        CHECK(contains(input_error_of([&] { static_cast<void>(solve_impact(impact)); }),
                       "cohesion_energy_density is "));
    }
    impact.contact.parameters = {{"cohesion_energy_density", 0.0}};
    CHECK_NOTHROW(static_cast<void>(solve_impact(impact)));
}

TEST_CASE("a batch takes a parameter as a column or as a single value, and refuses what an impact refuses") {
    const Impact impact = sjkr_impact();
    const Eigen::ArrayXd mass = Eigen::ArrayXd::Constant(1, impact.contact.mass);
    const Eigen::ArrayXd radius = Eigen::ArrayXd::Constant(1, impact.contact.effective_radius);
    const Eigen::ArrayXd modulus = Eigen::ArrayXd::Constant(1, impact.contact.contact_modulus);
    const Eigen::ArrayXd none = Eigen::ArrayXd::Zero(1);
    const Eigen::ArrayXd damping = Eigen::ArrayXd::Constant(1, impact.damping.coefficient);
    const Eigen::ArrayXd velocity = Eigen::ArrayXd::Constant(1, impact.velocity);
    Eigen::ArrayXd density(3);
    density << 1e6, 1e7, 1e8;
    const auto solved = [&](const Eigen::ArrayXd& values) {
        return solve_impacts(
            {impact.law,
             impact.detachment,
             impact.damping.law,
             {mass, radius, modulus, none, never_yields, {{"cohesion_energy_density", values}}},
             damping,
             velocity});
    };
    const ImpactBatchResult result = solved(density);
    REQUIRE(result.restitution.size() == 3);
    for (Eigen::Index i = 0; i < 3; ++i) {
        Impact alone = impact;
        alone.contact.parameters = {{"cohesion_energy_density", density[i]}};
        CHECK(std::abs(result.restitution[i] - solve_impact(alone).restitution) < 1e-12);
    }
    CHECK(solved(Eigen::ArrayXd::Constant(1, 1e7)).restitution[0] == result.restitution[1]);
    density[1] = -1.0;
    CHECK(contains(input_error_of([&] { static_cast<void>(solved(density)); }),
                   "impact 1: cohesion_energy_density is -1 Pa"));
    CHECK(contains(input_error_of([&] {
                       static_cast<void>(solve_impacts({impact.law,
                                                        impact.detachment,
                                                        impact.damping.law,
                                                        {mass, radius, modulus, none},
                                                        damping,
                                                        velocity}));
                   }),
                   "cohesion_energy_density is missing"));
}
