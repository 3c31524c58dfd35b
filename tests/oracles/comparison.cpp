// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/comparison.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/oracles/dem/dem_code.hpp"
#include "tests/oracles/time_domain.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::oracles {

namespace {

Column dem_oracle(const DemCode& code) {
    return {.name = code.name,
            .covers = code.covers,
            .impacts = [code](std::span<const Impact> impacts) { return dem_impacts(code, impacts); },
            .rebounds = [code](std::span<const Impact> impacts) { return dem_rebounds(code, impacts); }};
}

// For what computes an impact within the program.
Column one_by_one(const std::string& name, OracleResult (*compute)(const Impact&)) {
    return {.name = name,
            .covers = [](const Impact&) { return true; },
            .impacts =
                [compute](std::span<const Impact> impacts) {
                    std::vector<OracleResult> results;
                    std::transform(impacts.begin(), impacts.end(), std::back_inserter(results), compute);
                    return results;
                },
            .rebounds =
                [compute](std::span<const Impact> impacts) {
                    std::vector<bool> results;
                    std::transform(impacts.begin(), impacts.end(), std::back_inserter(results),
                                   [compute](const Impact& impact) { return compute(impact).rebound; });
                    return results;
                }};
}

OracleResult solved_impact(const Impact& impact) {
    constexpr double promised = 1e-10;
    const auto estimate = [](double value) { return Estimate{value, promised * value}; };
    const auto result = solve_impact(impact);
    return {.rebound = result.outcome == Outcome::rebound,
            .restitution = estimate(result.restitution),
            .contact_time = estimate(result.contact_time.value_or(0)),
            .maximum_overlap = estimate(result.maximum_overlap)};
}

constexpr double slower = 0.999;
constexpr double faster = 1.001;

std::vector<Impact> covered(const Column& column, std::span<const Impact> impacts) {
    std::vector<Impact> selected;
    std::copy_if(impacts.begin(), impacts.end(), std::back_inserter(selected), column.covers);
    return selected;
}

using Quantities = std::array<Estimate, 3>;

Quantities quantities(const OracleResult& result) {
    return {result.restitution, result.contact_time, result.maximum_overlap};
}

template <std::size_t size, class... Arguments>
std::string formatted(const char (&format)[size], Arguments... arguments) {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), format, arguments...);
    return text.data();
}

std::string parameters(const Impact& impact) {
    return formatted("| %s | %.3g | %.0f | %.3g | %.3g | %.3g ", std::string(impact.law.name()).c_str(),
                     impact.contact.effective_radius * 1e6,
                     impact.contact.mass / sphere_mass(impact.contact.effective_radius, 1),
                     impact.contact.contact_modulus * 1e-9, impact.contact.work_of_adhesion,
                     impact.damping.coefficient);
}

const std::string parameter_headings =
    "| law | R [um] | density [kg/m3] | E* [GPa] | w [J/m2] | damping [kg/s] ";

std::string rule(const std::string& headings) {
    std::string line = "|";
    for (auto i = std::count(headings.begin(), headings.end(), '|'); i > 1; --i) line += "---|";
    return line + '\n';
}

template <class Compared>
const typename Compared::Answer* answer_of(const Column& column, const Compared& compared) {
    for (const auto& answer : compared.answers)
        if (answer.column == column.name) return &answer;
    return nullptr;
}

}  // namespace

Column time_domain_oracle() {
    return one_by_one("GSL", time_domain_impact);
}
Column lammps_oracle() {
    return dem_oracle(lammps());
}
Column liggghts_oracle() {
    return dem_oracle(liggghts());
}
Column solver_under_test() {
    return one_by_one("ashimpact", solved_impact);
}

double solver_critical_velocity(const Impact& impact) {
    return critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value.value();
}

std::vector<Column> columns() {
    return {time_domain_oracle(), lammps_oracle(), liggghts_oracle(), solver_under_test()};
}

