#include "sinew/sqm/refine.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include "sinew/sqm/count_problem.h"

namespace sinew::sqm {
namespace {

constexpr std::int32_t unknown = 0;
constexpr double longest_on_ball = 0.6;  // radians of an arc in one piece on a ball
constexpr int most_tries = 4;
constexpr std::int32_t hopeless =
    1024;  // vertices round a path: far above what any joint was ever seen to need

/// Parts of the network that are joined by paths, and the paths on or between its cycles (the 2-core).
struct Regions {
    std::vector<std::int32_t> component;  // joint -> component
    std::int32_t components = 0;
    std::vector<std::uint8_t> core;  // path -> both its ends are joints, and it is not in a tree hanging off
};

std::int32_t joint_beyond(const Network& n, std::int32_t path, std::int32_t joint) {
    const auto& end = n.path_end[path];
    return end[0].joint == joint ? end[1].joint : end[0].joint;
}
bool between_joints(const Network& n, std::int32_t path) {
    return n.path_end[path][0].at_joint() && n.path_end[path][1].at_joint();
}
template <class Visit>
void for_slots(const Network& n, std::int32_t joint, Visit visit) {
    for (std::int32_t s = 0; s < n.degree(joint); ++s) visit(s, n.slot_path[n.slot_first[joint] + s] / 2);
}

Regions find_regions(const Network& n) {
    Regions r;
    r.component.assign(n.joint_count(), -1);
    std::vector<std::int32_t> stack;
    for (std::int32_t seed = 0; seed < n.joint_count(); ++seed) {
        if (r.component[seed] >= 0) continue;
        r.component[seed] = r.components;
        stack.assign(1, seed);
        while (!stack.empty()) {
            const std::int32_t joint = stack.back();
            stack.pop_back();
            for_slots(n, joint, [&](std::int32_t, std::int32_t path) {
                const std::int32_t next = joint_beyond(n, path, joint);
                if (next < 0 || r.component[next] >= 0) return;
                r.component[next] = r.components;
                stack.push_back(next);
            });
        }
        ++r.components;
    }

    // Peel joints that hang on by one path; what cannot be peeled is the core.
    std::vector<std::int32_t> hold(n.joint_count(), 0);
    r.core.assign(n.path_count(), 0);
    for (std::int32_t p = 0; p < n.path_count(); ++p)
        if (between_joints(n, p)) {
            r.core[p] = 1;
            for (const PathEnd& end : n.path_end[p]) ++hold[end.joint];
        }
    for (std::int32_t j = 0; j < n.joint_count(); ++j)
        if (hold[j] == 1) stack.push_back(j);
    while (!stack.empty()) {
        const std::int32_t joint = stack.back();
        stack.pop_back();
        for_slots(n, joint, [&](std::int32_t, std::int32_t path) {
            if (!r.core[path]) return;
            r.core[path] = 0;
            for (const PathEnd& end : n.path_end[path])
                if (--hold[end.joint] == 1) stack.push_back(end.joint);
        });
    }
    return r;
}

/// Arcs with both ends in common must not be one edge each.
bool needs_middle(const Polyhedra& p, std::int32_t joint, std::int32_t arc) {
    const CellArc& a = p.arcs[arc];
    for (std::int32_t b = p.arc_first[joint]; b < p.arc_first[joint + 1]; ++b) {
        const CellArc& c = p.arcs[b];
        const bool same = (a.from == c.from && a.to == c.to) || (a.from == c.to && a.to == c.from);
        if (b != arc && same) return true;
    }
    return false;
}

/// Pieces that an arc has at least.
std::int32_t least_pieces(const Plain& skeleton, const Network& network, const Polyhedra& p,
                          std::int32_t joint, std::int32_t arc) {
    const Form* form = skeleton.form(network.joint_node[joint]);
    const bool on_ball = form && (form->kind == Form::Kind::ball || form->sides > 4);
    const double length = on_ball ? arc_length(p, p.arcs[arc]) : 0;
    if (length > 2.3 * longest_on_ball) return 4;
    return length > longest_on_ball || needs_middle(p, joint, arc) ? 2 : 1;
}

/// The count problem of one joint in terms of orbits under the symmetries that keep the joint in place.
class JointProblem {
  public:
    JointProblem(const Plain& skeleton, const Network& network, const Polyhedra& p, const Images& images)
        : skeleton_(skeleton), network_(network), p_(p), images_(images) {}

