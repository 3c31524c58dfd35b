// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/glass/chemistry.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <regex>
#include <stdexcept>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr double oxygen_mass = 15.999e-3;

constexpr std::size_t longest_formula = 200;

/// Reads a formula by recursive descent: compounds between separators, groups in brackets, elements.
class FormulaReader {
  public:
    explicit FormulaReader(std::string_view formula) : whole_(formula), rest_(trimmed(formula)) {}

    std::vector<std::pair<std::string, double>> read() {
        if (rest_.empty() || rest_.size() > longest_formula) fail();
        while (true) {
            const double multiple = number().value_or(1);
            add(group(0), multiple);
            if (rest_.empty()) return std::move(atoms_);
            if (!skip_separator()) fail();
        }
    }

  private:
    using Atoms = std::vector<std::pair<std::string, double>>;

    [[noreturn]] void fail() const {
        throw InputError(in_quotes(whole_) + " is no chemical formula of known elements",
                         "a formula such as \"CaAl2Si2O8\" or \"3Al2O3.2SiO2\"");
    }

    void add(const Atoms& atoms, double multiple) {
        for (const auto& [element, count] : atoms) add_to(atoms_, element, count * multiple);
    }

    static void add_to(Atoms& atoms, const std::string& element, double count) {
        const auto known = std::ranges::find(atoms, element, &Atoms::value_type::first);
        if (known == atoms.end())
            atoms.emplace_back(element, count);
        else
            known->second += count;
    }

    /// Elements and brackets up to a separator, a closing bracket or the end.
    Atoms group(int depth) {
        constexpr int deepest = 10;
        if (depth > deepest) fail();
        Atoms atoms;
        while (!rest_.empty() && (rest_.front() == '(' || std::isupper(byte(0)) != 0)) {
            if (rest_.front() == '(') {
                rest_.remove_prefix(1);
                const Atoms inner = group(depth + 1);
                if (!rest_.starts_with(')')) fail();
                rest_.remove_prefix(1);
                const double count = subscript(true);
                for (const auto& [element, each] : inner) add_to(atoms, element, each * count);
                continue;
            }
            const std::string element = take_element();
            add_to(atoms, element, subscript(element == "O"));
        }
        if (atoms.empty()) fail();
        return atoms;
    }

    std::string take_element() {
        const std::size_t length = rest_.size() > 1 && std::islower(byte(1)) != 0 ? 2 : 1;
        std::string element(rest_.substr(0, length));
        const bool known = element == "O" || std::ranges::find(oxides(), std::string_view(element),
                                                               &OxideOfElement::element) != oxides().end();
        if (!known) fail();
        rest_.remove_prefix(length);
        return element;
    }

    /// The number behind an element or a bracket; 1 if there is none.
    double subscript(bool may_end_compound) {
        std::size_t digits = 0;
        while (digits < rest_.size() && is_digit(rest_[digits])) ++digits;
        if (digits == 0) return 1;
        std::size_t length = digits;
        if (rest_.size() > digits + 1 && rest_[digits] == '.' && is_digit(rest_[digits + 1])) {
            std::size_t end = digits + 1;
            while (end < rest_.size() && is_digit(rest_[end])) ++end;
            const bool formula_follows = end < rest_.size() && std::isupper(byte(end)) != 0;
            if (!may_end_compound || !formula_follows) length = end;
        }
        return take_number(length);
    }

    std::optional<double> number() {
        const auto length = std::min(rest_.find_first_not_of(".0123456789"), rest_.size());
        return length == 0 ? std::nullopt : std::optional(take_number(length));
    }

    double take_number(std::size_t length) {
        const std::optional<double> value = whole_decimal(rest_.substr(0, length));
        constexpr double most = 1e4;
        if (!value || !(*value > 0 && *value < most)) fail();
        rest_.remove_prefix(length);
        return *value;
    }

    bool skip_separator() {
        for (const std::string_view mark : {".", "*", "\u00b7", "\u2022", "\u22c5"})
            if (rest_.starts_with(mark)) {
                rest_.remove_prefix(mark.size());
                return true;
            }
        return false;
    }

