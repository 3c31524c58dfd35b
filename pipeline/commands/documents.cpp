#include "pipeline/commands/documents.hpp"

#include <filesystem>
#include <ostream>

#include "data/embedded.hpp"
#include "materials/text.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/json/schema.hpp"
#include "pipeline/json/writer.hpp"
#include "pipeline/text/artifact_text.hpp"

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

}  // namespace

void run_inspect_command(const std::string& file, std::ostream& out) {
    const std::string bytes = read_file(file);
    in_file(file, [&] {
        const Json document = parse_json(bytes);
        validate_document(document, schema_of_artifact(document));
        out << artifact_text(document);
    });
}

void run_init_command(const std::string& folder, std::ostream& out) {
    std::vector<FileContent> files;
    for (const std::string_view path : embedded_files(example)) {
        const auto place = std::filesystem::path(folder) / path.substr(example.size());
        if (std::filesystem::exists(place))
            throw InputError("is there already", "a folder without a case").in_file(place.string());
        files.push_back({place, std::string(embedded_file(path).value())});
    }
    write_files(files);
    for (const FileContent& file : files) out << file.path.string() << '\n';
    const std::string place = (std::filesystem::path(folder) / "case.json").string();
    out << "Edit it, then: ashimpact run " << place << " -o "
        << (std::filesystem::path(folder) / "results").string() << '\n';
}

void run_schema_command(const std::string& name, std::ostream& out) {
    if (!name.empty()) {
        out << write_json(name == "case" ? schema_with_comments(name) : schema_named(name));
        return;
    }
    for (const std::string& each : schema_names()) out << each << '\n';
}

}  // namespace ashimpact
