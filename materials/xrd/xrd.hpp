// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/view.hpp"
#include "core/quantities/names.hpp"
#include "core/tables/number_marks.hpp"
#include "materials/composition.hpp"

namespace ashimpact {

/// Greatest length of an XRD result [byte]. A longer file is refused without reading the rest.
inline constexpr std::size_t longest_xrd_file = std::size_t{16} << 20;

/// Code of every finding on an XRD result.
inline constexpr std::string_view xrd_code = "composition";

/// Format of a file.
enum class XrdFormat { bgmn_lst, gsas2_lst, fullprof_sum, topas_out, table, json };

template <>
struct Names<XrdFormat> {
    static constexpr std::string_view kind = "format of XRD results";
    static constexpr std::array<std::string_view, 6> all{"BGMN/Profex .lst", "GSAS-II .lst", "FullProf .sum",
                                                         "TOPAS .out",       "table",        "JSON"};
};

/// One sample of a file: fractions, the amorphous part as far as it is stated, the file's own densities.
struct XrdSample {
    std::string name;
    Analysis analysis{};
    std::vector<Finding> warnings{};
};

struct XrdResult {
    XrdFormat format = XrdFormat::table;
    std::vector<XrdSample> samples;
    std::vector<Finding> warnings{};  ///< about the file as a whole
    std::string reading{};            ///< how a table was read, by TableReading
};

/// Reads an XRD result; its content shows the format: BGMN/Profex .lst, GSAS-II .lst, FullProf .sum, TOPAS
/// .out, a CSV or TSV table of fractions or of peak intensities with RIR values, or the project's JSON.
/// docs/materials.md describes them. A byte-order mark, CRLF and Latin-1 are accepted. Errors: InputError
/// "NAME: line N: problem; allowed: ..." (for JSON with its pointer behind the line) for anything that is
/// empty, binary, cut off, malformed, has a phase twice or more than 100 %.
///
/// A table may be a sheet of a spreadsheet (.xlsx, .ods): the one of that name, else the only one that holds
/// a table; places in messages are then `sheet "XRD", cell B7`.
[[nodiscard]] XrdResult read_xrd(std::string_view text, std::string_view name,
                                 const TableOptions& options = {});

/// The remark that @p data, "phases", of a file are taken for a sample of another name than the file states
/// for them; none where the file states none, or the same. @param named their name, else the stem of @p file
[[nodiscard]] std::optional<Finding> other_sample_finding(std::string_view code, std::string_view data,
                                                          const std::string& named, std::string_view file,
                                                          const std::string& sample);

/// Rescales a sample to which a known weight of a standard was added before the measurement: w_i = w_s
/// c_i/c_s in the mixture, divided by 1 - w_s in the sample; the rest is amorphous. The standard is taken out
/// of the phases. Source: Chung 1974a, J. Appl. Cryst. 7:519 (matrix flushing). `added_fraction` is the
/// weight of the standard over that of the mixture [1], `added_uncertainty` that of the weighing [1]. Errors:
/// InputError if the standard is not among the phases, has no fraction, or implies that more than 100 % of
/// the sample is crystalline.
[[nodiscard]] XrdSample with_internal_standard(const XrdSample& sample, std::string_view standard,
                                               double added_fraction,
                                               std::optional<double> added_uncertainty = {});

/// One phase of a powder pattern: the intensity of its strongest peak and its reference intensity ratio
/// I/I_corundum.
struct PeakIntensity {
    std::string name;
    double intensity = 0;                           ///< [any unit, the same for all]
    double reference_intensity_ratio = 0;           ///< RIR [1]; corundum is 1 by definition
    std::optional<double> intensity_uncertainty{};  ///< [unit of the intensity]
    std::optional<double> ratio_uncertainty{};      ///< [1]
};

/// Returns weight fractions of the crystalline part [1] by the adiabatic principle:
/// w_i = (I_i/RIR_i)/sum_j(I_j/RIR_j). Source: Chung 1974b, J. Appl. Cryst. 7:526 (Ref. 27 of Dong et al.
/// 2013). Validity: every crystalline phase is listed. Errors: InputError for intensities below zero, ratios
/// not above zero.
[[nodiscard]] std::vector<PhaseFraction> adiabatic_fractions(const std::vector<PeakIntensity>& peaks);

/// The composition of a sample in JSON. A case and the project's own XRD results write it in the same way,
/// which docs/case.md describes.
namespace xrd {

/// Marks the phases that are internal standards by the name of their sample: corundum of "fa1_spiked".
/// @return a doubt on a name that calls a standard what is none of the phases known as such: "FA1 + 10 % MgO"
std::optional<Finding> mark_standards(Analysis& analysis, const std::string& sample);

/// Reads the fractions: "weight_fractions" or "volume_fractions" (an object with a fraction under the name of
/// each phase), "phases" (a list of such fractions with names) or "peaks". The place of each phase is its
/// JSON pointer. Errors: InputError with the JSON pointer for a fraction outside 0 to 1, a phase that is
/// there twice, and fractions given in more than one way or in none.
[[nodiscard]] Analysis read_fractions_json(const View& node);

/// "60 %" for "60 wt%", where fractions are by weight. @throws InputError for "60 vol%" there
[[nodiscard]] std::string without_basis(const std::string& text, FractionBasis basis);

/// Completes fractions, from any source, by the keys beside them: "densities" of single phases,
/// "amorphous", "amorphous_phase" and "internal_standard". What is not there stays as it is in @p analysis.
/// Errors: InputError with the JSON pointer for a density of no phase, and an amorphous part that is stated
/// twice.
[[nodiscard]] Analysis completed_by_json(Analysis analysis, const View& node);

}  // namespace xrd

}  // namespace ashimpact
