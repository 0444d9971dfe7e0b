#include "sinew/sqm/cells/sphere_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/cells/large_hull.h"
#include "sinew/sqm/cells/near_directions.h"

namespace sinew::sqm {
namespace {

using GridPoint = Eigen::Matrix<std::int64_t, 3, 1>;
using Triangle = std::array<std::int32_t, 3>;

/// Positive if d is on the side from which a, b, c are counter-clockwise. Differences have 20 bits: exact
/// in 64.
std::int64_t orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
    return (b - a).cross(c - a).dot(d - a);
}

constexpr double grid_steps = 1 << 18;
/// Of a crowd, where neighbours may be so near each other that the coarser grid would put one inside.
constexpr double fine_steps = std::int64_t{1} << 38;

void round_to_grid(std::span<const Vec3> points, double steps, std::vector<GridPoint>& grid) {
    grid.clear();
    for (const Vec3& p : points)
        grid.push_back({std::llrint(p.x() * steps), std::llrint(p.y() * steps), std::llrint(p.z() * steps)});
}

/// Index of the first point off the plane of points 0, 1, 2, or the number of points.
std::size_t first_off_plane(std::span<const GridPoint> grid, bool wide) {
    std::size_t i = 3;
    const auto in_plane = [&](const GridPoint& p) {
        return wide ? wide_orientation(grid[0], grid[1], grid[2], p) == 0
                    : orientation(grid[0], grid[1], grid[2], p) == 0;
    };
    while (i < grid.size() && in_plane(grid[i])) ++i;
    return i;
}

/// Two opposite polygons through all points.
void flat_hull(std::span<const Vec3> points, SphereHull& hull) {
    const Vec3 normal = (points[1] - points[0]).cross(points[2] - points[0]).normalized();
    const Vec3 centre = normal * normal.dot(points[0]);
    const Vec3 x = (points[0] - centre).normalized(), y = normal.cross(x);
    auto angle = [&](std::int32_t i) {
        return portable::angle_of((points[i] - centre).dot(y), (points[i] - centre).dot(x));
    };
    hull.corner.resize(points.size());
    std::iota(hull.corner.begin(), hull.corner.end(), 0);
    if (points.size() > 3)
        std::sort(hull.corner.begin() + 1, hull.corner.end(), [&](auto a, auto b) {
            const auto turn = [&](auto i) {
                const double t = angle(i);
                return t < 0 ? t + 2 * M_PI : t;
            };
            return turn(a) < turn(b);
        });
    const auto count = static_cast<std::int32_t>(points.size());
    hull.corner.insert(hull.corner.end(), hull.corner.rbegin(), hull.corner.rend());
    hull.first = {0, count, 2 * count};
}

/// Adds points one by one to a tetrahedron: faces that see the point go, and its horizon is joined to it.
class Incremental {
  public:
    Incremental(SphereHull& hull, std::int32_t count)
        : hull_(hull), count_(count), faces_(hull.triangles), seen_(hull.seen) {
        faces_.clear();
        hull.stays.assign(static_cast<std::size_t>(count) * count, -1);
    }

    void start(std::array<std::int32_t, 4> t) {
        const auto& g = hull_.grid;
        if (orientation(g[t[0]], g[t[1]], g[t[2]], g[t[3]]) > 0) std::swap(t[1], t[2]);
        for (const Triangle& face :
             {Triangle{t[0], t[1], t[2]}, {t[0], t[3], t[1]}, {t[1], t[3], t[2]}, {t[2], t[3], t[0]}})
            add(face);
    }
    void insert(std::int32_t point) {
        const std::size_t before = faces_.size();
        std::size_t kept = 0;
        seen_.clear();
        for (std::size_t f = 0; f < before; ++f) {
            if (sees(point, faces_[f])) {
                seen_.push_back(faces_[f]);
                for (int k = 0; k < 3; ++k) edge(faces_[f][k], faces_[f][(k + 1) % 3]) = -1;
            } else {
                faces_[kept++] = faces_[f];
            }
        }
        faces_.resize(kept);
        for (const Triangle& face : seen_)
            for (int k = 0; k < 3; ++k) {
                const std::int32_t a = face[k], b = face[(k + 1) % 3];
                if (edge(b, a) >= 0) add({a, b, point});  // the face beyond stays: a, b is on the horizon
            }
    }

  private:
    std::int32_t& edge(std::int32_t a, std::int32_t b) { return hull_.stays[a * count_ + b]; }
    bool sees(std::int32_t point, const Triangle& f) const {
        const auto& g = hull_.grid;
        return orientation(g[f[0]], g[f[1]], g[f[2]], g[point]) > 0;
    }
    void add(const Triangle& face) {
        faces_.push_back(face);
        for (int k = 0; k < 3; ++k) edge(face[k], face[(k + 1) % 3]) = 0;
    }

    SphereHull& hull_;
    std::int32_t count_;
    std::vector<Triangle>&faces_, &seen_;
};

void take_triangles(std::span<const Triangle> triangles, SphereHull& hull) {
    hull.first = {0};
    for (const Triangle& face : triangles) {
        hull.corner.insert(hull.corner.end(), face.begin(), face.end());
        hull.first.push_back(static_cast<std::int32_t>(hull.corner.size()));
    }
}

void index_edges(SphereHull& hull, std::int32_t count) {
    hull.edge_first.assign(count + 1, 0);
    for (const std::int32_t i : hull.corner) ++hull.edge_first[i + 1];
    std::partial_sum(hull.edge_first.begin(), hull.edge_first.end(), hull.edge_first.begin());
    hull.edges.resize(hull.corner.size());
    std::vector<std::int32_t>& next = hull.next;
    next.assign(hull.edge_first.begin(), hull.edge_first.end() - 1);
    for (std::int32_t f = 0; f < hull.face_count(); ++f) {
        const auto face = hull.face(f);
        for (std::size_t k = 0; k < face.size(); ++k)
            hull.edges[next[face[k]]++] = {face[k + 1 < face.size() ? k + 1 : 0], f};
    }
    for (std::int32_t i = 0; i < count; ++i)
        std::sort(hull.edges.begin() + hull.edge_first[i], hull.edges.begin() + hull.edge_first[i + 1],
                  [](const auto& a, const auto& b) { return a.to < b.to; });
}

}  // namespace

std::int32_t SphereHull::face_of(std::int32_t from, std::int32_t to) const {
    const auto begin = edges.begin() + edge_first[from], end = edges.begin() + edge_first[from + 1];
    const auto at = std::lower_bound(begin, end, to, [](const Edge& e, std::int32_t k) { return e.to < k; });
    return at != end && at->to == to ? at->face : -1;
}

void find_sphere_hull(std::span<const Vec3> points, SphereHull& hull) {
    const auto count = static_cast<std::int32_t>(points.size());
    const bool large = count > crowd;
    round_to_grid(points, large ? fine_steps : grid_steps, hull.grid);
    hull.corner.clear();
    const auto off = static_cast<std::int32_t>(first_off_plane(hull.grid, large));
    if (off == count) {
        flat_hull(points, hull);
    } else if (large) {
        take_triangles(find_large_hull(points, hull.grid, {0, 1, 2, off}), hull);
    } else {
        Incremental incremental(hull, count);
        incremental.start({0, 1, 2, off});
        for (std::int32_t i = 3; i < count; ++i)
            if (i != off) incremental.insert(i);
        take_triangles(hull.triangles, hull);
    }
    index_edges(hull, count);
}

}  // namespace sinew::sqm
