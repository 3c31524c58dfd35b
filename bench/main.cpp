// ./dev bench: one table from one run. What is timed runs on one core, but for the scaling over threads.

#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>

#include "bench/dem_rates.hpp"
#include "bench/machine.hpp"
#include "bench/measured.hpp"
#include "bench/multiply_add.hpp"
#include "bench/peers.hpp"
#include "bench/population.hpp"
#include "bench/thread_table.hpp"
#include "solver/batch/critical_batch.hpp"
#include "solver/batch/instruction_set.hpp"
#include "solver/batch/inversion_batch.hpp"

namespace ashimpact::bench {

namespace {

struct Options {
    int repetitions = 5;
    double seconds = 0.3;
};

constexpr std::int64_t peak_rounds = 2'000'000;

BatchOptions without_turn(BatchMethod method) {
    return {.turning_point = false, .method = method};
}

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

std::vector<double> values(const Eigen::ArrayXd& column) {
    return {column.begin(), column.end()};
}

void print_row(const std::string& name, double rate, const Errors& errors, double unit) {
    fmt::print("{:<44}{:>14.0f}{:>12.1e}{:>12.1e}{:>10.2f}\n", name, rate, errors.worst, errors.median,
               rate / unit);
}

/// The table of methods: DMT with constant damping.
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
    std::map<std::string, double> rates = rates_of(subjects, options.repetitions, options.seconds);
    const double unit = rates.at("GSL rk8pd 1e-10");
    fmt::print("\nDMT, constant damping, e >= 0.02{:>26}{:>12}{:>12}{:>10}\n", "impacts/s/core", "worst",
               "median", "/ GSL");
    const auto batch = many.impacts.batch();
    ImpactBatchResult result;
    for (const BatchMethod method : {BatchMethod::table, BatchMethod::integration}) {
        for (const std::string_view set : instruction_sets()) {
            use_instruction_set(set);
            const std::string name =
                fmt::format("ashimpact, batch, {}, {}", method == BatchMethod::table ? "table" : "integrated", set);
            const auto solve = [&] { solve_impacts(batch, result, without_turn(method)); };
            const double rate = rates_of({{name, static_cast<double>(many.restitution.size()), solve}},
                                         options.repetitions, options.seconds)
                                    .at(name);
            print_row(name, rate, errors_of(values(result.restitution), many.restitution), unit);
        }
    }
    use_instruction_set({});
    for (const Peer& peer : peers)
        print_row(peer.name, rates.at(peer.name), errors_of(peer.found, few.restitution), unit);
    for (const DemRate& code : dem_rates(options.repetitions))
        print_row(code.name, code.rate, code.errors, unit);
}

std::string name_of(const ImpactBatch& batch) {
    return std::string(batch.law.name()) + ' ' + std::string(ashimpact::name_of(batch.damping_law));
}

void for_each_law(const std::function<void(const Population&)>& measure) {
    for (const Law law : {Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()}) {
        for (const DampingName& damping : damping_names) {
            measure(population(law, law.default_detachment(), damping.law, 16384));
        }
    }
}

void find_dampings(const Population& many, BatchMethod method) {
    const ImpactBatch batch = many.impacts.batch();
    const Eigen::ArrayXd restitution =
        Eigen::Map<const Eigen::ArrayXd>(many.restitution.data(), std::ssize(many.restitution));
    benchmark::DoNotOptimize(dampings_from_restitutions({batch.law, batch.detachment, batch.damping_law,
                                                         batch.contact, batch.velocity, restitution},
                                                        1, method));
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

/// Every law, integrated: impacts, what share of the core's peak they take, and dampings.
void compare_laws_integrated(const Options& options) {
    const auto counts = operation_counts();
    const double peak = rates_of({{"multiply-add", static_cast<double>(multiply_adds(peak_rounds)),
                                   [] { multiply_adds(peak_rounds); }}},
                                 options.repetitions, options.seconds)
                            .at("multiply-add");
    fmt::print("\npeak of the core, measured: {:.2f} G multiply-adds/s\n", peak / 1e9);
    fmt::print("\n{:<30}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "integrated, best set", "impacts/s", "with turn",
               "operations", "% of peak", "dampings/s");
    for_each_law([&](const Population& many) {
        const ImpactBatch batch = many.impacts.batch();
        const auto count = static_cast<double>(many.restitution.size());
        ImpactBatchResult result;
        const auto rates = rates_of(
            {{"impacts", count, [&] { solve_impacts(batch, result, without_turn(BatchMethod::integration)); }},
             {"turn", count, [&] { solve_impacts(batch, result); }},
             {"dampings", count, [&] { find_dampings(many, BatchMethod::integration); }}},
            options.repetitions, options.seconds);
        const std::string name = name_of(batch);
        const double operations = counts.at(name);
        fmt::print("{:<30}{:>12.0f}{:>12.0f}{:>12.0f}{:>12.1f}{:>12.0f}\n", name, rates.at("impacts"),
                   rates.at("turn"), operations, 100.0 * rates.at("impacts") * operations / peak,
                   rates.at("dampings"));
    });
}

/// Every law, from tables; what it takes to make those as far as these impacts ask for them.
void compare_laws_tabulated(const Options& options) {
    fmt::print("\n{:<30}{:>12}{:>12}{:>12}{:>12}{:>12}\n", "tables, best set", "impacts/s", "worst",
               "making it, s", "dampings/s", "v_c/s");
    for_each_law([&](const Population& many) {
        const ImpactBatch batch = many.impacts.batch();
        const auto count = static_cast<double>(many.restitution.size());
        ImpactBatchResult result;
        const auto solve = [&] { solve_impacts(batch, result, without_turn(BatchMethod::table)); };
        const std::clock_t start = std::clock();
        solve();
        const double making = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        const auto rates =
            rates_of({{"impacts", count, solve},
                      {"dampings", count, [&] { find_dampings(many, BatchMethod::table); }},
                      {"critical", count,
                       [&] {
                           benchmark::DoNotOptimize(
                               critical_velocities({batch.law, batch.detachment, batch.damping_law,
                                                    batch.contact, batch.damping}));
                       }}},
                     options.repetitions, options.seconds);
        const Errors errors = errors_of(values(result.restitution), many.restitution);
        fmt::print("{:<30}{:>12.0f}{:>12.1e}{:>12.2f}{:>12.0f}{:>12.0f}\n", name_of(batch), rates.at("impacts"),
                   errors.worst, making, rates.at("dampings"), rates.at("critical"));
    });
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
    fmt::print("start to end: ashimpact impact {:.1f} ms, ashimpact run {:.0f} ms\n",
               1e3 * start_up_seconds(impact, 4 * options.repetitions + 1),
               1e3 * start_up_seconds(run, options.repetitions));
}

void run(const Options& options) {
    pin_to_one_core();
    fmt::print("{}; medians of {} repetitions; seconds of CPU time, on one core\n", processor(),
               options.repetitions);
    compare_laws_tabulated(options);  // first, while there are no tables
    compare_methods(options);
    compare_laws_integrated(options);
    measure_start_up(options);
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
    CLI11_PARSE(app, argc, argv);
    try {
        ashimpact::bench::run(options);
    } catch (const std::exception& error) {
        std::cerr << "ashimpact_bench: " << error.what() << '\n';
        return 1;
    }
}
