// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/sweep/spec/spec.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

struct InputEntry {
    std::string_view name;
    Dimension dimension;  ///< of a damping: that of the constant law
    bool may_be_zero = false;
};

constexpr std::array<InputEntry, 12> own_inputs{{{"radius", Dimension::length},
                                                 {"density", Dimension::density},
                                                 {"mass", Dimension::mass},
                                                 {"contact_modulus", Dimension::pressure},
                                                 {"work_of_adhesion", Dimension::energy_per_area, true},
                                                 {"yield_pressure", Dimension::pressure},
                                                 {"damping", Dimension::damping, true},
                                                 {"velocity", Dimension::velocity},
                                                 {"partner_radius", Dimension::length},
                                                 {"partner_density", Dimension::density},
                                                 {"partner_mass", Dimension::mass},
                                                 {"angle", Dimension::angle, true}}};

/// All inputs by their values: the own ones, then the parameters of contact laws.
const std::vector<InputEntry>& inputs() {
    static const std::vector<InputEntry> all = [] {
        std::vector<InputEntry> entries(own_inputs.begin(), own_inputs.end());
        for (const LawParameter& parameter : law_parameters())
            entries.push_back({parameter.name, parameter.dimension, parameter.may_be_zero});
        return entries;
    }();
    return all;
}

const InputEntry& entry_of(ImpactInput input) {
    return inputs()[static_cast<std::size_t>(input)];
}

struct ObservableEntry {
    Dimension dimension;
    const char* description;
};

constexpr std::array<ObservableEntry, Names<Observable>::all.size()> observable_entries{
    {{Dimension::fraction, "1 for a capture, 0 for a rebound"},
     {Dimension::fraction, "rebound velocity over impact velocity; 0 for a capture"},
     {Dimension::velocity, "0 for a capture"},
     {Dimension::time, "first touch to detachment; not a number for a capture"},
     {Dimension::length, "its supremum where the approach never turns"}}};

/// Greatest geometric standard deviation of a log-normal distribution; a wider one is a slip.
constexpr double widest_log_normal = 1e6;

/// Keys of a variable whose numbers have its dimension.
constexpr std::array<std::string_view, 8> keys_of_numbers{
    "from", "to", "mode", "mean", "median", "standard_deviation", "minimum", "maximum"};

/// One variable of the spec with what its numbers measure.
class VariableReader {
  public:
    VariableReader(const View& node, Dimension dimension) : node_(node), dimension_(dimension) {}

    [[nodiscard]] Distribution read() const {
        const int kinds = int{node_.has("values")} + int{node_.has("grid")} + int{node_.has("distribution")};
        if (kinds != 1)
            node_.fail("does not say in one way how it varies", "one of values, grid, distribution");
        require_same_units();
        if (node_.has("values")) return read_values();
        if (node_.has("grid")) return read_grid();
        const std::string kind = node_.at("distribution").text();
        if (kind == "uniform") return read_range<Uniform>(kind);
        if (kind == "log-uniform") return read_range<LogUniform>(kind);
        if (kind == "normal") return read_normal();
        return kind == "log-normal" ? read_log_normal() : read_triangular();
    }

  private:
    /// Refuses a number other than zero without a unit beside one that has a unit: it may be meant in that.
    void require_same_units() const {
        if (dimension_ == Dimension::fraction || node_.has("unit")) return;
        std::vector<View> numbers;
        for (const auto& [key, value] : node_.members())
            if (value.json().is_array())
                std::ranges::copy(value.elements(), std::back_inserter(numbers));
            else if (std::ranges::find(keys_of_numbers, key) != keys_of_numbers.end())
                numbers.push_back(value);
        const auto is_bare = [](const View& number) {
            return number.json().is_number() || (number.is_string() && read_number(number.text()));
        };
        if (std::ranges::all_of(numbers, is_bare)) return;
        for (const View& number : numbers)
            if (is_bare(number) && number.number(dimension_) != 0)
                number.fail("has no unit, beside a number that has one",
                            "a unit for each, or for none, which then are SI");
    }

