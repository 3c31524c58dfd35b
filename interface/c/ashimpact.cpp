// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/include/ashimpact.h"

#include <algorithm>
#include <array>
#include <cfenv>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "interface/c/calls.hpp"
#include "solver/batch/single_impacts.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/impact.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#include <xmmintrin.h>
#endif

namespace ashimpact {

namespace {

/// Floating point as the solver expects it, for the life of this object: nothing traps, results are rounded
/// to nearest and denormal numbers are kept. The caller's environment comes back with it, flags included:
/// codes such as OpenFOAM trap, others flush denormal numbers to zero.
class CompleteFloatingPoint {
  public:
    CompleteFloatingPoint() {
        std::feholdexcept(&callers_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~CompleteFloatingPoint() { std::fesetenv(&callers_); }
    CompleteFloatingPoint(const CompleteFloatingPoint&) = delete;
    CompleteFloatingPoint& operator=(const CompleteFloatingPoint&) = delete;

  private:
    std::fenv_t callers_{};
};

#if defined(__x86_64__) && defined(__GNUC__)

/// The same on x86-64, without saving the x87 unit's flags, which takes as long as an impact from a table.
class OwnFloatingPoint {
  public:
    OwnFloatingPoint() {
        if ((x87_status() & x87_flags) != 0) {
            complete_.emplace();
            return;
        }
        sse_ = _mm_getcsr();
        _mm_setcsr(default_sse);
        x87_ = x87_control();
        if (x87_ != default_x87) set_x87_control(default_x87);
    }
    ~OwnFloatingPoint() {
        if (complete_) return;
        if ((x87_status() & x87_flags) != 0) __asm__ volatile("fnclex");
        if (x87_ != default_x87) set_x87_control(x87_);
        _mm_setcsr(sse_);
    }
    OwnFloatingPoint(const OwnFloatingPoint&) = delete;
    OwnFloatingPoint& operator=(const OwnFloatingPoint&) = delete;

  private:
    static constexpr unsigned short default_x87 = 0x037F;  ///< as FE_DFL_ENV has it
    static constexpr unsigned int default_sse = 0x1F80;
    static constexpr unsigned short x87_flags = 0x7F;  ///< of exceptions, and of a stack fault

    static unsigned short x87_control() {
        unsigned short control = 0;
        __asm__ volatile("fnstcw %0" : "=m"(control));
        return control;
    }
    static void set_x87_control(unsigned short control) { __asm__ volatile("fldcw %0" : : "m"(control)); }
    static unsigned short x87_status() {
        unsigned short status = 0;
        __asm__ volatile("fnstsw %0" : "=am"(status));
        return status;
    }

    unsigned int sse_ = 0;
    unsigned short x87_ = default_x87;
    std::optional<CompleteFloatingPoint> complete_{};
};

#else
using OwnFloatingPoint = CompleteFloatingPoint;
#endif

}  // namespace

/// Impacts of spheres one by one, with the constants of a model.
struct SphereImpacts {
    SingleImpacts impacts;
    ContactPair contact;              ///< mass and effective radius are those of the sphere
    double damping = 0.0;             ///< [unit of the damping law]
    std::optional<double> density{};  ///< [kg/m3]; none: every sphere has the mass of the contact

    /// e_n [1] and v_c [m/s] as SingleImpacts gives them; none: let a batch of one solve it.
    [[nodiscard]] std::optional<double> restitution(double diameter, double velocity) const {
        return impacts.restitution(contact_of(diameter), damping, velocity);
    }
    [[nodiscard]] std::optional<double> critical_velocity(double diameter) const {
        return impacts.critical_velocity(contact_of(diameter), damping);
    }

  private:
    /// The contact of a sphere of a diameter [m].
    [[nodiscard]] ContactPair contact_of(double diameter) const {
        ContactPair pair = contact;
        pair.effective_radius = diameter / 2.0;
        if (density) pair.mass = mass_of_sphere(*density, diameter);
        return pair;
    }
};

}  // namespace ashimpact

/// The model behind a handle of the C interface; immutable.
struct ashimpact_model {  // NOLINT(readability-identifier-naming): the name of the C interface
    ashimpact::ModelChoice choice;
    std::array<std::optional<double>, ashimpact::most_parameters> constants{};
    std::optional<ashimpact::SphereImpacts> spheres{};  ///< none: constants for a sphere are missing

