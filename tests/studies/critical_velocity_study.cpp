// SPDX-License-Identifier: GPL-3.0-or-later
// How often the interval of v_c holds in laboratories of known truth; prints the tables of
// docs/uncertainty.md.
//     critical_velocity_study [REPETITIONS [ROW [LAW [SEED]]]]    the study; "" is every row, or the laws in
//     turn critical_velocity_study files FOLDER                        laboratories that truths.py has
//     written
// Exit status 1 where a demand is not met.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

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
    unsigned none = 0;     ///< no estimate, though the impacts are enough for one
    unsigned few = 0;      ///< no estimate, of too few: is_few()
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
    }
};

/// Whether impacts are fewer than 12, or fewer than five of their rebounds differ: without stated
/// uncertainties these are too few for an estimate.
bool is_few(const MeasurementSet& set) {
    std::set<double> rebounds;
    for (const Measurement& point : set.points)
        if (!point.captured()) rebounds.insert(point.rebound);
    return set.points.size() < 12 || rebounds.size() < 5;
}

double median(std::vector<double> values) {
    if (values.empty()) return std::nan("");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Held (warned of the misses); with a warning; median of v_c over the truth; that of the width.
std::string cells_of(const Tally& tally) {
    const unsigned misses = tally.above + tally.below;
    std::string text = fmt::format("{} of {}", tally.covered, tally.covered + misses);
    if (misses > 0) text += fmt::format(" ({} of {})", tally.warned, misses);
    if (tally.none + tally.few > 0) text += fmt::format(", no estimate {}", tally.none + tally.few);
    if (tally.silent > 0) text += fmt::format(", silent factor of 2: {}", tally.silent);
    return text +
           fmt::format(" | {} | {:.2f} | {:.2f}", tally.doubted, median(tally.ratio), median(tally.width));
}

/// @param options what the laboratory states beside its impacts
/// @param alt factor of the truth up to which the interval may lie
void take(Tally& tally, const ContactModel& model, const MeasurementSet& set, double truth,
          const EstimateOptions& options, double alt = 1.0) {
    ++tally.done;
    try {
        const auto estimate = estimate_critical_velocity(model, set, options);
        const Interval& v = estimate.curve.critical_velocity;
        const bool above = *v.lower > alt * truth;
        const bool below = *v.upper < truth;
        tally.above += above ? 1U : 0U;
        tally.below += below ? 1U : 0U;
        tally.covered += above || below ? 0U : 1U;
        const bool warns = std::ranges::any_of(
            estimate.findings, [](const Finding& finding) { return finding.severity == Severity::doubt; });
        tally.warned += (above || below) && warns ? 1U : 0U;
        tally.doubted += warns ? 1U : 0U;
        tally.silent += !warns && (v.value > 2.0 * alt * truth || v.value < 0.5 * truth) ? 1U : 0U;
        const double ratio = v.value / truth;
        tally.ratio.push_back(ratio);
        tally.width.push_back((*v.upper - *v.lower) / truth);
    } catch (const InputError&) {
        ++(is_few(set) ? tally.few : tally.none);
    } catch (const ConvergenceError&) {
        ++(is_few(set) ? tally.few : tally.none);
    }
}

Tally run(const studies::Row& row, const Law& law, int repetitions, unsigned long seed) {
    const studies::Laboratories laboratories(row, law);
    const double truth = laboratories.critical_velocity();
    const ContactModel model = studies::model_of(row, law, truth);
    const EstimateOptions options = studies::options_of(row);
    test::Random random(seed);
    Tally tally;
    for (int i = 0; i < repetitions; ++i) take(tally, model, laboratories.measure(random), truth, options);
    return tally;
}

/// The laws by which a row is run: of the first row all, of each other one in turn.
std::vector<Law> laws_of(std::size_t row) {
    const auto& all = studies::laws();
    const std::size_t first = studies::rows()[row].hertz ? 0 : 1;  // laws() begins with Hertz
    if (row == 0) return {all.begin() + static_cast<std::ptrdiff_t>(first), all.end()};
    return {all[first + row % (all.size() - first)]};
}

/// @param only_row @param only_law empty: all rows by the laws of laws_of()
bool study(int repetitions, const std::string& only_row, const std::string& only_law, unsigned long seed) {
    constexpr int enough_for_rows = 50;  // fewer laboratories are judged together
    const bool whole = repetitions >= enough_for_rows;
    Tally all;
    bool good = true;
    for (std::size_t i = 0; i < studies::rows().size(); ++i) {
        const studies::Row& row = studies::rows()[i];
        if (!only_row.empty() && row.name != only_row) continue;
        const int count = row.flaw == studies::Flaw::many && !whole ? 1 : repetitions;  // seconds each
        for (const Law& law : only_law.empty() ? laws_of(i) : studies::laws()) {
            if (!only_law.empty() && law.name() != only_law) continue;
            const Tally tally = run(row, law, count, seed);
            std::printf("| %s | `%s` | %s |\n", row.name.c_str(), std::string(law.name()).c_str(),
                        cells_of(tally).c_str());
            std::fflush(stdout);
            all.add(tally);
            good = tally.holds() && good;
        }
    }
    std::printf("In all %u of %u held, %u of the %u misses had a warning.\n", all.covered,
                all.covered + all.above + all.below, all.warned, all.above + all.below);
    return whole ? good : all.holds();
}

/// One laboratory of truths.csv.
struct Listed {
    std::string row, tells, file;
    double truth = 0.0;
    double alt = 1.0;
};

bool study_files(const std::string& folder) {
    std::ifstream table(folder + "/truths.csv");
    std::string line;
    std::getline(table, line);
    std::vector<std::pair<std::string, Tally>> rows;
    while (std::getline(table, line)) {
        std::ranges::replace(line, ',', ' ');
        Listed listed;
        std::istringstream(line) >> listed.row >> listed.tells >> listed.file >> listed.truth >> listed.alt;
        const std::string name = listed.row + " | " + listed.tells;
        if (rows.empty() || rows.back().first != name) rows.emplace_back(name, Tally{});
        std::ifstream file(folder + "/" + listed.file);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        // The estimate does not depend on the contact.
        take(rows.back().second, studies::model_of(studies::rows().front(), Law::of<Dmt>(), listed.truth),
             read_measurements(text, listed.file), listed.truth, {}, listed.alt);
    }
    bool good = !rows.empty();
    for (const auto& [name, tally] : rows) {
        std::printf("| %s | %s |\n", name.c_str(), cells_of(tally).c_str());
        good = tally.holds() && good;
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
    if (word(0) == "files") return study_files(word(1)) ? 0 : 1;
    const int repetitions = words.empty() ? 200 : repetitions_of(word(0));
    const unsigned long seed = word(3).empty() ? studies::default_seed : std::stoul(word(3));
    return study(repetitions, word(1), word(2), seed) ? 0 : 1;
}
