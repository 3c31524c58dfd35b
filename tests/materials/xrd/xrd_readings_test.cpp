// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <doctest/doctest.h>

#include "core/text/text.hpp"
#include "materials/xrd/xrd.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"
#include "tests/support/marked_tables.hpp"

namespace ashimpact::test {

namespace {

std::string refusal(const std::string& table) {
    return input_error_of(
        [&] { return compose(read_xrd(table, "t.csv").samples.front().analysis, shipped_catalogue()); });
}

XrdSample first_of(const std::string& table) {
    CAPTURE(table);
    return read_xrd(table, "t.csv").samples.front();
}

std::string told(const std::string& table) {
    const XrdResult result = read_xrd(table, "t.csv");
    std::string text = joined(texts_of(result.warnings));
    for (const XrdSample& sample : result.samples) text += joined(texts_of(sample.warnings));
    return text;
}

}  // namespace

TEST_CASE("no text in a table of a composition vanishes") {
    for (const Cells& rows :
         {Cells{{"Phase", "wt%"}, {"Quartz", "20"}, {"Mullite", "30"}, {"Amorphous", "50"}},
          Cells{{"Phase", "FA1", "esd", "FA2", "esd"},
                {"Quartz", "20", "1", "10", "1"},
                {"Amorphous", "80", "2", "90", "2"}},
          Cells{{"Sample", "Quartz", "Amorphous"}, {"FA1", "20", "80"}, {"FA2", "10", "90"}},
          Cells{{"Sample", "Quartz", "Amorphous"},
                {"FA1", "20", "80"},
                {"SD", "1", "2"},
                {"FA2", "10", "90"},
                {"SD", "1", "1"}},
          Cells{{"Sample", "Phase", "wt%"},
                {"FA1", "Quartz", "20"},
                {"FA1", "Amorphous", "80"},
                {"FA2", "Quartz", "10"},
                {"FA2", "Amorphous", "90"}},
          Cells{{"Phase", "I", "RIR"}, {"Quartz", "1234.5", "3.1"}, {"Mullite", "540.5", "0.7"}},
          Cells{{"Phase", "wt%", "Remark"}, {"Quartz", "20", ""}, {"Amorphous", "80", ""}}})
        check_marked(rows, [](const std::string& table) {
            const XrdResult result = read_xrd(table, "t.csv");
            std::string told = joined(texts_of(result.warnings)) + result.reading;
            for (const XrdSample& sample : result.samples) {
                told += sample.name + joined(texts_of(sample.warnings));
                for (const PhaseFraction& phase : sample.analysis.phases) told += phase.name;
            }
            return told;
        });
}

TEST_CASE("what each column of a composition is taken as is stated") {
    const auto reading = [](const std::string& table) { return read_xrd(table, "t.csv").reading; };
    const std::string rows = "\nQuartz;20;1;30;2\nGlass;80;1;70;2\n";
    CHECK(reading("Phase;FA1 [wt%];esd;FA2 [wt%];FA2 (2s)" + rows) ==
          "2 samples; phases: \"Phase\"; amounts by weight, in %: \"FA1 [wt%]\", \"FA2 [wt%]\"; "
          "standard uncertainties: \"esd\" of \"FA1 [wt%]\", \"FA2 (2s)\" of \"FA2 [wt%]\" divided by 2");
    CHECK(reading("Phase;vol%;esd;density [g/cm3]\nQuartz;20 \u00b1 1;;2.6\nGlass;80;;2.5\n") ==
          "1 sample; standard uncertainties in the cells or in rows; phases: \"Phase\"; amounts by volume, "
          "in %: "
          "\"vol%\"; standard uncertainties: \"esd\" of \"vol%\"; densities: \"density [g/cm3]\"");
    CHECK(reading("Phase;intensity;RIR\nQuartz;100;3.4\nMullite;50;0.8\n") ==
          "1 sample; phases: \"Phase\"; net intensities: \"intensity\"; reference intensity ratios: \"RIR\"");
    CHECK(reading("Sample;Quartz [g/kg];Glass [g/kg]\nA;200;800\n") ==
          "1 sample; samples: \"Sample\"; amounts by weight, in parts per thousand: \"Quartz [g/kg]\", "
          "\"Glass [g/kg]\"");
    CHECK(reading("phase;A1 [wt%];A2 [wt%];A3 [wt%];A4 [wt%];A5 [wt%];A6 [wt%];A7 [wt%];A8 [wt%];A9 [wt%];"
                  "B1 [wt%];B2 [wt%];B3 [wt%];B4 [wt%]\nQuartz;1;1;1;1;1;1;1;1;1;1;1;1;1\n")
              .ends_with("\"B3 [wt%]\", and 1 more"));
}

TEST_CASE("units, factors and coverages behind names of phases are refused") {
    const auto refused = [](const std::string& unit, const std::string& name) {
        return contains(refusal("Phase;" + unit + "\n" + name + ";20\nGlass;80\n"), " in the name ");
    };
    for (const char* inside :
         {"\u2030",   "ppmw",     "wppm",           "mass ppm", "\u043c\u0433/\u043a\u0433",
          "mg/100 g", "o/oo",     "10\u207b\u00b3", "per mil",  "parts per thousand",
          "1/1000",   "1:1000",   "0.001",          "1,000",    "U = 2u",
          "2u",       "2uc",      "2 \u03c3",       "2-sig",    "k\u00b7u",
          "s x 2",    "Faktor 2", "expanded"})
        CHECK_MESSAGE(refused("wt%", std::string("Lime (") + inside + ")"), std::string(inside));
    for (const char* behind :
         {", \u2030", ", mg/kg", ", ppm", ", g/kg", ", x10", ", \u00d7 10", ", /10", ", at.%", ", rel. %"})
        CHECK_MESSAGE(refused("wt%", std::string("Lime") + behind), behind);
    for (const char* per_cent : {" %", " [%]", ", %", "/%", "_%", ": %", " (Prozent)", ", wt%"})
        CHECK_MESSAGE(
            !refusal(std::string("Phase;Content [g/kg]\nLime") + per_cent + ";200\nGlass;800\n").empty(),
            per_cent);
    for (const char* name :
         {"Quartz (low)", "Mullite (3:2)", "Quartz (ICSD 174)", "Quartz (wt%)", "Quartz, low",
          "Gypsum (CaSO4\u00b72H2O)", "Quartz (46-1045)", "Quartz, %", "Goethite (\u03b1-FeOOH)"})
        CHECK_MESSAGE(refusal(std::string("Phase;wt%\n") + name + ";20\nGlass;80\n").find(" in the name ") ==
                          std::string::npos,
                      name);
    CHECK(
        first_of(
            "Phase;FA1 (k\u00a0=\u00a02) [wt%]\nQuartz;20\u00a0\u00b1\u00a01\nGlass;80\u00a0\u00b1\u00a01\n")
            .analysis.phases[0]
            .standard_uncertainty.value() == doctest::Approx(0.005));
}

TEST_CASE("names of samples that join a number and more are quoted") {
    for (const char* name :
         {"FA1_10MgO", "FA1-10MgO", "FA1-MgO10", "FA1 10MgO", "FA1MgO", "FA1_10NaCl", "FA1_periclase10",
          "FA1_IS10", "FA1_10IS", "FA1std10", "10MgO_FA1", "FA1spiked", "FA1_spiked10"}) {
        const std::string text = told(std::string("Sample;Quartz;Glass\n") + name + ";20;80\nFA2;20;80\n");
        CHECK_MESSAGE(contains(text, std::string("\"") + name + "\""), text);
    }
    for (const char* name : {"FA1", "FA1a", "FlyAsh2", "Ash_12", "KW5-2b", "S2"}) {
        const std::string text = told(std::string("Sample;Quartz;Glass\n") + name + ";20;80\nFA2;20;80\n");
        CHECK_MESSAGE(!contains(text, "as names of samples alone"), text);
    }
}

TEST_CASE("remarks of a column that is not used are quoted behind many words") {
    const std::string text = told(
        "Phase;wt%;Remark\nQuartz;20;a\nMullite;20;b\nHematite;20;c\nLime;20;d\n"
        "Anhydrite;20;value x 10\n");
    CHECK(contains(text, "column \"Remark\" is not used: \"a\", \"b\", \"c\", \"value x 10\", ..."));
}

TEST_CASE("rows of remarks in a table are texts beside it") {
    const std::string rows = "\nQuartz;20;10\nGlass;80;90\n";
    for (const char* remark :
         {"Comment;ok;by volume", "Note;wt%;vol%", "Bemerkung;;Mol-%", "* a;by volume;"}) {
        CAPTURE(remark);
        CHECK_FALSE(refusal("Phase;FA1;FA2" + rows + remark + "\n").empty());
    }
    CHECK(contains(told("Phase;FA1;FA2" + rows + "Comment;;spiked with 10 % ZnO\n"),
                   "may state an added standard"));
    CHECK(contains(told("Phase;FA1;FA2" + rows + "Comment;dry;coarse\n"),
                   "line 4 below the table is not read: \"Comment;dry;coarse\""));
    CHECK(contains(told("Phase;FA1;FA2\nRwp;low;4.2\nQuartz;20;10\nGlass;80;90\n"),
                   "line 2 is no phase and left out: \"Rwp\" (\"low\")"));
}

TEST_CASE("a footnote under a table, a column of places and an unnamed column of phases") {
    for (const char* note : {"* near the limit", "a) by difference", "1) fixed", "\u2020 estimated"}) {
        const std::string table = std::string("Phase;wt%\nQuartz;20\nGlass;80\n") + note;
        CHECK(contains(told(table + "\n"), std::string("line 4 below the table is not read: \"") + note));
        CHECK(contains(told(table + ";\n"), "line 4 below the table is not read"));
        CHECK(first_of(table).analysis.phases.size() == 2);
    }
    CHECK_FALSE(refusal("Phase;wt%\nQuartz;20\nGlass;80\nx y\n").empty());
    const std::string places = "Sample;Location;Quartz;Glass\nA;north;20;80\nB;south;30;70\n";
    CHECK(contains(told(places), "column \"Location\" is not used: \"north\", \"south\""));
    CHECK(read_xrd(places, "t.csv").samples[1].analysis.phases[0].fraction == doctest::Approx(0.3));
    CHECK_FALSE(refusal("Sample;Quartz;Glass\nA;n.d.;80\nB;south;70\n").empty());
    const std::string unnamed = ";A [wt%];esd;B [wt%]\nQuartz;20;1;30\nGlass;80;2;70\n";
    const XrdResult result = read_xrd(unnamed, "t.csv");
    REQUIRE(result.samples.size() == 2);
    CHECK(result.samples[0].analysis.phases[1].standard_uncertainty.value() == doctest::Approx(0.02));
    CHECK(contains(result.reading, "phases: a column without a heading"));
    CHECK_FALSE(refusal(";A;B\nQuartz;20;30\nGlass;80;70\n").empty());
    CHECK_FALSE(refusal(";Quartz [wt%];Glass [wt%]\nA;20;80\nB;30;70\n").empty());
}

TEST_CASE("a column that is not used does not scale the amounts") {
    for (const char* column : {"Hg ppm", "Cl mg/kg", "Cl [g/kg]", "Cl \u2030", "microstrain [ppm]"}) {
        for (const auto& [heading, amount] :
             {std::pair{"wt%;", "12.3;"}, {"Amount;", "12.3;"}, {"wt%;", "12.3 %;"}}) {
            const std::string table =
                std::string("Phase;") + heading + column + "\nQuartz;" + amount + "400\n";
            CHECK(first_of(table).analysis.phases[0].fraction == doctest::Approx(0.123));
            CHECK(contains(told(table), std::string("column \"") + column + "\" is not used"));
        }
    }
    CHECK(first_of("Phase;Cl [g/kg];wt%;esd [wt%]\nQuartz;4;12.3;0.4\n")
              .analysis.phases[0]
              .standard_uncertainty.value() == doctest::Approx(0.004));
    for (const char* column : {"strain [%]", "error %", "error in percent"}) {
        const std::string rows = "\nQuartz;0.123;3\nMullite;0.877;2\n";
        const XrdSample sample = first_of(std::string("Phase;Amount;") + column + rows);
        CHECK(sample.analysis.phases[0].fraction == doctest::Approx(0.123));
        CHECK_FALSE(sample.analysis.phases[0].standard_uncertainty);
    }
    CHECK(contains(refusal("Phase;Amount;esd [wt%]\nQuartz;0.123;3\nGlass;0.877;2\n"), "state another unit"));
    CHECK(contains(refusal("Phase;Amount;esd [g/kg]\nQuartz;20 %;3\nGlass;80 %;2\n"), "state another unit"));
    CHECK(told("Phase;wt%;size (crystalline)\nQuartz;20;9\nGlass;80;\n").find("crystalline part") ==
          std::string::npos);
}

TEST_CASE("amounts in two units, in headings or names of samples, are refused") {
    for (const char* table :
         {"Phase;FA1 [fraction];FA2 [wt%]\nQuartz;0.123;12.3\n",
          "Sample;Quartz [1];Mullite [%]\nA;0.123;28.4\n", "Phase;FA1;FA2\n;fraction;%\nQuartz;0.123;12.3\n"})
        CHECK(contains(refusal(table), "are not in one unit"));
    for (const char* table : {"Sample;Quartz [wt%];Glass [wt%]\nFA1 [g/kg];12.3;87.7\n",
                              "Sample;Phase;wt%\nFA1 [ppm];Quartz;12.3\n", "Sample;Quartz\nFA1 [%];0.123\n",
                              "Sample;Quartz\nFA1 [fraction];0.123\nFA2 [%];12.3\n"})
        CHECK(contains(refusal(table), "and the amounts are read in another unit"));
    CHECK(first_of("Sample;Quartz;Glass\nFA1 [%];12.3;87.7\n").analysis.phases[0].fraction ==
          doctest::Approx(0.123));
    CHECK(refusal("Size fraction 2\nSample;Quartz;Glass\nfine fraction;12.3;87.7\n").empty());
    const std::string rows = "\nQuartz;20\nGlass;80\n";
    for (const char* column : {"FA1 at. %", "FA1 rel. int. %", "FA1 \u043c\u043e\u043b\u044c\u043d. %"})
        CHECK(
            contains(refusal("Phase;" + std::string(column) + rows), "holds no weight or volume fractions"));
    for (const char* column : {"FA1, \ubd80\ud53c %", "FA1, \u4f53\u79ef\u6bd4 %"})
        CHECK(first_of("Phase;" + std::string(column) + rows).analysis.basis == FractionBasis::volume);
    CHECK_FALSE(first_of("Phase;Amount [fraction];error [%]\nQuartz;0.123;3\n")
                    .analysis.phases[0]
                    .standard_uncertainty);
    const XrdSample peaks = first_of("Phase;I [%];esd [%];RIR\nQuartz;100;3;3.1\nMullite;60;2;0.7\n");
    CHECK_FALSE(peaks.analysis.phases[0].standard_uncertainty);
}

TEST_CASE("words for per cent in the heading of uncertainties are of the whole or of the value") {
    for (const char* column : {"error in percent", "Fehler in Prozent", "Error pct", "Fehler [Prozent]",
                               "esd percent", "error [%]", "\u00b1 %", "\u8bef\u5dee(%)", "weight error [%]"})
        for (const char* amounts : {"wt%", "Amount", "Weight fraction %"}) {
            CAPTURE(column);
            const std::string table =
                std::string("Phase;") + amounts + ";" + column + "\nQuartz;20;3\nGlass;80;2\n";
            CHECK_FALSE(first_of(table).analysis.phases[0].standard_uncertainty);
            CHECK(contains(told(table), "of the whole or of the value"));
        }
}

TEST_CASE("the amount of an added standard has a unit of its own") {
    const auto scale = [](const std::string& heading, const std::string& cells) {
        const XrdSample sample = first_of("Phase;" + heading + "\nQuartz;" + cells);
        return std::get<AmorphousRemainder>(sample.analysis.amorphous).scale;
    };
    const double expected = 0.02 / (0.3 * 0.98);
    for (const auto& [unit, number] : {std::pair{"g/kg", "20"},
                                       {"mg/g", "20"},
                                       {"ppm", "20000"},
                                       {"\u2030", "20"},
                                       {"wt%", "2"},
                                       {"1", "0.02"}}) {
        const std::string table = "standard [" + std::string(unit) + "]";
        CHECK(scale("wt%;" + table, "70;\nCorundum;30;" + std::string(number) + "\n") ==
              doctest::Approx(expected));
        CHECK(scale("g/kg;" + table, "700;\nCorundum;300;" + std::string(number) + "\n") ==
              doctest::Approx(expected));
    }
    CHECK(scale("g/kg;standard", "700;\nCorundum;300;2 %\n") == doctest::Approx(expected));
    for (const char* unit : {"g/kg", "ppm"})
        CHECK(contains(
            refusal("Phase;" + std::string(unit) + ";standard\nQuartz;700;\nCorundum;300;2\n"),
            "line 3: the amount of the standard, 2, may be in the unit of the amounts, or per cent"));
    for (const char* table : {"Phase;wt%;standard [vol%]\nQuartz;70;\nCorundum;30;20\n",
                              "Phase;wt%;standard [g]\nQuartz;70;\nCorundum;30;20\n",
                              "Phase;I;RIR;standard [g]\nQuartz;70;1;\nCorundum;30;1;20\n"})
        CHECK(contains(refusal(table), "is in another unit; allowed: the weight fraction of the standard"));
}

TEST_CASE("an internal standard is one in every format, by its name or a remark beside it") {
    const auto topas = [](const std::string& comment, const std::string& name) {
        return comment + "\nxdd \"FA1.xy\"\n  str phase_name \"Mullite\" MVW(0, 1, 60)\n  str phase_name \"" +
               name + "\" MVW(0, 1, 40)\n";
    };
    for (const char* name :
         {"Corundum (internal standard)", "Corundum [spike]", "Corundum, internal standard"})
        CHECK(contains(refusal(topas("' Rietveld", name)), "is called an internal standard"));
    CHECK(contains(refusal(topas("' FA1 + 10 wt% corundum (internal standard)", "Corundum")),
                   "is called an internal standard"));
    for (const char* comment : {"r_wp 5 ' with internal standard corundum", "/* FA1 + 10 % Korund */"})
        CHECK(contains(refusal(topas(comment, "Corundum")), "is called an internal standard"));
    CHECK_FALSE(
        contains(refusal(topas("' no internal standard", "Corundum")), "is called an internal standard"));
    const std::string rows = "\nPhase;wt%\nMullite;60\nCorundum;40\n";
    for (const char* title : {"ISTD 10 %", "incl. internal standard", "spike 10%"})
        CHECK(contains(refusal(title + rows), "is called an internal standard"));
    for (const char* title : {"Standard cell", "without internal standard", "Fly ash 7"})
        CHECK_FALSE(contains(refusal(title + rows), "is called an internal standard"));
}

TEST_CASE("with an internal standard a refinement adds up to 100 %, or the standard is as it was added") {
    const auto told_of = [](const std::string& rows, double added) {
        return input_error_of([&] {
            static_cast<void>(with_internal_standard(first_of("Phase;wt%\n" + rows), "corundum", added, {}));
        });
    };
    CHECK(contains(told_of("Quartz;12.5\nMullite;5.13\nHematite;6.2\nCorundum;30\n", 0.2),
                   "with the internal standard the fractions add up to 53.83 %"));
    CHECK(told_of("Quartz;12.5\nMullite;51.3\nHematite;6.2\nCorundum;30\n", 0.2).empty());
    CHECK(told_of("Quartz;8.3\nMullite;34.2\nHematite;4.1\nCorundum;20\n", 0.2).empty());
    for (const char* table :
         {"Sample [g/kg];Quartz [wt%];Glass [wt%]\nA;10;90\n", "Phase [ppm];wt%\nQuartz;20\nGlass;80\n"})
        CHECK(contains(refusal(table), "of the names states another unit than the amounts"));
}

TEST_CASE("SEM beside the name of another method has two readings") {
    for (const char* table :
         {"Phase;XRD wt%;SEM wt%\nQuartz;20;21\nGlass;80;79\n", "Phase;Rietveld [wt%];SEM\nQuartz;20;1\n",
          "Sample;Quartz;Glass\nXRD;20;80\nSEM;21;79\n"})
        CHECK(
            contains(refusal(table), "may be standard errors of the mean, or amounts by scanning electron"));
    CHECK(first_of("Phase;wt%;SEM\nQuartz;20;1\n").analysis.phases[0].standard_uncertainty.value() ==
          doctest::Approx(0.01));
}

TEST_CASE("of several columns of uncertainties that behind the amounts counts") {
    for (const auto& [heading, cells] : {std::pair{"Phase;;esd;wt%;esd", "Quartz;;9;20;1"},
                                         {"Phase;PDF;error;wt%;error", "Quartz;33-1161;9;20;1"},
                                         {"\u00b1;Phase;wt%;\u00b1", "9;Quartz;20;1"}}) {
        const std::string table = std::string(heading) + "\n" + cells + "\n";
        CHECK(first_of(table).analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.01));
        CHECK(contains(told(table), "is not used"));
    }
    CHECK(contains(refusal("\u00b1;Phase;esd;wt%\n9;Quartz;1;20\n"), "none stands behind the amounts"));
    CHECK(first_of("Phase;esd;wt%\nQuartz;1;20\n").analysis.phases[0].standard_uncertainty.value() ==
          doctest::Approx(0.01));
    CHECK(first_of("Phase;wt%;rel. error [%];esd\nQuartz;20;5;1\n")
              .analysis.phases[0]
              .standard_uncertainty.value() == doctest::Approx(0.01));
}

