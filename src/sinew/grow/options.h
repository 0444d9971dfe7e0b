/// @file options.h
/// What may be asked of a grammar beside what is written in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sinew {

struct GrowOptions {
    std::optional<int> steps;           ///< default: the file's %steps
    std::optional<std::uint64_t> seed;  ///< default: the file's %seed
    std::int64_t limit = 10'000'000;    ///< most nodes that may grow
    std::vector<std::pair<std::string, double>>
        constants;  ///< instead of the file's; others follow by their formulas
};

}  // namespace sinew
