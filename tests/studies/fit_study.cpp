// SPDX-License-Identifier: GPL-3.0-or-later
// How often the estimate of v_c and the paper's extrapolation are said to disagree where the truth is the
// extrapolated polynomial, and how often the robust extrapolation finds no fit; docs/uncertainty.md.
//     fit_study [REPETITIONS [LAW]]    200 repetitions by default
// They are said to disagree falsely where the interval of the extrapolation holds the true v_c. Exit status 1
// where more than 5 % are (beyond chance), or more than 2 % of 12 impacts or more have no robust fit.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "solver/contact/law.hpp"
#include "solver/inference/measured_damping.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "tests/studies/laboratory.hpp"

using namespace ashimpact;

namespace {

struct Tally {
    unsigned done = 0;
    unsigned disagree = 0;
    unsigned falsely = 0;  ///< of these: the extrapolation is right
    unsigned no_fit = 0;

    void take(const MeasuredDamping& result, double truth) {
        ++done;
        no_fit += result.extrapolated ? 0U : 1U;
        if (!result.comparison || result.comparison->consistent) return;
        ++disagree;
        const Interval& v = result.extrapolated->critical_velocity;
        falsely += v.lower.value_or(0.0) <= truth && v.upper.value_or(truth) >= truth ? 1U : 0U;
    }

    [[nodiscard]] bool is_more_than(unsigned count, double share) const {
        return gsl::binomial_probability(done - count, 1.0 - share, done) < 1e-3;
    }
};

MeasuredDamping analysed(const ContactModel& model, const MeasurementSet& set, bool robust) {
    MeasuredDampingOptions options;
    options.extrapolated.robust = robust;
    return analyse_impacts(model, set, options);
}

bool run(const studies::Row& row, const Law& law, int repetitions) {
    const studies::Laboratories laboratories(row, law);
    const double truth = laboratories.critical_velocity();
    const ContactModel model = studies::model_of(row, law, truth);
    test::Random random(studies::default_seed);
    Tally plain;
    Tally robust;
    for (int i = 0; i < repetitions; ++i) {
        const MeasurementSet set = laboratories.measure(random);
        plain.take(analysed(model, set, false), truth);
        robust.take(analysed(model, set, true), truth);
    }
    std::printf("| %s | %s |", row.name.c_str(), std::string(law.name()).c_str());
    for (const Tally& tally : {plain, robust})
        for (const unsigned count : {tally.disagree, tally.falsely, tally.no_fit})
            std::printf(" %.1f %% |", 100.0 * count / tally.done);
    std::puts("");
    std::fflush(stdout);
    return !plain.is_more_than(plain.falsely, 0.05) && !robust.is_more_than(robust.falsely, 0.05) &&
           (row.flaw == studies::Flaw::few || !robust.is_more_than(robust.no_fit, 0.02));
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const int repetitions =
        words.empty() ? 200 : std::max(1, static_cast<int>(std::strtol(words[0].c_str(), nullptr, 10)));
    std::puts(
        "| truth and file | law | disagree | falsely | no fit | robust: disagree | falsely | no fit |\n"
        "|---|---|---|---|---|---|---|---|");
    bool good = true;
    for (const studies::Row& row : studies::rows()) {
        constexpr std::array flaws{studies::Flaw::none,         studies::Flaw::camera,
                                   studies::Flaw::nothing_told, studies::Flaw::scatter_of_size,
                                   studies::Flaw::outliers,     studies::Flaw::few};
        if (row.truth.damping != studies::TrueDamping::quadratic_in_restitution ||
            std::ranges::find(flaws, row.flaw) == flaws.end())
            continue;
        for (const Law& law : studies::laws())
            if (words.size() < 2 || law.name() == words[1]) good = run(row, law, repetitions) && good;
    }
    return good ? 0 : 1;
}
