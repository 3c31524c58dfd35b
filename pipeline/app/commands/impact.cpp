// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/error.hpp"
#include "core/json/writer.hpp"
#include "core/text.hpp"
#include "pipeline/document/files/file.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/document/regime_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/present/text/table.hpp"
#include "solver/motion/explicit_scheme.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

namespace {

Json energy_json(const EnergyLedger& energy) {
    const auto joule = [](double value) { return quantity_json(value, Dimension::energy); };
    return {{"incident", joule(energy.incident)},     {"at_touch", joule(energy.at_touch)},
            {"remaining", joule(energy.remaining)},   {"potential", joule(energy.potential)},
            {"dissipated", joule(energy.dissipated)}, {"plastic", joule(energy.plastic)},
            {"jumps", joule(energy.jumps)},           {"residual", joule(energy.residual)},
            {"minimum", joule(energy.minimum)}};
}

std::string trajectory_csv(const std::vector<TrajectoryPoint>& points) {
    std::string csv =
        "time [s],overlap [m],velocity [m/s],contact_radius [m],repulsive_force [N],attractive_force [N],"
        "damping_force [N]\n";
    for (const TrajectoryPoint& p : points) {
        const char* separator = "";
        for (const double value : {p.time, p.overlap, p.velocity, p.contact_radius, p.repulsive_force,
                                   p.attractive_force, p.damping_force}) {
            csv += separator + shortest(value);
            separator = ",";
        }
        csv += '\n';
    }
    return csv;
}

/// Energies as whole numbers of the last digit shown, so that what a reader adds up adds up.
class EnergyDigits {
  public:
    explicit EnergyDigits(double greatest) {
        constexpr std::array<std::string_view, 9> prefixes{"a", "f", "p", "n", "u", "m", "", "k", "M"};
        const int power = greatest > 0 ? static_cast<int>(std::floor(std::log10(greatest))) : 0;
        const int prefix = std::clamp((power + 18) / 3, 0, static_cast<int>(prefixes.size()) - 1);
        unit_ = std::string(prefixes.at(static_cast<std::size_t>(prefix))) + "J";
        const int unit_power = 3 * prefix - 18;
        decimals_ = std::clamp(3 - (power - unit_power), 0, 9);
        step_ = std::pow(10.0, unit_power - decimals_);
    }
    [[nodiscard]] long long steps(double energy) const { return std::llround(energy / step_); }
    [[nodiscard]] std::string text(long long steps) const {
        return fmt::format("{:.{}f} {}", static_cast<double>(steps) / std::pow(10.0, decimals_), decimals_,
                           unit_);
    }

  private:
    std::string unit_;
    int decimals_ = 0;
    double step_ = 1;
};

struct EnergyTerm {
    std::string_view name;
    long long steps;
};

/// What there is before an impact and where it went, term by term; terms of zero are left out. What rounding
/// leaves over goes to the greatest term after.
void add_energy(TextList& list, const EnergyLedger& energy) {
    const EnergyDigits digits(energy.incident);
    const long long incident = digits.steps(energy.incident);
    const long long at_touch = digits.steps(energy.at_touch);
    std::vector<EnergyTerm> after{{"  dissipated", digits.steps(energy.dissipated)},
                                  {"  spent in yielding", digits.steps(energy.plastic)},
                                  {"  lost in jumps", digits.steps(energy.jumps)},
                                  {"  left in motion", digits.steps(energy.remaining)},
                                  {"  left in the contact", digits.steps(energy.potential)}};
    long long missing = incident + at_touch;
    for (const EnergyTerm& term : after) missing -= term.steps;
    const auto less = [](const EnergyTerm& x, const EnergyTerm& y) { return x.steps < y.steps; };
    std::max_element(after.begin(), after.end(), less)->steps += missing;
    list.add("incident energy", digits.text(incident));
    if (at_touch != 0) list.add("  at first touch", digits.text(at_touch));
    for (const EnergyTerm& term : after)
        if (term.steps != 0) list.add(std::string(term.name), digits.text(term.steps));
}

std::string_view adhesion_words(AdhesionRegime regime) {
    switch (regime) {
        case AdhesionRegime::dmt:
            return "hard contact, the limit of DMT";
        case AdhesionRegime::jkr:
            return "soft contact, the limit of JKR";
        case AdhesionRegime::between:
            return "between the limits of DMT and JKR";
        case AdhesionRegime::none:
            break;
    }
    return "no work of adhesion";
}

}  // namespace

Json impact_json(const Impact& impact, const ImpactResult& result) {
    return {{"law", impact.law.name()},
            {"detachment", name_of(impact.detachment)},
            {"damping_law", name_of(impact.damping.law)},
            {"damping", quantity_json(impact.damping.coefficient, unit_of(impact.damping.law))},
            {"outcome", name_of(result.outcome)},
            {"restitution", quantity_json(result.restitution, Dimension::fraction)},
            {"contact_time", quantity_json(result.contact_time, Dimension::time)},
            {"approach_time", quantity_json(result.approach_time, Dimension::time)},
            {"maximum_overlap", quantity_json(result.maximum_overlap, Dimension::length)},
            {"rebound_velocity", quantity_json(result.rebound_velocity, Dimension::velocity)},
            {"energy", energy_json(result.energy)},
            {"regime", regime_json(regime_of(impact, result.maximum_overlap))}};
}

