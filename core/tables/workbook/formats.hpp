// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "core/tables/workbook/workbook.hpp"

namespace ashimpact {

/// Reads the members of a zip archive that lies in memory. The bytes must outlive the archive.
class Archive {
  public:
    /// @throws InputError if the bytes are no zip archive or a damaged one
    explicit Archive(std::string_view bytes);
    ~Archive();
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    /// A member, unpacked; none if there is no such member.
    /// @throws InputError if it is damaged, protected by a password or unpacks to more than `longest_member`
    [[nodiscard]] std::optional<std::string> read(const std::string& name) const;

    /// No member that is read may unpack to more [bytes]: a small archive can hold gigabytes.
    static constexpr std::size_t longest_member = std::size_t{8} << 20;

  private:
    struct Bytes {
        std::string_view all;
        std::size_t place = 0;
    };
    std::unique_ptr<Bytes> bytes_;
    void* reader_;  ///< minizip's unzFile
};

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
