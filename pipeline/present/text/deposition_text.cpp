// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/deposition_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"
#include "pipeline/run/deposition.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t most_size_groups = 7;
constexpr std::size_t arcs_together = 3;  ///< in a row: 15 degrees
constexpr double shown_share = 5e-4;      ///< of the mass in a row

std::string share_text(double share) {
    return fmt::format("{:.3g}", 100 * share);
}

/// Three digits, large numbers without an exponent.
std::string plain_number(double value) {
    if (!(value >= 1000 && value < 1e9)) return fmt::format("{:.3g}", value);
    const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
    return fmt::format("{:.0f}", std::round(value / unit) * unit);
}

std::string flux_number(double flux) {
    return plain_number(flux * grams_an_hour);
}

std::string flux_cell(const std::optional<Quantity>& flux) {
    return flux ? flux_number(flux->value) : "-";
}

/// Neighbouring classes together, weighted by mass or by what arrives of them.
struct SizeGroup {
    double from = 0, to = 0, mass = 0, arrives = 0, stays = 0, normal = 0, rebound = 0, flux = 0;
    const DepositedSize* middle = nullptr;
    bool has_flux = false;
};

/// "13.4 to 20.2 um", "below 8.94 um".
std::string size_group_name(const SizeGroup& group) {
    const std::string to = fmt::format("{:.3g} um", group.to * 1e6);
    if (group.from == group.to) return to;
    return group.arrives > 0 ? fmt::format("{:.3g} to {}", group.from * 1e6, to) : "below " + to;
}

/// The mean rebound velocity of a sum over what rebounds; "-" if nothing does or it is not known.
std::string rebound_cell(double sum, double rebounds) {
    return rebounds > 0 && std::isfinite(sum) ? velocity_text(sum / rebounds) : "-";
}

/// Of sizes that are too fine to arrive one group; of the others several.
std::vector<SizeGroup> size_groups(const std::vector<DepositedSize>& sizes) {
    std::vector<SizeGroup> groups;
    const auto arriving = static_cast<std::size_t>(
        std::ranges::find_if(sizes, [](const auto& size) { return size.impaction_efficiency > 0; }) -
        sizes.begin());
    const std::size_t together = (sizes.size() - arriving + most_size_groups - 1) / most_size_groups;
    for (std::size_t i = 0, end = 0; i < sizes.size(); i = end) {
        end = i < arriving ? arriving : std::min(sizes.size(), i + together);
        SizeGroup group{.from = sizes[i].from, .to = sizes[end - 1].to, .middle = &sizes[(i + end) / 2]};
        for (std::size_t k = i; k < end; ++k) {
            const double arrives = sizes[k].mass_fraction * sizes[k].impaction_efficiency;
            group.mass += sizes[k].mass_fraction;
            group.arrives += arrives;
            group.stays += arrives * sizes[k].stick_fraction.value;
            group.normal += arrives * sizes[k].normal_velocity.value_or(0);
            const double rebounds = arrives * (1 - sizes[k].stick_fraction.value);
            if (rebounds > 0) group.rebound += rebounds * sizes[k].rebound.velocity.value_or(std::nan(""));
            if (sizes[k].deposition_flux) group.flux += sizes[k].deposition_flux->value;
            group.has_flux = sizes[k].deposition_flux.has_value();
        }
        if (group.mass >= shown_share) groups.push_back(group);
    }
    return groups;
}

std::string size_group_table(const DepositionResult& result, std::size_t width) {
    TextTable table({"size", "mass %", "arrive %", "v_n", "v_c", "stay %", "v_r", "g/(m2 h)"}, 1);
    for (const SizeGroup& group : size_groups(result.sizes)) {
        const bool any = group.arrives > 0;
        const DepositedSize& middle = *group.middle;
        const std::string threshold = !any                       ? "-"
                                      : middle.critical_velocity ? velocity_text(*middle.critical_velocity)
                                      : middle.stick_fraction.value > 0 ? "all"
                                                                        : "none";
        table.add({size_group_name(group), share_text(group.mass), share_text(group.arrives / group.mass),
                   any ? velocity_text(group.normal / group.arrives) : "-", threshold,
                   any ? share_text(group.stays / group.arrives) : "-",
                   rebound_cell(group.rebound, group.arrives - group.stays),
                   group.has_flux ? flux_number(group.flux) : "-"});
    }
    table.drop_empty_columns();
    return table.text(0, width);
}

std::string angle_table(const DepositionResult& result, std::size_t width) {
    TextTable table({"from the front", "arrives %", "stays % of all", "v_n", "v_r", "g/(m2 h)"}, 1);
    for (std::size_t i = 0; i < result.angles.size(); i += arcs_together) {
        const std::size_t end = std::min(result.angles.size(), i + arcs_together);
        double arrives = 0;
        double stays = 0;
        double normal = 0;
        double rebound = 0;
        double flux = 0;
        for (std::size_t k = i; k < end; ++k) {
            const DepositedArc& arc = result.angles[k];
            arrives += arc.arrives;
            stays += arc.stays;
            normal += arc.arrives * arc.normal_velocity.value_or(0);
            if (arc.arrives > arc.stays)
                rebound += (arc.arrives - arc.stays) * arc.rebound.velocity.value_or(std::nan(""));
            if (arc.deposition_flux) flux += arc.deposition_flux->value / static_cast<double>(end - i);
        }
        const double total = result.total.impaction_efficiency;
        table.add({fmt::format("{:.0f} to {:.0f} deg", result.angles[i].from * 180 / std::numbers::pi,
                               result.angles[end - 1].to * 180 / std::numbers::pi),
                   total > 0 ? share_text(arrives / total) : "-", total > 0 ? share_text(stays / total) : "-",
                   arrives > 0 ? velocity_text(normal / arrives) : "-",
                   rebound_cell(rebound, arrives - stays), result.tube.load ? flux_number(flux) : "-"});
    }
    table.drop_empty_columns();
    return table.text(0, width);
}

