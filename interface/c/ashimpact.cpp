// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/include/ashimpact.h"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "interface/c/floating_point.hpp"
#include "interface/c/model.hpp"
#include "interface/c/solve.hpp"

namespace {

using ashimpact::Call;
using ashimpact::InputError;
using ashimpact::OwnFloatingPoint;
using ashimpact::Parameter;

ashimpact_status report(ashimpact_status status, std::string_view message, ashimpact_error* error) noexcept {
    if (error == nullptr) return status;
    const std::size_t size = std::min(message.size(), sizeof error->message - 1);
    std::copy_n(message.data(), size, error->message);
    error->message[size] = '\0';
    return status;
}

/// A call of its own, so that the compiler moves none of its operations before the change of floating point.
template <class Work>
[[gnu::noinline]] void do_apart(const Work& work) {
    work();
}

/// Does a call's work in floating point of its own, and turns what it throws into a status and a message.
template <class Work>
ashimpact_status guarded(ashimpact_error* error, const Work& work) noexcept {
    const OwnFloatingPoint own;
    try {
        do_apart(work);
        return report(ASHIMPACT_OK, {}, error);
    } catch (const InputError& refused) {
        return report(ASHIMPACT_INPUT_ERROR, refused.what(), error);
    } catch (const ashimpact::ConvergenceError& failed) {
        return report(ASHIMPACT_NOT_CONVERGED, failed.what(), error);
    } catch (const std::bad_alloc&) {
        return report(ASHIMPACT_DEFECT, "no memory left", error);
    } catch (const std::exception& defect) {
        return report(ASHIMPACT_DEFECT, defect.what(), error);
    } catch (...) {
        return report(ASHIMPACT_DEFECT, "an unknown exception", error);
    }
}

/// @throws InputError for a null pointer
void require(const void* pointer, std::string_view name) {
    if (pointer == nullptr) throw InputError(std::string(name) + " is NULL");
}

/// A call on spheres, of one column or two.
Call call_of(const ashimpact_model* model, std::size_t count, const double* diameter,
             const double* velocity) {
    require(model, "model");
    Call call{*model, model->parameters(), count};
    require(diameter, "diameter");
    call.parameters.set(Parameter::diameter, {diameter, 1});
    if (velocity != nullptr) call.parameters.set(Parameter::velocity, {velocity, 1});
    return call;
}

Call call_of(const ashimpact_model* model, std::size_t count, const ashimpact_column* columns,
             std::size_t column_count) {
    require(model, "model");
    if (column_count > 0) require(columns, "columns");
    Call call{*model, model->parameters(), count};
    for (std::size_t i = 0; i < column_count; ++i) {
        const Parameter parameter = ashimpact::parameter_named(columns[i].name);
        if (count > 0) require(columns[i].values, "values of column " + std::string(columns[i].name));
        call.parameters.set(parameter, {columns[i].values, columns[i].stride});
    }
    return call;
}

struct NamedOutput {
    std::string_view name;
    double** values;
};

/// Finds the array of each output that is asked for. @throws InputError for a name that is not among @p known
void take_outputs(const ashimpact_output* outputs, std::size_t count,
                  std::initializer_list<NamedOutput> known) {
    if (count > 0) require(outputs, "outputs");
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view wanted =
            outputs[i].name == nullptr ? std::string_view("(null)") : outputs[i].name;
        const auto* const found = std::ranges::find_if(
            known, [wanted](const NamedOutput& output) { return output.name == wanted; });
        if (found == known.end()) {
            std::string names;
            for (const NamedOutput& output : known)
                names += (names.empty() ? "" : ", ") + std::string(output.name);
            throw InputError("unknown output " + ashimpact::in_quotes(wanted), names);
        }
        require(outputs[i].values, "values of output " + std::string(wanted));
        *found->values = outputs[i].values;
    }
}

}  // namespace

const char* ashimpact_version(void) {
    return ashimpact::program_version().data();  // of a string literal, so that it ends with a zero
}

