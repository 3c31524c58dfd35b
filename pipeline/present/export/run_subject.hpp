// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/present/export/subject.hpp"

namespace ashimpact {

/// Which part of a run is exported.
struct RunChoice {
    std::string folder;                  ///< of the artifacts
    std::vector<std::string> samples{};  ///< none: all of the run
    std::string law{};                   ///< empty: the one that the run reports
};

/// Samples of a run, each a known size: its contact (2-contact.json) and its damping along the measured or
/// reconstructed impacts (6-fit.json, 5-damping.json), which begins at the critical damping of the headline
/// (7-critical-velocity.json). The range is that of their sizes.
/// @throws InputError naming the file; for samples of one diameter, and for a critical velocity that the
/// measured rebounds contradict
[[nodiscard]] ExportSubject subject_of_run(const RunChoice& choice);

}  // namespace ashimpact
