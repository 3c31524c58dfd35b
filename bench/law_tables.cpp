// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/law_tables.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include "bench/multiply_add.hpp"
#include "bench/population.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/kernels/kernel.hpp"
#include "solver/motion/scale.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::bench {

namespace {

constexpr std::int64_t peak_rounds = 2'000'000;
constexpr Eigen::Index tabulated_impacts = 16384;
constexpr Eigen::Index single_impacts = 512;

std::string name_of(const ImpactBatch& batch) {
    return std::string(batch.law.name()) + ' ' + std::string(ashimpact::name_of(batch.damping_law));
}

/// The impacts of one law and damping law, and how many.
struct LawImpacts {
    const Population& population;
    ImpactBatch batch;
    double count;
};

void for_each_law(const std::function<void(const LawImpacts&)>& measure) {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()}) {
        for (const DampingLaw damping : all_values<DampingLaw>) {
            if (!batch::has_kernels(law, damping)) continue;  // the scalar solver
            const Population many = population(law, law.default_detachment(), damping, tabulated_impacts);
            measure({many, many.impacts.batch(), static_cast<double>(many.restitution.size())});
        }
    }
}

void find_dampings(const LawImpacts& many, BatchMethod method) {
    const ImpactBatch& batch = many.batch;
    const std::vector<double>& found = many.population.restitution;
    const Eigen::ArrayXd restitution = Eigen::Map<const Eigen::ArrayXd>(found.data(), std::ssize(found));
    benchmark::DoNotOptimize(dampings_from_restitutions(
        {batch.law, batch.detachment, batch.damping_law, batch.contact, batch.velocity, restitution}, 1,
        method));
}

/// Counts of operations by "law damping-law", from the program that counts them.
std::map<std::string, double> operation_counts() {
    std::map<std::string, double> counts;
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(ASHIMPACT_OPERATIONS, "r"), pclose);
    char line[128];
    while (pipe && std::fgets(line, sizeof line, pipe.get())) {
        std::istringstream words(line);
        std::string law;
        std::string damping;
        double count = 0.0;
        words >> law >> damping >> count;
        counts[law + ' ' + damping] = count;
    }
    return counts;
}

}  // namespace

void print_integrated_laws(const Options& options) {
    const auto counts = operation_counts();
    const double peak = rates_of({{"multiply-add", static_cast<double>(multiply_adds(peak_rounds)),
                                   [] { multiply_adds(peak_rounds); }}},
                                 options)
                            .at("multiply-add");
    fmt::print("\npeak of the core, measured: {:.2f} G multiply-adds/s\n", peak / 1e9);
    fmt::print("\n{:<30}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "integrated, best set", "impacts/s", "with turn",
               "operations", "% of peak", "dampings/s");
    for_each_law([&](const LawImpacts& many) {
        const auto& [population, batch, count] = many;
        ImpactBatchResult result;
        const auto rates =
            rates_of({{"impacts", count,
                       [&] { solve_impacts(batch, result, without_turn(BatchMethod::integration)); }},
                      {"turn", count, [&] { solve_impacts(batch, result); }},
                      {"dampings", count, [&] { find_dampings(many, BatchMethod::integration); }}},
                     options);
        const std::string name = name_of(batch);
        const double operations = counts.at(name);
        fmt::print("{:<30}{:>12.0f}{:>12.0f}{:>12.0f}{:>12.1f}{:>12.0f}\n", name, rates.at("impacts"),
                   rates.at("turn"), operations, 100.0 * rates.at("impacts") * operations / peak,
                   rates.at("dampings"));
    });
}

