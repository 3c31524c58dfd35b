// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ashimpact/error.hpp"
#include "ashimpact/results.hpp"

namespace ashimpact {
inline namespace v1 {

/// Names of the parameters and columns are those of ashimpact.h; numbers are SI.
using Parameters = std::initializer_list<ashimpact_parameter>;
using Columns = std::initializer_list<ashimpact_column>;

/// A column of contiguous numbers, or one number for every row; what is passed must outlive the call.
[[nodiscard]] inline ashimpact_column column(const char* name, const std::vector<double>& values) {
    return {name, values.data(), 1};
}
[[nodiscard]] inline ashimpact_column column(const char* name, const double& value) {
    return {name, &value, 0};
}

/// How a contact ends, and how it is damped. An empty name means the law's own detachment, or constant
/// damping.
struct Choices {
    std::string detachment{};  ///< zero-overlap, zero-force, pull-off, load-controlled
    /// constant [kg/s], contact-radius [Pa s], tsuji [1], hunt-crossley [s/m], brach-dunn-damping [s/m]
    std::string damping_law{};
};

/// A contact law with the constants of a particle and a wall (Dong et al. 2013; docs/laws names the source of
/// each law). A model is immutable, so any number of threads may use it at once. Every function throws
/// InputError for what is not admissible, naming what is allowed, and ConvergenceError. Floating-point traps,
/// flags and modes of the caller are neither disturbed nor used.
class Model {
  public:
    /// @param law hertz, dmt, brach-dunn, jkr, ...
    /// @param parameters {{"density", 2160.0}, {"contact_modulus", 60e9}, ...} [SI]
    /// @param choices detachment and damping law, if not the default ones
    Model(const std::string& law, Parameters parameters, const Choices& choices = {}) {
        ashimpact_error error;
        ashimpact_model* made = nullptr;
        check(ashimpact_open(law.c_str(), name_or_none(choices.detachment), name_or_none(choices.damping_law),
                             parameters.begin(), parameters.size(), &made, &error),
              error);
        model_.reset(made);
        note_ = error.message;
    }

    /// Names the parameters that change nothing with the law; empty if all of them count.
    [[nodiscard]] const std::string& note() const { return note_; }

    /// Restitution e_n of a sphere on a flat wall; 0 for a capture [1].
    /// @param diameter [m] @param velocity of approach, > 0 [m/s]
    [[nodiscard]] double restitution(double diameter, double velocity) const {
        double result = 0.0;
        ashimpact_error error;
        check(ashimpact_restitution(model_.get(), diameter, velocity, &result, &error), error);
        return result;
    }

    /// Critical velocity of a sphere on a flat wall: captured below it, rebounding above; 0 if it always
    /// rebounds, infinite if it is always captured [m/s]. @param diameter [m]
    [[nodiscard]] double critical_velocity(double diameter) const {
        double result = 0.0;
        ashimpact_error error;
        check(ashimpact_critical_velocity(model_.get(), diameter, &result, &error), error);
        return result;
    }

    /// Restitutions of many spheres [1]. @param diameter [m] @param velocity [m/s], as many as diameters
    [[nodiscard]] std::vector<double> restitutions(const std::vector<double>& diameter,
                                                   const std::vector<double>& velocity) const {
        if (diameter.size() != velocity.size()) throw InputError("diameter and velocity differ in length");
        std::vector<double> result(diameter.size());
        ashimpact_error error;
        check(ashimpact_restitutions(model_.get(), result.size(), diameter.data(), velocity.data(),
                                     result.data(), &error),
              error);
        return result;
    }

    /// Critical velocities of many spheres [m/s]. @param diameter [m]
    [[nodiscard]] std::vector<double> critical_velocities(const std::vector<double>& diameter) const {
        std::vector<double> result(diameter.size());
        ashimpact_error error;
        check(ashimpact_critical_velocities(model_.get(), result.size(), diameter.data(), result.data(),
                                            &error),
              error);
        return result;
    }

    /// Many impacts; any parameter may be a column of @p count values or one value; see
    /// ashimpact_solve_impacts().
    [[nodiscard]] Impacts impacts(std::size_t count, Columns columns) const {
        Impacts out{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count),
                    std::vector<double>(count)};
        solve(ashimpact_solve_impacts, count, columns,
              {{"restitution", out.restitution.data()},
               {"contact_time", out.contact_time.data()},
               {"approach_time", out.approach_time.data()},
               {"maximum_overlap", out.maximum_overlap.data()}});
        return out;
    }

    /// Many critical velocities [m/s], parameters as in impacts(); see ashimpact_solve_critical_velocities().
    [[nodiscard]] std::vector<double> critical_velocities(std::size_t count, Columns columns) const {
        std::vector<double> out(count);
        solve(ashimpact_solve_critical_velocities, count, columns, {{"critical_velocity", out.data()}});
        return out;
    }

    /// Dampings that give measured restitutions back; see ashimpact_solve_dampings().
    [[nodiscard]] Dampings dampings(std::size_t count, Columns columns) const {
        Dampings out{std::vector<double>(count), std::vector<double>(count)};
        solve(ashimpact_solve_dampings, count, columns,
              {{"damping", out.damping.data()}, {"greatest_restitution", out.greatest_restitution.data()}});
        return out;
    }

    /// The handle of the C interface; it stays with the model.
    [[nodiscard]] const ashimpact_model* handle() const { return model_.get(); }

  private:
    struct Close {
        void operator()(ashimpact_model* model) const { ashimpact_close(model); }
    };

    static const char* name_or_none(const std::string& name) { return name.empty() ? nullptr : name.c_str(); }

    template <class Function>
    void solve(Function function, std::size_t count, Columns columns,
               std::initializer_list<ashimpact_output> outputs) const {
        if (count == 0) return;
        ashimpact_error error;
        check(function(model_.get(), count, columns.begin(), columns.size(), outputs.begin(), outputs.size(),
                       &error),
              error);
    }

    std::unique_ptr<ashimpact_model, Close> model_{};
    std::string note_{};
};

}  // namespace v1
}  // namespace ashimpact
