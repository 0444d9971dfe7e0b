#include "sinew/mesh/triangle_pair.h"

#include <algorithm>

#include "sinew/mesh/predicates.h"

namespace sinew {
namespace {

/// A triangle with its points at hand.
struct Points {
    const Vec3f* p[3];
    const Vec3f& operator[](int i) const { return *p[i % 3]; }
};

Points points_of(const std::vector<Vec3f>& positions, const Triangle& t) {
    return {{&positions[t[0]], &positions[t[1]], &positions[t[2]]}};
}

int side(const Points& plane, const Vec3f& point) { return orient3d(plane[0], plane[1], plane[2], point); }

bool holds_in_plane(const Points& t, int axis, const Vec3f& point) {
    const int turn = orient2d(t[0], t[1], t[2], axis);
    for (int i = 0; i < 3; ++i)
        if (orient2d(t[i], t[i + 1], point, axis) * turn < 0) return false;
    return true;
}

/// Do two segments in one plane, not on one line, have a point in common?
bool cross_in_plane(const Vec3f& p, const Vec3f& q, const Vec3f& a, const Vec3f& b, int axis) {
    const int pa = orient2d(p, q, a, axis), pb = orient2d(p, q, b, axis);
    if (pa * pb > 0 || (pa == 0 && pb == 0)) return false;
    return orient2d(a, b, p, axis) * orient2d(a, b, q, axis) <= 0;
}

/// A segment in the plane of a triangle. Where it covers a whole edge it crosses the two others, at their
/// ends.
bool meets_in_plane(const Vec3f& p, const Vec3f& q, const Points& t) {
    const int axis = projection_axis(t[0], t[1], t[2]);
    if (holds_in_plane(t, axis, p) || holds_in_plane(t, axis, q)) return true;
    for (int i = 0; i < 3; ++i)
        if (cross_in_plane(p, q, t[i], t[i + 1], axis)) return true;
    return false;
}

/// A segment whose ends lie on different sides of the triangle's plane, or one of them in it.
bool pierces(const Vec3f& p, const Vec3f& q, const Points& t) {
    int turn = 0;
    for (int i = 0; i < 3; ++i) {
        const int next = orient3d(p, q, t[i], t[i + 1]);
        if (next * turn < 0) return false;
        if (next != 0) turn = next;
    }
    return true;
}

bool segment_meets(const Vec3f& p, const Vec3f& q, const Points& t) {
    const int above_p = side(t, p), above_q = side(t, q);
    if (above_p * above_q > 0) return false;
    return above_p == 0 && above_q == 0 ? meets_in_plane(p, q, t) : pierces(p, q, t);
}

/// Does an edge of `a`, whose vertices lie on these sides of the plane of `b`, meet `b`? An edge in that
/// plane needs no look as long as the third vertex is not: the other edges look at its ends, and those of `b`
/// at what is between.
bool edge_meets(const Points& a, const int (&sides)[3], const Points& b) {
    const bool in_plane = sides[0] == 0 && sides[1] == 0 && sides[2] == 0;
    for (int i = 0; i < 3; ++i) {
        const int from = sides[i], to = sides[(i + 1) % 3];
        if (in_plane ? meets_in_plane(a[i], a[i + 1], b)
                     : (from != 0 || to != 0) && from * to <= 0 && pierces(a[i], a[i + 1], b))
            return true;
    }
    return false;
}

bool apart(const int (&sides)[3]) { return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2]; }

bool separate_triangles_meet(const Points& a, const Points& b) {
    const int a_sides[] = {side(b, a[0]), side(b, a[1]), side(b, a[2])};
    if (apart(a_sides)) return false;
    const int b_sides[] = {side(a, b[0]), side(a, b[1]), side(a, b[2])};
    if (apart(b_sides)) return false;
    return edge_meets(a, a_sides, b) || edge_meets(b, b_sides, a);
}

/// They share the edge 0-1: only if they are folded onto each other do they share more.
bool folded_over_edge(const Points& a, const Vec3f& other) {
    if (side(a, other) != 0) return false;
    const int axis = projection_axis(a[0], a[1], a[2]);
    return orient2d(a[0], a[1], a[2], axis) * orient2d(a[0], a[1], other, axis) > 0;
}

/// Turns a triangle until `vertex` is its first.
Triangle starting_with(const Triangle& t, std::uint32_t vertex) {
    if (t[1] == vertex) return {t[1], t[2], t[0]};
    return t[2] == vertex ? Triangle{t[2], t[0], t[1]} : t;
}

std::uint32_t vertex_not_in(const Triangle& t, const Triangle& other) {
    for (const std::uint32_t v : t)
        if (std::find(other.begin(), other.end(), v) == other.end()) return v;
    return t[0];
}

}  // namespace

bool triangles_intersect(const std::vector<Vec3f>& positions, const Triangle& a, const Triangle& b) {
    std::uint32_t shared[3];
    int count = 0;
    for (const std::uint32_t v : a)
        if (std::find(b.begin(), b.end(), v) != b.end()) shared[count++] = v;
    if (count == 0) return separate_triangles_meet(points_of(positions, a), points_of(positions, b));
    if (count == 3) return true;
    if (count == 2) {
        const Triangle edge_first{shared[0], shared[1], vertex_not_in(a, b)};
        return folded_over_edge(points_of(positions, edge_first), positions[vertex_not_in(b, a)]);
    }
    // What they share beyond one vertex reaches from there to the opposite edge of one of them.
    const Points p = points_of(positions, starting_with(a, shared[0]));
    const Points q = points_of(positions, starting_with(b, shared[0]));
    return segment_meets(p[1], p[2], q) || segment_meets(q[1], q[2], p);
}

}  // namespace sinew
