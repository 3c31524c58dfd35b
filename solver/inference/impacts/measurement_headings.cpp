// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/impacts/measurement_headings.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>
#include <utility>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

namespace {

const WordLists& column_words() {
    static const WordLists words("impact columns");
    return words;
}

/// Letters and digits in lower case: "v_{in}" is "vin", "v_rück" is "vrueck". Signs of changes do not count.
std::string key_of(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> signs{{{"\u00b1", "plusminus"},
                                                                                  {"+-", "plusminus"},
                                                                                  {"+/-", "plusminus"},
                                                                                  {"\u221a", ""},
                                                                                  {"\u00bd", ""},
                                                                                  {"\u0394", ""},
                                                                                  {"\u2206", ""},
                                                                                  {"\u2202", ""},
                                                                                  {"\u2212", ""}}};
    return word_key(replaced(text, signs));
}

std::optional<MeasuredQuantity> quantity_of(std::string_view key) {
    return meaning<MeasuredQuantity>(column_words(), key);
}

struct Meaning {
    MeasuredQuantity quantity;
    bool is_uncertainty;
};

std::optional<Meaning> meaning_of(std::string_view name) {
    if (name.size() > longest_heading) return std::nullopt;
    const std::string key = key_of(name);
    if (const auto quantity = quantity_of(key)) return Meaning{*quantity, false};
    for (const auto& [word, list] : uncertainty_words().words()) {
        std::optional<MeasuredQuantity> quantity;
        if (key.starts_with(word)) quantity = quantity_of(std::string_view(key).substr(word.size()));
        if (!quantity && key.ends_with(word))
            quantity = quantity_of(std::string_view(key).substr(0, key.size() - word.size()));
        if (quantity) return Meaning{*quantity, true};
    }
    // "Einfallsgeschwindigkeit v_ein": a name and a symbol of one quantity.
    for (auto at = name.find(' '); at != std::string_view::npos; at = name.find(' ', at + 1)) {
        const auto quantity = quantity_of(key_of(name.substr(0, at)));
        if (quantity && quantity == quantity_of(key_of(name.substr(at)))) return Meaning{*quantity, false};
    }
    return std::nullopt;
}

/// What is done to the quantity in a heading such as "e²", "√e_n" or "Δe_n"; empty: nothing.
std::string_view change_in(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> signs{{{"\u00b2", "square"},
                                                                                  {"\u00b3", "third power"},
                                                                                  {"^", "power"},
                                                                                  {"**", "power"},
                                                                                  {"\u221a", "root"},
                                                                                  {"\u00bd", "root"},
                                                                                  {"\u0394", "difference"},
                                                                                  {"\u2206", "difference"},
                                                                                  {"\u2202", "difference"}}};
    for (const auto& [sign, change] : signs)
        if (name.find(sign) != std::string_view::npos) return change;
    if (name.ends_with("(E)")) return "restitution of energy";
    if (has_sign_of_bound(name)) return "bound";
    return {};
}

/// A unit in ASCII; "ms-1" of a velocity is no inverse millisecond.
std::string velocity_unit(std::string_view text) {
    std::string unit = ascii_unit(text);
    for (const std::string_view joined : {"ms-1", "ms^-1", "ms**-1"})
        if (unit == joined) return "m/s";
    return unit;
}

}  // namespace

bool is_velocity_unit(std::string_view text) {
    const auto unit = read_unit(velocity_unit(text));
    return unit && unit->powers == Unit{1, {1, 0, -1, 0}}.powers;
}

