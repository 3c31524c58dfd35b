#include "pipeline/run.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "data/version.hpp"
#include "materials/base/text.hpp"
#include "pipeline/case/case_json.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/case/detachment_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/sha256.hpp"
#include "pipeline/json/schema.hpp"
#include "pipeline/json/writer.hpp"
#include "pipeline/stages/read_case_artifact.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view manifest_file = "manifest.json";

std::string schema_of(std::string_view file) {
    return std::string(file.substr(0, file.rfind('.')));
}

/// An artifact in its envelope.
Artifact sealed(std::string_view file, std::string_view stage, const std::vector<InputFile>& inputs,
                const StageOutput& output) {
    Json named = Json::array();
    for (const InputFile& input : inputs) named.push_back({{"file", input.file}, {"sha256", input.sha256}});
    Json document{{"schema", schema_of(file)},
                  {"stage", stage},
                  {"provenance",
                   {{"program", "ashimpact"},
                    {"version", program_version()},
                    {"revision", program_revision()},
                    {"inputs", named},
                    {"options", output.options}}},
                  {"citations", output.citations},
                  {"warnings", output.warnings},
                  {"result", output.result}};
    std::string bytes = write_json(document);
    return {std::string(file), std::move(document), std::move(bytes)};
}

Artifact case_artifact_of(const LoadedCase& loaded) {
    StageOutput output{.result = case_json(loaded.data)};
    output.options = {{"detachments", detachments_json(loaded.data)}};
    output.warnings = loaded.warnings;
    return sealed(case_artifact, "case", loaded.inputs, output);
}

Artifact computed(const Stage& stage, const Artifacts& before) {
    std::vector<InputFile> inputs;
    for (const std::string_view file : stage.reads)
        inputs.push_back({std::string(file), sha256(before.at(file).bytes)});
    StageOutput output = stage.run(before);
    const bool reads_case =
        std::find(stage.reads.begin(), stage.reads.end(), case_artifact) != stage.reads.end();
    if (reads_case) output.options["detachments"] = detachments_json(read_case_artifact(before));
    return sealed(stage.file, stage.name, inputs, output);
}

/// An artifact of an earlier run, checked against its schema.
Artifact loaded_artifact(const std::filesystem::path& folder, std::string_view file) {
    const auto path = folder / file;
    std::string bytes = read_file(path);
    return in_file(path.string(), [&] {
        Json document = without_comments(parse_json(bytes));
        validate_document(document, schema_of(file));
        return Artifact{std::string(file), std::move(document), std::move(bytes), path.string()};
    });
}

/// The manifest: every artifact of the folder with its hash, those of this run and those from before it.
Artifact manifest_of(const RunPlan& plan, const std::vector<Artifact>& all,
                     const std::vector<Artifact>& written) {
    StageOutput output;
    output.options = {{"from", plan.from.empty() ? Json(nullptr) : Json(plan.from)},
                      {"only", plan.only.empty() ? Json(nullptr) : Json(plan.only)}};
    output.result["artifacts"] = Json::array();
    for (const Artifact& artifact : all) {
        const bool is_new = std::any_of(written.begin(), written.end(),
                                        [&](const Artifact& each) { return each.file == artifact.file; });
        output.result["artifacts"].push_back({{"file", artifact.file},
                                              {"stage", artifact.document.at("stage")},
                                              {"sha256", sha256(artifact.bytes)},
                                              {"bytes", artifact.bytes.size()},
                                              {"written_by_this_run", is_new}});
    }
    return sealed(manifest_file, "manifest", {}, output);
}

void write_artifacts(const std::filesystem::path& folder, const std::vector<Artifact>& artifacts) {
    std::vector<FileContent> files;
    files.reserve(artifacts.size());
    for (const Artifact& artifact : artifacts) files.push_back({folder / artifact.file, artifact.bytes});
    write_files(files);
}

/// Refuses a folder in which the run would write over what it reads.
void keep_inputs(const std::vector<InputFile>& inputs, const std::filesystem::path& folder) {
    std::vector<std::string_view> files{case_artifact, manifest_file};
    for (const Stage& stage : stages()) files.push_back(stage.file);
    for (const InputFile& input : inputs)
        for (const std::string_view file : files)
            if (is_same_file(input.file, folder / file))
                throw InputError("the run reads this file and would write " + std::string(file) + " over it",
                                 "another folder; -o")
                    .in_file(input.file);
}

