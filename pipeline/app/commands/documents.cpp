// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/documents.hpp"

#include <filesystem>
#include <ostream>

#include <spdlog/spdlog.h>

#include "core/embedded.hpp"
#include "core/json/view.hpp"
#include "core/json/writer.hpp"
#include "core/text.hpp"
#include "pipeline/app/program_word.hpp"
#include "pipeline/document/files/file.hpp"
#include "pipeline/document/run_identity.hpp"
#include "pipeline/document/schema.hpp"
#include "pipeline/present/text/artifact_text.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view example = "cases/example/";

std::string schema_of_artifact(const Json& document) {
    const auto names = schema_names();
    if (document.is_object() && document.contains("schema") && document["schema"].is_string())
        for (const std::string& name : names)
            if (document["schema"] == name && name != "case" && name != "published") return name;
    throw InputError("this is not an artifact of ashimpact",
                     "a file of a run's folder, such as comparison.json")
        .at("/schema");
}

/// Whether a member that stands beside a number, or a list of numbers, is what a reader expects of it.
void require_beside_number(const std::string& key, const View& member) {
    if (key == "unit" || key == "origin") {
        if (!member.json().is_string()) member.fail("is " + member.json().dump(), "a string");
    } else if (key == "standard_uncertainty" && !member.json().is_number()) {
        member.fail("is " + member.json().dump(), "a number");
    }
}

/// Refuses a quantity without a readable unit also where the schemas leave open what stands there.
void require_quantities(const View& node) {
    if (node.json().is_array())
        for (const View& element : node.elements()) require_quantities(element);
    if (!node.is_object()) return;
    const bool quantity =
        node.json().contains("unit") && (node.json().contains("value") || node.json().contains("values"));
    for (const auto& [key, member] : node.members()) {
        if (quantity) require_beside_number(key, member);
        require_quantities(member);
    }
}

}  // namespace

void run_inspect_command(const InspectOptions& options, std::ostream& out) {
    const std::string& file = options.file;
    const std::string bytes = read_file(file);
    at_place(FileName{file}, [&] {
        const Json document = parse_json(bytes);
        validate_document(document, schema_of_artifact(document));
        require_quantities(View(document));
        if (document.at("provenance").contains("result_sha256") && is_edited(document))
            spdlog::warn("warning: {}: was edited after ashimpact wrote it", file);
        out << artifact_text(document, {.result = {.all = options.all},
                                        .provenance = spdlog::should_log(spdlog::level::debug)});
    });
}

void run_init_command(const std::string& folder, std::ostream& out) {
    std::vector<FileContent> files;
    for (const std::string_view path : embedded_files(example)) {
        const auto place = std::filesystem::path(folder) / path.substr(example.size());
        if (std::filesystem::exists(place))
            throw InputError("is there already", "a folder without a case").at(FileName{place.string()});
        files.push_back({place, std::string(embedded_file(path).value())});
    }
    write_files(files);
    for (const FileContent& file : files) out << file.path.string() << '\n';
    const auto typed = [&](const char* name) {
        return shell_word((std::filesystem::path(folder) / name).string());
    };
    out << "An example that runs as it is; your own numbers can replace it later:\n  " << program_word()
        << " run " << typed("case.json") << " -o " << typed("results") << '\n';
}

void run_schema_command(const std::string& name, std::ostream& out) {
    if (!name.empty()) {
        out << write_json(name == "case" ? schema_with_comments(name) : schema_named(name));
        return;
    }
    for (const std::string& each : schema_names()) out << each << '\n';
}

}  // namespace ashimpact
