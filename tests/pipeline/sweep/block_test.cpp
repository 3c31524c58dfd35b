// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/block.hpp"

#include <doctest/doctest.h>

#include "pipeline/app/sweep/bytes.hpp"
#include "tests/pipeline/sweep/specs.hpp"

using namespace ashimpact;

namespace {

/// Restitutions with digits down to the last, so that any change of order shows.
ResultColumns formula(const ImpactModel& model, const ImpactColumns& impacts, const WantedResults& wanted) {
    ResultColumns results;
    for (std::size_t i = 0; i < impacts.velocity.size(); ++i) {
        const double x = impacts.velocity[i] * value_at(impacts.effective_radius, i) * 1e4 /
                         (1.0 + static_cast<double>(model.law.index()));
        results.restitution.push_back(std::max(0.0, 1 - 1 / (0.7 + x)));
        if (wanted.contact_time)
            results.contact_time.push_back(results.restitution.back() > 0 ? x : std::nan(""));
    }
    return results;
}

std::string tallied(const SweepPlan& plan, const std::vector<unsigned>& levels) {
    SweepProgress progress;
    std::string rows;
    for (const unsigned level : levels) {
        const Block block{progress.chunks, level};
        BlockResult result = compute_block(plan, formula, block);
        rows += result.rows;
        progress.add(block, std::move(result));
    }
    CHECK(progress.chunks == plan.chunks());
    return packed(std::move(progress)) + rows;
}

}  // namespace

TEST_CASE("blocks of any level give the same bytes as chunk by chunk") {
    for (const char* method : {"random", "quasi-random"}) {
        Json spec = test::full_spec(14'000);
        spec["sampling"]["method"] = method;
        const SweepPlan plan(spec.dump());
        REQUIRE(plan.chunks() == 7);
        const std::string whole = tallied(plan, {0, 0, 0, 0, 0, 0, 0});
        CHECK(tallied(plan, {2, 1, 0}) == whole);
        CHECK(tallied(plan, {1, 0, 0, 1, 0}) == whole);
    }
}

TEST_CASE(
    "the progress of a sweep does not grow with the number of chunks, but for one node each time it "
    "doubles") {
    Json spec = test::full_spec(600'000);
    spec.erase("table");
    const SweepPlan plan(spec.dump());
    SweepProgress progress;
    std::size_t at_sixteen = 0;
    while (progress.chunks < 256) {
        const Block block{progress.chunks, 4};
        progress.add(block, compute_block(plan, formula, block));
        const std::size_t size = packed(progress).size();
        if (at_sixteen == 0) at_sixteen = size;
        CHECK(size < 5 * at_sixteen);
    }
}

TEST_CASE("points are numbered through chunks; the last one has what is left") {
    const SweepPlan plan(test::full_spec(14'000).dump());
    CHECK(plan.impacts_a_point() == 4);
    CHECK(plan.points_in(0) == 2048);
    CHECK(plan.points_in(6) == 14'000 - 6 * 2048);
    CHECK(plan.first_point(6) == 6 * 2048);
    CHECK(plan.rows() == 56'000);
    CHECK(plan.impacts() == 112'000);
    CHECK(plan.wanted().contact_time);
    CHECK_FALSE(plan.wanted().maximum_overlap);
}
