#include <cmath>
#include <optional>
#include <set>

#include "materials/base/json_lines.hpp"
#include "materials/base/quantity.hpp"
#include "materials/base/text.hpp"
#include "materials/base/view.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

namespace {

Quantity read_fraction(const View& node) {
    Quantity fraction = node.quantity(Dimension::fraction);
    if (!(fraction.value >= 0 && fraction.value <= 1))
        node.fail("the fraction is " + shortest(fraction.value), "0 to 1 (0 % to 100 %)");
    return fraction;
}

Amorphous read_amorphous_word(const View& node) {
    const std::string word = node.text();
    if (word == "none") return AmorphousNone{};
    if (word == "remainder") return AmorphousRemainder{};
    node.fail("the amorphous part is " + in_quotes(word), R"("none", "remainder", or an object)");
}

/// {"weight_fraction"}, {"volume_fraction"} or {"crystalline_total"}
Amorphous read_amorphous_object(const View& node) {
    node.require_keys({"weight_fraction", "volume_fraction", "crystalline_total"});
    const auto members = node.members();
    if (members.size() != 1)
        node.fail("the amorphous part is stated " + std::to_string(members.size()) + " times",
                  "one of weight_fraction, volume_fraction, crystalline_total");
    const std::string& key = members.front().key;
    const Quantity value = read_fraction(members.front().value);
    if (key == "crystalline_total")
        return CrystallineTotal{.value = value.value, .standard_uncertainty = value.standard_uncertainty};
    return AmorphousFraction{
        .value = value.value,
        .standard_uncertainty = value.standard_uncertainty,
        .basis = key == "weight_fraction" ? FractionBasis::weight : FractionBasis::volume};
}

Amorphous read_amorphous(const View& node) {
    return node.is_string() ? read_amorphous_word(node) : read_amorphous_object(node);
}

/// A phase with its fraction; the key tells the basis, which must be the same for all.
struct JsonPhase {
    PhaseFraction phase;
    FractionBasis basis = FractionBasis::weight;
};

JsonPhase read_phase(const View& node) {
    node.require_keys({"name", "weight_fraction", "volume_fraction", "density"});
    const bool by_weight = node.has("weight_fraction");
    if (by_weight == node.has("volume_fraction"))
        node.fail("not exactly one fraction", "weight_fraction or volume_fraction");
    const Quantity fraction = read_fraction(node.at(by_weight ? "weight_fraction" : "volume_fraction"));
    JsonPhase result{.phase = {.name = node.at("name").text(),
                               .fraction = fraction.value,
                               .standard_uncertainty = fraction.standard_uncertainty,
                               .place = node.pointer()},
                     .basis = by_weight ? FractionBasis::weight : FractionBasis::volume};
    if (const auto density = node.find("density")) result.phase.density = density->number(Dimension::density);
    return result;
}

PeakIntensity read_peak(const View& node) {
    node.require_keys({"name", "intensity", "rir"});
    const Quantity intensity = node.at("intensity").quantity(Dimension::fraction);
    const Quantity ratio = node.at("rir").quantity(Dimension::fraction);
    return {.name = node.at("name").text(),
            .intensity = intensity.value,
            .reference_intensity_ratio = ratio.value,
            .intensity_uncertainty = intensity.standard_uncertainty,
            .ratio_uncertainty = ratio.standard_uncertainty};
}

void refuse_repeated(const std::vector<PhaseFraction>& phases) {
    std::set<std::string> keys;
    for (const PhaseFraction& phase : phases)
        if (!keys.insert(phase_key(phase.name)).second)
            throw InputError("the phase " + in_quotes(phase.name) + " is there twice", "each phase once")
                .at(phase.place);
}

void read_phases(const View& list, Analysis& analysis) {
    for (const View& node : list.elements()) {
        const JsonPhase phase = read_phase(node);
        if (!analysis.phases.empty() && phase.basis != analysis.basis)
            node.fail("fractions by weight and by volume in one sample", "one of the two");
        analysis.basis = phase.basis;
        analysis.phases.push_back(phase.phase);
    }
}

void read_peaks(const View& list, Analysis& analysis) {
    const auto nodes = list.elements();
    std::vector<PeakIntensity> peaks;
    for (const View& node : nodes) peaks.push_back(read_peak(node));
    analysis.phases = list.located([&] { return adiabatic_fractions(peaks); });
    for (std::size_t i = 0; i < nodes.size(); ++i) analysis.phases[i].place = nodes[i].pointer();
}

XrdSample with_standard(const XrdSample& sample, const View& standard, bool amorphous_stated) {
    standard.require_keys({"phase", "weight_fraction"});
    if (amorphous_stated)
        standard.fail("an internal standard gives the amorphous part, which is stated too", "one of the two");
    const Quantity added = read_fraction(standard.at("weight_fraction"));
    const std::string phase = standard.at("phase").text();
    return standard.located(
        [&] { return with_internal_standard(sample, phase, added.value, added.standard_uncertainty); });
}

XrdSample read_sample(const View& node) {
    node.require_keys({"name", "phases", "peaks", "amorphous", "internal_standard"});
    XrdSample sample{.name = node.at("name").text()};
    if (node.has("phases") == node.has("peaks")) node.fail("not exactly one result", "phases or peaks");
    if (const auto phases = node.find("phases")) read_phases(*phases, sample.analysis);
    if (const auto peaks = node.find("peaks")) read_peaks(*peaks, sample.analysis);
    refuse_repeated(sample.analysis.phases);
    double total = 0;
    for (const PhaseFraction& phase : sample.analysis.phases) total += phase.fraction;
    if (total > 1 + default_closure_tolerance)
        node.at("phases").fail("the fractions add up to " + shortest(std::round(total * 1e4) / 100) + " %",
                               "100 % or less");
    if (const auto amorphous = node.find("amorphous")) sample.analysis.amorphous = read_amorphous(*amorphous);
    const auto standard = node.find("internal_standard");
    return standard ? with_standard(sample, *standard, node.has("amorphous")) : sample;
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
