// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "core/embedded.hpp"
#include "pipeline/present/text/layout.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::ashimpact_program;
using test::Finished;
using test::Sandbox;

namespace {

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

void check_fits(const Sandbox& sandbox, const std::string& arguments) {
    CAPTURE(arguments);
    check_fits(ashimpact_program(sandbox, arguments));
}

/// Does so with `inspect` of every artifact in a folder.
void check_inspect_fits(const Sandbox& sandbox, const std::string& folder) {
    for (const char* artifact :
         {"0-case", "1-modulus", "2-contact", "3-analytic", "4-restitution", "5-damping", "6-fit",
          "7-critical-velocity", "8-histories", "comparison", "manifest"})
        for (const char* options : {"", " -v", " --all", " -v --all"})
            check_fits(sandbox, "inspect " + folder + "/" + artifact + ".json" + options);
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
    for (const char* command :
         {"run -v", "run --from fit", "calibrate", "cross-check", "phases", "phases mullite", "schema",
          "figure restitution results -o r.svg", "report results -o b.html"})
        check_fits(sandbox, command);
    Json two_sizes = parse_json(embedded_file("cases/dong2013/case.json").value());
    two_sizes["samples"].erase(2);
    sandbox.write("two.json", two_sizes.dump());
    const Finished compared = ashimpact_program(sandbox, "calibrate --compare two.json");
    check_fits(compared);
    CHECK(compared.out == test::containing("Least AIC: "));
    check_inspect_fits(sandbox, "results");
    check_fits(sandbox, "report results -o a.html");
}

TEST_CASE("no output on the case of init is wider than 80 columns" * doctest::skip(test::sanitized)) {
    const Sandbox sandbox;
    for (const std::string command : {"init mine", "run mine/case.json -o r", "run -o r --only comparison",
                                      "modulus mine/ash.csv --amorphous-fraction '42 +- 2 %'"})
        check_fits(sandbox, command);
    check_inspect_fits(sandbox, "r");
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
}
