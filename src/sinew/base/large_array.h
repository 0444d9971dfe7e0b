/// @file large_array.h
/// Room for arrays of many megabytes. Memory that is touched for the first time is handed over by the system
/// page by page, which can cost more than all that is computed into it; large pages make it a few calls.
#pragma once

#include <cstddef>
#include <vector>

namespace sinew {

/// Asks the system to back a range with large pages, where it knows how (Linux) and the range is worth it.
/// Never more than a hint.
void advise_large_pages(const void* begin, std::size_t bytes);

template <class T>
void reserve_large(std::vector<T>& array, std::size_t count) {
    array.reserve(count);
    advise_large_pages(array.data(), count * sizeof(T));
}
template <class T>
void resize_large(std::vector<T>& array, std::size_t count, const T& value = T()) {
    reserve_large(array, count);
    array.resize(count, value);
}

}  // namespace sinew
