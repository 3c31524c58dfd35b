// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/case/input_files.hpp"
#include "pipeline/case/values.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/histories.hpp"
#include "pipeline/run/results/note.hpp"
#include "pipeline/run/results/oblique.hpp"
#include "pipeline/run/results/reported.hpp"
#include "pipeline/run/results/sizes.hpp"
#include "pipeline/run/results/temperature.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"

namespace ashimpact {

/// Whether a law has a critical velocity; the first three are those of CaptureVerdict.
enum class LawVerdict { finite, always_captured, never_captured, no_fit, no_damping_data };

template <>
struct Names<LawVerdict> {
    static constexpr std::string_view kind = "verdict";
    static constexpr std::array<std::string_view, 5> all{"finite", "always-captured", "never-captured",
                                                         "no fit", "no damping data"};
};

/// The critical velocity of one law beside the others.
struct LawComparison {
    LawVerdict verdict = LawVerdict::no_fit;
    std::optional<VelocityEstimate> velocity{};      ///< where finite
    std::optional<VelocityEstimate> extrapolated{};  ///< by the paper's extrapolation of measured impacts
    std::string interval_note{};                     ///< why there is no interval
    std::optional<CriticalVelocityCheck> check{};    ///< against the measured one
};

/// A property of the contact that was not measured.
struct AssumedProperty {
    std::string quantity;  ///< "work of adhesion"
    Quantity value;
    Origin origin = Origin::assumed;
    std::string why{};  ///< may be empty
};

/// A value beside the published one.
struct Beside {
    double ours = 0;  ///< in the unit of the published one
    Quantity published{};
    double relative_difference = 0;  ///< [1]
};

/// A contact time beside the published one.
struct ContactTimeBeside {
    Law law;
    Quantity velocity;  ///< [m/s]
    Beside contact_time;
};

/// Published values of a sample beside ours.
struct PublishedBeside {
    std::string source{};
    std::optional<Beside> young_modulus{};
    std::vector<std::pair<std::string, Beside>> volume_fractions{};
    LawMap<Beside> critical_damping{}, critical_velocity{}, critical_contact_times{};
    std::vector<ContactTimeBeside> contact_times{};
};

/// A damping eta(e) through the impacts of a sample and the critical velocity of its eta(0), Tables 2 to 4.
struct DampingAndVelocity {
    DampingPolynomial damping{};  ///< of the second order [kg/s]
    std::optional<double>
        critical_velocity{};  ///< none: eta(0) captures at no velocity or at every one [m/s]
};

/// The same impacts by the paper's explicit scheme (Eqs. 31 to 34) and by exact solution.
struct SchemeBesideExact {
    DampingAndVelocity scheme{}, exact{};
};

/// A sample with its critical velocities side by side.
struct SampleComparison {
    std::string name{};
    std::optional<ReportedVelocity> reported{};
    std::optional<double> diameter{};                       ///< [m]
    std::optional<Quantity> density{}, work_of_adhesion{};  ///< [kg/m3], [J/m2]
    std::vector<AssumedProperty> assumed{};
    std::vector<std::string> taken_as_exact{};                     ///< properties without an uncertainty
    std::optional<Quantity> young_modulus{};                       ///< [Pa]
    std::optional<double> contact_modulus{}, separation_energy{};  ///< E* [Pa], W_s [J]
    double analytic_velocity = 0;                                  ///< v_s of Eq. 30 [m/s]
    LawMap<LawComparison> laws{};
    std::optional<Stated> measured{};            ///< critical velocity as measured [m/s]
    std::optional<bool> measured_by_outcomes{};  ///< true: not stated, but by captures and rebounds alone
    std::optional<Bounds> measured_interval{};   ///< [m/s]; also of outcomes that give bounds only
    std::optional<PublishedBeside> published{};
    std::optional<GlassEffect> glass{};              ///< where the case has oxides
    std::optional<TemperatureLimits> temperature{};  ///< where it has oxides or a temperature
    std::optional<ObliqueCurves> oblique{};          ///< where it has a friction
    LawMap<SchemeBesideExact> paper_explicit{};      ///< where it has the step of the paper's scheme
};

/// The impact of a sample by a law at one of the equal velocities.
struct ImpactAtVelocity {
    Law law;
    std::string sample;
    double restitution = 0, damping = 0;   ///< [1], [unit of the damping law]
    std::optional<double> contact_time{};  ///< [s]
    double maximum_overlap = 0;            ///< [m]
};

/// Samples and laws at the same incident velocity.
struct EqualVelocity {
    double velocity = 0;  ///< [m/s]
    std::vector<ImpactAtVelocity> impacts{};
};

/// Range of the ratio of dynamic to analytic velocities [1].
struct RatioRange {
    double least = 0, greatest = 0;
};

/// Result of the comparison stage, comparison.json.
struct ComparisonResult {
    std::string name{};                     ///< of the case
    std::optional<ReportedLaw> reported{};  ///< one law for all samples
    std::vector<SampleComparison> samples{};
    std::optional<Reproduction> reproduction{};     ///< where restitutions were reconstructed
    std::vector<EqualVelocity> equal_velocities{};  ///< from slow to fast
    std::optional<RatioRange> dynamic_over_analytic{};
    std::optional<DampingComparison> dampings{};  ///< none: too few impacts by the reported law
    std::vector<SizeVelocity> by_size{};          ///< by assumption, then from small to large
    std::optional<SizeSummary> sizes{};           ///< what they say together
    std::vector<LawBySize> laws_by_size{};        ///< those with a v_c without damping
    std::string conclusion{};                     ///< in words
};

}  // namespace ashimpact
