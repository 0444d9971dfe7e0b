#include "sinew/mesh/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sinew {
namespace {

using Index = std::uint32_t;

/// A spread in the making: the sum stands in for the mean.
struct Tally {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    double sum = 0;
    std::int64_t count = 0;

    void add(double value) {
        min = std::min(min, value);
        max = std::max(max, value);
        sum += value;
        ++count;
    }
    void append(const Tally& later) {
        min = std::min(min, later.min);
        max = std::max(max, later.max);
        sum += later.sum;
        count += later.count;
    }
    Spread spread() const { return count ? Spread{min, sum / double(count), max, count} : Spread{}; }
};

/// Runs over [0, count) in pieces that do not depend on the threads, so that the sums come out the same on
/// any number.
template <class Part, class Add>
Part gather(std::size_t count, const Add& add) {
    using Range = tbb::blocked_range<std::size_t>;
    return tbb::parallel_deterministic_reduce(
        Range(0, count, 8192), Part{},
        [&](const Range& range, Part part) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) add(i, part);
            return part;
        },
        [](Part left, const Part& right) {
            left.append(right);
            return left;
        });
}

Vec3 position(const QuadMesh& mesh, Index vertex) { return mesh.positions[vertex].cast<double>(); }

/// The vector area of a face: its normal, as long as the area it throws along it.
Vec3 vector_area(const QuadMesh& mesh, std::span<const Index> face) {
    const Vec3 origin = position(mesh, face[0]);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 2; i < face.size(); ++i)
        sum += (position(mesh, face[i - 1]) - origin).cross(position(mesh, face[i]) - origin);
    return sum / 2;
}

struct Sides {
    double shortest = std::numeric_limits<double>::infinity();
    double longest = 0;
    double farthest = 0;  ///< largest coordinate in absolute value
};

Sides sides_of(const QuadMesh& mesh, std::span<const Index> face) {
    Sides sides;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = position(mesh, face[i]), b = position(mesh, face[i + 1 == face.size() ? 0 : i + 1]);
        const double length = (b - a).norm();
        sides.shortest = std::min(sides.shortest, length);
        sides.longest = std::max(sides.longest, length);
        sides.farthest = std::max(sides.farthest, a.cwiseAbs().maxCoeff());
    }
    return sides;
}

/// The least sine of a quad's four corner angles, seen along its normal.
double scaled_jacobian(const QuadMesh& mesh, std::span<const Index> face, const Vec3& area) {
    const double size = area.norm();
    if (size == 0) return 0;
    double least = 1;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 at = position(mesh, face[i]);
        const Vec3 to = position(mesh, face[(i + 1) % 4]) - at, from = position(mesh, face[(i + 3) % 4]) - at;
        const double lengths = to.norm() * from.norm();
        least = std::min(least, lengths > 0 ? to.cross(from).dot(area) / (lengths * size) : 0);
    }
    return least;
}

struct FacePart {
    std::int64_t triangles = 0, quads = 0, ngons = 0;
    double area = 0, volume = 0;
    IndexFaults zero_area, folded;
    Tally quality, aspect;

    void append(const FacePart& later) {
        triangles += later.triangles;
        quads += later.quads;
        ngons += later.ngons;
        area += later.area;
        volume += later.volume;
        zero_area.append(later.zero_area);
        folded.append(later.folded);
        quality.append(later.quality);
        aspect.append(later.aspect);
    }
};

void add_quad(const QuadMesh& mesh, std::size_t f, const Vec3& area, const Sides& sides, FacePart& part) {
    const double quality = scaled_jacobian(mesh, mesh.face(f), area);
    part.quality.add(quality);
    if (!(quality > 0)) part.folded.add(static_cast<Index>(f));
    if (sides.shortest > 0) part.aspect.add(sides.longest / sides.shortest);
}

void add_face(const QuadMesh& mesh, std::size_t f, const Vec3& centre, FacePart& part) {
    const std::span<const Index> face = mesh.face(f);
    part.triangles += face.size() == 3;
    part.quads += face.size() == 4;
    part.ngons += face.size() > 4;
    if (face.size() < 3) return part.zero_area.add(static_cast<Index>(f));
    const Vec3 area = vector_area(mesh, face);
    const Sides sides = sides_of(mesh, face);
    Vec3 middle = Vec3::Zero();
    for (const Index v : face) middle += position(mesh, v) - centre;
    part.area += area.norm();
    part.volume += middle.dot(area) / (3.0 * double(face.size()));
    constexpr double rounding = std::numeric_limits<float>::epsilon() / 2;
    if (!(area.norm() > rounding * sides.farthest * sides.longest)) part.zero_area.add(static_cast<Index>(f));
    if (face.size() == 4) add_quad(mesh, f, area, sides, part);
}

