// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results/note_json.hpp"

#include "pipeline/document/results/fields.hpp"

namespace ashimpact {

namespace {

Note read_note(const View& node) {
    return {.code = node.at("code").text(),
            .severity = named<Severity>(node.at("severity").text()),
            .stage = node.at("stage").text(),
            .sample = text_if(node, "sample"),
            .law = read_if(node, "law", [](const View& law) { return Law::named(law.text()); }),
            .text = node.at("text").text()};
}

}  // namespace

Json to_json(const Note& note) {
    return {{"code", note.code},
            {"severity", name_of(note.severity)},
            {"stage", note.stage},
            {"sample", note.sample.empty() ? Json(nullptr) : Json(note.sample)},
            {"law", note.law ? Json(note.law->name()) : Json(nullptr)},
            {"text", note.text}};
}

std::vector<Note> read_notes(const View& artifact) {
    std::vector<Note> notes = list_if(artifact, "notes", read_note);
    if (artifact.has("notes")) return notes;
    const std::string stage = artifact.at("stage").text();
    for (const std::string& text : artifact.at("warnings").texts())
        notes.push_back({.code = "warning", .stage = stage, .text = text});
    return notes;
}

}  // namespace ashimpact
