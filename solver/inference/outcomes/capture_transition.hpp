// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// The transition from captures to rebounds: P(capture at v) = Phi((center - v)/width), where width^2 is the
/// variance of v_in plus an extra variance.
struct CaptureTransition {
    double center;          ///< [m/s]
    double extra_variance;  ///< in addition to the noise; 0 if the noise explains the mixing [m2/s2]
};

/// -2 ln L of the outcomes of a series with captures and rebounds. Of large sets, neighbours of the same
/// outcome within a tenth of their noise are merged.
class OutcomeLikelihood {
  public:
    /// @param set with captures and rebounds, validated
    /// @param least standard deviation of v_in in place of an unknown noise [m/s]
    OutcomeLikelihood(const MeasurementSet& set, double least);

    /// -2 ln L.
    [[nodiscard]] double misfit(const CaptureTransition& transition) const;

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
    struct Outcome {
        double velocity;
        double variance;     ///< of v_in
        double sign;         ///< 1 for a capture, -1 for a rebound
        double count = 1.0;  ///< impacts merged into this one
    };

    void merge();
    template <class Term>
    [[nodiscard]] double sum_of(const CaptureTransition& transition, const Term& term) const;
    [[nodiscard]] double slope(const CaptureTransition& transition) const;
    [[nodiscard]] double variance_slope(const CaptureTransition& transition) const;
    [[nodiscard]] double best_extra_variance(double center) const;
    [[nodiscard]] double without_threshold() const;
    [[nodiscard]] CaptureTransition at_best_width() const;

    std::vector<Outcome> outcomes_;
    double noise_;     ///< variance of v_in of the first impact
    double slowest_;   ///< v_in
    double fastest_;   ///< v_in
    double middle_;    ///< between the fastest capture and the slowest rebound
    double captured_;  ///< share of captures
    double reversed_;  ///< reversed_share()
};

/// Share of the pairs of a capture and a rebound in which the capture is the faster (Mann and Whitney 1947);
/// pairs of equal velocity count half.
[[nodiscard]] double reversed_share(const MeasurementSet& set);

}  // namespace ashimpact
