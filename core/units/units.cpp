// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

struct Row {
    std::string_view symbols;  ///< separated by blanks; case matters
    std::string_view names;    ///< separated by blanks; in any case, with or without a plural ending
    double factor;
    std::array<double, 4> powers;  ///< as of Unit
};

/// Powers of m, kg, s and, as one, of all units that are not mechanical.
namespace of {
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
}  // namespace of

/// Mechanical units of the field and of its neighbours, with the values of UDUNITS-2 2.2.28. Other units are
/// listed so that messages can distinguish them from unknown ones, and so that none is taken for a prefix and
/// another unit: without a row for the candela, "cd" would be a hundredth of a day.
constexpr std::array rows{
    Row{"%", "percent", 1e-2, of::number},
    Row{"ppm", "", 1e-6, of::number},
    Row{"ppb", "", 1e-9, of::number},
    Row{"ppt", "", 1e-12, of::number},
    Row{"rad sr", "radian steradian", 1, of::number},
    Row{"m", "meter metre", 1, of::length},
    Row{"", "micron", 1e-6, of::length},
    Row{"", "angstrom", 1e-10, of::length},
    Row{"", "mil", 2.54e-5, of::length},
    Row{"in", "inch", 0.0254, of::length},
    Row{"ft", "foot feet", 0.3048, of::length},
    Row{"yd", "yard", 0.9144, of::length},
    Row{"mi", "mile", 1609.344, of::length},
    Row{"nmile", "nautical_mile", 1852, of::length},
    Row{"L l", "liter litre", 1e-3, of::volume},
    Row{"cc", "", 1e-6, of::volume},
    Row{"", "gallon", 3.785412e-3, of::volume},
    Row{"pt", "pint", 4.731765e-4, of::volume},
    Row{"kg Kg", "kilogram", 1, of::mass},
    Row{"g", "gram", 1e-3, of::mass},
    Row{"t", "tonne metric_ton", 1000, of::mass},
    Row{"lb", "pound avoirdupois_pound", 0.45359237, of::mass},
    Row{"", "grain", 6.479891e-5, of::mass},
    Row{"", "carat", 2e-4, of::mass},
    Row{"", "slug", 14.5939, of::mass},
    Row{"", "ton short_ton", 907.18474, of::mass},
    Row{"", "long_ton", 1016.0469088, of::mass},
    Row{"", "amu", 1.6605402e-27, of::mass},
    Row{"s sec", "second", 1, of::time},
    Row{"min", "minute", 60, of::time},
    Row{"h hr", "hour", 3600, of::time},
    Row{"d", "day", 86400, of::time},
    Row{"", "week", 604800, of::time},
    Row{"yr", "year", 31556925.9747, of::time},
    Row{"kt kts", "knot", 1852.0 / 3600, of::velocity},
    Row{"Hz", "hertz", 1, of::frequency},
    Row{"rpm", "", 3.14159265358979323846 / 30, of::frequency},
    Row{"St", "stokes", 1e-4, {2, 0, -1, 0}},
    Row{"", "gal", 1e-2, {1, 0, -2, 0}},
    Row{"N", "newton", 1, of::force},
    Row{"dyn", "dyne", 1e-5, of::force},
    Row{"gf", "gram_force force_gram pond", 9.80665e-3, of::force},
    Row{"kgf", "kilogram_force force_kilogram", 9.80665, of::force},
    Row{"lbf", "pound_force force_pound", 4.4482216152605, of::force},
    Row{"ozf", "ounce_force force_ounce", 0.2780139, of::force},
    Row{"", "poundal", 0.138255, of::force},
    Row{"", "kip", 4448.2216152605, of::force},
    Row{"Pa", "pascal", 1, of::pressure},
    Row{"", "bar", 1e5, of::pressure},
    Row{"", "barye barie", 0.1, of::pressure},
    Row{"atm", "atmosphere standard_atmosphere", 101325, of::pressure},
    Row{"at", "technical_atmosphere", 98066.5, of::pressure},
    Row{"mmHg mm_Hg mmhg mm_hg", "torr", 133.322387415, of::pressure},
    Row{"cmHg cm_Hg", "", 1333.22387415, of::pressure},
    Row{"inHg in_Hg", "", 3386.38864034, of::pressure},
    Row{"cmH2O cm_H2O", "", 98.0665, of::pressure},
    Row{"psi", "", 6894.757293168361, of::pressure},
    Row{"ksi", "", 6894757.293168361, of::pressure},
    Row{"J", "joule", 1, of::energy},
    Row{"", "erg", 1e-7, of::energy},
    Row{"eV", "electronvolt electron_volt", 1.60217733e-19, of::energy},
    Row{"cal", "calorie", 4.1868, of::energy},
    Row{"", "thermochemical_calorie", 4.184, of::energy},
    Row{"", "btu", 1055.05585262, of::energy},
    Row{"Wh", "watthour", 3600, of::energy},
    Row{"W VA", "watt voltampere", 1, of::power},
    Row{"hp", "horsepower", 745.6999, of::power},
    Row{"P", "poise", 0.1, {-1, 1, -1, 0}},
    Row{"Pas", "", 1, {-1, 1, -1, 0}},
    Row{"Ns", "", 1, {1, 1, -1, 0}},
    Row{"K degC degF degK degR", "kelvin celsius fahrenheit degree_C degree_F", 1, of::other},
    Row{"A V C F H T S", "ampere volt coulomb farad henry tesla ohm siemens weber gauss", 1, of::other},
    Row{"Wb Bq Gy Sv kat", "becquerel gray sievert katal", 1, of::other},
    Row{"mol cd lm lx ph nt", "mole candela lumen lux phot nit", 1, of::other},
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

/// Whether a list of words, separated by blanks, contains a word.
bool contains_word(std::string_view words, std::string_view word) {
    if (word.empty()) return false;
    for (auto at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
    }
    return false;
}

/// The row of a symbol or name without a prefix; null if there is none.
const Row* unit_row(std::string_view text) {
    const std::string name = lower_case(text);
    const auto is_name_of = [&](const Row& row, std::string_view ending) {
        return name.ends_with(ending) &&
               contains_word(row.names, std::string_view(name).substr(0, name.size() - ending.size()));
    };
    for (const Row& row : rows)
        if (contains_word(row.symbols, text) || is_name_of(row, "") || is_name_of(row, "s") ||
            is_name_of(row, "es"))
            return &row;
    return nullptr;
}

constexpr std::size_t longest_unit = 200;  // bounds the depth of brackets

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%';
}

