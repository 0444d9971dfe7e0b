/// @file surface_rules.h
/// All that decides what smooth surface a control mesh stands for, besides its faces: the features of the
/// mesh, looked up in its topology.
#pragma once

#include "sinew/mesh/flats.h"
#include "sinew/mesh/rounds.h"

namespace sinew {

struct SurfaceRules {
    Sharpness sharpness;
    Fans fans;
    Rounds rounds;
    Flats flats;
};

/// Fails (ErrorKind::input) for features that name what the mesh has not.
/// @param mesh   one that check_control_mesh passed
/// @param poles  mesh.features.poles, or those that detect_poles finds
Result<SurfaceRules> resolve_rules(const QuadMesh& mesh, const Topology& topology,
                                   std::span<const std::uint32_t> poles);

/// Subdivision takes any polygon mesh, open or not manifold, but refuses one that is not well formed, whose
/// positions are not finite, or that has a face of fewer than three corners or with a vertex twice. Names the
/// first such place.
Result<void> check_control_mesh(const QuadMesh& mesh);

}  // namespace sinew
