// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/view.hpp"
#include "core/quantities/names.hpp"
#include "core/units/units.hpp"
#include "pipeline/case/case.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"
#include "solver/statistics/design.hpp"
#include "solver/statistics/distribution.hpp"
#include "solver/statistics/histogram.hpp"

namespace ashimpact {

/// Inputs of an impact of a sphere, on a flat wall or on a second sphere, that a sweep may vary. The values
/// after the last one named here stand for the parameters of contact laws, in the order of law_parameters().
enum class ImpactInput {
    radius,
    density,
    mass,
    contact_modulus,
    work_of_adhesion,
    yield_pressure,
    damping,
    velocity,
    partner_radius,
    partner_density,
    partner_mass,
    angle  ///< from the normal; `velocity` is then that of the sphere
};

/// Number of inputs, parameters of contact laws among them.
[[nodiscard]] std::size_t impact_input_count();
/// The input of a parameter of contact laws.
[[nodiscard]] ImpactInput input_of(const LawParameter& parameter);
/// Checks a value of an input [SI]. @throws InputError naming it and what is allowed
void require_allowed(ImpactInput input, double value, Dimension dimension);

[[nodiscard]] std::string_view name_of(ImpactInput input);
/// The input of that name, which the schema has checked.
[[nodiscard]] ImpactInput impact_input_named(std::string_view name);
/// Dimension of an input; that of a damping coefficient depends on its law.
[[nodiscard]] Dimension dimension_of(ImpactInput input, DampingLaw law);
/// Whether zero is a value an input may have.
[[nodiscard]] bool may_be_zero(ImpactInput input);

/// Where the uncertainty of an input of a sweep belongs.
inline constexpr auto varies_instead = "a value alone; what is uncertain has a distribution in /variables";

/// Reads {"values"}, {"grid"} or {"distribution"}. @throws InputError with the JSON pointer if not admissible
[[nodiscard]] Distribution read_variable(const View& node, ImpactInput input, DampingLaw damping_law);

/// Results of an impact that a sweep may evaluate.
enum class Observable {
    captured,          ///< 1 for a capture, 0 for a rebound
    restitution,       ///< 0 for a capture
    rebound_velocity,  ///< 0 for a capture
    contact_time,      ///< of rebounds only
    maximum_overlap,   ///< its supremum where the approach never turns
};

template <>
struct Names<Observable> {
    static constexpr std::string_view kind = "observable";
    static constexpr std::array<std::string_view, 5> all{"captured", "restitution", "rebound_velocity",
                                                         "contact_time", "maximum_overlap"};
};

[[nodiscard]] Dimension dimension_of(Observable observable);
/// What it is, in the file of a full table.
[[nodiscard]] const char* description_of(Observable observable);
/// Whether every impact has a value, a capture too.
[[nodiscard]] bool captures_count(Observable observable);

struct SweepVariable {
    ImpactInput input;
    Distribution distribution;  ///< [SI]
};

/// Statistics of an observable.
struct ObservableStatistics {
    Observable observable;
    Bins bins;
    std::vector<double> quantiles;  ///< probabilities
};

/// How the damping coefficient goes with the radius, as the spec states it: damping (r/radius)^power.
struct DampingOverSizes {
    double power;
    double radius;  ///< at which the coefficient is that of the spec [m]
};

/// What a sweep computes.
struct SweepSpec {
    std::vector<LawChoice> laws;
    DampingLaw damping_law = DampingLaw::constant;
    std::vector<std::optional<double>> fixed =
        std::vector<std::optional<double>>(impact_input_count());  ///< inputs that do not vary [SI]
    std::vector<SweepVariable> variables;
    std::optional<DampingOverSizes> damping_over_sizes;  ///< none: not stated, the same for every size
    Sampling sampling{};
    std::vector<ObservableStatistics> statistics;  ///< `captured` first, always there
    std::vector<Observable> sensitivity;           ///< whose Sobol indices are wanted
    std::vector<Observable> table;                 ///< columns of the full table; empty: no table
    std::vector<std::string> warnings;
};

/// Whether an input stands in the sweep, as a constant or as a variable.
[[nodiscard]] bool is_given(const SweepSpec& spec, ImpactInput input);
/// The distributions of the variables, in their order.
[[nodiscard]] std::vector<Distribution> distributions_of(const SweepSpec& spec);

/// A spec with its canonical text, which identifies it whatever its comments and layout.
struct LoadedSpec {
    SweepSpec spec;
    std::string canonical;
};

/// Reads and checks a spec. @throws InputError with the JSON pointer
[[nodiscard]] LoadedSpec read_sweep_spec(const std::string& text);

}  // namespace ashimpact
