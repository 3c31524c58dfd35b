// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/composition.hpp"

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "materials/mixture_rules.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

Composition paper(const Analysis& analysis) {
    return compose(analysis, shipped_catalogue().preferring("dong2013"));
}

std::string refused(const Analysis& analysis) {
    return input_error_of([&] { return compose(analysis, shipped_catalogue()); });
}

const std::vector<PhaseFraction> crystalline{{.name = "quartz", .fraction = 0.2},
                                             {.name = "mullite", .fraction = 0.8}};

struct Sample {
    std::vector<double> volumes;
    std::vector<double> young_moduli;
    std::vector<IsotropicModuli> moduli;
};

/// Every crystalline or glassy phase of the catalogue in random amounts; about a third of them absent.
Sample random_sample(std::mt19937_64& generator, const PhaseCatalogue& catalogue) {
    std::exponential_distribution<double> amount;
    std::bernoulli_distribution present(2.0 / 3);
    Sample sample;
    double total = 0;
    for (const PhaseSet& set : catalogue.sets()) {
        for (const Phase& phase : set.phases) {
            if (!phase.poisson_ratio) continue;
            sample.volumes.push_back(present(generator) ? amount(generator) : 0);
            sample.young_moduli.push_back(phase.young_modulus.value);
            sample.moduli.push_back(isotropic_moduli(phase.young_modulus.value, phase.poisson_ratio->value));
            total += sample.volumes.back();
        }
    }
    if (total == 0) total = sample.volumes.front() = 1;
    for (double& v : sample.volumes) v /= total;
    return sample;
}

constexpr double rounding = 1 + 1e-12;

void refuses(const Analysis& analysis, const std::string& says) {
    CHECK(contains(refused(analysis), says));
}

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
    CHECK(contains(line, "the amorphous fraction of the sample is not stated"));
    CHECK(contains(line,
                   "allowed: the amorphous weight fraction, the crystalline total, an internal standard"));
}

TEST_CASE("five ways to state it give the same sample") {
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
          Analysis{.phases = with_glass},
          Analysis{.phases = with_glass, .amorphous = CrystallineTotal{.value = 1 - a}}}) {
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
    CHECK(contains(all.notes.back().text,
                   "the phases leave 0 % for the amorphous part: are the fractions of the"));
    const Composition half = paper({.phases = crystalline, .amorphous = AmorphousRemainder{.scale = 0.5}});
    for (const Finding& note : half.notes) CHECK(!contains(note.text, "the phases leave"));
}

TEST_CASE("statements beside a listed amorphous part that count for nothing are noted") {
    const Analysis listed{
        .phases = {{.name = "quartz", .fraction = 0.4}, {.name = "glass", .fraction = 0.6}}};
    Analysis total = listed;
    total.amorphous = CrystallineTotal{.value = 0.4, .standard_uncertainty = 0.03};
    Analysis named = listed;
    named.amorphous_phase = "fused-silica";
    const auto notes = [](const Analysis& analysis) {
        std::string texts;
        for (const Finding& note : compose(analysis, shipped_catalogue()).notes) texts += note.text + '\n';
        return texts;
    };
    CHECK(contains(notes(total), "the uncertainty of the crystalline total is not used"));
    CHECK(contains(notes(named), "the amorphous phase \"fused-silica\" is not used"));
    CHECK_FALSE(contains(notes(listed), "not used"));
}

TEST_CASE("a phase that laboratories weigh in counts as one of the ash, and that is said") {
    const auto notes = [](const char* name, double fraction) {
        const Analysis analysis{.phases = {{.name = name, .fraction = fraction},
                                           {.name = "quartz", .fraction = 0.4 - fraction},
                                           {.name = "glass", .fraction = 0.6}}};
        std::string texts;
        for (const Finding& note : compose(analysis, shipped_catalogue()).notes) texts += note.text + '\n';
        return texts;
    };
    for (const char* name : {"corundum", "Korund", "Al2O3", "Corundum (NIST 676a)"})
        CHECK(contains(notes(name, 0.1), "counts as a phase of the ash: no text"));
    CHECK_FALSE(contains(notes("corundum", 0.01), "counts as a phase"));
    CHECK_FALSE(contains(notes("mullite", 0.1), "counts as a phase"));
}

