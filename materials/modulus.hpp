// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"
#include "core/quantities/quantity.hpp"
#include "materials/composition.hpp"
#include "materials/mixture_rules.hpp"

namespace ashimpact {

/// An independent input of a computation.
struct UncertainInput {
    std::string what;                                          ///< "Young's modulus of mullite"
    double value = 0;                                          ///< [SI]
    double standard_uncertainty = 0;                           ///< [SI]; 0 if unknown
    bool positive = false;                                     ///< only positive values exist
    double lowest = -std::numeric_limits<double>::infinity();  ///< limits of values that are drawn [SI]
    double highest = std::numeric_limits<double>::infinity();
    std::string group{};  ///< inputs of a group are ranked together; empty: by itself
};

/// What one input adds to the variance of a result.
struct Contribution {
    std::string what;
    double share = 0;  ///< [1] of the variance
};

/// Uncertainty of one result.
struct PropagatedUncertainty {
    double standard_uncertainty = 0;            ///< [unit of the result]
    std::vector<Contribution> contributions{};  ///< largest first, without zeros
};

/// Propagates uncertainties linearly through a function with several results, each input independent:
/// u^2 = sum (df/dx_i u_i)^2 (JCGM 100:2008, 5.1.2), derivatives by central differences of relative step
/// 6e-6, good to about 1e-9. Validity: functions smooth over that step. Returns one entry for each result of
/// the function.
[[nodiscard]] std::vector<PropagatedUncertainty> propagate_linearly(
    const std::function<std::vector<double>(const std::vector<double>&)>& function,
    const std::vector<UncertainInput>& inputs);

/// How the Young's modulus of a mixture follows from those of its phases; see mixture_rules.hpp.
enum class MixtureRule {
    parallel,                ///< Eq. 1, the default
    series,                  ///< Reuss on E
    hill,                    ///< mean of parallel and series
    voigt,                   ///< upper bounds on K and G; from here on every Poisson ratio is needed
    reuss,                   ///< lower bounds on K and G
    voigt_reuss_hill,        ///< mean of voigt and reuss
    hashin_shtrikman_lower,  ///< lower bounds on K and G for isotropic mixtures
    hashin_shtrikman_upper,  ///< upper bounds on K and G for isotropic mixtures
};

template <>
struct Names<MixtureRule> {
    static constexpr std::string_view kind = "mixture rule";
    static constexpr std::array<std::string_view, 8> all{"parallel",
                                                         "series",
                                                         "hill",
                                                         "voigt",
                                                         "reuss",
                                                         "voigt-reuss-hill",
                                                         "hashin-shtrikman-lower",
                                                         "hashin-shtrikman-upper"};
};

/// Relative standard uncertainty assumed for a phase's Young's modulus if none is known: the median of those
/// that the catalogue's sources state, clinker phases by nanoindentation apart. A modulus without a stated
/// uncertainty never counts as exact.
inline constexpr double assumed_modulus_uncertainty = 0.04;

/// Standard uncertainty of a phase's Young's modulus [Pa]: the known one, else the assumed one.
[[nodiscard]] double modulus_uncertainty(const Phase& phase);

struct ModulusOptions {
    MixtureRule rule = MixtureRule::parallel;
    std::optional<Porosity> porosity{};  ///< nothing: dense
    /// Of the particle [kg/m3]: the porosity then is 1 - apparent/dense, whatever value it has.
    std::optional<Quantity> apparent_density{};
};

/// What follows from the phases and pores of a particle.
struct ParticleProperties {
    PorousModuli moduli{};     ///< by the chosen rule, porosity applied
    double dense_density = 0;  ///< of the phases [kg/m3]
    double density = 0;        ///< apparent: as stated, or dense_density (1 - P) [kg/m3]
};

/// The inputs of a mixture of its components' properties.
struct Mixture {
    FractionBasis basis;
    FractionModel model;
    std::vector<double> densities;       ///< [kg/m3]
    std::vector<double> young_moduli;    ///< [Pa]
    std::vector<double> poisson_ratios;  ///< empty unless every phase has one [1]
    ModulusOptions options;
};

/// A particle by the independent inputs from which its properties follow: fractions, densities, moduli and
/// Poisson's ratios of the phases, and its porosity or apparent density. Each is one input, however many
/// properties it enters.
class ParticleInputs {
  public:
    /// @throws InputError for an invalid porosity, or a rule that needs a Poisson ratio that is not known
    ParticleInputs(const Composition& composition, const ModulusOptions& options);

