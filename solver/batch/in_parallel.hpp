// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/batch/parallel.hpp"

namespace ashimpact {

/// Results of @p work for each item, in the order of the items, computed by one thread for each core. They do
/// not depend on the number of threads. If several items fail, the error of the first one is thrown.
template <class Item, class Work>
[[nodiscard]] auto in_parallel(const std::vector<Item>& items, Work&& work) {
    using Result = std::invoke_result_t<Work&, const Item&>;
    std::vector<std::optional<Result>> results(items.size());  // a Result need not be default-constructible
    std::vector<std::exception_ptr> errors(items.size());
    const auto one = [&](std::size_t i) {
        try {
            results[i].emplace(work(items[i]));
        } catch (...) {
            errors[i] = std::current_exception();
        }
    };
    batch::for_each_item(items.size(), one);
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    std::vector<Result> made;
    made.reserve(results.size());
    for (std::optional<Result>& result : results) made.push_back(std::move(*result));
    return made;
}

}  // namespace ashimpact
