// SPDX-License-Identifier: GPL-3.0-or-later
// What counts for nothing is said, what mixes two states or two runs is refused.
#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::check_refused;
using test::containing;
using test::Sandbox;

namespace {

constexpr auto elastic_sphere = " --radius '44 um' --density 2600 --contact-modulus '90 GPa'";
constexpr auto adhesive_sphere =
    " --radius '44 um' --density 2600 --contact-modulus '90 GPa' --work-of-adhesion 0.3";
constexpr auto export_run = "export lammps results --sample '88 um' --law dmt -o out";

/// Edits the result of an artifact of folder "results", by JSON pointer.
void edit_result(const Sandbox& sandbox, const std::string& file, const std::string& edits) {
    const std::string path = "results/" + file;
    sandbox.write(path, test::edited(sandbox.json(path), edits).dump());
}

constexpr auto slower =
    "/result/samples/0/dmt/critical_velocity/value = 1.5 ; - /result/samples/0/dmt/critical_velocity/interval"
    " ; - /result/samples/0/dmt/interval ; - /result/samples/0/dmt/check";

/// A case of one quick sample without the restitution data that its camera is for.
Json bare_case() {
    Json document = test::with_one_sample(test::example_case(), {"hertz"});
    document["samples"][0].erase("restitution");
    return document;
}

}  // namespace

TEST_CASE("an error of scale of all velocities is part of the uncertainties of damping constants") {
    const Sandbox sandbox;
    const std::vector<std::pair<double, double>> impacts{{1.31, 0.11}, {1.40, 0.21}, {2.55, 0.83},
                                                         {3.90, 1.51}, {4.60, 1.84}, {3.10, 1.13}};
    const auto constant_of = [&](double factor, const std::string& option) {
        std::string table = "v_in [m/s];v_r [m/s]\n";
        for (const auto& [velocity, rebound] : impacts)
            table += std::to_string(factor * velocity) + ";" + std::to_string(factor * rebound) + "\n";
        sandbox.write("impacts.csv", table);
        const Json json = parse_json(succeeded(sandbox,
                                               "damping --law dmt --diameter 88um --density 2300kg/m3 "
                                               "--contact-modulus 87.75GPa --work-of-adhesion 0.3J/m2 "
                                               "--json --impacts impacts.csv" +
                                                   option)
                                         .out);
        const Json& law = json.at("dampings").at("laws").at(0);
        CHECK(law.at("damping_law") == "constant");
        return std::pair{law.at("constants").at("damping").at("value").get<double>(),
                         law.at("constants").at("damping").at("standard_uncertainty").get<double>()};
    };
    const auto [value, alone] = constant_of(1, "");
    const auto [same, whole] = constant_of(1, " --velocity-scale-uncertainty 0.05");
    CHECK(same == value);
    const double moved = constant_of(1.05, "").first - value;
    CHECK(relative_difference(std::sqrt(whole * whole - alone * alone), std::abs(moved)) < 1e-4);
}

TEST_CASE("export, report and figure refuse artifacts computed from another state than the edited one" *
          doctest::test_suite("long")) {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    edit_result(sandbox, "2-contact.json", "/result/samples/0/work_of_adhesion/value = 0.5");
    const std::string says =
        "was computed from another 2-contact.json than the one beside it; allowed: --from analytic of "
        "`ashimpact run -o results`";
    check_refused(sandbox, export_run, says);
    check_refused(sandbox, "report results -o r.html", "results/3-analytic.json: " + says);
    check_refused(sandbox, "figure critical-velocity results -o f.svg", "results/3-analytic.json: " + says);
    test::succeeded(sandbox, "figure composition results -o f.svg");  // rests on the modulus alone
    test::succeeded(sandbox, "run --from analytic");
    test::succeeded(sandbox, "report results -o r.html");
    test::succeeded(sandbox, export_run);
    CHECK(sandbox.read("out/assumptions.md") == containing("w = 0.5000 +- 0.0053 J/m2"));
}

