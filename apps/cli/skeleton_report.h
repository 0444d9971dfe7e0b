/// @file skeleton_report.h
/// What `sinew check` says of a skeleton, and what a mesh is held against.
#pragma once

#include "cli/files.h"
#include "sinew/mesh/deviation.h"
#include "sinew/skeleton/condition.h"

namespace sinew::cli {

/// Of the skeleton as the mesher gets it: conditioned.
struct SkeletonFacts {
    std::int64_t nodes = 0;
    std::int64_t bones = 0;
    std::int64_t components = 0;
    std::int64_t cycles = 0;
    std::int64_t leaves = 0;
    std::int64_t branches = 0;
    std::int64_t largest_degree = 0;
    /// Vertices of a valence other than 4 that a mesh of spheres and cones may have at most: 2 (degree - 2)
    /// at each branch node, a pole at each leaf, the 8 corners of a lone ball.
    std::int64_t irregular = 0;
    double least_radius = 0, largest_radius = 0;
    bool plain =
        true;  ///< spheres and cones of round section only, without symmetry: `irregular` and cones hold
    RoundCones cones;   ///< of the skeleton as it was read, nothing thinned out
    Warnings warnings;  ///< what conditioning would do
};

/// The document must be valid.
SkeletonFacts facts_of(const ReadSkeleton& read);

/// Reads a skeleton and tells all that is wrong with it.
Result<Outcome> check_skeleton(Session& session, const Job& job, const FileOptions& files);

}  // namespace sinew::cli
