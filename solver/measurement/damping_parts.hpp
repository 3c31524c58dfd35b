#pragma once

#include "materials/base/names.hpp"
#include "solver/measurement/contact_model.hpp"
#include "solver/measurement/damping_smoothing.hpp"

#include <string>
#include <string_view>
#include <vector>

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

/// Between two parts.
struct PartBoundary {
    double velocity;              ///< [m/s]
    double standard_uncertainty;  ///< [m/s]
};

struct DampingParts {
    std::vector<DampingPart> parts;        ///< from slow to fast
    std::vector<PartBoundary> boundaries;  ///< one fewer
    std::vector<std::size_t> outliers;     ///< indices in the set; flagged, not left out
    std::string note;                      ///< why there are no parts; else empty
};

struct PartOptions {
    double flatness = 0.25;  ///< eta is flat where |d ln eta/d ln v| is below this [1]
    double outlier = 4.0;    ///< robust standard deviations beyond which a rebound is flagged
};

/// Finds the parts: from the least smoothed damping outwards, flat up to where |d ln eta/d ln v| first
/// exceeds the flatness. A falling or rising part must change eta by more than two standard uncertainties.
[[nodiscard]] DampingParts find_parts(const std::optional<DampingSmoothing>& smoothing,
                                      const PartOptions& options = {});

/// The part of a measurement series in which restitution rises with velocity, captures included.
struct RisingBranch {
    MeasurementSet set;
    std::vector<std::size_t> indices;  ///< of its points in the whole set
    double upper;                      ///< velocity at which e is greatest [m/s]
    bool falls_beyond;                 ///< e falls beyond that; otherwise the series ends while it rises
};

/// Everything up to the velocity of greatest smoothed restitution; the whole series if restitution never
/// falls by more than two standard uncertainties. A series too short to be smoothed is taken whole, unless a
/// rank test (Kendall) finds that restitution falls.
/// @param smoothing of the damping that @p model gives for @p set
/// @throws InputError if restitution falls with velocity from the slowest rebound on
[[nodiscard]] RisingBranch rising_branch(const ContactModel& model, const MeasurementSet& set,
                                         const std::optional<DampingSmoothing>& smoothing);

}  // namespace ashimpact