TEST_CASE(
    "one damping of a run, at a velocity: refused beside --follow-velocity, beyond the impacts said so") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    const std::string at = std::string(export_run) + " --at ";
    check_refused(sandbox, at + "'2 m/s' --follow-velocity",
                  "--follow-velocity, --at: one damping and one that");
    for (const auto& [velocity, says] : {std::pair{"'3 m/s'", "e is the measured one there. v_c is "},
                                         {"'90 m/s'", "no impact was faster than"},
                                         {"'0.01 m/s'", "no impact was slower than"}}) {
        CAPTURE(velocity);
        const std::string warning = test::succeeded(sandbox, at + velocity).err;
        const std::string assumptions = sandbox.read("out/assumptions.md");
        for (const std::string& text : {warning, assumptions}) {
            CHECK(text == containing(says));
            CHECK(text == containing(", that of the run "));
        }
        CHECK(assumptions != containing("above it"));  // the damping of a folder that follows
    }
    CHECK(sandbox.read("out/assumptions.md") != containing("e is the measured one"));
}

TEST_CASE("export computes from an edited critical velocity; a report waits for what follows from it" *
          doctest::test_suite("long")) {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    test::succeeded(sandbox, export_run);
    const std::string before = sandbox.read("out/expected.json");
    edit_result(sandbox, "7-critical-velocity.json", slower);
    test::succeeded(sandbox, export_run);
    CHECK(sandbox.read("out/expected.json") != before);
    CHECK(sandbox.read("out/expected.json") == containing("1.485"));
    for (const char* file : {"out/README.md", "out/assumptions.md"})
        CHECK(sandbox.read(file) ==
              containing("7-critical-velocity.json was edited after ashimpact wrote it"));
    check_refused(sandbox, "report results",
                  "results/8-histories.json: was computed from another 7-critical-velocity.json than the one "
                  "beside it; allowed: --from histories of");
    check_refused(sandbox, "run --from comparison",
                  "results/8-histories.json: was computed from another 7-critical-velocity.json");
    test::succeeded(sandbox, "run --from histories");
    CHECK(sandbox.has("results/report.html"));

    edit_result(sandbox, "7-critical-velocity.json", "/result/samples/0/dmt/dissipated/value = 1e-7");
    check_refused(sandbox, export_run, "/dissipated/value: was edited, and only part of what comes after");
}

TEST_CASE("a run does not compute an edited artifact anew: the edit would be lost" *
          doctest::test_suite("long")) {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    const auto before = sandbox.everything();
    edit_result(sandbox, "2-contact.json", "/result/samples/0/work_of_adhesion/value = 0.5");
    const std::string edited = sandbox.read("results/2-contact.json");
    const std::string lost =
        "results/2-contact.json: was edited, and contact computes it anew: the edit would "
        "be lost; allowed: --from analytic, which takes the edit; or the file removed";
    check_refused(sandbox, "run --from contact", lost);
    check_refused(sandbox, "run --only contact", lost);
    CHECK(sandbox.read("results/2-contact.json") == edited);
    std::filesystem::remove(sandbox.path("results/2-contact.json"));
    test::succeeded(sandbox, "run --from contact");
    for (const auto& [file, bytes] : before)
        if (file.ends_with(".json") && file != "results/manifest.json") CHECK(sandbox.read(file) == bytes);
    edit_result(sandbox, "7-critical-velocity.json", slower);
    CHECK(test::succeeded(sandbox, "run --from analytic").err ==
          containing("results/7-critical-velocity.json: was edited, and is computed anew"));
}

TEST_CASE("an interval has one level throughout a run") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    edit_result(sandbox, "7-critical-velocity.json", "/result/samples/0/dmt/interval/level = 0.9");
    check_refused(sandbox, "run --from histories", "/interval/level: is 0.9; allowed: 0.95");
}

