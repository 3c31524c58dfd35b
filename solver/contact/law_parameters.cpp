// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/law_parameters.hpp"

#include <algorithm>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

const std::vector<LawParameter>& law_parameters() {
    static const auto all = [] {
        std::vector<LawParameter> found;
        for (std::size_t i = 0; i < Law::count(); ++i)
            for (const LawParameter& parameter : Law::at(i).parameters())
                if (std::none_of(found.begin(), found.end(),
                                 [&](const LawParameter& known) { return known.name == parameter.name; }))
                    found.push_back(parameter);
        return found;
    }();
    return all;
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

std::optional<ParameterFault> parameter_fault(Law law,
                                              const std::function<bool(const LawParameter&)>& is_given) {
    for (const LawParameter& parameter : law.parameters()) {
        ParameterFault group{.parameters = {}, .given = 0};
        for (const LawParameter& other : law.parameters()) {
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

void require_parameters(Law law, const ParameterValues<double>& values) {
    const auto is_given = [&](const LawParameter& parameter) { return values.has(parameter); };
    if (const auto fault = parameter_fault(law, is_given))
        throw InputError(fault->problem(), fault->allowed());
    for (const LawParameter& parameter : law.parameters())
        if (values.has(parameter)) require_allowed(parameter, values[parameter]);
}

ParameterValues<double> typical_parameters(Law law) {
    ParameterValues<double> values;
    while (const auto fault =
               parameter_fault(law, [&](const LawParameter& parameter) { return values.has(parameter); }))
        values.set(fault->parameters.front().name, fault->parameters.front().typical);
    return values;
}

}  // namespace ashimpact
