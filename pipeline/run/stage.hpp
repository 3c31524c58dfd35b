// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/json/view.hpp"

namespace ashimpact {

/// Files of a run, in the order in which they are written; a run starts from the case.
inline constexpr std::string_view case_artifact = "0-case.json";
inline constexpr std::string_view modulus_artifact = "1-modulus.json";
inline constexpr std::string_view contact_artifact = "2-contact.json";
inline constexpr std::string_view analytic_artifact = "3-analytic.json";
inline constexpr std::string_view restitution_artifact = "4-restitution.json";
inline constexpr std::string_view damping_artifact = "5-damping.json";
inline constexpr std::string_view fit_artifact = "6-fit.json";
inline constexpr std::string_view critical_velocity_artifact = "7-critical-velocity.json";
inline constexpr std::string_view histories_artifact = "8-histories.json";
inline constexpr std::string_view comparison_artifact = "comparison.json";
inline constexpr std::string_view manifest_artifact = "manifest.json";

/// Output of a stage.
struct StageOutput {
    Json result = Json::object();
    Json options = Json::object();  ///< used by this stage, defaults included
    std::vector<std::string> citations{};
    std::vector<std::string> warnings{};
};

/// One artifact: its file name, its document and the bytes it was read from or will be written as.
struct Artifact {
    std::string file;
    Json document;
    std::string bytes;
    /// The file it was read from, for 0-case.json also the case file; for messages. Empty: it was computed.
    std::string place{};
    bool edited = false;  ///< its result is not what ashimpact wrote
};

/// The artifacts of earlier stages.
class Artifacts {
  public:
    void add(Artifact artifact) { artifacts_.push_back(std::move(artifact)); }
    /// The artifact of that file name. @throws std::logic_error if it was not added
    [[nodiscard]] const Artifact& at(std::string_view file) const;

    /// Whether it was added.
    [[nodiscard]] bool has(std::string_view file) const;

    /// The name of an artifact in messages.
    [[nodiscard]] const std::string& place_of(std::string_view file) const;

    /// Returns what @p read returns for the result of an artifact; errors name its file.
    template <class Read>
    auto read(std::string_view file, Read&& read) const {
        const Artifact& artifact = at(file);
        return at_place(FileName{place_of(file)}, [&] {
            if (!artifact.place.empty()) return read(View(artifact.document).at("result"));
            try {
                return read(View(artifact.document).at("result"));
            } catch (const InputError& error) {  // without its pointer: the artifact is in no file
                throw InputError(error.problem(), error.allowed());
            }
        });
    }

  private:
    std::vector<Artifact> artifacts_;
};

/// One step of a run: a pure function of the artifacts it reads.
struct Stage {
    std::string_view name;                ///< "modulus"
    std::string_view file;                ///< "1-modulus.json"; its schema is the file's stem
    std::vector<std::string_view> reads;  ///< files of earlier stages
    StageOutput (*run)(const Artifacts& before);
};

/// The stages after the case itself, in order.
[[nodiscard]] const std::vector<Stage>& stages();

}  // namespace ashimpact
