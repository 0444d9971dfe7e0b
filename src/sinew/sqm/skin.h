/// @file skin.h
/// Skeleton in, clean quads out: the whole method as one call.
#pragma once

#include <cstdint>
#include <optional>

#include "sinew/base/progress.h"
#include "sinew/base/result.h"
#include "sinew/mesh/quad_mesh.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// What the radii of the skeleton are those of.
enum class Fit : std::uint8_t {
    control,  ///< the mesh as it is
    limit,    ///< the smooth surface that subdivision makes of the mesh: its vertices stand further out
};

/// Which stage's result to show as a mesh; the last one is the finished mesh.
enum class SkinStage : std::uint8_t { polyhedra, refine, bridge, place };

struct SkinOptions {
    int sides = 0;  ///< vertices round every tube; 0: as few as each joint allows, at least 4
    Fit fit = Fit::control;
    bool repair = false;  ///< thin out and merge nodes far closer than a radius (for measured skeletons)
    SkinStage stage = SkinStage::place;
    std::optional<double> blend;     ///< instead of Document::blend, for nodes that have none of their own
    std::optional<Density> density;  ///< instead of Document::density
};

struct Skin {
    QuadMesh mesh;
    std::int64_t components = 0;  ///< of the conditioned skeleton
    std::int64_t cycles = 0;  ///< of the conditioned skeleton: the Euler number is 2 components - 2 cycles
    std::int64_t irregular =
        0;  ///< at most this many vertices of a valence other than 4: sum of 2 (degree - 2), and the poles
    Warnings warnings;  ///< what conditioning did and what could not be done as drawn
};

/// Skins a document. Fails for a document that validate() refuses, for a node type that this version cannot
/// skin, and when it is stopped. The same document gives the same bytes on every run, machine and number of
/// threads.
Result<Skin> skin(const Document& document, const SkinOptions& options = {}, const Progress& progress = {});

}  // namespace sinew
