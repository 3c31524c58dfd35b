// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/modulus.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"
#include "materials/mixture_rules.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view modulus_code = "modulus";  // of findings on the modulus

/// Inputs of one evaluation. All are plain numbers, so that results can be differentiated with respect to
/// each.
struct Mixture {
    FractionBasis basis;
    FractionModel model;
    std::vector<double> densities;
    std::vector<double> young_moduli;
    std::vector<double> poisson_ratios;  ///< empty unless every phase has one
    ModulusOptions options;

    [[nodiscard]] std::vector<double> volumes() const {
        const auto fractions = model.fractions();
        return basis == FractionBasis::weight ? volume_fractions(fractions, densities) : fractions;
    }
    [[nodiscard]] bool has_poisson_ratios() const { return !poisson_ratios.empty(); }
};

struct Results {
    std::vector<double> rules;  ///< Young's moduli, dense, in the order of MixtureRule
    PorousModuli chosen;        ///< by the chosen rule, porosity applied
    double density;             ///< dense
};

Results evaluate(const Mixture& mixture) {
    const std::vector<double> v = mixture.volumes();
    const auto& e = mixture.young_moduli;
    Results results{
        .rules = {parallel_young_modulus(v, e), series_young_modulus(v, e), hill_young_modulus(v, e)},
        .chosen = {},
        .density = mixture_density(v, mixture.densities)};
    if (mixture.has_poisson_ratios()) {
        std::vector<IsotropicModuli> phases;
        for (std::size_t i = 0; i < e.size(); ++i)
            phases.push_back(isotropic_moduli(e[i], mixture.poisson_ratios[i]));
        const IsotropicModuli mean = hill_moduli(v, phases);
        for (const IsotropicModuli& moduli :
             {voigt_moduli(v, phases), reuss_moduli(v, phases), mean, hashin_shtrikman_lower(v, phases),
              hashin_shtrikman_upper(v, phases)})
            results.rules.push_back(young_modulus(moduli));
        results.chosen.poisson_ratio = poisson_ratio(mean);
    }
    results.chosen.young_modulus = results.rules.at(static_cast<std::size_t>(mixture.options.rule));
    if (mixture.options.porosity) results.chosen = porous_moduli(results.chosen, *mixture.options.porosity);
    return results;
}

Mixture mixture_of(const Composition& composition, const ModulusOptions& options) {
    Mixture mixture{.basis = composition.basis,
                    .model = composition.model,
                    .densities = {},
                    .young_moduli = {},
                    .poisson_ratios = {},
                    .options = options};
    for (const Component& c : composition.components) {
        mixture.densities.push_back(c.phase.density.value);
        mixture.young_moduli.push_back(c.phase.young_modulus.value);
        if (c.phase.poisson_ratio) mixture.poisson_ratios.push_back(c.phase.poisson_ratio->value);
    }
    if (mixture.poisson_ratios.size() != composition.components.size()) mixture.poisson_ratios.clear();
    return mixture;
}

/// @throws InputError for an invalid porosity, or a rule that needs a Poisson ratio that is not known
Mixture checked_mixture(const Composition& composition, const ModulusOptions& options) {
    if (options.porosity) require_valid(*options.porosity);
    Mixture mixture = mixture_of(composition, options);
    if (options.rule > MixtureRule::hill && !mixture.has_poisson_ratios())
        throw InputError(
            "the rule " + std::string(name_of(options.rule)) + " needs a Poisson ratio for every phase",
            "parallel, series, hill, or Poisson's ratios in the case file");
    return mixture;
}

/// The inputs of a mixture as one list with uncertainties; mixture() is the inverse, from the values.
class MixtureInputs {
  public:
    MixtureInputs(const Composition& composition, const Mixture& mixture) : mixture_(mixture) {
        const auto& components = composition.components;
        const std::string basis = composition.basis == FractionBasis::weight ? "weight" : "volume";
        const FractionModel& model = mixture.model;
        for (std::size_t i = 0; i < model.amounts.size(); ++i)
            add(basis + " fraction of " + components[i].name, model.amounts[i], model.uncertainties[i]);
        add(model.kind == FractionModel::Kind::remainder ? "scale of the internal standard"
                                                         : "amorphous " + basis + " fraction",
            model.parameter, model.parameter_uncertainty);
        for (const Component& c : components)
            add("density of " + c.phase.name, c.phase.density.value, c.phase.density.uncertainty());
        for (const Component& c : components)
            add("Young's modulus of " + c.phase.name, c.phase.young_modulus.value,
                modulus_uncertainty(c.phase));
        if (mixture.has_poisson_ratios())
            for (const Component& c : components)
                add("Poisson's ratio of " + c.phase.name, c.phase.poisson_ratio->value,
                    c.phase.poisson_ratio->uncertainty());
        if (mixture.options.porosity)
            add("porosity", mixture.options.porosity->value, mixture.options.porosity->standard_uncertainty);
    }