    [[nodiscard]] const std::optional<double>& operator[](ashimpact::Parameter parameter) const {
        return constants[ashimpact::place_of(parameter)];
    }
    /// The sources of a call without columns: the constants.
    [[nodiscard]] ashimpact::Parameters parameters() const {
        ashimpact::Parameters sources;
        for (std::size_t place = 0; place < constants.size(); ++place)
            if (constants[place])
                sources.set(static_cast<ashimpact::Parameter>(place), {&*constants[place], 0});
        return sources;
    }
};

namespace {

using namespace ashimpact;

/// As parameter_named(); NULL is unknown.
Parameter parameter_of(const char* name) {
    return parameter_named(name == nullptr ? "(null)" : name);
}

/// Checks that a name is new among those given, as is what may stand in its place. @throws InputError
template <class IsGiven>
void require_new(Parameter parameter, const IsGiven& is_given) {
    const std::string name(name_of(parameter));
    const Parameter other = alternative_to(parameter);
    if (is_given(parameter)) throw InputError(name + " is given twice");
    if (is_given(other))
        throw InputError(name + " is given beside " + std::string(name_of(other)), "one of them");
}

void add_note(std::string& notes, const std::string& note) {
    notes += (notes.empty() || note.empty() ? "" : "; ") + note;
}

/// @return a note on constants that change nothing
std::string take_constants(ashimpact_model& model, const ashimpact_parameter* parameters, std::size_t count) {
    if (count > 0 && parameters == nullptr)
        throw InputError("parameters is NULL", "an array of count of them");
    std::string notes;
    for (std::size_t i = 0; i < count; ++i) {
        const Parameter parameter = parameter_of(parameters[i].name);
        require_new(parameter, [&](Parameter each) { return model[each].has_value(); });
        add_note(notes, note_on(model.choice, parameter));
        model.constants[place_of(parameter)] = parameters[i].value;
    }
    return notes;
}

/// The contact of a model's constants without parameters of its law; missing ones get admissible numbers.
ContactPair contact_of(const ashimpact_model& model) {
    ContactPair pair{.mass = model[Parameter::mass].value_or(1.0),
                     .effective_radius = model[Parameter::effective_radius].value_or(1.0),
                     .contact_modulus = model[Parameter::contact_modulus].value_or(1.0),
                     .work_of_adhesion = model[Parameter::work_of_adhesion].value_or(0.0)};
    if (model[Parameter::yield_pressure]) pair.yield_pressure = *model[Parameter::yield_pressure];
    return pair;
}

/// The model's constants as a contact of a sphere; none if a constant that it needs is missing.
std::optional<SphereImpacts> sphere_impacts(const ashimpact_model& model) {
    const auto& [law, detachment, damping_law] = model.choice;
    const auto& density = model[Parameter::density];
    const auto is_given = [&](const LawParameter& parameter) {
        return model[parameter_named(parameter.name)].has_value();
    };
    if ((!density && !model[Parameter::mass]) ||
        (law.uses_work_of_adhesion() && !model[Parameter::work_of_adhesion]) ||
        (law.is_plastic() && !model[Parameter::yield_pressure]) ||
        parameter_fault(parameters_of(law, damping_law), is_given))
        return std::nullopt;
    SphereImpacts spheres{.impacts = {law, detachment, damping_law},
                          .contact = contact_of(model),
                          .damping = model[Parameter::damping].value_or(0.0),
                          .density = density};
    for (const LawParameter& parameter : parameters_of(law, damping_law)) {
        if (const auto value = model[parameter_named(parameter.name)])
            spheres.contact.parameters.set(parameter.name, *value);
    }
    return spheres;
}

/// The constants that are given are checked in an impact whose other numbers are admissible.
void check_constants(const ashimpact_model& model) {
    const auto& [law, detachment, damping_law] = model.choice;
    if (!model[Parameter::contact_modulus]) throw InputError("contact_modulus is missing", "its value in Pa");
    if (const auto density = model[Parameter::density])
        require_positive("density", *density, Dimension::density);
    if (const auto diameter = model[Parameter::diameter])
        require_positive("diameter", *diameter, Dimension::length);
    for (const LawParameter& parameter : law_parameters()) {
        if (const auto value = model[parameter_named(parameter.name)]) require_allowed(parameter, *value);
    }
    ContactPair pair = contact_of(model);
    pair.parameters = typical_parameters(parameters_of(law, damping_law));
    validate(Impact{law,
                    detachment,
                    {damping_law, model[Parameter::damping].value_or(0.0)},
                    pair,
                    model[Parameter::velocity].value_or(1.0)});
}

/// Makes a model from what ashimpact_open() takes, null pointers included.
/// @param notes gets a note on constants that change nothing
/// @throws InputError for a name that is unknown, a constant that is not admissible, missing or given twice
ashimpact_model make_model(const char* law, const char* detachment, const char* damping_law,
                           const ashimpact_parameter* parameters, std::size_t count, std::string& notes) {
    ashimpact_model model{.choice = choice_named(law, detachment, damping_law)};
    if (const auto reason = refusal(model.choice.law, model.choice.detachment))
        throw InputError(*reason, admissible_detachments(model.choice.law));
    notes = take_constants(model, parameters, count);
    check_constants(model);
    model.spheres = sphere_impacts(model);
    return model;
}

ashimpact_status report(ashimpact_status status, std::string_view message, ashimpact_error* error) noexcept {
    if (error == nullptr) return status;
    const std::size_t size = std::min(message.size(), sizeof error->message - 1);
    std::copy_n(message.data(), size, error->message);
    error->message[size] = '\0';
    return status;
}

/// A call of its own, so that the compiler moves none of its operations before the change of floating point.
template <class Work>
[[gnu::noinline]] auto do_apart(const Work& work) {
    return work();
}

/// Does a call's work in floating point of its own, and turns what it throws into a status and a message;
/// what it returns is a note.
template <class Work>
ashimpact_status guarded(ashimpact_error* error, const Work& work) noexcept {
    const OwnFloatingPoint own;
    try {
        if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
            do_apart(work);
            return report(ASHIMPACT_OK, {}, error);
        } else {
            return report(ASHIMPACT_OK, do_apart(work), error);
        }
    } catch (const InputError& refused) {
        return report(ASHIMPACT_INPUT_ERROR, refused.what(), error);
    } catch (const ConvergenceError& failed) {
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
    Call call{.choice = model->choice, .parameters = model->parameters(), .count = count, .as_alone = true};
    require(diameter, "diameter");
    call.parameters.set(Parameter::diameter, {diameter, 1});
    if (velocity != nullptr) call.parameters.set(Parameter::velocity, {velocity, 1});
    return call;
}

/// A call with columns, and a note on those that change nothing with the law.
struct NotedCall {
    Call call;
    std::string notes{};
};

/// @param unused by this function @throws InputError for a column that is one of them, unknown or doubled
NotedCall call_of(const ashimpact_model* model, std::size_t count, const ashimpact_column* columns,
                  std::size_t column_count, std::initializer_list<Parameter> unused) {
    require(model, "model");
    if (column_count > 0) require(columns, "columns");
    NotedCall made{.call = {model->choice, model->parameters(), count}};
    Parameters given;
    for (std::size_t i = 0; i < column_count; ++i) {
        const Parameter parameter = parameter_of(columns[i].name);
        if (count > 0) require(columns[i].values, "values of column " + std::string(columns[i].name));
        if (std::ranges::find(unused, parameter) != unused.end())
            throw InputError("this function uses no column " + std::string(columns[i].name));
        require_new(parameter, [&](Parameter each) { return given.has(each); });
        add_note(made.notes, note_on(model->choice, parameter));
        given.set(parameter, {columns[i].values, columns[i].stride});
        made.call.parameters.set(parameter, given[parameter]);
    }
    return made;
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
            throw InputError("unknown output " + in_quotes(wanted), names);
        }
        require(outputs[i].values, "values of output " + std::string(wanted));
        if (*found->values != nullptr) throw InputError("output " + std::string(wanted) + " is given twice");
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
        std::string notes;
        *model = new ashimpact_model(make_model(law, detachment, damping_law, parameters, count, notes));
        return notes;
    });
}

