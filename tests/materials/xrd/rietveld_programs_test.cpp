// SPDX-License-Identifier: GPL-3.0-or-later
// FullProf and TOPAS: what their files may look like, and what is refused.
#include <string>

#include <doctest/doctest.h>

#include "materials/xrd/xrd.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

XrdResult read_text(const std::string& text) {
    return read_xrd(text, "ash.out");
}

std::string refused_text(const std::string& text) {
    return input_error_of([&] { return read_text(text); });
}

bool close_to(double value, double expected) {
    return relative_difference(value, expected) < 1e-12;
}

std::string fullprof_phase(int number, const std::string& name, const std::string& fraction) {
    return " => Phase:  " + std::to_string(number) + "     " + name +
           "\n => Bragg R-factor:   28.0       Vol:  591.768( 0.238)  Fract(%):   " + fraction +
           "\n => Rf-factor= 20.1                 ATZ:        961.337   Brindley:  1.0000\n";
}

const std::string topas = R"(
' quantitative analysis of /* no comment */ an ash
r_wp  7.12 r_exp 2.1
/* str
   phase_name "Removed" */
xdd "C:\data\Ash 7.raw"
  weight_percent_amorphous 40.12`_0.9
  str
    phase_name "Quartz low"
    MVW( 180.252, 112.98`, 25.000`_0.300)
    Phase_Density_g_on_cm3( 2.6490`_0.0003)
  str
    phase_name Mullite ' without quotes
    weight_percent  wp2  75.000`_0.500
    MVW( 426.05 , 167.4`, 11.1)
)";

void refuses_text(const std::string& text, const std::string& says) {
    CAPTURE(text);
    CHECK(contains(refused_text(text), says));
}

}  // namespace

TEST_CASE("a FullProf summary of two phases: deviations in the unit of the value") {
    const XrdResult result =
        read_text(" ** PROGRAM FullProf **\n" + fullprof_phase(1, "Quartz low", "25.00( 0.50)") +
                  fullprof_phase(2, "Mullite", "75.00( 2.25)"));
    CHECK(result.format == XrdFormat::fullprof_sum);
    REQUIRE(result.samples.size() == 1);
    CHECK(result.samples[0].name == "ash");
    const auto& phases = result.samples[0].analysis.phases;
    REQUIRE(phases.size() == 2);
    CHECK(phases[0].name == "Quartz low");
    CHECK(close_to(phases[0].fraction, 0.25));
    CHECK(close_to(*phases[0].standard_uncertainty, 0.005));
    CHECK(close_to(*phases[1].standard_uncertainty, 0.0225));
    CHECK(phases[1].place == "line 6");
    CHECK(std::holds_alternative<AmorphousNotStated>(result.samples[0].analysis.amorphous));
    CHECK(result.samples[0].warnings.empty());
}

TEST_CASE("FullProf: no brackets, a deviation too wide, several patterns, a rounded sum") {
    const XrdResult patterns =
        read_text(fullprof_phase(1, "Quartz", "40.00") + fullprof_phase(2, "Calcite", "60.00(0.00)") +
                  fullprof_phase(1, "Quartz", "20.00( 1.00)") + fullprof_phase(2, "Calcite", "80.00(*****)"));
    REQUIRE(patterns.samples.size() == 2);
    CHECK(patterns.samples[0].name == "pattern 1");
    CHECK(patterns.samples[1].name == "pattern 2");
    CHECK_FALSE(patterns.samples[0].analysis.phases[1].standard_uncertainty);
    CHECK(close_to(patterns.samples[1].analysis.phases[0].fraction, 0.2));
    CHECK(read_text(fullprof_phase(1, "Quartz", "40.00") + fullprof_phase(2, "Calcite", "59.98"))
              .samples[0]
              .warnings.empty());
}

