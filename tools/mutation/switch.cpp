#include "switch.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace sinew_mutation {
namespace {

constexpr int most = 1 << 16;
std::atomic<char> reached[most], impossible[most];

struct Notes {
    const char* file = std::getenv("SINEW_REACHED");
    ~Notes() {
        std::FILE* out = file ? std::fopen(file, "w") : nullptr;
        if (!out) return;
        for (int k = 0; k < most; ++k)
            if (reached[k] || impossible[k])
                std::fprintf(out, "%d %s\n", k, reached[k] ? "reached" : "impossible");
        std::fclose(out);
    }
} notes;

}  // namespace

bool on(int mutant) {
    static const int chosen = std::getenv("SINEW_MUTANT") ? std::atoi(std::getenv("SINEW_MUTANT")) : -1;
    if (!reached[mutant].load(std::memory_order_relaxed)) reached[mutant].store(1, std::memory_order_relaxed);
    return mutant == chosen;
}

void not_possible(int mutant) { impossible[mutant].store(1, std::memory_order_relaxed); }

}  // namespace sinew_mutation
