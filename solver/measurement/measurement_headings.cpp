#include "solver/measurement/measurement_headings.hpp"

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"
#include "materials/base/units.hpp"

#include <algorithm>
#include <cctype>

namespace ashimpact {

namespace {

struct Alias {
    std::string_view key;
    MeasuredQuantity quantity;
};

constexpr std::array aliases{
    Alias{"vin", MeasuredQuantity::velocity},
    Alias{"vi", MeasuredQuantity::velocity},
    Alias{"v", MeasuredQuantity::velocity},
    Alias{"velocity", MeasuredQuantity::velocity},
    Alias{"incidentvelocity", MeasuredQuantity::velocity},
    Alias{"incidentnormalvelocity", MeasuredQuantity::velocity},
    Alias{"normalincidentvelocity", MeasuredQuantity::velocity},
    Alias{"impactvelocity", MeasuredQuantity::velocity},
    Alias{"vein", MeasuredQuantity::velocity},
    Alias{"veinfall", MeasuredQuantity::velocity},
    Alias{"einfallsgeschwindigkeit", MeasuredQuantity::velocity},
    Alias{"aufprallgeschwindigkeit", MeasuredQuantity::velocity},
    Alias{"auftreffgeschwindigkeit", MeasuredQuantity::velocity},
    Alias{"geschwindigkeit", MeasuredQuantity::velocity},
    Alias{"vitesse", MeasuredQuantity::velocity},
    Alias{"vitesseincidente", MeasuredQuantity::velocity},
    Alias{"vitessedimpact", MeasuredQuantity::velocity},
    Alias{"ventre", MeasuredQuantity::velocity},  // "v_entrée"
    Alias{"ventree", MeasuredQuantity::velocity},
    Alias{"vr", MeasuredQuantity::rebound},
    Alias{"vrn", MeasuredQuantity::rebound},
    Alias{"vout", MeasuredQuantity::rebound},
    Alias{"rebound", MeasuredQuantity::rebound},
    Alias{"reboundvelocity", MeasuredQuantity::rebound},
    Alias{"normalreboundvelocity", MeasuredQuantity::rebound},
    Alias{"vaus", MeasuredQuantity::rebound},
    Alias{"vab", MeasuredQuantity::rebound},
    Alias{"vrck", MeasuredQuantity::rebound},  // "v_rück"
    Alias{"vrueck", MeasuredQuantity::rebound},
    Alias{"rckprallgeschwindigkeit", MeasuredQuantity::rebound},  // "Rückprallgeschwindigkeit"
    Alias{"rueckprallgeschwindigkeit", MeasuredQuantity::rebound},
    Alias{"abprallgeschwindigkeit", MeasuredQuantity::rebound},
    Alias{"vsortie", MeasuredQuantity::rebound},
    Alias{"vrebond", MeasuredQuantity::rebound},
    Alias{"vitessederebond", MeasuredQuantity::rebound},
    Alias{"e", MeasuredQuantity::restitution},
    Alias{"en", MeasuredQuantity::restitution},
    Alias{"cor", MeasuredQuantity::restitution},
    Alias{"restitution", MeasuredQuantity::restitution},
    Alias{"coefficientofrestitution", MeasuredQuantity::restitution},
    Alias{"normalrestitution", MeasuredQuantity::restitution},
    Alias{"stosszahl", MeasuredQuantity::restitution},
    Alias{"stozahl", MeasuredQuantity::restitution},  // "Stoßzahl"
    Alias{"restitutionskoeffizient", MeasuredQuantity::restitution},
    Alias{"coefficientderestitution", MeasuredQuantity::restitution},
};

constexpr std::array<std::string_view, 13> uncertainty_words{"u",
                                                             "sigma",
                                                             "sd",
                                                             "std",
                                                             "uncertainty",
                                                             "uncertaintyof",
                                                             "standarduncertainty",
                                                             "standarduncertaintyof",
                                                             "fehler",
                                                             "unsicherheit",
                                                             "incertitude",
                                                             "error",
                                                             "errorof"};

/// ASCII letters and digits in lower case; "v_{in}" becomes "vin", "v_rück" becomes "vrck".
std::string key_of(std::string_view text) {
    std::string key;
    for (const char c : lower_case(text)) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) key += c;
    }
    return key;
}

