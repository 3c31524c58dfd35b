// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/fuzz/stored_zip.hpp"

#include <cstdint>

#include <zlib.h>

namespace ashimpact::test {

namespace {

/// Appends the lowest bytes of a number, lowest first.
void append(std::string& bytes, std::uint64_t number, int count) {
    for (int i = 0; i < count; ++i, number >>= 8U) bytes += static_cast<char>(number & 0xFFU);
}

/// What a member's header and its entry in the directory have in common (PKWARE's APPNOTE, 4.3.7 and 4.3.12).
std::string description_of(const ZipMember& member) {
    std::string bytes;
    append(bytes, 20, 2);         // version needed: 2.0
    append(bytes, 0, 2 + 2 + 4);  // flags, method: stored, time and date
    append(bytes,
           crc32(0, reinterpret_cast<const Bytef*>(member.content.data()),
                 static_cast<uInt>(member.content.size())),
           4);
    append(bytes, member.content.size(), 4);  // as it is stored
    append(bytes, member.content.size(), 4);  // as it is unpacked
    append(bytes, member.name.size(), 2);
    append(bytes, 0, 2);  // no extra field
    return bytes;
}

}  // namespace

std::string stored_zip(const std::vector<ZipMember>& members) {
    std::string bytes, directory;
    for (const ZipMember& member : members) {
        const std::string description = description_of(member);
        directory += "PK\1\2";
        append(directory, 20, 2);  // version of the writer
        directory += description;
        append(directory, 0, 2 + 2 + 2 + 4);  // no comment, first disk, attributes
        append(directory, bytes.size(), 4);
        directory += member.name;
        bytes += "PK\3\4";
        bytes += description;
        bytes += member.name;
        bytes += member.content;
    }
    const std::size_t begin = bytes.size();
    bytes += directory;
    bytes += "PK\5\6";
    append(bytes, 0, 2 + 2);  // one disk
    append(bytes, members.size(), 2);
    append(bytes, members.size(), 2);
    append(bytes, directory.size(), 4);
    append(bytes, begin, 4);
    append(bytes, 0, 2);  // no comment
    return bytes;
}

}  // namespace ashimpact::test
