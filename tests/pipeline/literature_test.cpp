// SPDX-License-Identifier: GPL-3.0-or-later
// Published critical velocities, laws over sizes, and constants from velocities over sizes.
#include "pipeline/case/literature.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/json/document.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/run/laws_by_size.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/velocities_over_sizes.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::relative_difference;
using test::Sandbox;

namespace {

/// A sphere on a wall with the constants of silver on aluminium but for adhesion and yield.
CriticalVelocityProblem sphere_of_size(Law law, double diameter, double adhesion, double yield,
                                       const Damping& damping = {}) {
    const double radius = diameter / 2;
    return {law,
            law.default_detachment(),
            damping,
            {.mass = 4.0 / 3.0 * std::numbers::pi * 10490 * radius * radius * radius,
             .effective_radius = radius,
             .contact_modulus = 43.2e9,
             .work_of_adhesion = adhesion,
             .yield_pressure = yield}};
}

double exponent_at(Law law, double diameter, double adhesion, double yield) {
    constexpr double step = 1e-3;
    const auto velocity = [&](double factor) {
        return critical_velocity(sphere_of_size(law, diameter * factor, adhesion, yield)).value.value();
    };
    return std::log(velocity(1 + step) / velocity(1 - step)) / std::log((1 + step) / (1 - step));
}

const Law jkr = Law::named("jkr");
const Law thornton_ning = Law::named("thornton-ning");
constexpr double elastic = std::numeric_limits<double>::infinity();

const std::string silver = "--density '10490 kg/m3' --contact-modulus '43.2 GPa' ";

}  // namespace

// JKR alone: W_s ~ (w^5 R^4/E*^2)^(1/3) = m v^2/2. Fully plastic: the contact that adhesion holds is a ~ w
// E*/p_y^2 at every size, and its loading takes p_y a^4/R = m v^2/2.
TEST_CASE("files of measured and published values that the program carries fit their schemas") {
    std::size_t checked = 0;
    for (const auto& [folder, schema] :
         {std::pair("measured/", "literature"), std::pair("published/", "published")})
        for (const std::string_view path : embedded_files(folder)) {
            CAPTURE(path);
            CHECK_NOTHROW(validate_document(parse_json(embedded_file(path).value()), schema));
            ++checked;
        }
    CHECK(checked > 2);
}

TEST_CASE("v_c falls with d^-5/6 by elastic adhesion and with d^-2 in the fully plastic limit") {
    struct {
        Law law;
        double diameter, adhesion, yield, exponent;
    } const rows[] = {{jkr, 20e-9, 0.3, elastic, -5.0 / 6},
                      {jkr, 88e-6, 0.02, elastic, -5.0 / 6},
                      {thornton_ning, 1e-3, 0.02, 5e9, -5.0 / 6},  // yields only beyond v_c
                      {thornton_ning, 4e-6, 1e-4, 4.32e6, -2},
                      {thornton_ning, 1e-6, 1e-4, 4.32e6, -2}};
    for (const auto& row : rows) {
        CAPTURE(row.law.name());
        CAPTURE(row.diameter);
        CHECK(std::abs(exponent_at(row.law, row.diameter, row.adhesion, row.yield) - row.exponent) < 1e-3);
    }
}

TEST_CASE("lines of laws: from 10 nm to 1 mm, with the exponent of each size, only where there is a v_c") {
    const LawBySize line = law_by_size(jkr, [](double d) { return sphere_of_size(jkr, d, 0.1, elastic); });
    REQUIRE(line.curve.size() == sizes_of_the_field().size());
    CHECK(relative_difference(line.curve.front().diameter, 1e-8) < 1e-14);
    CHECK(relative_difference(line.curve.back().diameter, 1e-3) < 1e-14);
    for (const VelocityOfSize& size : line.curve)
        CHECK(size.exponent == doctest::Approx(-5.0 / 6).epsilon(1e-4));
    const Law hertz = Law::named("hertz");
    CHECK(law_by_size(hertz, [&](double d) { return sphere_of_size(hertz, d, 0, elastic); }).curve.empty());
}

