// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.hpp"
#include "core/units/unit.hpp"

namespace ashimpact {

namespace {

struct Row {
    std::string_view symbols;  ///< separated by blanks; case matters
    std::string_view names;    ///< separated by blanks; in any case, with or without a plural ending
    double factor;
    std::array<double, 4> powers;  ///< of m, kg, s and others
};

constexpr std::array<double, 4> number{0, 0, 0, 0};
constexpr std::array<double, 4> length{1, 0, 0, 0};
constexpr std::array<double, 4> volume{3, 0, 0, 0};
constexpr std::array<double, 4> mass{0, 1, 0, 0};
constexpr std::array<double, 4> time{0, 0, 1, 0};
constexpr std::array<double, 4> velocity{1, 0, -1, 0};
constexpr std::array<double, 4> frequency{0, 0, -1, 0};
constexpr std::array<double, 4> force{1, 1, -2, 0};
constexpr std::array<double, 4> pressure{-1, 1, -2, 0};
constexpr std::array<double, 4> energy{2, 1, -2, 0};
constexpr std::array<double, 4> power{2, 1, -3, 0};
constexpr std::array<double, 4> other{0, 0, 0, 1};

/// Mechanical units of the field and of its neighbours, with the values of UDUNITS-2 2.2.28. Other units have
/// rows here so that messages can distinguish them from unknown ones, and so that no symbol is read as a
/// prefix and another unit: without "cd", a candela would be a hundredth of a day.
constexpr std::array rows{
    Row{"%", "percent", 1e-2, number},
    Row{"ppm", "", 1e-6, number},
    Row{"ppb", "", 1e-9, number},
    Row{"ppt", "", 1e-12, number},
    Row{"rad sr", "radian steradian", 1, number},
    Row{"m", "meter metre", 1, length},
    Row{"", "micron", 1e-6, length},
    Row{"", "angstrom", 1e-10, length},
    Row{"", "mil", 2.54e-5, length},
    Row{"in", "inch", 0.0254, length},
    Row{"ft", "foot feet", 0.3048, length},
    Row{"yd", "yard", 0.9144, length},
    Row{"mi", "mile", 1609.344, length},
    Row{"nmile", "nautical_mile", 1852, length},
    Row{"L l", "liter litre", 1e-3, volume},
    Row{"cc", "", 1e-6, volume},
    Row{"", "gallon", 3.785412e-3, volume},
    Row{"pt", "pint", 4.731765e-4, volume},
    Row{"kg", "kilogram", 1, mass},
    Row{"g", "gram", 1e-3, mass},
    Row{"t", "tonne metric_ton", 1000, mass},
    Row{"lb", "pound avoirdupois_pound", 0.45359237, mass},
    Row{"gr", "grain", 6.479891e-5, mass},
    Row{"", "carat", 2e-4, mass},
    Row{"", "slug", 14.5939, mass},
    Row{"", "ton short_ton", 907.18474, mass},
    Row{"", "long_ton", 1016.0469088, mass},
    Row{"", "amu", 1.6605402e-27, mass},
    Row{"s sec", "second", 1, time},
    Row{"min", "minute", 60, time},
    Row{"h hr", "hour", 3600, time},
    Row{"d", "day", 86400, time},
    Row{"", "week", 604800, time},
    Row{"yr", "year", 31556925.9747, time},
    Row{"kt kts", "knot", 1852.0 / 3600, velocity},
    Row{"Hz", "hertz", 1, frequency},
    Row{"rpm", "", 3.14159265358979323846 / 30, frequency},
    Row{"St", "stokes", 1e-4, {2, 0, -1, 0}},
    Row{"", "gal", 1e-2, {1, 0, -2, 0}},
    Row{"N", "newton", 1, force},
    Row{"dyn", "dyne", 1e-5, force},
    Row{"gf", "gram_force force_gram pond", 9.80665e-3, force},
    Row{"kgf", "kilogram_force force_kilogram", 9.80665, force},
    Row{"lbf", "pound_force force_pound", 4.4482216152605, force},
    Row{"ozf", "ounce_force force_ounce", 0.2780139, force},
    Row{"", "poundal", 0.138255, force},
    Row{"", "kip", 4448.2216152605, force},
    Row{"Pa", "pascal", 1, pressure},
    Row{"", "bar", 1e5, pressure},
    Row{"", "barye barie", 0.1, pressure},
    Row{"atm", "atmosphere standard_atmosphere", 101325, pressure},
    Row{"at", "technical_atmosphere", 98066.5, pressure},
    Row{"mmHg mm_Hg mmhg mm_hg", "torr", 133.322387415, pressure},
    Row{"cmHg cm_Hg", "", 1333.22387415, pressure},
    Row{"inHg in_Hg", "", 3386.38864034, pressure},
    Row{"cmH2O cm_H2O", "", 98.0665, pressure},
    Row{"psi", "", 6894.757293168361, pressure},
    Row{"ksi", "", 6894757.293168361, pressure},
    Row{"J", "joule", 1, energy},
    Row{"", "erg", 1e-7, energy},
    Row{"eV", "electronvolt electron_volt", 1.60217733e-19, energy},
    Row{"cal", "calorie", 4.1868, energy},
    Row{"", "thermochemical_calorie", 4.184, energy},
    Row{"", "btu", 1055.05585262, energy},
    Row{"Wh", "watthour", 3600, energy},
    Row{"W VA", "watt voltampere", 1, power},
    Row{"hp", "horsepower", 745.6999, power},
    Row{"P", "poise", 0.1, {-1, 1, -1, 0}},
    Row{"K degC degF degK degR", "kelvin celsius fahrenheit degree_C degree_F", 1, other},
    Row{"A V C F H T S", "ampere volt coulomb farad henry tesla ohm siemens weber gauss", 1, other},
    Row{"Wb Bq Gy Sv kat", "becquerel gray sievert katal", 1, other},
    Row{"mol cd lm lx ph nt", "mole candela lumen lux phot nit", 1, other},
};

struct Prefix {
    std::string_view symbol;
    std::string_view name;
    double factor;
};
constexpr std::array prefixes{
    Prefix{"Y", "yotta", 1e24}, Prefix{"Z", "zetta", 1e21},  Prefix{"E", "exa", 1e18},
    Prefix{"P", "peta", 1e15},  Prefix{"T", "tera", 1e12},   Prefix{"G", "giga", 1e9},
    Prefix{"M", "mega", 1e6},   Prefix{"k", "kilo", 1e3},    Prefix{"h", "hecto", 1e2},
    Prefix{"da", "deka", 1e1},  Prefix{"da", "deca", 1e1},   Prefix{"d", "deci", 1e-1},
    Prefix{"c", "centi", 1e-2}, Prefix{"m", "milli", 1e-3},  Prefix{"u", "micro", 1e-6},
    Prefix{"n", "nano", 1e-9},  Prefix{"p", "pico", 1e-12},  Prefix{"f", "femto", 1e-15},
    Prefix{"a", "atto", 1e-18}, Prefix{"z", "zepto", 1e-21}, Prefix{"y", "yocto", 1e-24},
};

bool holds(std::string_view words, std::string_view word) {
    if (word.empty()) return false;
    for (auto at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
    }
    return false;
}

/// The row of a symbol or a name without prefix, null if there is none.
const Row* row_of(std::string_view text) {
    const std::string name = lower_case(text);
    const auto is_name_of = [&](const Row& row, std::string_view ending) {
        return name.ends_with(ending) &&
               holds(row.names, std::string_view(name).substr(0, name.size() - ending.size()));
    };
    for (const Row& row : rows)
        if (holds(row.symbols, text) || is_name_of(row, "") || is_name_of(row, "s") || is_name_of(row, "es"))
            return &row;
    return nullptr;
}

}  // namespace

std::optional<Unit> unit_named(std::string_view name) {
    if (const Row* row = row_of(name)) return Unit{row->factor, row->powers};
    if (name.ends_with('%')) return std::nullopt;
    const std::string lower = lower_case(name);
    for (const Prefix& prefix : prefixes)
        for (const bool by_name : {true, false}) {
            const std::string_view word = by_name ? prefix.name : prefix.symbol;
            if (!std::string_view(by_name ? std::string_view(lower) : name).starts_with(word)) continue;
            if (const Row* row = row_of(name.substr(word.size())))
                return Unit{prefix.factor * row->factor, row->powers};
        }
    return std::nullopt;
}

}  // namespace ashimpact
