// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/c/calls.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/batch/batch.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact {

namespace {

/// The names of all parameters, in their order.
const std::vector<std::string>& parameter_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{"density",
                                     "mass",
                                     "diameter",
                                     "effective_radius",
                                     "contact_modulus",
                                     "work_of_adhesion",
                                     "yield_pressure",
                                     "damping",
                                     "velocity",
                                     "restitution",
                                     "tangential_velocity",
                                     "spin",
                                     "friction",
                                     "sphere_radius",
                                     "sphere_mass"};
        for (const LawParameter& parameter : law_parameters()) all.emplace_back(parameter.name);
        if (all.size() > most_parameters)
            throw std::logic_error("more law parameters than the C interface has room for");
        return all;
    }();
    return names;
}

/// Hands the numbers of a call to the batch solver, some consecutive problems at a time. A column refers to
/// the caller's numbers where they lie side by side, and to a copy in here where they do not or are computed.
class ColumnReader {
  public:
    using View = Eigen::Map<const Eigen::ArrayXd>;

    /// Sources of problems first to first + count - 1.
    void select(const Parameters& parameters, std::size_t first, std::size_t count) {
        parameters_ = parameters;
        first_ = first;
        count_ = count;
    }

    /// A column of one value or of count; 0 for all where the parameter was not set.
    [[nodiscard]] View column(Parameter parameter) {
        static constexpr double unset = 0.0;
        const Strided& source = parameters_[parameter];
        if (source.values == nullptr) return view_of(&unset, 1);
        if (source.stride == 0) return view_of(source.values, 1);
        if (source.stride == 1) return view_of(source.values + first_, count_);
        return copy(parameter, count_, [&](std::size_t i) { return source[i]; });
    }

    /// Mass and effective radius come from density and diameter where they are not given themselves.
    [[nodiscard]] ContactColumns contact(Law law, DampingLaw damping) {
        const Strided& density = parameters_[Parameter::density];
        const Strided& diameter = parameters_[Parameter::diameter];
        const std::size_t diameters = diameter.stride == 0 ? 1 : count_;
        const std::size_t masses = density.stride == 0 ? diameters : count_;
        std::vector<ParameterColumn> own;
        for (const LawParameter& parameter : parameters_of(law, damping)) {
            const Parameter named = parameter_named(parameter.name);
            if (parameters_.has(named)) own.push_back({parameter.name, column(named)});
        }
        return {.mass = parameters_.has(Parameter::mass)
                            ? column(Parameter::mass)
                            : copy(Parameter::mass, masses,
                                   [&](std::size_t i) { return mass_of_sphere(density[i], diameter[i]); }),
                .effective_radius = parameters_.has(Parameter::effective_radius)
                                        ? column(Parameter::effective_radius)
                                        : copy(Parameter::effective_radius, diameters,
                                               [&](std::size_t i) { return diameter[i] / 2.0; }),
                .contact_modulus = column(Parameter::contact_modulus),
                .work_of_adhesion = column(Parameter::work_of_adhesion),
                .yield_pressure = parameters_.has(Parameter::yield_pressure)
                                      ? column(Parameter::yield_pressure)
                                      : view_of(never_yields.data(), 1),
                .parameters = std::move(own)};
    }

  private:
    static View view_of(const double* numbers, std::size_t size) {
        return {numbers, static_cast<Eigen::Index>(size)};
    }
    /// number(i) for the first @p size of the problems.
    template <class Number>
    [[nodiscard]] View copy(Parameter parameter, std::size_t size, const Number& number) {
        std::vector<double>& numbers = copies_[place_of(parameter)];
        numbers.resize(std::max(numbers.size(), size));
        for (std::size_t i = 0; i < size; ++i) numbers[i] = number(first_ + i);
        return view_of(numbers.data(), size);
    }

    Parameters parameters_{};
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::array<std::vector<double>, most_parameters> copies_{};  ///< they only grow
};

/// Memory of this thread that calls use again, so that a single impact allocates nothing.
ColumnReader& reader_of_this_thread() {
    thread_local ColumnReader reader;
    return reader;
}

