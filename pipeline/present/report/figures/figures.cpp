// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact::report {

namespace {

constexpr std::array<std::pair<std::string_view, double>, 11> prefixes{{{"T", 1e12},
                                                                        {"G", 1e9},
                                                                        {"M", 1e6},
                                                                        {"k", 1e3},
                                                                        {"", 1},
                                                                        {"m", 1e-3},
                                                                        {"µ", 1e-6},
                                                                        {"n", 1e-9},
                                                                        {"p", 1e-12},
                                                                        {"f", 1e-15},
                                                                        {"a", 1e-18}}};

constexpr std::array<std::string_view, 5> prefixed{"Pa", "m", "s", "N", "J"};

}  // namespace

const std::vector<FigureMaker>& figure_makers() {
    static const std::vector<FigureMaker> makers{
        {"critical-velocity", critical_velocity_figure},
        {"sensitivity", sensitivity_figure},
        {"composition", composition_figure},
        {"static-force", static_force_figure},
        {"regime-map", regime_map_figure},
        {"restitution", restitution_figure},
        {"damping", damping_figure},
        {"damping-fit", damping_fit_figure},
        {"contact-time", contact_time_figure},
        {"sizes", sizes_figure},
        {"histories", histories_figure},
        {"energy", energy_figure},
    };
    return makers;
}

Figure figure_named(std::string_view id, const RunData& run) {
    std::vector<std::string> ids;
    for (const FigureMaker& maker : figure_makers()) {
        if (maker.id == id) return maker.make(run);
        ids.emplace_back(maker.id);
    }
    throw InputError("no figure is called " + in_quotes(id) + did_you_mean(id, ids), joined(ids));
}

Axis quantity_axis(std::string label, std::string_view si, double greatest) {
    Axis axis{.label = std::move(label), .unit = std::string(si)};
    const auto in = [&](std::string unit, double scale) {
        axis.unit = std::move(unit);
        axis.scale = scale;
        return axis;
    };
    if (si == "1") return in("", 1);
    if (si == "kg/s" && greatest > 0 && greatest < 0.1)
        return greatest < 1e-4 ? in("mg/s", 1e-6) : in("g/s", 1e-3);
    if (!(greatest > 0) || std::ranges::find(prefixed, si) == prefixed.end()) return axis;
    for (const auto& [name, scale] : prefixes)
        if (greatest >= scale) return in(std::string(name) + axis.unit, scale);
    return axis;
}

double greatest_of(const std::vector<double>& values) {
    double greatest = 0;
    for (const double value : values)
        if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
    return greatest;
}

Look look_of(const LawData& law, bool hollow) {
    return Look::of(law.choice.law.index(), hollow);
}

Cell cell_of(const std::optional<double>& value) {
    return value ? Cell(*value) : Cell(std::string());
}

std::string display_name(std::string_view law) {
    const bool spelled = law.find_first_of("aeiou") == std::string_view::npos;  // an abbreviation
    std::string name;
    bool capital = true;
    for (const char c : law) {
        const bool letter = c >= 'a' && c <= 'z';
        name += letter && (capital || spelled) ? static_cast<char>(c - 'a' + 'A') : c;
        capital = !letter;
    }
    return name;
}

std::optional<double> LawData::extrapolated() const {
    if (velocity == nullptr || !velocity->extrapolated) return std::nullopt;
    return velocity->extrapolated->velocity.value;
}

const ModelCurve& LawData::curve() const {
    static const ModelCurve none;
    return drawn != nullptr ? drawn->impacts : none;
}

RunData::RunData(Run run, std::string label) : label_(std::move(label)), run_(std::move(run)) {
    for (std::size_t i = 0; i < run_.data.samples.size(); ++i) {
        SampleData sample{.sample = &run_.data.samples[i],
                          .modulus = &run_.modulus.samples.at(i),
                          .contact = &run_.contact.samples.at(i),
                          .analytic = &run_.analytic.samples.at(i),
                          .velocity = &run_.critical_velocity.samples.at(i),
                          .comparison = &run_.comparison.samples.at(i)};
        for (const LawChoice& choice : run_.data.laws)
            sample.laws.push_back({.choice = choice,
                                   .name = display_name(choice.law.name()),
                                   .measured = run_.restitution.samples.at(i).of(choice.law),
                                   .damping = run_.damping.samples.at(i).laws.find(choice.law),
                                   .fit = run_.fit.samples.at(i).laws.find(choice.law),
                                   .velocity = sample.velocity->laws.find(choice.law),
                                   .compared = sample.comparison->laws.find(choice.law),
                                   .histories = run_.histories.samples.at(i).laws.find(choice.law),
                                   .drawn = run_.histories.samples.at(i).curves.find(choice.law)});
        samples_.push_back(std::move(sample));
    }
}

std::string RunData::damping_unit() const {
    return std::string(unit_of(run_.data.damping_law));
}

}  // namespace ashimpact::report
