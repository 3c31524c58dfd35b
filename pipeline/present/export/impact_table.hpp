// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "pipeline/present/export/subject.hpp"

namespace ashimpact {

/// What impacts of a subject do, for codes that look them up: over the diameter and over
///
///     t = asinh(sqrt(v/v_0(d) - 1)),   v = v_0(d) (1 + sinh^2 t),
///
/// in which e is smooth, though as a function of v it rises from v_c with a vertical tangent. v_0 is v_c
/// where that is finite, else the smallest velocity of the table.
///
/// A reader takes ln v_0 between two diameters from the cubic in ln d that has the values and slopes there,
/// and e linearly in ln d and t. A velocity below v_c is a capture; one outside the table's range is refused.
struct ImpactTable {
    /// Rising; evenly in ln d between the known sizes, at which v_0 may have a kink: there two diameters
    /// differ by kink_width, with the slopes of either side [m].
    std::vector<double> diameter;
    std::vector<double> start_velocity;  ///< v_0 of each diameter [m/s]
    std::vector<double> slope;           ///< d ln v_0 / d ln d [1]
    bool captures = false;               ///< v_0 is v_c; else nothing is captured
    std::vector<double> t;               ///< rising, evenly, from 0 [1]
    Eigen::ArrayXXd velocity;            ///< (diameter, t) [m/s]
    Eigen::ArrayXXd damping;             ///< coefficient [unit of the damping law]
    Eigen::ArrayXXd restitution;         ///< 0 at v_c [1]
    Eigen::ArrayXXd contact_time;        ///< not a number at v_c [s]
    /// Time integral of the attraction over m v, on which friction acts too; at v_c that of the next node.
    /// Empty without friction, and without adhesion [1].
    Eigen::ArrayXXd attraction{};
    double from_velocity = 0;  ///< smallest velocity [m/s]; 0 where there are captures
    double to_velocity = 0;    ///< largest velocity [m/s]
    double largest_error = 0;  ///< |de| found between the nodes [1]
};

/// |de| that a table keeps between its nodes [1].
inline constexpr double table_accuracy = 2e-4;

/// Relative error of v_c that a table keeps between its sizes; it has none at them [1].
inline constexpr double table_threshold_accuracy = 1e-8;

/// Relative distance of the two diameters at a known size [1].
inline constexpr double kink_width = 1e-12;

/// Makes the table, as fine as the accuracy needs it. @throws InputError where every impact is captured, only
/// some sizes have a critical velocity, spheres are captured above it, or a table of reasonable size does not
/// reach the accuracy
[[nodiscard]] ImpactTable make_impact_table(const ExportSubject& subject);

/// v_0 at a diameter within the table's range [m/s].
[[nodiscard]] double start_velocity(const ImpactTable& table, double diameter);

/// e of the table, 0 for a capture [1]. Diameter and velocity must be within its range.
[[nodiscard]] double restitution(const ImpactTable& table, double diameter, double velocity);

}  // namespace ashimpact
