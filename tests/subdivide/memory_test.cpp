/// What subdivision takes at its peak. A program of its own, since it counts all that is allocated.
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "sinew/subdivide/subdivide.h"
#include "subdivide/feature_shapes.h"
#include "subdivide/random_mesh.h"

namespace {
std::atomic<std::size_t> in_use = 0, peak = 0;
}

// NOLINTBEGIN: the names are the language's.
void* operator new(std::size_t size) {
    void* const place = std::malloc(size > 0 ? size : 1);
    if (!place) throw std::bad_alloc();
    const std::size_t now = in_use += malloc_usable_size(place);
    for (std::size_t seen = peak; seen < now && !peak.compare_exchange_weak(seen, now);) {
    }
    return place;
}
void operator delete(void* place) noexcept {
    in_use -= malloc_usable_size(place);
    std::free(place);
}
void operator delete(void* place, std::size_t) noexcept {
    in_use -= malloc_usable_size(place);
    std::free(place);
}
// NOLINTEND

namespace sinew {
namespace {

std::size_t bytes_of(const Features& features) {
    std::size_t bytes =
        sizeof(Crease) * features.creases.size() + 4 * (features.corners.size() + features.poles.size());
    for (const Circle& circle : features.circles)
        bytes += sizeof(circle) + sizeof(MeshEdge) * circle.edges.size();
    for (const Plane& plane : features.planes) bytes += sizeof(plane) + 4 * plane.faces.size();
    return bytes;
}

std::size_t bytes_of(const QuadMesh& mesh) {
    return bytes_of(mesh.features) + sizeof(Vec3f) * mesh.vertex_count() +
           4 * (mesh.corners.size() + mesh.face_offsets.size()) +
           4 * (mesh.vertex_node.size() + mesh.vertex_bone.size() + mesh.vertex_along.size());
}

/// Some kilobytes for small lists come on top: small meshes are no matter.
constexpr std::size_t small_change = 48 << 10;

TEST(Memory, IsAtMostTwoAndAHalfTimesTheResult) {
    shapes::RandomMesh random(3);
    const QuadMesh meshes[] = {shapes::torus(60, 50), random.make(shapes::torus(60, 50), {.crease = 0.2}),
                               shapes::tube(40, 12),  shapes::flat_tube(40, 12),
                               shapes::box(),         shapes::cone(50, 2)};
    for (const QuadMesh& mesh : meshes)
        for (const bool limit : {false, true})
            for (const int levels : {1, 2, 4}) {
                const std::size_t before = in_use;
                peak = before;
                const QuadMesh finer = *subdivide(mesh, {.levels = levels, .limit = limit});
                EXPECT_LE(peak - before, bytes_of(finer) * 5 / 2 + small_change)
                    << mesh.vertex_count() << " vertices, level " << levels << (limit ? ", limit" : "")
                    << ", " << double(peak - before) / double(bytes_of(finer));
            }
}

}  // namespace
}  // namespace sinew
