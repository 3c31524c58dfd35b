// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/xrd.hpp"

#include <cmath>

#include <doctest/doctest.h>

#include "core/text/text.hpp"
#include "materials/modulus.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

XrdResult read(const std::string& file) {
    return read_xrd(file_text(ASHIMPACT_TEST_DATA "/xrd/" + file), file);
}

/// "Quartz 0.1523" for each phase, rounded to four places.
std::string digest(const XrdSample& sample) {
    std::string text;
    for (const PhaseFraction& phase : sample.analysis.phases)
        text += (text.empty() ? "" : ", ") + phase.name + " " +
                std::to_string(static_cast<int>(std::lround(phase.fraction * 1e4)));
    return text;
}

double amorphous_of(const XrdSample& sample) {
    return compose(sample.analysis, shipped_catalogue()).components.back().weight_fraction;
}

}  // namespace

TEST_CASE("uncertainties of a table that are multiples of standard ones are read as such") {
    const auto uncertainty = [](const std::string& table) {
        const XrdSample sample = read_xrd(table, "t.csv").samples[0];
        REQUIRE(sample.analysis.phases.size() == 2);
        CHECK(relative_difference(sample.analysis.phases[0].fraction, 0.2) < 1e-12);
        return sample.analysis.phases[0].standard_uncertainty.value_or(0);
    };
    const auto with_column = [](const std::string& heading) {
        return "Phase;Gew.-%;" + heading + "\nQuarz;20;0,8\nMullit;80;1,2\n";
    };
    for (const char* heading : {"Fehler (2s)", "Unsicherheit (2 sigma)", "U (k=2)", "2σ", "±2σ", "2s",
                                "Fehler 2s [wt%]", "esd (k = 2,0)", "error (95.45 %)", "U (95,45 %)"}) {
        CAPTURE(heading);
        CHECK(relative_difference(uncertainty(with_column(heading)), 0.004) < 1e-12);
        const std::string told = read_xrd(with_column(heading), "t.csv").warnings.front().text;
        CHECK_MESSAGE(told.find("divided by 2") != std::string::npos, told);
    }
    for (const char* heading : {"Fehler", "1σ", "±1σ", "1 sigma", "esd (1s)", "±", "s.u."})
        CHECK(relative_difference(uncertainty(with_column(heading)), 0.008) < 1e-12);
    CHECK(relative_difference(uncertainty(with_column("Unsicherheit (95 %)")), 0.008 / 1.95996) < 1e-5);
    CHECK(relative_difference(uncertainty("Phase;Gew.-% ± 2s\nQuarz;20 ± 0,8\nMullit;80 ± 1,2\n"), 0.004) <
          1e-12);
    CHECK(relative_difference(uncertainty("Phase;Probe A [%];2s\nQuarz;20;0,8\nMullit;80;1,2\n"), 0.004) <
          1e-12);
    CHECK(relative_difference(
              uncertainty("Sample,Quartz %,Quartz (2s),Mullite %,Mullite (2s)\nA,20,0.8,80,1.2\n"), 0.004) <
          1e-12);
    for (const auto& [heading, why] :
         {std::pair{"95 % CI", "half-widths"},
          std::pair{"erweiterte Unsicherheit", "needs its coverage factor"},
          std::pair{"U", "needs its coverage factor"}, std::pair{"Fehler [rel.%]", "another unit"},
          std::pair{"Fehler [%]", "of the whole or of the value"},
          std::pair{"% error", "of the whole or of the value"},
          std::pair{"err%", "of the whole or of the value"},
          std::pair{"\u00b1 %", "of the whole or of the value"},
          std::pair{"uncertainty [vol%]", "another unit"}, std::pair{"uncertainty [ppm]", "another unit"}}) {
        const XrdResult result = read_xrd(with_column(heading), "t.csv");
        CHECK_FALSE(result.samples[0].analysis.phases[0].standard_uncertainty);
        CHECK_MESSAGE(result.warnings.front().text.find(why) != std::string::npos,
                      result.warnings.front().text);
    }
    for (const char* heading :
         {"Mean (2SE) [wt%]", "Mittelwert (Spannweite) [Gew.-%]", "FA1 (RSD) [wt%]", "Mean (n) [wt%]"}) {
        CAPTURE(heading);
        const XrdResult result =
            read_xrd("Phase;" + std::string(heading) + "\nQuartz;20 (0.8)\nMullite;80 (1.2)\n", "t.csv");
        CHECK_FALSE(result.samples[0].analysis.phases[0].standard_uncertainty);
        CHECK(contains(joined(texts_of(result.warnings)), "in brackets names no standard uncertainty"));
    }
    for (const char* table : {"Phase;Weight %;Error %\nQuartz;20;3\nMullite;80;2\n",
                              "Phase;Massenanteil in %;Fehler in %\nQuartz;20;3\nMullite;80;2\n",
                              "Sample;Quartz (%);Error (%);Mullite (%);Error (%)\nFA-1;20;3;80;2\n"}) {
        CAPTURE(table);
        const XrdResult result = read_xrd(table, "t.csv");
        CHECK_FALSE(result.samples[0].analysis.phases[0].standard_uncertainty);
        CHECK(contains(joined(texts_of(result.warnings)), "of the whole or of the value"));
    }
    CHECK(contains(
        joined(texts_of(read_xrd("Phase,wt%\nQuartz,20\nMullite,80\nTotal,100.0 \u00b1 1.5\n", "t.csv")
                            .samples[0]
                            .warnings)),
        "the uncertainty of the total is not used"));
    CHECK_THROWS_WITH_AS(
        static_cast<void>(read_xrd("Phase,wt%,error\nQuartz,20,3%\nMullite,80,1%\n", "t.csv")),
        "t.csv: line 2, cell 3: \"3%\" may be per cent of the whole, or of the value before "
        "it; allowed: the number alone, or the unit in the heading of the column",
        InputError);
    for (const char* wrong : {"Phase,wt%,standard [g]\nQuartz,80,\nCorundum,20,0.1\n",
                              "Phase,weight fraction [1]\nQuartz,0.2 +- 3 %\nMullite,0.8\n",
                              "Sample,Quartz [wt%],Mullite [wt%],Magnetite [ppm]\nA,20,80,500\n"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(static_cast<void>(read_xrd(wrong, "t.csv")), InputError);
    }
    CHECK_FALSE(read_xrd("Phase,wt%,error [-]\nQuartz,20,0.004\nMullite,80,0\n", "t.csv")
                    .samples[0]
                    .analysis.phases[0]
                    .standard_uncertainty);
    const XrdSample doubled = read_xrd("Phase,wt%\nQuartz,2.6 (6.5)\nMullite,90 (1)\n", "t.csv").samples[0];
    REQUIRE(doubled.warnings.size() == 1);
    CHECK(doubled.warnings[0].severity == Severity::doubt);
    // Names of samples that look like it.
    const XrdResult named = read_xrd("Phase;Probe 2S;Probe 3S\nQuarz;20;30\nMullit;80;70\n", "t.csv");
    CHECK(named.samples.size() == 2);
}

TEST_CASE("one column of uncertainties behind several of amounts may be of the last or of all") {
    const auto refusal = [](const std::string& heading, const std::string& cells) {
        return input_error_of(
            [&] { return read_xrd(heading + "\nQuarz;" + cells + "\n", "t.csv").samples.front().name; });
    };
    CHECK(contains(refusal("Phase [wt%];FA1;FA2;SD", "30;40;1"), "\"FA2\" alone, or of all"));
    CHECK(contains(refusal("Phase [wt%];FA1;FA2;\u00b1", "30;40;1"), "\"FA2\" alone, or of all"));
    CHECK(refusal("Phase [wt%];FA1;esd;FA2", "30;1;40").empty());
    CHECK(refusal("Phase [wt%];FA1;FA2;FA2 esd", "30;40;1").empty());
    CHECK(refusal("Phase [wt%];FA1;esd;FA2;esd", "30;1;40;1").empty());
    CHECK(refusal("Phase [wt%];FA1;FA2;Mittel;SD", "30;40;35;7").empty());
}

TEST_CASE("what the name of a sample states counts: a basis, a coverage, a standard") {
    const auto refusal = [](const std::string& rows) {
        return input_error_of([&] { return read_xrd(rows, "t.csv").samples.front().name; });
    };
    const auto standard = [](const std::string& rows) {
        return input_error_of(
            [&] { return compose(read_xrd(rows, "t.csv").samples.front().analysis, shipped_catalogue()); });
    };
    const std::string plain = "Sample;Quarz [%];Mullit [%];Glas [%]\n";
    CHECK(contains(refusal(plain + "FA1 (Vol.-%);12,4;24,1;63,5\n"), "Vol.-%"));
    for (const char* name : {"FA1 vol", "Volume", "FA1 Volumen", "FA1Vol", "vf_FA1"})
        CHECK(
            contains(refusal(plain + "FA1;12;24;64\n" + name + ";12;24;64\n"), "states fractions by volume"));
    CHECK(contains(refusal("Phase;Sample;Anteil [%]\nQuarz;FA1 Vol.-%;12,4\nGlas;FA1 Vol.-%;87,6\n"),
                   "Vol.-%"));
    for (const char* name : {"FA1 \u00b1 2\u03c3", "FA1 (k=2)"})
        CHECK(contains(refusal(plain + name + ";12,3 \u00b1 0,8;28,4 \u00b1 1,2;59,3 \u00b1 1,4\n"),
                       "the coverage in the heading"));
    for (const char* name : {"FA1 \u00b1 U", "FA1 \u00b1 Spannweite", "FA1 (95 % CI)", "FA1 (range)"})
        CHECK(contains(refusal(plain + name + ";12,3 \u00b1 0,8;28,4 \u00b1 1,2;59,3 \u00b1 1,4\n"),
                       "in the heading"));
    CHECK(read_xrd(plain + "FA1 (n = 3);12,3 \u00b1 0,8;28,4;59,3\n", "t.csv").samples.size() == 1);
    for (const char* name : {"FA1 (outlier)", "FA1, excluded"})
        CHECK(contains(refusal(plain + name + ";12;24;64\n"), "calls the row invalid"));
    for (const char* name :
         {"FA1 spiked", "FA1 mit Korund", "FA1_Corundum", "FA1 (IS)", "FA1+IS", "FA1 with NIST 676a"})
        CHECK(contains(
            standard("Phase;" + std::string(name) + " [wt%]\nQuarz;11\nMullit;26\nKorund;10\nGlas;53\n"),
            "internal standard"));
    const std::string mixture = "Quarz;11;12\nMullit;26;25\nKorund;10;10\nGlas;53;53\n";
    for (const char* heading : {"Phase (spiked);FA1;FA2\n", "Phase (IS);FA1;FA2\n",
                                "Phase;Mixture with 10 % corundum;\n;FA1;FA2\n", "Phase;Spiked;\n;FA1;FA2\n"})
        CHECK_MESSAGE(contains(standard(heading + mixture), "internal standard"), heading);
    CHECK(standard("Phase;Fly ash;\n;FA1;FA2\nQuarz;11;12\nGlas;89;88\n").empty());
    const std::string uncertain = "FA1;12.3 \u00b1 1.2;28.5 \u00b1 2.4;59.2 \u00b1 3\n";
    for (const char* group :
         {"wt% \u00b1 95 % CI", "wt% (2\u03c3)", "wt% \u00b1 1", "wt% x 10", "multiplied by 10"})
        CHECK_MESSAGE(
            !refusal("Sample;" + std::string(group) + ";;\n;Quartz;Mullite;Amorphous\n" + uncertain).empty(),
            group);
    CHECK(contains(refusal("rel. errors\n" + plain + "FA1;12,3 \u00b1 6;28,4 \u00b1 5;59,3\n"),
                   "states relative uncertainties"));
    CHECK(refusal("Sample;wt%;;\n;Quartz;Mullite;Amorphous\n" + uncertain).empty());
    CHECK(
        contains(refusal("Phase (volume);Content\nQuartz;12\nAmorphous;88\n"), "states fractions by volume"));
    CHECK(contains(standard("Phase;FA1 [wt%]\nQuarz;37\nKorund (ref.);10\nGlas;53\n"), "internal standard"));
    for (const char* name : {"Corundum ash", "FA1 without corundum"})
        CHECK(standard("Phase;" + std::string(name) + " [wt%]\nQuarz;11\nKorund;36\nGlas;53\n").empty());
    for (const char* name : {"FA1 + 10 % Korund", "FA1 (spiked with 10 % corundum)"}) {
        CAPTURE(name);
        const std::string row = std::string(name) + ";11;26;10;53\n";
        CHECK(contains(standard("Sample;Quarz;Mullit;Korund;Glas\n" + row), "internal standard"));
    }
    CHECK(
        contains(standard("Phase;FA1 spiked with corundum [wt%]\nQuarz;11\nMullit;26\nKorund;10\nGlas;53\n"),
                 "internal standard"));
    for (const char* name : {"FA1", "McKenzie", "CaCl2 ash", "FA1 + lime", "FA1 + 10 % lime", "Ash 2.5 um",
                             "FA1 (Gew.-%)", "FA1 2s"}) {
        CAPTURE(name);
        CHECK(read_xrd(plain + name + ";12;24;64\n", "t.csv").samples.front().analysis.phases.size() == 3);
    }
}

TEST_CASE("a complete BGMN list of six phases") {
    const XrdResult result = read("fa07-corundum.lst");
    CHECK(result.format == XrdFormat::bgmn_lst);
    CHECK(name_of(result.format) == "BGMN/Profex .lst");
    REQUIRE(result.samples.size() == 1);
    const XrdSample& sample = result.samples[0];
    CHECK(sample.name == "FA-07_10pct-corundum");
    CHECK(sample.warnings.empty());
    CHECK(digest(sample) ==
          "Quartz 1523, Mullite 5610, Hematite 412, Magnetite 656, Anhydrite 480, Corundum 1319");
    // GEWICHT=0.5049+-0.0038 over the sum 0.9
    CHECK(relative_difference(sample.analysis.phases[1].fraction, 0.561) < 1e-14);
    CHECK(relative_difference(*sample.analysis.phases[1].standard_uncertainty, 0.0038 / 0.9) < 1e-14);
    CHECK(relative_difference(*sample.analysis.phases[1].density, 3166) < 1e-14);
    CHECK(std::holds_alternative<AmorphousNotStated>(sample.analysis.amorphous));
    CHECK(contains(input_error_of([&] { return compose(sample.analysis, shipped_catalogue()); }),
                   "\"Corundum\" is called an internal standard"));  // by the name of the sample
}

TEST_CASE("goals of a BGMN list that could not be computed are reported, with a block or without") {
    const XrdSample sample =
        read_xrd(
            "Rietveld refinement to file(s) one.xy\nGlobal parameters and GOALs\n*****\nQQuartz=ERROR\n"
            "QMullite=ERROR\n\nLocal parameters and GOALs for phase Quartz\n*****\nGEWICHT=0.25+-0.01\n\n",
            "one.lst")
            .samples[0];
    REQUIRE(sample.warnings.size() == 2);
    CHECK(sample.warnings[0].text == "the goal QQuartz could not be computed by the refinement");
    CHECK(contains(sample.warnings[1].text, "the goal QMullite (line 5) could not be computed"));
}

TEST_CASE("every unknown phase of a BGMN list is named at its own line") {
    std::string text;
    for (const char* phase : {"Quartz", "Fooite", "Barite99"})
        text += "Local parameters and GOALs for phase " + std::string(phase) + "\n*****\nGEWICHT=0.2\n\n";
    XrdSample sample = read_xrd(text, "ash.lst").samples[0];
    sample.analysis.amorphous = AmorphousNone{};
    const std::string message = input_error_of([&] { return compose(sample.analysis, shipped_catalogue()); });
    CHECK(contains(message, "line 7: no phase is called \"Fooite\""));
    CHECK(contains(message, "; line 11: no phase is called \"Barite99\""));
    CHECK(contains(message, "--phases FILE"));
}

TEST_CASE("the internal standard turns it into fractions of the whole ash") {
    const XrdSample sample = with_internal_standard(read("fa07-corundum.lst").samples[0], "corundum", 0.1);
    CHECK(sample.analysis.phases.size() == 5);
    // scale = 0.1/(0.1318888... 0.9); mullite 0.561 of the mixture; worked by hand in docs/materials.md
    const Composition composition = compose(sample.analysis, shipped_catalogue());
    REQUIRE(composition.components.size() == 6);
    CHECK(relative_difference(composition.components[1].weight_fraction, 0.47262005) < 1e-8);
    CHECK(relative_difference(composition.components[5].weight_fraction, 0.26865113) < 1e-7);
    CHECK(composition.components[5].phase.name == "glass-dong2013");
    const auto& remainder = std::get<AmorphousRemainder>(sample.analysis.amorphous);
    CHECK(relative_difference(*remainder.standard_uncertainty, 0.84245998 * 0.0011 / 0.1187) < 1e-8);
    const ModulusEstimate estimate = estimate_modulus(composition);
    CHECK(relative_difference(estimate.young_modulus, 152.000603244213e9) < 1e-13);
    REQUIRE_FALSE(sample.name.empty());
    CHECK(contains(input_error_of([&] { return with_internal_standard(sample, "corundum", 0.1); }),
                   "is not among the phases of \"" + sample.name + "\""));  // the histogram of several
    const XrdSample mixture = read("fa07-corundum.lst").samples[0];
    CHECK(contains(input_error_of([&] { return with_internal_standard(mixture, "Corundum", 10); }),
                   "above 0, below 1"));
    CHECK(contains(input_error_of([&] { return with_internal_standard(mixture, "Corundum", 0.2); }),
                   "% of the sample are crystalline"));
}

TEST_CASE("the uncertainty of the weighing goes into the scale of an internal standard") {
    const XrdSample mixture = read("fa07-corundum.lst").samples[0];
    const auto scale_uncertainty = [&](std::optional<double> weighing) {
        const XrdSample sample = with_internal_standard(mixture, "corundum", 0.1, weighing);
        return *std::get<AmorphousRemainder>(sample.analysis.amorphous).standard_uncertainty;
    };
    // p = w/(c (1 - w)): u(w)/(w (1 - w)) = 0.001/0.09 beside u(c)/c = 0.0011/0.1187
    CHECK(relative_difference(scale_uncertainty(0.001),
                              0.842459983 * std::hypot(0.001 / 0.09, 0.0011 / 0.1187)) < 1e-8);
    const std::string table = "phase,wt%,standard [%]\nQuartz,90,\nCorundum,10,5.0(1)\n";
    const XrdSample read_sample = read_xrd(table, "t.csv").samples[0];
    const auto& remainder = std::get<AmorphousRemainder>(read_sample.analysis.amorphous);
    CHECK(relative_difference(*remainder.standard_uncertainty, 0.05 / (0.1 * 0.95) * 0.001 / (0.05 * 0.95)) <
          1e-12);
}

TEST_CASE("phases keep the place at which their file has them") {
    CHECK(read("fa07-corundum.lst").samples[0].analysis.phases[1].place == "line 50");
    CHECK(read("fa07-gsas2.lst").samples[0].analysis.phases[1].place == "line 37");
    CHECK(read("long-percent.csv").samples[0].analysis.phases[1].place == "line 4");
    CHECK(read("peaks.csv").samples[0].analysis.phases[1].place == "line 4");
    CHECK(read("samples.json").samples[0].analysis.phases[1].place == "line 7: /samples/0/phases/1");
    CHECK(read("samples.json").samples[2].analysis.phases[1].place == "line 23: /samples/2/peaks/1");
}

TEST_CASE("a BGMN list with CRLF, UNDEF, ERROR, mean values and missing uncertainties") {
    const XrdResult result = read("fa12-crlf-undef.lst");
    REQUIRE(result.samples.size() == 1);
    const XrdSample& sample = result.samples[0];
    CHECK(sample.name == "FA-12");
    CHECK(digest(sample) == "Quartz 3021, Mullite 6979");
    CHECK(!sample.analysis.phases[0].standard_uncertainty);
    CHECK(relative_difference(*sample.analysis.phases[1].standard_uncertainty, 0.0088) < 1e-14);
    REQUIRE(sample.warnings.size() == 3);
    CHECK(contains(sample.warnings[2].text, "\"Quartz\" has no uncertainty, as other phases do"));
    CHECK(sample.warnings[0].text == "the phase \"Lime\" has no weight (line 34) and is left out");
    CHECK(sample.warnings[1].text == "the phase \"Calcite\" has no weight (line 39) and is left out");
}

TEST_CASE("a BGMN goal that differs from the weights is reported") {
    std::string text = file_text(ASHIMPACT_TEST_DATA "/xrd/fa07-corundum.lst");
    text.replace(text.find("QMullite=0.5610"), 15, "QMullite=0.6010");
    const XrdResult result = read_xrd(text, "fa07.lst");
    REQUIRE(result.samples[0].warnings.size() == 1);
    CHECK(contains(result.samples[0].warnings[0].text, "the goal QMullite is 0.601, GEWICHT gives 0.561"));
}

TEST_CASE("goals of a BGMN list name their block in any case, with the mark of a goal or without") {
    for (const char* goal : {"Qmullite=0.6010", "QMULLITE=0.6010", "qMullite=0.6010"}) {
        std::string text = file_text(ASHIMPACT_TEST_DATA "/xrd/fa07-corundum.lst");
        text.replace(text.find("QMullite=0.5610"), 15, goal);
        const XrdResult result = read_xrd(text, "fa07.lst");
        REQUIRE(result.samples[0].warnings.size() == 1);
        CHECK(contains(result.samples[0].warnings[0].text, "is 0.601, GEWICHT gives 0.561"));
    }
    std::string text = file_text(ASHIMPACT_TEST_DATA "/xrd/fa07-corundum.lst");
    text.replace(text.find("QQuartz=0.1523"), 7, "quartz");
    CHECK(read_xrd(text, "fa07.lst").samples[0].analysis.phases.size() == 6);
}

TEST_CASE("a fraction in JSON states no other basis than the phases have") {
    for (const char* unit : {"m3/m3", "(vol/vol)", "v/v", "l/l"})
        for (const std::string& keys :
             {R"("weight_fractions": {"quartz": 0.1}, "amorphous": "0.47 )" + std::string(unit) + '"',
              R"("weight_fractions": {"quartz": "0.1 )" + std::string(unit) +
                  R"("}, "amorphous": "remainder")",
              R"("weight_fractions": {"quartz": 0.1}, "amorphous": {"crystalline_total": "0.5 )" +
                  std::string(unit) + "\"}"})
            CHECK(contains(input_error_of([&] {
                               return read_xrd(R"({"samples": [{"name": "a", )" + keys + "}]}", "a.json");
                           }),
                           "is by volume, and the phases are by weight"));
    CHECK(read_xrd(R"({"samples": [{"name": "a", "volume_fractions": {"quartz": "0.53 m3/m3"},
                       "amorphous": "0.47 m3/m3"}]})",
                   "a.json")
              .samples.front()
              .analysis.phases.front()
              .fraction == doctest::Approx(0.53));
}