TEST_CASE("an edited comparison is refused by a report, which shows its numbers from other artifacts too" *
          doctest::test_suite("long")) {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    const std::string computed = sandbox.read("results/comparison.json");
    const std::string deposit =
        "deposit results --tube-diameter '38 mm' --gas-velocity 12 --gas-temperature '900 C' --sizes '88 um' "
        "-o tube";
    for (const auto& [command, edit] :
         {std::pair{std::string("report results"), "/samples/0/analytic_critical_velocity/value = 9"},
          {"report results", "/reported/samples/0/critical_velocity/value = 1.52"},
          {"report results", "/reported/law = \"hertz\""},
          {"figure which-sizes results -o f.svg", "/by_size/0/diameter/value = 5e-5"},
          {deposit, "/by_size/0/critical_velocity = null"},
          {"export openfoam results -o out", "/by_size/0/critical_velocity = null"}}) {
        const std::string place = std::string("/result") + edit;
        edit_result(sandbox, "comparison.json", place);
        check_refused(sandbox, command,
                      "results/comparison.json: " + place.substr(0, place.find(" =")) + ": was edited");
        sandbox.write("results/comparison.json", computed);
    }
}

TEST_CASE("a run from its own 0-case.json in the current folder is up to date") {
    const Sandbox sandbox;
    test::write_example(sandbox, test::with_one_sample(test::example_case(), {"hertz"}));
    test::succeeded(sandbox, "run case.json -o out");
    std::filesystem::copy(sandbox.path("out/0-case.json"), sandbox.path("0-case.json"));
    Json whole = sandbox.json("0-case.json")["result"];
    sandbox.write("0-case.json", whole.dump());
    test::succeeded(sandbox, "run 0-case.json -o again");
    test::succeeded(sandbox, "run -o again --from comparison");
    test::succeeded(sandbox, "report again");
}

TEST_CASE("a file that has changed since a run is named where the run is used") {
    const Sandbox sandbox;
    test::write_example(sandbox, test::with_one_sample(test::example_case(), {"hertz"}));
    test::succeeded(sandbox, "run case.json -o out");
    const std::string case_text = sandbox.read("case.json");
    for (const char* command : {"run -o out --from comparison", "report out"}) {
        CAPTURE(command);
        sandbox.write("case.json", case_text + "\n");
        CHECK(test::succeeded(sandbox, command).err ==
              containing("case.json: has changed since it was read for out/0-case.json"));
        sandbox.write("case.json", case_text);
        CHECK(test::succeeded(sandbox, command).err != containing("has changed"));
    }
}

TEST_CASE("a figure takes artifacts of one run, and those that it shows") {
    const Sandbox sandbox;
    test::put_built_in_run(sandbox);
    std::filesystem::copy(sandbox.folder() / "results", sandbox.folder() / "other");
    test::succeeded(
        sandbox,
        "figure histories results/8-histories.json other/2-contact.json -o f.svg");  // the same run
    std::filesystem::remove(sandbox.path("f.svg"));
    Json histories = sandbox.json("other/8-histories.json");
    histories["provenance"]["run"] = std::string(64, 'a');
    sandbox.write("other/8-histories.json", histories.dump());
    check_refused(sandbox, "figure histories other/8-histories.json results/2-contact.json -o f.svg",
                  "is of another run than 0-case.json beside it");
    check_refused(sandbox, "figure histories other/8-histories.json results -o f.svg",
                  "other/8-histories.json: is of another run");
    check_refused(sandbox, "figure damping results other -o f.svg",
                  "other: is given beside the folder results; allowed: one run; report shows several");
    check_refused(sandbox, "figure damping results/5-damping.json other/5-damping.json -o f.svg",
                  "other/5-damping.json: another 5-damping.json is given too");
    check_refused(sandbox, "figure composition results/1-modulus.json results/8-histories.json -o f.svg",
                  "results/8-histories.json: figure composition shows nothing of it; allowed: 0-case.json, "
                  "1-modulus.json, or the folder of a run");
}

TEST_CASE("a warning with the same text for several samples of a table is printed once") {
    const Sandbox sandbox;
    sandbox.write("two.csv", "Sample;Quartz [wt%];Glass [wt%]\nA;20;80\nB;30;70\n");
    const std::string said = test::succeeded(sandbox, "modulus two.csv").err;
    const auto first = said.find("\"Glass\" is taken as");
    REQUIRE(first != std::string::npos);
    CHECK(said.find("\"Glass\" is taken as", first + 1) == std::string::npos);
}

