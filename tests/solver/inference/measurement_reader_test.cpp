// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/inference/impacts/angle_classes.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/motion/impact.hpp"
#include "solver/surrogate/contact_model.hpp"
#include "tests/solver/inference/ash_laboratory.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/marked_tables.hpp"

using namespace ashimpact;
using test::Cells;
using test::check_marked;
using test::contains;
using test::input_error_of;

namespace {

std::string warnings_of(const MeasurementSet& set) {
    std::string text;
    for (const Finding& warning : set.warnings) text += warning.text + "\n";
    return text;
}

double noise_of_incident(const std::string& table) {
    const MeasurementSet set = read_measurements(table, "t.csv");
    REQUIRE(set.has_noise());
    return std::sqrt(set.points.front().noise->incident);
}

double noise_of_rebound(const std::string& table) {
    const MeasurementSet set = read_measurements(table, "t.csv");
    REQUIRE(set.has_noise());
    return std::sqrt(set.points.front().noise->rebound);
}

}  // namespace

TEST_CASE("a coverage of uncertainties in a comment is refused") {
    const auto refusal = [](const std::string& heading) {
        return input_error_of([&] {
            return read_measurements("# errors: 2 sigma\n" + heading + "\n1,0.5,0.1,0.1\n2,1,0.1,0.1\n",
                                     "a.csv");
        });
    };
    CHECK(contains(refusal("v_in [m/s],v_r [m/s],u(v_in) [m/s],u(v_r) [m/s]"),
                   "line 1: \"errors: 2 sigma\" states \"2 sigma\", and the column"));
    CHECK(refusal("v_in [m/s],v_r [m/s],u(v_in) (2 sigma) [m/s],u(v_r) (2 sigma) [m/s]").empty());
}

TEST_CASE("what the texts beside impacts and their columns state counts, or the table is refused") {
    const std::string bare = "v_in;v_r\n0.3;0\n0.75;0.08\n";
    const std::string given = "v_in [m/s];v_r [m/s]\n0.3;0\n0.75;0.08\n";
    const std::string oblique = "v_in [m/s];v_rn [m/s];angle [deg]\n0.3;0;60\n0.75;0.08;60\n";
    const auto marked = [](const std::string& heading, const std::string& mark) {
        return "v_in [m/s];v_r [m/s];" + heading + "\n0.3;0;\n0.75;0.08;\n1.4;0.55;" + mark + "\n";
    };
    for (const auto& [table, says] :
         {std::pair{"velocities: millimetres per second\n" + given, "states millimetres per second"},
          {"in mm s-1\n" + given, "states mm s-1"},
          {"# Einfallswinkel 30\u00b0\n" + given, "states an angle of the impacts"},
          {"oblique impacts, 30 deg to the wall\n" + given, "states an angle of the impacts"},
          {"errors relative\nv_in;u(v_in);v_r\n2;0.1;0.5\n", "states relative uncertainties"},
          {"errors in %\nv_in;u(v_in);v_r\n2;0.1;0.5\n", "states relative uncertainties"},
          {"# mm/s\n" + bare, "states mm/s, and column \"v_in\" is taken in another unit"},
          {bare + "\nVelocities in mm/s\n", "states mm/s"},
          {"Velocities in mm/s\n" + given, "column \"v_in\" is taken in another unit"},
          {given + "\nVelocities [mm/s]\n", "column \"v_in\" is taken in another unit"},
          {"angles measured from the surface\n" + oblique, "may state that the angles are from the wall"},
          {"# k=2\nv_in [m/s];v_r [m/s]\n0.3 \u00b1 0.02;0.1 \u00b1 0.02\n", "the heading \"v_in [m/s]\" of"},
          {"v_in [m/s];v_rn [m/s];impingement angle [deg]\n0.75;0.08;60\n",
           "may hold the angle of incidence"},
          {"v_in [m/s];Plattenneigung [\u00b0];e_n\n0.75;60;0.08\n", "may hold the angle of incidence"},
          {"v_in [mm/s];v_r\n300;0\n750;80\n", "has a unit, and it is not m/s"},
          {"v_in [m/s];v_r [m/s];u [%]\n0.3;0;5\n0.75;0.08;5\n", "is relative to a reading of 0"},
          {marked("unit", "cm/s"), "\"cm/s\" states cm/s, and column \"v_in\""},
          {marked("", "all velocities in mm/s"), "states mm/s"},
          {"v_in [m/s];v_r [m/s];angle of plate\n0.75;0.08;60\n", "may hold the angle of incidence"},
          {"v_in [m/s];v_r [m/s];Plattenwinkel\n0.75;0.08;60\n", "may hold the angle of incidence"},
          {"v_in [m/s];v_r [m/s];tilt [deg]\n0.75;0.08;60\n", "may hold the angle of incidence"},
          {"# angle of plate 30\n" + given, "states an angle of the impacts"},
          {given + "\ntangential velocities\n", "may state that the velocities are those along the wall"},
          {marked("Ausschluss", "x"), "marks rows as valid or not"},
          {marked("\u00e0 exclure", "x"), "marks rows as valid or not"},
          {marked("Vermerk 2", "x"), "marks rows as valid or not"},
          {marked("Remarque", "\u00e0 rejeter"), "calls the row invalid"}}) {
        const std::string message =
            input_error_of([&, &text = table] { return read_measurements(text, "a.csv"); });
        CHECK_MESSAGE(contains(message, says), message);
    }
    for (const std::string& table :
         {"gas at 1200 mm/s, mm/s converted to m/s\n" + given, "# camera: 12 mm/s a pixel\n" + given,
          "impact angle 90\u00b0, camera at 30\u00b0\n" + given,
          std::string("v_in [m/s];v_r/v_in\n0.75;0.1\n"), std::string("v_in [m/s];v_r/v_in [%]\n0.75;10\n"),
          std::string("v_in [m/s];v_rn [m/s];rebound angle [deg]\n0.75;0.08;60\n"), marked("Vermerk 2", "y"),
          marked("unit", "m/s"), marked("Bemerkung", "gas 12 mm/s")})
        CHECK_MESSAGE(input_error_of([&] { return read_measurements(table, "a.csv"); }).empty(), table);
    for (const auto& [table, says] :
         {std::pair{"# each row is a mean of 5\n" + given, "is not read: each row counts as one impact"},
          {std::string("v_in [m/s];e_n;u(v_r) [m/s]\n0.75;0.1;0.02\n1.4;0.3;0.02\n"),
           "column \"u(v_r)\" is not used: it is the uncertainty of a column that is not there"},
          {given + "\nNote: camera A; lens B\n", "line 5 below the table is not read"}}) {
        CAPTURE(table);
        CHECK(contains(warnings_of(read_measurements(table, "a.csv")), says));
    }
    CHECK(read_measurements("# v_in [m/s];v_r [m/s]\n0.75;0.08\n", "a.csv").points.size() == 1);
    CHECK(noise_of_rebound("v_in;v_r;\u00b1\n2.1;0.4;\u00b10.02\n") == doctest::Approx(0.02));
    CHECK(read_measurements("v_in [m/s];v_r [m/s];tangential velocities [m/s]\n0.75;0.08;0.3\n", "a.csv")
              .points.front()
              .tangential == doctest::Approx(0.3));
    CHECK(read_measurements("v_in [m/s];v_r [m/s];remark\n0.75;0.08;mean of 3\n1.4;0.55;\n", "a.csv")
              .points.size() == 2);
    CHECK(noise_of_incident(
              "v_in [m/s] \u00b1 2\u03c3;v_r [m/s] \u00b1 2\u03c3\n2,1 \u00b1 0,06;0,4 \u00b1 0,02\n") ==
          doctest::Approx(0.03).epsilon(1e-12));
    CHECK(contains(warnings_of(read_measurements("v_in [m/s] (2 sigma);v_r [m/s]\n0.75;0.08\n", "a.csv")),
                   "holds no uncertainties"));
}

TEST_CASE("impacts at an angle: the part of v_in normal to the wall counts") {
    const auto read = [](const std::string& table) { return read_measurements(table, "t.csv"); };
    for (const char* heading : {"v_in [m/s];e_n;angle [deg]", "v_in [m/s];e_n;Winkel (\u00b0)",
                                "v_in [m/s];e_n;Einfallswinkel in deg", "v_in [m/s];e_n;Incidence (\u00b0)",
                                "v_in [m/s];e_n;angle of incidence [\u00b0]"}) {
        CAPTURE(heading);
        const MeasurementSet set = read(std::string(heading) + "\n2;0.5;60\n4;0.5;0\n");
        CHECK(set.points[0].velocity == doctest::Approx(1).epsilon(1e-12));
        CHECK(set.points[0].rebound == doctest::Approx(0.5).epsilon(1e-12));
        CHECK(set.points[0].tangential.value() == doctest::Approx(std::sqrt(3.0)).epsilon(1e-12));
        CHECK(set.points[1].velocity == 4);
        CHECK(contains(warnings_of(set), "the velocity normal to the wall is \"v_in\" times the cosine of"));
    }
    const MeasurementSet radians = read(
        "v_in [m/s],v_rn [m/s],angle [rad],u(v_in) [m/s],u(v_rn) "
        "[m/s]\n2,0.5,1.0471975511965976,0.02,0.01\n");
    CHECK(radians.points[0].velocity == doctest::Approx(1).epsilon(1e-12));
    CHECK(radians.points[0].rebound == 0.5);
    CHECK(std::sqrt(radians.points[0].noise->incident) == doctest::Approx(0.01).epsilon(1e-12));
    const MeasurementSet normal = read("v_n [m/s],v_rn [m/s],angle [deg]\n1,0.5,60\n");
    CHECK(normal.points[0].velocity == 1);
    CHECK(normal.points[0].tangential.value() == doctest::Approx(std::sqrt(3.0)).epsilon(1e-12));
    const MeasurementSet split = read("v_in [m/s],v_r [m/s],v_t [mm/s]\n1,0.5,300\n");
    CHECK(split.points[0].velocity == 1);
    CHECK(split.points[0].tangential.value() == doctest::Approx(0.3).epsilon(1e-12));
    CHECK_FALSE(read("v_in [m/s],v_r [m/s]\n1,0.5\n").points[0].tangential);
    for (const auto& [table, says] :
         {std::pair{"v_in [m/s],v_r [m/s],angle [deg]\n2,0.5,60\n",
                    "\"v_r\" may be of the velocity of the sphere or of its part normal"},
          {"v_in [m/s],e,angle [deg]\n2,0.5,60\n", "\"e\" may be of the velocity of the sphere"},
          {"v_in [m/s],e_n,angle\n2,0.5,60\n",
           "column \"angle\" states no unit; allowed: degrees or radians"},
          {"v_in [m/s],e_n,angle [deg]\n2,0.5,95\n",
           "\"95\" in column \"angle\" is no angle from the normal; allowed: 0 to below 90 degrees"},
          {"v_in [m/s],v_rn [m/s],angle [deg]\n2,0.5,20 \u00b1 3\n",
           "\"20 \u00b1 3\" in column \"angle\" states an uncertainty, which nothing here uses; allowed: the "
           "angle alone; an error of all angles counts through velocity_scale_uncertainty"},
          {"v_n [m/s],v_rn [m/s],angle [deg]\n2,0.5,20(3)\n", "\"20(3)\" in column \"angle\" states an"},
          {"v_in [m/s],v_r [m/s],v_t [m/s]\n1,0.5,0.3 +- 0.1\n",
           "\"0.3 +- 0.1\" in column \"v_t\" states an uncertainty, which nothing here uses; allowed: the "
           "velocity alone"},
          {"v_in [m/s],e_n,angle [deg],v_t [m/s]\n2,0.5,60,1\n", "both state how oblique the impacts are"},
          {"v_in [m/s],v_rn [m/s],v_rt [m/s]\n2,0.5,1\n",
           "column \"v_rt [m/s]\" shows impacts at an angle, and \"v_in\" may be"},
          {"|v_in| [m/s],v_rn [m/s],v_t [m/s]\n2,0.5,1\n",
           "beside \"v_t\", \"|v_in|\" may be the speed of the sphere or the size of its part normal"},
          {"v_in [m/s],e_n,angle [m]\n2,0.5,60\n", "is not one of angle"}})
        CHECK_MESSAGE(contains(input_error_of([&, &text = table] { return read(text); }), says), says);
}

