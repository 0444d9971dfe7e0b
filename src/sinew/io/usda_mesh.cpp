#include "sinew/io/usda_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "sinew/mesh/topology.h"

namespace sinew {
namespace {

using Problem = std::optional<std::string>;
using Index = std::uint32_t;

/// Appends one Mesh prim; its vertices follow those that are there.
class Appender {
  public:
    Appender(const UsdaMesh& usda, QuadMesh& mesh)
        : usda_(usda), mesh_(mesh), first_vertex_(mesh.vertex_count()) {}

    Problem append() {
        if (auto problem = append_points()) return problem;
        if (auto problem = append_faces()) return problem;
        if (auto problem = append_creases()) return problem;
        return append_corners();
    }

  private:
    std::int64_t vertices() const { return std::ssize(usda_.points) / 3; }

    Problem append_points() {
        if (usda_.points.size() % 3 != 0) return "points do not come in threes";
        for (std::size_t i = 0; i < usda_.points.size(); i += 3) {
            const Vec3f position(usda_.points[i], usda_.points[i + 1], usda_.points[i + 2]);
            if (!position.allFinite()) return fmt::format("point {} is not finite", i / 3);
            mesh_.positions.push_back(position);
        }
        if (mesh_.positions.size() >= no_index) return "more points than 32 bits can count";
        return {};
    }

    Problem append_faces() {
        std::size_t at = 0;
        for (const std::int64_t count : usda_.counts) {
            if (count < 3) return fmt::format("a face of {} corners; three are the least", count);
            if (count > std::ssize(usda_.indices) - static_cast<std::int64_t>(at))
                return "faceVertexIndices are fewer than faceVertexCounts ask for";
            for (std::size_t end = at + static_cast<std::size_t>(count); at < end; ++at) {
                if (auto problem = check_vertex(usda_.indices[at], "a face")) return problem;
                mesh_.corners.push_back(vertex(usda_.indices[at]));
            }
            if (usda_.left_handed) std::reverse(mesh_.corners.end() - count, mesh_.corners.end());
            if (mesh_.corners.size() >= no_index) return "more corners than 32 bits can count";
            mesh_.face_offsets.push_back(static_cast<Index>(mesh_.corners.size()));
        }
        if (at != usda_.indices.size()) return "faceVertexIndices are more than faceVertexCounts ask for";
        return {};
    }

    Problem append_creases() {
        std::int64_t edges = 0;
        for (const std::int64_t length : usda_.crease_lengths) {
            if (length < 2 || length > std::ssize(usda_.crease_indices)) return "a crease of no edge";
            edges += length - 1;
        }
        const std::int64_t sharpnesses = std::ssize(usda_.crease_sharpnesses);
        const bool one_an_edge = sharpnesses != std::ssize(usda_.crease_lengths);
        if (one_an_edge && sharpnesses != edges)
            return "creaseSharpnesses are neither one a crease nor one an edge";
        std::size_t at = 0, edge = 0;
        for (std::size_t c = 0; c < usda_.crease_lengths.size(); ++c, ++at)
            for (std::int64_t i = 1; i < usda_.crease_lengths[c]; ++i, ++at, ++edge) {
                if (at + 1 >= usda_.crease_indices.size())
                    return "creaseIndices are fewer than creaseLengths ask for";
                const std::int64_t a = usda_.crease_indices[at], b = usda_.crease_indices[at + 1];
                if (auto problem = check_vertex(std::min(a, b), "a crease")) return problem;
                if (auto problem = check_vertex(std::max(a, b), "a crease")) return problem;
                const float sharpness = usda_.crease_sharpnesses[one_an_edge ? edge : c];
                if (sharpness > 0) mesh_.features.creases.push_back({{vertex(a), vertex(b)}, sharpness});
            }
        return {};
    }

    Problem append_corners() {
        if (usda_.corner_indices.size() != usda_.corner_sharpnesses.size())
            return "cornerSharpnesses are not one a corner";
        for (std::size_t i = 0; i < usda_.corner_indices.size(); ++i) {
            if (auto problem = check_vertex(usda_.corner_indices[i], "a corner")) return problem;
            if (usda_.corner_sharpnesses[i] >= 10)
                mesh_.features.corners.push_back(vertex(usda_.corner_indices[i]));
        }
        return {};
    }

    Problem check_vertex(std::int64_t index, std::string_view what) const {
        if (index >= 0 && index < vertices()) return {};
        return fmt::format("{} names point {}, but there are {}", what, index, vertices());
    }
    Index vertex(std::int64_t index) const {
        return static_cast<Index>(first_vertex_ + static_cast<std::size_t>(index));
    }

    const UsdaMesh& usda_;
    QuadMesh& mesh_;
    std::size_t first_vertex_;
};

}  // namespace

std::optional<std::string> append_usda_mesh(const UsdaMesh& usda, QuadMesh& mesh) {
    return Appender(usda, mesh).append();
}

}  // namespace sinew
