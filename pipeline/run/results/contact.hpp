// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/quantities/quantity.hpp"
#include "materials/modulus.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/contact/law.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// One phase of a sample.
struct PhaseShare {
    std::string name;                                  ///< as the analysis has it
    std::string phase{};                               ///< of the catalogue
    double weight_fraction = 0, volume_fraction = 0;   ///< [1]
    std::optional<double> density{}, young_modulus{};  ///< [kg/m3], [Pa]
};

/// Bounds of Young's modulus that hold for any arrangement of the phases.
struct ModulusBounds {
    Quantity lower, upper;  ///< [Pa]
    std::optional<MixtureRule> lower_rule{}, upper_rule{};
};

/// Moduli of a sample with the glass that does not count.
struct OtherGlass {
    Quantity young_modulus;                 ///< of the sample [Pa]
    Quantity density;                       ///< of the dense mixture [kg/m3]
    std::optional<double> poisson_ratio{};  ///< of the sample [1]
};

/// The glass of a sample by its chemistry.
struct SampleGlass {
    bool used = false;  ///< whether it counts; else that of the catalogue
    std::vector<std::pair<std::string, Quantity>> composition{};  ///< of the glass, by weight [1]
    Quantity young_modulus{};                                     ///< of the glass [Pa]
    double poisson_ratio = 0;                                     ///< [1]
    Quantity density{};                                           ///< [kg/m3]
    bool density_assumed = false;
    Quantity weight_fraction{}, amorphous_fraction{};  ///< by the oxides, by XRD [1]
    OtherGlass other{};
};

/// Composition and Young's modulus of a sample.
struct SampleModulus {
    std::string name{};
    Quantity diameter{};  ///< [m]
    std::vector<PhaseShare> phases{};
    MixtureRule rule = MixtureRule::parallel;
    Quantity young_modulus{};  ///< by that rule, porosity applied [Pa]
    std::optional<ModulusBounds> bounds{};
    std::vector<RuleResult> rules{};            ///< of the dense mixture
    Quantity density{};                         ///< of the dense mixture [kg/m3]
    std::optional<Quantity> poisson_ratio{};    ///< mixed from the phases [1]
    bool poisson_ratio_assumed = false;         ///< of one of the phases at least
    std::vector<Contribution> contributions{};  ///< to the variance of young_modulus, largest first
    std::optional<SampleGlass> glass{};         ///< where the case has oxides
};

/// Result of the modulus stage, 1-modulus.json.
using ModulusResult = SampleResults<SampleModulus>;

/// The second sphere of a contact.
struct SecondSphere {
    Quantity radius;  ///< [m]
    Quantity mass;    ///< [kg]
};

/// Properties of the contact of a sample.
struct SampleContact {
    std::string name{};
    ContactPair pair{};                           ///< pair_of() the other fields
    Stated contact_modulus{};                     ///< E* [Pa]
    Quantity effective_radius{};                  ///< R* [m]
    Quantity radius{};                            ///< of the particle; R* where the other body is a wall [m]
    Quantity mass{};                              ///< of the particle [kg]
    Stated density{};                             ///< apparent [kg/m3]
    Stated work_of_adhesion{};                    ///< w that acts, reduced by roughness [J/m2]
    std::optional<double> density_from_phases{};  ///< less the stated pores [kg/m3]
    std::optional<Stated> smooth_work_of_adhesion{};  ///< before that reduction; none: smooth surfaces
    std::optional<Stated> roughness{};                ///< rms [m]
    std::optional<Stated> poisson_ratio{};            ///< of the particle; none: nothing needs it [1]
    std::optional<Stated> yield_pressure{};           ///< none: the contact stays elastic [Pa]
    std::vector<std::pair<LawParameter, Stated>> parameters{};  ///< of laws that declare their own [SI]
    std::optional<SecondSphere> partner{};                      ///< none: the other body is a flat wall
};

/// The contact as the solver takes it.
[[nodiscard]] ContactPair pair_of(const SampleContact& contact);

/// Result of the contact stage, 2-contact.json.
using ContactResult = SampleResults<SampleContact>;

/// Energy to separate a contact and the velocity that just supplies it.
struct AnalyticVelocity {
    double separation_energy = 0;  ///< W_s [J]
    double critical_velocity = 0;  ///< v_s of Eq. 30 [m/s]
};

/// The same for a cohesion of finite range, between 0 (DMT) and JKR.
struct CohesiveVelocity {
    AnalyticVelocity exact{};
    double transition_parameter = 0;  ///< lambda of Maugis [1]
    AnalyticVelocity fitted{};        ///< by a closed form
    double fitted_error = 0;          ///< relative, of its energy [1]
};

/// Analytic results of a sample: of a JKR contact that ends at pull-off, and variants.
struct SampleAnalytic : AnalyticVelocity {
    std::string name{};
    std::optional<AnalyticVelocity> load_controlled{};
    std::optional<AnalyticVelocity> with_printed_constants{};  ///< of Dong et al. 2013
    std::optional<CohesiveVelocity> maugis_dugdale{};
};

/// Result of the analytic stage, 3-analytic.json.
using AnalyticResult = SampleResults<SampleAnalytic>;

/// Impacts in the columns in which artifacts list them. Restitution 0 is a capture.
struct ListedImpacts {
    std::vector<double> velocity{};              ///< v_in [m/s]
    std::vector<double> restitution{};           ///< [1]
    std::vector<double> velocity_uncertainty{};  ///< standard; empty: the noise is not known [m/s]
    std::vector<double> rebound_uncertainty{};   ///< standard, of v_r; empty as well [m/s]
    std::vector<double> correlation{};           ///< of these two errors; empty: none [1]
    std::vector<double> resolution{};            ///< v_r always seen; empty: not known [m/s]
    std::vector<double> noted_captures{};        ///< 1: seen to stick, 0: by its reading; empty: all so
    std::vector<double> tangential{};            ///< velocities along the wall; empty: not stated [m/s]
    std::vector<double> counts{};                ///< impacts of which a point is the mean; empty: one each
};

[[nodiscard]] ListedImpacts columns_of(const MeasurementSet& set);

/// The impacts of these columns; they differ from those of columns_of() by rounding.
/// @param columns of one length
[[nodiscard]] MeasurementSet impacts_of(const ListedImpacts& columns);

/// Restitution against incident velocity that serves several laws.
struct RestitutionSeries {
    std::vector<Law> laws{};
    Origin origin = Origin::measured;  ///< measured or reconstructed
    std::string source{};
    ListedImpacts columns{};
    MeasurementSet impacts{};  ///< the impacts of these columns, in their order
    /// Of a reconstructed series: standard uncertainty of each coefficient behind it, its rounding [kg/s].
    std::optional<double> coefficient_uncertainty{};
};

/// The restitution data of a sample.
struct SampleRestitution {
    std::string name{};
    std::vector<RestitutionSeries> series{};

    /// The series of a law, or null.
    [[nodiscard]] const RestitutionSeries* of(Law law) const {
        for (const RestitutionSeries& each : series)
            if (std::find(each.laws.begin(), each.laws.end(), law) != each.laws.end()) return &each;
        return nullptr;
    }
};

/// Result of the restitution stage, 4-restitution.json.
using RestitutionResult = SampleResults<SampleRestitution>;

}  // namespace ashimpact
