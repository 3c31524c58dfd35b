// SPDX-License-Identifier: GPL-3.0-or-later
// What nobody's file and no surroundings may do: SECURITY.md.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::check_refused;
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
    Json document = test::with_one_sample(test::example_case(), {"hertz", "jkr"});
    document["name"] = name;
    document["samples"][0]["name"] = name;
    test::write_example(sandbox, document);
    test::succeeded(sandbox, "run case.json -o out");
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
    Json document = test::with_one_sample(test::example_case(), {"hertz", "jkr"});
    document["samples"][0]["density"] = {{"value", 2300}, {"unit", "kg/m3"}, {"standard_uncertainty", 30}};
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

TEST_CASE("a run does not write over the case or the data that it reads") {
    const Sandbox sandbox;
    test::write_example(sandbox, test::example_case());
    std::filesystem::rename(sandbox.path("case.json"), sandbox.path("0-case.json"));
    check_refused(sandbox, "run 0-case.json -o .",
                  "0-case.json: the run reads this file and would write 0-case.json over it; allowed: ");
    check_refused(sandbox, "run ./0-case.json -o '" + sandbox.folder().string() + "'", "another folder; -o");

    Json document = test::example_case();
    document["samples"][0]["restitution"]["file"] = "5-damping.json";
    std::filesystem::rename(sandbox.path("impacts.csv"), sandbox.path("5-damping.json"));
    sandbox.write("case.json", document.dump());
    check_refused(sandbox, "run case.json -o .", "5-damping.json: the run reads this file");
    std::filesystem::create_directory(sandbox.folder() / "out");
    std::filesystem::create_symlink("../case.json", sandbox.folder() / "out/comparison.json");
    check_refused(sandbox, "run case.json -o out", "case.json: the run reads this file");
}

TEST_CASE("a folder that cannot be written is refused before the first stage") {
    const Sandbox sandbox;
    sandbox.write("file", "x");
    check_refused(sandbox, "run none.json -o file", "file: cannot be written: it is no folder");
    check_refused(sandbox, "run -o file/below", "file: cannot be written: it is no folder");
    check_refused(sandbox, "run -o " + std::string(300, 'x'), "cannot be written: File name too long");
}

TEST_CASE("names with control characters do not reach the terminal raw") {
    const Sandbox sandbox;
    Json document = test::with_one_sample(test::example_case(), {"dmt"});
    document["samples"][0]["name"] = "fine\x1b[31m";
    document["samples"][0]["composition"]["xrd_sample"] = "fine";
    test::write_example(sandbox, document);
    const auto run = test::succeeded(sandbox, "run case.json -o out -v");
    const auto shown = ashimpact_program(sandbox, "inspect out/2-contact.json");
    CHECK(shown.out == containing("fine?[31m"));
    for (const std::string& text : {run.out, run.err, shown.out, shown.err})
        CHECK(text != containing("\x1b"));
}

TEST_CASE("help that cannot be written is an error") {
    const Sandbox sandbox;
    const auto help = ashimpact_program(sandbox, "--help >/dev/full 2>err; echo $? >status; true");
    CHECK(sandbox.read("status") == "2\n");
    CHECK(sandbox.read("err") == "standard output: cannot be written; allowed: a place with room\n");
}

TEST_CASE("a limit on the size of files is an error of the write and leaves nothing behind") {
    const Sandbox sandbox;
    const Sandbox outputs;
    const std::string command = "cd '" + sandbox.folder().string() +
                                "' && (ulimit -f 8; '" ASHIMPACT_PROGRAM "' run -o out) >/dev/null 2>'" +
                                outputs.path("err") + "'";
    const int result = std::system(command.c_str());
    CHECK(result == 2 << 8);  // its exit status, no signal
    CHECK(outputs.read("err") == containing("cannot be written: File too large"));
    for (const auto& file : sandbox.everything()) CHECK_MESSAGE(file.first == "out", file.first);
}

TEST_CASE("a small stack is enough, whatever its limit" * doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    test::write_example(sandbox, test::with_one_sample(test::example_case(), {"hertz", "jkr"}));
    for (const char* limit : {"64", "256"})
        for (const char* arguments : {"--version", "run case.json -o out",
                                      "impact --law jkr --radius 44e-6 --density 2600 --contact-modulus 9e10 "
                                      "--work-of-adhesion 0.3 --velocity 2"}) {
            CAPTURE(limit);
            CAPTURE(arguments);
            const std::string command = "cd '" + sandbox.folder().string() + "' && ulimit -s " + limit +
                                        " && '" + ASHIMPACT_PROGRAM "' " + arguments + " >/dev/null 2>&1";
            CHECK(std::system(command.c_str()) == 0);
        }
}

