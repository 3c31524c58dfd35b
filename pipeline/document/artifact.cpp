// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/artifact.hpp"

#include <algorithm>
#include <stdexcept>

#include <spdlog/spdlog.h>

#include "core/json/writer.hpp"
#include "core/version.hpp"
#include "pipeline/document/fields.hpp"
#include "pipeline/document/run_folder.hpp"
#include "pipeline/document/run_identity.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/files/schema_version.hpp"

namespace ashimpact {

const Artifact& Artifacts::at(std::string_view file) const {
    const auto found = std::ranges::find(artifacts_, file, &Artifact::file);
    if (found != artifacts_.end()) return *found;
    throw std::logic_error("the artifact " + std::string(file) + " was not read");
}

bool Artifacts::has(std::string_view file) const {
    return std::ranges::find(artifacts_, file, &Artifact::file) != artifacts_.end();
}

const std::string& Artifacts::place_of(std::string_view file) const {
    const Artifact& artifact = at(file);
    if (!artifact.place.empty()) return artifact.place;
    const std::string& first = artifacts_.front().place;
    return first.empty() ? artifact.file : first;
}

template <class Io>
void fields(Io& io, Is<Note> auto& note) {
    std::optional<std::string> sample;
    if (!note.sample.empty()) sample = note.sample;
    io("code", note.code);
    io("severity", note.severity);
    io("stage", note.stage);
    io("sample", sample);
    io("law", note.law);
    io("text", note.text);
    if constexpr (Io::reads) note.sample = sample.value_or("");
}

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
        notes.push_back(to_json(note, DampingLaw::constant));
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

std::vector<Note> read_notes(const View& artifact) {
    std::vector<Note> notes;
    if (const auto list = artifact.find("notes")) {
        for (const View& note : list->elements())
            notes.push_back(from_json<Note>(note, DampingLaw::constant));
        return notes;
    }
    const std::string stage = artifact.at("stage").text();
    for (const std::string& text : artifact.at("warnings").texts())
        notes.push_back({.code = "warning", .stage = stage, .text = text});
    return notes;
}

}  // namespace ashimpact
