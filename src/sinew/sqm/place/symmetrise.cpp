#include "sinew/sqm/place/symmetrise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sinew::sqm {
namespace {

/// How far from the image of a vertex, of the ring's radius, the vertex may be that it goes to. Any number
/// between 1e-6 and 0.15 tells the same: of 94,520 vertices of rings in symmetric meshes (../shared/data and
/// examples, as they are and with --sides 8) 94,400 are nearer than that, all others further.
constexpr double farthest = 0.09;

class VertexImages {
  public:
    VertexImages(const Parts& parts, const Images& images, const Bridge& bridge)
        : d_(parts),
          n_(parts.network),
          images_(images),
          bridge_(bridge),
          image_(bridge.mesh.vertex_count(), no_vertex) {}

    std::vector<std::uint32_t> run() {
        joints();
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (!path(p)) askew_.push_back(p);
        capped();
        release_paths();
        if (!lone() || !is_permutation()) return {};
        for (std::int32_t p = 0; p < n_.path_count(); ++p) leave_askew(p);
        return std::move(image_);
    }

  private:
    void joints() {
        const Polyhedra& poly = d_.polyhedra;
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            for (std::int32_t v = poly.vertex_first[j]; v < poly.vertex_first[j + 1]; ++v) {
                const std::int32_t k = images_.joint[j], w = images_.vertex[v];
                image_[d_.points.first[j] + v - poly.vertex_first[j]] =
                    d_.points.first[k] + w - poly.vertex_first[k];
            }
            for (std::int32_t a = poly.arc_first[j]; a < poly.arc_first[j + 1]; ++a) {
                const std::int32_t inner = d_.refinement.pieces[a] - 1, b = images_.arc[a];
                for (std::int32_t i = 0; i < inner; ++i)
                    image_[d_.points.arc_first[a] + i] =
                        d_.points.arc_first[b] + (images_.arc_reversed[a] ? inner - 1 - i : i);
            }
        }
    }

    /// Where ring 0 and column 0 of a path go, and which way round its rings and columns go from there.
    struct PathImage {
        std::int32_t path = 0, ring = 0, column = 0;
        bool rings_back = false, columns_back = false;
    };
    static std::int32_t wrapped(std::int32_t i, std::int32_t count) { return ((i % count) + count) % count; }
    std::int32_t ring_count(std::int32_t p) const { return d_.stations.first[p + 1] - d_.stations.first[p]; }
    std::int32_t sides(std::int32_t p) const { return d_.refinement.path_sides[p]; }
    std::uint32_t first_of_ring(std::int32_t p, std::int32_t ring) const {
        return bridge_.path_vertex[p] + ring * sides(p);
    }

    /// Columns of a path go to columns of its image, all shifted alike, backwards if the sense is reversed.
    /// @return whether the path follows the symmetry
    bool path(std::int32_t p) {
        const std::int32_t q = images_.path[p];
        if (ring_count(q) != ring_count(p) || sides(q) != sides(p)) return false;
        for (int end = 0; end < 2; ++end)
            if (bridge_.path_pole[p][end] != no_vertex)
                image_[bridge_.path_pole[p][end]] =
                    bridge_.path_pole[q][images_.path_reversed[p] ? 1 - end : end];
        if (ring_count(p) == 0) return true;  // the joints' rings are matched already: nothing lies between
        return n_.path_closed[p] ? closed_path(p, start_of_closed(p, q)) : open_path(p, start_of_open(p, q));
    }
    void ring_goes_to(std::int32_t p, std::int32_t ring, const PathImage& to, std::int32_t to_ring,
                      std::int32_t to_column) {
        const std::int32_t n = sides(p);
        for (std::int32_t k = 0; k < n; ++k)
            image_[first_of_ring(p, ring) + k] =
                first_of_ring(to.path, to_ring) + wrapped(to_column + (to.columns_back ? -k : k), n);
    }

    PathImage start_of_open(std::int32_t p, std::int32_t q) const {
        PathImage to{q};
        to.rings_back = images_.path_reversed[p];
        to.columns_back = to.rings_back != images_.reverses;
        to.ring = to.rings_back ? ring_count(p) - 1 : 0;
        to.column = n_.path_end[p][0].at_joint()
                        ? column_at_joint(p, q, to.rings_back)
                        : nearest(bridge_.path_vertex[p], first_of_ring(q, to.ring), sides(p));
        return to;
    }
    bool open_path(std::int32_t p, const PathImage& to) {
        for (std::int32_t i = 0; i < ring_count(p); ++i)
            ring_goes_to(p, i, to, to.ring + (to.rings_back ? -i : i), to.column);
        return ends_agree(p, to.path, sides(p));
    }

