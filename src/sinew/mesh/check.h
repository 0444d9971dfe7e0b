/// @file check.h
/// Everything one may want to know of a mesh, in one call.
#pragma once

#include <optional>

#include "sinew/base/progress.h"
#include "sinew/base/result.h"
#include "sinew/mesh/deviation.h"
#include "sinew/mesh/intersect.h"
#include "sinew/mesh/measure.h"
#include "sinew/mesh/validate.h"

namespace sinew {

struct CheckOptions {
    bool self_intersections = true;     ///< the only part that takes long
    const RoundCones* cones = nullptr;  ///< the skeleton's, where the deviation from them is wanted too
};

struct MeshReport {
    Validation validation;
    Measures measures;  ///< as far as the mesh is well formed
    std::optional<std::vector<FacePair>>
        intersections;                   ///< where they were wanted, and the mesh is well formed
    bool all_intersections = true;       ///< false: there may be more of them (intersect.h)
    std::optional<Deviation> deviation;  ///< the same, with at least one cone

    /// The surface of a body that does not run through itself, as far as was looked at; not where the search
    /// was given up.
    bool clean() const {
        return validation.solid() && !measures.zero_area && all_intersections &&
               (!intersections || intersections->empty());
    }
};

/// Looks at a mesh from all sides: any mesh, however broken. Fails only when it is stopped.
Result<MeshReport> check(const QuadMesh& mesh, const CheckOptions& options = {},
                         const Progress& progress = {});

}  // namespace sinew
