// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "solver/contact/law.hpp"

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

/// How the impacts of a batch are solved; both keep the bound of solve_impacts().
enum class BatchMethod {
    integration,  ///< each impact is integrated
    table,  ///< e and contact time come from a table of the law's impacts. Its parts are integrated when they
            ///< are first needed, then kept. Impacts next to the edge of capture are integrated. Faster from
            ///< about 100,000 impacts on.
};

/// Name and length of a column, for messages.
struct NamedColumn {
    std::string_view name;
    Eigen::Index size;
};

/// The common length of all columns with more than one value; 1 if there is no such column.
/// @throws InputError if two lengths differ
[[nodiscard]] Eigen::Index common_size(const ContactColumns& contact, const std::vector<NamedColumn>& others);

}  // namespace ashimpact
