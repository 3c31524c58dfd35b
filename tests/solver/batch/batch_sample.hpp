// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "solver/batch/batch.hpp"

namespace ashimpact::test {

/// Columns of impacts that own their values.
struct Impacts {
    Law law = Law::of<Hertz>();
    Detachment detachment = Detachment::zero_overlap;
    DampingLaw damping_law = DampingLaw::constant;
    Eigen::ArrayXd mass{};
    Eigen::ArrayXd effective_radius{};
    Eigen::ArrayXd contact_modulus{};
    Eigen::ArrayXd work_of_adhesion{};
    Eigen::ArrayXd yield_pressure = never_yields;  ///< one value for all unless the law yields
    Eigen::ArrayXd damping{};
    Eigen::ArrayXd velocity{};
    using Parameters = std::map<std::string_view, Eigen::ArrayXd>;
    Parameters parameters{};  ///< of laws, by name

    [[nodiscard]] Eigen::Index size() const { return velocity.size(); }
    [[nodiscard]] ImpactBatch batch() const;
    [[nodiscard]] Impact at(Eigen::Index i) const;
    /// Those at these places, in this order.
    [[nodiscard]] Impacts picked(const std::vector<Eigen::Index>& places) const;
};

/// "dmt, tsuji, zero-overlap".
[[nodiscard]] std::string name_of(const Impacts& impacts);

/// Every law with a batch kernel with every detachment admissible for it and every damping law, @p count
/// impacts each: fly ash of 0.5 to 100 micrometres at 0.01 to 20 m/s, damping numbers evenly from 0 to @p
/// most_damping.
[[nodiscard]] std::vector<Impacts> random_impacts(Eigen::Index count, double most_damping,
                                                  std::uint64_t seed);

/// Those of one law with the detachment registered last and Tsuji's damping.
[[nodiscard]] Impacts random_impacts_of(Law law, Eigen::Index count, double most_damping, std::uint64_t seed);

/// The ways to solve a batch: table only where that pays for any number of impacts.
[[nodiscard]] std::vector<BatchMethod> methods_of(const Impacts& impacts);

/// Greatest conditioned_error() of a batch of that law [1].
[[nodiscard]] double bound_of(Law law);

/// |e^2 - e_ref^2| / (1 + |U_min|/(m v^2/2)), the error in units of the problem's conditioning [1].
[[nodiscard]] double conditioned_error(double restitution, const ImpactResult& reference);

/// Whether two results are the same, bit by bit; NaN equals NaN.
[[nodiscard]] bool identical(const ImpactBatchResult& a, const ImpactBatchResult& b);

}  // namespace ashimpact::test
