/// @file ring_form.h
/// Outlines that were asked for, given to rings. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Gives a ring the outline of a form, turned into its plane or with its plane. A plain circle changes
/// nothing: the ring stays on the round cones.
void take_form(const Form& form, Station& ring);

/// Gives a ring, at a share of the way along a bone, the outline between those of the bone's nodes; a
/// rectangle only between two of them.
void blend_forms(const PathWork& w, std::int32_t bone, double share, Station& ring);

}  // namespace sinew::sqm