Unit raised(Unit unit, int exponent) {
    unit.factor = std::pow(unit.factor, exponent);
    for (double& power : unit.powers) power *= exponent;
    return unit;
}

Unit product(Unit left, const Unit& right) {
    left.factor *= right.factor;
    for (std::size_t i = 0; i < left.powers.size(); ++i) left.powers[i] += right.powers[i];
    return left;
}

/// Reads a unit by recursive descent: products of powers of symbols, names and brackets.
class UnitReader {
  public:
    explicit UnitReader(std::string_view text) : rest_(text) {}

    std::optional<Unit> read() {
        const std::optional<Unit> unit = products();
        return rest_.empty() ? unit : std::nullopt;
    }

  private:
    std::optional<Unit> products() {
        std::optional<Unit> left = power();
        for (std::size_t factors = 1; left; ++factors) {
            const bool blank = skip_blanks();
            if (rest_.empty() || rest_.front() == ')')
                return has_share_ && factors > 1 ? std::nullopt : left;  // "5 % um" is none
            const bool divides = skip("/") || (blank && skip_per());
            if (!divides) static_cast<void>(skip(".") || skip("*") || skip("-"));
            skip_blanks();
            const std::optional<Unit> right = power();
            if (!right) return std::nullopt;
            left = product(*left, divides ? raised(*right, -1) : *right);
        }
        return left;
    }

    std::optional<Unit> power() {
        const std::optional<Unit> unit = name_or_brackets();
        if (!unit) return unit;
        const bool needs_exponent = skip("^");
        const std::optional<int> exponent = integer();
        if (!exponent) return needs_exponent ? std::nullopt : unit;
        return raised(*unit, *exponent);
    }

    std::optional<Unit> name_or_brackets() {
        if (skip("(")) {
            const std::optional<Unit> unit = products();
            return unit && skip(")") ? unit : std::nullopt;
        }
        const std::string_view name = rest_.substr(0, length_of_name());
        rest_.remove_prefix(name.size());
        has_share_ = has_share_ || name == "%" || lower_case(name) == "percent";
        return name.empty() ? std::nullopt : unit_named(name);
    }

    /// Length of the name in front: letters and digits, but a letter first and last, as in "cmH2O".
    [[nodiscard]] std::size_t length_of_name() const {
        std::size_t length = 0;
        for (std::size_t i = 0; i < rest_.size() && (is_letter(rest_[i]) || is_digit(rest_[i])); ++i) {
            if (i == 0 && is_digit(rest_[i])) return 0;
            if (is_letter(rest_[i])) length = i + 1;
        }
        return length;
    }

