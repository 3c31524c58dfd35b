// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <thread>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/kernels/kernel.hpp"
#include "solver/batch/tables/law_tables.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/damping/damping.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/motion/scale.hpp"
#include "tests/solver/batch/batch_sample.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

std::vector<Eigen::Index> shuffled(Eigen::Index count) {
    std::vector<Eigen::Index> places(static_cast<std::size_t>(count));
    std::iota(places.begin(), places.end(), Eigen::Index{0});
    std::shuffle(places.begin(), places.end(), std::mt19937_64(5));
    return places;
}

ImpactBatchResult picked(const ImpactBatchResult& result, const std::vector<Eigen::Index>& places) {
    ImpactBatchResult some;
    some.outcome = result.outcome(places);
    some.restitution = result.restitution(places);
    some.contact_time = result.contact_time(places);
    some.approach_time = result.approach_time(places);
    some.maximum_overlap = result.maximum_overlap(places);
    return some;
}

/// Every way to solve a batch; a table has no turning points.
std::vector<BatchOptions> ways_of(const Impacts& impacts) {
    std::vector<BatchOptions> ways;
    for (const BatchMethod method : methods_of(impacts))
        ways.push_back({.turning_point = method == BatchMethod::integration, .method = method});
    return ways;
}

BatchOptions on_threads(BatchOptions options, int threads) {
    options.threads = threads;
    return options;
}

/// Checks that results are the same, bit by bit, for any threads, order and number of impacts.
void check_same_bits(const Impacts& impacts, const BatchOptions& options) {
    const ImpactBatchResult whole = solve_impacts(impacts.batch(), options);
    CHECK(identical(whole, solve_impacts(impacts.batch(), on_threads(options, 3))));
    const auto order = shuffled(impacts.size());
    CHECK(identical(picked(whole, order), solve_impacts(impacts.picked(order).batch(), options)));
    const std::vector<Eigen::Index> few(order.begin(), order.begin() + 37);
    CHECK(identical(picked(whole, few), solve_impacts(impacts.picked(few).batch(), options)));
    for (const Eigen::Index one : {order[0], order[1]}) {
        CHECK(identical(picked(whole, {one}), solve_impacts(impacts.picked({one}).batch(), options)));
    }
}

#ifdef __SANITIZE_ADDRESS__
constexpr int places_asked = 400;
#else
constexpr int places_asked = 10'000;
#endif

/// Random coordinates of a table, from 0 to where nothing rebounds.
class Places {
  public:
    explicit Places(unsigned seed) : random_(seed) {}
    double next() { return 0.6 * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max()); }

  private:
    std::mt19937 random_;
};

/// Has an instruction set used for as long as it lives.
class Prescribed {
  public:
    explicit Prescribed(std::string_view name) { use_instruction_set(name); }
    ~Prescribed() { use_instruction_set({}); }
    Prescribed(const Prescribed&) = delete;
    Prescribed& operator=(const Prescribed&) = delete;
};

void check_sets_agree(const Impacts& impacts, const BatchOptions& options) {
    use_instruction_set("baseline");
    const ImpactBatchResult baseline = solve_impacts(impacts.batch(), options);
    for (const std::string_view set : instruction_sets()) {
        CAPTURE(set);
        const Prescribed prescribed(set);
        const ImpactBatchResult other = solve_impacts(impacts.batch(), options);
        CHECK((other.outcome == baseline.outcome).all());
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            const double difference = std::abs(other.restitution[i] * other.restitution[i] -
                                               baseline.restitution[i] * baseline.restitution[i]);
            const double bound = bound_of(impacts.law);
            if (difference <= bound) continue;
            CHECK(conditioned_error(other.restitution[i], solve_impact(impacts.at(i))) <= bound);
            CHECK(conditioned_error(baseline.restitution[i], solve_impact(impacts.at(i))) <= bound);
        }
    }
}

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

TEST_CASE("an impact's result does not depend, in any bit, on order, number and threads") {
    const Eigen::Index count = 2000;
    for (const std::string_view set : instruction_sets()) {
        CAPTURE(set);
        const Prescribed prescribed(set);
        for (const Impacts& impacts : random_impacts(set == "baseline" ? count / 8 : count, 1.3, 21)) {
            CAPTURE(impacts.law.name());
            for (const BatchOptions& options : ways_of(impacts)) check_same_bits(impacts, options);
        }
    }
}

