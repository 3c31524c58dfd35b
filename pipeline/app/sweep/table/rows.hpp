// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ashimpact {

/// Packs the columns of one chunk of the table as the filters shuffle and deflate of HDF5 would. So threads
/// can do this work, and the file takes the bytes unchanged. A short last chunk is padded with zeros to @p
/// rows, as in HDF5.
[[nodiscard]] std::string pack_rows(const std::vector<std::vector<double>>& columns, std::size_t rows);

/// Level of compression: higher levels hardly shrink numbers of full precision.
inline constexpr int deflate_level = 1;

/// The packed rows of a chunk behind a hash of them and of the chunk's number, and their length, by which
/// damage is detected.
[[nodiscard]] std::string sealed_rows(std::uint64_t chunk, const std::string& packed);

/// Thrown for rows that differ from those that were sealed.
class DamagedRows : public std::runtime_error {
  public:
    explicit DamagedRows(std::uint64_t chunk) : std::runtime_error("damaged rows"), chunk_(chunk) {}
    [[nodiscard]] std::uint64_t chunk() const { return chunk_; }

  private:
    std::uint64_t chunk_;
};

/// Reads the packed columns of the next chunk, which must be that of this number.
/// @throws DamagedRows unless they are there, unchanged
[[nodiscard]] std::vector<std::string> read_sealed_rows(std::istream& stream, std::uint64_t chunk,
                                                        std::size_t columns);

}  // namespace ashimpact
