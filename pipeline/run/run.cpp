// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/run.hpp"

#include <algorithm>

#include <spdlog/spdlog.h>

#include "core/json/writer.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/case_json.hpp"
#include "pipeline/document/detachment_json.hpp"
#include "pipeline/document/files/file.hpp"
#include "pipeline/document/files/run_folder.hpp"
#include "pipeline/document/files/sha256.hpp"
#include "pipeline/document/run_identity.hpp"
#include "pipeline/document/schema.hpp"
#include "pipeline/document/schema_version.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/report.hpp"
#include "pipeline/run/read_case_artifact.hpp"

namespace ashimpact {

namespace {

std::string schema_of(std::string_view file) {
    return std::string(file.substr(0, file.rfind('.')));
}

/// Whether an artifact was edited, or computed from an edited one.
bool rests_on_edit(const Artifact& artifact) {
    return artifact.edited || artifact.document.at("provenance").value("edited", false);
}

/// Runs a stage. An error without a place gets one: the edited artifact, else the first input.
StageOutput run_stage(const Stage& stage, const Artifacts& before) {
    try {
        return stage.run(before);
    } catch (const InputError& error) {
        if (!error.place().empty()) throw;
        const auto found = std::find_if(stage.reads.begin(), stage.reads.end(),
                                        [&](std::string_view file) { return before.at(file).edited; });
        throw error.at("/result").at(
            FileName{before.place_of(found != stage.reads.end() ? *found : stage.reads.front())});
    }
}

/// An artifact in its envelope.
/// @param run identity of its run; empty: it starts one
/// @param edited whether it was computed from an edited artifact
Artifact sealed(std::string_view file, std::string_view stage, const std::vector<InputFile>& inputs,
                const StageOutput& output, const std::string& run, bool edited = false) {
    Json named = Json::array();
    for (const InputFile& input : inputs) named.push_back({{"file", input.file}, {"sha256", input.sha256}});
    Json document{{"schema", schema_of(file)},
                  {"schema_version", schema_version},
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
    if (edited) document["provenance"]["edited"] = true;
    seal(document, run.empty() ? run_identity(output.result, named) : run);
    std::string bytes = write_json(document);
    return {std::string(file), std::move(document), std::move(bytes)};
}

Artifact case_artifact_of(const LoadedCase& loaded) {
    StageOutput output{.result = case_json(loaded.data)};
    output.options = {{"detachments", detachments_json(loaded.data)}};
    output.warnings = loaded.warnings;
    Artifact artifact = sealed(case_artifact, "case", loaded.inputs, output, {});
    artifact.place = loaded.inputs.front().file;
    return artifact;
}

/// Warns of edited artifacts that a stage reads. @return whether its output rests on an edit
bool warn_of_edits(const Stage& stage, const Artifacts& before, std::vector<std::string>& warnings) {
    bool edited = false;
    bool rests = false;
    for (const std::string_view file : stage.reads) {
        const Artifact& artifact = before.at(file);
        if (artifact.edited) warnings.push_back(std::string(file) + " was edited after ashimpact wrote it");
        edited = edited || artifact.edited;
        rests = rests || rests_on_edit(artifact);
    }
    if (rests && !edited) warnings.emplace_back("computed from artifacts that rest on an edited one");
    return rests;
}

Artifact computed(const Stage& stage, const Artifacts& before) {
    std::vector<InputFile> inputs;
    for (const std::string_view file : stage.reads)
        inputs.push_back({std::string(file), sha256(before.at(file).bytes)});
    StageOutput output = run_stage(stage, before);
    const bool edited = warn_of_edits(stage, before, output.warnings);
    const bool reads_case =
        std::find(stage.reads.begin(), stage.reads.end(), case_artifact) != stage.reads.end();
    if (reads_case) output.options["detachments"] = detachments_json(read_case_artifact(before));
    return sealed(stage.file, stage.name, inputs, output, run_of(before.at(stage.reads.front()).document),
                  edited);
}

/// An artifact of an earlier run, checked against its schema. An edited one is taken, with a warning.
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
    return sealed(manifest_artifact, "manifest", {}, output, run_of(written.front().document));
}

/// Report and figures of a run; of a part of one, where the folder has the artifacts of the rest.
std::vector<FileContent> presentation(const RunPlan& plan, Artifacts artifacts, RunSummary& summary) {
    if (!plan.report && !plan.figures) return {};
    try {
        for (const std::string_view file : report::report_artifacts())
            if (!artifacts.has(file)) artifacts.add(loaded_artifact(plan.folder, file));
        report::Presentation made = report::present(
            std::move(artifacts), {.folder = plan.folder, .page = plan.report, .figures = plan.figures});
        summary.report = made.page;
        summary.figures = made.files.size() - (made.page.empty() ? 0 : 1);
        return std::move(made.files);
    } catch (const InputError& error) {
        if (plan.from.empty() && plan.only.empty()) throw;
        summary.remarks.push_back({"report.html", std::string("no report: ") + error.what()});
        return {};
    }
}

std::vector<std::string> artifact_names() {
    std::vector<std::string> names{std::string(case_artifact), std::string(manifest_artifact)};
    for (const Stage& stage : stages()) names.emplace_back(stage.file);
    names.emplace_back(report::report_file);
    return names;
}

/// Takes the figures of an earlier run away that this run does not make again: they would show other results
/// than the folder has.
void remove_old_figures(const std::filesystem::path& folder, const std::vector<FileContent>& made) {
    std::size_t removed = 0;
    for (const std::filesystem::path& old : report::own_figures(folder)) {
        if (std::any_of(made.begin(), made.end(), [&](const FileContent& file) { return file.path == old; }))
            continue;
        std::error_code failure;
        if (!std::filesystem::remove(old, failure))
            throw InputError("cannot be removed: " + failure.message(), "a folder you may write to")
                .at(FileName{old.string()});
        ++removed;
    }
    if (removed == 0) return;
    std::error_code not_empty;
    std::filesystem::remove(folder, not_empty);
    spdlog::warn("warning: {}: {} figures of an earlier run removed; --figures makes them again",
                 folder.string(), removed);
}

/// The folder of a run, for this run alone; where it is not there yet, from the time it is made.
class RunFolder {
  public:
    explicit RunFolder(const std::filesystem::path& folder)
        : folder_(folder.empty() ? std::filesystem::path(".") : folder), names_(artifact_names()) {
        require_writable_folder(folder_);
        if (std::filesystem::is_directory(folder_)) take();
    }

