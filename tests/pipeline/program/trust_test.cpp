// SPDX-License-Identifier: GPL-3.0-or-later
// What nobody's file and no surroundings may do: SECURITY.md.
#include <cstdlib>
#include <string>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::containing;
using test::Sandbox;

namespace {

std::size_t count_of(const std::string& piece, const std::string& text) {
    std::size_t count = 0;
    for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
    return count;
}

/// The report of the example whose case and first sample have this name.
std::string report_with_name(const std::string& name) {
    const Sandbox sandbox;
    Json document = test::example_case();
    document["name"] = name;
    document["laws"] = {"hertz", "jkr"};
    document["samples"][0]["name"] = name;
    test::write_example(sandbox, document);
    const auto run = ashimpact_program(sandbox, "run case.json -o out");
    REQUIRE_MESSAGE(run.status == 0, run.err);
    return sandbox.read("out/report.html");
}

}  // namespace

TEST_CASE("names of a case are text in the report, not HTML, SVG or script") {
    const std::string plain = report_with_name("fine");
    const std::string spoilt = report_with_name("</script></style><svg onload=x()>\"'&lt;");
    CHECK(spoilt == containing("&lt;/script&gt;"));
    CHECK(spoilt != containing("<svg onload"));
    for (const char* piece : {"<script", "</script", "<style", "</style", "<svg", "</svg"}) {
        CAPTURE(piece);
        CHECK(count_of(piece, spoilt) == count_of(piece, plain));
    }
}

TEST_CASE("no environment variable and no locale changes a byte of an artifact, a report or of --json") {
    const Sandbox sandbox;
    Json document = test::example_case();
    document["laws"] = {"hertz", "jkr"};
    test::write_example(sandbox, document);
    const auto under = [&](const std::string& environment, const std::string& folder) {
        const std::string program = environment + " '" ASHIMPACT_PROGRAM "' ";
        const std::string both =
            program + "run case.json -o " + folder + " >/dev/null 2>&1 && " + program +
            "impact --law jkr --diameter 88um --density 2300kg/m3 --contact-modulus 90GPa"
            " --work-of-adhesion 0.3J/m2 --velocity 2m/s --json >" +
            folder + "/impact.json";
        REQUIRE(std::system(("cd '" + sandbox.folder().string() + "' && " + both).c_str()) == 0);
    };
    under("env -i", "bare");
    under(
        "env GSL_RNG_SEED=7 GSL_RNG_TYPE=taus GSL_IEEE_MODE=single-precision"
        " LC_ALL=de_DE.UTF-8 LC_NUMERIC=de_DE.UTF-8 LANG=tr_TR.UTF-8 TZ=Asia/Tokyo HOME=/nowhere "
        "TMPDIR=/nowhere"
        " OMP_NUM_THREADS=7 COLUMNS=20 SPDLOG_LEVEL=trace NO_COLOR=1 CLICOLOR_FORCE=1 SOURCE_DATE_EPOCH=1",
        "crowded");
    std::size_t compared = 0;
    for (const auto& file : sandbox.everything()) {
        const std::string& name = file.first;
        if (name.find("bare/") == std::string::npos) continue;
        std::string other = name;
        other.replace(other.find("bare/"), 5, "crowded/");
        CAPTURE(name);
        CHECK(file.second == sandbox.read(other));
        ++compared;
    }
    CHECK(compared > 10);
}
