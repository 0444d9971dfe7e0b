/// @file pick.h
/// What lies under the pointer: nodes by their whole glyph, bones by their stick, in the document and in its
/// images.
#pragma once

#include <vector>

#include "document/glyph.h"
#include "document/selection.h"

namespace sinew::modeler {

struct Hit {
    enum class Kind : std::uint8_t { nothing, node, bone };
    Kind kind = Kind::nothing;
    std::int32_t index = -1;  ///< of the node, or of the bone in bones_of
    std::int32_t image = 0;   ///< in which image it was hit, 0: as drawn (see images.h)
    double distance = 0;      ///< along the ray
    double along = 0;         ///< bones: where, in [0, 1]

    explicit operator bool() const { return kind != Kind::nothing; }
    bool same_thing(const Hit& other) const {
        return kind == other.kind && index == other.index && image == other.image;
    }
};

/// Everything under a pixel, nearest first; nodes come before bones, since a node is the smaller target. What
/// is smaller than a fingertip on the screen is picked as if it were that large.
std::vector<Hit> hits_at(const Document& document, const Glyphing& glyphs, const Screen& screen,
                         const Vec2& pixel);

/// The first, or nothing.
Hit hit_at(const Document& document, const Glyphing& glyphs, const Screen& screen, const Vec2& pixel);

/// The one behind `last` in the list, round and round; the first where `last` is not in it. So that hidden
/// nodes can be reached by clicking again.
Hit behind(const std::vector<Hit>& hits, const Hit& last);

/// Nodes whose centre is inside a rectangle of the screen, images included.
Selection nodes_in_box(const Document& document, const Screen& screen, const Vec2& corner,
                       const Vec2& opposite);

}  // namespace sinew::modeler