TEST_CASE("a piece of a table is the same, in every bit, whoever asked for it first, and when") {
    const auto table = [] {
        return std::make_unique<batch::RestitutionTable>(
            batch::kernels_of(Law::of<Dmt>(), DampingLaw::constant).numbers, Detachment::zero_overlap,
            DampingLaw::constant);
    };
    const auto ask = [](batch::RestitutionTable& of, unsigned seed) {
        Places places(seed);
        for (int i = 0; i < places_asked; ++i) {
            const double x = places.next();
            static_cast<void>(of.at(x, places.next()));
        }
    };
    const auto one = table();
    ask(*one, 1);
    ask(*one, 2);
    const auto other = table();
    ask(*other, 2);
    const auto shared = table();
    std::thread first(ask, std::ref(*shared), 2);
    ask(*shared, 3);
    first.join();
    int rebounds = 0;
    int captures = 0;
    int undecided = 0;
    Places places(4);
    for (int i = 0; i < 2 * places_asked; ++i) {
        const double x = places.next();
        const double y = places.next();
        const batch::RestitutionPiece& a = *one->at(x, y);
        for (const auto* table_asked : {&other, &shared}) {
            const batch::RestitutionPiece& b = *(*table_asked)->at(x, y);
            REQUIRE(a.state() == b.state());
            REQUIRE(a.local(0, x) == b.local(0, x));
            REQUIRE(a.local(1, y) == b.local(1, y));
            if (a.state() != batch::PieceState::tabulated) continue;
            REQUIRE(a.content()[0].result.low == b.content()[0].result.low);
            REQUIRE(a.content()[0].result.high == b.content()[0].result.high);
            REQUIRE(a.content()[0].time.low == b.content()[0].time.low);
            REQUIRE(a.content()[0].time.high == b.content()[0].time.high);
        }
        rebounds += a.state() == batch::PieceState::tabulated ? 1 : 0;
        captures += a.state() == batch::PieceState::captured ? 1 : 0;
        undecided += a.state() == batch::PieceState::undecided ? 1 : 0;
    }
    CHECK(rebounds > places_asked / 2);
    CHECK(captures > places_asked / 2);
    CHECK(undecided > places_asked / 200);
    CHECK(undecided < places_asked / 10);
    CHECK(one->at(std::numeric_limits<double>::quiet_NaN(), 0.5) == nullptr);
}

TEST_CASE("instruction sets agree within the bound of the solver") {
    for (const Impacts& impacts : random_impacts(1000, 1.2, 22)) {
        for (const BatchOptions& options : ways_of(impacts)) check_sets_agree(impacts, options);
    }
}

TEST_CASE("instruction sets: the baseline is always there, an unknown one is refused by name") {
    const auto sets = instruction_sets();
    REQUIRE(!sets.empty());
    CHECK(sets.back() == "baseline");
    CHECK_THROWS_AS(use_instruction_set("mmx"), InputError);
    use_instruction_set({});
}

using namespace ashimpact::batch;

TEST_CASE("the square that a table gives for a place holds it, at the edges of the table as well") {
    RestitutionTable& table =
        restitution_table(Law::of<Dmt>(), Detachment::zero_overlap, DampingLaw::constant);
    const auto check = [&](double x, double y) {
        const RestitutionPiece* piece = table.at(x, y);
        CAPTURE(x);
        CAPTURE(y);
        REQUIRE(piece != nullptr);
        CHECK(x >= piece->lower(0));
        CHECK(x <= piece->upper(0));
        CHECK(y >= piece->lower(1));
        CHECK(y <= piece->upper(1));
        CHECK(piece->state() != PieceState::unknown);
        CHECK(piece->state() != PieceState::divided);
    };
    // The edges first: a place that was entered wrongly is found again by those after it.
    for (const double edge : {1.0, 0.0})
        for (int i = 0; i <= 256; ++i) {
            check(edge, i / 256.0);
            check(i / 256.0, edge);
        }
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j) check((i + 0.4) / 64, (j + 0.6) / 64);
    CHECK(table.at(std::nan(""), 0.5) == nullptr);
}