    /// A closed path may be turned along itself too: the ring that its first ring goes to is the nearest one.
    PathImage start_of_closed(std::int32_t p, std::int32_t q) const {
        const Station* const rings = &d_.stations.stations[d_.stations.first[q]];
        const Station& first = d_.stations.stations[d_.stations.first[p]];
        const Vec3 centre = images_.generator * first.centre;
        PathImage to{q};
        double nearest_square = std::numeric_limits<double>::infinity();
        for (std::int32_t i = 0; i < ring_count(q); ++i)
            if (const double square = (rings[i].centre - centre).squaredNorm(); square < nearest_square)
                nearest_square = square, to.ring = i;
        to.column = nearest(bridge_.path_vertex[p], first_of_ring(q, to.ring), sides(p));
        to.rings_back = (images_.generator * first.tangent).dot(rings[to.ring].tangent) < 0;
        to.columns_back = to.rings_back != images_.reverses;
        return to;
    }
    /// Rings are walked along the path and its image at once. Where the walk passes from the last ring of the
    /// image to its first, column k goes on as column k + far_shift, and the other way round.
    /// @return whether that agrees with where the path itself is joined to its first ring
    bool closed_path(std::int32_t p, const PathImage& to) {
        const std::int32_t rings = ring_count(p), own_shift = d_.stations.far_shift[p],
                           shift = d_.stations.far_shift[to.path];
        std::int32_t ring = to.ring, column = to.column;
        for (std::int32_t i = 0; i < rings; ++i) {
            ring_goes_to(p, i, to, ring, column);
            ring += to.rings_back ? -1 : 1;
            if (ring == rings) ring = 0, column += shift;
            if (ring < 0) ring = rings - 1, column -= shift;
        }
        const std::int32_t expected = to.column + (to.columns_back ? -own_shift : own_shift);
        return wrapped(column - expected, sides(p)) == 0;
    }

    Vec3 position(std::uint32_t vertex) const { return bridge_.mesh.positions[vertex].cast<double>(); }
    std::int32_t nearest(std::uint32_t vertex, std::uint32_t ring, std::int32_t n) const {
        const Vec3 at = images_.generator * position(vertex);
        std::int32_t best = 0;
        for (std::int32_t k = 1; k < n; ++k)
            if ((position(ring + k) - at).squaredNorm() < (position(ring + best) - at).squaredNorm())
                best = k;
        return best;
    }

    std::vector<std::uint32_t> joint_ring(std::int32_t p, int end) const {
        std::vector<std::uint32_t> ring;
        joint_ring_of_path(d_, p, end, ring);
        return ring;
    }
    /// The column of the image that ends where column 0 does, at the joint that the path begins at.
    std::int32_t column_at_joint(std::int32_t p, std::int32_t q, bool back) const {
        const auto from = joint_ring(p, 0), to = joint_ring(q, back ? 1 : 0);
        return static_cast<std::int32_t>(std::find(to.begin(), to.end(), image_[from[0]]) - to.begin());
    }
    /// Column by column, the joint's vertex that a column ends in must go to the one that the column's image
    /// ends in.
    bool ends_agree(std::int32_t p, std::int32_t q, std::int32_t n) const {
        const bool back = images_.path_reversed[p];
        const std::int32_t rings = d_.stations.first[p + 1] - d_.stations.first[p];
        for (int end = 0; end < 2; ++end) {
            if (!n_.path_end[p][end].at_joint()) continue;
            const auto from = joint_ring(p, end), to = joint_ring(q, back ? 1 - end : end);
            const std::uint32_t row = bridge_.path_vertex[p] + (end == 0 ? 0 : rings - 1) * n;
            for (std::int32_t k = 0; k < n; ++k) {
                const std::uint32_t column = (image_[row + k] - bridge_.path_vertex[q]) % n;
                if (image_[from[k]] != to[column]) return false;
            }
        }
        return true;
    }

    void capped() {
        for (std::size_t i = 0; i < bridge_.capped.size(); ++i) {
            const auto at = std::lower_bound(bridge_.capped.begin(), bridge_.capped.end(),
                                             images_.cell[bridge_.capped[i]]);
            image_[bridge_.capped_pole + i] =
                bridge_.capped_pole + static_cast<std::uint32_t>(at - bridge_.capped.begin());
        }
    }

