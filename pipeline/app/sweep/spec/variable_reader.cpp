// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/variable_reader.hpp"

#include <cmath>
#include <optional>

#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

/// Greatest geometric standard deviation of a log-normal distribution; a wider one is a slip.
constexpr double widest_log_normal = 1e6;

/// One variable of the spec with what its numbers measure.
class VariableReader {
  public:
    VariableReader(const View& node, Dimension dimension) : node_(node), dimension_(dimension) {}

    [[nodiscard]] Distribution read() const {
        const int kinds = int{node_.has("values")} + int{node_.has("grid")} + int{node_.has("distribution")};
        if (kinds != 1)
            node_.fail("does not say in one way how it varies", "one of values, grid, distribution");
        if (node_.has("values")) return read_values();
        if (node_.has("grid")) return read_grid();
        const std::string kind = node_.at("distribution").text();
        if (kind == "uniform") return read_uniform();
        if (kind == "log-uniform") return read_log_uniform();
        if (kind == "normal") return read_normal();
        if (kind == "log-normal") return read_log_normal();
        return read_triangular();
    }

  private:
    /// Refuses keys of other kinds, which would be ignored.
    void allow(const std::string& kind, std::initializer_list<std::string_view> keys) const {
        for (const auto& [key, value] : node_.members()) {
            bool allowed = false;
            std::vector<std::string> names;
            for (const std::string_view each : keys) {
                allowed = allowed || each == key;
                names.emplace_back(each);
            }
            if (!allowed) value.fail("means nothing for " + kind, joined(names));
        }
    }

    [[nodiscard]] double at(const char* key) const {
        if (!node_.has(key))
            node_.fail(in_quotes(key) + " is missing", with_article(dimension_name(dimension_)));
        return computable(node_.at(key));
    }

    /// A number that is zero or far from the limits of double precision, of either sign.
    [[nodiscard]] double computable(const View& node) const {
        const double value = node.number(dimension_);
        if (value != 0 && !is_computable(std::abs(value)))
            node.fail("is " + shortest(value) + " " + std::string(si_unit(dimension_)),
                      "0, or " + std::string(computable_range) + " in SI");
        return value;
    }

    [[nodiscard]] std::optional<double> find(const char* key) const {
        const auto value = node_.find(key);
        if (!value) return std::nullopt;
        return computable(*value);
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
                choice.values.push_back(value.number(dimension_));
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

    [[nodiscard]] Distribution read_uniform() const {
        allow("\"uniform\"", {"distribution", "from", "to"});
        const Uniform uniform{at("from"), at("to")};
        require_order(uniform.from < uniform.to, "from < to");
        return uniform;
    }

    [[nodiscard]] Distribution read_log_uniform() const {
        allow("\"log-uniform\"", {"distribution", "from", "to"});
        const LogUniform uniform{at("from"), at("to")};
        require_order(0 < uniform.from && uniform.from < uniform.to, "0 < from < to");
        return uniform;
    }

    [[nodiscard]] Distribution read_normal() const {
        allow("\"normal\"", {"distribution", "mean", "standard_deviation", "minimum", "maximum"});
        Normal normal{at("mean"), at("standard_deviation")};
        require_order(normal.standard_deviation > 0, "standard_deviation > 0");
        normal.minimum = find("minimum").value_or(normal.minimum);
        normal.maximum = find("maximum").value_or(normal.maximum);
        require_order(normal.minimum < normal.maximum, "minimum < maximum");
        require_mass((normal.minimum - normal.mean) / normal.standard_deviation,
                     (normal.maximum - normal.mean) / normal.standard_deviation);
        return normal;
    }

    [[nodiscard]] Distribution read_log_normal() const {
        allow("\"log-normal\"",
              {"distribution", "median", "geometric_standard_deviation", "minimum", "maximum"});
        if (!node_.has("geometric_standard_deviation"))
            node_.fail("\"geometric_standard_deviation\" is missing", "a number above 1");
        LogNormal normal{at("median"), node_.at("geometric_standard_deviation").number(Dimension::fraction)};
        require_order(normal.median > 0, "median > 0");
        if (!(normal.geometric_standard_deviation > 1 &&
              normal.geometric_standard_deviation <= widest_log_normal))
            node_.at("geometric_standard_deviation")
                .fail("is " + shortest(normal.geometric_standard_deviation), "a number above 1, at most 1e6");
        normal.minimum = find("minimum").value_or(normal.minimum);
        normal.maximum = find("maximum").value_or(normal.maximum);
        require_order(0 <= normal.minimum && normal.minimum < normal.maximum, "0 <= minimum < maximum");
        const double spread = std::log(normal.geometric_standard_deviation);
        require_mass(std::log(normal.minimum / normal.median) / spread,
                     std::log(normal.maximum / normal.median) / spread);
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

Distribution read_variable(const View& node, ImpactInput input, DampingLaw damping_law) {
    const Dimension dimension = dimension_of(input, damping_law);
    Distribution distribution = VariableReader(node, dimension).read();
    check_sign(node, distribution, input, dimension);
    check_values(node, distribution, input, dimension);
    return distribution;
}

}  // namespace ashimpact