TEST_CASE("tabulated critical velocities are those of the backward integration to 1e-10") {
    for (Impacts& impacts : random_impacts(60, 2.0, 31)) {
        if (impacts.law.has_cohesive_zone() || impacts.law.is_plastic()) continue;
        impacts.damping[0] = 0.0;
        impacts.damping[1] *= 1e-7;
        impacts.damping[2] *= 1e3;
        impacts.work_of_adhesion[3] = 0.0;
        const CriticalVelocityBatchResult result = critical_velocities(critical_batch(impacts));
        CAPTURE(name_of(impacts));
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

TEST_CASE("critical velocities beyond yield are those of the backward integration to 1e-9, on any threads" *
          doctest::test_suite("long")) {
    int yielded = 0;
    int sets = 0;
    for (const Impacts& impacts : random_impacts(sanitized ? 2 : 24, 1.5, 37)) {
        if (!impacts.law.is_plastic()) continue;
        CAPTURE(name_of(impacts));
        ++sets;
        const CriticalVelocityBatchResult result = critical_velocities(critical_batch(impacts));
        const CriticalVelocityBatchResult threaded = critical_velocities(critical_batch(impacts), 3);
        CHECK(result.scalar <= impacts.size() / 8);
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            CAPTURE(i);
            const Impact impact = impacts.at(i);
            const CriticalVelocity reference =
                critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
            REQUIRE(result.verdict[i] == reference.verdict);
            if (reference.value) CHECK(relative_difference(result.value[i], *reference.value) <= 1e-9);
            CHECK(same(result.value[i], threaded.value[i]));
            const Impacts alone = impacts.picked({i});
            CHECK(same(critical_velocities(critical_batch(alone)).value[0], result.value[i]));
            yielded += reference.plastic > 0.0 ? 1 : 0;
        }
    }
    if (sets > 0 && !sanitized) CHECK(yielded >= 2 * sets);
}

/// Spheres with a cohesive zone that differ in Tabor parameter and damping alone.
struct ZonePairs {
    Detachment detachment;
    DampingLaw damping_law;
    Eigen::ArrayXd tabor;
    Eigen::ArrayXd damping;

    static constexpr ContactPair sphere{
        .mass = 1e-9, .effective_radius = 22e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.3};

    [[nodiscard]] CriticalVelocityProblem at(Eigen::Index i) const {
        CriticalVelocityProblem problem{
            Law::of<MaugisDugdale>(), detachment, {damping_law, damping[i]}, sphere};
        problem.contact.parameters.set("tabor", tabor[i]);
        return problem;
    }
    [[nodiscard]] CriticalVelocityBatchResult solve(BatchMethod method, int threads = 1) const {
        const auto one = [](double value) { return Eigen::ArrayXd::Constant(1, value).eval(); };
        const Eigen::ArrayXd mass = one(sphere.mass);
        const Eigen::ArrayXd radius = one(sphere.effective_radius);
        const Eigen::ArrayXd modulus = one(sphere.contact_modulus);
        const Eigen::ArrayXd work = one(sphere.work_of_adhesion);
        return critical_velocities({Law::of<MaugisDugdale>(),
                                    detachment,
                                    damping_law,
                                    {mass, radius, modulus, work, never_yields, {{"tabor", tabor}}},
                                    damping},
                                   threads, method);
    }
};

/// Every detachment and damping law of one term, Tabor parameters from @p tabor to 1.1 of it.
std::vector<ZonePairs> zone_pairs(double tabor, Eigen::Index count) {
    std::vector<ZonePairs> all;
    Random random(36);
    const Scale scale = Scale::of(ZonePairs::sphere, maugis_velocity(ZonePairs::sphere));
    for (const Detachment detachment : all_values<Detachment>) {
        if (refusal(Law::of<MaugisDugdale>(), detachment)) continue;
        for (const DampingLaw law : all_values<DampingLaw>) {
            if (!batch::has_kernels(Law::of<MaugisDugdale>(), law)) continue;
            ZonePairs pairs{detachment, law, Eigen::ArrayXd(count), Eigen::ArrayXd(count)};
            for (Eigen::Index i = 0; i < count; ++i) {
                pairs.tabor[i] = random.uniform(tabor, 1.1 * tabor);
                pairs.damping[i] = scale.damping_coefficient(law, random.log_uniform(0.02, 4.0));
            }
            pairs.damping[0] = 0.0;
            pairs.damping[1] *= 1e-12;
            all.push_back(std::move(pairs));
        }
    }
    return all;
}

TEST_CASE("tabulated critical velocities of a cohesive zone are those of the backward integration to 1e-9") {
    for (const double tabor : {0.3, 0.7, 4.0}) {
        if (sanitized && tabor < 4.0) continue;  // the same code, for a minute
        for (const ZonePairs& pairs : zone_pairs(tabor, sanitized ? 8 : 30)) {
            // A zone of long reach refuses that end: no undamped impact may gain energy.
            if (pairs.detachment == Detachment::load_controlled && tabor < 2.0) continue;
            const CriticalVelocityBatchResult result = pairs.solve(BatchMethod::table);
            CAPTURE(tabor);
            CAPTURE(name_of(pairs.detachment));
            CAPTURE(name_of(pairs.damping_law));
            CHECK(result.scalar <= pairs.damping.size() / 3);
            for (Eigen::Index i = 0; i < pairs.damping.size(); ++i) {
                CAPTURE(pairs.damping[i]);
                const CriticalVelocity reference = critical_velocity(pairs.at(i));
                REQUIRE(result.verdict[i] == reference.verdict);
                if (reference.value) CHECK(relative_difference(result.value[i], *reference.value) <= 1e-9);
            }
        }
    }
}

TEST_CASE("impacts beside a tabulated critical velocity of a cohesive zone end on its two sides") {
    for (const ZonePairs& pairs : zone_pairs(2.0, 6)) {
        const CriticalVelocityBatchResult result = pairs.solve(BatchMethod::table);
        // The first two have next to no damping: where contact also ends at the overlap at which it began,
        // no precision resolves a part in 1e9 of v_c.
        for (Eigen::Index i = 2; i < pairs.damping.size(); ++i) {
            if (result.verdict[i] != CaptureVerdict::finite) continue;
            const auto [law, detachment, damping, contact] = pairs.at(i);
            const auto outcome_at = [&](double velocity) {
                return solve_impact({law, detachment, damping, contact, velocity}).outcome;
            };
            CHECK(outcome_at(result.value[i] * (1.0 - 1e-9)) == Outcome::capture);
            CHECK(outcome_at(result.value[i] * (1.0 + 1e-9)) == Outcome::rebound);
        }
    }
}

TEST_CASE("tabulated critical velocities of a cohesive zone: no bit depends on threads or the batch") {
    const std::vector<ZonePairs> all = zone_pairs(2.0, 5000);
    if (all.empty()) return;  // a build without the kernels of this law
    const ZonePairs& pairs = all.front();
    const CriticalVelocityBatchResult one = pairs.solve(BatchMethod::table, 1);
    const CriticalVelocityBatchResult three = pairs.solve(BatchMethod::table, 3);
    Eigen::Index different = 0;
    for (Eigen::Index i = 0; i < one.value.size(); ++i)
        different += same(one.value[i], three.value[i]) ? 0 : 1;
    CHECK(different == 0);
    for (const Eigen::Index i : {Eigen::Index{7}, Eigen::Index{4999}}) {
        const ZonePairs alone{pairs.detachment, pairs.damping_law, pairs.tabor.segment(i, 1),
                              pairs.damping.segment(i, 1)};
        CHECK(same(alone.solve(BatchMethod::table).value[0], one.value[i]));
    }
}

TEST_CASE("damping found from a restitution gives it back") {
    for (const Impacts& impacts : random_impacts(300, 1.0, 32)) {
        if (impacts.law.is_plastic()) continue;  // by the scalar solver
        const ImpactBatchResult forward = solve_impacts(impacts.batch());
        std::vector<Eigen::Index> rebounds;
        for (Eigen::Index i = 0; i < impacts.size(); ++i) {
            if (forward.restitution[i] > 0.01) rebounds.push_back(i);
        }
        Impacts again = impacts.picked(rebounds);
        const Eigen::ArrayXd wanted = forward.restitution(rebounds);
        Impacts undamped = again;
        undamped.damping.setZero();
        CAPTURE(name_of(impacts));
        const double bound = bound_of(impacts.law);
        for (const BatchMethod method : methods_of(impacts)) {
            CAPTURE(method);
            const DampingBatchResult found =
                dampings_from_restitutions(damping_batch(again, wanted), 1, method);
            again.damping = found.damping;
            for (Eigen::Index i = 0; i < again.size(); ++i) {
                CAPTURE(i);
                ImpactResult target = solve_impact(again.at(i));
                CHECK(conditioned_error(wanted[i], target) <= 3.0 * bound);
                CHECK(conditioned_error(found.greatest_restitution[i], solve_impact(undamped.at(i))) <=
                      bound);
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
    for (const Impacts& impacts : random_impacts(sanitized ? 600 : 1200, 0.9, 34)) {
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