/// Solves the problems of a chunk that failed one by one, so that the message names the first that fails by
/// its place in the call, and names no place in a call of one problem.
template <class Solve>
void find_failure(std::size_t first, std::size_t size, bool only_one, const Solve& solve) {
    for (std::size_t i = first; i < first + size; ++i) {
        const std::string place = "impact " + std::to_string(i);
        try {
            solve(i, std::size_t{1});
        } catch (const InputError& error) {
            if (only_one) throw InputError(error.problem(), error.allowed());
            throw InputError(error.problem(), error.allowed()).at(place);
        } catch (const ConvergenceError& error) {
            std::string message = error.what();
            const std::string own_place = "impact 0: ";
            if (message.starts_with(own_place)) message.erase(0, own_place.size());
            if (!only_one) message.insert(0, ": ").insert(0, place);
            throw ConvergenceError(message);
        }
    }
}

/// Calls solve(reader, first, size) for the chunks of a call; rethrows for the first problem that fails.
/// @param needed besides the contact
template <class Solve>
void in_chunks(const Call& call, std::initializer_list<Parameter> needed, const Solve& solve) {
    call.parameters.require_contact(call.choice.law);
    for (const Parameter parameter : needed) call.parameters.require(parameter);
    const auto solve_part = [&](std::size_t first, std::size_t size) {
        ColumnReader& reader = reader_of_this_thread();
        reader.select(call.parameters, first, size);
        solve(reader, first, size);
    };
    for (std::size_t first = 0; first < call.count; first += call.chunk) {
        const std::size_t size = std::min(call.chunk, call.count - first);
        try {
            solve_part(first, size);
        } catch (const InputError&) {
            find_failure(first, size, call.count == 1, solve_part);
            throw;
        } catch (const ConvergenceError&) {
            find_failure(first, size, call.count == 1, solve_part);
            throw;
        }
        if (call.after_chunk) call.after_chunk();
    }
}

constexpr std::array tangential_columns{&TangentialOutputs::velocity,      &TangentialOutputs::spin,
                                        &TangentialOutputs::restitution,   &TangentialOutputs::rebound_angle,
                                        &TangentialOutputs::impulse_ratio, &TangentialOutputs::regime};

void require_oblique(const Parameters& parameters) {
    parameters.require(Parameter::friction);
    if (!parameters.has(Parameter::spin)) parameters.require(Parameter::tangential_velocity);
}

/// Copies results to the caller; a single one, of constants alone, to every place.
void write(const Eigen::ArrayXd& column, std::size_t first, std::size_t size, double* output) {
    if (output == nullptr) return;
    if (column.size() == 1) {
        std::fill_n(output + first, size, column[0]);
    } else {
        std::copy_n(column.data(), size, output + first);
    }
}

}  // namespace

std::string_view name_of(Parameter parameter) {
    return parameter_names()[place_of(parameter)];
}

Parameter parameter_named(std::string_view name) {
    const auto& names = parameter_names();
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) throw InputError("unknown parameter " + in_quotes(name), joined(names));
    return static_cast<Parameter>(found - names.begin());
}

Parameter alternative_to(Parameter parameter) {
    for (const auto& [one, other] : {std::pair{Parameter::density, Parameter::mass},
                                     std::pair{Parameter::diameter, Parameter::effective_radius}}) {
        if (parameter == one) return other;
        if (parameter == other) return one;
    }
    return parameter;
}

std::string note_on(const ModelChoice& choice, Parameter parameter) {
    const std::string name(name_of(parameter));
    const auto reason = idle_reason(choice.law, choice.damping_law, name);
    return reason ? name + ": " + idle_words(*reason) : std::string();
}

void Parameters::set(Parameter parameter, Strided source) {
    sources_[place_of(alternative_to(parameter))] = {};
    sources_[place_of(parameter)] = source;
}

void Parameters::require_contact(Law law) const {
    require(Parameter::contact_modulus);
    if (law.uses_work_of_adhesion()) require(Parameter::work_of_adhesion);
    if (law.is_plastic()) require(Parameter::yield_pressure);
    if (!has(Parameter::effective_radius)) require(Parameter::diameter);
    if (has(Parameter::mass)) return;
    require(Parameter::density);
    if (!has(Parameter::diameter))
        throw InputError("mass is missing: effective_radius and density do not tell it", "mass, or diameter");
}

void Parameters::require(Parameter parameter) const {
    if (has(parameter)) return;
    throw InputError(std::string(name_of(parameter)) + " is missing",
                     "numbers for it, as a parameter or a column");
}

