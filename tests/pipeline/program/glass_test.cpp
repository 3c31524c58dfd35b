// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::check_refused;
using test::containing;
using test::Sandbox;
using test::succeeded;

namespace {

/// XRD and XRF results of one laboratory, each in two shapes.
void write_laboratory(const Sandbox& sandbox) {
    sandbox.write("xrd.csv", "phase,weight %\nquartz,10\nmullite,20\namorphous,70\n");
    sandbox.write("xrd-wide.csv", "Probe;Quarz;Mullit;Amorph\nFA 7;10,0;20,0;70,0\n");
    sandbox.write("xrf.csv", "Oxide,wt%\nSiO2,55\nAl2O3,30\nFe2O3,6\nCaO,4\nK2O,3\nMgO,2\nTotal,100\n");
    sandbox.write("xrf-wide.csv",
                  "Probe;SiO2;Al2O3;Fe2O3;CaO;K2O;MgO;MnO;Summe\n"
                  "FA 6;50,0;30,0;8,0;5,0;4,0;2,0;<LOD;99,0\n"
                  "FA 7;55,0;30,0;6,0;4,0;3,0;2,0;n.d.;100,0\n");
}

double number(const Json& quantity) {
    return quantity.at("value").get<double>();
}

}  // namespace

TEST_CASE("modulus --oxides: the glass from its chemistry, in every shape of the files") {
    const Sandbox sandbox;
    write_laboratory(sandbox);
    for (const char* xrd : {"xrd.csv", "xrd-wide.csv"})
        for (const char* xrf : {"xrf.csv", "xrf-wide.csv --oxides-sample 'FA 7'"}) {
            CAPTURE(xrd);
            CAPTURE(xrf);
            const Json json = Json::parse(
                succeeded(sandbox, std::string("modulus ") + xrd + " --json --oxides " + xrf).out);
            const Json& glass = json.at("glass");
            CHECK(glass.at("used") == true);
            CHECK(std::abs(number(glass.at("composition").at("SiO2")) - 39.35904 / 70) < 1e-6);
            CHECK(std::abs(number(glass.at("composition").at("Al2O3")) - 15.64096 / 70) < 1e-6);
            CHECK(number(glass.at("young_modulus")) > 75e9);
            CHECK(number(glass.at("young_modulus")) < 95e9);
            CHECK(json.at("phases").back().at("phase") == "glass-from-chemistry");
        }
    sandbox.write("two.csv", "Sample;Quartz [wt%];Glass [wt%]\nFA 7;30;70\nFA 8;20;80\n");
    sandbox.write("one.csv", "SiO2;Al2O3;CaO\n65;25;10\n");
    CHECK(succeeded(sandbox, "modulus two.csv --oxides one.csv").err ==
          containing("one analysis counts for 2 samples"));
    sandbox.write("two.json",
                  R"({"name": "t", "wall": {"rigid": true}, "work_of_adhesion": "0.3 J/m2", "laws": ["jkr"],
  "oxides": "one.csv", "glass": "from-chemistry", "samples": [
  {"name": "FA 7", "diameter": "50 um", "density": "2300 kg/m3", "composition": {"xrd": "two.csv", "xrd_sample": "FA 7"}},
  {"name": "FA 8", "diameter": "50 um", "density": "2300 kg/m3", "composition": {"xrd": "two.csv", "xrd_sample": "FA 8"}}]})");
    CHECK(succeeded(sandbox, "run two.json -v -o two").err ==
          containing("the one analysis of one.csv counts for every sample"));
    const std::string text = succeeded(sandbox, "modulus xrd.csv --oxides xrf.csv").out;
    CHECK(text == containing("glass by its oxides [wt%]"));
    CHECK(text == containing("SiO2 56.2, Al2O3 22.3, Fe2O3 8.6"));
    CHECK(text == containing("70.00 % (by XRD 70.00 %)"));
    CHECK(text == containing("E with the catalogue's glass"));
    const Json plain = Json::parse(succeeded(sandbox, "modulus xrd.csv --json").out);
    CHECK_FALSE(plain.contains("glass"));
    const Json beside =
        Json::parse(succeeded(sandbox, "modulus xrd.csv --json --oxides xrf.csv --glass catalogue").out);
    CHECK(beside.at("young_modulus") == plain.at("young_modulus"));
    const Json stated = Json::parse(
        succeeded(sandbox, "modulus xrd.csv --json --oxides xrf.csv --glass-density '2.6 g/cm3'").out);
    CHECK(number(stated.at("glass").at("density")) == 2600);
    CHECK(stated.at("glass").at("density_assumed") == false);
}

TEST_CASE("fractions by volume balance with the weights that the stated density of the glass gives") {
    const Sandbox sandbox;
    write_laboratory(sandbox);
    const std::string stated = " --json --oxides xrf.csv --glass-density '2.2 g/cm3'";
    sandbox.write("volumes.csv", "phase,volume %\nquartz,10\nmullite,17\namorphous,73\n");
    const Json by_volume = Json::parse(succeeded(sandbox, "modulus volumes.csv" + stated).out);
    double mass = 0;
    for (const Json& phase : by_volume.at("phases"))
        mass += phase.at("volume_fraction").get<double>() * number(phase.at("density"));
    std::string weights = "phase,weight %\n";
    for (const Json& phase : by_volume.at("phases"))
        weights += phase.at("name").get<std::string>() + "," +
                   std::to_string(100 * phase.at("volume_fraction").get<double>() *
                                  number(phase.at("density")) / mass) +
                   "\n";
    sandbox.write("weights.csv", weights);
    const Json by_weight = Json::parse(succeeded(sandbox, "modulus weights.csv" + stated).out);
    for (const char* oxide : {"SiO2", "Al2O3"})
        CHECK(relative_difference(number(by_volume.at("glass").at("composition").at(oxide)),
                                  number(by_weight.at("glass").at("composition").at(oxide))) < 1e-6);
}

