// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "solver/motion/impact.hpp"

namespace ashimpact {

/// One value for each impact, or a single value for all of them. A column made from an array refers to it;
/// the array must outlive the column and its copies. A column made from an expression holds the values; its
/// copies refer to it.
using Column = Eigen::Ref<const Eigen::ArrayXd>;

/// Column of an infinite yield pressure, for contacts that stay elastic [Pa].
inline const Eigen::ArrayXd never_yields =
    Eigen::ArrayXd::Constant(1, std::numeric_limits<double>::infinity());

/// The values of a law parameter.
struct ParameterColumn {
    std::string_view name;  ///< that of a LawParameter; it must outlive the column
    Column values;          ///< [SI]
};

/// Columns of one value each. @param values must outlive the columns
[[nodiscard]] std::vector<ParameterColumn> single_columns(const ParameterValues<double>& values);

/// The contact pairs of a batch, as ContactPair.
struct ContactColumns {
    Column mass;                                ///< effective mass m* [kg]
    Column effective_radius;                    ///< R* [m]
    Column contact_modulus;                     ///< E* [Pa]
    Column work_of_adhesion;                    ///< w [J/m2]
    Column yield_pressure = never_yields;       ///< p_y [Pa]
    std::vector<ParameterColumn> parameters{};  ///< of laws that declare parameters of their own
};

/// Many impacts of one law, one damping law and one detachment.
struct ImpactBatch {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
    ContactColumns contact;
    Column damping;   ///< coefficient of the damping law [unit of the law]
    Column velocity;  ///< v_in > 0 [m/s]
};

/// The columns of impacts that have law, detachment, damping law and law parameters in common.
class ImpactList {
  public:
    /// @param impacts at least one; what they have in common is taken from the first
    explicit ImpactList(const std::vector<Impact>& impacts);

    /// It refers to these columns.
    [[nodiscard]] ImpactBatch batch() const;

  private:
    Impact first_;
    Eigen::Array<double, Eigen::Dynamic, 7> columns_;  ///< those of ContactColumns, damping, velocity
};

}  // namespace ashimpact
