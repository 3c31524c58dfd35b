// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of C and Python: numbers by name, for the batch solver.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string_view>

#include "solver/batch/batch.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Parameters of calls by name; those of laws follow, in the order of law_parameters().
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
};
/// Most names that there may be.
inline constexpr std::size_t most_parameters = 24;

[[nodiscard]] inline std::size_t place_of(Parameter parameter) {
    return static_cast<std::size_t>(parameter);
}
[[nodiscard]] std::string_view name_of(Parameter parameter);
/// The parameter of that name. @throws InputError naming all of them
[[nodiscard]] Parameter parameter_named(std::string_view name);
/// Mass for density, diameter for effective_radius, and back; the same parameter for others.
[[nodiscard]] Parameter alternative_to(Parameter parameter);
/// @throws InputError for a parameter that only other laws declare
void require_taken(Law law, Parameter parameter);

/// Mass of a sphere [kg] of a density [kg/m3] and a diameter [m]; every way through the interface multiplies
/// in this order, so that results agree bit by bit.
[[nodiscard]] inline double mass_of_sphere(double density, double diameter) {
    return density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

/// Numbers for consecutive problems: value i at values[i stride]; none where values is null.
struct Strided {
    const double* values = nullptr;
    std::size_t stride = 0;

    [[nodiscard]] double operator[](std::size_t i) const { return values[i * stride]; }
};

/// A constant or a column for each parameter; setting one removes its alternative.
class Parameters {
  public:
    void set(Parameter parameter, Strided source);
    /// The source of a parameter; its values are null where it was not set.
    [[nodiscard]] const Strided& operator[](Parameter parameter) const {
        return sources_[place_of(parameter)];
    }
    [[nodiscard]] bool has(Parameter parameter) const { return (*this)[parameter].values != nullptr; }
    /// @throws InputError naming what a contact lacks
    void require_contact() const;
    void require(Parameter parameter) const;

  private:
    std::array<Strided, most_parameters> sources_{};
};

/// A contact law, how its contacts end and how they are damped.
struct Choice {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
};
/// The choice of these names; NULL: the law's own detachment, constant damping. @throws InputError
[[nodiscard]] Choice choice_named(const char* law, const char* detachment, const char* damping_law);

/// Problems of one call.
struct Call {
    Choice choice;
    Parameters parameters;
    std::size_t count;
    int threads = 1;                      ///< 0: one for each core; no bit of a result depends on it
    std::size_t chunk = 2048;             ///< problems at a time
    std::function<void()> after_chunk{};  ///< may throw, which ends the call
};

/// Where results go, an array of call.count numbers each; null where one is not asked for.
struct DampingOutputs {
    double* damping = nullptr;               ///< NaN where there is none [unit of the damping law]
    double* greatest_restitution = nullptr;  ///< without damping [1]
};

/// Solve the problems of a call; impacts by tables where the results asked for are in them.
/// @throws InputError naming the first impact it concerns, where there are several; ConvergenceError
void solve_impacts(const Call& call, const BatchOutputs& outputs);
/// v_c; 0 where nothing is captured, infinite where everything is [m/s].
void solve_critical_velocities(const Call& call, double* critical_velocity);
void solve_dampings(const Call& call, const DampingOutputs& outputs);

}  // namespace ashimpact
