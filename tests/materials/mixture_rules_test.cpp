#include "materials/mixture_rules.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <vector>

#include "materials/error.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

namespace {

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

}  // namespace

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

}  // namespace ashimpact::test