TEST_CASE("a quantity beside a sample names none") {
    for (const char* column : {"strain [%]", "probability [%]", "match [%]", "expansion [%]", "humidity [%]",
                               "preferred orientation [%]"}) {
        const std::string table = "Phase;FA1 [wt%];" + std::string(column) + "\nQuartz;20;1\nGlass;80;2\n";
        CHECK(read_xrd(table, "t.csv").samples.size() == 1);
        CHECK(contains(told(table), "column \"" + std::string(column) + "\" is not used"));
    }
}

TEST_CASE("a crystalline total of 100 % may be the sum of the crystalline phases") {
    for (const char* table : {"Phase;wt%\nQuartz;30\nMullite;70\nTotal crystalline;100\n",
                              "Phase;wt%\nQuartz;30\nMullite;70\nSumme kristallin;100\n",
                              "Sample;Quartz;Mullite;crystalline\nA;30;70;100\n"})
        CHECK(contains(refusal(table), "the amorphous fraction of the sample is not stated: by "));
    XrdSample sample = first_of("Phase;wt%\nQuartz;30\nMullite;70\nTotal crystalline;100\n");
    sample.analysis.state_amorphous(AmorphousFraction{.value = 0.4});
    CHECK(compose(sample.analysis, shipped_catalogue()).components.back().weight_fraction ==
          doctest::Approx(0.4));
    CHECK(refusal("Phase;wt%\nQuartz;30\nMullite;70\nTotal crystalline;60\n").empty());
    CHECK(contains(refusal("Phase;wt%\nQuartz;30\nGlass;70\nTotal crystalline;100\n"), "\"Glass\" is none"));
}