    /// Refuses keys of other kinds, which would be ignored.
    void allow(const std::string& kind, const std::vector<std::string>& keys) const {
        for (const auto& [key, value] : node_.members())
            if (std::find(keys.begin(), keys.end(), key) == keys.end())
                value.fail("means nothing for " + kind, joined(keys));
    }

    [[nodiscard]] double at(const char* key) const {
        if (!node_.has(key))
            node_.fail(in_quotes(key) + " is missing", with_article(dimension_name(dimension_)));
        return computable(node_.at(key));
    }

    /// A number that is zero or far from the limits of double precision, of either sign.
    [[nodiscard]] double computable(const View& node) const {
        const double value = node.certain_number(dimension_, varies_instead);
        if (value != 0 && !is_computable(std::abs(value)))
            node.fail("is " + shortest(value) + " " + std::string(si_unit(dimension_)),
                      "0, or " + std::string(computable_range) + " in SI");
        return value;
    }

    [[nodiscard]] double at(const char* key, double otherwise) const {
        return node_.has(key) ? computable(node_.at(key)) : otherwise;
    }

    void require_order(bool in_order, const char* allowed) const {
        if (!in_order) node_.fail("its numbers are not in order", allowed);
    }

    [[nodiscard]] Distribution read_values() const {
        allow("values", {"values", "unit"});
        Choice choice;
        if (node_.has("unit"))
            choice.values = node_.column(dimension_);
        else
            for (const View& value : node_.at("values").elements())
                choice.values.push_back(value.certain_number(dimension_, varies_instead));
        return choice;
    }

    [[nodiscard]] Distribution read_grid() const {
        allow("a grid", {"grid", "from", "to", "points"});
        const bool logarithmic = node_.at("grid").text() == "logarithmic";
        const double from = at("from");
        const double to = at("to");
        if (!node_.has("points")) node_.fail("\"points\" is missing", "2 to 10000000");
        const int points = node_.at("points").integer();
        require_order(from < to, "from < to");
        if (logarithmic) require_order(from > 0, "0 < from < to");
        return Choice{logarithmic ? logarithmic_grid(from, to, points) : linear_grid(from, to, points)};
    }

    template <class Range>
    [[nodiscard]] Distribution read_range(const std::string& kind) const {
        constexpr bool positive = std::is_same_v<Range, LogUniform>;
        allow(in_quotes(kind), {"distribution", "from", "to"});
        const Range range{at("from"), at("to")};
        require_order(range.from < range.to && (!positive || range.from > 0),
                      positive ? "0 < from < to" : "from < to");
        return range;
    }

    [[nodiscard]] Distribution read_normal() const {
        allow("\"normal\"", {"distribution", "mean", "standard_deviation", "minimum", "maximum"});
        Normal normal{at("mean"), at("standard_deviation")};
        require_order(normal.standard_deviation > 0, "standard_deviation > 0");
        normal.minimum = at("minimum", normal.minimum);
        normal.maximum = at("maximum", normal.maximum);
        require_order(normal.minimum < normal.maximum, "minimum < maximum");
        require_mass((normal.minimum - normal.mean) / normal.standard_deviation,
                     (normal.maximum - normal.mean) / normal.standard_deviation);
        return normal;
    }

    [[nodiscard]] Distribution read_log_normal() const {
        constexpr auto spread = "geometric_standard_deviation";
        allow("\"log-normal\"", {"distribution", "median", spread, "minimum", "maximum"});
        if (!node_.has(spread)) node_.fail(in_quotes(spread) + " is missing", "a number above 1");
        if (const View given = node_.at(spread); given.is_string() && given.text().ends_with('%')) {
            const double share = given.number(Dimension::fraction);
            given.fail(fmt::format("is {}, the factor {} or one more, {}", in_quotes(given.text()),
                                   shortest(share), shortest(1 + share)),
                       "the factor: a number above 1");
        }
        LogNormal normal{at("median"), node_.at(spread).number(Dimension::fraction)};
        const double deviation = normal.geometric_standard_deviation;
        require_order(normal.median > 0, "median > 0");
        if (!(deviation > 1 && deviation <= widest_log_normal))
            node_.at(spread).fail("is " + shortest(deviation), "a number above 1, at most 1e6");
        normal.minimum = at("minimum", normal.minimum);
        normal.maximum = at("maximum", normal.maximum);
        require_order(0 <= normal.minimum && normal.minimum < normal.maximum, "0 <= minimum < maximum");
        require_mass(std::log(normal.minimum / normal.median) / std::log(deviation),
                     std::log(normal.maximum / normal.median) / std::log(deviation));
        return normal;
    }

