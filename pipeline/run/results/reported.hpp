// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"
#include "pipeline/case/values.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// The law by which a run reports its critical velocities.
struct ReportedLaw {
    Law law{};
    std::string reason{};  ///< in words
    /// The laws of the case that the contacts allow, the reported one among them, in the order of the case.
    /// How far their velocities lie apart is the uncertainty of the choice.
    std::vector<Law> admissible{};
};

/// What a reported velocity rests on.
enum class ReportedBasis {
    nothing,
    impacts,       ///< measured impacts
    reproduction,  ///< restitution reconstructed from published fits of damping
    outcomes,      ///< captures and rebounds alone: no law gives a velocity
};

template <>
struct Names<ReportedBasis> {
    static constexpr std::string_view kind = "basis";
    static constexpr std::array<std::string_view, 4> all{
        "nothing", "measured impacts", "published fits of damping", "outcomes of the impacts"};
};

/// The critical velocity of a sample to report.
struct ReportedVelocity {
    std::optional<Law> law{};                    ///< none: the impacts alone
    std::optional<VelocityEstimate> velocity{};  ///< none: only bounds are known, or nothing
    /// Of the velocity, the choice among the admissible laws included, or those bounds [m/s]. A reproduction
    /// has none: what dominates its error has no known distribution, see Reproduction.
    std::optional<Bounds> interval{};
    std::string reason{};  ///< in words
    ReportedBasis basis = ReportedBasis::nothing;
    /// True where the glass relaxes during the contact at the stated temperature: the velocity is no answer
    /// but a lower bound that elastic theory gives. None elsewhere.
    std::optional<bool> lower_bound{};
};

/// Least and greatest of velocities without a probability [m/s].
struct VelocitySpan {
    double least = 0, greatest = 0;

    void include(double value) {
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
};

/// What the reported velocity of a reproduced sample leaves open: each source alone, the others held. None of
/// them has a known distribution.
struct ReproducedSample {
    std::string name{};
    VelocitySpan laws{};                 ///< over the laws of the case that have adhesion
    std::optional<VelocitySpan> fits{};  ///< over the ranges of restitution and orders of polynomial
    VelocitySpan diameter{};             ///< for a diameter smaller and larger by diameter_change
};

/// How far a law is from the measured critical velocities of all samples together.
struct JointTest {
    double sum_of_squares = 0;  ///< of deviations over standard uncertainties, of model and measurement [1]
    std::size_t samples = 0;    ///< with a velocity by the law and a measured one
};

/// Samples whose restitutions follow from published fits of damping: their velocities reproduce a
/// publication, and are no measurement.
struct Reproduction {
    double diameter_change = 0;        ///< [m]
    std::vector<double> from{}, to{};  ///< ends of the ranges of restitution that are fitted [1]
    std::vector<double> orders{};      ///< of the polynomials
    std::vector<ReproducedSample> samples{};
    LawMap<JointTest> joint_tests{};  ///< empty without measured velocities
};

}  // namespace ashimpact