const char* ashimpact_method(const ashimpact_model* model) {
    if (model == nullptr) return nullptr;
    return name_of(method_of_many(model->choice.law, model->choice.damping_law)).data();  // a literal
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
        solve_impacts(call_of(model, 1, &diameter, &velocity), {.normal = {.restitution = restitution}});
    });
}

ashimpact_status ashimpact_restitutions(const ashimpact_model* model, size_t count, const double* diameter,
                                        const double* velocity, double* restitution, ashimpact_error* error) {
    return guarded(error, [&] {
        if (count == 0) return;
        require(velocity, "velocity");
        require(restitution, "restitution");
        solve_impacts(call_of(model, count, diameter, velocity), {.normal = {.restitution = restitution}});
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
        const auto [call, notes] = call_of(model, count, columns, column_count, {Parameter::restitution});
        ImpactOutputs out;
        take_outputs(outputs, output_count,
                     {{"restitution", &out.normal.restitution},
                      {"contact_time", &out.normal.contact_time},
                      {"approach_time", &out.normal.approach_time},
                      {"maximum_overlap", &out.normal.maximum_overlap},
                      {"rebound_tangential_velocity", &out.tangential.velocity},
                      {"rebound_spin", &out.tangential.spin},
                      {"tangential_restitution", &out.tangential.restitution},
                      {"rebound_angle", &out.tangential.rebound_angle},
                      {"impulse_ratio", &out.tangential.impulse_ratio},
                      {"regime", &out.tangential.regime}});
        solve_impacts(call, out);
        return notes;
    });
}

ashimpact_status ashimpact_solve_critical_velocities(const ashimpact_model* model, size_t count,
                                                     const ashimpact_column* columns, size_t column_count,
                                                     const ashimpact_output* outputs, size_t output_count,
                                                     ashimpact_error* error) {
    return guarded(error, [&] {
        const auto [call, notes] =
            call_of(model, count, columns, column_count, {Parameter::velocity, Parameter::restitution});
        double* out = nullptr;
        take_outputs(outputs, output_count, {{"critical_velocity", &out}});
        solve_critical_velocities(call, out);
        return notes;
    });
}

ashimpact_status ashimpact_solve_dampings(const ashimpact_model* model, size_t count,
                                          const ashimpact_column* columns, size_t column_count,
                                          const ashimpact_output* outputs, size_t output_count,
                                          ashimpact_error* error) {
    return guarded(error, [&] {
        const auto [call, notes] = call_of(model, count, columns, column_count, {Parameter::damping});
        DampingOutputs out;
        take_outputs(outputs, output_count,
                     {{"damping", &out.damping}, {"greatest_restitution", &out.greatest_restitution}});
        solve_dampings(call, out);
        return notes;
    });
}