TEST_CASE("constants come back from critical velocities of three sizes") {
    struct Row {
        const char* law;
        std::vector<FreeConstant> free;
        double adhesion, yield, damping;
    };
    using enum CalibrationQuantity;
    const Row rows[] = {{"jkr", {{work_of_adhesion}}, 0.05, elastic, 0},
                        {"jkr", {{work_of_adhesion}, {damping}}, 0.05, elastic, 2e-9},
                        {"dmt", {{damping}}, 0.05, elastic, 2e-9},
                        {"thornton-ning", {{work_of_adhesion}, {yield_pressure}}, 0.0095, 0.387e9, 0}};
    for (const Row& row : rows) {
        CAPTURE(row.law);
        CAPTURE(row.free.size());
        const Law law = Law::named(row.law);
        CalibrationProblem problem{
            .samples = {}, .free = row.free, .critical_velocities = {}, .contact_times = {}};
        for (const double diameter : {100e-9, 300e-9, 1000e-9}) {
            const double velocity = *critical_velocity(sphere_of_size(law, diameter, row.adhesion, row.yield,
                                                                      {DampingLaw::constant, row.damping}))
                                         .value;
            problem.critical_velocities.push_back({.sample = problem.samples.size(),
                                                   .law = law,
                                                   .critical_damping = 0,
                                                   .critical_damping_uncertainty = 0,
                                                   .value = velocity,
                                                   .standard_uncertainty = 0.05 * velocity});
            problem.samples.push_back({.diameter = diameter,
                                       .density = 10490,
                                       .work_of_adhesion = row.adhesion,
                                       .particle = {},
                                       .wall = {},
                                       .contact_modulus = 43.2e9,
                                       .yield_pressure = row.yield,
                                       .damping = Damping{DampingLaw::constant, row.damping}});
        }
        for (CalibrationSample& sample : problem.samples)
            for (const FreeConstant& free : row.free) {
                if (free.quantity == work_of_adhesion) sample.work_of_adhesion *= 1.5;
                if (free.quantity == yield_pressure) sample.yield_pressure *= 1.4;
                if (free.quantity == damping) sample.damping->coefficient *= 0.5;
            }
        const CalibrationSummary summary = calibrate(problem);
        const CalibratedVelocity between = velocities_over_sizes(problem, summary, {170e-9}).front();
        CHECK(relative_difference(*between.velocity,
                                  *critical_velocity(sphere_of_size(law, 170e-9, row.adhesion, row.yield,
                                                                    {DampingLaw::constant, row.damping}))
                                       .value) < 1e-4);
        // The band of one constant is that of its power law, v_c ~ w^(5/6); of any it is narrower between the
        // velocities than one of them is known.
        CHECK(*between.interval.upper / *between.velocity < std::exp(1.96 * 0.05));
        if (row.free.size() == 1 && row.damping == 0)
            CHECK(relative_difference(
                      std::log(*between.interval.upper / *between.velocity),
                      5.0 / 6 * std::log(summary.constants[0].upper / summary.constants[0].value)) < 1e-3);
        CHECK(summary.chi_squared < 1e-8);
        CHECK(summary.degrees_of_freedom == 3 - static_cast<int>(row.free.size()));
        for (const CalibratedConstant& constant : summary.constants) {
            const double truth = constant.quantity == work_of_adhesion ? row.adhesion
                                 : constant.quantity == yield_pressure ? row.yield
                                                                       : row.damping;
            CHECK(relative_difference(constant.value, truth) < 1e-5);
        }
    }
}

TEST_CASE("published numbers that a calibration leaves out, and assumed uncertainties, are named") {
    const Sandbox sandbox;
    sandbox.write("case.json", R"({"name": "T", "work_of_adhesion": "0.3 J/m2", "laws": ["jkr"], "samples": [
        {"name": "S", "diameter": "88 um", "density": "2300 kg/m3", "contact_modulus": "87.75 GPa",
         "composition": {"weight_fractions": {"quartz": 1}, "amorphous": "none"},
         "published": {"critical_damping": {"jkr": "0.0135 kg/s"},
                       "critical_velocity": {"jkr": "1.06 m/s", "dmt": "0.9 +- 0.05 m/s"},
                       "contact_times": [{"law": "jkr", "velocity": "2 m/s", "contact_time": "230 +- 10 ns"}]}}]})");
    const std::string said =
        test::succeeded(sandbox, "calibrate case.json --free work_of_adhesion --json").out;
    for (const char* each :
         {"1 published number states no uncertainty: 0.1 % is assumed",
          "the critical velocity of \\\"S\\\" by dmt is not used, without its critical_damping",
          "a contact time of \\\"S\\\" by jkr is not used, without its damping_fits"})
        CHECK(said == test::containing(each));
}

