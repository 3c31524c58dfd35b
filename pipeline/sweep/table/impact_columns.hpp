#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/batch/method.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

/// Many impacts, one entry each [SI].
struct ImpactColumns {
    std::vector<double> mass;
    std::vector<double> effective_radius;
    std::vector<double> contact_modulus;
    std::vector<double> work_of_adhesion;
    std::vector<double> yield_pressure;
    std::vector<double> damping;
    std::vector<double> velocity;
    std::vector<std::pair<std::string_view, std::vector<double>>> parameters;  ///< of contact laws, by name
};

/// What is the same for all of them.
struct ContactModel {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
};

/// Which results are wanted beside the restitution, others are left empty; and how they are to be had.
struct WantedResults {
    bool contact_time = false;
    bool maximum_overlap = false;
    BatchMethod method = BatchMethod::integration;
};

/// An impact that did not converge.
struct FailedSolution {
    std::uint64_t place;  ///< among the impacts
    std::string reason;
    std::string command;  ///< that computes this impact alone
};

/// What the impacts did, one entry each; not a number where an impact did not converge.
struct ResultColumns {
    std::vector<double> restitution;      ///< 0 for a capture
    std::vector<double> contact_time;     ///< not a number for a capture [s]
    std::vector<double> maximum_overlap;  ///< [m]
    std::vector<FailedSolution> failed{};
};

/// Solves many impacts. The result of an impact may not depend on the others beside it.
using ImpactSolver =
    std::function<ResultColumns(const ContactModel&, const ImpactColumns&, const WantedResults&)>;

/// The batch solver, on the calling thread. Impacts that do not converge are listed. @throws InputError
/// naming what a variable may not be
[[nodiscard]] ResultColumns solve_in_batch(const ContactModel& model, const ImpactColumns& impacts,
                                           const WantedResults& wanted);

}  // namespace ashimpact
