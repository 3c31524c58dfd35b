// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace ashimpact::batch {

/// Calls @p body(first, size) for consecutive chunks of @p count items on @p threads threads (0: one for each
/// core). Every chunk but the last has @p chunk items. Any thread may get a chunk, so the result of a chunk
/// must not depend on the thread. Exceptions from a body are rethrown.
void for_chunks(std::size_t count, std::size_t chunk, int threads,
                const std::function<void(std::size_t, std::size_t)>& body);

/// Calls @p body(i) for each of @p count items, which may take very different times, on one thread for each
/// core. A thread that waits within one item does not begin another one. @p body must not throw.
void for_each_item(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace ashimpact::batch
