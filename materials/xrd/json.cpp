// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/composition_json.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

namespace {

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