ashimpact_status ashimpact_open(const char* law, const char* detachment, const char* damping_law,
                                const ashimpact_parameter* parameters, size_t count, ashimpact_model** model,
                                ashimpact_error* error) {
    return guarded(error, [&] {
        require(model, "model");
        *model = nullptr;
        *model = new ashimpact_model(ashimpact::make_model(law, detachment, damping_law, parameters, count));
    });
}

void ashimpact_close(ashimpact_model* model) {
    delete model;
}

ashimpact_status ashimpact_restitution(const ashimpact_model* model, double diameter, double velocity,
                                       double* restitution, ashimpact_error* error) {
    return guarded(error, [&] {
        require(model, "model");
        require(restitution, "restitution");
        if (const auto e = model->spheres ? model->spheres->restitution(diameter, velocity) : std::nullopt) {
            *restitution = *e;
            return;
        }
        solve_impacts(call_of(model, 1, &diameter, &velocity), {.restitution = restitution});
    });
}

ashimpact_status ashimpact_restitutions(const ashimpact_model* model, size_t count, const double* diameter,
                                        const double* velocity, double* restitution, ashimpact_error* error) {
    return guarded(error, [&] {
        if (count == 0) return;
        require(velocity, "velocity");
        require(restitution, "restitution");
        solve_impacts(call_of(model, count, diameter, velocity), {.restitution = restitution});
    });
}

ashimpact_status ashimpact_critical_velocity(const ashimpact_model* model, double diameter,
                                             double* critical_velocity, ashimpact_error* error) {
    return guarded(error, [&] {
        require(model, "model");
        require(critical_velocity, "critical_velocity");
        if (const auto v = model->spheres ? model->spheres->critical_velocity(diameter) : std::nullopt) {
            *critical_velocity = *v;
            return;
        }
        solve_critical_velocities(call_of(model, 1, &diameter, nullptr), critical_velocity);
    });
}

ashimpact_status ashimpact_critical_velocities(const ashimpact_model* model, size_t count,
                                               const double* diameter, double* critical_velocity,
                                               ashimpact_error* error) {
    return guarded(error, [&] {
        if (count == 0) return;
        require(critical_velocity, "critical_velocity");
        solve_critical_velocities(call_of(model, count, diameter, nullptr), critical_velocity);
    });
}

ashimpact_status ashimpact_solve_impacts(const ashimpact_model* model, size_t count,
                                         const ashimpact_column* columns, size_t column_count,
                                         const ashimpact_output* outputs, size_t output_count,
                                         ashimpact_error* error) {
    return guarded(error, [&] {
        const Call call = call_of(model, count, columns, column_count);
        ashimpact::ImpactOutputs out;
        take_outputs(outputs, output_count,
                     {{"restitution", &out.restitution},
                      {"contact_time", &out.contact_time},
                      {"approach_time", &out.approach_time},
                      {"maximum_overlap", &out.maximum_overlap}});
        solve_impacts(call, out);
    });
}

ashimpact_status ashimpact_solve_critical_velocities(const ashimpact_model* model, size_t count,
                                                     const ashimpact_column* columns, size_t column_count,
                                                     const ashimpact_output* outputs, size_t output_count,
                                                     ashimpact_error* error) {
    return guarded(error, [&] {
        const Call call = call_of(model, count, columns, column_count);
        double* out = nullptr;
        take_outputs(outputs, output_count, {{"critical_velocity", &out}});
        solve_critical_velocities(call, out);
    });
}

ashimpact_status ashimpact_solve_dampings(const ashimpact_model* model, size_t count,
                                          const ashimpact_column* columns, size_t column_count,
                                          const ashimpact_output* outputs, size_t output_count,
                                          ashimpact_error* error) {
    return guarded(error, [&] {
        const Call call = call_of(model, count, columns, column_count);
        ashimpact::DampingOutputs out;
        take_outputs(outputs, output_count,
                     {{"damping", &out.damping}, {"greatest_restitution", &out.greatest_restitution}});
        solve_dampings(call, out);
    });
}