TEST_CASE("marks of outcomes and groups of impacts in columns that are not read are said or refused") {
    const auto refused = [](std::string_view text) {
        return input_error_of([&] { static_cast<void>(read_measurements(text, "t.csv")); });
    };
    CHECK(contains(refused("v_in [m/s],v_r [m/s],fate\n1,0.1,stuck\n2,1,\n"),
                   "\"stuck\" in column \"fate\" speaks of another outcome than the reading"));
    CHECK(contains(refused("v_in [m/s],v_r [m/s],\n1,0.1,haftet\n2,1,\n"), "in a column without heading"));
    CHECK(contains(refused("v_in [m/s],v_r [m/s],remark\n1,0.1,particle stuck\n2,1,\n"),
                   "speaks of a capture"));
    CHECK(
        contains(refused("v_in [m/s],,v_r [m/s]\n1,<,0.1\n2,,1\n"), "may make the number beside it a bound"));
    CHECK(
        contains(refused("v_in [m/s],% e\n1,0.1\n2,0.2\n"), "\"% e\" may be in per cent, or hold fractions"));
    CHECK(contains(refused("v_in [m/s],v_r < [m/s]\n1,0.1\n2,0.2\n"), "holds a bound, not the quantity"));
    CHECK(contains(refused("v_in [m/s],e (E)\n1,0.1\n2,0.2\n"), "restitution of energy, not the quantity"));
    CHECK(refused("v_in [m/s],v_r [m/s],fate\n1,0,stuck\n2,1,rebound\n").empty());
    for (const char* flags :
         {"contact\n1,,1\n2,1,0\n", "rebounded\n1,0,0\n2,1,1\n", "spin\n1,.1,yes\n2,1,no\n"})
        CHECK(contains(refused(std::string("v_in [m/s],v_r [m/s],") + flags),
                       "it may state which impacts were captured, or which count"));
    const auto sticking = read_measurements("v_in [m/s],v_r [m/s],sticking\n1,,1\n2,1,0\n", "t.csv");
    CHECK(sticking.captures() == 1);
    CHECK(sticking.points.size() == 2);
    CHECK(contains(refused("v_in [m/s],e_n,u(e_n)\n1,45 %,0.02\n2,50 %,0.02\n"),
                   "\"0.02\" in column \"u(e_n)\" may be a fraction or per cent, beside \"45 %\""));
    const auto said = [](std::string_view text) { return warnings_of(read_measurements(text, "t.csv")); };
    const std::string table = "v_in [m/s],v_r [m/s],wall\n1,0.2,steel\n2,1,steel\n3,1.8,alumina\n4,2.5,";
    CHECK(contains(said(table + "alumina\n"),
                   "column \"wall\" has \"alumina\", \"steel\": all impacts count as"));
    CHECK_FALSE(contains(said(table + "glass\n"), "all impacts count as"));
    CHECK(
        contains(said("v_in [m/s];e\n1;0.5\n;\n2;0.6\n"), "the impacts below line 3, which is blank, count"));
    CHECK_FALSE(contains(said("v_in [m/s];e\n\n1;0.5\n2;0.6\n\n"), "blank"));
}

TEST_CASE("classes of angle are compared, and told apart where damping differs") {
    std::mt19937_64 random(11);
    std::normal_distribution<double> noise(0, 0.03);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto comparison = [&](double more_at_an_angle) {
        MeasurementSet set{.source = "made up", .points = {}};
        std::vector<InvertedImpact> inverted;
        for (std::size_t i = 0; i < 60; ++i) {
            const double v = 1 + 3 * unit(random);
            const double angle = (i % 3 == 0 ? 2 : i % 3 == 1 ? 30 : 55) * 0.0174533;
            const double factor = i % 3 == 2 ? 1 + more_at_an_angle : 1;
            set.points.push_back({.velocity = v, .rebound = 0.5 * v, .tangential = v * std::tan(angle)});
            inverted.push_back({.index = i,
                                .velocity = v,
                                .restitution = 0.5,
                                .damping = 1e-3 * factor * std::pow(v, -0.4) * std::exp(noise(random))});
        }
        return compare_angles(set, inverted, DampingSmoothing::of(inverted)).value();
    };
    const AngleComparison differs = comparison(0.2);
    REQUIRE(differs.classes.size() == 3);
    CHECK(differs.classes[2].from == doctest::Approx(55 * 0.0174533).epsilon(1e-6));
    CHECK(differs.classes[1].rebounds == 20);
    CHECK_FALSE(differs.normal_decides());
    CHECK(differs.classes[2].difference - differs.classes[0].difference ==
          doctest::Approx(std::log(1.2)).epsilon(0.2));
    int agreeing = 0;
    for (int i = 0; i < 40; ++i) agreeing += comparison(0).normal_decides() ? 1 : 0;
    CHECK(agreeing >= 35);  // 38 on average: the level is 5 %
    MeasurementSet same{.source = {}, .points = {}};
    std::vector<InvertedImpact> inverted;
    for (std::size_t i = 0; i < 20; ++i) {
        const double v = 1 + 0.1 * static_cast<double>(i);
        same.points.push_back({.velocity = v, .rebound = 0.5 * v, .tangential = 0.1 * v});
        inverted.push_back(
            {.index = i, .velocity = v, .restitution = 0.5, .damping = 1e-3 * std::exp(noise(random))});
    }
    CHECK_FALSE(compare_angles(same, inverted, DampingSmoothing::of(inverted)));
}

TEST_CASE("a word for a capture in a column of remarks counts beside an empty reading") {
    for (const char* heading : {"Bemerkung", "Befund", "Status", "Verbleib", "Kommentar", "remark",
                                "Comments", "note", "Remarque", "Beobachtung:"})
        for (const char* word :
             {"haftet", "Haftet!", "stick", "stuck", "captured", "(captured)", "bleibt haften"}) {
            CAPTURE(heading);
            CAPTURE(word);
            const MeasurementSet set = read_measurements(
                "v_ein [m/s];v_aus [m/s];" + std::string(heading) + "\n1,4;;" + word + "\n2,1;0,44;\n",
                "t.csv");
            CHECK(set.captures() == 1);
            CHECK(set.unknown == 0);
            CHECK(set.points.front().outcome == NotedOutcome::capture);
            CHECK_MESSAGE(warnings_of(set).find("tells the outcome in line 2") != std::string::npos,
                          warnings_of(set));
        }
}

TEST_CASE("an outcome of capture beside a reading: noise explains it, or the line is refused") {
    const std::string heading = "v_in [m/s],v_r [m/s],outcome,u(v_in) [m/s],u(v_r) [m/s]\n";
    const MeasurementSet set = read_measurements(heading + "1.4,0.05,capture,0.02,0.02\n", "t.csv");
    CHECK(set.captures() == 1);
    CHECK(set.points.front().rebound == 0.0);
    CHECK_THROWS_WITH_AS(
        read_measurements(heading + "1.4,0.5,capture,0.02,0.02\n", "t.csv"),
        "t.csv: line 2: the outcome tells of a capture, and the rebound velocity is 0.5 m/s; "
        "allowed: one of them",
        InputError);
}

TEST_CASE(
    "a remark that is not just such a word leaves the impact unknown, and one line says where and what to "
    "do") {
    for (const char* text :
         {"haftet nicht", "Partikel haftet an der Wand", "stuck?", "not captured", "ok", "c"}) {
        CAPTURE(text);
        const MeasurementSet set = read_measurements(
            "v_ein [m/s];v_aus [m/s];Bemerkung\n1,4;;" + std::string(text) + "\n2,1;0,44;\n", "t.csv");
        CHECK(set.captures() == 0);
        CHECK(set.unknown == 1);
        const std::string told = warnings_of(set);
        CHECK_MESSAGE(told.find("1 impact of unknown outcome is left out (line 2)") != std::string::npos,
                      told);
        if (std::string(text).size() > 1)
            for (const std::string& part : {"\"" + std::string(text) + "\" in column \"Bemerkung\"",
                                            std::string("or 0 in column \"v_aus\"")})
                CHECK_MESSAGE(told.find(part) != std::string::npos, told);
        CHECK(std::count(told.begin(), told.end(), '\n') == 1);
    }
    const MeasurementSet set =
        read_measurements("v_in [m/s],v_r [m/s],seen\n1.4,,stuck\n1.5,,\n1.6,,Stuck\n2.1,0.4,\n", "t.csv");
    CHECK(set.unknown == 3);
    CHECK_MESSAGE(
        warnings_of(set).find("3 impacts of unknown outcome are left out (lines 2, 3, 4), as column "
                              "\"seen\", which tells of captures in lines 2, 4, is read only if its "
                              "heading is \"outcome\"") != std::string::npos,
        warnings_of(set));
}

TEST_CASE("a remark beside a reading counts where both agree, and is refused where they do not") {
    const auto read = [](const std::string& row) {
        return read_measurements("v_in [m/s],v_r [m/s],comment\n" + row + "\n2.1,0.4,\n", "t.csv");
    };
    CHECK(read("1.4,0,stuck").captures() == 1);
    CHECK(read("1.4,0.01,stuck").captures() == 1);
    CHECK(read("1.4,0,bounced").captures() == 0);  // a rebound too slow for its reading
    CHECK(read("1.4,,bounced").unknown == 1);      // how fast is not known
    CHECK(read("1.4,0.3,good shot").rebounds() == 2);
    CHECK_THROWS_WITH_AS(
        static_cast<void>(read("1.4,0.33,stuck")),
        doctest::Contains("line 2: the remark tells of a capture, and the rebound velocity is "
                          "0.33 m/s; allowed: one of them"),
        InputError);
    // A column of outcomes is what counts where there is one.
    const MeasurementSet set = read_measurements(
        "v_in [m/s],v_r [m/s],outcome,comment\n1.4,,unknown,stuck\n1.5,,,stuck\n2,0.4,,\n", "t.csv");
    CHECK(set.unknown == 1);
    CHECK(set.captures() == 1);
}

TEST_CASE("uncertainties of impacts that are multiples of standard ones are read as such") {
    const auto table = [](const std::string& uncertainty, const char* number) {
        return "v_in [m/s];" + uncertainty + ";v_r [m/s]\n2,1;" + number + ";0,4\n2,2;" + number + ";0,5\n";
    };
    for (const char* heading :
         {"Unsicherheit (2s)", "Unsicherheit (2 s) [m/s]", "u(v_in) (2 sigma) [m/s]", "2 sigma", "2σ [m/s]",
          "U (k=2)", "U(v_in), k = 2 [m/s]", "u(v_in) [m/s] (k=2,0)", "±2s", "Fehler 2s", "2-sigma error",
          "v_in ±2σ [m/s]", "expanded uncertainty (k=2)", "2 SD", "Unsicherheit (95,45 %)"}) {
        CAPTURE(heading);
        CHECK(noise_of_incident(table(heading, "0,06")) == doctest::Approx(0.03).epsilon(1e-12));
        const std::string told = warnings_of(read_measurements(table(heading, "0,06"), "t.csv"));
        CHECK_MESSAGE(told.find("divided by 2") != std::string::npos, told);
    }
    for (const char* heading : {"Unsicherheit (95 %)", "U95", "error (95%) [m/s]", "± 95 % CI"})
        CHECK(noise_of_incident(table(heading, "0,06")) == doctest::Approx(0.06 / 1.95996).epsilon(1e-4));
    for (const char* heading :
         {"Unsicherheit", "Fehler (1s)", "u(v_in) [m/s]", "u(v_in)", "1 sigma", "σ", "±", "s.u."})
        CHECK(noise_of_incident(table(heading, "0,06")) == doctest::Approx(0.06).epsilon(1e-12));
    CHECK(noise_of_incident(table("u(v_in) [mm/s] (2s)", "60")) == doctest::Approx(0.03).epsilon(1e-12));
    CHECK(noise_of_incident("v_in ± 2s [m/s];v_r [m/s]\n2,1 ± 0,06;0,4\n2,2 ± 0,06;0,5\n") ==
          doctest::Approx(0.03).epsilon(1e-12));
    CHECK(noise_of_incident("v_in ± u [m/s];v_r [m/s]\n2,1 ± 0,06;0,4\n2,2 ± 0,06;0,5\n") ==
          doctest::Approx(0.06).epsilon(1e-12));
}

TEST_CASE("an uncertainty without a quantity is that of the column before it, in its unit") {
    CHECK(noise_of_rebound("v_in [m/s],u,v_r [mm/s],Fehler\n2.1,0.03,400,20\n2.2,0.03,500,20\n") ==
          doctest::Approx(0.02).epsilon(1e-12));
    const std::string two = "v_in [m/s],u,v_r [m/s],u\n2.1,0.03,0.4,0.02\n2.2,0.03,0.5,0.02\n";
    CHECK(noise_of_incident(two) == doctest::Approx(0.03).epsilon(1e-12));
    CHECK(noise_of_rebound(two) == doctest::Approx(0.02).epsilon(1e-12));
}

