// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/json/view.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/case/input_files.hpp"

namespace ashimpact {

/// The camera that velocities were read from. @throws InputError with the JSON pointer
[[nodiscard]] Camera read_camera(const View& node);

/// Measured impacts, from columns in the case or a file; @p camera serves impacts whose uncertainty neither
/// says. @throws InputError with the JSON pointer, or the file and line
[[nodiscard]] MeasuredRestitution read_measured(const View& node, InputFiles& files,
                                                const std::optional<View>& camera);

/// How measured impacts are fitted, and how uncertainties are propagated to v_c. Absent keys have their
/// defaults.
[[nodiscard]] FitChoices read_fit_choices(const std::optional<View>& node);
[[nodiscard]] UncertaintyChoices read_uncertainty_choices(const std::optional<View>& node);

}  // namespace ashimpact
