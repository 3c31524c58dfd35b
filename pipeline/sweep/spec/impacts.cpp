#include "pipeline/sweep/spec/impacts.hpp"

#include <algorithm>
#include <limits>

#include "materials/contact_properties.hpp"

namespace ashimpact {

namespace {

/// Values of a function of two columns.
template <class Function>
std::vector<double> combined(const std::vector<double>& a, const std::vector<double>& b,
                             const Function& function) {
    std::vector<double> values(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = function(value_at(a, i), value_at(b, i));
    return values;
}

/// Column of an input, a single value where it does not vary.
class InputColumns {
  public:
    InputColumns(const SweepSpec& spec, const std::vector<std::vector<double>>& variables, std::size_t count)
        : spec_(spec), variables_(variables), count_(count) {}

    [[nodiscard]] std::vector<double> of(ImpactInput input, double fallback = 0) const {
        for (std::size_t i = 0; i < spec_.variables.size(); ++i)
            if (spec_.variables[i].input == input) return variables_[i];
        return {spec_.fixed[static_cast<std::size_t>(input)].value_or(fallback)};
    }
    /// The same with a value for each impact.
    [[nodiscard]] std::vector<double> of_each(ImpactInput input) const {
        std::vector<double> values = of(input);
        values.resize(count_, values.front());
        return values;
    }
    /// Mass of a sphere, as given or from its density.
    [[nodiscard]] std::vector<double> masses(ImpactInput mass, ImpactInput density,
                                             const std::vector<double>& radius) const {
        if (!is_given(spec_, density)) return of(mass);
        std::vector<double> unit = of(density);  // masses of spheres of radius 1 m
        for (double& value : unit) value = sphere_mass(1.0, value);
        return combined(radius, unit, [](double r, double each) { return each * r * r * r; });
    }

  private:
    const SweepSpec& spec_;
    const std::vector<std::vector<double>>& variables_;
    std::size_t count_;
};

}  // namespace

ImpactColumns impacts_of(const SweepSpec& spec, const std::vector<std::vector<double>>& variables,
                         std::size_t count) {
    const InputColumns inputs(spec, variables, count);
    ImpactColumns columns{
        .mass = {},
        .effective_radius = inputs.of(ImpactInput::radius),
        .contact_modulus = inputs.of(ImpactInput::contact_modulus),
        .work_of_adhesion = inputs.of(ImpactInput::work_of_adhesion),
        .yield_pressure = inputs.of(ImpactInput::yield_pressure, std::numeric_limits<double>::infinity()),
        .damping = inputs.of(ImpactInput::damping),
        .velocity = inputs.of_each(ImpactInput::velocity),
        .parameters = {}};
    columns.mass = inputs.masses(ImpactInput::mass, ImpactInput::density, columns.effective_radius);
    if (is_given(spec, ImpactInput::partner_radius)) {
        const std::vector<double> radius = inputs.of(ImpactInput::partner_radius);
        const std::vector<double> mass =
            inputs.masses(ImpactInput::partner_mass, ImpactInput::partner_density, radius);
        columns.effective_radius = combined(columns.effective_radius, radius, effective_radius);
        columns.mass = combined(columns.mass, mass, effective_mass);
    }
    for (const LawParameter& parameter : law_parameters())
        if (is_given(spec, input_of(parameter)))
            columns.parameters.emplace_back(parameter.name, inputs.of(input_of(parameter)));
    return columns;
}

ImpactBatch batch_of(const ImpactModel& model, const ImpactColumns& impacts) {
    const auto column = [](const std::vector<double>& values) {
        return Eigen::Map<const Eigen::ArrayXd>(values.data(), std::ssize(values));
    };
    std::vector<ParameterColumn> parameters;
    for (const auto& [name, values] : impacts.parameters) parameters.push_back({name, column(values)});
    return {model.law,
            model.detachment,
            model.damping_law,
            {column(impacts.mass), column(impacts.effective_radius), column(impacts.contact_modulus),
             column(impacts.work_of_adhesion), column(impacts.yield_pressure), parameters},
            column(impacts.damping),
            column(impacts.velocity)};
}

}  // namespace ashimpact