/// The stages a plan runs, as positions in stages().
struct Range {
    std::size_t first = 0;
    std::size_t end = stages().size();
    bool with_case = true;

    [[nodiscard]] bool holds(std::size_t i) const { return i >= first && i < end; }
};

Range range_of(const RunPlan& plan) {
    const std::string& name = plan.only.empty() ? plan.from : plan.only;
    if (name.empty()) return {};
    const auto names = stage_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        const auto guess = nearest(name, names, 1);
        throw InputError("no stage is called " + in_quotes(name) +
                             (guess.empty() ? "" : ", did you mean " + in_quotes(guess.front()) + "?"),
                         joined(names))
            .at(plan.only.empty() ? "--from" : "--only");
    }
    if (plan.case_file)
        throw InputError("a case file and a stage to start from are both given", "one of the two")
            .in_file(*plan.case_file);
    const auto first = static_cast<std::size_t>(found - names.begin());
    return {first, plan.only.empty() ? stages().size() : first + 1, false};
}

bool is_read(const Range& range, std::string_view file) {
    for (std::size_t i = range.first; i < range.end; ++i)
        if (std::find(stages()[i].reads.begin(), stages()[i].reads.end(), file) != stages()[i].reads.end())
            return true;
    return false;
}

/// The artifacts in the folder that this run neither reads nor writes: only their bytes matter.
void add_left(const std::filesystem::path& folder, std::string_view file, std::string_view stage,
              std::vector<Artifact>& all) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(folder / file, ignored))
        all.push_back({std::string(file), Json{{"stage", stage}}, read_file(folder / file)});
}

}  // namespace

std::vector<std::string> stage_names() {
    std::vector<std::string> names;
    for (const Stage& stage : stages()) names.emplace_back(stage.name);
    return names;
}

Artifacts load_artifacts(const std::filesystem::path& folder, const std::vector<std::string_view>& files) {
    Artifacts artifacts;
    for (const std::string_view file : files) artifacts.add(loaded_artifact(folder, file));
    return artifacts;
}

Artifacts compute_artifacts(const std::optional<std::string>& case_file, std::string_view last_stage) {
    Artifacts artifacts;
    artifacts.add(case_artifact_of(load_case(case_file)));
    for (const Stage& stage : stages()) {
        artifacts.add(computed(stage, artifacts));
        if (stage.name == last_stage) break;
    }
    return artifacts;
}

RunSummary run_stages(const RunPlan& plan) {
    const Range range = range_of(plan);
    require_writable_folder(plan.folder);
    Artifacts artifacts;
    std::vector<Artifact> all;
    RunSummary summary;
    const auto keep = [&](Artifact artifact, bool is_new) {
        if (is_new) summary.written.push_back(artifact);
        all.push_back(artifact);
        artifacts.add(std::move(artifact));
    };
    if (range.with_case) {
        const LoadedCase loaded = load_case(plan.case_file);
        keep_inputs(loaded.inputs, plan.folder);
        keep(case_artifact_of(loaded), true);
    } else if (is_read(range, case_artifact))
        keep(loaded_artifact(plan.folder, case_artifact), false);
    else
        add_left(plan.folder, case_artifact, "case", all);

    for (std::size_t i = 0; i < stages().size(); ++i) {
        const Stage& stage = stages()[i];
        if (range.holds(i)) {
            keep(computed(stage, artifacts), true);
            spdlog::debug("{}: done", stage.name);
        } else if (i < range.first && is_read(range, stage.file)) {
            keep(loaded_artifact(plan.folder, stage.file), false);
        } else {
            add_left(plan.folder, stage.file, stage.name, all);
        }
    }
    summary.written.push_back(manifest_of(plan, all, summary.written));
    for (const Artifact& artifact : summary.written)
        for (const auto& warning : artifact.document.at("warnings")) summary.warnings.push_back(warning);
    write_artifacts(plan.folder, summary.written);
    return summary;
}

}  // namespace ashimpact
