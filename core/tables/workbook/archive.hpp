// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace ashimpact
