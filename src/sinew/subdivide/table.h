/// @file table.h
/// Large arrays that are written once.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "sinew/base/large_array.h"

namespace sinew {

/// Allocates for a vector that does not write zeros first to what is filled in afterwards.
template <class T>
struct TableAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = TableAllocator<U>;
    };

    T* allocate(std::size_t size) {
        T* const begin = std::allocator<T>::allocate(size);
        advise_large_pages(begin, size * sizeof(T));
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
