// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/artifact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/document/fields.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

namespace {

constexpr auto run_key = "run";
constexpr auto result_key = "result_sha256";

bool is_quantity(const Json& node) {
    return node.is_object() && node.contains("value") && node["value"].is_number() && node.contains("unit") &&
           node["unit"].is_string();
}

std::string text_of(const Json& quantity) {
    return shortest(quantity.at("value").get<double>()) + " " + quantity.at("unit").get<std::string>();
}

/// Refuses a quantity that no computation can have written.
void require_possible(const Json& quantity, const std::string& pointer) {
    constexpr std::array not_negative{"m", "m/s", "kg", "s", "Pa", "kg/m3", "J/m2"};
    const double value = quantity.at("value").get<double>();
    const bool is_signed =
        std::find(not_negative.begin(), not_negative.end(), quantity["unit"]) == not_negative.end();
    const auto refuse = [&](const char* allowed) {
        throw InputError("is " + text_of(quantity), allowed).at(child_pointer(pointer, "value"));
    };
    if (!std::isfinite(value) || std::abs(value) > 1e40) refuse("a number up to 1e40");
    if (value < 0 && !is_signed) refuse("0 or more");
}

/// Refuses a quantity outside of its interval. An end that is null is no bound.
void require_inside(const Json& quantity, const Json& interval, const std::string& pointer) {
    if (!is_quantity(quantity) || !interval.is_object()) return;
    for (const char* key : {"lower", "upper"}) {
        const Json end = interval.value(key, Json());
        if (!is_quantity(end)) continue;
        const double beyond = quantity["value"].get<double>() - end["value"].get<double>();
        if (end["unit"] == quantity["unit"] && !(key == std::string_view("lower") ? beyond < 0 : beyond > 0))
            continue;
        throw InputError("is " + text_of(quantity) + ", outside of its interval",
                         std::string(key) + " end " + text_of(end) + "; edit or remove the interval as well")
            .at(pointer);
    }
}

/// Checks the quantities of a part of a result. The interval of a quantity is inside of it, or beside it
/// under "interval" or the name of the quantity with "_interval".
void require_possible_part(const Json& node, const std::string& pointer) {
    if (is_quantity(node)) {
        require_possible(node, pointer);
        require_inside(node, node.value("interval", Json()), pointer);
    }
    if (!node.is_structured()) return;
    for (const auto& [key, member] : node.items()) {
        const std::string place = child_pointer(pointer, key);
        require_possible_part(member, place);
        if (!node.is_object()) continue;
        require_inside(member, node.value(key + "_interval", Json()), place);
        if (key == "critical_velocity") require_inside(member, node.value("interval", Json()), place);
    }
}

/// Identity of the run that starts from a case: a hash of the program's version and revision, of the case and
/// of the bytes of its inputs. The same inputs give the same bytes of all artifacts, so runs of one identity
/// may be mixed; others may not.
std::string run_identity(const Json& case_result, const Json& inputs) {
    std::string hashed = std::string(program_version()) + "\n" + std::string(program_revision()) + "\n";
    for (const Json& input : inputs) hashed += input.at("sha256").get<std::string>() + "\n";
    return sha256(hashed + case_result.dump());
}

}  // namespace

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
    for (const InputFile& input : envelope.inputs) {
        inputs.push_back({{"file", input.file}, {"sha256", input.sha256}});
        if (!input.readings.empty()) inputs.back()["read_as"] = input.readings;
    }
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
    document["provenance"][run_key] = run.empty() ? run_identity(document.at("result"), inputs) : run;
    seal_result(document);
    std::string bytes = write_json(document);
    return {record.file, std::make_shared<const Json>(std::move(document)), std::move(bytes)};
}

namespace {

/// Warns of files of a case that are there and are not what the run has read.
void warn_of_changed_inputs(const Json& document, const std::string& place) {
    for (const Json& input : document.at("provenance").at("inputs")) {
        const std::filesystem::path file(input.at("file").get<std::string>());
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored)) continue;
        if (sha256(read_file(file)) == input.at("sha256").get<std::string>()) continue;
        spdlog::warn("warning: {}: has changed since it was read for {}, whose content counts", file.string(),
                     place);
    }
}

}  // namespace

Artifact loaded_artifact(const std::filesystem::path& folder, std::string_view file) {
    const auto path = folder / file;
    std::string bytes = read_file(path);
    return at_place(FileName{path.string()}, [&] {
        Json document = parse_json(bytes);
        require_schema_version(document, true);
        validate_document(document, schema_of(file));
        if (file == case_artifact) warn_of_changed_inputs(document, path.string());
        const bool edited = is_edited(document);
        std::vector<Finding> doubts;
        if (edited) {
            require_possible_result(document);
            if (file != histories_artifact)
                doubts = implausible_values(document.at("result"), "/result", file == case_artifact);
            spdlog::warn("warning: {}: {}; its values count", path.string(), edited_words);
        }
        return Artifact{std::string(file),
                        std::make_shared<const Json>(std::move(document)),
                        std::move(bytes),
                        path.string(),
                        edited,
                        std::move(doubts)};
    });
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

std::string run_of(const Json& document) {
    const Json& provenance = document.at("provenance");
    if (!provenance.contains(run_key))
        throw InputError("\"run\" is missing: the artifact of no run", "an artifact as ashimpact wrote it")
            .at("/provenance");
    return provenance[run_key].get<std::string>();
}

void seal_result(Json& document) {
    document["provenance"][result_key] =
        sha256(as_read_back(document["result"]).dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool is_edited(const Json& document) {
    const Json& provenance = document.at("provenance");
    return !provenance.contains(result_key) || provenance[result_key] != sha256(document.at("result").dump());
}

void require_one_run(const std::vector<Artifact>& artifacts) {
    for (const Artifact& artifact : artifacts) {
        const Artifact& first = artifacts.front();
        const std::string& place = artifact.place.empty() ? artifact.file : artifact.place;
        if (at_place(FileName{place}, [&] { return run_of(*artifact.document); }) == run_of(*first.document))
            continue;
        throw InputError("is of another run than " + first.file + " beside it",
                         "artifacts of one run; `ashimpact run` with the case writes all of them anew")
            .at(FileName{place});
    }
}

void require_possible_result(const Json& document) {
    require_possible_part(document.at("result"), "/result");
}

}  // namespace ashimpact
