// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/phase_catalogue.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "core/text/text.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

std::string one_phase(const std::string& members) {
    return R"({"set": "s", "title": "", "phases": [{"name": "x", )" + members + "}]}";
}

constexpr const char* density = R"("density": {"value": 2.5, "unit": "g/cm3", "citations": ["k"]})";
constexpr const char* modulus = R"("young_modulus": {"value": 73, "unit": "GPa", "citations": ["k"]})";

}  // namespace

TEST_CASE("values of the catalogue agree with the bulk and shear moduli of their sources") {
    struct Row {
        const char* phase;
        double bulk;
        double shear;
    };
    // K and G [GPa] as the sources print them, from which E = 9KG/(3K+G) and nu = (3K-2G)/(6K+2G) follow.
    for (const auto& [name, k, g] :
         {Row{"quartz", 37.8, 44.3},       Row{"mullite", 170.9, 87.8},      Row{"anorthite", 84.2, 39.9},
          Row{"anhydrite", 54.9, 29.3},    Row{"calcite", 73.3, 32.0},       Row{"corundum", 253.5, 163.2},
          Row{"rutile", 215.5, 112.4},     Row{"hematite", 204.24537, 91.0}, Row{"orthoclase", 59.45, 30.3},
          Row{"cristobalite", 16.4, 39.1}, Row{"diopside", 114.6, 72.7},     Row{"magnetite", 162.0, 91.2},
          Row{"periclase", 160.0, 130.3},  Row{"lime", 114.7, 81.2},         Row{"portlandite", 32.2, 21.2},
          Row{"brucite", 43.8, 35.2},      Row{"spinel", 197.9, 108.5},      Row{"dolomite", 94.9, 45.7},
          Row{"halite", 25.3, 14.7},       Row{"sylvite", 18.1, 9.4},        Row{"thenardite", 43.4, 22.3}}) {
        const Phase phase = shipped_catalogue().resolve(name).phase;
        CAPTURE(phase.name);
        CHECK(relative_difference(phase.young_modulus.value, 9e9 * k * g / (3 * k + g)) < 1.1e-3);
        CHECK(std::abs(phase.poisson_ratio->value - (3 * k - 2 * g) / (6 * k + 2 * g)) < 1.1e-3);
    }
}

TEST_CASE("the paper's values are their own entries and can be preferred") {
    const PhaseCatalogue literature = shipped_catalogue();
    CHECK(literature.resolve("mullite").phase.young_modulus.value == doctest::Approx(224.9e9));
    const PhaseCatalogue paper = literature.preferring("dong2013");
    CHECK(paper.resolve("Quartz").phase.name == "quartz-dong2013");
    CHECK(paper.resolve("mullite").phase.young_modulus.value == 230e9);
    CHECK(paper.resolve("mullite").phase.density.value == 2800);
    CHECK(paper.resolve("glass").phase.density.value == 2500);
    CHECK(paper.resolve("hematite").phase.name == "hematite");
    CHECK(literature.resolve("quartz-dong2013").phase.young_modulus.value == 94e9);
    CHECK(literature.resolve("amorphous").phase.name == "glass-dong2013");
    CHECK(literature.resolve("glass").phase.poisson_ratio->assumed);
    CHECK(input_error_of([&] { return literature.preferring("paper"); }) ==
          "no phase set is called \"paper\"; allowed: literature, dong2013");
}

