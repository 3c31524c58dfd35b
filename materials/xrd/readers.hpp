// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/quantity.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/text_lines.hpp"
#include "materials/xrd/xrd.hpp"

/// One reader for each format, chosen by read_xrd(). Errors: InputError at "line N" (JSON: at the pointer).
namespace ashimpact::xrd {

/// The name of a file without its folders and its ending.
[[nodiscard]] std::string file_stem(std::string_view name);

/// Divides fractions and their uncertainties by the total of the fractions, so that they add up to one.
void normalise(std::vector<PhaseFraction>& phases, double total);

/// A phase as the file of a refinement program lists it.
struct ListedPhase {
    std::string name;
    std::size_t line = 0;
    std::optional<PrintedNumber> amount{};   ///< not negative, in any unit that is the same for all
    std::optional<PrintedNumber> density{};  ///< [g/cm3]
};

/// Gives a phase the density that a program printed, with a finding on an uncertainty, which is not used.
void set_density(PhaseFraction& phase, const PrintedNumber& density, std::vector<Finding>& findings);

/// Turns amounts into the fractions of a sample. A phase without an amount is left out, with a warning.
/// @param amount what the amounts are, for messages: "weight"
/// @param needed what the file needs if all amounts are zero: "GEWICHT above zero", at @p line
/// @return the total of the amounts
/// @throws InputError for a phase that is listed twice, and if all amounts are zero
double add_fractions(XrdSample& sample, const std::vector<ListedPhase>& phases, const std::string& amount,
                     const std::string& needed, std::size_t line);

/// BGMN and Profex list files: GEWICHT of each phase over their sum, XrayDensity, checked against the goals.
[[nodiscard]] bool looks_like_bgmn(const TextLines& file);
[[nodiscard]] XrdResult read_bgmn(const TextLines& file);

/// GSAS-II list files: the weight fractions of each histogram.
[[nodiscard]] bool looks_like_gsas2(const TextLines& file);
[[nodiscard]] XrdResult read_gsas2(const TextLines& file);

/// FullProf summaries (.sum, .out): Fract(%) of each phase, one sample a pattern.
[[nodiscard]] bool looks_like_fullprof(const TextLines& file);
[[nodiscard]] XrdResult read_fullprof(const TextLines& file);

/// TOPAS files (.out, .inp): weight_percent, or the third argument of MVW, of each phase; the amorphous part
/// by weight_percent_amorphous or by a spiked phase. One sample a pattern (xdd).
[[nodiscard]] bool looks_like_topas(const TextLines& file);
[[nodiscard]] XrdResult read_topas(const TextLines& file);

/// Tables of fractions or of peak intensities, separated by comma, semicolon or tab.
[[nodiscard]] bool looks_like_table(const TextLines& file);
[[nodiscard]] XrdResult read_table(const TextLines& file, std::optional<DecimalMark> decimal);

/// The project's JSON.
[[nodiscard]] bool looks_like_json(const TextLines& file);
[[nodiscard]] XrdResult read_json(const TextLines& file);

/// The formats that read_xrd() names if it recognises none.
inline constexpr const char* known_formats =
    "a BGMN/Profex .lst, a GSAS-II .lst, a FullProf .sum, a TOPAS .out, a table with a header as CSV, TSV, "
    ".xlsx or .ods, or the project's JSON";

}  // namespace ashimpact::xrd