    /// Beyond 30 standard deviations nothing is left to draw from.
    void require_mass(double lower, double upper) const {
        if (lower > 30 || upper < -30)
            node_.fail("minimum and maximum cut off all of it", "limits that leave a part");
    }

    [[nodiscard]] Distribution read_triangular() const {
        allow("\"triangular\"", {"distribution", "from", "mode", "to"});
        const Triangular triangular{at("from"), at("mode"), at("to")};
        require_order(triangular.from <= triangular.mode && triangular.mode <= triangular.to &&
                          triangular.from < triangular.to,
                      "from <= mode <= to, from < to");
        return triangular;
    }

    const View& node_;
    Dimension dimension_;
};

/// Refuses a variable that gives, however rarely, a value no impact may have.
void check_values(const View& node, const Distribution& distribution, ImpactInput input,
                  Dimension dimension) {
    std::vector<double> values{0x1p-53, 1 - 0x1p-53};  // beyond, no point of a sweep is
    to_quantiles(distribution, values);
    if (const auto* choice = std::get_if<Choice>(&distribution)) values = choice->values;
    at_place(node.pointer(), [&] {
        for (const double value : values) require_allowed(input, value, dimension);
    });
}

void check_sign(const View& node, const Distribution& distribution, ImpactInput input, Dimension dimension) {
    const double lowest = support_of(distribution).lowest;
    const bool open = std::holds_alternative<LogNormal>(distribution);  // comes near zero, never there
    if (lowest > 0 || (lowest == 0 && (open || may_be_zero(input)))) return;
    const std::string sign = may_be_zero(input) ? "not negative" : "positive";
    if (std::isinf(lowest))
        node.fail("a normal distribution reaches below zero", "a \"minimum\" that is " + sign);
    node.fail("reaches down to " + shortest(lowest) + " " + std::string(si_unit(dimension)),
              "values that are " + sign);
}

}  // namespace

std::size_t impact_input_count() {
    return inputs().size();
}

ImpactInput input_of(const LawParameter& parameter) {
    return impact_input_named(parameter.name);
}

std::string_view name_of(ImpactInput input) {
    return entry_of(input).name;
}

ImpactInput impact_input_named(std::string_view name) {
    const auto found = std::ranges::find(inputs(), name, &InputEntry::name);
    if (found == inputs().end()) throw std::logic_error("the schema of a sweep allows " + std::string(name));
    return static_cast<ImpactInput>(found - inputs().begin());
}

Dimension dimension_of(ImpactInput input, DampingLaw law) {
    return input == ImpactInput::damping ? dimension_of(law) : entry_of(input).dimension;
}

bool may_be_zero(ImpactInput input) {
    return entry_of(input).may_be_zero;
}

void require_allowed(ImpactInput input, double value, Dimension dimension) {
    const auto place = static_cast<std::size_t>(input);
    if (place >= own_inputs.size())
        return require_allowed(law_parameters()[place - own_inputs.size()], value);
    if (input == ImpactInput::angle && !(value < std::numbers::pi / 2))
        throw InputError("angle is " + shortest(value) + " rad", "0 to below 90 degrees, from the normal");
    (may_be_zero(input) ? require_not_negative : require_positive)(name_of(input), value, dimension);
}

Dimension dimension_of(Observable observable) {
    return observable_entries.at(static_cast<std::size_t>(observable)).dimension;
}

const char* description_of(Observable observable) {
    return observable_entries.at(static_cast<std::size_t>(observable)).description;
}

bool captures_count(Observable observable) {
    return observable != Observable::contact_time;
}

Distribution read_variable(const View& node, ImpactInput input, DampingLaw damping_law) {
    const Dimension dimension = dimension_of(input, damping_law);
    Distribution distribution = VariableReader(node, dimension).read();
    check_sign(node, distribution, input, dimension);
    check_values(node, distribution, input, dimension);
    return distribution;
}

}  // namespace ashimpact
