// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <string>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/jkr.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/thornton_ning.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/number.hpp"
#include "tests/solver/batch/batch_sample.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Impacts at the critical velocity times each factor.
Impacts around_critical(Impacts impacts, const std::vector<double>& factors) {
    std::vector<Eigen::Index> places;
    std::vector<double> velocities;
    for (Eigen::Index i = 0; i < impacts.size(); ++i) {
        const Impact impact = impacts.at(i);
        const CriticalVelocity critical =
            critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
        if (!critical.value) continue;
        for (const double factor : factors) {
            places.push_back(i);
            velocities.push_back(*critical.value * factor);
        }
    }
    impacts = impacts.picked(places);
    impacts.velocity =
        Eigen::Map<const Eigen::ArrayXd>(velocities.data(), static_cast<Eigen::Index>(velocities.size()));
    return impacts;
}

/// How far a batch is from the scalar solver.
struct Agreement {
    double restitution = 0.0;  ///< greatest |d(e^2)| over the conditioning of the problem
    double contact_time =
        0.0;            ///< greatest relative difference over the conditioning, which near capture is 1/e^2
    double turn = 0.0;  ///< greatest relative difference of overlap, tenth of that of approach time
    Eigen::Index outcomes = 0;  ///< that differ, as times do that one of both has

    void add(const ImpactBatchResult& batch, Eigen::Index i, const ImpactResult& reference,
             bool turns = false) {
        if (batch.outcome[i] != reference.outcome ||
            std::isnan(batch.contact_time[i]) == reference.contact_time.has_value() ||
            (turns && std::isnan(batch.approach_time[i]) == reference.approach_time.has_value())) {
            ++outcomes;
            return;
        }
        restitution = std::max(restitution, conditioned_error(batch.restitution[i], reference));
        if (turns) {
            turn = std::max(turn, relative_difference(batch.maximum_overlap[i], reference.maximum_overlap));
            if (reference.approach_time)
                turn = std::max(turn,
                                0.1 * relative_difference(batch.approach_time[i], *reference.approach_time));
        }
        if (!reference.contact_time) return;
        const double depth = 1.0 + std::abs(reference.energy.minimum) / reference.energy.incident;
        const double condition = 1.0 + depth / std::pow(reference.restitution, 2.0);
        const double difference = std::abs(batch.contact_time[i] / *reference.contact_time - 1.0);
        contact_time = std::max(contact_time, difference / condition);
    }
    void add(const Agreement& other) {
        restitution = std::max(restitution, other.restitution);
        contact_time = std::max(contact_time, other.contact_time);
        turn = std::max(turn, other.turn);
        outcomes += other.outcomes;
    }
};

struct Agreements {
    Agreement integrated{};
    Agreement tabulated{};
    Eigen::Index rebounds = 0;
};

Agreements agreements(const Impacts& impacts) {
    const ImpactBatchResult integrated = solve_impacts(impacts.batch(), {.threads = 0});
    const ImpactBatchResult tabulated = solve_impacts(
        impacts.batch(),
        {.threads = 0, .turning_point = false, .method = method_of_many(impacts.law, impacts.damping_law)});
    Agreements all;
    std::mutex adding;
    const auto chunk = [&](std::size_t first, std::size_t count) {
        Agreements own;
        for (auto i = static_cast<Eigen::Index>(first); i < static_cast<Eigen::Index>(first + count); ++i) {
            const ImpactResult reference = solve_impact(impacts.at(i));
            own.integrated.add(integrated, i, reference, true);
            own.tabulated.add(tabulated, i, reference);
            if (reference.outcome == Outcome::rebound) ++own.rebounds;
        }
        const std::scoped_lock lock(adding);
        all.integrated.add(own.integrated);
        all.tabulated.add(own.tabulated);
        all.rebounds += own.rebounds;
    };
    batch::for_chunks(static_cast<std::size_t>(impacts.size()), 512, 0, chunk);
    return all;
}

/// A million with ASHIMPACT_WHOLE, as `./dev test reliability` sets it; under sanitizers every impact makes a
/// square of a table.
Eigen::Index impacts_in_all() {
    if (sanitized) return 2'100;
    return std::getenv("ASHIMPACT_WHOLE") == nullptr ? 40'000 : 1'000'000;
}

}  // namespace

