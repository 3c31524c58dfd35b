// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// The parameters of all registered contact and damping laws, each name once.
[[nodiscard]] const std::vector<LawParameter>& law_parameters();

/// Parameters of a law of which too few or, of a choice, too many are given.
struct ParameterFault {
    std::vector<LawParameter> parameters;       ///< one, or those of a choice
    int given;                                  ///< 0, or two or more of a choice
    [[nodiscard]] std::string problem() const;  ///< "cohesion_energy_density is missing"
    [[nodiscard]] std::string allowed() const;  ///< what each of them is, in words
};

/// The parameters that a contact law and a damping law take together.
[[nodiscard]] std::vector<LawParameter> parameters_of(Law law, DampingLaw damping_law);

/// Names of the contact laws and damping laws that take a parameter.
[[nodiscard]] std::vector<std::string> takers_of(const LawParameter& parameter);

/// Why "work_of_adhesion", "yield_pressure" or a parameter changes nothing with a law and a damping law,
/// "hertz does not use it"; none if it counts.
[[nodiscard]] std::optional<std::string> idle_reason(Law law, DampingLaw damping, std::string_view name);

/// The same with none of several laws, at least one.
[[nodiscard]] std::optional<std::string> idle_reason(std::span<const Law> laws, DampingLaw damping,
                                                     std::string_view name);

/// Text of all interfaces on an input that changes nothing, after its name: "<reason>, so it changes
/// nothing".
[[nodiscard]] std::string idle_words(const std::string& reason);

/// The first parameter or choice of the laws that is not given as it must be; none if all are.
[[nodiscard]] std::optional<ParameterFault> parameter_fault(
    std::span<const LawParameter> parameters, const std::function<bool(const LawParameter&)>& is_given);
[[nodiscard]] inline std::optional<ParameterFault> parameter_fault(
    Law law, const std::function<bool(const LawParameter&)>& is_given) {
    return parameter_fault(law.parameters(), is_given);
}

/// Checks one value of a parameter [SI]. @throws InputError naming it, its value, unit and what is allowed
void require_allowed(const LawParameter& parameter, double value);

/// Checks that laws have the parameters they need and that their values are allowed. @throws InputError
void require_parameters(std::span<const LawParameter> parameters, const ParameterValues<double>& values);

/// Typical values of the parameters that laws require, one for each choice. For code whose results do not
/// depend on them, such as tables in scaled numbers.
[[nodiscard]] ParameterValues<double> typical_parameters(std::span<const LawParameter> parameters);
[[nodiscard]] inline ParameterValues<double> typical_parameters(Law law) {
    return typical_parameters(law.parameters());
}

}  // namespace ashimpact