TEST_CASE("names are found whatever their case, punctuation, spelling and data-base number") {
    const PhaseCatalogue catalogue = shipped_catalogue();
    for (const auto& pair : std::initializer_list<std::pair<const char*, const char*>>{
             {"Quartz low", "quartz"},
             {"quartz, low", "quartz"},
             {"CaO", "lime"},
             {"CaCO\u2083", "calcite"},
             {"\u03b1-Quartz", "quartz"},
             {"QUARTZ", "quartz"},
             {"Quartz9000775", "quartz"},
             {"Mullite 3:2", "mullite"},
             {"Mullite_32", "mullite"},
             {"Al6Si2O13", "mullite"},
             {"Haematite", "hematite"},
             {"Anorthite", "anorthite"},
             {"fused silica", "fused-silica"},
             {"Quartz, syn", "quartz"},
             {"Quartz low, syn", "quartz"},
             {"Quartz - SiO2", "quartz"},
             {"Quarz (SiO\u2082)", "quartz"},
             {"SiO2 (Cristobalite)", "cristobalite"},
             {"Cristobalite, syn - SiO2", "cristobalite"},
             {"Mullite, syn", "mullite"},
             {"Mullite - Al6Si2O13", "mullite"},
             {"Hematite PDF 00-033-0664", "hematite"},
             {"00-046-1045 Quartz", "quartz"},
             {"Magnetite_ICSD_26410", "magnetite"},
             {"C2S_b", "larnite"},
             {"Albite, ordered", "albite"},
             {"K-feldspar", "orthoclase"},
             {"Plagioclase", "anorthite"}}) {
        CAPTURE(pair.first);
        CHECK(catalogue.resolve(pair.first).phase.name == pair.second);
    }
    CHECK(catalogue.resolve("Plagioclase").note ==
          "\"Plagioclase\" may be one of several phases: anorthite is used");
    CHECK(catalogue.resolve("Kalk").note == "\"Kalk\" may be one of several phases: lime is used");
    CHECK(catalogue.resolve("Quartz").note.empty());
    CHECK(catalogue.resolve("Anorthite, sodian").note == "\"Anorthite, sodian\" is read as anorthite");
    for (const auto& [name, phases] : {std::pair{"SiO2", "quartz, cristobalite, fused-silica"},
                                       {"SiO\u2082, syn", "quartz, cristobalite, fused-silica"},
                                       {"TiO2", "rutile, anatase"},
                                       {"Fe2O3", "hematite, maghemite"}})
        CHECK_MESSAGE(contains(input_error_of([&] { return catalogue.resolve(name); }),
                               std::string("is the formula of ") + phases),
                      name);
    CHECK(contains(input_error_of([&] { return catalogue.resolve("Quartz (Cristobalite)"); }),
                   "may be quartz or cristobalite"));
    for (const auto& [name, phases] : {std::pair{"Freikalk, CaCO3", "lime or calcite"},
                                       {"Lime (Ca(OH)2)", "lime or portlandite"},
                                       {"Fe2O3 - Magnetite", "hematite or magnetite"},
                                       {"Magnetite (maghemite)", "magnetite or maghemite"},
                                       {"Rutile, Anatas", "rutile or anatase"},
                                       {"Albite (KAlSi3O8)", "albite or "}})
        CHECK_MESSAGE(contains(input_error_of([&] { return catalogue.resolve(name); }),
                               std::string("may be ") + phases),
                      name);
    CHECK(catalogue.resolve("Microcline, KAlSi3O8").phase.name == "microcline");
    for (const char* name :
         {"SiO2 (tridymite)", "Tridymite - SiO2", "Quartz (high)", "Quartz, beta", "Tridymite, syn",
          "Quarz (struck out)", "Lime (hydrated)", "Lime, partly slaked", "Lime, carbonated",
          "Hematite, hydrated", "Anhydrite (hemihydrate)", "Gypsum, calcined", "Calcite (burnt)",
          "Calcit (gebrannt)", "Brucite, dehydrated", "Periclase, hydrated", "Diopside (molten)"}) {
        CAPTURE(name);
        CHECK(contains(input_error_of([&] { return catalogue.resolve(name); }), "no phase is called"));
    }
    for (const auto& [name, phase] : {std::pair{"Slaked lime (Ca(OH)2)", "portlandite"},
                                      {"Lime, burnt", "lime"},
                                      {"Corundum (calcined)", "corundum"},
                                      {"Gypsum, hydrated", "gypsum"},
                                      {"Quartz, high purity", "quartz"}})
        CHECK_MESSAGE(catalogue.resolve(name).phase.name == phase, name);
}

TEST_CASE("members of solid solutions and other forms of feldspars are found by their stem") {
    const PhaseCatalogue catalogue = shipped_catalogue();
    for (const auto& [name, phase] :
         std::initializer_list<std::pair<const char*, const char*>>{{"Anorthite_An65", "anorthite"},
                                                                    {"Albite high", "albite"},
                                                                    {"Albite_high", "albite"},
                                                                    {"Plagioclase An50", "anorthite"},
                                                                    {"Labradorite_An65", "anorthite"},
                                                                    {"Oligoclase", "albite"},
                                                                    {"Diopside En10", "diopside"}}) {
        CAPTURE(name);
        const ResolvedPhase found = catalogue.resolve(name);
        CHECK(found.phase.name == phase);
        CHECK(contains(found.note, std::string(": ") + phase + " is used"));
    }
    for (const char* name :
         {"Quartz high", "Quartz_high", "Quartz 2", "Cristobalite high", "Tridymite_An65"}) {
        CAPTURE(name);
        CHECK(contains(input_error_of([&] { return catalogue.resolve(name); }), "no phase is called"));
    }
}

