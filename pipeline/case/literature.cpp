// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/literature.hpp"

#include "core/embedded.hpp"
#include "core/json/view.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view measured_folder = "measured/";
constexpr std::string_view literature_ending = ".json";

std::string text_at(const View& node, std::string_view key) {
    const auto text = node.find(key);
    return text ? text->text() : std::string();
}

LiteratureVelocity read_literature_velocity(const View& node) {
    LiteratureVelocity velocity{.name = node.at("name").text(),
                                .particle = node.at("particle").text(),
                                .wall = node.at("wall").text(),
                                .conditions = text_at(node, "conditions"),
                                .basis = named<VelocityBasis>(node.at("basis").text())};
    if (const auto diameter = node.find("diameter")) velocity.diameter = diameter->number(Dimension::length);
    const View value = node.at("velocity");
    velocity.upper = (value.is_object() ? value.at("to") : value).number(Dimension::velocity);
    if (!value.is_object())
        velocity.lower = velocity.upper;
    else if (const auto from = value.find("from"))
        velocity.lower = from->number(Dimension::velocity);
    return velocity;
}

LiteratureSource read_literature_source(const std::string& key, std::string_view text) {
    const Json document = parse_json(text);  // by its schema, as a test makes sure
    const View root(document);
    LiteratureSource source{.key = key,
                            .reference = root.at("reference").text(),
                            .doi = text_at(root, "doi"),
                            .read = root.at("read").text(),
                            .missing = root.at("missing").texts()};
    if (const auto exponent = root.find("exponent")) source.exponent = exponent->number(Dimension::fraction);
    for (const View& each : root.at("velocities").elements())
        source.velocities.push_back(read_literature_velocity(each));
    return source;
}

}  // namespace

const std::vector<LiteratureSource>& literature() {
    static const std::vector<LiteratureSource> sources = [] {
        std::vector<LiteratureSource> all;
        for (const std::string_view path : embedded_files(measured_folder)) {
            const std::string_view file = path.substr(measured_folder.size());
            const std::string key(file.substr(0, file.size() - literature_ending.size()));
            all.push_back(at_place(FileName{std::string(path)},
                                   [&] { return read_literature_source(key, embedded_file(path).value()); }));
        }
        return all;
    }();
    return sources;
}

const LiteratureSource& literature_source(std::string_view key) {
    std::vector<std::string> keys;
    for (const LiteratureSource& source : literature()) {
        if (source.key == key) return source;
        keys.push_back(source.key);
    }
    throw InputError("no source is called " + in_quotes(key) + did_you_mean(key, keys), joined(keys));
}

}  // namespace ashimpact
