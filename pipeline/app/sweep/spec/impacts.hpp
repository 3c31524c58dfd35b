// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pipeline/app/sweep/spec/spec.hpp"
#include "pipeline/present/report/sweep/sweep_page.hpp"
#include "solver/batch/batch.hpp"

namespace ashimpact {

/// Many impacts of a sweep [SI]: a value for each of them, or a single one for all; velocities are always one
/// for each. Columns refer to the variables that they are made from, or to values kept here.
class ImpactColumns {
  public:
    using Values = std::span<const double>;

    /// @param variables @p count values of each variable of the sweep [SI]; they must outlive this
    ImpactColumns(const SweepSpec& spec, const std::vector<std::vector<double>>& variables,
                  std::size_t count);
    ImpactColumns(const ImpactColumns&) = delete;
    ImpactColumns& operator=(const ImpactColumns&) = delete;

    Values mass;  ///< m*
    Values effective_radius;
    Values contact_modulus;
    Values work_of_adhesion;
    Values yield_pressure;
    Values damping;
    Values velocity;
    std::vector<std::pair<std::string_view, Values>> parameters;  ///< of contact laws, by name

  private:
    Values keep(Eigen::ArrayXd values);

    std::vector<Eigen::ArrayXd> kept_;
};

/// The value of impact @p i of a column.
[[nodiscard]] inline double value_at(std::span<const double> column, std::size_t i) {
    return column.size() == 1 ? column.front() : column[i];
}

/// Contact law, detachment and damping law of many impacts.
struct ImpactModel {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
};

/// The middle 99 % of the values of an input; all of those that are listed.
[[nodiscard]] Support bulk_of(const SweepSpec& spec, ImpactInput input);

/// What to doubt where sizes vary: a constant damping that is the same for all of them without the spec
/// stating so, and a Tabor parameter that stays while what it depends on varies.
[[nodiscard]] std::vector<std::string> warnings_of_sizes(const SweepSpec& spec);

/// A share of the captures.
struct OutsideShare {
    double fraction = 0;     ///< [1]
    double uncertainty = 0;  ///< standard uncertainty by the number of impacts [1]; 0 of a whole grid
};

/// By law, the share of captures whose critical velocity is above fastest_in_model: from 1024 impacts, or so
/// many more that there are 1000 captures among them, at most 65,536 unless the scalar solver takes them.
[[nodiscard]] std::vector<OutsideShare> captures_outside_model(const SweepSpec& spec);

/// The doubts about such captures, and by law the share of impacts that it does not hold for (of 100).
/// @param outside of captures_outside_model()
[[nodiscard]] std::vector<std::string> warnings_of_impacts(const SweepSpec& spec,
                                                           const std::vector<OutsideShare>& outside);

/// Results wanted in addition to the restitution (others stay empty), and the method to compute them.
struct WantedResults {
    bool contact_time = false;
    bool maximum_overlap = false;
    BatchMethod method = BatchMethod::integration;
};

/// An impact that did not converge.
struct FailedSolution {
    std::uint64_t place;  ///< among the impacts
    std::string reason;
    std::string command;  ///< shell command that computes this impact alone
};

/// Results of the impacts, one entry each; NaN if an impact did not converge.
struct ResultColumns {
    std::vector<double> restitution;      ///< 0 for a capture
    std::vector<double> contact_time;     ///< NaN for a capture [s]
    std::vector<double> maximum_overlap;  ///< [m]
    std::vector<FailedSolution> failed{};
};

/// Solves many impacts. The result of an impact must not depend on the other impacts.
using ImpactSolver =
    std::function<ResultColumns(const ImpactModel&, const ImpactColumns&, const WantedResults&)>;

/// The batch solver, on the calling thread. @throws InputError naming what a variable may not be
[[nodiscard]] ResultColumns solve_in_batch(const ImpactModel& model, const ImpactColumns& impacts,
                                           const WantedResults& wanted);

/// Capture fraction against each variable, from at most 8192 impacts of the design, solved again: value by
/// value if there are few, else in sixteen parts of equally many impacts.
[[nodiscard]] report::CaptureFractions capture_fractions(const SweepSpec& spec);

/// The same from the result of a sweep, whose provenance holds the spec. @throws InputError
[[nodiscard]] report::CaptureFractions capture_fractions(const Json& artifact);

}  // namespace ashimpact