TEST_CASE("a GSAS-II list with two histograms") {
    const XrdResult result = read("fa07-gsas2.lst");
    CHECK(result.format == XrdFormat::gsas2_lst);
    REQUIRE(result.samples.size() == 2);
    CHECK(result.samples[0].name == "FA-07.xy Bank 1");
    CHECK(digest(result.samples[0]) == "Quartz 1983, Mullite 3:2 7302, Hematite 715");
    CHECK(digest(result.samples[1]) == "Quartz 2801, Mullite 3:2 7199");
    const auto& phases = result.samples[0].analysis.phases;
    CHECK(phases[0].standard_uncertainty == 0.00171);
    CHECK(!phases[2].standard_uncertainty);
    CHECK(relative_difference(*phases[1].density, 3160.2) < 1e-14);
}

TEST_CASE("tables as laboratories send them") {
    const XrdResult long_table = read("long-percent.csv");
    REQUIRE(long_table.samples.size() == 2);
    CHECK(digest(long_table.samples[0]) == "Quartz 1231, Mullite (3:2) 2840, Hematite 190, Amorphous 5739");
    CHECK(relative_difference(*long_table.samples[0].analysis.phases[1].standard_uncertainty, 0.0055) <
          1e-14);
    CHECK(relative_difference(*long_table.samples[0].analysis.phases[2].density, 5260) < 1e-14);
    CHECK(digest(long_table.samples[1]) == "Quartz 805, Mullite 3195, Amorphous 6000");
    CHECK(relative_difference(*long_table.samples[1].analysis.phases[0].standard_uncertainty, 0.0012) <
          1e-12);
    CHECK(relative_difference(*long_table.samples[1].analysis.phases[1].standard_uncertainty, 0.006) < 1e-14);
    REQUIRE(long_table.samples[1].warnings.size() == 1);
    CHECK(long_table.samples[1].warnings[0].text ==
          "\"Magnetite\" in \"FA-02\" has no amount (line 9: \"n.d.\") and is left out");
    REQUIRE(long_table.warnings.size() == 2);
    CHECK(contains(long_table.warnings[0].text, "a comment, is no part of the table"));
    CHECK(long_table.warnings[1].text.starts_with("column \"Remark\" is not used: \""));
    CHECK(relative_difference(amorphous_of(long_table.samples[0]), 0.5739) < 1e-14);

    const XrdResult german = read("semicolon-comma.csv");
    REQUIRE(german.samples.size() == 1);
    CHECK(digest(german.samples[0]) == "Quarz 1182, Mullite 5, Amorphous 8813");
    CHECK(relative_difference(*german.samples[0].analysis.phases[2].standard_uncertainty, 0.008) < 1e-14);

    const XrdResult latin1 = read("latin1.csv");
    CHECK(latin1.samples[0].name == "M\u00fcnchen");
    CHECK(relative_difference(*latin1.samples[0].analysis.phases[0].standard_uncertainty, 0.003) < 1e-14);
    CHECK(texts_of(latin1.warnings) ==
          std::vector<std::string>{"the file is not UTF-8 and was read as Latin-1"});

    const XrdResult bom = read("bom-crlf.csv");
    CHECK(bom.samples[0].name == "bom-crlf");
    CHECK(digest(bom.samples[0]) == "Quartz 2000, Mullite 3000, Glass 5000");
}

