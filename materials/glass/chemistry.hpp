// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quantities/quantity.hpp"

namespace ashimpact {

/// An element with the oxide by which chemical analyses report it.
struct OxideOfElement {
    std::string_view element;
    double atomic_mass;        ///< [kg/mol]; abridged standard atomic weight of IUPAC
    std::string_view formula;  ///< "Al2O3"; the element itself for chlorine and fluorine
    std::string_view others;   ///< further forms in which analyses list it, between blanks: "FeO Fe3O4"
};

/// Every element that is known here except oxygen; the usual oxides of an ash come first.
[[nodiscard]] const std::vector<OxideOfElement>& oxides();

/// Amounts of oxides, in the order of oxides(): weight fractions or amounts of substance.
using OxideAmounts = std::vector<double>;

/// All amounts zero.
[[nodiscard]] OxideAmounts no_oxides();

/// Whether an oxide is one of the gases of carbonates and hydroxides, CO2 or H2O: no glass contains them.
[[nodiscard]] bool is_gas(std::string_view formula);

/// Place in oxides() of the oxide of that formula, such as "Fe2O3".
/// @throws std::logic_error for a formula that is not in the table
[[nodiscard]] std::size_t oxide_index(std::string_view formula);

/// Elements of a formula with the number of their atoms, in the order in which they appear: "3Al2O3.2SiO2",
/// "CaSO4.2H2O", "Ca6Al2(SO4)3(OH)12.26H2O", "Al4.8Si1.2O9.6". A point behind the number of an O or of a
/// bracket separates compounds if a formula follows; any other point is a decimal point.
/// Errors: InputError for what is no formula, and for elements that are not in the table.
[[nodiscard]] std::vector<std::pair<std::string, double>> atoms_of(std::string_view formula);

/// Returns the molar mass of a formula [kg/mol]. Errors: as atoms_of().
[[nodiscard]] double molar_mass(std::string_view formula);

/// Returns the weight of each oxide per weight of a substance [1]. The sum differs from 1 where the oxidation
/// differs: magnetite, Fe3O4, gives 1.0346 Fe2O3. Errors: as atoms_of().
[[nodiscard]] OxideAmounts oxides_of(std::string_view formula);

/// An oxide as a file names it, and the weight of the one in the table per weight of it: 1.1113 for FeO.
struct NamedOxide {
    std::size_t index = 0;
    double factor = 1;
    bool is_total = false;  ///< a total of all iron, "Fe2O3(t)"
};

/// The oxide of a name such as "SiO2", "SIO2", "Fe2O3(t)", "FeO", "Mn3O4", or "S" for
/// sulfur; none for any other text.
[[nodiscard]] std::optional<NamedOxide> named_oxide(std::string_view name);

/// The oxides of the table whose formulas are nearest to a name, for messages.
[[nodiscard]] std::vector<std::string> nearest_oxides(std::string_view name);

/// One oxide of an analysis or of a glass.
struct OxideShare {
    std::string oxide;                             ///< formula in oxides()
    double fraction = 0;                           ///< by weight [1]
    std::optional<double> standard_uncertainty{};  ///< [1]
};

/// Returns the amounts of substance of oxides [1, sum 1] from weight fractions of any sum:
/// x_i = (w_i/M_i)/sum_j(w_j/M_j). Zero for all if every fraction is.
[[nodiscard]] OxideAmounts mole_fractions(const OxideAmounts& weight_fractions);

/// Returns weight fractions [1, sum 1] from amounts of substance, the inverse of mole_fractions().
[[nodiscard]] OxideAmounts weight_fractions_of_moles(const OxideAmounts& mole_fractions);

}  // namespace ashimpact
