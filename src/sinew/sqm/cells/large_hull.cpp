#include "sinew/sqm/cells/large_hull.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace sinew::sqm {
namespace {

using GridPoint = Eigen::Matrix<std::int64_t, 3, 1>;
using Triangle = std::array<std::int32_t, 3>;
__extension__ using Wide = __int128;  // differences have 40 bits: a determinant has 122

constexpr std::int32_t none = -1;

/// The same for an index every time, and as good as random.
std::uint64_t scatter(std::uint64_t i) {
    i = (i + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
    i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
    return i ^ (i >> 31);
}

/// Place on a curve that fills the cube round the sphere: ten bits of each coordinate, by turns.
std::uint64_t along_curve(const Vec3& point) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto x = static_cast<std::uint64_t>(std::clamp((point[axis] + 1) * 512, 0.0, 1023.0));
        for (int bit = 0; bit < 10; ++bit) code |= ((x >> bit) & 1) << (3 * bit + axis);
    }
    return code;
}

/// Half of the points are of the last round, a quarter of the one before, and so on.
std::vector<std::int32_t> order_of(std::span<const Vec3> points) {
    constexpr std::uint64_t most_rounds = 20;
    std::vector<std::pair<std::uint64_t, std::int32_t>> keys;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::uint64_t back = 0;
        for (std::uint64_t random = scatter(i); back < most_rounds && (random & 1) != 0; random >>= 1) ++back;
        keys.emplace_back(((most_rounds - back) << 32) | along_curve(points[i]),
                          static_cast<std::int32_t>(i));
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::int32_t> order;
    for (const auto& [key, i] : keys) order.push_back(i);
    return order;
}

class LargeHull {
  public:
    LargeHull(std::span<const Vec3> points, std::span<const GridPoint> grid)
        : points_(points), grid_(grid), face_at_(points.size(), none), starting_(points.size(), none) {}

    std::vector<Triangle> run(std::array<std::int32_t, 4> t) {
        start(t);
        for (const std::int32_t i : order_of(points_))
            if (std::find(t.begin(), t.end(), i) == t.end()) insert(i);
        std::vector<Triangle> alive;
        for (const Face& f : faces_)
            if (!f.gone) alive.push_back(f.corner);
        return alive;
    }

  private:
    struct Face {
        Triangle corner{};
        Triangle beyond{};  ///< the face across the edge from corner k to the next one
        bool gone = false;
        std::int32_t seen_by = none;
    };
    struct Edge {
        std::int32_t from, to, beyond;  ///< on the horizon; the face that stays
    };