TEST_CASE("remarks on rows and amounts say what is there") {
    const auto says = [](const std::string& table, const char* text) {
        return told(table).find(text) != std::string::npos;
    };
    CHECK_FALSE(says("Phase;wt%\nQuartz;20\nLime;0\nGlass;80\n", "as other phases do"));
    const std::string wide = "Sample;Quartz;Glass\n";
    CHECK_FALSE(says(wide + "#1;20;80\n#2;30;70\n", "a comment"));
    CHECK(says("# note\n" + wide + "#1;20;80\n", "line 1, a comment, is no part of the table: \"note\""));
    CHECK(
        says(wide + "FA1;20;80\n2 sigma;1;1\nFA2;30;70\n", "line 3 is no sample and left out: \"2 sigma\""));
    CHECK(says(wide + "FA1;20;80\nFA1 mean;21;79\n", "the numbers in line 3 are not read, as \"FA1 mean\""));
    CHECK_FALSE(says("Sample;Phase;wt%\nFA1;Quartz;20\nFA1;Glass;80\nFA11;Quartz;9\n", "write \"FA1 esd\""));
}

namespace {

std::string refusal_of_crystalline(const std::string& table) {
    return input_error_of([&] {
        Analysis analysis = read_xrd(table, "t.csv").samples.front().analysis;
        analysis.state_amorphous(AmorphousRemainder{});
        return compose(analysis, shipped_catalogue());
    });
}

}  // namespace

