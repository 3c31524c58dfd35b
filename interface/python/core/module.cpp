// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ part of the Python module: calls on numpy's arrays, and the tables of laws.
#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "core/plausibility.hpp"
#include "core/text/error.hpp"
#include "core/version.hpp"
#include "interface/c/calls.hpp"
#include "interface/law_inputs.hpp"
#include "materials/contact_properties.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/motion/impact.hpp"

namespace py = pybind11;

namespace ashimpact {

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
constexpr py::ssize_t users_frame = 4;                     ///< from Call's, of warnings
constexpr std::size_t chunk_size = std::size_t{1} << 15U;  ///< problems between two looks at signals

/// Runs Python's signal handlers ten times a second, so that an interrupt ends a long call.
class Signals {
  public:
    void look() {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) return;
        last_ = now;
        const py::gil_scoped_acquire python;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A call from Python. Each array holds one number for all problems, or one for each.
class PythonCall {
  public:
    PythonCall(const std::string& law, const std::optional<std::string>& detachment,
               const std::string& damping_law, const py::dict& numbers, std::size_t count, int threads)
        : call_{.choice = choice_named(law.c_str(), detachment ? detachment->c_str() : nullptr,
                                       damping_law.c_str()),
                .parameters = {},
                .count = count,
                .threads = threads,
                .chunk = chunk_size,
                .after_chunk = [this] { signals_.look(); }} {
        for (const auto& [name, values] : numbers) {
            const Parameter parameter = parameter_named(name.cast<std::string>());
            const Array& array = arrays_.emplace_back(values.cast<Array>());
            const std::string note = note_on(call_.choice, parameter);
            const bool is_zero = std::all_of(array.data(), array.data() + array.size(),
                                             [](double value) { return value == 0; });
            if (!note.empty() && !is_zero && PyErr_WarnEx(PyExc_UserWarning, note.c_str(), users_frame) != 0)
                throw py::error_already_set();
            call_.parameters.set(parameter, {array.data(), array.size() == 1 ? std::size_t{0} : 1});
        }
    }
    PythonCall(const PythonCall&) = delete;
    PythonCall& operator=(const PythonCall&) = delete;

    /// Whether so many impacts come from tables faster.
    [[nodiscard]] bool tables_pay() const {
        return method_of_many(call_.choice.law, call_.choice.damping_law, call_.count) == BatchMethod::table;
    }

    /// An array for a result.
    [[nodiscard]] Array column() const { return Array(static_cast<py::ssize_t>(call_.count)); }

    /// Solves with Python free to do something else in between.
    template <class Outputs>
    void solve(void (*function)(const Call&, Outputs), const std::type_identity_t<Outputs>& outputs) const {
        const py::gil_scoped_release free_python;
        function(call_, outputs);
    }