std::optional<MeasuredQuantity> quantity_of(std::string_view key) {
    const auto found =
        std::find_if(aliases.begin(), aliases.end(), [&](const Alias& alias) { return alias.key == key; });
    return found == aliases.end() ? std::nullopt : std::optional(found->quantity);
}

struct Meaning {
    MeasuredQuantity quantity;
    bool is_uncertainty;
};

std::optional<Meaning> meaning_of(std::string_view name) {
    const std::string key = key_of(name);
    if (const auto quantity = quantity_of(key)) return Meaning{*quantity, false};
    for (const std::string_view word : uncertainty_words) {
        std::optional<MeasuredQuantity> quantity;
        if (key.starts_with(word)) quantity = quantity_of(std::string_view(key).substr(word.size()));
        if (!quantity && key.ends_with(word))
            quantity = quantity_of(std::string_view(key).substr(0, key.size() - word.size()));
        if (quantity) return Meaning{*quantity, true};
    }
    return std::nullopt;
}

struct NameAndUnit {
    std::string_view name;
    std::string_view unit;
};

/// "v_r (mm/s)" into name and unit; brackets that belong to the name, as in "u(v_r)", stay there.
NameAndUnit split(std::string_view cell) {
    for (const std::string_view pair : {"[]", "()"}) {
        if (!cell.ends_with(pair[1])) continue;
        const auto open = cell.rfind(pair[0]);
        if (open == std::string_view::npos) continue;
        const std::string_view name = trimmed(cell.substr(0, open));
        if (pair == "[]" || meaning_of(name))
            return {name, trimmed(cell.substr(open + 1, cell.size() - open - 2))};
    }
    return {cell, {}};
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
    const auto other = rebound ? MeasuredQuantity::restitution : MeasuredQuantity::rebound;
    if (heading.uncertainty_of(other))
        throw InputError("the uncertainty in column " + in_quotes(heading.uncertainty_of(other)->name) +
                             " is that of a column that is not there",
                         "the uncertainty of a column of the table");
}

/// Columns that hold no velocity: the outcome, and the correlation of the errors of the two velocities.
bool take_other(MeasurementHeading& heading, std::string_view name, std::size_t position) {
    const std::string key = key_of(name);
    const auto take = [&](std::optional<std::size_t>& column) {
        if (column) throw InputError("column " + in_quotes(name) + " stands twice", "each quantity once");
        column = position;
        return true;
    };
    constexpr std::array<std::string_view, 6> outcomes{"outcome",  "result",  "ausgang",
                                                       "ergebnis", "rsultat", "resultat"};
    if (std::find(outcomes.begin(), outcomes.end(), key) != outcomes.end()) return take(heading.outcome);
    if (key == "correlation" || key == "rvinvr" || key == "corrvinvr") return take(heading.correlation);
    return false;
}

}  // namespace

bool names_incident_velocity(const std::vector<std::string>& cells) {
    return std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
        const auto meaning = meaning_of(split(cell).name);
        return meaning && meaning->quantity == MeasuredQuantity::velocity && !meaning->is_uncertainty;
    });
}

MeasurementHeading read_measurement_heading(const std::vector<std::string>& cells) {
    MeasurementHeading heading{.value = {},
                               .uncertainty = {},
                               .outcome = {},
                               .correlation = {},
                               .unused = {},
                               .columns = cells.size()};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto [name, unit] = split(cells[i]);
        if (take_other(heading, name, i)) continue;
        const auto meaning = meaning_of(name);
        if (!meaning) {
            if (!cells[i].empty()) heading.unused.emplace_back(cells[i]);
            continue;
        }
        const bool is_ratio = meaning->quantity == MeasuredQuantity::restitution;
        const Dimension dimension = is_ratio ? Dimension::fraction : Dimension::velocity;
        auto& column = (meaning->is_uncertainty ? heading.uncertainty
                                                : heading.value)[static_cast<std::size_t>(meaning->quantity)];
        if (column)
            throw InputError("the columns " + in_quotes(column->name) + " and " + in_quotes(name) +
                                 " hold the same quantity",
                             "each quantity once");
        column = MeasuredColumn{.position = i,
                                .name = std::string(name),
                                .to_si = unit.empty() ? 1.0 : to_si(1.0, unit, dimension),
                                .unit_given = !unit.empty() || is_ratio};
    }
    require_columns(heading);
    return heading;
}

}  // namespace ashimpact
