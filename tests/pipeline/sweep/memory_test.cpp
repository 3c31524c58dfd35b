// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tests/pipeline/sweep/process.hpp"
#include "tests/pipeline/sweep/specs.hpp"

using namespace ashimpact;

#ifndef __SANITIZE_ADDRESS__  // which keeps what was freed

TEST_CASE("memory does not depend on the number of samples") {
    long fewer = 0;
    for (const double samples : {2e5, 5e6}) {
        const test::Sandbox sandbox;
        Json spec = test::full_spec(samples);
        for (const char* part : {"sensitivity", "table"}) spec.erase(part);
        sandbox.write("spec.json", spec.dump());
        const test::Ended ended =
            test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json", "--threads", "2"});
        CHECK(ended.status == 0);
        CHECK(ended.peak_memory < 100'000);
        if (fewer == 0) fewer = ended.peak_memory;
        CHECK(ended.peak_memory < fewer + 20'000);
    }
}

#endif