TEST_CASE("an option that changes nothing is said or refused") {
    const Sandbox sandbox;
    for (const std::string option : {"--order 3", "--robust", "--bin 3", "--frames 3", "--size-scatter 0.1",
                                     "--velocity-scale-uncertainty 0.03"})
        check_refused(sandbox,
                      "damping --law hertz --velocity 2 --restitution 0.5 " + option + elastic_sphere,
                      option.substr(0, option.find(' ')) + " requires --");
    sandbox.write("sizes.csv", "d [um];v_c [m/s];u(v_c) [m/s]\n5;1.2;.2\n10;.7;.14\n");
    constexpr auto of_sizes =
        "calibrate --law jkr --density 2600 --contact-modulus '90 GPa' --free work_of_adhesion ";
    for (const auto& [command, says] :
         {std::pair{std::string("export table --law dmt --damping 1e-3 --damping-exponent 2 -o out") +
                        adhesive_sphere,
                    "warning: --damping-exponent: there is one size, so it changes nothing"},
          {std::string("export table --law dmt --to-diameter '100 um' --damping-exponent 2 -o out") +
               adhesive_sphere,
           "warning: --damping-exponent: there is no damping, so it changes nothing"},
          {std::string("impact --law dmt --velocity 2 --damping-law tsuji") + adhesive_sphere,
           "warning: --damping-law: there is no damping, so it changes nothing"},
          {std::string("impact --law dmt --velocity 2 --damping-law tsuji --damping 0") + adhesive_sphere,
           "warning: --damping-law: there is no damping, so it changes nothing"},
          {std::string("critical-velocity --law hertz --angle '60 deg'") + elastic_sphere,
           "warning: --angle: there is no critical velocity, so it changes nothing"},
          {std::string(of_sizes) + "--sizes sizes.csv --uncertainty '50 %'",
           "warning: --uncertainty: the table states that of each velocity, so it changes nothing"},
          {std::string(of_sizes) + "--sizes sizes.csv --allow-outside",
           "warning: --allow-outside: there is no case, so it changes nothing"},
          {std::string(of_sizes) + "--sizes arffman2015 --uncertainty '10 %' --decimal point",
           "warning: --decimal: no table is read, so it changes nothing"},
          {std::string("impact --law hertz --velocity 2 --damping-law brach-dunn-damping --damping 0.2 "
                       "--adhesion-damping 0.5") +
               adhesive_sphere,
           "warning: --adhesion-damping: hertz has no attraction, so it changes nothing"},
          {std::string("impact --law dmt --velocity 2 --damping-law brach-dunn-damping "
                       "--adhesion-damping-ratio 2") +
               adhesive_sphere,
           "warning: --adhesion-damping-ratio: there is no damping, so it changes nothing"},
          {std::string("impact --law hertz --velocity 2 --tabor 2 --roughness '1 nm'") + adhesive_sphere,
           "warning: --roughness: hertz does not use it, so it changes nothing"}}) {
        CAPTURE(command);
        CHECK(test::succeeded(sandbox, command).err == containing(says));
    }
}

TEST_CASE("options of measured impacts that others replace, or that there is nothing for, are named") {
    const Sandbox sandbox;
    sandbox.write("impacts.csv",
                  "v_in [m/s],u(v_in) [m/s],v_r [m/s],u(v_r) [m/s]\n1.9,0.02,0.25,0.02\n"
                  "2.4,0.02,0.7,0.02\n");
    for (const auto& [options, says] :
         {std::pair{"--frame-rate 80000 --pixel-size '2 um'",
                    "takes the place of the uncertainties stated with the impacts"},
          std::pair{"--size-scatter 0.1",
                    "--size-scatter: there is no estimate, which it is for, so it changes"},
          std::pair{"--velocity-scale-uncertainty 0.1",
                    "--velocity-scale-uncertainty: there is no estimate"}}) {
        const std::string command = std::string("damping --law dmt --impacts impacts.csv ") + options;
        CAPTURE(command);
        CHECK(test::succeeded(sandbox, command + adhesive_sphere).err == containing(says));
    }
    check_refused(
        sandbox,
        std::string("export lammps --law dmt --damping 4e-3 --follow-velocity -o out") + adhesive_sphere,
        "--follow-velocity: there is no run whose damping follows the velocity");
}