TEST_CASE("capture is decided exactly, down to a part in 1e9 of the critical velocity") {
    for (const Impacts& impacts : random_impacts(12, 0.8, 13)) {
        const Impacts near = around_critical(impacts, {1.0 - 1e-9, 1.0 + 1e-9, 1.0 - 1e-5, 1.0 + 1e-5, 1.01});
        if (near.size() == 0) continue;
        CAPTURE(name_of(near));
        std::vector<ImpactBatchResult> results{solve_impacts(near.batch())};
        if (!near.law.has_cohesive_zone())  // each size would make tables of a cohesive zone of its own
            results.push_back(
                solve_impacts(near.batch(), {.turning_point = false, .method = BatchMethod::table}));
        for (const ImpactBatchResult& result : results) {
            for (Eigen::Index i = 0; i < near.size(); ++i) {
                CAPTURE(i);
                CHECK((result.outcome[i] == Outcome::capture) == (i % 5 == 0 || i % 5 == 2));
                CHECK(conditioned_error(result.restitution[i], solve_impact(near.at(i))) <=
                      bound_of(near.law));
            }
        }
    }
}

TEST_CASE(
    "captures whose energy passes through what double precision leaves in doubt are found by the kernels") {
    constexpr Eigen::Index count = 2000;
    const auto one = [](double value) { return Eigen::ArrayXd::Constant(1, value); };
    const Impacts impacts{.law = Law::of<MaugisDugdale>(),
                          .detachment = Detachment::pull_off,
                          .mass = one(1.1597e-10),
                          .effective_radius = one(22e-6),
                          .contact_modulus = one(90e9),
                          .work_of_adhesion = one(0.3),
                          .damping = one(0.005),
                          .velocity = Eigen::ArrayXd::LinSpaced(count, 3.8, 4.5),
                          .parameters = {{"cohesion_range", one(4e-10)}}};
    const ImpactBatchResult result = solve_impacts(impacts.batch(), {.turning_point = false});
    CHECK((result.outcome == Outcome::capture).all());
    CHECK(result.scalar == 0);
}

TEST_CASE("without damping all of the energy comes back, less what the break costs") {
    for (Impacts& impacts : random_impacts(40, 1.0, 14)) {
        const double bound = bound_of(impacts.law);
        impacts.damping.setZero();
        const ImpactBatchResult result = solve_impacts(impacts.batch());
        CAPTURE(name_of(impacts));
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            const ImpactResult reference = solve_impact(impacts.at(i));
            CHECK(result.outcome[i] == reference.outcome);
            CHECK(conditioned_error(result.restitution[i], reference) <= bound);
            const double depth = 1.0 + std::abs(reference.energy.minimum) / reference.energy.incident;
            const double lost = 1.0 - result.restitution[i] * result.restitution[i];
            if (impacts.law != Law::of<Jkr>() && !impacts.law.has_cohesive_zone() &&
                !impacts.law.is_plastic())
                CHECK(std::abs(lost) <= bound * depth);
        }
    }
}

TEST_CASE("rebounds within 1e-9 of capture, in energy, are those of the scalar solver bit by bit") {
    Impact impact{.law = Law::of<Dmt>(),
                  .detachment = Detachment::zero_overlap,
                  .damping = {DampingLaw::constant, 0.0141},
                  .contact = {.mass = 9.3e-10,
                              .effective_radius = 44e-6,
                              .contact_modulus = 90e9,
                              .work_of_adhesion = 0.3},
                  .velocity = 1.0};
    const double critical =
        critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value.value();
    int rebounds = 0;
    for (int i = 0; i < 16; ++i) {
        const double beyond = 1e-13 * std::pow(1.5, i);
        impact.velocity = critical * (1 + beyond);
        const ImpactResult scalar = solve_impact(impact);
        CAPTURE(beyond);
        CHECK(solve_impacts(ImpactList({impact}).batch()).restitution[0] == scalar.restitution);
        rebounds += scalar.outcome == Outcome::rebound ? 1 : 0;
    }
    CHECK(rebounds > 5);
}

