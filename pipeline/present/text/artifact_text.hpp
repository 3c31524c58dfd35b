// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/document.hpp"
#include "pipeline/present/text/result_text.hpp"

namespace ashimpact {

/// What is shown of an artifact.
struct ArtifactView {
    ResultView result{};
    bool provenance = false;  ///< inputs, options, citations too
};

/// An artifact for a reader: its result, what it warns about, and where it comes from.
[[nodiscard]] std::string artifact_text(const Json& artifact, const ArtifactView& view = {});

}  // namespace ashimpact
