// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/edits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/text/text.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/run_folder.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

/// Whether an edit counts, by the object of a sample or law that holds the member.
using Condition = bool (*)(const Json& holder);

/// A member of a sample, or of a law of it, that later stages read, and from nowhere else.
struct Source {
    std::string_view file;
    std::string_view member;
    Condition counts = [](const Json&) { return true; };
};

/// Measured impacts are fitted in the plane of both velocities.
bool is_reconstructed(const Json& series) {
    return series.value("origin", std::string()) != "measured";
}
bool is_alone(const Json& fit) {
    return !fit.contains("direct") && !fit.contains("extrapolated");
}
/// The critical damping of an estimate alone is that of "direct", and the reader refuses another one.
bool is_critical_damping(const Json& fit) {
    return is_alone(fit) || fit.value("method", std::string()) == "estimate";
}

constexpr std::array sources{Source{modulus_artifact, "young_modulus"},
                             Source{modulus_artifact, "density"},
                             Source{modulus_artifact, "poisson_ratio"},
                             Source{contact_artifact, "contact_modulus/value"},
                             Source{contact_artifact, "effective_radius"},
                             Source{contact_artifact, "radius"},
                             Source{contact_artifact, "mass"},
                             Source{contact_artifact, "effective_mass"},
                             Source{contact_artifact, "density"},
                             Source{contact_artifact, "partner"},
                             Source{contact_artifact, "work_of_adhesion"},
                             Source{contact_artifact, "yield_pressure"},
                             Source{analytic_artifact, "separation_energy"},
                             Source{analytic_artifact, "critical_velocity"},
                             Source{restitution_artifact, "series"},
                             Source{damping_artifact, "rising_branch"},
                             Source{damping_artifact, "damping", is_reconstructed},
                             Source{damping_artifact, "damping_uncertainty", is_reconstructed},
                             Source{fit_artifact, "direct/critical_damping"},
                             Source{fit_artifact, "direct/critical_damping_interval"},
                             Source{fit_artifact, "a/value", is_alone},
                             Source{fit_artifact, "b/value", is_alone},
                             Source{fit_artifact, "c/value", is_critical_damping},
                             Source{fit_artifact, "critical_damping", is_critical_damping},
                             Source{critical_velocity_artifact, "critical_velocity"},
                             Source{critical_velocity_artifact, "interval"},
                             Source{critical_velocity_artifact, "extrapolated/critical_velocity"},
                             Source{critical_velocity_artifact, "extrapolated/interval"},
                             Source{histories_artifact, "contact_times"}};

bool is_same_number(const Json& one, const Json& other) {
    constexpr double rounding = 1e-9;
    const auto x = one.get<double>();
    const auto y = other.get<double>();
    return std::abs(x - y) <= rounding * std::max(std::abs(x), std::abs(y));
}

/// Compares the result of an artifact with what its stage computes.
class EditReader {
  public:
    /// @param removable whether a value that was removed is no edit
    explicit EditReader(std::string_view file, bool removable = true) : file_(file), removable_(removable) {}