TEST_CASE("run names what changes nothing in a case, calibrate too") {
    const Sandbox sandbox;
    Json document = bare_case();
    document["particle"] = {{"contact_modulus", "90 GPa"}, {"tabor", 2}};
    test::write_example(sandbox, document);
    const auto run = test::succeeded(sandbox, "run case.json -o out");
    for (const char* says :
         {"1 x 0-case.json: /wall changes nothing, as every sample states its contact_modulus",
          "1 x 0-case.json: /camera changes nothing, as no sample has measured impacts",
          "1 x 0-case.json: /particle/tabor changes no impact, as hertz does not use it",
          "1 x 0-case.json: /work_of_adhesion changes no impact, as hertz does not use it"})
        CHECK(run.err == containing(says));
    CHECK(sandbox.read("out/report.html") ==
          containing("No sample has impacts, so there is nothing to show."));
    document["samples"][0]["published"] = {{"critical_velocity", {{"hertz", 1}}},
                                           {"critical_damping", {{"hertz", 0.01}}}};
    sandbox.write("case.json", document.dump());
    CHECK(ashimpact_program(sandbox, "calibrate case.json --free density").err ==
          containing("warning: /camera changes nothing, as no sample has measured impacts"));
    document["samples"][0]["diameter"] = "88 +- 3 um";
    sandbox.write("case.json", document.dump());
    CHECK(ashimpact_program(sandbox, "calibrate case.json --free density").err ==
          containing("leave out the standard uncertainties of what is held fixed: diameter (up to 3.4 %)"));
}

TEST_CASE(
    "where the damping is held v_c depends on the contact, whose pores are drawn once for mass and modulus") {
    const Sandbox sandbox;
    Json document = test::with_one_sample(test::example_case(), {"hertz"});
    document["uncertainty"] = {{"damping", "held"}, {"samples", 512}};
    document["wall"] = {{"rigid", true}};
    document["phases"] = Json::parse(
        R"([{"name": "own glass", "amorphous": true, "density": "2600 kg/m3", "poisson_ratio": 0.25,
             "young_modulus": {"value": 80, "unit": "GPa", "standard_uncertainty": 0}}])");
    Json& sample = document["samples"][0];
    sample["composition"] = {{"weight_fractions", {{"own glass", 1}}}};
    sample["porosity"] = Json::parse(R"({"law": "gibson-ashby", "value": "20 +- 5 %"})");
    sample.erase("density");
    test::write_example(sandbox, document);
    const auto run = test::succeeded(sandbox, "run case.json -o out --no-report");
    CHECK(run.out != containing("The impacts give v_c"));
    CHECK(run.out == containing("Taken as exact in the intervals, no uncertainty being stated: diameter"));
    CHECK(run.out == containing("of samples"));
    // Hertz: v_c ~ (m^3 E*^2)^-1 ~ (1 - P)^-7.
    const Json velocity = sandbox.json("out/7-critical-velocity.json")["result"]["samples"][0]["hertz"];
    const auto ratio_at = [&](const char* end) {
        return velocity["interval"][end]["value"].get<double>() /
               velocity["critical_velocity"]["value"].get<double>();
    };
    const double z = 1.96 * 0.05;
    CHECK(ratio_at("lower") == doctest::Approx(std::pow((0.8 + z) / 0.8, -7)).epsilon(0.03));
    CHECK(ratio_at("upper") == doctest::Approx(std::pow((0.8 - z) / 0.8, -7)).epsilon(0.03));

    check_refused(sandbox, "run case.json -o out --temperature '900 +- 50 C'",
                  "--temperature: \"900 +- 50 C\" states an uncertainty, which nothing here uses");
    document["camera"]["frame_rate"] = "80.000";
    sandbox.write("case.json", document.dump());
    check_refused(sandbox, "run case.json -o out",
                  "/camera/frame_rate: \"80.000\" is 80.000 or 80000; allowed: 80000, or 80.0000");
    document["camera"]["frame_rate"] = 80;
    sandbox.write("case.json", document.dump());
    check_refused(sandbox, "run case.json -o out",
                  "/camera/frame_rate: 80 has no unit and is 80 frames per second, did you mean 80 kHz?");
    document["camera"]["frame_rate"] = 80000;
    document["samples"][0]["diameter"] = {{"value", 88}, {"unit", "um"}, {"standard_uncertainty", 2e-6}};
    sandbox.write("case.json", document.dump());
    check_refused(sandbox, "run case.json -o out", "is 2e-06 um, or 2e-06 m; allowed: a number in the unit");
    check_refused(sandbox,
                  "contact --diameter '88 um' --density '2300 kg/m3' --contact-modulus '90.000 MPa' "
                  "--work-of-adhesion '0.3 J/m2'",
                  "--contact-modulus: \"90.000\" is 90.000 or 90000; allowed: 90000, or 90.0000");
}

