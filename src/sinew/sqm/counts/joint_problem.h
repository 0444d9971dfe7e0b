/// @file joint_problem.h
/// How many pieces the arcs of one joint are split into, so that each of its cells gets the count that is
/// asked for.
///
/// In: the joint's cells and arcs, what is asked of its cells. Out: pieces of every arc. A symmetry that
/// keeps the joint in place makes one unknown of all arcs that are images of each other (an orbit), so that
/// the split is symmetric; a cell that some of the symmetries keep in place then gets a multiple of their
/// number. Solved as a CountProblem, in the order of bones, so that the same joint is split in the same way.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/sqm/cells/count_problem.h"
#include "sinew/sqm/cells/images.h"
#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

/// Radians of a piece of an arc where round cones meet: the chord of a right angle passes the centre at 0.7 radii, that of
/// 165 degrees at 0.13, and the joint caves in. Hardly more than the right angle, so that perpendicular bones need no more.
inline constexpr double longest_at_blend = 1.58;

/// Pieces that an arc has at least: 1, or more where it would bulge visibly on a ball, or would be the same
/// edge as another arc with its ends.
std::int32_t least_pieces(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                          const JointSurfaces& surfaces, std::int32_t joint, std::int32_t arc);

/// Take a joint, ask for counts, solve, read the pieces; then the next joint.
class JointProblem {
  public:
    JointProblem(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                 const JointSurfaces& surfaces, const Images& images)
        : skeleton_(skeleton), network_(network), p_(polyhedra), surfaces_(surfaces), images_(images) {}

    /// Sets up the orbits of a joint; everything later refers to it.
    void take(std::int32_t joint);

    std::int32_t first_cell() const { return p_.cell_first[joint_]; }
    /// The count of a cell is a multiple of this.
    std::int32_t step(std::int32_t cell) const { return cell_share_[orbit(cell)]; }
    /// Least count that the least pieces give a cell.
    std::int32_t least(std::int32_t cell) const;

    void ask_nothing_yet();
    /// @param exact  that count and no other; else at least that
    /// @param cheap  more than that costs nothing: the cell's path ends there
    void ask(std::int32_t cell, std::int32_t count, bool exact, bool cheap);
    /// @returns whether all that was asked can be had
    bool solve() { return !impossible_ && problem_.solve(); }

    std::int32_t pieces(std::int32_t arc) const;

  private:
    std::int32_t orbit(std::int32_t cell) const { return cell_orbit_[cell - first_cell()]; }
    void find_orbits(const std::vector<std::int32_t>& first, const std::vector<std::int32_t>& image,
                     std::vector<std::int32_t>& orbit, std::vector<std::int32_t>& share) const;
    void add_arcs();
    void describe(std::int32_t arc, std::int32_t orbit);

    const Plain& skeleton_;
    const Network& network_;
    const Polyhedra& p_;
    const JointSurfaces& surfaces_;
    const Images& images_;
    std::int32_t joint_ = 0, turns_ = 1;
    bool fixed_ = false, impossible_ = false;
    CountProblem problem_;
    std::vector<std::int32_t> cell_orbit_, arc_orbit_, cell_share_, arc_share_, arc_factor_;
};

}  // namespace sinew::sqm