TEST_CASE("errors about phases name their place in the file") {
    const auto analysis = [](const char* second) {
        return Analysis{.phases = {{.name = "quartz", .fraction = 0.5, .place = "line 4"},
                                   {.name = second, .fraction = 0.5, .place = "line 7"}},
                        .amorphous = AmorphousNone{}};
    };
    CHECK(refused(analysis("quarz")) ==
          "line 7: \"quartz\" and \"quarz\" are the same phase, quartz; allowed: each phase once; add "
          "their fractions");
    refuses(analysis("mullitte"), "line 7: no phase is called \"mullitte\" (nearest: mullite, ");
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
    CHECK(contains(composition.notes[0].text,
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
    refuses({.phases = two(0.6, 0.5), .amorphous = AmorphousNone{}},
            "add up to 110 %; allowed: 100 % or less");
    refuses({.phases = two(0.6, 0.3), .amorphous = AmorphousNone{}},
            "add up to 90 %; allowed: 100 % within 0.5 %, as there is no amorphous part");
    refuses({.phases = two(0.6, 0.3), .amorphous = AmorphousFraction{.value = 0.3}},
            "add up to 90 %; allowed: 70 % within 0.5 %");
    refuses({.phases = {{.name = "quartz", .fraction = 0.4}, {.name = "glass", .fraction = 0.6}},
             .amorphous = CrystallineTotal{.value = 0.5}},
            "the crystalline total is stated as 50 %, and the amorphous part is listed as 60 %");
    refuses({.phases = two(0.6, 0.3), .amorphous = CrystallineTotal{.value = 0.8}}, "allowed: 80 %");
    refuses({.phases = two(0.6, -0.3), .amorphous = AmorphousNone{}}, "the fraction of \"mullite\" is -0.3");
    refuses({.phases = two(0.6, NAN), .amorphous = AmorphousNone{}}, "the fraction of \"mullite\" is nan");
    refuses({.phases = two(0, 0), .amorphous = AmorphousNone{}}, "all fractions are zero");
    refuses({.phases = two(0.6, 0.4), .amorphous = AmorphousFraction{.value = 1.2}},
            "amorphous fraction is 1.2");
    refuses({.phases = two(0.6, 0.4), .amorphous = AmorphousFraction{.value = 1}}, "wholly amorphous");
    refuses({.phases = two(0.6, 0.4),
             .amorphous = AmorphousFraction{.value = 0.3, .basis = FractionBasis::volume}},
            "not both by weight or by volume");
    refuses({.phases = two(0.6, 0.4), .amorphous = AmorphousRemainder{.scale = 1.2}}, "120 % of the sample");
    refuses({.phases = {{.name = "quartz", .fraction = 0.5}, {.name = "glass", .fraction = 0.5}},
             .amorphous = AmorphousFraction{.value = 0.5}},
            "listed among the phases and stated again");
    refuses({.phases = {{.name = "quartz", .fraction = 0.5}, {.name = "glass", .fraction = 0.3}}},
            "allowed: 100 % within 0.5 %, as the amorphous part is listed");
    refuses({.phases = {{.name = "quarz-like", .fraction = 1}}, .amorphous = AmorphousNone{}},
            "no phase is called");
    refuses({.phases = {{.name = "quartz", .fraction = 1, .standard_uncertainty = -0.1}},
             .amorphous = AmorphousNone{}},
            "uncertainty of the fraction of quartz is -0.1");
    refuses({.phases = {{.name = "quartz", .fraction = 1, .density = 0.0}}, .amorphous = AmorphousNone{}},
            "density of quartz is 0 kg/m3");
}

TEST_CASE("E, nu and K, G are two ways to say the same") {
    const IsotropicModuli mullite = isotropic_moduli(224.9e9, 0.281);
    CHECK(relative_difference(mullite.bulk, 224.9e9 / 1.314) < 1e-14);
    CHECK(relative_difference(mullite.shear, 224.9e9 / 2.562) < 1e-14);
    CHECK(relative_difference(young_modulus(mullite), 224.9e9) < 1e-14);
    CHECK(relative_difference(poisson_ratio(mullite), 0.281) < 1e-14);
    const IsotropicModuli auxetic = isotropic_moduli(65.4e9, -0.164);
    CHECK(relative_difference(poisson_ratio(auxetic), -0.164) < 1e-14);
    CHECK_THROWS_AS(static_cast<void>(isotropic_moduli(90e9, 0.5)), InputError);
    CHECK_THROWS_AS(static_cast<void>(isotropic_moduli(0, 0.2)), InputError);
}

TEST_CASE("two phases in equal parts, worked by hand") {
    // K 30 and 90, G 20 and 60 GPa: here K/G is the same, so the bounds can be written down on a slip of
    // paper.
    const std::array v{0.5, 0.5};
    const std::array phases{IsotropicModuli{.bulk = 30e9, .shear = 20e9},
                            IsotropicModuli{.bulk = 90e9, .shear = 60e9}};
    CHECK(relative_difference(voigt_moduli(v, phases).bulk, 60e9) < 1e-15);
    CHECK(relative_difference(reuss_moduli(v, phases).bulk, 45e9) < 1e-15);
    CHECK(relative_difference(hill_moduli(v, phases).shear, 35e9) < 1e-15);
    // lower: y = 80/3, K = 1/(0.5/(30+80/3) + 0.5/(90+80/3)) - 80/3 = 49.6153846...
    CHECK(relative_difference(hashin_shtrikman_lower(v, phases).bulk, (645.0 / 13) * 1e9) < 1e-14);
    // upper: y = 80, K = 1/(0.5/110 + 0.5/170) - 80 = 53.5714285...
    CHECK(relative_difference(hashin_shtrikman_upper(v, phases).bulk, (375.0 / 7) * 1e9) < 1e-14);
    // z = 20 (270 + 160)/(6 (30 + 40)) = 430/21 and three times that
    CHECK(relative_difference(hashin_shtrikman_lower(v, phases).shear, 33.38582677165355e9) < 1e-14);
    CHECK(relative_difference(hashin_shtrikman_upper(v, phases).shear, 36.056338028169016e9) < 1e-14);
    const std::array e{young_modulus(phases[0]), young_modulus(phases[1])};
    CHECK(relative_difference(parallel_young_modulus(v, e), (e[0] + e[1]) / 2) < 1e-15);
    CHECK(relative_difference(series_young_modulus(v, e), 1.5 * e[0]) < 1e-15);
    CHECK(relative_difference(hill_young_modulus(v, e), 1.75 * e[0]) < 1e-15);
}

TEST_CASE("a single phase keeps its moduli under every rule, and an absent one changes nothing") {
    const std::array v{0.0, 1.0};
    const std::array phases{IsotropicModuli{.bulk = 1e9, .shear = 900e9},
                            IsotropicModuli{.bulk = 170.9e9, .shear = 87.8e9}};
    for (const auto rule :
         {voigt_moduli, reuss_moduli, hill_moduli, hashin_shtrikman_lower, hashin_shtrikman_upper}) {
        const IsotropicModuli result = rule(v, phases);
        CHECK(relative_difference(result.bulk, 170.9e9) < 1e-14);
        CHECK(relative_difference(result.shear, 87.8e9) < 1e-14);
    }
    const std::array e{1e9, 224.9e9};
    CHECK(parallel_young_modulus(v, e) == 224.9e9);
    CHECK(relative_difference(series_young_modulus(v, e), 224.9e9) < 1e-15);
}

TEST_CASE(
    "pores are a phase without stiffness: nothing is left of the lower bound, the upper one is finite") {
    const std::array v{0.8, 0.2};
    const std::array phases{isotropic_moduli(90e9, 0.2), IsotropicModuli{}};
    for (const auto& softest : {hashin_shtrikman_lower(v, phases), reuss_moduli(v, phases)}) {
        CHECK(softest.bulk == 0);
        CHECK(softest.shear == 0);
        CHECK(young_modulus(softest) == 0);
    }
    // K0 = 50 GPa, G0 = 37.5 GPa = 3K0/4: K = G0 4/3 0.8/(1 + 0.2) = 100/3, and G falls by the same factor
    // 2/3
    CHECK(relative_difference(hashin_shtrikman_upper(v, phases).bulk, 100e9 / 3) < 1e-14);
    CHECK(relative_difference(hashin_shtrikman_upper(v, phases).shear, 25e9) < 1e-14);
    // a liquid has no shear modulus, but its bulk modulus counts
    const std::array wet{isotropic_moduli(90e9, 0.2), IsotropicModuli{.bulk = 2.2e9, .shear = 0}};
    const IsotropicModuli lower = hashin_shtrikman_lower(v, wet);
    CHECK(relative_difference(lower.bulk, 1e9 / (0.8 / 50 + 0.2 / 2.2)) < 1e-14);
    CHECK(lower.shear == 0);
}

TEST_CASE("Walpole's form is Hashin and Shtrikman's own (1963, Eqs. 4.1 to 4.4) for two phases") {
    const IsotropicModuli soft{.bulk = 37.8e9, .shear = 44.3e9};    // quartz
    const IsotropicModuli stiff{.bulk = 170.9e9, .shear = 87.8e9};  // mullite
    for (const double f : {0.01, 0.3, 0.77}) {
        const std::array v{1 - f, f};
        const std::array phases{soft, stiff};
        const auto bound = [&](const IsotropicModuli& a, const IsotropicModuli& b, double vb) {
            const double va = 1 - vb;
            return IsotropicModuli{
                .bulk = a.bulk + vb / (1 / (b.bulk - a.bulk) + 3 * va / (3 * a.bulk + 4 * a.shear)),
                .shear = a.shear +
                         vb / (1 / (b.shear - a.shear) +
                               6 * va * (a.bulk + 2 * a.shear) / (5 * a.shear * (3 * a.bulk + 4 * a.shear)))};
        };
        const IsotropicModuli lower = bound(soft, stiff, f);
        const IsotropicModuli upper = bound(stiff, soft, 1 - f);
        CHECK(relative_difference(hashin_shtrikman_lower(v, phases).bulk, lower.bulk) < 1e-14);
        CHECK(relative_difference(hashin_shtrikman_lower(v, phases).shear, lower.shear) < 1e-14);
        CHECK(relative_difference(hashin_shtrikman_upper(v, phases).bulk, upper.bulk) < 1e-14);
        CHECK(relative_difference(hashin_shtrikman_upper(v, phases).shear, upper.shear) < 1e-14);
    }
}

TEST_CASE(
    "phases that are not well ordered, with a liquid: Mavko, Mukerji & Dvorkin, The Rock Physics Handbook, "
    "4.1") {
    // quartz, calcite, water at a porosity of 27 %; the book prints K 26.9 and 7.1, G 24.6 and 0 GPa
    const std::array v{0.584, 0.146, 0.27};
    const std::array phases{IsotropicModuli{.bulk = 36e9, .shear = 45e9},
                            IsotropicModuli{.bulk = 75e9, .shear = 31e9},
                            IsotropicModuli{.bulk = 2.2e9, .shear = 0}};
    CHECK(std::abs(hashin_shtrikman_upper(v, phases).bulk - 26.9e9) < 0.05e9);
    CHECK(std::abs(hashin_shtrikman_upper(v, phases).shear - 24.6e9) < 0.05e9);
    CHECK(std::abs(hashin_shtrikman_lower(v, phases).bulk - 7.1e9) < 0.05e9);
    CHECK(hashin_shtrikman_lower(v, phases).shear == 0);
}

TEST_CASE("10,000 random compositions: the order of the rules") {
    std::mt19937_64 generator(20130806);
    const PhaseCatalogue catalogue = shipped_catalogue();
    int eq1_above_hashin_shtrikman = 0;
    int eq1_below_voigt = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto [v, e, phases] = random_sample(generator, catalogue);
        const double parallel = parallel_young_modulus(v, e);
        const double series = series_young_modulus(v, e);
        const double hill = hill_young_modulus(v, e);
        const double voigt = young_modulus(voigt_moduli(v, phases));
        const double reuss = young_modulus(reuss_moduli(v, phases));
        const IsotropicModuli lower = hashin_shtrikman_lower(v, phases);
        const IsotropicModuli upper = hashin_shtrikman_upper(v, phases);
        REQUIRE(series <= hill * rounding);
        REQUIRE(hill <= parallel * rounding);
        REQUIRE(reuss <= young_modulus(lower) * rounding);
        REQUIRE(young_modulus(lower) <= young_modulus(upper) * rounding);
        REQUIRE(young_modulus(upper) <= voigt * rounding);
        REQUIRE(lower.bulk <= upper.bulk * rounding);
        REQUIRE(lower.shear <= upper.shear * rounding);
        REQUIRE(parallel <= voigt * rounding);
        REQUIRE(relative_difference(series, reuss) < 1e-12);
        eq1_above_hashin_shtrikman += parallel > young_modulus(upper) * rounding;
        eq1_below_voigt += parallel * rounding < voigt;
    }
    // Eq. 1 is no bound: it lies above the rigorous upper bound, and below Voigt's.
    CHECK(eq1_above_hashin_shtrikman > 1000);
    CHECK(eq1_below_voigt > 9000);
}

TEST_CASE("Eq. 1 can also lie below the rigorous upper bound") {
    // Cork and rubber: two phases of the same E whose Poisson ratios differ stiffen each other.
    const std::array v{0.5, 0.5};
    const std::array e{90e9, 90e9};
    const std::array phases{isotropic_moduli(90e9, -0.2), isotropic_moduli(90e9, 0.45)};
    CHECK(parallel_young_modulus(v, e) == 90e9);
    CHECK(young_modulus(hashin_shtrikman_lower(v, phases)) > 90.5e9);
    CHECK(young_modulus(voigt_moduli(v, phases)) > young_modulus(hashin_shtrikman_upper(v, phases)));
}

TEST_CASE("an amorphous part that the file states is not replaced by another statement") {
    Analysis analysis{.phases = crystalline};
    analysis.state_amorphous(AmorphousFraction{.value = 0.4});
    CHECK(contains(input_error_of([&] { analysis.state_amorphous(CrystallineTotal{.value = 0.5}); }),
                   "it is stated again"));
    CHECK(std::get<AmorphousFraction>(analysis.amorphous).value == 0.4);
}

}  // namespace ashimpact::test