void print_tabulated_laws(const Options& options, double unit) {
    fmt::print("\n{:<30}{:>12}{:>12}{:>12}{:>12}{:>12}{:>8}\n", "tables, best set", "impacts/s", "worst",
               "made in, s", "dampings/s", "v_c/s", "/ GSL");
    for_each_law([&](const LawImpacts& many) {
        const auto& [population, batch, count] = many;
        ImpactBatchResult result;
        const auto solve = [&] { solve_impacts(batch, result, without_turn(BatchMethod::table)); };
        const std::clock_t start = std::clock();
        solve();
        const double making = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        const auto rates = rates_of(
            {{"impacts", count, solve},
             {"dampings", count, [&] { find_dampings(many, BatchMethod::table); }},
             {"critical", count,
              [&] {
                  benchmark::DoNotOptimize(critical_velocities(
                      {batch.law, batch.detachment, batch.damping_law, batch.contact, batch.damping}));
              }}},
            options);
        const Errors errors = errors_of(result.restitution, population.restitution);
        fmt::print("{:<30}{:>12.0f}{:>12.1e}{:>12.2f}{:>12.0f}{:>12.0f}{:>8.0f}\n", name_of(batch),
                   rates.at("impacts"), errors.worst, making, rates.at("dampings"), rates.at("critical"),
                   rates.at("impacts") / unit);
    });
}

void print_laws_of_three_numbers(const Options& options, double unit) {
    constexpr Eigen::Index count = 200'000;
    fmt::print("\n{:<30}{:>12}{:>12}{:>12}{:>12}{:>12}{:>12}{:>8}\n", "three numbers, constant", "integrated",
               "table", "worst", "made in, s", "v_c/s", "made in, s", "/ GSL");
    struct Row {
        Law law;
        bool one_size;
    };
    // One size: velocity and damping are even in the logarithm and in the damping number. Many: sizes alone
    // vary.
    for (const auto& [law, one_size] : {Row{Law::of<MaugisDugdale>(), true},
                                        {Law::of<MaugisDugdale>(), false},
                                        {Law::of<ThorntonNing>(), true},
                                        {Law::of<ThorntonNing>(), false}}) {
        test::Random random(61);
        Eigen::ArrayXd radius(count);
        Eigen::ArrayXd mass(count);
        Eigen::ArrayXd velocity = Eigen::ArrayXd::Constant(count, 2.0);
        Eigen::ArrayXd damping(count);
        const Eigen::ArrayXd modulus = Eigen::ArrayXd::Constant(1, 90e9);
        const Eigen::ArrayXd work = Eigen::ArrayXd::Constant(1, 0.3);
        const Eigen::ArrayXd yield = Eigen::ArrayXd::Constant(1, 2e9);
        const Eigen::ArrayXd range = Eigen::ArrayXd::Constant(1, 4e-10);
        for (Eigen::Index i = 0; i < count; ++i) {
            radius[i] = one_size ? 22e-6 : random.log_uniform(2e-6, 50e-6);
            mass[i] = 4.0 / 3.0 * std::numbers::pi * 2600.0 * std::pow(radius[i], 3);
            if (one_size) velocity[i] = random.log_uniform(0.05, 20.0);
            const Scale scale = Scale::of({.mass = mass[i],
                                           .effective_radius = radius[i],
                                           .contact_modulus = modulus[0],
                                           .work_of_adhesion = work[0]},
                                          velocity[i]);
            damping[i] =
                scale.damping_coefficient(DampingLaw::constant, one_size ? random.uniform(0.0, 1.0) : 0.1);
        }
        test::Impacts all{.law = law,
                          .detachment = Detachment::pull_off,
                          .damping_law = DampingLaw::constant,
                          .mass = mass,
                          .effective_radius = radius,
                          .contact_modulus = modulus,
                          .work_of_adhesion = work,
                          .damping = damping,
                          .velocity = velocity,
                          .parameters = {{"cohesion_range", range}}};
        if (law.is_plastic()) all.yield_pressure = yield;
        ImpactBatchResult result;
        const auto solve = [&](BatchMethod method) {
            solve_impacts(all.batch(), result, without_turn(method));
        };
        const auto find_critical = [&] {
            benchmark::DoNotOptimize(critical_velocities(
                {law, Detachment::pull_off, DampingLaw::constant, all.batch().contact, all.damping}));
        };
        const auto seconds_of = [](const auto& work_once) {
            const std::clock_t start = std::clock();
            work_once();
            return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        };
        const double making = seconds_of([&] { solve(BatchMethod::table); });
        const Eigen::ArrayXd read = result.restitution;
        solve(BatchMethod::integration);
        const double worst = (read.square() - result.restitution.square()).abs().maxCoeff();
        const double making_critical = seconds_of(find_critical);
        const auto rates =
            rates_of({{"integrated", static_cast<double>(count), [&] { solve(BatchMethod::integration); }},
                      {"table", static_cast<double>(count), [&] { solve(BatchMethod::table); }},
                      {"critical", static_cast<double>(count), find_critical}},
                     options);
        const std::string name = std::string(law.name()) + (one_size ? ", one size" : ", 4 to 100 um");
        fmt::print("{:<30}{:>12.0f}{:>12.0f}{:>12.1e}{:>12.2f}{:>12.0f}{:>12.2f}{:>8.0f}\n", name,
                   rates.at("integrated"), rates.at("table"), worst, making, rates.at("critical"),
                   making_critical, rates.at("table") / unit);
    }
}

