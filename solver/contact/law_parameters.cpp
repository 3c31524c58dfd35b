// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/law_parameters.hpp"

#include <algorithm>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact {

namespace {

void add_new(std::vector<LawParameter>& found, std::span<const LawParameter> parameters) {
    for (const LawParameter& parameter : parameters)
        if (std::ranges::find(found, parameter.name, &LawParameter::name) == found.end())
            found.push_back(parameter);
}

bool takes(DampingLaw law, const LawParameter& parameter) {
    const auto own = parameters_of(law);
    return std::ranges::find(own, parameter.name, &LawParameter::name) != own.end();
}

bool is_of_damping(const LawParameter& parameter) {
    return std::ranges::any_of(all_values<DampingLaw>, [&](DampingLaw law) { return takes(law, parameter); });
}

}  // namespace

std::vector<std::string> takers_of(const LawParameter& parameter) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < Law::count(); ++i)
        if (Law::at(i).takes(parameter)) names.emplace_back(Law::at(i).name());
    for (const DampingLaw law : all_values<DampingLaw>)
        if (takes(law, parameter)) names.emplace_back(name_of(law));
    return names;
}

const std::vector<LawParameter>& law_parameters() {
    static const auto all = [] {
        std::vector<LawParameter> found;
        for (std::size_t i = 0; i < Law::count(); ++i) add_new(found, Law::at(i).parameters());
        for (const DampingLaw law : all_values<DampingLaw>) add_new(found, parameters_of(law));
        return found;
    }();
    return all;
}

std::vector<LawParameter> parameters_of(Law law, DampingLaw damping_law) {
    std::vector<LawParameter> found;
    add_new(found, law.parameters());
    add_new(found, parameters_of(damping_law));
    if (!law.is_adhesive()) std::erase_if(found, [](const LawParameter& p) { return p.of_attraction; });
    return found;
}

std::optional<std::string> idle_reason(Law law, DampingLaw damping, std::string_view name) {
    const auto own = std::ranges::find(law_parameters(), name, &LawParameter::name);
    if (own != law_parameters().end() && is_of_damping(*own)) {
        if (!takes(damping, *own)) return "damping law " + std::string(name_of(damping)) + " does not use it";
        if (own->of_attraction && !law.is_adhesive()) return std::string(law.name()) + " has no attraction";
        return std::nullopt;
    }
    const bool counts = name == "yield_pressure"     ? law.is_plastic()
                        : name == "work_of_adhesion" ? law.uses_work_of_adhesion()
                                                     : own == law_parameters().end() || law.takes(*own);
    if (counts) return std::nullopt;
    return std::string(law.name()) + (name == "yield_pressure" ? " never yields" : " does not use it");
}

std::optional<std::string> idle_reason(std::span<const Law> laws, DampingLaw damping, std::string_view name) {
    std::vector<std::string_view> names;
    for (const Law law : laws) {
        const auto reason = idle_reason(law, damping, name);
        if (!reason || laws.size() == 1) return reason;
        names.push_back(law.name());
    }
    return "none of " + joined(names) + " uses it";
}

std::string idle_words(const std::string& reason) {
    return reason + ", so it changes nothing";
}

std::string ParameterFault::problem() const {
    std::vector<std::string> all;
    for (const LawParameter& parameter : parameters) all.emplace_back(parameter.name);
    const std::string names = joined(all);
    if (parameters.size() == 1) return names + " is missing";
    return (given == 0 ? "none" : std::to_string(given)) + std::string(" of ") + names + " given";
}

std::string ParameterFault::allowed() const {
    std::string text = parameters.size() == 1 ? "" : "one of them: ";
    for (const LawParameter& parameter : parameters) {
        if (&parameter != &parameters.front()) text += "; ";
        text += std::string(parameter.description) + ", such as \"" + std::string(parameter.example) + '"';
    }
    return text;
}

std::optional<ParameterFault> parameter_fault(std::span<const LawParameter> parameters,
                                              const std::function<bool(const LawParameter&)>& is_given) {
    for (const LawParameter& parameter : parameters) {
        ParameterFault group{.parameters = {}, .given = 0};
        for (const LawParameter& other : parameters) {
            const bool same =
                parameter.choice == 0 ? other.name == parameter.name : other.choice == parameter.choice;
            if (!same) continue;
            group.parameters.push_back(other);
            group.given += is_given(other) ? 1 : 0;
        }
        if (group.given == 1 || (group.given == 0 && parameter.otherwise)) continue;
        return group;
    }
    return std::nullopt;
}

void require_allowed(const LawParameter& parameter, double value) {
    if (value > parameter.greatest) {
        const std::string unit = " " + std::string(si_unit(parameter.dimension));
        throw InputError(std::string(parameter.name) + " is " + shortest(value) + unit,
                         "up to " + shortest(parameter.greatest) + unit);
    }
    (parameter.may_be_zero ? require_not_negative : require_positive)(parameter.name, value,
                                                                      parameter.dimension);
}

void require_parameters(std::span<const LawParameter> parameters, const ParameterValues<double>& values) {
    const auto is_given = [&](const LawParameter& parameter) { return values.has(parameter); };
    if (const auto fault = parameter_fault(parameters, is_given))
        throw InputError(fault->problem(), fault->allowed());
    for (const LawParameter& parameter : parameters)
        if (values.has(parameter)) require_allowed(parameter, values[parameter]);
}

ParameterValues<double> typical_parameters(std::span<const LawParameter> parameters) {
    ParameterValues<double> values;
    while (const auto fault = parameter_fault(
               parameters, [&](const LawParameter& parameter) { return values.has(parameter); }))
        values.set(fault->parameters.front().name, fault->parameters.front().typical);
    return values;
}

}  // namespace ashimpact
