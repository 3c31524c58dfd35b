// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/text_lines.hpp"
#include "materials/xrd/xrd.hpp"

/// One reader for each format, chosen by read_xrd(). Errors: InputError at "line N" (JSON: at the pointer).
namespace ashimpact::xrd {

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
[[nodiscard]] XrdResult read_table(const TextLines& file);

/// The project's JSON.
[[nodiscard]] bool looks_like_json(const TextLines& file);
[[nodiscard]] XrdResult read_json(const TextLines& file);

/// The formats that read_xrd() names if it recognises none.
inline constexpr const char* known_formats =
    "a BGMN/Profex .lst, a GSAS-II .lst, a FullProf .sum, a TOPAS .out, a table with a header as CSV, TSV, "
    ".xlsx "
    "or .ods, or the project's JSON";

}  // namespace ashimpact::xrd