namespace {

struct NameAndUnit {
    std::string_view name;
    std::string_view unit;
};

/// Whether a column holds an angle or a velocity along the wall.
bool is_sideways(std::string_view name) {
    const auto list = column_words().list_of(key_of(name));
    return list == "angle" || list == "tangential";
}

/// The value before "±", as in "v_in ± u [m/s]", whose cells hold value and uncertainty.
std::optional<Meaning> value_before_plus_minus(std::string_view name) {
    for (const std::string_view sign : {"\u00b1", "+-", "+/-"}) {
        const auto at = name.find(sign);
        if (at == std::string_view::npos || at == 0) continue;
        const auto meaning = meaning_of(name.substr(0, at));
        if (meaning && !meaning->is_uncertainty) return meaning;
    }
    return std::nullopt;
}

/// Whether a name is that of a quantity that is measured, or of an uncertainty.
bool names_measured(std::string_view name) {
    return meaning_of(name) || names_uncertainty(name) || value_before_plus_minus(name);
}

/// Splits "v_r (mm/s)" into name and unit. Brackets that belong to the name, as in "u(v_r)", stay there.
NameAndUnit split(std::string_view cell) {
    if (cell.size() > longest_heading) return {cell, {}};
    for (const std::string_view pair : {"[]", "()"}) {
        if (!cell.ends_with(pair[1])) continue;
        const auto open = cell.rfind(pair[0]);
        if (open == std::string_view::npos) continue;
        const std::string_view name = trimmed(cell.substr(0, open));
        std::string_view inside = trimmed(cell.substr(open + 1, cell.size() - open - 2));
        if (inside.starts_with("in ")) inside = trimmed(inside.substr(3));
        const bool is_named = meaning_of(name) || names_uncertainty(name) || is_sideways(name);
        if (pair == "[]" || ((is_named || name.empty()) && !meaning_of(inside))) return {name, inside};
    }
    // "e_n/%" and "v_r/(m/s)": a quantity over its unit.
    if (const auto slash = cell.find('/'); slash != std::string_view::npos) {
        const std::string_view name = trimmed(cell.substr(0, slash));
        std::string_view unit = trimmed(cell.substr(slash + 1));
        if (unit.starts_with('(') && unit.ends_with(')')) unit = unit.substr(1, unit.size() - 2);
        if (meaning_of(name) && read_unit(ascii_unit(unit))) return {name, unit};
        if (value_before_plus_minus(name) && (is_velocity_unit(unit) || unit == "%")) return {name, unit};
    }
    for (auto at = cell.find(' '); at != std::string_view::npos; at = cell.find(' ', at + 1)) {
        std::string_view name = cell.substr(0, at);
        while (name.ends_with(',') || name.ends_with(';') || name.ends_with(':')) name.remove_suffix(1);
        std::string_view unit = trimmed(cell.substr(at));
        if (unit.starts_with("in ")) unit = trimmed(unit.substr(3));  // "v_in in ms-1": no inches
        if (names_measured(name) && is_velocity_unit(unit)) return {name, unit};
    }
    if (cell.ends_with('%')) {  // "u(v_in) %", and "2s %" without its coverage
        const std::string_view name = trimmed(cell.substr(0, cell.size() - 1));
        const auto meaning = meaning_of(name);
        if (name.empty() || names_uncertainty(name) || (meaning && meaning->is_uncertainty))
            return {name, "%"};
    }
    if (is_velocity_unit(cell)) return {{}, cell};
    if (const auto in = cell.rfind(" in "); in != std::string_view::npos) {
        const std::string_view name = trimmed(cell.substr(0, in));
        const std::string_view unit = trimmed(cell.substr(in + 4));
        if (is_sideways(name) || (names_measured(name) && read_unit(ascii_unit(unit)))) return {name, unit};
    }
    return {cell, {}};
}

/// The quantity of the column at a position, if that column holds values.
std::optional<MeasuredQuantity> value_at(const MeasurementHeading& heading, std::size_t position) {
    for (std::size_t i = 0; i < heading.value.size(); ++i)
        if (heading.value[i] && heading.value[i]->position == position)
            return static_cast<MeasuredQuantity>(i);
    return std::nullopt;
}

/// What a column holds. One that names an uncertainty and no quantity belongs to the column before it.
std::optional<Meaning> meaning_in(const MeasurementHeading& heading, std::string_view name,
                                  const StatedCoverage& coverage, std::size_t position) {
    if (const auto both = value_before_plus_minus(name)) {
        if (!number_behind_plus_minus(name).empty())
            throw InputError("the heading " + in_quotes(name) + " states one uncertainty, " +
                                 number_behind_plus_minus(name) + ", for all numbers of its column",
                             "a column of the uncertainties, such as \"u(v_in) [m/s]\"");
        return Meaning{both->quantity, heading.of(both->quantity).has_value()};
    }
    auto meaning = meaning_of(name);
    if (meaning && !meaning->is_uncertainty && !coverage.stated.empty())
        meaning->is_uncertainty = coverage.stated_first || heading.of(meaning->quantity).has_value();
    const bool bare = names_uncertainty(name) || !coverage.stated.empty();
    if (meaning || !bare || position == 0) return meaning;
    const auto before = value_at(heading, position - 1);
    return before ? std::optional(Meaning{*before, true}) : std::nullopt;
}

void require_columns(const MeasurementHeading& heading) {
    constexpr const char* allowed = "v_in with v_r or with e_n, e.g. \"v_in [m/s], v_r [m/s]\"";
    if (!heading.of(MeasuredQuantity::velocity))
        throw InputError("the heading has no column for the incident velocity", allowed);
    const bool rebound = heading.of(MeasuredQuantity::rebound).has_value();
    const bool restitution = heading.of(MeasuredQuantity::restitution).has_value();
    if (!rebound && !restitution)
        throw InputError("the heading has no column for the rebound velocity or the restitution", allowed);
    if (rebound && restitution)
        throw InputError("the heading has both the rebound velocity and the restitution", "one of them");
    if (heading.correlation && !rebound)
        throw InputError("a correlation beside e_n may be that of v_in with v_r, or of v_in with e_n",
                         "v_r with u(v_r) beside it, or no correlation");
}

/// Leaves out u(v_r) beside e_n, or u(e_n) beside v_r, with a remark.
void drop_uncertainty_without_value(MeasurementHeading& heading) {
    for (std::size_t i = 0; i < heading.value.size(); ++i) {
        if (heading.value[i] || !heading.uncertainty[i]) continue;
        heading.notes.push_back({impacts_code, Severity::remark,
                                 "column " + in_quotes(heading.uncertainty[i]->name) +
                                     " is not used: it is the uncertainty of a column that is not there"});
        heading.coverages[heading.uncertainty[i]->position].reset();
        heading.uncertainty[i].reset();
    }
}

/// Enters a column that holds no velocity: the outcome, or the correlation of the errors of the two
/// velocities.
/// @return whether the column is one of these
bool take_other(MeasurementHeading& heading, std::string_view name, std::size_t position) {
    const std::string key = key_of(name);
    if (key.empty()) return false;
    const auto take = [&](std::optional<std::size_t>& column) {
        if (column) throw InputError("column " + in_quotes(name) + " stands twice", "each quantity once");
        column = position;
        return true;
    };
    const auto list = column_words().list_of(key);
    if (list == "outcome") return take(heading.outcome);
    if (list == "correlation") return take(heading.correlation);
    return false;
}

/// Enters the column of an angle or of the velocity along the wall. @return whether the column is one
/// @throws InputError for a second one, and for an angle without a unit
bool take_sideways(MeasurementHeading& heading, const std::string& cell, std::string_view name,
                   std::string_view unit, std::size_t position) {
    if (column_words().list_of(key_of(name)) == "wall angle")
        throw InputError("column " + in_quotes(cell) + " holds angles from the wall, which are not read",
                         "the angle from the normal, \"angle [deg]\", 90 degrees less that");
    if (!is_sideways(name)) return false;
    if (heading.sideways)
        throw InputError("the columns " + in_quotes(heading.sideways->name) + " and " + in_quotes(cell) +
                             " both state how oblique the impacts are",
                         "one of them");
    const bool is_angle = column_words().list_of(key_of(name)) == "angle";
    if (is_angle && unit.empty())
        throw InputError("column " + in_quotes(cell) + " states no unit",
                         "degrees or radians: " + in_quotes(cell + " [deg]"));
    const double to_si_unit = at_place("column " + in_quotes(cell), [&] {
        return unit.empty() ? 1.0 : to_si(1.0, unit, is_angle ? Dimension::angle : Dimension::velocity);
    });
    heading.sideways = {{position, std::string(name)}, is_angle, to_si_unit};
    return true;
}

/// Whether a column is named as a velocity or restitution normal to the wall.
bool is_normal(const TextColumn& column) {
    static const WordLists words("normal velocities");
    return words.holds(column.name) || column.name == "v_i,n";  // unlike "v_in"
}

/// Decides what the velocities of impacts at an angle are. Beside an angle v_in is that of the sphere; the
/// reading has to be named as normal to the wall. @throws InputError
void settle_sideways(MeasurementHeading& heading) {
    const MeasuredColumn& velocity = *heading.of(MeasuredQuantity::velocity);
    if (!heading.sideways) {
        const auto oblique = std::ranges::find_if(heading.unused, [](const TextColumn& column) {
            return column_words().list_of(key_of(split(column.name).name)) == "tangential rebound";
        });
        if (oblique != heading.unused.end() && !is_normal(velocity))
            throw InputError("column " + in_quotes(oblique->name) + " shows impacts at an angle, and " +
                                 in_quotes(velocity.name) +
                                 " may be the velocity of the sphere or its part normal to the wall",
                             "v_n for the part, or a column \"angle [deg]\" or \"v_t [m/s]\"");
        return;
    }
    const MeasuredColumn& reading = heading.reading();
    if (velocity.name.starts_with('|') && !is_normal(velocity))
        throw InputError("beside " + in_quotes(heading.sideways->name) + ", " + in_quotes(velocity.name) +
                             " may be the speed of the sphere or the size of its part normal to the wall",
                         "v_n for the part, v_in beside an angle for the speed");
    heading.normal_velocity = !heading.sideways->is_angle || is_normal(velocity);
    if (heading.sideways->is_angle && !heading.normal_velocity && !is_normal(reading))
        throw InputError("beside the angle, column " + in_quotes(reading.name) +
                             " may be of the velocity of the sphere or of its part normal to the wall",
                         heading.of(MeasuredQuantity::rebound) ? "v_rn, normal to the wall; or e_n" : "e_n");
    heading.notes.push_back(
        {impacts_code, Severity::remark,
         heading.normal_velocity
             ? in_quotes(velocity.name) + " is taken as the velocity normal to the wall, beside " +
                   in_quotes(heading.sideways->name)
             : "the velocity normal to the wall is " + in_quotes(velocity.name) + " times the cosine of " +
                   in_quotes(heading.sideways->name) + ", which is taken from the normal"});
}

double factor_of(std::string_view unit, MeasuredQuantity quantity) {
    const bool is_ratio = quantity == MeasuredQuantity::restitution;
    return unit.empty() || (is_ratio && unit == "-") ? 1.0
           : is_ratio                                ? to_si(1.0, unit, Dimension::fraction)
                                                     : to_si(1.0, velocity_unit(unit), Dimension::velocity);
}

/// Enters a column of values or uncertainties.
void take_measured(MeasurementHeading& heading, const Meaning& meaning, MeasuredColumn column) {
    const auto index = static_cast<std::size_t>(meaning.quantity);
    auto& place = (meaning.is_uncertainty ? heading.uncertainty : heading.value)[index];
    if (place)
        throw InputError(
            "the columns " + in_quotes(place->name) + " and " + in_quotes(column.name) +
                " hold the same quantity",
            "each quantity once; outcomes in a column \"outcome\", or \"captured\" with yes and no");
    place = std::move(column);
}

/// Takes a column "captured" or "haftet" for the column of outcomes if there is no other.
void take_captured(MeasurementHeading& heading) {
    if (heading.outcome) return;
    const auto found = std::ranges::find_if(heading.unused, [](const TextColumn& column) {
        return column_words().list_of(column.name) == "captured";
    });
    if (found == heading.unused.end()) return;
    heading.outcome = found->position;
    heading.outcome_is_capture = true;
    heading.unused.erase(found);
}

/// Keeps v_r of v_r and e_n, which have to agree in every row.
void take_checked(MeasurementHeading& heading) {
    auto& restitution = heading.value[static_cast<std::size_t>(MeasuredQuantity::restitution)];
    if (!heading.of(MeasuredQuantity::rebound) || !restitution || heading.sideways ||
        heading.uncertainty_of(MeasuredQuantity::restitution))
        return;
    heading.notes.push_back({impacts_code, Severity::remark,
                             "column " + in_quotes(restitution->name) + " only has to agree with column " +
                                 in_quotes(heading.of(MeasuredQuantity::rebound)->name)});
    heading.checked = std::exchange(restitution, std::nullopt);
}

/// Whether a heading names an angle: "angle of plate", "Plattenwinkel".
bool names_angle(std::string_view name) {
    static const WordLists angles("angle words");
    return std::ranges::any_of(words_in(name), [&](const std::string& word) {
        return std::ranges::any_of(angles.words(), [&](const auto& angle) {
            return word.starts_with(angle.first) || word.ends_with(angle.first);
        });
    });
}

bool is_angle_unit(std::string_view unit) {
    try {
        return !unit.empty() && to_si(1.0, unit, Dimension::angle) > 0.0;
    } catch (const InputError&) {
        return false;
    }
}

/// Whether a unit is none of a fraction, as of "E* [GPa]", a modulus, or "E [J]", an energy.
bool is_of_other_dimension(std::string_view unit) {
    const auto known = read_unit(ascii_unit(unit));
    return known && known->powers != Unit{}.powers;
}

/// The coverage in a heading. A capital U beside a velocity is an expanded uncertainty: "U_v_in", "v_in U".
StatedCoverage coverage_in(const std::string& cell) {
    StatedCoverage coverage = read_coverage(cell);
    const std::string_view name = trimmed(split(coverage.rest).name);
    const bool is_capital =
        name.starts_with("U_") || name.starts_with("U ") || name.ends_with(" U") || name.ends_with("_U");
    const auto meaning = meaning_of(name);
    if (is_capital && meaning && meaning->is_uncertainty && coverage.stated.empty())
        coverage.problem = read_coverage("U").problem;
    return coverage;
}

/// Enters the column of one cell of the heading.
void take_column(MeasurementHeading& heading, const std::string& cell, std::size_t position) {
    const StatedCoverage coverage = coverage_in(cell);
    const auto [name, unit] = split(coverage.rest);
    if (take_sideways(heading, cell, name, unit, position) || take_other(heading, name, position)) return;
    auto meaning = meaning_in(heading, name, coverage, position);
    if (meaning && meaning->quantity == MeasuredQuantity::restitution && name.starts_with('E') &&
        is_of_other_dimension(unit))
        meaning.reset();
    if (!meaning) {
        const auto list = column_words().list_of(key_of(name));
        if ((is_angle_unit(unit) || names_angle(name)) && list != "other angle")
            throw InputError(
                "column " + in_quotes(cell) + " may hold the angle of incidence, or another one",
                "\"angle [deg]\" for that from the normal, \"rebound angle [deg]\" for one that is "
                "not used, or a file without this column");
        if (names_uncertainty(name) || !coverage.stated.empty())
            heading.notes.push_back(
                {impacts_code, Severity::remark,
                 "column " + in_quotes(cell) +
                     " is not used: it is not clear of which velocity or of what coverage it is; write "
                     "\"u(v_in) [m/s]\" or \"U(v_in) [m/s] (k=2)\""});
        else
            heading.LabelColumns::take({position, cell}, name);
        return;
    }
    if (constexpr std::string_view marks = "*'`\"!?#^";
        !name.empty() && marks.find(name.back()) != std::string_view::npos)
        throw InputError("column " + in_quotes(cell) + " has the mark " +
                             in_quotes(name.substr(name.size() - 1)) +
                             " behind its name: it may hold another quantity, or have a footnote",
                         "the name alone if it is that quantity; another name for what is not read");
    if (const std::string_view change = change_in(name); !change.empty())
        throw InputError(
            "column " + in_quotes(cell) + " holds " + with_article(change) + ", not the quantity",
            "v_in, v_r or e_n and their standard uncertainties; another name for what is not read");
    if (meaning->quantity == MeasuredQuantity::restitution && unit.empty() &&
        name.find('%') != std::string_view::npos)
        throw InputError("column " + in_quotes(cell) + " may be in per cent, or hold fractions",
                         "\"e_n [%]\" or \"e_n\"");
    const auto& incident = heading.of(MeasuredQuantity::velocity);
    const bool follows_v0 = incident && key_of(incident->name) == "v0";
    if (follows_v0 && key_of(name).find("v1") != std::string::npos)
        meaning->quantity = MeasuredQuantity::rebound;
    heading.coverages[position] = {cell, coverage, meaning->is_uncertainty};
    if (meaning->is_uncertainty && !coverage.problem.empty()) return;
    const bool named = meaning_of(name).has_value();
    const auto& value = heading.of(meaning->quantity);
    const bool is_ratio = meaning->quantity == MeasuredQuantity::restitution;
    const bool is_relative = meaning->is_uncertainty && !is_ratio && unit == "%";
    MeasuredColumn column{
        {position, named ? std::string(name) : cell},
        at_place("column " + in_quotes(cell),
                 [&, &of = unit] {
                     return factor_of(of, is_relative ? MeasuredQuantity::restitution : meaning->quantity);
                 }),
        !unit.empty() || (is_ratio && !meaning->is_uncertainty),
        is_ratio || is_relative,
        coverage.problem.empty() ? coverage.factor : 0,
        false,
        is_relative};
    if (unit.empty() && !named && meaning->is_uncertainty && value) {
        column.to_si = value->to_si;
        column.unit_given = value->unit_given;
        heading.notes.push_back({impacts_code, Severity::background,
                                 "column " + in_quotes(cell) + " is taken as the uncertainty of " +
                                     in_quotes(value->name) + ", which stands before it"});
    }
    if (is_ratio && meaning->is_uncertainty && unit == "%")
        heading.notes.push_back(
            {impacts_code, Severity::remark,
             "column " + in_quotes(cell) +
                 " is taken as points of the restitution, 5 % as 0.05, not as a share of it"});
    take_measured(heading, *meaning, std::move(column));
}

}  // namespace

