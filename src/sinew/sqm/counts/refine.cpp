#include "sinew/sqm/counts/refine.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "sinew/sqm/counts/joint_problem.h"
#include "sinew/sqm/counts/path_needs.h"
#include "sinew/sqm/counts/regions.h"

namespace sinew::sqm {
namespace {

constexpr std::int32_t unknown = 0;
/// How many counts a path with corners tries beyond its least one, before it may have any: its count is then
/// still a multiple of four, so that its corners are evenly spread, unless no such number does.
constexpr int most_tries = 4;
/// Vertices round a path: far above what any joint was ever seen to need.
constexpr std::int32_t hopeless = 1024;

/// Carries counts through the network.
class Refiner {
  public:
    Refiner(const Plain& skeleton, const Network& n, const Polyhedra& p, const JointSurfaces& surfaces,
            const Images& images, const RefineOptions& options)
        : skeleton_(skeleton),
          n_(n),
          p_(p),
          surfaces_(surfaces),
          images_(images),
          options_(options),
          regions_(find_regions(n)),
          needs_(find_path_needs(skeleton, n, p, surfaces, images, std::max(4, options.sides))) {
        out_.pieces.resize(p.arcs.size());
        out_.path_sides.assign(n.path_count(), unknown);
        if (options.sides > 0) std::fill(regions_.core.begin(), regions_.core.end(), 1);
    }

    Result<Refinement> run(const Progress& progress) {
        mark_core_joints();
        if (!solve_core(progress)) {
            if (progress.cancelled()) return Progress::stopped();
            return no_solution();
        }
        if (!solve_trees()) return no_solution();
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (out_.path_sides[p] == unknown) out_.path_sides[p] = needs_.least[p];
        return std::move(out_);
    }

  private:
    static tl::unexpected<Error> no_solution() {
        return fail(ErrorKind::program, "no number of vertices fits all tubes of a joint",
                    "please report this skeleton");
    }
    /// The count of a path so far.
    std::int32_t known(std::int32_t path, std::int32_t core_count) const {
        return regions_.core[path] ? core_count : out_.path_sides[path];
    }

    /// Most joints can do with the least pieces of all arcs: then there is nothing to solve.
    bool settle_for_least(std::int32_t j, std::int32_t core_count) {
        if (images_.any()) return false;
        bool enough = true;
        n_.for_slots(j, [&](std::int32_t slot, std::int32_t path) {
            const std::int32_t sum = sum_of_cell(p_, p_.cell_first[j] + slot, needs_.pieces);
            const std::int32_t count = known(path, core_count), least = needs_.least[path];
            enough = enough && (count != unknown       ? sum == count
                                : needs_.corners[path] ? sum == least
                                                       : sum >= least);
        });
        for (std::int32_t a = p_.arc_first[j]; enough && a < p_.arc_first[j + 1]; ++a)
            out_.pieces[a] = needs_.pieces[a];
        return enough;
    }

