// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/block.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pipeline/app/sweep/sweep.hpp"
#include "pipeline/files/file.hpp"

namespace ashimpact {

namespace {

using Columns = std::vector<std::vector<double>>;

/// Merges sums, or lists of them element by element; an empty list becomes a copy of the other.
template <class Sums>
void merge_sums(Sums& sums, const Sums& others) {
    if constexpr (std::is_arithmetic_v<Sums>) {
        sums += others;
    } else if constexpr (requires { sums.merge(others); }) {
        sums.merge(others);
    } else {
        if (sums.empty()) sums.resize(others.size());
        for (std::size_t i = 0; i < others.size(); ++i) merge_sums(sums[i], others[i]);
    }
}

/// One chunk while it is computed. Impacts are stored in blocks of one impact per point: the sample a. With
/// sensitivity (Saltelli et al. 2010) the blocks are a, b, and for each variable a with that variable from b.
class Chunk {
  public:
    /// @param memory buffer that successive chunks reuse
    Chunk(const SweepPlan& plan, std::uint64_t number, Columns& memory)
        : plan_(plan),
          number_(number),
          points_(plan.points_in(number)),
          first_(plan.first_point(number)),
          variables_(memory) {
        variables_.resize(plan.design().variables());
        for (std::size_t variable = 0; variable < variables_.size(); ++variable) {
            variables_[variable].resize(impact_count());
            fill(variable, variables_[variable]);
        }
    }

    void compute(const ImpactSolver& solver, BlockResult& into) {
        const SweepSpec& spec = plan_.spec();
        const ImpactColumns impacts(spec, variables_, impact_count());
        Columns table = spec.table.empty() ? Columns{} : variables_;
        into.sums.laws.resize(spec.laws.size());
        into.counts.resize(spec.laws.size());
        into.failed.counts.resize(spec.laws.size());
        for (std::size_t i = 0; i < spec.laws.size(); ++i) {
            const ImpactModel model{spec.laws[i].law, spec.laws[i].detachment, spec.damping_law};
            const ResultColumns results = solver(model, impacts, plan_.wanted(model.law));
            add_statistics(results, impacts, into.sums.laws[i], into.counts[i]);
            add_failures(results, i, into.failed);
            for (const Observable observable : spec.table)
                table.push_back(values_of(observable, results, impacts));
        }
        if (!table.empty())
            into.rows = sealed_rows(number_, in_order_of_points(table), plan_.rows_in_chunk());
    }

  private:
    [[nodiscard]] std::size_t impact_count() const { return points_ * plan_.impacts_a_point(); }

    /// Sets the values of a variable in all blocks.
    void fill(std::size_t variable, std::span<double> values) const {
        for (std::size_t sample = 0; sample < plan_.samples_a_point(); ++sample)
            plan_.design().fill(sample, variable, first_, values.subspan(sample * points_, points_));
        for (std::size_t block = plan_.samples_a_point(); block < plan_.impacts_a_point(); ++block) {
            const std::size_t source = block - plan_.samples_a_point() == variable ? 1 : 0;
            for (std::size_t i = 0; i < points_; ++i)
                values[block * points_ + i] = values[source * points_ + i];
        }
    }

    [[nodiscard]] static std::vector<double> values_of(Observable observable, const ResultColumns& results,
                                                       const ImpactColumns& impacts) {
        if (observable == Observable::contact_time) return results.contact_time;
        if (observable == Observable::maximum_overlap) return results.maximum_overlap;
        std::vector<double> values = results.restitution;
        if (observable == Observable::captured)
            for (double& value : values) value = std::isnan(value) ? value : value > 0 ? 0 : 1;
        if (observable == Observable::rebound_velocity)
            for (std::size_t i = 0; i < values.size(); ++i) values[i] *= impacts.velocity[i];
        return values;
    }

    void add_statistics(const ResultColumns& results, const ImpactColumns& impacts, LawSums& sums,
                        std::vector<Histogram>& counts) const {
        for (const ObservableStatistics& each : plan_.spec().statistics) {
            Histogram& histogram = counts.emplace_back();
            std::vector<Moments>& moments = sums.observables.emplace_back(plan_.design().groups());
            if (each.observable == Observable::captured) {
                add_captures(samples_of(results.restitution), moments, histogram);
            } else {
                const std::vector<double> values = values_of(each.observable, results, impacts);
                add_values(samples_of(values), each.bins, moments, histogram);
            }
        }
        for (const Observable observable : plan_.spec().sensitivity)
            sums.sensitivity.push_back(sobol_by_group(values_of(observable, results, impacts)));
    }

    /// The values of the sample a, or a and b, without those of the mixed blocks.
    [[nodiscard]] std::span<const double> samples_of(std::span<const double> values) const {
        return values.first(points_ * plan_.samples_a_point());
    }

    void add_values(std::span<const double> values, const Bins& bins, std::vector<Moments>& moments,
                    Histogram& histogram) const {
        histogram.count(bins, values);
        for (std::size_t block = 0; block < values.size(); block += points_)
            merge_sums(moments,
                       moments_by_group(values.subspan(block, points_), plan_.design().groups(), first_));
    }