TEST_CASE("a crystalline phase behind a total may be in it or beside it") {
    const std::string rows = "Phase;FA1 [wt%]\nQuartz;12.3\nMullite;28.4\nHematite;2.1\nTotal;42.8\n";
    CHECK(contains(refusal_of_crystalline(rows + "Free lime;4.0\nCalcite;3.0\n"),
                   "line 6: \"Free lime\", 4 %, stands behind a total of the phases before it: it may be in "
                   "this total, or beside it"));
    for (const char* table : {"Sample;Quartz;Mullite;Total;Lime\nFA1;12.3;28.4;40.7;4\n",
                              "Sample;Phase;wt%\nFA1;Quartz;12.3\nFA1;Total;12.3\nFA1;Lime;4\n",
                              "Phase;wt%\nQuartz;20\nGlass;80\nTotal;100\nLime;0.4\n"})
        CHECK(contains(refusal_of_crystalline(table), "stands behind a total of the phases before it"));
    CHECK(refusal_of_crystalline(rows + "Lime;0\nCalcite;n.d.\n").empty());
    CHECK(refusal(rows + "Amorphous;57.2\n").empty());
    CHECK(refusal(rows + "R\u00f6ntgenamorph;57.2\nSum;100\n").empty());
    CHECK(refusal_of_crystalline(rows + "Lime;4\nSum;46.8\n").empty());
}

TEST_CASE("a row without cells may head the rows below it") {
    const std::string head = "Phase;FA1 [wt%];FA2 [wt%]\nQuartz;12.3;10.1\nMullite;28.4;30.0\n";
    for (const char* row : {"XRF:;;\n", "FA2;;\n", "Peak positions;;\n", "Glass:;;\n", "Oxides:;;\n"})
        CHECK(contains(refusal_of_crystalline(head + row + "Al2O3;26.1;27.0\nCaO;4.1;5.0\n"),
                       "has no cells: it may head the rows below it, or be a phase without amount"));
    CHECK(contains(refusal_of_crystalline(head + "Detection limits:;;\nLime;0.1;0.1\n"),
                   "line 4: \"Detection limits:\" has no cells: the rows below it may be of that quantity"));
    CHECK(contains(refusal_of_crystalline("Phase;wt%\nFA1;\nQuartz;12.3\nFA2;\nLime;3\n"),
                   "line 2: \"FA1\" has no cells"));
    for (const char* row : {"Gypsum;;\n", "Anatase;;\n", "Feldspar;;\n", "XRF:;-;-\n", "Unknown;n.d.;n.d.\n",
                            "Crystalline phases:;;\n", "Minor phases;;\n", "Total;;\n", "LOI;;\n"})
        CHECK(refusal_of_crystalline(head + row + "Hematite;2.1;1.9\n").empty());
    CHECK(refusal_of_crystalline("Phase;wt%\nQuartz:;12\nGypsum:;\nLime:;3\n").empty());
    CHECK(contains(refusal_of_crystalline("Phase;wt%\nQuartz:;12\nXRF:;\nLime:;3\n"), "has no cells"));
    CHECK(refusal_of_crystalline(head + "Xyz;;\n").empty());  // the last row heads none
}

TEST_CASE("coverage factors in a column of their own are refused") {
    for (const char* heading : {"coverage factor k", "k", "k-factor", "Erweiterungsfaktor", "k [-]",
                                "Coverage factor (k)", "facteur d'\u00e9largissement"}) {
        const std::string table = std::string("Phase;wt%;uncertainty;") + heading + "\nQuartz;20;1.2;";
        CHECK(contains(refusal(table + "2\nGlass;80;2;2\n"), "states a coverage, 2"));
        CHECK(contains(refusal(table + "k = 2\nGlass;80;2;2\n"), "k = 2"));
        CHECK(refusal(table + "1\nGlass;80;2;1\n").empty());
    }
    CHECK(contains(refusal("Phase;wt%;k\nQuartz;20 \u00b1 1;2\nGlass;80;2\n"), "states a coverage, 2"));
    CHECK(contains(refusal("Phase;FA1;esd;k\nQuartz;20;1;2\nGlass;80;1;2\n"), "states a coverage, 2"));
    CHECK(refusal("Phase;wt%;k\nQuartz;20;2\nGlass;80;2\n").empty());
    CHECK(refusal("Phase;wt%;U (k=2);k\nQuartz;20;2;2\nGlass;80;2;2\n").empty());
    CHECK(refusal("Phase;FA1;\u00b1;K;\u00b1\nQuartz;20;1;30;1\nGlass;80;1;70;1\n").empty());
}

TEST_CASE("a column of levels beside uncertainties states their coverage") {
    for (const char* heading : {"Level", "Confidence level", "Niveau", "P", "probability", "Level [%]"})
        for (const char* level : {"95", "95 %", "0.95", "P = 95 %"}) {
            const auto table = [&](const std::string& uncertainties) {
                const std::string cells = std::string(";") + level + "\n";
                return "Phase;wt%;" + uncertainties + ";" + heading + "\nQuartz;20;1" + cells + "Glass;80;2" +
                       cells;
            };
            CHECK_MESSAGE(contains(refusal(table("esd")), " states "), refusal(table("esd")));
            CHECK_MESSAGE(refusal(table("error (95 %)")).empty(), refusal(table("error (95 %)")));
            CHECK_MESSAGE(refusal(table("U (k=2)")).empty(), refusal(table("U (k=2)")));
        }
    CHECK(contains(refusal("Phase;wt%;Level\nQuartz;20 \u00b1 1;95\nGlass;80 \u00b1 1;95\n"),
                   "states a coverage"));
    CHECK(refusal("Phase;wt%;Level\nQuartz;20;95\nGlass;80;95\n").empty());
    CHECK(contains(told("Phase;wt%;esd;Level\nQuartz;20;1;3\nGlass;80;2;95\n"),
                   "column \"Level\" is not used"));
}

