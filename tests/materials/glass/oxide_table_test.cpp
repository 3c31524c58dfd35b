// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/glass/oxide_table.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "core/text/text.hpp"
#include "materials/glass/balance.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/marked_tables.hpp"

namespace ashimpact::test {

namespace {

/// Per cent of an oxide in the sample; -1 if it is not listed.
double per_cent_of(const OxideSample& sample, std::string_view oxide) {
    for (const OxideShare& each : sample.analysis.oxides)
        if (each.oxide == oxide) return 100 * each.fraction;
    return -1;
}

double loss_of(const OxideSample& sample) {
    return 100 * sample.analysis.loss_on_ignition.value().fraction;
}

OxideSample only(std::string_view text) {
    const OxideResult result = read_oxides(text, "xrf.csv");
    REQUIRE(result.samples.size() == 1);
    return result.samples.front();
}

bool near(double a, double b) {
    return std::abs(a - b) < 1e-9;
}

bool tells(const std::vector<Finding>& warnings, std::string_view text) {
    return std::ranges::any_of(
        warnings, [&](const Finding& each) { return each.text.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE("notes in several cells below an analysis are texts beside it") {
    const std::string rows = "Oxide;wt%\nSiO2;60\nAl2O3;36\nP2O5;4\n";
    for (const char* note : {"Note;P2O5 in g/kg", "* P2O5 in g/kg", "* P2O5;in g/kg", "Note: P2O5 in g/kg"})
        CHECK_MESSAGE(
            contains(input_error_of([&] { static_cast<void>(read_oxides(rows + note + "\n", "x.csv")); }),
                     "g/kg"),
            note);
    const OxideResult result = read_oxides(rows + "* dried;at 105 C\nRemark;by XRF\n", "x.csv");
    CHECK(result.samples.front().analysis.oxides.size() == 3);
    CHECK(tells(result.warnings, "line 5 below the table is not read: \"* dried, at 105 C\""));
    CHECK(tells(result.warnings, "line 6 below the table is not read: \"Remark, by XRF\""));
}

TEST_CASE("a text beside an oxide without an amount is quoted") {
    for (const char* name : {"LOI", "Total", "MgO"}) {
        const OxideSample sample =
            only(std::string("Oxide;wt%;esd\nSiO2;60;1\nAl2O3;40;1\n") + name + ";;at 950 C\n");
        CHECK_MESSAGE(tells(sample.warnings, "\"at 950 C\" beside " + std::string(name)), name);
    }
}

TEST_CASE("an element as its oxide, and a total of one, are that oxide") {
    const OxideSample sample =
        only("Oxide;wt%\nSiO2;50\nAl2O3;30\nFe as Fe2O3;8\nS als SO3;2\nCaO (total);10\n");
    CHECK(near(per_cent_of(sample, "Fe2O3"), 8));
    CHECK(near(per_cent_of(sample, "SO3"), 2));
    CHECK(near(per_cent_of(sample, "CaO"), 10));
    CHECK_FALSE(input_error_of([] {
                    static_cast<void>(read_oxides("Oxide;wt%\nSiO2;50\nAl2O3;30\nS as CaO;2\n", "x.csv"));
                }).empty());
}

TEST_CASE("names of samples above units of an analysis are those of its columns") {
    const OxideResult result =
        read_oxides(";FA1;;FA2;\nOxide;wt%;2\u03c3;wt%;2\u03c3\nSiO2;60;1;50;2\nAl2O3;40;1;50;2\n", "x.csv");
    REQUIRE(result.samples.size() == 2);
    CHECK(result.samples[1].name == "FA2");
    CHECK(near(per_cent_of(result.samples[1], "SiO2"), 50));
    CHECK(near(*result.samples[1].analysis.oxides[0].standard_uncertainty, 0.01));
    CHECK_FALSE(input_error_of([] {
                    static_cast<void>(
                        read_oxides(";FA1;\nOxide;wt%;wt%\nSiO2;60;50\nAl2O3;40;50\n", "x.csv"));
                }).empty());
}

TEST_CASE("rows of an analysis without a name are refused or quoted") {
    for (const char* row : {";\u00b1 4\n", ";(0.5)\n", ";0.1\n", ";47.07\n"})
        CHECK_MESSAGE(contains(input_error_of([&] {
                                   static_cast<void>(read_oxides(
                                       std::string("Oxide;wt%\nSiO2;60\n") + row + "Al2O3;40\n", "x.csv"));
                               }),
                               "names no oxide"),
                      row);
    CHECK(tells(read_oxides("Oxide;wt%\nSiO2;60\n;by XRF\nAl2O3;40\n", "x.csv").warnings, "\"by XRF\""));
    const OxideResult doubled = read_oxides("Sample;SiO2;Al2O3;SO3\nA;60;40;-\n2s;1;1;-\n", "x.csv");
    CHECK_FALSE(tells(doubled.warnings, "word beside its name"));
    CHECK(near(*doubled.samples.front().analysis.oxides.front().standard_uncertainty, 0.005));
}

TEST_CASE("a coverage in a row of an analysis is refused, remarks in the first row are quoted") {
    const std::string rows = "Oxide;wt%;error\nSiO2;60;1\nAl2O3;40;1\n";
    for (const char* row : {"Coverage factor;;2\n", "Uncertainty;;k=2\n", "Note;;2 sigma\n"})
        CHECK_MESSAGE(!input_error_of([&] { static_cast<void>(read_oxides(rows + row, "x.csv")); }).empty(),
                      row);
    const OxideResult result = read_oxides("Oxide;wt%;Remark\nSiO2;60;by difference\nAl2O3;40;\n", "x.csv");
    CHECK(tells(result.warnings, "columns not used: \"Remark\" (\"by difference\")"));
}

TEST_CASE("no text in an analysis vanishes") {
    for (const Cells& rows : {Cells{{"Oxide", "wt%"}, {"SiO2", "60"}, {"Al2O3", "39"}, {"LOI", "1"}},
                              Cells{{"Oxide", "wt%", "esd"}, {"SiO2", "60", "1"}, {"Al2O3", "40", "1"}},
                              Cells{{"Oxide", "x", "y"}, {"SiO2", "60", "50"}, {"Al2O3", "40", "50"}},
                              Cells{{"Sample", "SiO2", "Al2O3"}, {"x", "60", "40"}, {"y", "50", "50"}},
                              Cells{{"Sample", "SiO2", "Al2O3"},
                                    {"x", "60", "40"},
                                    {"SD", "1", "1"},
                                    {"y", "50", "50"},
                                    {"SD", "1", "1"}},
                              Cells{{"Oxide", "wt%", "Remark"}, {"SiO2", "60", ""}, {"Al2O3", "40", ""}}})
        check_marked(rows, [](const std::string& table) {
            const OxideResult result = read_oxides(table, "x.csv");
            std::string told = joined(texts_of(result.warnings)) + result.reading;
            for (const OxideSample& sample : result.samples)
                told += sample.name + joined(texts_of(sample.warnings));
            return told;
        });
}

TEST_CASE("what each column and row of an analysis is taken as is stated") {
    CHECK(read_oxides("Oxide;FA1 [wt%];2s\nSiO2;60;1\nAl2O3;37;1\nLOI;3;\nTotal;100;\n", "x.csv").reading ==
          "1 sample; 97 % by weight in oxides, LOI 3 %; oxides: \"SiO2\", \"Al2O3\"; amounts: \"FA1 [wt%]\"; "
          "standard uncertainties: \"2s\" divided by 2; loss on ignition: \"LOI\"; total: \"Total\"");
    CHECK(read_oxides("Sample;SiO2;Al2O3\nA;60;40\nB;50;50\n", "x.csv").reading ==
          "2 samples; A 100 % by weight in oxides; B 100 % by weight in oxides; oxides: \"SiO2\", \"Al2O3\"");
    CHECK(contains(read_oxides("Sample;SiO2;Al2O3\nA;60;40\nU (k=2);1;1\n", "x.csv").reading,
                   "uncertainties in the cells divided by 2: \"SiO2\", \"Al2O3\""));
}

TEST_CASE("titles and footnotes without a separator do not decide on it") {
    const OxideResult result =
        read_oxides("XRF of ash\nOxide;wt%\nSiO2;60\nAl2O3;40\n* dried at 105 C\nby XRF\n", "xrf.csv");
    CHECK(result.samples.front().analysis.oxides.size() == 2);
}

TEST_CASE("what the headings of names and amounts of oxides say counts") {
    const auto refusal = [](const std::string& table) {
        return input_error_of([&] { return read_oxides(table, "xrf.csv"); });
    };
    const std::string rows = "\nSiO2;52;1\nAl2O3;28;1\nCaO;20;1\n";
    for (const char* heading :
         {"Oxide;cation %;\u00b1", "Oxide (at.%);FA1;\u00b1", "Oxide (cation %);FA1;\u00b1",
          "Oxide [cation %];FA1;esd", "Oxide [g/kg];FA1;esd", "Oxide;Kationen-%;esd"})
        CHECK_MESSAGE(!refusal(heading + rows).empty(), heading);
    for (const char* heading : {"Oxide [wt%];FA1;esd", "Oxide (wt%);FA1 [wt%];esd", "Oxide (XRF);FA1;esd"})
        CHECK_MESSAGE(refusal(heading + rows).empty(), heading);
    for (const char* heading : {"Oxide;wt% (2s);\u00b1", "Oxide;Content [wt%] (\u00b1 2\u03c3);error"})
        CHECK(only(heading + rows).analysis.oxides[0].standard_uncertainty.value() == doctest::Approx(0.005));
    CHECK(contains(refusal("Oxide;wt% (2s);esd" + rows), "names standard uncertainties"));
    const OxideResult two = read_oxides("Oxide;FA1;FA2\nUnit;wt%;wt%\nSiO2;52;50\nAl2O3;48;50\n", "xrf.csv");
    REQUIRE(two.samples.size() == 2);
    CHECK(two.samples[1].name == "FA2");
    CHECK(two.samples[1].analysis.oxides[0].fraction == doctest::Approx(0.5));
}

TEST_CASE("uncertainties of oxides may stand behind other columns, and marks beside amounts are refused") {
    for (const char* heading : {"oxide;Conc.;Unit;StdErr\nSiO2;60;%;2\nAl2O3;40;%;2\n",
                                "oxide;wt%;LOD;esd\nSiO2;60;<0.05;2\nAl2O3;40;0.05;2\n",
                                "oxide;esd;wt%\nSiO2;2;60\nAl2O3;2;40\n"}) {
        CAPTURE(heading);
        CHECK(near(*only(heading).analysis.oxides[0].standard_uncertainty, 0.02));
    }
    for (const auto& [table, unused] :
         {std::pair{"oxide;wt%;Net int.;error\nSiO2;60;123;5\nAl2O3;40;123;5\n", "\"error\""},
          {"oxide;Intensity;\u00b1;wt%\nSiO2;123;5;60\nAl2O3;123;5;40\n", "\"\u00b1\""},
          {"oxide;FA1;counts;esd\nSiO2;60;123;5\nAl2O3;40;123;5\n", "\"esd\""}}) {
        CAPTURE(table);
        const OxideSample sample = only(table);  // the uncertainties are those of the counts
        CHECK_FALSE(sample.analysis.oxides[0].standard_uncertainty);
        CHECK(tells(read_oxides(table, "xrf.csv").warnings, std::string("columns not used: ") + unused));
    }
    CHECK(near(*only("oxide;counts;esd;wt%;esd\nSiO2;123;5;60;2\nAl2O3;123;5;40;2\n")
                    .analysis.oxides[0]
                    .standard_uncertainty,
               0.02));
    const auto refused = [](std::string_view text) {
        return input_error_of([&] { static_cast<void>(read_oxides(text, "xrf.csv")); });
    };
    CHECK(contains(refused("oxide;FA1;FA2;note;esd\nSiO2;60;50;a;2\nAl2O3;40;50;b;2\n"),
                   "the uncertainties in column \"esd\" may be of any column"));
    CHECK(contains(refused("oxide;;wt%\nSiO2;;60\nAl2O3;;39.4\nNa2O;<;0.6\n"),
                   "line 4, cell 2: \"<\" in column \"\" may make the number beside it a bound"));
    CHECK(contains(refused("oxide;wt%;note\nSiO2;60;\nAl2O3;40;invalid\n"), "calls the row invalid"));
    CHECK(contains(refused("Sample;SiO2;Al2O3\nFA1;60;40\n;0.4;0.3\n"), "line 3: the line names no sample"));
    CHECK(contains(refused("Sample,SiO2,Al2O3,Na2Oeq\nFA1,60,39,1\n"), "nothing else gives Na2O"));
    CHECK(contains(refused("oxide;wt%\nSiO2;60\nAl2O3;39\nNa2O <;1\n"), "nothing else gives Na2O"));
    const OxideSample relative =
        only("Oxide;Massenanteil;Messunsicherheit\nSiO2;60 %;5 %\nAl2O3;40 %;5 %\nK2O;;\n");
    CHECK(tells(relative.warnings, "the uncertainties in % are taken as per cent of the sample"));
    CHECK(tells(relative.warnings, "no amount is given of K2O: not in the glass"));
    CHECK(tells(only("Oxide;wt%\nSiO2;60\nAl2O3;40\nNa2O;n.d.\n").warnings,
                "read as not found, zero: Na2O (\"n.d.\"); the cell of an oxide that was not determined"));
    CHECK(contains(refused("Oxide;wt%\nSiO2;60 %\nAl2O3;39 %\nNa2O;0.01\n"),
                   "line 4, cell 2: the amount \"0.01\" of Na2O has no sign, others are in %"));
    for (const char* heading : {"wt% (LOI-free)", "wt% (ignited)", "Gew.-% (gegl\u00fcht)", "FA1 ignited"})
        CHECK_FALSE(only("oxide;" + std::string(heading) + "\nSiO2;60\nAl2O3;40\n").analysis.ignited.empty());
}

TEST_CASE("rows without cells above oxides, and coverage factors beside them, are refused") {
    const auto refused = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_oxides(text, "xrf.csv")); });
    };
    const std::string head = "Oxide;FA1;FA2\n";
    for (const char* row : {"Leachate [mg/l];;\n", "Detection limits:;;\n", "water-soluble:;;\n"}) {
        const std::string rows = "SiO2;60;50\nAl2O3;30;40\n";
        CHECK(contains(refused(head + rows + row + "CaO;4;5\n"), "has no cells: it may head the rows below"));
        CHECK(contains(refused(head + row + rows), "has no cells: it may head the rows below"));
        CHECK(refused(head + rows + row).empty());
        CHECK(contains(refused("Sample;SiO2;Al2O3\nFA1;60;40\n" + std::string(row) + "FA2;50;50\n"),
                       "it may head the rows below it, or be a sample"));
    }
    for (const char* row : {"K2O;;\n", "Major oxides:;;\n", "As;;\n", "LOI;;\n", "Leachate;-;-\n"})
        CHECK(refused(head + "SiO2;60;50\nAl2O3;30;40\n" + row + "CaO;4;5\n").empty());
    CHECK(refused("XRF of FA1;;\nSiO2;60\nAl2O3;40\n").empty());
    CHECK(refused("Sample;SiO2;Al2O3\nFA1;60;40\nFA2;;\nFA3;50;50\n").empty());
    CHECK(contains(refused("Oxide;wt%;u;k\nSiO2;60;1;2\nAl2O3;40;1;2\n"), "states a coverage, 2"));
    CHECK(refused("Oxide;wt%;u;k\nSiO2;60;1;1\nAl2O3;40;1;1\n").empty());
    CHECK(contains(refused("Sample;SiO2;u;Al2O3;u;k\nFA1;60;1;40;1;2\n"), "states a coverage, 2"));
    CHECK(contains(refused("Oxide;wt%;u;Remark\nSiO2;60;1;k=2\nAl2O3;40;1;k=2\n"), "\"Remark: k=2\" states"));
    for (const char* level : {"Level", "Confidence level", "Niveau"})
        for (const char* names : {"Oxide;wt%;u;", "Oxide;FA1;esd;"})
            CHECK(contains(refused(std::string(names) + level + "\nSiO2;60;1;95\nAl2O3;40;1;95 %\n"),
                           "states a coverage, 95"));
    CHECK(
        contains(refused("Oxide;wt%;k\nSiO2;60 \u00b1 1;2\nAl2O3;40 \u00b1 1;2\n"), "states a coverage, 2"));
    CHECK(contains(refused("Oxide;wt%;-err;+err\nSiO2;60;1;2\nAl2O3;40;1;1\n"), "are not equal"));
    CHECK(contains(refused("Sample;SiO2;err-;err+;Al2O3\nFA1;60;1;2;40\n"), "are not equal"));
    for (const char* table :
         {"Oxide;wt%;-err;+err\nSiO2;60;1;1\nAl2O3;40;1;1\n", "Oxide;wt%;2 s.d.\nSiO2;60;2\nAl2O3;40;2\n",
          "Oxide;wt%\nSiO2;60 \u00b1 1 wt%\nAl2O3;40 \u00b1 1 wt%\n",

          "Oxide;wt% (95 %)\nSiO2;60 \u00b1 1.96\nAl2O3;40 \u00b1 1\n",
          "Sample;SiO2;err-;err+;Al2O3\nFA1;60;1;1;40\n"}) {
        CHECK_MESSAGE(refused(table).empty(), refused(table));
        CAPTURE(std::string(table));
        CHECK(only(table).analysis.oxides[0].standard_uncertainty.value_or(0) ==
              doctest::Approx(0.01).epsilon(1e-4));
    }
    CHECK(contains(refused("Oxide;FA1;\n;wt%;2\u03c3\nSiO2;60;2\nAl2O3;40;2\n"),
                   "line 2: \"2\u03c3\" in a second line of headings is not read"));
    CHECK(contains(refused("Oxide;wt% (95 %)\nSiO2;60\nAl2O3;40\n"),
                   "nothing has uncertainties of that coverage"));
    CHECK(tells(read_oxides("Oxide;wt%;Remark\nSiO2;60;\nAl2O3;40;as Al\n", "x.csv").warnings,
                "columns not used: \"Remark\" (\"as Al\")"));
}

TEST_CASE("oxides in columns: two samples, units in the headings, below them and not at all") {
    for (const char* text :
         {"Sample,SiO2 [wt%],Al2O3 [wt%],Fe2O3 (%),LOI [wt%]\nFA1,60,30,8,2\nFA2,50,40,8,2\n",
          "Sample;SiO2;Al2O3;Fe2O3;LOI\n;wt%;wt%;wt%;wt%\nFA1;60;30;8;2\nFA2;50;40;8;2\n",
          "Sample\tSiO2\tAl2O3\tFe2O3\tLOI\nFA1\t60\t30\t8\t2\nFA2\t50\t40\t8\t2\n",
          "Probe;SiO2;Al2O3;Fe2O3;GV\nFA1;0,6;0,3;0,08;0,02\nFA2;0,5;0,4;0,08;0,02\n",
          "Report 12\nin wt%\nSample,SiO2,Al2O3,Fe2O3,LOI,Total\nFA1,60,30,8,2,100\n"
          "FA2,50,40,8,2,100\n"}) {
        CAPTURE(text);
        const OxideResult result = read_oxides(text, "xrf.csv");
        REQUIRE(result.samples.size() == 2);
        CHECK(result.samples[0].name == "FA1");
        CHECK(near(per_cent_of(result.samples[0], "SiO2"), 60));
        CHECK(near(per_cent_of(result.samples[0], "Fe2O3"), 8));
        CHECK(near(per_cent_of(result.samples[1], "Al2O3"), 40));
        CHECK(near(loss_of(result.samples[1]), 2));
        CHECK_FALSE(result.samples[0].analysis.oxides[0].standard_uncertainty);
    }
}

TEST_CASE("oxides in rows: one amount, several samples, without a heading, as a spectrometer prints them") {
    for (const char* text :
         {"Oxide,wt%\nSiO2,60\nAl2O3,30\nFe2O3,8\nL.O.I.,2\nSum,100\n", "SiO2;60\nAl2O3;30\nFe2O3;8\nLOI;2\n",
          "Formula;Z;Concentration;Line 1;Net int.\nSiO2;14;60 %;Si KA1;12.3\nAl2O3;13;30 %;Al KA1;8.1\n"
          "Fe2O3;26;8 %;Fe KA1;90\nLOI;;2 %;;\n",
          "Compound,Conc. [%],Error\nSiO2,60,0.3\nAl2O3,30,0.2\nFe2O3,8,0.1\nLOI,2,0.1\n"}) {
        CAPTURE(text);
        const OxideSample sample = only(text);
        CHECK(sample.name == "xrf");
        CHECK(near(per_cent_of(sample, "SiO2"), 60));
        CHECK(near(per_cent_of(sample, "Al2O3"), 30));
        CHECK(near(loss_of(sample), 2));
    }
    CHECK(near(only("Compound,wt%,Error\nSiO2,60,0.3\nAl2O3,40,0.2\n")
                   .analysis.oxides[0]
                   .standard_uncertainty.value(),
               0.003));
    CHECK(near(only("Compound,wt%,2 sigma\nSiO2,60,0.3\nAl2O3,40,0.2\n")
                   .analysis.oxides[0]
                   .standard_uncertainty.value(),
               0.0015));
    CHECK(near(per_cent_of(only("Compound;m/m%;StdErr\nSiO2;60;0.3\nAl2O3;40;0.2\n"), "SiO2"), 60));
    const OxideResult both =
        read_oxides("Oxide;FA1;FA2\nSiO2 (reactive);35;30\nSiO2;60;50\nAl2O3;40;50\n", "xrf.csv");
    REQUIRE(both.samples.size() == 2);
    CHECK(both.samples[1].name == "FA2");
    CHECK(near(per_cent_of(both.samples[1], "SiO2"), 50));
}

TEST_CASE("uncertainties beside the oxides of a row, and in the cells") {
    const OxideSample beside = only("Sample,SiO2,SiO2 u,Al2O3,\u00b1\nFA1,60,0.6,40,0.4\n");
    CHECK(near(*beside.analysis.oxides[0].standard_uncertainty, 0.006));
    CHECK(near(*beside.analysis.oxides[1].standard_uncertainty, 0.004));
    const OxideSample within = only("Sample;SiO2;Al2O3\nFA1;60(1);40 \u00b1 0.4\n");
    CHECK(near(*within.analysis.oxides[0].standard_uncertainty, 0.01));
    CHECK(near(*within.analysis.oxides[1].standard_uncertainty, 0.004));
    for (const char* heading : {"s", "sigma"})
        CHECK(near(*only("Oxide;wt%;" + std::string(heading) + "\nSiO2;60;0.6\nAl2O3;40;0.4\n")
                        .analysis.oxides[0]
                        .standard_uncertainty,
                   0.006));
    CHECK_FALSE(only("Oxide;wt%;MU\nSiO2;60;0.6\nAl2O3;40;0.4\n").analysis.oxides[0].standard_uncertainty);
    // Each by its own unit, and by the coverage that the heading states.
    const OxideSample units = only("Oxide;wt%;\u00b1 [mg/kg]\nSiO2;60;6000\nAl2O3;40;4000\n");
    CHECK(near(*units.analysis.oxides[0].standard_uncertainty, 0.006));
    const OxideSample twice = only("Oxide;wt% (2\u03c3)\nSiO2;60 \u00b1 1.2\nAl2O3;40 \u00b1 0.8\n");
    CHECK(near(*twice.analysis.oxides[0].standard_uncertainty, 0.006));
}

TEST_CASE("rows of uncertainties behind the samples; rows of another kind are left out") {
    const std::string wide = "Sample,SiO2,Al2O3\nFA1,60,40\n";
    for (const auto& [row, u] : {std::pair{"esd,0.6,0.4\n", 0.006},
                                 {"SD,0.6,0.4\n", 0.006},
                                 {"FA1 \u00b1,0.6,0.4\n", 0.006},
                                 {"2s,0.6,0.4\n", 0.003},
                                 {"LOD,0.6,0.4\n", 0.0},
                                 {"RSD,0.6,0.4\n", 0.0}}) {
        CAPTURE(row);
        const OxideResult result = read_oxides(wide + row, "xrf.csv");
        REQUIRE(result.samples.size() == 1);
        CHECK(near(result.samples[0].analysis.oxides[0].standard_uncertainty.value_or(0), u));
        CHECK(tells(result.warnings, "line 3") == (u == 0));
    }
    const OxideResult last = read_oxides(wide + "FA2,50,50\nesd,0.6,0.4\n", "xrf.csv");
    CHECK(last.samples.size() == 2);
    CHECK(tells(last.warnings, "line 4 is no sample and left out: \"esd\""));
}

TEST_CASE("a line of text beside the table that states an amount is read, or refused") {
    const std::string down = "Oxide;wt%\nSiO2;60\nAl2O3;36,9\n";
    const std::string wide = "Sample;SiO2;Al2O3\nFA1;60;36,9\n";
    for (const std::string& table : {down, down + "\n", wide, wide + "\n"})
        for (const char* note : {"LOI = 3.1 %", "LOI: 3,1 wt%", "Gl\u00fchverlust 3.1 %",
                                 "LOI (950 \u00b0C): 3.1 wt%", "GV = 3.1", "LOI =3.1%", "LOI 3.1%",
                                 "LOI 950 \u00b0C = 3.1 %", "LOI = 3.1 \u00b1 0.2 %", "LOI = 31 g/kg"}) {
            CAPTURE(table + note);
            CHECK(near(loss_of(only(table + note + "\n")), 3.1));
        }
    CHECK(near(loss_of(only("LOI = 3.1 %\n" + down)), 3.1));
    for (const auto& [table, not_used] :
         {std::pair{down + "LOI;3,1 \u00b1 0,2\n", true},
          {down + "LOI = 3.1 \u00b1 0.2 %\n", true},
          {"Oxide;wt%;error\nSiO2;60;0.6\nAl2O3;36.9;0.4\nLOI;3.1;0.2\n", true},
          {down + "LOI;3,1\n", false},
          {down + "LOI;<0,1\n", false}}) {
        CAPTURE(table);
        const OxideSample sample = only(table);
        CHECK_FALSE(sample.analysis.loss_on_ignition.value().standard_uncertainty);
        CHECK(tells(sample.warnings, "the uncertainty of the LOI, 0.2 %, is not used") == not_used);
    }
    CHECK(near(per_cent_of(only(down + "MgO = 1.5 %\n"), "MgO"), 1.5));
    for (const char* note : {"LOI 950 \u00b0C", "SiO2+Al2O3 = 96.9 %", "XRF of pearls; 3 of them", "n = 3"})
        CHECK_FALSE(only(down + note + "\n").analysis.loss_on_ignition);
    for (const auto& [table, says] :
         {std::pair{wide + "FA2;50;40\nLOI = 3.1 %\n",
                    "line 4: \"LOI = 3.1 %\" may be of any of the samples"},
          {down + "LOI;3\nLOI = 3.1 %\n", "the loss on ignition is there twice"},
          {down + "LOI = 3.1 % (950 \u00b0C)\n", "may state the loss on ignition, and is not read"},
          {"Oxide,wt%\nSiO2,60\nAl2O3,36.9\nLOI = 3,1 %\n", "may state the loss on ignition"},
          {down + "all in mol%\n", "states fractions by mole"},
          {"Oxide;wt%;error\nSiO2;60;0.6\nAl2O3;40;0.4\nErrors are 2 sigma\n",
           "line 4: \"Errors are 2 sigma\" states"},
          {"# k=2\nSample;SiO2;Al2O3\nash;60;40\nesd;4;2\n", "and the row \"esd\" does not"},
          {"Sample;SiO2;Al2O3\nash;60;40\nesd;4;2\n\nUncertainties: k = 2\n", "and the row \"esd\" does not"},
          {"Oxide (2\u03c3);FA\nSiO2;60 \u00b1 4\nAl2O3;40 \u00b1 2\n", "and the heading \"FA\" of"},
          {"# mol%\n" + wide, "states fractions by mole"},
          {"Sample;SiO2;Al2O3\nash (mol%);60;40\n", "states fractions by mole"},
          {"Sample;Unit;SiO2;Al2O3\nash;mol%;60;40\n", "states fractions by mole"},
          {"Oxide;Mol-%;\n;FA1;FA2\nSiO2;60;50\nAl2O3;40;50\n", "states fractions by mole"},
          {"Oxid (Stoffmengenanteil);FA [%]\nSiO2;60\nAl2O3;40\n", "states fractions by mole"},
          {"Oxide;\u6469\u5c14%\nSiO2;60\nAl2O3;40\n", "no column holds amounts of oxides by weight"},
          {"Oxide;Molenbruch [%]\nSiO2;60\nAl2O3;40\n", "no column holds amounts of oxides by weight"}}) {
        const std::string message = input_error_of([&, &text = table] { return read_oxides(text, "x.csv"); });
        CHECK_MESSAGE(message.find(says) != std::string::npos, message);
    }
}

TEST_CASE("amounts in g/kg beside others in per cent are what they are") {
    const OxideSample sample = only("Sample;SiO2 [wt%];Al2O3 [wt%];P2O5 [g/kg]\nFA;60;39.6;4\n");
    CHECK(near(per_cent_of(sample, "P2O5"), 0.4));
}

TEST_CASE("what is below a limit, was not found, or was not determined") {
    const OxideSample sample =
        only("Sample,SiO2,Al2O3,MgO,MnO,P2O5,TiO2,Na2O\nFA1,60,38,<0.3,<LOD,n.d.,-,\n");
    CHECK(near(per_cent_of(sample, "MgO"), 0.15));
    CHECK(near(*sample.analysis.oxides[2].standard_uncertainty, 0.0015 / std::sqrt(3.0)));
    CHECK(per_cent_of(sample, "MnO") == 0);
    CHECK(per_cent_of(sample, "P2O5") == 0);
    CHECK(per_cent_of(sample, "TiO2") == -1);
    CHECK(per_cent_of(sample, "Na2O") == -1);
}

TEST_CASE("iron as FeO, as both and as a total; other forms; traces") {
    CHECK(std::abs(per_cent_of(only("Sample,SiO2,Al2O3,FeO\nA,60,30,9\n"), "Fe2O3") - 10.00212) < 1e-4);
    const std::string two = "Sample,SiO2,Al2O3,Fe2O3,FeO";
    for (const std::string& table : {two + "\nA,60,30,5,4\n", two + ",Total\nA,60,30,5,4,97\n"})
        CHECK(
            contains(input_error_of([&] { return only(table.c_str()).name; }),
                     "iron is there as Fe2O3 and FeO: Fe2O3 may be all of it, 5 % as Fe2O3, or a part of "));
    const OxideSample parts = only((two + ",LOI,Total\nA,60,30,5,4,1,99.98\n").c_str());
    CHECK(std::abs(per_cent_of(parts, "Fe2O3") - (5 + 4 * 1.111346)) < 1e-4);
    CHECK(tells(parts.warnings, "Fe2O3 and FeO are added, as in the total of the table"));
    const OxideSample all = only((two + ",Total\nA,60,30,5,4,95\n").c_str());
    CHECK(near(per_cent_of(all, "Fe2O3"), 5));
    CHECK(tells(all.warnings, "Fe2O3 is the total iron"));
    CHECK_FALSE(tells(all.warnings, "the total is given as"));
    const OxideSample total = only("Sample,SiO2,Al2O3,Fe2O3(t),FeO\nA,60,30,10,4\n");
    CHECK(near(per_cent_of(total, "Fe2O3"), 10));
    CHECK(tells(total.warnings, "Fe2O3(t) is the total iron"));
    CHECK(std::abs(per_cent_of(only("Sample,SiO2,Al2O3,S\nA,60,30,1\n"), "SO3") - 2.497099) < 1e-5);
    const OxideSample traces = only("Sample,SiO2,Al2O3,SrO [ppm],V [ppm],Cr [mg/kg]\nA,60,39,500,200,100\n");
    CHECK(near(per_cent_of(traces, "SrO"), 0.05));
    CHECK(tells(traces.warnings,
                "elements in ppm are traces and left out, together 0.03 % of the sample: V, Cr"));
}

TEST_CASE("a phase named for an oxide, and uncertainties that may be fractions") {
    CHECK(contains(input_error_of([&] { return only("Oxide,wt%\nSiO2,60\nAl2O3,30\nLime,5\n").name; }),
                   "\"Lime\" is not read as an oxide, and nothing else gives CaO; allowed: \"CaO\" for it"));
    CHECK(near(per_cent_of(only("Oxide,wt%\nSiO2,60\nAl2O3,30\nCaO,8\nLime,1\n"), "CaO"), 8));
    const std::string amounts = "Oxid;Anteil [%];";
    CHECK(tells(only((amounts + "Fehler\nSiO2;60;0.004\nAl2O3;38;0.003\n").c_str()).warnings,
                "the uncertainties, such as \"0.004\", are taken as per cent of the sample"));
    CHECK_FALSE(tells(only((amounts + "Fehler\nSiO2;60;0.4\nAl2O3;38;0.003\n").c_str()).warnings,
                      "the uncertainties, such as"));
}

TEST_CASE("a spreadsheet of an XRF laboratory, in both formats") {
    for (const char* file : {"oxides.xlsx", "oxides.ods"}) {
        CAPTURE(file);
        const OxideResult result =
            read_oxides(file_text(std::string(ASHIMPACT_TEST_DATA "/workbooks/") + file), file);
        REQUIRE(result.samples.size() == 2);
        CHECK(result.samples[0].name == "FA 1");
        CHECK(near(per_cent_of(result.samples[0], "SiO2"), 52.3));
        CHECK(near(per_cent_of(result.samples[0], "SO3"), 0.8));
        CHECK(near(loss_of(result.samples[0]), 3.1));
        CHECK(near(per_cent_of(result.samples[1], "CaO"), 8.7));
        CHECK(result.samples[0].warnings.empty());
        CHECK(oxide_sample(result, "FA2", true).name == "FA 2");
        CHECK(input_error_of([&] { return oxide_sample(result, "FA 3", false).name; }) ==
              "the oxides have no sample \"FA 3\"; allowed: FA 1, FA 2");
    }
}

TEST_CASE("names, units and marks that laboratories write: one oxide each") {
    struct Row {
        const char* table;
        const char* oxide;
        double per_cent;
    };
    for (const auto& [table, oxide, expected] : std::initializer_list<Row>{
             // Total iron, and sulfur.
             {"Sample,SiO2,Al2O3,Total Fe as Fe2O3\nx,60,30,9\n", "Fe2O3", 9},
             {"Sample,SiO2,Al2O3,TFe2O3\nx,60,30,9\n", "Fe2O3", 9},
             {"Sample,SiO2,Al2O3,T-Fe2O3\nx,60,30,9\n", "Fe2O3", 9},
             {"Oxide,wt%\nSiO2,60\nAl2O3,30\nFeO as Fe2O3,9\n", "Fe2O3", 9},
             {"Sample,SiO2,Al2O3,total S\nx,60,30,1\n", "SO3", 2.497099},
             // Units and words for a fraction before and behind the oxide.
             {"Sample,wt% SiO2,wt% Al2O3\nx,60,40\n", "SiO2", 60},
             {"Sample,w(SiO2)/%,w(Al2O3)/%\nx,60,40\n", "Al2O3", 40},
             {"Sample,SiO2_wt,Al2O3_wt\nx,60,40\n", "SiO2", 60},
             {"Sample,SiO2 mass fraction,Al2O3 mass fraction\nx,0.6,0.4\n", "SiO2", 60},
             {"Sample;SiO2 %;Al2O3 %;MnO ppm\nx;60;39,9;1 000\n", "MnO", 0.1},
             {"Sample;SiO2;Al2O3;V ppm\nunit;%;%;\nx;60;39,9;150\n", "SiO2", 60},
             {"Compound,Line,Conc.,Unit\nSiO2,KA,60,%\nAl2O3,KA,39.9,%\nMnO,KA,1000,ppm\nSr,KA,200,ppm\n",
              "MnO", 0.1},
             {"Oxide,Unit,FA\nSiO2,%,60\nMnO,ppm,1000\nAl2O3,%,39.9\n", "MnO", 0.1},
             // Per cent reach no thousand: three decimals are decimals.
             {"Sample;SiO2;Al2O3\nx;60,312;39,688\n", "SiO2", 60.312},
             // A year is the name of a column below "Oxide".
             {"Oxide,2023\nSiO2,60\nAl2O3,40\n", "SiO2", 60},
             // Two kinds of water add up.
             {"Sample,SiO2,Al2O3,H2O-,H2O+\nx,58,38,1,2\n", "H2O", 3},
             // Words beside an oxide that another column gives are other quantities.
             {"Sample,SiO2,Al2O3,reactive SiO2,SiO2/Al2O3\nx,60,40,35,1.5\n", "SiO2", 60}}) {
        CAPTURE(table);
        CHECK(std::abs(per_cent_of(only(table), oxide) - expected) < 1e-5);
    }
    for (const char* loss : {"w(LOI)/%", "wt% LOI", "\u70e7\u5931\u91cf", "Ig. loss", "LOI", "LOI (1000 C)",
                             "LOI @1050 \u00b0C", "Gl\u00fchverlust (950 \u00b0C)", "LOI1000"}) {
        CAPTURE(loss);
        CHECK(near(loss_of(only("Sample;SiO2;Al2O3;" + std::string(loss) + "\nx;57;38;5\n")), 5));
    }
    CHECK_FALSE(only("Sample,SiO2,Al2O3,LOI 550 C\nx,57,38,5\n").analysis.loss_on_ignition);
}

TEST_CASE("amounts of which some are per cent and others small and without a unit are refused") {
    CHECK(input_error_of([] {
              return only("Oxide;FA 7\nSiO2;60%\nAl2O3;39%\nNa2O;0.02\n").name;
          }).find("they may be fractions or per cent") != std::string::npos);
    CHECK(only("Oxide;FA 7\nSiO2;60%\nAl2O3;39%\nNa2O;n.d.\n").analysis.oxides.size() == 3);
}

TEST_CASE("the oxides of a sample are those of its name, with its marks") {
    const auto silica = [](const std::string& table, const std::string& name, bool must_match = true) {
        const OxideResult result = read_oxides("Sample,SiO2,Al2O3\n" + table, "xrf.csv");
        return per_cent_of(oxide_sample(result, name, must_match), "SiO2");
    };
    const std::string sieved =
        "FA >45 \u00b5m,60,40\nFA <45 \u00b5m,50,50\nFA-1.1,40,60\nFA-1a,30,70\nFA-1A,20,80\n";
    CHECK(near(silica(sieved, "FA >45 \u00b5m"), 60));
    CHECK(near(silica(sieved, "FA <45 \u00b5m"), 50));
    CHECK(near(silica(sieved, "FA -45 \u00b5m"), 50));
    CHECK(near(silica(sieved, "fa>45\u00b5m"), 60));
    CHECK(near(silica(sieved, "FA 1.1"), 40));
    CHECK(near(silica(sieved, "FA-1A"), 20));
    for (const char* other : {"FA +45 \u00b5m", "FA 45 \u00b5m", "FA-11", "fa 1a", "FA 1 .1", "FA1-1"}) {
        CAPTURE(other);
        CHECK_THROWS_WITH_AS(static_cast<void>(silica(sieved, other)),
                             doctest::Contains("the oxides have no sample"), InputError);
    }
    const OxideSample larger = only("Sample,SiO2,Al2O3\nFA >45,60,40\n");
    CHECK(other_sample_finding(larger, "FA <45"));
    CHECK(near(silica("FA >45,60,40\n", "FA <45", false), 60));
}

TEST_CASE("uncertainties of oxides that are no uncertainties of the sample are not taken for such") {
    for (const char* table : {"Oxide,Mass %,Error %\nSiO2,60,1.5\nAl2O3,40,1.5\n",
                              "Sample;SiO2 (%);Error (%);Al2O3 (%);Error (%)\nFA1;60;1;40;1\n"}) {
        CAPTURE(table);
        CHECK_THROWS_WITH_AS(static_cast<void>(only(table)),
                             doctest::Contains("may be of the sample or of the amount"), InputError);
    }
    for (const char* heading : {"wt% \u00b1 RSD %", "wt% \u00b1 %", "wt% \u00b1 error %", "wt% \u00b1 U",
                                "wt% (U)", "wt% (n)", "wt% (RSD)", "wt% (2SE)", "Gew.-% (Nachweisgrenze)"}) {
        CAPTURE(heading);
        const OxideResult result = read_oxides(
            "Oxide;" + std::string(heading) + "\nSiO2;60 \u00b1 0.6\nAl2O3;40 \u00b1 0.4\n", "t.csv");
        CHECK_FALSE(result.samples[0].analysis.oxides[0].standard_uncertainty);
        CHECK(tells(result.warnings, "are not read, as"));
    }
    for (const char* heading : {"wt% (SD)", "wt% \u00b1 SD", "wt% (mean)", "wt% (1 sigma)"}) {
        CAPTURE(heading);
        CHECK(near(*only("Oxide;" + std::string(heading) + "\nSiO2;60 \u00b1 0.6\nAl2O3;40 \u00b1 0.4\n")
                        .analysis.oxides[0]
                        .standard_uncertainty,
                   0.006));
    }
    CHECK_THROWS_WITH_AS(
        static_cast<void>(only("Sample;SiO2;Al2O3\nFA 7 \u00b1 2\u03c3;60 \u00b1 0.6;40 \u00b1 0.4\n")),
        doctest::Contains("the coverage in the heading"), InputError);
    for (const char* name : {"FA 7 mol", "FA7Vol"})
        CHECK_THROWS_WITH_AS(static_cast<void>(only("Sample;SiO2;Al2O3\n" + std::string(name) + ";60;40\n")),
                             doctest::Contains("states fractions by"), InputError);
    const OxideSample above = only("Sample,SiO2,Al2O3,Na2O,Total\nFA1,60,39.4,0.6,100(2)\nerror,0.5,1,5,\n");
    CHECK(tells(above.warnings, "the uncertainty of Na2O, 5 %, is above its amount, 0.6 %: is it one?"));
    CHECK(tells(above.warnings, "the uncertainty of the total is not used"));
}

TEST_CASE("numbers below no heading are refused, texts are told") {
    for (const char* table :
         {"Sample,SiO2,Al2O3\nFA1,60,37,3.0\n", "Sample,SiO2,Al2O3,\nFA1,60,37,3.0\n",
          "Sample,SiO2,Al2O3,Cr2O3\nFA1,60,37,0,05\n", "Oxide,wt%\nSiO2,60\nAl2O3,37,3\n"}) {
        CAPTURE(table);
        CHECK_THROWS_WITH_AS(static_cast<void>(only(table)), doctest::Contains("stands below no heading"),
                             InputError);
    }
    for (const char* table : {"Oxide,wt%\nSiO2,60,3\nAl2O3,37,7\n", "Oxide;wt%;\nSiO2;60;0.5\nAl2O3;37;0.4\n",
                              "Sample;SiO2;;Al2O3;\nFA1;60;0.5;37;0.4\n"}) {
        CAPTURE(table);
        CHECK_THROWS_WITH_AS(static_cast<void>(only(table)), doctest::Contains("stands below no heading"),
                             InputError);
    }
    CHECK(tells(read_oxides("Oxide;wt%\nSiO2;60;see note\nAl2O3;37\n", "t.csv").warnings, "is not read"));
    CHECK_THROWS_WITH_AS(static_cast<void>(read_oxides("Sample;SiO2;Al2O3\n;60;40\nFA1;61;39\n", "t.csv")),
                         doctest::Contains("names no sample, and others do"), InputError);
    CHECK_THROWS_WITH_AS(static_cast<void>(only("Sample;SiO2;Al2O3\nFA1;60;37;excluded\n")),
                         doctest::Contains("calls the row invalid"), InputError);
    CHECK(tells(read_oxides("Sample;SiO2;Al2O3\nFA1;60;37;LOI 3.0 %\n", "t.csv").warnings,
                "below no heading, is not read: \"LOI 3.0 %\""));
    CHECK(near(per_cent_of(only(",Sample,SiO2,Al2O3\n0,FA1,60,40\n"), "SiO2"), 60));  // an index of rows
}

TEST_CASE("oxides of a sample of another name are told") {
    const OxideSample named = only("Sample,SiO2,Al2O3\nFA 1,60,40\n");
    CHECK(other_sample_finding(named, "FA 2")->text == "the oxides are those of the sample \"FA 1\"");
    CHECK_FALSE(other_sample_finding(named, "fa1"));
    CHECK_FALSE(other_sample_finding(only("SiO2,60\nAl2O3,40\n"), "FA 2"));
}

TEST_CASE("uncertainties beside the name of a sample or oxide are read, or what they are is told") {
    const auto first = [](const std::string& table) {
        OxideResult result = read_oxides(table, "t.csv");
        OxideSample sample = result.samples.front();
        sample.warnings.insert(sample.warnings.end(), result.warnings.begin(), result.warnings.end());
        return sample;
    };
    const auto down = [&](const std::string& heading) {
        return first("Oxide;FA1;" + heading + ";FA2\nSiO2;60;0.6;50\nAl2O3;40;0.4;50\n");
    };
    const auto across = [&](const std::string& heading) {
        return first("Sample;SiO2;" + heading + ";Al2O3\nFA1;60;0.6;40\n");
    };
    for (const auto& [word, factor] : {std::pair{"esd", 1.0}, std::pair{"SD", 1.0}, std::pair{"2 esd", 2.0},
                                       std::pair{"2s", 2.0}, std::pair{"unc.", 1.0}}) {
        const std::string behind = word;
        CAPTURE(behind);
        for (const OxideSample& sample : {down("FA1 " + behind), across("SiO2 " + behind)})
            CHECK(near(100 * sample.analysis.oxides.front().standard_uncertainty.value(), 0.6 / factor));
    }
    for (const char* word : {"SE", "U", "RSD", "CI95"}) {
        CAPTURE(word);
        for (const OxideSample& sample :
             {down("FA1 " + std::string(word)), across("SiO2 " + std::string(word))}) {
            CHECK_FALSE(sample.analysis.oxides.front().standard_uncertainty);
            CHECK(tells(sample.warnings, "are not read, as"));
        }
    }
    CHECK(tells(down("FA1 wet").warnings, "\"FA1 wet\" is not read as uncertainties of \"FA1\""));
}

TEST_CASE("oxides of the crystalline part, by two methods and with relative errors are refused") {
    const auto refused = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_oxides(text, "xrf.csv")); });
    };
    for (const auto& [table, place] : {std::pair{"Oxide;wt%\nSiO2 crystalline;60\nAl2O3;40\n", "line 2"},
                                       {"Oxide;wt%\nSiO2;60\nAl2O3 (cryst.);40\n", "line 3"},
                                       {"Oxide;wt% (crystalline)\nSiO2;60\nAl2O3;40\n", "line 1"},
                                       {"Sample;SiO2 crystalline;Al2O3\nFA1;60;40\n", "line 1"}})
        CHECK_MESSAGE(contains(refused(table), place), refused(table));
    for (const char* table :
         {"Oxide;XRF wt%;SEM wt%\nSiO2;60;59\nAl2O3;40;41\n", "Sample;SiO2;Al2O3\nXRF;60;40\nSEM;59;41\n"})
        CHECK(contains(refused(table), "standard errors of the mean, or amounts by scanning electron"));
    CHECK(
        near(*only("Oxide;wt%;SEM\nSiO2;60;2\nAl2O3;40;2\n").analysis.oxides[0].standard_uncertainty, 0.02));
    for (const char* heading : {"error in percent", "Fehler in Prozent", "Error pct", "Fehler [Prozent]"})
        for (const char* amounts : {"wt%", "g/kg"})
            CHECK(contains(
                refused(std::string("Oxide;") + amounts + ";" + heading + "\nSiO2;60;2\nAl2O3;40;2\n"),
                "may be of the sample or of the amount"));
    CHECK_FALSE(
        tells(read_oxides("Sample;SiO2;Al2O3\n#1;60;40\n#2;59;41\n", "xrf.csv").warnings, "a comment"));
}