TEST_CASE("modulus --oxides: wrong chemistry is refused in one line that says what is wrong") {
    const Sandbox sandbox;
    write_laboratory(sandbox);
    const auto refused = [&](const std::string& table, const std::string& says) {
        sandbox.write("wrong.csv", table);
        check_refused(sandbox, "modulus xrd.csv --oxides wrong.csv", says);
    };
    refused("Oxide,wt%\nSiO2,70\nAl2O3,50\n", "wrong.csv: the oxides add up to 120 %");
    refused("Oxide,wt%\nSiO2,75\nAl2O3,-5\n", "wrong.csv: line 3, cell 2: the amount of Al2O3 is -5");
    refused("Oxide,wt%\nSiO2,70\nAl2O3,30\nQxO2,3\n", "no oxide is called \"QxO2\"");
    refused("Oxide,mol%\nSiO2,70\nAl2O3,30\n", "holds amounts of oxides by weight: \"mol%\"");
    refused("Oxide,wt%\nSiO2,90\nAl2O3,5\nCaO,5\n", "Al2O3, more than the whole sample");
    check_refused(sandbox, "modulus xrd.csv --glass from-chemistry", "--oxides FILE");
    check_refused(sandbox, "modulus xrd.csv --oxides xrf-wide.csv", "the oxides have no sample \"xrd\"");
    check_refused(sandbox, "modulus xrd.csv --oxides xrd.csv", "no two oxides are named");
}

TEST_CASE("run: a laboratory's XRD and XRF files lead to a critical velocity") {
    const Sandbox sandbox;
    write_laboratory(sandbox);
    sandbox.write("case.json", R"({
        "name": "FA 7 on steel", "wall": {"young_modulus": "193 GPa", "poisson_ratio": 0.29},
        "work_of_adhesion": "0.3 J/m2", "laws": ["dmt", "jkr"],
        "oxides": "xrf-wide.csv", "glass": "from-chemistry",
        "samples": [{"name": "FA 7", "diameter": "40 um", "composition": {"xrd": "xrd-wide.csv"}}]})");
    const std::string text = succeeded(sandbox, "run case.json --no-report").out;
    CHECK(text == containing("Glass of the catalogue -> glass from its chemistry:"));
    const Json modulus = sandbox.json("results/1-modulus.json");
    CHECK(modulus.at("result").at("samples").at(0).at("glass").at("used") == true);
    CHECK(sandbox.json("results/0-case.json").at("provenance").at("inputs").size() == 3);
    CHECK(succeeded(sandbox, "inspect results/1-modulus.json").out == containing("glass-from-chemistry"));
    succeeded(sandbox, "run --from contact --no-report");
}

TEST_CASE("run --temperature: the limit on the first screen, in the report and as a figure") {
    const Sandbox sandbox;
    write_laboratory(sandbox);
    sandbox.write("case.json", R"({
        "name": "FA 7 on steel", "wall": {"young_modulus": "193 GPa", "poisson_ratio": 0.29},
        "work_of_adhesion": "0.3 J/m2", "laws": ["dmt"], "oxides": "xrf-wide.csv", "glass": "from-chemistry",
        "samples": [{"name": "FA 7", "diameter": "40 um", "composition": {"xrd": "xrd-wide.csv"}, "restitution": {
            "velocity": [0.9, 1.1, 1.3, 1.4, 1.5, 1.7, 1.9, 2.1, 2.4, 2.7, 3.0, 3.4],
            "restitution": [0, 0, 0.18, 0.26, 0.33, 0.43, 0.49, 0.54, 0.59, 0.63, 0.66, 0.68]}}]})");
    const std::string text = succeeded(sandbox, "run case.json --temperature '900 C'").out;
    CHECK(text == containing("Temperatures in C up to which the answer holds (particle at 900 C"));
    const Json limits =
        sandbox.json("results/comparison.json").at("result").at("samples").at(0).at("temperature_limits");
    CHECK(limits.at("by_size").size() == 7);
    CHECK(text == containing("Holds for normal impact on a flat wall, dry, at 900 C, smooth surfaces; not"));
    CHECK(sandbox.read("results/report.html") ==
          containing("Holds for normal impact on a flat wall, dry, at 900 C"));
    CHECK(sandbox.read("results/report.html") == containing("<figure id=\"temperature\">"));
    succeeded(sandbox, "figure temperature results -o viscosity.svg");
    CHECK(sandbox.read("viscosity.svg") == containing("Giordano et al. 2008"));
    const std::string hot = succeeded(sandbox, "run case.json --temperature '1500 C' --no-report -o hot").out;
    CHECK(hot == containing(" m/s is a lower bound that elastic theory gives"));
    CHECK(succeeded(sandbox, "export openfoam hot -o foam").err == containing("is a lower bound"));
    CHECK(sandbox.read("foam/assumptions.md") ==
          containing("- \"FA 7\": at 1500 C the glass is liquid during the contact"));
    check_refused(sandbox, "run case.json --temperature '900 m'", "--temperature");
    check_refused(sandbox, "run case.json --temperature '900 C' --from fit",
                  "--temperature: is part of the case");
}