void measure_faces(const QuadMesh& mesh, Measures& result) {
    // Far from the origin the volume would drown in its terms: they are taken about the middle of the mesh.
    const Vec3 centre = (result.low + result.high) / 2;
    FacePart part = gather<FacePart>(mesh.face_count(),
                                     [&](std::size_t f, FacePart& sum) { add_face(mesh, f, centre, sum); });
    result.triangles = part.triangles;
    result.quads = part.quads;
    result.ngons = part.ngons;
    result.area = part.area;
    result.volume = part.volume;
    result.zero_area = std::move(part.zero_area);
    result.folded_quads = std::move(part.folded);
    result.quad_quality = part.quality.spread();
    result.quad_aspect = part.aspect.spread();
}

void measure_edges(const QuadMesh& mesh, const Topology& topology, Measures& result) {
    result.edge_length = gather<Tally>(topology.edge_count(), [&](std::size_t e, Tally& lengths) {
                             const MeshEdge edge = topology.edges[e];
                             lengths.add((position(mesh, edge[1]) - position(mesh, edge[0])).norm());
                         }).spread();
}

bool all_triangles(const QuadMesh& mesh, const Topology& topology, std::size_t vertex) {
    const std::span<const Index> ring = topology.ring(vertex);
    return !ring.empty() && std::all_of(ring.begin(), ring.end(), [&](Index h) {
        return mesh.face(topology.half_edge_face[h]).size() == 3;
    });
}

/// 1 for each pole, 0 for other vertices.
std::vector<char> find_poles(const QuadMesh& mesh, const Topology& topology) {
    std::vector<char> surrounded(mesh.vertex_count());
    for (std::size_t v = 0; v < surrounded.size(); ++v) surrounded[v] = all_triangles(mesh, topology, v);
    std::vector<char> poles = surrounded;
    for (const MeshEdge& edge : topology.edges)
        if (surrounded[edge[0]] && surrounded[edge[1]]) poles[edge[0]] = poles[edge[1]] = 0;
    return poles;
}

void measure_valences(const QuadMesh& mesh, const Topology& topology, Measures& result) {
    const std::vector<Index> valence = valences(topology);
    const std::vector<char> poles = find_poles(mesh, topology);
    std::int64_t in_fans = 0;
    for (std::size_t v = 0; v < valence.size(); ++v) {
        if (topology.ring(v).empty()) continue;
        result.irregular_vertices += valence[v] != 4;
        result.poles += poles[v];
        if (poles[v]) in_fans += std::ssize(topology.ring(v));
        std::int64_t& most = poles[v] ? result.max_pole_valence : result.max_valence;
        most = std::max<std::int64_t>(most, valence[v]);
    }
    // Two poles are never neighbours, so that no triangle is in two fans.
    result.stray_triangles = result.triangles - in_fans;
}

struct BoundingBox {
    Eigen::AlignedBox3f box;
    void append(const BoundingBox& other) { box.extend(other.box); }
};

void measure_box(const QuadMesh& mesh, Measures& result) {
    if (mesh.positions.empty()) return;
    const BoundingBox all = gather<BoundingBox>(
        mesh.vertex_count(), [&](std::size_t v, BoundingBox& part) { part.box.extend(mesh.positions[v]); });
    result.low = all.box.min().cast<double>();
    result.high = all.box.max().cast<double>();
}

}  // namespace

double quad_quality(const QuadMesh& mesh, std::size_t face) {
    return scaled_jacobian(mesh, mesh.face(face), vector_area(mesh, mesh.face(face)));
}

Measures measure(const QuadMesh& mesh) { return measure(mesh, build_topology(mesh)); }

Measures measure(const QuadMesh& mesh, const Topology& topology) {
    Measures result;
    measure_box(mesh, result);
    measure_faces(mesh, result);
    measure_edges(mesh, topology, result);
    measure_valences(mesh, topology, result);
    return result;
}

}  // namespace sinew
