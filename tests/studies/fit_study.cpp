// How often the estimate of v_c and the paper's extrapolation are said to disagree where the truth is the
// extrapolated polynomial, and how often the robust extrapolation finds no fit; docs/uncertainty.md.
//     fit_study [REPETITIONS [LAW]]    200 repetitions by default
// Exit status 1 where more than 5 % are said to disagree (beyond chance), or more than 2 % have no robust
// fit.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "materials/contact_properties.hpp"
#include "solver/contact/registry.hpp"
#include "solver/gsl/distribution.hpp"
#include "solver/uncertainty/measured_damping.hpp"
#include "tests/studies/laboratory.hpp"
#include "tests/studies/model.hpp"

using namespace ashimpact;

namespace {

struct Tally {
    unsigned done = 0;
    unsigned disagree = 0;
    unsigned robust_disagree = 0;
    unsigned no_fit = 0;
    unsigned no_robust_fit = 0;

    [[nodiscard]] bool holds() const {
        const auto more_than = [this](unsigned count, double share) {
            return gsl::binomial_probability(done - count, 1.0 - share, done) < 1e-3;
        };
        return !more_than(std::min(disagree, robust_disagree), 0.05) && !more_than(no_robust_fit, 0.02);
    }
};

MeasuredDamping analysed(const ContactModel& model, const MeasurementSet& set, bool robust) {
    MeasuredDampingOptions options{.propagate = false};
    options.extrapolated.robust = robust;
    return analyse_impacts(model, nullptr, set, options);
}

bool disagree(const MeasuredDamping& result) {
    return result.comparison && result.comparison->exclude_one_another;
}

bool run(const studies::Row& row, const Law& law, int repetitions) {
    const studies::Laboratories laboratories(row, oracles::law_from(std::string(law.name())));
    const ContactModel model = studies::model_of(law, laboratories.critical_velocity());
    test::Random random(studies::default_seed);
    Tally tally;
    for (int i = 0; i < repetitions; ++i) {
        const MeasurementSet set = laboratories.measure(random);
        const MeasuredDamping plain = analysed(model, set, false);
        const MeasuredDamping robust = analysed(model, set, true);
        ++tally.done;
        tally.disagree += disagree(plain) ? 1U : 0U;
        tally.robust_disagree += disagree(robust) ? 1U : 0U;
        tally.no_fit += plain.extrapolated ? 0U : 1U;
        tally.no_robust_fit += robust.extrapolated ? 0U : 1U;
    }
    const auto percent = [&](unsigned count) { return 100.0 * count / tally.done; };
    std::printf("| %s | %s | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", row.name.c_str(),
                std::string(law.name()).c_str(), percent(tally.disagree), percent(tally.robust_disagree),
                percent(tally.no_fit), percent(tally.no_robust_fit));
    std::fflush(stdout);
    return tally.holds();
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const int repetitions = words.empty() ? 200 : std::max(1, std::atoi(words[0].c_str()));
    std::puts(
        "| truth and file | law | disagree | disagree, robust | no fit | no robust fit |\n"
        "|---|---|---|---|---|---|");
    bool good = true;
    for (const studies::Row& row : studies::rows()) {
        if (row.damping != studies::TrueDamping::quadratic_in_restitution) continue;
        for (const Law& law : studies::laws())
            if (words.size() < 2 || law.name() == words[1]) good = run(row, law, repetitions) && good;
    }
    return good ? 0 : 1;
}