  private:
    std::vector<Array> arrays_{};
    Signals signals_{};
    Call call_;
};

/// Columns by name: restitution, contact_time; approach_time and maximum_overlap where the turning point is
/// asked for; those along the wall where the impacts are oblique.
py::dict impacts(const PythonCall& call, const std::string& method, bool turning_point, bool oblique) {
    py::dict columns;
    const auto column = [&](const char* name) {
        Array values = call.column();
        columns[name] = values;
        return values.mutable_data();
    };
    ImpactOutputs outputs{.method = named<BatchMethod>(method)};
    outputs.normal.restitution = column("restitution");
    outputs.normal.contact_time = column("contact_time");
    if (turning_point) {
        outputs.normal.approach_time = column("approach_time");
        outputs.normal.maximum_overlap = column("maximum_overlap");
    }
    if (oblique)
        outputs.tangential = {.velocity = column("tangential_velocity"),
                              .spin = column("spin"),
                              .restitution = column("tangential_restitution"),
                              .rebound_angle = column("rebound_angle"),
                              .impulse_ratio = column("impulse_ratio"),
                              .regime = column("regime")};
    call.solve<const ImpactOutputs&>(solve_impacts, outputs);
    return columns;
}

/// Names of the regimes of sliding, in the order of their numbers.
std::vector<std::string> sliding_regimes() {
    return {Names<SlidingRegime>::all.begin(), Names<SlidingRegime>::all.end()};
}

Array velocities(const PythonCall& call) {
    Array velocity = call.column();
    call.solve<double*>(solve_critical_velocities, velocity.mutable_data());
    return velocity;
}

py::tuple dampings(const PythonCall& call) {
    Array damping = call.column();
    Array greatest = call.column();
    call.solve<const DampingOutputs&>(solve_dampings, {damping.mutable_data(), greatest.mutable_data()});
    return py::make_tuple(damping, greatest);
}

/// Name of each law, its own detachment, and those that are admissible.
py::dict laws() {
    py::dict all;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        std::vector<std::string> admissible;
        for (const Detachment detachment : all_values<Detachment>)
            if (!refusal(law, detachment)) admissible.emplace_back(name_of(detachment));
        all[py::str(std::string(law.name()))] =
            py::make_tuple(std::string(name_of(law.default_detachment())), admissible);
    }
    return all;
}

/// SI unit, text, laws, typical value [SI] and number of the choice of each law parameter, by name.
py::dict table_of_law_parameters() {
    py::dict table;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const std::string law(Law::at(i).name());
        for (const LawParameter& parameter : inputs_of(Law::at(i))) {
            const py::str name{std::string(parameter.name)};
            if (!table.contains(name))
                table[name] = py::make_tuple(std::string(si_unit(parameter.dimension)),
                                             std::string(parameter.description), py::list(),
                                             parameter.typical, parameter.choice);
            table[name].cast<py::tuple>()[2].cast<py::list>().append(law);
        }
    }
    for (const DampingLaw law : all_values<DampingLaw>)
        for (const LawParameter& parameter : parameters_of(law)) {
            py::list takers;
            for (const std::string& name : takers_of(parameter)) takers.append(name);
            table[py::str(std::string(parameter.name))] =
                py::make_tuple(std::string(si_unit(parameter.dimension)), std::string(parameter.description),
                               takers, parameter.typical, parameter.choice);
        }
    return table;
}

/// The doubt about a number of a quantity [SI], in words; none if it is plausible.
std::optional<std::string> doubt_about(const std::string& name, double value) {
    const PlausibleRange* range = plausible_range(name);
    const auto doubt = range == nullptr ? std::nullopt : implausible(*range, {value});
    return doubt ? std::optional(name + ": " + doubt->text) : std::nullopt;
}

/// The doubt about the density of a sphere that follows from its mass, in words; none if it is plausible.
std::optional<std::string> doubt_about_mass(double radius, double mass) {
    const auto doubt = implausible_mass(radius, mass);
    return doubt ? std::optional("mass: " + doubt->text) : std::nullopt;
}

/// The doubt about the greatest critical velocity of several [m/s].
std::optional<std::string> doubt_about_velocity(double greatest) {
    const auto doubt = outside_model(greatest);
    return doubt ? std::optional(doubt->text) : std::nullopt;
}

/// The SI unit of a quantity with a range of plausible values; empty for any other name.
std::string unit_of_quantity(const std::string& name) {
    const PlausibleRange* range = plausible_range(name);
    return range == nullptr ? "" : std::string(si_unit(range->dimension));
}

/// Name of each damping law and the SI unit of its coefficient.
py::dict damping_laws() {
    py::dict units;
    for (const DampingLaw law : all_values<DampingLaw>)
        units[py::str(std::string(name_of(law)))] = std::string(unit_of(law));
    return units;
}

}  // namespace

}  // namespace ashimpact

PYBIND11_MODULE(_core, module) {
    using namespace ashimpact;
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
    py::register_exception<ConvergenceError>(module, "ConvergenceError", PyExc_ArithmeticError);
    module.attr("version") = std::string(program_version());
    module.def("laws", &laws);
    module.def("law_parameters", &table_of_law_parameters);
    module.def("damping_laws", &damping_laws);
    module.def("sliding_regimes", &sliding_regimes);
    module.def("doubt_about", &doubt_about);
    module.def("doubt_about_mass", &doubt_about_mass);
    module.def("doubt_about_velocity", &doubt_about_velocity);
    module.def("unit_of_quantity", &unit_of_quantity);
    py::class_<PythonCall>(module, "Call")
        .def(py::init<const std::string&, const std::optional<std::string>&, const std::string&,
                      const py::dict&, std::size_t, int>())
        .def("tables_pay", &PythonCall::tables_pay)
        .def("impacts", &impacts)
        .def("critical_velocities", &velocities)
        .def("dampings", &dampings);
}