TEST_CASE("a multiple of the standard uncertainty is one in any spelling") {
    for (const char* heading :
         {"2 s.d.", "2 s. d.", "2\u00d7\u03c3", "2*sigma", "\u03c3\u00d72", "(2 sd)", "2-sigma",

          "zwei Sigma", "two-sigma",

          "2 Sigma (95%)", "2\u03c3 / 95 %", "2 \u00b7 \u03c3", "2*s", "2 \u00d7 s", "esd (2 s.d.)",
          "deux \u00e9carts-types", "error (2\u00b7s)"}) {
        const std::string table = std::string("Phase;wt%;") + heading + "\nQuartz;20;1\nGlass;80;2\n";
        CHECK_MESSAGE(refusal(table).empty(), refusal(table));
        CHECK_MESSAGE(
            first_of(table).analysis.phases[0].standard_uncertainty.value_or(0) == doctest::Approx(0.005),
            heading);
    }
    CHECK(contains(told("Phase;wt%;2 Sigma (68 %)\nQuartz;20;1\nGlass;80;2\n"), "are not the same coverage"));
    CHECK(first_of("Phase;wt%;drei Sigma\nQuartz;20;1.5\nGlass;80;3\n")
              .analysis.phases[0]
              .standard_uncertainty.value() == doctest::Approx(0.005));
}

TEST_CASE("a coverage in the second heading line, or in brackets behind the unit, is of the uncertainties") {
    for (const char* heading : {"Phase;FA1;\n;wt%;2\u03c3", "Phase;FA1;\n;wt%;2 s.d.",
                                "Phase;FA1;\n;[wt%];(2\u03c3)", "Phase;FA1;\n;wt%;\u00b1 2\u03c3"}) {
        const std::string table = std::string(heading) + "\nQuartz;20;1\nGlass;80;2\n";
        CHECK_MESSAGE(refusal(table).empty(), refusal(table));
        CHECK(first_of(table).name == "FA1");
        CHECK(first_of(table).analysis.phases[0].standard_uncertainty.value_or(0) == doctest::Approx(0.005));
    }
    for (const char* table : {"Phase;wt% (95 %)\nQuartz;20 \u00b1 1.96\nGlass;80 \u00b1 2\n",
                              "Phase;FA1 [wt%] (95 %)\nQuartz;20 \u00b1 1.96\nGlass;80 \u00b1 2\n",
                              "Phase;wt% (95 %);\u00b1\nQuartz;20;1.96\nGlass;80;2\n"}) {
        CHECK_MESSAGE(refusal(table).empty(), refusal(table));
        CHECK(first_of(table).analysis.phases[0].standard_uncertainty.value_or(0) ==
              doctest::Approx(0.01).epsilon(1e-4));
    }
    CHECK(contains(refusal("Phase;wt% (95 %)\nQuartz;20\nGlass;80\n"),
                   "column \"wt% (95 %)\" states \"95 %\", and nothing has uncertainties of that coverage"));
    CHECK(
        contains(refusal("Phase;wt% (95 %);esd\nQuartz;20;1\nGlass;80;2\n"), "names standard uncertainties"));
}

TEST_CASE("a unit behind a number and its uncertainty is of both") {
    for (const char* cell : {"20.0 \u00b1 0.5 wt%", "20.0 wt% \u00b1 0.5 wt%", "(20.0 \u00b1 0.5) wt%",
                             "20.0(5) wt%", "20,0 \u00b1 0,5 Gew.-%", "20.0+/-0.5 wt.%"}) {
        for (const char* heading : {"Phase;FA1", "Phase;wt%"}) {
            const std::string table = std::string(heading) + "\nQuartz;" + cell + "\nGlass;80 wt%\n";
            CHECK_MESSAGE(refusal(table).empty(), refusal(table));
            CHECK(first_of(table).analysis.phases[0].fraction == doctest::Approx(0.2));
            CHECK(first_of(table).analysis.phases[0].standard_uncertainty.value_or(0) ==
                  doctest::Approx(0.005));
        }
    }
    CHECK(contains(refusal("Phase;wt%\nQuartz;20.0 \u00b1 0.5 vol%\nGlass;80\n"), "cannot read"));
    CHECK(contains(refusal("Phase;wt%\nQuartz;20.0 wt% \u00b1 0.5 %\nGlass;80\n"), "cannot read"));
}

TEST_CASE("uncertainties to two sides are one if they are equal") {
    for (const char* headings : {"-err;+err", "err-;err+", "err +;err -", "\u2212\u03c3;+\u03c3",
                                 "lower error;upper error", "esd (-);esd (+)", "Fehler minus;Fehler plus"}) {
        for (const char* amounts : {"wt%", "FA1 [wt%]"}) {
            const auto table = [&](const std::string& cells) {
                return std::string("Phase;") + amounts + ";" + headings + "\nQuartz;20;" + cells +
                       "\nGlass;80;1;1\n";
            };
            CHECK_MESSAGE(refusal(table("0.5;0.5")).empty(), refusal(table("0.5;0.5")));
            CHECK(first_of(table("0.5;+0.50")).analysis.phases[0].standard_uncertainty.value_or(0) ==
                  doctest::Approx(0.005));
            CHECK_MESSAGE(
                contains(refusal(table("0.5;0.8")), "line 2, cell 3: the uncertainties \"0.5\" and \"0.8\""),
                refusal(table("0.5;0.8")));
        }
    }
    CHECK(contains(refusal("Phase;wt%;-err\nQuartz;20;1\nGlass;80;1\n"), "uncertainties to one side"));
    CHECK(
        contains(refusal("Phase;wt%;+err;Remark\nQuartz;20;1;\nGlass;80;1;\n"), "uncertainties to one side"));
}

TEST_CASE("a remark beside a sample, and a title, name what was added") {
    const auto spiked = [](const std::string& remark) {
        return refusal_of_crystalline("Sample;Quartz;Mullite;Corundum;Remark\nFA1;33;49;18;" + remark + "\n");
    };
    for (const char* remark : {"with internal standard (10 % corundum)", "spiked", "FA1 + 10 % Korund"})
        CHECK(contains(spiked(remark), "is called an internal standard"));
    for (const char* remark : {"", "no internal standard", "wet", "corundum crucible", "external standard"})
        CHECK(spiked(remark).empty());
    CHECK(contains(
        refusal_of_crystalline("Phase;wt%;Remark\nQuartz;20;spiked with 10 % corundum\nCorundum;9;\n"),
        "\"Corundum\" is called an internal standard"));
    const std::string rows = "\nPhase;wt%\nMullite;60\nCorundum;40\n";
    for (const char* title : {"Mischung mit 10 % Korund", "FA1 mit Korund", "mixture with 10 wt% of corundum",
                              "M\u00e9lange avec 10 % de corindon"})
        CHECK(contains(refusal(title + rows), "is called an internal standard"));
    for (const char* title : {"FA1 ohne Korund", "calibrated with corundum", "Fly ash and corundum",
                              "RIR measured with 50 % corundum", "FA1 with quartz and corundum"})
        CHECK_FALSE(contains(refusal(title + rows), "is called an internal standard"));
}

