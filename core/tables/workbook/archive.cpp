// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstring>

#include <minizip/unzip.h>

#include "core/tables/workbook/formats.hpp"
#include "core/text/error.hpp"

namespace ashimpact {

namespace {

/// The calls by which minizip reads a file, for one in memory; it is never written.
template <class Bytes>
struct CallsFor {
    static Bytes& of(void* opaque) { return *static_cast<Bytes*>(opaque); }

    static uLong read(void* opaque, void* /*stream*/, void* target, uLong wanted) {
        Bytes& file = of(opaque);
        const std::size_t length = std::min<std::size_t>(wanted, file.all.size() - file.place);
        if (length > 0) std::memcpy(target, file.all.data() + file.place, length);
        file.place += length;
        return static_cast<uLong>(length);
    }

    static long seek(void* opaque, void* /*stream*/, ZPOS64_T offset, int origin) {
        Bytes& file = of(opaque);
        const std::size_t start = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                                  : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.place
                                                                     : file.all.size();
        const std::size_t place = start + static_cast<std::size_t>(offset);  // wraps for an offset below zero
        if (place > file.all.size()) return -1;
        file.place = place;
        return 0;
    }

    static zlib_filefunc64_def make(Bytes& file) {
        zlib_filefunc64_def calls{};
        calls.zopen64_file = [](void* opaque, const void* /*name*/, int /*mode*/) { return opaque; };
        calls.zread_file = read;
        calls.zwrite_file = [](void*, void*, const void*, uLong) -> uLong { return 0; };
        calls.ztell64_file = [](void* opaque, void*) -> ZPOS64_T { return of(opaque).place; };
        calls.zseek64_file = seek;
        calls.zclose_file = [](void*, void*) { return 0; };
        calls.zerror_file = [](void*, void*) { return 0; };
        calls.opaque = &file;
        return calls;
    }
};

constexpr auto undamaged = "an undamaged file without a password";

InputError damaged_part(const std::string& name) {
    return InputError("the part " + name + " of the spreadsheet is damaged", undamaged);
}

}  // namespace

Archive::Archive(std::string_view bytes) : bytes_(std::make_unique<Bytes>(Bytes{.all = bytes})) {
    auto calls = CallsFor<Bytes>::make(*bytes_);
    reader_ = unzOpen2_64("", &calls);
    if (!reader_) throw InputError("the file begins as a spreadsheet and is damaged", undamaged);
}

Archive::~Archive() {
    unzClose(reader_);
}

std::optional<std::string> Archive::read(const std::string& name) const {
    constexpr int any_case = 2;
    if (unzLocateFile(reader_, name.c_str(), any_case) != UNZ_OK) return std::nullopt;
    if (unzOpenCurrentFile(reader_) != UNZ_OK) throw damaged_part(name);
    std::string content;
    int length = 0;
    do {
        constexpr unsigned step = 1 << 16;
        const std::size_t before = content.size();
        content.resize(before + step);
        length = unzReadCurrentFile(reader_, content.data() + before, step);
        content.resize(before + static_cast<std::size_t>(std::max(length, 0)));
    } while (length > 0 && content.size() <= longest_member);
    const bool sound = unzCloseCurrentFile(reader_) == UNZ_OK && length >= 0;
    if (content.size() > longest_member)
        throw InputError("the spreadsheet is too large: its part " + name + " unpacks to more than " +
                             std::to_string(longest_member >> 20) + " MB",
                         "a smaller one, or the table as CSV");
    if (!sound) throw damaged_part(name);
    return content;
}

}  // namespace ashimpact