    std::optional<int> integer() {
        const std::size_t sign = rest_.starts_with('-') || rest_.starts_with('+') ? 1 : 0;
        int value = 0;
        const auto* const first = rest_.data() + sign;
        const auto [end, status] = std::from_chars(first, rest_.data() + rest_.size(), value);
        if (status != std::errc{} || (sign == 1 && !is_digit(*first))) return std::nullopt;
        if (rest_.front() == '-') value = -value;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    bool skip(std::string_view text) {
        const bool found = rest_.starts_with(text);
        if (found) rest_.remove_prefix(text.size());
        return found;
    }
    bool skip_per() {
        const bool found = length_of_name() == 3 && lower_case(rest_.substr(0, 3)) == "per";
        if (found) rest_.remove_prefix(3);
        return found;
    }
    bool skip_blanks() {
        const std::size_t before = rest_.size();
        rest_ = rest_.substr(std::min(rest_.find_first_not_of(' '), rest_.size()));
        return rest_.size() < before;
    }

    std::string_view rest_;
    bool has_share_ = false;  ///< whether it has a per cent, which is a unit by itself alone
};

const DimensionRow& row_of(Dimension dimension) {
    return *std::ranges::find(dimension_rows, dimension, &DimensionRow::dimension);
}

std::string allowed(Dimension dimension) {
    const auto& [_, name, unit, examples] = row_of(dimension);
    return with_article(name) + " [" + std::string(unit) + "], e.g. " + std::string(examples);
}

/// Whether what follows a number in a text makes it a range of quantities: "-100 um", " um to 100 um".
bool is_rest_of_range(std::string_view rest, Dimension expected) {
    for (const std::string_view between : {"-", "\u2013", "..", "to ", "bis "}) {
        const auto place = rest.find(between);
        if (place == std::string_view::npos) continue;
        const std::string_view unit = trimmed(rest.substr(0, place));
        std::string_view end = trimmed(rest.substr(place + between.size()));
        double value = 0;
        if ((!unit.empty() && !read_unit(unit)) || take_decimal(end, value) != std::errc{}) continue;
        const auto end_unit = read_unit(trimmed(end));
        const auto si = read_unit(si_unit(expected));
        if (end_unit ? si && end_unit->powers == si->powers : unit.empty() && end.empty()) return true;
    }
    return false;
}

/// The factor rounded to 15 significant digits: a product of unit factors has errors beyond them.
double without_rounding_noise(double factor) {
    return whole_decimal(fmt::format("{:.14e}", factor)).value_or(factor);
}

}  // namespace

std::optional<Unit> unit_named(std::string_view name) {
    if (const Row* row = unit_row(name)) return Unit{row->factor, row->powers};
    if (name.ends_with('%')) return std::nullopt;
    const std::string lower = lower_case(name);
    for (const Prefix& prefix : prefixes)
        for (const bool by_name : {true, false}) {
            const std::string_view word = by_name ? prefix.name : prefix.symbol;
            const std::string_view text = by_name ? std::string_view(lower) : name;
            if (!text.starts_with(word)) continue;
            if (const Row* row = unit_row(name.substr(word.size())))
                return Unit{prefix.factor * row->factor, row->powers};
        }
    return std::nullopt;
}

std::optional<Unit> read_unit(std::string_view text) {
    if (text == "1") return Unit{};
    if (text.size() > longest_unit) return std::nullopt;
    const std::optional<Unit> unit = UnitReader(text).read();
    return unit && std::isfinite(unit->factor) && unit->factor > 0 ? unit : std::nullopt;
}

std::string ascii_unit(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 23> spellings{{
        {"\u00b5", "u"},        {"\u03bc", "u"},        {"\u00b7", "."}, {"\u22c5", "."}, {"\u00d7", "."},
        {"\u2212", "-"},        {"\u207b", "-"},        {"\u2070", "0"}, {"\u00b9", "1"}, {"\u00b2", "2"},
        {"\u00b3", "3"},        {"\u2074", "4"},        {"\u2075", "5"}, {"\u2076", "6"}, {"\u2077", "7"},
        {"\u2078", "8"},        {"\u2079", "9"},        {"\u00a0", " "}, {"\u2009", " "}, {"\u202f", " "},
        {"\u00c5", "angstrom"}, {"\u212b", "angstrom"}, {"**", "^"},
    }};
    return text == "\"" || text == "\u2033" ? "in" : replaced(text, spellings);
}