    /// The JSON pointer, below the result, of the first edit that does not count.
    std::optional<std::string> first(const Json& edited, const Json& computed, const std::string& pointer,
                                     const Json& holder, const std::string& member) {
        if (counts(holder, member) || (edited.is_null() && (removable_ || computed.is_null())))
            return std::nullopt;
        if (edited.is_number() && computed.is_object())  // a bare number in SI
            return first(edited, computed.value("value", Json()), pointer, holder, member + "/value");
        if (edited.is_number() && computed.is_number())
            return is_same_number(edited, computed) ? std::nullopt : std::optional(pointer);
        if (edited.is_array() && computed.is_array() && edited.size() == computed.size()) {
            for (std::size_t i = 0; i < edited.size(); ++i)
                if (auto found = first(edited[i], computed[i], child_pointer(pointer, i), holder, member))
                    return found;
            return std::nullopt;
        }
        if (!edited.is_object() || !computed.is_object())
            return edited == computed ? std::nullopt : std::optional(pointer);
        for (const auto& [key, value] : edited.items()) {
            const std::string place = child_pointer(pointer, key);
            const bool holds = member.empty() && std::ranges::count(laws_, key) > 0;
            const std::string inner = holds ? std::string() : member.empty() ? key : member + "/" + key;
            const Json other = computed.value(key, Json());
            if (auto found = first(value, other, place, holds ? value : holder, inner)) return found;
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] bool counts(const Json& holder, const std::string& member) const {
        const auto is_this = [&](const Source& source) {
            std::string unit(source.member);
            if (unit.ends_with("/value")) unit.replace(unit.rfind('/'), std::string::npos, "/unit");
            return source.file == file_ && (source.member == member || unit == member) &&
                   source.counts(holder);
        };
        if (std::ranges::any_of(sources, is_this)) return true;
        return file_ == contact_artifact &&
               std::ranges::find(law_parameters(), member, &LawParameter::name) != law_parameters().end();
    }

    std::string_view file_;
    bool removable_;
    std::vector<std::string> laws_ = names_of_laws();
};

/// Whether an artifact has this hash, in its layout or in that of ashimpact.
bool has_hash(const Artifact& artifact, const Json& hash) {
    return sha256(artifact.bytes) == hash || sha256(write_json(parse_json(artifact.bytes))) == hash;
}

/// What may be edited in an artifact, in words.
std::string allowed_edits(std::string_view file) {
    std::vector<std::string> members;
    for (const Source& source : sources)
        if (source.file == file) members.emplace_back(source.member);
    std::string text = members.empty() ? "no edits of it" : "edits of " + joined(members);
    if (file == damping_artifact) text += " (of dampings that are not of measured impacts)";
    if (file == fit_artifact)
        text +=
            " (of a to critical_damping without \"direct\" and \"extrapolated\", or by method \"estimate\" "
            "with c the same in all places)";
    return text;
}

/// The stage that writes an artifact; null for the case.
const Stage* stage_of(std::string_view file) {
    const auto found = std::ranges::find(stages(), file, &Stage::file);
    return found == stages().end() ? nullptr : &*found;
}

/// The first stage that reads an artifact.
const Stage& first_reader(std::string_view file) {
    return *std::ranges::find_if(stages(), [&](const Stage& stage) {
        return std::ranges::find(stage.reads, file) != stage.reads.end();
    });
}

std::filesystem::path folder_of(const Artifact& artifact) {
    return std::filesystem::path(artifact.place).parent_path();
}

/// Whether an artifact was computed from this version of another one. None: it does not read it.
std::optional<bool> is_computed_from(const Artifact& artifact, const Artifact& other) {
    const Stage* stage = stage_of(artifact.file);
    if (stage == nullptr || std::ranges::find(stage->reads, other.file) == stage->reads.end())
        return std::nullopt;
    for (const Json& input : artifact.document->at("provenance").at("inputs"))
        if (input.at("file") == other.file) return has_hash(other, input.at("sha256"));
    return std::nullopt;
}

/// Files with all that they were computed from, in the order of a run.
std::vector<std::string_view> with_sources(std::span<const std::string_view> files) {
    std::vector<std::string_view> all(files.begin(), files.end());
    for (auto stage = stages().rbegin(); stage != stages().rend(); ++stage)
        if (std::ranges::find(all, stage->file) != all.end())
            for (const std::string_view file : stage->reads)
                if (std::ranges::find(all, file) == all.end()) all.push_back(file);
    std::ranges::sort(all);  // the names of files begin with their numbers
    return all;
}

/// Refuses edits of an artifact that do not count. @param computed what its stage computes
void require_to_count(const Artifact& edited, const Stage& stage, const Json& computed) {
    const auto refuse = [&](const std::string& place) {
        const std::vector<std::string> reads(stage.reads.begin(), stage.reads.end());
        throw InputError("was edited, and only part of what comes after would rest on it",
                         fmt::format("{}; or of {}, with --from {}", allowed_edits(edited.file),
                                     joined(reads), stage.name))
            .at(place)
            .at(FileName{edited.place});
    };
    const Json& samples = edited.document->at("result").at("samples");
    const Json& others = computed.at("samples");
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto same = std::ranges::find_if(
            others, [&](const Json& other) { return other.at("name") == samples[i].at("name"); });
        if (same == others.end()) continue;
        const auto found = EditReader(edited.file)
                               .first(samples[i], *same, child_pointer("/result/samples", i), samples[i], "");
        if (found) refuse(*found);
    }
    for (const auto& [key, value] : edited.document->at("result").items()) {
        if (key == "samples") continue;  // beside them a comparison states their velocities again
        const auto found =
            EditReader(edited.file, false)
                .first(value, computed.value(key, Json()), child_pointer("/result", key), value, key);
        if (found) refuse(*found);
    }
}

