// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "core/json/view.hpp"

namespace ashimpact {

/// Names of the JSON Schemas (draft 7) the program carries: "case", "1-modulus", ...
[[nodiscard]] std::vector<std::string> schema_names();

/// The schema of that name, complete in itself: what it takes from other files is among its definitions, and
/// lists of laws and the like are those of this program. @throws InputError naming the schemas
[[nodiscard]] Json schema_named(std::string_view name);

/// The same schema with comments ("//" keys) allowed in every object, as an editor needs it.
[[nodiscard]] Json schema_with_comments(std::string_view name);

/// Checks a document. @throws InputError for the first violation: JSON pointer, what is wrong, what is
/// allowed
void validate_document(const Json& document, std::string_view schema_name);

/// Version of the schemas of cases, sweep specs and artifacts that this program writes and reads.
inline constexpr int schema_version = 1;

/// Refuses a document of another version. Cases and specs may leave the version out; artifacts may not.
/// @throws InputError with the version that is read
inline void require_schema_version(const Json& document, bool is_artifact) {
    const std::string read = std::to_string(schema_version) + ", the version that this program reads";
    if (!document.is_object()) return;  // the schema reports it
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