    [[nodiscard]] int byte(std::size_t at) const { return static_cast<unsigned char>(rest_[at]); }

    std::string_view whole_;
    std::string_view rest_;
    Atoms atoms_{};
};

/// Atoms of its element in one formula unit of an oxide.
double cations_of(std::string_view formula, std::string_view element) {
    for (const auto& [each, count] : atoms_of(formula))
        if (each == element) return count;
    throw std::logic_error("an oxide without its element");
}

/// What is computed once of every oxide of the table.
struct OxideData {
    double molar_mass;  ///< [kg/mol]
    double cations;     ///< of its element in one formula unit
};

const std::vector<OxideData>& oxide_data() {
    static const std::vector<OxideData> data = [] {
        std::vector<OxideData> list;
        for (const OxideOfElement& each : oxides())
            list.push_back({molar_mass(each.formula), cations_of(each.formula, each.element)});
        return list;
    }();
    return data;
}

std::size_t index_of_element(std::string_view element) {
    const auto found = std::ranges::find(oxides(), element, &OxideOfElement::element);
    return static_cast<std::size_t>(found - oxides().begin());
}

double total_of(const OxideAmounts& amounts) {
    return std::accumulate(amounts.begin(), amounts.end(), 0.0);
}

OxideAmounts shares_of(OxideAmounts amounts) {
    const double total = total_of(amounts);
    if (total != 0)
        for (double& amount : amounts) amount /= total;
    return amounts;
}

/// The name without marks of a total: "Fe2O3(t)", "TFe2O3", "FeO*", "ΣFe2O3", "total Fe as Fe2O3", "S total".
std::string without_total(std::string_view name) {
    static const std::regex iron(
        "(?:sum|total|tot|gesamt|ges|t)?(?:(?:iron|eisen|feo?|fe2o3)(?:total|tot)?(?:as|als))?"
        "(feo|fe2o3)(?:total|tot|gesamt|ges|t)?");
    static const std::regex sulfur("(?:total|gesamt)s|s(?:total|tot|gesamt|ges)");
    constexpr std::size_t longest = 60;
    const std::string key = word_key(name);
    if (key.size() > longest) return key;
    std::smatch found;
    if (std::regex_match(key, found, iron)) return found[1];
    return std::regex_match(key, found, sulfur) ? "s" : key;
}

}  // namespace

const std::vector<OxideOfElement>& oxides() {
    static const std::vector<OxideOfElement> table{{"Si", 28.085e-3, "SiO2", ""},
                                                   {"Al", 26.982e-3, "Al2O3", ""},
                                                   {"Fe", 55.845e-3, "Fe2O3", "FeO Fe3O4"},
                                                   {"Ca", 40.078e-3, "CaO", ""},
                                                   {"Mg", 24.305e-3, "MgO", ""},
                                                   {"Na", 22.990e-3, "Na2O", ""},
                                                   {"K", 39.098e-3, "K2O", ""},
                                                   {"Ti", 47.867e-3, "TiO2", ""},
                                                   {"P", 30.974e-3, "P2O5", ""},
                                                   {"S", 32.06e-3, "SO3", "S SO2"},
                                                   {"Mn", 54.938e-3, "MnO", "Mn2O3 Mn3O4 MnO2"},
                                                   {"Sr", 87.62e-3, "SrO", ""},
                                                   {"Ba", 137.33e-3, "BaO", ""},
                                                   {"Zn", 65.38e-3, "ZnO", ""},
                                                   {"Cr", 51.996e-3, "Cr2O3", ""},
                                                   {"V", 50.942e-3, "V2O5", "V2O3"},
                                                   {"Zr", 91.224e-3, "ZrO2", ""},
                                                   {"Ni", 58.693e-3, "NiO", ""},
                                                   {"Cu", 63.546e-3, "CuO", "Cu2O"},
                                                   {"Pb", 207.2e-3, "PbO", ""},
                                                   {"Rb", 85.468e-3, "Rb2O", ""},
                                                   {"Li", 6.94e-3, "Li2O", ""},
                                                   {"B", 10.81e-3, "B2O3", ""},
                                                   {"Co", 58.933e-3, "CoO", "Co3O4"},
                                                   {"As", 74.922e-3, "As2O3", "As2O5"},
                                                   {"Y", 88.906e-3, "Y2O3", ""},
                                                   {"Nb", 92.906e-3, "Nb2O5", ""},
                                                   {"Ga", 69.723e-3, "Ga2O3", ""},
                                                   {"Ge", 72.630e-3, "GeO2", ""},
                                                   {"Mo", 95.95e-3, "MoO3", ""},
                                                   {"Sn", 118.71e-3, "SnO2", ""},
                                                   {"Sb", 121.76e-3, "Sb2O3", ""},
                                                   {"Ce", 140.12e-3, "CeO2", "Ce2O3"},
                                                   {"La", 138.91e-3, "La2O3", ""},
                                                   {"W", 183.84e-3, "WO3", ""},
                                                   {"Sc", 44.956e-3, "Sc2O3", ""},
                                                   {"Cl", 35.45e-3, "Cl", ""},
                                                   {"F", 18.998e-3, "F", ""},
                                                   {"C", 12.011e-3, "CO2", ""},
                                                   {"H", 1.008e-3, "H2O", ""}};
    return table;
}

