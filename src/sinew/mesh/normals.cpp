#include "sinew/mesh/normals.h"

#include <tbb/parallel_for.h>

namespace sinew {
namespace {

using Face = std::span<const std::uint32_t>;

void add_corner_normals(const QuadMesh& mesh, Face face, std::vector<Vec3>& sums) {
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 at = mesh.positions[face[i]].cast<double>();
        const Vec3 next = mesh.positions[face[i + 1 == n ? 0 : i + 1]].cast<double>() - at;
        const Vec3 previous = mesh.positions[face[i == 0 ? n - 1 : i - 1]].cast<double>() - at;
        sums[face[i]] += corner_normal(next, previous);
    }
}

Vec3f unit(const Vec3& sum) {
    const double length = sum.norm();
    return length > 0 && std::isfinite(length) ? Vec3f((sum / length).cast<float>()) : Vec3f::UnitZ();
}

}  // namespace

std::vector<Vec3f> vertex_normals(const QuadMesh& mesh) {
    std::vector<Vec3> sums(mesh.vertex_count(), Vec3::Zero());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) add_corner_normals(mesh, mesh.face(f), sums);
    std::vector<Vec3f> normals(sums.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sums.size(), 8192), [&](const auto& range) {
        for (std::size_t v = range.begin(); v < range.end(); ++v) normals[v] = unit(sums[v]);
    });
    return normals;
}

}  // namespace sinew