/// The same, of an artifact whose stage reads those of @p artifacts.
void require_to_count(const Artifact& edited, const Artifacts& artifacts, ContactModels& models) {
    const Stage* stage = stage_of(edited.file);
    if (!edited.edited || stage == nullptr) return;
    Artifacts inputs;
    for (const std::string_view file : stage->reads)
        inputs.add(artifacts.has(file) ? artifacts.at(file) : loaded_artifact(folder_of(edited), file));
    Run before = read_run(inputs);
    compute_stage(*stage, before, models);
    require_to_count(edited, *stage, as_read_back(result_json(before, stage->file)));
}

}  // namespace

void require_up_to_date(const std::vector<Artifact>& all, const IsUsed& is_used) {
    for (const Artifact& artifact : all) {
        if (!is_used(artifact.file)) continue;
        for (const Artifact& other : all)
            if (!is_computed_from(artifact, other).value_or(true))
                throw InputError("was computed from another " + other.file + " than the one beside it",
                                 fmt::format("--from {} of `ashimpact run -o {}`",
                                             first_reader(other.file).name, folder_of(artifact).string()))
                    .at(FileName{artifact.place});
    }
}

void require_edits_to_count(const Artifacts& artifacts, ContactModels& models) {
    for (const Artifact& artifact : artifacts.list()) require_to_count(artifact, artifacts, models);
}

void require_one_state(const Artifacts& artifacts, std::span<const std::string_view> used) {
    require_one_run(artifacts.list());
    const auto sources = with_sources(used);
    require_up_to_date(artifacts.list(), [&](std::string_view file) {
        return std::ranges::find(sources, file) != sources.end();
    });
    ContactModels models;
    for (const std::string_view file : sources) {
        if (!artifacts.has(file)) continue;
        const Artifact& artifact = artifacts.at(file);
        const bool was_checked = std::ranges::any_of(artifacts.list(), [&](const Artifact& other) {
            return is_computed_from(other, artifact).value_or(false);
        });
        if (!was_checked) require_to_count(artifact, artifacts, models);
    }
}

Artifacts load_artifacts(const std::filesystem::path& folder, const std::vector<std::string_view>& files) {
    complete_interrupted(folder);
    Artifacts artifacts;
    for (const std::string_view file : with_sources(files)) {
        const bool wanted = std::ranges::find(files, file) != files.end();
        std::error_code ignored;
        if (!wanted && !std::filesystem::is_regular_file(folder / file, ignored)) continue;
        artifacts.add(loaded_artifact(folder, file));
        for (const Finding& doubt : artifacts.at(file).doubts)
            spdlog::warn("warning: {}: {}", artifacts.at(file).place, doubt.text);
    }
    require_one_state(artifacts, files);
    return artifacts;
}

}  // namespace ashimpact
