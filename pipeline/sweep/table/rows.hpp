#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ashimpact {

/// Packs the columns of one chunk of the table, each as HDF5's filters shuffle and deflate would: so threads
/// do the work, and the file takes the bytes as they are. A short last chunk is filled up with zeros to @p
/// rows, as HDF5 stores it.
[[nodiscard]] std::string pack_rows(const std::vector<std::vector<double>>& columns, std::size_t rows);

/// How hard the table is deflated: numbers at full precision shrink little however hard one tries.
inline constexpr int deflate_level = 1;

/// Reads the length that stands before a packed column.
[[nodiscard]] std::uint32_t packed_length(std::string_view bytes);
inline constexpr std::size_t packed_length_size = sizeof(std::uint32_t);

}  // namespace ashimpact
