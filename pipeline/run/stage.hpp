// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "materials/modulus.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/histories.hpp"
#include "pipeline/run/results/note.hpp"
#include "pipeline/run/results/run.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"
#include "solver/batch/parallel.hpp"

namespace ashimpact {

/// Files of a run, in the order in which they are written; a run starts from the case.
inline constexpr std::string_view case_artifact = "0-case.json";
inline constexpr std::string_view modulus_artifact = "1-modulus.json";
inline constexpr std::string_view contact_artifact = "2-contact.json";
inline constexpr std::string_view analytic_artifact = "3-analytic.json";
inline constexpr std::string_view restitution_artifact = "4-restitution.json";
inline constexpr std::string_view damping_artifact = "5-damping.json";
inline constexpr std::string_view fit_artifact = "6-fit.json";
inline constexpr std::string_view critical_velocity_artifact = "7-critical-velocity.json";
inline constexpr std::string_view histories_artifact = "8-histories.json";
inline constexpr std::string_view comparison_artifact = "comparison.json";
inline constexpr std::string_view manifest_artifact = "manifest.json";

/// One step of a run: a pure function of the results it reads.
struct Stage {
    std::string_view name;                ///< "modulus"
    std::string_view file;                ///< "1-modulus.json"; its schema is the file's stem
    std::vector<std::string_view> reads;  ///< files of earlier stages
    /// Sets the result of this stage from those of the stages it reads.
    void (*compute)(Run& run, ContactModels& models, StageRecord& record);
};

/// The stages after the case itself, in order.
[[nodiscard]] const std::vector<Stage>& stages();

/// Computes the result of a stage and adds its record to the run.
void compute_stage(const Stage& stage, Run& run, ContactModels& models);

/// Phases, fractions both ways and Young's modulus by every rule; Dong et al. 2013, Eq. 1.
[[nodiscard]] ModulusResult modulus_stage(const Case& data, StageRecord& record);

/// A porosity law with the porosity that an apparent density implies.
struct PorosityFromDensity {
    Porosity porosity;
    Finding finding;  ///< the porosity
};

/// Completes a porosity law with P = 1 - apparent/true [kg/m3]. Errors: InputError for an apparent density
/// above the true one.
[[nodiscard]] PorosityFromDensity porosity_from_density(Porosity porosity, const Quantity& apparent,
                                                        double true_density);

/// The independent inputs of the particle of a sample: its phases, and its porosity or density.
[[nodiscard]] ParticleInputs particle_inputs(const Case& data, const Sample& sample);

/// The w that roughness leaves, with the uncertainty of both, linearly.
[[nodiscard]] Stated rough_adhesion(const Stated& smooth, const Stated& roughness, double effective_radius);

/// Composition and modulus of one sample; name and diameter are left empty.
[[nodiscard]] SampleModulus sample_modulus(const Composition& composition, const ModulusEstimate& estimate,
                                           MixtureRule rule);

/// The glass of a sample by its chemistry. @param sample with oxides
/// @param other modulus of the sample with the glass that does not count
[[nodiscard]] SampleGlass sample_glass(const GlassInSample& sample, const ModulusEstimate& other,
                                       GlassSource used);

/// Contact modulus, effective radius and mass, and work of adhesion; Dong et al. 2013, Eqs. 6, 7 and 11.
[[nodiscard]] ContactResult contact_stage(const Case& data, const ModulusResult& moduli, StageRecord& record);

/// Energy to separate a JKR contact and the velocity that just supplies it; Dong et al. 2013, Eqs. 28-30,
/// read with the contact modulus and the work of adhesion.
[[nodiscard]] AnalyticResult analytic_stage(const ContactResult& contacts, StageRecord& record);

/// The restitution data of each sample: as measured, or reconstructed from published fits eta(e) by searching
/// the velocity at which an impact with eta(e) gives e back.
[[nodiscard]] RestitutionResult restitution_stage(const Case& data, const ContactResult& contacts,
                                                  StageRecord& record);

/// The damping that gives back each restitution, with its uncertainty and the reachable range, the parts of
/// eta(v_in) and the rising branch; Dong et al. 2013, section 4.2. Captures (restitution 0) bound the damping
/// but do not fix it: they are listed apart.
[[nodiscard]] DampingStageResult damping_stage(const Case& data, const ContactResult& contacts,
                                               const RestitutionResult& restitutions, ContactModels& models,
                                               StageRecord& record);

/// eta(e) over the rising branch of e(v), quadratic by default, and the critical damping eta(0); Dong et al.
/// 2013, section 4.3, Tables 2 and 3. Of measured impacts also the critical damping that all of them support,
/// captures included, whatever the form of eta; reconstructed ones are fitted by least squares.
[[nodiscard]] FitResult fit_stage(const Case& data, const ContactResult& contacts,
                                  const RestitutionResult& restitutions, const DampingStageResult& dampings,
                                  ContactModels& models, StageRecord& record);

/// The dynamic critical velocity at the critical damping (Dong et al. 2013, section 4.3, Table 4) with its
/// interval, what dominates it, the regime of the impact, and the measured one beside it.
[[nodiscard]] CriticalVelocityResult critical_velocity_stage(const Case& data, const ModulusResult& moduli,
                                                             const ContactResult& contacts,
                                                             const RestitutionResult& restitutions,
                                                             const FitResult& fits, ContactModels& models,
                                                             StageRecord& record);

/// The critical velocity of one damping and the regime of the impact, without an interval.
[[nodiscard]] LawCriticalVelocity law_critical_velocity(const CriticalVelocityProblem& problem);

/// Overlap against time just above the critical velocity and in the middle of the rising branch, with the
/// momentum balance of each; Dong et al. 2013, section 4.4, Eqs. 35-45, Figure 9. With the curves of the
/// figures.
[[nodiscard]] HistoriesResult histories_stage(const Case& data, const ContactResult& contacts,
                                              const DampingStageResult& dampings, const FitResult& fits,
                                              const CriticalVelocityResult& velocities, StageRecord& record);

/// Compares analytic, dynamic and measured critical velocities, and published values with ours, and states in
/// words what the ratio of dynamic to analytic velocities means.
/// @param run with the results of all other stages
[[nodiscard]] ComparisonResult comparison_stage(const Run& run, StageRecord& record);

/// The result of one law for a sample, if there is one, and findings on it.
template <class Value>
struct ResultOfLaw {
    std::optional<Value> value{};
    std::vector<Finding> findings{};
};

/// Computes the results of all laws of the case for a sample, in parallel, and records the findings on them.
template <class Value>
[[nodiscard]] LawMap<Value> results_by_law(
    const Case& data, const std::string& sample, StageRecord& record,
    const std::function<ResultOfLaw<Value>(const LawChoice&)>& compute) {
    auto all = in_parallel(data.laws, compute);
    LawMap<Value> laws;
    for (std::size_t i = 0; i < all.size(); ++i) {
        record.note(all[i].findings, sample, data.laws[i].law);
        if (all[i].value) laws.set(data.laws[i].law, *std::move(all[i].value));
    }
    return laws;
}

}  // namespace ashimpact