void LabelColumns::take(TextColumn column, std::string_view name) {
    const auto list = column_words().list_of(key_of(name));
    if (list == "validity" || list == "exclusion") validity.push_back({column.position, list == "exclusion"});
    (announces_remarks(name) ? remarks : unused).push_back(std::move(column));
}

std::string_view as_flag(std::string_view cell) {
    const auto number = read_number(cell, true);
    if (!number || number->per_cent || number->standard_uncertainty) return cell;
    return number->value == 0 ? "0" : number->value == 1 ? "1" : cell;
}

OutcomeWord capture_flag(std::string_view cell) {
    static const WordLists flags("flags");
    return meaning<OutcomeWord>(flags, as_flag(cell)).value_or(outcome_word(cell));
}

OutcomeWord outcome_word(std::string_view cell) {
    static const WordLists words("outcomes", all_marks);
    return meaning<OutcomeWord>(words, trimmed(cell)).value_or(OutcomeWord::none);
}

OutcomeWord outcome_of_remark(std::string_view remark) {
    constexpr std::string_view dropped = ".!()[] ";
    const auto first = remark.find_first_not_of(dropped);
    if (first == std::string_view::npos) return OutcomeWord::none;
    const std::string_view word = remark.substr(first, remark.find_last_not_of(dropped) - first + 1);
    if (word.size() < 2) return OutcomeWord::none;
    const OutcomeWord meaning = outcome_word(word);
    return meaning == OutcomeWord::unknown ? OutcomeWord::none : meaning;
}

