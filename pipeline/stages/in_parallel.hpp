#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace ashimpact {

/// What @p work makes of each item, in their order, by as many threads as the machine has cores. The result
/// does not depend on their number: each item is worked on alone. Of several errors the first item's is
/// thrown.
template <class Item, class Work>
[[nodiscard]] auto in_parallel(const std::vector<Item>& items, Work&& work) {
    using Result = std::invoke_result_t<Work&, const Item&>;
    std::vector<std::optional<Result>> results(items.size());  // a result need not exist before its work
    std::vector<std::exception_ptr> errors(items.size());
    std::atomic<std::size_t> next{0};
    const auto worker = [&] {
        for (std::size_t i = next++; i < items.size(); i = next++) {
            try {
                results[i].emplace(work(items[i]));
            } catch (...) {
                errors[i] = std::current_exception();
            }
        }
    };
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < std::min(cores, items.size()); ++i) helpers.emplace_back(worker);
    worker();
    for (std::thread& helper : helpers) helper.join();
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    std::vector<Result> made;
    made.reserve(results.size());
    for (std::optional<Result>& result : results) made.push_back(std::move(*result));
    return made;
}

}  // namespace ashimpact
