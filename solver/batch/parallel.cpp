// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/parallel.hpp"

#include <algorithm>

#if defined(__SANITIZE_THREAD__)
#include <atomic>
#include <thread>
#elif !defined(__EMSCRIPTEN__)
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

namespace ashimpact::batch {

void for_each_item(std::size_t count, const std::function<void(std::size_t)>& body) {
#if defined(__EMSCRIPTEN__)  // no threads in a browser
    for (std::size_t i = 0; i < count; ++i) body(i);
#elif defined(__SANITIZE_THREAD__)
    // The thread sanitizer does not see how the threads of TBB, a library built without it, wait for one
    // another. An exception of the body ends the program.
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads;
    for (int i = 0; i < 3; ++i)
        threads.emplace_back([&] {
            for (std::size_t item = next++; item < count; item = next++) body(item);
        });
#else
    // Isolated: a thread that waits within the work of one item must not begin another item, which might wait
    // for something that the first one holds.
    const auto isolated = [&](std::size_t i) { tbb::this_task_arena::isolate([&] { body(i); }); };
    tbb::parallel_for(std::size_t{0}, count, isolated, tbb::simple_partitioner{});
#endif
}

void for_chunks(std::size_t count, std::size_t chunk, int threads,
                const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t chunks = (count + chunk - 1) / chunk;
    const auto one = [&](std::size_t i) { body(i * chunk, std::min(chunk, count - i * chunk)); };
    if (threads == 1 || chunks <= 1) {
        for (std::size_t i = 0; i < chunks; ++i) one(i);
        return;
    }
#if defined(__EMSCRIPTEN__) || defined(__SANITIZE_THREAD__)
    for_each_item(chunks, one);
#else
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, one); });
#endif
}

}  // namespace ashimpact::batch
