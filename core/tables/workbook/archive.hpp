// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include <minizip/unzip.h>

#include "core/text/error.hpp"

namespace ashimpact {

/// A file in memory, and the calls by which minizip reads it; it is never written.
struct FileInMemory {
    std::string_view all;
    std::size_t place = 0;

    static FileInMemory& of(void* opaque) { return *static_cast<FileInMemory*>(opaque); }

    static uLong read(void* opaque, void* /*stream*/, void* target, uLong wanted) {
        FileInMemory& file = of(opaque);
        const std::size_t length = std::min<std::size_t>(wanted, file.all.size() - file.place);
        if (length > 0) std::memcpy(target, file.all.data() + file.place, length);
        file.place += length;
        return static_cast<uLong>(length);
    }

    static long seek(void* opaque, void* /*stream*/, ZPOS64_T offset, int origin) {
        FileInMemory& file = of(opaque);
        const std::size_t start = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                                  : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.place
                                                                     : file.all.size();
        const std::size_t place = start + static_cast<std::size_t>(offset);  // wraps for an offset below zero
        if (place > file.all.size()) return -1;
        file.place = place;
        return 0;
    }

    zlib_filefunc64_def make_calls() {
        zlib_filefunc64_def calls{};
        calls.zopen64_file = [](void* opaque, const void* /*name*/, int /*mode*/) { return opaque; };
        calls.zread_file = read;
        calls.zwrite_file = [](void*, void*, const void*, uLong) -> uLong { return 0; };
        calls.ztell64_file = [](void* opaque, void*) -> ZPOS64_T { return of(opaque).place; };
        calls.zseek64_file = seek;
        calls.zclose_file = [](void*, void*) { return 0; };
        calls.zerror_file = [](void*, void*) { return 0; };
        calls.opaque = this;
        return calls;
    }
};

inline constexpr auto undamaged = "an undamaged file without a password";

inline InputError damaged_part(const std::string& name) {
    return InputError("the part " + name + " of the spreadsheet is damaged", undamaged);
}

/// Reads the members of a zip archive that lies in memory. The bytes must outlive the archive.
class Archive {
  public:
    /// @throws InputError if the bytes are no zip archive or a damaged one
    explicit Archive(std::string_view bytes) : file_{bytes} {
        auto calls = file_.make_calls();
        reader_ = unzOpen2_64("", &calls);
        if (!reader_) throw InputError("the file begins as a spreadsheet and is damaged", undamaged);
    }
    ~Archive() { unzClose(reader_); }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    /// A member, unpacked; none if there is no such member.
    /// @throws InputError if it is damaged, protected by a password, or unpacks to more than
    /// `longest_member`, all members to more than `most_bytes`
    [[nodiscard]] std::optional<std::string> read(const std::string& name) {
        constexpr int any_case = 2;
        if (unzLocateFile(reader_, name.c_str(), any_case) != UNZ_OK) return std::nullopt;
        if (unzOpenCurrentFile(reader_) != UNZ_OK) throw damaged_part(name);
        std::string content;
        const std::size_t most = std::min(longest_member, most_bytes - unpacked_);
        int length = 0;
        do {
            constexpr unsigned step = 1 << 16;
            const std::size_t before = content.size();
            content.resize(before + step);
            length = unzReadCurrentFile(reader_, content.data() + before, step);
            content.resize(before + static_cast<std::size_t>(std::max(length, 0)));
        } while (length > 0 && content.size() <= most);
        const bool sound = unzCloseCurrentFile(reader_) == UNZ_OK && length >= 0;
        if (content.size() > most)
            throw InputError("the spreadsheet is too large: its part " + name + " unpacks to more than " +
                                 std::to_string(longest_member >> 20) + " MB, or all parts to more than " +
                                 std::to_string(most_bytes >> 20) + " MB",
                             "a smaller one, or the table as CSV");
        if (!sound) throw damaged_part(name);
        unpacked_ += content.size();
        return content;
    }

  private:
    /// No member that is read may unpack to more [bytes]: a small archive can hold gigabytes.
    static constexpr std::size_t longest_member = std::size_t{8} << 20;
    static constexpr std::size_t most_bytes = std::size_t{64} << 20;  ///< of all members together

    std::size_t unpacked_ = 0;
    FileInMemory file_;
    unzFile reader_ = nullptr;
};

}  // namespace ashimpact