OxideAmounts no_oxides() {
    return OxideAmounts(oxides().size(), 0.0);
}

bool is_gas(std::string_view formula) {
    return formula == "CO2" || formula == "H2O";
}

std::size_t oxide_index(std::string_view formula) {
    const auto found = std::ranges::find(oxides(), formula, &OxideOfElement::formula);
    if (found == oxides().end()) throw std::logic_error("no such oxide: " + std::string(formula));
    return static_cast<std::size_t>(found - oxides().begin());
}

std::vector<std::pair<std::string, double>> atoms_of(std::string_view formula) {
    return FormulaReader(formula).read();
}

double molar_mass(std::string_view formula) {
    double mass = 0;
    for (const auto& [element, count] : atoms_of(formula))
        mass += count * (element == "O" ? oxygen_mass : oxides()[index_of_element(element)].atomic_mass);
    return mass;
}

OxideAmounts oxides_of(std::string_view formula) {
    const double mass = molar_mass(formula);
    OxideAmounts amounts = no_oxides();
    for (const auto& [element, count] : atoms_of(formula)) {
        if (element == "O") continue;
        const std::size_t i = index_of_element(element);
        amounts[i] = count / oxide_data()[i].cations * oxide_data()[i].molar_mass / mass;
    }
    return amounts;
}

std::optional<NamedOxide> named_oxide(std::string_view name) {
    const std::string key = without_total(name);
    if (key.empty()) return std::nullopt;
    const bool is_total = key != word_key(name);
    for (std::size_t i = 0; i < oxides().size(); ++i) {
        const OxideOfElement& oxide = oxides()[i];
        if (word_key(oxide.formula) == key) return NamedOxide{i, 1, is_total};
        for (std::string_view rest = oxide.others; !rest.empty();) {
            const auto end = std::min(rest.find(' '), rest.size());
            const std::string_view other = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            if (word_key(other) != key) continue;
            return NamedOxide{i, oxides_of(other)[i], is_total};
        }
    }
    return std::nullopt;
}

std::vector<std::string> nearest_oxides(std::string_view name) {
    std::vector<std::string> formulas;
    for (const OxideOfElement& each : oxides()) formulas.emplace_back(each.formula);
    return nearest(name, formulas, 3);
}

OxideAmounts mole_fractions(const OxideAmounts& weight_fractions) {
    OxideAmounts amounts = weight_fractions;
    for (std::size_t i = 0; i < amounts.size(); ++i) amounts[i] /= oxide_data()[i].molar_mass;
    return shares_of(std::move(amounts));
}

OxideAmounts weight_fractions_of_moles(const OxideAmounts& mole_fractions) {
    OxideAmounts amounts = mole_fractions;
    for (std::size_t i = 0; i < amounts.size(); ++i) amounts[i] *= oxide_data()[i].molar_mass;
    return shares_of(std::move(amounts));
}

}  // namespace ashimpact
