/// @file limit.h
/// The limit surface of a control mesh, at its vertices: where each goes when the mesh is subdivided without
/// end.
///
/// It is the limit of sinew::subdivide (src/sinew/subdivide), exactly, rounding apart:
///  - smooth inner vertices of any valence, among faces of any number of corners: Catmull-Clark;
///  - creases, semi-sharp ones included, darts, corners and boundaries: DeRose's rules (sharpness.h);
///  - poles: the polar rule (fans.h), (2 pole + mean of ring) / 3; their ring: the rule's own points in place
///    of the pole; fixed poles (tips of cones, middles of flat discs) stay;
///  - vertices on circles, and on cones and discs that end in a circle, stay; their neighbours see the
///    circle's control points (rounds.h);
///  - vertices on the rims of planes: the limit, put back into the plane (flats.h).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sinew/mesh/surface_rules.h"

namespace sinew {

/// Limit positions as sparse sums, for many positions of one topology: the limit of vertex v is that of
/// p_v + sum of weight (p_vertex - p_v) over its terms, and what the rules add. Circles and planes stay as
/// they were.
struct LimitStencils {
    struct Term {
        std::uint32_t vertex = 0;
        float weight = 0;
    };
    std::vector<std::uint32_t> first{0};  ///< rows of `terms`: vertices + 1 entries
    std::vector<Term> terms;

    SurfaceRules rules;
    /// What the pole rule's offsets j - 1, j, j + 1 add at ring vertex j: one entry for each of
    /// rules.fans.ring.
    std::vector<std::array<double, 3>> fan_weights;
    std::vector<Circle> circles;  ///< of the mesh, without their edges
    std::vector<Plane> planes;    ///< of the mesh, without their faces

    std::size_t vertex_count() const { return first.size() - 1; }
};

/// Linear in the size of the mesh. Fails for what resolve_rules refuses.
/// @param wanted  empty, or whose limits are asked for: 0 or 1 a vertex. The others have no terms, as if they
///                were their own limits.
Result<LimitStencils> build_limit_stencils(const QuadMesh& mesh, std::span<const char> wanted = {});

/// @param control  positions of the control mesh
/// @param limit    as many; must not overlap `control`
/// The same result on any number of threads.
void limit_positions(const LimitStencils& stencils, std::span<const Vec3> control, std::span<Vec3> limit);
void limit_positions(const LimitStencils& stencils, std::span<const Vec3f> control, std::span<Vec3f> limit);

/// The limit of each vertex of a mesh.
Result<std::vector<Vec3f>> limit_positions(const QuadMesh& mesh);

/// Moves control points until their limits are at `target`: `steps` times control += target - limit. What is
/// left of a ring's lack of radius shrinks to a third a step (ring of 4) or faster, of the roughest bumps of
/// a grid to 8/9.
void fit_to_limit(const LimitStencils& stencils, std::span<const Vec3> target, std::span<Vec3> control,
                  int steps = 16);

/// Share of its radius that a ring of n evenly spread control points keeps in the limit: (4 + 2 cos(2 pi /
/// n)) / 6.
double ring_limit_radius(int n);

/// A cubic B-spline through n points of a circle runs inside it between them, by 2.8 % at n = 4. This is what
/// to multiply the target radius of a ring with, so that its limit lies as far outside the radius as inside.
double ring_fit_radius(int n);

}  // namespace sinew