    void start(std::array<std::int32_t, 4>& t) {
        if (wide_orientation(grid_[t[0]], grid_[t[1]], grid_[t[2]], grid_[t[3]]) > 0) std::swap(t[1], t[2]);
        faces_.push_back({{t[0], t[1], t[2]}, {1, 2, 3}});
        faces_.push_back({{t[0], t[3], t[1]}, {3, 2, 0}});
        faces_.push_back({{t[1], t[3], t[2]}, {1, 3, 0}});
        faces_.push_back({{t[2], t[3], t[0]}, {2, 1, 0}});
        for (std::int32_t f = 0; f < 4; ++f)
            for (const std::int32_t c : faces_[f].corner) face_at_[c] = f;
        last_ = t[0];
    }
    bool sees(std::int32_t point, const Face& f) const {
        return wide_orientation(grid_[f.corner[0]], grid_[f.corner[1]], grid_[f.corner[2]], grid_[point]) > 0;
    }
    static int at(const Face& f, std::int32_t point) {
        return f.corner[0] == point ? 0 : f.corner[1] == point ? 1 : 2;
    }
    /// visit(face) for the faces round a point, which are no more than there are faces.
    template <class Visit>
    void for_faces_round(std::int32_t point, Visit visit) const {
        std::int32_t f = face_at_[point];
        do {
            visit(f);
            f = faces_[f].beyond[at(faces_[f], point)];
        } while (f != face_at_[point]);
    }
    /// The nearest point that is in: each step of the walk is to a nearer one.
    std::int32_t nearest(std::int32_t point) const {
        std::int32_t here = last_;
        double best = points_[here].dot(points_[point]);
        for (bool moved = true; moved;) {
            moved = false;
            std::int32_t next = here;
            for_faces_round(here, [&](std::int32_t f) {
                const std::int32_t other = faces_[f].corner[(at(faces_[f], here) + 1) % 3];
                if (const double near = points_[other].dot(points_[point]); near > best)
                    best = near, next = other, moved = true;
            });
            here = next;
        }
        return here;
    }
    /// A face that sees a point; none if it is inside.
    std::int32_t find_seeing(std::int32_t point) const {
        std::int32_t found = none;
        for_faces_round(nearest(point), [&](std::int32_t f) {
            if (found == none && sees(point, faces_[f])) found = f;
        });
        // Where rounding leads astray: all of them.
        for (std::int32_t f = 0; found == none && f < std::ssize(faces_); ++f)
            if (!faces_[f].gone && sees(point, faces_[f])) found = f;
        return found;
    }
    void insert(std::int32_t point) {
        const std::int32_t first = find_seeing(point);
        if (first == none) return;
        std::vector<std::int32_t>& seen = seen_;
        seen.assign(1, first);
        horizon_.clear();
        faces_[first].seen_by = point;
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const std::int32_t beyond = faces_[seen[i]].beyond[k];
                if (faces_[beyond].seen_by == point) continue;
                if (sees(point, faces_[beyond])) {
                    faces_[beyond].seen_by = point;
                    seen.push_back(beyond);
                }
            }
        for (const std::int32_t f : seen)
            for (int k = 0; k < 3; ++k)
                if (const std::int32_t beyond = faces_[f].beyond[k]; faces_[beyond].seen_by != point)
                    horizon_.push_back({faces_[f].corner[k], faces_[f].corner[(k + 1) % 3], beyond});
        if (!is_ring()) return;
        for (const std::int32_t f : seen) faces_[f].gone = true;
        join(point);
    }
    /// Whether the horizon goes through each of its points once, as it does but for rounding.
    bool is_ring() {
        bool once = true;
        for (const Edge& e : horizon_) once = once && std::exchange(starting_[e.from], 0) == none;
        for (const Edge& e : horizon_) starting_[e.from] = none;
        return once;
    }
    void join(std::int32_t point) {
        const auto first = static_cast<std::int32_t>(faces_.size());
        for (std::size_t i = 0; i < horizon_.size(); ++i)
            starting_[horizon_[i].from] = first + static_cast<std::int32_t>(i);
        for (const Edge& e : horizon_) {
            const auto f = static_cast<std::int32_t>(faces_.size());
            faces_.push_back({{e.from, e.to, point}, {e.beyond, starting_[e.to], none}});
            Face& beyond = faces_[e.beyond];
            beyond.beyond[at(beyond, e.to)] = f;
            face_at_[e.from] = f;
        }
        for (std::int32_t f = first; f < std::ssize(faces_); ++f) faces_[faces_[f].beyond[1]].beyond[2] = f;
        for (const Edge& e : horizon_) starting_[e.from] = none;
        face_at_[point] = first;
        last_ = point;
    }

    std::span<const Vec3> points_;
    std::span<const GridPoint> grid_;
    std::vector<Face> faces_;
    std::vector<std::int32_t> face_at_;   // point -> a face that it is a corner of
    std::vector<std::int32_t> starting_;  // point -> the new face whose edge on the horizon starts there
    std::vector<std::int32_t> seen_;
    std::vector<Edge> horizon_;
    std::int32_t last_ = 0;
};

}  // namespace

int wide_orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
    const GridPoint u = b - a, v = c - a, w = d - a;
    const auto minor = [&](int i, int j) { return Wide(u[i]) * v[j] - Wide(u[j]) * v[i]; };
    const Wide sum = minor(1, 2) * w[0] + minor(2, 0) * w[1] + minor(0, 1) * w[2];
    return (sum > 0) - (sum < 0);
}

std::vector<Triangle> find_large_hull(std::span<const Vec3> points, std::span<const GridPoint> grid,
                                      std::array<std::int32_t, 4> tetrahedron) {
    return LargeHull(points, grid).run(tetrahedron);
}

}  // namespace sinew::sqm
