// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tests/pipeline/sweep/process.hpp"
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

}  // namespace

TEST_CASE("any number of threads and ranks leaves the same bytes, of tables and of integration") {
    for (const double samples : {test::many_samples, test::many_samples / 10}) {
        CAPTURE(samples);
        const auto one = left_by(with_threads(1), samples);
        CHECK(one == left_by(with_threads(2), samples));
        CHECK(one == left_by(with_threads(5), samples));
        for (const int ranks : {1, 2, 3, 4}) {
            CAPTURE(ranks);
            CHECK(one == left_by(test::under_mpi(ranks, with_threads(ranks == 2 ? 2 : 1)), samples));
        }
    }
}
