// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <set>
#include <thread>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "pipeline/app/sweep/workers.hpp"

using namespace ashimpact;

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
