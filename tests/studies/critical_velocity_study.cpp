// SPDX-License-Identifier: GPL-3.0-or-later
// How often the interval of v_c holds in laboratories of known truth; docs/uncertainty.md has the table.
//     critical_velocity_study [REPETITIONS [ROW [LAW [SEED]]]]    the study; 1000 repetitions by default; ""
//     is
//                                                                 every row or law; another seed adds
//                                                                 laboratories
//     critical_velocity_study quick REPETITIONS                   each row with one law, for the tests
// Exit status 1 where a demand is not met.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/text/error.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/numeric/gsl/statistics.hpp"
#include "tests/studies/laboratory.hpp"

using namespace ashimpact;

namespace {

struct Tally {
    unsigned done = 0;
    unsigned covered = 0;
    unsigned above = 0;  ///< the whole interval lies above the truth
    unsigned below = 0;
    unsigned warned = 0;   ///< of the misses
    unsigned doubted = 0;  ///< with a warning, of all
    unsigned silent = 0;   ///< off by more than a factor of 2 without a warning
    unsigned none = 0;     ///< no estimate, of 12 impacts or more
    unsigned few = 0;      ///< no estimate, of fewer
    unsigned absurd = 0;   ///< off by more than a factor of 3
    std::vector<double> width{};
    std::vector<double> ratio{};

    /// Coverage of 90 %, or a warning in nine of ten misses, and no silent factor of 2; a result below by
    /// chance is let pass.
    [[nodiscard]] bool holds() const {
        const bool warns = 10 * warned >= 9 * (above + below);
        return (warns || gsl::binomial_probability(covered, 0.9, done) > 1e-3) && silent == 0 &&
               none <= std::max(1U, done / 50);
    }
    void add(const Tally& other) {
        done += other.done;
        covered += other.covered;
        above += other.above;
        below += other.below;
        warned += other.warned;
        doubted += other.doubted;
        silent += other.silent;
        none += other.none;
        few += other.few;
        absurd += other.absurd;
    }
};

double median(std::vector<double> values) {
    if (values.empty()) return std::nan("");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// @param options what the laboratory states beside its impacts
void take(Tally& tally, const ContactModel& model, const MeasurementSet& set, double truth,
          const EstimateOptions& options) {
    ++tally.done;
    try {
        const auto estimate = estimate_critical_velocity(model, set, options);
        const Interval& v = estimate.curve.critical_velocity;
        const bool above = *v.lower > truth;
        const bool below = *v.upper < truth;
        tally.above += above ? 1U : 0U;
        tally.below += below ? 1U : 0U;
        tally.covered += above || below ? 0U : 1U;
        const bool warns = std::ranges::any_of(
            estimate.findings, [](const Finding& finding) { return finding.severity == Severity::doubt; });
        tally.warned += (above || below) && warns ? 1U : 0U;
        tally.doubted += warns ? 1U : 0U;
        tally.silent += !warns && (v.value > 2.0 * truth || v.value < 0.5 * truth) ? 1U : 0U;
        const double ratio = v.value / truth;
        tally.absurd += ratio > 3.0 || ratio < 1.0 / 3.0 ? 1U : 0U;
        tally.ratio.push_back(ratio);
        tally.width.push_back((*v.upper - *v.lower) / truth);
    } catch (const InputError&) {
        ++(set.points.size() >= 12 ? tally.none : tally.few);
    } catch (const ConvergenceError&) {
        ++(set.points.size() >= 12 ? tally.none : tally.few);
    }
}

Tally run(const studies::Row& row, const Law& law, int repetitions, unsigned long seed) {
    const studies::Laboratories laboratories(row, law);
    const double truth = laboratories.critical_velocity();
    const ContactModel model = studies::model_of(row, law, truth);
    const EstimateOptions options = studies::options_of(row);
    test::Random random(seed);
    Tally tally;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < repetitions; ++i) take(tally, model, laboratories.measure(random), truth, options);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / repetitions;
    std::printf("| %s | %s | %.1f %% | %u | %u | %u | %u | %u | %u | %u | %.3f | %.3f | %.2f |\n",
                row.name.c_str(), std::string(law.name()).c_str(), 100.0 * tally.covered / tally.done,
                tally.above, tally.below, tally.warned, tally.doubted, tally.none + tally.few, tally.silent,
                tally.absurd, median(tally.ratio), median(tally.width), seconds);
    std::fflush(stdout);
    return tally;
}

bool quick(int repetitions) {
    Tally all;
    for (std::size_t i = 0; i < studies::rows().size(); ++i) {
        const studies::Row& row = studies::rows()[i];
        const std::size_t first = row.hertz ? 0 : 1;  // laws() begins with Hertz
        const std::size_t choices = studies::laws().size() - first;
        all.add(run(row, studies::laws()[first + i % choices], repetitions, studies::default_seed));
    }
    return all.holds();
}

bool study(int repetitions, const std::string& only_row, const std::string& only_law, unsigned long seed) {
    bool good = true;
    for (const studies::Row& row : studies::rows()) {
        if (!only_row.empty() && row.name != only_row) continue;
        for (const Law& law : studies::laws())
            if ((only_law.empty() || law.name() == only_law) && (row.hertz || law != Law::of<Hertz>()))
                good = run(row, law, repetitions, seed).holds() && good;
    }
    return good;
}

/// At least one, also where the word is no number.
int repetitions_of(const std::string& word) {
    return std::max(1, static_cast<int>(std::strtol(word.c_str(), nullptr, 10)));
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : std::string{}; };
    std::puts(
        "| truth and file | law | covered | above | below | warned | of all | no estimate | silent factor of "
        "2 | off by 3 | median of "
        "v_c/truth | "
        "median width | s each |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    if (word(0) == "quick") return quick(repetitions_of(word(1))) ? 0 : 1;
    const int repetitions = words.empty() ? 1000 : repetitions_of(word(0));
    const unsigned long seed = word(3).empty() ? studies::default_seed : std::stoul(word(3));
    return study(repetitions, word(1), word(2), seed) ? 0 : 1;
}
