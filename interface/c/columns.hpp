// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "interface/c/parameters.hpp"
#include "solver/batch/columns.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// Hands the numbers of a call to the batch solver, some consecutive problems at a time. A column refers to
/// the caller's numbers where they lie side by side, and to a copy in here where they do not or are computed.
class ColumnReader {
  public:
    static constexpr std::size_t capacity =
        2048;  ///< problems at a time: what the batch solver takes at once
    using View = Eigen::Map<const Eigen::ArrayXd>;

    /// Sources of problems first to first + count - 1; count <= capacity.
    void select(Law law, const Parameters& parameters, std::size_t first, std::size_t count);

    /// Mass and effective radius come from density and diameter where they are not given themselves.
    [[nodiscard]] ContactColumns contact();
    /// A column of one value or of count; 0 for all where the parameter was not set.
    [[nodiscard]] View column(Parameter parameter);

  private:
    [[nodiscard]] View mass();
    [[nodiscard]] View effective_radius();
    /// A place for numbers that belong to a parameter, and these numbers.
    [[nodiscard]] double* copy_of(Parameter parameter);
    [[nodiscard]] static View view_of(const double* numbers, Eigen::Index size) { return {numbers, size}; }

    Law law_;
    Parameters parameters_{};
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::vector<std::array<double, capacity>> copies_{parameter_names().size()};
};

/// Checks that a contact can be made of what is set, and that what else is needed is there.
/// @throws InputError naming what is missing
void require_contact(const Parameters& parameters);
void require_column(const Parameters& parameters, Parameter parameter);

}  // namespace ashimpact
