// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"
#include "solver/inference/impacts/damping_smoothing.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// The parts of eta(v_in) of Dong et al. 2013, section 4.2.
enum class DampingPart {
    falling,  ///< (i) near capture
    flat,     ///< (ii) little changed
    rising,   ///< (iii) plastic
};

template <>
struct Names<DampingPart> {
    static constexpr std::string_view kind = "part";
    static constexpr std::array<std::string_view, 3> all{"falling", "flat", "rising"};
};

/// Boundary between two parts.
struct PartBoundary {
    double velocity;              ///< [m/s]
    double standard_uncertainty;  ///< [m/s]
};

struct DampingParts {
    std::vector<DampingPart> parts;        ///< from slow to fast
    std::vector<PartBoundary> boundaries;  ///< between consecutive parts
    std::vector<std::size_t> outliers;     ///< indices in the set; flagged, but used like the others
    std::string note;                      ///< why there are no parts; empty if there are
};

struct PartOptions {
    double flatness = 0.25;  ///< eta is flat where |d ln eta/d ln v| is below this [1]
    double outlier = 4.0;    ///< robust standard deviations beyond which a rebound is flagged
};

/// Finds the parts of a smoothed eta(v_in). The flat part reaches from the least damping in both directions
/// up to where |d ln eta/d ln v| first exceeds the flatness. Beyond it eta must change by more than two
/// standard uncertainties, otherwise there is no falling or rising part.
[[nodiscard]] DampingParts find_parts(const std::optional<DampingSmoothing>& smoothing,
                                      const PartOptions& options = {});

/// The part of a measurement series in which restitution rises with velocity, captures included.
struct RisingBranch {
    MeasurementSet set;
    std::vector<std::size_t> indices;  ///< of its points in the whole set
    double upper;       ///< velocity at which e is greatest; infinite if outliers hide it [m/s]
    bool falls_beyond;  ///< e falls above that velocity; otherwise the series ends while e rises

    [[nodiscard]] bool is_hidden() const { return std::isinf(upper); }
};

/// The impacts up to the velocity of greatest smoothed restitution; all of them if restitution never falls by
/// more than two standard uncertainties. A series too short for smoothing is taken whole unless a rank test
/// (Kendall) shows that its restitution falls.
/// @param smoothing of the damping that @p model gives for @p set
/// @throws InputError if restitution falls with velocity from the slowest rebound on
[[nodiscard]] RisingBranch rising_branch(const ContactModel& model, const MeasurementSet& set,
                                         const std::optional<DampingSmoothing>& smoothing);

/// The impacts up to a known end of the rising branch, @p upper [m/s].
[[nodiscard]] RisingBranch impacts_up_to(const MeasurementSet& set, double upper);

}  // namespace ashimpact