TEST_CASE("phases of fly ash and of its deposits, by the names that users have") {
    const PhaseCatalogue catalogue = shipped_catalogue();
    for (const auto& [name, phase] :
         std::initializer_list<std::pair<const char*, const char*>>{{"C3A", "tricalcium-aluminate"},
                                                                    {"C4AF", "brownmillerite"},
                                                                    {"Brownmillerite", "brownmillerite"},
                                                                    {"Dolomit", "dolomite"},
                                                                    {"Microcline", "microcline"},
                                                                    {"Sylvine", "sylvite"},
                                                                    {"Halite, syn", "halite"},
                                                                    {"Thenardite", "thenardite"},
                                                                    {"Spinel", "spinel"},
                                                                    {"Periclase", "periclase"},
                                                                    {"Cristobalite", "cristobalite"}}) {
        CAPTURE(name);
        CHECK(catalogue.resolve(name).phase.name == phase);
        CHECK_FALSE(catalogue.resolve(name).phase.formula.empty());
    }
    CHECK(catalogue.resolve("microcline").phase.young_modulus.assumed);
    CHECK(catalogue.resolve("Spinell").note == "\"Spinell\" may be one of several phases: MgAl2O4 is used");
    CHECK(catalogue.resolve("MgAl2O4").note.empty());
}