TEST_CASE("a single value stands for all, and what is not asked for is not a number") {
    Impacts impacts = random_impacts_of(Law::of<Jkr>(), 40, 1.0, 15);
    impacts.mass.setConstant(1e-12);
    impacts.velocity.setConstant(2.0);
    ImpactBatch batch = impacts.batch();
    const ImpactBatchResult full = solve_impacts(batch);
    const Eigen::ArrayXd mass = Eigen::ArrayXd::Constant(1, 1e-12);
    const Eigen::ArrayXd velocity = Eigen::ArrayXd::Constant(1, 2.0);
    const ImpactBatch single{
        batch.law,
        batch.detachment,
        batch.damping_law,
        {mass, impacts.effective_radius, impacts.contact_modulus, impacts.work_of_adhesion},
        impacts.damping,
        velocity};
    CHECK(identical(full, solve_impacts(single)));
    const ImpactBatchResult less = solve_impacts(single, {.turning_point = false});
    CHECK(less.approach_time.isNaN().all());
    CHECK(less.maximum_overlap.isNaN().all());
    CHECK((less.outcome == full.outcome).all());
    const ImpactBatchResult read =
        solve_impacts(single, {.turning_point = false, .method = BatchMethod::table});
    CHECK(read.approach_time.isNaN().all());
    CHECK(read.maximum_overlap.isNaN().all());
    CHECK((read.outcome == full.outcome).all());
    const ImpactBatchResult both = solve_impacts(single, {.method = BatchMethod::table});
    CHECK((both.maximum_overlap == full.maximum_overlap).all());
    CHECK((both.restitution == read.restitution).all());
}

TEST_CASE("columns of the caller get what a result holds, and those that are not given change nothing") {
    const Impacts impacts = random_impacts_of(Law::of<Dmt>(), 3000, 1.0, 15);
    const ImpactBatch batch = impacts.batch();
    for (const BatchMethod method : {BatchMethod::integration, BatchMethod::table}) {
        const ImpactBatchResult result = solve_impacts(batch, {.turning_point = false, .method = method});
        Eigen::ArrayXd restitution(impacts.size());
        Eigen::ArrayXd time(impacts.size());
        Eigen::ArrayXd overlap(impacts.size());
        solve_impacts(batch,
                      {.restitution = restitution.data(),
                       .contact_time = time.data(),
                       .maximum_overlap = overlap.data()},
                      {.turning_point = false, .method = method});
        CHECK((restitution == result.restitution).all());
        CHECK((time == result.contact_time || (time.isNaN() && result.contact_time.isNaN())).all());
        CHECK(overlap.isNaN().all());
        restitution.setZero();
        const BatchReport report =
            solve_impacts(batch, {.restitution = restitution.data()},
                          {.turning_point = false, .contact_time = false, .method = method});
        CHECK((restitution == result.restitution).all());
        CHECK(report.failed.empty());
    }
}

TEST_CASE("asking for turning points changes no bit of the rest, however strong the damping") {
    for (const double most_damping : {1.5, 1e3, 1e11}) {
        for (const Impacts& impacts : random_impacts(150, most_damping, 19)) {
            CAPTURE(name_of(impacts));
            ImpactBatchResult less;
            try {
                less = solve_impacts(impacts.batch(), {.turning_point = false});
            } catch (const ConvergenceError&) {
                continue;  // contact-radius damping that creeps back for ever
            }
            ImpactBatchResult more = solve_impacts(impacts.batch());
            more.approach_time = less.approach_time;
            more.maximum_overlap = less.maximum_overlap;
            CHECK(identical(less, more));
        }
    }
}

TEST_CASE("impacts of any adhesion and damping, over twelve decades, are those of the scalar solver") {
    Random random(23);
    Eigen::Index solved = 0;
    Eigen::Index rebounds = 0;
    for (Impacts& impacts : random_impacts(sanitized ? 10 : 120, 1.0, 23)) {
        CAPTURE(name_of(impacts));
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            const double stickier = random.log_uniform(1e-6, 1e6);
            impacts.work_of_adhesion[i] *= stickier;
            if (impacts.law.is_plastic()) impacts.yield_pressure[i] *= std::cbrt(stickier);
            for (auto& [name, column] : impacts.parameters)
                column[i] *= impacts.law.uses_work_of_adhesion() ? 1.0 : random.log_uniform(1e-6, 1e6);
            impacts.damping[i] *= random.log_uniform(1e-6, 1e6);
        }
        const double bound = bound_of(impacts.law);
        for (const BatchMethod method : methods_of(impacts)) {
            const ImpactBatchResult result = solve_impacts(
                impacts.batch(), {.turning_point = false, .method = method, .keep_failures = true});
            for (Eigen::Index i = 0; i < impacts.size(); ++i) {
                if (std::isnan(result.restitution[i])) continue;
                CAPTURE(i);
                const ImpactResult reference = solve_impact(impacts.at(i));
                ++solved;
                rebounds += reference.outcome == Outcome::rebound ? 1 : 0;
                CHECK(result.outcome[i] == reference.outcome);
                CHECK(conditioned_error(result.restitution[i], reference) <= bound);
            }
            if (impacts.damping_law == DampingLaw::hunt_crossley) CHECK(result.failed.empty());
        }
    }
    CHECK(rebounds > solved / 8);
    CHECK(rebounds < solved);
}

