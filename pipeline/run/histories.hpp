// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/run/stage.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// A contact time at a velocity that something was published for.
struct ContactTimeAt {
    Law law;
    double velocity;      ///< [m/s]
    double contact_time;  ///< [s]
};

/// The entry of a sample in 8-histories.json, as later stages read it.
struct SampleHistories {
    std::string name;
    std::vector<ContactTimeAt> contact_times;
};

/// Overlap against time just above the critical velocity and in the middle of the rising branch, with the
/// momentum balance of each; Dong et al. 2013, section 4.4, Eqs. 35-45, Figure 9.
[[nodiscard]] StageOutput histories_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleHistories> read_histories(const View& result);

}  // namespace ashimpact
