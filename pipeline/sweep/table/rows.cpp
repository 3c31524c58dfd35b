#include "pipeline/sweep/table/rows.hpp"

#include <zlib.h>

#include <cstring>
#include <stdexcept>

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

std::uint32_t packed_length(std::string_view bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof(length));
    return length;
}

}  // namespace ashimpact