std::string assumption_table(const DepositionResult& result, std::size_t width) {
    TextTable table({"assumption", "stay %", "over v_c", "g/(m2 h)"}, 1);
    for (const AssumedDeposition& each : result.assumptions)
        table.add({std::string(name_of(each.basis)), share_text(each.stays.value),
                   share_text(each.stays.span.least) == share_text(each.stays.span.greatest)
                       ? "-"
                       : share_text(each.stays.span.least) + " to " + share_text(each.stays.span.greatest),
                   flux_cell(each.deposition_flux)});
    table.drop_empty_columns();
    return table.text(0, width);
}

}  // namespace

std::string flux_text(double flux) {
    return flux_number(flux) + " g/(m2 h)";
}

std::vector<std::string> deposition_sentences(const DepositionResult& result) {
    const DepositionTotal& total = result.total;
    std::vector<std::string> sentences;
    if (result.measured && total.impaction_efficiency > 0 && total.supported_fraction < enough_supported)
        sentences.push_back(fmt::format(
            "This is outside of what the data support: {} % of the mass that arrives is of the measured "
            "sizes, {}; "
            "for the "
            "rest v_c is an assumption, here {}.",
            share_text(total.supported_fraction), size_range_text(*result.measured), name_of(result.basis)));
    const auto [least, greatest] = total.stick_fraction.span;
    const bool spans = share_text(least) != share_text(greatest);
    constexpr auto span_words = "over the interval of v_c and the assumptions on sizes";
    if (total.deposition_flux)
        sentences.push_back(
            fmt::format("{} of ash stays on the clean tube, as a mean over its circumference{}. That is {} "
                        "g/h on each metre of "
                        "tube.",
                        flux_text(total.deposition_flux->value),
                        spans ? fmt::format("; {} to {} {}", flux_number(total.least_flux->value),
                                            flux_number(total.greatest_flux->value), span_words)
                              : "",
                        plain_number(total.deposition_rate->value * grams_an_hour)));
    sentences.push_back(
        fmt::format("Of the mass that flies at the tube {} % arrives, and {} % of that stays{}{}.",
                    share_text(total.impaction_efficiency), share_text(total.stick_fraction.value),
                    spans ? fmt::format(" ({} to {} %{})", share_text(least), share_text(greatest),
                                        total.deposition_flux ? "" : std::string(" ") + span_words)
                          : "",
                    total.outside_model ? "; " + outside_model_words(*total.outside_model) : ""));
    if (total.rebound.restitution)
        sentences.push_back(
            fmt::format("The rest rebounds with a mean restitution of {:.2g}, at {} normal to the wall ({}).",
                        *total.rebound.restitution, readable(*total.rebound.velocity, "m/s"),
                        result.measured ? "at other sizes as measured at equal v/v_c, an assumption"
                                        : "by the constants given"));
    return sentences;
}

std::string deposition_scope() {
    return "What this is not: it holds for the first layer on one clean tube in a potential flow. There is "
           "no "
           "turbulence, no thermophoresis, no gravity, no growth or shedding of a deposit, no neighbouring "
           "tube, and no change of v_c by the temperatures of gas and tube. Particles are points; those that "
           "rebound leave.";
}

std::string deposition_text(const DepositionResult& result, std::size_t width) {
    std::string text;
    for (const std::string& sentence : deposition_sentences(result))
        text += wrapped(sentence, width, 2) + "\n";
    const TubeConditions& tube = result.tube;
    text += "\n" +
            wrapped(fmt::format("Tube of {} in gas of {} at {} ({}), {}, {}; ash: {}{}; v_c by {}.",
                                readable(tube.diameter, "m"), readable(tube.velocity, "m/s"),
                                readable(tube.temperature, "K"), celsius(tube.temperature),
                                readable(tube.viscosity, "Pa s"), readable(tube.density, "kg/m3"), tube.sizes,
                                tube.load ? ", " + plain_number(1000 * *tube.load) + " g/m3" : "",
                                result.law.name()),
                    width, 2) +
            "\n\nVelocities in m/s, normal to the wall: v_n arrives, v_r rebounds (means).\n\n" +
            size_group_table(result, width) + "\n" + angle_table(result, width);
    if (result.total.half_angle > 0)
        text += fmt::format("Half of what stays lies within {:.0f} degrees of the front.\n",
                            result.total.half_angle * 180 / std::numbers::pi);
    if (result.assumptions.size() > 1)
        text += "\nWhich assumption on v_c matters:\n\n" + assumption_table(result, width);
    return text + "\n" + wrapped(deposition_scope(), width) + "\n";
}

}  // namespace ashimpact
