// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/reconstruction.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/published.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Densities and work of adhesion that the calibration finds for the three samples.
constexpr double densities[] = {2178.29, 2158.52, 2072.50};
constexpr double work_of_adhesion = 0.295917;

PublishedDamping published_damping(std::size_t sample, Law law) {
    const PublishedSample data = published_samples()[sample];
    const double radius = data.diameter / 2;
    return {
        .law = law,
        .detachment = law.default_detachment(),
        .contact = {.mass = sphere_mass(radius, densities[sample]),
                    .effective_radius = radius,
                    .contact_modulus = contact_modulus({data.young_modulus, 0.2}, ElasticBody{193e9, 0.29}),
                    .work_of_adhesion = work_of_adhesion},
        .damping = data.of(law).damping_fit};
}

template <class Action>
void for_each_published(Action&& action) {
    for (std::size_t sample = 0; sample < 3; ++sample) {
        for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
            action(published_damping(sample, law));
        }
    }
}

}  // namespace

TEST_CASE("the velocity of a restitution gives that restitution, for every case with a critical velocity") {
    Worst worst;
    for (const ContactCase& c : elastic_cases()) {
        if (c.damping_law != DampingLaw::constant || c.detachment == Detachment::zero_force) continue;
        for (const double e : {0.001, 0.1, 0.5, 0.9, 0.99}) {
            Impact impact = impact_of(c, ash(0.3), 0.3, 2.0);
            impact.velocity = velocity_of_restitution(impact, e);
            worst.see(std::abs(solve_impact(impact).restitution - e), describe(impact));
        }
    }
    CHECK(worst.count() >= 30);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("small restitutions belong to velocities just above the critical one") {
    const Impact impact =
        impact_of({Law::of<Dmt>(), DampingLaw::constant, Detachment::zero_overlap}, ash(0.3), 0.5, 2.0);
    const double critical =
        *critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value;
    CHECK(velocity_of_restitution(impact, 1e-3) > critical);
    CHECK(velocity_of_restitution(impact, 1e-3) < 1.001 * critical);
    CHECK(velocity_of_restitution(impact, 0.3) > velocity_of_restitution(impact, 0.2));
}

TEST_CASE("restitutions down to rounding have a velocity, which is v_c to rounding") {
    const Impact impact =
        impact_of({Law::of<Jkr>(), DampingLaw::constant, Detachment::zero_overlap}, ash(0.3), 0.5, 2.0);
    Worst worst;
    for (int i = 0; i < 60; ++i) {
        Impact at = impact;
        at.damping.coefficient *= 1.0 + 1e-3 * i;
        const double critical = *critical_velocity({at.law, at.detachment, at.damping, at.contact}).value;
        for (const double e : {1e-8, 1e-10, 1e-12}) {
            double velocity = 0.0;
            CHECK_NOTHROW(velocity = velocity_of_restitution(at, e));
            worst.see(relative_difference(velocity, critical), describe(at));
        }
    }
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("a reconstructed point of the paper's curves gives its own restitution back") {
    Worst worst;
    for_each_published([&](const PublishedDamping& published) {
        for (const double e : {0.05, 0.2, 0.4, 0.6}) {
            const Impact impact{.law = published.law,
                                .detachment = published.detachment,
                                .damping = {DampingLaw::constant, published.damping(e)},
                                .contact = published.contact,
                                .velocity = reconstructed_velocity(published, e)};
            worst.see(std::abs(solve_impact(impact).restitution - e), describe(impact));
        }
    });
    CHECK(worst.count() == 36);
    CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where());
}

TEST_CASE("the curve as velocity over restitution and as restitution over velocity is one curve") {
    Worst worst;
    for_each_published([&](const PublishedDamping& published) {
        const CurvePoint least = least_rebound(published);
        double before = least.velocity;
        const double first = least.restitution + 0.002;
        for (int i = 0; i < (0.5 - first) / 0.01; ++i) {
            const double e = first + 0.01 * i;
            const double velocity = reconstructed_velocity(published, e);
            if (velocity <= before) break;  // the end of the rising branch
            before = velocity;
            worst.see(std::abs(reconstructed_restitution(published, velocity) - e),
                      std::string(published.law.name()) + " " + std::to_string(e));
        }
    });
    CHECK(worst.count() > 300);
    CHECK_MESSAGE(worst.deviation() < 1e-11, worst.where());
}

TEST_CASE("the curve of an adhesive law folds back from v_c; below the fold there is no rebound") {
    for_each_published([&](const PublishedDamping& published) {
        const double critical = *critical_velocity({published.law,
                                                    published.detachment,
                                                    {DampingLaw::constant, published.damping(0.0)},
                                                    published.contact})
                                     .value;
        const CurvePoint least = least_rebound(published);
        CAPTURE(published.law.name());
        CAPTURE(critical);
        CAPTURE(least.velocity);
        CAPTURE(least.restitution);
        CHECK(reconstructed_restitution(published, least.velocity * (1.0 - 1e-6)) == 0.0);
        CHECK(reconstructed_restitution(published, 1.1 * critical) > least.restitution);
        const bool folds = published.law != Law::of<Hertz>();
        CHECK((least.restitution > 0.0) == folds);
        CHECK((least.velocity < critical) == folds);
        if (!folds) return;
        // Both branches rebound with their own damping; the curve takes the upper one.
        CHECK(reconstructed_velocity(published, 0.9 * least.restitution) > least.velocity);
        CHECK(reconstructed_velocity(published, 1.1 * least.restitution) > least.velocity);
        for (const double share : {0.01, 0.5, 0.99}) {
            const double velocity = least.velocity + share * (critical - least.velocity);
            const double e = reconstructed_restitution(published, velocity);
            CHECK(e > least.restitution);
            CHECK(relative_difference(reconstructed_velocity(published, e), velocity) < 1e-11);
        }
        // It joins on smoothly where the damping of e = 0 rebounds too.
        const double below = reconstructed_restitution(published, critical * (1.0 - 1e-9));
        const double above = reconstructed_restitution(published, critical * (1.0 + 1e-9));
        CHECK(std::abs(above - below) < 1e-6);
    });
    const CurvePoint least = least_rebound(published_damping(0, Law::of<BrachDunn>()));
    const double critical = reconstructed_velocity(published_damping(0, Law::of<BrachDunn>()), 1e-9);
    CHECK(std::abs(1.0 - least.velocity / critical - 0.0085) < 1e-4);
    CHECK(std::abs(least.restitution - 0.00570) < 5e-5);
}

TEST_CASE(
    "Hertz needs 21.415 e more than v_c, so that a damping which falls by 4.283 of itself folds its curve") {
    const ContactPair pair = published_damping(0, Law::of<Hertz>()).contact;
    constexpr double damping = 0.0153;  // [kg/s]
    const Impact impact{
        Law::of<Hertz>(), Detachment::zero_overlap, {DampingLaw::constant, damping}, pair, 1.0};
    const double critical =
        *critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value;
    constexpr double e = 1e-5;
    const double share = velocity_of_restitution(impact, e) / critical - 1.0;
    CHECK(std::abs(share / e - (21.415 - 50.0 * std::sqrt(e))) < 0.01);
    for (const double fall : {1.9, 4.2, 4.4}) {
        const PublishedDamping published{impact.law, impact.detachment, pair,
                                         DampingPolynomial::quadratic(0.0, -fall * damping, damping)};
        CAPTURE(fall);
        CHECK((reconstructed_velocity(published, e) < critical) == (fall > 4.283));
    }
}

TEST_CASE("how well the three laws agree on one measurement: 11 % in velocity, for the 96 um sample 26 %") {
    for (std::size_t sample = 0; sample < 3; ++sample) {
        for (const double e : {0.1, 0.2, 0.3, 0.4, 0.5}) {
            double least = 1e9;
            double greatest = 0.0;
            for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>()}) {
                const double velocity = reconstructed_velocity(published_damping(sample, law), e);
                least = std::min(least, velocity);
                greatest = std::max(greatest, velocity);
            }
            CAPTURE(sample);
            CAPTURE(e);
            CHECK(greatest < (sample == 1 ? 1.26 : 1.11) * least);
        }
    }
}