    /// A box has as many pieces on each edge, so that its corners part all its faces' rings evenly.
    bool settle_box(std::int32_t j, std::int32_t core_count) {
        const Form* form = skeleton_.form(n_.joint_node[j]);
        if (!form || form->kind != Form::Kind::box) return false;
        std::int32_t given = unknown, least = 4, step = 4;
        bool agree = true;
        n_.for_slots(j, [&](std::int32_t, std::int32_t path) {
            least = std::max(least, needs_.least[path]);
            step = std::lcm(step, needs_.step[path]);
            const std::int32_t sides = known(path, core_count);
            if (sides == unknown) return;
            agree = agree && (given == unknown || given == sides);
            given = sides;
        });
        const std::int32_t count = given != unknown ? given : round_up(least, step);
        if (!agree || count < least || count % step != 0) return false;
        for (std::int32_t a = p_.arc_first[j]; a < p_.arc_first[j + 1]; ++a) set_pieces(a, count / 4);
        return true;
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
        n_.for_slots(j, [&](std::int32_t slot, std::int32_t path) {
            const std::int32_t count = known(path, core_count);
            const bool cornered = needs_.corners[path] && more < most_tries;
            const std::int32_t wanted = needs_.least[path] + (cornered ? more * needs_.step[path] : 0);
            joint.ask(joint.first_cell() + slot, count != unknown ? count : wanted,
                      count != unknown || cornered, !n_.between_joints(path));
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

    /// Visits the paths of the core that have joints: visit(path, component).
    template <class Visit>
    void for_core_paths(Visit visit) const {
        for (std::int32_t p = 0; p < n_.path_count(); ++p)
            if (const std::int32_t c = regions_.component_of(n_, p); regions_.core[p] && c >= 0) visit(p, c);
    }

    /// The least count with which every core joint of a component can be solved, for every component. Joints
    /// of one component must agree: when one needs more, all the others are solved again with that.
    bool solve_core(const Progress& progress) {
        std::vector<std::int32_t> count(regions_.components, 4);
        // An odd count can never be had by all cells of a joint of an odd number of them: each piece counts
        // in two cells. Where there is no such joint it might, but the count must not hang on that.
        std::vector<std::int32_t> step(regions_.components, options_.sides > 0 ? 1 : 2);
        for_core_paths([&](std::int32_t path, std::int32_t c) {
            count[c] = std::max(count[c], needs_.least[path]);
            step[c] = std::lcm(step[c], needs_.step[path]);
        });
        for (std::int32_t c = 0; c < regions_.components; ++c) count[c] = round_up(count[c], step[c]);

        const std::vector<std::int32_t> joints = core_representatives();
        std::vector<std::int32_t> met(joints.size(), 0), pending(joints.size());
        std::iota(pending.begin(), pending.end(), 0);
        while (!pending.empty()) {
            if (progress.cancelled()) return false;
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pending.size(), 64), [&](const auto& range) {
                JointProblem joint(skeleton_, n_, p_, surfaces_, images_);
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
        for_core_paths([&](std::int32_t path, std::int32_t c) { out_.path_sides[path] = count[c]; });
        return true;
    }
    /// Joints of the core, one of those that are images of each other.
    std::vector<std::int32_t> core_representatives() const {
        std::vector<std::int32_t> joints;
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            if (core_joint_[j] && representative(j)) joints.push_back(j);
        return joints;
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

    /// The joints of trees, from the core or from their roots outward, breadth first; the core's joints are
    /// solved already.
    bool solve_trees() {
        done_ = core_joint_;
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            if (core_joint_[j]) pass_on_counts(j);
        JointProblem joint(skeleton_, n_, p_, surfaces_, images_);
        if (!solve_waiting(joint)) return false;
        for (const std::int32_t root : tree_roots()) {
            waiting_.push_back(root);
            if (!solve_waiting(joint)) return false;
        }
        return true;
    }
    /// Solves the joints that wait, and those that begin to wait on account of them.
    bool solve_waiting(JointProblem& joint) {
        for (; next_waiting_ < waiting_.size(); ++next_waiting_)
            if (const std::int32_t j = waiting_[next_waiting_]; !done_[j] && !solve_tree_joint(joint, j))
                return false;
        return true;
    }
    /// Solves one joint of a tree, and with it its images.
    bool solve_tree_joint(JointProblem& joint, std::int32_t j) {
        if (!settle_box(j, unknown) && !settle_for_least(j, unknown)) {
            joint.take(j);
            if (!solve_joint(joint, j, unknown)) return false;
            write(joint, j);
        }
        std::int32_t image = j;
        do {
            pass_on_counts(image);
            if (images_.any()) image = images_.joint[image];
        } while (image != j);
        return true;
    }
    /// The paths of a solved joint have the counts of its cells, and the joints beyond them are next.
    void pass_on_counts(std::int32_t j) {
        done_[j] = 1;
        n_.for_slots(j, [&](std::int32_t slot, std::int32_t path) {
            out_.path_sides[path] = sum_of_cell(p_, p_.cell_first[j] + slot, out_.pieces);
            const std::int32_t beyond = n_.joint_beyond(path, j);
            if (beyond >= 0 && !done_[beyond]) waiting_.push_back(beyond);
        });
    }

    /// A root for each component of trees: a joint that the symmetry keeps in place if there is one.
    std::vector<std::int32_t> tree_roots() const {
        std::vector<std::int32_t> root(regions_.components, -1);
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            if (done_[j]) continue;
            std::int32_t& r = root[regions_.component[j]];
            if (r < 0 || (images_.any() && images_.joint[r] != r && images_.joint[j] == j)) r = j;
        }
        root.erase(std::remove(root.begin(), root.end(), -1), root.end());
        return root;
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
    const JointSurfaces& surfaces_;
    const Images& images_;
    RefineOptions options_;
    Regions regions_;
    PathNeeds needs_;
    std::vector<std::uint8_t> core_joint_;
    // While trees are solved:
    std::vector<std::uint8_t> done_;     ///< joint -> its pieces are known
    std::vector<std::int32_t> waiting_;  ///< joints, in the order in which they are solved
    std::size_t next_waiting_ = 0;
    Refinement out_;
};

}  // namespace

Result<Refinement> refine(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                          const JointSurfaces& surfaces, const Images& images, const RefineOptions& options,
                          const Progress& progress) {
    return Refiner(skeleton, network, polyhedra, surfaces, images, options).run(progress);
}

}  // namespace sinew::sqm
