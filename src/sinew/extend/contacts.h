/// @file contacts.h
/// Cubes that stand face to face: they become one solid, without faces between them.
#pragma once

#include "sinew/extend/box_faces.h"

namespace sinew {

/// How one cube meets another.
struct Contact {
    enum class Kind : std::uint8_t {
        none,     ///< it does not, or not face to face: a tube leads from one to the other
        same,     ///< both faces have the same outline: the sides go on
        inside,   ///< its face lies in the other's: a step
        outside,  ///< the other's face lies in its own
    };
    Kind kind = Kind::none;
    bool shares = false;         ///< same: of the two cubes it is the one that has no ring there of its own
    Vec3 middle = Vec3::Zero();  ///< of the face that stays
    bool shares_ring() const { return kind == Kind::same && shares; }
};

/// From one cube to a neighbour. They meet if their faces touch, or if one that a path runs through begins
/// within the other and goes on beyond it; neither if both are joints.
Contact find_contact(const PlainBuilder& builder, std::int32_t node, std::int32_t neighbour);

}  // namespace sinew