TEST_CASE("tables with one column a phase or one column a sample") {
    const XrdResult phases = read("wide-phases.tsv");
    REQUIRE(phases.samples.size() == 2);
    CHECK(digest(phases.samples[0]) == "Quartz 1230, Mullite 2840, Anhydrite 130, Amorphous 5800");
    CHECK(digest(phases.samples[1]) == "Quartz 810, Mullite 3200, Amorphous 5990");
    CHECK(relative_difference(*phases.samples[0].analysis.phases[0].standard_uncertainty, 0.002) < 1e-14);

    const XrdResult samples = read("wide-samples.csv");
    REQUIRE(samples.samples.size() == 2);
    CHECK(samples.samples[1].name == "FA-02");
    CHECK(digest(samples.samples[1]) == "Quartz 810, Mullite 3200, Glass 5990");
    REQUIRE(samples.warnings.size() == 1);
    CHECK(contains(samples.warnings[0].text, "by their size they are fractions"));
}

TEST_CASE("phases of a sample of another name are told") {
    const auto remark = [](std::string_view table, const std::string& sample) {
        const auto named = read_xrd(table, "folder/ash.csv").samples.front().name;
        return other_sample_finding(xrd_code, "phases", named, "folder/ash.csv", sample);
    };
    for (const char* table : {"Sample,Quartz,Mullite,Glass\nFA 8,12,19,69\n",
                              "Phase,FA 8 [wt%]\nQuartz,12\nMullite,19\nGlass,69\n"}) {
        CHECK(remark(table, "FA 7")->text == "the phases are those of the sample \"FA 8\"");
        CHECK_FALSE(remark(table, "fa8"));
        for (const char* other : {"FA 8'", "FA 8*", "FA -8"}) CHECK(remark(table, other));
    }
    CHECK_FALSE(remark("Phase,wt%\nQuartz,12\nMullite,19\nGlass,69\n", "FA 7"));
}

TEST_CASE("columns and rows beside a sample that are not read as its uncertainties are told") {
    const auto told = [](const std::string& table, std::size_t samples) {
        const XrdResult result = read_xrd(table, "t.csv");
        CHECK(result.samples.size() == samples);
        for (const PhaseFraction& phase : result.samples.front().analysis.phases)
            CHECK_FALSE(phase.standard_uncertainty);
        std::string texts;
        for (const auto* list : {&result.warnings, &result.samples.front().warnings})
            for (const Finding& each : *list) texts += each.text + '\n';
        return texts;
    };
    CHECK(
        contains(told("Phase;FA1;FA1 SE;FA2\nMullite;30;3;20\nQuartz;70;2;80\n", 2),
                 "uncertainties of column \"FA1 SE\" are not read, as \"SE\" names no standard uncertainty"));
    CHECK(contains(told("Sample;Mullite;Quartz\nFA1;30;70\nFA1 RSD;3;2\n", 1),
                   "the numbers in line 3 are not read, as \"FA1 RSD\": \"RSD\" names no"));
    CHECK(contains(told("Phase;FA1;FA1 wet;FA2\nMullite;30;3;20\nQuartz;70;2;80\n", 3),
                   "\"FA1 wet\" is not read as uncertainties of \"FA1\": write \"FA1 esd\""));
    for (const char* label : {"s", "twice sd", "rel. esd", "err3"})
        CHECK(contains(told("Sample;Mullite;Quartz\nFA1;30;70\n" + std::string(label) + ";3;2\n", 2),
                       "\" is not read as uncertainties of \"FA1\": write \"FA1 esd\""));
    CHECK(contains(told("Sample;Mullite;Quartz\nFA1;30;70\n95% CI;3;2\n", 1), "left out: \"95% CI\""));
    CHECK_FALSE(contains(told("Phase;FA1;FA1 wet;FA2\nMullite;30;32;20\nQuartz;70;68;80\n", 3),
                         "not read as uncertainties"));
}

TEST_CASE("a coverage behind the name of a sample or phase divides uncertainties, never amounts") {
    const auto first = [](const std::string& text) { return read_xrd(text, "t.csv").samples.front(); };
    for (const char* heading : {"FA1 (\u00b1 2\u03c3)", "FA1 (k=2)", "FA1 [wt%] \u00b1 2\u03c3"}) {
        CAPTURE(heading);
        for (const char* uncertainty : {" \u00b1 0.6", ""}) {
            const XrdSample sample = first("Phase;" + std::string(heading) + ";FA2 (k=2)\nQuartz;60" +
                                           uncertainty + ";10\nMullite;40" + uncertainty + ";90\n");
            CHECK(digest(sample) == "Quartz 6000, Mullite 4000");
            const auto& u = sample.analysis.phases[0].standard_uncertainty;
            CHECK(u.has_value() == (*uncertainty != '\0'));
            if (u) CHECK(*u == doctest::Approx(0.003));
        }
    }
    CHECK(digest(first("Sample;Quartz (2s);Mullite (2s)\nFA1;60;40\n")) == "Quartz 6000, Mullite 4000");
    const XrdSample beside = first("Phase;FA1 [wt%];FA1 (2s)\nQuartz;60;1\nMullite;40;1\n");
    CHECK(*beside.analysis.phases[0].standard_uncertainty == doctest::Approx(0.005));
}

TEST_CASE("a unit of amounts in the heading of the names is refused, unless the amounts state it") {
    const auto error = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_xrd(text, "t.csv")); });
    };
    for (const char* corner : {"Phase [Vol.-%]", "Phase / Vol.-%", "Mineral (vol%)"})
        CHECK(contains(error(std::string(corner) + ";FA1;FA2\nQuartz;60;10\nMullite;40;90\n"),
                       "of the names states a unit of amounts"));
    CHECK(contains(error("Phase [mol%];FA1;FA2\nQuartz;60;10\nMullite;40;90\n"), "states fractions by mole"));
    CHECK(contains(error("Phase (area);FA1;FA2\nQuartz;60;10\nMullite;40;90\n"),
                   "\"(area)\" is not understood"));
    CHECK(contains(error("Phase;FA1 area;FA2 area\nQuartz;60;10\nMullite;40;90\n"), "FA1 area"));
    CHECK(contains(error("Phase;FA1_m;FA1_v\nQuartz;60;10\nMullite;40;90\n"),
                   "may be two samples, or one by weight and by volume"));
    CHECK(error("Phase;FA1_a;FA1_v\nQuartz;60;10\nMullite;40;90\n").empty());
    CHECK(error("Phase (Name);FA1 [wt%]\nQuartz;60\nMullite;40\n").empty());
    CHECK(error("Phase [wt%];FA1;FA2\nQuartz;60;10\nMullite;40;90\n").empty());
    CHECK(error("Phase [vol%];FA1 [vol%]\nQuartz;60\nMullite;40\n").empty());
}

