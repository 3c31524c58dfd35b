// SPDX-License-Identifier: GPL-3.0-or-later
// Random parameter sets over twelve decades. ASHIMPACT_WHOLE: a million of them, or its value;
// ASHIMPACT_SEED: others; ASHIMPACT_CASE: only those whose names have this in them, such as "dmt, constant".
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "solver/batch/batch.hpp"
#include "solver/batch/kernels/kernel.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/scale.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::test {

namespace {

/// What was found among random parameter sets.
struct NumbersReport {
    std::int64_t impacts = 0;
    std::int64_t rebounds = 0;
    std::int64_t captures = 0;
    std::map<std::string, std::int64_t> refusals;  ///< typed errors by their text without numbers
    std::int64_t wrong = 0;
    std::map<std::string, std::pair<std::int64_t, std::string>> findings;  ///< how often, and one such impact

    void find(const std::string& what, const Impact& impact) {
        ++wrong;
        auto& [count, example] = findings[what];
        if (++count > 1) return;
        example = describe(impact);
        MESSAGE("found: " << what << "; " << example);  // at once: a whole run takes more than an hour
    }
};

/// Message of an error without its numbers, so that equal ones can be counted.
std::string without_numbers(const std::string& message) {
    std::string kind;
    for (const char c : message)
        if (std::string("0123456789.+-").find(c) == std::string::npos) kind += c;
    return kind.substr(0, 80);
}

Impact random_impact(const ContactCase& c, Random& random) {
    ContactPair pair{.mass = random.log_uniform(1e-18, 1e-6),
                     .effective_radius = random.log_uniform(1e-10, 1e2),
                     .contact_modulus = random.log_uniform(1e3, 1e15),
                     .work_of_adhesion = random.below(8) == 0 ? 0.0 : random.log_uniform(1e-9, 1e3)};
    const double velocity = random.log_uniform(1e-6, 1e6);
    // Half of the impacts lie where adhesion matters as much as inertia.
    if (pair.work_of_adhesion > 0.0 && random.below(2) == 0) {
        const Scale scale = Scale::of(pair, velocity);
        const double number = Jkr<double>::adhesion_number(pair, scale.length);
        const double wanted = random.log_uniform(1e-4, 10.0);
        pair.work_of_adhesion *= (wanted / number) * (wanted / number);
    }
    pair.parameters = parameters_like(pair.work_of_adhesion);
    const double damping = random.below(10) == 0  ? 0.0
                           : random.below(2) == 0 ? random.uniform(0.0, 2.5)
                                                  : random.log_uniform(1e-8, 1e12);
    ContactCase yielding = c;
    if (std::isfinite(c.yield_pressure)) {
        const Scale scale = Scale::of(pair, velocity);
        const double contact = std::sqrt(scale.length / pair.effective_radius) * pair.contact_modulus;
        yielding.yield_pressure =
            contact * (random.below(2) == 0 ? random.log_uniform(1e-2, 3.0) : random.log_uniform(1e-8, 1e4));
    }
    return impact_of(yielding, pair, damping, velocity);
}

/// What the scalar solver makes of an impact: a result, or why there is none.
struct Solved {
    std::optional<ImpactResult> result;
    std::optional<double> in_double;  ///< restitution in double precision
    std::vector<std::string> refusals;
    std::vector<std::string> findings;
};

template <typename Solve>
auto attempt(const std::string& precision, Solved& solved, const Solve& solve)
    -> std::optional<decltype(solve())> {
    try {
        return solve();
    } catch (const ConvergenceError& error) {
        solved.refusals.push_back(precision + "ConvergenceError: " + without_numbers(error.what()));
    } catch (const InputError& error) {
        solved.refusals.push_back(precision + "InputError: " + without_numbers(error.what()));
    } catch (const std::exception& error) {
        solved.findings.push_back(precision + "an error that is no refusal: " + error.what());
    }
    return std::nullopt;
}

Solved solve(const Impact& impact) {
    Solved solved;
    solved.result = attempt("", solved, [&] { return solve_impact(impact); });
    if (solved.result) solved.in_double = attempt("double: ", solved, [&] { return restitution_of(impact); });
    return solved;
}

/// What must hold of any result by itself.
void check_result(const Impact& impact, const ImpactResult& r, NumbersReport& report) {
    const bool rebound = r.outcome == Outcome::rebound;
    const auto check = [&](bool holds, const char* what) {
        if (!holds) report.find(what, impact);
    };
    check(std::isfinite(r.restitution) && r.restitution >= 0.0 && r.restitution <= 1.0, "0 <= e <= 1");
    check(rebound == (r.restitution > 0.0), "a capture has restitution 0, a rebound more");
    check(r.contact_time.has_value() == rebound, "a rebound has a contact time");
    check(!r.contact_time || (std::isfinite(*r.contact_time) && *r.contact_time > 0.0), "contact time > 0");
    check(!r.approach_time || (std::isfinite(*r.approach_time) && *r.approach_time > 0.0),
          "approach time > 0");
    check(!rebound || (r.approach_time && *r.approach_time < *r.contact_time),
          "the turn comes before detachment");
    check(std::isfinite(r.maximum_overlap) && r.maximum_overlap > 0.0, "greatest overlap > 0");
    const EnergyLedger& energy = r.energy;
    const double size = std::max(
        {energy.incident, std::abs(energy.minimum), std::abs(energy.at_touch), std::abs(energy.plastic)});
    for (const double entry : {energy.incident, energy.remaining, energy.at_touch, energy.potential,
                               energy.dissipated, energy.plastic, energy.residual, energy.minimum})
        check(std::isfinite(entry), "the ledger is finite");
    check(std::abs(energy.residual) <= 1e-9 * size, "the ledger closes");
    check(energy.dissipated >= -1e-12 * size, "damping takes energy");
}

/// Whether a contest between e = 0 and e > 0, or between two restitutions, is one of rounding.
double conditioning_of(const ImpactResult& reference) {
    return 1.0 + std::abs(reference.energy.minimum) / reference.energy.incident;
}

struct Many {
    std::vector<Impact> impacts;
    std::vector<ImpactResult> references;
};

ImpactBatchResult solve_batch(const Many& many, const BatchOptions& options) {
    const auto size = static_cast<Eigen::Index>(many.impacts.size());
    Eigen::ArrayXd columns[7];
    for (Eigen::ArrayXd& column : columns) column.resize(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const Impact& impact = many.impacts[static_cast<std::size_t>(i)];
        columns[0][i] = impact.contact.mass;
        columns[1][i] = impact.contact.effective_radius;
        columns[2][i] = impact.contact.contact_modulus;
        columns[3][i] = impact.contact.work_of_adhesion;
        columns[4][i] = impact.contact.yield_pressure;
        columns[5][i] = impact.damping.coefficient;
        columns[6][i] = impact.velocity;
    }
    const Impact& one = many.impacts.front();
    std::map<std::string_view, Eigen::ArrayXd> values;
    std::vector<ParameterColumn> parameters;
    for (const auto& [name, value] : one.contact.parameters) values[name].resize(size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (const auto& [name, value] : many.impacts[static_cast<std::size_t>(i)].contact.parameters)
            values[name][i] = value;
    parameters.reserve(values.size());
    for (const auto& [name, column] : values) parameters.push_back({name, column});
    const ImpactBatch batch{
        one.law,         one.detachment,
        one.damping.law, {columns[0], columns[1], columns[2], columns[3], columns[4], parameters},
        columns[5],      columns[6]};
    return solve_impacts(batch, options);
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

void check_batches(const Many& many, NumbersReport& report) {
    if (many.impacts.empty()) return;
    const ImpactBatchResult plain = solve_batch(many, {.threads = 0, .turning_point = false});
    const ImpactBatchResult turning = solve_batch(many, {.threads = 0, .turning_point = true});
    const ImpactBatchResult table =
        solve_batch(many, {.threads = 0,
                           .turning_point = false,
                           .method = method_of_many(many.impacts[0].law, many.impacts[0].damping.law)});
    for (std::size_t i = 0; i < many.impacts.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const Impact& impact = many.impacts[i];
        const ImpactResult& reference = many.references[i];
        const double conditioning = conditioning_of(reference);
        const double bound = (impact.law.has_cohesive_zone() ? 1e-9 : 2e-12) * conditioning;
        for (const auto* batch : {&plain, &table}) {
            const std::string name = batch == &plain ? "batch: " : "table: ";
            const double e = batch->restitution[at];
            const double difference = std::abs(e * e - reference.restitution * reference.restitution);
            if (!(difference <= bound)) report.find(name + "another restitution", impact);
            const bool rebound = batch->outcome[at] == Outcome::rebound;
            // Next to capture, e^2 within rounding of 0, either outcome is right.
            const bool decided = std::max(difference, std::pow(reference.restitution, 2)) > bound;
            if (rebound != (reference.outcome == Outcome::rebound) && decided)
                report.find(name + "another outcome", impact);
            if (rebound != (e > 0.0) || !(e >= 0.0 && e <= 1.0)) report.find(name + "impossible e", impact);
            if (rebound ? !(batch->contact_time[at] > 0.0) : !std::isnan(batch->contact_time[at]))
                report.find(name + "impossible contact time", impact);
        }
        if (!same_bits(plain.restitution[at], turning.restitution[at]) ||
            !same_bits(plain.contact_time[at], turning.contact_time[at]))
            report.find("asking for the turning point changes the rest", impact);
        if (!(std::abs(turning.maximum_overlap[at] / reference.maximum_overlap - 1.0) <= 1e-8))
            report.find("batch: greatest overlap", impact);
        const bool turns = reference.approach_time.has_value();
        if (turns ? !(std::abs(turning.approach_time[at] / *reference.approach_time - 1.0) <= 1e-6)
                  : !std::isnan(turning.approach_time[at]))
            report.find("batch: approach time", impact);
    }
}

/// Checks @p count random impacts of a case. Each input varies over twelve decades, damping and adhesion from
/// nothing to far beyond what captures everything. Each impact is solved in extended precision, in double
/// precision, in a batch with and without turning points, and from a table. All have to agree, or the scalar
/// solver refuses with a typed error. Batches of a law without kernels get one impact of eight.
void check_random_impacts(const ContactCase& c, std::size_t count, Random& random, NumbersReport& report) {
    std::vector<Impact> impacts;
    for (std::size_t i = 0; i < count; ++i) impacts.push_back(random_impact(c, random));
    std::vector<Solved> all(count);
    batch::for_each_item(count, [&](std::size_t i) { all[i] = solve(impacts[i]); });

    // Where a law has no kernels, a batch calls the scalar solver again: one impact of eight shows that.
    const std::size_t batch_every = batch::has_kernels(c.law, c.damping_law) ? 1 : 8;
    Many many;
    for (std::size_t i = 0; i < count; ++i) {
        ++report.impacts;
        for (const std::string& refusal : all[i].refusals) ++report.refusals[refusal];
        for (const std::string& finding : all[i].findings) report.find(finding, impacts[i]);
        if (!all[i].result) continue;
        const ImpactResult& reference = *all[i].result;
        (reference.outcome == Outcome::rebound ? report.rebounds : report.captures) += 1;
        check_result(impacts[i], reference, report);
        if (const std::optional<double> e = all[i].in_double) {
            const double difference = std::abs(*e * *e - std::pow(reference.restitution, 2));
            if (!(difference <= 1e-10 * conditioning_of(reference)))
                report.find("double precision", impacts[i]);
        }
        if (i % batch_every != 0) continue;
        many.impacts.push_back(impacts[i]);
        many.references.push_back(reference);
    }
    check_batches(many, report);
}

std::size_t wanted_sets() {
    constexpr std::size_t whole = 1'000'000;
    const char* text = std::getenv("ASHIMPACT_WHOLE");
    if (text == nullptr) return static_cast<std::size_t>(repetitions(3'000));
    const auto number = std::strtoull(text, nullptr, 10);
    return number > 1 ? number : whole;
}

double share_of(const ContactCase& c) {
    return method_of_many(c.law, c.damping_law) == BatchMethod::table ? 1.0 : 0.25;
}

}  // namespace

TEST_CASE("random parameter sets: scalar, double, batch and table agree, or a typed refusal") {
    const char* seed_text = std::getenv("ASHIMPACT_SEED");
    const std::uint64_t seed = seed_text != nullptr ? std::strtoull(seed_text, nullptr, 10) : 1;
    const char* chosen = std::getenv("ASHIMPACT_CASE");
    NumbersReport report;
    const std::vector<ContactCase> cases = contact_cases();
    // Impacts of laws without tables take hundreds of times as long: a quarter as many of them.
    double shares = 0.0;
    for (const ContactCase& c : cases) shares += share_of(c);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const ContactCase& c = cases[i];
        if (chosen != nullptr && name_of(c).find(chosen) == std::string::npos) continue;
        Random random(seed * cases.size() + i);  // the same sets of a case whatever else is asked for
        const auto sets =
            static_cast<std::size_t>(std::ceil(static_cast<double>(wanted_sets()) * share_of(c) / shares));
        check_random_impacts(c, sets, random, report);
        MESSAGE(name_of(c) << ": " << sets << ", wrong so far: " << report.wrong);
        std::fflush(stdout);  // a whole run takes an hour
    }
    for (const auto& [what, found] : report.findings)
        MESSAGE(found.first << " x " << what << "; " << found.second);
    for (const auto& [what, count] : report.refusals) MESSAGE(count << " x " << what);
    MESSAGE(report.impacts << " impacts: " << report.rebounds << " rebounds, " << report.captures
                           << " captures, " << report.wrong << " wrong");
    CHECK(report.wrong == 0);
    CHECK(report.rebounds > report.impacts / 5);
    CHECK(report.captures > report.impacts / 10);
}

}  // namespace ashimpact::test
