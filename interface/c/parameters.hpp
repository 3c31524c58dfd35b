// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <vector>

namespace ashimpact {

/// What the C interface takes by name; parameters that laws declare of their own come behind these, in the
/// order of law_parameters().
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

/// The names of all parameters, in their order.
[[nodiscard]] const std::vector<std::string_view>& parameter_names();

[[nodiscard]] inline std::size_t place_of(Parameter parameter) {
    return static_cast<std::size_t>(parameter);
}

/// The parameter of that name. @throws InputError naming all of them
[[nodiscard]] Parameter parameter_named(const char* name);

/// Numbers for consecutive problems: value i at values[i stride]; none where values is null.
struct Strided {
    const double* values = nullptr;
    std::size_t stride = 0;
};

/// Mass of a sphere [kg] of a density [kg/m3] and a diameter [m]; every way through the interface multiplies
/// in this order, so that results agree bit by bit.
[[nodiscard]] inline double mass_of_sphere(double density, double diameter) {
    return density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
}

/// Where the numbers of a call come from, a constant or a column for each parameter. Density and mass tell
/// the same, and so do diameter and effective radius: the one that is set last counts.
class Parameters {
  public:
    void set(Parameter parameter, Strided source);
    /// The source of a parameter; its values are null where it was not set.
    [[nodiscard]] const Strided& operator[](Parameter parameter) const {
        return sources_[place_of(parameter)];
    }
    [[nodiscard]] bool has(Parameter parameter) const { return (*this)[parameter].values != nullptr; }

  private:
    std::array<Strided, most_parameters> sources_{};
};

/// The parameter that tells the same as another one: mass and density, diameter and effective_radius; itself
/// for the others.
[[nodiscard]] Parameter alternative_to(Parameter parameter);

}  // namespace ashimpact