    /// Sets up the orbits of a joint; everything later refers to it.
    void take(std::int32_t joint) {
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

    std::int32_t first_cell() const { return p_.cell_first[joint_]; }
    /// The count of a cell is a multiple of this.
    std::int32_t step(std::int32_t cell) const { return cell_share_[orbit(cell)]; }
    void ask(std::int32_t cell, std::int32_t count, bool exact, bool cheap) {
        CountCell& c = problem_.cells[orbit(cell)];
        const std::int32_t share = step(cell), target = (count + share - 1) / share;
        if (exact && count % share != 0) impossible_ = true;
        c = {std::max(target, exact ? 0 : c.target), exact || c.exact, cheap};
    }
    void ask_nothing_yet() {
        impossible_ = false;
        for (CountCell& c : problem_.cells) c = {0, false, false};
    }
    bool solve() { return !impossible_ && problem_.solve(); }

    /// Least count that the least pieces give a cell.
    std::int32_t least(std::int32_t cell) const {
        std::int32_t sum = 0;
        for (const CellSide& side : p_.cell(cell)) sum += pieces_at_least(side.arc);
        return sum;
    }
    std::int32_t pieces(std::int32_t arc) const {
        const std::int32_t o = arc_orbit_[arc - p_.arc_first[joint_]];
        return problem_.arcs[o].pieces * arc_factor_[o];
    }

  private:
    std::int32_t orbit(std::int32_t cell) const { return cell_orbit_[cell - first_cell()]; }
    std::int32_t pieces_at_least(std::int32_t arc) const {
        const std::int32_t o = arc_orbit_[arc - p_.arc_first[joint_]];
        return problem_.arcs[o].least * arc_factor_[o];
    }

    /// Numbers the orbits of the joint's cells or arcs; `share` says how many symmetries keep a member in
    /// place.
    void find_orbits(const std::vector<std::int32_t>& first, const std::vector<std::int32_t>& image,
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
    void add_arcs() {
        const std::int32_t begin = p_.arc_first[joint_], count = p_.arc_first[joint_ + 1] - begin;
        problem_.arcs.assign(arc_share_.size(), {});
        arc_factor_.assign(arc_share_.size(), 0);  // at least 1 once it is described
        for (std::int32_t i = 0; i < count; ++i)
            if (const std::int32_t o = arc_orbit_[i]; arc_factor_[o] == 0) describe(begin + i, o);
    }

    /// An arc in the mirror (its cells change places) may be split in any way. One across it is split evenly,
    /// and adds its pieces to two cells that are symmetric themselves, of which the problem counts one half.
    void describe(std::int32_t arc, std::int32_t o) {
        const CellArc& a = p_.arcs[arc];
        const std::int32_t left = orbit(a.left), right = orbit(a.right);
        const bool across = arc_share_[o] > 1 && left != right;
        CountArc& out = problem_.arcs[o];
        arc_factor_[o] = across ? arc_share_[o] : 1;
        out.a = left;
        out.b = left != right ? right : (arc_share_[o] > 1 ? -1 : left);
        out.length = arc_length(p_, a) / arc_factor_[o];
        out.least = arc_factor_[o] == 1 ? least_pieces(skeleton_, network_, p_, joint_, arc) : 1;
    }

    const Plain& skeleton_;
    const Network& network_;
    const Polyhedra& p_;
    const Images& images_;
    std::int32_t joint_ = 0, turns_ = 1;
    bool fixed_ = false, impossible_ = false;
    CountProblem problem_;
    std::vector<std::int32_t> cell_orbit_, arc_orbit_, cell_share_, arc_share_, arc_factor_;
};

/// Carries counts through the network.
class Refiner {
  public:
    Refiner(const Plain& skeleton, const Network& n, const Polyhedra& p, const Images& images,
            const RefineOptions& options)
        : skeleton_(skeleton), n_(n), p_(p), images_(images), options_(options), regions_(find_regions(n)) {
        out_.pieces.resize(p.arcs.size());
        out_.path_sides.assign(n.path_count(), unknown);
        if (options.sides > 0) std::fill(regions_.core.begin(), regions_.core.end(), 1);
    }

    Result<Refinement> run(const Progress& progress) {
        find_least();
        mark_core_joints();
        if (!solve_core(progress)) {
            if (progress.cancelled()) return Progress::stopped();
            return no_solution();
        }
        if (!solve_trees()) return no_solution();
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (out_.path_sides[p] == unknown) out_.path_sides[p] = round_up(lone_path_sides(), step_[p]);
        return std::move(out_);
    }

  private:
    static tl::unexpected<Error> no_solution() {
        return fail(ErrorKind::program, "no number of vertices fits all tubes of a joint",
                    "please report this skeleton");
    }
    std::int32_t lone_path_sides() const { return options_.sides > 0 ? std::max(4, options_.sides) : 4; }
    std::int32_t cell(const PathEnd& end) const { return p_.cell_first[end.joint] + end.slot; }

    /// Least count of every path: what the cells at its ends have at least, a multiple of what their symmetry
    /// asks for.
    void find_least() {
        least_.assign(n_.path_count(), options_.sides > 0 ? std::max(4, options_.sides) : 4);
        corners_.resize(n_.path_count());
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            corners_[p] = !skeleton_.forms.empty() && has_corners(p);
        step_.assign(n_.path_count(), 1);
        for (std::int32_t p = 0; p < n_.path_count(); ++p) {
            if (corners_[p]) step_[p] = 4;
            if (!skeleton_.forms.empty()) least_[p] = std::max(least_[p], sides_of_forms(p));
        }
        if (!images_.any()) return least_without_symmetry();
        JointProblem joint(skeleton_, n_, p_, images_);
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            joint.take(j);
            for_slots(n_, j, [&](std::int32_t slot, std::int32_t path) {
                const std::int32_t c = joint.first_cell() + slot, step = joint.step(c);
                least_[path] = std::max(least_[path], joint.least(c));
                step_[path] = std::lcm(step_[path], step);
                if (step > 1 && !is_box(j) && has_sides_across_mirror(path))
                    step_[path] = std::lcm(step_[path], 8);
            });
        }
        for (std::int32_t p = 0; p < n_.path_count(); ++p) least_[p] = round_up(least_[p], step_[p]);
    }
    void least_without_symmetry() {
        least_pieces_.resize(p_.arcs.size());
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            for (std::int32_t a = p_.arc_first[j]; a < p_.arc_first[j + 1]; ++a)
                least_pieces_[a] = least_pieces(skeleton_, n_, p_, j, a);
            for_slots(n_, j, [&](std::int32_t slot, std::int32_t path) {
                least_[path] = std::max(least_[path], sum_of_cell(p_.cell_first[j] + slot, least_pieces_));
            });
        }
        for (std::int32_t p = 0; p < n_.path_count(); ++p) least_[p] = round_up(least_[p], step_[p]);
    }