TEST_CASE("impacts in a cohesive zone of any transition parameter are those of the scalar solver") {
    Random random(29);
    for (Impacts& impacts : random_impacts(sanitized ? 10 : 60, 1.0, 29)) {
        if (!impacts.law.has_cohesive_zone()) continue;
        CAPTURE(name_of(impacts));
        const double least = impacts.detachment == Detachment::load_controlled ? 1.2 : 1e-3;
        for (double& tabor : impacts.parameters.at("tabor")) tabor = random.log_uniform(least, 1e3);
        const ImpactBatchResult result = solve_impacts(impacts.batch());
        CHECK(result.scalar <= impacts.size() / 10);
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            CAPTURE(i);
            CAPTURE(impacts.parameters.at("tabor")[i]);
            const ImpactResult reference = solve_impact(impacts.at(i));
            CHECK(result.outcome[i] == reference.outcome);
            CHECK(conditioned_error(result.restitution[i], reference) <= bound_of(impacts.law));
            CHECK(relative_difference(result.maximum_overlap[i], reference.maximum_overlap) <= 1e-8);
            if (reference.contact_time)
                CHECK(relative_difference(result.contact_time[i], *reference.contact_time) <=
                      1e-8 * (1.0 + std::pow(reference.restitution, -2.0)));
        }
    }
}

TEST_CASE("in the deepest wells of a cohesive zone of long reach an undamped impact still rebounds") {
    for (Impacts& impacts : random_impacts(40, 1.0, 30)) {
        if (!impacts.law.has_cohesive_zone() || impacts.detachment != Detachment::zero_overlap) continue;
        impacts.damping.setZero();
        impacts.parameters.at("tabor").setConstant(1.7e-4);
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            const Impact impact = impacts.at(i);
            const double number = Jkr<double>::adhesion_number(
                impact.contact, Scale::of(impact.contact, impact.velocity).length);
            impacts.work_of_adhesion[i] *= std::pow((50.0 + static_cast<double>(i)) / number, 2);
        }
        CAPTURE(name_of(impacts));
        CHECK((solve_impacts(impacts.batch()).outcome == Outcome::rebound).all());
    }
}

namespace {

/// Impacts of a law of three numbers, over a range of the third: particles of sizes up to twenty times the
/// least, at one velocity and damping number.
struct ManySizes {
    Law law;
    double velocity;
    double yield_pressure;

    [[nodiscard]] Impacts impacts(Eigen::Index count) const {
        Impacts impacts = random_impacts_of(law, count, 1.0, 31);
        impacts.detachment = Detachment::pull_off;
        impacts.damping_law = DampingLaw::constant;
        for (Eigen::Index i = 0; i < count; ++i) {
            const double size = std::exp(3.0 * static_cast<double>(i) / static_cast<double>(count));
            impacts.mass[i] = 1e-14 * std::pow(size, 3);
            impacts.effective_radius[i] = 1e-6 * size;
            impacts.contact_modulus[i] = 90e9;
            impacts.work_of_adhesion[i] = 0.3;
            impacts.velocity[i] = velocity;
            if (law.is_plastic()) impacts.yield_pressure[i] = yield_pressure;
            impacts.parameters.at("tabor")[i] = 0.35 * std::cbrt(size);
            impacts.damping[i] =
                Scale::of(impacts.at(i).contact, velocity).damping_coefficient(DampingLaw::constant, 0.1);
        }
        return impacts;
    }
};

}  // namespace

