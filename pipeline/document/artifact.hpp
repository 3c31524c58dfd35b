// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/json/view.hpp"

namespace ashimpact {

/// One artifact: its file name, its document and the bytes it was read from or will be written as.
struct Artifact {
    std::string file;
    Json document;
    std::string bytes;
    /// The file it was read from, for 0-case.json also the case file; for messages. Empty: it was computed.
    std::string place{};
    bool edited = false;  ///< its result is not what ashimpact wrote
};

/// The artifacts of a run.
class Artifacts {
  public:
    void add(Artifact artifact) { artifacts_.push_back(std::move(artifact)); }
    /// The artifact of that file name. @throws std::logic_error if it was not added
    [[nodiscard]] const Artifact& at(std::string_view file) const;
    /// Whether it was added.
    [[nodiscard]] bool has(std::string_view file) const;
    /// The name of an artifact in messages; of a computed one that of the first, which it was computed from.
    [[nodiscard]] const std::string& place_of(std::string_view file) const;

    /// Returns what @p read returns for the result of an artifact; errors name its file.
    template <class Read>
    auto read(std::string_view file, Read&& read) const {
        const Artifact& artifact = at(file);
        return at_place(FileName{place_of(file)}, [&] { return read(View(artifact.document).at("result")); });
    }

  private:
    std::vector<Artifact> artifacts_;
};

}  // namespace ashimpact
