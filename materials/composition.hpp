// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/finding.hpp"
#include "materials/phase_catalogue.hpp"

namespace ashimpact {

/// A fraction for messages, as "12.34 %", rounded to four decimals.
[[nodiscard]] std::string per_cent(double fraction);

enum class FractionBasis { weight, volume };

/// One line of an analysis, under the name the file uses.
struct PhaseFraction {
    std::string name;
    double fraction = 0;                           ///< [1], of the crystalline part or of the whole
    std::optional<double> standard_uncertainty{};  ///< [1]
    std::optional<double> density{};  ///< [kg/m3] the file's own x-ray density; wins over the catalogue
    std::string place{};              ///< where the file has it, "line 12"; for messages, may be empty
    bool is_standard = false;         ///< the file calls it an internal standard
    bool behind_total = false;        ///< it stands behind a total that it is not in
};

/// How the amorphous part is given. An analysis that does not state it is refused; it is never assumed.
struct AmorphousNotStated {};
struct AmorphousNone {};  ///< stated: there is none
struct AmorphousFraction {
    double value = 0;  ///< [1] of the whole
    std::optional<double> standard_uncertainty{};
    FractionBasis basis = FractionBasis::weight;
};
struct CrystallineTotal {
    double value = 0;  ///< [1] of the whole; the rest is amorphous
    std::optional<double> standard_uncertainty{};
};
/// The fractions times a scale are those of the whole sample; the rest is amorphous. An internal standard
/// gives the scale.
struct AmorphousRemainder {
    double scale = 1;  ///< [1]
    std::optional<double> standard_uncertainty{};
};
using Amorphous =
    std::variant<AmorphousNotStated, AmorphousNone, AmorphousFraction, CrystallineTotal, AmorphousRemainder>;

/// The largest gap by which rounded fractions may miss their sum [1]; six phases to 0.1 % miss it by 0.003.
inline constexpr double default_closure_tolerance = 0.005 * (1 + 1e-9);  // and the rounding of a sum

/// What is known of a sample. The phases may include the amorphous one; then `amorphous` must not be stated.
struct Analysis {
    std::vector<PhaseFraction> phases;
    FractionBasis basis = FractionBasis::weight;
    Amorphous amorphous = AmorphousNotStated{};
    std::string amorphous_phase = "glass";  ///< name under which the amorphous part is looked up
    double closure_tolerance = default_closure_tolerance;
    /// States the amorphous part. @throws InputError where it is stated already
    void state_amorphous(Amorphous stated);
    /// What states that the fractions are those of the crystalline part, "the heading"; empty: nothing does.
    std::string of_crystalline_part{};
    /// Rows without any cell but their name above others with amounts: "XRF:" may head these.
    std::vector<PlacedName> blank_rows{};
};

/// How the fractions of the whole follow from independent inputs; kept for the propagation of uncertainty.
struct FractionModel {
    enum class Kind {
        closed,     ///< f_i = c_i/sum c
        split,      ///< f_i = (1 - p) c_i/sum c, and the last, amorphous, is p
        remainder,  ///< f_i = p c_i, and the last, amorphous, is 1 - p sum c
    };
    Kind kind = Kind::closed;
    std::vector<double> amounts{};                       ///< c_i [1]
    std::vector<std::optional<double>> uncertainties{};  ///< of c_i [1]
    double parameter = 1;                                ///< p [1]
    std::optional<double> parameter_uncertainty{};       ///< [1]

    /// Returns the fractions of the whole [1], in the order of the components.
    [[nodiscard]] std::vector<double> fractions() const;
};

/// One phase of a sample.
struct Component {
    std::string name;            ///< as in the analysis
    Phase phase;                 ///< density replaced by the file's own where there is one
    double weight_fraction = 0;  ///< [1] of the whole
    double volume_fraction = 0;  ///< [1] of the whole
    std::size_t place = 0;       ///< in the analysis
};

/// A sample whose fractions add up to one.
struct Composition {
    /// In descending order of the names of the phases, so that no result depends on their order in a file;
    /// the amorphous part, if not in the analysis, is the last.
    std::vector<Component> components;
    FractionBasis basis = FractionBasis::weight;
    FractionModel model{};
    double density = 0;  ///< of the dense mixture [kg/m3]
    std::vector<Finding> notes{};

    /// The components in the order of the analysis, for tables.
    [[nodiscard]] std::vector<Component> listed() const;
};

/// How to state the amorphous part, for the message where nothing does.
inline constexpr const char* how_to_state_amorphous =
    "the amorphous weight fraction, the crystalline total, an internal standard, fractions of the whole "
    "sample, or the statement that there is none";

/// Resolves the phases, closes the fractions and converts them both ways.
/// Errors: InputError for unknown or repeated phases, negative fractions, more than 100 %, fractions that do
/// not close within the tolerance, an internal standard whose weight is not stated, and an amorphous part
/// that is stated twice, or that is missing, with
/// @p how_to_state it.
[[nodiscard]] Composition compose(const Analysis& analysis, const PhaseCatalogue& catalogue,
                                  const std::string& how_to_state = how_to_state_amorphous);

/// Returns volume fractions [1] from weight fractions and densities: v_i = (w_i/rho_i)/sum_j(w_j/rho_j).
[[nodiscard]] std::vector<double> volume_fractions(std::span<const double> weight_fractions,
                                                   std::span<const double> densities);

/// Returns weight fractions [1]: w_i = v_i rho_i/sum_j(v_j rho_j).
[[nodiscard]] std::vector<double> weight_fractions(std::span<const double> volume_fractions,
                                                   std::span<const double> densities);

/// Returns the density of a dense mixture [kg/m3]: sum v_i rho_i.
[[nodiscard]] double mixture_density(std::span<const double> volume_fractions,
                                     std::span<const double> densities);

}  // namespace ashimpact
