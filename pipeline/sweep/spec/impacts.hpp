#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/sweep/spec/spec.hpp"
#include "solver/batch/impact_batch.hpp"

namespace ashimpact {

/// Many impacts [SI]: a value for each of them, or a single one for all; velocities are always one for each.
struct ImpactColumns {
    std::vector<double> mass;  ///< m*
    std::vector<double> effective_radius;
    std::vector<double> contact_modulus;
    std::vector<double> work_of_adhesion;
    std::vector<double> yield_pressure;
    std::vector<double> damping;
    std::vector<double> velocity;
    std::vector<std::pair<std::string_view, std::vector<double>>> parameters;  ///< of contact laws, by name
};

/// The value of impact @p i of a column.
[[nodiscard]] inline double value_at(const std::vector<double>& column, std::size_t i) {
    return column.size() == 1 ? column.front() : column[i];
}

/// Contact law, detachment and damping law of many impacts.
struct ImpactModel {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
};

/// The impacts of a sweep.
/// @param variables values of each variable of the sweep, as many of each [SI] @param count how many of each
[[nodiscard]] ImpactColumns impacts_of(const SweepSpec& spec,
                                       const std::vector<std::vector<double>>& variables, std::size_t count);

/// The same for the batch solver; it refers to @p impacts.
[[nodiscard]] ImpactBatch batch_of(const ImpactModel& model, const ImpactColumns& impacts);

}  // namespace ashimpact