TEST_CASE("a contact at rest that is wide is warned of") {
    const Sandbox sandbox;
    const std::string soft =
        "contact --diameter '5 um' --density '2300 kg/m3' --work-of-adhesion '0.3 J/m2' --contact-modulus ";
    for (const char* at : {"'20 MPa'", "'20 MPa' --force '0.1 uN'"})
        CHECK(test::succeeded(sandbox, soft + at).err == containing("warning: contact radius is 0.4"));
    CHECK(test::succeeded(sandbox, soft + "'20 MPa' --contact-radius '2 um'").err ==
          containing("warning: contact radius is 0.8 of the radius"));
    CHECK(test::succeeded(sandbox, soft + "'20 GPa'").err.empty());
}

TEST_CASE("every command that solves impacts says where the law does not hold") {
    const Sandbox sandbox;
    const std::string contact =
        " --law dmt --density '2300 kg/m3' --contact-modulus '60 GPa' --work-of-adhesion '0.5 J/m2'";
    const std::string sphere = contact + " --diameter '88 um'";
    const std::string damping = " --damping '0.005 kg/s'";
    sandbox.write("impacts.csv", "v_in [m/s],v_r [m/s]\n1,0.55\n2,1.2\n3,1.9\n4,2.6\n");
    for (const std::string& command :
         {"impact --velocity '2 m/s'" + sphere + damping, "critical-velocity" + sphere + damping,
          "damping --velocity '2 m/s' --restitution 0.6" + sphere, "damping --impacts impacts.csv" + sphere,
          "export table -o table" + sphere + damping,
          "deposit --tube-diameter '38 mm' --gas-velocity '2 m/s' --gas-temperature '900 C' -o tube "
          "--sizes '88 um'" +
              contact + damping}) {
        CAPTURE(command);
        const std::string said = test::succeeded(sandbox, command).err;
        CHECK(said == containing("Tabor parameter 3.6"));
        CHECK(said.find("Tabor parameter") == said.rfind("Tabor parameter"));
    }
    sandbox.write("spec.json", R"({"impact": {"laws": ["dmt", "maugis-dugdale"], "radius": "44 um",
        "density": "2300 kg/m3", "contact_modulus": "60 GPa", "damping": "0.005 kg/s", "cohesion_range": "0.4 nm",
        "velocity": "2 m/s"}, "variables": {"work_of_adhesion": {"values": ["1 uJ/m2", "0.5 J/m2"]}},
        "sampling": {"method": "grid"}})");
    const std::string said = test::succeeded(sandbox, "sweep spec.json -o sweep.json").err;
    CHECK(said == containing("dmt: 50 % of the impacts are outside of where the law holds"));
    CHECK(said != containing("maugis-dugdale:"));
}

TEST_CASE("a Tabor parameter beside a roughness has two readings") {
    const Sandbox sandbox;
    check_refused(sandbox,
                  std::string("impact --law maugis-dugdale --velocity 2 --tabor 2 --roughness '1 nm'") +
                      adhesive_sphere,
                  "--tabor: may be that of the smooth surfaces or of the rough ones");
    Json document = test::with_one_sample(test::example_case(), {"maugis-dugdale"});
    document.erase("particle");
    document["samples"][0]["tabor"] = 2;
    document["roughness"] = "1 nm";
    test::write_example(sandbox, document);
    check_refused(sandbox, "run case.json", "/roughness: a sample states its tabor");
}

