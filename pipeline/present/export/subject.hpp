// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// A point of the damping against the incident velocity.
struct DampingNode {
    double velocity;     ///< v_in [m/s]
    double coefficient;  ///< [unit of the damping law]
};

/// The damping of every exported particle: coefficient(d, v_in) = c(v_in) (d/d_0)^n. c is piecewise linear
/// through the nodes and constant before the first and after the last. One node: no dependence on velocity.
/// n = 0 gives every size the same damping; n = 2 gives, with constant damping, Hertz spheres of one material
/// the same restitution at every size (m ~ d^3 and k ~ sqrt(d) in beta = eta/(m^(3/5) k^(2/5) v^(1/5))).
struct SizedDamping {
    DampingLaw law = DampingLaw::constant;
    std::vector<DampingNode> nodes{};  ///< at least one; velocities rise
    double reference_diameter = 0;     ///< d_0 [m]
    double exponent = 0;               ///< n [1]

    [[nodiscard]] bool depends_on_velocity() const { return nodes.size() > 1; }
    /// [unit of the damping law]
    [[nodiscard]] double coefficient(double diameter, double velocity) const;
    /// Whether there is no damping at any velocity.
    [[nodiscard]] bool is_zero() const;
};

/// The sphere that a particle meets where there is no wall.
struct PartnerBody {
    double radius;  ///< [m]
    double mass;    ///< [kg]
};

/// The contact that a softened one stands for, with the same restitutions.
struct StiffContact {
    double factor;  ///< S > 1, by which E* was divided [1]
    ContactPair contact;
    std::vector<DampingNode> nodes;
};

/// Subject of an export: one kind of particle on one flat wall, or on one other sphere, over a range of sizes
/// and velocities. E*, w and density are the same for every size; on a wall R* = d/2.
struct ExportSubject {
    Law law;
    Detachment detachment;
    ContactPair contact;  ///< of the reference size
    double density;       ///< [kg/m3]
    SizedDamping damping;
    double from_diameter;                  ///< [m]
    double to_diameter;                    ///< not below from_diameter [m]
    std::optional<PartnerBody> partner{};  ///< the other body is this sphere; none: it is a flat wall
    std::optional<double> to_velocity{};   ///< largest v_in; none: ten times the largest v_c, at least 10 m/s
    std::optional<double> velocity{};      ///< of one more impact to check [m/s]
    std::vector<std::string> origins{};    ///< sources of E, w and damping, a line each
    std::optional<StiffContact> stiff{};   ///< what contact and damping were before they were softened

    [[nodiscard]] double reference_diameter() const { return damping.reference_diameter; }
    [[nodiscard]] bool one_size() const { return from_diameter == to_diameter; }
};

/// The subject with E* divided by a factor above 1, and all that goes with it. @throws InputError
[[nodiscard]] ExportSubject softened(ExportSubject subject, double factor);

/// The subject before softening; itself if it is not softened.
[[nodiscard]] ExportSubject stiffened(ExportSubject subject);

/// Factor of the softened contact's times and overlaps; 1 if the subject is not softened [1].
[[nodiscard]] double stretch_of(const ExportSubject& subject);

/// @throws InputError if the subject has a partner. @param reason why the code can only do a wall
void require_wall(const ExportSubject& subject, const std::string& reason);

/// The mass of a particle of that diameter [m], in kg.
[[nodiscard]] double particle_mass(const ExportSubject& subject, double diameter);

/// The contact of a sphere of that diameter [m].
[[nodiscard]] ContactPair contact_at(const ExportSubject& subject, double diameter);

/// One impact of the subject. @param diameter [m] @param velocity [m/s]
[[nodiscard]] Impact impact_at(const ExportSubject& subject, double diameter, double velocity);

/// The verdict of a size, its v_c where that is finite. Damping that depends on velocity: the velocity at
/// which v_in = v_c(damping(v_in)). @throws InputError if there are several
[[nodiscard]] CriticalVelocity threshold_at(const ExportSubject& subject, double diameter);

/// Which part of a run is exported.
struct RunChoice {
    std::string folder;  ///< of the artifacts
    std::string sample;
    std::string law;               ///< empty: the first of the run's
    bool follow_velocity = false;  ///< damping from the fit eta(e) along v_in instead of the critical one
};

/// A sample of a run with its contact (2-contact.json), its critical damping (7-critical-velocity.json or
/// 6-fit.json) or its fit eta(e) over the rising branch (6-fit.json, 5-damping.json). Sizes: its own alone.
/// @throws InputError naming the file
[[nodiscard]] ExportSubject subject_of_run(const RunChoice& choice);

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
    std::vector<double> diameter;        ///< rising, evenly in ln d [m]
    std::vector<double> start_velocity;  ///< v_0 of each diameter [m/s]
    std::vector<double> slope;           ///< d ln v_0 / d ln d [1]
    bool captures = false;               ///< v_0 is v_c; else nothing is captured
    std::vector<double> t;               ///< rising, evenly, from 0 [1]
    Eigen::ArrayXXd velocity;            ///< (diameter, t) [m/s]
    Eigen::ArrayXXd damping;             ///< coefficient [unit of the damping law]
    Eigen::ArrayXXd restitution;         ///< 0 at v_c [1]
    Eigen::ArrayXXd contact_time;        ///< not a number at v_c [s]
    double from_velocity = 0;            ///< smallest velocity [m/s]; 0 where there are captures
    double to_velocity = 0;              ///< largest velocity [m/s]
    double largest_error = 0;            ///< |de| found between the nodes [1]
};

/// |de| that a table keeps between its nodes [1].
inline constexpr double table_accuracy = 2e-4;

/// Relative error of v_c that a table keeps between its sizes; it has none at them [1].
inline constexpr double table_threshold_accuracy = 1e-8;

/// Makes the table, as fine as the accuracy needs it. @throws InputError where every impact is captured, only
/// some sizes have a critical velocity, the damping of several sizes follows the velocity, or a table of
/// reasonable size does not reach the accuracy
[[nodiscard]] ImpactTable make_impact_table(const ExportSubject& subject);

/// v_0 at a diameter within the table's range [m/s].
[[nodiscard]] double start_velocity(const ImpactTable& table, double diameter);

/// e of the table, 0 for a capture [1]. Diameter and velocity must be within its range.
[[nodiscard]] double restitution(const ImpactTable& table, double diameter, double velocity);

}  // namespace ashimpact