TEST_CASE("an uncertainty is in the unit of its column, in its own, or in per cent of the velocity") {
    for (const auto& [heading, cell] :
         {std::pair{"u(e_n)", "4"}, {"u(e_n) [%]", "4"}, {"u(e_n) [1]", "0.04"}}) {
        CAPTURE(heading);
        CHECK(noise_of_rebound("v_in [m/s];u(v_in) [m/s];e_n [%];" + std::string(heading) + "\n2;0.1;50;" +
                               cell + "\n") == doctest::Approx(std::hypot(0.5 * 0.1, 2 * 0.04)));
    }
    const std::string slow = "v_in [mm/s];u(v_in);v_r [mm/s];u(v_r)\n2000;30;500;20\n";
    CHECK(noise_of_incident(slow) == doctest::Approx(0.03));
    CHECK(contains(warnings_of(read_measurements(slow, "t.csv")),
                   "column \"u(v_in)\" has no unit: taken in that of column \"v_in\""));
    CHECK(noise_of_incident("v_in [m/s];u(v_in) [%];v_r [m/s]\n2;3;0.5\n") == doctest::Approx(0.06));
    CHECK(noise_of_incident("v_in [m/s];u(v_in) [%];v_r [m/s];u(v_r) [%]\n2;3;0;2\n") ==
          doctest::Approx(0.06));
    CHECK(contains(
        input_error_of([] { return read_measurements("v_in;u(v_in);e_n;u(e_n)\n2;0.1;0.5;4\n", "t.csv"); }),
        "\"4\" in column \"u(e_n)\" may be 4 % or a fraction whose decimal mark was lost"));
    CHECK(read_measurements("v_in;v_r;u(v_r)\n2;0.5;0.02\n", "t.csv").rebound_alone_uncertain);
    for (const auto& [table, alone] : {std::pair{"v_in;e_n;u(e_n)\n2;0.5;0.02\n", "e_n"},
                                       {"v_in;u(v_in);v_r\n2;0.1;0.5\n", "v_in"},
                                       {"v_in;u(v_in);v_r;u(v_r)\n2;0.1;0.5;0.02\n", ""}}) {
        const MeasurementSet set = read_measurements(table, "t.csv");
        CHECK_FALSE(set.rebound_alone_uncertain);
        CHECK(contains(warnings_of(set), "uncertainties of \"" + std::string(alone) +
                                             "\" alone are stated: v_in and v_r are taken as equally "
                                             "uncertain") == (*alone != '\0'));
    }
}

TEST_CASE("a per cent sign beside a word for an uncertainty is its unit, wherever it stands") {
    for (const char* heading : {"error [%]", "% error", "%err", "error %", "Fehler in %"}) {
        CAPTURE(heading);
        CHECK(noise_of_incident("v_in [m/s];" + std::string(heading) + ";v_r [m/s]\n2;3;0.5\n") ==
              doctest::Approx(0.06));
    }
}

TEST_CASE("uncertainties of all readings or of none; a reading of 0 has the greatest of the others") {
    const auto table = [](const std::string& capture) {
        return "v_in [m/s];v_r [m/s]\n" + capture +
               "\n1.9 \u00b1 0.05;0.4 \u00b1 0.02\n2.4 \u00b1 0.05;0.7 \u00b1 0.03\n";
    };
    CHECK(noise_of_rebound(table("0.9 \u00b1 0.05;0")) == doctest::Approx(0.03));
    const std::string told = warnings_of(read_measurements(table("0.9 \u00b1 0.05;0"), "t.csv"));
    CHECK_MESSAGE(told ==
                      "readings of 0 without an uncertainty (line 2) are given the greatest of the others, "
                      "0.03 m/s\n",
                  told);
    const std::string columns = "v_in [m/s];u(v_in) [m/s];v_r [m/s];u(v_r) [m/s];outcome\n";
    CHECK(noise_of_rebound(columns + "0.9;0.05;0;-;\n1.9;0.05;0.4;0.02;\n") == doctest::Approx(0.02));
    CHECK(read_measurements(columns + "0.9;0.05;;-;stuck\n1.9;0.05;0.4;0.02;\n", "t.csv").captures() == 1);
    CHECK(noise_of_rebound("v_in;e_n\n2 \u00b1 0.1;0\n3 \u00b1 0.1;0.5 \u00b1 0.04\n") ==
          doctest::Approx(0.08));
    for (const auto& [row, says] :
         {std::pair{"0.9 \u00b1 0.05;0.1", "line 2: only some measurements of \"v_r\" have an uncertainty"},
          {"0.9;0.1 \u00b1 0.02", "line 2: only some measurements of \"v_in\" have an uncertainty"},
          {"0.9 \u00b1 0.05;n.d.",
           "may be a capture, or an unknown outcome; allowed: a finite number; 0 for a "
           "capture; an empty cell for an unknown outcome"}})
        CHECK_MESSAGE(
            contains(input_error_of([&, &of = row] { return read_measurements(table(of), "t.csv"); }), says),
            row);
    for (const char* unknown : {"n.a.", "\u2014", "k. A.", "NULL"})
        CHECK(read_measurements(table("0.9 \u00b1 0.05;" + std::string(unknown)), "t.csv").unknown == 1);
}

TEST_CASE("a per cent of a reading of 0 is no uncertainty of it, and neither is that of v_in") {
    const auto table = [](const char* unit, const char* captured, const char* of_captured) {
        return fmt::format(
            "v_in [m/s];u(v_in) [%];v_r [m/s];u(v_r) [{}]\n0.9;2;{};{}\n1.9;2;0.4;5\n2.4;2;0.6;5\n", unit,
            captured, of_captured);
    };
    for (const auto& [text, greatest] : {std::pair{table("%", "0", "5"), 0.03},
                                         {table("%", "stuck", "5"), 0.03},
                                         {table("mm/s", "stuck", "-"), 0.005}}) {
        CAPTURE(text);
        CHECK(noise_of_rebound(text) == doctest::Approx(greatest));
        CHECK(
            contains(warnings_of(read_measurements(text, "t.csv")),
                     "readings of 0 without an uncertainty (line 2) are given the greatest of the others, " +
                         shortest(greatest) + " m/s"));
    }
}

TEST_CASE("readings below zero that noise around zero does not explain are refused, others are counted") {
    const std::string stated = "v_in [m/s];v_r [m/s];outcome;u(v_in) [m/s];u(v_r) [m/s]\n";
    const auto rows = [](const std::vector<double>& rebounds, const std::string& rest) {
        std::string text;
        double velocity = 0.7;
        for (const double rebound : rebounds)
            text += fmt::format("{:.1f};{}{}\n", velocity += 0.2, rebound, rest);
        return text;
    };
    for (const auto& [rebounds, says] :
         {std::pair{std::vector{0.0, 0.0, -0.05, -0.1, -0.14, -0.18, -0.21},
                    "line 4: 5 readings of column \"v_r\" below zero, 0 above: they may be rebounds with the "
                    "sign of their direction, or noise of impacts that read 0; allowed: magnitudes for "
                    "rebounds; 0 for a capture"},
          {{0.0, -0.05, -0.1, 0.02, -0.16}, "line 3: 3 readings of column \"v_r\" below zero, 1 above"}})
        for (const auto& [heading, rest] : {std::pair{stated, ";;0.05;0.05"},
                                            {stated, ";rebound;0.05;0.05"},
                                            {std::string("v_in [m/s];v_r [m/s]\n"), ""}}) {
            const std::string text = heading + rows(rebounds, rest);
            CAPTURE(text);
            CHECK(contains(input_error_of([&] { return read_measurements(text, "t.csv"); }), says));
        }
    const MeasurementSet noisy =
        read_measurements(stated + rows({-0.04, 0.03, -0.09, -0.01, 0.4}, ";;0.05;0.05"), "t.csv");
    CHECK(noisy.captures() == 3);
    CHECK(contains(warnings_of(noisy), "3 readings of column \"v_r\" below zero (lines 2, 4, 5) count as 0"));
    CHECK(contains(warnings_of(read_measurements("v_in;v_r\n0.9;-0.01\n1.4;0.2\n", "t.csv")),
                   "1 reading of column \"v_r\" below zero (line 2) counts as 0"));
    CHECK(read_measurements(stated + rows({-0.04, -0.03, -0.09}, ";capture;0.05;0.05"), "t.csv").captures() ==
          3);
    const auto told = [&](const std::vector<double>& rebounds, const std::string& outcome) {
        return warnings_of(read_measurements(stated + rows(rebounds, ";" + outcome + ";0.05;0.05"), "t.csv"));
    };
    CHECK(contains(told({0, 0.09, 0.02, 0.4}, ""),
                   "2 of 4 impacts count as rebounds although noise explains their v_r"));
    CHECK_FALSE(contains(told({0, 0.11, 0.2, 0.4}, ""), "count as rebounds although"));
    CHECK_FALSE(contains(told({0.09, 0.02, 0.4}, "rebound"), "count as rebounds although"));
    CHECK(contains(warnings_of(read_measurements("v_in;v_r\n0.9;-0.03\n1.1;0.02\n1.4;0.2\n", "t.csv")),
                   "1 of 3 impacts count as rebounds although"));
}

TEST_CASE("impacts that a table holds twice are refused, few equal ones are not") {
    const std::string heading = "v_in [m/s];v_r [m/s];film\n";
    const std::vector<std::string> block{"1.21;0.113;\n", "2.16;0.476;\n", "0.64;0;\n",
                                         "1.24;0.118;\n", "2.73;0.69;\n",  "1.95;0.36;\n"};
    std::string once;
    std::string sorted;
    for (const std::string& row : block) {
        once += row;
        sorted += row + row;
    }
    const auto refusal = [&](const std::string& rows) {
        return input_error_of([&] { return read_measurements(heading + rows, "t.csv"); });
    };
    for (const std::string& rows : {once + once, once + "2.9;0.77;\n" + once, once + once + once})
        CHECK_MESSAGE(contains(refusal(rows),
                               "repeat those from line 2 to 7: they may be there twice, or be other "
                               "measurements; allowed: each row once; or, if they are other "
                               "measurements, a first column that numbers all rows"),
                      refusal(rows));
    std::string remarked;  // cells that are not the numbers may differ
    for (const std::string& row : block) remarked += row.substr(0, row.size() - 1) + "again\n";
    CHECK(contains(refusal(once + remarked), "repeat those from line 2 to 7"));
    CHECK(contains(
        refusal(sorted),
        "line 3: the row repeats that of line 2, and 5 of 12 rows repeat others: they may be there twice"));
    std::string spread;  // velocities on no common step, each impact twice
    for (int i = 0; i < 17; ++i)
        for (int copy = 0; copy < 2; ++copy)
            spread += fmt::format("{:.3f};{:.3f};\n", 1.16 * std::pow(1.12, i), 0.05 + 0.19 * i);
    CHECK(contains(refusal(spread), "17 of 34 rows repeat others: they may be there twice"));
    CHECK(contains(warnings_of(read_measurements(heading + once + block[0] + block[4] + block[3], "t.csv")),
                   "line 8: the row repeats that of line 2, and 3 of 9 rows repeat others"));
    std::string coarse;
    std::string nominal;
    std::string numbered;
    for (int i = 0; i < 24; ++i) {
        coarse += fmt::format("{};0.{};\n", 1 + i % 6, 1 + i % 6);
        nominal += fmt::format("1.5;0.{};\n", 31 + i % 4);
        numbered += fmt::format("{};{}", i + 1, block[static_cast<std::size_t>(i) % block.size()]);
    }
    for (const std::string& rows : {coarse, nominal})
        CHECK_FALSE(contains(warnings_of(read_measurements(heading + rows, "t.csv")), "repeat"));
    CHECK(read_measurements("Nr;" + heading + numbered, "t.csv").points.size() == 24);
}

TEST_CASE("one uncertainty in the heading, and a correlation without uncertainties, are refused") {
    for (const auto& [heading, says] :
         {std::pair{"v_in \u00b1 0.03 [m/s];v_r [m/s]", "\"v_in \u00b1 0.03\" states one uncertainty, 0.03"},
          {"v_in +/- 0.03 [m/s];v_r [m/s]", "states one uncertainty, 0.03"},
          {"v_in [m/s];v_r (\u00b10.02) [m/s]", "states one uncertainty, 0.02"},
          {"v_in [m/s];e_n \u00b1 0.02", "states one uncertainty, 0.02"},
          {"v_in [m/s];angle to the surface [deg];v_rn [m/s]", "angles from the wall, which are not read"},
          {"v_in [m/s];e_n;correlation", "may be that of v_in with v_r, or of v_in with e_n"},
          {"v_in [m/s];v_r [m/s];correlation",
           "the correlation of two velocities is that of their uncertainties"}}) {
        const std::string table = std::string(heading) + "\n2;0.5;0.5\n";
        CHECK_MESSAGE(contains(input_error_of([&] { return read_measurements(table, "t.csv"); }), says),
                      table);
    }
}

TEST_CASE("uncertainties of unclear coverage are not read, and one line says why and how to write them") {
    for (const auto& [name, why] :
         {std::pair{"95 % CI", "half-widths"}, std::pair{"Konfidenzintervall (95 %)", "half-widths"},
          std::pair{"expanded uncertainty", "needs its coverage factor"},
          std::pair{"erweiterte Unsicherheit", "needs its coverage factor"},
          std::pair{"Unsicherheit (80 %)", "not one that is known"}}) {
        const char* heading = name;
        CAPTURE(heading);
        const MeasurementSet set = read_measurements(
            "v_in [m/s];v_r [m/s];" + std::string(heading) + "\n2,1;0,4;0,06\n2,2;0,5;0,06\n", "t.csv");
        CHECK_FALSE(set.has_noise());
        const std::string told = warnings_of(set);
        CHECK_MESSAGE(told.find("not read") != std::string::npos, told);
        CHECK_MESSAGE(told.find(why) != std::string::npos, told);
    }
}

