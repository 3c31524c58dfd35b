// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/table_texts.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"
#include "materials/xrd/table_headings.hpp"
#include "materials/xrd/xrd.hpp"

namespace ashimpact::xrd {

namespace {

constexpr std::array<std::string_view, 4> ways{"weight_fractions", "volume_fractions", "phases", "peaks"};

/// @param basis that a text may state: "60 wt%", "0.4 m3/m3"
Quantity read_fraction(const View& node, FractionBasis basis) {
    const auto read = [&] {
        if (node.is_string())
            return at_place(node.pointer(), [&] {
                return quantity_of_text(without_basis(node.text(), basis), Dimension::fraction);
            });
        if (!node.is_object() || !node.has("unit")) return node.quantity(Dimension::fraction);
        const std::string one = "1 ";
        const std::string unit = node.at("unit").text();
        Json plain = node.json();
        return at_place(node.pointer(), [&] {
            plain["unit"] = without_basis(one + unit, basis).substr(one.size());
            return View(plain).quantity(Dimension::fraction);
        });
    };
    const Quantity fraction = read();
    if (!(fraction.value >= 0 && fraction.value <= 1))
        node.fail("the fraction is " + per_cent(fraction.value), "0 % to 100 % (0 to 1)");
    return fraction;
}

void require_plain_name(const std::string& name, const View& node) {
    if (has_sign_of_bound(name)) node.fail(in_quotes(name) + " has the sign of a bound", "the name alone");
}

PhaseFraction read_phase(const std::string& name, const View& node, FractionBasis basis,
                         const std::string& place) {
    require_plain_name(name, node);
    const Quantity fraction = read_fraction(node, basis);
    return {.name = name,
            .fraction = fraction.value,
            .standard_uncertainty = fraction.standard_uncertainty,
            .place = place};
}

/// {"quartz": "10 %", ...}
std::vector<PhaseFraction> read_fractions(const View& node, FractionBasis basis) {
    std::vector<PhaseFraction> phases;
    for (const auto& [name, value] : node.members())
        phases.push_back(read_phase(name, value, basis, value.pointer()));
    return phases;
}

double density_of(const View& node) {
    static_cast<void>(node.certain_number(Dimension::density, "a phase of your own under \"phases\" for it"));
    const double density = positive_quantity(node, "density", Dimension::density).value;
    const bool is_bare = node.json().is_number() || (node.json().is_string() && read_number(node.text()));
    if (is_bare)  // where it stands the name of a phase is its key
        static_cast<void>(implausible_at(node.pointer(), *plausible_range("density"), {density, density}));
    return density;
}

/// [{"name", "weight_fraction" or "volume_fraction", "density"}, ...]; the basis is that of all of them.
void read_list(const View& list, Analysis& analysis) {
    for (const View& node : list.elements()) {
        node.require_keys({"name", "weight_fraction", "volume_fraction", "density"});
        const bool by_weight = node.has("weight_fraction");
        if (by_weight == node.has("volume_fraction"))
            node.fail("not exactly one fraction", "weight_fraction or volume_fraction");
        const FractionBasis basis = by_weight ? FractionBasis::weight : FractionBasis::volume;
        if (!analysis.phases.empty() && basis != analysis.basis)
            node.fail("fractions by weight and by volume in one sample", "one of the two");
        analysis.basis = basis;
        analysis.phases.push_back(read_phase(node.at("name").text(),
                                             node.at(by_weight ? "weight_fraction" : "volume_fraction"),
                                             basis, node.pointer()));
        if (const auto density = node.find("density")) analysis.phases.back().density = density_of(*density);
    }
}

PeakIntensity read_peak(const View& node) {
    node.require_keys({"name", "intensity", "rir"});
    require_plain_name(node.at("name").text(), node);
    if (!node.has("rir"))
        node.fail("the peak of " + in_quotes(node.at("name").text()) + " has no \"rir\"",
                  "its reference intensity ratio I/Ic, \"rir\": 3.4; without it \"weight_fractions\"");
    for (const char* key : {"intensity", "rir"}) {
        const View number = node.at(key);
        const bool in_per_cent = number.is_string() && number.text().find('%') != std::string::npos;
        const bool is_uncertain = in_per_cent && number.text().find_first_of("+\xb1(") != std::string::npos;
        if (in_per_cent && (key == std::string_view("rir") || is_uncertain))
            number.fail(in_quotes(number.text()) + " may be per cent, or its uncertainty per cent of it",
                        "numbers without \"%\", \"3.4 +- 0.17\"");
    }
    const Quantity intensity = node.at("intensity").quantity(Dimension::fraction);
    const Quantity ratio = node.at("rir").quantity(Dimension::fraction);
    return {.name = node.at("name").text(),
            .intensity = intensity.value,
            .reference_intensity_ratio = ratio.value,
            .intensity_uncertainty = intensity.standard_uncertainty,
            .ratio_uncertainty = ratio.standard_uncertainty};
}

std::vector<PhaseFraction> read_peaks(const View& list) {
    const auto nodes = list.elements();
    std::vector<PeakIntensity> peaks;
    peaks.reserve(nodes.size());
    for (const View& node : nodes) peaks.push_back(read_peak(node));
    const auto in_per_cent = [](const View& node) {
        const View& intensity = node.at("intensity");
        return intensity.is_string() && intensity.text().find('%') != std::string::npos;
    };
    const auto mixed = std::ranges::count_if(nodes, in_per_cent);
    if (mixed > 0 && mixed < std::ssize(nodes))
        list.fail("some intensities are in % and others are not", "one unit for all");
    auto phases = at_place(list.pointer(), [&] { return adiabatic_fractions(peaks); });
    for (std::size_t i = 0; i < nodes.size(); ++i) phases[i].place = nodes[i].pointer();
    return phases;
}

/// The one key by which the fractions are given.
std::string way_of(const View& node) {
    std::vector<std::string> given;
    for (const std::string_view way : ways)
        if (node.has(way)) given.emplace_back(way);
    if (given.empty()) node.fail("the composition is missing", "one of " + joined(ways));
    if (given.size() > 1)
        node.fail("the composition is given in more than one way: " + given[0] + " and " + given[1],
                  "one of " + joined(ways));
    return given[0];
}

void refuse_repeated(const std::vector<PhaseFraction>& phases) {
    std::set<std::string> keys;
    for (const PhaseFraction& phase : phases)
        if (!keys.insert(phase_key(phase.name)).second)
            throw InputError("the phase " + in_quotes(phase.name) + " is there twice", "each phase once")
                .at(phase.place);
}

void refuse_more_than_all(const View& node, const std::vector<PhaseFraction>& phases) {
    double total = 0;
    for (const PhaseFraction& phase : phases) total += phase.fraction;
    if (total > 1 + default_closure_tolerance)
        node.fail("the fractions add up to " + shortest(std::round(total * 1e4) / 100) + " %",
                  "100 % or less");
}

Amorphous read_amorphous(const View& node, FractionBasis basis) {
    if (node.is_string() && node.text() == "none") return AmorphousNone{};
    if (node.is_string() && node.text() == "remainder") return AmorphousRemainder{};
    if (node.is_string() && node.text().find_first_of("0123456789") == std::string::npos)
        node.fail("the amorphous part is " + in_quotes(node.text()),
                  R"("none", "remainder", a fraction such as "47 %", or an object)");
    if (!node.is_object() || node.has("value")) {
        const Quantity whole = read_fraction(node, basis);
        return AmorphousFraction{whole.value, whole.standard_uncertainty, basis};
    }
    node.require_keys({"weight_fraction", "volume_fraction", "crystalline_total", "remainder_scale"});
    const auto members = node.members();
    if (members.size() != 1)
        node.fail("the amorphous part is stated " + std::to_string(members.size()) + " times",
                  "one of weight_fraction, volume_fraction, crystalline_total, remainder_scale");
    const auto& [key, value] = members.front();
    if (key == "remainder_scale") {
        const Quantity scale = value.quantity(Dimension::fraction);
        return AmorphousRemainder{scale.value, scale.standard_uncertainty};
    }
    if (key != "crystalline_total")
        basis = key == "weight_fraction" ? FractionBasis::weight : FractionBasis::volume;
    const Quantity part = read_fraction(value, basis);
    if (key == "crystalline_total") return CrystallineTotal{part.value, part.standard_uncertainty};
    return AmorphousFraction{part.value, part.standard_uncertainty, basis};
}

/// The phases without the standard, and what is amorphous by it. The older key "weight_fraction" is read too.
Analysis without_standard(const Analysis& analysis, const View& standard) {
    standard.require_keys({"phase", "added_fraction", "weight_fraction"});
    if (standard.has("added_fraction") == standard.has("weight_fraction"))
        standard.fail("the weight of the standard over that of the mixture is not given once",
                      "phase and added_fraction");
    const Quantity added =
        read_fraction(standard.at(standard.has("added_fraction") ? "added_fraction" : "weight_fraction"),
                      FractionBasis::weight);
    const std::string phase = standard.at("phase").text();
    return at_place(standard.pointer(), [&] {
        const XrdSample mixture{.name = {}, .analysis = analysis};
        return with_internal_standard(mixture, phase, added.value, added.standard_uncertainty).analysis;
    });
}

void read_densities(const View& densities, std::vector<PhaseFraction>& phases) {
    for (const auto& [name, value] : densities.members()) {
        const auto named = [key = phase_key(name)](const PhaseFraction& phase) {
            return phase_key(phase.name) == key;
        };
        const auto phase = std::find_if(phases.begin(), phases.end(), named);
        if (phase == phases.end())
            value.fail("is the density of a phase that is not in the composition",
                       "phases of the composition; \"phases\" of a case gives another glass");
        phase->density = density_of(value);
    }
}

XrdSample read_sample(const View& node) {
    node.require_keys({"name", "weight_fractions", "volume_fractions", "phases", "peaks", "densities",
                       "amorphous", "amorphous_phase", "internal_standard"});
    return {.name = node.at("name").text(), .analysis = completed_by_json(read_fractions_json(node), node)};
}

XrdResult read_samples(const View& root) {
    if (!root.is_object()) root.fail("is not an object", "an object with the key samples");
    root.require_keys({"samples"});
    const auto nodes = root.at("samples").elements();
    if (nodes.empty()) root.at("samples").fail("no samples", "at least one");
    XrdResult result{.format = XrdFormat::json, .samples = {}};
    std::set<std::string> names;
    for (const View& node : nodes) {
        XrdSample sample = read_sample(node);
        if (!names.insert(sample.name).second)
            node.fail("the sample " + in_quotes(sample.name) + " is there twice", "each sample once");
        result.samples.push_back(std::move(sample));
    }
    return result;
}

}  // namespace

std::string without_basis(const std::string& text, FractionBasis basis) {
    const auto at = std::min(text.find_first_not_of("+-.,()0123456789eE \u00b1"), text.size());
    std::string_view unit = std::string_view(text).substr(at);
    if (unit.ends_with(')')) unit.remove_suffix(1);
    auto stated = bases_in(text);
    if (unit_of(unit) == HeadingUnit::volume) stated.insert("volume");  // "0.47 m3/m3"
    if (unit_of(unit) == HeadingUnit::weight) stated.insert("weight");
    if (stated.empty()) return text;
    const std::string_view own = basis == FractionBasis::weight ? "weight" : "volume";
    if (stated.size() > 1 || *stated.begin() != own)
        throw InputError(fmt::format("{} is by {}, and the phases are by {}", in_quotes(text),
                                     *stated.rbegin() == own ? *stated.begin() : *stated.rbegin(), own),
                         fmt::format("a fraction by {}", own));
    if (!holds_per_cent(text)) return text;
    std::string plain;  // "47 ± 2 %" of "47 wt% ± 2 wt%"
    std::string_view rest = text;
    for (auto sign = rest.find('%'); sign != std::string_view::npos; sign = rest.find('%')) {
        const std::size_t end = rest.substr(0, sign).find_last_of("0123456789)") + 1;
        const bool has_basis = !trimmed(rest.substr(end, sign - end)).empty();
        if (has_basis && plain.ends_with(" %")) plain.resize(plain.size() - 2);  // both of the whole
        (plain += rest.substr(0, end)) += " %";
        rest.remove_prefix(sign + 1);
    }
    return rest.find_first_of("0123456789") == std::string_view::npos ? plain : plain.append(rest);
}

Analysis read_fractions_json(const View& node) {
    Analysis analysis;
    const std::string way = way_of(node);
    const View given = node.at(way);
    if (way == "volume_fractions") analysis.basis = FractionBasis::volume;
    if (way == "phases")
        read_list(given, analysis);
    else
        analysis.phases = way == "peaks" ? read_peaks(given) : read_fractions(given, analysis.basis);
    refuse_repeated(analysis.phases);
    refuse_more_than_all(given, analysis.phases);
    return analysis;
}

Analysis completed_by_json(Analysis analysis, const View& node) {
    const auto amorphous = node.find("amorphous");
    const auto standard = node.find("internal_standard");
    if (amorphous && standard)
        standard->fail("an internal standard gives the amorphous part, which is stated too",
                       "one of the two");
    if (const auto densities = node.find("densities")) read_densities(*densities, analysis.phases);
    if (amorphous) {
        const Amorphous stated = read_amorphous(*amorphous, analysis.basis);
        at_place(amorphous->pointer(), [&] { analysis.state_amorphous(stated); });
    }
    if (const auto name = node.find("amorphous_phase")) analysis.amorphous_phase = name->text();
    return standard ? without_standard(analysis, *standard) : analysis;
}

bool looks_like_json(const TextLines& file) {
    const std::string_view text = trimmed(file.text());
    return text.starts_with('{') || text.starts_with('[');
}

XrdResult read_json(const TextLines& file) {
    const Json root = parse_json(file.text());
    const JsonLines lines(file.text());
    const auto with_line = [&](const std::string& pointer) { return at_line(lines.line_of(pointer)); };
    try {
        XrdResult result = read_samples(View(root));
        for (XrdSample& sample : result.samples)
            for (PhaseFraction& phase : sample.analysis.phases)
                phase.place = with_line(phase.place) + ": " + phase.place;
        return result;
    } catch (const InputError& error) {
        throw error.at(with_line(error.place()));
    }
}

}  // namespace ashimpact::xrd