TEST_CASE(
    "calibrate --sizes finds a constant from a table, says when none fits and when nothing can contradict") {
    const Sandbox sandbox;
    const auto table = [](double exponent, const char* heading, const char* separator, bool comma) {
        std::string text = heading;
        for (const double nm : {50.0, 200.0, 800.0}) {
            const double velocity = *critical_velocity(sphere_of_size(jkr, 200e-9, 0.05, elastic)).value *
                                    std::pow(nm / 200, exponent);
            text += fmt::format("{}{}{:.9f}\n", nm, separator, velocity);
        }
        if (comma) std::ranges::replace(text, '.', ',');
        return text;
    };
    sandbox.write("jkr.csv", table(-5.0 / 6, "d [nm],v_c [m/s]\n", ",", false));
    sandbox.write("german.csv", table(-5.0 / 6, "d [nm];v_c [m/s]\n", ";", true));
    sandbox.write("steep.csv", table(-1.6, "d [nm],v_c [m/s]\n", ",", false));
    const std::string with = " --uncertainty '10 %' --law jkr " + silver + "--free work_of_adhesion";
    for (const char* file : {"jkr.csv", "german.csv"}) {
        CAPTURE(file);
        const Json found = parse_json(
            test::succeeded(sandbox, "calibrate --sizes " + std::string(file) + with + " --json").out);
        CHECK(found["constants"][0]["value"]["value"].get<double>() == doctest::Approx(0.05).epsilon(1e-5));
        CHECK(found["constants"][0]["value"]["unit"] == "J/m2");
        CHECK(found["fits"] == true);
        CHECK(found["constants"][0]["profile"]["identifiable"] == true);
    }
    CHECK(test::succeeded(sandbox, "calibrate --sizes jkr.csv" + with + " -o fit.svg").out ==
          test::containing("by profile likelihood"));
    for (const char* piece : {"given velocities", "class=\"band", "JKR"})
        CHECK(sandbox.read("fit.svg") == test::containing(piece));
    const test::Finished steep = test::succeeded(sandbox, "calibrate --sizes steep.csv" + with);
    CHECK(steep.out == test::containing("No value of these constants fits"));
    for (const std::string& line : test::lines_of(steep.out)) CHECK(line.size() <= 80);
    sandbox.write("one.csv", "d [um],v_c [m/s],u(v_c) [m/s]\n1,0.1,0.01\n");
    CHECK(
        test::succeeded(sandbox, "calibrate --sizes one.csv --law jkr " + silver + "--free work_of_adhesion")
            .out == test::containing("There are as many constants as velocities"));

    // Constants that only their quotient counts of have no intervals.
    sandbox.write("traded.csv", "d [um],v_c [m/s]\n5,0.147536\n10,0.082802\n20,0.046471\n40,0.026081\n");
    const Json traded = parse_json(test::succeeded(sandbox,
                                                   "calibrate --sizes traded.csv --law jkr --density 2300 "
                                                   "--contact-modulus '60 GPa' --uncertainty '5 %' "
                                                   "--free work_of_adhesion --free density --json")
                                       .out);
    for (const Json& constant : traded["constants"]) CHECK(constant["interval_95"][1].is_null());
    sandbox.write("unnamed.csv", "d [um],v_c [m/s],u(v_c) [m/s],\n1,0.1,0.01,\n2,0.06,0.01,*\n");
    CHECK(test::succeeded(sandbox,
                          "calibrate --sizes unnamed.csv --law jkr " + silver + "--free work_of_adhesion")
              .err == test::containing("which has no heading, is not used: \"*\""));

    sandbox.write("plain.csv", "d [um],v_c [m/s]\n1,0.1\n");
    sandbox.write("units.csv", "d [um],v_c [m/s]\n1 um,0.1 m/s\n");
    const std::string of_one =
        " --law jkr " + silver + "--uncertainty '10 %' --free work_of_adhesion --json --sizes ";
    CHECK(test::succeeded(sandbox, "calibrate" + of_one + "units.csv").out ==
          test::succeeded(sandbox, "calibrate" + of_one + "plain.csv").out);
    sandbox.write("grouped.csv", "d [um];v_c [mm/s]\n1;100.000\n");
    CHECK(test::succeeded(sandbox, "calibrate" + of_one + "grouped.csv --decimal point").out ==
          test::succeeded(sandbox, "calibrate" + of_one + "plain.csv").out);
    // What other readers accept: names, titles, notes, columns beside, coverages, rows that sum up.
    sandbox.write("german-names.csv",
                  "Silber\nDurchmesser (\u00b5m);kritische Geschwindigkeit "
                  "[m/s];Bemerkung\n1;0,1;x\nMittel;0,1;\n\n* trocken\n");
    const test::Finished named = test::succeeded(sandbox, "calibrate" + of_one + "german-names.csv");
    CHECK(named.out == test::succeeded(sandbox, "calibrate" + of_one + "plain.csv").out);
    for (const char* says : {"line 1, above the heading, is not read", "column \"Bemerkung\" is not used",
                             "line 4 is no size and left out", "below the table is not read"})
        CHECK(named.err == test::containing(says));
    sandbox.write("sized.csv", "d [um],v_c [m/s]\n1 +- 0.2,0.1\n");
    CHECK(test::succeeded(sandbox, "calibrate" + of_one + "sized.csv").err ==
          test::containing("uncertainties of sizes are not used, the first in line 2, cell 1"));
    for (const char* heading :
         {"v_c [m/s];u(v_c) [m/s] (k=2)", "v_c [m/s];\u00b1 (2s)", "v_c [m/s] \u00b1 2\u03c3",
          "v_c [m/s];U(v_c) (k=2)", "v_c [m/s];2 sigma [m/s]", "v_c [m/s];2\u03c3"}) {
        const bool in_cells = std::string_view(heading).find(';') == std::string_view::npos;
        sandbox.write("doubled.csv", "d [um];" + std::string(heading) + "\n1;0.1" +
                                         (in_cells ? " \u00b1 " : ";") + "0.02\n");
        const auto uncertainty = [&](const char* file) {
            const Json fit = Json::parse(test::succeeded(sandbox, "calibrate" + of_one + file).out);
            return fit.at("/constants/0/value/standard_uncertainty"_json_pointer).get<double>();
        };
        CHECK(uncertainty("doubled.csv") == doctest::Approx(uncertainty("plain.csv")).epsilon(1e-9));
    }
    for (const char* relative :
         {"d [um];v_c [m/s];u(v_c) [%]\n1;0.1;10\n", "d [um];v_c [m/s];err %\n1;0.1;10\n",
          "d / \u00b5m;v_c / m/s;error [%]\n1;0.1;10 %\n", "d;v_c;u(v_c)\num;m/s;%\n1;0.1;10\n"}) {
        CAPTURE(relative);
        sandbox.write("relative.csv", relative);
        CHECK(test::succeeded(sandbox, "calibrate" + of_one + "relative.csv").out ==
              test::succeeded(sandbox, "calibrate" + of_one + "plain.csv").out);
    }
    const std::string rows = "d [um];v_c [m/s];remark\n1;0.1;mean of 3\n2;0.06;mean of 3\n4;0.03;\n";
    sandbox.write("remarks.csv", rows);
    sandbox.write("no-remarks.csv", "d [um];v_c [m/s]\n1;0.1\n2;0.06\n4;0.03\n");
    CHECK(test::succeeded(sandbox, "calibrate" + of_one + "remarks.csv").out ==
          test::succeeded(sandbox, "calibrate" + of_one + "no-remarks.csv").out);
    sandbox.write("sides.csv", "d [um];v_c [m/s];+;-\n1;0.1;0.01;0.02\n2;0.06;0.01;0.02\n4;0.03;0.01;0.02\n");
    CHECK(test::succeeded(sandbox, "calibrate" + of_one + "sides.csv").err ==
          test::containing("column \"+\" is not used"));
    // What the reader of impacts refuses in titles, labels and rows below is refused here.
    const std::string four = "d [um];v_c [m/s]\n1;0.1\n2;0.06\n4;0.03\n8;0.018\n";
    for (const auto& [text, says] :
         {std::pair{"# sizes are radii\n" + four, "line 1: \"sizes are radii\" states radii"},
          {"Velocities in cm/s\n" + four, "states cm/s, and column \"v_c [m/s]\" is taken in another unit"},
          {four + "3.75;0.052\n", "line 6: the row holds the means of the rows above"},
          {four + "15;0.208\n", "line 6: the row holds the sums of the rows above"},
          {std::string(
               "wall;d [um];v_c [m/s]\nA;10;0.40\nA;20;0.24\nA;33;0.17\nB;40;0.23\nB;60;0.17\nB;83;0.11\n"
               "A;21;0.27\nB;61;0.17\n"),
           "line 8: the row holds the means of the rows with its label"},
          {"d [um];v_c [m/s]\n20;0.42\n40;0.24\n60;0.17\n20;0.42\n40;0.24\n60;0.17\n",
           "line 5: the rows to line 7 repeat those from line 2 to 4: they may be there twice"},
          {std::string("d [um];v_c [m/s];excluded\n1;0.1;\n2;0.06;x\n"),
           "\"excluded\" marks rows as valid or not"},
          {std::string("d [um];v_c [m/s];remark\n1;0.1;\n2;0.06;outlier\n"), "calls the row invalid"}}) {
        CAPTURE(text);
        sandbox.write("refused.csv", text);
        test::check_refused(sandbox, "calibrate" + of_one + "refused.csv", says);
    }
    const auto published = test::succeeded(
        sandbox,
        "calibrate --law jkr --density 2500 --contact-modulus '70 GPa' --uncertainty '10 %' --free "
        "work_of_adhesion --sizes jungmann2018");
    CHECK(published.err == test::containing("jungmann2018: 1 of 2 critical velocities used; left out: 1 a "
                                            "range or a bound, no single value"));
    CHECK(published.err == test::containing("is outside of what is plausible, 1e-5 to 20 J/m2"));
    sandbox.write("undamped.csv",
                  "d [um],v_c [m/s]\n2,0.2336\n5,0.1088\n10,0.06108\n20,0.03428\n50,0.01597\n");
    test::check_refused(sandbox,
                        "calibrate --law jkr --density 2500 --contact-modulus '70 GPa' --uncertainty '10 %' "
                        "--free work_of_adhesion --free damping --sizes undamped.csv",
                        "damping is not identifiable");
    sandbox.write("coverage.csv", "# k=2\nd [um];v_c [m/s]\n1;0.1 \u00b1 0.02\n");
    sandbox.write("coverage-column.csv", "# k=2\nd [um];v_c [m/s];u(v_c) [m/s]\n1;0.1;0.02\n");
    sandbox.write("mixed.csv", "d [um],v_c [m/s]\n1,100 mm/s\n");
    sandbox.write("bare.csv", "d,v_c [m/s]\n1,0.1\n");
    sandbox.write("negative.csv", "d [um],v_c [m/s]\n1,-0.1\n");
    const std::string jkr_free = " --law jkr " + silver + "--free work_of_adhesion";
    const struct {
        std::string options, says;
    } refused[] = {
        {"--sizes mixed.csv --uncertainty 0.1" + jkr_free,
         "mixed.csv: line 2, cell 2: \"100 mm/s\" in column \"v_c [m/s]\" is not a positive number; allowed: "
         "a number above 0 in m/s"},
        {"--sizes jkr.csv --law jkr " + silver + "--free time_step",
         "--free: \"time_step\" cannot follow from velocities over sizes"},
        {"--sizes jkr.csv --uncertainty 0.1 -o fit.txt" + jkr_free, "fit.txt"},
        {"-o fit.svg --free density", "--output requires --sizes"},
        {"--sizes jkr.csv" + jkr_free, "--uncertainty: is missing"},
        {"--sizes jkr.csv" + jkr_free + " --uncertainty 1",
         "--uncertainty: 1 without a unit is 100 % or 1 %"},
        {"--sizes jkr.csv --uncertainty 0.1 --law jkr " + silver, "--free: is missing"},
        {"--sizes jkr.csv --uncertainty 0.1 --law jkr --work-of-adhesion 0.1 " + silver +
             "--free yield_pressure",
         "--free: yield_pressure is free, and"},
        {"--sizes bare.csv --uncertainty 0.1" + jkr_free, "bare.csv: line 1: column \"d\" has no unit"},
        {"--sizes coverage.csv --uncertainty 0.1" + jkr_free, "line 1: \"k=2\" states \"k=2\""},
        {"--sizes coverage-column.csv --uncertainty 0.1" + jkr_free,
         "and the column \"u(v_c) [m/s]\" does not"},
        {"--sizes negative.csv --uncertainty 0.1" + jkr_free,
         "negative.csv: line 2, cell 2: \"-0.1\" in column \"v_c [m/s]\" is not a positive number"},
        {"--law jkr --free density", "--law: is given without --sizes"},
        {"--free damping", "/calibration: damping is free, and no case determines it"}};
    for (const auto& row : refused) {
        CAPTURE(row.options);
        test::check_refused(sandbox, "calibrate " + row.options, row.says);
    }
}

