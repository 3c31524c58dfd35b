// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/view.hpp"

namespace ashimpact {

/// Version of the schemas of cases, sweep specs and artifacts that this program writes and reads.
inline constexpr int schema_version = 1;

/// Refuses a document of another version. Cases and specs may leave the version out; artifacts may not.
/// @throws InputError that says which version is read
inline void require_schema_version(const Json& document, bool is_artifact) {
    const std::string read = std::to_string(schema_version) + ", the version that this program reads";
    if (!document.is_object()) return;  // the schema says what is wrong
    if (!document.contains("schema_version")) {
        if (!is_artifact || !document.contains("schema")) return;
        throw InputError("\"schema_version\" is missing: an artifact of an earlier version of ashimpact",
                         read + "; run its case again")
            .at("/");
    }
    const Json& version = document["schema_version"];
    if (version.is_number_integer() && version == schema_version) return;
    throw InputError("is " + version.dump().substr(0, 40), read).at("/schema_version");
}

}  // namespace ashimpact
