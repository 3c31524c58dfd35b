#include "solver/batch/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
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

}  // namespace ashimpact::batch