TEST_CASE("a table in the place of a case is refused with what to do with it") {
    const Sandbox sandbox;
    sandbox.write("ash.csv", "Phase;Gew.-%\nQuarz;20,5\nMullit;79,5\n");
    sandbox.write("impacts.csv", "v_in [m/s],v_r [m/s]\n2,0.5\n");
    sandbox.write("odd.csv", "v_in [mm/s],v_r [mm/s]\n\"2,000\",500\n");
    std::filesystem::copy_file(ASHIMPACT_TEST_DATA "/workbooks/kessel2.xlsx", sandbox.path("both.xlsx"));
    check_refused(sandbox, "run ash.csv",
                  "ash.csv: this is a table of XRD results, not a case; allowed: a case with "
                  "\"composition\": {\"xrd\": \"ash.csv\"} in a sample; `ashimpact init DIR` writes one");
    check_refused(sandbox, "run impacts.csv",
                  "of impacts, not a case; allowed: a case with \"restitution\": {\"file\"");
    check_refused(sandbox, "run odd.csv", "odd.csv: this is a table, not a case");
    check_refused(sandbox, "run both.xlsx", "both.xlsx: this is a table");
}

TEST_CASE("without ashimpact-sweep beside it the error names what is missing") {
    const Sandbox sandbox;
    std::filesystem::copy_file(ASHIMPACT_PROGRAM, sandbox.path("alone"));
    const Sandbox outputs;
    const std::string command = "cd '" + sandbox.folder().string() +
                                "' && ./alone sweep s.json -o o.json 2>'" + outputs.path("err") + "'";
    const int result = std::system(command.c_str());
    CHECK(result == 2 << 8);
    CHECK(outputs.read("err") == containing("/ashimpact-sweep: cannot be started: No such file"));
}

TEST_CASE("what init says can be typed as it stands, and so can the examples of help") {
    const Sandbox sandbox;
    const auto init = test::succeeded(sandbox, "init 'my case'");
    const std::string program = "/ashimpact ";
    const auto at = init.out.rfind(program);
    REQUIRE(at != std::string::npos);
    const Json quick = test::with_one_sample(sandbox.json("my case/case.json"), {"hertz"});
    sandbox.write("my case/case.json", quick.dump());
    CHECK(ashimpact_program(sandbox, init.out.substr(at + program.size())).status == 0);
    CHECK(sandbox.has("my case/results/comparison.json"));

    test::succeeded(sandbox, "init my-case");
    const auto modulus =
        ashimpact_program(sandbox, "modulus my-case/ash.csv --amorphous-fraction '42 +- 2 %'");
    CHECK_MESSAGE(modulus.status == 0, modulus.err);
    check_refused(sandbox, "modulus my-case/ash.csv --amorphous-fraction '42 +- 200 %'",
                  "--amorphous-fraction: a standard uncertainty of 2; allowed: a fraction of the whole");
}

TEST_CASE("an output replaces only a file of its kind, whatever the command" * doctest::test_suite("long")) {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    sandbox.write("mine.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
    sandbox.write("mine.html", "<p>mine</p>");
    sandbox.write("mine.csv", "v_in [m/s],e_n\n1,0.5\n");
    const std::string impact =
        "impact --law hertz --radius '44 um' --density 2600 --contact-modulus '90 GPa' --velocity 1 "
        "--trajectory ";
    for (const std::string& command :
         {std::string("report results -o results/0-case.json"), std::string("report results -o mine.html"),
          std::string("report results -o mine.csv"), std::string("figure restitution results -o mine.svg"),
          impact + "mine.csv", impact + "results/2-contact.json", impact + "results/report.html"}) {
        CAPTURE(command);
        check_refused(sandbox, command, "is there already, and is nothing that this command writes");
    }
    sandbox.write("empty.html", "");
    for (const std::string& command :
         {std::string("report results -o empty.html"), std::string("report results"),
          std::string("figure restitution results -o own.svg"), impact + "own.csv"})
        for (int time = 0; time < 2; ++time) test::succeeded(sandbox, command);
    sandbox.write("results/report.html", "<p>mine</p>");
    check_refused(sandbox, "run -o results --from comparison", "results/report.html: is there already");
}
