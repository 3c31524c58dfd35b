// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/result_json.hpp"

#include <cmath>

#include "core/json/view.hpp"
#include "core/version.hpp"
#include "pipeline/files/schema_version.hpp"

namespace ashimpact {

namespace {

/// A quantity with its standard uncertainty, where there is one.
Json with_error(double value, Dimension dimension, const std::optional<double>& error) {
    Json json = quantity_json(value, dimension);
    if (error) json["standard_uncertainty"] = *error;
    return json;
}

/// One law's results as JSON.
class LawResult {
  public:
    LawResult(const SweepPlan& plan, const LawSums& sums, const std::vector<Histogram>& counts,
              std::uint64_t failed)
        : plan_(plan), sums_(sums), counts_(counts), failed_(failed) {}

    [[nodiscard]] Json json(const LawChoice& choice) const {
        Json law{{"law", choice.law.name()},
                 {"detachment", name_of(choice.detachment)},
                 {"impacts", counts_.front().total()},
                 {"captured", counts_.front().total() - counts_.front().zeros()},
                 {"not_converged", failed_},
                 {"capture_fraction", with_error(whole(0).mean, Dimension::fraction, error_of_mean(0))},
                 {"observables", Json::array()}};
        for (std::size_t i = 1; i < plan_.spec().statistics.size(); ++i)
            law["observables"].push_back(observable(i));
        if (plan_.with_sensitivity()) law["sensitivity"] = sensitivity();
        return law;
    }

  private:
    /// Moments of an observable over all groups.
    [[nodiscard]] Moments whole(std::size_t i) const {
        Moments moments;
        for (const Moments& group : sums_.observables[i]) moments.merge(group);
        return moments;
    }

    /// Of random points from their variance, of quasi-random ones from the spread of their copies, of a grid
    /// none.
    [[nodiscard]] std::optional<double> error_of_mean(std::size_t i) const {
        if (plan_.spec().sampling.method == SamplingMethod::random) {
            const Moments moments = whole(i);
            if (moments.count < 2) return std::nullopt;
            return std::sqrt(moments.variance() / static_cast<double>(moments.count));
        }
        std::vector<double> means;
        for (const Moments& group : sums_.observables[i])
            if (group.count > 0) means.push_back(group.mean);
        if (means.size() < 2) return std::nullopt;
        return std::sqrt(Moments::of(means).variance() / static_cast<double>(means.size()));
    }

    [[nodiscard]] Json observable(std::size_t i) const {
        const ObservableStatistics& statistics = plan_.spec().statistics[i];
        const Dimension dimension = dimension_of(statistics.observable);
        Json json{{"name", name_of(statistics.observable)},
                  {"of", captures_count(statistics.observable) ? "all impacts" : "rebounds"}};
        add_moments(json, i, dimension);
        const Bins& bins = statistics.bins;
        json["resolution"] = {{"kind", bins.is_relative() ? "relative" : "absolute"},
                              {"value", bins.resolution()},
                              {"unit", "1"}};
        json["quantiles"] = Json::array();
        if (counts_[i].total() == 0) return json;
        for (const double probability : statistics.quantiles) {
            const auto [lower, upper] = counts_[i].quantile(bins, probability);
            json["quantiles"].push_back({{"probability", probability},
                                         {"lower", quantity_json(lower, dimension)},
                                         {"upper", quantity_json(upper, dimension)}});
        }
        json["histogram"] = histogram(counts_[i], bins, dimension);
        return json;
    }

    void add_moments(Json& json, std::size_t i, Dimension dimension) const {
        const Moments moments = whole(i);
        const bool any = moments.count > 0;
        const auto optional = [&](bool there, double value) { return there ? Json(value) : Json(nullptr); };
        const auto quantity = [&](bool there, double value) {
            return there ? quantity_json(value, dimension) : Json(nullptr);
        };
        const bool spread = moments.count > 1 && moments.second > 0;
        json["count"] = moments.count;
        json["mean"] = any ? with_error(moments.mean, dimension, error_of_mean(i)) : Json(nullptr);
        json["standard_deviation"] =
            quantity(moments.count > 1, moments.count > 1 ? std::sqrt(moments.variance()) : 0);
        json["skewness"] = optional(spread, spread ? moments.skewness() : 0);
        json["excess_kurtosis"] = optional(spread, spread ? moments.excess_kurtosis() : 0);
        json["minimum"] = quantity(any, moments.minimum);
        json["maximum"] = quantity(any, moments.maximum);
    }

