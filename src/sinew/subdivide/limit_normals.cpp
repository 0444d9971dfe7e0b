#include <algorithm>
#include <cmath>
#include <numbers>

#include "sinew/subdivide/finest_rings.h"
#include "sinew/subdivide/limit_surface.h"
#include "sinew/subdivide/refine.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

constexpr int dart_steps = 12;  // of subdivision, until the ring of a dart is as good as flat

Vec3 edge_at(const VertexRing& ring, std::size_t i) {
    return (ring.edges.row(static_cast<Eigen::Index>(i % ring.sharpness.size())) - ring.vertex).transpose();
}
Vec3 mean_at(const VertexRing& ring, std::size_t i) {
    return (ring.means.row(static_cast<Eigen::Index>(i)) - ring.vertex).transpose();
}

/// What is orthogonal to a surface whose tangents one knows but for a sign, on the side of another normal.
Vec3 on_side_of(const Vec3& normal, const Vec3& side) {
    return (normal.dot(side) < 0 ? -normal : normal).normalized();
}

/// Sum of the normals of some faces of a ring at its vertex.
Vec3 sum_of_faces(const VertexRing& ring, std::size_t begin, std::size_t count) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = begin; i < begin + count; ++i) sum += edge_at(ring, i).cross(edge_at(ring, i + 1));
    return sum;
}

/// A of the eigenvectors of a step of Catmull-Clark round a vertex whose edges are `angle` apart.
double edge_weight(double angle) {
    const double c = 1 + std::cos(angle);
    return c + std::sqrt(c * (8 + c));
}

/// Weights of the tangents of a smooth inner vertex of n edges, by the masks of Catmull-Clark (Halstead, Kass
/// and DeRose 1993) applied to the ring after one step of subdivision: `edge` times the unit vector at angle
/// i a for edge i, and `face` times that at (i + 1/2) a for the mean of face i.
struct TangentWeights {
    double edge, face;
    Vec2 half_step;  ///< the unit vector at angle a / 2
};

TangentWeights tangent_weights(std::size_t n) {
    const double angle = 2 * std::numbers::pi / static_cast<double>(n), edge = edge_weight(angle) / 4;
    const Vec2 half_step(std::cos(angle / 2), std::sin(angle / 2));
    if (n == 2) return {1, 1, half_step};  // edges and faces are eigenvectors each on their own
    return {edge, (1 + edge) * 2 * half_step.x(), half_step};
}

/// Gathers the normal of a smooth inner vertex from its ring, in order.
class SmoothNormal {
  public:
    explicit SmoothNormal(std::size_t n) {
        static const TangentWeights four = tangent_weights(4);
        weights_ = n == 4 ? four : tangent_weights(n);
    }
    /// @param edge, mean  seen from the vertex
    void add(const Vec3& edge, const Vec3& mean) {
        along_ += weights_.edge * direction_.x() * edge;
        across_ += weights_.edge * direction_.y() * edge;
        turn();
        along_ += weights_.face * direction_.x() * mean;
        across_ += weights_.face * direction_.y() * mean;
        turn();
    }
    Vec3 normal() const { return along_.cross(across_).normalized(); }

  private:
    void turn() {
        const Vec2& step = weights_.half_step;
        direction_ = {direction_.x() * step.x() - direction_.y() * step.y(),
                      direction_.x() * step.y() + direction_.y() * step.x()};
    }

    TangentWeights weights_{};
    Vec2 direction_ = Vec2::UnitX();
    Vec3 along_ = Vec3::Zero();
    Vec3 across_ = Vec3::Zero();
};

Vec3 smooth_normal(const VertexRing& ring) {
    const std::size_t n = ring.sharpness.size();
    SmoothNormal sum(n);
    for (std::size_t i = 0; i < n; ++i) sum.add(edge_at(ring, i), mean_at(ring, i));
    return sum.normal();
}