TEST_CASE("headings of fractions are read as what they state, and what is no fraction is refused") {
    const auto of = [](const std::string& heading, const std::string& amounts = "60;40") {
        const auto half = amounts.find(';');
        return read_xrd("phase;" + heading + "\nQuartz;" + amounts.substr(0, half) + "\nMullite;" +
                            amounts.substr(half + 1) + "\n",
                        "t.csv");
    };
    for (const char* heading : {"Volumen-%", "V%", "% v/v", "Vol.-%", "Gehalt [Vol.-%]", "Volumenanteil [%]",
                                "content, vol%", "Anteil in Vol.-%", "FA1 vol%"}) {
        CAPTURE(heading);
        const XrdResult result = of(heading);
        CHECK(result.samples.front().analysis.basis == FractionBasis::volume);
        CHECK(digest(result.samples.front()) == "Quartz 6000, Mullite 4000");
    }
    for (const char* heading :
         {"wt%", "Gew.-%", "Massen-%", "Ma.-%", "Gehalt [wt%]", "w [%]", "Massenanteil in %", "FA1 [wt%]",
          "w [g/100 g]", "Weight fraction/ %", "Probe 1 (Gew.-%)"}) {
        CAPTURE(heading);
        CHECK(of(heading).samples.front().analysis.basis == FractionBasis::weight);
    }
    for (const char* heading : {"m%", "M.-%", "m-%", "Content (% w/w)", "Gehalt % w/w", "FA1 wt %",
                                "wt% (n=3)", "FA1 (n = 3) [wt%]"}) {
        CAPTURE(heading);
        const XrdResult result = of(heading);
        CHECK(result.samples.front().analysis.basis == FractionBasis::weight);
        CHECK(digest(result.samples.front()) == "Quartz 6000, Mullite 4000");
        CHECK(result.samples.front().name.find_first_of("%(") == std::string::npos);
    }
    for (const auto& [heading, amounts] : {std::pair{"ppm", "600000;400000"},
                                           {"Gehalt [\u2030]", "600;400"},
                                           {"wt\u2030", "600;400"},
                                           {"% poids", "60;40"},
                                           {"% en masse", "60;40"},
                                           {"wt% of total", "60;40"},
                                           {"\"wt%\n(n=3)\"", "60;40"},
                                           {"w [mg/kg]", "600000;400000"},
                                           {"g/kg", "600;400"},
                                           {"Gehalt in g/kg", "600;400"},
                                           {"Gehalt [mg/g]", "600;400"},
                                           {"kg/kg", "0.6;0.4"},
                                           {"w [g/g]", "0.6;0.4"}}) {
        CAPTURE(heading);
        CHECK(digest(of(heading, amounts).samples.front()) == "Quartz 6000, Mullite 4000");
    }
    CHECK(of("ppm (v/v)", "600000;400000").samples.front().analysis.basis == FractionBasis::volume);
    CHECK(digest(of("content", "60 wt%;40.0 wt.-%").samples.front()) == "Quartz 6000, Mullite 4000");
    CHECK(contains(input_error_of([&] { static_cast<void>(of("content", "60 vol%;40 vol%")); }),
                   "cannot read"));
    CHECK(contains(input_error_of([&] { static_cast<void>(of("wt%", "60 \u00b1 3%;40")); }),
                   "line 2, cell 2: in \"60 \u00b1 3%\" the uncertainty is 3 % of 60, or 3 in the unit"));
    const XrdResult crystalline = of("wt% (crystalline)", "59,8;40,1");
    CHECK(relative_difference(crystalline.samples.front().analysis.phases[0].fraction, 59.8 / 99.9) < 1e-14);
    CHECK(contains(crystalline.samples.front().warnings.front().text, "the crystalline part"));
    for (const char* heading : {"Mol-%",
                                "mol%",
                                "at.%",
                                "Gehalt [Mol-%]",
                                "counts",
                                "FWHM",
                                "g",
                                "log wt%",
                                "d [\u00c5]",
                                "1/wt%",
                                "1 / wt%",
                                "\u0394 wt%",
                                "Stoffmengenanteil",
                                "Gehalt [Fl\u00e4chen-%]",
                                "Gehalt in Mol-%",
                                "Gehalt [J]",
                                "Volume [cm3]",
                                "FA1 mol%",
                                "FA1 [at.%]",
                                "St\u00fcck-%",
                                "cts"}) {
        CAPTURE(heading);
        CHECK(contains(input_error_of([&] { static_cast<void>(of(heading)); }),
                       "no weight or volume fractions"));
    }
    for (const char* heading : {"A \u00b1 2 [wt%]", "wt% (\u00b12)"})
        CHECK_MESSAGE(contains(input_error_of([&] { static_cast<void>(of(heading)); }),
                               "states one uncertainty, 2, for all numbers of its column"),
                      heading);
    for (const char* heading : {"Rel. Int. [%]", "\u00c1rea [%]", "Fl\u00e4chen-%", "relative intensity"}) {
        CAPTURE(heading);
        CHECK(
            contains(input_error_of([&] { static_cast<void>(of(heading)); }), "reference intensity ratios"));
    }
}

TEST_CASE("headings with two bases, or with what changes a number, hold no fractions") {
    for (const char* heading : {"wt%/vol%", "Vol. and wt %", "wt% (vol)", "log10(wt%)", "sqrt wt%",
                                "cum. wt%", "cumulative %", "peak %", "wt% <", "delta [wt%]"}) {
        CAPTURE(heading);
        CHECK(contains(input_error_of([&] {
                           return read_xrd("phase;" + std::string(heading) + "\nQuartz;60\nMullite;40\n",
                                           "t.csv");
                       }),
                       "holds no weight or volume fractions"));
    }
    CHECK(contains(
        input_error_of([] { return read_xrd("phase;crystalline wt%\nQuartz;30\nMullite;15\n", "t.csv"); }),
        "the fractions of the crystalline part add up to 45 %"));
    for (const auto& [mullite, tells] : {std::pair{"0.003", true}, {"0.3", false}}) {
        const std::string rows = std::string("Quartz;60;0.004\nMullite;40;") + mullite + "\n";
        const auto warnings = read_xrd("Phase;Anteil [%];Fehler\n" + rows, "t.csv").warnings;
        CHECK(std::ranges::any_of(warnings, [](const Finding& each) {
                  return contains(each.text, "the uncertainties, such as \"0.004\", are taken as per cent");
              }) == tells);
    }
    const XrdResult scaled = read_xrd("phase;wt%;esd x100\nQuartz;60;20\nMullite;40;30\n", "t.csv");
    CHECK_FALSE(scaled.samples[0].analysis.phases[0].standard_uncertainty);
    CHECK(contains(joined(texts_of(scaled.warnings)), "such a multiple is not plausible"));
}

TEST_CASE("a heading that is not known is no sample, and the units of all samples and phases count") {
    const auto refusal = [](const std::string& table) {
        return input_error_of([&] { static_cast<void>(read_xrd(table, "t.csv")); });
    };
    const std::string amounts = "\nQuartz;20;20\nMullite;80;80\n";
    CHECK(contains(
        refusal("Phase;Messwert\nQuartz;20\nMullite;80\n"),
        "\"Messwert\" may be a sample, or a quantity that is not known here; allowed: \"weight %\""));
    CHECK(read_xrd("Phase;A;B" + amounts, "t.csv").samples.size() == 2);
    CHECK(contains(refusal("Phase;A [mol%];B [mol%]" + amounts), "no weight or volume fractions"));
    CHECK(contains(refusal("Phase;A [wt%];B [vol%]" + amounts), "fractions by weight and by volume"));
    for (const char* unit : {" [mol%]", " mol%", " [counts]", " (mg/l)", " [Fl\u00e4chen-%]"}) {
        CAPTURE(unit);
        CHECK(contains(refusal(std::string("Sample;Quartz") + unit + ";Mullite" + unit + "\nA;20;80\n"),
                       "is in another unit; allowed: fractions by weight or by volume"));
    }
    CHECK(read_xrd("Sample;Quartz vol%;Mullite vol%\nA;20;80\n", "t.csv").samples[0].analysis.basis ==
          FractionBasis::volume);
}

TEST_CASE("columns and rows that are no phases are set aside, and named") {
    const XrdResult columns = read_xrd(
        "Sample;Quartz;Mullite;Glass;Blaine [cm2/g];Rwp;GOF;chi2;density [g/cm3];LOI "
        "[%];\nA;20;30;50;3500;7.8;1.9;3.6;2.3;"
        "4.1;x\n",
        "t.csv");
    CHECK(digest(columns.samples.front()) == "Quartz 2000, Mullite 3000, Glass 5000");
    const std::string told = joined(texts_of(columns.warnings));
    for (const char* name : {"\"Blaine [cm2/g]\"", "\"Rwp\"", "\"GOF\"", "\"chi2\"", "\"density [g/cm3]\"",
                             "\"LOI [%]\"", "11, which has no heading,"})
        CHECK_MESSAGE(contains(told, "column " + std::string(name) + " is not used"), told);
    const XrdResult rows = read_xrd(
        "Phase;A [wt%];B [wt%];ICSD;Density [g/cm3]\nQuartz;20;30;1;2.6\nGlass;80;70;2;2.4\nRwp;7.8;8;;\n",
        "t.csv");
    REQUIRE(rows.samples.size() == 2);
    CHECK(digest(rows.samples.back()) == "Quartz 3000, Glass 7000");
    CHECK(rows.samples.back().analysis.phases.front().density == 2600);
    CHECK(contains(joined(texts_of(rows.warnings)), "line 4 is no phase and left out: \"Rwp\""));
    CHECK(contains(joined(texts_of(rows.warnings)), "column \"ICSD\" is not used"));
}

TEST_CASE("columns that sum up samples, and results beside the intensities they come from") {
    const XrdResult repeats = read_xrd(
        "Phase;FA-1;FA-2;Mittelwert;Stabw.\nQuarz;12,3;12,5;12,4;0,1\nGlas;87,7;87,5;87,6;0,1\n", "t.csv");
    REQUIRE(repeats.samples.size() == 2);
    CHECK(contains(joined(texts_of(repeats.warnings)), "column \"Mittelwert\" is not used"));
    const XrdResult mean = read_xrd("Phase;Mittelwert [%];Stabw.\nQuarz;12,4;0,1\nGlas;87,6;0,1\n", "t.csv");
    CHECK(mean.samples.front().analysis.phases.front().standard_uncertainty.value() ==
          doctest::Approx(0.001));
    const XrdResult range =
        read_xrd("Phase;Mean [wt%];SD;Min;Max\nQuartz;20;1;19;21\nGlass;80;1;79;81\n", "t.csv");
    REQUIRE(range.samples.size() == 1);
    CHECK(digest(range.samples.front()) == "Quartz 2000, Glass 8000");
    CHECK(range.samples.front().analysis.phases.front().standard_uncertainty.value() ==
          doctest::Approx(0.01));
    CHECK(contains(joined(texts_of(range.warnings)), "column \"Max\" is not used"));
    const XrdResult jade = read_xrd(
        "Phase ID;Formula;Wt%;esd;I/Ic;I%;esd\nQuartz, low;SiO2;12.3;0.2;3.41;100;3\nGlass;;87.7;0.3;;;\n",
        "t.csv");
    CHECK(digest(jade.samples.front()) == "Quartz, low 1230, Glass 8770");
    CHECK(jade.samples.front().analysis.phases.front().standard_uncertainty.value() ==
          doctest::Approx(0.002));
    for (const char* name : {"\"Formula\"", "\"I/Ic\""})
        CHECK(contains(joined(texts_of(jade.warnings)), "column " + std::string(name) + " is not used"));
    for (const char* heading : {"Quartz/wt%,Glass/wt%", "Quartz \uff08wt%\uff09,Glass \uff08wt%\uff09"})
        CHECK(
            digest(read_xrd("Sample No.," + std::string(heading) + "\nA,20,80\n", "t.csv").samples.front()) ==
            "Quartz 2000, Glass 8000");
}

TEST_CASE("headings in other languages, and as programs export them") {
    const auto of = [](const std::string& heading) {
        const XrdResult result = read_xrd(heading + "\nQuartz;20\nGlass;80\n", "t.csv");
        REQUIRE(result.samples.size() == 1);
        CHECK(digest(result.samples.front()) == "Quartz 2000, Glass 8000");
        CHECK(texts_of(result.warnings).empty());
        return result.samples.front().analysis.basis;
    };
    for (const char* heading : {"Fase;% en peso", "Fase;% in peso", "Faza;Zawarto\u015b\u0107 [% wag.]",
                                "Fase;% em peso", "fase;gew.%", "\u9271\u7269;\u8cea\u91cf\u5206\u7387(%)",
                                "\u0424\u0430\u0437\u0430;\u041c\u0430\u0441\u0441\u043e\u0432\u0430\u044f "
                                "\u0434\u043e\u043b\u044f, %",
                                "\u77ff\u7269;\u8d28\u91cf\u5206\u6570/%", "Minerals;wt%", "Phase ID (2);Wt%",
                                "Compound Name;S-Q [%]", "Phase;RIR wt%", "Phase;m/m%"}) {
        CAPTURE(heading);
        CHECK(of(heading) == FractionBasis::weight);
    }
    CHECK(of("F\u00e1ze;% obj.") == FractionBasis::volume);
    CHECK(read_xrd("\u77ff\u7269;wt%\nQuartz;20\nGlass;80\n\u5408\u8ba1;100\n", "t.csv").samples.size() == 1);
    const XrdResult projects = read_xrd("Project;Sample;Quartz;Glass\nX;A;20;80\nX;B;30;70\n", "t.csv");
    CHECK(digest(projects.samples.back()) == "Quartz 3000, Glass 7000");
    CHECK(contains(joined(texts_of(projects.warnings)), "column \"Project\" is not used"));
}

