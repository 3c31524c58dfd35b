// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/json/view.hpp"
#include "core/tables/number_marks.hpp"
#include "materials/glass/balance.hpp"

namespace ashimpact {

/// One sample of a chemical analysis.
struct OxideSample {
    std::string name;
    OxideAnalysis analysis{};
    std::vector<Finding> warnings{};
};

struct OxideResult {
    std::vector<OxideSample> samples;
    std::vector<Finding> warnings{};  ///< about the file as a whole
    std::string reading{};            ///< how the table was read, by TableReading
};

/// Reads a chemical analysis by XRF or wet chemistry: a CSV or TSV table, or a sheet of a spreadsheet (.xlsx,
/// .ods), with one column or one row for each oxide. Amounts are per cent by weight, fractions or ppm, by the
/// headings or else by their sum. "<0.05" is half of it with a rectangular distribution; "<LOD", "n.d." and
/// "tr" are zero; empty cells and "-" are not determined. Iron as FeO, Fe2O3, both or a total, manganese and
/// sulfur in other forms are converted to the oxides of oxides(); a loss on ignition and a total are known.
/// Elements in ppm are traces: they are left out, with a warning. See docs/glass.md.
/// Errors: InputError "NAME: line N: problem; allowed: ..." for what is no such table, oxides that do not
/// exist or stand there twice, elements in per cent, amounts that are negative, in mol% or no numbers.
[[nodiscard]] OxideResult read_oxides(std::string_view text, std::string_view name,
                                      const TableOptions& options = {});

/// The sample of that name, or the only one of such a name as sample_key() compares them, else the only one
/// of the file. @throws InputError with the names that there are
[[nodiscard]] const OxideSample& oxide_sample(const OxideResult& result, const std::string& name,
                                              bool must_match);

/// The remark that oxides are taken for a sample of another name; none where the file names none, or the
/// same.
[[nodiscard]] std::optional<Finding> other_sample_finding(const OxideSample& oxides,
                                                          const std::string& sample);

/// Reads the oxides of a case: an object with a fraction under each formula and "LOI", or a list of such
/// objects with "oxide" and "weight_fraction". Errors: InputError with the JSON pointer.
[[nodiscard]] OxideAnalysis read_oxides_json(const View& node);

}  // namespace ashimpact
