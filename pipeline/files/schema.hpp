// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"

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

/// The part of a schema that describes the value under @p path (keys and indices, outermost first),
/// references resolved; null if there is none.
[[nodiscard]] const Json* schema_part(const Json& schema, const std::vector<std::string>& path);

}  // namespace ashimpact
