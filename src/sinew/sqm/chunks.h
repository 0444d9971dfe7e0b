/// @file chunks.h
/// Many joints or paths whose results have sizes that only the work itself can tell.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace sinew::sqm {

/// Makes parts of the result in parallel, `chunk` items each, and appends them in their order: so the result
/// is the same for any number of threads. A few parts at a time: their memory is used again and stays in the
/// caches.
/// @param make    (Part& part, begin, end) clears the part and fills it with what comes of items begin .. end
/// - 1
/// @param append  (const Part& part)
template <class Part, class Make, class Append>
void for_chunks(std::int32_t items, std::int32_t chunk, Make make, Append append) {
    const std::int32_t chunks = (items + chunk - 1) / chunk,
                       threads = tbb::this_task_arena::max_concurrency();
    std::vector<Part> parts(std::min(chunks, threads == 1 ? 1 : 4 * threads));
    for (std::int32_t first = 0, count = 0; first < chunks; first += count) {
        count = std::min(chunks - first, static_cast<std::int32_t>(parts.size()));
        tbb::parallel_for(std::int32_t{0}, count, [&](std::int32_t i) {
            const std::int32_t begin = (first + i) * chunk;
            make(parts[i], begin, std::min(items, begin + chunk));
        });
        for (std::int32_t i = 0; i < count; ++i) append(parts[i]);
    }
}

}  // namespace sinew::sqm
