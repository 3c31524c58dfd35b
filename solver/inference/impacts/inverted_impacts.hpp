// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "core/quantities/names.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/numeric/gsl/interpolation.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// One measured impact with the damping that the dynamic model gives for it; Dong et al. 2013, Figures 6
/// to 8.
struct InvertedImpact {
    std::size_t index;                  ///< in the set
    double velocity;                    ///< v_in [m/s]
    double restitution;                 ///< e_n, 0 for a capture [1]
    double greatest_restitution = 0.0;  ///< without damping, the greatest that can be reached [1]
    /// The damping that gives the restitution; for a capture a lower bound, the least damping that captures;
    /// none if no damping gives the restitution [kg/s].
    std::optional<double> damping{};
    std::optional<double> standard_uncertainty{};  ///< of the damping, where that of the velocities is known
    std::optional<double> contact_time{};          ///< of a rebound [s]
};

/// Inverts every impact of a set, in its order. The uncertainty of a damping is that of both velocities, with
/// their correlation, propagated linearly.
[[nodiscard]] std::vector<InvertedImpact> invert(const ContactModel& model, const MeasurementSet& set);

/// Like invert(), but for any law, also one with a history (yield), by solving impacts. Takes milliseconds an
/// impact; derivatives are central differences.
[[nodiscard]] std::vector<InvertedImpact> invert_by_solving(Law law, Detachment detachment,
                                                            const ContactPair& contact,
                                                            const MeasurementSet& set);

/// Fewest rebounds that can be smoothed.
inline constexpr std::size_t least_smoothed = 8;

/// Damping over the logarithm of velocity as a robust cubic spline. Its knots lie at quantiles of the data,
/// and the corrected Akaike criterion chooses their number. Data without noise are interpolated: there the
/// neighbours of a point predict it better than such a spline does.
class DampingSmoothing {
  public:
    /// The smoothing of inverted impacts; none if fewer than least_smoothed rebounds have a damping, or fewer
    /// than four distinct velocities.
    [[nodiscard]] static std::optional<DampingSmoothing> of(const std::vector<InvertedImpact>& inverted);

    struct Value {
        double damping;                 ///< [kg/s]
        double standard_uncertainty;    ///< [kg/s]
        double elasticity;              ///< d ln eta/d ln v [1]
        double elasticity_uncertainty;  ///< standard [1]
    };
    /// @param velocity within [slowest(), fastest()] [m/s]
    [[nodiscard]] Value at(double velocity) const;
    [[nodiscard]] double slowest() const { return std::exp(first_); }
    [[nodiscard]] double fastest() const { return std::exp(last_); }
    /// Residual of each rebound in robust standard deviations, with its index in the set.
    struct Residual {
        std::size_t index;
        double value;
    };
    [[nodiscard]] const std::vector<Residual>& residuals() const { return residuals_; }

  private:
    struct Rows;

    /// With knots at @p breaks, without coefficients yet.
    DampingSmoothing(const Rows& rows, const std::vector<double>& breaks);

    gsl::BSpline splines_;
    Eigen::VectorXd coefficients_;
    Eigen::MatrixXd covariance_;
    std::vector<Residual> residuals_;
    double first_;  ///< ln v
    double last_;
    double criterion_ = 0.0;

    [[nodiscard]] static std::optional<DampingSmoothing> with_intervals(const Rows& rows, int intervals);
    [[nodiscard]] static std::optional<DampingSmoothing> robust(const Rows& rows);
    [[nodiscard]] static DampingSmoothing through(const Rows& rows);
    [[nodiscard]] std::vector<double> scaled_residuals(const Rows& rows) const;
};

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