TEST_CASE("literature lists sources with what was read and what is missing, beside a law if one is given") {
    const Sandbox sandbox;
    const Json all = parse_json(test::succeeded(sandbox, "literature --json").out)["sources"];
    REQUIRE(all.size() == 8);
    for (const Json& source : all) {
        CAPTURE(source["source"]);
        CHECK_FALSE(source["read"].get<std::string>().empty());
        CHECK_FALSE(source["missing"].empty());
        CHECK(source["doi"] != "");
    }
    const test::Finished text = test::succeeded(sandbox, "literature");
    for (const std::string& line : test::lines_of(text.out)) CHECK_MESSAGE(width_of(line) <= 80, line);
    for (const char* piece : {"silver on aluminium", "14 m/s", "below 0.01 m/s", "0.829 to 0.847 m/s",
                              "second-hand", "10.1088/2399-6528/aad0d2"})
        CHECK(text.out == test::containing(piece));

    const Json beside = parse_json(test::succeeded(sandbox, "literature arffman2015 --law jkr " + silver +
                                                                "--work-of-adhesion '0.1 J/m2' --json")
                                       .out)["sources"][0];
    CHECK(beside["exponent"] == -1.6);
    const Json& small = beside["velocities"][0];
    CHECK(relative_difference(small["by_law"]["critical_velocity"]["value"].get<double>(),
                              *critical_velocity(sphere_of_size(jkr, 20e-9, 0.1, elastic)).value) < 1e-12);
    CHECK(small["by_law"]["exponent"].get<double>() == doctest::Approx(-5.0 / 6).epsilon(1e-6));
    CHECK(small["critical_velocity"]["lower"] == small["critical_velocity"]["upper"]);

    test::check_refused(sandbox, "literature arfman2015", "did you mean \"arffman2015\"");
    test::check_refused(sandbox, "literature --density 1000", "--density: is given without --law");
    test::check_refused(sandbox, "literature --law jkr --density 1000 --work-of-adhesion 0.1",
                        "--contact-modulus: is missing");
    for (const std::string command :
         {"literature", "calibrate --sizes arffman2015 --uncertainty '10 %' --free work_of_adhesion"})
        test::check_refused(sandbox,
                            command + " --law maugis-dugdale --tabor 1 --work-of-adhesion 0.1 " + silver,
                            "--tabor: goes with the size");
    test::succeeded(sandbox, "literature --law jkr " + silver + "--work-of-adhesion 0.1 -o field.svg");
    for (const char* piece : {"jungmann2018, glass on metal", "JKR, d^-0.83"})
        CHECK(sandbox.read("field.svg") == test::containing(piece));
}