bool rebounds(const Column& column, const Impact& impact, double velocity) {
    const Impact moved = at_velocity(impact, velocity);
    return column.rebounds(std::span(&moved, 1)).front();
}

double deviation(const OracleResult& a, const OracleResult& b) {
    const auto ours = quantities(a);
    const auto theirs = quantities(b);
    double worst = 0;
    for (std::size_t i = 0; i < ours.size(); ++i)
        worst = std::max(worst, test::relative_difference(ours[i].value, theirs[i].value));
    return worst;
}

double claimed_error(const OracleResult& result) {
    double worst = 0;
    for (const Estimate& quantity : quantities(result))
        worst = std::max(worst, quantity.error / quantity.value);
    return worst;
}

std::vector<ComparedImpact> compare_impacts(std::span<const Column> columns,
                                            std::span<const Impact> impacts) {
    std::vector<ComparedImpact> compared;
    for (const Impact& impact : impacts) compared.push_back({impact, {}});
    for (const Column& column : columns) {
        const auto results = column.impacts(covered(column, impacts));
        auto result = results.begin();
        for (auto& one : compared)
            if (column.covers(one.impact)) one.answers.push_back({column.name, *result++});
    }
    return compared;
}

std::vector<ComparedVerdict> compare_verdicts(std::span<const Column> columns,
                                              std::span<const Impact> impacts,
                                              const std::function<double(const Impact&)>& critical_velocity) {
    std::vector<ComparedVerdict> compared;
    for (const Impact& impact : impacts) compared.push_back({impact, critical_velocity(impact), {}});
    for (const Column& column : columns) {
        std::vector<Impact> tries;
        for (const auto& one : compared)
            if (column.covers(one.impact))
                for (const double factor : {slower, faster})
                    tries.push_back(at_velocity(one.impact, factor * one.critical_velocity));
        const auto verdicts = column.rebounds(tries);
        std::size_t i = 0;
        for (auto& one : compared) {
            if (!column.covers(one.impact)) continue;
            one.answers.push_back({column.name, verdicts[i], verdicts[i + 1]});
            i += 2;
        }
    }
    return compared;
}

std::string impacts_table(std::span<const Column> columns, std::span<const ComparedImpact> compared) {
    std::string headings = parameter_headings;
    headings += "| v [m/s] | restitution | contact time [ns] | maximum overlap [nm] |";
    for (const Column& column : columns.subspan(1)) headings += ' ' + column.name + " deviates | claims |";
    std::string table = headings + '\n' + rule(headings);
    for (const auto& one : compared) {
        const OracleResult& first = one.answers.front().result;
        table += parameters(one.impact) + formatted("| %.3g | %.9f | %.9g | %.9g |", one.impact.velocity,
                                                    first.restitution.value, first.contact_time.value * 1e9,
                                                    first.maximum_overlap.value * 1e9);
        for (const Column& column : columns.subspan(1)) {
            const auto* answer = answer_of(column, one);
            table += answer ? formatted(" %.0e | %.0e |", deviation(answer->result, first),
                                        claimed_error(answer->result))
                            : " | |";
        }
        table += '\n';
    }
    return table;
}

std::string verdicts_table(std::span<const Column> columns, std::span<const ComparedVerdict> compared) {
    const auto word = [](bool rebound) { return rebound ? "rebound" : "capture"; };
    std::string headings = parameter_headings;
    headings += "| critical velocity [m/s] |";
    for (const Column& column : columns) headings += ' ' + column.name + " |";
    std::string table = headings + '\n' + rule(headings);
    for (const auto& one : compared) {
        table += parameters(one.impact) + formatted("| %.7g |", one.critical_velocity);
        for (const Column& column : columns) {
            const auto* answer = answer_of(column, one);
            table += answer
                         ? formatted(" %s, %s |", word(answer->rebounds_below), word(answer->rebounds_above))
                         : " |";
        }
        table += '\n';
    }
    return table;
}

}  // namespace ashimpact::oracles