bool announces_remarks(std::string_view heading) {
    static const WordLists words("remark columns", all_marks);
    std::string_view text = trimmed(heading);
    while (!text.empty() && std::ispunct(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
    return words.holds(text);
}

void require_agreeing_units(const TextBeside& beside, const MeasurementHeading& heading) {
    static const WordLists angles("angle references", " ");
    std::vector<ColumnUnit> columns;
    for (const auto& column : heading.value)
        if (column && !column->is_fraction)
            columns.push_back({column->name, column->to_si, Dimension::velocity});
    const std::string_view text = beside.text;
    // A unit of velocity is a quotient, or has an exponent below zero, perhaps raised; most cells have
    // neither.
    if (text.find_first_of("/-\xe2") != std::string_view::npos || text.find("per") != std::string_view::npos)
        require_units({beside}, columns);
    if (!heading.sideways || !heading.sideways->is_angle) return;
    for (const Mention& mention : mentions_in(words_in(text), angles))
        if (!mention.negated && mention.list == "wall")
            refuse_line(beside.line,
                        in_quotes(text) + " may state that the angles are from the wall, and column " +
                            in_quotes(heading.sideways->name) + " is taken from the normal",
                        "angles from the normal, and a file without this text");
}

void require_stated_angle(const TextBeside& beside, const MeasurementHeading& heading) {
    static const WordLists angles("angle references", " ");
    static const std::regex degrees(
        "([0-9]+(?:[.,][0-9]+)?) *(?:\u00b0|deg|grad)|(?:angle|winkel)[^0-9]{0,20}([0-9]+(?:[.,][0-9]+)?)",
        std::regex::icase);
    const std::string text = beside.text.substr(0, longest_heading);
    std::smatch match;
    if (heading.sideways || !std::regex_search(text, match, degrees)) return;
    const double angle = read_number(match.str(match[1].matched ? 1 : 2)).value_or(PrintedNumber{}).value;
    const bool is_normal = angle == 0.0 || angle == 90.0;  // from the normal, or from the wall
    for (const Mention& mention : mentions_in(words_in(text), angles))
        if (!is_normal && !mention.negated && mention.list == "oblique")
            refuse_line(beside.line,
                        in_quotes(text) +
                            " states an angle of the impacts: the velocities may be those of the "
                            "sphere, or their parts normal to the wall",
                        "a column \"angle [deg]\" beside v_rn or e_n, or a file without this text");
}

bool names_incident_velocity(const std::vector<std::string>& cells) {
    const bool is_title = cells.size() < 2;  // "Velocities in mm/s"
    return !is_title && std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
        const StatedCoverage coverage = read_coverage(cell);
        const std::string_view name = split(coverage.rest).name;
        auto meaning = value_before_plus_minus(name);
        if (!meaning) meaning = meaning_of(name);
        return meaning && meaning->quantity == MeasuredQuantity::velocity && !meaning->is_uncertainty;
    });
}

MeasurementHeading read_measurement_heading(const std::vector<std::string>& cells) {
    MeasurementHeading heading{};
    heading.columns = cells.size();
    heading.coverages.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) take_column(heading, cells[i], i);
    take_captured(heading);
    take_checked(heading);
    require_columns(heading);
    drop_uncertainty_without_value(heading);
    settle_sideways(heading);
    return heading;
}

}  // namespace ashimpact