std::string_view si_unit(Dimension dimension) {
    return row_of(dimension).unit;
}

std::string_view dimension_name(Dimension dimension) {
    return row_of(dimension).name;
}

namespace {

/// A unit that one dimension alone has: its size and zero in SI.
struct OwnUnit {
    double size, zero = 0;
};

std::optional<OwnUnit> temperature_unit(std::string_view text) {
    std::string name(trimmed(text));
    for (const std::string_view sign : {"\u00b0", "\u00ba", "deg ", "degree ", "degrees ", " "})
        if (name.starts_with(sign)) name.erase(0, sign.size());
    if (name == "\u2103") name = "C";
    const std::string lower = lower_case(name);
    constexpr double zero_celsius = 273.15;
    if (name == "K" || contains_word("kelvin degk", lower)) return OwnUnit{1};
    if (name == "C" || contains_word("degc celsius degree_c grad", lower)) return OwnUnit{1, zero_celsius};
    constexpr double fahrenheit = 1 / 1.8;
    if (name == "F" || contains_word("degf fahrenheit degree_f", lower))
        return OwnUnit{fahrenheit, zero_celsius - 32 * fahrenheit};
    return std::nullopt;
}

std::optional<OwnUnit> angle_unit(std::string_view text) {
    const std::string name = lower_case(trimmed(text));
    if (name == "\u00b0" || name == "\u00ba" || text == "Grad" || contains_word("deg degree degrees", name))
        return OwnUnit{std::numbers::pi / 180};
    const auto known = read_unit(ascii_unit(trimmed(text)));  // "mrad", "milliradian"
    const bool is_radian = name.ends_with("rad") || name.ends_with("radian") || name.ends_with("radians");
    return known && is_radian && known->powers == Unit{}.powers ? std::optional(OwnUnit{known->factor})
                                                                : std::nullopt;
}

/// Revolutions are not radians: Hz has both readings and is none.
std::optional<OwnUnit> angular_velocity_unit(std::string_view text) {
    const std::string name = lower_case(ascii_unit(trimmed(text)));
    if (contains_word("rpm u/min r/min rev/min 1/min min-1", name)) return OwnUnit{std::numbers::pi / 30};
    if (contains_word("rps rev/s rev.s-1", name)) return OwnUnit{2 * std::numbers::pi};
    if (contains_word("deg/s degrees/s", name)) return OwnUnit{std::numbers::pi / 180};
    return contains_word("rad/s rad.s-1 rads-1", name) || name == "rad s-1" ? std::optional(OwnUnit{1})
                                                                            : std::nullopt;
}

/// Reader of the units that a dimension alone has; null if it has none.
std::optional<OwnUnit> (*own_units(Dimension dimension))(std::string_view) {
    if (dimension == Dimension::temperature) return temperature_unit;
    if (dimension == Dimension::angle) return angle_unit;
    return dimension == Dimension::angular_velocity ? angular_velocity_unit : nullptr;
}

}  // namespace

namespace {

/// ", did you mean "GPa"?" for "Gpa", by the units of the examples of a dimension.
std::string meant_unit(std::string_view unit, Dimension dimension) {
    std::vector<std::string> units;
    std::string_view examples = row_of(dimension).examples;
    for (std::size_t end = 0; end < examples.size();
         examples.remove_prefix(std::min(end + 1, examples.size()))) {
        end = std::min(examples.find(','), examples.size());
        const std::string_view one = trimmed(examples.substr(0, end));
        units.emplace_back(one.substr(std::min(one.find(' '), one.size() - 1) + 1));
    }
    return did_you_mean(unit, units);
}

/// Refuses a unit with a part that has two readings. @throws InputError
void require_one_reading(std::string_view unit) {
    struct Readings {
        std::string_view part, both, allowed;
    };
    constexpr std::array symbols{
        Readings{"gr", "gram and grain", "\"g\" or \"grain\""},
        Readings{"ppt", "parts per thousand and per trillion", "\"per mille\" or a number"},
        Readings{"grad", "degree and gradian", "\"deg\"; 100 gradians are 90 deg"}};
    constexpr std::array names{// in any case, one or several
                               Readings{"ton", "metric and short ton", "\"t\" or \"short_ton\""},
                               Readings{"gallon", "American and imperial gallon", "\"l\""},
                               Readings{"pint", "American and imperial pint", "\"l\""}};
    for (std::size_t i = 0; i < unit.size();) {
        std::size_t end = i;
        while (end < unit.size() && is_letter(unit[end])) ++end;
        const std::string_view word = unit.substr(i, end - i);
        const std::string name = lower_case(word);
        const auto refuse_if = [&](bool is_part, const Readings& readings) {
            if (is_part)
                throw InputError(
                    "the unit " + in_quotes(unit) + " has two readings, " + std::string(readings.both),
                    std::string(readings.allowed));
        };
        for (const Readings& each : symbols) refuse_if(word == each.part, each);
        for (const Readings& each : names)
            refuse_if(name == each.part || name == std::string(each.part) + "s", each);
        i = std::max(end, i + 1);
    }
}

}  // namespace

