// Coverage of v_c in laboratories of known truth; see docs/uncertainty.md.
//     critical_velocity_study [REPETITIONS] [ROW] [LAW]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "materials/contact_properties.hpp"
#include "solver/contact/registry.hpp"
#include "solver/uncertainty/curve/headline.hpp"
#include "tests/studies/laboratory.hpp"

using namespace ashimpact;

namespace {

struct Tally {
    int covered = 0, none = 0, above = 0, below = 0, warned = 0, absurd = 0, done = 0;
    std::vector<double> width, ratio;
};

double median(std::vector<double> values) {
    if (values.empty()) return std::nan("");
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

void print_set(const MeasurementSet& set) {
    for (const Measurement& p : set.points) std::printf("%.5g/%.5g ", p.velocity, p.rebound);
    std::printf("\n");
}

Tally tally(const studies::Row& row, const Law& law, int repetitions, bool verbose) {
    const studies::Laboratories laboratories(row, oracles::law_from(std::string(law.name())));
    const double truth = laboratories.critical_velocity();
    const ContactPair ash{.mass = sphere_mass(48e-6, 2158.5), .effective_radius = 48e-6, .contact_modulus = 90e9, .work_of_adhesion = 0.2959};
    const ContactModel model = make_contact_model(law, law.default_detachment(), ash, {0.01 * truth, 100 * truth});
    test::Random random(20130829);
    Tally result;
    for (int i = 0; i < repetitions; ++i) {
        const MeasurementSet set = laboratories.measure(random);
        ++result.done;
        try {
            const auto estimate = estimate_critical_velocity(model, set);
            const Interval& v = estimate.curve.critical_velocity;
            const bool low = v.lower && *v.lower > truth;
            const bool high = v.upper && *v.upper < truth;
            result.above += low;
            result.below += high;
            result.covered += !low && !high;
            const double ratio = v.value / truth;
            result.ratio.push_back(ratio);
            if (ratio > 3.0 || ratio < 1.0 / 3.0) ++result.absurd;
            result.width.push_back((v.upper.value_or(9e9) - v.lower.value_or(0)) / truth);
            if (verbose && (low || high)) {
                std::printf("#%d n=%zu truth %.3f: %.3f (%.3f, %.3f) tau %.2f noise %.3f scatter %.4f: ", i, set.points.size(), truth, v.value, *v.lower, *v.upper, estimate.curve.roughness, estimate.curve.scatter.noise, estimate.curve.scatter.damping);
                print_set(set);
            }
        } catch (const std::exception& e) {
            ++result.none;
            if (verbose) std::printf("#%d none: %s\n", i, e.what());
        }
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    const int repetitions = argc > 1 ? std::atoi(argv[1]) : 1000;
    const std::string only_row = argc > 2 ? argv[2] : "";
    const std::string only_law = argc > 3 ? argv[3] : "";
    const bool verbose = argc > 4;
    std::printf("%-18s %-11s covered  above below none absurd  median ratio  width   direct s\n", "truth and file", "law");
    for (const studies::Row& row : studies::rows()) {
        if (!only_row.empty() && row.name != only_row) continue;
        for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()}) {
            if (!only_law.empty() && law.name() != only_law) continue;
            const auto start = std::chrono::steady_clock::now();
            const Tally t = tally(row, law, repetitions, verbose);
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            std::printf("%-18s %-11s %5.1f %%  %5d %5d %4d %6d  %.3f         %.3f  %.0f\n", row.name.c_str(), std::string(law.name()).c_str(),
                        100.0 * t.covered / t.done, t.above, t.below, t.none, t.absurd, median(t.ratio), median(t.width), seconds);
            std::fflush(stdout);
        }
    }
}
