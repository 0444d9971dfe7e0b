/// @file box_faces.h
/// Boxes and their faces.
#pragma once

#include "sinew/extend/builder.h"

namespace sinew {

/// Half the extents of a cube.
Vec3 half_size(const PlainBuilder& builder, std::int32_t node);

/// Whether a cube is the body of a joint, with six faces; others are two rings of a path.
bool is_box_joint(const PlainBuilder& builder, std::int32_t node);

/// A face of a box: its middle, its frame (z outward) and half extents.
struct Face {
    Vec3 middle;
    Frame frame;
    double half_x, half_y;
};

/// Faces by number: those along x, -x, y, -y, z and -z of the box. The path through a cube that is no joint
/// runs along z.
constexpr int face_count = 6;
constexpr int face_ahead = 4, face_behind = 5;
Face face_of(const Form& box, const Vec3& centre, int index);

/// The face through which a way from the middle leaves a box: its index.
int face_towards(const Form& box, const Vec3& offset);

}  // namespace sinew
