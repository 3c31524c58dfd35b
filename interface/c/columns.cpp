// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/c/columns.hpp"

#include <string>
#include <utility>

#include "core/text/error.hpp"

namespace ashimpact {

namespace {

constexpr double unset = 0.0;

double at(const Strided& source, std::size_t i) {
    return source.values[i * source.stride];
}

}  // namespace

void ColumnReader::select(Law law, const Parameters& parameters, std::size_t first, std::size_t count) {
    law_ = law;
    parameters_ = parameters;
    first_ = first;
    count_ = count;
}

ContactColumns ColumnReader::contact() {
    std::vector<ParameterColumn> own;
    for (const LawParameter& parameter : law_.parameters()) {
        const Parameter named = parameter_named(parameter.name.data());
        if (parameters_.has(named)) own.push_back({parameter.name, column(named)});
    }
    if (!parameters_.has(Parameter::yield_pressure)) {
        return {.mass = mass(),
                .effective_radius = effective_radius(),
                .contact_modulus = column(Parameter::contact_modulus),
                .work_of_adhesion = column(Parameter::work_of_adhesion),
                .parameters = std::move(own)};
    }
    return {.mass = mass(),
            .effective_radius = effective_radius(),
            .contact_modulus = column(Parameter::contact_modulus),
            .work_of_adhesion = column(Parameter::work_of_adhesion),
            .yield_pressure = column(Parameter::yield_pressure),
            .parameters = std::move(own)};
}

ColumnReader::View ColumnReader::column(Parameter parameter) {
    const Strided& source = parameters_[parameter];
    if (source.values == nullptr) return view_of(&unset, 1);
    if (source.stride == 0) return view_of(source.values, 1);
    if (source.stride == 1) return view_of(source.values + first_, static_cast<Eigen::Index>(count_));
    double* const copy = copy_of(parameter);
    for (std::size_t i = 0; i < count_; ++i) copy[i] = at(source, first_ + i);
    return view_of(copy, static_cast<Eigen::Index>(count_));
}

ColumnReader::View ColumnReader::mass() {
    if (parameters_.has(Parameter::mass)) return column(Parameter::mass);
    const Strided& density = parameters_[Parameter::density];
    const Strided& diameter = parameters_[Parameter::diameter];
    const std::size_t count = density.stride == 0 && diameter.stride == 0 ? 1 : count_;
    double* const copy = copy_of(Parameter::mass);
    for (std::size_t i = 0; i < count; ++i) {
        copy[i] = mass_of_sphere(at(density, first_ + i), at(diameter, first_ + i));
    }
    return view_of(copy, static_cast<Eigen::Index>(count));
}

ColumnReader::View ColumnReader::effective_radius() {
    if (parameters_.has(Parameter::effective_radius)) return column(Parameter::effective_radius);
    const Strided& diameter = parameters_[Parameter::diameter];
    const std::size_t count = diameter.stride == 0 ? 1 : count_;
    double* const copy = copy_of(Parameter::effective_radius);
    for (std::size_t i = 0; i < count; ++i) copy[i] = at(diameter, first_ + i) / 2.0;
    return view_of(copy, static_cast<Eigen::Index>(count));
}

double* ColumnReader::copy_of(Parameter parameter) {
    return copies_[place_of(parameter)].data();
}

void require_contact(const Parameters& parameters) {
    if (!parameters.has(Parameter::effective_radius)) require_column(parameters, Parameter::diameter);
    if (parameters.has(Parameter::mass)) return;
    require_column(parameters, Parameter::density);
    if (!parameters.has(Parameter::diameter)) {
        throw InputError("mass is missing: effective_radius and density do not tell it", "mass, or diameter");
    }
}

void require_column(const Parameters& parameters, Parameter parameter) {
    if (parameters.has(parameter)) return;
    throw InputError(std::string(parameter_names()[place_of(parameter)]) + " is missing",
                     "a parameter of the model or a column of the call");
}

}  // namespace ashimpact
