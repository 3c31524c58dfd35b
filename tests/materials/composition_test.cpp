// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/composition.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "tests/core/messages.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

namespace {

Composition paper(const Analysis& analysis) {
    return compose(analysis, shipped_catalogue().preferring("dong2013"));
}

std::string refused(const Analysis& analysis) {
    return refusal([&] { return compose(analysis, shipped_catalogue()); });
}

const std::vector<PhaseFraction> crystalline{{.name = "quartz", .fraction = 0.2},
                                             {.name = "mullite", .fraction = 0.8}};

}  // namespace

TEST_CASE("weight fractions to volume fractions, worked by hand") {
    // 30 % quartz (2.65), 70 % mullite (2.80): 0.3/2.65 = 0.113207547, 0.7/2.80 = 0.25, sum 0.363207547
    const std::vector<double> v = volume_fractions(std::vector{0.3, 0.7}, std::vector{2650.0, 2800.0});
    CHECK(relative_difference(v[0], 0.3116883116883117) < 1e-14);
    CHECK(relative_difference(v[1], 0.6883116883116883) < 1e-14);
    CHECK(relative_difference(mixture_density(v, std::vector{2650.0, 2800.0}), 2753.246753246753) < 1e-14);
}

TEST_CASE("weight to volume to weight comes back to 1e-14") {
    std::mt19937_64 generator(7);
    std::exponential_distribution<double> amount;
    std::uniform_real_distribution<double> density(2000, 6000);
    for (int sample = 0; sample < 1000; ++sample) {
        std::vector<double> w(8);
        std::vector<double> rho(8);
        double total = 0;
        for (double& x : w) total += x = amount(generator);
        for (double& x : w) x /= total;
        for (double& x : rho) x = density(generator);
        const std::vector<double> back = weight_fractions(volume_fractions(w, rho), rho);
        for (std::size_t i = 0; i < w.size(); ++i) REQUIRE(relative_difference(back[i], w[i]) < 1e-14);
    }
}

TEST_CASE("the amorphous part is never assumed") {
    const std::string line = refused({.phases = crystalline});
    CHECK(holds(line, "nothing says how much of the sample is amorphous"));
    CHECK(holds(line, "allowed: the amorphous weight fraction, the crystalline total, an internal standard"));
}

TEST_CASE("four ways to state it give the same sample") {
    const double a = 0.45;
    const std::vector<PhaseFraction> of_the_whole{{.name = "quartz", .fraction = 0.11},
                                                  {.name = "mullite", .fraction = 0.44}};
    std::vector<PhaseFraction> with_glass = of_the_whole;
    with_glass.push_back({.name = "glass", .fraction = a});
    for (const Analysis& analysis :
         {Analysis{.phases = crystalline, .amorphous = AmorphousFraction{.value = a}},
          Analysis{.phases = of_the_whole, .amorphous = AmorphousFraction{.value = a}},
          Analysis{.phases = crystalline, .amorphous = CrystallineTotal{.value = 1 - a}},
          Analysis{.phases = of_the_whole, .amorphous = CrystallineTotal{.value = 1 - a}},
          Analysis{.phases = of_the_whole, .amorphous = AmorphousRemainder{}},
          Analysis{.phases = crystalline, .amorphous = AmorphousRemainder{.scale = 1 - a}},
          Analysis{.phases = with_glass}}) {
        const Composition composition = paper(analysis);
        REQUIRE(composition.components.size() == 3);
        CHECK(composition.components[2].phase.name == "glass-dong2013");
        CHECK(relative_difference(composition.components[0].weight_fraction, 0.11) < 1e-14);
        CHECK(relative_difference(composition.components[1].weight_fraction, 0.44) < 1e-14);
        CHECK(relative_difference(composition.components[2].weight_fraction, 0.45) < 1e-14);
        // 1/density = 0.11/2650 + 0.44/2800 + 0.45/2500
        CHECK(relative_difference(composition.density, 2640.945330296128) < 1e-14);
    }
    const Composition none = paper({.phases = crystalline, .amorphous = AmorphousNone{}});
    REQUIRE(none.components.size() == 2);
    CHECK(relative_difference(none.components[1].weight_fraction, 0.8) < 1e-15);
}

TEST_CASE("a remainder of nothing is noted: the fractions may be those of the crystalline part") {
    const Composition all = paper({.phases = crystalline, .amorphous = AmorphousRemainder{}});
    CHECK(holds(all.notes.back().text,
                "the phases leave 0 % for the amorphous part: are the fractions of the"));
    const Composition half = paper({.phases = crystalline, .amorphous = AmorphousRemainder{.scale = 0.5}});
    for (const Finding& note : half.notes) CHECK(!holds(note.text, "the phases leave"));
}

TEST_CASE("errors about phases name their place in the file") {
    const auto analysis = [](const char* second) {
        return Analysis{.phases = {{.name = "quartz", .fraction = 0.5, .place = "line 4"},
                                   {.name = second, .fraction = 0.5, .place = "line 7"}},
                        .amorphous = AmorphousNone{}};
    };
    CHECK(refused(analysis("SiO2")) ==
          "line 7: \"quartz\" and \"SiO2\" are the same phase, quartz; allowed: each phase once; add "
          "their fractions");
    CHECK(holds(refused(analysis("mulite")), "line 7: no phase is called \"mulite\" (nearest: mullite, "));
    Analysis many{.phases = std::vector<PhaseFraction>(1001, {.name = "quartz", .place = "line 9"})};
    CHECK(refused(many) == "line 9: the sample has 1001 phases; allowed: 1000 or fewer");
}

