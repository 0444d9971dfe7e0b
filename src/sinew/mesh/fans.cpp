#include "sinew/mesh/fans.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sinew/base/portable_math.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

bool is_triangle(const QuadMesh& mesh, Index face) { return mesh.face(face).size() == 3; }

/// Is the vertex the middle of one closed fan of three triangles or more?
bool is_closed_fan(const QuadMesh& mesh, const Topology& topology, Index vertex) {
    const auto ring = topology.ring(vertex);
    if (ring.size() < 3) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (!is_triangle(mesh, topology.half_edge_face[ring[i]])) return false;
        if (counter_clockwise(mesh, topology, ring[i]) != ring[(i + 1) % ring.size()]) return false;
    }
    return true;
}

std::vector<Index> ascending(std::span<const Index> list) {
    std::vector<Index> poles(list.begin(), list.end());
    std::sort(poles.begin(), poles.end());
    poles.erase(std::unique(poles.begin(), poles.end()), poles.end());
    return poles;
}

/// Faces of planes, ascending, with the plane each lies in.
std::vector<std::array<Index, 2>> planar_faces(const QuadMesh& mesh) {
    std::vector<std::array<Index, 2>> faces;
    for (Index plane = 0; plane < mesh.features.planes.size(); ++plane)
        for (const Index face : mesh.features.planes[plane].faces) faces.push_back({face, plane});
    std::sort(faces.begin(), faces.end());
    return faces;
}

class FanFinder {
  public:
    FanFinder(const QuadMesh& mesh, const Topology& topology, const Sharpness& sharpness,
              std::span<const Index> poles)
        : mesh_(mesh),
          topology_(topology),
          sharpness_(sharpness),
          poles_(ascending(poles)),
          planar_(planar_faces(mesh)) {}

    Fans find() {
        for (const Index pole : poles_)
            if (is_pole(pole)) append(pole);
        return std::move(fans_);
    }

  private:
    Index end_of(Index half_edge) const { return mesh_.corners[next_half_edge(mesh_, topology_, half_edge)]; }

    bool is_pole(Index vertex) const {
        if (!is_closed_fan(mesh_, topology_, vertex)) return false;
        for (const Index h : topology_.ring(vertex))
            if (std::binary_search(poles_.begin(), poles_.end(), end_of(h))) return false;
        const Index sharp = find_sharp_vertex(sharpness_, vertex);
        return sharp == no_index || stays(sharp);
    }

    /// Is it a corner for ever?
    bool stays(Index sharp_vertex) const {
        const auto spokes = sharpness_.spokes_of(sharp_vertex);
        const auto infinite = [](const SharpSpoke& s) { return s.sharpness >= infinite_sharpness; };
        return sharpness_.corner[sharp_vertex] || std::count_if(spokes.begin(), spokes.end(), infinite) >= 3;
    }

    Index plane_of(Index face) const {
        const auto found = std::lower_bound(planar_.begin(), planar_.end(), std::array<Index, 2>{face, 0});
        return found != planar_.end() && (*found)[0] == face ? (*found)[1] : no_index;
    }

    bool is_flat(std::span<const Index> faces) const {
        const Index plane = plane_of(faces[0]);
        return plane != no_index &&
               std::all_of(faces.begin(), faces.end(), [&](Index face) { return plane_of(face) == plane; });
    }

    void append(Index pole) {
        const auto ring = topology_.ring(pole);
        PoleFan fan{pole, static_cast<Index>(fans_.faces.size()), static_cast<Index>(ring.size()), false};
        for (const Index h : ring) {
            fans_.faces.push_back(topology_.half_edge_face[h]);
            fans_.ring.push_back(end_of(h));
        }
        fan.fixed = find_sharp_vertex(sharpness_, pole) != no_index || is_flat(fans_.faces_of(fan));
        fans_.fans.push_back(fan);
    }

    const QuadMesh& mesh_;
    const Topology& topology_;
    const Sharpness& sharpness_;
    std::vector<Index> poles_;
    std::vector<std::array<Index, 2>> planar_;
    Fans fans_;
};

/// Calls body(j, cos(2 pi j / n), sin(2 pi j / n)) for j = 0 .. n - 1.
template <class Body>
void for_each_root_of_unity(std::size_t n, const Body& body) {
    const double angle = 2 * std::numbers::pi / static_cast<double>(n);
    const auto [s, c] = portable::sine_cosine(angle);
    double x = 1, y = 0;
    for (std::size_t j = 0; j < n; ++j) {
        body(j, x, y);
        const double turned = c * x - s * y;
        y = s * x + c * y;
        x = turned;
    }
}

/// Sums of the ring times cosine and sine of modes 1 and 2, and alone.
struct Modes {
    Vec3 mean = Vec3::Zero();
    std::array<Vec3, 2> first{Vec3::Zero(), Vec3::Zero()};
    std::array<Vec3, 2> second{Vec3::Zero(), Vec3::Zero()};
};

Modes modes_of(std::span<const Vec3> ring) {
    Modes modes;
    for (const Vec3& p : ring) modes.mean += p;
    modes.mean /= static_cast<double>(ring.size());
    for_each_root_of_unity(ring.size(), [&](std::size_t j, double c, double s) {
        const Vec3 p = ring[j] - modes.mean;
        modes.first[0] += c * p;
        modes.first[1] += s * p;
        modes.second[0] += (c * c - s * s) * p;
        modes.second[1] += 2 * c * s * p;
    });
    return modes;
}

}  // namespace

Result<Fans> resolve_fans(const QuadMesh& mesh, const Topology& topology, const Sharpness& sharpness,
                          std::span<const std::uint32_t> poles) {
    for (const Index pole : poles)
        if (pole >= mesh.vertex_count())
            return fail(ErrorKind::input, fmt::format("the pole {} is no vertex of the mesh", pole));
    return FanFinder(mesh, topology, sharpness, poles).find();
}

std::vector<std::uint32_t> detect_poles(const QuadMesh& mesh, const Topology& topology) {
    const auto has_other_faces = [&](Index h) {
        const Index neighbour = mesh.corners[next_half_edge(mesh, topology, h)];
        const auto ring = topology.ring(neighbour);
        return std::any_of(ring.begin(), ring.end(),
                           [&](Index g) { return !is_triangle(mesh, topology.half_edge_face[g]); });
    };
    std::vector<Index> poles;
    for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        if (!is_closed_fan(mesh, topology, vertex)) continue;
        const auto ring = topology.ring(vertex);
        if (std::all_of(ring.begin(), ring.end(), has_other_faces)) poles.push_back(vertex);
    }
    return poles;
}

Vec3 polar_offsets(std::span<const Vec3> ring, std::span<Vec3> offsets) {
    const std::size_t n = ring.size();
    const Modes modes = modes_of(ring);
    const double share = 2 / static_cast<double>(n);
    const double second_share = n == 3 ? 0 : n == 4 ? share / 2 : share;
    for_each_root_of_unity(n, [&](std::size_t j, double c, double s) {
        const Vec3 first = share * (c * modes.first[0] + s * modes.first[1]);
        const Vec3 second = second_share * ((c * c - s * s) * modes.second[0] + 2 * c * s * modes.second[1]);
        offsets[j] = modes.mean + first + second / 2 - ring[j];
    });
    return modes.mean;
}

std::array<Vec3, 2> polar_tangents(std::span<const Vec3> ring) { return modes_of(ring).first; }

}  // namespace sinew
