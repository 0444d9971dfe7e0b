/// @file parallel.h
/// Work on all elements of a level, in pieces that are worth a task.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace sinew {

/// @param body  called with each number below count, from any thread
template <class Number, class Body>
void for_each_in_parallel(Number count, const Body& body) {
    constexpr std::size_t grain = 2048;
    tbb::parallel_for(tbb::blocked_range<Number>(0, count, grain), [&](const auto& range) {
        for (Number i = range.begin(); i < range.end(); ++i) body(i);
    });
}

}  // namespace sinew