TEST_CASE("restitutions that no velocity has are refused") {
    const Impact impact =
        impact_of({Law::of<Dmt>(), DampingLaw::constant, Detachment::zero_overlap}, ash(0.3), 0.3, 2.0);
    const auto message = [](const Impact& i, double e) {
        return input_error_of([&] { static_cast<void>(velocity_of_restitution(i, e)); });
    };
    for (const double e : {0.0, 1.0, -0.2, 1.7, std::nan("")}) {
        CHECK(contains(message(impact, e), "is not reached at any velocity; allowed: 0 < e < 1"));
    }
    Impact never =
        impact_of({Law::of<Hertz>(), DampingLaw::constant, Detachment::zero_force}, ash(0.0), 0.3, 2.0);
    CHECK(contains(message(never, 0.5), "never-captured"));
    // With contact-radius damping restitution rises from capture and falls again: two velocities share it.
    const Impact falling =
        impact_of({Law::of<Dmt>(), DampingLaw::contact_radius, Detachment::zero_overlap}, ash(0.3), 0.5, 2.0);
    CHECK(message(falling, 0.5) ==
          "restitution need not rise with velocity for damping law 'contact-radius'; allowed: constant");
    Impact yielding = impact;
    yielding.law = Law::of<ThorntonNing>();
    yielding.detachment = Detachment::pull_off;
    yielding.contact.yield_pressure = 2e9;
    CHECK(
        message(yielding, 0.5) ==
        "restitution need not rise with velocity where the contact yields; allowed: a contact without yield "
        "pressure");
}