TEST_CASE("units behind \u00b1, counts in brackets, and copies with units in their cells") {
    for (const char* heading : {"v_in \u00b1 error, cm/s", "v_in \u00b1 s / (cm/s)", "v_in \u00b1 SD in cm/s",
                                "v_in \u00b1 U(k=2), cm/s"}) {
        const MeasurementSet set =
            read_measurements(std::string(heading) + ";v_r [cm/s]\n200 \u00b1 2;100 \u00b1 2\n", "t.csv");
        CHECK_MESSAGE(set.points.at(0).velocity == doctest::Approx(2), heading);
    }
    for (const char* count : {"(N)", "(#)", "(n)"}) {
        const std::string mark = count;
        const MeasurementSet set = read_measurements(
            "v_in " + mark + " [m/s];v_r " + mark + " [m/s]\n1.10 (3);0.00 (3)\n1.35 (5);0.20 (5)\n",
            "t.csv");
        CHECK_MESSAGE(!set.has_noise(), count);
        CHECK(contains(warnings_of(set), "not read"));
    }
    for (const char* heading : {"u(v_in) %", "v_in err %", "SD(v_in) %", "u(v_in) [%]"}) {
        const MeasurementSet set =
            read_measurements(std::string("v_in [m/s];v_r [m/s];") + heading + "\n2;1;2\n3;1.5;2\n", "t.csv");
        CHECK_MESSAGE(std::sqrt(set.points.at(0).noise.value().incident) == doctest::Approx(0.04), heading);
    }
    for (const char* heading : {"2s (cm/s)", "2 SD (cm/s)", "k=2 (cm/s)"}) {
        const MeasurementSet set =
            read_measurements(std::string("v_in (m/s);") + heading + ";v_r (m/s)\n2;4;1\n3;4;1.5\n", "t.csv");
        CHECK_MESSAGE(std::sqrt(set.points.at(0).noise.value().incident) == doctest::Approx(0.02), heading);
    }
    for (const char* heading : {"v_i,n [m/s]", "normal impact velocity [m/s]"}) {
        const MeasurementSet set =
            read_measurements(std::string(heading) + ";v_r,n [m/s];angle [deg]\n2;1;60\n3;1.5;60\n", "t.csv");
        CHECK_MESSAGE(set.points.at(0).velocity == doctest::Approx(2), heading);
    }
    for (const char* heading : {"2s (%)", "2\u03c3 %"}) {
        const MeasurementSet set =
            read_measurements(std::string("v_in [m/s];") + heading + ";v_r [m/s]\n2;2;1\n3;2;1.5\n", "t.csv");
        CHECK_MESSAGE(std::sqrt(set.points.at(0).noise.value().incident) == doctest::Approx(0.02), heading);
    }
    std::string rows;
    for (const char* pair :
         {"1.78 m/s;0.52 m/s", "2.31 m/s;0.84 m/s", "2.95 m/s;1.17 m/s", "3.42 m/s;1.46 m/s"})
        rows += std::string(pair) + "\n";
    const std::string copies = std::string("1.780 m/s;0.520 m/s\n2.310 m/s;0.840 m/s\n") +
                               "2.950 m/s;1.170 m/s\n3.420 m/s;1.460 m/s\n";
    CHECK(contains(
        input_error_of([&] { static_cast<void>(read_measurements("v_in;v_r\n" + rows + copies, "t.csv")); }),
        "repeat those"));
}

TEST_CASE("a restitution with a per cent sign beside one without it, and means of pairs, are refused") {
    const auto refused = [](const std::string& table) {
        return input_error_of([&] { static_cast<void>(read_measurements(table, "t.csv")); });
    };
    CHECK(contains(refused("v_in [m/s];e_n\n2;6 %\n3;0.9\n"), "with a per cent sign and without"));
    CHECK(refused("v_in [m/s];e_n\n2;6 %\n3;9 %\n1;0\n").empty());
    const std::string heading = "v_in [m/s];v_r [m/s]\n";
    CHECK(contains(refused(heading + "1.11;0.31\n1.35;0.42\n1.23;0.365\n2.04;0.91\n2.38;0.98\n2.21;0.945\n"
                                     "3.17;1.52\n3.35;1.66\n3.26;1.59\n"),
                   "the means"));
    CHECK(refused(heading + "1.11;0.31\n1.35;0.42\n1.27;0.365\n2.04;0.91\n2.38;0.98\n2.21;0.945\n"
                            "3.17;1.52\n3.35;1.66\n3.26;1.59\n")
              .empty());
}

TEST_CASE("no text in a table of impacts vanishes") {
    for (const Cells& rows :
         {Cells{{"v_in [m/s]", "v_r [m/s]"}, {"1.1", "0"}, {"1.35", "0.2"}, {"1.62", "0.41"}},
          Cells{{"No", "v_in [m/s]", "v_r [m/s]"},
                {"1", "1.1", "0"},
                {"2", "1.35", "0.2"},
                {"3", "1.62", "0.41"}},
          Cells{{"v_in [m/s]", "esd", "v_r [m/s]", "esd"},
                {"1.1", "0.02", "0", "0.02"},
                {"1.35", "0.02", "0.2", "0.02"}},
          Cells{{"v_in [m/s]", "v_r [m/s]", "outcome"}, {"1.1", "", "capture"}, {"1.35", "0.2", "rebound"}},
          Cells{{"v_in [m/s]", "e_n", "Remark"}, {"1.1", "0", ""}, {"1.35", "0.2", ""}},
          Cells{{"Sample", "v_in [m/s]", "v_r [m/s]"}, {"A", "1.1", "0"}, {"A", "1.35", "0.2"}}})
        check_marked(rows, [](const std::string& table) {
            const MeasurementSet set = read_measurements(table, "t.csv");
            return warnings_of(set) + set.reading + set.sample;
        });
}

TEST_CASE("what each column of impacts is taken as is stated") {
    const auto reading = [](const std::string& table) { return read_measurements(table, "t.csv").reading; };
    CHECK(reading("No;v1 [mm/s];U(k=2) [mm/s];v2 [mm/s];outcome\n1;2000;40;400;\n2;500;40;0;capture\n") ==
          "2 impacts, 1 captured, v_in 0.5 to 2 m/s; v_in [mm/s]: \"v1 [mm/s]\"; standard uncertainties of "
          "v_in "
          "[mm/s]: \"U(k=2) [mm/s]\" divided by 2; v_r [mm/s]: \"v2 [mm/s]\"; outcomes: \"outcome\"");
    CHECK(reading("v_in [m/s];e_n [%];angle [deg]\n2;40;10\n3;50;20\n") ==
          "2 impacts, 0 captured, v_in 1.97 to 2.819 m/s; v_in [m/s]: \"v_in [m/s]\"; e_n [%]: \"e_n [%]\"; "
          "angles from the normal: \"angle [deg]\"; v_in is that of the sphere at this angle");
    CHECK(contains(
        reading("v_in [m/s];v_r \u00b1 2s [m/s]\n2(1);1.0 \u00b1 0.1\n"),
        "standard uncertainties in cells of v_in [m/s]: \"v_in [m/s]\"; v_r [m/s]: \"v_r \u00b1 2s [m/s]\"; "
        "standard uncertainties in cells of v_r [m/s]: \"v_r \u00b1 2s [m/s]\" divided by 2"));
    CHECK(contains(reading("v_in [m/s];v_r [m/s];e_n\n2;1;0.5\n"),
                   "e_n, compared with v_r over v_in: \"e_n\""));
}

TEST_CASE("uncertainties that are no standard ones beside a velocity are not read") {
    for (const char* heading : {"U_v_in [m/s]", "v_in U [m/s]", "U(v_in) [m/s]"}) {
        CAPTURE(heading);
        const MeasurementSet set = read_measurements(
            "v_in [m/s];" + std::string(heading) + ";v_r [m/s]\n2;0.1;0.4\n3;0.1;0.5\n", "t.csv");
        CHECK_FALSE(set.has_noise());
        CHECK(contains(warnings_of(set), "needs its coverage factor"));
    }
    for (const char* word : {"CI", "U", "max. error", "IQR", "RSD %", "%", "error %"}) {
        CAPTURE(word);
        const std::string name = word;
        const MeasurementSet set = read_measurements("v_in \u00b1 " + name + " [m/s];v_r \u00b1 " + name +
                                                         " [m/s]\n2 \u00b1 0.1;0.4 \u00b1 0.1\n"
                                                         "3 \u00b1 0.1;0.5 \u00b1 0.1\n",
                                                     "t.csv");
        CHECK_FALSE(set.has_noise());
        CHECK(contains(warnings_of(set), "names no standard uncertainty"));
    }
}

TEST_CASE("impacts of a sample of another name are told") {
    const auto remark = [](const std::string& column, const std::string& sheet, const std::string& sample) {
        MeasurementSet set = read_measurements(
            "sample;v_in [m/s];v_r [m/s]\n" + column + ";2;0.4\n" + column + ";3;0.5\n", "t.csv");
        set.sheet = sheet;
        const auto other = other_sample_finding(set, sample);
        return other ? other->text : std::string();
    };
    CHECK(remark("FA8", "", "FA 7") == "the impacts are those of the sample \"FA8\", as its column says");
    CHECK(remark("FA8", "", "FA 8").empty());
    CHECK(remark("FA 8 (96 um)", "", "FA8").empty());
    CHECK(remark("FA >45 um, run 1.", "", "FA >45 um").empty());
    CHECK(contains(remark("FA80", "", "FA8"), "FA80"));
    CHECK(contains(remark("FA >45 um", "", "FA <45 um"), "FA >45"));
    CHECK(contains(remark("FA-1.1", "", "FA-11"), "FA-1.1"));
    CHECK(remark("", "FA8 104um", "FA 7") == "the impacts are those of the sheet \"FA8 104um\"");
    CHECK(remark("", "Messung 1", "FA 7").empty());
    CHECK(remark("", "FA7 impacts", "FA 7").empty());
}

TEST_CASE("the usual headings of impacts are known, in English, German and French") {
    for (const char* heading :
         {"v_in [m/s];v_r [m/s]",
          "Einfallsgeschwindigkeit [m/s];Rückprall [m/s]",
          "Aufprall [m/s];Rueckprall [m/s]",
          "Einfallsgeschwindigkeit v_ein in m/s;R\u00fcckprallgeschwindigkeit, v_aus in m/s",
          "Einfall (m/s);Abprall (m/s)",
          "Anfluggeschwindigkeit;v_Rückprall",
          "impact speed [m/s];rebound speed [m/s]",
          "incoming velocity;outgoing velocity",
          "v_impact;v_rebound",
          "vitesse d'impact;rebond",
          "U_in [m/s];U_out [m/s]",
          "v_0 [m/s];v_1 [m/s]",
          "v\u1d62 [m/s];v\u1d63 [m/s]",
          "v_{in} [ms-1];v_r [ms\u207b\u00b9]",
          "vel in;vel out",
          "pre-impact velocity;post-impact velocity",
          "\"v_in\n[m/s]\";v_r",
          "v vorher;v nachher",
          "v vor (m/s);v nach (m/s)",
          "Aufprallgeschw. [m/s];Abprallgeschw. [m/s]",
          "Aufprallgeschwindigkeit in m/s;R\u00fcckprallgeschw. in m/s",
          "vitesse incidente;vitesse de rebond",
          "velocit\u00e0 d'impatto [m/s];velocit\u00e0 di rimbalzo [m/s]",
          "v_in (in m/s);v_r (in m/s)",
          "v_in in ms-1;v_r in ms^-1",
          "velocidad de impacto (m/s);velocidad de rebote (m/s)"}) {
        CAPTURE(heading);
        const MeasurementSet set = read_measurements(std::string(heading) + "\n2,1;0,4\n", "t.csv");
        REQUIRE(set.points.size() == 1);
        CHECK(set.points.front().velocity == 2.1);
        CHECK(set.points.front().rebound == 0.4);
    }
    for (const char* heading : {"Stoßkoeffizient", "Restitutionszahl", "restitution coefficient",
                                "coefficient of normal restitution"}) {
        CAPTURE(heading);
        const MeasurementSet set =
            read_measurements("v_in [m/s];" + std::string(heading) + "\n2;0,5\n", "t.csv");
        REQUIRE(set.points.size() == 1);
        CHECK(set.points.front().rebound == doctest::Approx(1.0));
    }
}

using namespace ashimpact::test;

TEST_CASE("columns of 0 and 1 are read or refused, however their numbers are written") {
    for (const char* one : {"1", "1.0", "1,0", "1.00"})
        for (const char* zero : {"0", "0.0", "0,0"}) {
            CAPTURE(one);
            CAPTURE(zero);
            const auto table = [&](const std::string& heading) {
                return fmt::format("v_in [m/s];v_r [m/s];{0}\n1.2;0;{1}\n2.1;0.9;{2}\n3.2;1.9;{2}\n", heading,
                                   one, zero);
            };
            for (const char* heading : {"captured", "stuck"})
                CHECK(read_measurements(table(heading), "t.csv").points[1].outcome == NotedOutcome::rebound);
            for (const char* heading : {"valid", "use", "exclude", "contact"})
                CHECK(contains(input_error_of([&] { return read_measurements(table(heading), "t.csv"); }),
                               "allowed"));
        }
    CHECK(read_measurements("v_in;v_r;quality\n1.2;0;0,95\n2.1;0.9;1,0\n", "t.csv").points.size() == 2);
}

