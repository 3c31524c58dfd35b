// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/table/rows.hpp"

#include <cstring>
#include <stdexcept>

#include <zlib.h>

#include "pipeline/files/sha256.hpp"

namespace ashimpact {

namespace {

/// HDF5's shuffle: the first bytes of all numbers, then the second ones, ...
std::vector<unsigned char> shuffled(const std::vector<double>& column, std::size_t rows) {
    std::vector<double> padded = column;
    padded.resize(rows, 0.0);
    std::vector<unsigned char> plain(rows * sizeof(double));
    std::memcpy(plain.data(), padded.data(), plain.size());
    std::vector<unsigned char> bytes(plain.size());
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t byte = 0; byte < sizeof(double); ++byte)
            bytes[byte * rows + row] = plain[row * sizeof(double) + byte];
    return bytes;
}

std::vector<unsigned char> deflated(const std::vector<unsigned char>& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<unsigned char> packed(size);
    const int status =
        compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), deflate_level);
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

std::string pack_rows(const std::vector<std::vector<double>>& columns, std::size_t rows) {
    std::string packed;
    for (const auto& column : columns) {
        const auto bytes = deflated(shuffled(column, rows));
        const auto length = static_cast<std::uint32_t>(bytes.size());
        const std::size_t at = packed.size();
        packed.resize(at + sizeof(length) + bytes.size());
        std::memcpy(packed.data() + at, &length, sizeof(length));
        std::memcpy(packed.data() + at + sizeof(length), bytes.data(), bytes.size());
    }
    return packed;
}

std::string sealed_rows(std::uint64_t chunk, const std::string& packed) {
    const std::uint64_t length = packed.size();
    std::string sealed = digest_of(chunk, packed);
    sealed.append(reinterpret_cast<const char*>(&length), sizeof(length));
    return sealed + packed;
}

std::vector<std::string> read_sealed_rows(std::istream& stream, std::uint64_t chunk, std::size_t columns) {
    std::string digest(digest_length, '\0');
    std::uint64_t length = 0;
    stream.read(digest.data(), static_cast<std::streamsize>(digest.size()));
    stream.read(reinterpret_cast<char*>(&length), sizeof(length));
    if (!stream || length > most_packed_bytes) throw DamagedRows(chunk);
    std::string packed(length, '\0');
    stream.read(packed.data(), static_cast<std::streamsize>(length));
    if (!stream || digest != digest_of(chunk, packed)) throw DamagedRows(chunk);
    std::vector<std::string> read;
    std::size_t at = 0;
    for (std::size_t column = 0; column < columns; ++column) {
        std::uint32_t size = 0;
        if (packed.size() - at < sizeof(size)) throw DamagedRows(chunk);
        std::memcpy(&size, packed.data() + at, sizeof(size));
        at += sizeof(size);
        if (packed.size() - at < size) throw DamagedRows(chunk);
        read.push_back(packed.substr(at, size));
        at += size;
    }
    if (at != packed.size()) throw DamagedRows(chunk);
    return read;
}

}  // namespace ashimpact