TEST_CASE("a text beside the table that calls one of its phases an internal standard marks that phase") {
    const std::string table = "Phase;wt%\nQuartz;10\nCorundum;10\nGlass;80\n";
    const auto is_standard = [](const std::string& text) {
        return read_xrd(text, "t.csv").samples.front().analysis.phases[1].is_standard;
    };
    for (const char* text : {"spiked with 10 % corundum", "corundum = internal standard",
                             "mit 10 % Korund als interner Standard", "\u00e9talon interne: corindon 10 %"}) {
        CAPTURE(text);
        CHECK(is_standard(text + ("\n" + table)));
        CHECK(is_standard("# " + (text + ("\n" + table))));
        CHECK(is_standard(table + "\n" + text + "\n"));
    }
    for (const char* text : {"corundum was not added", "corundum is natural", "rutile as internal standard"})
        CHECK_FALSE(is_standard(text + ("\n" + table)));
}

TEST_CASE("fractions by weight are preferred to those by volume beside them, with their own uncertainties") {
    const XrdResult result =
        read_xrd("Phase;vol%;esd;wt%;esd\nQuartz;25;9;20;0.3\nGlass;75;9;80;1\n", "t.csv");
    const auto& analysis = result.samples.front().analysis;
    CHECK(analysis.basis == FractionBasis::weight);
    CHECK(analysis.phases.front().standard_uncertainty.value() == doctest::Approx(0.003));
    CHECK(contains(joined(texts_of(result.warnings)), "column \"vol%\" is not used"));
}

TEST_CASE("uncertainties without a name behind a column that is not used are of that column") {
    const auto first = [](const std::string& table) {
        const XrdResult result = read_xrd(table, "t.csv");
        CAPTURE(table);
        CHECK(contains(joined(texts_of(result.warnings)), "is not used"));
        return result.samples.front().analysis.phases.front().standard_uncertainty;
    };
    for (const char* behind : {"esd", "\u00b1", "2 sigma", "error", "esd [nm]"}) {
        const std::string size = std::string("crystallite size [nm];") + behind;
        CHECK_FALSE(first("Phase;wt%;" + size + "\nQuartz;20;100;2\nGlass;80;100;2\n"));
        CHECK_FALSE(first("Phase;" + size + ";wt%\nQuartz;100;2;20\nGlass;100;2;80\n"));
        CHECK(first("Phase;" + size + ";wt%;esd\nQuartz;100;2;20;0.3\nGlass;100;2;80;1\n").value() ==
              doctest::Approx(0.003));
    }
    CHECK_FALSE(first("Sample;Quartz;Rwp;esd;Glass\nA;20;9;0.5;80\n"));
    // Texts and detection limits have no uncertainty, and a name or a unit states whose it is.
    for (const char* between : {"Formula;esd", "LOD;esd", "Biso;weight error", "Biso;esd [wt%]"}) {
        CAPTURE(between);
        const char* const cell = std::string_view(between).starts_with("Formula") ? "SiO2" : "0.5";
        CHECK(first(std::string("Phase;wt%;") + between + "\nQuartz;20;" + cell + ";0.3\nGlass;80;" + cell +
                    ";1\n")
                  .value() == doctest::Approx(0.003));
    }
    const auto peaks = first("Phase;2theta;esd;I;esd;RIR\nQuartz;26;2;3100;31;3.1\nMullite;26;2;2000;0;2\n");
    CHECK(peaks.value() == doctest::Approx(0.005));
    CHECK_FALSE(first("Phase;2theta;esd;I;RIR\nQuartz;26;2;3100;3.1\nMullite;26;2;2000;2\n"));
}

TEST_CASE("uncertainties of peaks belong to the column before them, in its unit") {
    const auto read = [](const std::string& heading) {
        return read_xrd("Phase;" + heading + "\nQuartz;3100;31;3.1;0.31\nMullite;2000;20;2;0\n", "t.csv");
    };
    // u(w)/w = (1 - w) u(I/RIR)/(I/RIR), of which only the own term is kept: 0.5 hypot(1 %, 10 %).
    for (const char* heading : {"I;esd;RIR;esd", "I (counts);esd;RIR (calc);RIR esd"})
        CHECK(read(heading).samples[0].analysis.phases[0].standard_uncertainty.value() ==
              doctest::Approx(0.5 * std::hypot(0.01, 0.1)));
    const XrdResult relative = read("I;% err;RIR;% err");
    CHECK_FALSE(relative.samples[0].analysis.phases[0].standard_uncertainty);
    CHECK(contains(joined(texts_of(relative.warnings)), "in another unit than the column before them"));
    CHECK(contains(input_error_of([] { return read_xrd("Phase;Messwert;RIR\nQuartz;20;3\n", "t.csv"); }),
                   "\"Messwert\" may hold intensities, beside reference intensity ratios, or fractions"));
}

TEST_CASE("a heading over two rows") {
    const XrdResult spread =
        read_xrd("Phase;FA1;;FA2;\n;wt%;esd;wt%;esd\nQuartz;20;0.3;30;0.4\nGlass;80;1;70;1\n", "t.csv");
    REQUIRE(spread.samples.size() == 2);
    CHECK(spread.samples.back().name == "FA2");
    CHECK(spread.warnings.empty());
    CHECK(digest(spread.samples.back()) == "Quartz 3000, Glass 7000");
    CHECK(spread.samples.back().analysis.phases.front().standard_uncertainty.value() ==
          doctest::Approx(0.004));
    for (const char* group : {"Phase content (wt%)", "Phases [Gew.-%]"}) {
        const XrdResult named =
            read_xrd(std::string("Sample;") + group + "\n;Quartz;Mullite;Glass\nA;0.5;0.3;99.2\n", "t.csv");
        CHECK(digest(named.samples.front()) == "Quartz 50, Mullite 30, Glass 9920");
        CHECK(named.warnings.empty());
    }
}

TEST_CASE("columns of uncertainties by the name before them") {
    for (const char* heading : {"esd", "Quartz esd", "Quartz (SD)", "u(Quartz)", "Unsicherheit Quartz",
                                "Quartz std. error", "error of Quartz", "Quartz_esd"}) {
        CAPTURE(heading);
        const XrdResult result =
            read_xrd("Sample;Quartz;" + std::string(heading) + ";Glass\nA;20;0.3;80\n", "t.csv");
        CHECK(digest(result.samples.front()) == "Quartz 2000, Glass 8000");
        CHECK(result.samples.front().analysis.phases.front().standard_uncertainty.value() ==
              doctest::Approx(0.003));
    }
    for (const char* heading :
         {"rel. error", "max. error", "Corundum (std)", "Mullite esd", "u(Glass)", "Unsicherheit Mullit"}) {
        CAPTURE(heading);
        const std::string refusal = input_error_of([&] {
            return read_xrd("Sample;Quartz;" + std::string(heading) + ";Glass\nA;20;5;75\n", "t.csv");
        });
        CHECK_MESSAGE(contains(refusal, std::string("the column \"") + heading +
                                            "\" may hold standard uncertainties of \"Quartz\", other ones"),
                      refusal);
    }
    const XrdResult thrice = read_xrd("Sample;Quartz;3 esd;Glass\nA;20;0.6;80\n", "t.csv");
    CHECK(thrice.samples.front().analysis.phases.front().standard_uncertainty.value() ==
          doctest::Approx(0.002));
    const XrdResult samples = read_xrd(
        "Phase;FA1;u(FA1);FA2;u(FA2);NWG\nQuartz;20;0.3;30;0.4;1\n"
        "Glass;80;1;70;1;1\n",
        "t.csv");
    REQUIRE(samples.samples.size() == 2);
    CHECK(samples.samples[1].analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.004));
    CHECK(contains(joined(texts_of(samples.warnings)), "column \"NWG\" is not used"));
    for (const char* table :
         {"Sample;Quartz;esd;Glass\nA;0.2;0.1 %;0.8\n", "Phase;weight;esd\nQuartz;0.2;0.1 %\nGlass;0.8;0\n"})
        CHECK(contains(input_error_of([&] { return read_xrd(table, "t.csv"); }),
                       "\"0.1 %\" may be per cent of the whole, or of the value before it"));
    const XrdResult signs = read_xrd("Sample;Quartz;esd;Glass\nA;20 %;0.1 %;80 %\n", "t.csv");
    CHECK(signs.samples.front().analysis.phases.front().standard_uncertainty.value() ==
          doctest::Approx(0.001));
    for (const char* heading : {"rel. wt%", "norm. [wt%]", "max. Gew.-%"})
        CHECK(contains(input_error_of([&] {
                           return read_xrd("Phase;" + std::string(heading) + "\nQuartz;20\nGlass;80\n",
                                           "t.csv");
                       }),
                       "holds no weight or volume fractions, and is not the name of a sample"));
}

TEST_CASE("rows that may be parts of the row above them are refused") {
    const auto with_row = [](const std::string& above, const std::string& name) {
        return "Phase;wt%\nQuartz;20\n" + above + "\n" + name + ";5\nGlass;70\n";
    };
    for (const char* name : {"- Albite", "\u2013 Albite", "\u2022 Albite", "(Albite)"})
        CHECK(contains(input_error_of([&] { return read_xrd(with_row("Plagioclase;5", name), "t.csv"); }),
                       "line 4, cell 1: " + in_quotes(name) +
                           " may be a part of the row above it, or a phase beside it"));
    CHECK_NOTHROW((void)read_xrd(with_row("Feldspars;", "- Albite") + "Hematite;5\n", "t.csv"));
    CHECK(contains(input_error_of([&] { return read_xrd(with_row("Lime;5", "Hematite?"), "t.csv"); }),
                   "the sign in the name \"Hematite?\" may make its amount a bound or doubtful"));
    CHECK(contains(
        input_error_of([&] { return read_xrd("Phase;wt%\nQuartz;20 (\u00b1 3 %)\nGlass;80\n", "t.csv"); }),
        "3 % of 20, or 3 in the unit of the value"));
}

TEST_CASE("small numbers without a sign beside per cent are refused") {
    for (const char* table : {"Phase;wt%\nQuartz;34.1 %\nMullite;0.159\n",
                              "Phase;wt%\nQuartz;68.2 %\nMullite;31.8 %\nTotal crystalline;0.5\n",
                              "Phase;amount\nQuartz;68.2\nMullite;31.8\nTotal crystalline;0.5\n",
                              "Sample;Quartz [wt%];Mullite [wt%];Total crystalline\nFA1;68.2;31.8;0.5\n"})
        CHECK(contains(input_error_of([&] { return read_xrd(table, "t.csv"); }), "fraction"));
    CHECK_NOTHROW((void)read_xrd("Phase;wt%\nQuartz;34.1 %\nMullite;15.9\n", "t.csv"));
}