    /// Most joints can do with the least pieces of all arcs: then there is nothing to solve.
    bool settle_for_least(std::int32_t j, std::int32_t core_count) {
        if (images_.any()) return false;
        bool enough = true;
        for_slots(n_, j, [&](std::int32_t slot, std::int32_t path) {
            const std::int32_t sum = sum_of_cell(p_.cell_first[j] + slot, least_pieces_);
            const std::int32_t known = regions_.core[path] ? core_count : out_.path_sides[path];
            enough = enough && (known != unknown ? sum == known
                                : corners_[path] ? sum == least_[path]
                                                 : sum >= least_[path]);
        });
        for (std::int32_t a = p_.arc_first[j]; enough && a < p_.arc_first[j + 1]; ++a)
            out_.pieces[a] = least_pieces_[a];
        return enough;
    }
    static std::int32_t round_up(std::int32_t count, std::int32_t step) {
        return (count + step - 1) / step * step;
    }

    /// What the rings of the path ask for.
    std::int32_t sides_of_forms(std::int32_t path) const {
        std::int32_t sides = 4;
        for (const std::int32_t node : n_.nodes(path))
            if (const Form* form = skeleton_.form(node)) sides = std::max(sides, form->sides);
        return sides;
    }

    /// A box has as many pieces on each edge, so that its corners part all its faces' rings evenly.
    bool settle_box(std::int32_t j, std::int32_t core_count) {
        const Form* form = skeleton_.form(n_.joint_node[j]);
        if (!form || form->kind != Form::Kind::box) return false;
        std::int32_t known = unknown, least = 4, step = 4;
        bool agree = true;
        for_slots(n_, j, [&](std::int32_t, std::int32_t path) {
            least = std::max(least, least_[path]);
            step = std::lcm(step, step_[path]);
            const std::int32_t sides = regions_.core[path] ? core_count : out_.path_sides[path];
            if (sides == unknown) return;
            agree = agree && (known == unknown || known == sides);
            known = sides;
        });
        const std::int32_t count = known != unknown ? known : round_up(least, step);
        if (!agree || count < least || count % step != 0) return false;
        for (std::int32_t a = p_.arc_first[j]; a < p_.arc_first[j + 1]; ++a) set_pieces(a, count / 4);
        return true;
    }

