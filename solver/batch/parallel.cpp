#include "solver/batch/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace ashimpact::batch {

void for_chunks(std::size_t count, std::size_t chunk, int threads,
                const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t chunks = (count + chunk - 1) / chunk;
    const auto one = [&](std::size_t i) { body(i * chunk, std::min(chunk, count - i * chunk)); };
    if (threads == 1 || chunks <= 1) {
        for (std::size_t i = 0; i < chunks; ++i) one(i);
        return;
    }
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, one); });
}

void for_each_item(std::size_t count, const std::function<void(std::size_t)>& body) {
    // Isolated: a thread that waits within the work of one item must not begin another item, which might wait
    // for something that the first one holds.
    const auto isolated = [&](std::size_t i) { tbb::this_task_arena::isolate([&] { body(i); }); };
    tbb::parallel_for(std::size_t{0}, count, isolated, tbb::simple_partitioner{});
}

}  // namespace ashimpact::batch