TEST_CASE("rows of uncertainties behind each sample") {
    for (const auto& [first, second] :
         {std::pair{"esd", "esd"}, {"\u00b1", "\u00b1"}, {"A esd", "B esd"}, {"A (SD)", "B (SD)"}}) {
        const XrdResult result = read_xrd(
            "Sample;Quartz;Glass\nA;20;80\n" + std::string(first) + ";0.3;-\nB;10;90\n" + second + ";0.4;1\n",
            "t.csv");
        REQUIRE(result.samples.size() == 2);
        CHECK(result.samples[0].analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.003));
        CHECK_FALSE(result.samples[0].analysis.phases[1].standard_uncertainty);
        CHECK(result.samples[1].analysis.phases[1].standard_uncertainty.value() == doctest::Approx(0.01));
    }
    const XrdResult doubled = read_xrd("Sample;Quartz;Glass\nA;20;80\n2\u03c3;0.6;1\n", "t.csv");
    CHECK(doubled.samples[0].analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.003));
    const XrdResult numbered = read_xrd("Sample;Quartz;Glass\nAsh 2;20;80\nAsh 2 SD;0.6;1\n", "t.csv");
    CHECK(numbered.samples[0].analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.006));
    CHECK(contains(input_error_of([] {
                       static_cast<void>(
                           read_xrd("Sample;Quartz [wt%] (expanded);Glass [wt%]\nA;20 \u00b1 1;80 \u00b1 1\n",
                                    "t.csv"));
                   }),
                   "\"expanded\" in the name"));
    const XrdResult expanded =
        read_xrd("Sample;Quartz;Glass\nA;20;80\nU (k=2);0.6;1\nB;10;90\nU (k=2);0.8;2\n", "t.csv");
    CHECK(expanded.samples[1].analysis.phases[0].standard_uncertainty.value() == doctest::Approx(0.004));
    CHECK(contains(expanded.reading, "\"Quartz\" (uncertainties divided by 2)"));
    CHECK(contains(input_error_of([] {
                       static_cast<void>(
                           read_xrd("Sample;Quartz;Glass;\nA;20;80;\nSD;1;2;relative, in %\n", "t.csv"));
                   }),
                   "holds a text that may change them"));
    for (const char* row : {"% error", "error %"}) {
        const XrdResult result =
            read_xrd("Sample;Quartz;Glass\nA;20;80\n" + std::string(row) + ";5;1\n", "t.csv");
        CHECK_FALSE(result.samples[0].analysis.phases[0].standard_uncertainty);
        CHECK(contains(joined(texts_of(result.warnings)), "[%] may be of the whole or of the value"));
    }
}

TEST_CASE("a mark of a bound beside an amount is refused, a missing uncertainty is said") {
    const auto refused = [](std::string_view text, const char* file) {
        return input_error_of([&] { static_cast<void>(read_xrd(text, file)); });
    };
    CHECK(contains(refused("phase;wt%;qual\nQuartz;12.3;<\nMullite;87.7;\n", "t.csv"),
                   "line 2, cell 3: \"<\" in column \"qual\" may make the number beside it a bound"));
    const XrdSample sample = read_xrd("phase,wt%,esd\nQuartz,12.3,2\nMullite,87.7,\n", "t.csv").samples[0];
    REQUIRE(sample.warnings.size() == 1);
    CHECK(sample.warnings[0].text ==
          "\"Mullite\" has no uncertainty, as other phases do, and counts as exact");
    CHECK(read_xrd("phase,wt%\nQuartz,12.3\nMullite,87.7\n", "t.csv").samples[0].warnings.empty());
    for (const char* heading :
         {"recovery %", "0.1 wt%", "10 wt%", "w/v %", "\u2264 wt%", "FA7 x10 [wt%]", "porosity [%]"})
        CHECK_MESSAGE(
            !refused(std::string("phase;") + heading + "\nQuartz;12.3\nMullite;87.7\n", "t.csv").empty(),
            heading);
    for (const char* name : {"Quartz (<)", "Quartz <", "< Quartz", "Quartz (~)", "Quartz (?)"})
        CHECK_MESSAGE(contains(refused(std::string("phase;wt%\n") + name + ";12.3\nMullite;87.7\n", "t.csv"),
                               "may make its amount a bound or doubtful"),
                      name);
    CHECK(read_xrd("phase;ash < 63 um [wt%]\nQuartz;12.3\nMullite;87.7\n", "t.csv").samples[0].name ==
          "ash < 63 um");
    CHECK(contains(refused(R"({"samples": [{"name": "a", "weight_fractions": {"quartz <": 1}}]})", "t.json"),
                   "\"quartz <\" has the sign of a bound"));
    const XrdResult errors =
        read_xrd("Phase;Anteil;Unsicherheit\nQuarz;12,3 %;5 %\nMullit;87,7 %;5 %\n", "t.csv");
    CHECK(
        contains(errors.warnings.front().text, "the uncertainties in % are taken as per cent of the sample"));
    const XrdResult russian = read_xrd(
        "\u0424\u0430\u0437\u0430;\u043c\u0430\u0441\u0441. %;"
        "\u043f\u043e\u0433\u0440\u0435\u0448\u043d\u043e\u0441\u0442\u044c\n"
        "quartz;12.3;1\nmullite;87.7;2\n",
        "t.csv");
    REQUIRE(russian.samples.size() == 1);
    CHECK(*russian.samples[0].analysis.phases[1].standard_uncertainty == doctest::Approx(0.02));
    const XrdResult word = read_xrd("phase;X [%]\nQuartz;12.3\nMullite;87.7\n", "t.csv");
    REQUIRE(word.warnings.size() == 1);
    CHECK(contains(word.warnings[0].text, "\"X [%]\" is taken as the sample \"X\""));
    CHECK(contains(refused("phase;intensity;rir\nQuartz;753;3.1\nMullite;75 %;0.9\n", "t.csv"),
                   "line 3: some intensities are in % and others are not"));
    const XrdResult peaks = read_xrd("phase;I (2nd peak);rir\nQuartz;753;3.1\nMullite;75;0.9\n", "t.csv");
    REQUIRE_FALSE(peaks.warnings.empty());
    CHECK(contains(peaks.warnings[0].text, "is taken as net intensities of the strongest peaks"));
    const std::string block = "Local parameters and GOALs for phase quartz\nXrayDensity=2.648\nGEWICHT=";
    for (const char* weight : {"0,1230+-0,0040", "12.3 %", "0.1230+-4.0%"})
        CHECK_FALSE(refused(block + weight + "\n", "a.lst").empty());
    CHECK(refused(block + "0.1230+-0.0040\n", "a.lst").empty());
    const std::string phase = "xdd a.raw\nstr\nphase_name \"quartz\"\nweight_percent ";
    for (const char* weight : {"100,0", "100.0(4)", "100.0` _0.4`", "100.0`_4%"})
        CHECK(contains(refused(phase + weight + "\n", "a.out"), "behind weight_percent"));
    CHECK(refused(phase + "100.0`_0.4\n", "a.out").empty());
    const std::string pattern = " => Phase:  1     Quartz\n => Bragg R-factor: 2.9  Vol: 162.  Fract(%):  ";
    for (const char* fraction : {"100.0(40)", "100.0(-0.40)", "100.0 0.4"})
        CHECK_FALSE(refused(pattern + fraction + "\n", "a.sum").empty());
    CHECK(refused(pattern + "100.0( 0.40)\n", "a.sum").empty());
}

TEST_CASE("a bound is no amount, which is said with its sample, and each row has a sample") {
    const XrdResult bounded =
        read_xrd("Phase;FA 7 [wt%];FA 8 [wt%]\nQuartz;40;50\nGlass;57.8;50\nHematite;2.2;< 3\n", "t.csv");
    REQUIRE(bounded.samples[1].warnings.size() == 1);
    CHECK(bounded.samples[1].warnings[0].text ==
          "\"Hematite\" in \"FA 8\" has no amount (line 4: \"< 3\") and is left out");
    CHECK(contains(input_error_of([] {
                       static_cast<void>(
                           read_xrd("sample,phase,wt%\n,mullite,60\n,quartz,40\nB,quartz,100\n", "t.csv"));
                   }),
                   "line 2: the line names no sample, and none stands above it"));
    CHECK(read_xrd("sample,phase,wt%\n,mullite,60\n,quartz,40\n", "t.csv").samples.size() == 1);
    CHECK_FALSE(input_error_of([] {
                    static_cast<void>(read_xrd("phase,\u00b1wt%\nmullite,60\nquartz,40\n", "t.csv"));
                }).empty());
}

TEST_CASE("an internal standard that is only named, and phases that were not detected") {
    const auto table = [](const std::string& row) {
        return read_xrd("Phase;wt%\nQuartz;20\nMullite;30\n" + row + "\nGlass;50\n", "t.csv").samples.front();
    };
    const std::string marked = input_error_of([&] {
        return compose(read_xrd("Phase;wt%\nQuartz;30\nMullite;50\nCorundum (spike);20\n", "t.csv")
                           .samples.front()
                           .analysis,
                       shipped_catalogue());
    });
    CHECK_MESSAGE(
        contains(marked,
                 "line 4: \"Corundum\" is called an internal standard: the fractions are those of the "
                 "mixture with it, or those of the sample beside it"),
        marked);
    CHECK(contains(marked, "--internal-standard Corundum --added-fraction"));
    for (const char* rows :
         {"Corundum*;20;\n\n* internal standard\n", "Corundum\u00b9;20;\n\n\u00b9 internal standard\n",
          "Corundum (ISTD);20;\n", "Corundum;20;internal standard\n", "Corundum;20;Spike\n"})
        CHECK_MESSAGE(read_xrd(std::string("Phase;wt%;Remark\nQuartz\u00b2;80;\n") + rows, "t.csv")
                          .samples.front()
                          .analysis.phases.back()
                          .is_standard,
                      rows);
    CHECK(digest(table("Lime\u00b9;0")) == "Quartz 2000, Mullite 3000, Lime 0, Glass 5000");
    const XrdSample mixture =
        read_xrd("Phase;wt%\nQuartz;30\nMullite;50\nCorundum (spike);20\n", "t.csv").samples.front();
    CHECK(amorphous_of(with_internal_standard(mixture, "corundum", 0.1)) ==
          doctest::Approx(1 - 0.8 * 0.1 / 0.2 / 0.9));
    for (const char* row :
         {"Lime (not detected);", "Lime (n.n.);-", "Lime;n. n.", "Lime;nicht nachgewiesen"}) {
        const XrdSample sample = table(row);
        CHECK(digest(sample) == "Quartz 2000, Mullite 3000, Glass 5000");
        CHECK(contains(sample.warnings.front().text, "\"Lime\" has no amount (line 4"));
    }
    CHECK(digest(table("Lime (n.d.);0")) == "Quartz 2000, Mullite 3000, Lime 0, Glass 5000");
    CHECK(
        contains(input_error_of([&] { static_cast<void>(table("Lime (n.d.);3")); }),
                 "line 4: \"Lime\" is called not detected, and its amount is 3 %; allowed: one of the two"));
}

