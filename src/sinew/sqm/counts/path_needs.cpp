#include "sinew/sqm/counts/path_needs.h"

#include <algorithm>
#include <numeric>

#include "sinew/sqm/counts/joint_problem.h"

namespace sinew::sqm {
namespace {

bool is_box(const Form* form) { return form && form->kind == Form::Kind::box; }
bool has_outline_with_corners(const Form* form) {
    return is_box(form) || (form && form->kind == Form::Kind::ring && form->section == Section::rectangular);
}

class NeedFinder {
  public:
    NeedFinder(const Plain& skeleton, const Network& n, const Polyhedra& p, const JointSurfaces& surfaces,
               const Images& images)
        : skeleton_(skeleton), n_(n), p_(p), surfaces_(surfaces), images_(images) {}

    PathNeeds run(std::int32_t sides) {
        out_.least.assign(n_.path_count(), sides);
        out_.step.assign(n_.path_count(), 1);
        out_.corners.assign(n_.path_count(), 0);
        if (!skeleton_.forms.empty())
            for (std::int32_t p = 0; p < n_.path_count(); ++p) ask_forms(p);
        if (images_.any()) {
            ask_symmetric_joints();
            ask_tubes_on_axis();
        } else {
            ask_joints();
        }
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            out_.least[p] = round_up(out_.least[p], out_.step[p]);
        return std::move(out_);
    }

  private:
    void ask_forms(std::int32_t path) {
        for (const std::int32_t node : n_.nodes(path)) {
            const Form* form = skeleton_.form(node);
            if (!form) continue;
            out_.least[path] = std::max(out_.least[path], form->sides);
            if (has_outline_with_corners(form)) out_.corners[path] = 1;
        }
        if (out_.corners[path]) out_.step[path] = 4;
    }

    void ask_joints() {
        out_.pieces.resize(p_.arcs.size());
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            for (std::int32_t a = p_.arc_first[j]; a < p_.arc_first[j + 1]; ++a)
                out_.pieces[a] = least_pieces(skeleton_, n_, p_, surfaces_, j, a);
            n_.for_slots(j, [&](std::int32_t slot, std::int32_t path) {
                const std::int32_t sum = sum_of_cell(p_, p_.cell_first[j] + slot, out_.pieces);
                out_.least[path] = std::max(out_.least[path], sum);
            });
        }
    }

    void ask_symmetric_joints() {
        JointProblem joint(skeleton_, n_, p_, surfaces_, images_);
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            joint.take(j);
            n_.for_slots(j, [&](std::int32_t slot, std::int32_t path) {
                const std::int32_t c = joint.first_cell() + slot, step = joint.step(c);
                out_.least[path] = std::max(out_.least[path], joint.least(c));
                out_.step[path] = std::lcm(out_.step[path], step);
                if (step > 1 && (!is_box_joint(j) ? has_sides_across_mirror(path) : leads_elsewhere(path, j)))
                    out_.step[path] = std::lcm(out_.step[path], 8);
            });
        }
    }

    /// Tubes along an axis that everything is turned about.
    void ask_tubes_on_axis() {
        for (std::int32_t p = 0; p < n_.path_count(); ++p) {
            const auto& end = n_.path_end[p];
            const bool alone = !n_.path_closed[p] && !end[0].at_joint() && !end[1].at_joint();
            if (alone && images_.path[p] == p && !images_.path_reversed[p] && !images_.reverses)
                out_.step[p] = std::lcm(out_.step[p], images_.order);
        }
    }
    bool is_box_joint(std::int32_t joint) const { return is_box(skeleton_.form(n_.joint_node[joint])); }
    /// From a box whose edges cross the mirror to a joint that is none: there vertices are in the mirror.
    bool leads_elsewhere(std::int32_t path, std::int32_t box) const {
        const auto& end = n_.path_end[path];
        const std::int32_t other = end[0].joint == box ? end[1].joint : end[0].joint;
        return images_.reverses && other >= 0 && !is_box_joint(other);
    }

    /// Where a path lies in the mirror, the rings of its joints have a vertex in it on either side, so an
    /// outline whose sides cross the mirror needs one in the middle of each side.
    bool has_sides_across_mirror(std::int32_t path) const {
        if (!out_.corners[path] || !images_.reverses) return false;
        const Mat3& mirror = images_.generator;
        for (const std::int32_t node : n_.nodes(path)) {
            const Form* form = skeleton_.form(node);
            if (has_outline_with_corners(form) &&
                ((mirror * form->x + form->x).norm() < 1e-6 || (mirror * form->y + form->y).norm() < 1e-6))
                return true;
        }
        return false;
    }

    const Plain& skeleton_;
    const Network& n_;
    const Polyhedra& p_;
    const JointSurfaces& surfaces_;
    const Images& images_;
    PathNeeds out_;
};

}  // namespace

PathNeeds find_path_needs(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                          const JointSurfaces& surfaces, const Images& images, std::int32_t sides) {
    return NeedFinder(skeleton, network, polyhedra, surfaces, images).run(sides);
}

}  // namespace sinew::sqm
