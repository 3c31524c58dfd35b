// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "materials/composition.hpp"
#include "materials/contact_properties.hpp"
#include "materials/glass/balance.hpp"
#include "materials/modulus.hpp"
#include "pipeline/case/values.hpp"
#include "solver/damping/damping.hpp"
#include "solver/damping/damping_polynomial.hpp"
#include "solver/inference/calibration/calibration.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/inference/measured_damping.hpp"
#include "solver/statistics/propagation.hpp"

namespace ashimpact {

/// Elasticity of the other body, or only the contact modulus E* of the pair.
struct ElasticWall {
    Stated young_modulus, poisson_ratio;
};
using Wall = std::variant<ElasticWall, RigidWall, Stated>;

/// The second sphere in place of a wall, with its density [kg/m3] or its mass [kg]. Its elasticity is a Wall.
struct PartnerSphere {
    Stated diameter;  ///< [m]
    std::optional<Stated> density{}, mass{};
};

/// Work of adhesion from the surface energies of the two bodies.
struct AdhesionFromSurfaces {
    SurfaceEnergies energies;
    AdhesionRule rule;
};
using Adhesion = std::variant<Stated, AdhesionFromSurfaces>;

/// Impacts as measured; binned, and with the uncertainty of a camera, if the case has these keys.
struct MeasuredRestitution {
    std::string source{};            ///< in words, with what was done to them
    MeasurementSet impacts{};        ///< with the warnings of the file they were read from
    bool by_camera_of_case = false;  ///< their uncertainty is that of the camera of the whole case
};

/// Restitution data to be reconstructed from published fits eta(e); see reconstructed_velocity().
struct Reconstruction {
    std::string source{};
    LawMap<DampingPolynomial> damping_fits{};
    double from = 0;          ///< smallest restitution [1]
    double to = 0;            ///< largest restitution [1]
    int points = 0;           ///< evenly spaced between them
    std::string reference{};  ///< law whose points stand for laws without a fit of their own
    std::optional<double> coefficient_uncertainty{};  ///< standard, of each coefficient: its rounding [kg/s]
};
using RestitutionSource = std::variant<MeasuredRestitution, Reconstruction>;

/// Published values of a sample, used for comparison and calibration only.
struct PublishedSample {
    struct ContactTime {
        Law law;
        Quantity velocity;
        Quantity contact_time;
    };
    std::string source{};
    std::optional<Quantity> young_modulus{};
    std::vector<std::pair<std::string, Quantity>> volume_fractions{};
    LawMap<DampingPolynomial> damping_fits{};
    std::optional<double> damping_fit_uncertainty{};  ///< standard, of each coefficient [kg/s]
    LawMap<Quantity> critical_damping{}, critical_velocity{};
    std::optional<Quantity> measured_critical_velocity{};
    std::vector<ContactTime> contact_times{};
    LawMap<Quantity> critical_contact_times{};
};

/// One sieve size.
struct Sample {
    std::string name;
    Stated diameter;
    Analysis analysis{};
    std::string analysis_source{};
    GlassInputs glass{};  ///< oxides of the sample, and which glass counts
    std::optional<Porosity> porosity{};
    bool porosity_from_density = false;       ///< the porosity's value follows from density and phases
    std::optional<Stated> poisson_ratio{};    ///< none: mixed from the phases
    std::optional<Stated> density{};          ///< apparent; none: that of the phases, less the pores
    std::optional<Stated> contact_modulus{};  ///< instead of Eq. 7 [Pa]
    std::optional<Stated> yield_pressure{};   ///< for laws that yield; none: the contact stays elastic [Pa]
    std::vector<std::pair<LawParameter, Stated>> parameters{};  ///< of laws that declare their own
    std::optional<Adhesion> work_of_adhesion{};
    std::optional<Stated> measured_critical_velocity{};
    std::optional<RestitutionSource> restitution{};
    std::optional<PublishedSample> published{};
};

struct LawChoice {
    Law law;
    Detachment detachment;
};

struct HistoryOptions {
    int points = 49;
    double critical_excess = 1e-3;  ///< the history "at" v_c is taken at v_c (1 + this) [1]
};

/// Temperatures of an impact [K]; none: not stated, room temperature.
struct Temperatures {
    std::optional<Stated> particle{}, wall{};
};

/// How uncertainties are propagated to v_c.
struct UncertaintyChoices {
    PropagationOptions propagation{};
    bool reread = true;  ///< whether v_r(v_in) as measured is inverted again for each contact
};

/// A case, complete: every default filled in, every file it names read.
struct Case {
    std::string name;
    std::vector<Phase> phases{};  ///< every phase the samples need, with its properties
    MixtureRule mixture_rule = MixtureRule::parallel;
    std::optional<Wall> wall{};              ///< elasticity of the other body
    std::optional<PartnerSphere> partner{};  ///< the other body is this sphere; none: it is a flat wall
    std::optional<Stated> roughness{};  ///< rms of both surfaces, see roughness_reduction(); none: smooth [m]
    std::optional<Stated>
        friction{};  ///< Coulomb's coefficient, of impacts at an angle; none: not stated [1]
    Temperatures temperature{};
    std::vector<Sample> samples{};
    std::vector<LawChoice> laws{};
    DampingLaw damping_law = DampingLaw::constant;
    std::optional<double> paper_time_step{};  ///< of the paper's explicit scheme; none: not asked for [s]
    HistoryOptions histories{};
    MeasuredDampingOptions fit{};  ///< of measured impacts; see docs/case.md
    UncertaintyChoices uncertainty{};
    std::vector<FreeConstant> calibration{};  ///< constants left to a calibration

    /// Where the contact of a law ends: as chosen, or by default if the case does not have the law.
    [[nodiscard]] Detachment detachment_of(Law law) const {
        const auto choice = std::ranges::find(laws, law, &LawChoice::law);
        return choice == laws.end() ? law.default_detachment() : choice->detachment;
    }
};

}  // namespace ashimpact
