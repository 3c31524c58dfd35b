#pragma once

#include "solver/measurement/measurement.hpp"

#include <optional>

namespace ashimpact {

/// Where captures turn into rebounds: P(capture at v) = Phi((center - v)/width), width^2 the variance of the
/// noise of v_in plus extra_variance.
struct CaptureTransition {
    double center;          ///< [m/s]
    double extra_variance;  ///< 0 if the noise explains how outcomes mix [m2/s2]
};

/// -2 ln L of the outcomes of a series with captures and rebounds.
class OutcomeLikelihood {
  public:
    /// @param set with captures and rebounds, validated
    /// @param least width at which outcomes without known noise are told apart [m/s]
    OutcomeLikelihood(const MeasurementSet& set, double least) : set_(&set), least_(least) {}

    [[nodiscard]] double at(const CaptureTransition& transition) const;

    /// The most likely centre at this extra variance; there is one, as -2 ln L is convex in it. If outcomes
    /// are so far apart that any centre between them is as likely, it is their middle. Can be negative.
    [[nodiscard]] double best_center(double extra_variance) const;

    /// -2 ln L at a centre with the extra variance that is likeliest there, up to the range of v_in squared.
    [[nodiscard]] double profile(double center) const;

    /// The most likely transition; it has an extra variance only if that makes the outcomes likelier.
    /// @return none if no width up to the range of v_in explains the outcomes better than chance that does
    /// not depend on the velocity, or if the centre is not positive
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
