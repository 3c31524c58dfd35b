// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/edits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/text/text.hpp"
#include "pipeline/files/file.hpp"
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

bool is_solved(const Json& series) {
    return series.value("map_accuracy", 0.0) == 0;
}
bool is_alone(const Json& fit) {
    return !fit.contains("direct") && !fit.contains("extrapolated");
}

constexpr std::array sources{Source{modulus_artifact, "young_modulus"},
                             Source{modulus_artifact, "density"},
                             Source{modulus_artifact, "poisson_ratio"},
                             Source{contact_artifact, "contact_modulus"},
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
                             Source{damping_artifact, "damping", is_solved},
                             Source{damping_artifact, "damping_uncertainty", is_solved},
                             Source{fit_artifact, "direct/critical_damping"},
                             Source{fit_artifact, "direct/critical_damping_interval"},
                             Source{fit_artifact, "a", is_alone},
                             Source{fit_artifact, "b", is_alone},
                             Source{fit_artifact, "c", is_alone},
                             Source{fit_artifact, "critical_damping", is_alone},
                             Source{fit_artifact, "covariance", is_alone},
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
    explicit EditReader(std::string_view file) : file_(file) {}

    /// The JSON pointer, below the result, of the first edit that does not count.
    std::optional<std::string> first(const Json& edited, const Json& computed, const std::string& pointer,
                                     const Json& holder, const std::string& member) {
        if (counts(holder, member) || edited.is_null()) return std::nullopt;
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
            return source.file == file_ && source.member == member && source.counts(holder);
        };
        if (std::ranges::any_of(sources, is_this)) return true;
        return file_ == contact_artifact &&
               std::ranges::find(law_parameters(), member, &LawParameter::name) != law_parameters().end();
    }

    std::string_view file_;
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
    if (file == damping_artifact) text += " (of dampings where map_accuracy is 0)";
    if (file == fit_artifact) text += " (of a to covariance without \"direct\" and \"extrapolated\")";
    return text;
}

}  // namespace

void require_edits_to_count(const Artifact& edited, const Stage& stage, const Json& computed) {
    const Json& samples = edited.document->at("result").at("samples");
    const Json& others = computed.at("samples");
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto same = std::ranges::find_if(
            others, [&](const Json& other) { return other.at("name") == samples[i].at("name"); });
        if (same == others.end()) continue;
        const auto found = EditReader(edited.file)
                               .first(samples[i], *same, child_pointer("/result/samples", i), samples[i], "");
        if (!found) continue;
        const std::vector<std::string> reads(stage.reads.begin(), stage.reads.end());
        throw InputError("was edited, and only part of what comes after would rest on it",
                         fmt::format("{}; or of {}, with --from {}", allowed_edits(edited.file),
                                     joined(reads), stage.name))
            .at(*found)
            .at(FileName{edited.place});
    }
}

void require_up_to_date(const std::vector<Artifact>& all, const Artifacts& read) {
    for (const Artifact& artifact : all) {
        // What the comparison takes from the histories does not rest on critical velocities.
        if (!read.has(artifact.file) || artifact.file == histories_artifact) continue;
        for (const Json& input : artifact.document->at("provenance").at("inputs"))
            for (const Artifact& other : all)
                if (other.file == input.at("file") && !has_hash(other, input.at("sha256")))
                    throw InputError(
                        "was computed from another " + other.file + " than the one beside it",
                        fmt::format("--from {}", artifact.document->at("stage").get<std::string>()))
                        .at(FileName{artifact.place});
    }
}

}  // namespace ashimpact