TEST_CASE("a report is refused under the name of another format") {
    const Sandbox sandbox;
    check_refused(sandbox, "report results -o report.pdf", "-o: a report is an HTML file, not \".pdf\"");
}

TEST_CASE("energy that rounding leaves is not shown as dissipated") {
    const Sandbox sandbox;
    const auto run =
        test::succeeded(sandbox, std::string("impact --law jkr --velocity 0.01") + adhesive_sphere);
    CHECK(run.out == containing("capture"));
    CHECK(run.out != containing("dissipated"));
    CHECK(run.out == containing("left in the contact  -20.35 fJ"));
}

TEST_CASE("one quantity in the spellings of its field is one result") {
    const Sandbox sandbox;
    sandbox.write("impacts.csv", "v_in [m/s],v_r [m/s]\n1.9,0.25\n2.4,0.7\n");
    sandbox.write("ash.csv", "phase,wt%\nquartz,40\nmullite,60\n");
    const std::string oblique =
        std::string("impact --law hertz --velocity 2 --angle '30 deg' --friction 0.2") + elastic_sphere;
    const std::string camera =
        std::string("damping --law dmt --impacts impacts.csv --pixel-size '2 um'") + adhesive_sphere;
    const std::string contact =
        "contact --density 2600 --contact-modulus '90 GPa' --work-of-adhesion 0.3 --diameter ";
    const std::string ash = "modulus ash.csv --amorphous-fraction ";
    for (const auto& [first, second] :
         {std::pair{oblique + " --spin '10 rev/s'", oblique + " --spin '600 rpm'"},
          {camera + " --frame-rate '80 kHz'", camera + " --frame-rate 80000"},
          {contact + "'0.001\"'", contact + "'0.001 in'"},
          {ash + "'60 wt%'", ash + "'60 %'"},
          {ash + "'60 % by weight'", ash + "'60 %'"}}) {
        CAPTURE(first);
        CHECK(test::succeeded(sandbox, first).out == test::succeeded(sandbox, second).out);
    }
    check_refused(sandbox, ash + "'60 vol%'",
                  "--amorphous-fraction: \"60 vol%\" is by volume, and the phases are by weight");
    check_refused(sandbox, camera + " --frame-rate '80000 rpm'", "--frame-rate: is \"80000 rpm\"");
    check_refused(sandbox,
                  std::string("impact --law hertz --velocity 2 --radius '44 um' --density 2600 ") +
                      "--contact-modulus '90 Gpa'",
                  "the unit \"Gpa\" is not known, did you mean \"GPa\"?");
}

TEST_CASE("a slip of a unit is warned of with the unit that was meant; no friction is no sticking") {
    const Sandbox sandbox;
    const auto soft = test::succeeded(
        sandbox,
        "contact --diameter '88 um' --density 2600 --young-modulus '148 GPa' --poisson-ratio 0.2 "
        "--wall-young-modulus '193 Pa' --wall-poisson-ratio 0.29 --work-of-adhesion 0.3");
    CHECK(soft.err == containing("is the unit right? Did you mean 193 GPa?"));
    const auto impact = test::succeeded(
        sandbox,
        std::string("impact --law hertz --velocity 2 --angle '30 deg' --friction 0") + elastic_sphere);
    CHECK(impact.out == containing("mu = 0: slides freely"));
}

