// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/run_stages.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/plausibility.hpp"
#include "core/text/text.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/edits.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/run_folder.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

namespace {

/// A run while it is computed: its results, and the artifacts that are read or written.
struct Work {
    Run run{};
    Artifacts artifacts{};
    std::vector<Artifact> all{};  ///< in the order of the stages
    ContactModels models{};
    std::vector<Finding> doubts{};  ///< about edited artifacts, for the record of the first stage

    void add(const Artifact& artifact) {
        for (Finding doubt : artifact.doubts) {
            doubt.text.insert(0, artifact.file + ": ");
            doubts.push_back(std::move(doubt));
        }
        all.push_back(artifact);
        artifacts.add(artifact);
    }
};

/// Adds the artifact of the case and reads the case back from it, as a later run from that file will.
Artifact begin(const LoadedCase& loaded, Work& work) {
    Envelope envelope{.record = {.stage = "case", .file = std::string(case_artifact)},
                      .inputs = loaded.inputs,
                      .options = options_json(loaded.data, case_artifact)};
    for (const SampleFinding& each : loaded.findings) envelope.record.note(each.finding, each.sample);
    Artifact artifact = sealed_artifact(envelope, case_json(loaded.data), {});
    artifact.place = loaded.inputs.front().file;
    work.add(artifact);
    read_artifact(work.artifacts, case_artifact, work.run);
    return artifact;
}

/// Computes the result of a stage. Errors without a place get one: the edited artifact, else the first input.
void compute_result(const Stage& stage, Work& work) {
    try {
        compute_stage(stage, work.run, work.models);
    } catch (const InputError& error) {
        if (!error.place().empty()) throw;
        const auto found = std::ranges::find_if(
            stage.reads, [&](std::string_view file) { return work.artifacts.at(file).edited; });
        throw error.at("/result").at(
            FileName{work.artifacts.place_of(found != stage.reads.end() ? *found : stage.reads.front())});
    }
}

/// Notes values of an edited 1-modulus.json that count for nothing, since the case states them.
void note_stated_values(const Case& data, StageRecord& record) {
    for (const Sample& sample : data.samples) {
        std::vector<std::string> stated;
        if (sample.poisson_ratio) stated.emplace_back("poisson_ratio");
        if (sample.density) stated.emplace_back("density");
        if (sample.contact_modulus) stated.emplace_back("contact_modulus");
        if (!stated.empty())
            record.note({"edited", Severity::doubt,
                         fmt::format("{} as the case states, not as {}", joined(stated), modulus_artifact)},
                        sample.name);
    }
}

/// Notes edited artifacts that a stage reads. @return whether its result rests on an edit
bool note_edits(const Stage& stage, const Artifacts& before, const Case& data, StageRecord& record) {
    bool edited = false;
    bool rests_on_edit = false;  // an artifact that is read was itself computed from an edited one
    for (const std::string_view file : stage.reads) {
        const Artifact& artifact = before.at(file);
        if (artifact.edited)
            record.note({"edited", Severity::remark, fmt::format("{} {}", file, edited_words)});
        if (artifact.edited && file == modulus_artifact && stage.file == contact_artifact)
            note_stated_values(data, record);
        edited = edited || artifact.edited;
        rests_on_edit = rests_on_edit || artifact.document->at("provenance").value("edited", false);
    }
    if (rests_on_edit && !edited)
        record.note(
            {"rests-on-edit", Severity::remark, "computed from artifacts that rest on an edited one"});
    return rests_on_edit || edited;
}

/// Computes a stage and adds its artifact, sealed.
Artifact add_stage(const Stage& stage, Work& work) {
    compute_result(stage, work);
    StageRecord& record = work.run.records.back();
    record.note(std::exchange(work.doubts, {}), {});
    const bool rests_on_edit = note_edits(stage, work.artifacts, work.run.data, record);
    Envelope envelope{
        .record = record, .options = options_json(work.run.data, stage.file), .rests_on_edit = rests_on_edit};
    for (const std::string_view file : stage.reads)
        envelope.inputs.push_back({std::string(file), sha256(work.artifacts.at(file).bytes)});
    Artifact artifact = sealed_artifact(envelope, result_json(work.run, stage.file),
                                        run_of(*work.artifacts.at(stage.reads.front()).document));
    record.sha256 = sha256(artifact.bytes);
    work.add(artifact);
    return artifact;
}

/// The manifest: every artifact of the folder with its hash, those of this run and those from before it.
Artifact manifest_of(const RunPlan& plan, const std::vector<Artifact>& all,
                     const std::vector<Artifact>& written) {
    Envelope envelope{.record = {.stage = "manifest", .file = std::string(manifest_artifact)},
                      .options = {{"from", plan.from.empty() ? Json(nullptr) : Json(plan.from)},
                                  {"only", plan.only.empty() ? Json(nullptr) : Json(plan.only)}}};
    Json list = Json::array();
    for (const Artifact& artifact : all) {
        const bool is_new = std::ranges::find(written, artifact.file, &Artifact::file) != written.end();
        list.push_back({{"file", artifact.file},
                        {"stage", artifact.document->at("stage")},
                        {"sha256", sha256(artifact.bytes)},
                        {"bytes", artifact.bytes.size()},
                        {"written_by_this_run", is_new}});
    }
    return sealed_artifact(envelope, {{"artifacts", std::move(list)}}, run_of(*written.front().document));
}

/// The complete run: moved out of @p work, or, if only some stages ran, read from all artifacts.
Run complete_run(const RunPlan& plan, Work& work) {
    if (plan.from.empty() && plan.only.empty()) return std::move(work.run);
    for (const std::string_view file : report::report_artifacts())
        if (!work.artifacts.has(file)) work.artifacts.add(loaded_artifact(plan.folder, file));
    require_one_state(work.artifacts, report::report_artifacts());
    return read_run(work.artifacts);
}

/// Report and figures, which it adds to the summary; for part of a run without the other artifacts, a remark.
std::vector<FileContent> presentation(const RunPlan& plan, Work& work, RunSummary& summary) {
    if (!plan.report && !plan.figures) return {};
    try {
        std::vector<report::RunData> runs;
        runs.emplace_back(complete_run(plan, work), "");
        std::vector<FileContent> files;
        if (plan.figures) files = report::figure_files(runs.front(), plan.folder);
        if (plan.report) files.push_back({plan.folder / report::report_file, report::run_page(runs)});
        if (plan.report) summary.report = files.back().path;
        summary.figures = files.size() - (plan.report ? 1 : 0);
        return files;
    } catch (const InputError& error) {
        if (plan.from.empty() && plan.only.empty()) throw;
        summary.remarks.push_back({std::string(report::report_file),
                                   {.code = "no-report",
                                    .severity = Severity::doubt,
                                    .text = fmt::format("no report ({})", error.what())}});
        return {};
    }
}

std::vector<std::string> artifact_names() {
    const auto& files = report::report_artifacts();
    std::vector<std::string> names(files.begin(), files.end());
    names.insert(names.end(), {std::string(manifest_artifact), std::string(report::report_file)});
    return names;
}

/// Removes figures of an earlier run that this run does not replace: they would show other results.
void remove_old_figures(const std::filesystem::path& folder, const std::vector<FileContent>& made) {
    std::size_t removed = 0;
    for (const std::filesystem::path& old : report::own_figures(folder)) {
        if (std::ranges::find(made, old, &FileContent::path) != made.end()) continue;
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

/// The folder of a run, locked for this run. A new folder is made, and locked, only by write().
class RunFolder {
  public:
    explicit RunFolder(const std::filesystem::path& folder)
        : folder_(folder.empty() ? std::filesystem::path(".") : folder), names_(artifact_names()) {
        require_writable_folder(folder_);
        if (std::filesystem::is_directory(folder_)) lock();
    }

    /// Replaces artifacts and report, all or none; then the figures, which are in a subfolder.
    void write(const std::vector<Artifact>& artifacts, std::vector<FileContent> presentation) {
        if (!lock_) {
            make_folder(folder_);
            lock();
        }
        std::vector<NamedContent> files;
        std::vector<FileContent> figures;
        for (FileContent& file : presentation) {
            if (file.path.parent_path().filename() == report::figures_folder)
                figures.push_back(std::move(file));
            else
                files.push_back({file.path.filename().string(), std::move(file.content)});
        }
        for (const Artifact& artifact : artifacts) files.push_back({artifact.file, artifact.bytes});
        const bool reported =
            std::ranges::find(files, report::report_file, &NamedContent::name) != files.end();
        if (!reported && report::is_own_page(folder_ / report::report_file))
            files.push_back({std::string(report::report_file), {}});  // removes the outdated report
        for (const NamedContent& file : files)
            if (!file.content.empty()) require_replaceable(folder_ / file.name, file.content);
        for (const FileContent& figure : figures) require_replaceable(figure.path, figure.content);
        remove_old_figures(folder_ / report::figures_folder, figures);
        replace_files(folder_, files);
        if (!figures.empty()) write_files(figures);
    }

  private:
    void lock() {
        require_plain_files(folder_, names_);
        lock_.emplace(folder_);
    }

    std::filesystem::path folder_;
    std::vector<std::string> names_;
    std::optional<FolderLock> lock_;
};

/// Refuses a folder in which the run would write over its input files.
void refuse_to_overwrite(const std::vector<InputFile>& inputs, const std::filesystem::path& folder) {
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
    bool with_case = true;  ///< the case is read from its own file, not from 0-case.json
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
        if (std::ranges::find(stages()[i].reads, file) != stages()[i].reads.end()) return true;
    return false;
}

/// Whether an artifact in the folder was edited; a damaged one is written anew.
bool was_edited(const std::filesystem::path& path, std::string_view file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return false;
    try {
        const Json document = parse_json(read_file(path));
        validate_document(document, schema_of(file));
        return is_edited(document);
    } catch (const InputError&) {
        return false;
    }
}

/// Refuses to start at a stage whose artifact was edited: the edit would be lost. Later ones are computed
/// anew with a warning. @throws InputError
void keep_edits(const std::filesystem::path& folder, const Range& range) {
    for (std::size_t i = range.first; i < range.end; ++i) {
        const Stage& stage = stages()[i];
        const auto path = folder / stage.file;
        if (!was_edited(path, stage.file)) continue;
        if (i > range.first) {
            spdlog::warn("warning: {}: was edited, and is computed anew", path.string());
            continue;
        }
        throw InputError(
            fmt::format("was edited, and {} computes it anew: the edit would be lost", stage.name),
            i + 1 == stages().size()
                ? "the file removed, or as it was"
                : fmt::format("--from {}, which takes the edit; or the file removed", stages()[i + 1].name))
            .at(FileName{path.string()});
    }
}

/// Adds an artifact that the run neither reads nor writes, if it exists: checked, but kept without its
/// result.
void add_unused(const std::filesystem::path& folder, std::string_view file, std::string_view stage,
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
        for (const char* key : {"warnings", "notes"})
            if (whole.contains(key)) document[key] = whole.at(key);
    });
    all.push_back({std::string(file), std::make_shared<const Json>(std::move(document)), std::move(bytes),
                   path.string()});
}

/// Adds all notes in the folder, of this run and earlier ones, and the number of samples.
void summarize(const std::vector<Artifact>& all, RunSummary& summary) {
    for (const Artifact& artifact : all) {
        for (const Note& note : read_notes(View(*artifact.document)))
            summary.remarks.push_back({artifact.file, note});
        if (summary.samples == 0 && artifact.document->contains("result") &&
            artifact.document->at("result").contains("samples"))
            summary.samples = artifact.document->at("result").at("samples").size();
    }
    std::stable_partition(summary.remarks.begin(), summary.remarks.end(), [](const Remark& remark) {
        return remark.note.code == implausible_code || remark.note.code == outside_model_code;
    });
}

/// Results and artifacts of a case up to and with a stage; nothing is written.
std::pair<Run, Artifacts> computed(const std::optional<std::string>& case_file, std::string_view last_stage,
                                   bool allow_outside) {
    Work work;
    const LoadedCase loaded = load_case(case_file, allow_outside);
    for (const auto& [sample, finding] : loaded.findings)
        if (finding.code == implausible_code || finding.code == unused_code)
            spdlog::warn("warning: {}", finding.text);
    begin(loaded, work);
    for (const Stage& stage : stages()) {
        add_stage(stage, work);
        if (stage.name == last_stage) break;
    }
    return {std::move(work.run), std::move(work.artifacts)};
}

}  // namespace