TEST_CASE("tables of laws of three numbers tell what the scalar solver does, of particles of many sizes") {
    const Eigen::Index count = sanitized ? 3 : 400;
    // Of the cohesive zone over both parameters at which its branches change; of yield from next to where
    // adhesion alone causes it.
    for (const ManySizes& row : {ManySizes{Law::of<MaugisDugdale>(), 0.25, 0.0},
                                 {Law::of<ThorntonNing>(), 0.25, 2e9},
                                 {Law::of<ThorntonNing>(), 20.0, 5e9}}) {
        if (sanitized && row.velocity > 1.0) continue;
        const Law law = row.law;
        CAPTURE(law.name());
        CAPTURE(row.velocity);
        const Impacts impacts = row.impacts(count);
        CHECK(method_of_many(law, DampingLaw::constant) == BatchMethod::integration);
        CHECK(method_of_many(law, DampingLaw::constant, 100'000'000) == BatchMethod::table);
        const BatchOptions options{.threads = 0, .turning_point = false, .method = BatchMethod::table};
        const ImpactBatchResult read = solve_impacts(impacts.batch(), options);
        CHECK(read.scalar <= count / 20);
        for (Eigen::Index i = 0; i < count; ++i) {
            CAPTURE(i);
            const ImpactResult reference = solve_impact(impacts.at(i));
            CHECK(read.outcome[i] == reference.outcome);
            CHECK(conditioned_error(read.restitution[i], reference) <= bound_of(law));
            if (reference.contact_time)
                CHECK(relative_difference(read.contact_time[i], *reference.contact_time) <=
                      1e-8 * (1.0 + std::pow(reference.restitution, -2.0)));
            const std::vector<Eigen::Index> alone{i};
            CHECK(solve_impacts(impacts.picked(alone).batch(), options).restitution[0] ==
                  read.restitution[i]);
        }
        const auto rebounds = (read.outcome == Outcome::rebound).count();
        if (!sanitized) CHECK(rebounds > count / 5);
        if (!sanitized) CHECK((rebounds < count) == (row.velocity < 1.0));
        if (law.is_plastic()) continue;  // beyond yield e may rise with the damping
        const DampingBatchResult found =
            dampings_from_restitutions({law, impacts.detachment, impacts.damping_law, impacts.batch().contact,
                                        impacts.velocity, read.restitution},
                                       0, BatchMethod::table);
        for (Eigen::Index i = 0; i < count; ++i)
            if (read.restitution[i] > 0.1)
                CHECK(relative_difference(found.damping[i], impacts.damping[i]) <= 1e-6);
    }
}

TEST_CASE("tables of contacts that yield tell what the scalar solver does, captures of theirs too") {
    const Eigen::Index count = sanitized ? 3 : 300;
    const Law law = Law::of<ThorntonNing>();
    for (const Impacts& sample : random_impacts(count, 0.3, 77)) {
        if (sample.law != law) continue;
        if (sanitized && sample.damping_law != DampingLaw::constant) continue;
        CAPTURE(name_of(sample));
        Impacts impacts = sample;  // of one size
        Random random(78);
        for (Eigen::Index i = 0; i < count; ++i) {
            impacts.mass[i] = 1.16e-13;
            impacts.effective_radius[i] = 2.2e-6;
            impacts.contact_modulus[i] = 90e9;
            impacts.work_of_adhesion[i] = 0.3;
            impacts.yield_pressure[i] = i < 10 ? std::numeric_limits<double>::infinity() : 1e9;
            impacts.velocity[i] = random.log_uniform(0.1, 300.0);
            const double number = i < 20 ? 0.0 : random.uniform(0.0, 0.5);
            impacts.damping[i] = Scale::of(impacts.at(i).contact, impacts.velocity[i])
                                     .damping_coefficient(impacts.damping_law, number);
        }
        const BatchOptions options{.turning_point = false, .method = BatchMethod::table};
        const ImpactBatchResult read = solve_impacts(impacts.batch(), options);
        CHECK(read.scalar <= count / 50);
        int yielded_captures = 0;
        for (Eigen::Index i = 0; i < count; ++i) {
            CAPTURE(i);
            const ImpactResult alone = solve_impact(impacts.at(i));
            REQUIRE(read.outcome[i] == alone.outcome);
            CHECK(conditioned_error(read.restitution[i], alone) <= bound_of(law));
            if (alone.contact_time)
                CHECK(relative_difference(read.contact_time[i], *alone.contact_time) <=
                      1e-11 * (1.0 + std::pow(alone.restitution, -2.0)));
            yielded_captures += alone.outcome == Outcome::capture && alone.yielded;
        }
        if (!sanitized) CHECK((read.outcome == Outcome::rebound).count() > count / 5);
        if (!sanitized) CHECK(yielded_captures > 0);
    }
}