/// Normal of the side of a crease that has `count` faces from face `begin` on: of the crease's direction and
/// of the eigenvector that runs across, of the ring after one step.
///
/// With s_i = sin(i pi / count) that eigenvector weighs inner edges by A s_i, corners of faces by s_i +
/// s_i+1, and the ends of the crease alike; its eigenvalue is (4 + A) / 16, as for a smooth vertex of twice
/// as many faces. (The mask of OpenSubdiv, after Biermann, Levin and Zorin, has 4 for A, which is right for
/// two faces only.)
Vec3 crease_normal(const VertexRing& ring, std::size_t begin, std::size_t count) {
    VertexRing finer = ring;
    refine_ring(finer);
    const std::size_t n = ring.sharpness.size();
    const auto face_point =
        [&](std::size_t i) -> Vec3 {  // the mean of a coarse face is a corner of a finer one
        return (ring.means.row(static_cast<Eigen::Index>((begin + i) % n)) - finer.vertex).transpose();
    };
    const Vec3 first = edge_at(finer, begin), last = edge_at(finer, begin + count);
    const Vec3 side = sum_of_faces(finer, begin, count);
    if (count == 1) return on_side_of((first - last).cross(first + last), side);
    const double angle = std::numbers::pi / static_cast<double>(count);
    const double inner = edge_weight(angle), eigenvalue = (4 + inner) / 16;
    const double end =
        (std::sin(angle) * eigenvalue - (inner + 2) / std::tan(angle / 2) / 8) / (eigenvalue - 0.25);
    Vec3 across = end * (first + last);
    for (std::size_t i = 0; i < count; ++i) {
        const double here = angle * static_cast<double>(i), next = angle * static_cast<double>(i + 1);
        across += inner * std::sin(here) * edge_at(finer, begin + i);
        across += (std::sin(here) + std::sin(next)) * face_point(i);
    }
    return on_side_of((first - last).cross(across), side);
}

/// Writes the normals of the finest mesh, corner by corner.
class NormalWriter {
  public:
    NormalWriter(const Finest& finest, const QuadMesh& mesh, std::vector<Vec3f>& normals)
        : finest_(finest), mesh_(mesh), normals_(normals) {}

    Index face_of(Index slot) const {
        return finest_.splits == 0 ? finest_.levels[0].slot_face[slot] : slot >> 2;
    }

    void write(Index slot, Index vertex, const Vec3& normal) const {
        const Index face = face_of(slot), begin = mesh_.face_offsets[face],
                    end = mesh_.face_offsets[face + 1];
        Index corner = begin;
        while (corner + 1 < end && mesh_.corners[corner] != vertex) ++corner;
        normals_[corner] = normal.cast<float>();
    }

    /// Writes the normals of a vertex with sharp edges, side by side.
    void write_sides(const RuledRing& ring, Index vertex, bool corner) const {
        const VertexRing points = steadied(ring.points, corner);
        const std::vector<std::size_t> sharp = sharp_edges(points);
        const std::size_t faces = ring.slots.size(), n = points.sharpness.size();
        if (corner && sharp.size() < 2) return write_each(ring, vertex);
        if (sharp.empty()) return write_all(ring, vertex, smooth_normal(points));
        if (sharp.size() == 1) return write_all(ring, vertex, sum_of_faces(points, 0, faces).normalized());
        for (std::size_t s = 0; s < sharp.size(); ++s) {
            const std::size_t begin = sharp[s], end = s + 1 < sharp.size() ? sharp[s + 1] : sharp[0] + n;
            if (end > n - 1 && !points.closed) break;
            const Vec3 normal = !corner && sharp.size() == 2
                                    ? crease_normal(points, begin, end - begin)
                                    : sum_of_faces(points, begin, end - begin).normalized();
            for (std::size_t i = begin; i < end; ++i) write(ring.slots[i % faces], vertex, normal);
        }
    }

    void write_all(const RuledRing& ring, Index vertex, const Vec3& normal) const {
        for (const Index slot : ring.slots) write(slot, vertex, normal);
    }

  private:
    /// Subdivides until only infinitely sharp edges are left, and darts until they are flat.
    static VertexRing steadied(VertexRing points, bool corner) {
        if (corner) return points;
        while (fades(points.sharpness)) refine_ring(points);
        for (int i = 0; i < dart_steps && sharp_edges(points).size() == 1; ++i) refine_ring(points);
        return points;
    }

    static std::vector<std::size_t> sharp_edges(const VertexRing& points) {
        std::vector<std::size_t> sharp;
        for (std::size_t i = 0; i < points.sharpness.size(); ++i)
            if (points.sharpness[i] > 0) sharp.push_back(i);
        return sharp;
    }

    void write_each(const RuledRing& ring, Index vertex) const {
        for (std::size_t i = 0; i < ring.slots.size(); ++i)
            write(ring.slots[i], vertex, sum_of_faces(ring.points, i, 1).normalized());
    }

    const Finest& finest_;
    const QuadMesh& mesh_;
    std::vector<Vec3f>& normals_;
};