    [[nodiscard]] const std::vector<UncertainInput>& list() const { return list_; }

    [[nodiscard]] Mixture mixture(const std::vector<double>& values) const {
        Mixture m = mixture_;
        auto next = values.begin();
        for (double& amount : m.model.amounts) amount = *next++;
        m.model.parameter = *next++;
        for (auto* list : {&m.densities, &m.young_moduli, &m.poisson_ratios})
            for (double& value : *list) value = *next++;
        if (m.options.porosity) m.options.porosity->value = *next++;
        return m;
    }

  private:
    void add(const std::string& what, double value, std::optional<double> uncertainty) {
        list_.push_back({.what = what, .value = value, .standard_uncertainty = uncertainty.value_or(0)});
    }

    Mixture mixture_;
    std::vector<UncertainInput> list_;
};

/// Results as a list: the chosen modulus, the density, then the rules.
std::vector<double> listed(const Results& results) {
    std::vector<double> list{results.chosen.young_modulus, results.density};
    list.insert(list.end(), results.rules.begin(), results.rules.end());
    return list;
}

bool has_assumed_poisson_ratio(const Component& component) {
    return component.phase.poisson_ratio && component.phase.poisson_ratio->assumed;
}

void note_missing(const Composition& composition, std::vector<Finding>& notes) {
    std::vector<std::string> without_uncertainty;
    std::vector<std::string> without_ratio;
    std::vector<std::string> assumed;
    for (const Component& c : composition.components) {
        if (!c.phase.young_modulus.uncertainty()) without_uncertainty.push_back(c.phase.name);
        if (!c.phase.poisson_ratio) without_ratio.push_back(c.phase.name);
        if (has_assumed_poisson_ratio(c)) assumed.push_back(c.phase.name);
    }
    if (!without_uncertainty.empty())
        notes.push_back({modulus_code, Severity::background,
                         "no uncertainty of Young's modulus is known for " + joined(without_uncertainty) +
                             ": " + shortest(100.0 * assumed_modulus_uncertainty) + " % is assumed"});
    if (!without_ratio.empty())
        notes.push_back({modulus_code, Severity::remark,
                         "no Poisson ratio is known for " + joined(without_ratio) +
                             ": the bounds on bulk and shear modulus are left out, and E has no rigorous "
                             "upper bound (the parallel rule is none)"});
    if (!assumed.empty())
        notes.push_back(
            {modulus_code, Severity::background, "the Poisson ratio is assumed for " + joined(assumed)});
}

void note_dominant(const std::vector<Contribution>& contributions, std::vector<Finding>& notes) {
    constexpr double most = 0.5;
    if (contributions.empty() || contributions.front().share <= most) return;
    notes.push_back({modulus_code, Severity::background,
                     contributions.front().what + " gives " +
                         shortest(std::floor(contributions.front().share * 1000) / 10) +
                         " % of the variance of E"});
}

}  // namespace

