/// @file mesh_round_trip.h
/// What must hold of every mesh that a reader lets through.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "sinew/io/mesh_formats.h"
#include "sinew/mesh/check.h"

namespace sinew {

inline void demand(bool holds) {
    if (!holds) std::abort();
}

/// Reads the bytes: an error names the file; a mesh is well formed, finite and made of polygons, can be
/// checked from all sides, and comes back the same after being written and read again.
inline int check_mesh_reader(const std::uint8_t* data, std::size_t size, FormatName format) {
    const Result<QuadMesh> mesh = parse_mesh({reinterpret_cast<const char*>(data), size}, format, "fuzz");
    if (!mesh) {
        demand(mesh.error().file == "fuzz" && !mesh.error().text().empty());
        return 0;
    }
    const Result<MeshReport> report = check(*mesh, {.self_intersections = mesh->face_count() < 200});
    demand(report.has_value());
    demand(report->validation.well_formed() && report->validation.finite() &&
           !report->validation.small_faces);
    demand(mesh->face_count() > 0);
    if (format == FormatName::gltf) return 0;  // which may cut polygons that repeat vertices
    const Result<QuadMesh> again = parse_mesh(*mesh_bytes(*mesh, format), format, "fuzz");
    demand(again.has_value());
    demand(again->positions == mesh->positions && again->corners == mesh->corners);
    demand(again->face_offsets == mesh->face_offsets);
    return 0;
}

}  // namespace sinew