TEST_CASE("malformed FullProf summaries are refused at their line") {
    const std::string quartz = fullprof_phase(1, "Quartz", "40.00( 1.00)");
    refuses_text(quartz + " => Phase:  2     Mullite\n", "line 4: the phase \"Mullite\" has no Fract(%)");
    refuses_text(quartz + fullprof_phase(2, "QUARTZ", "60.00"),
                 "line 5: the phase \"QUARTZ\" is there twice");
    refuses_text(fullprof_phase(1, "Quartz", "40.00") + fullprof_phase(2, "Calcite", "40.00"),
                 "line 5: the fractions add up to 80 %: a phase may be missing, or the rest be amorphous");
    refuses_text(fullprof_phase(1, "Quartz", "-4.00"), "line 2: the fraction is below zero");
    refuses_text(fullprof_phase(1, "Quartz", "4.00( 1.0"), "line 2: cannot read");
    refuses_text(fullprof_phase(1, "Quartz", "abc"), "line 2: cannot read");
    refuses_text(quartz + fullprof_phase(2, "Mullite", "*******(*****)"), "line 5: the fraction is too wide");
    refuses_text(fullprof_phase(1, "Quartz", "0.00"), "no phase has a fraction");
    for (const std::string number : {"x", "0", "3e43", "-1e300"})
        refuses_text(" => Phase:  " + number + "     Quartz\n => Bragg R-factor: 2 Fract(%): 4\n",
                     "line 1: cannot read");
    refuses_text(" Fract(%): 4\n" + quartz, "line 1: a fraction stands before the first phase");
}

TEST_CASE("a TOPAS file: macros and keywords, comments, standard deviations, amorphous part") {
    const XrdResult result = read_text(topas);
    CHECK(result.format == XrdFormat::topas_out);
    REQUIRE(result.samples.size() == 1);
    const XrdSample& sample = result.samples[0];
    CHECK(sample.name == "Ash 7");
    const auto& phases = sample.analysis.phases;
    REQUIRE(phases.size() == 2);
    CHECK(phases[0].name == "Quartz low");
    CHECK(phases[0].place == "line 9");
    CHECK(close_to(phases[0].fraction, 0.25));
    CHECK(close_to(*phases[0].standard_uncertainty, 0.003));
    CHECK(close_to(*phases[0].density, 2649));
    REQUIRE(sample.warnings.size() == 1);
    CHECK(sample.warnings[0].text ==
          "the uncertainty of the density of \"Quartz low\", 0.0003 g/cm3, is not used");
    CHECK(phases[1].name == "Mullite");
    CHECK(close_to(phases[1].fraction, 0.75));  // the keyword, not the macro
    CHECK(close_to(std::get<AmorphousFraction>(sample.analysis.amorphous).value, 0.4012));
    CHECK(close_to(*std::get<AmorphousFraction>(sample.analysis.amorphous).standard_uncertainty, 0.009));
}

TEST_CASE("TOPAS: a spiked standard gives the amorphous part of the ash") {
    const std::string spiked =
        "xdd a.raw\n weight_percent_amorphous 50\n"
        "str phase_name Quartz weight_percent 80\n"
        "str phase_name Corundum weight_percent 20 spiked_phase_measured_weight_percent 10\n";
    const XrdSample sample = read_text(spiked).samples[0];
    CHECK(sample.warnings.empty());
    REQUIRE(sample.analysis.phases.size() == 1);
    const Composition composition = compose(sample.analysis, shipped_catalogue());
    // In the mixture quartz is 10 % * 80/20 = 40 %, of the ash 40/90.
    CHECK(close_to(composition.components[0].weight_fraction, 4.0 / 9.0));
    CHECK(composition.components[1].phase.amorphous);
    std::string other = spiked;
    other.replace(other.find(" 50"), 3, " 30");
    CHECK(contains(read_text(other).samples[0].warnings.back().text,
                   "amorphous part of the mixture is 30 %, the standard gives 50 %"));
    std::string uncertain = spiked;
    uncertain.replace(uncertain.find(" 50"), 3, " 50`_4");
    uncertain.replace(uncertain.rfind(" 10\n"), 4, " 10`_0.5\n");
    const XrdSample with_weighing = read_text(uncertain).samples[0];
    // The scale is w_s/(0.2 (1 - w_s)).
    CHECK(close_to(*std::get<AmorphousRemainder>(with_weighing.analysis.amorphous).standard_uncertainty,
                   0.005 / (0.2 * 0.9 * 0.9)));
    CHECK(
        contains(with_weighing.warnings.back().text, "uncertainty of weight_percent_amorphous is not used"));
    refuses_text(spiked + "str phase_name Calcite weight_percent 5 spiked_phase_measured_weight_percent 5\n",
                 "line 5: there are two spiked phases");
}

