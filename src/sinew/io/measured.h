/// @file measured.h
/// What the readers of measured formats share: remarks and repair. For the sources of this folder only.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/io/skeleton_file.h"

namespace sinew {

/// Remarks by kind. A kind's text becomes "3 nodes had no radius and ... (the first on line 7)".
class Remarks {
  public:
    /// @param noun       what is counted, in the singular
    /// @param predicate  what is said of one or several of them
    void note(std::string_view noun, std::string_view predicate, std::int64_t node, std::int64_t line = 0);

    /// The warnings; in a strict reading the first as an error.
    Result<Warnings> take(bool strict) const;

  private:
    struct Kind {
        std::string noun, predicate;
        std::int64_t count = 0, line = 0;
        std::vector<std::int64_t> nodes;
    };
    static std::string text(const Kind& kind, bool with_line);
    std::vector<Kind> kinds_;
};

/// Gives each node without a positive radius that of the nearest node which has one, nearest along the bones;
/// where its component has none, a guess (guess_radii).
/// @param lines  where the nodes stand in the file: empty, or one a node
void repair_radii(Document& document, std::span<const std::int64_t> lines, Remarks& remarks);

/// Remarks on bones without a length, whose ends conditioning will merge.
void note_zero_lengths(const Document& document, std::span<const std::int64_t> lines, Remarks& remarks);

/// A radius for each node of a skeleton that has none: a fifth of the mean length of the node's bones. A node
/// whose bones have no length takes the median of the others, and 1 where there are none.
std::vector<double> guess_radii(const Document& document);

}  // namespace sinew
