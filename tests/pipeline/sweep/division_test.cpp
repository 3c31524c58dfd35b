// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <set>
#include <thread>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "pipeline/app/sweep/block.hpp"
#include "pipeline/app/sweep/bytes.hpp"
#include "pipeline/app/sweep/workers.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/pipeline/sweep/specs.hpp"

using namespace ashimpact;
using test::Sandbox;

namespace {

const std::vector<std::string> divided_sweep{ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json"};

std::vector<std::string> with_threads(int threads) {
    std::vector<std::string> command = divided_sweep;
    command.insert(command.end(), {"--threads", std::to_string(threads)});
    return command;
}

/// Every byte a sweep left.
auto left_by(const std::vector<std::string>& command, double samples) {
    const Sandbox sandbox;
    sandbox.write("spec.json", test::full_spec(samples).dump());
    const test::Ended ended = test::run(sandbox, command);
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
    auto files = sandbox.everything();
    REQUIRE(files.size() == 4);  // and the spec
    CHECK(files[0].first == "out.h5");
    CHECK(files[1].first == "out.html");
    CHECK(files[2].first == "out.json");
    return files;
}

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

TEST_CASE("any number of threads and ranks leaves the same bytes, of tables and of integration") {
    for (const double samples : {test::many_samples, test::many_samples / 10}) {
        CAPTURE(samples);
        const auto one = left_by(with_threads(1), samples);
        CHECK(one == left_by(with_threads(5), samples));
        const bool many = samples == test::many_samples;
        for (const int ranks : many ? std::vector{2} : std::vector{1, 3, 4}) {
            CAPTURE(ranks);
            CHECK(one == left_by(test::under_mpi(ranks, with_threads(ranks == 2 ? 2 : 1)), samples));
        }
    }
}

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

TEST_CASE("every block that is assigned comes back once") {
    ThreadWorkers threads(2, [](const Block& block) { return std::to_string(block.first); });
    CHECK(threads.capacity() == 4);
    std::set<std::string> seen;
    std::uint64_t next = 0;
    while (seen.size() < 100) {
        while (next < 100 && threads.vacancies() > 0) threads.assign({next++, 0});
        if (const auto done = threads.finished(std::chrono::seconds(10))) {
            CHECK(done->bytes == std::to_string(done->block.first));
            CHECK(seen.insert(done->bytes).second);
        }
    }
    CHECK(threads.vacancies() == threads.capacity());
}

TEST_CASE("as many threads work at once as asked for, whatever the number of cores") {
    std::atomic<int> working = 0;
    std::atomic<int> most = 0;
    ThreadWorkers threads(3, [&](const Block&) {
        most = std::max(most.load(), ++working);
        for (int i = 0; i < 2000 && most < 3; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        --working;
        return std::string();
    });
    for (std::uint64_t i = 0; i < 3; ++i) threads.assign({i, 0});
    for (int i = 0; i < 3; ++i) CHECK(threads.finished(std::chrono::seconds(20)).has_value());
    CHECK(most == 3);
}

TEST_CASE("what the work throws comes out; patience ends") {
    ThreadWorkers threads(1, [](const Block& block) -> std::string {
        if (block.first == 1) throw ConvergenceError("block 1");
        return {};
    });
    CHECK_FALSE(threads.finished(std::chrono::milliseconds(1)).has_value());
    threads.assign({1, 0});
    CHECK_THROWS_WITH_AS(static_cast<void>(threads.finished(std::chrono::seconds(10))), "block 1",
                         ConvergenceError);
}

TEST_CASE("the share of the cores is one thread at least") {
    CHECK(default_threads(1) >= 1);
    CHECK(default_threads(1000) == 1);
}