TEST_CASE("fractions by volume go the other way") {
    const Composition composition =
        paper({.phases = crystalline, .basis = FractionBasis::volume, .amorphous = AmorphousNone{}});
    CHECK(relative_difference(composition.components[0].volume_fraction, 0.2) < 1e-15);
    CHECK(relative_difference(composition.components[0].weight_fraction,
                              0.2 * 2650 / (0.2 * 2650 + 0.8 * 2800)) < 1e-14);
    CHECK(relative_difference(composition.density, 2770) < 1e-14);
}

TEST_CASE("rounded fractions are scaled within the tolerance, with a note") {
    const Composition composition =
        paper({.phases = {{.name = "quartz", .fraction = 0.2}, {.name = "mullite", .fraction = 0.797}},
               .amorphous = AmorphousNone{}});
    CHECK(relative_difference(composition.components[0].weight_fraction, 0.2 / 0.997) < 1e-14);
    REQUIRE(composition.notes.size() == 1);
    CHECK(composition.notes[0].text == "the fractions add up to 99.7 % and were scaled to 100 %");
}

TEST_CASE("whose modulus stands for the glass is said") {
    const Composition composition =
        paper({.phases = crystalline, .amorphous = AmorphousFraction{.value = 0.4}});
    REQUIRE(composition.notes.size() == 1);
    CHECK(holds(composition.notes[0].text,
                "\"glass\" is taken as glass-dong2013: No measured modulus of fly-ash glass"));
}

TEST_CASE("the file's own density is used and compared with the catalogue's") {
    const Composition composition = compose(
        {.phases = {{.name = "Mullite", .fraction = 1, .density = 3087.0}}, .amorphous = AmorphousNone{}},
        shipped_catalogue());
    CHECK(composition.density == 3087);
    REQUIRE(composition.notes.size() == 1);
    CHECK(composition.notes[0].text ==
          "the file's density of \"Mullite\", 3087 kg/m3, is used; the catalogue has 3156 kg/m3 (-2.1863 %)");
}

TEST_CASE("what does not close or makes no sense is refused in one line") {
    const auto two = [](double first, double second) {
        return std::vector<PhaseFraction>{{.name = "quartz", .fraction = first},
                                          {.name = "mullite", .fraction = second}};
    };
    CHECK(refused({.phases = {}}) == "no phases; allowed: at least one phase with its fraction");
    CHECK(holds(refused({.phases = two(0.6, 0.5), .amorphous = AmorphousNone{}}),
                "add up to 110 %; allowed: 100 % or less"));
    CHECK(holds(refused({.phases = two(0.6, 0.3), .amorphous = AmorphousNone{}}),
                "add up to 90 %; allowed: 100 % within 0.5 %, as there is no amorphous part"));
    CHECK(holds(refused({.phases = two(0.6, 0.3), .amorphous = AmorphousFraction{.value = 0.3}}),
                "add up to 90 %; allowed: 70 % within 0.5 %"));
    CHECK(holds(refused({.phases = two(0.6, 0.3), .amorphous = CrystallineTotal{.value = 0.8}}),
                "allowed: 80 %"));
    CHECK(holds(refused({.phases = two(0.6, -0.3), .amorphous = AmorphousNone{}}),
                "the fraction of \"mullite\" is -0.3"));
    CHECK(holds(refused({.phases = two(0.6, NAN), .amorphous = AmorphousNone{}}),
                "the fraction of \"mullite\" is nan"));
    CHECK(holds(refused({.phases = two(0, 0), .amorphous = AmorphousNone{}}), "all fractions are zero"));
    CHECK(holds(refused({.phases = two(0.6, 0.4), .amorphous = AmorphousFraction{.value = 1.2}}),
                "amorphous fraction is 1.2"));
    CHECK(holds(refused({.phases = two(0.6, 0.4), .amorphous = AmorphousFraction{.value = 1}}),
                "wholly amorphous"));
    CHECK(holds(refused({.phases = two(0.6, 0.4),
                         .amorphous = AmorphousFraction{.value = 0.3, .basis = FractionBasis::volume}}),
                "not both by weight or by volume"));
    CHECK(holds(refused({.phases = two(0.6, 0.4), .amorphous = AmorphousRemainder{.scale = 1.2}}),
                "120 % of the sample"));
    CHECK(holds(refused({.phases = {{.name = "quartz", .fraction = 0.5}, {.name = "SiO2", .fraction = 0.5}},
                         .amorphous = AmorphousNone{}}),
                "\"quartz\" and \"SiO2\" are the same phase, quartz"));
    CHECK(holds(refused({.phases = {{.name = "quartz", .fraction = 0.5}, {.name = "glass", .fraction = 0.5}},
                         .amorphous = AmorphousFraction{.value = 0.5}}),
                "listed among the phases and stated again"));
    CHECK(
        holds(refused({.phases = {{.name = "quartz", .fraction = 0.5}, {.name = "glass", .fraction = 0.3}}}),
              "allowed: 100 % within 0.5 %, as the amorphous part is listed"));
    CHECK(holds(refused({.phases = {{.name = "quarz-like", .fraction = 1}}, .amorphous = AmorphousNone{}}),
                "no phase is called"));
    CHECK(holds(refused({.phases = {{.name = "quartz", .fraction = 1, .standard_uncertainty = -0.1}},
                         .amorphous = AmorphousNone{}}),
                "uncertainty of the fraction of quartz is -0.1"));
    CHECK(holds(refused({.phases = {{.name = "quartz", .fraction = 1, .density = 0.0}},
                         .amorphous = AmorphousNone{}}),
                "density of quartz is 0 kg/m3"));
}

}  // namespace ashimpact::test