TEST_CASE("a total that does not fit is doubted") {
    CHECK(tells(only("Oxide,wt%\nSiO2,60\nAl2O3,30\nTotal,99\n").warnings, "the total is given as 99 %"));
    CHECK_FALSE(tells(only("Oxide,wt%\nSiO2,60\nAl2O3,30\nTotal,90.2\n").warnings, "the total"));
}

TEST_CASE("a text beside the table that the oxides are those of the ignited sample counts") {
    const auto received = [](const std::string& silica, const std::string& loss) {
        std::vector<Finding> notes;
        const OxideAnalysis analysis = as_received(
            only("# loss-free basis\nOxide;wt%\nSiO2;" + silica + "\nAl2O3;40\n" + loss).analysis, notes);
        return std::pair{100 * analysis.oxides.front().fraction, notes};
    };
    CHECK(received("58.5", "LOI;3\n").first ==
          doctest::Approx(58.5 * 0.97));  // the sum alone does not decide
    CHECK(only("# LOI: ignited at 950 \u00b0C\nOxide;wt%\nSiO2;57\nAl2O3;40\nLOI;3\n")
              .analysis.ignited.empty());
    CHECK(tells(received("60", "").second, "states oxides of the ignited sample, and no LOI is given"));
    const std::string message = input_error_of([&] { return received("55", "LOI;5\n").first; });
    CHECK_MESSAGE(message.find("they add up to 95 % without the LOI, to 100 % with it") != std::string::npos,
                  message);
}

