// SPDX-License-Identifier: GPL-3.0-or-later
// What the C and Python interfaces share: parameters by name, and calls of the batch solver.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "solver/batch/batch.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"
#include "solver/oblique/oblique_batch.hpp"

namespace ashimpact {

/// Parameters of every law; those of single laws follow, in the order of law_parameters().
enum class Parameter : std::size_t {
    density,
    mass,
    diameter,
    effective_radius,
    contact_modulus,
    work_of_adhesion,
    yield_pressure,
    damping,
    velocity,
    restitution,
    tangential_velocity,
    spin,
    friction,
    sphere_radius,  ///< where effective_radius is that of two spheres
    sphere_mass,    ///< likewise
};
/// Room for all parameters, those of laws included.
inline constexpr std::size_t most_parameters = 24;

[[nodiscard]] inline std::size_t place_of(Parameter parameter) {
    return static_cast<std::size_t>(parameter);
}
[[nodiscard]] std::string_view name_of(Parameter parameter);
/// The parameter of that name. @throws InputError naming all of them
[[nodiscard]] Parameter parameter_named(std::string_view name);
/// What may be set instead: mass for density, diameter for effective_radius, vice versa; others: themselves.
[[nodiscard]] Parameter alternative_to(Parameter parameter);
/// A contact law, how its contacts end and how they are damped.
struct ModelChoice {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
};
/// A line on a parameter that changes nothing with the laws, empty if it counts.
[[nodiscard]] std::string note_on(const ModelChoice& choice, Parameter parameter);

/// Mass of a sphere [kg] from density [kg/m3] and diameter [m]. All interfaces use it, so that their results
/// agree bit by bit: the order of the factors matters.
[[nodiscard]] inline double mass_of_sphere(double density, double diameter) {
    return density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

/// Numbers of consecutive problems: that of problem i is values[i * stride]. Null values: not set.
struct Strided {
    const double* values = nullptr;
    std::size_t stride = 0;

    [[nodiscard]] double operator[](std::size_t i) const { return values[i * stride]; }
};

/// A constant (stride 0) or a column for each parameter. Setting one unsets its alternative.
class Parameters {
  public:
    void set(Parameter parameter, Strided source);
    /// The source of a parameter; its values are null if it was not set.
    [[nodiscard]] const Strided& operator[](Parameter parameter) const {
        return sources_[place_of(parameter)];
    }
    [[nodiscard]] bool has(Parameter parameter) const { return (*this)[parameter].values != nullptr; }
    /// @throws InputError naming what the law needs and is missing: a modulus, a radius, a mass ...
    void require_contact(Law law) const;
    /// @throws InputError if the parameter is not set
    void require(Parameter parameter) const;

  private:
    std::array<Strided, most_parameters> sources_{};
};

/// The choice of these names; null: the law's default detachment, constant damping. @throws InputError
[[nodiscard]] ModelChoice choice_named(const char* law, const char* detachment, const char* damping_law);

/// Problems of one call.
struct Call {
    ModelChoice choice;
    Parameters parameters;
    std::size_t count;                    ///< of problems
    int threads = 1;                      ///< 0: one per core; results do not depend on it
    std::size_t chunk = 2048;             ///< problems solved at a time
    std::function<void()> after_chunk{};  ///< may throw, which ends the call
    bool as_alone = false;                ///< the bits of calls of one problem each
};

/// Arrays for the results, of call.count numbers each; null for a result that is not needed.
struct DampingOutputs {
    double* damping = nullptr;               ///< NaN if none gives the restitution [unit of the damping law]
    double* greatest_restitution = nullptr;  ///< restitution without damping [1]
};

/// Arrays for the results of impacts, at an angle too.
struct ImpactOutputs {
    BatchOutputs normal{};
    TangentialOutputs tangential{};
    std::optional<BatchMethod> method{};  ///< none: method_of_many(), unless turning points are wanted
};

/// Solves impacts, by default from tables unless approach time or maximum overlap are needed. Results at an
/// angle need friction, and the tangential velocity or the spin.
/// @throws InputError, ConvergenceError, like the next two, naming the first problem of several that fails
void solve_impacts(const Call& call, const ImpactOutputs& outputs);
/// Solves critical velocities [m/s]: 0 if no impact is captured, infinity if every impact is. From tables
/// where that pays for so many.
void solve_critical_velocities(const Call& call, double* critical_velocity);
/// Solves for the damping that gives each restitution.
void solve_dampings(const Call& call, const DampingOutputs& outputs);

}  // namespace ashimpact
