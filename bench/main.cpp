// SPDX-License-Identifier: GPL-3.0-or-later
// ./dev bench: one table from one run. What is timed runs on one core, but for the scaling over threads.

#include <cstdio>
#include <functional>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include "bench/dem_rates.hpp"
#include "bench/law_tables.hpp"
#include "bench/machine.hpp"
#include "bench/measured.hpp"
#include "bench/peers.hpp"
#include "bench/population.hpp"
#include "bench/seams.hpp"
#include "bench/size_of_work.hpp"
#include "bench/thread_table.hpp"
#include "bench/tube.hpp"
#include "bench/viscoelastic.hpp"
#include "solver/batch/kernels/kernel.hpp"

namespace ashimpact::bench {

namespace {

/// Solves one by one and keeps the restitutions.
std::function<void()> one_by_one(const Population& population, double (*solver)(const Impact&),
                                 std::vector<double>& out) {
    return [&population, solver, &out] {
        for (Eigen::Index i = 0; i < population.impacts.size(); ++i) {
            out[static_cast<std::size_t>(i)] = solver(population.impacts.at(i));
        }
    };
}

double extended_restitution(const Impact& impact) {
    return solve_impact(impact).restitution;
}

void print_row(const std::string& name, double rate, const Errors& errors, double unit) {
    fmt::print("{:<44}{:>14.0f}{:>12.1e}{:>12.1e}{:>10.2f}\n", name, rate, errors.worst, errors.median,
               rate / unit);
}

/// Impacts/s by GSL rk8pd 1e-10, of DMT with constant damping.
double gsl_rate(const Options& options) {
    const Population few = population(Law::of<Dmt>(), Detachment::zero_overlap, DampingLaw::constant, 512);
    std::vector<double> found(few.restitution.size());
    return rates_of({{"GSL", static_cast<double>(found.size()), one_by_one(few, gsl_rk8pd, found)}}, options)
        .at("GSL");
}

/// The tables of methods: DMT with constant damping, and viscoelastic spheres without adhesion.
void compare_methods(const Options& options) {
    const Population many = population(Law::of<Dmt>(), Detachment::zero_overlap, DampingLaw::constant, 16384);
    const Population few = population(Law::of<Dmt>(), Detachment::zero_overlap, DampingLaw::constant, 512);
    struct Peer {
        std::string name;
        double (*solver)(const Impact&);
        std::vector<double> found{};
    };
    std::vector<Peer> peers{{"ashimpact, scalar, extended precision", extended_restitution},
                            {"ashimpact, scalar, double precision", restitution_of},
                            {"GSL rk8pd 1e-10", gsl_rk8pd},
                            {"Boost.odeint fehlberg78 1e-7", odeint_fehlberg78},
                            {"Boost.odeint dopri5 1e-7", odeint_dopri5},
                            {"velocity Verlet, 200 steps a contact", velocity_verlet}};
    std::vector<Subject> subjects;
    for (Peer& peer : peers) {
        peer.found.resize(few.restitution.size());
        subjects.push_back({peer.name, static_cast<double>(few.restitution.size()),
                            one_by_one(few, peer.solver, peer.found)});
    }
    std::map<std::string, double> rates = rates_of(subjects, options);
    const double unit = rates.at("GSL rk8pd 1e-10");
    fmt::print("\nDMT, constant damping, e >= 0.02{:>26}{:>12}{:>12}{:>10}\n", "impacts/s/core", "worst",
               "median", "/ GSL");
    const auto batch = many.impacts.batch();
    ImpactBatchResult result;
    for (const BatchMethod method : {BatchMethod::table, BatchMethod::integration}) {
        for (const std::string_view set : instruction_sets()) {
            use_instruction_set(set);
            const std::string name = fmt::format("ashimpact, batch, {}, {}",
                                                 method == BatchMethod::table ? "table" : "integrated", set);
            const auto solve = [&] { solve_impacts(batch, result, without_turn(method)); };
            const double rate =
                rates_of({{name, static_cast<double>(many.restitution.size()), solve}}, options).at(name);
            print_row(name, rate, errors_of(result.restitution, many.restitution), unit);
        }
    }
    use_instruction_set({});
    for (const Peer& peer : peers)
        print_row(peer.name, rates.at(peer.name), errors_of(peer.found, few.restitution), unit);
    for (const DemRate& code : dem_rates(options.repetitions))
        print_row(code.name, code.rate, code.errors, unit);
    print_viscoelastic(options, unit);
}

void measure_start_up(const Options& options) {
    const std::vector<std::string> impact{ASHIMPACT_PROGRAM,
                                          "impact",
                                          "--law",
                                          "dmt",
                                          "--radius",
                                          "44 um",
                                          "--density",
                                          "2600 kg/m3",
                                          "--contact-modulus",
                                          "90 GPa",
                                          "--work-of-adhesion",
                                          "0.3 J/m2",
                                          "--damping",
                                          "0.0141 kg/s",
                                          "--velocity",
                                          "2 m/s"};
    const std::vector<std::string> run{ASHIMPACT_PROGRAM, "run", "-o", ASHIMPACT_BENCH_WORK "/run"};
    fmt::print("start to end, wall time on all cores: ashimpact impact {:.1f} ms, ashimpact run {:.0f} ms\n",
               1e3 * start_up_seconds(impact, 4 * options.repetitions + 1),
               1e3 * start_up_seconds(run, options.repetitions));
}

/// The seams alone, for who works on them.
void run_seams(const Options& options) {
    pin_to_one_core();
    print_seams(options);
}

/// The laws of three numbers, for who works on them.
void run_zone(const Options& options) {
    pin_to_one_core();
    const double unit = gsl_rate(options);
    print_laws_of_three_numbers(options, unit);
}

void run(const Options& options) {
    fmt::print("{}; medians of {} repetitions; seconds of CPU time, on one core\n", processor(),
               options.repetitions);
    measure_start_up(options);  // first: this process is small as yet, and quick to fork
    pin_to_one_core();
    const double unit = gsl_rate(options);
    print_tabulated_laws(options, unit);  // while there are no tables
    print_laws_of_three_numbers(options, unit);
    print_single_laws(options, unit);
    compare_methods(options);
    print_integrated_laws(options);
    print_seams(options);
    print_tube(options);
    print_sizes_of_work();
    print_thread_table(options.repetitions);
}

}  // namespace

}  // namespace ashimpact::bench

int main(int argc, char** argv) {
    CLI::App app("Measures ashimpact and its peers in one run");
    ashimpact::bench::Options options;
    app.add_option("--repetitions", options.repetitions, "of every measurement; the median counts")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    app.add_option("--seconds", options.seconds, "least length of a repetition")->capture_default_str();
    bool seams = false;
    bool zone = false;
    app.add_flag("--zone", zone, "only law maugis-dugdale beside GSL");
    app.add_flag("--seams", seams, "only sweep and Python beside a batch");
    CLI11_PARSE(app, argc, argv);
    try {
        if (zone)
            ashimpact::bench::run_zone(options);
        else
            seams ? ashimpact::bench::run_seams(options) : ashimpact::bench::run(options);
    } catch (const std::exception& error) {
        std::cerr << "ashimpact_bench: " << error.what() << '\n';
        return 1;
    }
}
