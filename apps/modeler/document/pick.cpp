#include "document/pick.h"

#include <algorithm>

#include "document/images.h"

namespace sinew::modeler {
namespace {

const double smallest_target = 7;  ///< radius in pixels
const double bone_target = 5;

/// Distance to a node's glyph, or to the spot of smallest_target round its centre.
std::optional<double> meet_node(const NodeGlyph& glyph, const Screen& screen, const Ray& ray,
                                const Vec2& pixel) {
    if (auto distance = meet(ray, glyph)) return distance;
    const std::optional<Vec2> centre = screen.project(glyph.centre);
    if (!centre || (*centre - pixel).norm() > smallest_target) return std::nullopt;
    return (glyph.centre - ray.origin).dot(ray.direction);
}

void add_hits(const Glyphing& glyphs, const Screen& screen, const Vec2& pixel, std::int32_t image,
              std::vector<Hit>& hits) {
    const Ray ray = screen.ray(pixel);
    for (std::int32_t i = 0; i < std::ssize(glyphs.nodes); ++i)
        if (auto distance = meet_node(glyphs.nodes[i], screen, ray, pixel))
            hits.push_back({Hit::Kind::node, i, image, *distance, 0});
    for (std::int32_t i = 0; i < std::ssize(glyphs.bones); ++i) {
        const Stick& stick = glyphs.bones[i];
        const StickHit hit = nearest(ray, stick);
        if (hit.distance <= 0) continue;
        const double thickness = (1 - hit.along) * stick.from_radius + hit.along * stick.to_radius;
        if (hit.apart > thickness && hit.apart > bone_target * screen.pixel_length(ray.at(hit.distance)))
            continue;
        hits.push_back({Hit::Kind::bone, i, image, hit.distance, hit.along});
    }
}

}  // namespace

std::vector<Hit> hits_at(const Document& document, const Glyphing& glyphs, const Screen& screen,
                         const Vec2& pixel) {
    std::vector<Hit> hits;
    const std::vector<Mat3> images = images_of(document.symmetry);
    for (std::int32_t image = 0; image < std::ssize(images); ++image)
        add_hits(glyphs, image == 0 ? screen : screen.in_image(images[image]), pixel, image, hits);
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.distance < b.distance;
    });
    // A node on the mirror's plane is its own twin: hit once, as drawn.
    std::vector<Hit> distinct;
    for (const Hit& hit : hits) {
        const bool own_twin =
            hit.kind == Hit::Kind::node && hit.image > 0 &&
            is_own_twin(document.symmetry, glyphs.nodes[hit.index].centre, document.nodes[hit.index].radius);
        if (!own_twin) distinct.push_back(hit);
    }
    return distinct;
}

Hit hit_at(const Document& document, const Glyphing& glyphs, const Screen& screen, const Vec2& pixel) {
    const std::vector<Hit> hits = hits_at(document, glyphs, screen, pixel);
    return hits.empty() ? Hit{} : hits.front();
}

Hit behind(const std::vector<Hit>& hits, const Hit& last) {
    if (hits.empty()) return {};
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (hits[i].same_thing(last)) return hits[(i + 1) % hits.size()];
    return hits.front();
}

Selection nodes_in_box(const Document& document, const Screen& screen, const Vec2& corner,
                       const Vec2& opposite) {
    const Vec2 low = corner.cwiseMin(opposite), high = corner.cwiseMax(opposite);
    std::vector<std::int32_t> inside;
    for (const Mat3& image : images_of(document.symmetry))
        for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
            const std::optional<Vec2> pixel = screen.project(image * document.nodes[i].position);
            if (pixel && (pixel->array() >= low.array()).all() && (pixel->array() <= high.array()).all())
                inside.push_back(i);
        }
    return selection_of(inside);
}

}  // namespace sinew::modeler
