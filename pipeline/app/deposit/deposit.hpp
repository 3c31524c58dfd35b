// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/tables/number_marks.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/run/results/deposition.hpp"

namespace ashimpact {

/// What `deposit` has computed and the files it has written.
struct Deposition {
    DepositionResult result;
    std::vector<std::filesystem::path> files{};
};

/// The deposition of a run, --run, or of the options of an impact, written to the folder --output: artifact,
/// page and tables. Warns of what limits it. @param table how the file of --sizes is read
/// @throws InputError naming the option or the file; ConvergenceError
[[nodiscard]] Deposition write_deposition(const CommandOptions& options, const TableOptions& table);

}  // namespace ashimpact
