// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "core/tables/workbook/archive.hpp"
#include "core/tables/workbook/sheet.hpp"

namespace ashimpact {

/// The sheets of an .xlsx (ECMA-376 and ISO 29500, both sets of namespaces); none if the archive is something
/// else.
[[nodiscard]] std::optional<std::vector<Sheet>> read_xlsx(const Archive& archive);

/// The sheets of an .ods (OpenDocument 1.0 to 1.3); none if the archive is something else.
[[nodiscard]] std::optional<std::vector<Sheet>> read_ods(const Archive& archive);

/// A part of a spreadsheet as XML. @throws InputError if it is not well formed
[[nodiscard]] pugi::xml_document parse_part(const std::string& content, const std::string& name);

/// The name of an element or attribute without its prefix, which each writer chooses for itself.
[[nodiscard]] std::string_view local_name(const char* name);

/// First child of that local name, or a null node.
[[nodiscard]] pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name);

/// Value of the attribute of that local name, or nothing.
[[nodiscard]] std::optional<std::string> attribute_of(const pugi::xml_node& node, std::string_view name);

}  // namespace ashimpact
