// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Python module that is not Python: the batch solver on numpy's arrays.
#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "core/text/error.hpp"
#include "core/version.hpp"
#include "interface/chunks.hpp"
#include "solver/batch/critical_batch.hpp"
#include "solver/batch/impact_batch.hpp"
#include "solver/batch/inversion_batch.hpp"
#include "solver/contact/law_parameters.hpp"

namespace py = pybind11;

namespace ashimpact {

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
constexpr std::size_t chunk_size = std::size_t{1} << 15U;  ///< problems between two looks at signals

/// The law of a call by names; an empty detachment is the law's own.
struct Choice {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;

    Choice(const std::string& law_name, const std::optional<std::string>& end, const std::string& damping)
        : law(Law::named(law_name)),
          detachment(end ? named<Detachment>(*end) : law.default_detachment()),
          damping_law(named<DampingLaw>(damping)) {}
};

/// The numbers of a chunk of an array that holds one number for all, or one for each problem.
Column part(const Array& array, std::size_t first, std::size_t size) {
    const bool single = array.size() == 1;
    return Eigen::Map<const Eigen::ArrayXd>(array.data() + (single ? 0 : first),
                                            static_cast<Eigen::Index>(single ? 1 : size));
}

/// A parameter of a law, with its values.
struct ParameterArray {
    std::string_view name;  ///< that of the LawParameter
    Array values;
};

/// The arrays of a contact, in the order of ContactColumns.
struct ContactArrays {
    Array mass;
    Array effective_radius;
    Array contact_modulus;
    Array work_of_adhesion;
    Array yield_pressure;
    std::vector<ParameterArray> parameters;