TEST_CASE("the velocities of the paper are the same in the literature and among its published values") {
    const Json published = parse_json(embedded_file("published/dong2013.json").value());
    for (const LiteratureVelocity& each : literature_source("dong2013").velocities)
        CHECK(published["samples"][each.name]["measured_critical_velocity"] ==
              fmt::format("{} m/s", each.upper));
}

// The others are in its blocks, which the test of the site runs, and in tests/data_files.
TEST_CASE("docs/validation.md has the numbers that follow from the literature") {
    const auto& silver_ends = literature_source("arffman2015").velocities;
    const auto& silica = literature_source("dong2014").velocities;
    const auto& ash = literature_source("dong2013").velocities;
    const double stated = *literature_source("arffman2015").exponent;
    const LiteratureVelocity& small = silver_ends[0];
    const LiteratureVelocity& large = silver_ends[1];
    const auto adhesion_for = [](const LiteratureVelocity& end) {  // v_c ~ w^(5/6)
        const auto at = critical_velocity(sphere_of_size(jkr, *end.diameter, 1, elastic)).value;
        return std::pow(end.upper / at.value(), 6.0 / 5);
    };
    const auto best = [&](const LiteratureVelocity& end) {  // of both ends, by their geometric mean
        return std::pow(std::sqrt(adhesion_for(small) * adhesion_for(large)) / adhesion_for(end), 5.0 / 6);
    };
    CHECK(relative_difference(best(large), 1 / best(small)) < 1e-9);
    const auto velocity_of = [](const CriticalVelocityProblem& problem) {
        return critical_velocity(problem).value.value();
    };
    const double glass_radius = *literature_source("jungmann2018").velocities[0].diameter / 2;
    const CriticalVelocityProblem glass{
        jkr,
        jkr.default_detachment(),
        {},
        {.mass = 4.0 / 3.0 * std::numbers::pi * 2500 * std::pow(glass_radius, 3),
         .effective_radius = glass_radius,
         .contact_modulus = 54.5e9,
         .work_of_adhesion = 1}};
    const double bound = std::pow(0.01 / velocity_of(glass), 6.0 / 5);
    // Two grains of ice of 3 um: half the radius and half the mass of one.
    CriticalVelocityProblem ice = glass;
    ice.contact.mass = 0.5 * 4.0 / 3.0 * std::numbers::pi * 920 * std::pow(1.5e-6, 3);
    ice.contact.effective_radius = 0.75e-6;
    ice.contact.contact_modulus = 5.05e9;
    ice.contact.work_of_adhesion = 0.38;
    const double slow = literature_source("gundlach2015").velocities[0].upper / velocity_of(ice);
    const auto slower = [&](double um) { return slow * std::pow(um / 3, 5.0 / 6); };
    const auto fall = [&](double from, double to) {
        return std::log(ash.front().upper / ash.back().upper) / std::log(from / to);
    };
    const auto rougher = [](double um) {  // from an rms of 1.5 nm to one of 12 nm
        return roughness_reduction(um * 1e-6, {.rms = 1.5e-9}) /
               roughness_reduction(um * 1e-6, {.rms = 12e-9});
    };
    std::ifstream stream(ASHIMPACT_SOURCES "/docs/validation.md");
    std::string page{std::istreambuf_iterator<char>(stream), {}};
    std::ranges::replace(page, '\n', ' ');
    for (const std::string& text :
         {fmt::format("it has {:.2f} to {:.2f} m/s at 100 nm", large.upper * std::pow(0.1, stated),
                      small.upper * std::pow(100.0 / 20, stated)),
          fmt::format("by a factor of {:.1f}", best(large)),
          fmt::format("{:.2f} J/m2 at 20 nm and {:.3f} J/m2 at 1 um", adhesion_for(small),
                      adhesion_for(large)),
          fmt::format("a ratio of {:.2f} to {:.2f}", *silica[1].lower / silica[0].upper,
                      silica[1].upper / *silica[0].lower),
          fmt::format("with every w up to {:.1f} J/m2", bound),
          fmt::format("{:.0f} to {:.0f} times too slow", slower(1.4), slower(4.6)),
          fmt::format("grains of {:.1f} um, or {:.0f} times this w", 3 * std::pow(slow, -6.0 / 5),
                      std::pow(slow, 6.0 / 5)),
          fmt::format("{} to {} m/s at 88 to 104 um", ash.front().upper, ash.back().upper),
          fmt::format("fall with d^{:.1f}, with those openings with d^{:.1f}",
                      fall(*ash.front().diameter, *ash.back().diameter), fall(45, 63)),
          fmt::format("by a factor of {:.1f}; with spheres of 2.5 and 10 um by {:.1f} and {:.1f}", rougher(5),
                      rougher(2.5), rougher(10)),
          fmt::format("{} m/s without a size", literature_source("hu2022").velocities[0].upper)})
        CHECK_MESSAGE(test::contains(page, text), text);
}