    /// Whether rings of the path have four corners.
    bool has_corners(std::int32_t path) const {
        for (const std::int32_t node : n_.nodes(path)) {
            const Form* form = skeleton_.form(node);
            if (!form) continue;
            if (form->kind == Form::Kind::box) return true;
            if (form->kind == Form::Kind::ring && form->section == Section::rectangular) return true;
        }
        return false;
    }

    bool is_box(std::int32_t joint) const {
        const Form* form = skeleton_.form(n_.joint_node[joint]);
        return form && form->kind == Form::Kind::box;
    }
    /// Where a path lies in the mirror, the rings of its joints have a vertex in it on either side, so an
    /// outline whose sides cross the mirror needs one in the middle of each side.
    bool has_sides_across_mirror(std::int32_t path) const {
        if (!corners_[path] || !images_.reverses) return false;
        const Mat3& mirror = images_.generator;
        for (const std::int32_t node : n_.nodes(path)) {
            const Form* form = skeleton_.form(node);
            const bool outline =
                form && (form->kind == Form::Kind::box ||
                         (form->kind == Form::Kind::ring && form->section == Section::rectangular));
            if (outline &&
                ((mirror * form->x + form->x).norm() < 1e-6 || (mirror * form->y + form->y).norm() < 1e-6))
                return true;
        }
        return false;
    }

    void mark_core_joints() {
        core_joint_.assign(n_.joint_count(), 0);
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (regions_.core[p])
                for (const PathEnd& end : n_.path_end[p])
                    if (end.at_joint()) core_joint_[end.joint] = 1;
    }

    /// Asks a joint for the counts of its paths: those that are known exactly, the core's if there is one,
    /// the rest freely. Paths with corners ask for `more` than their least, exactly, until no such number
    /// will do.
    void ask(JointProblem& joint, std::int32_t j, std::int32_t core_count, int more) const {
        joint.ask_nothing_yet();
        for_slots(n_, j, [&](std::int32_t slot, std::int32_t path) {
            const std::int32_t c = joint.first_cell() + slot;
            const std::int32_t known = regions_.core[path] ? core_count : out_.path_sides[path];
            const bool cornered = corners_[path] && more < most_tries;
            const std::int32_t wanted = least_[path] + (cornered ? more * step_[path] : 0);
            joint.ask(c, known != unknown ? known : wanted, known != unknown || cornered,
                      !between_joints(n_, path));
        });
        for (std::int32_t c = joint.first_cell() + n_.degree(j); c < p_.cell_first[j + 1]; ++c)
            joint.ask(c, 3, false, true);
    }
    bool solve_joint(JointProblem& joint, std::int32_t j, std::int32_t core_count) const {
        for (int more = 0; more <= most_tries; ++more) {
            ask(joint, j, core_count, more);
            if (joint.solve()) return true;
            if (skeleton_.forms.empty()) return false;  // nothing was asked for that could be given up
        }
        return false;
    }

    /// The least count from `count` on with which every core joint of every component can be solved.
    bool solve_core(const Progress& progress) {
        std::vector<std::int32_t> count(regions_.components, 4);
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (const std::int32_t c = component_of(p); regions_.core[p] && c >= 0)
                count[c] = std::max(count[c], least_[p]);
        std::vector<std::int32_t> step(regions_.components, options_.sides > 0 ? 1 : 2);
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (const std::int32_t c = component_of(p); regions_.core[p] && c >= 0)
                step[c] = std::lcm(step[c], step_[p]);
        for (std::int32_t c = 0; c < regions_.components; ++c) count[c] = round_up(count[c], step[c]);

        std::vector<std::int32_t> joints;
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            if (core_joint_[j] && representative(j)) joints.push_back(j);
        // Joints of one component must agree: when one needs more, all the others are solved again with that.
        std::vector<std::int32_t> met(joints.size(), 0), pending(joints.size());
        std::iota(pending.begin(), pending.end(), 0);
        while (!pending.empty()) {
            if (progress.cancelled()) return false;
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pending.size(), 64), [&](const auto& range) {
                JointProblem joint(skeleton_, n_, p_, images_);
                for (std::size_t i = range.begin(); i < range.end(); ++i) {
                    const std::int32_t j = joints[pending[i]], c = regions_.component[j];
                    met[pending[i]] = least_met(joint, j, count[c], step[c]);
                }
            });
            for (std::size_t i = 0; i < joints.size(); ++i) {
                if (met[i] >= hopeless) return false;
                std::int32_t& c = count[regions_.component[joints[i]]];
                c = std::max(c, met[i]);
            }
            pending.clear();
            for (std::size_t i = 0; i < joints.size(); ++i)
                if (met[i] < count[regions_.component[joints[i]]])
                    pending.push_back(static_cast<std::int32_t>(i));
        }
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (const std::int32_t c = component_of(p); regions_.core[p] && c >= 0)
                out_.path_sides[p] = count[c];
        return true;
    }
    std::int32_t component_of(std::int32_t path) const {
        const auto& end = n_.path_end[path];
        const std::int32_t joint = std::max(end[0].joint, end[1].joint);
        return joint < 0 ? -1 : regions_.component[joint];
    }
    /// Solves a core joint with the least count that it can meet, and writes its pieces down. Joints share no
    /// arcs.
    std::int32_t least_met(JointProblem& joint, std::int32_t j, std::int32_t count, std::int32_t step) {
        if (settle_box(j, count) || settle_for_least(j, count)) return count;
        joint.take(j);
        for (; count < hopeless; count += step) {
            if (!solve_joint(joint, j, count)) continue;
            write(joint, j);
            break;
        }
        return count;
    }

