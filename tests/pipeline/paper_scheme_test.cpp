// SPDX-License-Identifier: GPL-3.0-or-later
// Tables 2 to 4 of Dong et al. 2013 by the paper's own steps, in a run.
#include "pipeline/run/comparison/paper_scheme.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <doctest/doctest.h>

#include "core/embedded.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::containing;
using test::relative_difference;

namespace {

Run run_with_step(const char* step) {
    Json document = parse_json(embedded_file("cases/dong2013/case.json").value());
    document = test::with_one_sample(document, {"hertz", "dmt", "brach-dunn", "jkr"});
    if (step != nullptr) document["paper_explicit"] = {{"time_step", step}};
    return read_run(test::computed_from(document));
}

const LawMap<SchemeBesideExact>& schemes_of(const Run& run) {
    return run.comparison.samples[0].paper_explicit;
}

}  // namespace

TEST_CASE("the paper's scheme in a case: of first order, beside the exact values of the run") {
    const Run coarse = run_with_step("1 ns");
    const Run fine = run_with_step("0.5 ns");
    CHECK(std::ranges::distance(schemes_of(run_with_step(nullptr))) == 0);
    REQUIRE(std::ranges::distance(schemes_of(coarse)) == 3);
    CHECK(schemes_of(coarse).find(Law::named("jkr")) == nullptr);
    for (const auto& [law, of] : schemes_of(coarse)) {
        CAPTURE(law.name());
        const SchemeBesideExact& finer = *schemes_of(fine).find(law);
        // What the run has by its own stages: the same rebounds, the same least squares, the same search.
        const LawFit& fit = *coarse.fit.samples[0].laws.find(law);
        for (int power = 0; power < 3; ++power)
            CHECK(relative_difference(of.exact.damping.coefficients[power], fit.damping.coefficients[power]) <
                  1e-9);
        const double exact = coarse.critical_velocity.samples[0].laws.find(law)->velocity->value;
        REQUIRE(of.exact.critical_velocity);
        CHECK(relative_difference(*of.exact.critical_velocity, exact) < 1e-9);
        const double c = fit.critical_damping;
        CHECK((of.scheme.damping.critical_damping() - c) / (finer.scheme.damping.critical_damping() - c) ==
              doctest::Approx(2).epsilon(0.05));
        // Both read the same rebounds, so their critical velocities nearly agree.
        REQUIRE(of.scheme.critical_velocity);
        CHECK(std::abs(*of.scheme.critical_velocity / exact - 1) < 0.01);
    }
    CHECK(comparison_text(coarse.comparison) == containing("By the explicit steps of the paper"));
}

TEST_CASE("a step too long for an impact: a note in place of the scheme's values") {
    const Run run = run_with_step("50 ns");
    CHECK(std::ranges::distance(schemes_of(run)) == 0);
    const StageRecord* record = run.record(comparison_artifact);
    REQUIRE(record != nullptr);
    const auto note = std::ranges::find(record->notes, "no-explicit-scheme", &Note::code);
    REQUIRE(note != record->notes.end());
    CHECK(text_of(*note) == containing("too long for this impact"));
}
