// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/viscoelastic.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "bench/law_tables.hpp"
#include "bench/population.hpp"
#include "solver/batch/batch.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact::bench {

namespace {

constexpr double strongest_damping = 14.0;  ///< damping number at which e has fallen to 0.02

/// Viscoelastic impacts as an event-driven code has them: a constant of the pair, and the velocity.
struct Viscoelastic {
    Population population;
    std::vector<double> root_beta;  ///< v* / v^(1/10) of each pair

    explicit Viscoelastic(double most_damping, Eigen::Index count)
        : population(bench::population(Law::of<Hertz>(), Detachment::zero_force, DampingLaw::contact_radius,
                                       count, most_damping)) {
        for (Eigen::Index i = 0; i < population.impacts.size(); ++i) {
            const Impact impact = population.impacts.at(i);
            const double number = Scale::of(impact.contact, impact.velocity).damping_number(impact.damping);
            root_beta.push_back(std::sqrt(number) / std::pow(impact.velocity, 0.1));
        }
    }
    template <double (*approximant)(double)>
    void evaluate(std::vector<double>& out) const {
        out.resize(root_beta.size());
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = approximant(root_beta[i] *
                                 std::pow(population.impacts.velocity[static_cast<Eigen::Index>(i)], 0.1));
    }
    void solve(BatchMethod method, std::vector<double>& out) const {
        thread_local ImpactBatchResult result;
        solve_impacts(population.impacts.batch(), result, without_turn(method));
        out.assign(result.restitution.begin(), result.restitution.end());
    }
};

}  // namespace

double pade_1_4(double x) {
    return (1.0 + 0.501086 * x) / (1.0 + x * (0.501086 + x * (1.15345 + x * (0.577977 + x * 0.532178))));
}

double pade_3_6(double x) {
    const double above = 1.0 + x * (1.07232 + x * (0.574198 + x * 0.141552));
    return above /
           (1.0 +
            x * (1.07232 + x * (1.72765 + x * (1.37842 + x * (1.19449 + x * (0.467273 + x * 0.235585))))));
}

void print_viscoelastic(const Options& options, double unit) {
    const Viscoelastic usual(1.0, 16384);
    const Viscoelastic strong(strongest_damping, 16384);
    using Method = std::function<void(const Viscoelastic&, std::vector<double>&)>;
    const std::vector<std::pair<std::string, Method>> methods{
        {"ashimpact, batch, table", [](const auto& all, auto& out) { all.solve(BatchMethod::table, out); }},
        {"ashimpact, batch, integrated",
         [](const auto& all, auto& out) { all.solve(BatchMethod::integration, out); }},
        {"Pade approximant [1/4]", [](const auto& all, auto& out) { all.template evaluate<pade_1_4>(out); }},
        {"Pade approximant [3/6]", [](const auto& all, auto& out) { all.template evaluate<pade_3_6>(out); }}};
    fmt::print("\nviscoelastic spheres without adhesion       {:>14}{:>12}{:>12}{:>10}{:>16}\n",
               "impacts/s/core", "worst", "median", "/ GSL", "to e = 0.02");
    for (const auto& [name, method] : methods) {
        std::vector<double> found;
        const double count = static_cast<double>(usual.root_beta.size());
        const double rate = rates_of({{name, count, [&] { method(usual, found); }}}, options).at(name);
        const Errors errors = errors_of(found, usual.population.restitution);
        method(strong, found);
        fmt::print("{:<44}{:>14.0f}{:>12.1e}{:>12.1e}{:>10.2f}{:>16.1e}\n", name, rate, errors.worst,
                   errors.median, rate / unit, errors_of(found, strong.population.restitution).worst);
    }
}

}  // namespace ashimpact::bench
