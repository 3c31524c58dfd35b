#include "solver/batch/impact_batch.hpp"
#include "solver/batch/instruction_set.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>

#include "materials/error.hpp"
#include "solver/batch/restitution_table.hpp"
#include "tests/solver/batch_sample.hpp"

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
    return {.outcome = result.outcome(places),
            .restitution = result.restitution(places),
            .contact_time = result.contact_time(places),
            .approach_time = result.approach_time(places),
            .maximum_overlap = result.maximum_overlap(places)};
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
    const Eigen::Index count = 5000;
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
        return std::make_unique<batch::RestitutionTable>(batch::kernels_of(Law::of<Dmt>()),
                                                         Detachment::zero_overlap, DampingLaw::constant);
    };
    const auto forwards = table();
    const auto backwards = table();
    std::vector<double> places;
    for (int i = 0; i < 40; ++i) places.push_back(0.0131 * i);
    for (const double x : places) {
        for (const double y : places) static_cast<void>(forwards->at(x, y));
    }
    int rebounds = 0;
    int captures = 0;
    for (auto x = places.rbegin(); x != places.rend(); ++x) {
        for (auto y = places.rbegin(); y != places.rend(); ++y) {
            const batch::RestitutionPiece& a = *forwards->at(*x, *y);
            const batch::RestitutionPiece& b = *backwards->at(*x, *y);
            REQUIRE(a.state() == b.state());
            if (a.state() == batch::RestitutionPiece::State::capture) ++captures;
            if (a.state() != batch::RestitutionPiece::State::rebound) continue;
            ++rebounds;
            CHECK(a.polynomials().restitution_squared == b.polynomials().restitution_squared);
            CHECK(a.polynomials().contact_time == b.polynomials().contact_time);
        }
    }
    CHECK(rebounds > 500);
    CHECK(captures > 100);
    CHECK(forwards->at(std::numeric_limits<double>::quiet_NaN(), 0.5) == nullptr);
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
