/// @file table.h
/// Large arrays that are written once.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace sinew {

/// Asks the system to back fresh memory by large pages, where there is enough of it to matter: half of the
/// time of filling a large array is else spent on one page fault for every 4 KiB. Changes nothing but speed.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Gives an empty vector room, in large pages.
template <class T>
void reserve_large(std::vector<T>& list, std::size_t size) {
    list.reserve(size);
    prefer_large_pages(list.data(), size * sizeof(T));
}

/// Allocates for a vector that does not write zeros first to what is filled in afterwards.
template <class T>
struct TableAllocator : std::allocator<T> {
    template <class U>
    struct rebind {                       // NOLINT(readability-identifier-naming): the library's name
        using other = TableAllocator<U>;  // NOLINT(readability-identifier-naming)
    };

    T* allocate(std::size_t size) {
        T* const begin = std::allocator<T>::allocate(size);
        prefer_large_pages(begin, size * sizeof(T));
        return begin;
    }
    template <class U>
    void construct(U* place) noexcept {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }
};
template <class T>
using Table = std::vector<T, TableAllocator<T>>;

}  // namespace sinew
