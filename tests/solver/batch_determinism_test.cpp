#include "solver/batch/impact_batch.hpp"
#include "solver/batch/instruction_set.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

#include "materials/error.hpp"
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

/// Has an instruction set used for as long as it lives.
class Prescribed {
  public:
    explicit Prescribed(std::string_view name) { use_instruction_set(name); }
    ~Prescribed() { use_instruction_set({}); }
    Prescribed(const Prescribed&) = delete;
    Prescribed& operator=(const Prescribed&) = delete;
};

}  // namespace

TEST_CASE("an impact's result does not depend, in any bit, on order, number and threads") {
    const Eigen::Index count = 5000;
    for (const std::string_view set : instruction_sets()) {
        CAPTURE(set);
        const Prescribed prescribed(set);
        for (const Impacts& impacts : random_impacts(set == "baseline" ? count / 8 : count, 1.3, 21)) {
            CAPTURE(impacts.law.name());
            const ImpactBatchResult whole = solve_impacts(impacts.batch());
            CHECK(identical(whole, solve_impacts(impacts.batch(), {.threads = 3})));
            const auto order = shuffled(impacts.size());
            CHECK(identical(picked(whole, order), solve_impacts(impacts.picked(order).batch())));
            const std::vector<Eigen::Index> few(order.begin(), order.begin() + 37);
            CHECK(identical(picked(whole, few), solve_impacts(impacts.picked(few).batch())));
            for (const Eigen::Index one : {order[0], order[1]}) {
                CHECK(identical(picked(whole, {one}), solve_impacts(impacts.picked({one}).batch())));
            }
        }
    }
}

TEST_CASE("instruction sets agree within the bound of the solver") {
    for (const Impacts& impacts : random_impacts(1000, 1.2, 22)) {
        use_instruction_set("baseline");
        const ImpactBatchResult baseline = solve_impacts(impacts.batch());
        for (const std::string_view set : instruction_sets()) {
            CAPTURE(set);
            const Prescribed prescribed(set);
            const ImpactBatchResult other = solve_impacts(impacts.batch());
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
}

TEST_CASE("instruction sets: the baseline is always there, an unknown one is refused by name") {
    const auto sets = instruction_sets();
    REQUIRE(!sets.empty());
    CHECK(sets.back() == "baseline");
    CHECK_THROWS_AS(use_instruction_set("mmx"), InputError);
    use_instruction_set({});
}