TEST_CASE("captures by very strong damping are captures, with turning points too") {
    Impacts impacts = random_impacts(2000, 1.0, 20).front();
    for (Eigen::Index i = 0; i < impacts.size(); ++i) {
        const Scale scale = Scale::of(impacts.at(i).contact, impacts.velocity[i]);
        const double number = std::pow(10.0, 9.3 + 1.7 * static_cast<double>(i) / 2000.0);
        impacts.damping[i] = scale.damping_coefficient(impacts.damping_law, number);
    }
    const ImpactBatchResult result = solve_impacts(impacts.batch());
    CHECK((result.outcome == Outcome::capture).all());
    CHECK((result.restitution == 0.0).all());
    CHECK(result.contact_time.isNaN().all());
}

TEST_CASE("a table tells most impacts, undamped ones and those of no adhesion too") {
    for (Impacts& impacts : random_impacts(400, 1.0, 18)) {
        if (method_of_many(impacts.law, impacts.damping_law) != BatchMethod::table) continue;
        CAPTURE(name_of(impacts));
        for (Eigen::Index i = 0; i < 100; ++i) impacts.damping[i] = 0.0;
        for (Eigen::Index i = 50; i < 150; ++i) impacts.work_of_adhesion[i] = 0.0;
        const ImpactBatchResult read =
            solve_impacts(impacts.batch(), {.turning_point = false, .method = BatchMethod::table});
        CHECK(read.scalar <= impacts.size() / 50);
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            CAPTURE(i);
            const ImpactResult reference = solve_impact(impacts.at(i));
            REQUIRE(read.outcome[i] == reference.outcome);
            CHECK(conditioned_error(read.restitution[i], reference) <= bound_of(impacts.law));
            CHECK(read.restitution[i] <= 1.0);
        }
    }
}

namespace {

/// The impact of a batch has outcome, restitution and turning point of the scalar solver.
void check_as_alone(const Impacts& impacts, const ImpactBatchResult& result, Eigen::Index i,
                    const ImpactResult& alone) {
    CHECK(result.outcome[i] == alone.outcome);
    CHECK(conditioned_error(result.restitution[i], alone) <= bound_of(impacts.law));
    CHECK(relative_difference(result.maximum_overlap[i], alone.maximum_overlap) <= 1e-9);
}

}  // namespace

TEST_CASE("impacts that yield are followed in lanes, to the turn and back on the flattened sphere") {
    for (const Impacts& impacts : random_impacts(sanitized ? 10 : 400, 1.0, 16)) {
        if (!impacts.law.is_plastic()) continue;
        CAPTURE(name_of(impacts));
        const ImpactBatchResult result = solve_impacts(impacts.batch());
        CHECK(result.scalar <= impacts.size() / 20);
        Eigen::Index yielded = 0;
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            CAPTURE(i);
            const ImpactResult alone = solve_impact(impacts.at(i));
            yielded += alone.yielded ? 1 : 0;
            check_as_alone(impacts, result, i, alone);
            CHECK(std::isnan(result.approach_time[i]) != alone.approach_time.has_value());
        }
        CHECK(yielded > impacts.size() / 8);
        CHECK(yielded < impacts.size());
    }
}

TEST_CASE("impacts that turn next to their yield point, before or beyond it, turn where they do alone") {
    Random random(42);
    for (Impacts& impacts : random_impacts(sanitized ? 10 : 200, 1.0, 42)) {
        if (!impacts.law.is_plastic()) continue;
        CAPTURE(name_of(impacts));
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            Impact elastic = impacts.at(i);
            elastic.contact.yield_pressure = 1e6 * elastic.contact.contact_modulus;
            const double length = Scale::of(elastic.contact, elastic.velocity).length;
            const double adhesion = Jkr<double>::adhesion_number(elastic.contact, length);
            const double overlap = solve_impact(elastic).maximum_overlap / length;
            double u = 1.0 + std::sqrt(std::sqrt(overlap)) + std::cbrt(adhesion);
            for (int k = 0; k < 12; ++k)  // Newton from above
                u -= (power<4>(u) - adhesion * u - overlap) / (4.0 * power<3>(u) - adhesion);
            const double nearness = random.log_uniform(1e-9, 1e-2) * (i % 2 == 0 ? 1.0 : -1.0);
            const double yield = u * (1.0 - nearness);
            elastic.contact.yield_pressure = 1.0;
            impacts.yield_pressure[i] = (power<2>(yield) - adhesion / (2.0 * yield)) /
                                        ThorntonNing<double>::yield_number(elastic.contact, length);
        }
        const ImpactBatchResult result = solve_impacts(impacts.batch());
        const ImpactBatchResult read =
            solve_impacts(impacts.batch(), {.turning_point = false, .method = BatchMethod::table});
        Eigen::Index yielded = 0;
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            CAPTURE(i);
            const ImpactResult alone = solve_impact(impacts.at(i));
            yielded += alone.yielded ? 1 : 0;
            check_as_alone(impacts, result, i, alone);
            CHECK(read.outcome[i] == alone.outcome);
            CHECK(conditioned_error(read.restitution[i], alone) <= bound_of(impacts.law));
            if (alone.approach_time)
                CHECK(relative_difference(result.approach_time[i], *alone.approach_time) <= 1e-8);
        }
        CHECK(yielded > impacts.size() / 4);
        CHECK(yielded < impacts.size() - impacts.size() / 4);
    }
}

