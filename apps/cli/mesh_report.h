/// @file mesh_report.h
/// What `sinew check` says of a mesh.
#pragma once

#include <optional>

#include "cli/skeleton_report.h"
#include "sinew/mesh/check.h"

namespace sinew::cli {

std::string mesh_text(const std::string& name, const MeshReport& report,
                      const std::optional<SkeletonFacts>& skeleton);
Json mesh_json(const MeshReport& report, const std::optional<SkeletonFacts>& skeleton);

}  // namespace sinew::cli