std::vector<std::string> stage_names() {
    std::vector<std::string> names;
    for (const Stage& stage : stages()) names.emplace_back(stage.name);
    return names;
}

Run compute_run(const std::optional<std::string>& case_file, std::string_view last_stage,
                bool allow_outside) {
    return computed(case_file, last_stage, allow_outside).first;
}

Artifacts compute_artifacts(const std::optional<std::string>& case_file, std::string_view last_stage,
                            bool allow_outside) {
    return computed(case_file, last_stage, allow_outside).second;
}

static void compute_range(const RunPlan& plan, const Range& range, Work& work, RunSummary& summary) {
    for (std::size_t i = range.first; i < range.end; ++i) {
        if (plan.on_step)
            plan.on_step(fmt::format("step {} of {}: {}", i + 1, stages().size(), stages()[i].name));
        summary.written.push_back(add_stage(stages()[i], work));
        spdlog::debug("{}: done", stages()[i].name);
    }
}

RunSummary run_stages(const RunPlan& plan) {
    const Range range = range_of(plan);
    if (plan.figures) report::require_converter(report::FigureFormat::pdf);
    RunFolder folder(plan.folder);
    Work work;
    RunSummary summary;
    const auto add_earlier = [&](std::string_view file, std::string_view stage) {
        if (!is_read(range, file)) return add_unused(plan.folder, file, stage, work.all);
        work.add(loaded_artifact(plan.folder, file));
    };
    if (range.with_case) {
        LoadedCase loaded = load_case(plan.case_file, plan.allow_outside);
        if (plan.temperature) loaded.data.temperature = {plan.temperature, plan.temperature};
        refuse_to_overwrite(loaded.inputs, plan.folder);
        summary.files = loaded.inputs;
        summary.written.push_back(begin(loaded, work));
    } else {
        add_earlier(case_artifact, "case");
    }
    for (std::size_t i = 0; i < range.first; ++i) add_earlier(stages()[i].file, stages()[i].name);
    std::vector<Artifact> later;
    for (std::size_t i = range.end; i < stages().size(); ++i)
        add_unused(plan.folder, stages()[i].file, stages()[i].name, later);
    if (!range.with_case) {
        keep_edits(plan.folder, range);
        std::vector<Artifact> old = work.all;
        old.insert(old.end(), later.begin(), later.end());
        require_one_run(old);
        work.run = read_run(work.artifacts);
        require_up_to_date(work.all, [&](std::string_view file) { return work.artifacts.has(file); });
        require_edits_to_count(work.artifacts, work.models);
    }
    compute_range(plan, range, work, summary);
    work.all.insert(work.all.end(), later.begin(), later.end());
    summary.written.push_back(manifest_of(plan, work.all, summary.written));
    summarize(work.all, summary);
    summary.scope = scope_sentence(work.run.data);
    summary.inputs = inputs_text(work.run);
    folder.write(summary.written, presentation(plan, work, summary));
    return summary;
}

}  // namespace ashimpact
