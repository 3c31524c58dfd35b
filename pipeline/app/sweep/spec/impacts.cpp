// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/impacts.hpp"

#include <limits>

#include <Eigen/Core>

#include "materials/contact_properties.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

Eigen::Map<const Eigen::ArrayXd> array_of(ImpactColumns::Values values) {
    return {values.data(), std::ssize(values)};
}

/// Values of a function of two columns.
template <class Function>
Eigen::ArrayXd combined(ImpactColumns::Values a, ImpactColumns::Values b, const Function& function) {
    Eigen::ArrayXd values(std::ssize(a.size() == 1 ? b : a));
    const auto fill = [&](const auto& first, const auto& second) {  // each combination a loop of its own
        for (Eigen::Index i = 0; i < values.size(); ++i) {
            const auto place = static_cast<std::size_t>(i);
            values[i] = function(first(place), second(place));
        }
    };
    const auto single = [](ImpactColumns::Values column) {
        return [value = column.front()](std::size_t) { return value; };
    };
    const auto each = [](ImpactColumns::Values column) {
        return [column](std::size_t i) { return column[i]; };
    };
    if (a.size() == 1)
        b.size() == 1 ? fill(single(a), single(b)) : fill(single(a), each(b));
    else
        b.size() == 1 ? fill(each(a), single(b)) : fill(each(a), each(b));
    return values;
}

/// Columns of the inputs of a sweep as its variables or its fixed values give them.
class InputColumns {
  public:
    InputColumns(const SweepSpec& spec, const std::vector<std::vector<double>>& variables)
        : spec_(spec), variables_(variables) {}

    /// A variable, or the single fixed value.
    [[nodiscard]] ImpactColumns::Values of(ImpactInput input, const double& fallback) const {
        for (std::size_t i = 0; i < spec_.variables.size(); ++i)
            if (spec_.variables[i].input == input) return variables_[i];
        const auto& fixed = spec_.fixed[static_cast<std::size_t>(input)];
        return {fixed ? &*fixed : &fallback, 1};
    }
    /// Masses of spheres from their density.
    [[nodiscard]] Eigen::ArrayXd masses(ImpactInput density, ImpactColumns::Values radius) const {
        Eigen::ArrayXd unit = array_of(of(density, none));  // to be masses of spheres of radius 1 m
        for (double& value : unit) value = sphere_mass(1.0, value);
        const Eigen::Map<const Eigen::ArrayXd> r = array_of(radius);
        if (unit.size() == 1) return unit[0] * r * r * r;
        if (r.size() == 1) return unit * r[0] * r[0] * r[0];
        return unit * r * r * r;
    }

    static constexpr double none = 0;
    static constexpr double infinite = std::numeric_limits<double>::infinity();

  private:
    const SweepSpec& spec_;
    const std::vector<std::vector<double>>& variables_;
};

}  // namespace

ImpactColumns::ImpactColumns(const SweepSpec& spec, const std::vector<std::vector<double>>& variables,
                             std::size_t count) {
    const InputColumns inputs(spec, variables);
    const auto column = [&](ImpactInput input) { return inputs.of(input, InputColumns::none); };
    const auto masses = [&](ImpactInput given, ImpactInput density, ImpactColumns::Values radius) {
        return is_given(spec, density) ? keep(inputs.masses(density, radius)) : column(given);
    };
    effective_radius = column(ImpactInput::radius);
    contact_modulus = column(ImpactInput::contact_modulus);
    work_of_adhesion = column(ImpactInput::work_of_adhesion);
    yield_pressure = inputs.of(ImpactInput::yield_pressure, InputColumns::infinite);
    damping = column(ImpactInput::damping);
    velocity = column(ImpactInput::velocity);
    if (velocity.size() != count)
        velocity = keep(Eigen::ArrayXd::Constant(static_cast<Eigen::Index>(count), velocity.front()));
    mass = masses(ImpactInput::mass, ImpactInput::density, effective_radius);
    if (is_given(spec, ImpactInput::partner_radius)) {
        const ImpactColumns::Values radius = column(ImpactInput::partner_radius);
        const ImpactColumns::Values partner =
            masses(ImpactInput::partner_mass, ImpactInput::partner_density, radius);
        effective_radius = keep(combined(effective_radius, radius, ashimpact::effective_radius));
        mass = keep(combined(mass, partner, effective_mass));
    }
    for (const LawParameter& parameter : law_parameters())
        if (is_given(spec, input_of(parameter)))
            parameters.emplace_back(parameter.name, column(input_of(parameter)));
}

ImpactColumns::Values ImpactColumns::keep(Eigen::ArrayXd values) {
    const Eigen::ArrayXd& kept = kept_.emplace_back(std::move(values));
    return {kept.data(), static_cast<std::size_t>(kept.size())};
}

ImpactBatch batch_of(const ImpactModel& model, const ImpactColumns& impacts) {
    std::vector<ParameterColumn> parameters;
    for (const auto& [name, values] : impacts.parameters) parameters.push_back({name, array_of(values)});
    return {model.law,
            model.detachment,
            model.damping_law,
            {array_of(impacts.mass), array_of(impacts.effective_radius), array_of(impacts.contact_modulus),
             array_of(impacts.work_of_adhesion), array_of(impacts.yield_pressure), parameters},
            array_of(impacts.damping),
            array_of(impacts.velocity)};
}

}  // namespace ashimpact
