#include "tests/solver/uncertainty/coverage.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <string>

#include "solver/gsl/distribution.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

constexpr unsigned long study_seed = 20130829;  // the day the paper appeared

/// Which fit should cover which truth: the paper's is quadratic, the direct one need not care.
struct Study {
    TrueDamping truth;
    DampingCurveOptions options;
};
constexpr std::array studies{
    Study{TrueDamping::quadratic, extrapolated_fit}, Study{TrueDamping::quadratic, direct_fit},
    Study{TrueDamping::exponential, direct_fit}, Study{TrueDamping::bent, direct_fit}};

const std::array laws{Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()};

/// Whether so few covered that a coverage of at least 92 % would give them once in 1000 times.
bool too_few(int covered, int repetitions) {
    return gsl::binomial_probability(static_cast<unsigned>(covered), 0.92,
                                     static_cast<unsigned>(repetitions)) < 1e-3;
}

}  // namespace

TEST_CASE("intervals of eta_c and v_c cover the truth: all laws, few repetitions") {
    for (const Study& study : studies) {
        Coverage all;
        for (const Law law : laws) {
            const ContactModel model = ash_model(law);
            // A seed for each law: with the same impacts the 80 repetitions would be 20.
            const Coverage c =
                coverage_of(ash_laboratory(model, study.truth), study.options, 20, study_seed + law.index());
            all.repetitions += c.repetitions;
            all.failures += c.failures;
            all.damping_above += c.damping_above;
            all.damping_below += c.damping_below;
            all.velocity += c.velocity;
            CHECK(std::abs(c.bias) < 0.02);
        }
        CAPTURE(name_of(study.truth));
        CAPTURE(study.options.captures);
        CHECK_FALSE(too_few(all.damping(), all.repetitions));
        CHECK_FALSE(too_few(all.velocity, all.repetitions));
        CHECK(all.failures <= 3);
    }
}

TEST_CASE("the bounds of the coverage test can fail") {
    CHECK(too_few(60, 80));
    CHECK_FALSE(too_few(76, 80));
}

// test_uncertainty --no-skip --test-case="coverage study*": some twenty minutes; docs/uncertainty.md has its
// table.
TEST_CASE("coverage study: 1,000 repetitions, all laws" * doctest::skip()) {
    std::puts(
        "law         truth        fit           eta_c    v_c      above  below  none  bias      half width");
    for (const Law law : laws) {
        const ContactModel model = ash_model(law);
        for (const Study& study : studies) {
            const Coverage c =
                coverage_of(ash_laboratory(model, study.truth), study.options, 1000, study_seed);
            const double damping = static_cast<double>(c.damping()) / c.repetitions;
            const double velocity = static_cast<double>(c.velocity) / c.repetitions;
            std::printf("%-11s %-12s %-13s %.3f    %.3f    %-6d %-6d %-5d %+.5f  %.4f\n",
                        std::string(law.name()).c_str(), std::string(name_of(study.truth)).c_str(),
                        study.options.captures ? "direct" : "extrapolated", damping, velocity,
                        c.damping_above, c.damping_below, c.failures, c.bias, c.width);
            std::fflush(stdout);
            CHECK(damping >= 0.92);
            CHECK(damping <= 0.98);
            CHECK(velocity >= 0.92);
            CHECK(velocity <= 0.98);
        }
    }
}
