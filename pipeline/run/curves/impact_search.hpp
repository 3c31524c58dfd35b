// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "pipeline/case/case.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact::curves {

struct SearchedContact {
    LawChoice choice;
    DampingLaw damping_law;
    ContactPair pair;
};

/// Impacts of wanted restitutions. NaN where none was found.
struct FoundImpacts {
    Eigen::ArrayXd velocity;      ///< [m/s]
    Eigen::ArrayXd contact_time;  ///< [s]
};

/// The impacts of given dampings that have these restitutions, all at once.
/// @param e restitutions, above 0 [1]
/// @param damping of each [unit of the damping law]
/// @param guess of each velocity [m/s]
/// @param enough change of ln v that ends a search
[[nodiscard]] FoundImpacts impacts_with(const Eigen::ArrayXd& e, const SearchedContact& contact,
                                        const Eigen::ArrayXd& damping, const Eigen::ArrayXd& guess,
                                        double enough);

}  // namespace ashimpact::curves
