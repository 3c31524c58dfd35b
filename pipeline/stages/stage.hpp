#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/json/view.hpp"

namespace ashimpact {

/// What a stage makes of the artifacts before it.
struct StageOutput {
    Json result = Json::object();
    Json options = Json::object();  ///< that this stage worked with, defaults included
    std::vector<std::string> citations{};
    std::vector<std::string> warnings{};
};

/// One artifact: its file name, its document and the bytes it was read from or will be written as.
struct Artifact {
    std::string file;
    Json document;
    std::string bytes;
    std::string place{};  ///< where it, or the case, was read from, for messages; empty: it was computed
};

/// The artifacts of earlier stages.
class Artifacts {
  public:
    void add(Artifact artifact) { artifacts_.push_back(std::move(artifact)); }
    /// The artifact of that file name. @throws std::logic_error if it was not added
    [[nodiscard]] const Artifact& at(std::string_view file) const;

    /// What messages call an artifact.
    [[nodiscard]] const std::string& place_of(std::string_view file) const;

    /// What @p read makes of the result of an artifact; errors name its file.
    template <class Read>
    auto read(std::string_view file, Read&& read) const {
        const Artifact& artifact = at(file);
        return in_file(place_of(file), [&] {
            if (!artifact.place.empty()) return read(View(artifact.document).at("result"));
            try {
                return read(View(artifact.document).at("result"));
            } catch (const InputError& error) {  // a pointer into what is nowhere to be seen says nothing
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

/// File of the case artifact, which a run starts from.
inline constexpr std::string_view case_artifact = "0-case.json";

}  // namespace ashimpact