TEST_CASE("readings of 0 beside slow rebounds may be clipped, which is said") {
    const auto said = [](const std::string& rows, const std::string& more = "") {
        return contains(warnings_of(read_measurements("v_in [m/s];v_r [m/s]" + more + "\n" + rows, "t.csv")),
                        "v_c is off to either side");
    };
    CHECK(said("0.5;0\n0.8;0.012\n0.9;0.2\n1.1;0.3\n"));  // of noise, hardly of a rebound
    CHECK(said("0.5;0\n0.8;0.03\n0.9;0\n1.1;0.3\n"));
    CHECK_FALSE(said("0.5;0\n0.7;0\n0.8;0.03\n1.1;0.3\n"));  // below all rebounds
    CHECK_FALSE(said("0.5;0\n0.8;0.4\n0.9;0\n1.1;0.6\n"));   // no rebound is near 0
    CHECK_FALSE(said("0.5;haftet\n0.8;0.03\n0.9;haftet\n1.1;0.3\n"));
    CHECK_FALSE(said("0.5;0;c\n0.8;0.03;r\n0.9;0;c\n1.1;0.3;r\n", ";outcome"));
    CHECK_FALSE(said("0.5;0;.1;.1\n0.8;0.03;.1;.1\n0.9;0;.1;.1\n1.1;0.3;.1;.1\n", ";u(v_in);u(v_r)"));
}

TEST_CASE("marks in a heading that are not understood are refused, another quantity is not read") {
    const auto refused = [](const std::string& heading) {
        return input_error_of([&] { return read_measurements(heading + "\n2;0.5;0.4\n", "t.csv"); });
    };
    CHECK(contains(refused("v_in;e*;x"), "column \"e*\" has the mark \"*\" behind its name"));
    CHECK(contains(refused("v_in [m/s];v_r' [m/s];x"), "has the mark \"'\""));
    for (const char* heading : {"v_in;v_r;E* [GPa]", "v_in;v_r;E [J]"})
        CHECK(read_measurements(std::string(heading) + "\n2;0.5;40\n", "t.csv").points.size() == 1);
    CHECK(read_measurements("v_in;e_n (in %)\n2;50\n", "t.csv").points[0].rebound == doctest::Approx(1));
}

TEST_CASE("two statements of one coverage count once, and others are no coverage") {
    for (const char* of : {"u({}) (95%, k=1.96) [m/s]", "2\u03c3 {} [m/s]", "u({}) [m/s] (k=2, 95 %)",
                           "u({}) (2 sigma, k=2) [m/s]"}) {
        CAPTURE(of);
        const std::string v_in = fmt::format(fmt::runtime(of), "v_in");
        const std::string v_r = fmt::format(fmt::runtime(of), "v_r");
        for (const std::string& heading :
             {"v_in [m/s];v_r [m/s];" + v_in + ";" + v_r, v_in + ";v_in [m/s];" + v_r + ";v_r [m/s]"}) {
            const bool first = heading.starts_with("v_in");
            const std::string table = heading + (first ? "\n2;0.5;0.2;0.2\n" : "\n0.2;2;0.2;0.5\n");
            CHECK(noise_of_incident(table) == doctest::Approx(0.1).epsilon(0.03));
        }
    }
    CHECK(contains(warnings_of(read_measurements("v_in;v_r;u(v_in) (95 %, k=3)\n2;0.5;0.2\n", "t.csv")),
                   "are not the same coverage"));
}

TEST_CASE("what is not determined is left out, and a number of a cell decides the mark of the other") {
    for (const char* cell : {"n.b.", "n. b.", "k.A.", "nicht bestimmt"}) {
        const MeasurementSet set =
            read_measurements(fmt::format("v_in;v_r;Ausgang\n2;0.5;bounce\n1;{};\n", cell), "t.csv");
        CHECK(set.points.size() == 1);
        CHECK(set.unknown == 1);
    }
    const MeasurementSet set = read_measurements("v_in;v_r\n2.5;1,091 \u00b1 0,020\n", "t.csv");
    CHECK(set.points[0].rebound == 1.091);
}

TEST_CASE("a heading of a square, a root or a difference is not the quantity") {
    for (const char* heading : {"e\u00b2", "COR^2", "\u221ae_n", "\u0394e_n", "v_r\u00b2", "v_r**2"}) {
        CAPTURE(heading);
        const std::string table = std::string("v_in [m/s];") + heading + "\n2;0,5\n";
        CHECK_THROWS_AS(static_cast<void>(read_measurements(table, "t.csv")), InputError);
    }
    CHECK(contains(
        input_error_of([] { static_cast<void>(read_measurements("v_in;\u221ae_n\n2;0,5\n", "t.csv")); }),
        "column \"\u221ae_n\" holds a root, not the quantity"));
    const MeasurementSet set = read_measurements("v_in;v_r;u\u00b2(v_in)\n2;0,5;0,1\n", "t.csv");
    CHECK_FALSE(set.has_noise());
    CHECK(contains(warnings_of(set), "\"u\u00b2(v_in)\" is not used"));
    CHECK(set.warnings.front().severity == Severity::remark);  // on the screen of `run`
}

TEST_CASE("v_r beside e_n is read where both agree") {
    const MeasurementSet set =
        read_measurements("v_in;v_r;e_n [%]\n2;0.5;25\n1.33;0.47;35.3\n0.7;0;0\n0.5;0;\n", "t.csv");
    CHECK(set.points.size() == 4);
    CHECK(set.points[1].rebound == 0.47);
    CHECK(contains(warnings_of(set), "column \"e_n\" only has to agree with column \"v_r\""));
    CHECK(contains(
        input_error_of([] { return read_measurements("v_in;v_r;e_n\n2;0.5;0.25\n2;0.9;0.55\n", "t.csv"); }),
        "line 3, cell 3: \"0.55\" in column \"e_n\" is not v_r over v_in, which is 0.45"));
}

TEST_CASE("restitutions in per cent that may be fractions are refused") {
    const auto refusal = [](const char* table) {
        return input_error_of([&] { static_cast<void>(read_measurements(table, "t.csv")); });
    };
    CHECK(contains(refusal("v_in [m/s],e_n [%]\n1.95,0.313\n1.5,0.3\n"), "no number is above 1"));
    CHECK(contains(refusal("v_in [m/s],e_n [%]\n1.95,31.3 %\n1.5,0.3\n"),
                   "numbers with a per cent sign and without"));
    CHECK(read_measurements("v_in [m/s],e_n [%]\n1.95,31.3 %\n1.5,0\n", "t.csv").points.size() == 2);
    CHECK(read_measurements("v_in [m/s],e_n [%]\n1.95,31.3\n1.5,0.3\n", "t.csv").points.size() == 2);
}

TEST_CASE("a quantity over its unit, and velocities before and after") {
    const MeasurementSet ratio = read_measurements("v vor/(mm/s);e_n/%\n2000;50,5\n", "t.csv");
    CHECK(ratio.points.front().velocity == 2.0);
    CHECK(ratio.points.front().rebound == doctest::Approx(1.01));
    CHECK(read_measurements("v1 [m/s];v2 [m/s]\n2;0,5\n", "t.csv").points.front().rebound == 0.5);
    CHECK(read_measurements("v vor [m/s];v nach [m/s]\n2;0,5\n", "t.csv").points.front().rebound == 0.5);
    for (const char* cell : {"57 %", "57%"}) {
        const std::string table = std::string("v_in [m/s];v_r [m/s]\n2;") + cell + "\n";
        CHECK(contains(input_error_of([&] { static_cast<void>(read_measurements(table, "t.csv")); }),
                       "is in per cent"));
    }
}

TEST_CASE("rows that sum up others are left out with a remark, and no row of a single impact is") {
    CHECK(contains(warnings_of(read_measurements("v_in,v_r\n1,0.5\n2,1.2\nMean,0.85\n", "t.csv")),
                   "line 4 is no impact and left out: \"Mean\""));
    const auto of = [](const std::string& rows) {
        return read_measurements("Nr.;v_in [m/s];v_r [m/s];side\n" + rows, "t.csv");
    };
    const MeasurementSet set = of("1;1,5;0,5;n\n2;2,5;0,9;s\nMittel;2,0;0,7;\ns;0,7;0,3;\n");
    CHECK(set.points.size() == 2);
    CHECK(contains(warnings_of(set), "line 4 is no impact and left out: \"Mittel\""));
    CHECK(contains(warnings_of(set), "line 5 is no impact and left out: \"s\""));
    CHECK(of("1;1,5;0,5;n\n2;2,5;0,9;n\n").points.size() == 2);
    CHECK(of("n;1,5;0,5;1\ns;2,5;0,9;2\n").points.size() == 2);
    CHECK(of("s;1,5;0,5;1\n2;2,5;0,9;2\n").points.size() == 2);
    CHECK(of("1;1,5;0,5;total\n2;2,5;0,9;partial\n3;2,6;0,9;total\n").points.size() == 3);
    CHECK(of("1;1,5;0,5;\n2;2,5;0,9;\n;2;0,7;Mittelwert\n").points.size() == 2);
}

TEST_CASE(
    "rows that alone have a label, which may call them means, are refused on either side of their groups") {
    const auto refusal = [](const std::string& first, const std::string& second, bool in_front) {
        const std::string means = first + ";1.56;0.2\n";
        const std::string other = second + ";1.95;0.37\n";
        const std::string rows = ";1.40;0.1\n;1.55;0.2\n;1.73;0.3\n;1.56;0.19\n";
        const std::string others = ";1.81;0.3\n;1.95;0.4\n;2.12;0.5\n;1.9;0.3\n";
        const std::string text = in_front ? means + rows + other + others : rows + means + others + other;
        return input_error_of(
            [&] { static_cast<void>(read_measurements("Reihe;v_in [m/s];v_r [m/s]\n" + text, "t.csv")); });
    };
    for (const bool in_front : {true, false})
        for (const auto& [first, second] : {std::pair{"MW 1", "MW 2"},
                                            {"avg 1", "avg 2"},
                                            {"\u00d8 Reihe 1", "\u00d8 Reihe 2"},
                                            {"Serie 1 Mittel", "Serie 2 Mittel"}})
            CHECK_MESSAGE(contains(refusal(first, second, in_front), "or the row sums up others"), first);
    for (const char* label : {"\u00d8", "MW", "M"})
        CHECK_MESSAGE(contains(refusal(label, label, true), "may be a name, or the row sums up others"),
                      label);
    for (const char* label : {"A", "M"})  // by their numbers
        CHECK(contains(refusal(label, "B", true), "the row holds the means of the rows below"));
}

TEST_CASE("statistics above or below the impacts are no impacts, short words among them either") {
    const std::string rows = "Ash;1,9;0,13\nAsh;3,04;0,36\nAsh;0,77;0\nAsh;2,2;0,19\nAsh;1,4;0,05\n";
    for (const std::string& words :
         {std::string("Mittelwert;1,86;0,15\nSD;0,8;0,14\nMin;0,77;0\nMax;3,04;0,36\n"),
          std::string("moyenne;1,86;0,15\nmini;0,77;0\nmaxi;3,04;0,36\n")})
        for (const std::string& text : {words + rows, rows + words}) {
            CAPTURE(text);
            CHECK(read_measurements("Probe;v_in [m/s];v_r [m/s]\n" + text, "t.csv").points.size() == 5);
        }
    CHECK(read_measurements("Probe;v_in [m/s];v_r [m/s]\nMax;1,3;0,1\n" + rows, "t.csv").points.size() == 6);
}

