#pragma once

#include "solver/measurement/measurement.hpp"

#include <optional>

namespace ashimpact {

/// The transition from captures to rebounds: P(capture at v) = Phi((center - v)/width), where width^2 is the
/// variance of v_in plus an extra variance.
struct CaptureTransition {
    double center;          ///< [m/s]
    double extra_variance;  ///< in addition to the noise; 0 if the noise explains the mixing [m2/s2]
};

/// -2 ln L of the outcomes of a series with captures and rebounds.
class OutcomeLikelihood {
  public:
    /// @param set with captures and rebounds, validated
    /// @param least standard deviation of v_in in place of an unknown noise [m/s]
    OutcomeLikelihood(const MeasurementSet& set, double least) : set_(&set), least_(least) {}

    [[nodiscard]] double at(const CaptureTransition& transition) const;

    /// The most likely centre at an extra variance. It is unique because -2 ln L is convex in the centre;
    /// between outcomes far apart, where -2 ln L is flat, it is their middle. Can be negative [m/s].
    [[nodiscard]] double best_center(double extra_variance) const;

    /// -2 ln L at a centre with the extra variance that is likeliest there, up to the range of v_in squared.
    [[nodiscard]] double profile(double center) const;

    /// The most likely transition, with an extra variance only if that makes the outcomes more likely.
    /// @return none where no extra width up to the range of v_in explains them better than outcomes that do
    /// not depend on the velocity, or the centre is not positive
    [[nodiscard]] std::optional<CaptureTransition> best() const;

  private:
    [[nodiscard]] double slope(const CaptureTransition& transition) const;
    [[nodiscard]] double variance_slope(const CaptureTransition& transition) const;
    [[nodiscard]] double best_extra_variance(double center) const;
    [[nodiscard]] double deviation_of(const Measurement& point, double extra_variance) const;
    [[nodiscard]] double without_threshold() const;
    [[nodiscard]] CaptureTransition at_best_width() const;

    const MeasurementSet* set_;
    double least_;
};

/// Share of the pairs of a capture and a rebound in which the capture is the faster (Mann and Whitney 1947);
/// pairs of equal velocity count half.
[[nodiscard]] double reversed_share(const MeasurementSet& set);

}  // namespace ashimpact