    /// Replaces the artifacts and the report as one; figures, which have a folder of their own, after them.
    void write(const std::vector<Artifact>& artifacts, std::vector<FileContent> presentation) {
        if (!lock_) {
            make_folder(folder_);
            take();
        }
        std::vector<NamedContent> files;
        std::vector<FileContent> figures;
        for (FileContent& file : presentation) {
            if (file.path.parent_path().filename() == report::figures_folder)
                figures.push_back(std::move(file));
            else
                files.push_back({file.path.filename().string(), std::move(file.content)});
        }
        remove_old_figures(folder_ / report::figures_folder, figures);
        for (const Artifact& artifact : artifacts) files.push_back({artifact.file, artifact.bytes});
        const auto is_report = [](const NamedContent& file) { return file.name == report::report_file; };
        const bool reported = std::any_of(files.begin(), files.end(), is_report);
        if (!reported && report::is_own_page(folder_ / report::report_file))
            files.push_back({std::string(report::report_file), {}});  // removes that of other artifacts
        replace_files(folder_, files);
        if (!figures.empty()) write_files(figures);
    }

  private:
    void take() {
        require_plain_files(folder_, names_);
        lock_.emplace(folder_);
    }

    std::filesystem::path folder_;
    std::vector<std::string> names_;
    std::optional<FolderLock> lock_;
};

/// Refuses a folder in which the run would write over what it reads.
void keep_inputs(const std::vector<InputFile>& inputs, const std::filesystem::path& folder) {
    const std::vector<std::string> files = artifact_names();
    for (const InputFile& input : inputs)
        for (const std::string& file : files)
            if (is_same_file(input.file, folder / file))
                throw InputError("the run reads this file and would write " + file + " over it",
                                 "another folder; -o")
                    .at(FileName{input.file});
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
    if (found == names.end())
        throw unknown_name("stage", name, names).at(plan.only.empty() ? "--from" : "--only");
    if (plan.case_file)
        throw InputError("a case file and a stage to start from are both given", "one of the two")
            .at(FileName{*plan.case_file});
    const auto first = static_cast<std::size_t>(found - names.begin());
    return {first, plan.only.empty() ? stages().size() : first + 1, false};
}

bool is_read(const Range& range, std::string_view file) {
    for (std::size_t i = range.first; i < range.end; ++i)
        if (std::find(stages()[i].reads.begin(), stages()[i].reads.end(), file) != stages()[i].reads.end())
            return true;
    return false;
}

/// The artifacts in the folder that this run neither reads nor writes: only their bytes and their run matter.
void add_left(const std::filesystem::path& folder, std::string_view file, std::string_view stage,
              std::vector<Artifact>& all) {
    const auto path = folder / file;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return;
    std::string bytes = read_file(path);
    Json document{{"stage", stage}, {"provenance", {{"inputs", Json::array()}}}, {"warnings", Json::array()}};
    at_place(FileName{path.string()}, [&] {
        const Json whole = parse_json(bytes);
        require_schema_version(whole, true);
        validate_document(whole, schema_of(file));
        document["provenance"] = whole.at("provenance");
        document["warnings"] = whole.at("warnings");
    });
    all.push_back({std::string(file), std::move(document), std::move(bytes), path.string()});
}

/// Every warning in the folder of the run, whichever run wrote it, and the samples they may name.
void add_remarks(const std::vector<Artifact>& all, RunSummary& summary) {
    for (const Artifact& artifact : all) {
        for (const auto& warning : artifact.document.at("warnings"))
            summary.remarks.push_back({artifact.file, warning.get<std::string>()});
        if (!summary.samples.empty() || !artifact.document.contains("result") ||
            !artifact.document.at("result").contains("samples"))
            continue;
        for (const Json& sample : artifact.document.at("result").at("samples"))
            if (sample.is_object() && sample.contains("name"))
                summary.samples.push_back(sample.at("name").get<std::string>());
    }
}

}  // namespace

std::vector<std::string> stage_names() {
    std::vector<std::string> names;
    for (const Stage& stage : stages()) names.emplace_back(stage.name);
    return names;
}

Artifacts load_artifacts(const std::filesystem::path& folder, const std::vector<std::string_view>& files) {
    complete_interrupted(folder);
    Artifacts artifacts;
    std::vector<Artifact> of_one_run;
    of_one_run.reserve(files.size());
    for (const std::string_view file : files) of_one_run.push_back(loaded_artifact(folder, file));
    require_one_run(of_one_run);
    for (Artifact& artifact : of_one_run) artifacts.add(std::move(artifact));
    return artifacts;
}

Artifacts compute_artifacts(const std::optional<std::string>& case_file, std::string_view last_stage,
                            bool allow_outside) {
    Artifacts artifacts;
    artifacts.add(case_artifact_of(load_case(case_file, allow_outside)));
    for (const Stage& stage : stages()) {
        artifacts.add(computed(stage, artifacts));
        if (stage.name == last_stage) break;
    }
    return artifacts;
}

RunSummary run_stages(const RunPlan& plan) {
    const Range range = range_of(plan);
    if (plan.figures) report::require_figure_programs();
    RunFolder folder(plan.folder);
    Artifacts artifacts;
    std::vector<Artifact> all;
    RunSummary summary;
    const auto keep = [&](Artifact artifact, bool is_new) {
        if (is_new) summary.written.push_back(artifact);
        all.push_back(artifact);
        artifacts.add(std::move(artifact));
    };
    if (range.with_case) {
        const LoadedCase loaded = load_case(plan.case_file, plan.allow_outside);
        keep_inputs(loaded.inputs, plan.folder);
        keep(case_artifact_of(loaded), true);
    } else if (is_read(range, case_artifact))
        keep(loaded_artifact(plan.folder, case_artifact), false);
    else
        add_left(plan.folder, case_artifact, "case", all);

    for (std::size_t i = 0; i < range.first; ++i) {
        const Stage& stage = stages()[i];
        if (is_read(range, stage.file))
            keep(loaded_artifact(plan.folder, stage.file), false);
        else
            add_left(plan.folder, stage.file, stage.name, all);
    }
    std::vector<Artifact> after;
    for (std::size_t i = range.end; i < stages().size(); ++i)
        add_left(plan.folder, stages()[i].file, stages()[i].name, after);
    if (!range.with_case) {
        std::vector<Artifact> old = all;
        old.insert(old.end(), after.begin(), after.end());
        require_one_run(old);
        for (const std::string& told : outdated(all)) spdlog::warn("warning: {}", told);
    }
    for (std::size_t i = range.first; i < range.end; ++i) {
        keep(computed(stages()[i], artifacts), true);
        spdlog::debug("{}: done", stages()[i].name);
    }
    all.insert(all.end(), after.begin(), after.end());
    summary.written.push_back(manifest_of(plan, all, summary.written));
    add_remarks(all, summary);
    folder.write(summary.written, presentation(plan, std::move(artifacts), summary));
    return summary;
}

}  // namespace ashimpact
