#include "sinew/sqm/bridge/features.h"

#include <algorithm>
#include <cmath>

#include "sinew/sqm/surface/dents.h"

namespace sinew::sqm {
namespace {

constexpr float rim_sharpness = 2;  // of grooves: less shows where the faces beside the rim change
constexpr auto infinite = static_cast<float>(infinitely_sharp);

class FeatureWriter {
  public:
    FeatureWriter(const Parts& parts, Bridge& bridge)
        : d_(parts), n_(parts.network), b_(bridge), out_(bridge.mesh.features) {}

    void run() {
        for (std::int32_t p = 0; p < n_.path_count(); ++p) {
            tips(p);
            if (!is_plain(d_.skeleton, n_, p)) path(p);
        }
        if (d_.skeleton.forms.empty()) return;
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) joint(j);
        for (std::size_t i = 0; i < n_.lone.size(); ++i) lone_box(i);
    }

  private:
    std::int32_t sides(std::int32_t p) const { return d_.refinement.path_sides[p]; }
    std::uint32_t vertex(std::int32_t p, std::int32_t ring, std::int32_t column) const {
        return b_.path_vertex[p] + ring * sides(p) + column % sides(p);
    }
    Cap cap(std::int32_t p, int end) const {
        const auto nodes = n_.nodes(p);
        return d_.skeleton.cap[end == 0 ? nodes.front() : nodes.back()];
    }
    std::vector<std::uint32_t> faces(std::uint32_t first, std::uint32_t count) const {
        std::vector<std::uint32_t> list(count);
        for (std::uint32_t i = 0; i < count; ++i) list[i] = first + i;
        return list;
    }
    void plane(const Vec3& point, const Vec3& normal, std::vector<std::uint32_t> list) {
        out_.planes.push_back({point.cast<float>(), normal.normalized().cast<float>(), std::move(list)});
    }
    void crease(std::uint32_t a, std::uint32_t b, float sharpness) {
        if (sharpness > 0) out_.creases.push_back({{a, b}, sharpness});
    }

    void tips(std::int32_t p) {
        for (int end = 0; end < 2; ++end)
            if (b_.path_pole[p][end] != no_vertex && cap(p, end) == Cap::point)
                out_.corners.push_back(b_.path_pole[p][end]);
    }

    void path(std::int32_t p) {
        const std::int32_t first = d_.stations.first[p], rings = d_.stations.first[p + 1] - first;
        const bool fan_first = b_.path_pole[p][0] != no_vertex,
                   starts_at_joint = n_.path_end[p][0].at_joint();
        // The band after ring i is band i, counted from where the bands begin; a joint's ring comes before
        // ring 0.
        const std::uint32_t bands =
            b_.path_face[p] + (fan_first ? sides(p) : 0) + (starts_at_joint ? sides(p) : 0);
        for (std::int32_t i = 0; i < rings; ++i) {
            const Station& ring = d_.stations.stations[first + i];
            ring_features(p, i, ring);
            if (i + 1 == rings) continue;
            const Station& next = d_.stations.stations[first + i + 1];
            const std::uint32_t band = bands + i * sides(p);
            if (ring.to_next == BoneKind::plate) {
                // It looks along the path where that gets narrower, and back where it gets wider.
                const double sign = next.half.sum() < ring.half.sum() ? 1 : -1;
                plane((sign > 0 ? ring : next).centre, sign * ring.tangent, faces(band, sides(p)));
            } else if (ring.shape == RingShape::outline && next.shape == RingShape::outline) {
                lines(p, i, i + 1, std::max(ring.lines, ring.to_next == BoneKind::side ? infinite : 0));
                if (ring.to_next == BoneKind::side) box_sides(p, i, band);
            }
        }
        for (int end = 0; end < 2; ++end) end_features(p, end);
    }