TEST_CASE("damping of two numbers goes through the scalar solver") {
    Impacts impacts = random_impacts_of(Law::of<Jkr>(), 20, 0.3, 16);
    impacts.detachment = Detachment::pull_off;
    impacts.law = Law::of<ThorntonNing>();
    impacts.damping_law = DampingLaw::brach_dunn;
    impacts.yield_pressure = Eigen::ArrayXd::Constant(impacts.size(), 2e9);
    const ImpactBatch batch = impacts.batch();
    const ImpactBatchResult result = solve_impacts(batch);
    CHECK(result.scalar == impacts.size());
    CHECK(input_error_of([&] { return solve_impacts(batch, {.method = BatchMethod::table}); }) ==
          "method 'table': law 'thornton-ning' with damping law 'brach-dunn-damping' has no table; allowed: "
          "integration");
    // Whatever the columns held before, such as possible turns.
    Eigen::ArrayXd approach_time = Eigen::ArrayXd::Constant(impacts.size(), 1e-300);
    Eigen::ArrayXd maximum_overlap = Eigen::ArrayXd::Constant(impacts.size(), 1e-9);
    solve_impacts(batch, {.approach_time = approach_time.data(), .maximum_overlap = maximum_overlap.data()},
                  {});
    for (Eigen::Index i = 0; i < impacts.size(); ++i) {
        const ImpactResult alone = solve_impact(impacts.at(i));
        CHECK(result.restitution[i] == alone.restitution);
        CHECK(alone.approach_time.has_value() == !std::isnan(approach_time[i]));
        if (alone.approach_time) CHECK(approach_time[i] == *alone.approach_time);
        CHECK(maximum_overlap[i] == alone.maximum_overlap);
    }
}

TEST_CASE(
    "a turn that is lost in rounding, and a rebound out of a well far deeper than its energy, are right") {
    // Stopped by damping alone: the contact's own force is 1e-12 of that of the damping.
    const Impact stopped{.law = Law::of<Dmt>(),
                         .detachment = Detachment::zero_overlap,
                         .damping = {DampingLaw::constant, 3313.3401365340842},
                         .contact = {.mass = 5.4671483166794746e-9,
                                     .effective_radius = 2.0795602945493365e-10,
                                     .contact_modulus = 709577.23094357073,
                                     .work_of_adhesion = 1.0001917812836072e-9},
                         .velocity = 9.6807852957046414};
    // Adhesion takes eight million times what the impact brings.
    const Impact deep{.law = Law::of<Jkr>(),
                      .detachment = Detachment::zero_overlap,
                      .damping = {DampingLaw::constant, 6.045384999413128e-13},
                      .contact = {.mass = 1.4825068210814381e-13,
                                  .effective_radius = 2.0123254187960524e-6,
                                  .contact_modulus = 2362878797.0190778,
                                  .work_of_adhesion = 205.94837477023944},
                      .velocity = 0.04369800849136795};
    // Damped nearly critically: it creeps up to equilibrium, and rounding makes it seem to turn there.
    const Impact creeping{.law = Law::of<Jkr>(),
                          .detachment = Detachment::load_controlled,
                          .damping = {DampingLaw::constant, 0.12285755870029297},
                          .contact = {.mass = 1.5773306577260458e-9,
                                      .effective_radius = 36.449984335509349,
                                      .contact_modulus = 878769.27807571762,
                                      .work_of_adhesion = 546.34430536746243},
                          .velocity = 0.0044471614277916943};
    CHECK(std::isnan(solve_impacts(ImpactList({creeping}).batch()).approach_time[0]));
    CHECK_FALSE(solve_impact(creeping).approach_time.has_value());
    for (const Impact& impact : {stopped, deep}) {
        CAPTURE(impact.law.name());
        const ImpactBatchResult result = solve_impacts(ImpactList({impact}).batch());
        const ImpactResult reference = solve_impact(impact);
        CHECK(result.outcome[0] == reference.outcome);
        CHECK(conditioned_error(result.restitution[0], reference) <= bound_of(impact.law));
        CHECK(relative_difference(result.maximum_overlap[0], reference.maximum_overlap) < 1e-8);
        CHECK(relative_difference(result.approach_time[0], reference.approach_time.value()) < 1e-6);
    }
}

