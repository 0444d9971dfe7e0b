/// @file room.h
/// Does a level fit? Answered from the counts of the control mesh, before anything is built.
#pragma once

#include <cstdint>

#include "sinew/base/result.h"
#include "sinew/subdivide/level.h"

namespace sinew {

struct LevelCounts {
    std::uint64_t vertices = 0;
    std::uint64_t edges = 0;
    std::uint64_t faces = 0;
    std::uint64_t slots = 0;
};

/// Counts after some splits; they stop growing where they would pass 2^60.
LevelCounts counts_after(const Level& control, int splits);

/// Bytes that subdividing takes at its peak beside the control mesh: the finest mesh, the tables and the
/// positions of all the levels before it.
/// @param origins  bytes a vertex of what the mesh knows of where its vertices came from
std::uint64_t bytes_needed(const Level& control, int splits, bool limit, std::uint64_t origins);

/// Bytes that can still be taken without swapping: what the machine, the process and its control group leave;
/// the greatest number where none of them can be asked.
std::uint64_t bytes_available();

/// Fails (ErrorKind::call) where the finest level has too many corners for 32-bit indices or needs more than
/// `available`.
Result<void> check_room(const Level& control, int splits, bool limit, std::uint64_t origins,
                        std::uint64_t available);

}  // namespace sinew
