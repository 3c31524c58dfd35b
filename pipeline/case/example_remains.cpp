// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/example_remains.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/json/document.hpp"
#include "pipeline/files/sha256.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view example_folder = "cases/example/";
constexpr std::string_view first_words = "A case of ashimpact. ";  // of the example's comments

Json example_case() {
    return parse_json(embedded_file(std::string(example_folder) + "case.json").value());
}

bool same_member(const Json& ours, const Json& theirs, const std::string& key) {
    return ours.contains(key) && theirs.contains(key) && ours.at(key) == theirs.at(key);
}

/// Adds what a sample shares with the one of the example in its place, other than names.
void add_sample(const Json& ours, const Json& theirs, const std::string& place,
                std::vector<std::string>& remains) {
    for (const auto& [key, value] : ours.items()) {
        if (key == "name") continue;
        if (key == "composition" && value.is_object()) {
            for (const char* part : {"amorphous", "weight_fractions"})
                if (theirs.contains(key) && same_member(value, theirs.at(key), part))
                    remains.push_back(fmt::format("{}/{}/{}", place, key, part));
        } else if (key == "restitution" && value.is_object() && value.contains("file")) {
            continue;  // the file was replaced, or the whole case is the example
        } else if (same_member(ours, theirs, key)) {
            remains.push_back(fmt::format("{}/{}", place, key));
        }
    }
}

/// The files beside the example's case that a case reads unchanged.
std::vector<std::string> same_files(const std::vector<InputFile>& inputs) {
    std::vector<std::string> names;
    for (const InputFile& input : inputs) {
        const std::string name = std::filesystem::path(input.file).filename().string();
        const auto bytes = embedded_file(std::string(example_folder) + name);
        if (bytes && name != "case.json" && input.sha256 == sha256(*bytes)) names.push_back(name);
    }
    return names;
}

}  // namespace

std::vector<std::string> example_remains(const Json& ours, std::string_view text,
                                         const std::vector<InputFile>& inputs) {
    const Json theirs = example_case();
    const bool began_as_example =
        text.find(first_words) != std::string_view::npos || same_member(ours, theirs, "camera");
    if (!began_as_example) return {};
    std::vector<std::string> remains = same_files(inputs);
    if (ours == theirs && remains.size() == 2) return {};
    for (const char* key : {"name", "wall", "work_of_adhesion", "camera"})
        if (same_member(ours, theirs, key)) remains.push_back(std::string("/") + key);
    const Json& samples = theirs.at("samples");
    const std::size_t count = std::min(ours.at("samples").size(), samples.size());
    for (std::size_t i = 0; i < count; ++i)
        add_sample(ours.at("samples")[i], samples[i], "/samples/" + std::to_string(i), remains);
    return remains;
}

}  // namespace ashimpact
