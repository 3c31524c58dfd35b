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
constexpr const char* unknown_moduli = "Young's moduli of unknown uncertainty";

std::vector<double> volumes_of(const Mixture& mixture) {
    const auto fractions = mixture.model.fractions();
    return mixture.basis == FractionBasis::weight ? volume_fractions(fractions, mixture.densities)
                                                  : fractions;
}

bool has_poisson_ratios(const Mixture& mixture) {
    return !mixture.poisson_ratios.empty();
}

/// The porosity of a mixture [1], and its apparent density [kg/m3].
struct Pores {
    double porosity = 0;
    double density = 0;
};

constexpr double most_pores = 0.99;

Pores pores_of(const ModulusOptions& options, double dense_density) {
    if (options.apparent_density) {
        const double apparent = options.apparent_density->value;
        return {std::clamp(1 - apparent / dense_density, 0.0, most_pores), apparent};
    }
    const double porosity = options.porosity ? options.porosity->value : 0;
    return {porosity, dense_density * (1 - porosity)};
}

/// The phases of a mixture, for one rule after the other.
class MixedPhases {
  public:
    explicit MixedPhases(const Mixture& mixture)
        : volumes_(volumes_of(mixture)), moduli_(mixture.young_moduli) {
        for (std::size_t i = 0; i < mixture.poisson_ratios.size(); ++i)
            phases_.push_back(isotropic_moduli(moduli_[i], mixture.poisson_ratios[i]));
    }

    [[nodiscard]] const std::vector<double>& volumes() const { return volumes_; }
    /// The Voigt-Reuss-Hill mean.
    [[nodiscard]] IsotropicModuli mean() const { return hill_moduli(volumes_, phases_); }
    /// Returns E of the dense mixture [Pa].
    [[nodiscard]] double young_modulus_by(MixtureRule rule) const {
        switch (rule) {
            case MixtureRule::parallel:
                return parallel_young_modulus(volumes_, moduli_);
            case MixtureRule::series:
                return series_young_modulus(volumes_, moduli_);
            case MixtureRule::hill:
                return hill_young_modulus(volumes_, moduli_);
            case MixtureRule::voigt:
                return young_modulus(voigt_moduli(volumes_, phases_));
            case MixtureRule::reuss:
                return young_modulus(reuss_moduli(volumes_, phases_));
            case MixtureRule::voigt_reuss_hill:
                return young_modulus(mean());
            case MixtureRule::hashin_shtrikman_lower:
                return young_modulus(hashin_shtrikman_lower(volumes_, phases_));
            case MixtureRule::hashin_shtrikman_upper:
                return young_modulus(hashin_shtrikman_upper(volumes_, phases_));
        }
        return 0;
    }

  private:
    std::vector<double> volumes_;
    const std::vector<double>& moduli_;
    std::vector<IsotropicModuli> phases_{};
};

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

/// Results as a list: the chosen modulus, the density of the phases, Poisson's ratio (0: not known), then the
/// rules.
std::vector<double> listed(const ParticleInputs& inputs, std::span<const double> values) {
    const ParticleProperties results = inputs.at(values);
    std::vector<double> list{results.moduli.young_modulus, results.dense_density,
                             results.moduli.poisson_ratio.value_or(0)};
    const auto by_rule = inputs.rules_at(values);
    list.insert(list.end(), by_rule.begin(), by_rule.end());
    return list;
}

