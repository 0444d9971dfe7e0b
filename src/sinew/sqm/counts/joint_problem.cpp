#include "sinew/sqm/counts/joint_problem.h"

#include <algorithm>
#include <cmath>

#include "sinew/sqm/surface/dents.h"

namespace sinew::sqm {
namespace {

constexpr std::int32_t across_groove =
    10;  // pieces of an arc between two dents: to the rim, over wall, floor, wall and rim, and on
constexpr double longest_on_ball = 0.6;  // radians of an arc in one piece on a ball

}  // namespace

std::int32_t least_pieces(const Plain& skeleton, const Network& network, const Polyhedra& p,
                          const JointSurfaces& surfaces, std::int32_t joint, std::int32_t arc) {
    const Form* form = skeleton.form(network.joint_node[joint]);
    const auto slot = [&](std::int32_t cell) { return cell - p.cell_first[joint]; };
    const std::int32_t left = slot(p.arcs[arc].left), right = slot(p.arcs[arc].right),
                       first = network.slot_first[joint];
    if (form && std::max(left, right) < network.degree(joint) &&
        dents_overlap(surfaces, first + left, first + right))
        return across_groove;
    const bool on_ball = form && (form->kind == Form::Kind::ball || form->sides > 4);
    const double length = on_ball || !form ? arc_length(p, p.arcs[arc]) : 0;
    const std::int32_t least = p.arc_doubled[arc] ? 2 : 1;  // two arcs must not be one edge
    if (!form) return std::max(least, static_cast<std::int32_t>(std::ceil(length / longest_at_blend)));
    if (length > 2.3 * longest_on_ball) return 4;
    return length > longest_on_ball ? 2 : least;
}

void JointProblem::take(std::int32_t joint) {
    joint_ = joint;
    turns_ = 1;  // smallest power of the generator that brings the joint back onto itself
    if (images_.any())
        for (std::int32_t j = images_.joint[joint]; j != joint; j = images_.joint[j]) ++turns_;
    fixed_ = images_.any() && turns_ < images_.order;
    problem_.clear();
    find_orbits(p_.cell_first, images_.cell, cell_orbit_, cell_share_);
    find_orbits(p_.arc_first, images_.arc, arc_orbit_, arc_share_);
    problem_.cells.resize(cell_share_.size());
    add_arcs();
}

std::int32_t JointProblem::least(std::int32_t cell) const {
    std::int32_t sum = 0;
    for (const CellSide& side : p_.cell(cell)) {
        const std::int32_t o = arc_orbit_[side.arc - p_.arc_first[joint_]];
        sum += problem_.arcs[o].least * arc_factor_[o];
    }
    return sum;
}

void JointProblem::ask_nothing_yet() {
    impossible_ = false;
    for (CountCell& c : problem_.cells) c = {0, false, false};
}

void JointProblem::ask(std::int32_t cell, std::int32_t count, bool exact, bool cheap) {
    CountCell& c = problem_.cells[orbit(cell)];
    const std::int32_t share = step(cell), target = (count + share - 1) / share;
    if (exact && count % share != 0) impossible_ = true;
    c = {std::max(target, exact ? 0 : c.target), exact || c.exact, cheap};
}

std::int32_t JointProblem::pieces(std::int32_t arc) const {
    const std::int32_t o = arc_orbit_[arc - p_.arc_first[joint_]];
    return problem_.arcs[o].pieces * arc_factor_[o];
}

/// Numbers the orbits of the joint's cells or arcs; `share` says how many symmetries keep a member in
/// place.
void JointProblem::find_orbits(const std::vector<std::int32_t>& first, const std::vector<std::int32_t>& image,
                               std::vector<std::int32_t>& orbit, std::vector<std::int32_t>& share) const {
    const std::int32_t begin = first[joint_], count = first[joint_ + 1] - begin;
    orbit.assign(count, -1);
    share.clear();
    for (std::int32_t i = 0; i < count; ++i) {
        if (orbit[i] >= 0) continue;
        const auto id = static_cast<std::int32_t>(share.size());
        std::int32_t size = 0, at = i + begin;
        do {
            orbit[at - begin] = id;
            ++size;
            for (std::int32_t t = 0; fixed_ && t < turns_; ++t) at = image[at];
        } while (at != i + begin);
        share.push_back(fixed_ ? images_.order / turns_ / size : 1);
    }
}

void JointProblem::add_arcs() {
    const std::int32_t begin = p_.arc_first[joint_], count = p_.arc_first[joint_ + 1] - begin;
    problem_.arcs.assign(arc_share_.size(), {});
    arc_factor_.assign(arc_share_.size(), 0);  // at least 1 once it is described
    for (std::int32_t i = 0; i < count; ++i)
        if (const std::int32_t o = arc_orbit_[i]; arc_factor_[o] == 0) describe(begin + i, o);
}

/// An arc in the mirror (its cells change places) may be split in any way. One across it is split evenly,
/// and adds its pieces to two cells that are symmetric themselves, of which the problem counts one half.
void JointProblem::describe(std::int32_t arc, std::int32_t o) {
    const CellArc& a = p_.arcs[arc];
    const std::int32_t left = orbit(a.left), right = orbit(a.right);
    const bool across = arc_share_[o] > 1 && left != right;
    CountArc& out = problem_.arcs[o];
    arc_factor_[o] = across ? arc_share_[o] : 1;
    out.a = left;
    out.b = left != right ? right : (arc_share_[o] > 1 ? -1 : left);
    out.length = arc_length(p_, a) / arc_factor_[o];
    const std::int32_t least = least_pieces(skeleton_, network_, p_, surfaces_, joint_, arc),
                       factor = arc_factor_[o];
    out.least = (least + factor - 1) / factor;
}

}  // namespace sinew::sqm