void write_smooth(const Finest& finest, std::span<const Vec3f> control, const NormalWriter& writer) {
    with_finest_faces(finest, control, [&](const auto& see) {
        for_each_ring(finest.levels, finest.splits, [&](Index vertex, const auto& slots) {
            if (slots.size() < 2) return;
            const Vec3f& point = control[vertex];
            SmoothNormal sum(slots.size());
            for (const Index slot : slots) {
                const SeenFace face = see(slot);
                sum.add((control[face.next] - point).template cast<double>(),
                        (face.mean - point).template cast<double>());
            }
            const Vec3 normal = sum.normal();
            for (const Index slot : slots) writer.write(slot, vertex, normal);
        });
    });
}

/// Positions as the surface beside the circles sees them.
std::vector<Vec3f> with_circle_controls(const Finest& finest, std::span<const Vec3f> control) {
    std::vector<Vec3f> seen(control.begin(), control.end());
    show_circle_controls(finest.rules.rounds, finest.features, seen);
    return seen;
}

/// Every triangle of a fan has its own normal at a fixed pole.
void write_poles(const Finest& finest, std::span<const Vec3f> control, const QuadMesh& mesh,
                 std::vector<Vec3f>& normals) {
    const Fans& fans = finest.rules.fans;
    for (const PoleFan& fan : fans.fans) {
        std::vector<Vec3> ring;
        for (const Index v : fans.ring_of(fan))
            ring.push_back((control[v] - control[fan.pole]).cast<double>());
        const auto tangents = polar_tangents(ring);
        for (std::size_t j = 0; j < ring.size(); ++j) {
            const Vec3 own = ring[j].cross(ring[(j + 1) % ring.size()]);
            const Index face = fans.faces[fan.first + j];
            const auto corners = mesh.face(face);
            const auto corner = std::ranges::find(corners, fan.pole) - corners.begin();
            normals[mesh.face_offsets[face] + static_cast<std::size_t>(corner)] =
                (fan.fixed ? own : tangents[0].cross(tangents[1])).normalized().cast<float>();
        }
    }
}

/// On a cone the normal is orthogonal to the line to the tip and to the circle's direction.
void write_cone(const Cone& cone, const Circle& circle, std::span<const Vec3f> control, const QuadMesh& mesh,
                std::vector<Vec3f>& normals) {
    const Vec3 tip = control[cone.tip].cast<double>(), axis = circle.axis.cast<double>();
    for (const Index face : cone.faces) {
        const auto corners = mesh.face(face);
        const auto at = [&](std::size_t i) -> Vec3 {
            return control[corners[i % corners.size()]].cast<double>();
        };
        Vec3 side = Vec3::Zero(), middle = Vec3::Zero();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            side += (at(i) - tip).cross(at(i + 1) - tip);
            middle += at(i) / static_cast<double>(corners.size());
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 from_tip = nearest_on_circle(circle, corners[i] == cone.tip ? middle : at(i)) - tip;
            const Vec3 outward = nearest_on_circle(circle, corners[i] == cone.tip ? middle : at(i)) -
                                 circle.centre.cast<double>();
            normals[mesh.face_offsets[face] + i] =
                on_side_of(from_tip.cross(axis.cross(outward)), side).cast<float>();
        }
    }
}

}  // namespace

std::vector<Vec3f> find_limit_normals(const Finest& finest, std::span<const Vec3f> control,
                                      const QuadMesh& mesh) {
    const auto& [sharpness, fans, rounds, flats] = finest.rules;
    std::vector<Vec3f> normals(mesh.corners.size(), Vec3f::Zero());
    const NormalWriter writer(finest, mesh, normals);
    const std::vector<Vec3f> copy =
        rounds.vertices.empty() ? std::vector<Vec3f>() : with_circle_controls(finest, control);
    const std::span<const Vec3f> seen = copy.empty() ? control : copy;
    write_smooth(finest, seen, writer);
    const FinestRings rings(finest, seen);
    for (const Index vertex : rings.round_poles()) {
        const RuledRing ring = rings.ring(vertex);
        writer.write_all(ring, vertex, smooth_normal(ring.points));
    }
    for (std::size_t i = 0; i < sharpness.vertices.size(); ++i)
        writer.write_sides(rings.ring(sharpness.vertices[i]), sharpness.vertices[i], sharpness.corner[i]);
    write_poles(finest, seen, mesh, normals);
    for (const Cone& cone : rounds.cones)
        write_cone(cone, finest.features.circles[cone.circle], control, mesh, normals);
    return normals;
}

}  // namespace sinew