TEST_CASE("names of samples, and headings, that change what amounts are") {
    for (const char* name : {"FA1 at.%", "FA1 (x10)", "FA1 x10", "FA1 (/2)", "FA1 mol%"})
        CHECK_FALSE(refusal("Sample;Quartz;Glass\n" + std::string(name) + ";20;80\n").empty());
    for (const char* name : {"FA1 x10", "FA1 (x10)", "FA1 peak %"})
        CHECK_FALSE(refusal("Phase;" + std::string(name) + ";FA2\nQuartz;20;20\nGlass;80;80\n").empty());
    for (const char* name : {"10", "FA 100", "Mix10", "FA 5 %", "FA1 (*)", "FA1 (2)", "FA7 5%", "Box 10"})
        CHECK(refusal("Sample;Quartz;Glass\n" + std::string(name) + ";20;80\n").empty());
    CHECK(contains(refusal("Sample;Quartz;Glass\nFA1;20;80\nSTD;30;70\n"), "may be a standard, a sample"));
    CHECK(contains(refusal("Phase;FA1;STD\nQuartz;20;30\nGlass;80;70\n"), "may be a standard, a sample"));
    CHECK(refusal("Sample;Quartz;Glass\nFA1;20;80\nSTD;1;1\n").empty());
    CHECK(contains(refusal("Phase;wt%;Mittelwert;SD\nQuartz;20;21;1\nGlass;80;79;2\n"),
                   "the uncertainties in column \"SD\" may be of \"Mittelwert\""));
    CHECK(refusal("Phase;wt%;SD;Mittelwert;SD\nQuartz;20;1;21;1\nGlass;80;2;79;2\n").empty());
    for (const char* heading : {"Phase;FA1;\n;mean;2SD", "Phase;FA1 [wt%];\n;mean;2\u03c3"})
        CHECK_MESSAGE(contains(refusal(std::string(heading) + "\nQuartz;12.6;0.9\nMullite;28.2;1.2\n"),
                               "which is not read, or of the amounts"),
                      heading);
    for (const char* heading :
         {"FA1 volume fraction [%] (2s)", "FA1 volume content %", "FA1 Volumengehalt [%]",
          "FA1 Molgehalt [%]", "Molanteil % (2s)", "FA1 area fraction %", "FA1 QEMSCAN %"})
        CHECK_MESSAGE(
            !refusal("Phase;" + std::string(heading) + "\nQuartz;20 \u00b1 1\nGlass;80 \u00b1 2\n").empty(),
            heading);
    CHECK(refusal("Phase;Surface [wt%]\nQuartz;20\nGlass;80\n") == "");
    for (const char* heading : {"FA1 (n=3, 2s) [wt%]", "FA1 [wt%] (2s, n = 3)", "wt% (2 sigma, n=5)"})
        CHECK(first_of("Phase;" + std::string(heading) + "\nQuartz;20 \u00b1 1\nGlass;80 \u00b1 2\n")
                  .analysis.phases[0]
                  .standard_uncertainty.value() == doctest::Approx(0.005));
    CHECK(first_of("Phase;wt%;n;SD\nQuartz;20;3;1\n").analysis.phases[0].standard_uncertainty.value() ==
          doctest::Approx(0.01));
}

TEST_CASE("names of samples that may state more than a sample are quoted") {
    const auto told = [](const std::string& text) {
        std::string all;
        for (const Finding& each : read_xrd(text, "t.csv").warnings) all += each.text + "\n";
        return all;
    };
    for (const char* heading :
         {"FA1 particle %", "FA1 number %", "FA1 (Min-Max)", "FA1 rel. Int. [%]", "FA1 (cov. factor 2) [wt%]",
          "FA1 I/Imax [%]", "FA1 #%", "FA1 95er VB [wt%]", "FA1 + MgO", "FA1 kristallin [wt%]",
          "FA1 x 2 [wt%]", "2 x FA1", "FA1\u00b710", "FA1 mit Standard"}) {
        const std::string text =
            "Phase;" + std::string(heading) + "\nQuartz;20 \u00b1 1\nGlass;80 \u00b1 2\n";
        CHECK_MESSAGE((!refusal(text).empty() ||
                       contains(told(text), "these names are read as names of samples alone: \"FA1")),
                      heading);
    }
    CHECK(contains(told("Phase;FA1 [wt%];Crystallite size, nm\nQuartz;20;45\nGlass;80;55\n"),
                   "these names are read as names of samples alone: \"Crystallite size, nm\""));
    for (const char* name : {"FA2 V%", "FA2 (area)", "FA2 (95 %)", "FA2 \u00b1 2 SE"})
        CHECK_MESSAGE(contains(told("Sample;Quartz;Glass\nFA1;20;80\n" + std::string(name) + ";30;70\n"),
                               "these names are read as names of samples alone: \"FA2"),
                      name);
    for (const char* heading : {"FA1 [wt%]", "FA1 [%]", "Ash 1 %", "Nord [wt%]", "Fly ash sample 3 B [wt%]"})
        CHECK_FALSE_MESSAGE(contains(told("Phase;" + std::string(heading) + "\nQuartz;20\nGlass;80\n"),
                                     "names of samples alone"),
                            heading);
}

TEST_CASE("what the heading of the names says is read, or refused") {
    const std::string rows = ";wt%;\u00b1\nQuartz;20;1\nGlass;80;2\n";
    for (const char* heading :
         {"Phase (Fehler 2s)", "Phase (2 sigma)", "Phase (\u00b1 2\u03c3)", "Phase [Fehler 2s]",
          "Mineral [Vol.-%]", "Phase (area)", "Phase (values / 10)", "Phase [scaled]", "Phase (estimated)",
          "Phase (cation %)", "Phase \u00b1 2 SE", "Phase CI", "Phase 95% conf.", "Phase (10 % ZnO added)",
          "Phase (/10)", "Phase (1:10)"})
        CHECK_MESSAGE(!refusal(heading + rows).empty(), heading);
    CHECK(contains(
        refusal("Phase (values / 10)" + rows),
        "line 1: of the heading \"Phase (values / 10)\" of the names \"(values / 10)\" is not understood"));
    for (const char* heading :
         {"Phase (ICSD)", "Mineral (PDF no.)", "Phase [Rietveld]", "Phase (Mineral)", "Phase [wt%]",
          "Phase (n=3)", "Phase (Name, Formel)", "Phases (Rietveld refinement)", "Mineral [ICSD no.]",
          "Phase (\u00b0C)", "Phase name (ICDD PDF-4+)"})
        CHECK_MESSAGE(refusal(heading + rows).empty(), heading);
}

TEST_CASE("a coverage before its unit is that of uncertainties") {
    for (const char* headings :
         {"FA1 (wt%);2\u03c3 (wt%)", "FA1 (wt%);2s [wt%]", "FA1 (wt%);2SD wt%", "wt%;2\u03c3 (wt%)",
          "FA1 [wt%];FA1 2\u03c3 (wt%)", "wt%;k=2 (wt%)", "mean (wt%);2\u03c3 (wt%)"}) {
        CAPTURE(headings);
        const Analysis analysis =
            first_of("Phase;" + std::string(headings) + "\nQuartz;20;1\nGlass;80;2\n").analysis;
        CHECK(analysis.phases[0].fraction == doctest::Approx(0.2));
        CHECK(analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.005));
    }
    for (const char* headings :
         {"FA1 (wt%);FA1 \u03c3 (wt%)", "FA1 (wt%);\u03c3(FA1) (wt%)", "wt%;1\u03c3 (wt%)"})
        CHECK_MESSAGE(first_of("Phase;" + std::string(headings) + "\nQuartz;20;1\nGlass;80;2\n")
                              .analysis.phases[0]
                              .standard_uncertainty.value() == doctest::Approx(0.01),
                      headings);
    for (const char* heading : {"95 % CI (\u00b1)", "CI 95 % (\u00b1)"})
        CHECK_MESSAGE(first_of("Phase;wt%;" + std::string(heading) + "\nQuartz;20;1.96\nGlass;80;2\n")
                              .analysis.phases[0]
                              .standard_uncertainty.value() == doctest::Approx(0.01).epsilon(1e-3),
                      heading);
    CHECK_FALSE(
        first_of("Phase;wt%;+;-\nQuartz;20;1;2\nGlass;80;2;3\n").analysis.phases[0].standard_uncertainty);
}

