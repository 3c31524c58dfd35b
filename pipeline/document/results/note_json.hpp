// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/json/view.hpp"
#include "pipeline/run/results/note.hpp"

namespace ashimpact {

/// {"code", "severity", "stage", "sample", "law", "text"}.
[[nodiscard]] Json to_json(const Note& note);

/// The notes of an artifact; of one without "notes" its warnings, as remarks of code "warning".
[[nodiscard]] std::vector<Note> read_notes(const View& artifact);

}  // namespace ashimpact
