// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace ashimpact {

namespace batch {

/// Calls @p body(first, size) for consecutive chunks of @p count items on @p threads threads (0: one for each
/// core). Every chunk but the last has @p chunk items. Any thread may get a chunk, so the result of a chunk
/// must not depend on the thread. Exceptions from a body are rethrown.
void for_chunks(std::size_t count, std::size_t chunk, int threads,
                const std::function<void(std::size_t, std::size_t)>& body);

/// Calls @p body(i) for each of @p count items, which may take very different times, on one thread for each
/// core. A thread that waits within one item does not begin another one. @p body must not throw.
void for_each_item(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace batch

/// Results of @p work for each item, in the order of the items, computed by one thread for each core. They do
/// not depend on the number of threads. If several items fail, the error of the first one is thrown.
template <class Item, class Work>
[[nodiscard]] auto in_parallel(const std::vector<Item>& items, Work&& work) {
    using Result = std::invoke_result_t<Work&, const Item&>;
    std::vector<std::optional<Result>> results(items.size());  // a Result need not be default-constructible
    std::vector<std::exception_ptr> errors(items.size());
    batch::for_each_item(items.size(), [&](std::size_t i) {
        try {
            results[i].emplace(work(items[i]));
        } catch (...) {
            errors[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    std::vector<Result> made;
    made.reserve(results.size());
    for (std::optional<Result>& result : results) made.push_back(std::move(*result));
    return made;
}

}  // namespace ashimpact
