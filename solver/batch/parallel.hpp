#pragma once

#include <cstddef>
#include <functional>

namespace ashimpact::batch {

/// Calls @p body(first, size) for the consecutive chunks of @p count items, all of @p chunk but the last, on
/// @p threads threads (0: one a core). Which thread gets a chunk is left open, so a chunk's result must not
/// depend on it. An exception from a body is passed on.
void for_chunks(std::size_t count, std::size_t chunk, int threads,
                const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace ashimpact::batch