    /// Spheres of lone nodes are alike: a rotation copies them, a mirror turns them over.
    bool lone() {
        const auto& points = lone_sphere_points();
        for (std::size_t i = 0; i < n_.lone.size(); ++i) {
            const std::int32_t node = d_.skeleton.symmetry.image[n_.lone[i]];
            const auto at = static_cast<std::size_t>(std::lower_bound(n_.lone.begin(), n_.lone.end(), node) -
                                                     n_.lone.begin());
            if (!images_.reverses && at == i) return false;
            for (std::size_t k = 0; k < points.size(); ++k) {
                std::size_t to = k;
                if (images_.reverses) {
                    const Vec3 turned = images_.generator * Vec3(points[k][0], points[k][1], points[k][2]);
                    std::array<int, 3> wanted{};
                    for (int c = 0; c < 3; ++c) wanted[c] = static_cast<int>(std::lround(turned[c]));
                    to = static_cast<std::size_t>(std::find(points.begin(), points.end(), wanted) -
                                                  points.begin());
                }
                image_[bridge_.lone_vertex + i * points.size() + k] =
                    bridge_.lone_vertex + static_cast<std::uint32_t>(at * points.size() + to);
            }
        }
        return true;
    }

    /// Tubes that do not follow the symmetry of the joints keep their shape, and so do their images.
    void release_paths() {
        for (const std::int32_t askew : askew_) {
            std::int32_t p = askew;
            do {
                std::fill(image_.begin() + bridge_.path_vertex[p],
                          image_.begin() + bridge_.path_vertex[p + 1], no_vertex);
                p = images_.path[p];
            } while (p != askew);
        }
    }
    /// Whether no symmetry takes a ring onto itself: then its images can be copies of it, whatever it is
    /// like.
    bool is_copied(std::uint32_t ring, std::int32_t n) const {
        std::int32_t copies = 1;
        for (std::uint32_t v = image_[ring]; v < ring || v >= ring + n; v = image_[v])
            if (v == no_vertex || ++copies > images_.order) return false;
        return copies == images_.order;
    }
    /// A ring that has corners where its neighbours have sides in the mirror cannot be symmetric together
    /// with them: such a ring keeps its shape.
    void leave_askew(std::int32_t p) {
        const std::int32_t n = d_.refinement.path_sides[p], first = d_.stations.first[p];
        for (std::int32_t i = first; i < d_.stations.first[p + 1]; ++i) {
            const Station& station = d_.stations.stations[i];
            const bool free = station.shape == RingShape::follow || station.shape == RingShape::pit;
            const double far = farthest * (free ? d_.skeleton.radius[station.node] : station.half.minCoeff());
            const std::uint32_t ring = first_of_ring(p, i - first);
            if (station.shape != RingShape::outline && is_copied(ring, n)) continue;
            for (std::uint32_t v = ring; v < ring + n; ++v)
                if (image_[v] != no_vertex &&
                    (images_.generator * position(v) - position(image_[v])).norm() > far)
                    release_orbit(v);
        }
    }
    void release_orbit(std::uint32_t v) {
        while (image_[v] != no_vertex) v = std::exchange(image_[v], no_vertex);
    }

    bool is_permutation() const {
        std::vector<std::uint8_t> hit(image_.size(), 0);
        for (const std::uint32_t v : image_) {
            if (v == no_vertex) continue;
            if (v >= image_.size() || hit[v]) return false;
            hit[v] = 1;
        }
        return true;
    }

    const Parts& d_;
    const Network& n_;
    const Images& images_;
    const Bridge& bridge_;
    std::vector<std::uint32_t> image_;
    std::vector<std::int32_t> askew_;
};

}  // namespace

std::vector<std::uint32_t> vertex_images(const Parts& parts, const Images& images, const Bridge& bridge) {
    if (!images.any()) return {};
    return VertexImages(parts, images, bridge).run();
}

void make_symmetric(const Images& images, std::span<const std::uint32_t> vertex_image,
                    std::span<Vec3f> positions) {
    for (std::uint32_t v = 0; v < vertex_image.size(); ++v) {
        if (vertex_image[v] == no_vertex) continue;
        // Only the first of an orbit leads: the others have an image of a lower index on their way round.
        const Vec3 point = positions[v].cast<double>();
        Vec3 sum = point;
        std::int32_t returns = 0, steps = 0;
        Mat3 power = Mat3::Identity();
        bool first = true;
        for (std::uint32_t w = vertex_image[v]; steps + 1 < images.order; w = vertex_image[w]) {
            ++steps;
            power = images.generator * power;
            if (w < v) first = false;
            if (w == v) ++returns, sum += power * point;
        }
        if (!first) continue;
        Vec3 at = sum / (1 + returns);  // stays put under those symmetries that keep the vertex in place
        positions[v] = at.cast<float>();
        for (std::uint32_t w = vertex_image[v]; w != v; w = vertex_image[w]) {
            at = images.generator * at;
            positions[w] = at.cast<float>();
        }
    }
}

}  // namespace sinew::sqm