TEST_CASE("rows behind each group that a short word calls their mean are no impacts") {
    const auto table = [](const std::string& label, bool is_first, const std::string& group) {
        std::string text = is_first ? "group;v_in [m/s];v_r [m/s]\n" : "v_in [m/s];v_r [m/s];group\n";
        const auto add = [&](const std::string& name, const std::string& row) {
            text += is_first ? name + ";" + row + "\n" : row + ";" + name + "\n";
        };
        for (const char* row : {"1.40;0.1", "1.55;0.2", "1.73;0.3"}) add(group, row);
        add(label, "1.56;0.2");
        for (const char* row : {"1.81;0.3", "1.95;0.4", "2.12;0.5"}) add(group, row);
        add(label, "1.96;0.4");
        return text;
    };
    const auto refusal = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_measurements(text, "t.csv")); });
    };
    for (const bool is_first : {true, false})
        for (const char* group : {"A1", "1.5"}) {
            for (const char* label : {"MW", "Mw.", "avg", "AVG", "x\u0304", "gem.", "\u03a3/4", "MW 1.5 m/s",
                                      "SD", "Mean", "\u00d8"}) {
                CAPTURE(label);
                const MeasurementSet set = read_measurements(table(label, is_first, group), "t.csv");
                CHECK(set.points.size() == 6);
                for (const char* line : {"line 5", "line 9"})
                    CHECK(contains(warnings_of(set),
                                   std::string(line) + " is no impact and left out: \"" + label + "\""));
            }
            for (const char* label : {"M", "mu"})
                if (is_first || std::string_view(group) == "1.5")
                    CHECK(contains(refusal(table(label, is_first, group)),
                                   "may be a name, or the row sums up others"));
        }
    for (const char* label : {"Mittelwert A", "MW 1", "A1 mean", "A1 (mean)", "1 mean", "SD A", "A1_SD"}) {
        CAPTURE(label);
        CHECK(contains(refusal(table(label, true, "A")), "may be the name of an impact, or the row sums"));
        CHECK(contains(refusal(table(label, true, "A1")), "sum"));
    }
    CHECK(contains(
        refusal("v_in;v_r;;Statistik;Wert\n0.7;0;;;\n1.1;0.1;;Mittelwert;1.5\n1.6;0.3;;;\n2.1;0.5;;;\n"),
        "\"Mittelwert\" stands before 1.5: the row may sum up others"));
    CHECK(contains(refusal("v_in;v_r;outcome;remark\n1.1;0.1;rebound;\n0.5;0;rebound;haftet\n"),
                   "line 3: the outcome is a rebound, but a remark records a capture"));
    CHECK(read_measurements("run;v_in;v_r\nMW 1;1.4;0.1\nMW 2;1.6;0.2\nMW 3;1.8;0.3\n", "t.csv")
              .points.size() == 3);
    const MeasurementSet both = read_measurements(
        "group;v_in;v_r\nA;1.4;0.1\nA;1.6;0.2\nMW;1.5;0.15\nSD;0.14;0.07\nB;1.8;0.3\nB;2.0;0.4\n"
        "MW;1.9;0.35\nSD;0.14;0.07\n",
        "t.csv");
    CHECK(both.points.size() == 4);
    // Names of who measured, and of sides.
    for (const char* names : {"KM MW KM MW", "MW MW KM KM", "A L M N", "e n w s"}) {
        CAPTURE(names);
        std::string text = "name;v_in;v_r\n";
        std::istringstream all(names);
        for (std::string name, row = "1.4;0.1"; all >> name; row[2] = static_cast<char>(row[2] + 1))
            text += name + ";" + row + "\n";
        text += "KM;2.5;1.1\n";
        CHECK(read_measurements(text, "t.csv").points.size() == 5);
    }
}

TEST_CASE("a reading of 0 without a noted outcome is named where others have one") {
    const std::string noted = "v_in [m/s];v_r [m/s];outcome\n1.1;0;capture\n2;0.5;rebound\n";
    const std::string told = "of 0 without a noted outcome";
    CHECK(contains(warnings_of(read_measurements(noted + "0.9;0;\n", "t.csv")),
                   "1 reading " + told + " (line 4) counts as captured"));
    CHECK_FALSE(contains(warnings_of(read_measurements(noted, "t.csv")), told));
    CHECK_FALSE(contains(warnings_of(read_measurements("v_in;v_r\n0.9;0\n2;0.5\n", "t.csv")), told));
}

TEST_CASE("labels that are dates or runs number the rows") {
    for (const auto& labels : {std::array{"2024-03-01", "2024-03-02", "2024-03-04", "2024-03-05"},
                               std::array{"7-0", "7-1", "7-2", "7-3"}}) {
        std::string text = "run;v_in [m/s];v_r [m/s]\n";
        for (std::size_t i = 0; i < labels.size(); ++i)
            text += fmt::format("{};{};0.{}\n", labels[i], 1.21 + static_cast<double>(i), 3 + 2 * i);
        CHECK(read_measurements(text, "t.csv").points.size() == labels.size());
        CHECK(contains(input_error_of([&] { return read_measurements(text + "25 %;1.9;0.5\n", "t.csv"); }),
                       "the row may be a measurement, or sum up others"));
    }
}

TEST_CASE("a row among numbered ones that has another label is no impact, or is refused") {
    CHECK(read_measurements("#;v_in;v_r\n1;1;0.5\n2;2;1.2\n", "t.csv").points.size() == 2);
    const auto of = [](const std::string& label, const std::string& heading = "Nr.") {
        return read_measurements(
            heading + ";v_in [m/s];v_r [m/s]\n1;1,5;0,5\n2;2,5;0,9\n3;3,5;1,1\n" + label + ";2,5;0,83\n",
            "t.csv");
    };
    for (const char* label :
         {"Schnitt", "n=3", "\u00d8", "SD (n=3)", "Max", "x\u0304", "RSD %", "Mittel 1-3"})
        for (const char* heading : {"Nr.", ""}) {
            CAPTURE(label);
            const MeasurementSet set = of(label, heading);
            CHECK(set.points.size() == 3);
            CHECK(contains(warnings_of(set),
                           "line 5 is no impact and left out: \"" + std::string(label) + "\""));
        }
    CHECK(contains(
        input_error_of([&] { static_cast<void>(of("Serie")); }),
        "line 5, cell 1: \"Serie\" is in column \"Nr.\", where the others have a number: the "
        "row may be a measurement, or sum up others; allowed: its number, or a file without this row"));
    CHECK(contains(input_error_of([&] { static_cast<void>(of("")); }),
                   "the row has no number in column \"Nr.\""));
    CHECK(contains(input_error_of([&] { static_cast<void>(of("", "")); }),
                   "the row has no number in the column without a heading"));
    const std::string six =
        "Nr;v_in [m/s];v_r [m/s];outcome\n1;0.62;0;capture\n2;0.71;0;capture\n3;1.1;0.1;rebound\n"
        "4;1.5;0.3;rebound\n5;1.9;0.5;rebound\n6;2.4;0.8;rebound\n";
    CHECK(contains(
        input_error_of([&] { static_cast<void>(read_measurements(six + ";1.372;0.283;\n", "t.csv")); }),
        "the row has no number in column \"Nr\""));
    for (const char* label :
         {"Q1", "P90", "q25", "1. Quartil", "U (k=2)", "U95", "k=2", "MW1", "Mean1", "Nr. 1-12", "1 - 12"})
        CHECK_MESSAGE(
            contains(input_error_of([&] {
                         static_cast<void>(read_measurements(six + label + ";1.372;0.283;\n", "t.csv"));
                     }),
                     "sum up others"),
            label);
    const std::string days =
        "date;v_in;v_r\n2024-05-01;1.1;0.1\n2024-05-02;1.5;0.3\n2024-05-03;1.9;0.5\n"
        "2024-05-06;2.4;0.8\n";
    CHECK(contains(
        input_error_of([&] { static_cast<void>(read_measurements(days + "Q1;1.8;0.4\n", "t.csv")); }),
        "sum up others"));
    for (const char* label : {"4", "4a", "4*", "7", "#4"}) CHECK(of(label).points.size() == 4);
    for (const char* label : {"25%", "2s", "3\u03c3", "2 SD", "95 %", "1-3"})
        CHECK(contains(input_error_of([&] { static_cast<void>(of(label)); }), "sum up others"));
    // The number of a particle above its impacts, and a column of another quantity, are no numbers of
    // impacts.
    CHECK(read_measurements(
              "Particle;v_in [m/s];v_r [m/s]\n1;1,5;0,5\n;2,5;0,9\n2;1,5;0,5\n;2,5;0,9\n3;2,6;0,9\n", "t.csv")
              .points.size() == 5);
    CHECK(read_measurements("v_in [m/s];v_r [m/s];d [um]\n1,5;0,5;88\n2,5;0,9;91\n3,5;1,1;n.m.\n", "t.csv")
              .points.size() == 3);
    CHECK(contains(warnings_of(read_measurements("v_in [m/s];v_r [m/s];\n1,5;0,5;x\n", "t.csv")),
                   "column 3, which has no heading, is not used: \"x\""));
    CHECK(contains(warnings_of(read_measurements("v_in;v_r;;\n1.2;0.1;ab;\n1.5;0.4;;cd\n", "t.csv")),
                   "columns 3, 4, which have no heading, are not used: \"ab\", \"cd\""));
}

TEST_CASE("a row with an outcome is an impact; equal rows are equal with other digits, too") {
    const auto read = [](const std::string& rows) {
        return read_measurements("v_in [m/s];v_r [m/s];outcome\n" + rows, "t.csv");
    };
    const std::string rows =
        "1.12;0.14;rebound\n1.47;0.31;rebound\n1.93;0.52;rebound\n"
        "2.38;0.81;rebound\n2.61;1.02;rebound\n3.09;1.28;rebound\n";
    CHECK(read(rows + "2.10;0.68;rebound\n").points.size() == 7);  // the means
    CHECK(contains(input_error_of([&] { static_cast<void>(read(rows + "2.10;0.68;\n")); }),
                   "the row holds the means"));
    const std::string again =
        "1.120;0.140;rebound\n1.470;0.310;rebound\n1.930;0.520;rebound\n"
        "2.380;0.810;rebound\n2.610;1.020;rebound\n3.090;1.280;rebound\n";
    CHECK(contains(input_error_of([&] { static_cast<void>(read(rows + again)); }), "repeat"));
}

TEST_CASE("rows that are equal because velocities are whole pixels are read") {
    const auto table = [](double pixel, int first, int last, int decimals) {
        std::string text = "v_in [m/s];v_r [m/s]\n";
        for (int k = first; k <= last; ++k)
            for (int copy = 0; copy < 2; ++copy)
                text += fmt::format("{:.{}f};{:.{}f}\n", k * pixel, decimals, (k * 3 / 5) * pixel, decimals);
        return text;
    };
    CHECK(read_measurements(table(0.124, 5, 20, 3), "t.csv").points.size() == 32);
    std::string apart = "v_in [m/s];v_r [m/s]\n";  // the same of velocities that are not
    for (int k = 5; k <= 20; ++k)
        for (int copy = 0; copy < 2; ++copy)
            apart += fmt::format("{:.3f};{:.3f}\n", 0.6 + 0.001 * (k * k * k % 997), 0.07 * k);
    CHECK(contains(input_error_of([&] { static_cast<void>(read_measurements(apart, "t.csv")); }),
                   "rows repeat others: they may be there twice"));
}

TEST_CASE("a label without a number below numbered ones may sum up, in any language") {
    const auto of = [](const std::string& label) {
        return read_measurements(
            "Particella;v_in [m/s];v_r [m/s]\nP1;1.1;0.1\nP2;1.5;0.3\nP3;1.9;0.5\nP10;2.4;0.8\n" + label +
                ";1.8;0.4\n",
            "t.csv");
    };
    for (const char* label :
         {"Q1", "U95", "ET", "Dev. st.", "Std. sapma", "\u5e73\u5747\u5024", "Mean rebounds"})
        CHECK(contains(input_error_of([&] { static_cast<void>(of(label)); }),
                       "is in column \"Particella\", where the others have \"P\" and a number"));
    const auto mixed = [](const std::string& label) {
        return read_measurements(
            "Nr;v_in [m/s];v_r [m/s]\n1a;1.1;0.1\n1b;1.5;0.3\n2;1.9;0.5\nB7;2.4;0.8\n"
            "3;2.2;0.6\n" +
                label + ";1.8;0.4\n",
            "t.csv");
    };
    CHECK(contains(input_error_of([&] { static_cast<void>(mixed("Keskim.")); }), "have a number"));
    for (const char* label : {"Moy.", "gemittelt", "moyenne", "media", "promedio"})
        CHECK(mixed(label).points.size() == 5);
    for (const char* label : {"P11", "P11*"}) CHECK(of(label).points.size() == 5);
    CHECK(read_measurements(
              "v_in;v_r;Remark\n1.1;0.1;camera 1\n1.5;0.3;camera 2\n1.9;0.5;camera 2\n2.4;0.8;camera 1\n"
              "3.1;1.1;clean\n",
              "t.csv")
              .points.size() == 5);
}

TEST_CASE("ditto marks are no quotes around rows") {
    for (const char* table :
         {"v_in [m/s];v_r [m/s];run\n0.5;0;A\n0.6;0;\"\n0.7;0;\"\n0.8;0.1;\"\n0.9;0.2;\"\n",
          "v_in [m/s];run;v_r [m/s]\n0.5;A;0\n0.6;\";0\n0.7;\";0\n0.8;\";0.1\n0.9;\";0.2\n"})
        CHECK(contains(input_error_of([&] { static_cast<void>(read_measurements(table, "t.csv")); }),
                       "a quote is not closed"));
    CHECK(read_measurements("\"v_in\n[m/s]\";v_r [m/s]\n0.5;0\n0.9;0.2\n", "t.csv").points.size() == 2);
    CHECK(read_measurements("\"v_in\n[m/s]\";\"v_r\n[m/s]\";\"no\"\n0.5;0;1\n0.9;0.2;2\n", "t.csv")
              .points.size() == 2);
    CHECK(read_measurements("v_inc [m/s];v_refl [m/s]\n0.5;0\n0.9;0.2\n", "t.csv").points.size() == 2);
}