    void ring_features(std::int32_t p, std::int32_t i, const Station& ring) {
        const std::int32_t n = sides(p);
        if (ring.shape == RingShape::pit && ring.share == 1 && in_groove(p, ring))
            rim_of_groove(p, i, ring);
        else
            for (std::int32_t k = 0; k < n; ++k) crease(vertex(p, i, k), vertex(p, i, k + 1), ring.crease);
        if (ring.round) {
            Circle circle{
                ring.centre.cast<float>(), ring.tangent.cast<float>(), static_cast<float>(ring.half.x()), {}};
            for (std::int32_t k = 0; k < n; ++k)
                circle.edges.push_back({vertex(p, i, k), vertex(p, i, k + 1)});
            out_.circles.push_back(std::move(circle));
        }
        if (ring.corners && d_.stations.corner[p] >= 0)
            for (int c = 0; c < 4; ++c)
                out_.corners.push_back(vertex(p, i, corner_column(d_.stations.corner[p], c, n)));
    }
    bool in_groove(std::int32_t p, const Station& ring) const {
        const PathEnd& end = n_.path_end[p][ring.far ? 1 : 0];
        return merges(d_.surfaces, end.joint, n_.slot_first[end.joint] + end.slot);
    }
    /// The rim of a groove runs along the rings of its dents and from one to the next over the border between
    /// their cells, where faces lie to it otherwise than elsewhere: a crease makes it one smooth line.
    void rim_of_groove(std::int32_t p, std::int32_t i, const Station& ring) {
        const int end = ring.far ? 1 : 0;
        const std::int32_t joint = n_.path_end[p][end].joint;
        const Vec3& centre = d_.skeleton.position[n_.joint_node[joint]];
        const auto rests = [&](std::uint32_t v) {
            return on_rim(n_, d_.surfaces, joint, centre, b_.mesh.positions[v].cast<double>());
        };
        std::vector<std::uint32_t> border;
        joint_ring_of_path(d_, p, end, border);
        const std::int32_t rings = d_.stations.first[p + 1] - d_.stations.first[p], step = ring.far ? 1 : -1;
        const float sharpness = std::max(ring.crease, rim_sharpness);
        for (std::int32_t k = 0; k < sides(p); ++k) {
            if (!rests(vertex(p, i, k))) continue;
            if (rests(vertex(p, i, k + 1))) crease(vertex(p, i, k), vertex(p, i, k + 1), sharpness);
            std::uint32_t before = vertex(p, i, k);
            for (std::int32_t r = i + step; rests(border[k]) && r >= -1 && r <= rings; r += step) {
                const std::uint32_t v = r < 0 || r == rings ? border[k] : vertex(p, r, k);
                if (rests(v) && rests(before)) crease(before, v, sharpness);
                before = v;
            }
        }
    }
    void lines(std::int32_t p, std::int32_t i, std::int32_t next, float sharpness) {
        for (int c = 0; c < 4; ++c) {
            const std::int32_t column = corner_column(d_.stations.corner[p], c, sides(p));
            crease(vertex(p, i, column), vertex(p, next, column), sharpness);
        }
    }
    void box_sides(std::int32_t p, std::int32_t i, std::uint32_t band) {
        const Station& ring = d_.stations.stations[d_.stations.first[p] + i];
        const Vec3 y = ring.tangent.cross(ring.form_x);
        const std::int32_t n = sides(p), first = d_.stations.corner[p];
        for (int c = 0; c < 4; ++c) {
            const int side = (c + ring.corner) % 4;  // from this corner on: +y, -x, -y, +x
            const Vec3 normal = side == 0   ? y
                                : side == 1 ? Vec3(-ring.form_x)
                                : side == 2 ? Vec3(-y)
                                            : ring.form_x;
            const double half = side % 2 == 0 ? ring.half.y() : ring.half.x();
            std::vector<std::uint32_t> list;
            for (std::int32_t k = corner_column(first, c, n); k != corner_column(first, (c + 1) % 4, n);
                 k = (k + 1) % n)
                list.push_back(band + k);
            plane(ring.centre + half * normal, normal, std::move(list));
        }
    }

    void end_features(std::int32_t p, int end) {
        flat_end(p, end);
        const PathEnd& e = n_.path_end[p][end];
        const Form* body = e.at_joint() ? d_.surfaces.body[e.joint] : nullptr;
        if (!body || body->kind != Form::Kind::box) return;
        if (is_face_of_box(p, end))
            box_face(e, *body, faces(band_at(p, end), sides(p)));
        else if (goes_on_flush(p, end))
            flush_edges(p, end);
    }
    std::int32_t ring_count(std::int32_t p) const { return d_.stations.first[p + 1] - d_.stations.first[p]; }
    std::int32_t ring_at(std::int32_t p, int end) const { return end == 0 ? 0 : ring_count(p) - 1; }
    const Station& station_at(std::int32_t p, int end) const {
        return d_.stations.stations[d_.stations.first[p] + ring_at(p, end)];
    }
    BoneKind bone_kind(std::int32_t p, int end) const {
        return d_.skeleton.bone_kind[n_.bones(p)[end == 0 ? 0 : n_.nodes(p).size() - 2]];
    }
    /// The first of the faces at one end of a path: of a fan, or of the band next to a joint.
    std::uint32_t band_at(std::int32_t p, int end) const {
        return end == 0 ? b_.path_face[p] : b_.path_face[p + 1] - sides(p);
    }

