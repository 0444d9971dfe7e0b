/// @file sections.h
/// Leaf caps, scaled and rectangular sections, sharp joints: nodes that stay one plain node.
#pragma once

#include "sinew/extend/builder.h"

namespace sinew {

/// Gives the node its cap and, where it is not a plain ball, a form.
void add_section(PlainBuilder& builder, std::int32_t node);

/// The outline of a node's section: a ring form in its local frame.
Form section_form(const PlainBuilder& builder, std::int32_t node);

}  // namespace sinew