    [[nodiscard]] ContactColumns part(std::size_t first, std::size_t size) const {
        std::vector<ParameterColumn> own;
        for (const auto& [name, values] : parameters)
            own.push_back({name, ashimpact::part(values, first, size)});
        return {ashimpact::part(mass, first, size),
                ashimpact::part(effective_radius, first, size),
                ashimpact::part(contact_modulus, first, size),
                ashimpact::part(work_of_adhesion, first, size),
                ashimpact::part(yield_pressure, first, size),
                std::move(own)};
    }
};

/// The parameters of a law among those of a call. @throws InputError for one that the law does not take
std::vector<ParameterArray> parameters_of(const Law& law, const py::dict& given) {
    std::vector<ParameterArray> parameters;
    for (const LawParameter& parameter : law_parameters()) {
        const py::str name{std::string(parameter.name)};
        if (!given.contains(name)) continue;
        if (!law.takes(parameter)) {
            throw InputError("law " + std::string(law.name()) + " takes no " + std::string(parameter.name));
        }
        parameters.push_back({parameter.name, given[name].cast<Array>()});
    }
    return parameters;
}

ContactArrays contact_of(const Law& law, const py::tuple& arrays) {
    return {arrays[0].cast<Array>(), arrays[1].cast<Array>(), arrays[2].cast<Array>(),
            arrays[3].cast<Array>(), arrays[4].cast<Array>(), parameters_of(law, arrays[5].cast<py::dict>())};
}

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

void copy(const Eigen::ArrayXd& from, std::size_t first, std::size_t size, double* to) {
    if (from.size() == 1) {
        std::fill_n(to + first, size, from[0]);
    } else {
        std::copy_n(from.data(), size, to + first);
    }
}

/// Solves in chunks, with Python free to do something else in between.
template <class Solve>
void solve_in_chunks(std::size_t count, const Solve& solve) {
    const py::gil_scoped_release free_python;
    Signals signals;
    in_chunks(count, chunk_size, [&](std::size_t first, std::size_t size) {
        solve(first, size);
        signals.look();
    });
}

py::tuple impacts(const Choice& choice, const py::tuple& contact_arrays, const Array& damping,
                  const Array& velocity, std::size_t count, const std::string& method, int threads) {
    const ContactArrays contact = contact_of(choice.law, contact_arrays);
    if (method != "integration" && method != "table") {
        throw InputError("unknown method '" + method + "'", "integration, table");
    }
    const bool tabulated = method == "table";
    const BatchOptions options{.threads = threads,
                               .turning_point = !tabulated,
                               .method = tabulated ? BatchMethod::table : BatchMethod::integration};
    const auto size_of = static_cast<py::ssize_t>(count);
    Array restitution(size_of);
    Array contact_time(size_of);
    Array approach_time(tabulated ? 0 : size_of);
    Array maximum_overlap(tabulated ? 0 : size_of);
    double* const out[] = {restitution.mutable_data(), contact_time.mutable_data(),
                           tabulated ? nullptr : approach_time.mutable_data(),
                           tabulated ? nullptr : maximum_overlap.mutable_data()};
    solve_in_chunks(count, [&](std::size_t first, std::size_t size) {
        const auto from = [&](double* column) { return column == nullptr ? nullptr : column + first; };
        const BatchOutputs outputs{.restitution = from(out[0]),
                                   .contact_time = from(out[1]),
                                   .approach_time = from(out[2]),
                                   .maximum_overlap = from(out[3])};
        solve_impacts({choice.law, choice.detachment, choice.damping_law, contact.part(first, size),
                       part(damping, first, size), part(velocity, first, size)},
                      outputs, options);
    });
    return py::make_tuple(restitution, contact_time, approach_time, maximum_overlap);
}

Array velocities(const Choice& choice, const py::tuple& contact_arrays, const Array& damping,
                 std::size_t count, int threads) {
    const ContactArrays contact = contact_of(choice.law, contact_arrays);
    Array velocity(static_cast<py::ssize_t>(count));
    double* const out = velocity.mutable_data();
    solve_in_chunks(count, [&](std::size_t first, std::size_t size) {
        CriticalVelocityBatchResult result =
            critical_velocities({choice.law, choice.detachment, choice.damping_law, contact.part(first, size),
                                 part(damping, first, size)},
                                threads);
        for (Eigen::Index i = 0; i < result.value.size(); ++i) {
            if (result.verdict[i] == CaptureVerdict::never_captured) result.value[i] = 0.0;
            if (result.verdict[i] == CaptureVerdict::always_captured) {
                result.value[i] = std::numeric_limits<double>::infinity();
            }
        }
        copy(result.value, first, size, out);
    });
    return velocity;
}

py::tuple dampings(const Choice& choice, const py::tuple& contact_arrays, const Array& velocity,
                   const Array& restitution, std::size_t count, int threads) {
    const ContactArrays contact = contact_of(choice.law, contact_arrays);
    const auto size_of = static_cast<py::ssize_t>(count);
    Array damping(size_of);
    Array greatest(size_of);
    double* const out[] = {damping.mutable_data(), greatest.mutable_data()};
    solve_in_chunks(count, [&](std::size_t first, std::size_t size) {
        const DampingBatchResult result = dampings_from_restitutions(
            {choice.law, choice.detachment, choice.damping_law, contact.part(first, size),
             part(velocity, first, size), part(restitution, first, size)},
            threads);
        copy(result.damping, first, size, out[0]);
        copy(result.greatest_restitution, first, size, out[1]);
    });
    return py::make_tuple(damping, greatest);
}

/// Name of each law, its own detachment, and those that are admissible.
py::dict laws() {
    py::dict all;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        py::list admissible;
        for (const Detachment detachment : all_values<Detachment>) {
            if (!refusal(law, detachment)) admissible.append(py::str(std::string(name_of(detachment))));
        }
        all[py::str(std::string(law.name()))] =
            py::make_tuple(py::str(std::string(name_of(law.default_detachment()))), admissible);
    }
    return all;
}

/// Name, SI unit, text and laws of each parameter that laws take beside those of every contact.
py::dict table_of_law_parameters() {
    py::dict table;
    for (const LawParameter& parameter : law_parameters()) {
        py::list laws;
        for (std::size_t i = 0; i < Law::count(); ++i)
            if (Law::at(i).takes(parameter)) laws.append(std::string(Law::at(i).name()));
        table[py::str(std::string(parameter.name))] = py::make_tuple(
            std::string(si_unit(parameter.dimension)), std::string(parameter.description), laws);
    }
    return table;
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
    py::class_<Choice>(module, "Choice")
        .def(py::init<const std::string&, const std::optional<std::string>&, const std::string&>());
    module.def("impacts", &impacts);
    module.def("critical_velocities", &velocities);
    module.def("dampings", &dampings);
}
