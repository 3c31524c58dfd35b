#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ashimpact {

/// Packs the columns of one chunk of the table, each as HDF5's filters shuffle and deflate would: so threads
/// do the work, and the file takes the bytes as they are. A short last chunk is filled up with zeros to @p
/// rows, as HDF5 stores it.
[[nodiscard]] std::string pack_rows(const std::vector<std::vector<double>>& columns, std::size_t rows);

/// How hard the table is deflated: numbers at full precision shrink little however hard one tries.
inline constexpr int deflate_level = 1;

/// The packed rows of a chunk with what proves them whole: a hash of them and of the chunk's number, and
/// their length, before them.
[[nodiscard]] std::string sealed_rows(std::uint64_t chunk, const std::string& packed);

/// Rows that are not those that were sealed.
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
