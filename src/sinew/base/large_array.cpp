#include "sinew/base/large_array.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace sinew {

void advise_large_pages([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t large = 2u << 20;
    if (bytes < 2 * large) return;
    const auto from = reinterpret_cast<std::uintptr_t>(begin), to = from + bytes;
    const std::uintptr_t first = (from + large - 1) / large * large, last = to / large * large;
    if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

}  // namespace sinew