TEST_CASE("what a title states is said once, as it is used") {
    const Sandbox sandbox;
    for (const char* table : {"Fractions of the crystalline part\nphase,wt%\nquartz,40\nmullite,60\n",
                              "phase,wt%\nquartz,40\nmullite,60\n\n* fractions of the crystalline part\n"}) {
        sandbox.write("ash.csv", table);
        const auto modulus = test::succeeded(sandbox, "-v modulus ash.csv --amorphous-fraction '40 %'");
        CHECK(modulus.err == containing("the fractions are those of the crystalline part, as line"));
        CHECK(modulus.err != containing("is not read"));
    }
    sandbox.write("plain.csv", "# v_in e_n\n1.4e+00 1e-1\n1.5e+00 2e-1\n");
    check_refused(sandbox, std::string("damping --law dmt --impacts plain.csv") + adhesive_sphere,
                  "plain.csv: line 2: the numbers are apart by blanks; allowed: tabs, semicolons or commas");
    check_refused(sandbox,
                  "calibrate --sizes wall1990 --law jkr --density 2600 --contact-modulus '90 GPa' --free "
                  "work_of_adhesion",
                  "\"wall1990\" has no measured v_c of one stated diameter");
}

TEST_CASE("a range in the place of one value is named as one") {
    const Sandbox sandbox;
    for (const auto& [command, says] :
         {std::tuple{std::string("impact --law hertz --diameter '80-100 um' --velocity 2 --density 2600 "
                                 "--contact-modulus 9e10"),
                     "--diameter: \"80-100 um\" is a range; allowed: one value: a length [m], e.g. 44 um, "
                     "4.4e-5 m; ranges are for `ashimpact sweep` and, as meshes of two sieves, for the "
                     "\"diameter\" of a sample in a case"},
          {std::string("impact --law hertz --velocity '2 to 3 m/s'") + elastic_sphere,
           "--velocity: \"2 to 3 m/s\" is a range; allowed: one value: a velocity [m/s], e.g. 2 m/s, 150 "
           "cm/s; "
           "ranges are for `ashimpact sweep`"}})
        check_refused(sandbox, command, says);
    check_refused(sandbox, std::string("impact --law hertz --velocity '2 m/s..3 m/s'") + elastic_sphere,
                  "is a range");
}

TEST_CASE("how each table was read is shown, kept in the artifact, and not said before an error") {
    const Sandbox sandbox;
    sandbox.write("ash.csv", "Phase;wt%\nQuartz;20\nGlass;80\n");
    const std::string reading =
        "ash.csv: read as 1 sample; phases: \"Phase\"; amounts by weight, in %: \"wt%\"";
    CHECK(succeeded(sandbox, "modulus ash.csv").err == containing(reading));
    CHECK(succeeded(sandbox, "-q modulus ash.csv").err.empty());
    sandbox.write("half.csv", "Phase;wt%\nQuartz;20\nUnobtainium;80\n");
    check_refused(sandbox, "modulus half.csv", "half.csv: line 3: no phase is called");
    sandbox.write("sizes.csv", "d [um],v_c [m/s],u(v_c) [m/s]\n20,3,0.3\n60,1,0.1\n");
    CHECK(succeeded(sandbox,
                    "calibrate --sizes sizes.csv --law jkr --density 2600 --contact-modulus '90 GPa' "
                    "--work-of-adhesion 0.3 --free damping")
              .err == containing("sizes.csv: read as 2 sizes; diameters [um]: \"d [um]\"; v_c [m/s]"));
    succeeded(sandbox, "init case");
    const auto run = succeeded(sandbox, "run case/case.json -o out --no-report");
    CHECK(run.err == containing("case/impacts.csv: read as 12 impacts, 2 captured"));
    CHECK(run.err == containing("case/ash.csv: read as 1 sample"));
    std::string small = sandbox.read("case/case.json");
    const std::string uncertain = "\"standard_uncertainty\": 30";
    small.replace(small.find(uncertain), uncertain.size(), "\"standard_uncertainty\": 0.05");
    sandbox.write("case/case.json", small);
    CHECK(succeeded(sandbox, "run case/case.json -o small --no-report").out ==
          containing("2300 kg/m3 (u 0.05 kg/m3)"));
    const Json inputs = sandbox.json("out/0-case.json").at("provenance").at("inputs");
    CHECK_FALSE(inputs.at(0).contains("read_as"));
    CHECK(inputs.at(1).at("read_as").size() == 1);
    CHECK(succeeded(sandbox, "inspect out/0-case.json -v").out == containing("read as 12 impacts"));
}