TEST_CASE("means below a table are found in any unit, and beside readings that are not known") {
    const auto refusal = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_measurements(text, "t.csv")); });
    };
    const std::string rows = "863;0\n940;7\n1159;66\n1436;170\n1975;428\n2071;461\n2640;749\n3067;1009\n";
    for (const char* unit : {"mm/s", "cm/s"})
        for (const char* sums : {"1768.9;361.2\n", "807.8;371.1\n", "14151;2890\n"}) {
            CAPTURE(sums);
            CHECK(contains(refusal(fmt::format("v_in [{0}];v_r [{0}]\n{1}{2}", unit, rows, sums)),
                           "it may be a measurement, or sum up others"));
        }
    for (const char* cell : {"", "n.a.", "unknown"})
        CHECK(
            contains(refusal(fmt::format("v_in [m/s];v_r [m/s]\n0.863;0\n0.940;0.007\n1.159;{}\n1.436;0.170\n"
                                         "1.975;0.428\n2.640;0.749\n1.5022;0.2708\n",
                                         cell)),
                     "the row holds the means"));
}

TEST_CASE("a first column of sizes or groups does not number the rows") {
    for (const char* heading : {"d [um]", "T [\u00b0C]", "Serie"}) {
        std::string table = std::string(heading) + ";v_in [m/s];v_r [m/s]\n";
        for (const char* row :
             {"2.10;0.81", "3.42;1.36", "4.88;2.05", "1.52;0.43", "4.21;1.85", "3.44;1.38", "3.26;1.31"})
            table += "88;" + std::string(row) + "\n";
        CHECK_MESSAGE(contains(input_error_of([&] { static_cast<void>(read_measurements(table, "t.csv")); }),
                               "the row holds the means"),
                      heading);
    }
    CHECK(contains(input_error_of([] {
                       static_cast<void>(
                           read_measurements("frames;v_in [m/s];v_r [m/s]\n5;2.10;0.81\n6;3.42;1.36\n"
                                             "5;4.88;2.05\n7;1.52;0.43\n6;4.21;1.85\n8;3.44;1.38\n"
                                             ";3.26;1.31\n",
                                             "t.csv"));
                   }),
                   "the row holds the means"));
}

TEST_CASE("columns of the sides of an uncertainty, + and -, are not used") {
    const MeasurementSet set = read_measurements(
        "v_in [m/s];+ [m/s];- [m/s];v_r [m/s];+ [m/s];- "
        "[m/s]\n1.4;0.03;0.06;0.11;0.02;0.04\n2.6;0.03;0.06;0.9;0.02;0.04\n",
        "t.csv");
    CHECK_FALSE(set.has_noise());
    CHECK(std::ranges::any_of(set.warnings, [](const Finding& each) {
        return contains(each.text, "column \"+ [m/s]\" is not used");
    }));
}

TEST_CASE("coverages P = 95 %, bounds of uncertainties, and signs of summaries behind each group") {
    const auto refusal = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_measurements(text, "t.csv")); });
    };
    const MeasurementSet set = read_measurements(
        "v_in;u(v_r) (P=95%);v_r;u(v_in) (k=2, P=95%)\n1.4;0.0392;0.11;0.1\n2.6;0.0392;0.9;0.1\n", "t.csv");
    CHECK(std::sqrt(set.points[0].noise.value().incident) == doctest::Approx(0.05));
    CHECK(std::sqrt(set.points[0].noise.value().rebound) == doctest::Approx(0.02).epsilon(1e-3));
    CHECK(
        contains(refusal("v_in;u(v_in);v_r;u(v_r)\n1.4;<0.03;0.1;0.02\n2.6;0.03;0.9;0.02\n"), "is a bound"));
    CHECK(contains(
        refusal("Gruppe;v_in;v_r\nA;1.4;0.1\nA;1.9;0.4\ns;0.3;0.2\nB;2.4;0.7\nB;2.9;1.0\ns;0.4;0.2\n"),
        "sum"));
}

TEST_CASE("a word in an otherwise empty column is quoted") {
    const MeasurementSet set = read_measurements(
        "Datum;v_imp [m/s];v_reb [m/s]\n;1.27;0\n;4.95;2.28\n;1.90;0.40\nLiteratur;2.56;0.81\n", "t.csv");
    CHECK(set.points.size() == 4);
    CHECK(std::ranges::any_of(set.warnings, [](const Finding& each) {
        return contains(each.text, "column \"Datum\" has \"Literatur\" in few rows");
    }));
}

TEST_CASE("marks behind the numbers of rows are quoted") {
    const MeasurementSet set = read_measurements(
        "Nr.;v_in [m/s];v_r [m/s]\n1;1.27;0\n2;4.95;2.28\n3*;1.90;0.40\n4*;2.56;0.81\n", "t.csv");
    CHECK(set.points.size() == 4);
    CHECK(std::ranges::any_of(set.warnings, [](const Finding& each) {
        return contains(each.text,
                        "the mark of \"3*\" in column \"Nr.\" is not read, and the rows with one count");
    }));
}

TEST_CASE("rows that sum up counters, with last zeros or under the labels of groups are refused") {
    const auto refusal = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_measurements(text, "t.csv")); });
    };
    const std::string counted =
        "Nr;v_in;v_r\n1;1.31;0.11\n2;1.40;0.21\n3;2.55;0.83\n4;3.90;1.51\n5;4.60;1.84\n6;3.10;1.13\n";
    CHECK(refusal(counted).empty());
    CHECK(contains(refusal(counted + "3.5;2.81;0.94\n"), "the row holds the means"));
    CHECK(contains(refusal(counted + "21;16.86;5.63\n"), "the row holds the sums"));
    CHECK(contains(refusal("v_in;v_r\n1.41;0.12\n2.43;0.81\n3.39;1.32\n0.99;0.60\n"), "standard deviations"));
    const std::string groups =
        "Serie;v_in;v_r\nA;1.31;0.12\nA;1.40;0.22\nA;1.55;0.31\nB;1.95;0.33\nB;2.31;0.52\n"
        "B;2.55;0.71\n";
    CHECK(refusal(groups).empty());
    CHECK(contains(refusal(groups + "A;1.42;0.22\nB;2.27;0.52\n"),
                   "the row holds the means of the rows with its label"));
}

TEST_CASE("means beside angles are those of the velocities as written") {
    const std::string table(
        "v_in [m/s];angle [deg];v_rn [m/s]\n2.10;5.0;0.81\n3.42;12.5;1.36\n4.88;22.0;2.05\n"
        "1.52;15.5;0.43\n4.21;19.0;1.85\n3.44;30.0;1.38\n3.26;17.3;1.31\n");
    CHECK(contains(input_error_of([&] { static_cast<void>(read_measurements(table, "t.csv")); }),
                   "the row holds the means"));
}

TEST_CASE("a last row without a label that holds the means of the others is refused") {
    const std::string rows = "v_in;v_r\n1,52;0,48\n2,51;0,93\n3,03;1,22\n3,91;1,70\n";
    for (const char* sums : {"\n2,74;1,08\n", "2,7425;1,0825\n1,0;0,5\n"})
        CHECK(
            contains(input_error_of([&] { static_cast<void>(read_measurements(rows + sums, "t.csv")); }),
                     "the row holds the means of the rows above: it may be a measurement, or sum up others"));
    const char* const ratios = "v_in;e\n1,52;0,48\n2,51;0,53\n3,03;0,62\n3,91;0,70\n2,743;0,5825\n";
    CHECK(contains(input_error_of([&] { static_cast<void>(read_measurements(ratios, "t.csv")); }),
                   "the row holds the means"));
    const std::string dense = "v_in;v_r\n0.5;0\n0.7;0\n1.02;0.21\n1.33;0.47\n1.95;0.93\n2.5;1.31\n3.1;1.7\n";
    for (const auto& [row, holds] : {std::pair{"11.1;4.62", "sums"},
                                     {"1.6;0.7", "means"},
                                     {"0.96;0.7", "standard deviations"},
                                     {"0.895;0.62", "standard deviations"},
                                     {"1.33;0.47", "medians"},
                                     {"7;5", "counts"},
                                     {"0.365;0.253", "standard errors"},
                                     {"0.935;0.448", "variances"},
                                     {"1.586;0.924", "means"}})
        CHECK_MESSAGE(contains(input_error_of([&] { return read_measurements(dense + row + "\n", "t.csv"); }),
                               std::string("the row holds the ") + holds + " of the rows above"),
                      row);
    for (const auto& [row, holds] : {std::pair{"1.586;0.66", "means"}, {"1.33;0.47", "medians"}})
        CHECK(contains(input_error_of([&] {
                           return read_measurements("v_in;v_r\n" + std::string(row) + dense.substr(8),
                                                    "t.csv");
                       }),
                       std::string("line 2: the row holds the ") + holds + " of the rows below"));
    const std::string labelled = "sample;v_in;v_r\nA;1.52;0.48\nA;2.51;0.93\nA;3.03;1.22\n";
    for (const char* label : {"95 % CI", "VK"})
        CHECK(read_measurements(labelled + label + ";0.4;0.2\n", "t.csv").points.size() == 3);
    const std::string second = "1,1;0,3\n2,2;0,8\n3,3;1,4\n2,9;0,9\n";
    for (const std::string& series : {rows + "\n2,74;1,08\n\n" + second, rows + "2,74;1,08\n\n" + second,
                                      rows + "2,74;1,08\n" + second + "2,375;0,85\n3,1;1,0\n2,2;0,9\n"})
        CHECK(contains(input_error_of([&] { return read_measurements(series, "t.csv"); }),
                       "the row holds the means of the rows above"));
    CHECK(contains(warnings_of(read_measurements(rows + "2,74;1,08\n" + second, "t.csv")),
                   "line 6 holds the means of the rows above: if it sums them up, it is no impact"));
    const auto long_file = [](bool with_means) {  // 20 groups of 4 rows
        std::string text = "v_in;v_r\n";
        for (int group = 0; group < 20; ++group) {
            for (int row = 0; row < 4; ++row)
                text += fmt::format("{:.2f};{:.2f}\n", 1 + 0.1 * group + 0.04 * row * row, 0.4 + 0.06 * row);
            if (with_means && group < 19) text += fmt::format("{:.2f};{:.2f}\n", 1.14 + 0.1 * group, 0.49);
        }
        return text;
    };
    CHECK(contains(input_error_of([&] { return read_measurements(long_file(true), "t.csv"); }),
                   "line 6: the row holds the means of the rows above"));
    CHECK(read_measurements(long_file(false), "t.csv").points.size() == 80);
    std::string captured_first =
        "v_in;v_r\n";  // means and standard deviations behind groups of captures, too
    captured_first += "0.765;0.0\n0.744;0.0\n0.774;0.0\n0.743;0.0\n0.7565;0.000\n0.0155;0.000\n";
    captured_first += "0.844;0.0\n0.922;0.0\n1.008;0.0\n1.103;0.008\n0.96925;0.00200\n0.11134;0.00400\n";
    captured_first += "1.215;0.044\n1.328;0.082\n1.46;0.117\n1.605;0.169\n1.40200;0.10300\n0.1688;0.0529\n";
    CHECK(contains(input_error_of([&] { return read_measurements(captured_first, "t.csv"); }),
                   "line 6: the row holds the means of the rows above"));
    std::string without_words = "v_in;v_r\n0.649;haftet\n0.720;haftet\n0.648;haftet\n0.672;haftet\n";
    without_words += "0.964;0.001\n0.852;haftet\n0.956;0.015\n0.924;0.008\n";
    without_words += "1.215;0.044\n1.328;haftet\n1.46;0.117\n1.334;0.081\n";
    CHECK(contains(input_error_of([&] { return read_measurements(without_words, "t.csv"); }),
                   "line 5: the row holds the means of the rows above"));
    std::string means_first = "v_in;v_r\n0.7565;0.000\n0.765;0.0\n0.744;0.0\n0.774;0.0\n0.743;0.0\n";
    means_first += "0.96925;0.00200\n0.844;0.0\n0.922;0.0\n1.008;0.0\n1.103;0.008\n";
    means_first += "1.40200;0.10300\n1.215;0.044\n1.328;0.082\n1.46;0.117\n1.605;0.169\n";
    CHECK(contains(input_error_of([&] { return read_measurements(means_first, "t.csv"); }),
                   "line 2: the row holds the means of the rows below"));
    for (const char* ends : {"0.5;0\n3.1;1.7\n1.586;0.66\n", "0.5;0\n3.1;1.7\n1.586;0.66\n0.967;0.67\n"})
        CHECK(contains(input_error_of([&] { return read_measurements(dense + ends, "t.csv"); }),
                       "the row holds the means of the rows above"));
    CHECK(contains(input_error_of([&] {
                       return read_measurements("v_in;v_r\n1.586;0.66\n0.967;0.67\n" + dense.substr(9),
                                                "t.csv");
                   }),
                   "line 2: the row holds the means of the rows below"));
    CHECK(read_measurements(rows + "\n" + second, "t.csv").points.size() == 8);
    CHECK(read_measurements(dense + "1.7;0.7\n", "t.csv").points.size() == 8);
    CHECK(read_measurements(rows + "2,74;1,02\n", "t.csv").points.size() == 5);
    CHECK(read_measurements("v_in [mm/s];v_r [mm/s]\n6273;2838\n2265;1285\n6945;2189\n5192;2086\n", "t.csv")
              .points.size() == 4);
    CHECK(read_measurements("v_in;v_r\n2;0,5\n2;0,5\n2;0,5\n2;0,5\n", "t.csv").points.size() == 4);
    CHECK(read_measurements("Nr.;v_in;v_r\n1;1;0,5\n2;3;1,5\n3;2;1\n4;2;1\n", "t.csv").points.size() == 4);
}