    [[nodiscard]] const std::vector<UncertainInput>& list() const { return list_; }

    /// The properties at some values of the inputs. A porosity that follows from densities is limited to 0 to
    /// 0.99.
    [[nodiscard]] ParticleProperties at(std::span<const double> values) const;
    /// The same for values that are drawn: those beyond the limits of their inputs count as the limits.
    [[nodiscard]] ParticleProperties drawn(std::span<const double> values) const;
    /// Young's moduli of the dense mixture there [Pa], by every rule that can be computed, in the order of
    /// MixtureRule.
    [[nodiscard]] std::vector<double> rules_at(std::span<const double> values) const;

  private:
    [[nodiscard]] Mixture mixture_at(std::span<const double> values) const;

    Mixture nominal_;
    std::vector<bool> follows_density_;  ///< of phases, see Phase::follows_density
    std::vector<UncertainInput> list_;
};

/// Young's modulus by one rule, of the dense mixture.
struct RuleResult {
    MixtureRule rule = MixtureRule::parallel;
    double young_modulus = 0;         ///< [Pa]
    double standard_uncertainty = 0;  ///< [Pa]
};

/// Elastic properties of a sample.
struct ModulusEstimate {
    double young_modulus = 0;                   ///< by the chosen rule, porosity applied [Pa]
    double standard_uncertainty = 0;            ///< [Pa]
    std::vector<RuleResult> rules{};            ///< every rule that can be computed, dense [Pa]
    std::optional<double> poisson_ratio{};      ///< of the Voigt-Reuss-Hill mean, porosity applied [1]
    double poisson_ratio_uncertainty = 0;       ///< [1]
    bool poisson_ratio_assumed = false;         ///< one of the phases has an assumed one
    double density = 0;                         ///< of the dense mixture [kg/m3]
    double density_uncertainty = 0;             ///< [kg/m3]
    std::vector<Contribution> contributions{};  ///< to the variance of young_modulus, largest first
    std::vector<Finding> notes{};               ///< in addition to those of the composition

    /// The result of one rule; nothing where a Poisson ratio is missing.
    [[nodiscard]] std::optional<RuleResult> by(MixtureRule rule) const;
};

/// Computes the moduli of a composition by every rule, with uncertainties propagated linearly from the
/// fractions and the phase properties. Errors: InputError if the chosen rule or the porosity law needs a
/// Poisson ratio that no source gives.
[[nodiscard]] ModulusEstimate estimate_modulus(const Composition& composition,
                                               const ModulusOptions& options = {});

/// Density of a particle: that of its phases and the apparent one.
struct ParticleDensity {
    double true_density = 0;      ///< of the dense mixture [kg/m3]
    double porosity = 0;          ///< [1]
    double apparent_density = 0;  ///< to be used for the mass [kg/m3]
    std::vector<Finding> notes{};
};

/// Returns the density of a particle: the measured (apparent) one if given, else true_density (1 - P). P is
/// the stated porosity, else that of the measured density; a difference of more than 0.005 gives a note.
/// Errors: InputError for a measured density above the true one, or a porosity outside [0, 1).
[[nodiscard]] ParticleDensity particle_density(double true_density, std::optional<double> porosity,
                                               std::optional<double> measured_density);

}  // namespace ashimpact
