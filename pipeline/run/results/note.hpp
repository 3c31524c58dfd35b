// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/finding.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// A finding of a run: of a stage, a sample and a law.
struct Note {
    std::string code{};  ///< as in Finding; "warning" in artifacts of a version without codes
    Severity severity = Severity::remark;
    std::string stage{};       ///< that made it, "fit"
    std::string sample{};      ///< empty: it concerns the whole run
    std::optional<Law> law{};  ///< none: it concerns every law
    std::string text{};        ///< without sample and law

    friend bool operator==(const Note&, const Note&) = default;
};

/// "88 um, hertz: ...": the note with sample and law in front.
[[nodiscard]] inline std::string text_of(const Note& note) {
    if (note.sample.empty()) return note.text;
    return note.sample + (note.law ? ", " + std::string(note.law->name()) : "") + ": " + note.text;
}

/// What is known of a stage beside its result.
struct StageRecord {
    std::string stage{};   ///< "fit"
    std::string file{};    ///< of its artifact
    std::string sha256{};  ///< of the bytes of that file
    std::vector<std::string> citations{};
    std::vector<Note> notes{};
    bool edited = false;  ///< the artifact was read, and is not what ashimpact wrote

    void note(const Finding& finding, const std::string& sample = {}, const std::optional<Law>& law = {}) {
        notes.push_back({std::string(finding.code), finding.severity, stage, sample, law, finding.text});
    }
    void note(const std::vector<Finding>& findings, const std::string& sample,
              const std::optional<Law>& law = {}) {
        for (const Finding& finding : findings) note(finding, sample, law);
    }
};

/// The results of a stage for each sample of the case, in its order.
template <class Sample>
struct SampleResults {
    std::vector<Sample> samples{};
};

}  // namespace ashimpact