TEST_CASE(
    "remarks that call an impact invalid, or speak against its reading, are refused; others are named") {
    const auto read = [](const std::string& row, const std::string& heading = "Bemerkung") {
        return read_measurements("v_in [m/s];v_r [m/s];" + heading + "\n" + row + "\n2,1;0,44;\n", "t.csv");
    };
    for (const char* remark : {"ung\u00fcltig", "invalid", "exclude!", "Ausrei\u00dfer", "outlier (camera)",
                               "bitte nicht verwenden", "not valid"})
        for (const char* heading : {"Bemerkung", "seen"}) {
            CAPTURE(remark);
            CHECK(contains(
                input_error_of([&] { static_cast<void>(read("1,4;0,33;" + std::string(remark), heading)); }),
                "calls the row invalid, and remarks are not read; allowed: a file without this row"));
        }
    for (const char* remark : {"Partikel haftet an der Wand", "sticks to the wall", "hat gehaftet"})
        CHECK(contains(input_error_of([&] { static_cast<void>(read("1,4;0,33;" + std::string(remark))); }),
                       "speaks of a capture, and the rebound velocity is 0.33 m/s"));
    CHECK(contains(input_error_of([&] { static_cast<void>(read("1,4;0;bounced off twice")); }),
                   "speaks of a rebound, and the reading is a capture"));
    CHECK(read("1,4;0;haftet nicht").captures() == 0);
    CHECK(read("1,4;0;kein R\u00fcckprall").captures() == 1);
    for (const char* remark :
         {"kein Ausrei\u00dfer", "Bild unscharf", "did it stick?", "haftet kurz, prallt dann ab"}) {
        CAPTURE(remark);
        const MeasurementSet set = read("1,4;0,33;" + std::string(remark));
        CHECK(set.rebounds() == 2);
        const Finding& told = set.warnings.back();
        CHECK_MESSAGE(contains(told.text, "\"" + std::string(remark) +
                                              "\" in column \"Bemerkung\" is not read (line 2)"),
                      told.text);
        CHECK(told.severity == Severity::remark);
    }
}

TEST_CASE(
    "columns that say yes or no of a capture are read, those of validity refused unless all rows are alike") {
    for (const char* rows : {"1.5;1\n2.5;0\n", "1.5;1\n2.5;1\n"})
        CHECK(contains(
            input_error_of([&] { return read_measurements(std::string("v_in;rebound\n") + rows, "t.csv"); }),
            "\"rebound\" may hold velocities of 1 m/s, or 1 for a rebound"));
    const MeasurementSet set =
        read_measurements("v_in;v_r;captured\n1,4;0,4;no\n0,6;0;yes\n0,5;;x\n0,7;0;nein\n", "t.csv");
    CHECK(set.captures() == 2);
    CHECK(set.points.back().outcome == NotedOutcome::rebound);
    CHECK(contains(input_error_of([] {
                       static_cast<void>(read_measurements("v_in;v_r;stuck\n1,4;0,4;yes\n", "t.csv"));
                   }),
                   "the outcome tells of a capture, and the rebound velocity is 0.4 m/s"));
    struct Judged {
        const char* heading;
        std::array<const char*, 2> cells;
        const char* says;  // of the refusal; empty: read
    };
    for (const auto& [heading, cells, says] :
         {Judged{"valid", {"1", "0"}, "line 3, cell 3: column \"valid\" marks rows as valid or not"},
          {"ok",
           {"yes", "no"},
           "\"yes\" or \"no\": those with one of the marks may be excluded, or all count"},
          {"OK?", {"", "x"}, "column \"OK?\" marks rows"},
          {"quality", {"good", "bad"}, "column \"quality\" marks rows"},
          {"Qualit\u00e4t", {"2", "3"}, "marks rows"},
          {"flag", {"", "1"}, "marks rows"},
          {"n.i.O.", {"", "ja"}, "marks rows"},
          {"remark", {"", "x"}, "column \"remark\" marks rows"},
          {"", {"", "no"}, "the column without a heading marks rows"},
          {"seen", {"", "bad"}, "\"bad\" in column \"seen\" calls the row invalid"},
          {"valid", {"no", "no"}, "column \"valid\" has \"no\" in every row: all may be excluded"},
          {"exclude", {"x", "x"}, "column \"exclude\" has \"x\" in every row"},
          {"quality", {"schlecht", "schlecht"}, "in every row"},
          {"valid", {"1", "1"}, ""},
          {"exclude", {"no", "no"}, ""},
          {"flag", {"", ""}, ""},
          {"quality", {"good", "good"}, ""},
          {"quality", {"0.93", "0.89"}, ""},
          {"wet", {"yes", "no"}, "it may state which impacts were captured, or which count"}}) {
        const std::string table =
            "v_in;v_r;" + std::string(heading) + "\n1.4;0.4;" + cells[0] + "\n1.5;0.4;" + cells[1] + "\n";
        CAPTURE(table);
        if (*says != '\0')
            CHECK(contains(input_error_of([&] { return read_measurements(table, "t.csv"); }), says));
        else
            CHECK(contains(warnings_of(read_measurements(table, "t.csv")), "is not used"));
    }
}

TEST_CASE("units of velocities in cells, and behind a name without brackets") {
    for (const char* table :
         {"v_in;v_r\n1.4 m/s;0.41 m/s\n2.4 m/s;0.93 m/s\n",
          "v_in [m/s];v_r [m/s]\n1.4 m/s;0.41\n2.4;0.93 m/s\n",
          "v_in;v_r\n1400 mm/s;410 mm/s\n2400mm/s;930 mm/s\n", "v_in m/s;v_r, m/s\n1.4;0.41\n2.4;0.93\n",
          "incident velocity mm/s;v_r m s-1\n1400;0.41\n2400;0.93\n"}) {
        CAPTURE(table);
        const MeasurementSet set = read_measurements(table, "t.csv");
        REQUIRE(set.points.size() == 2);
        CHECK(set.points[1].velocity == doctest::Approx(2.4).epsilon(1e-12));
        CHECK(set.points[0].rebound == doctest::Approx(0.41).epsilon(1e-12));
        CHECK_FALSE(contains(warnings_of(set), "no unit"));
    }
    CHECK(noise_of_incident("v_in;v_r\n2.1 \u00b1 0.06 m/s;0.4 m/s\n2.2 m/s \u00b1 0.06 m/s;0.5 m/s\n") ==
          doctest::Approx(0.06).epsilon(1e-12));
    CHECK(contains(input_error_of([] {
                       static_cast<void>(read_measurements("v_in;v_r\n1.4 m/s;0\n2400 mm/s;0\n", "t.csv"));
                   }),
                   "line 3, cell 1: \"2400 mm/s\" in column \"v_in\" is in another unit than its column"));
    CHECK(contains(
        input_error_of(
            [] { static_cast<void>(read_measurements("v_in;v_r\n2400;0\n1.4 m/s;0\n", "t.csv")); }),
        "line 2, cell 1: \"2400\" in column \"v_in\" has no unit, and other cells of the column have one"));
    CHECK(contains(
        input_error_of([] { static_cast<void>(read_measurements("v_in [kg];v_r\n1;0\n", "t.csv")); }),
        "line 1: column \"v_in [kg]\": the unit \"kg\" is not one of velocity"));
}

TEST_CASE("a restitution far above one has two readings, and the first velocity at fault is named") {
    CHECK(contains(input_error_of([] {
                       static_cast<void>(read_measurements("v_in;e\n1;0.7\n2;69.8\n3;71\n", "t.csv"));
                   }),
                   "line 3, cell 2: \"69.8\" in column \"e\" may be 69.8 % or a restitution whose decimal "
                   "mark was lost"));
    CHECK(contains(
        input_error_of([] { static_cast<void>(read_measurements("v_in;e\n1;0.7 \u00b1 3%\n", "t.csv")); }),
        "the uncertainty is 3 % of 0.7, or 3 in the unit of the value"));
    CHECK(contains(input_error_of([] {
                       static_cast<void>(read_measurements("v_in;v_r\n1;0.7\n4000;930\n2;1\n", "t.csv"));
                   }),
                   "line 3: v_in: 4000 has no unit and is 4000 m/s, did you mean 4000 mm/s?"));
    const MeasurementSet set =
        read_measurements("v_in [m/s];v_r [m/s]\n1;0.7\n4000;930\n2;1\n5000;930\n", "t.csv");
    CHECK(contains(set.warnings.front().text, "line 3: v_in: 4000 m/s"));
    CHECK(contains(input_error_of([] {
                       static_cast<void>(read_measurements("v_in [mm/s];v_r [mm/s]\n1.753;950\n", "t.csv"));
                   }),
                   "\"1.753\" is 1.753 or 1753"));
}

TEST_CASE("velocities that may be grouped are refused, unless another number of the table decides") {
    const auto first = [](const std::string& rows) {
        return read_measurements("v_in [mm/s];v_r [mm/s]\n" + rows, "t.csv").points.front().velocity;
    };
    CHECK_THROWS_AS(static_cast<void>(first("1,234;567\n2,345;600\n")), InputError);
    CHECK(first("1.234;567,5\n2.345;600\n") == 1.234);
    CHECK(first("1,234;0,567\n") == doctest::Approx(1.234e-3));
    CHECK(contains(input_error_of([&] { static_cast<void>(first("1,234;567\n")); }),
                   "--decimal point or comma"));
    for (const auto& [mark, velocity] :
         {std::pair{DecimalMark::point, 1.234}, {DecimalMark::comma, 1.234e-3}})
        CHECK(read_measurements("v_in [mm/s];v_r [mm/s]\n1,234;1\n", "t.csv", {.decimal = mark})
                  .points.front()
                  .velocity == doctest::Approx(velocity));
}

TEST_CASE("units in a second heading line, and a note below the table") {
    const MeasurementSet set =
        read_measurements("Nr.;v_in;v_r\n;[mm/s];mm/s\n1;2000;500\n\nMessung: NN\n", "t.csv");
    REQUIRE(set.points.size() == 1);
    CHECK(set.points.front().rebound == doctest::Approx(0.5));
    CHECK(contains(warnings_of(set), "line 5 below the table is not read: \"Messung: NN\""));
    CHECK_FALSE(contains(warnings_of(set), "no unit"));
}

TEST_CASE("a contact model is the solver's impact: its restitution and contact time at the model's damping") {
    for (const Law law : fitted_laws) {
        const ContactModel model = ash_model(law);
        for (const double v : {0.5, 2.0, 11.0})
            for (const double share : {0.1, 0.5, 0.9}) {
                CAPTURE(law.name());
                CAPTURE(v);
                const double e = share * model.greatest_restitution(v);
                const ImpactResult result = solve_impact({law,
                                                          law.default_detachment(),
                                                          {DampingLaw::constant, model.damping(v, e).value},
                                                          model.contact(),
                                                          v});
                CHECK(std::abs(result.restitution - e) < 10 * model.map().accuracy());
                REQUIRE(result.contact_time);
                CHECK(relative_difference(model.contact_time(v, e), *result.contact_time) < 1e-3);
            }
    }
}

TEST_CASE("velocity, restitution and damping of a contact model follow from one another, from any start") {
    for (const Law law : fitted_laws) {
        const ContactModel model = ash_model(law);
        // That of Hertz has no end.
        const VelocityRange range{std::max(model.range().lower, 0.01), std::min(model.range().upper, 30.0)};
        for (const double v : {1.2 * range.lower, 0.5, 2.0, 0.8 * range.upper})
            for (const double share : {0.0, 0.3, 0.97}) {
                CAPTURE(law.name());
                CAPTURE(v);
                const double e = share * model.greatest_restitution(v);
                const DampingAt damping = model.damping(v, e);
                if (e > 0) CHECK(std::abs(model.restitution(v, damping.value) - e) < 1e-9);
                for (const std::optional<double> guess :
                     {std::optional<double>(), std::optional(range.lower), std::optional(range.upper)}) {
                    const auto found = model.velocity(e, damping.value, guess);
                    REQUIRE(found);
                    CHECK(relative_difference(found->value, v) < 1e-9);
                    CHECK(relative_difference(found->by_damping, 1 / damping.by_velocity) < 1e-5);
                }
            }
        if (law == Law::of<Hertz>()) continue;
        CHECK_FALSE(model.velocity(0.0, 1.01 * model.damping(range.upper, 0.0).value));
        CHECK_FALSE(model.velocity(0.0, 0.99 * model.damping(range.lower, 0.0).value));
    }
}

TEST_CASE("a contact that ends at zero force, and so never captures, has no contact model") {
    const Law hertz = Law::of<Hertz>();
    CHECK_THROWS_AS(
        static_cast<void>(make_contact_model(hertz, Detachment::zero_force, ash_pair, {0.01, 30.0})),
        InputError);
}
