// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody types who has an ash, a camera and no knowledge of the program: a transcript.
#include <filesystem>
#include <regex>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/embedded.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/present/text/layout.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::check_refused;
using test::containing;
using test::Finished;
using test::Sandbox;

namespace {

/// As the laboratory's spreadsheet writes it: a title, semicolons, decimal commas, an error column.
constexpr auto german_ash =
    "Röntgenbeugung Flugasche Kessel 2; Labor Nord;\n"
    "Phase;Gew.-%;Fehler\n"
    "Quarz;3,1;0,4\n"
    "Mullit;95,2;0,8\n"
    "Hämatit;1,7;0,3\n";
constexpr auto tidy_ash =
    "phase,weight %,uncertainty\n"
    "quartz,3.1,0.4\n"
    "mullite,95.2,0.8\n"
    "hematite,1.7,0.3\n";
constexpr auto german_impacts =
    "Aufprallversuche Flugasche Kessel 2;\n"
    "v_ein [m/s];v_aus [m/s]\n"
    "1,40;haftet\n1,55;haftet\n1,72;0,12\n1,81;0,22\n1,95;0,33\n2,10;0,44\n2,31;0,57\n2,55;0,73\n"
    "2,70;\n2,90;0,93\n3,35;1,20\n3,90;1,51\n4,60;1,84\n";
constexpr auto tidy_impacts =
    "v_in [m/s],v_r [m/s],outcome\n"
    "1.40,,capture\n1.55,,capture\n1.72,0.12,rebound\n1.81,0.22,rebound\n1.95,0.33,rebound\n"
    "2.10,0.44,rebound\n2.31,0.57,rebound\n2.55,0.73,rebound\n2.70,,unknown\n2.90,0.93,rebound\n"
    "3.35,1.20,rebound\n3.90,1.51,rebound\n4.60,1.84,rebound\n";

/// The case of `init` with the files put in its place, and what is not known taken out, under one law.
Json own_case(const Json& example) {
    Json document = test::with_one_sample(example, {"dmt"});
    Json& sample = document["samples"][0];
    sample["composition"].erase("xrd_sample");
    sample.erase("density");
    sample.erase("measured_critical_velocity");
    return document;
}

Json reported(const Json& comparison) {
    return comparison.at("result").at("samples")[0].at("reported");
}

constexpr auto particle_and_wall =
    " --diameter '88 um' --density '2300 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2'";

/// Every line of both outputs fits, unless it is one long word, such as a path.
void check_fits(const Finished& finished) {
    REQUIRE_MESSAGE(finished.status == 0, finished.err);
    CHECK(finished.out.size() + finished.err.size() > 0);
    for (const std::string* text : {&finished.out, &finished.printed})
        for (const std::string& line : test::lines_of(*text)) {
            const bool one_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;
            if (!one_word) CHECK_MESSAGE(width_of(line) <= piped_width, line);
        }
}

std::string check_fits(const Sandbox& sandbox, const std::string& arguments) {
    CAPTURE(arguments);
    const Finished finished = ashimpact_program(sandbox, arguments);
    check_fits(finished);
    return finished.out;
}

/// Does so with `inspect` of every artifact in a folder.
void check_inspect_fits(const Sandbox& sandbox, const std::string& folder) {
    for (const char* artifact :
         {"0-case", "1-modulus", "2-contact", "3-analytic", "4-restitution", "5-damping", "6-fit",
          "7-critical-velocity", "8-histories", "comparison", "manifest"})
        for (const char* options : {"", " -v", " --all", " -v --all"}) {
            if (test::sanitized && *options) continue;
            const std::string arguments = fmt::format("inspect {}/{}.json{}", folder, artifact, options);
            CHECK_MESSAGE(
                check_fits(sandbox, arguments).starts_with(std::string(artifact) + " by ashimpact "),
                arguments);
        }
}

/// The commands that `ashimpact --help` lists.
std::vector<std::string> commands_of_help(const Sandbox& sandbox) {
    std::vector<std::string> commands;
    bool listed = false;
    for (const std::string& line : test::lines_of(ashimpact_program(sandbox, "--help").out)) {
        if (listed && line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
            commands.push_back(line.substr(2, line.find(' ', 2) - 2));
        if (line.empty()) listed = false;
        if (line == "Subcommands:") listed = true;
    }
    return commands;
}

}  // namespace

TEST_CASE("the first hour: files as a German laboratory has them end in the v_c of tidy files") {
    const Sandbox sandbox;
    auto typed = [&](const std::string& arguments) {
        auto finished = ashimpact_program(sandbox, arguments);
        CHECK_MESSAGE(finished.status == 0, arguments, "\n", finished.err);
        return finished;
    };
    sandbox.write("asche.csv", german_ash);
    sandbox.write("impacts.csv", german_impacts);

    // The amorphous part is no result of the diffraction: it is asked for, by the name of the option.
    check_refused(sandbox, "modulus asche.csv", "--amorphous-fraction");
    const auto modulus = typed("modulus asche.csv --amorphous-fraction '47 %'");
    for (const char* phase : {"Quarz", "Mullit", "Hämatit"}) CHECK(modulus.out == containing(phase));

    const auto made = typed("init mine");
    // A program with a long path has its commands broken at a backslash.
    const std::string unbroken = std::regex_replace(made.out, std::regex(R"( \\\n +)"), " ");
    CHECK(unbroken == containing("run mine/case.json -o mine/results"));
    for (const auto& [folder, ash, impacts] :
         {std::tuple{"mine", german_ash, german_impacts}, std::tuple{"tidy", tidy_ash, tidy_impacts}}) {
        if (std::string(folder) == "tidy") typed("init tidy");
        const std::string path = std::string(folder) + "/";
        sandbox.write(path + "ash.csv", ash);
        sandbox.write(path + "impacts.csv", impacts);
        sandbox.write(path + "case.json", own_case(sandbox.json(path + "case.json")).dump(1));
        const auto run = typed(fmt::format("run {0}case.json -o {0}results", path));
        CHECK(run.out == containing(" stick below "));
        CHECK(run.out == containing("not given: that of the phases without any pores"));
        CHECK(run.out == containing("work of adhesion 0.3 J/m2, assumed"));
    }
    const Json own = reported(sandbox.json("mine/results/comparison.json"));
    const Json tidy = reported(sandbox.json("tidy/results/comparison.json"));
    REQUIRE(own.at("critical_velocity").is_object());
    CHECK(own == tidy);
    const Json read = sandbox.json("mine/results/0-case.json");
    CHECK(read["warnings"].dump() == containing("1 impact of unknown outcome"));
}

// With sanitizers the readers of spreadsheets and this route are run by the cases around it.
TEST_CASE("the first hour: the same laboratory's spreadsheets end in the same v_c" *
          doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    test::succeeded(sandbox, "init mine");
    Json document = own_case(sandbox.json("mine/case.json"));
    sandbox.write("mine/ash.csv", tidy_ash);
    sandbox.write("mine/impacts.csv", tidy_impacts);
    sandbox.write("mine/case.json", document.dump(1));
    test::succeeded(sandbox, "run mine/case.json -o tidy --no-report");
    const Json tidy = reported(sandbox.json("tidy/comparison.json"));
    REQUIRE(tidy.at("critical_velocity").is_object());
    for (const char* file : {"kessel2.xlsx", "kessel2.ods"}) {
        CAPTURE(file);
        std::filesystem::copy_file(ASHIMPACT_TEST_DATA "/workbooks/" + std::string(file),
                                   sandbox.folder() / "mine" / file);
        document["samples"][0]["composition"]["xrd"] = file;
        document["samples"][0]["restitution"] = {{"file", file}};
        sandbox.write("mine/case.json", document.dump(1));
        const std::string folder = std::string("own-") + file;
        const auto run = test::succeeded(sandbox, "run mine/case.json --no-report -o " + folder);
        CHECK(reported(sandbox.json(folder + "/comparison.json")) == tidy);
        CHECK(run.out == containing("not given: that of the phases without any pores"));
        const std::string told = sandbox.json(folder + "/0-case.json")["warnings"].dump();
        CHECK(told == containing("1 impact of unknown outcome"));
    }
}

TEST_CASE("the command of docs/materials.md gives the moduli of the paper, as typed") {
    const Sandbox sandbox;
    const std::string samples = ASHIMPACT_TEST_DATA "/../../data/cases/dong2013/xrd.csv";
    const auto finished = test::succeeded(sandbox, "modulus " + samples + " --phase-set dong2013 --json");
    for (const char* modulus : {"14812", "15082", "16481"})
        CHECK(finished.out == containing("\"value\": " + std::string(modulus)));
}

TEST_CASE("the first hour: remarks and doubled uncertainties end in the v_c of tidy columns") {
    const Sandbox sandbox;
    const std::string command =
        "damping --law jkr --diameter '88 um' --density '2300 kg/m3' --contact-modulus '88 GPa' "
        "--work-of-adhesion '0.3 J/m2' --json --impacts ";
    sandbox.write(
        "remarks.csv",
        "Stoßversuche;;;;\nv_ein [m/s];Unsicherheit (2s);v_aus [m/s];Unsicherheit (2s);Bemerkung\n"
        "1,40;0,06;;0,06;haftet\n1,55;0,06;;0,06;Haftet!\n1,72;0,06;0,12;0,06;\n1,81;0,06;0,22;0,06;\n"
        "1,95;0,06;0,33;0,06;ok\n2,10;0,06;0,44;0,06;\n2,31;0,06;0,57;0,06;\n2,55;0,06;0,73;0,06;\n"
        "2,90;0,06;0,93;0,06;\n3,35;0,06;1,20;0,06;\n");
    sandbox.write(
        "tidy.csv",
        "v_in [m/s],u(v_in) [m/s],v_r [m/s],u(v_r) [m/s],outcome\n1.40,0.03,,0.03,capture\n"
        "1.55,0.03,,0.03,capture\n1.72,0.03,0.12,0.03,\n1.81,0.03,0.22,0.03,\n1.95,0.03,0.33,0.03,\n"
        "2.10,0.03,0.44,0.03,\n2.31,0.03,0.57,0.03,\n2.55,0.03,0.73,0.03,\n2.90,0.03,0.93,0.03,\n"
        "3.35,0.03,1.20,0.03,\n");
    const auto own = ashimpact_program(sandbox, command + "remarks.csv");
    const auto tidy = ashimpact_program(sandbox, command + "tidy.csv");
    REQUIRE_MESSAGE(own.status == 0, own.err);
    REQUIRE_MESSAGE(tidy.status == 0, tidy.err);
    CHECK(parse_json(own.out).at("critical_velocity").is_object());
    CHECK(parse_json(own.out).at("critical_velocity") == parse_json(tidy.out).at("critical_velocity"));
}

TEST_CASE("the first hour: what is still of init's example is told, and nothing else is") {
    const Sandbox sandbox;
    test::succeeded(sandbox, "init mine");
    const auto warnings = [&] {
        std::string all;
        for (const auto& each : load_case(sandbox.path("mine/case.json")).findings) all += each.finding.text;
        return all;
    };
    CHECK(warnings() != containing("of the example"));  // all of it is
    sandbox.write("mine/impacts.csv", tidy_impacts);
    std::string told = warnings();
    for (const char* part : {"ash.csv, /name, /wall", "/camera", "/samples/0/density",
                             "/samples/0/measured_critical_velocity", "/samples/1/restitution"})
        CHECK(told == containing(part));
    CHECK(told != containing("impacts.csv"));
    // Without the comments the camera is what remains of it.
    Json document = own_case(sandbox.json("mine/case.json"));
    document["wall"] = {{"young_modulus", "70 GPa"}, {"poisson_ratio", 0.3}};
    sandbox.write("mine/case.json", document.dump(1));
    told = warnings();
    CHECK(told == containing("/camera"));
    CHECK(told != containing("/wall"));
    CHECK(told == containing("/samples/0/composition/amorphous"));
    CHECK(told != containing("weight_fractions"));
    document["samples"][0]["composition"]["amorphous"] = "30 %";
    sandbox.write("mine/case.json", document.dump(1));
    told = warnings();
    CHECK(told != containing("/composition"));
    document.erase("camera");
    sandbox.write("mine/case.json", document.dump(1));
    CHECK(warnings() != containing("of the example"));
}

TEST_CASE("help COMMAND says what COMMAND --help says") {
    const Sandbox sandbox;
    for (const char* command : {"", "run", "damping", "init"}) {
        const std::string name = command;
        const auto help = ashimpact_program(sandbox, name.empty() ? "help" : "help " + name);
        CHECK(help.status == 0);
        CHECK(help.out.size() > 100);
        CHECK(help.out == ashimpact_program(sandbox, name.empty() ? "--help" : name + " --help").out);
    }
    check_refused(sandbox, "help impct", "did you mean \"impact\"?");
}

TEST_CASE("the first hour: all impacts captured give a bound") {
    const Sandbox sandbox;
    test::succeeded(sandbox, "init mine");
    sandbox.write("mine/impacts.csv", "v_ein [m/s];v_aus [m/s]\n1,40;haftet\n1,55;haftet\n1,72;haftet\n");
    sandbox.write("mine/case.json", own_case(sandbox.json("mine/case.json")).dump(1));
    const auto run = test::succeeded(sandbox, "run mine/case.json -o r");
    CHECK(run.out == containing("stick below 1."));
    CHECK(run.out == containing("No sample has both a dynamic"));
}

TEST_CASE(
    "the first hour: spreadsheets give what the same tables as CSV give, and name the cell that is wrong") {
    const Sandbox sandbox;
    const std::string folder = ASHIMPACT_TEST_DATA "/workbooks/";
    sandbox.write("impacts.csv",
                  "v_ein [m/s];v_aus "
                  "[m/s]\n0,4;haftet\n0,4;haftet\n0,9;haftet\n1,5;0,21\n2,1;0,62\n2,8;1,02\n3,3;1,33\n"
                  "4,1;1,81\n1,2;\n");
    const std::string contact =
        "damping --law jkr --diameter '80 um' --density '2300 kg/m3' --contact-modulus '85 GPa' "
        "--work-of-adhesion '0.3 J/m2' --json --impacts ";
    const auto text = test::succeeded(sandbox, contact + "impacts.csv");
    for (const char* file : {"openpyxl.xlsx", "opendocument.ods"}) {
        const auto sheet = ashimpact_program(sandbox, contact + folder + file);
        CHECK_MESSAGE(sheet.status == 0, sheet.err);
        Json ours = parse_json(sheet.out);
        Json theirs = parse_json(text.out);
        CHECK(ours.at("critical_velocity") == theirs.at("critical_velocity"));
        CHECK(sheet.err == containing("the sheet \"Stöße\" is read, not"));
        CHECK(ashimpact_program(sandbox, contact + folder + file + " --sheet 'Stöße'").out == sheet.out);
    }
    check_refused(sandbox, contact + folder + "shared-strings.xlsx", "sheet \"XRD\", row ");
    const auto none = ashimpact_program(sandbox, contact + folder + "openpyxl.xlsx --sheet Tabelle1");
    CHECK(none.err == containing("there is no sheet \"Tabelle1\""));

    // A case takes them by name, and a sheet where there are several.
    test::succeeded(sandbox, "init mine");
    Json document = own_case(sandbox.json("mine/case.json"));
    document["samples"][0]["composition"] = Json{{"xrd", folder + "openpyxl.xlsx"}, {"xrd_sheet", "Phasen"}};
    document["samples"][0]["restitution"]["file"] = folder + "opendocument.ods";
    document["samples"][0]["restitution"]["sheet"] = "Stöße";
    sandbox.write("mine/case.json", document.dump(1));
    const auto run = ashimpact_program(sandbox, "run mine/case.json -o r --no-report --allow-outside");
    CHECK_MESSAGE(run.status == 0, run.err);
    document["samples"][0]["restitution"]["sheet"] = "Phasen";
    sandbox.write("mine/case.json", document.dump(1));
    check_refused(sandbox, "run mine/case.json -o s --no-report --allow-outside", "sheet \"Phasen\"");
}

TEST_CASE("no help is wider than 80 columns") {
    const Sandbox sandbox;
    check_fits(sandbox, "--help");
    const auto commands = commands_of_help(sandbox);
    CHECK(commands.size() >= 16);
    for (const std::string& command : commands) check_fits(sandbox, command + " --help");
}

TEST_CASE("descriptions in help keep their column, also behind a name that fills it") {
    const Sandbox sandbox;
    const std::string help = ashimpact_program(sandbox, "impact --help").out;
    CHECK(help == test::containing("\n" + std::string(30, ' ') + "MJ/m3\", for sjkr\n"));
}

// What is printed does not depend on the build, and all commands together take minutes with sanitizers.
TEST_CASE("no output on the built-in case is wider than 80 columns" * doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    check_fits(test::put_built_in_run(sandbox));
    const std::string before = sandbox.read("results/7-critical-velocity.json");
    Json one = parse_json(embedded_file("cases/dong2013/case.json").value());
    while (one["samples"].size() > 1) one["samples"].erase(1);
    sandbox.write("one.json", one.dump());
    for (const char* command :
         {"run -v", "run --from fit", "calibrate one.json", "cross-check", "laws", "phases", "phases mullite",
          "schema", "figure restitution results -o r.svg", "report results -o b.html"})
        check_fits(sandbox, command);
    const Finished compared = ashimpact_program(sandbox, "calibrate --compare one.json");
    check_fits(compared);
    CHECK(compared.out == test::containing("Least AIC: "));
    check_inspect_fits(sandbox, "results");
    CHECK(sandbox.read("results/7-critical-velocity.json") == before);  // of both runs
    check_fits(sandbox, "report results -o a.html");
}

TEST_CASE("init, run and inspect, as the help says, in no line wider than 80 columns" *
          doctest::test_suite("long")) {
    const Sandbox sandbox;
    for (const std::string command : {"init mine", "run mine/case.json -o r"}) check_fits(sandbox, command);
    CHECK(ashimpact_program(sandbox, "init mine").status == 2);
    CHECK(sandbox.read("mine/case.json") == containing("\n  // A case of ashimpact. "));
    check_inspect_fits(sandbox, "r");
    CHECK(ashimpact_program(sandbox, "inspect r/2-contact.json").out == containing("2300 kg/m3"));
    CHECK(ashimpact_program(sandbox, "inspect mine/case.json").status == 2);
    check_fits(sandbox, "run -o r --only comparison");
    const std::string read = ashimpact_program(sandbox, "run -o r --only comparison").out;
    CHECK(read == containing("\nfine: 88 um, 2300 kg/m3, w 0.3 J/m2; "));
    CHECK(read == containing("mullite 50.5, glass-dong2013 47, quartz"));
    CHECK(read == containing("by weight, no uncertainties; 12 impacts, v_in 1.4"));
    CHECK(read == containing("2 captured, u(v_in) 0.0146 m/s"));
    sandbox.write("uncertain.json", R"({"name": "u", "work_of_adhesion": "0.3 +- 0.1 J/m2",
        "wall": {"young_modulus": "210 GPa", "poisson_ratio": 0.3}, "samples": [
        {"name": "FA 1", "diameter": "90 +- 6 um", "density": "2300 kg/m3", "composition":
         {"weight_fractions": {"mullite": "70 +- 4 %", "quartz": "30 +- 2 %"}, "amorphous": "60 +- 10 %"}}]})");
    const std::string uncertain = ashimpact_program(sandbox, "run uncertain.json -o u").out;
    CHECK(uncertain == containing("FA 1: 90.0 +- 6.0 um, 2300 kg/m3, w 0.30 +- 0.10 J/m2; glass"));
    CHECK(uncertain == containing("by weight, u 0.8 to 1.6 %, u 10 % of the amorphous\n"));
    CHECK(uncertain == containing("without damping and\nuncertainties."));
}