SiConversion::SiConversion(std::string_view unit, Dimension expected) : expected_(expected) {
    require_one_reading(unit);
    if (const auto own_unit = own_units(expected)) {
        const auto own = own_unit(unit);
        if (!own)
            throw InputError(
                "the unit " + in_quotes(unit) + " is not one of " + std::string(dimension_name(expected)),
                allowed(expected));
        factor_ = own->size;
        zero_ = own->zero;
        return;
    }
    const std::optional<Unit> from = read_unit(ascii_unit(unit));
    if (!from)
        throw InputError("the unit " + in_quotes(unit) + " is not known" + meant_unit(unit, expected),
                         allowed(expected));
    if (from->powers != read_unit(si_unit(expected))->powers)
        throw InputError(
            "the unit " + in_quotes(unit) + " is not one of " + std::string(dimension_name(expected)),
            allowed(expected));
    divides_ = from->factor < 1;
    factor_ = without_rounding_noise(divides_ ? 1 / from->factor : from->factor);
}

double SiConversion::operator()(double value) const {
    if (!std::isfinite(value)) throw InputError("the value is not finite", allowed(expected_));
    const double converted = (divides_ ? value / factor_ : value * factor_) + zero_;
    if (std::isfinite(converted)) return converted;
    throw InputError("the value is too large in SI units", allowed(expected_));
}

double to_si(double value, std::string_view unit, Dimension expected) {
    return SiConversion(unit, expected)(value);
}

double difference_to_si(double value, std::string_view unit, Dimension expected) {
    const SiConversion conversion(unit, expected);
    return conversion(value) - conversion(0);
}

/// Whether a raised digit belongs to the number of a text: "1·10³ Pa s", unlike "5 m²".
static bool has_raised_digit(std::string_view text) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const std::string_view number =
        text.substr(0, static_cast<std::size_t>(std::ranges::find_if(text, is_letter) - text.begin()));
    constexpr std::array<std::string_view, 10> raised{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                      "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    return std::ranges::any_of(
        raised, [&](std::string_view digit) { return number.find(digit) != std::string_view::npos; });
}

double parse_quantity(std::string_view text, Dimension expected) {
    if (has_raised_digit(text))
        throw InputError(in_quotes(text) + " has a raised digit in its number",
                         "1e3 for a power of ten; " + allowed(expected));
    const std::string plain = ascii_unit(text);
    std::string_view rest = trimmed(plain);
    if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
    double value = 0;
    const std::errc status = take_decimal(rest, value);
    if (status == std::errc::result_out_of_range)
        throw InputError(in_quotes(text) + " is outside the range of numbers", allowed(expected));
    if (status != std::errc{})
        throw InputError(in_quotes(text) + " does not start with a number", allowed(expected));
    if (!std::isfinite(value)) throw InputError(in_quotes(text) + " is not finite", allowed(expected));
    if (rest.size() > 1 && (rest.front() == ',' || rest.front() == '.'))
        if (const std::string remedy = remedy_for_commas(trimmed(plain)); !remedy.empty())
            throw InputError(in_quotes(text) + " has a decimal comma, " + remedy, allowed(expected));
    const std::string_view unit = trimmed(rest);
    if (!unit.empty() && is_rest_of_range(rest, expected))
        throw InputError(in_quotes(text) + " is a range",
                         "one value: " + allowed(expected) + "; ranges are for `ashimpact sweep`" +
                             (expected == Dimension::length ? " and, as meshes of two sieves, for the "
                                                              "\"diameter\" of a sample in a case"
                                                            : ""));
    return unit.empty() ? value : to_si(value, unit, expected);
}

}  // namespace ashimpact
