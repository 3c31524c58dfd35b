// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results/run_artifacts.hpp"

#include <spdlog/spdlog.h>

#include "core/json/writer.hpp"
#include "core/version.hpp"
#include "pipeline/document/results/note_json.hpp"
#include "pipeline/document/run_folder.hpp"
#include "pipeline/document/run_identity.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/files/schema_version.hpp"

namespace ashimpact {

std::string schema_of(std::string_view file) {
    return std::string(file.substr(0, file.rfind('.')));
}

Artifact sealed_artifact(const Envelope& envelope, Json result, const std::string& run) {
    const StageRecord& record = envelope.record;
    Json inputs = Json::array();
    for (const InputFile& input : envelope.inputs)
        inputs.push_back({{"file", input.file}, {"sha256", input.sha256}});
    Json warnings = Json::array();
    Json notes = Json::array();
    for (const Note& note : record.notes) {
        warnings.push_back(text_of(note));
        notes.push_back(to_json(note));
    }
    Json document{{"schema", schema_of(record.file)},
                  {"schema_version", schema_version},
                  {"stage", record.stage},
                  {"provenance",
                   {{"program", "ashimpact"},
                    {"version", program_version()},
                    {"revision", program_revision()},
                    {"inputs", inputs},
                    {"options", envelope.options}}},
                  {"citations", record.citations},
                  {"warnings", std::move(warnings)},
                  {"notes", std::move(notes)},
                  {"result", std::move(result)}};
    if (envelope.rests_on_edit) document["provenance"]["edited"] = true;
    seal(document, run.empty() ? run_identity(document.at("result"), inputs) : run);
    std::string bytes = write_json(document);
    return {record.file, std::move(document), std::move(bytes)};
}

Artifact loaded_artifact(const std::filesystem::path& folder, std::string_view file) {
    const auto path = folder / file;
    std::string bytes = read_file(path);
    return at_place(FileName{path.string()}, [&] {
        Json document = parse_json(bytes);
        require_schema_version(document, true);
        validate_document(document, schema_of(file));
        const bool edited = is_edited(document);
        if (edited) {
            require_possible_result(document);
            spdlog::warn("warning: {}: was edited after ashimpact wrote it; its values count", path.string());
        }
        return Artifact{std::string(file), std::move(document), std::move(bytes), path.string(), edited};
    });
}

Artifacts load_artifacts(const std::filesystem::path& folder, const std::vector<std::string_view>& files) {
    complete_interrupted(folder);
    std::vector<Artifact> of_one_run;
    of_one_run.reserve(files.size());
    for (const std::string_view file : files) of_one_run.push_back(loaded_artifact(folder, file));
    require_one_run(of_one_run);
    Artifacts artifacts;
    for (Artifact& artifact : of_one_run) artifacts.add(std::move(artifact));
    return artifacts;
}

}  // namespace ashimpact