    static Json histogram(const Histogram& histogram, const Bins& bins, Dimension dimension) {
        std::vector<double> edges;
        if (!histogram.counts().empty())
            for (std::size_t bin = 0; bin <= histogram.counts().size(); ++bin)
                edges.push_back(bins.edge(histogram.first() + static_cast<std::uint32_t>(bin)));
        return {{"zeros", histogram.zeros()},
                {"edges", column_json(edges, dimension)},
                {"counts", histogram.counts()}};
    }

    [[nodiscard]] Json sensitivity() const {
        Json list = Json::array();
        for (std::size_t i = 0; i < plan_.spec().sensitivity.size(); ++i) {
            const auto indices = sobol_indices(sums_.sensitivity[i]);
            Json json{{"of", name_of(plan_.spec().sensitivity[i])}, {"indices", Json::array()}};
            for (std::size_t variable = 0; variable < indices.size(); ++variable)
                json["indices"].push_back({{"variable", name_of(plan_.spec().variables[variable].input)},
                                           {"first", with_error(indices[variable].first, Dimension::fraction,
                                                                indices[variable].first_error)},
                                           {"total", with_error(indices[variable].total, Dimension::fraction,
                                                                indices[variable].total_error)}});
            list.push_back(std::move(json));
        }
        return list;
    }

    const SweepPlan& plan_;
    const LawSums& sums_;
    const std::vector<Histogram>& counts_;
    std::uint64_t failed_;
};

/// The first impacts that did not converge, each with the command that computes it alone.
Json failures_json(const SweepPlan& plan, const FailedImpacts& failed) {
    Json list = Json::array();
    for (const FailedImpacts::Listed& each : failed.listed)
        list.push_back({{"law", plan.spec().laws[each.law].law.name()},
                        {"row", each.row},
                        {"reason", each.reason},
                        {"command", each.command}});
    return {{"count", failed.total()}, {"listed", std::move(list)}};
}

Json citations_of(const SweepPlan& plan) {
    Json citations = Json::array();
    const SamplingMethod method = plan.spec().sampling.method;
    if (method == SamplingMethod::random)
        citations.push_back("Salmon, Moraes, Dror & Shaw 2011, doi 10.1145/2063384.2063405 (random points)");
    if (method == SamplingMethod::quasi_random)
        citations.push_back(
            plan.spec().sampling.sequence == QuasiRandomSequence::sobol
                ? "Joe & Kuo 2008, doi 10.1137/070709359 (quasi-random points)"
                : "Bratley, Fox & Niederreiter 1994, doi 10.1145/198429.198436 (quasi-random points)");
    if (plan.with_sensitivity())
        citations.push_back(
            "Saltelli et al. 2010, doi 10.1016/j.cpc.2009.09.018; Jansen 1999, doi "
            "10.1016/S0010-4655(98)00154-4 (Sobol indices)");
    return citations;
}

}  // namespace

Json sweep_artifact(const SweepPlan& plan, const SweepProgress& progress, const SpecFile& spec) {
    const SweepSums sums = progress.sums.total();
    Json result{{"points", plan.design().points()},
                {"impacts", plan.impacts()},
                {"damping_law", name_of(plan.spec().damping_law)},
                {"laws", Json::array()}};
    for (std::size_t i = 0; i < plan.spec().laws.size(); ++i)
        result["laws"].push_back(
            LawResult(plan, sums.laws[i], progress.counts[i], progress.failed.counts.at(i))
                .json(plan.spec().laws[i]));
    result["not_converged"] = failures_json(plan, progress.failed);
    std::vector<std::string> warnings = plan.spec().warnings;
    if (progress.failed.total() > 0)
        warnings.push_back(std::to_string(progress.failed.total()) + " of " + std::to_string(plan.impacts()) +
                           " impacts did not converge; they are left out, see /result/not_converged");
    return {{"schema", "sweep-result"},
            {"schema_version", schema_version},
            {"stage", "sweep"},
            {"provenance",
             {{"program", "ashimpact"},
              {"version", program_version()},
              {"revision", program_revision()},
              {"inputs", Json::array({{{"file", spec.name}, {"sha256", spec.sha256}}})},
              {"options", parse_json(plan.canonical())}}},
            {"citations", citations_of(plan)},
            {"warnings", warnings},
            {"result", std::move(result)}};
}

}  // namespace ashimpact