TEST_CASE("brackets in headings of peaks that are no known units are quoted") {
    const std::string rows = "\nQuartz;4382;3.4\nMullite;2188;0.7\n";
    for (const char* heading :
         {"I (gross);RIR", "Intensity (log);RIR", "Intensity [2nd peak];RIR", "I (raw);RIR"})
        CHECK_MESSAGE(contains(told("Phase;" + std::string(heading) + rows),
                               "is taken as net intensities of the strongest peaks"),
                      heading);
    for (const char* heading : {"I;RIR (1/x)", "I (counts);RIR (inverse)"})
        CHECK_MESSAGE(contains(told("Phase;" + std::string(heading) + rows),
                               "is taken as reference intensity ratios, I/Ic"),
                      heading);
    for (const char* heading : {"I (cps);RIR", "Intensity [a.u.];RIR (I/Ic)", "Int. (net);RIR", "I [%];RIR"})
        CHECK_FALSE_MESSAGE(contains(told("Phase;" + std::string(heading) + rows), "is taken as"), heading);
}

TEST_CASE("texts and units in columns of their own are no samples") {
    for (const char* table : {"Phase;ICDD;FA1 [wt%]\nQuartz;46-1045;20\nMullite;15-0776;30\nGlass;;50\n",
                              "Phase;Content;Unit\nQuartz;20;wt%\nMullite;30;wt%\nGlass;50;wt%\n",
                              "phase_name,weight_percent\nQuartz,20\nMullite,30\nGlass,50\n"}) {
        const XrdResult result = read_xrd(table, "t.csv");
        REQUIRE_MESSAGE(result.samples.size() == 1, table);
        CHECK(result.format == XrdFormat::table);
        CHECK(result.samples[0].analysis.phases[0].fraction == doctest::Approx(0.2));
    }
    CHECK(contains(told("Phase;ICDD;FA1 [wt%]\nQuartz;46-1045;20\nGlass;;80\n"), "\"ICDD\" is not used"));
    CHECK(first_of("Phase;Value;Unit\nQuartz;200;g/kg\nGlass;800;g/kg\n").analysis.phases[0].fraction ==
          doctest::Approx(0.2));
    CHECK_FALSE(refusal("Phase;Value;Unit\nQuartz;200;g/kg\nGlass;80;wt%\n").empty());
    CHECK(contains(refusal("Phase;wt%\nQuartz;20\nInternal standard;\nCorundum;10\nGlass;70\n"),
                   "line 3: \"Internal standard\" has no cells: it may call the rows below it so"));
    CHECK(first_of("Sample;Quartz;Mullite;Total crystalline\nFA1;12;28;40\n").analysis.phases[0].fraction ==
          doctest::Approx(0.12));
    CHECK(first_of("Phase;n;Mean (wt%);SD\nQuartz;3;20;1\nGlass;3;80;2\n").analysis.phases[0].fraction ==
          doctest::Approx(0.2));
    for (const char* column : {"T (\u00b0C)", "d50 [\u00b5m]"})
        CHECK(contains(told("Sample;" + std::string(column) + ";Quartz;Glass\nFA1;900;20;80\n"),
                       "is not used"));
    CHECK_FALSE(refusal("Sample;Quartz [mg];Glass [mg]\nFA1;20;80\n").empty());
    CHECK(first_of("Phase;wt%\nQuartz;20\nCorundum (20 % added);10\nGlass;70\n").analysis.phases.size() == 3);
    for (const char* standard : {"Corundum (added 20 %)", "Corundum (internal standard, 20 wt%)"})
        CHECK(contains(told("Phase;wt%\nQuartz;20\n" + std::string(standard) + ";10\nGlass;70\n"),
                       "the amounts in these names are not read: \"Corundum"));
    CHECK(contains(refusal("Phase;FA1 [ppm];esd\nQuartz;182 000;9.000\nGlass;818 000;8.000\n"),
                   "\"9.000\" is 9.000 or 9000"));
}

TEST_CASE("a coverage in the heading of the amounts is that of the uncertainties behind them") {
    for (const char* heading : {"Phase;Content [wt%] (\u00b1 2\u03c3);\u00b1", "Phase;wt% (2s);error",
                                "Phase;FA1 [wt%] (k=2);Fehler"}) {
        const std::string table = std::string(heading) + "\nQuartz;20;1\nGlass;80;2\n";
        CHECK(first_of(table).analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.005));
        CHECK(contains(told(table), "are divided by 2 for standard ones"));
        CHECK_FALSE(contains(told(table), "holds no uncertainties"));
    }
    CHECK(contains(refusal("Phase;wt% (2s);esd\nQuartz;20;1\nGlass;80;2\n"),
                   "\"wt% (2s)\" states \"2s\", and \"esd\" behind it names standard uncertainties"));
    CHECK(first_of("Phase;wt% (2s);1 sigma\nQuartz;20;1\n").analysis.phases[0].standard_uncertainty.value() ==
          doctest::Approx(0.01));
}

TEST_CASE("per cent at the end of the name of a sample may be of its name") {
    for (const char* table :
         {"Sample;Quartz;Glass\nFA 5 %;0.2;0.8\n", "Phase;FA 5 %;FA 10 %\nQuartz;0.2;0.3\nGlass;0.8;0.7\n",
          "Sample;Phase;Amount\nFA-5%;Quartz;0.2\nFA-5%;Glass;0.8\n"})
        CHECK(contains(refusal(table), "they may be fractions, or in the \"%\" of its name"));
    for (const char* table :
         {"Sample;Quartz;Glass\nFA 5 %;20;80\n", "Phase;FA 5 %;FA 10 %\nQuartz;20;30\nGlass;80;70\n",
          "Sample;Quartz [1];Glass [1]\nFA 5 %;0.2;0.8\n", "Phase;FA1 %;FA2 %\nQuartz;20;30\nGlass;80;70\n"})
        CHECK(first_of(table).analysis.phases[0].fraction == doctest::Approx(0.2));
}

TEST_CASE("the amount of a standard without a unit has two readings below 1") {
    for (const char* table : {"Phase;wt%;standard\nQuartz;70;\nCorundum;30;0.1\n",
                              "Phase;I;RIR;standard\nQuartz;70;1;\nCorundum;30;1;0.1\n"})
        CHECK(contains(refusal(table), "the amount of the standard, 0.1, may be 0.1 % or 10 %"));
    for (const char* table : {"Phase;wt%;standard\nQuartz;70;\nCorundum;30;10\n",
                              "Phase;wt%;standard\nQuartz;70;\nCorundum;30;10 %\n",
                              "Phase;Amount [1];standard\nQuartz;0.7;\nCorundum;0.3;0.1\n"})
        CHECK(std::get<AmorphousRemainder>(first_of(table).analysis.amorphous).scale ==
              doctest::Approx(0.1 / (0.3 * 0.9)));
}

TEST_CASE("a garbled name of a phase is refused") {
    for (const char* name : {"Quartz (10", "Quartz [low", "Quartz 10)", "Qua\"rtz"})
        CHECK(contains(refusal("Phase;wt%\n" + std::string(name) + ";20\nGlass;80\n"),
                       "line 2, cell 1: a bracket or quote"));
    CHECK(contains(refusal("Sample;Quartz (low;Glass\nA;20;80\n"), "line 1, cell 2: a bracket or quote"));
}