TEST_CASE("the name of a sample calls a standard one in every format") {
    const auto refusal = [](const std::string& text) {
        return input_error_of(
            [&] { return compose(read_text(text).samples.front().analysis, shipped_catalogue()); });
    };
    const std::string topas =
        "weight_percent_amorphous 50\nstr phase_name Quartz weight_percent 80\n"
        "str phase_name Corundum weight_percent 20\n";
    CHECK(contains(refusal("xdd fa1_spiked.raw\n " + topas), "is called an internal standard"));
    CHECK(refusal("xdd fa1.raw\n " + topas).empty());
    const std::string json =
        R"(", "weight_fractions": {"quartz": 0.4, "corundum": 0.1}, "amorphous": "remainder"}]})";
    CHECK(contains(refusal(R"({"samples": [{"name": "FA1 mit Korund)" + json),
                   "is called an internal standard"));
    CHECK(refusal(R"({"samples": [{"name": "FA1)" + json).empty());
}

TEST_CASE("TOPAS: several patterns, phases without an xdd, a phase without a weight") {
    const XrdResult two = read_text(
        "xdd a.raw\nstr phase_name Quartz weight_percent 100\n"
        "xdd b.raw\nstr phase_name Mullite weight_percent 100`\n");
    REQUIRE(two.samples.size() == 2);
    CHECK(two.samples[0].name == "a");
    CHECK(two.samples[1].analysis.phases[0].name == "Mullite");
    const XrdResult alike = read_text(
        "xdd \"day 1\\a.raw\"\nstr phase_name Quartz weight_percent 100\n"
        "xdd \"day 2\\a.raw\"\nstr phase_name Lime weight_percent 100\n"
        "xdd \"\"\nstr phase_name Mullite weight_percent 100\n");
    REQUIRE(alike.samples.size() == 3);
    CHECK(alike.samples[0].name == "a (pattern 1)");
    CHECK(alike.samples[1].name == "a (pattern 2)");
    CHECK(alike.samples[2].name == "pattern 3");
    const XrdSample bare = read_text(
                               "str\nphase_name \"Quartz\"\nMVW(1,2,60)\nstr phase_name Lime scale @ 1\n"
                               "hkl_Is phase_name \"Calcite\" MVW( 0, 0, 40`_1)\n")
                               .samples[0];
    CHECK(bare.name == "ash");
    CHECK(close_to(bare.analysis.phases[1].fraction, 0.4));
    REQUIRE(bare.warnings.size() == 2);
    CHECK(contains(bare.warnings[0].text, "\"Lime\" has no weight (line 4)"));
    CHECK(contains(bare.warnings[1].text, "\"Quartz\" has no uncertainty, as other phases do"));
}

TEST_CASE("TOPAS: a phase of peaks is a phase of its own") {
    const std::string phases =
        "str phase_name Quartz weight_percent 40\n"
        "str phase_name Mullite weight_percent 60\n";
    for (const std::string block : {"xo_Is", "d_Is", "hkl_Is", "fit_obj"}) {
        CAPTURE(block);
        for (const std::string& text : {phases + block + " phase_name Glass xo @ 23.4`_0.1 I @ 1234\n",
                                        block + " phase_name Glass xo 23.4 I @ 1234\n" + phases}) {
            const XrdSample hump = read_text(text).samples[0];
            REQUIRE(hump.analysis.phases.size() == 2);
            CHECK(hump.analysis.phases[0].name == "Quartz");
            CHECK(hump.analysis.phases[1].name == "Mullite");
            CHECK(contains(hump.warnings.front().text, "the phase \"Glass\" has no weight (line "));
            CHECK(contains(input_error_of([&] { return compose(hump.analysis, shipped_catalogue()); }),
                           "the amorphous fraction of the sample is not stated"));
        }
        const XrdSample weighed = read_text("str phase_name Quartz weight_percent 40\n" + block +
                                            " phase_name Glass weight_percent 60`_1\n")
                                      .samples[0];
        REQUIRE(weighed.analysis.phases.size() == 2);
        CHECK(weighed.analysis.phases[0].name == "Quartz");
        CHECK(close_to(weighed.analysis.phases[1].fraction, 0.6));
        CHECK(compose(weighed.analysis, shipped_catalogue()).components[1].phase.amorphous);
    }
    // Peaks of the background have no name; a macro may add them.
    const XrdSample background =
        read_text("xo_Is xo 20 I @ 5\n#ifdef X\nd_Is d 3 I @ 5\n#endif\n" + phases + "fit_obj = 3;\n")
            .samples[0];
    CHECK(background.analysis.phases.size() == 2);
    CHECK(background.warnings.empty());
    refuses_text("str phase_name Quartz\nxo_Is xo 20 I @ 5 weight_percent 100\n",
                 "line 2: a phase has no phase_name");
}

