#include <cmath>
#include <optional>
#include <set>

#include "materials/base/json_input.hpp"
#include "materials/base/json_lines.hpp"
#include "materials/base/quantity.hpp"
#include "materials/base/text.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

namespace {

Quantity read_fraction(const Json& node) {
    Quantity fraction = read_quantity(node, Dimension::fraction);
    if (!(fraction.value >= 0 && fraction.value <= 1))
        throw InputError("the fraction is " + shortest(fraction.value), "0 to 1 (0 % to 100 %)");
    return fraction;
}

Amorphous read_amorphous_word(const std::string& word) {
    if (word == "none") return AmorphousNone{};
    if (word == "remainder") return AmorphousRemainder{};
    throw InputError("the amorphous part is " + in_quotes(word), R"("none", "remainder", or an object)");
}

/// {"weight_fraction"}, {"volume_fraction"} or {"crystalline_total"}
Amorphous read_amorphous_object(const Json& node) {
    require_keys(node, {"weight_fraction", "volume_fraction", "crystalline_total"});
    if (node.size() != 1)
        throw InputError("the amorphous part is stated " + std::to_string(node.size()) + " times",
                         "one of weight_fraction, volume_fraction, crystalline_total");
    const std::string key = node.begin().key();
    const Quantity value = required_member(node, key, read_fraction);
    if (key == "crystalline_total")
        return CrystallineTotal{.value = value.value, .standard_uncertainty = value.standard_uncertainty};
    return AmorphousFraction{
        .value = value.value,
        .standard_uncertainty = value.standard_uncertainty,
        .basis = key == "weight_fraction" ? FractionBasis::weight : FractionBasis::volume};
}

Amorphous read_amorphous(const Json& node) {
    return node.is_string() ? read_amorphous_word(node.get<std::string>()) : read_amorphous_object(node);
}

/// A phase with its fraction; the key tells the basis, which must be the same for all.
struct JsonPhase {
    PhaseFraction phase;
    FractionBasis basis = FractionBasis::weight;
};

JsonPhase read_phase(const Json& node) {
    require_keys(node, {"name", "weight_fraction", "volume_fraction", "density"});
    const bool by_weight = node.contains("weight_fraction");
    if (by_weight == node.contains("volume_fraction"))
        throw InputError("not exactly one fraction", "weight_fraction or volume_fraction");
    const Quantity fraction =
        required_member(node, by_weight ? "weight_fraction" : "volume_fraction", read_fraction);
    JsonPhase result{.phase = {.name = required_member(node, "name", as_string),
                               .fraction = fraction.value,
                               .standard_uncertainty = fraction.standard_uncertainty},
                     .basis = by_weight ? FractionBasis::weight : FractionBasis::volume};
    const auto density =
        optional_member(node, "density", [](const Json& n) { return read_quantity(n, Dimension::density); });
    if (density) result.phase.density = density->value;
    return result;
}

PeakIntensity read_peak(const Json& node) {
    require_keys(node, {"name", "intensity", "rir"});
    const auto number = [](const Json& n) { return read_quantity(n, Dimension::fraction); };
    const Quantity intensity = required_member(node, "intensity", number);
    const Quantity ratio = required_member(node, "rir", number);
    return {.name = required_member(node, "name", as_string),
            .intensity = intensity.value,
            .reference_intensity_ratio = ratio.value,
            .intensity_uncertainty = intensity.standard_uncertainty,
            .ratio_uncertainty = ratio.standard_uncertainty};
}

/// Where a phase of a sample stands; the reader of the samples puts their number in front.
std::string place_in(const char* list, std::size_t index) {
    return "/" + std::string(list) + "/" + std::to_string(index);
}

void refuse_repeated(const std::vector<PhaseFraction>& phases) {
    std::set<std::string> keys;
    for (const PhaseFraction& phase : phases)
        if (!keys.insert(phase_key(phase.name)).second)
            throw InputError("the phase " + in_quotes(phase.name) + " is there twice", "each phase once")
                .at(phase.place);
}

void read_phases(const Json& list, Analysis& analysis) {
    for (std::size_t i = 0; i < as_array(list).size(); ++i) {
        at_place("/" + std::to_string(i), [&] {
            JsonPhase phase = read_phase(list[i]);
            if (i > 0 && phase.basis != analysis.basis)
                throw InputError("fractions by weight and by volume in one sample", "one of the two");
            analysis.basis = phase.basis;
            phase.phase.place = place_in("phases", i);
            analysis.phases.push_back(std::move(phase.phase));
        });
    }
}

void read_peaks(const Json& list, Analysis& analysis) {
    std::vector<PeakIntensity> peaks;
    for (std::size_t i = 0; i < as_array(list).size(); ++i)
        peaks.push_back(at_place("/" + std::to_string(i), [&] { return read_peak(list[i]); }));
    analysis.phases = adiabatic_fractions(peaks);
    for (std::size_t i = 0; i < peaks.size(); ++i) analysis.phases[i].place = place_in("peaks", i);
}

XrdSample read_sample(const Json& node) {
    require_keys(node, {"name", "phases", "peaks", "amorphous", "internal_standard"});
    XrdSample sample{.name = required_member(node, "name", as_string)};
    if (node.contains("phases") == node.contains("peaks"))
        throw InputError("not exactly one result", "phases or peaks");
    optional_member(node, "phases", [&](const Json& n) { return read_phases(n, sample.analysis), true; });
    optional_member(node, "peaks", [&](const Json& n) { return read_peaks(n, sample.analysis), true; });
    refuse_repeated(sample.analysis.phases);
    double total = 0;
    for (const PhaseFraction& phase : sample.analysis.phases) total += phase.fraction;
    if (total > 1 + default_closure_tolerance)
        throw InputError("the fractions add up to " + shortest(std::round(total * 1e4) / 100) + " %",
                         "100 % or less")
            .at("/phases");
    if (const auto amorphous = optional_member(node, "amorphous", read_amorphous))
        sample.analysis.amorphous = *amorphous;
    if (!node.contains("internal_standard")) return sample;
    return at_place("/internal_standard", [&] {
        const Json& standard = node.at("internal_standard");
        require_keys(standard, {"phase", "weight_fraction"});
        if (node.contains("amorphous"))
            throw InputError("an internal standard gives the amorphous part, which is stated too",
                             "one of the two");
        const Quantity added = required_member(standard, "weight_fraction", read_fraction);
        return with_internal_standard(sample, required_member(standard, "phase", as_string), added.value,
                                      added.standard_uncertainty);
    });
}

XrdResult read_samples(const Json& root) {
    if (!root.is_object()) throw InputError("not an object", "an object with the key samples").at("/");
    require_keys(root, {"samples"});
    XrdResult result{.format = XrdFormat::json, .samples = {}};
    const Json& samples = required(root, "samples");
    at_place("/samples", [&] {
        if (as_array(samples).empty()) throw InputError("no samples", "at least one");
        std::set<std::string> names;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const std::string place = "/" + std::to_string(i);
            XrdSample sample = at_place(place, [&] { return read_sample(samples[i]); });
            if (!names.insert(sample.name).second)
                throw InputError("the sample " + in_quotes(sample.name) + " is there twice",
                                 "each sample once")
                    .at(place);
            for (PhaseFraction& phase : sample.analysis.phases) phase.place.insert(0, "/samples" + place);
            result.samples.push_back(std::move(sample));
        }
    });
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
        XrdResult result = read_samples(root);
        for (XrdSample& sample : result.samples)
            for (PhaseFraction& phase : sample.analysis.phases)
                phase.place = with_line(phase.place) + ": " + phase.place;
        return result;
    } catch (const InputError& error) {
        throw error.at(with_line(error.place()));
    }
}

}  // namespace ashimpact::xrd
