// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/motion/impact.hpp"
#include "tests/relative_difference.hpp"
#include "tests/solver/inference/ash_laboratory.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

TEST_CASE("a contact model is the solver's impact: its restitution and contact time at the model's damping") {
    for (const Law law : fitted_laws) {
        const ContactModel model = ash_model(law);
        for (const double v : {0.5, 2.0, 11.0})
            for (const double share : {0.1, 0.5, 0.9}) {
                CAPTURE(law.name());
                CAPTURE(v);
                const double e = share * model.greatest_restitution(v);
                const ImpactResult result = solve_impact({law,
                                                          law.default_detachment(),
                                                          {DampingLaw::constant, model.damping(v, e).value},
                                                          model.contact(),
                                                          v});
                CHECK(std::abs(result.restitution - e) < 10 * model.map().accuracy());
                REQUIRE(result.contact_time);
                CHECK(relative_difference(model.contact_time(v, e), *result.contact_time) < 1e-3);
            }
    }
}

TEST_CASE("velocity, restitution and damping of a contact model follow from one another, from any start") {
    for (const Law law : fitted_laws) {
        const ContactModel model = ash_model(law);
        // That of Hertz has no end.
        const VelocityRange range{std::max(model.range().lower, 0.01), std::min(model.range().upper, 30.0)};
        for (const double v : {1.2 * range.lower, 0.5, 2.0, 0.8 * range.upper})
            for (const double share : {0.0, 0.3, 0.97}) {
                CAPTURE(law.name());
                CAPTURE(v);
                const double e = share * model.greatest_restitution(v);
                const DampingAt damping = model.damping(v, e);
                if (e > 0) CHECK(std::abs(model.restitution(v, damping.value) - e) < 1e-9);
                for (const std::optional<double> guess :
                     {std::optional<double>(), std::optional(range.lower), std::optional(range.upper)}) {
                    const auto found = model.velocity(e, damping.value, guess);
                    REQUIRE(found);
                    CHECK(relative_difference(found->value, v) < 1e-9);
                    CHECK(relative_difference(found->by_damping, 1 / damping.by_velocity) < 1e-5);
                }
            }
        if (law == Law::of<Hertz>()) continue;
        CHECK_FALSE(model.velocity(0.0, 1.01 * model.damping(range.upper, 0.0).value));
        CHECK_FALSE(model.velocity(0.0, 0.99 * model.damping(range.lower, 0.0).value));
    }
}

TEST_CASE("a contact that ends at zero force, and so never captures, has no contact model") {
    const Law hertz = Law::of<Hertz>();
    CHECK_THROWS_AS(
        static_cast<void>(make_contact_model(hertz, Detachment::zero_force, ash_pair, {0.01, 30.0})),
        InputError);
}
