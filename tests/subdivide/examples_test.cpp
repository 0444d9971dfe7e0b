/// The meshes of the project's examples: OpenSubdiv's away from poles, circles and planes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "sinew/io/skeleton_formats.h"
#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"
#include "subdivide/open_subdiv.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// Vertices of poles, circles and planes and those within so many rings of faces around them.
std::vector<bool> near_features(const QuadMesh& mesh, int rings) {
    std::vector<bool> near(mesh.vertex_count(), false);
    for (const std::uint32_t pole : mesh.features.poles) near[pole] = true;
    for (const Circle& circle : mesh.features.circles)
        for (const MeshEdge& edge : circle.edges) near[edge[0]] = near[edge[1]] = true;
    for (const Plane& plane : mesh.features.planes)
        for (const std::uint32_t f : plane.faces)
            for (const std::uint32_t v : mesh.face(f)) near[v] = true;
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<bool> before = near;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f);
            if (std::any_of(face.begin(), face.end(), [&](std::uint32_t v) { return before[v]; }))
                for (const std::uint32_t v : face) near[v] = true;
        }
    }
    return near;
}

QuadMesh without_features(QuadMesh mesh) {
    mesh.features.poles.clear();
    mesh.features.circles.clear();
    mesh.features.planes.clear();
    return mesh;
}

/// Vertices of a finer level of plain faces that lie on control faces away from features. Finer faces are the
/// corners of the coarser ones, so each knows its control face.
std::vector<bool> away_from_features(const QuadMesh& control, const QuadMesh& finer, int level) {
    const std::vector<bool> near = near_features(control, 2);
    std::vector<bool> away(finer.vertex_count(), false);
    for (std::size_t g = 0; g < finer.face_count(); ++g) {
        const std::size_t corner = g >> (2 * (level - 1));
        const auto next = std::upper_bound(control.face_offsets.begin(), control.face_offsets.end(), corner);
        const auto face = control.face(std::size_t(next - control.face_offsets.begin()) - 1);
        if (std::any_of(face.begin(), face.end(), [&](std::uint32_t v) { return near[v]; })) continue;
        for (const std::uint32_t v : finer.face(g)) away[v] = true;
    }
    return away;
}

/// Whether a mesh has a vertex at a place: its positions, sorted by x.
bool has_vertex(const std::vector<Vec3f>& sorted, const Vec3f& place, float allowed) {
    auto at = std::lower_bound(sorted.begin(), sorted.end(), place.x() - allowed,
                               [](const Vec3f& p, float x) { return p.x() < x; });
    for (; at != sorted.end() && at->x() <= place.x() + allowed; ++at)
        if ((*at - place).norm() <= allowed) return true;
    return false;
}

/// @returns how many vertices away from features there are
std::ptrdiff_t expect_features_keep_to_themselves(const QuadMesh& mesh, const QuadMesh& plain, int level) {
    auto positions = subdivide(mesh, {.levels = level})->positions;
    std::sort(positions.begin(), positions.end(),
              [](const Vec3f& a, const Vec3f& b) { return a.x() < b.x(); });
    const std::vector<bool> away = away_from_features(mesh, plain, level);
    std::ptrdiff_t lost = 0;
    const auto allowed = static_cast<float>(1e-6 * open_subdiv::size_of(mesh));
    for (std::size_t v = 0; v < away.size(); ++v)
        lost += away[v] && !has_vertex(positions, plain.positions[v], allowed);
    EXPECT_EQ(lost, 0) << "level " << level;
    return std::count(away.begin(), away.end(), true);
}

TEST(Examples, SubdivideAsOpenSubdivDoes) {
    std::ptrdiff_t files = 0, compared = 0;
    for (const auto& entry : fs::recursive_directory_iterator(SINEW_EXAMPLES)) {
        if (entry.path().extension() != ".sinew") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const auto read = read_skeleton(entry.path().string());
        ASSERT_TRUE(read) << read.error().text();
        const auto skinned = skin(read->document);
        ASSERT_TRUE(skinned) << skinned.error().text();
        const QuadMesh plain = without_features(skinned->mesh);
        for (int level = 1; level <= 2; ++level) {
            SCOPED_TRACE(level);
            const QuadMesh finer = *subdivide(plain, {.levels = level});
            open_subdiv::expect_same(plain, finer, open_subdiv::subdivide(plain, level).back());
            compared += expect_features_keep_to_themselves(skinned->mesh, finer, level);
        }
        ++files;
    }
    EXPECT_GE(files, 13);
    EXPECT_GT(compared, 10000);
}

}  // namespace
}  // namespace sinew
