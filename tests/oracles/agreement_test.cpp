// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "materials/contact_properties.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/oracles/dem/dem_code.hpp"
#include "tests/oracles/time_domain.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::oracles {

namespace {

/// One column of the comparison: anything that can compute impacts. The functions take many impacts at a time
/// because a DEM code is started once for all of them.
struct Column {
    std::string name;
    std::function<bool(const Impact&)> covers;
    std::function<std::vector<OracleResult>(std::span<const Impact>)> impacts;
    std::function<std::vector<bool>(std::span<const Impact>)> rebounds;
};

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

/// One impact and what each oracle that covers it found, in the order of the oracles.
struct ComparedImpact {
    struct Answer {
        std::string column;
        OracleResult result;
    };
    Impact impact;
    std::vector<Answer> answers;
};

/// One set of parameters around its critical velocity.
struct ComparedVerdict {
    struct Answer {
        std::string column;
        bool rebounds_below;  ///< at 0.999 of the critical velocity
        bool rebounds_above;  ///< at 1.001
    };
    Impact impact;
    double critical_velocity;  ///< [m/s]
    std::vector<Answer> answers;
};

/// Integration in time with GSL: every law and detachment.
Column time_domain_oracle() {
    return one_by_one("GSL", time_domain_impact);
}
/// What is put to the test: solve_impact(), which claims a relative 1e-10.
Column solver_under_test() {
    return one_by_one("ashimpact", solved_impact);
}

double solver_critical_velocity(const Impact& impact) {
    return critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact}).value.value();
}

/// All columns; deviations are given from the first. A further column is one more function here.
std::vector<Column> columns() {
    return {time_domain_oracle(), dem_oracle(lammps()), dem_oracle(liggghts()), solver_under_test()};
}

/// The largest relative difference of restitution, contact time and maximum overlap [-].
double deviation(const OracleResult& a, const OracleResult& b) {
    const auto ours = quantities(a);
    const auto theirs = quantities(b);
    double worst = 0;
    for (std::size_t i = 0; i < ours.size(); ++i)
        worst = std::max(worst, test::relative_difference(ours[i].value, theirs[i].value));
    return worst;
}

/// The largest relative error claimed for these [-].
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

/// @param critical_velocity what is put to the test [m/s]
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

/// The comparisons as Markdown tables, deviations from the first oracle.
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

constexpr double agreement = 1e-8;

// docs/verification.md with its tables renewed, in the build directory, to be copied back when it should
// change.
class VerificationPage {
  public:
    VerificationPage() {
        std::ostringstream text;
        text << std::ifstream(ASHIMPACT_VERIFICATION_PAGE).rdbuf();
        text_ = text.str();
    }

    void renew(const std::string& section, const std::string& table) {
        const std::string begin = "<!-- begin " + section + " -->\n";
        const auto start = text_.find(begin);
        const auto end = text_.find("<!-- end " + section + " -->");
        if (start == std::string::npos || end == std::string::npos)
            throw std::runtime_error("docs/verification.md has no section " + section);
        text_.replace(start + begin.size(), end - start - begin.size(), '\n' + table + '\n');
        std::ofstream(ASHIMPACT_VERIFICATION_RENEWED) << text_;
    }

  private:
    std::string text_;
};

VerificationPage& verification_page() {
    static VerificationPage page;
    return page;
}

std::string label(const Impact& impact) {
    std::ostringstream text;
    text << impact.law.name() << " R " << impact.contact.effective_radius << " m " << impact.contact.mass
         << " E* " << impact.contact.contact_modulus << " w " << impact.contact.work_of_adhesion
         << " damping " << impact.damping.coefficient << " v " << impact.velocity;
    return text.str();
}

// Contact that ends where it began, at zero overlap, takes nothing without damping; at zero force it never
// captures.
std::vector<Impact> with_a_critical_velocity(std::vector<Impact> impacts) {
    std::erase_if(impacts, [](const Impact& impact) {
        return impact.detachment == Detachment::zero_force ||
               (impact.detachment == Detachment::zero_overlap && impact.damping.coefficient == 0);
    });
    return impacts;
}

}  // namespace

TEST_CASE("solver and oracles agree on restitution, contact time and maximum overlap") {
    const auto all = columns();
    const auto compared = compare_impacts(all, grid());
    verification_page().renew("impacts", impacts_table(all, compared));
    CHECK(compared.size() >= 30);
    for (const auto& one : compared) {
        CAPTURE(label(one.impact));
        CHECK(one.answers.size() >= 3);
        for (const auto& a : one.answers) {
            CAPTURE(a.column);
            CHECK(a.result.rebound);
            CHECK(claimed_error(a.result) < agreement);
            for (const auto& b : one.answers) {
                CAPTURE(b.column);
                const double difference = deviation(a.result, b.result);
                CHECK(difference < agreement);
                CHECK(difference <= 2 * (claimed_error(a.result) + claimed_error(b.result)));
            }
        }
    }
}

TEST_CASE("solver and oracles agree on capture and rebound around the critical velocity") {
    const auto all = columns();
    const auto compared = compare_verdicts(all, with_a_critical_velocity(grid()), solver_critical_velocity);
    verification_page().renew("verdicts", verdicts_table(all, compared));
    for (const auto& one : compared) {
        CAPTURE(label(one.impact));
        CAPTURE(one.critical_velocity);
        CHECK(one.answers.size() >= 3);
        for (const auto& answer : one.answers) {
            CAPTURE(answer.column);
            CHECK_FALSE(answer.rebounds_below);
            CHECK(answer.rebounds_above);
        }
    }
}

TEST_CASE("the solver agrees with GSL on laws and ends of contact that no DEM code has") {
    const std::vector pair{time_domain_oracle(), solver_under_test()};
    for (const auto& one : compare_impacts(pair, grid_beyond_dem_codes())) {
        const OracleResult& oracle = one.answers.front().result;
        const OracleResult& solver = one.answers.back().result;
        CAPTURE(label(one.impact));
        CHECK(solver.rebound == oracle.rebound);
        CHECK(deviation(solver, oracle) < 1e-10);
    }
}

TEST_CASE("the solver agrees with GSL on the critical velocity") {
    for (const Impact& impact : with_a_critical_velocity(grid_beyond_dem_codes())) {
        CAPTURE(label(impact));
        const double bisected = time_domain_critical_velocity(impact);
        CHECK(test::relative_difference(solver_critical_velocity(impact), bisected) < 1e-9);
    }
}

}  // namespace ashimpact::oracles