    /// Like add_values() for the observable captured: 1 where the restitution is 0, else 0.
    void add_captures(std::span<const double> restitutions, std::vector<Moments>& moments,
                      Histogram& histogram) const {
        for (std::size_t block = 0; block < restitutions.size(); block += points_)
            merge_sums(moments, moments_of_zeros_by_group(restitutions.subspan(block, points_),
                                                          plan_.design().groups(), first_));
        for (const Moments& group : moments) {
            const auto captures =
                static_cast<std::uint64_t>(std::llround(group.mean * static_cast<double>(group.count)));
            histogram.add_ones(captures, group.count - captures);
        }
    }

    void add_failures(const ResultColumns& results, std::size_t law, FailedImpacts& failed) const {
        failed.counts[law] += results.failed.size();
        for (const FailedSolution& each : results.failed) {
            if (failed.listed.size() == FailedImpacts::most_listed) break;
            const std::uint64_t point = first_ + each.place % points_;
            const std::uint64_t row = point * plan_.impacts_a_point() + each.place / points_;
            failed.listed.push_back({law, row, each.reason, each.command});
        }
    }

    /// Sums of each group of points; a point is left out if one of its impacts did not converge.
    [[nodiscard]] std::vector<SobolSums> sobol_by_group(const std::vector<double>& values) const {
        const std::uint32_t groups = plan_.design().groups();
        std::vector<SobolSums> sums;
        for (std::uint32_t group = 0; group < groups; ++group) {
            Columns blocks(plan_.impacts_a_point());
            for (std::size_t i = (group + groups - first_ % groups) % groups; i < points_; i += groups) {
                const auto value = [&](std::size_t block) { return values[block * points_ + i]; };
                bool converged = true;
                for (std::size_t block = 0; block < blocks.size(); ++block)
                    converged = converged && !std::isnan(value(block));
                for (std::size_t block = 0; converged && block < blocks.size(); ++block)
                    blocks[block].push_back(value(block));
            }
            sums.push_back(SobolSums::of({blocks[0], blocks[1], {blocks.begin() + 2, blocks.end()}}));
        }
        return sums;
    }

    /// Reorders columns from block by block to point by point.
    [[nodiscard]] Columns in_order_of_points(const Columns& columns) const {
        const std::size_t blocks = plan_.impacts_a_point();
        Columns ordered;
        for (const auto& column : columns) {
            auto& rows = ordered.emplace_back(column.size());
            for (std::size_t block = 0; block < blocks; ++block)
                for (std::size_t i = 0; i < points_; ++i)
                    rows[i * blocks + block] = column[block * points_ + i];
        }
        return ordered;
    }

    const SweepPlan& plan_;
    std::uint64_t number_;
    std::size_t points_;
    std::uint64_t first_;
    Columns& variables_;
};

/// Impacts of a chunk for one law: at most a millisecond of a fast solver, and the buffers fit the cache.
constexpr std::size_t chunk_impacts = 8192;
constexpr std::uint64_t tabulated_from = 500'000;  ///< points from which making a table saves time

Design design_of(const SweepSpec& spec) {
    return {distributions_of(spec), spec.sampling,
            spec.sensitivity.empty() ? std::size_t{1} : std::size_t{2}};
}

bool has_observable(const SweepSpec& spec, Observable observable) {
    return std::ranges::count(spec.sensitivity, observable) + std::ranges::count(spec.table, observable) +
               std::ranges::count(spec.statistics, observable, &ObservableStatistics::observable) >
           0;
}

}  // namespace

void LawSums::merge(const LawSums& other) {
    merge_sums(observables, other.observables);
    merge_sums(sensitivity, other.sensitivity);
}

void SweepSums::merge(const SweepSums& other) {
    merge_sums(laws, other.laws);
}

std::uint64_t FailedImpacts::total() const {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

void FailedImpacts::merge(const FailedImpacts& other) {
    merge_sums(counts, other.counts);
    for (const Listed& each : other.listed)
        if (listed.size() < most_listed) listed.push_back(each);
}

void SweepProgress::add(const Block& block, BlockResult result) {
    sums.add(std::move(result.sums), block.level);
    merge_sums(counts, result.counts);
    failed.merge(result.failed);
    chunks += block.chunks();
}

BlockResult compute_block(const SweepPlan& plan, const ImpactSolver& solver, const Block& block) {
    SweepProgress progress;
    BlockResult whole;
    Columns memory;
    for (std::uint64_t chunk = block.first; chunk < block.first + block.chunks(); ++chunk) {
        BlockResult part;
        Chunk(plan, chunk, memory).compute(solver, part);
        whole.rows += part.rows;
        progress.add({.first = chunk, .level = 0}, std::move(part));
    }
    whole.sums = progress.sums.total();
    whole.counts = std::move(progress.counts);
    whole.failed = std::move(progress.failed);
    return whole;
}

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

WantedResults SweepPlan::wanted(Law law) const {
    // The method depends on no observable: one more must not change other results.
    const bool many = design_.points() >= tabulated_from;
    return {.contact_time = has_observable(spec(), Observable::contact_time),
            .maximum_overlap = has_observable(spec(), Observable::maximum_overlap),
            .method =
                many ? method_of_many(law, spec().damping_law, design_.points()) : BatchMethod::integration};
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
