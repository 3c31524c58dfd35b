// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "solver/batch/columns.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

/// Many impacts of one law, one damping law and one detachment.
struct ImpactBatch {
    Law law;
    Detachment detachment;
    DampingLaw damping_law;
    ContactColumns contact;
    Column damping;   ///< coefficient of the damping law [unit of the law]
    Column velocity;  ///< v_in > 0 [m/s]
};

struct BatchOptions {
    int threads = 1;            ///< 0: one for each core
    bool turning_point = true;  ///< also compute approach time and greatest overlap, by a step of its own
                                ///< from beside the turn. The other results are the same bits without them
    bool contact_time = true;   ///< also compute contact times, which takes as long again where a table has
                                ///< the impact. The other results are the same bits without them
    BatchMethod method = BatchMethod::integration;
    bool keep_failures = false;  ///< impacts that do not converge are listed; otherwise the first one throws
};

/// An impact of a batch that did not converge.
struct FailedImpact {
    std::int64_t place;  ///< in the batch
    std::string reason;
};

/// Results of the impacts. NaN stands for the contact time of a capture, for the approach time of an approach
/// that never turns, and for what the options leave out.
struct ImpactBatchResult {
    Eigen::Array<Outcome, Eigen::Dynamic, 1> outcome{};
    Eigen::ArrayXd restitution{};        ///< e_n, 0 for a capture [1]
    Eigen::ArrayXd contact_time{};       ///< first touch to detachment [s]
    Eigen::ArrayXd approach_time{};      ///< first touch to greatest overlap [s]
    Eigen::ArrayXd maximum_overlap{};    ///< greatest overlap, or its supremum where it never turns [m]
    std::vector<FailedImpact> failed{};  ///< by place; all their numbers are NaN, and they count as captures
    /// How many were left to solve_impact(): too near capture for double precision, or plastic.
    std::int64_t scalar = 0;
};

/// Where the results of a batch go: columns of as many values as it has impacts, and none where a result is
/// of no interest. What is written there is what ImpactBatchResult holds.
struct BatchOutputs {
    Outcome* outcome = nullptr;
    double* restitution = nullptr;      ///< [1]
    double* contact_time = nullptr;     ///< [s]
    double* approach_time = nullptr;    ///< [s]
    double* maximum_overlap = nullptr;  ///< [m]
};

/// Results of a batch that are no columns, as in ImpactBatchResult.
struct BatchReport {
    std::vector<FailedImpact> failed{};
    std::int64_t scalar = 0;
};

/// Solves many impacts, several in each instruction, to |d(e^2)| <= 1e-12 (1 + |U_min|/(m v^2/2)) of
/// solve_impact().
///
/// No bit of a result depends on the other impacts, on their number or order, or on the number of threads.
/// Instruction sets differ within the bound above.
/// @throws InputError for inadmissible input, naming the first impact it concerns; ConvergenceError unless
/// failures are kept
[[nodiscard]] ImpactBatchResult solve_impacts(const ImpactBatch& batch, const BatchOptions& options = {});

/// As above, into an existing result. Columns of the right length are reused without allocation.
void solve_impacts(const ImpactBatch& batch, ImpactBatchResult& result, const BatchOptions& options = {});

/// As above, to columns of the caller: nothing is copied, and a null column is not written.
BatchReport solve_impacts(const ImpactBatch& batch, const BatchOutputs& outputs, const BatchOptions& options);

/// The columns of impacts that have law, detachment, damping law and law parameters in common.
class ImpactList {
  public:
    /// @param impacts at least one; what they have in common is taken from the first
    explicit ImpactList(const std::vector<Impact>& impacts);

    /// It refers to these columns.
    [[nodiscard]] ImpactBatch batch() const;

  private:
    Impact first_;
    Eigen::ArrayXd mass_, radius_, modulus_, adhesion_, pressure_, damping_, velocity_;
};

}  // namespace ashimpact