    /// The joints of trees, from their roots outward; the core's joints are solved already.
    bool solve_trees() {
        std::vector<std::uint8_t> done(core_joint_);
        std::vector<std::int32_t> queue;
        JointProblem joint(skeleton_, n_, p_, images_);
        auto settle = [&](std::int32_t j, bool solved) {
            for (std::int32_t k = j;;) {  // the joint and its images
                done[k] = 1;
                for_slots(n_, k, [&](std::int32_t slot, std::int32_t path) {
                    out_.path_sides[path] = sum_of_cell(p_.cell_first[k] + slot, out_.pieces);
                    const std::int32_t next = joint_beyond(n_, path, k);
                    if (next >= 0 && !done[next]) queue.push_back(next);
                });
                if (!images_.any() || !solved) break;
                k = images_.joint[k];
                if (k == j) break;
            }
        };
        auto solve = [&](std::int32_t j) {
            if (!settle_box(j, unknown) && !settle_for_least(j, unknown)) {
                joint.take(j);
                if (!solve_joint(joint, j, unknown)) return false;
                write(joint, j);
            }
            settle(j, true);
            return true;
        };
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            if (core_joint_[j]) settle(j, false);
        std::size_t head = 0;
        auto drain = [&] {
            for (; head < queue.size(); ++head)
                if (!done[queue[head]] && !solve(queue[head])) return false;
            return true;
        };
        if (!drain()) return false;
        for (const std::int32_t root : tree_roots(done))
            if ((!done[root] && !solve(root)) || !drain()) return false;
        return true;
    }

    /// A root for each component of trees: a joint that the symmetry keeps in place if there is one.
    std::vector<std::int32_t> tree_roots(const std::vector<std::uint8_t>& done) const {
        std::vector<std::int32_t> root(regions_.components, -1);
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            if (done[j]) continue;
            std::int32_t& r = root[regions_.component[j]];
            if (r < 0 || (images_.any() && images_.joint[r] != r && images_.joint[j] == j)) r = j;
        }
        root.erase(std::remove(root.begin(), root.end(), -1), root.end());
        return root;
    }

    std::int32_t sum_of_cell(std::int32_t c, const std::vector<std::int32_t>& pieces) const {
        std::int32_t sum = 0;
        for (const CellSide& side : p_.cell(c)) sum += pieces[side.arc];
        return sum;
    }
    bool representative(std::int32_t j) const {
        if (!images_.any()) return true;
        for (std::int32_t k = images_.joint[j]; k != j; k = images_.joint[k])
            if (k < j) return false;
        return true;
    }
    void write(const JointProblem& joint, std::int32_t j) {
        for (std::int32_t a = p_.arc_first[j]; a < p_.arc_first[j + 1]; ++a) set_pieces(a, joint.pieces(a));
    }
    void set_pieces(std::int32_t arc, std::int32_t pieces) {
        std::int32_t image = arc;
        do {
            out_.pieces[image] = pieces;
            if (images_.any()) image = images_.arc[image];
        } while (image != arc);
    }

    const Plain& skeleton_;
    const Network& n_;
    const Polyhedra& p_;
    const Images& images_;
    RefineOptions options_;
    Regions regions_;
    std::vector<std::int32_t> least_, step_, least_pieces_;
    std::vector<std::uint8_t> corners_;
    std::vector<std::uint8_t> core_joint_;
    Refinement out_;
};

}  // namespace

Result<Refinement> refine(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                          const Images& images, const RefineOptions& options, const Progress& progress) {
    return Refiner(skeleton, network, polyhedra, images, options).run(progress);
}

}  // namespace sinew::sqm
