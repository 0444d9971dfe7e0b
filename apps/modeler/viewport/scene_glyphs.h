/// @file scene_glyphs.h
/// What the viewport shows of a document: glyphs in the colours of their state, the mirror's plane and the
/// ground.
#pragma once

#include "document/glyph.h"
#include "document/pick.h"
#include "sinew/render/overlay.h"

namespace sinew::modeler {

/// Colours of glyphs. Also used by icons and labels, so that a type has one colour everywhere.
struct GlyphColours {
    Colour node{104, 158, 222};
    Colour root{226, 84, 76};
    Colour special{232, 165, 74};  ///< cone, hemisphere, cube, ball
    Colour negative{178, 104, 206};
    Colour bone{168, 176, 190};
    Colour selected{255, 224, 120};  ///< mixed in
    Colour hovered{255, 255, 255};
    std::uint8_t ghost_alpha = 95;  ///< of what stands for an image
};

Colour colour_of(const Node& node, const GlyphColours& colours = {});

/// @param hovered  brightened; may be nothing
/// @param alpha    of all of them; ghosts fade further
Glyphs scene_glyphs(const Document& document, const Glyphing& glyphs, const Selection& selection,
                    const Hit& hovered, std::uint8_t alpha = 255);

/// The green plane of a mirror, large enough for the model.
std::optional<PlaneMark> mirror_plane(const Document& document);

/// The ground with a grid whose cells fit the model.
PlaneMark ground_plane(float reach);

/// How far the model reaches from the origin, at least a little.
float reach_of(const Document& document);

}  // namespace sinew::modeler