TEST_CASE("what is inadmissible is refused with the place of the first such impact") {
    Impacts impacts = random_impacts(5000, 1.0, 17).front();
    impacts.velocity[4321] = -1.0;
    impacts.velocity[4500] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(static_cast<void>(solve_impacts(impacts.batch(), {.threads = 2})),
                         "impact 4321: velocity is -1 m/s; allowed: a positive velocity [m/s]", InputError);
    impacts.velocity.conservativeResize(17);
    CHECK_THROWS_AS(static_cast<void>(solve_impacts(impacts.batch())), InputError);
    impacts = random_impacts(4, 1.0, 17).front();
    impacts.detachment = Detachment::pull_off;
    CHECK_THROWS_AS(static_cast<void>(solve_impacts(impacts.batch())), InputError);
}

TEST_CASE("numbers whose powers are no numbers are refused as one impact alone is") {
    Impacts impacts = random_impacts(5, 1.0, 17).front();
    impacts.mass[3] = 1e-41;
    CHECK_THROWS_WITH_AS(static_cast<void>(solve_impacts(impacts.batch())),
                         "impact 3: mass is 1e-41 kg; allowed: 1e-40 to 1e40 kg", InputError);
    impacts.damping[2] = 1e-300;
    CHECK_THROWS_WITH_AS(static_cast<void>(solve_impacts(impacts.batch())),
                         "impact 2: damping is 1e-300 kg/s; allowed: 0, or 1e-40 to 1e40 kg/s", InputError);
    impacts.work_of_adhesion[1] = 1e41;
    CHECK_THROWS_WITH_AS(static_cast<void>(solve_impacts(impacts.batch())),
                         "impact 1: work_of_adhesion is 1e+41 J/m2; allowed: 0, or 1e-40 to 1e40 J/m2",
                         InputError);
}

TEST_CASE("an inadmissible value is found wherever it stands, and zero where it may stand") {
    for (const Eigen::Index place : {0, 1, 31, 32, 77, 2047, 2048, 2999}) {
        CAPTURE(place);
        Impacts impacts = random_impacts_of(Law::of<Dmt>(), 3000, 1.0, 18);
        impacts.damping[place] = 0.0;
        impacts.work_of_adhesion[place] = -0.0;
        const std::string here = "impact " + std::to_string(place) + ":";
        const auto message = [&] {
            return input_error_of(
                       [&] { return solve_impacts(impacts.batch(), {.method = BatchMethod::table}); })
                .substr(0, here.size());
        };
        CHECK(message().empty());
        for (const double bad : {0.0, -1.0, 9e-41, 2e40, std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()}) {
            CAPTURE(bad);
            impacts.velocity[place] = bad;
            CHECK(message() == here);
        }
    }
}

TEST_CASE(
    "random impacts, a million in the whole form: integrated and tabulated batches do what the scalar solver "
    "does") {
    const auto sets = std::ssize(random_impacts(1, 1.0, 51));
    Eigen::Index solved = 0;
    Eigen::Index rebounds = 0;
    for (const double most_damping : {1.1, 2.2}) {  // where damping captures almost everything, fewer
        const Eigen::Index each = most_damping < 2 ? impacts_in_all() / sets + 1 : 80;
        for (const Impacts& impacts : random_impacts(each, most_damping, 51)) {
            CAPTURE(name_of(impacts));
            const Agreements found = agreements(impacts);
            const double wider = bound_of(impacts.law) / 1e-12;
            solved += impacts.size();
            rebounds += found.rebounds;
            for (const Agreement& agreement : {found.integrated, found.tabulated}) {
                CHECK(agreement.outcomes == 0);
                CHECK(agreement.restitution <= 1e-12 * wider);
                CHECK(agreement.contact_time <= 1e-11 * wider);
                CHECK(agreement.turn <= 1e-9);
            }
        }
    }
    CHECK(solved >= impacts_in_all());
    CHECK(rebounds > solved / 4);
    CHECK(rebounds < solved);
}
