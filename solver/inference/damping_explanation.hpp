// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "solver/contact/pair.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// The impacts of one sphere.
struct ImpactsOfSphere {
    ContactPair contact;
    std::vector<Measurement> impacts;
};

/// A constant of a damping law.
struct DampingConstant {
    std::string_view name;   ///< "damping", or that of a parameter of the law
    double value = 0;        ///< [SI unit of its dimension]
    double uncertainty = 0;  ///< standard, from the differences that remain [SI]
    Dimension dimension = Dimension::fraction;
};

/// How well one damping law explains the impacts of all spheres with the same constants.
struct DampingExplanation {
    DampingLaw law = DampingLaw::constant;
    std::vector<DampingConstant> constants{};  ///< empty: the impacts do not tell them apart
    std::optional<double> correlation{};       ///< of two constants [1]
    double misfit = 0;                         ///< root mean square of e as measured less e as computed [1]
    /// Of each sphere with the constants; none where it was not found or there are no constants.
    std::vector<std::optional<CriticalVelocity>> velocities{};
};

/// Constants with a greater correlation are not told apart [1].
inline constexpr double greatest_correlation = 0.98;

/// Every damping law with those constants that minimise the squared differences of e, captures counted as e =
/// 0. Neighbouring impacts are averaged where there are many.
/// @param spheres with at least one rebound among them @throws InputError for fewer than three impacts
[[nodiscard]] std::vector<DampingExplanation> explain_by_damping(Law law, Detachment detachment,
                                                                 std::span<const ImpactsOfSphere> spheres);

/// The contact of a sphere with the parameters of the damping law that explains, which has its constants.
[[nodiscard]] ContactPair contact_with(const DampingExplanation& explanation, const ContactPair& contact);

}  // namespace ashimpact
