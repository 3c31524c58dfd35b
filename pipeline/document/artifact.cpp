// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/artifact.hpp"

#include <algorithm>
#include <stdexcept>

namespace ashimpact {

const Artifact& Artifacts::at(std::string_view file) const {
    for (const Artifact& artifact : artifacts_)
        if (artifact.file == file) return artifact;
    throw std::logic_error("the artifact " + std::string(file) + " was not read");
}

bool Artifacts::has(std::string_view file) const {
    return std::any_of(artifacts_.begin(), artifacts_.end(),
                       [&](const Artifact& each) { return each.file == file; });
}

const std::string& Artifacts::place_of(std::string_view file) const {
    const Artifact& artifact = at(file);
    if (!artifact.place.empty()) return artifact.place;
    const std::string& first = artifacts_.front().place;
    return first.empty() ? artifact.file : first;
}

}  // namespace ashimpact