TEST_CASE("units and signs in the cells of an analysis") {
    const OxideSample sample = only("Oxide;wt%;\u00b1\nSiO2;60 wt%;\u00b10.4\nAl2O3;40 Gew.-%;+/-0.4\n");
    CHECK(near(per_cent_of(sample, "SiO2"), 60));
    CHECK(sample.analysis.oxides[1].standard_uncertainty.value() == doctest::Approx(0.004));
    CHECK(input_error_of([] {
              return only("Oxide;ppm\nSiO2;60 %\nAl2O3;40 %\n").name;
          }).find("a cell is per cent, and \"ppm\" states another unit") != std::string::npos);
}

TEST_CASE("tables that are no chemical analysis are refused in one line with the place") {
    const auto refusal = [](std::string_view text) {
        const std::string message =
            input_error_of([&] { return read_oxides(text, "xrf.csv").samples.size(); });
        CHECK(message.starts_with("xrf.csv: "));
        CHECK(message.find('\n') == std::string::npos);
        return message;
    };
    const auto says = [](const std::string& message, std::string_view text) {
        CAPTURE(message);
        return message.find(text) != std::string::npos;
    };
    CHECK(
        says(refusal("Sample,SiO2,Al2O3,SiO3\nA,60,30,5\n"), "line 1, cell 4: no oxide is called \"SiO3\""));
    CHECK(says(refusal("Sample,SiO2,Al2O3,Fe\nA,60,30,5\n"), "Fe is an element"));
    CHECK(says(refusal("Sample,SiO2,Al2O3\nA,60,-3\n"), "line 2, cell 3: the amount of Al2O3 is -3"));
    CHECK(says(refusal("Sample,SiO2,Al2O3\nA,60,much\n"), "cannot read \"much\""));
    CHECK(says(refusal("Sample,SiO2 [mol%],Al2O3 [mol%]\nA,60,40\n"), "the amounts are in mol%"));
    CHECK(says(refusal("Sample,SiO2 [counts],Al2O3 [counts]\nA,60,40\n"), "the amounts are in \"counts\""));
    CHECK(says(refusal("Sample,SiO2 [at%],Al2O3 [at%]\nA,60,40\n"), "the amounts are in \"at%\""));
    CHECK(says(refusal("Sample,SiO2,Al2O3,MgO\nA,60,39,<blah\n"), "cannot read \"<blah\""));
    CHECK(says(refusal("Sample,SiO2,\u00b1 [ppm],Al2O3,\u00b1\nA,60,600,40,0.4\n"),
               "has a unit and its amount has none"));
    CHECK(says(refusal("Sample,SiO2,Al2O3,SiO2\nA,30,40,30\n"), "SiO2 is there twice"));
    CHECK(says(refusal("Sample,SiO2,Fe2O3,Fe2O3\nA,30,40,30\n"), "iron is there more than once"));
    CHECK(says(refusal("Sample,SiO2,Al2O3\nA,60,40\nA,50,50\n"), "the sample \"A\" is there twice"));
    CHECK(says(refusal("phase,weight %\nquartz,60\nmullite,40\n"), "no two oxides are named"));
    CHECK(says(refusal("Oxide;wt%;\u00b1\nSiO2;60 \u00b1 0.1;1\nAl2O3;40;1\n"), "state an uncertainty"));
    CHECK(says(refusal("Oxide;wt%;Fehler [%]\nSiO2;60;1\nAl2O3;40;1\n"), "of the sample or of the amount"));
    CHECK(says(refusal("Oxide;kcps\nSiO2;60\nAl2O3;40\n"), "no column holds amounts of oxides"));
    CHECK(says(refusal("Sample,SiO2,Al2O3\n"), "there are no amounts of oxides"));
    CHECK(says(refusal("Oxide;wt%;% error\nSiO2;60;1\nAl2O3;40;1\n"), "of the sample or of the amount"));
    CHECK(says(refusal("Oxid;Gehalt;Einheit;u;Einheit\nSiO2;60;%;2;% rel.\nAl2O3;40;%;2;% rel.\n"),
               "line 2, cell 5: \"% rel.\" in column \"Einheit\" is not the unit of the amounts"));
    CHECK(says(refusal("SiO2;60;%\nAl2O3;39;%\nCr2O3;0.9;ppm\n"), "\"ppm\" in column"));
    CHECK(says(refusal("Sample;Unit;SiO2;Al2O3\nA;g/kg;60;40\n"), "\"g/kg\" in column \"Unit\""));
    CHECK(says(refusal("Oxid;Gehalt;u\nSiO2;60 %;0.02\nAl2O3;40 %;0.02\n"), "it may be 0.02 % or 2 %"));
    const std::string long_title = "Analysis of the fly ash from the electrostatic precipitator of unit 3, ";
    CHECK(says(refusal(long_title + "LOI = 3.1 %\nOxide;wt%\nSiO2;60\nAl2O3;35\n"),
               "may state the loss on ignition, and is not read"));
    CHECK(says(refusal(long_title + "in mg/kg\nOxide;Gehalt\nSiO2;60\nAl2O3;40\n"), "states mg/kg, and the"));
    CHECK(says(refusal("Sample;SiO2;Al2O3;esd;esd\nx;60;40;1;1\n"), "they may be of any oxide"));
    for (const char* loss : {"LOI, 2h", "Gl\u00fchverlust roh"})
        CHECK(says(refusal("Sample;SiO2;Al2O3;" + std::string(loss) + "\nx;60;35;5\n"),
                   "may be the loss on ignition, and nothing else gives it"));
    // Amounts that would be lost: no other column or row gives that oxide.
    for (const char* lost : {"MgO (corr.)", "MgO\u00b9", "Mg0", "MgO+SrO"})
        for (const std::string& table : {"Sample;SiO2;Al2O3;" + std::string(lost) + "\nx;60;35;5\n",
                                         "Oxide;wt%\nSiO2;60\nAl2O3;35\n" + std::string(lost) + ";5\n"})
            CHECK(says(refusal(table), "is not read as an oxide, and nothing else gives MgO"));
    CHECK(says(refusal("Sample,SiO2,Al2O3,Fe total\nx,60,30,7\n"),
               "nothing else gives Fe2O3; allowed: \"Fe2O3(t)\""));
    CHECK(says(refusal("Sample (mol%),SiO2,Al2O3\nx,60,40\n"), "states fractions by mole"));
    CHECK(says(refusal("Sample,SiO2,Al2O3,A" + std::string(200'000, '1') + "\nx,60,40,1\n"),
               "line 1, cell 4: the cell is too long"));
    for (const char* title : {"Results in mol%", "Mole percent"})
        CHECK(says(refusal(std::string(title) + "\nSample,SiO2,Al2O3\nA,60,40\n"),
                   "line 1: \"" + std::string(title) + "\" states fractions by mole"));
    CHECK(says(refusal("Sample;SiO2;MnO [ppm]\nA;99.5;4.000\nB;99.4;950\n"), "\"4.000\" is 4.000 or 4000"));
    CHECK_FALSE(refusal("").empty());
}

TEST_CASE("the oxides of a case") {
    const auto read = [](const char* text) {
        const Json json = parse_json(text);
        return read_oxides_json(View(json));
    };
    const OxideAnalysis plain =
        read(R"({"SiO2": "52.1 +- 0.4 %", "Al2O3": 0.3, "FeO": "9 %", "LOI": "2 %"})");
    REQUIRE(plain.oxides.size() == 3);
    CHECK(near(*plain.oxides[0].standard_uncertainty, 0.004));
    CHECK(plain.oxides[2].oxide == "Fe2O3");
    CHECK(near(plain.loss_on_ignition->fraction, 0.02));
    const OxideAnalysis list = read(R"([{"oxide": "SiO2", "weight_fraction": "60 %"},
                                        {"oxide": "Al2O3", "weight_fraction": "40 %"}])");
    CHECK(near(list.oxides[1].fraction, 0.4));
    CHECK(contains(input_error_of([&] { return read(R"({"Fe2O3": "5 %", "FeO": "4 %"})").oxides; }),
                   "iron is there as one form and \"FeO\""));
    CHECK(
        contains(input_error_of([&] { return read(R"({"SiO2": "50 % +- 2 %"})").oxides; }),
                 "/SiO2: in \"50 % +- 2 %\" the uncertainty is 2 % of the whole, or of the value, 1 % of the "
                 "whole; allowed: \"50 +- 2 %\" or \"50 +- 1 %\""));
    CHECK(input_error_of([&] { return read(R"({"SiO2": 52.1})").oxides; }) ==
          "/SiO2: the fraction is 5210 %; allowed: 0 % to 100 % (0 to 1), as \"52.1 %\"");
    for (const char* loss :
         {R"("2.0 +- 0.5 %")", R"({"value": 2, "unit": "%", "standard_uncertainty": 0.5})"})
        CHECK(input_error_of([&] {
                  return read((R"({"SiO2": "98 %", "LOI": )" + std::string(loss) + "}").c_str()).oxides;
              }) == "/LOI: states an uncertainty, which nothing here uses; allowed: the loss alone");
    CHECK(input_error_of([&] { return read(R"({"SiO3": 0.5})").oxides; }).find("nearest: SiO2") !=
          std::string::npos);
}

}  // namespace ashimpact::test
