// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/values.hpp"
#include "pipeline/run/results/note.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

/// A contact time at the velocity of a published one.
struct ContactTimeAt {
    Law law;
    double velocity = 0;                   ///< [m/s]
    std::optional<double> restitution{};   ///< [1]
    std::optional<double> contact_time{};  ///< none: the contact never ends [s]
};

/// Which impact a history is of.
enum class HistoryPart {
    critical,     ///< just above the critical velocity
    rising,       ///< the middle point of the rising branch
    at_critical,  ///< at the critical velocity
    falling,      ///< the middle one of the impacts beyond the rising branch
};

template <>
struct Names<HistoryPart> {
    static constexpr std::string_view kind = "part";
    static constexpr std::array<std::string_view, 4> all{"critical", "rising", "at-critical", "falling"};
};

/// Whether the history is of a LawCurve, of which only the trajectory is known.
[[nodiscard]] constexpr bool is_of_a_curve(HistoryPart part) {
    return part == HistoryPart::at_critical || part == HistoryPart::falling;
}

/// Both sides of an equation [unit of D].
template <Dimension D>
struct Sides {
    double left = 0, right = 0;
};

/// Momentum balance of a history; Eqs. 35-45.
struct HistoryMomentum {
    StageMomentum approach{}, rebound{};
    double mean_force_ratio = 0;  ///< rebound over approach; the paper takes it for 1 [1]
    double damping_impulse = 0;   ///< left side of (44) [N s]
    double momentum_lost = 0;     ///< right side of (44) [N s]
    std::optional<Sides<Dimension::impulse>> equation_41{};
    /// Half the damping impulse times v_in + v_r against the work of damping.
    std::optional<Sides<Dimension::energy>> equation_42{};
    /// The work of damping against the kinetic energy lost.
    std::optional<Sides<Dimension::energy>> equation_43{};
    bool damping_exceeds_loss = false;  ///< (44) holds
    bool rebound_is_longer = false;     ///< (45) holds
    std::string verdict{};              ///< in words
};

/// Overlap against time of one impact.
struct History {
    HistoryPart part = HistoryPart::critical;
    double velocity = 0;  ///< [m/s]
    double damping = 0;   ///< [unit of the damping law]
    Outcome outcome = Outcome::rebound;
    double restitution = 0;                  ///< [1]
    std::optional<double> contact_time{};    ///< [s]
    double maximum_overlap = 0;              ///< [m]
    double greatest_pressure = 0;            ///< in the centre, by the law [Pa]
    std::optional<double> yield_pressure{};  ///< none: the contact never yields [Pa]
    std::optional<EnergyLedger> energy{};
    std::optional<HistoryMomentum> momentum{};  ///< of a rebound
    std::vector<TrajectoryPoint> trajectory{};
};

/// An impact on the model's curve e(v_in): its damping is that of the estimate, else eta(e) of the fit.
struct CurveImpact {
    double velocity = 0;          ///< v_in [m/s]
    double lower = 0, upper = 0;  ///< 95 % band of the velocity at this restitution; NaN: not known [m/s]
    double restitution = 0;       ///< [1]
    double damping = 0;           ///< [unit of the damping law]
    double contact_time = 0;      ///< [s]
    double dissipated = 0;        ///< share of the incident energy that damping takes [1]
    double adhesion = 0;  ///< share that breaking the contact takes, jumps of the surfaces included [1]
    double plastic = 0;   ///< share that yielding takes [1]
};
using ModelCurve = std::vector<CurveImpact>;

/// What the figures draw of one law beside its histories.
struct LawCurve {
    std::optional<double> start{};     ///< v_c, where the curve begins at e = 0 [m/s]
    ModelCurve impacts{};              ///< from just above e = 0 on; empty if there is no curve
    std::vector<History> histories{};  ///< at v_c, for as long as the others last, and of the falling branch
};

/// The histories of a sample.
struct SampleHistories {
    std::string name{};
    std::vector<ContactTimeAt> contact_times{};
    LawMap<std::vector<History>> laws{};
    LawMap<LawCurve> curves{};
};

/// Result of the histories stage, 8-histories.json.
using HistoriesResult = SampleResults<SampleHistories>;

}  // namespace ashimpact
