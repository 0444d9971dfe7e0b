#include "document/glyph.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "sinew/skeleton/frames.h"
#include "sinew/skeleton/graph.h"

namespace sinew::modeler {
namespace {

const double bone_share = 0.3;  ///< how thick a bone is drawn, as a share of the glyphs at its ends

GlyphShape shape_of(const Node& node, bool leaf) {
    if (node.type == NodeType::cube) return GlyphShape::box;
    if (node.type == NodeType::cone && leaf) return GlyphShape::cone;
    if (node.type == NodeType::hemisphere && leaf) return GlyphShape::half_sphere;
    const bool flat_sided = node.section == Section::rectangular && node.type == NodeType::sphere;
    return flat_sided ? GlyphShape::box : GlyphShape::sphere;
}

Vec3 half_extents(const Node& node, bool alone) {
    if (node.type == NodeType::cube)
        return node.size ? Vec3(*node.size / 2) : Vec3(Vec3::Constant(node.radius));
    const bool ellipsoid = node.type == NodeType::ball || alone;
    return node.radius * Vec3(node.scale[0], node.scale[1], ellipsoid ? node.scale[2] : 1);
}

/// The z of a root leads away from it; its tip points outward.
Mat3 frame_of(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
              std::int32_t i, GlyphShape shape) {
    Mat3 frame = local_frame(document, bones, neighbours, i);
    const bool pointed = shape == GlyphShape::cone || shape == GlyphShape::half_sphere;
    if (pointed && document.nodes[i].parent < 0) frame.rightCols<2>() *= -1;
    return frame;
}

/// The first of the distances offered that lies ahead of the ray's origin.
struct Nearest {
    std::optional<double> distance;
    void offer(double t) {
        if (t > 0 && (!distance || t < *distance)) distance = t;
    }
};

/// Roots of a t² + 2 b t + c; not-a-numbers where there is none.
std::array<double, 2> roots(double a, double b, double c) {
    const double root = std::sqrt(b * b - a * c);
    return {(-b - root) / a, (-b + root) / a};
}

void meet_sphere(const Vec3& o, const Vec3& d, bool lower_half, Nearest& nearest) {
    for (double t : roots(d.dot(d), o.dot(d), o.dot(o) - 1))
        if (!lower_half || (o + t * d).z() <= 0) nearest.offer(t);
}

void meet_disc(const Vec3& o, const Vec3& d, double height, Nearest& nearest) {
    const double t = (height - o.z()) / d.z();
    if ((o + t * d).head<2>().norm() <= 1) nearest.offer(t);
}

void meet_cone(const Vec3& o, const Vec3& d, Nearest& nearest) {
    // x² + y² = (z / 2)² between z = -2 and the tip at the origin
    const double w = o.z() / 2, dw = d.z() / 2;
    const auto ts = roots(d.head<2>().squaredNorm() - dw * dw, o.head<2>().dot(d.head<2>()) - w * dw,
                          o.head<2>().squaredNorm() - w * w);
    for (double t : ts) {
        const double z = (o + t * d).z();
        if (z >= -2 && z <= 0) nearest.offer(t);
    }
    meet_disc(o, d, -2, nearest);
}

void meet_box(const Vec3& o, const Vec3& d, Nearest& nearest) {
    const Vec3 a = (-Vec3::Ones() - o).cwiseQuotient(d), b = (Vec3::Ones() - o).cwiseQuotient(d);
    const double enter = a.cwiseMin(b).maxCoeff(), leave = a.cwiseMax(b).minCoeff();
    if (enter > leave) return;
    nearest.offer(enter);
    nearest.offer(leave);
}

}  // namespace

Glyphing glyphs_of(const Document& document, double scale) {
    const std::vector<Bone> bones = bones_of(document);
    const Adjacency neighbours = adjacency(static_cast<std::int32_t>(document.nodes.size()), bones);
    Glyphing glyphs;
    glyphs.nodes.reserve(document.nodes.size());
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        const Node& node = document.nodes[i];
        const std::int32_t degree = neighbours.degree(i);
        const GlyphShape shape = shape_of(node, degree == 1);
        const Mat3 frame = frame_of(document, bones, neighbours, i, shape);
        glyphs.nodes.push_back(
            {shape, frame * (scale * half_extents(node, degree == 0)).asDiagonal(), node.position});
    }
    glyphs.bones.reserve(bones.size());
    for (auto [a, b] : bones) {
        const Node &from = document.nodes[a], &to = document.nodes[b];
        const double share = scale * bone_share;
        glyphs.bones.push_back({from.position, to.position, from.radius * share, to.radius * share});
    }
    return glyphs;
}

GlyphBall ball_round(const NodeGlyph& glyph) {
    const Vec3 lengths = glyph.axes.colwise().norm();
    switch (glyph.shape) {
        case GlyphShape::box:
            return {glyph.centre, lengths.norm()};
        case GlyphShape::cone:
            return {glyph.centre - glyph.axes.col(2), lengths.norm()};
        default:
            return {glyph.centre, lengths.maxCoeff()};
    }
}

std::optional<double> meet(const Ray& ray, const NodeGlyph& glyph) {
    const Mat3 to_unit = glyph.axes.inverse();
    const Vec3 o = to_unit * (ray.origin - glyph.centre), d = to_unit * ray.direction;
    Nearest nearest;
    switch (glyph.shape) {
        case GlyphShape::sphere:
            meet_sphere(o, d, false, nearest);
            break;
        case GlyphShape::half_sphere:
            meet_sphere(o, d, true, nearest);
            meet_disc(o, d, 0, nearest);
            break;
        case GlyphShape::cone:
            meet_cone(o, d, nearest);
            break;
        case GlyphShape::box:
            meet_box(o, d, nearest);
            break;
    }
    return nearest.distance;
}

StickHit nearest(const Ray& ray, const Stick& stick) {
    const Vec3 axis = stick.to - stick.from, offset = ray.origin - stick.from;
    const double length2 = axis.squaredNorm(), slope = axis.dot(ray.direction);
    const double denominator = length2 - slope * slope;
    double along = 0;
    if (denominator > 1e-12 * length2)
        along = std::clamp((axis.dot(offset) - slope * ray.direction.dot(offset)) / denominator, 0.0, 1.0);
    const Vec3 point = stick.from + along * axis;
    const double distance = (point - ray.origin).dot(ray.direction);
    return {distance, (ray.at(distance) - point).norm(), along};
}

}  // namespace sinew::modeler