    /// The disc at a flat end.
    void flat_end(std::int32_t p, int end) {
        if (b_.path_pole[p][end] == no_vertex || cap(p, end) != Cap::flat || ring_count(p) == 0) return;
        const Station& ring = station_at(p, end);
        plane(ring.centre, end == 0 ? Vec3(-ring.tangent) : ring.tangent, faces(band_at(p, end), sides(p)));
    }
    /// Whether the faces next to a box lie in its own face: a fan where nothing leaves it there, or the band
    /// to the ring that the face has as a hole.
    bool is_face_of_box(std::int32_t p, int end) const {
        return ring_count(p) == 0 ? cap(p, 1 - end) == Cap::surface : bone_kind(p, end) == BoneKind::body;
    }
    void box_face(const PathEnd& e, const Form& box, std::vector<std::uint32_t> list) {
        const Vec3& normal = d_.polyhedra.sites[d_.polyhedra.cell_first[e.joint] + e.slot];
        const Vec3& centre = d_.skeleton.position[n_.joint_node[e.joint]];
        const Vec3 local(normal.dot(box.x), normal.dot(box.y), normal.dot(box.z));
        plane(centre + local.cwiseAbs().dot(box.half) * normal, normal, std::move(list));
    }
    /// Whether a beam leaves a box with the outline of its face.
    bool goes_on_flush(std::int32_t p, int end) const {
        return ring_count(p) > 0 && bone_kind(p, end) == BoneKind::tube &&
               station_at(p, end).shape == RingShape::outline;
    }
    /// The edges of such a beam are those of the box: they go on from its corners.
    void flush_edges(std::int32_t p, int end) {
        std::vector<std::uint32_t> joint_ring;
        joint_ring_of_path(d_, p, end, joint_ring);
        for (int c = 0; c < 4; ++c) {
            const std::int32_t column = corner_column(d_.stations.corner[p], c, sides(p));
            crease(joint_ring[column], vertex(p, ring_at(p, end), column), infinite);
        }
    }

    void joint(std::int32_t j) {
        const Form* body = d_.surfaces.body[j];
        if (!body) return;
        const bool box = body->kind == Form::Kind::box;
        const float sharpness = box                               ? infinite
                                : body->kind == Form::Kind::blend ? static_cast<float>(body->sharpness)
                                                                  : 0;
        if (sharpness <= 0) return;
        const Polyhedra& poly = d_.polyhedra;
        const auto of = [&](std::int32_t v) { return d_.points.first[j] + v - poly.vertex_first[j]; };
        for (std::int32_t a = poly.arc_first[j]; a < poly.arc_first[j + 1]; ++a) {
            std::uint32_t at = of(poly.arcs[a].from);
            for (std::int32_t i = 0; i + 1 < d_.refinement.pieces[a]; ++i) {
                crease(at, d_.points.arc_first[a] + i, sharpness);
                at = d_.points.arc_first[a] + i;
            }
            crease(at, of(poly.arcs[a].to), sharpness);
        }
        for (std::int32_t v = poly.vertex_first[j]; box && v < poly.vertex_first[j + 1]; ++v)
            out_.corners.push_back(of(v));
    }

    /// Edges are the pairs of points that differ by one in one coordinate and have two at their ends.
    void lone_box(std::size_t i) {
        const std::int32_t node = n_.lone[i];
        const Form* form = d_.skeleton.form(node);
        if (!form || form->kind != Form::Kind::box) return;
        const auto& points = lone_sphere_points();
        const auto base = b_.lone_vertex + static_cast<std::uint32_t>(i * points.size());
        for (std::uint32_t a = 0; a < points.size(); ++a) {
            const Vec3 pa(points[a][0], points[a][1], points[a][2]);
            if (pa.squaredNorm() == 3) out_.corners.push_back(base + a);
            for (std::uint32_t b = 0; b < points.size(); ++b) {
                const Vec3 pb(points[b][0], points[b][1], points[b][2]);
                if (pa.squaredNorm() == 3 && pb.squaredNorm() == 2 && (pa - pb).squaredNorm() == 1)
                    crease(base + a, base + b, infinite);
            }
        }
        const auto first_face = static_cast<std::uint32_t>(b_.mesh.face_count() - 24 * (n_.lone.size() - i));
        const Vec3 axes[] = {form->x, form->y, form->z};
        for (std::uint32_t side = 0; side < 6; ++side) {
            const Vec3 normal = (side % 2 == 0 ? -1.0 : 1.0) * axes[side / 2];
            plane(d_.skeleton.position[node] + form->half[side / 2] * normal, normal,
                  faces(first_face + 4 * side, 4));
        }
    }

    const Parts& d_;
    const Network& n_;
    Bridge& b_;
    Features& out_;
};

}  // namespace

void add_features(const Parts& parts, Bridge& bridge) { FeatureWriter(parts, bridge).run(); }

}  // namespace sinew::sqm
