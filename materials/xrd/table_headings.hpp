// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantities/names.hpp"
#include "core/tables/table_texts.hpp"
#include "core/tables/vocabulary.hpp"

namespace ashimpact::xrd {

/// What a column of a table contains.
enum class Role {
    other,
    sample,
    phase,
    weight,  ///< fraction by weight
    volume,  ///< fraction by volume
    uncertainty,
    density,
    intensity,
    ratio,  ///< reference intensity ratio
    ratio_uncertainty,
    standard,  ///< known weight fraction of an added internal standard
    measure,   ///< neither a fraction nor the name of a sample: "FWHM", "counts", "Mol-%"
};

/// What a row of a table of fractions contains.
enum class RowMeaning { phase, total, crystalline_total };

/// What stands behind the name of a phase: "Corundum (internal standard)", "Lime (not detected)".
enum class PhaseMark { none, standard, not_detected, traces };

/// Whether the numbers under a heading are per cent or fractions.
enum class Scale { not_stated, per_cent, fraction, per_mille, ppm };

/// What the unit of a heading states of the numbers under it.
enum class HeadingUnit {
    none,      ///< there is no unit
    fraction,  ///< "%", "1": of weight or volume
    weight,    ///< "wt%", "ppm"
    volume,    ///< "vol%"
    other,     ///< "Mol-%", "counts", "mg/g"
};

/// The parts of a heading: "Weight [wt.%]" is a weight in per cent.
struct Heading {
    std::string text;  ///< without unit and coverage
    std::string unit;  ///< without its brackets; may be empty
    HeadingUnit states = HeadingUnit::none;
    Role role = Role::other;
    Scale scale = Scale::not_stated;
    bool of_crystalline = false;  ///< "wt% (crystalline)": fractions of the crystalline part
    std::string written{};        ///< the whole heading as in the file
    StatedCoverage coverage{};    ///< of the uncertainties under it
    bool sums_up = false;         ///< a column "Mittelwert" beside those of samples, or its uncertainties
};

[[nodiscard]] Heading read_heading(std::string_view text);

/// The same behind a column of that name, whose uncertainties "FA1 2s" and "u(FA1)" are.
/// @param name empty: none
[[nodiscard]] Heading read_heading_beside(std::string_view text, std::string_view name);

/// What the row of a name contains: a total of all or of the crystalline phases, else a phase.
[[nodiscard]] RowMeaning meaning_of_row(std::string_view name);

/// Signs of footnotes behind the names of phases; "Corundum**" has its longest one.
inline constexpr std::array<std::string_view, 8> footnote_signs{"***",    "**",     "*",      "\u00b9",
                                                                "\u00b2", "\u00b3", "\u2020", "\u2021"};

/// A phase as a table names it, without its mark.
struct MarkedPhase {
    std::string name;
    PhaseMark mark = PhaseMark::none;
};
[[nodiscard]] MarkedPhase read_phase_name(std::string_view text);

/// Whether a column stands beside those of the phases or samples and is none of them: "Rwp", "density".
[[nodiscard]] bool stands_beside(const Heading& heading);

/// Role of a column by its heading alone: "wt%" is a weight, "esd" an uncertainty.
[[nodiscard]] Role role_of_text(std::string_view text);

/// Whether uncertainties under a heading are per cent of the whole or of the value: "error [%]", "Fehler in
/// Prozent", unlike "esd [wt%]".
[[nodiscard]] bool may_be_relative(const Heading& heading);

/// Whether a heading without the unit of a fraction names moles, volumes or intensities: "Molenbruch [%]".
[[nodiscard]] bool names_other_basis(const Heading& heading);

/// What a text states as the unit of fractions.
[[nodiscard]] HeadingUnit unit_of(std::string_view text);

/// Whether a text names the loss on ignition: "LOI", "Glühverlust bei 950 °C". Below 700 °C carbonates keep
/// their CO2: that is another quantity, which counts at any temperature.
[[nodiscard]] bool names_loss(std::string_view text, bool at_any_temperature = false);

/// The cell "12.3 wt%" as "12.3 %", if it is in that kind of fractions.
[[nodiscard]] std::string without_fraction_unit(const std::string& cell, HeadingUnit kind);

/// Whether a text holds "%" or a word for it.
[[nodiscard]] bool holds_per_cent(std::string_view text);

/// Refuses a cell that states another unit than that of the amounts beside it: "ppm", "% rel.".
/// @param column that holds it, for the message @throws InputError
void refuse_other_unit(std::string_view cell, const std::string& column, Scale amounts, std::size_t line,
                       std::size_t place);

/// Refuses a text beside a table that states a unit of fractions behind no number, "values in g/kg", and none
/// of those of the amounts. @throws InputError at its line
void require_scale(const std::vector<TextBeside>& texts, const std::set<Scale>& amounts);

/// A heading that names an uncertainty and whose it is: "Quartz esd", "u(FA1)", "Unsicherheit FA1", "esd".
struct UncertaintyName {
    bool is_uncertainty = false;  ///< not certain of "u 3", which may be the name of a sample
    std::string of{};             ///< empty: of the column before
};
[[nodiscard]] UncertaintyName uncertainty_name(std::string_view text);

/// Whether a column of uncertainties without a name or unit of amounts is that of the column before it, from
/// which no amount is read: of "Biso" or "counts", but not of texts, detection limits and counts of samples.
/// @param holds_numbers whether the column before does
[[nodiscard]] bool is_uncertainty_of_unused(const Heading& heading, const Heading& before,
                                            bool holds_numbers);

/// Materials that texts beside a table or names of samples call internal standards, or added to a sample:
/// "spiked with 10 % Korund", "FA1 with corundum"; all such materials for "FA1 spiked".
class StandardsInTexts {
  public:
    void take(const TextBeside& text);
    /// The same for a text that counts for the materials which it names alone.
    void take_named(const TextBeside& text);
    /// Whether a phase is one of these materials.
    [[nodiscard]] bool hold(std::string_view phase) const;
    /// Whether any text called something a standard, known or not.
    [[nodiscard]] bool any() const { return any_ || !materials_.empty(); }

  private:
    std::set<std::string_view> materials_{};
    bool any_ = false;
};

}  // namespace ashimpact::xrd

template <>
struct ashimpact::Names<ashimpact::xrd::Role> {
    static constexpr std::string_view kind = "column";
    static constexpr std::array<std::string_view, 12> all{
        "other",       "sample",  "phase",     "weight", "volume",
        "uncertainty", "density", "intensity", "ratio",  "ratio_uncertainty",
        "standard",    "measure"};
};

template <>
struct ashimpact::Names<ashimpact::xrd::RowMeaning> {
    static constexpr std::string_view kind = "row";
    static constexpr std::array<std::string_view, 3> all{"phase", "total", "crystalline_total"};
};

template <>
struct ashimpact::Names<ashimpact::xrd::PhaseMark> {
    static constexpr std::string_view kind = "mark of a phase";
    static constexpr std::array<std::string_view, 4> all{"none", "standard", "not_detected", "traces"};
};
