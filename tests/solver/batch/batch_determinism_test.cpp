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
#include "solver/batch/tables/restitution_table.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"
#include "tests/solver/batch/batch_sample.hpp"

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
const std::vector<BatchOptions> every_method{
    {.method = BatchMethod::integration},
    {.turning_point = false, .method = BatchMethod::table},
};

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
            if (difference <= 1e-12) continue;
            CHECK(conditioned_error(other.restitution[i], solve_impact(impacts.at(i))) <= 1e-12);
            CHECK(conditioned_error(baseline.restitution[i], solve_impact(impacts.at(i))) <= 1e-12);
        }
    }
}

}  // namespace

TEST_CASE("an impact's result does not depend, in any bit, on order, number and threads") {
    const Eigen::Index count = 2000;
    for (const std::string_view set : instruction_sets()) {
        CAPTURE(set);
        const Prescribed prescribed(set);
        for (const Impacts& impacts : random_impacts(set == "baseline" ? count / 8 : count, 1.3, 21)) {
            CAPTURE(impacts.law.name());
            for (const BatchOptions& options : every_method) check_same_bits(impacts, options);
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
            REQUIRE(a.content()->restitution_squared.low == b.content()->restitution_squared.low);
            REQUIRE(a.content()->restitution_squared.high == b.content()->restitution_squared.high);
            REQUIRE(a.content()->contact_time.low == b.content()->contact_time.low);
            REQUIRE(a.content()->contact_time.high == b.content()->contact_time.high);
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
        for (const BatchOptions& options : every_method) check_sets_agree(impacts, options);
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
