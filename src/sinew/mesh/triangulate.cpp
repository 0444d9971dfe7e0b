#include "sinew/mesh/triangulate.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace sinew {
namespace {

using Index = std::uint32_t;
using Face = std::span<const Index>;

Vec3 vertex_position(const QuadMesh& mesh, Index vertex) { return mesh.positions[vertex].cast<double>(); }

Vec3 normal(const QuadMesh& mesh, const Triangle& t) {
    const Vec3 a = vertex_position(mesh, t[0]);
    return (vertex_position(mesh, t[1]) - a).cross(vertex_position(mesh, t[2]) - a);
}

/// Is the diagonal from corner 1 to 3 the better one?
bool cut_from_second(const QuadMesh& mesh, Face q) {
    const bool first_flat = normal(mesh, {q[0], q[1], q[2]}).dot(normal(mesh, {q[0], q[2], q[3]})) > 0;
    const bool second_flat = normal(mesh, {q[1], q[2], q[3]}).dot(normal(mesh, {q[1], q[3], q[0]})) > 0;
    if (first_flat != second_flat) return second_flat;
    const double first = (vertex_position(mesh, q[2]) - vertex_position(mesh, q[0])).squaredNorm();
    const double second = (vertex_position(mesh, q[3]) - vertex_position(mesh, q[1])).squaredNorm();
    return second != first ? second < first : std::min(q[1], q[3]) < std::min(q[0], q[2]);
}

Vec3 face_normal(const QuadMesh& mesh, Face face) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 2; i < face.size(); ++i) sum += normal(mesh, {face[0], face[i - 1], face[i]});
    return sum;
}

bool is_fan_from(const QuadMesh& mesh, Face face, std::size_t start, const Vec3& up) {
    const std::size_t n = face.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
        if (!(normal(mesh, {face[start], face[(start + i) % n], face[(start + i + 1) % n]}).dot(up) > 0))
            return false;
    return true;
}

void cut_fan(Face face, std::size_t start, Triangle* out) {
    const std::size_t n = face.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
        *out++ = {face[start], face[(start + i) % n], face[(start + i + 1) % n]};
}

/// May the ear (previous, at, next) of the outline be cut off: is it convex, with no other corner in it?
bool is_ear(const QuadMesh& mesh, Face outline, std::size_t at, const Vec3& up) {
    const std::size_t n = outline.size();
    const Triangle ear{outline[(at + n - 1) % n], outline[at], outline[(at + 1) % n]};
    if (!(normal(mesh, ear).dot(up) > 0)) return false;
    return std::none_of(outline.begin(), outline.end(), [&](Index v) {
        if (std::find(ear.begin(), ear.end(), v) != ear.end()) return false;
        return normal(mesh, {ear[0], ear[1], v}).dot(up) >= 0 &&
               normal(mesh, {ear[1], ear[2], v}).dot(up) >= 0 &&
               normal(mesh, {ear[2], ear[0], v}).dot(up) >= 0;
    });
}

void clip_ears(const QuadMesh& mesh, Face face, const Vec3& up, Triangle* out) {
    std::vector<Index> outline(face.size());
    std::copy(face.begin(), face.end(), outline.begin());
    std::size_t at = 0;
    while (outline.size() > 3) {
        const std::size_t n = outline.size();
        std::size_t tried = 0;
        while (tried < n && !is_ear(mesh, outline, at % n, up)) ++tried, ++at;
        at %= n;  // where a face crosses itself there may be no ear: any corner does then
        *out++ = {outline[(at + n - 1) % n], outline[at], outline[(at + 1) % n]};
        outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(at));
    }
    *out = {outline[0], outline[1], outline[2]};
}

void cut_polygon(const QuadMesh& mesh, Face face, Triangle* out) {
    const Vec3 up = face_normal(mesh, face);
    const std::size_t most = 512;
    for (std::size_t start = 0; start < std::min(face.size(), most); ++start)
        if (is_fan_from(mesh, face, start, up)) return cut_fan(face, start, out);
    if (face.size() > most) return cut_fan(face, 0, out);
    clip_ears(mesh, face, up, out);
}

void cut(const QuadMesh& mesh, Face face, Triangle* out) {
    if (face.size() < 3) return;
    if (face.size() == 3) return cut_fan(face, 0, out);
    if (face.size() == 4) return cut_fan(face, cut_from_second(mesh, face), out);
    cut_polygon(mesh, face, out);
}

std::size_t triangle_count(Face face) { return face.size() < 3 ? 0 : face.size() - 2; }

}  // namespace

Triangles triangulate(const QuadMesh& mesh) {
    Triangles result;
    result.first.resize(mesh.face_count() + 1);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        result.first[f + 1] = static_cast<Index>(result.first[f] + triangle_count(mesh.face(f)));
    result.triangles.resize(result.first.back());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.face_count(), 4096), [&](const auto& range) {
        for (std::size_t f = range.begin(); f < range.end(); ++f)
            cut(mesh, mesh.face(f), result.triangles.data() + result.first[f]);
    });
    return result;
}

void triangulate_face(const QuadMesh& mesh, std::size_t face, std::vector<Triangle>& triangles) {
    const std::size_t before = triangles.size();
    triangles.resize(before + triangle_count(mesh.face(face)));
    cut(mesh, mesh.face(face), triangles.data() + before);
}

}  // namespace sinew
