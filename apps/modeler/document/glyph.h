/// @file glyph.h
/// How nodes and bones look while one edits: the renderer's unit shapes, placed. What is drawn is what is
/// picked.
#pragma once

#include <optional>
#include <vector>

#include "document/screen.h"
#include "sinew/render/glyphs.h"
#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// A node's shape. Columns of `axes` and `centre` place the unit shape of render/glyphs.h.
struct NodeGlyph {
    GlyphShape shape = GlyphShape::sphere;
    Mat3 axes = Mat3::Identity();
    Vec3 centre = Vec3::Zero();
};

/// A ball that holds a shape, and not much more.
struct GlyphBall {
    Vec3 centre;
    double radius;
};
GlyphBall ball_round(const NodeGlyph& glyph);

/// A bone, drawn as a thin round cone.
struct Stick {
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double from_radius = 0, to_radius = 0;
};

/// What there is to see of a document itself, without the images of its symmetry.
struct Glyphing {
    std::vector<NodeGlyph> nodes;  ///< one a node
    std::vector<Stick> bones;      ///< one a bone, in the order of bones_of
};

/// @param scale  share of their size that shapes are drawn at: below 1, so that bones can be seen between them
///               and the mesh does not hide them
Glyphing glyphs_of(const Document& document, double scale);

/// Where a ray enters a shape, as a distance along it; nothing where it misses.
std::optional<double> meet(const Ray& ray, const NodeGlyph& glyph);

/// Where a ray is nearest to a stick's axis.
struct StickHit {
    double distance;  ///< along the ray
    double apart;     ///< between ray and axis
    double along;     ///< along the bone, in [0, 1]
};
StickHit nearest(const Ray& ray, const Stick& stick);

}  // namespace sinew::modeler