TEST_CASE("no output of the other commands is wider than 80 columns" * doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    check_fits(sandbox, "init mine");
    check_fits(sandbox, "modulus mine/ash.csv --amorphous-fraction '42 +- 2 %'");
    for (const char* law :
         {"hertz", "dmt", "brach-dunn", "jkr", "thornton-ning --yield-pressure '5 GPa'",
          "sjkr --cohesion-energy-density '1e6 J/m3'", "maugis-dugdale --cohesion-range '0.4 nm'",
          "jkr --partner-diameter '60 um' --partner-density '7800 kg/m3' --roughness '1 nm'"}) {
        const std::string pair = std::string(" --law ") + law + particle_and_wall;
        check_fits(sandbox, "impact --damping '0.005 kg/s' --velocity '2 m/s'" + pair);
        check_fits(sandbox, "critical-velocity --damping '0.005 kg/s'" + pair);
        check_fits(sandbox, "damping --velocity '2 m/s' --restitution 0.2" + pair);
        if (pair.find("maugis") == std::string::npos)  // which refuses fits, in one line
            check_fits(sandbox, "damping --impacts mine/impacts.csv" + pair);
    }
    check_fits(sandbox, std::string("contact") + particle_and_wall);
    for (const char* command : {"contact --soften 1000", "impact --law dmt --velocity '2 m/s'"})
        check_fits(sandbox,
                   std::string(command) + " --damping-restitution 0.3 --at '2 m/s'" + particle_and_wall);
    for (const char* code : {"openfoam", "lammps", "liggghts", "yade", "fluent"})
        check_fits(sandbox, std::string("export ") + code + " --law dmt --damping '0.005 kg/s'" +
                                particle_and_wall + " --velocity '2 m/s' -o " + code);
    sandbox.write("spec.json", R"({"impact": {"laws": ["dmt"], "density": "2600 kg/m3",
        "contact_modulus": "90 GPa", "work_of_adhesion": "0.3 J/m2", "damping": "0.0141 kg/s"},
        "variables": {"velocity": {"distribution": "uniform", "from": "0.5 m/s", "to": "5 m/s"},
                      "radius": {"distribution": "log-normal", "median": "44 um",
                                 "geometric_standard_deviation": 1.5}},
        "sampling": {"method": "quasi-random", "samples": 1024, "seed": 1}, "sensitivity": ["restitution"]})");
    check_fits(sandbox, "sweep spec.json -o sweep.json");
    for (const char* options : {"", " -v", " --all"})
        check_fits(sandbox, std::string("inspect sweep.json") + options);
    check_fits(
        sandbox,
        "export table --law dmt --damping '0.005 kg/s' --contact-modulus '90 GPa' "
        "--work-of-adhesion '0.3 J/m2' --density '2300 kg/m3' --diameter '88 um' --velocity '2 m/s' -o t");
    // Files of two codes do not mix in a folder.
    const std::string before = sandbox.read("t/expected.json");
    check_refused(sandbox,
                  std::string("export lammps --law dmt --damping '0.005 kg/s' --velocity '2 m/s' -o t") +
                      particle_and_wall,
                  "t/expected.json: is of an export for another code");
    CHECK(sandbox.read("t/expected.json") == before);
}