std::vector<PropagatedUncertainty> propagate_linearly(
    const std::function<std::vector<double>(const std::vector<double>&)>& function,
    const std::vector<UncertainInput>& inputs) {
    constexpr double relative_step = 6e-6;  // cube root of epsilon: least error of a central difference
    std::vector<double> x;
    for (const UncertainInput& input : inputs) x.push_back(input.value);
    std::vector<PropagatedUncertainty> results(function(x).size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double u = inputs[i].standard_uncertainty;
        if (u == 0) continue;
        const double step = relative_step * std::max(std::abs(inputs[i].value), u);
        x[i] = inputs[i].value + step;
        const std::vector<double> above = function(x);
        x[i] = inputs[i].value - step;
        const std::vector<double> below = function(x);
        x[i] = inputs[i].value;
        for (std::size_t k = 0; k < results.size(); ++k) {
            const double change = (above[k] - below[k]) / (2 * step) * u;
            // Variances at first; the loop below divides them by their sum.
            results[k].contributions.push_back({.what = inputs[i].what, .share = change * change});
        }
    }
    for (PropagatedUncertainty& result : results) {
        double variance = 0;
        for (const Contribution& c : result.contributions) variance += c.share;
        result.standard_uncertainty = std::sqrt(variance);
        for (Contribution& c : result.contributions) c.share = variance == 0 ? 0 : c.share / variance;
        std::erase_if(result.contributions, [](const Contribution& c) { return c.share == 0; });
        std::stable_sort(result.contributions.begin(), result.contributions.end(),
                         [](const Contribution& a, const Contribution& b) { return a.share > b.share; });
    }
    return results;
}

std::optional<RuleResult> ModulusEstimate::by(MixtureRule rule) const {
    for (const RuleResult& result : rules)
        if (result.rule == rule) return result;
    return std::nullopt;
}

double modulus_uncertainty(const Phase& phase) {
    return phase.young_modulus.uncertainty().value_or(assumed_modulus_uncertainty *
                                                      phase.young_modulus.value);
}

double young_modulus_of(const Composition& composition, const ModulusOptions& options) {
    return evaluate(checked_mixture(composition, options)).chosen.young_modulus;
}

ModulusEstimate estimate_modulus(const Composition& composition, const ModulusOptions& options) {
    const Mixture mixture = checked_mixture(composition, options);
    const MixtureInputs inputs(composition, mixture);
    const auto function = [&](const std::vector<double>& x) { return listed(evaluate(inputs.mixture(x))); };
    const auto uncertainties = propagate_linearly(function, inputs.list());
    const Results results = evaluate(mixture);

    ModulusEstimate estimate{.young_modulus = results.chosen.young_modulus,
                             .standard_uncertainty = uncertainties[0].standard_uncertainty};
    for (std::size_t i = 0; i < results.rules.size(); ++i)
        estimate.rules.push_back({.rule = static_cast<MixtureRule>(i),
                                  .young_modulus = results.rules[i],
                                  .standard_uncertainty = uncertainties[i + 2].standard_uncertainty});
    estimate.poisson_ratio = results.chosen.poisson_ratio;
    estimate.poisson_ratio_assumed = std::ranges::any_of(composition.components, has_assumed_poisson_ratio);
    estimate.density = results.density;
    estimate.density_uncertainty = uncertainties[1].standard_uncertainty;
    estimate.contributions = uncertainties[0].contributions;
    note_missing(composition, estimate.notes);
    if (auto doubt =
            implausible_at("Young's modulus", *plausible_range("young_modulus"), {estimate.young_modulus}))
        estimate.notes.push_back(*std::move(doubt));
    note_dominant(estimate.contributions, estimate.notes);
    if (options.porosity)
        if (const std::string outside = porosity_warning(*options.porosity); !outside.empty())
            estimate.notes.push_back({modulus_code, Severity::remark, outside});
    return estimate;
}

ParticleDensity particle_density(double true_density, std::optional<double> porosity,
                                 std::optional<double> measured_density) {
    require_positive("density of the phases", true_density, Dimension::density);
    if (porosity && !(*porosity >= 0 && *porosity < 1))
        throw InputError("porosity is " + shortest(*porosity), "0 <= porosity < 1");
    ParticleDensity result{.true_density = true_density, .porosity = porosity.value_or(0)};
    result.apparent_density = true_density * (1 - result.porosity);
    if (!measured_density) return result;
    const double measured_porosity = porosity_from_densities(*measured_density, true_density);
    constexpr double tolerance = 0.005;
    if (porosity && std::abs(measured_porosity - *porosity) > tolerance)
        result.notes.push_back({"density", Severity::doubt,
                                "the measured density gives a porosity of " +
                                    shortest(std::round(1e4 * measured_porosity) / 1e4) + ", stated is " +
                                    shortest(*porosity)});
    if (!porosity) result.porosity = measured_porosity;
    result.apparent_density = *measured_density;
    return result;
}

}  // namespace ashimpact
