// SPDX-License-Identifier: GPL-3.0-or-later
// parallel.hpp where there are no threads: in a browser.
#include <algorithm>

#include "solver/batch/parallel.hpp"

namespace ashimpact::batch {

void for_chunks(std::size_t count, std::size_t chunk, int /*threads*/,
                const std::function<void(std::size_t, std::size_t)>& body) {
    for (std::size_t first = 0; first < count; first += chunk) body(first, std::min(chunk, count - first));
}

void for_each_item(std::size_t count, const std::function<void(std::size_t)>& body) {
    for (std::size_t i = 0; i < count; ++i) body(i);
}

}  // namespace ashimpact::batch
