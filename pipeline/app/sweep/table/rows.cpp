// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/table/rows.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "core/text/error.hpp"
#include "pipeline/app/sweep/workers/bytes.hpp"
#include "pipeline/files/sha256.hpp"

namespace ashimpact {

namespace {

/// HDF5's shuffle: the first bytes of all numbers, then the second ones, ...
std::string shuffled(std::vector<double> column, std::size_t rows) {
    column.resize(rows, 0.0);
    const auto* const plain = reinterpret_cast<const char*>(column.data());
    std::string bytes(rows * sizeof(double), '\0');
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t byte = 0; byte < sizeof(double); ++byte)
            bytes[byte * rows + row] = plain[row * sizeof(double) + byte];
    return bytes;
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                 reinterpret_cast<const Bytef*>(bytes.data()),
                                 static_cast<uLong>(bytes.size()), deflate_level);
    if (status != Z_OK) throw std::runtime_error("zlib cannot deflate a chunk of the table");
    packed.resize(size);
    return packed;
}

constexpr std::size_t digest_length = 64;  ///< of a SHA-256 in hexadecimal
/// Beyond the rows of any chunk: a length above it is damaged, and no memory is asked for.
constexpr std::uint64_t most_packed_bytes = std::uint64_t{1} << 28U;

std::string digest_of(std::uint64_t chunk, const std::string& packed) {
    return sha256(std::to_string(chunk) + "\n" + packed);
}

}  // namespace

std::string sealed_rows(std::uint64_t chunk, const std::vector<std::vector<double>>& columns,
                        std::size_t rows) {
    std::vector<std::string> packed_columns;
    for (const auto& column : columns) packed_columns.push_back(deflated(shuffled(column, rows)));
    const std::string packed_rows = packed(std::move(packed_columns));
    return digest_of(chunk, packed_rows) + packed(packed_rows);
}

std::vector<std::string> read_sealed_rows(std::istream& stream, std::uint64_t chunk, std::size_t columns) {
    std::string digest(digest_length, '\0');
    std::uint64_t length = 0;
    stream.read(digest.data(), static_cast<std::streamsize>(digest.size()));
    stream.read(reinterpret_cast<char*>(&length), sizeof(length));
    if (!stream || length > most_packed_bytes) throw DamagedRows(chunk);
    std::string packed_rows(length, '\0');
    stream.read(packed_rows.data(), static_cast<std::streamsize>(length));
    if (!stream || digest != digest_of(chunk, packed_rows)) throw DamagedRows(chunk);
    auto read = unpacked<std::vector<std::string>>(packed_rows);  // as they were written: the digest agrees
    if (read.size() != columns) throw DamagedRows(chunk);
    return read;
}

RowLog::RowLog(std::filesystem::path path) : path_(std::move(path)) {
    for (;;) {
        file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (file_ < 0) refuse("written");
        const bool locked = flock(file_, LOCK_EX | LOCK_NB) == 0;
        if (locked && is_current()) return;
        close(file_);
        if (!locked)
            throw InputError("another sweep writes here", "another -o, or patience")
                .at(FileName{path_.string()});
    }
}

RowLog::~RowLog() {
    struct stat status {};
    if (fstat(file_, &status) == 0 && status.st_size == 0 && is_current()) unlink(path_.c_str());
    close(file_);
}

bool RowLog::is_current() const {
    struct stat own {};
    struct stat named {};
    return fstat(file_, &own) == 0 && stat(path_.c_str(), &named) == 0 && own.st_dev == named.st_dev &&
           own.st_ino == named.st_ino;
}

void RowLog::resume(std::uint64_t size) {
    struct stat status {};
    if (fstat(file_, &status) == 0 && static_cast<std::uint64_t>(status.st_size) < size)
        throw InputError("is shorter than its checkpoint says", "--restart to begin anew")
            .at(FileName{path_.string()});
    truncate(size);
    if (size == 0) append(row_log_mark);
}

void RowLog::clear() {
    truncate(0);
}

void RowLog::truncate(std::uint64_t size) {
    if (ftruncate(file_, static_cast<off_t>(size)) != 0 || lseek(file_, 0, SEEK_END) < 0) refuse("written");
    size_ = size;
}

void RowLog::append(std::string_view rows) {
    size_ += rows.size();
    while (!rows.empty()) {
        const ssize_t written = write(file_, rows.data(), rows.size());
        if (written < 0 && errno != EINTR) refuse("written");
        if (written > 0) rows.remove_prefix(static_cast<std::size_t>(written));
    }
}

void RowLog::sync() {
    if (fdatasync(file_) != 0) refuse("written");
}

void RowLog::refuse(const std::string& doing) const {
    throw InputError("cannot be " + doing + ": " + std::generic_category().message(errno),
                     "a place you may write to")
        .at(FileName{path_.string()});
}

}  // namespace ashimpact
