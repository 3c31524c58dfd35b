// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pipeline/present/export/subject.hpp"

namespace ashimpact {

/// Which part of a run is exported.
struct RunChoice {
    std::string folder;  ///< of the artifacts
    std::string sample;
    std::string law;               ///< empty: the first of the run's
    bool follow_velocity = false;  ///< damping from the fit eta(e) along v_in instead of the critical one
};

/// A sample of a run with its contact (2-contact.json), its critical damping (7-critical-velocity.json or
/// 6-fit.json) or its fit eta(e) over the rising branch (6-fit.json, 5-damping.json). Sizes: its own alone.
/// @throws InputError naming the file
[[nodiscard]] ExportSubject subject_of_run(const RunChoice& choice);

}  // namespace ashimpact
