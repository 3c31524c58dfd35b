// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/files/file.hpp"
#include "pipeline/present/report/drawing/figure.hpp"

namespace ashimpact::report {

/// Kinds of figure files, by their endings.
enum class FigureFormat { svg, pdf, png };

/// The format of a file name's ending. @throws InputError naming the allowed ones
[[nodiscard]] FigureFormat format_of(const std::filesystem::path& file);

/// Refuses a format that needs rsvg-convert where that program is missing. @throws InputError saying how to
/// get it
void require_converter(FigureFormat format);

/// The bytes of a figure in a format: SVG by us; PDF (vector, fonts embedded) and PNG (600 dots an inch) by
/// rsvg-convert of librsvg. The same figure gives the same bytes with the same version of that program.
/// @throws InputError where it is missing or fails
[[nodiscard]] std::string figure_bytes(const Figure& figure, Width width, FigureFormat format);

}  // namespace ashimpact::report
