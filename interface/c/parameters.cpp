#include "interface/c/parameters.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"

namespace ashimpact {

Parameter parameter_named(const char* name) {
    const std::string_view wanted = name == nullptr ? std::string_view("(null)") : name;
    const auto* const found = std::ranges::find(parameter_names, wanted);
    if (found == parameter_names.end()) {
        throw InputError("unknown parameter " + in_quotes(wanted),
                         joined(std::vector<std::string>(parameter_names.begin(), parameter_names.end())));
    }
    return static_cast<Parameter>(found - parameter_names.begin());
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
    sources_[static_cast<std::size_t>(alternative_to(parameter))] = {};
    sources_[static_cast<std::size_t>(parameter)] = source;
}

}  // namespace ashimpact
