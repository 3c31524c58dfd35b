// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/seams.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "bench/machine.hpp"
#include "materials/contact_properties.hpp"
#include "solver/batch/batch.hpp"

namespace ashimpact::bench {

namespace {

constexpr int sweep_samples = 105'000'000;
constexpr int batch_impacts = 1 << 20;

/// The sweep's command; its impacts are those of SweptImpacts.
const char* const sweep_spec = R"({{
    "impact": {{"laws": ["dmt"], "density": "2600 kg/m3", "contact_modulus": "90 GPa",
               "work_of_adhesion": "0.3 J/m2", "damping": "0.002 kg/s"}},
    "variables": {{
        "velocity": {{"distribution": "uniform", "from": "0.5 m/s", "to": "5 m/s"}},
        "radius": {{"distribution": "log-normal", "median": "44 um", "geometric_standard_deviation": 1.5}}}},
    "sampling": {{"method": "random", "samples": {}, "seed": 1}}}})";

/// Impacts drawn as that sweep draws them.
struct SweptImpacts {
    Eigen::ArrayXd mass{batch_impacts};
    Eigen::ArrayXd radius{batch_impacts};
    Eigen::ArrayXd velocity{batch_impacts};
    Eigen::ArrayXd contact_modulus = Eigen::ArrayXd::Constant(1, 90e9);
    Eigen::ArrayXd work_of_adhesion = Eigen::ArrayXd::Constant(1, 0.3);
    Eigen::ArrayXd yield_pressure = Eigen::ArrayXd::Constant(1, std::numeric_limits<double>::infinity());
    Eigen::ArrayXd damping = Eigen::ArrayXd::Constant(1, 0.002);

    SweptImpacts() {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> velocities(0.5, 5.0);
        std::lognormal_distribution<double> radii(std::log(44e-6), std::log(1.5));
        for (Eigen::Index i = 0; i < batch_impacts; ++i) {
            velocity[i] = velocities(random);
            radius[i] = radii(random);
            mass[i] = sphere_mass(radius[i], 2600.0);
        }
    }
    [[nodiscard]] ImpactBatch batch() const {
        return {Law::of<Dmt>(),
                Detachment::zero_overlap,
                DampingLaw::constant,
                {mass, radius, contact_modulus, work_of_adhesion, yield_pressure, {}},
                damping,
                velocity};
    }
};

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Rate of a call that solves the whole batch, median of five.
template <class Solve>
double batch_rate(const Solve& solve) {
    std::vector<double> seconds;
    for (int i = 0; i < 5; ++i) {
        const std::clock_t start = std::clock();
        solve();
        seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return batch_impacts / median(seconds);
}

double sweep_seconds() {
    const double before = children_seconds();
    static_cast<void>(start_up_seconds(
        {ASHIMPACT_PROGRAM, "sweep", "seams-spec.json", "-o", "seams.json", "--threads", "1", "--restart"},
        1));
    return children_seconds() - before;
}

/// Seconds of CPU time of one call from Python, or none where the module is not built.
std::vector<double> python_seconds(const std::string& arrays, int calls) {
    const std::string command = fmt::format("PYTHONPATH='{}' /usr/bin/python3 '{}' '{}' {} 2>/dev/null",
                                            ASHIMPACT_PYTHON_FOLDER, ASHIMPACT_PYTHON_BENCH, arrays, calls);
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::vector<double> seconds;
    for (double each = 0; pipe && std::fscanf(pipe.get(), "%lf", &each) == 1;) seconds.push_back(each);
    return seconds;
}

std::string written(const SweptImpacts& impacts) {
    const std::string name = ASHIMPACT_BENCH_WORK "/seams.bin";
    std::ofstream file(name, std::ios::binary);
    for (const Eigen::ArrayXd* column : {&impacts.mass, &impacts.radius, &impacts.velocity})
        file.write(reinterpret_cast<const char*>(column->data()),
                   static_cast<std::streamsize>(column->size() * sizeof(double)));
    return name;
}

}  // namespace

void print_seams(const Options& options) {
    std::filesystem::create_directories(ASHIMPACT_BENCH_WORK);
    std::ofstream(ASHIMPACT_BENCH_WORK "/seams-spec.json")
        << fmt::format(fmt::runtime(sweep_spec), sweep_samples);
    const SweptImpacts impacts;
    const ImpactBatch batch = impacts.batch();
    const std::string arrays = written(impacts);
    ImpactBatchResult result;
    const auto with_columns = [&](bool contact_time) {
        solve_impacts(batch, result,
                      {.turning_point = false, .contact_time = contact_time, .method = BatchMethod::table});
    };
    with_columns(true);                       // makes the table
    std::vector<double> sweep_ratios;         // to a batch as Python and the command line have it
    std::vector<double> sweep_ratios_by_end;  // to one without contact times
    std::vector<double> sweep_ratios_alone;  // to one that writes restitutions alone, as the sweep's own does
    std::vector<double> python_ratios;
    std::vector<double> rates;
    for (int round = 0; round < 2 * options.repetitions + 1; ++round) {
        const double ends_only = batch_rate([&] { with_columns(false); });
        const double alone = batch_rate([&] {
            solve_impacts(batch, {.restitution = result.restitution.data()},
                          {.turning_point = false, .contact_time = false, .method = BatchMethod::table});
        });
        const double swept = sweep_samples / sweep_seconds();
        rates.push_back(batch_rate([&] { with_columns(true); }));
        sweep_ratios.push_back(swept / rates.back());
        sweep_ratios_by_end.push_back(swept / ends_only);
        sweep_ratios_alone.push_back(swept / alone);
        const std::vector<double> python = python_seconds(arrays, 7);
        if (!python.empty()) python_ratios.push_back(batch_impacts / median(python) / rates.back());
    }
    fmt::print("\n{:<44}{:>14}{:>12}\n", "seams, DMT, one core, medians", "impacts/s", "/ batch");
    const double unit = median(rates);
    fmt::print("{:<44}{:>14.0f}{:>12.2f}\n", "a batch from its table", unit, 1.0);
    if (!python_ratios.empty())
        fmt::print("{:<44}{:>14.0f}{:>12.2f}\n", "ashimpact.impacts of Python", unit * median(python_ratios),
                   median(python_ratios));
    fmt::print("{:<44}{:>14.0f}{:>12.2f}\n", "ashimpact sweep, 105 million samples",
               unit * median(sweep_ratios), median(sweep_ratios));
    fmt::print("{:<44}{:>14}{:>12.2f}\n", "  / a batch without contact times", "",
               median(sweep_ratios_by_end));
    fmt::print("{:<44}{:>14}{:>12.2f}\n", "  / a batch of restitutions alone", "",
               median(sweep_ratios_alone));
}

}  // namespace ashimpact::bench
