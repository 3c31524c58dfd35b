// SPDX-License-Identifier: GPL-3.0-or-later
// How often the estimate of v_c and the paper's extrapolation are said to disagree where the truth is the
// extrapolated polynomial, how often an extrapolation finds no fit, and how often its fit is refused because
// it begins above clear rebounds; docs/uncertainty.md.
//     fit_study [REPETITIONS [LAW]]    200 repetitions by default
// A disagreement is false if the interval of the extrapolation holds the true v_c. A refusal is false if the
// v_c of the fit lies within a factor of 1.5 of the true one. The exit status is 1 if, beyond chance, more
// than 5 % of the laboratories disagree falsely, more than 2 % of the robust fits are refused falsely, or
// more than 2 % of the laboratories with 12 impacts or more have no robust fit.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/text/error.hpp"
#include "solver/contact/law.hpp"
#include "solver/inference/measured_damping.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "tests/studies/laboratory.hpp"

using namespace ashimpact;

namespace {

struct Tally {
    unsigned done = 0;
    unsigned disagree = 0;
    unsigned disagree_falsely = 0;
    unsigned refused = 0;
    unsigned refused_falsely = 0;
    unsigned no_fit = 0;

    void take(const ContactModel& model, const MeasurementSet& set, bool robust, double truth) {
        ++done;
        MeasuredDampingOptions options;
        options.extrapolated.robust = robust;
        const MeasuredDamping result = analyse_impacts(model, set, options);
        if (!result.extrapolated) take_refused(model, result, options.extrapolated, truth);
        if (!result.comparison || result.comparison->consistent) return;
        ++disagree;
        const Interval& v = result.extrapolated->critical_velocity;
        disagree_falsely += v.lower.value_or(0.0) <= truth && v.upper.value_or(truth) >= truth ? 1U : 0U;
    }

    [[nodiscard]] bool is_more_than(unsigned count, double share) const {
        return gsl::binomial_probability(done - count, 1.0 - share, done) < 1e-3;
    }

  private:
    void take_refused(const ContactModel& model, const MeasuredDamping& result,
                      const DampingCurveOptions& options, double truth) {
        try {
            if (!result.rising) throw ConvergenceError("no rising branch");
            const double velocity =
                fit_damping_curve(model, result.rising->set, options).critical_velocity.value;
            ++refused;
            refused_falsely += std::abs(std::log(velocity / truth)) < std::log(1.5) ? 1U : 0U;
        } catch (const std::runtime_error&) {
            ++no_fit;
        }
    }
};

bool run(const studies::Row& row, const Law& law, int repetitions) {
    const studies::Laboratories laboratories(row, law);
    const double truth = laboratories.critical_velocity();
    const ContactModel model = studies::model_of(row, law, truth);
    test::Random random(studies::default_seed);
    Tally plain;
    Tally robust;
    for (int i = 0; i < repetitions; ++i) {
        const MeasurementSet set = laboratories.measure(random);
        plain.take(model, set, false, truth);
        robust.take(model, set, true, truth);
    }
    std::printf("| %s | %s |", row.name.c_str(), std::string(law.name()).c_str());
    for (const Tally& tally : {plain, robust})
        for (const unsigned count :
             {tally.disagree, tally.disagree_falsely, tally.refused, tally.refused_falsely, tally.no_fit})
            std::printf(" %.1f %% |", 100.0 * count / tally.done);
    std::puts("");
    std::fflush(stdout);
    const bool few = row.flaw == studies::Flaw::few;
    return !plain.is_more_than(plain.disagree_falsely, 0.05) &&
           !robust.is_more_than(robust.disagree_falsely, 0.05) &&
           !robust.is_more_than(robust.refused_falsely, 0.02) &&
           (few || !robust.is_more_than(robust.no_fit, 0.02));
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const int repetitions =
        words.empty() ? 200 : std::max(1, static_cast<int>(std::strtol(words[0].c_str(), nullptr, 10)));
    std::puts(
        "| truth and file | law | disagree | falsely | refused | falsely | no fit | robust: disagree | "
        "falsely | "
        "refused | falsely | no fit |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|");
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
