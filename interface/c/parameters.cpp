// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/c/parameters.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

const std::vector<std::string_view>& parameter_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{
            "density",          "mass",           "diameter", "effective_radius", "contact_modulus",
            "work_of_adhesion", "yield_pressure", "damping",  "velocity",         "restitution"};
        for (const LawParameter& parameter : law_parameters()) {
            if (std::ranges::find(all, parameter.name) == all.end()) all.push_back(parameter.name);
        }
        if (all.size() > most_parameters)
            throw std::logic_error("more law parameters than the C interface has room for");
        return all;
    }();
    return names;
}

Parameter parameter_named(const char* name) {
    const auto& names = parameter_names();
    const std::string_view wanted = name == nullptr ? std::string_view("(null)") : name;
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end()) {
        throw InputError("unknown parameter " + in_quotes(wanted),
                         joined(std::vector<std::string>(names.begin(), names.end())));
    }
    return static_cast<Parameter>(found - names.begin());
}

Parameter alternative_to(Parameter parameter) {
    switch (parameter) {
        case Parameter::density:
            return Parameter::mass;
        case Parameter::mass:
            return Parameter::density;
        case Parameter::diameter:
            return Parameter::effective_radius;
        case Parameter::effective_radius:
            return Parameter::diameter;
        default:
            return parameter;
    }
}

void Parameters::set(Parameter parameter, Strided source) {
    sources_[place_of(alternative_to(parameter))] = {};
    sources_[place_of(parameter)] = source;
}

}  // namespace ashimpact
