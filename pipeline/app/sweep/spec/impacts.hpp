// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pipeline/app/sweep/spec/spec.hpp"
#include "solver/batch/impact_batch.hpp"

namespace ashimpact {

/// Many impacts of a sweep [SI]: a value for each of them, or a single one for all; velocities are always one
/// for each. Columns refer to the variables that they are made from, or to values kept here.
class ImpactColumns {
  public:
    using Values = std::span<const double>;

    /// @param variables values of each variable of the sweep, as many of each [SI]; they must outlive this
    /// @param count how many of each
    ImpactColumns(const SweepSpec& spec, const std::vector<std::vector<double>>& variables,
                  std::size_t count);
    ImpactColumns(const ImpactColumns&) = delete;
    ImpactColumns& operator=(const ImpactColumns&) = delete;
    ImpactColumns(ImpactColumns&&) = delete;
    ImpactColumns& operator=(ImpactColumns&&) = delete;
    ~ImpactColumns() = default;

    Values mass;  ///< m*
    Values effective_radius;
    Values contact_modulus;
    Values work_of_adhesion;
    Values yield_pressure;
    Values damping;
    Values velocity;
    std::vector<std::pair<std::string_view, Values>> parameters;  ///< of contact laws, by name

  private:
    Values keep(Eigen::ArrayXd values);

    std::vector<Eigen::ArrayXd> kept_;
};

/// The value of impact @p i of a column.
[[nodiscard]] inline double value_at(std::span<const double> column, std::size_t i) {
    return column.size() == 1 ? column.front() : column[i];
}

/// Contact law, detachment and damping law of many impacts.
struct ImpactModel {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
};

/// Impacts of a sweep for the batch solver; the batch refers to @p impacts.
[[nodiscard]] ImpactBatch batch_of(const ImpactModel& model, const ImpactColumns& impacts);

}  // namespace ashimpact
