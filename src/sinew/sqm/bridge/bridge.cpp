#include "sinew/sqm/bridge/bridge.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace sinew::sqm {
namespace {

/// Counts and offsets of everything, then the faces, each path in its own range.
class Builder {
  public:
    explicit Builder(const Parts& parts) : d_(parts), n_(parts.network) {}

    Result<Bridge> run(const Progress& progress) {
        if (!lay_out())
            return fail(ErrorKind::input, "the mesh would have more than 4,000 million vertices",
                        "skin it in parts");
        QuadMesh& mesh = out_.mesh;
        mesh.positions.resize(vertices_);
        mesh.corners.resize(corner_total_);
        mesh.face_offsets.resize(face_total_ + 1);
        mesh.face_offsets[face_total_] = static_cast<std::uint32_t>(corner_total_);
        tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n_.path_count(), 128), [&](const auto& range) {
            std::vector<std::uint32_t> near, far;
            for (std::int32_t p = range.begin(); p < range.end() && !progress.cancelled(); ++p)
                tube(p, near, far);
        });
        if (progress.cancelled()) return Progress::stopped();
        rest();
        return std::move(out_);
    }

  private:
    struct Cursor {
        std::uint32_t* corner;
        std::uint32_t* offset;
        std::uint32_t at;
    };
    std::int32_t ring_count(std::int32_t p) const { return d_.stations.first[p + 1] - d_.stations.first[p]; }
    std::int32_t sides(std::int32_t p) const { return d_.refinement.path_sides[p]; }
    bool has_pole(std::int32_t p, int end) const {
        return !n_.path_closed[p] && !n_.path_end[p][end].at_joint();
    }

    bool lay_out() {
        const std::size_t paths = n_.path_count();
        out_.path_vertex.reserve(paths + 1);
        out_.path_pole.reserve(paths);
        out_.path_face.reserve(paths + 1);
        first_face_.reserve(paths + 1);
        first_corner_.reserve(paths + 1);
        vertices_ = d_.points.position.size();
        out_.path_vertex.push_back(static_cast<std::uint32_t>(vertices_));
        first_face_ = {0};
        out_.path_face = {0};
        first_corner_ = {0};
        for (std::int32_t p = 0; p < n_.path_count(); ++p) {
            const std::uint64_t rings = ring_count(p), n = sides(p);
            const std::uint64_t poles = has_pole(p, 0) + has_pole(p, 1),
                                ends = n_.path_closed[p] ? 1 : 2 - poles;
            vertices_ += rings * n;
            std::array<std::uint32_t, 2> pole{no_vertex, no_vertex};
            for (int end = 0; end < 2; ++end)
                if (has_pole(p, end)) {
                    pole[end] = static_cast<std::uint32_t>(vertices_++);
                    out_.mesh.features.poles.push_back(pole[end]);
                }
            out_.path_pole.push_back(pole);
            const std::uint64_t bands = (rings + ends - 1) * n, fans = poles * n;
            first_face_.push_back(first_face_.back() + bands + fans);
            first_corner_.push_back(first_corner_.back() + 4 * bands + 3 * fans);
            out_.path_vertex.push_back(static_cast<std::uint32_t>(vertices_));
            out_.path_face.push_back(static_cast<std::uint32_t>(first_face_.back()));
            if (vertices_ > 4'000'000'000u || first_corner_.back() > 4'200'000'000u) return false;
        }
        find_capped();
        face_total_ = first_face_.back() + capped_sides_ + lone_sphere_faces().size() * n_.lone.size();
        corner_total_ =
            first_corner_.back() + 3 * capped_sides_ + 4 * lone_sphere_faces().size() * n_.lone.size();
        return vertices_ < 4'000'000'000u && corner_total_ < 4'200'000'000u;
    }
    void find_capped() {
        const Polyhedra& p = d_.polyhedra;
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            for (std::int32_t c = p.cell_first[j] + n_.degree(j); c < p.cell_first[j + 1]; ++c) {
                out_.capped.push_back(c);
                capped_joint_.push_back(j);
                for (const CellSide& side : p.cell(c)) capped_sides_ += d_.refinement.pieces[side.arc];
            }
        out_.capped_pole = static_cast<std::uint32_t>(vertices_);
        for (std::size_t i = 0; i < out_.capped.size(); ++i)
            out_.mesh.features.poles.push_back(out_.capped_pole + static_cast<std::uint32_t>(i));
        vertices_ += out_.capped.size();
        out_.lone_vertex = static_cast<std::uint32_t>(vertices_);
        vertices_ += lone_sphere_points().size() * n_.lone.size();
    }

    Cursor cursor(std::uint64_t face, std::uint64_t corner) {
        return {out_.mesh.corners.data() + corner, out_.mesh.face_offsets.data() + face,
                static_cast<std::uint32_t>(corner)};
    }
    static void quad(Cursor& c, std::uint32_t v0, std::uint32_t v1, std::uint32_t v2, std::uint32_t v3) {
        *c.offset++ = c.at;
        c.at += 4;
        *c.corner++ = v0, *c.corner++ = v1, *c.corner++ = v2, *c.corner++ = v3;
    }
    static void triangle(Cursor& c, std::uint32_t v0, std::uint32_t v1, std::uint32_t v2) {
        *c.offset++ = c.at;
        c.at += 3;
        *c.corner++ = v0, *c.corner++ = v1, *c.corner++ = v2;
    }
    /// Calls face(this, next) for all columns of a ring: their vertices.
    template <class Ring, class Face>
    static void for_columns(std::uint32_t columns, Ring ring, Face face) {
        for (std::uint32_t k = 1; k < columns; ++k) face(ring(k - 1), ring(k));
        face(ring(columns - 1), ring(0));
    }
    /// Quads from one ring to the next; each says which vertices a column has.
    template <class From, class To>
    static void band(Cursor& c, std::uint32_t columns, From from, To to) {
        const auto pair = [&](std::uint32_t k) { return std::array{from(k), to(k)}; };
        for_columns(columns, pair, [&](const auto& a, const auto& b) { quad(c, a[0], b[0], b[1], a[1]); });
    }

    /// @param near,far  working memory
    void tube(std::int32_t p, std::vector<std::uint32_t>& near, std::vector<std::uint32_t>& far) {
        Cursor c = cursor(first_face_[p], first_corner_[p]);
        const auto n = static_cast<std::uint32_t>(sides(p));
        const std::int32_t rings = ring_count(p);
        const auto ring = [&](std::int32_t i) {
            return [first = out_.path_vertex[p] + i * n](std::uint32_t k) { return first + k; };
        };
        const auto of_joint = [&](int end, std::vector<std::uint32_t>& vertices) {
            joint_ring_of_path(d_, p, end, vertices);
            return [&vertices](std::uint32_t k) { return vertices[k]; };
        };
        const auto close = [&](auto last) {
            const std::uint32_t shift = d_.stations.far_shift[p], pole = out_.path_pole[p][1];
            if (n_.path_closed[p])  // what comes next is the first ring, as seen from the frame that went
                                    // round
                band(c, n, last,
                     [&](std::uint32_t k) { return ring(0)(k + shift < n ? k + shift : k + shift - n); });
            else if (n_.path_end[p][1].at_joint())
                band(c, n, last, of_joint(1, far));
            else
                for_columns(n, last, [&](std::uint32_t a, std::uint32_t b) { triangle(c, a, b, pole); });
        };

        if (n_.path_end[p][0].at_joint()) {
            const auto first = of_joint(0, near);
            if (rings == 0) return close(first);
            band(c, n, first, ring(0));
        } else if (!n_.path_closed[p]) {
            const std::uint32_t pole = out_.path_pole[p][0];
            for_columns(n, ring(0), [&](std::uint32_t a, std::uint32_t b) { triangle(c, b, a, pole); });
        }
        for (std::int32_t i = 1; i < rings; ++i) band(c, n, ring(i - 1), ring(i));
        close(ring(rings - 1));
    }

    void rest() {
        Cursor c = cursor(first_face_.back(), first_corner_.back());
        std::vector<std::uint32_t> ring;
        for (std::size_t i = 0; i < out_.capped.size(); ++i) {
            ring.clear();
            for_ring(d_.polyhedra, d_.refinement, d_.points, capped_joint_[i], out_.capped[i],
                     [&](std::uint32_t point) { ring.push_back(point); });
            for (std::size_t k = 0; k < ring.size(); ++k)
                triangle(c, ring[k], ring[(k + 1) % ring.size()],
                         out_.capped_pole + static_cast<std::uint32_t>(i));
        }
        const auto& faces = lone_sphere_faces();
        for (std::size_t i = 0; i < n_.lone.size(); ++i) {
            const auto base = out_.lone_vertex + static_cast<std::uint32_t>(i * lone_sphere_points().size());
            for (const auto& f : faces) quad(c, base + f[0], base + f[1], base + f[2], base + f[3]);
        }
    }

    const Parts& d_;
    const Network& n_;
    Bridge out_;
    std::vector<std::uint64_t> first_face_, first_corner_;  // path -> its first face and corner
    std::vector<std::int32_t> capped_joint_;
    std::uint64_t vertices_ = 0, face_total_ = 0, corner_total_ = 0, capped_sides_ = 0;
};

}  // namespace

void joint_ring_of_path(const Parts& d, std::int32_t path, int end, std::vector<std::uint32_t>& ring) {
    const PathEnd& e = d.network.path_end[path][end];
    const std::int32_t columns = d.refinement.path_sides[path],
                       step = end == 0 ? 1 : -1;  // seen from the far joint, columns go the other way round
    ring.resize(columns);
    std::int32_t k = end == 0 ? 0 : columns - 1 - d.stations.far_shift[path];
    for_ring(d.polyhedra, d.refinement, d.points, e.joint, d.polyhedra.cell_first[e.joint] + e.slot,
             [&](std::uint32_t point) {
                 ring[k] = point;
                 k += step;
                 if (k < 0) k = columns - 1;
             });
}

Result<Bridge> bridge(const Parts& parts, const Progress& progress) { return Builder(parts).run(progress); }

}  // namespace sinew::sqm
