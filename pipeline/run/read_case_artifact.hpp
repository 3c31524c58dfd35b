// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

/// The case of a run, from 0-case.json.
[[nodiscard]] Case read_case_artifact(const Artifacts& artifacts);

/// The entry of that name. @throws InputError naming the sample
template <class Entry>
[[nodiscard]] const Entry& entry_named(const std::vector<Entry>& entries, const std::string& name,
                                       const Artifacts& artifacts, std::string_view file) {
    for (const Entry& entry : entries)
        if (entry.name == name) return entry;
    throw InputError("the sample " + in_quotes(name) + " is missing", "every sample of 0-case.json")
        .at("/result/samples")
        .at(FileName{artifacts.place_of(file)});
}

}  // namespace ashimpact