TEST_CASE("what a table says of itself in two ways is refused") {
    const auto refusal = [](const std::string& table) {
        return input_error_of(
            [&] { return compose(read_xrd(table, "t.csv").samples.front().analysis, shipped_catalogue()); });
    };
    CHECK(
        contains(refusal("Phase;wt% (crystalline)\nQuartz;20\nAmorphous;80\n"),
                 "line 3: the heading states fractions of the crystalline part, and \"Amorphous\" is none"));
    CHECK(contains(refusal("Sample;Quartz [ppm];Glass\nA;200000;800000\n"),
                   "line 1: the columns \"Quartz [ppm]\" and \"Glass\" are not in one unit"));
    CHECK(contains(refusal("Sample;Quartz [g/kg];Glass [ppm]\nA;200;800000\n"), "are not in one unit"));
    for (const char* table :
         {"Component;wt%\nSiO2;50\nAl2O3;25\nFe2O3;8\nCaO;10\nMgO;7\n",
          "Sample;SiO2;Al2O3;CaO;LOI\nA;60;25;11;4\n", "Component;wt%\nSiO2;60\nAl2O3;40\n"})
        for (const char* says : {"are oxides of a chemical analysis (XRF)", "the analysis as --oxides FILE"})
            CHECK_MESSAGE(contains(refusal(table), says), refusal(table));
    CHECK(contains(refusal("Phase;wt%\nSiO2;20\nMullite;30\nMgO;10\nGlass;40\n"),
                   "line 2: \"SiO2\" is the formula of quartz, cristobalite, fused-silica"));
    CHECK(refusal("Phase;wt%\nCaO;20\nMullite;30\nMgO;10\nGlass;40\n").empty());
    CHECK(contains(refusal("Phase;Intensity;RIR\nQuartz;1.753;3\nMullite;540;2\n"),
                   "\"1.753\" is 1.753 or 1753"));
    CHECK(contains(refusal("Phase;ppm\nQuartz;200.000\nGlass;800.000\n"), "\"200.000\" is"));
}

TEST_CASE("what a name, a heading or a text beside a table may mean otherwise is refused") {
    const auto refusal = [](const std::string& table) {
        return input_error_of(
            [&] { return compose(read_xrd(table, "t.csv").samples.front().analysis, shipped_catalogue()); });
    };
    const auto with_quartz = [](const std::string& name) {
        return "Phase;wt%\n" + name + ";20\nMullite;30\nGlass;50\n";
    };
    for (const auto& [table, says] :
         {std::pair{with_quartz("Quartz (x10)"),
                    "line 2, cell 1: \"x10\" in the name \"Quartz (x10)\" may be"},
          {with_quartz("Quartz [\u00d7 0.1]"), "may be a part of the name, or change the amount"},
          {with_quartz("Quartz (g/kg)"), "line 2, cell 1: \"g/kg\" in the name \"Quartz (g/kg)\" may be"},
          {with_quartz("Quartz (excluded)"),
           "line 2, cell 1: \"Quartz (excluded)\" in the names calls the row invalid"},
          {with_quartz("Quartz - do not use"), "calls the row invalid"},
          {with_quartz("Quartz (counts)"),
           "line 2, cell 1: \"counts\" in the name \"Quartz (counts)\" may be"},
          {with_quartz("Quartz (max)"), "may be a part of the name, or change the amount"},
          {std::string("Phase;Use;wt%\nQuartz;yes;20\nGlass;no;80\n"),
           "line 3, cell 2: \"no\" in column \"Use\" calls the row invalid"},
          {std::string("Phase;excluded;wt%\nQuartz;x;20\nGlass;;80\n"), "line 2, cell 2: \"x\" in column"},
          {std::string("phase;weight\nQuartz;20 %\nGlass;0.8\n"),
           "line 3: the amount 0.8 of \"Glass\" has no sign, others of the table are in %"},
          {std::string("sample;Quartz [vol%];Glass\nA;20%;80%\n"),
           "line 1: one column is by volume, and \"Glass\" may be by weight"},
          {std::string("Phase;wt%;Remark\nQuartz;20;outlier\nGlass;80;\n"),
           "line 2, cell 3: \"outlier\" in column \"Remark\" calls the row invalid"},
          {std::string("Sample;Quartz (x10);Glass\nA;20;80\n"), "line 1, cell 2: \"x10\" in the name"},
          {std::string("Phase;wt%\nQuartz;20\nGlass (crystalline);80\n"),
           "line 3: \"Glass (crystalline)\" may be glass-dong2013 or a crystalline phase"},
          {std::string("Phase;FA1;s\nQuartz;20;1\nGlass;80;99\n"),
           "the column \"s\" may be a sample, or hold standard deviations"},
          {std::string("Phase;FA1;MU\nQuartz;20;1\nGlass;80;2\n"),
           "the column \"MU\" may be a sample, or hold"},
          {std::string("Phase;FA1;FA2;Diff\nQuartz;20;22;2\nGlass;80;78;2\n"), "is not the name of a sample"},
          {std::string("Phase;Gehalt;esd\nQuartz;20 %;0.012\nGlass;80 %;0.02\n"),
           "line 2, cell 3: \"0.012\" has no sign, and the amount beside it is \"20 %\": it may be 0.012 % "
           "or 1.2 %"},
          {std::string("Sample;Quartz;esd;Glass\nA;20 %;0.012;80 %\n"), "it may be 0.012 % or 1.2 %"},
          {std::string("Phase;Gehalt [%];Einheit\nQuartz;20;g/kg\nGlass;80;g/kg\n"),
           "line 2, cell 3: \"g/kg\" in column \"Einheit\" is not the unit of the amounts"},
          {std::string("Values in g/kg\nPhase;Gehalt\nQuartz;20\nGlass;80\n"),
           "line 1: \"Values in g/kg\" states g/kg, and the amounts are read in another unit"},
          {std::string("Angaben in Promille\nPhase;Gehalt [%]\nQuartz;20\nGlass;80\n"), "states Promille"},
          {std::string("Angaben in %\nPhase;Gehalt\nQuartz;0.20\nGlass;0.80\n"), "states %"},
          {std::string("Quantities of phases in the ash of the electrostatic precipitator of unit 3 in ppm\n"
                       "Phase;Gehalt\nQuartz;20\nGlass;80\n"),
           "states ppm"},
          {std::string("Results multiplied by 10\nPhase;Gehalt [%]\nQuartz;20\nGlass;80\n"),
           "line 1: \"Results multiplied by 10\" may state a factor of the numbers"},
          {std::string("Phase;wt% (crystalline);wt% (whole sample)\nQuartz;100;20\nGlass;;80\n"),
           "the columns \"wt% (crystalline)\" and \"wt% (whole sample)\" hold the same quantity"}})
        CHECK_MESSAGE(contains(refusal(table), says), refusal(table));
    for (const char* text :
         {"crystalline part only", "without amorphous", "crystalline phases only", "amorphous not considered",
          "normalised to 100 % crystalline", "ohne amorphen Anteil", "nur kristalline Phasen"})
        for (const std::string& table :
             {text + ("\n" + with_quartz("Quartz")), "# " + (text + ("\n" + with_quartz("Quartz"))),
              with_quartz("Quartz") + "\n" + text + "\n"}) {
            CAPTURE(table);
            CHECK(
                contains(refusal(table), "states fractions of the crystalline part, and \"Glass\" is none"));
        }
    const XrdSample part =
        read_xrd("# without amorphous\nPhase;wt%\nQuartz;20\nMullite;80\n", "t.csv").samples[0];
    CHECK(contains(joined(texts_of(part.warnings)), "of the crystalline part, as line 1 states"));
    for (const char* text : {"# loss-free basis", "on an ignited basis", "gl\u00fchverlustfrei"})
        CHECK(contains(joined(texts_of(read_xrd(text + ("\n" + with_quartz("Quartz")), "t.csv").warnings)),
                       "is not read: the fractions are taken as those of the sample"));
    const std::string title =
        "Quantities of phases in the ash of the electrostatic precipitator of unit 3, in %";
    const std::string titled = title + "\nPhase;Gehalt\nQuartz;20\nGlass;80\n";
    CHECK(contains(joined(texts_of(read_xrd(titled, "t.csv").warnings)),
                   "line 1, above the heading, is not read: \"" + title + "\""));
    CHECK_FALSE(
        read_xrd("external standard: corundum\nPhase;wt%\nQuartz;20\nCorundum;30\nGlass;50\n", "t.csv")
            .samples[0]
            .analysis.phases[1]
            .is_standard);
}

TEST_CASE("what laboratories write beside names and numbers is no reason to refuse a table") {
    const std::string rows = "\nQuartz;20\nMullite;30\nGlass;50\n";
    for (const std::string& table :
         {"Phase ID;Phase;wt%\n1;Quartz;20\n2;Mullite;30\n3;Glass;50\n" + std::string(),
          "Phase;wt%" + rows + "LOI (950 \u00b0C);3\n",
          "Phase;wt%" + rows + "Gl\u00fchverlust bei 950 \u00b0C;3\n", "# Phase;wt%" + rows,
          "crystalline part 50 %, amorphous part 50 %\nPhase;wt%" + rows,
          "Phase;wt%" + rows + "\nmeasured at 40 kV; 40 mA; Cu K\u03b1\n",
          "Phase;wt%" + rows + "Note: measured at 40 kV; 40\n",
          std::string("Phase;FA1\nQuartz;20 wt%\nMullite;30 wt%\nGlass;50 wt%\n")}) {
        CAPTURE(table);
        CHECK(digest(read_xrd(table, "t.csv").samples.front()) == "Quartz 2000, Mullite 3000, Glass 5000");
    }
    CHECK(compose(read_xrd("Phase;wt%\nQuartz;20\nGlass [PONKCS];80\n", "t.csv").samples[0].analysis,
                  shipped_catalogue())
              .components.back()
              .phase.amorphous);
    for (const char* heading : {"esd", "dev. std", "\u8bef\u5dee", "desv. est."}) {
        CAPTURE(heading);
        const XrdResult stated = read_xrd(
            "Phase;wt%;" + std::string(heading) + "\nQuartz;20;\u00b10.4\nGlass;80;+/- 0.4\n", "t.csv");
        CHECK(stated.samples[0].analysis.phases[1].standard_uncertainty.value() == doctest::Approx(0.004));
    }
}

TEST_CASE("units in a second line, rows that sum up samples, and notes below a table") {
    for (const auto& [unit, basis] :
         {std::pair{"Gew.-%", FractionBasis::weight}, std::pair{"[Vol.-%]", FractionBasis::volume}}) {
        const XrdResult result = read_xrd(
            "Phase;Gehalt;Fehler\n;" + std::string(unit) + ";\nQuarz;20;1\nMullit;80;1\n\nGesamt;100;\n",
            "t.csv");
        CHECK(result.samples[0].analysis.basis == basis);
        CHECK(digest(result.samples[0]) == "Quarz 2000, Mullit 8000");
    }
    CHECK(read_xrd("Phase;wt% \u00b1 esd\nQuartz;20.0 \u00b1 0.4\nMullite;80.0 \u00b1 0.5\n", "t.csv")
              .samples[0]
              .analysis.phases[0]
              .standard_uncertainty == 0.4 / 100);
    for (const char* total : {"TOTAL (wt%)", "\u03a3 [wt%]", "Sum of phases", "Yhteens\u00e4"}) {
        CAPTURE(total);
        const XrdResult result =
            read_xrd("Phase;wt%\nQuartz;20\nMullite;80\n" + std::string(total) + ";100\n", "t.csv");
        CHECK(digest(result.samples[0]) == "Quartz 2000, Mullite 8000");
    }
    CHECK(contains(input_error_of([] { return read_xrd("Phase;Gehalt\n;mol%\nQuarz;20\n", "t.csv"); }),
                   "no weight or volume fractions"));
    const XrdResult wide = read_xrd(
        "Probe;Quarz;Mullit\n;wt%;wt%\nA;20;80\ns;22;78\nB;tr.;100\n\nMittel;14;86\ns;1;1\n\n* n.d.: "
        "nichts\n",
        "t.csv");
    REQUIRE(wide.samples.size() == 3);
    CHECK(wide.samples[1].name == "s");
    CHECK(digest(wide.samples[2]) == "Mullit 10000");
    const std::string told = joined(texts_of(wide.warnings));
    CHECK_MESSAGE(contains(told, "line 7 is no sample and left out: \"Mittel\", line 8"), told);
    CHECK_MESSAGE(contains(told, "line 10 below the table is not read"), told);
}