TEST_CASE("what is not found comes with the nearest names, all at once") {
    const PhaseCatalogue catalogue = shipped_catalogue();
    CHECK(contains(input_error_of([&] { return catalogue.resolve("Qartz"); }), "nearest: quartz, "));
    CHECK(input_error_of([&] { return catalogue.resolve("silica"); }) ==
          "\"silica\" is a mineral group; allowed: one of its phases: quartz, cristobalite");
    CHECK(input_error_of([&] {
              return catalogue.resolve("gehlenite");
          }).find("no phase is called \"gehlenite\" with all its properties: a measured shear or Young's") ==
          0);
    for (const char* name : {"Melilite", "Merwinite, syn", "Maghemite", "Wollastonit", "Arcanite", "K2SO4"}) {
        CAPTURE(name);
        CHECK(contains(input_error_of([&] { return catalogue.resolve(name); }), " is missing"));
    }
    const std::string both = input_error_of([&] {
        return catalogue.resolve_all({{"quartz", "line 3"}, {"mulite", "line 8"}, {"kryptonite", "line 9"}});
    });
    CHECK(both.find("line 8: no phase is called \"mulite\" (nearest: ") == 0);
    CHECK(contains(both, "); line 9: no phase is called \"kryptonite\"; allowed: "));
    CHECK(contains(both, "--phases FILE"));
    CHECK_FALSE(contains(both, "\n"));
    CHECK(catalogue.resolve_all({{"quartz"}, {"mullite"}}).size() == 2);
    const std::string many = input_error_of(
        [&] { static_cast<void>(catalogue.resolve_all(std::vector<PlacedName>(100'000, {"kryptonite"}))); });
    CHECK(contains(many, "and more"));
    CHECK(many.size() < 2000);
}

TEST_CASE("the user's own phases come first") {
    const Json own = parse_json(R"([{"name": "quartz", "density": "2.7 g/cm3", "young_modulus": 9.0e10},
                                     {"name": "lime", "density": {"value": 3.3, "unit": "g/cm3"},
                                      "young_modulus": {"value": 190, "unit": "GPa", "standard_uncertainty": 10}}])");
    const PhaseCatalogue catalogue = shipped_catalogue().overridden_by(read_user_phases(View(own)));
    CHECK(relative_difference(catalogue.resolve("quartz").phase.density.value, 2700) < 1e-15);
    CHECK(catalogue.resolve("lime").phase.young_modulus.uncertainty().value() == doctest::Approx(10e9));
    const PhaseCatalogue texts = shipped_catalogue().overridden_by(read_user_phases(View(parse_json(
        R"([{"name": "lime", "density": "3.3 +- 0.1 g/cm3", "young_modulus": "190(10) GPa",
             "poisson_ratio": "0.22 +- 0.02"}])"))));
    const Phase lime = texts.resolve("lime").phase;
    CHECK(lime.density.uncertainty().value() == doctest::Approx(100));
    CHECK(lime.young_modulus.uncertainty().value() == doctest::Approx(10e9));
    CHECK(lime.poisson_ratio.value().uncertainty().value() == doctest::Approx(0.02));
    // it replaces the catalogue's under every synonym, with a note; a glass of one's own replaces the paper's
    CHECK(catalogue.resolve("Quartz low").phase.young_modulus.value == 90e9);
    CHECK(catalogue.resolve("Quartz9000775").phase.young_modulus.value == 90e9);
    CHECK(catalogue.resolve("Quarz").note == "\"Quarz\" is quartz: quartz of the set user is taken");
    CHECK(catalogue.resolve("quartz").note.empty());
    CHECK(catalogue.resolve("quartz-dong2013").phase.young_modulus.value == 94e9);
    const PhaseCatalogue glassy = shipped_catalogue().overridden_by(read_user_phases(View(parse_json(
        R"([{"name": "glass", "amorphous": true, "density": "2.4 g/cm3", "young_modulus": "80 GPa"},
            {"name": "sanidine", "density": "2.6 g/cm3", "young_modulus": "70 GPa"}])"))));
    CHECK(glassy.resolve("Amorphous").phase.young_modulus.value == 80e9);
    CHECK(glassy.resolve("glass-dong2013").phase.young_modulus.value == 73e9);
    CHECK(glassy.resolve("sanidine").phase.young_modulus.value == 70e9);
    CHECK(relative_difference(glassy.resolve("orthoclase").phase.young_modulus.value, 77.7e9) < 1e-14);
    CHECK(shipped_catalogue().preferring("dong2013").resolve("Quartz low").phase.young_modulus.value == 94e9);
}

TEST_CASE("the uncertainty of a range is that of a rectangular distribution") {
    const Phase albite = shipped_catalogue().resolve("albite").phase;
    CHECK(relative_difference(albite.young_modulus.uncertainty().value(), 26.4e9 / std::sqrt(12.0)) < 1e-14);
    CHECK(shipped_catalogue().resolve("mullite").phase.young_modulus.uncertainty() ==
          9e9);  // stated, despite a range
    CHECK(!shipped_catalogue().resolve("corundum").phase.young_modulus.uncertainty());
}

TEST_CASE("a broken catalogue says where it is broken") {
    const auto read = [](const std::string& text) {
        return input_error_of([&] { return read_phase_set(text); });
    };
    const std::string good = std::string(density) + ", " + modulus;
    CHECK(read(one_phase(good)).empty());
    CHECK(read("{").starts_with("line 1, column 2: this is not valid JSON"));
    CHECK(read("{\n\"set\": 3,,\n}").starts_with("line 2, column 10: "));
    CHECK(read(one_phase(std::string(density))).starts_with("/phases/0: \"young_modulus\" is missing"));
    CHECK(read(one_phase(good + R"(, "young": 3)")).starts_with("/phases/0/young: unknown key"));
    CHECK(read(one_phase(good + ", " + density)).starts_with("/phases/0/density: this key is there twice"));
    CHECK(contains(read(one_phase(good + R"(, "poisson_ratio": {"value": 0.2, "unit": "1"})")),
                   "without a citation"));
    CHECK(read(one_phase(good + R"(, "poisson_ratio": {"value": 0.6, "unit": "1"})"))
              .starts_with("/phases/0/poisson_ratio: value is 0.6"));
    CHECK(read(one_phase(R"("density": {"value": -2.5, "unit": "g/cm3"}, )" + std::string(modulus)))
              .starts_with("/phases/0/density: value is -2500 kg/m3"));
    CHECK(read(one_phase(R"("density": {"value": 2.5, "unit": "GPa"}, )" + std::string(modulus)))
              .starts_with("/phases/0/density: the unit \"GPa\" is not one of density"));
    CHECK(read(one_phase(R"("density": {"value": 2.5, "unit": "g/cm3", "range": [2.6, 2.7]}, )" +
                         std::string(modulus)))
              .starts_with("/phases/0/density/range: the value lies outside"));
    CHECK(read(R"({"set": "s", "title": "", "phases": [{"name": "x", )" + good +
               R"(}, {"name": "y", "synonyms": ["X"], )" + good + "}]}")
              .starts_with("/phases: \"X\" stands for both x and y"));
    CHECK(contains(read(std::string(5000, '[')), "nested too deeply"));
}

TEST_CASE("docs/phases.md shows the catalogue as it is") {
    const std::string page = file_text(ASHIMPACT_DOCS "/phases.md");
    const PhaseCatalogue catalogue = shipped_catalogue();
    for (const PhaseSet& set : catalogue.sets()) {
        for (const Phase& phase : set.phases) {
            std::string row = "| " + phase.name + " | " + phase.formula + " | " +
                              shortest(phase.density.value / 1000) + " | " +
                              shortest(phase.young_modulus.value / 1e9) + " | ";
            CAPTURE(row);
            CHECK(contains(page, row));
            if (phase.remark.empty()) continue;
            CHECK(contains(page, "**" + phase.name + "**: " + phase.remark));
        }
    }
}

}  // namespace ashimpact::test
