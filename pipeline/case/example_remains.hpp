// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/case/input_files.hpp"

namespace ashimpact {

/// JSON pointers of what a case that began as the one of `ashimpact init` still has of it: the wall, the
/// camera and the particles of an invented laboratory. Empty for any other case, and for the example itself,
/// whose numbers are all invented. A case began as the example if it has its first comment or its camera.
/// @param text the file of the case, with comments
/// @param inputs the files that the case was read from
[[nodiscard]] std::vector<std::string> example_remains(const Json& document, std::string_view text,
                                                       const std::vector<InputFile>& inputs);

}  // namespace ashimpact