std::string regime_text(const Regime& regime) {
    const auto velocity = [](const std::optional<double>& value) {
        return value ? readable(*value, "m/s") : std::string("no yield pressure given");
    };
    TextList list;
    list.add("damping number", fmt::format("beta = {}", readable_number(regime.damping_number)));
    list.add("Tabor parameter", regime.tabor_parameter > 0
                                    ? fmt::format("{} ({})", readable_number(regime.tabor_parameter),
                                                  adhesion_words(regime.adhesion))
                                    : "none: no work of adhesion");
    list.add(
        "greatest pressure",
        regime.yield_pressure
            ? fmt::format("{}, {} times the yield pressure of {}", readable(regime.greatest_pressure, "Pa"),
                          readable_number(regime.greatest_pressure / *regime.yield_pressure),
                          readable(*regime.yield_pressure, "Pa"))
            : readable(regime.greatest_pressure, "Pa"));
    list.add("yield velocity", velocity(regime.yield_velocity));
    list.add("contact radius", fmt::format("at most {}, {} of R*", readable(regime.contact_radius, "m"),
                                           readable_number(regime.relative_contact_radius)));
    return list.text(0);
}

void warn_of_regime(const Regime& regime) {
    for (const std::string& warning : regime.warnings) spdlog::warn("warning: {}", warning);
}

std::string impact_text(const Impact& impact, const ImpactResult& result) {
    const auto time = [](const std::optional<double>& value, const char* none) {
        return value ? readable(*value, "s") : std::string(none);
    };
    TextList list;
    list.add("law", fmt::format("{}, contact ends at {}", impact.law.name(), name_of(impact.detachment)));
    list.add("damping",
             fmt::format("{} ({})", readable(impact.damping.coefficient, unit_of(impact.damping.law)),
                         name_of(impact.damping.law)));
    list.add("velocity", readable(impact.velocity, "m/s"));
    list.add("outcome", std::string(name_of(result.outcome)));
    list.add("restitution", readable_number(result.restitution));
    list.add("rebound velocity", readable(result.rebound_velocity, "m/s"));
    list.add("contact time", time(result.contact_time, "none: the particle stays"));
    list.add("approach time", time(result.approach_time, "none: the approach never turns"));
    list.add("maximum overlap", readable(result.maximum_overlap, "m"));
    add_energy(list, result.energy);
    return list.text(0) + regime_text(regime_of(impact, result.maximum_overlap));
}

namespace {

/// How an impact was solved: 0 for the time step of the exact method.
struct Solution {
    ImpactResult result;
    double time_step;
};

Solution solve(const ImpactOptions& options, const Impact& impact) {
    constexpr double steps = 1e4;
    if (options.method == "taylor") {
        if (!options.time_step.empty())
            throw InputError("belongs to the explicit method", "--method paper-explicit").at("--time-step");
        return {solve_impact(impact), 0};
    }
    if (options.method != "paper-explicit")
        throw InputError("unknown method " + in_quotes(options.method), "taylor, paper-explicit")
            .at("--method");
    if (!options.trajectory.empty())
        throw InputError("is written by the exact method alone", "--method taylor").at("--trajectory");
    validate(impact);
    const double time_step = options.time_step.empty()
                                 ? explicit_time_step(impact, steps)
                                 : read_positive_option("--time-step", options.time_step, Dimension::time);
    return at_place("--method, --time-step", [&] {
        return Solution{solve_impact_explicit(impact, {.time_step = time_step}), time_step};
    });
}

}  // namespace

void run_impact_command(const ImpactOptions& options, std::ostream& out) {
    const ContactChoice choice = read_contact(options.contact);
    const Impact impact{
        .law = choice.law,
        .detachment = choice.detachment,
        .damping = read_damping(options.contact),
        .contact = choice.contact,
        .velocity = read_positive_option("--velocity", options.velocity, Dimension::velocity)};
    const auto [result, time_step] = solve(options, impact);
    warn_of_regime(regime_of(impact, result.maximum_overlap));
    if (!options.trajectory.empty()) {
        const auto points = trajectory(impact, options.points);
        write_file(options.trajectory, trajectory_csv(points));
        spdlog::info("{}: {} points", options.trajectory, points.size());
    }
    if (!options.json) {
        out << impact_text(impact, result);
        return;
    }
    Json json = impact_json(impact, result);
    json["method"] = options.method;
    if (time_step > 0) json["time_step"] = quantity_json(time_step, Dimension::time);
    out << write_json(json, Digits::seventeen);
}

}  // namespace ashimpact