/// Standard uncertainty of a phase's Young's modulus at its density [Pa].
double modulus_uncertainty_at_density(const Phase& phase) {
    const double u = modulus_uncertainty(phase);
    if (!phase.follows_density) return u;
    const double of_density =
        phase.young_modulus.value / phase.density.value * phase.density.uncertainty().value_or(0);
    return std::sqrt(std::max(0.0, u * u - of_density * of_density));
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

ParticleInputs::ParticleInputs(const Composition& composition, const ModulusOptions& options)
    : nominal_(mixture_of(composition, options)) {
    if (options.porosity) require_valid(*options.porosity);
    if (options.rule > MixtureRule::hill && !has_poisson_ratios(nominal_))
        throw InputError(
            "the rule " + std::string(name_of(options.rule)) + " needs a Poisson ratio for every phase",
            "parallel, series, hill, or Poisson's ratios in the case file");
    const auto& components = composition.components;
    const std::string basis = composition.basis == FractionBasis::weight ? "weight" : "volume";
    const FractionModel& model = nominal_.model;
    for (std::size_t i = 0; i < model.amounts.size(); ++i)
        list_.push_back({.what = basis + " fraction of " + components[i].name,
                         .value = model.amounts[i],
                         .standard_uncertainty = model.uncertainties[i].value_or(0),
                         .lowest = 0});
    list_.push_back({.what = model.kind == FractionModel::Kind::remainder
                                 ? "scale of the internal standard"
                                 : "amorphous " + basis + " fraction",
                     .value = model.parameter,
                     .standard_uncertainty = model.parameter_uncertainty.value_or(0),
                     .lowest = 0});
    for (const Component& c : components) {
        follows_density_.push_back(c.phase.follows_density);
        list_.push_back({.what = "density of " + c.phase.name,
                         .value = c.phase.density.value,
                         .standard_uncertainty = c.phase.density.uncertainty().value_or(0),
                         .positive = true,
                         .group = c.phase.follows_density ? "" : "densities of the phases"});
    }
    for (const Component& c : components)
        list_.push_back({.what = "Young's modulus of " + c.phase.name,
                         .value = c.phase.young_modulus.value,
                         .standard_uncertainty = modulus_uncertainty_at_density(c.phase),
                         .positive = true,
                         .group = c.phase.young_modulus.uncertainty() ? "" : unknown_moduli});
    if (has_poisson_ratios(nominal_))
        for (const Component& c : components)
            list_.push_back({.what = "Poisson's ratio of " + c.phase.name,
                             .value = c.phase.poisson_ratio->value,
                             .standard_uncertainty = c.phase.poisson_ratio->uncertainty().value_or(0),
                             .lowest = -0.99,
                             .highest = 0.499,
                             .group = "Poisson's ratios of the phases"});
    if (const auto& apparent = options.apparent_density)
        list_.push_back({.what = "density",
                         .value = apparent->value,
                         .standard_uncertainty = apparent->standard_uncertainty.value_or(0),
                         .positive = true});
    else if (options.porosity)
        list_.push_back({.what = "porosity",
                         .value = options.porosity->value,
                         .standard_uncertainty = options.porosity->standard_uncertainty.value_or(0),
                         .lowest = 0,
                         .highest = most_pores});
}

Mixture ParticleInputs::mixture_at(std::span<const double> values) const {
    Mixture mixture = nominal_;
    auto next = values.begin();
    for (double& amount : mixture.model.amounts) amount = *next++;
    mixture.model.parameter = *next++;
    for (auto* list : {&mixture.densities, &mixture.young_moduli, &mixture.poisson_ratios})
        for (double& value : *list) value = *next++;
    for (std::size_t i = 0; i < follows_density_.size(); ++i) {
        if (!follows_density_[i]) continue;
        const double packing = mixture.densities[i] / nominal_.densities[i];
        mixture.young_moduli[i] *= packing;
        if (has_poisson_ratios(mixture))
            mixture.poisson_ratios[i] = 0.5 - (0.5 - mixture.poisson_ratios[i]) / packing;
    }
    if (mixture.options.apparent_density)
        mixture.options.apparent_density->value = *next++;
    else if (mixture.options.porosity)
        mixture.options.porosity->value = *next++;
    return mixture;
}

ParticleProperties ParticleInputs::at(std::span<const double> values) const {
    const Mixture mixture = mixture_at(values);
    const MixedPhases phases(mixture);
    ParticleProperties result{.dense_density = mixture_density(phases.volumes(), mixture.densities)};
    result.moduli.young_modulus = phases.young_modulus_by(mixture.options.rule);
    if (has_poisson_ratios(mixture)) result.moduli.poisson_ratio = poisson_ratio(phases.mean());
    const Pores pores = pores_of(mixture.options, result.dense_density);
    result.density = pores.density;
    if (auto porosity = mixture.options.porosity) {
        porosity->value = pores.porosity;
        result.moduli = porous_moduli(result.moduli, *porosity);
    }
    return result;
}

ParticleProperties ParticleInputs::drawn(std::span<const double> values) const {
    std::vector<double> limited(values.begin(), values.end());
    for (std::size_t i = 0; i < limited.size(); ++i)
        limited[i] = std::clamp(limited[i], list_[i].lowest, list_[i].highest);
    return at(limited);
}

std::vector<double> ParticleInputs::rules_at(std::span<const double> values) const {
    const Mixture mixture = mixture_at(values);
    const MixedPhases phases(mixture);
    std::vector<double> moduli;
    for (const MixtureRule rule : all_values<MixtureRule>)
        if (rule <= MixtureRule::hill || has_poisson_ratios(mixture))
            moduli.push_back(phases.young_modulus_by(rule));
    return moduli;
}

ModulusEstimate estimate_modulus(const Composition& composition, const ModulusOptions& options) {
    const ParticleInputs inputs(composition, options);
    const auto function = [&](const std::vector<double>& x) { return listed(inputs, x); };
    const auto uncertainties = propagate_linearly(function, inputs.list());
    std::vector<double> values;
    for (const UncertainInput& input : inputs.list()) values.push_back(input.value);
    const ParticleProperties results = inputs.at(values);
    const std::vector<double> by_rule = inputs.rules_at(values);

    ModulusEstimate estimate{.young_modulus = results.moduli.young_modulus,
                             .standard_uncertainty = uncertainties[0].standard_uncertainty};
    for (std::size_t i = 0; i < by_rule.size(); ++i)
        estimate.rules.push_back({.rule = static_cast<MixtureRule>(i),
                                  .young_modulus = by_rule[i],
                                  .standard_uncertainty = uncertainties[i + 3].standard_uncertainty});
    estimate.poisson_ratio = results.moduli.poisson_ratio;
    estimate.poisson_ratio_uncertainty = uncertainties[2].standard_uncertainty;
    estimate.poisson_ratio_assumed = std::ranges::any_of(composition.components, has_assumed_poisson_ratio);
    estimate.density = results.dense_density;
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
