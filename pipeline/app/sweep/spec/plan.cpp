// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/plan.hpp"

#include <algorithm>

#include "pipeline/files/sha256.hpp"

namespace ashimpact {

namespace {

/// Impacts of a chunk and law: a millisecond or less for a fast solver, buffers that stay in the cache.
constexpr std::size_t chunk_impacts = 8192;
constexpr std::uint64_t tabulated_from = 500'000;  ///< points from which a table pays

Design design_of(const SweepSpec& spec) {
    std::vector<Distribution> distributions;
    for (const SweepVariable& variable : spec.variables) distributions.push_back(variable.distribution);
    return {std::move(distributions), spec.sampling,
            spec.sensitivity.empty() ? std::size_t{1} : std::size_t{2}};
}

bool asks_for(const SweepSpec& spec, Observable observable) {
    const auto holds = [&](const std::vector<Observable>& list) {
        return std::find(list.begin(), list.end(), observable) != list.end();
    };
    return holds(spec.sensitivity) || holds(spec.table) ||
           std::any_of(
               spec.statistics.begin(), spec.statistics.end(),
               [&](const ObservableStatistics& statistics) { return statistics.observable == observable; });
}

}  // namespace

SweepPlan::SweepPlan(const std::string& spec_text)
    : loaded_(read_sweep_spec(spec_text)),
      hash_(sha256(loaded_.canonical)),
      design_(design_of(loaded_.spec)),
      chunk_points_(chunk_impacts / impacts_a_point()) {}

std::size_t SweepPlan::impacts_a_point() const {
    return with_sensitivity() ? design_.variables() + 2 : 1;
}

std::size_t SweepPlan::points_in(std::uint64_t chunk) const {
    return std::min<std::uint64_t>(chunk_points_, design_.points() - first_point(chunk));
}

WantedResults SweepPlan::wanted() const {
    // The method depends on nothing that is asked for: asking for more does not change a bit of the rest.
    const bool tabulated = design_.points() >= tabulated_from;
    return {.contact_time = asks_for(spec(), Observable::contact_time),
            .maximum_overlap = asks_for(spec(), Observable::maximum_overlap),
            .method = tabulated ? BatchMethod::table : BatchMethod::integration};
}

std::vector<TableColumn> SweepPlan::table_columns() const {
    std::vector<TableColumn> columns;
    if (spec().table.empty()) return columns;
    for (const SweepVariable& variable : spec().variables)
        columns.push_back({"variables/" + std::string(name_of(variable.input)),
                           std::string(si_unit(dimension_of(variable.input, spec().damping_law))), "input"});
    for (const LawChoice& choice : spec().laws)
        for (const Observable observable : spec().table)
            columns.push_back({std::string(choice.law.name()) + "/" + std::string(name_of(observable)),
                               std::string(si_unit(dimension_of(observable))), description_of(observable)});
    return columns;
}

}  // namespace ashimpact