ModelChoice choice_named(const char* law, const char* detachment, const char* damping_law) {
    if (law == nullptr) throw InputError("no law is given", law_names());
    const Law chosen = Law::named(law);
    return {.law = chosen,
            .detachment = detachment == nullptr ? chosen.default_detachment() : named<Detachment>(detachment),
            .damping_law = damping_law == nullptr ? DampingLaw::constant : named<DampingLaw>(damping_law)};
}

void solve_impacts(const Call& call, const ImpactOutputs& outputs) {
    const auto& [law, detachment, damping_law] = call.choice;
    const BatchOutputs& normal = outputs.normal;
    const bool turning_point = normal.approach_time != nullptr || normal.maximum_overlap != nullptr;
    const bool oblique = std::ranges::any_of(
        tangential_columns, [&](auto column) { return outputs.tangential.*column != nullptr; });
    if (oblique) require_oblique(call.parameters);
    const BatchOptions options{.threads = call.threads,
                               .turning_point = turning_point,
                               .contact_time = normal.contact_time != nullptr,
                               .method = outputs.method  ? *outputs.method
                                         : turning_point ? BatchMethod::integration
                                                         : method_of_many(law, damping_law)};
    in_chunks(call, {Parameter::velocity}, [&](ColumnReader& reader, std::size_t first, std::size_t size) {
        const ImpactBatch batch{law,
                                detachment,
                                damping_law,
                                reader.contact(law, damping_law),
                                reader.column(Parameter::damping),
                                reader.column(Parameter::velocity)};
        BatchOutputs part;
        for (const auto column : {&BatchOutputs::restitution, &BatchOutputs::contact_time,
                                  &BatchOutputs::approach_time, &BatchOutputs::maximum_overlap})
            if (normal.*column != nullptr) part.*column = normal.*column + first;
        std::vector<double> own(oblique && part.restitution == nullptr ? size : 0);
        if (!own.empty()) part.restitution = own.data();
        if (solve_impacts(batch, part, options).count <= 1)
            for (double* column :
                 {part.restitution, part.contact_time, part.approach_time, part.maximum_overlap})
                if (column != nullptr) std::fill_n(column, size, *column);
        if (!oblique) return;
        TangentialOutputs tangential;
        for (const auto column : tangential_columns)
            if (outputs.tangential.*column != nullptr)
                tangential.*column = outputs.tangential.*column + first;
        const auto of_sphere = [&](Parameter own_one, const Column& effective) {
            return call.parameters.has(own_one) ? Column(reader.column(own_one)) : effective;
        };
        solve_tangential(batch, part.restitution, size,
                         {of_sphere(Parameter::sphere_radius, batch.contact.effective_radius),
                          of_sphere(Parameter::sphere_mass, batch.contact.mass),
                          reader.column(Parameter::tangential_velocity), reader.column(Parameter::spin),
                          reader.column(Parameter::friction)},
                         tangential, call.threads);
    });
}

void solve_critical_velocities(const Call& call, double* critical_velocity) {
    const auto& [law, detachment, damping_law] = call.choice;
    in_chunks(call, {}, [&](ColumnReader& reader, std::size_t first, std::size_t size) {
        CriticalVelocityBatchResult result =
            critical_velocities({law, detachment, damping_law, reader.contact(law, damping_law),
                                 reader.column(Parameter::damping)},
                                call.threads, method_of_many_velocities(law, call.as_alone ? 1 : call.count));
        for (Eigen::Index i = 0; i < result.value.size(); ++i) {
            if (result.verdict[i] == CaptureVerdict::never_captured) result.value[i] = 0.0;
            if (result.verdict[i] == CaptureVerdict::always_captured)
                result.value[i] = std::numeric_limits<double>::infinity();
        }
        write(result.value, first, size, critical_velocity);
    });
}

void solve_dampings(const Call& call, const DampingOutputs& outputs) {
    const auto& [law, detachment, damping_law] = call.choice;
    in_chunks(call, {Parameter::velocity, Parameter::restitution},
              [&](ColumnReader& reader, std::size_t first, std::size_t size) {
                  const DampingBatchResult result = dampings_from_restitutions(
                      {law, detachment, damping_law, reader.contact(law, damping_law),
                       reader.column(Parameter::velocity), reader.column(Parameter::restitution)},
                      call.threads);
                  write(result.damping, first, size, outputs.damping);
                  write(result.greatest_restitution, first, size, outputs.greatest_restitution);
              });
}

}  // namespace ashimpact