void print_single_laws(const Options& options, double unit) {
    struct Row {
        Law law;
        DampingLaw damping;
        double yield_pressure = std::numeric_limits<double>::infinity();
    };
    fmt::print("\n{:<30}{:>12}{:>12}{:>12}{:>8}\n", "without tables", "impacts/s", "dampings/s", "v_c/s",
               "/ GSL");
    for (const Row& row : {Row{Law::of<Hertz>(), DampingLaw::brach_dunn},
                           {Law::of<Dmt>(), DampingLaw::brach_dunn},
                           {Law::of<BrachDunn>(), DampingLaw::brach_dunn},
                           {Law::of<Jkr>(), DampingLaw::brach_dunn},
                           {Law::of<ThorntonNing>(), DampingLaw::constant, 2e9}}) {
        const bool two_terms = row.damping == DampingLaw::brach_dunn;
        Population some = population(two_terms ? row.law : Law::of<Jkr>(),
                                     two_terms ? row.law.default_detachment() : Detachment::pull_off,
                                     two_terms ? DampingLaw::hunt_crossley : row.damping, single_impacts);
        some.impacts.law = row.law;
        some.impacts.damping_law = row.damping;
        const Eigen::ArrayXd yield_pressure = Eigen::ArrayXd::Constant(1, row.yield_pressure);
        const auto& own = some.impacts;
        const ImpactBatch batch{own.law,
                                own.detachment,
                                own.damping_law,
                                {own.mass, own.effective_radius, own.contact_modulus, own.work_of_adhesion,
                                 yield_pressure, own.batch().contact.parameters},
                                own.damping,
                                own.velocity};
        ImpactBatchResult result;
        solve_impacts(batch, result);
        some.restitution.assign(result.restitution.begin(), result.restitution.end());
        const LawImpacts all{some, batch, static_cast<double>(single_impacts)};
        const auto rates = rates_of(
            {{"impacts", all.count, [&] { solve_impacts(batch, result); }},
             {"dampings", all.count, [&] { find_dampings(all, BatchMethod::integration); }},
             {"critical", all.count,
              [&] {
                  benchmark::DoNotOptimize(critical_velocities(
                      {batch.law, batch.detachment, batch.damping_law, batch.contact, batch.damping}));
              }}},
            options);
        fmt::print("{:<30}{:>12.0f}{:>12.0f}{:>12.0f}{:>8.2f}\n", name_of(batch), rates.at("impacts"),
                   rates.at("dampings"), rates.at("critical"), rates.at("impacts") / unit);
    }
}

}  // namespace ashimpact::bench