TEST_CASE("malformed TOPAS files are refused at their line") {
    refuses_text("str phase_name \"Quartz\nweight_percent 3\n", "line 1: a quote is not closed");
    refuses_text("str phase_name Quartz\n/* weight_percent\n", "line 2: a comment is not closed");
    refuses_text("phase_name Quartz\nweight_percent 3\n",
                 "line 1: \"phase_name\" stands before the first phase");
    refuses_text("str phase_name Quartz\nweight_percent\n", "nothing follows \"weight_percent\"");
    refuses_text("str phase_name Quartz\nweight_percent 3x\n", "line 2: cannot read \"3x\"");
    refuses_text("str phase_name Quartz\nweight_percent -3\n", "line 2: cannot read \"-3\"");
    refuses_text("str phase_name Quartz\nMVW( 1, 2\n", "cut off");
    refuses_text("str phase_name Quartz\nMVW( 1, 2)\n", "line 2: MVW has 2 arguments");
    refuses_text("str phase_name Quartz\nweight_percent 20\nweight_percent 30\n",
                 "line 3: \"weight_percent\" stands twice");
    refuses_text(
        "weight_percent_amorphous 57\nstr phase_name Quartz weight_percent 20\nweight_percent_amorphous 40\n",
        "line 3: \"weight_percent_amorphous\" stands twice");
    refuses_text("str phase_name Quartz weight_percent 0\n", "no phase has a weight");
    refuses_text("str phase_name Quartz weight_percent 25\nstr phase_name Mullite weight_percent 70\n",
                 "line 1: the weights of the phases add up to 95 %");
    refuses_text("str phase_name Quartz weight_percent 25\n#ifdef X\nstr phase_name Mullite\n#endif\n",
                 "line 3: the line counts only if the #ifdef above it holds");
    refuses_text("str weight_percent 4\nstr phase_name Quartz weight_percent 3\n",
                 "line 1: a phase has no phase_name");
    refuses_text("str phase_name Quartz weight_percent 4\nstr phase_name quartz weight_percent 3\n",
                 "line 2: the phase \"quartz\" is there twice");
}

TEST_CASE(
    "tables as laboratories write them: a title line, Fehler, decimal commas, German and French heads") {
    const XrdSample sample =
        read_text(
            "Probe;Kraftwerk Nord\nPhase;Gew.-%;Fehler\nQuarz;10,5;0,3\nMullit 3:2;29,5;0,8\n"
            "R\u00f6ntgenamorph;60,0;1,0\n")
            .samples[0];
    REQUIRE(sample.analysis.phases.size() == 3);
    CHECK(close_to(sample.analysis.phases[0].fraction, 0.105));
    CHECK(close_to(*sample.analysis.phases[1].standard_uncertainty, 0.008));
    CHECK(compose(sample.analysis, shipped_catalogue()).components[2].phase.amorphous);
    for (const char* head : {"Error", "ESD", "s.u.", "Standardabweichung", "Unsicherheit", "incertitude",
                             "\u00b1 (1\u03c3)", "1 \u03c3", "1-sigma"}) {
        CAPTURE(head);
        const XrdSample table =
            read_text("phase,wt%," + std::string(head) + "\nquartz,40,0.5\nGlasphase,60,1\n").samples[0];
        CHECK(close_to(*table.analysis.phases[0].standard_uncertainty, 0.005));
    }
    const XrdResult wide = read_text("Sample,Fly ash 7\nsample,quartz %,mullite %\nA,40,60\nB,30,70\n");
    CHECK(wide.samples.size() == 2);
}

}  // namespace ashimpact::test
