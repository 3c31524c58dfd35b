// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "tests/solver/batch/batch_sample.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

CriticalVelocityBatch critical_batch(const Impacts& impacts) {
    const ImpactBatch batch = impacts.batch();
    return {batch.law, batch.detachment, batch.damping_law, batch.contact, batch.damping};
}

DampingBatch damping_batch(const Impacts& impacts, const Eigen::ArrayXd& restitution) {
    const ImpactBatch batch = impacts.batch();
    return {batch.law, batch.detachment, batch.damping_law, batch.contact, batch.velocity, restitution};
}

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

TEST_CASE("tabulated critical velocities are those of the backward integration to 1e-10") {
    for (Impacts& impacts : random_impacts(60, 2.0, 31)) {
        impacts.damping[0] = 0.0;
        impacts.damping[1] *= 1e-7;
        impacts.damping[2] *= 1e3;
        impacts.work_of_adhesion[3] = 0.0;
        const CriticalVelocityBatchResult result = critical_velocities(critical_batch(impacts));
        CAPTURE(impacts.law.name());
        CAPTURE(name_of(impacts.detachment));
        CAPTURE(name_of(impacts.damping_law));
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            CAPTURE(i);
            const Impact impact = impacts.at(i);
            const CriticalVelocity reference =
                critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
            REQUIRE(result.verdict[i] == reference.verdict);
            if (reference.value) {
                CHECK(relative_difference(result.value[i], *reference.value) <= 1e-10);
            } else {
                CHECK(std::isnan(result.value[i]));
            }
        }
    }
}

TEST_CASE("damping found from a restitution gives it back") {
    for (const Impacts& impacts : random_impacts(300, 1.0, 32)) {
        const ImpactBatchResult forward = solve_impacts(impacts.batch());
        std::vector<Eigen::Index> rebounds;
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            if (forward.restitution[i] > 0.01) rebounds.push_back(i);
        }
        Impacts again = impacts.picked(rebounds);
        const Eigen::ArrayXd wanted = forward.restitution(rebounds);
        Impacts undamped = again;
        undamped.damping.setZero();
        const Eigen::ArrayXd greatest = solve_impacts(undamped.batch()).restitution;
        CAPTURE(impacts.law.name());
        CAPTURE(name_of(impacts.detachment));
        CAPTURE(name_of(impacts.damping_law));
        for (const BatchMethod method : {BatchMethod::integration, BatchMethod::table}) {
            CAPTURE(method);
            const DampingBatchResult found =
                dampings_from_restitutions(damping_batch(again, wanted), 1, method);
            again.damping = found.damping;
            for (Eigen::Index i = 0; i < again.size(); ++i) {
                CAPTURE(i);
                ImpactResult target = solve_impact(again.at(i));
                CHECK(conditioned_error(wanted[i], target) <= 3e-12);
                CHECK(relative_difference(found.greatest_restitution[i], greatest[i]) <= 1e-12);
            }
        }
    }
}

TEST_CASE("a restitution out of reach has no damping, restitution zero the least that captures") {
    Impacts impacts = random_impacts_of(Law::of<Jkr>(), 4, 1.0, 33);
    impacts.velocity.setConstant(2.0);
    Eigen::ArrayXd restitution(4);
    restitution << 0.5, 0.9999999, 0.0, 0.3;
    impacts.work_of_adhesion[1] = 5.0;  // its break alone costs more than a part in 1e7
    const Impact impact = impacts.at(2);
    const DampingInversion least = damping_from_restitution(
        {impact.law, impact.detachment, impact.damping.law, impact.contact, impact.velocity, 0.0});
    for (const BatchMethod method : {BatchMethod::integration, BatchMethod::table}) {
        const DampingBatchResult result =
            dampings_from_restitutions(damping_batch(impacts, restitution), 1, method);
        CHECK(result.damping[0] > 0.0);
        CHECK(std::isnan(result.damping[1]));
        CHECK(result.greatest_restitution[1] < restitution[1]);
        CHECK(result.damping[2] == least.damping.coefficient);
    }
}

TEST_CASE("inverse problems: no bit depends on threads or order, and the first fault is named") {
    for (const Impacts& impacts : random_impacts(3000, 0.9, 34)) {
        if (impacts.law != Law::of<Jkr>() && impacts.law != Law::of<Hertz>()) continue;
        const CriticalVelocityBatchResult one = critical_velocities(critical_batch(impacts), 1);
        const CriticalVelocityBatchResult three = critical_velocities(critical_batch(impacts), 3);
        const Eigen::ArrayXd restitution = Eigen::ArrayXd::LinSpaced(impacts.size(), 0.1, 0.8);
        std::vector<Eigen::Index> reversed;
        for (Eigen::Index i = impacts.size(); i-- > 0;) reversed.push_back(i);
        const Impacts backward = impacts.picked(reversed);
        Eigen::Index different = 0;
        for (const BatchMethod method : {BatchMethod::integration, BatchMethod::table}) {
            const auto damping = dampings_from_restitutions(damping_batch(impacts, restitution), 1, method);
            const auto threaded = dampings_from_restitutions(damping_batch(impacts, restitution), 3, method);
            const auto other =
                dampings_from_restitutions(damping_batch(backward, restitution(reversed)), 1, method);
            for (Eigen::Index i = 0; i < impacts.size(); ++i) {
                const bool all = same(one.value[i], three.value[i]) &&
                                 same(damping.damping[i], threaded.damping[i]) &&
                                 same(damping.damping[i], other.damping[impacts.size() - 1 - i]);
                different += all ? 0 : 1;
            }
        }
        CHECK(different == 0);
    }
    Impacts impacts = random_impacts(10, 0.5, 35).front();
    impacts.mass[7] = 0.0;
    CHECK_THROWS_WITH_AS(static_cast<void>(critical_velocities(critical_batch(impacts))),
                         "impact 7: mass is 0 kg; allowed: a positive mass [kg]", InputError);
    const Eigen::ArrayXd restitution = Eigen::ArrayXd::Constant(1, 0.5);
    CHECK_THROWS_WITH_AS(static_cast<void>(dampings_from_restitutions(damping_batch(impacts, restitution))),
                         "impact 7: mass is 0 kg; allowed: a positive mass [kg]", InputError);
    impacts.effective_radius[4] = 1e-41;
    CHECK_THROWS_WITH_AS(static_cast<void>(critical_velocities(critical_batch(impacts))),
                         "impact 4: effective_radius is 1e-41 m; allowed: 1e-40 to 1e40 m", InputError);
    CHECK_THROWS_WITH_AS(static_cast<void>(dampings_from_restitutions(damping_batch(impacts, restitution))),
                         "impact 4: effective_radius is 1e-41 m; allowed: 1e-40 to 1e40 m", InputError);
}
