// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/present/export/sized_ash.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// The sphere that a particle meets where there is no wall.
struct PartnerBody {
    double radius;  ///< [m]
    double mass;    ///< [kg]
};

/// The contact that a softened one stands for, with the same restitutions.
struct StiffContact {
    double factor;  ///< S > 1, by which E* was divided [1]
    std::vector<AshSize> sizes;
};

/// An impact of the laboratory.
struct LaboratoryImpact {
    double velocity;     ///< v_in [m/s]
    double restitution;  ///< 0 for a capture [1]
};

/// The impacts that the damping of one size follows.
struct Laboratory {
    std::string sample;
    double diameter;                          ///< [m]
    bool reconstructed = false;               ///< from a published fit; else measured
    std::vector<LaboratoryImpact> impacts{};  ///< by rising velocity
};

/// Subject of an export: one kind of particle on one flat wall, or on one other sphere, over a range of sizes
/// and velocities. On a wall R* = d/2.
struct ExportSubject {
    Law law;
    Detachment detachment;
    DampingLaw damping_law = DampingLaw::constant;
    std::vector<AshSize> sizes;  ///< that are known; at least one, diameters rise
    double from_diameter;        ///< [m]
    double to_diameter;          ///< not below from_diameter [m]
    /// n of the damping beyond the known sizes, which goes with (d/d_0)^n. 0 gives every size the damping of
    /// the known one, 2 with constant damping Hertz spheres of one material the same restitution (m ~ d^3 and
    /// k ~ sqrt(d) in beta = eta/(m^(3/5) k^(2/5) v^(1/5))).
    double exponent = 0;
    std::optional<PartnerBody> partner{};  ///< the other body is this sphere; none: it is a flat wall
    std::optional<double> to_velocity{};   ///< largest v_in; none: ten times the largest v_c, at least 10 m/s
    std::optional<double> velocity{};      ///< of one more impact to check [m/s]
    double friction = 0;                   ///< coefficient of Coulomb friction; 0: none was asked for [1]
    std::vector<std::string> origins{};    ///< sources of E and w, without a run also of damping, a line each
    std::vector<std::string> dampings{};   ///< of a run: the damping of each sample, a line each
    std::vector<std::string> edits{};      ///< of a run: its artifacts that were edited, a line each
    std::vector<std::string> doubts{};     ///< of a run at a temperature, a line each
    std::vector<Laboratory> laboratory{};  ///< of a run; a sample each
    std::optional<StiffContact> stiff{};   ///< what contact and damping were before they were softened

    /// The one known size; of several the first.
    [[nodiscard]] const AshSize& reference() const { return sizes.front(); }
    [[nodiscard]] bool one_size() const { return from_diameter == to_diameter; }
    /// Whether a size of the range lies beyond the known ones.
    [[nodiscard]] bool goes_beyond_sizes() const {
        return from_diameter < sizes.front().diameter || to_diameter > sizes.back().diameter;
    }
    [[nodiscard]] bool depends_on_velocity() const;  ///< the damping of a size does
    [[nodiscard]] bool is_undamped() const;          ///< at any size and velocity
};

/// The subject with E* divided by a factor above 1, and all that goes with it. @throws InputError
[[nodiscard]] ExportSubject softened(ExportSubject subject, double factor);

/// The subject before softening; itself if it is not softened.
[[nodiscard]] ExportSubject stiffened(ExportSubject subject);

/// The subject with the damping that each size has at one velocity, at every velocity [m/s].
[[nodiscard]] ExportSubject with_damping_at(ExportSubject subject, double velocity);

/// Factor of the softened contact's times and overlaps; 1 if the subject is not softened [1].
[[nodiscard]] double stretch_of(const ExportSubject& subject);

/// @throws InputError if the subject has a partner. @param reason why the code can only do a wall
void require_wall(const ExportSubject& subject, const std::string& reason);

/// The ash of a diameter, and of it by the formulas of a piece.
[[nodiscard]] AshBetween ash_at(const ExportSubject& subject, double diameter);
[[nodiscard]] AshBetween ash_at(const ExportSubject& subject, double diameter, std::size_t piece);

/// The mass of a particle of that diameter [m], in kg.
[[nodiscard]] double particle_mass(const ExportSubject& subject, double diameter);

/// The contact of a sphere of that diameter [m].
[[nodiscard]] ContactPair contact_at(const ExportSubject& subject, double diameter);

/// One impact of the subject. @param diameter [m] @param velocity [m/s]
/// @throws InputError if the damping follows the velocity and the size has no finite v_c
[[nodiscard]] Impact impact_at(const ExportSubject& subject, double diameter, double velocity);

/// The same where v_c of that size is known [m/s].
[[nodiscard]] Impact impact_above(const ExportSubject& subject, double diameter, double velocity,
                                  double critical);

/// The verdict of a size, its v_c where that is finite: that of its critical damping.
/// @throws InputError if there are several
[[nodiscard]] CriticalVelocity threshold_at(const ExportSubject& subject, double diameter);

/// The same by the formulas of a piece.
[[nodiscard]] CriticalVelocity threshold_at(const ExportSubject& subject, double diameter, std::size_t piece);

/// Says that a size has no one critical velocity. @throws InputError
[[noreturn]] void refuse_several(double diameter);

}  // namespace ashimpact
