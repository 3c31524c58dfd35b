// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "materials/phase_catalogue.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/case/input_files.hpp"
#include "pipeline/case/unused_statements.hpp"

namespace ashimpact {

/// A case with the files it was read from.
struct LoadedCase {
    Case data;
    std::vector<InputFile> inputs;
    std::vector<SampleFinding> findings;
};

/// Reads and checks a case file and every file it names; the built-in case if no file is given.
/// @param allow_outside whether the case may name files outside of its folder
/// @throws InputError: file, JSON pointer or line, what is wrong, what is allowed
[[nodiscard]] LoadedCase load_case(const std::optional<std::string>& file, bool allow_outside = false);

/// Reads a case that conforms to the schema and checks what a schema cannot express. @p files reads the files
/// that it names.
[[nodiscard]] Case read_case(const View& document, const PhaseCatalogue& catalogue, InputFiles& files);

/// The laws of a case that names none; thornton-ning besides, if a sample has a yield pressure. Samples
/// without a Tabor parameter, cohesive stress or range of cohesion then take the usual_separation as range,
/// assumed.
[[nodiscard]] std::vector<Law> default_laws();

/// The phase sets the program carries, literature values first.
[[nodiscard]] PhaseCatalogue built_in_phases();

/// The built-in case of that file.
inline constexpr auto built_in_case = "cases/dong2013/case.json";

}  // namespace ashimpact
