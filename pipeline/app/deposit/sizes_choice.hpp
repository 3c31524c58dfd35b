// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/finding.hpp"
#include "core/tables/number_marks.hpp"
#include "pipeline/case/input_files.hpp"
#include "solver/deposition/particle_sizes.hpp"

namespace ashimpact {

/// The sizes of a command, --sizes.
struct SizesChoice {
    ParticleSizes sizes{};
    std::string words{};              ///< "Rosin-Rammler, 20 um, exponent 1.2, by mass"
    std::optional<InputFile> file{};  ///< of a table
    std::vector<Finding> notes{};
    std::string reading{};  ///< how a table was read, by TableReading
};

/// The sizes of a sieve table.
struct SieveResult {
    ParticleSizes sizes;
    std::vector<Finding> notes;
    std::string reading;
};

/// Forms of --sizes, for help and messages.
inline constexpr auto sizes_forms =
    "\"20 um\", \"rosin-rammler: 20 um, 1.2\", \"log-normal: 20 um, 1.8\" (by mass; with \", number\" by "
    "number), "
    "or the FILE of a sieve table";

/// Reads a distribution or the table of a file. Of Rosin-Rammler 63.2 % of the mass is finer than the size.
/// @throws InputError at --sizes or with file and line
[[nodiscard]] SizesChoice read_sizes(const std::string& spec, const TableOptions& options);

/// Reads a sieve table, CSV, TSV, .xlsx or .ods: sizes with the share that is finer ("passing") or coarser
/// ("residue"), or classes "from", "to" with their "share". Errors: InputError with the line.
[[nodiscard]] SieveResult read_sieve_table(std::string_view bytes, const TableOptions& options);

}  // namespace ashimpact