TEST_CASE("numbers of an XRD table that may be grouped are refused with both readings") {
    const auto read = [](const std::string& table) { return read_xrd(table, "t.csv"); };
    CHECK(contains(
        input_error_of([&] { static_cast<void>(read("phase;ppm\nQuartz;12,345\nMullite;957,120\n")); }),
        "\"12,345\" is 12.345 or 12345"));
    CHECK(digest(read("phase;wt%\nQuartz;12,345\nMullite;57,120\n").samples.front()) ==
          "Quartz 1235, Mullite 5712");  // no fraction is 12345 %
    CHECK(digest(
              read_xrd("phase;wt%\nQuartz;12,345\nMullite;57,120\n", "t.csv", {.decimal = DecimalMark::comma})
                  .samples.front()) == "Quartz 1235, Mullite 5712");
    CHECK(contains(input_error_of([] {
                       return read_xrd(file_text(ASHIMPACT_TEST_DATA "/xrd/fa07-corundum.lst"), "a.lst",
                                       {.decimal = DecimalMark::point});
                   }),
                   "the file is no table"));
    CHECK(digest(read("phase;wt%\nQuartz;12,345\nMullite;57,12\n").samples.front()) ==
          "Quartz 1235, Mullite 5712");
    CHECK(contains(input_error_of([&] { static_cast<void>(read("phase,wt%\n#N/A,12\nQuartz,60\n")); }),
                   "#N/A") == false);
    CHECK(read("phase,wt%\n#DIV/0!,12\nQuartz,60\n").samples.front().analysis.phases.size() == 2);
    CHECK(read("Phase;Gew.-%\nQuarz;53\namorph (Differenz);47\nkristallin;53\n")
              .samples.front()
              .analysis.phases.size() == 2);
}

TEST_CASE("Table 1 of the paper as a file: by volume, glass by difference from the crystalline total") {
    const XrdResult result = read("volumes.csv");
    REQUIRE(result.samples.size() == 3);
    const XrdSample& sample = result.samples[2];
    CHECK(sample.analysis.basis == FractionBasis::volume);
    CHECK(relative_difference(std::get<CrystallineTotal>(sample.analysis.amorphous).value, 0.4928) < 1e-14);
    const Composition composition = compose(sample.analysis, shipped_catalogue().preferring("dong2013"));
    CHECK(relative_difference(composition.components[2].volume_fraction, 0.5072) < 1e-14);
    CHECK(relative_difference(estimate_modulus(composition).young_modulus, 148.1256e9) < 1e-13);
}

TEST_CASE("peak intensities by the adiabatic principle, worked by hand") {
    const XrdResult result = read("peaks.csv");
    REQUIRE(result.samples.size() == 1);
    const auto& phases = result.samples[0].analysis.phases;
    // 3410/3.1 = 1100, 1890/2.5 = 756, 145/2.4 = 60.41667
    const double sum = 1100 + 756 + 145 / 2.4;
    CHECK(relative_difference(phases[0].fraction, 1100 / sum) < 1e-14);
    CHECK(relative_difference(phases[2].fraction, 145 / 2.4 / sum) < 1e-14);
    CHECK(relative_difference(*phases[0].standard_uncertainty, 60 / 3.1 / sum) < 1e-14);
    CHECK(relative_difference(*phases[1].standard_uncertainty, std::hypot(18, 30.24) / sum) < 1e-14);
    CHECK(std::holds_alternative<AmorphousNotStated>(result.samples[0].analysis.amorphous));
    const std::vector<PhaseFraction> corundum =
        adiabatic_fractions({{.name = "Corundum", .intensity = 500, .reference_intensity_ratio = 1},
                             {.name = "Quartz", .intensity = 1550, .reference_intensity_ratio = 3.1}});
    CHECK(relative_difference(corundum[0].fraction, 0.5) < 1e-15);
}

TEST_CASE("peaks with an internal standard give the amorphous part") {
    // in the mixture 0.1 243/180 = 0.135 and 0.1 648/180 = 0.36; in the ash over 0.9: 0.15 and 0.40
    for (const auto* file : {"peaks-standard.csv", "samples.json"}) {
        CAPTURE(file);
        const XrdSample sample = read(file).samples.back();
        CHECK(sample.name == "FA-07");
        const Composition composition = compose(sample.analysis, shipped_catalogue());
        REQUIRE(composition.components.size() == 3);
        CHECK(relative_difference(composition.components[0].weight_fraction, 0.15) < 1e-13);
        CHECK(relative_difference(composition.components[1].weight_fraction, 0.40) < 1e-13);
        CHECK(relative_difference(composition.components[2].weight_fraction, 0.45) < 1e-13);
    }
}

TEST_CASE("the project's JSON") {
    const XrdResult result = read("samples.json");
    CHECK(result.format == XrdFormat::json);
    REQUIRE(result.samples.size() == 3);
    const auto& phases = result.samples[0].analysis.phases;
    CHECK(digest(result.samples[0]) == "Quartz 1231, Mullite 3:2 2840");
    CHECK(relative_difference(*phases[0].standard_uncertainty, 0.002) < 1e-14);
    CHECK(phases[0].density == 2650);
    CHECK(relative_difference(amorphous_of(result.samples[0]), 0.5929) < 1e-14);
    CHECK(result.samples[1].analysis.basis == FractionBasis::volume);
    CHECK(std::holds_alternative<AmorphousNone>(result.samples[1].analysis.amorphous));
}

TEST_CASE("fractions in JSON: an object, a list, any form of a number, and the amorphous part in its ways") {
    const auto composed = [](const std::string& keys) {
        const XrdResult result = read_xrd(R"({"samples": [{"name": "a", )" + keys + "}]}", "a.json");
        return compose(result.samples.at(0).analysis, shipped_catalogue());
    };
    const Composition expected =
        composed(R"("weight_fractions": {"quartz": 0.1, "mullite": 0.5}, "amorphous": 0.4)");
    for (
        const char* keys :
        {R"("weight_fractions": {"quartz": "10 %", "mullite": {"value": 50, "unit": "%"}}, "amorphous": "40 %")",
         R"("weight_fractions": {"quartz": "10 +- 1 %", "mullite": "50(2) %"}, "amorphous": "remainder")",
         R"("phases": [{"name": "quartz", "weight_fraction": "10 %"},
                        {"name": "mullite", "weight_fraction": 0.5}], "amorphous": {"weight_fraction": "40 %"})",
         R"("weight_fractions": {"quartz": 0.1, "mullite": 0.5}, "amorphous": {"crystalline_total": "60 %"})",
         R"("weight_fractions": {"quartz": 0.1, "mullite": 0.5}, "amorphous": "40 wt% +- 2 wt%")",
         R"("weight_fractions": {"quartz": 0.1, "mullite": 0.5, "glass": 0.4})",
         R"("weight_fractions": {"quartz": 0.1, "mullite": 0.5}, "amorphous": {"remainder_scale": 1})"}) {
        CAPTURE(keys);
        const Composition composition = composed(keys);
        REQUIRE(composition.components.size() == 3);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(relative_difference(composition.components[i].weight_fraction,
                                      expected.components[i].weight_fraction) < 1e-14);
    }
    // 10 % corundum added: p = 0.1/(0.2 * 0.9) = 5/9, quartz 5/9 * 0.3
    for (const char* key : {"added_fraction", "weight_fraction"}) {
        const Composition flushed = composed(
            R"("weight_fractions": {"corundum": 0.2, "quartz": 0.3, "mullite": 0.5},
               "internal_standard": {"phase": "corundum", ")" +
            std::string(key) + R"(": "10 %"})");
        CHECK(relative_difference(flushed.components.front().weight_fraction, 0.3 / 1.8) < 1e-14);
    }
    const XrdResult dense = read_xrd(
        R"({"samples": [{"name": "a", "volume_fractions": {"quartz": 1}, "densities": {"Quartz": "2.7 g/cm3"}}]})",
        "a");
    CHECK(contains(input_error_of([] {
                       return read_xrd(R"({"samples": [{"name": "a", "volume_fractions": {"quartz": 1},
                                           "densities": {"Quartz": 2.7}}]})",
                                       "a");
                   }),
                   "did you mean 2.7 g/cm3?"));
    CHECK(dense.samples.at(0).analysis.basis == FractionBasis::volume);
    CHECK(relative_difference(dense.samples.at(0).analysis.phases.at(0).density.value(), 2700) < 1e-14);
}

TEST_CASE("a density with its unit has the decimal mark of its table") {
    for (const char* rows : {"Phase;Gew.-%;Dichte\nQuarz;30,5;2,65 g/cm³\nGlas;69,5;2,5 g/cm³\n",
                             "Phase;Gew.-%;Dichte\nQuarz;30.5;2.65 g/cm³\nGlas;69.5;2.5 g/cm³\n"}) {
        const auto sample = read_xrd(rows, "t.csv").samples.front();
        CHECK(relative_difference(sample.analysis.phases.front().density.value(), 2650) < 1e-14);
    }
}

TEST_CASE("an uncertainty behind ratio and intensity is refused, as it may be of either") {
    const auto refusal = [](const std::string& rows) {
        return input_error_of([&] { return read_xrd(rows, "t.csv").samples.front().name; });
    };
    CHECK(contains(refusal("Phase;Int. [cts];RIR;esd\nQuarz;753;3.1;10\n"), "\"RIR\" or of \"Int. [cts]\""));
    CHECK(contains(refusal("Phase;Int. [cts];RIR;RIR esd\nQuarz;753;3.1;5%\n"), "\"5%\" is per cent"));
    CHECK(refusal("Phase;Int. [cts];esd;RIR\nQuarz;753;10;3.1\n").empty());
    CHECK(refusal("Phase;Int. [cts];RIR;RIR esd\nQuarz;753;3.1;0.1\n").empty());
}

TEST_CASE("per cent in the peaks of JSON are refused where they have two readings") {
    const auto refusal = [](const char* intensity, const char* ratio) {
        return input_error_of([&] {
            return read_xrd(std::string(
                                R"({"samples": [{"name": "a", "peaks": [{"name": "quartz", "intensity": ")") +
                                intensity + R"(", "rir": ")" + ratio + R"("}], "amorphous": "50 %"}]})",
                            "a.json")
                .samples.size();
        });
    };
    CHECK(contains(refusal("753", "3.41 +- 5 %"), "or its uncertainty per cent of it"));
    CHECK(contains(refusal("753 +- 20 %", "3.41"), "or its uncertainty per cent of it"));
    CHECK(refusal("753 +- 20", "3.41 +- 0.2").empty());
    CHECK(contains(input_error_of([] {
                       return read_xrd(R"({"samples": [{"name": "a", "peaks": [{"name": "quartz",
                                           "intensity": 753}], "amorphous": "50 %"}]})",
                                       "a.json");
                   }),
                   "the peak of \"quartz\" has no \"rir\""));
    CHECK(contains(input_error_of([] {
                       return read_xrd(R"({"samples": [{"name": "a", "weight_fractions": {"quartz": 0.5},
                                           "amorphous": "50 wt% +- 2"}]})",
                                       "a.json");
                   }),
                   "the uncertainty of \"50 % +- 2\" has no unit"));
}

TEST_CASE("intensities and ratios that make no sense are refused") {
    const auto refused = [](double intensity, double ratio) {
        return input_error_of([&] {
            return adiabatic_fractions(
                {{.name = "Quartz", .intensity = intensity, .reference_intensity_ratio = ratio}});
        });
    };
    CHECK(contains(refused(-1, 3), "intensity of Quartz is -1"));
    CHECK(contains(refused(1, 0), "reference intensity ratio of Quartz is 0"));
    CHECK(contains(refused(0, 3), "all intensities are zero"));
}

}  // namespace ashimpact::test