TEST_CASE("texts of columns that are not used are quoted, and refused where they state a coverage") {
    const auto of = [](const std::string& heading, const std::string& remark) {
        return "Phase;wt%;esd;" + heading + "\nQuartz;12.3;0.8;\nGlass;87.7;1.6;" + remark + "\n";
    };
    CHECK(contains(told(of("Remark", "kcounts")), "column \"Remark\" is not used: \"kcounts\""));
    for (const char* factor : {"x10", "/10", "\u00d7 10"})
        CHECK(contains(refusal(of("Remark", factor)), "may state a factor of the numbers"));
    CHECK(contains(told(of("Remark", "Zusatz")), "column \"Remark\" is not used: \"Zusatz\""));
    for (const auto& [heading, remark] : {std::pair{"Remark", "k=2"},
                                          {"Coverage", "95 %"},
                                          {"Level of confidence", "95 %"},
                                          {"Bemerkung", "Fehler = 2 sigma"},
                                          {"Comment", "n=3, 2 SD"}})
        CHECK_MESSAGE(contains(refusal(of(heading, remark)), " states "), refusal(of(heading, remark)));
    CHECK(contains(refusal("Sample;Mullite;Glass;Comment\nFA1;40 \u00b1 4;60 \u00b1 4;errors 2 sigma\n"),
                   "2 sigma"));
    CHECK(contains(refusal(of("Confidence", "0.95")), "\"Confidence\" states a coverage, 0.95"));
    CHECK(contains(refusal(of("Remark", "multiplied by 10")), "may state a factor"));
    for (const auto& [row, says] :
         {std::pair{"Coverage factor;;2\n", "states a coverage"},
          {"Remark;;2 sigma\n", "states \"2 sigma\", and the column \"esd\" does not"}})
        CHECK(contains(refusal(std::string("Phase;wt%;esd\nQuartz;12.3;0.8\nGlass;87.7;1.6\n") + row), says));
    CHECK(contains(told(of("ICSD", "26429")), "column \"ICSD\" is not used"));
}

TEST_CASE("a standard in the name of a sample that is none of its known phases is doubted") {
    for (const char* name : {"FA1 + 10 % MgO", "FA1 spiked", "FA1 (internal standard: calcite)"}) {
        const std::string table = "Sample;Quartz;Periclase;Glass\n" + std::string(name) + ";30;10;60\n";
        CHECK_MESSAGE(contains(told(table), "may state an added standard, and no phase is marked"),
                      told(table));
    }
    CHECK(contains(told("spiked with 10 % MgO\nPhase;wt%\nQuartz;30\nPericlase;10\nGlass;60\n"),
                   "may state an added standard"));
    CHECK_FALSE(contains(told("Sample;Quartz;Periclase;Glass\nFA1;30;10;60\n"), "added standard"));
}

TEST_CASE("a crystalline total beside an internal standard states the amorphous part twice") {
    const XrdSample sample = first_of("Phase;wt%\nQuartz;30\nMullite;50\nCorundum;20\nCrystalline;70\n");
    CHECK(contains(
        input_error_of([&] { static_cast<void>(with_internal_standard(sample, "Corundum", 0.1, {})); }),
        "the amorphous part, and it is stated again"));
}

TEST_CASE("a short mark of a standard in a name is not taken") {
    const std::string rows = "Phase;wt%\nQuartz;37\nCorundum;10\nGlass;53\n";
    for (const char* file : {"is_x.csv", "STD_3.csv", "ref 7.csv", "Standard 3.csv"}) {
        const XrdSample sample = read_xrd(rows, file).samples.front();
        CHECK_FALSE(sample.analysis.phases[1].is_standard);
    }
    CHECK_FALSE(first_of("Sample;Quartz;Corundum;Glass\nSTD_3;37;10;53\n").analysis.phases[1].is_standard);
    for (const char* file : {"FA1 (IS).csv", "FA1 + IS.csv", "spiked_3.csv", "int. std. 3.csv"})
        CHECK(read_xrd(rows, file).samples.front().analysis.phases[1].is_standard);
}

TEST_CASE("tables that laboratories write are read") {
    const std::string two = "\nQuartz;20;30\nGlass;80;70\n";
    const std::string with_esd = "\nQuartz;20;1;30;1\nGlass;80;2;70;2\n";
    for (const std::string& table :
         {std::string("Phase;Weight fraction\nQuartz;20.0 %\nGlass;80.0 %\n"),
          "Phase;FA1;FA2\nUnit;wt%;wt%" + two, "Phase;FA1;FA2\nEinheit;[Gew.-%];[Gew.-%]" + two,
          "Phase;FA1;;FA2;\n;wt%;esd;wt%;esd" + with_esd, "Phase;FA1;;FA2;\nUnits;wt%;esd;wt%;esd" + with_esd,
          std::string("Phase;wt%;esd\nQuartz;20 %;1 %\nGlass;80 %;2 %\n"),
          std::string("Phase;wt% (mean \u00b1 SD)\nQuartz;20 \u00b1 1\nGlass;80 \u00b1 2\n"),
          std::string("Phase name;Wt% Rietveld;Wt%-Rietveld error\nQuartz;20;1\nGlass;80;2\n"),
          "Phase;900 \u00b0C;1000 \u00b0C" + two, "Phase;FA1;;FA2;\nPhase;wt%;esd;wt%;esd" + with_esd,
          ";FA1;;FA2;\nPhase;wt%;esd;wt%;esd" + with_esd,
          "Phase;FA1 900 \u00b0C [wt%];FA1 1000\u00b0C [wt%]" + two,
          std::string("Sample;Quartz [wt%];Glass [wt%];crystalline [wt%];Total [wt%]\nA;20;80;20;100\n"),
          std::string("Sample;Quartz [wt%];Glass [wt%];Cr [ppm];Ni (mg/kg);esd\nA;20;80;120;40;3\n"),
          std::string("Sample;Size fraction;Quartz [wt%];Glass [wt%]\nA;<63;20;80\n"),
          std::string("Phase;wt%;esd\nQuartz;20;\x96\nHematite;\x96;\x96\nGl\xfcshaus;80;\x96\n")}) {
        CAPTURE(table);
        CHECK(first_of(table).analysis.phases[0].fraction == doctest::Approx(0.2));
    }
    CHECK(
        std::get<CrystallineTotal>(
            first_of("Sample;Quartz [wt%];Mullite [wt%];crystalline [wt%]\nA;12;30;42\n").analysis.amorphous)
            .value == doctest::Approx(0.42));
    CHECK(contains(told("Sample;Quartz [wt%];Glass [wt%];Cr [ppm]\nA;20;80;120\n"),
                   "column \"Cr [ppm]\" is not used"));
    CHECK(
        contains(told("Phase;wt%\nQuartz;20\nGlass;80\nLOI (550 \u00b0C);3\n"), "is no phase and left out"));
    CHECK(contains(told("Sample;Quartz;Glass;LOI (550 \u00b0C)\nA;20;80;3\n"), "is not used"));
}

TEST_CASE("a density far from that of the catalogue is doubtful") {
    const auto severity = [](double density) {
        Analysis analysis{.phases = {{.name = "Quartz", .fraction = 1, .density = density}},
                          .amorphous = AmorphousNone{}};
        return compose(analysis, shipped_catalogue()).notes.front().severity;
    };
    CHECK(severity(2600) == Severity::background);
    CHECK(severity(1500) == Severity::doubt);
    CHECK(severity(4000) == Severity::doubt);
}

}  // namespace ashimpact::test
