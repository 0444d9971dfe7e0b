#include "sinew/skeleton/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <set>
#include <span>

#include "sinew/base/round_cone.h"

namespace sinew {
namespace {

/// By how many times the tube without a node is wider or narrower there than the node, before that is a shape of
/// its own: half of an artist's or a reader's eye for a bulge, and above what neighbours in measured tubes differ by
/// (1.0 to 1.2 at 90 % of the nodes of runs in ../shared/data).
constexpr double own_shape = 1.4;
/// Of a ball's radius, from its centre: where a tube that comes out of it gets a node.
constexpr double out_of_ball = 1.02;

/// A graph under repair: nodes point at the node they were merged into, bones at the source bone they stand
/// for.
class Repair {
  public:
    Repair(const Document& document, const ConditionOptions& options)
        : document_(document), options_(options), bones_(bones_of(document)), merged_(document.nodes.size()) {
        std::iota(merged_.begin(), merged_.end(), 0);
        source_.resize(bones_.size());
        std::iota(source_.begin(), source_.end(), 0);
        foot_.assign(bones_.size(), {-1, -1});
    }

    CleanGraph run() {
        merge_bones_of_no_length();
        drop_duplicates();
        if (options_.repair) {
            merge_nested();
            drop_duplicates();
            thin_runs();
        }
        return compact();
    }

  private:
    const Vec3& position(std::int32_t i) const { return document_.nodes[i].position; }
    double radius(std::int32_t i) const { return document_.nodes[i].radius; }
    double distance(std::int32_t a, std::int32_t b) const { return (position(a) - position(b)).norm(); }
    bool coincide(std::int32_t a, std::int32_t b) const {
        return distance(a, b) <= 1e-9 * std::max(radius(a), radius(b));
    }
    std::int32_t root(std::int32_t i) {
        while (merged_[i] != i) i = merged_[i] = merged_[merged_[i]];
        return i;
    }

    bool is_plain(std::int32_t i) const {
        const Node& node = document_.nodes[i];
        return node.type == NodeType::sphere && node.section == Section::round;
    }

    void warn(std::string_view what, std::int64_t count, std::vector<std::int64_t> nodes = {}) {
        if (count > 0) warnings_.push_back({fmt::format("{} {}", count, what), count, std::move(nodes)});
    }
    void note(std::vector<std::int64_t>& nodes, std::int32_t i) const {
        if (nodes.size() < 16) nodes.push_back(document_.nodes[i].id);
    }

    /// The larger ball stays; of equal ones that of the lower index.
    std::int32_t larger(std::int32_t a, std::int32_t b) const {
        if (radius(a) != radius(b)) return radius(a) > radius(b) ? a : b;
        return std::min(a, b);
    }
    void merge(std::int32_t a, std::int32_t b) {
        const std::int32_t stays = larger(a, b);
        merged_[stays == a ? b : a] = stays;
    }

    void merge_bones_of_no_length() {
        std::int64_t count = 0;
        std::vector<std::int64_t> nodes;
        for (const Bone& bone : bones_) {
            const std::int32_t a = root(bone[0]), b = root(bone[1]);
            if (a == b || !coincide(a, b)) continue;
            if (!is_plain(bone[0]) || !is_plain(bone[1])) continue;  // drawn on purpose
            merge(a, b);
            note(nodes, bone[1]);
            ++count;
        }
        warn("bones of no length were merged", count, std::move(nodes));
    }

    /// Of bones between the same two nodes the first stays; those from a node to itself vanish.
    void drop_duplicates() {
        for (std::size_t b = 0; b < bones_.size(); ++b)
            for (int k = 0; k < 2; ++k) {
                std::int32_t& end = bones_[b][k];
                const std::int32_t stays = root(end);
                if (stays != end && foot_[b][k] < 0) foot_[b][k] = end;
                end = stays;
            }
        const auto count = static_cast<std::int32_t>(document_.nodes.size());
        const Adjacency around = adjacency(count, bones_);
        std::vector<std::int32_t> last(count, -1);  // node -> the lower neighbour that was looked at last
        std::vector<std::uint8_t> drop(bones_.size(), 0);
        std::int64_t repeated = 0;
        for (std::int32_t low = 0; low < count; ++low)
            for (const std::int32_t b : around.bones(low)) {
                const std::int32_t high = bones_[b][0] + bones_[b][1] - low;
                if (high < low) continue;
                drop[b] = high == low || last[high] == low;
                repeated += high != low && last[high] == low;
                last[high] = low;
            }
        keep_bones(drop);
        warn("duplicate bones were dropped", repeated);
    }
    void keep_bones(const std::vector<std::uint8_t>& drop) {
        std::size_t kept = 0;
        for (std::size_t b = 0; b < bones_.size(); ++b)
            if (!drop[b]) bones_[kept] = bones_[b], source_[kept] = source_[b], foot_[kept++] = foot_[b];
        bones_.resize(kept);
        source_.resize(kept);
        foot_.resize(kept);
    }

    bool too_close(std::int32_t a, std::int32_t b, bool crowded) const {
        const double d = distance(a, b), large = std::max(radius(a), radius(b)),
                     small = std::min(radius(a), radius(b));
        return d + small <= options_.nested * large || (crowded && d < options_.together * large);
    }

    /// Merges along bones, each node's neighbours kept as a list; never where both ends have a neighbour in
    /// common, which would close a cycle up.
    void merge_nested() {
        const auto count = static_cast<std::int32_t>(document_.nodes.size());
        std::vector<std::vector<std::int32_t>> neighbours(count);
        for (const Bone& bone : bones_) {
            neighbours[bone[0]].push_back(bone[1]);
            neighbours[bone[1]].push_back(bone[0]);
        }
        std::int64_t merged = 0;
        std::vector<std::int64_t> nodes;
        std::vector<std::int32_t> pending(count);
        std::iota(pending.rbegin(), pending.rend(), 0);
        while (!pending.empty()) {
            const std::int32_t at = pending.back();
            pending.pop_back();
            if (root(at) != at) continue;
            for (const std::int32_t next : std::vector<std::int32_t>(neighbours[at])) {
                const bool crowded = neighbours[at].size() > 2 || neighbours[next].size() > 2;
                if (!too_close(at, next, crowded) || have_common(neighbours[at], neighbours[next]) ||
                    leaves_no_length(neighbours, at, next))
                    continue;
                merge(at, next);
                const std::int32_t stays = root(at), goes = stays == at ? next : at;
                join(neighbours, stays, goes);
                note(nodes, goes);
                ++merged;
                pending.push_back(stays);
                break;
            }
        }
        warn("nodes inside a neighbour's ball were merged into it", merged, std::move(nodes));
    }
    /// Whether a bone of the ball that goes would have no length once it belongs to the one that stays.
    bool leaves_no_length(const std::vector<std::vector<std::int32_t>>& neighbours, std::int32_t a,
                          std::int32_t b) const {
        const std::int32_t stays = larger(a, b), goes = stays == a ? b : a;
        return std::any_of(neighbours[goes].begin(), neighbours[goes].end(),
                           [&](std::int32_t n) { return n != stays && coincide(n, stays); });
    }
    static bool have_common(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
        const auto& small = a.size() < b.size() ? a : b;
        const auto& large = a.size() < b.size() ? b : a;
        return std::any_of(small.begin(), small.end(), [&](std::int32_t i) {
            return std::find(large.begin(), large.end(), i) != large.end();
        });
    }
    static void join(std::vector<std::vector<std::int32_t>>& neighbours, std::int32_t stays,
                     std::int32_t goes) {
        auto& list = neighbours[stays];
        list.erase(std::find(list.begin(), list.end(), goes));
        for (const std::int32_t n : neighbours[goes]) {
            if (n == stays) continue;
            list.push_back(n);
            std::replace(neighbours[n].begin(), neighbours[n].end(), goes, stays);
        }
        neighbours[goes].clear();
    }

    /// Takes nodes out of runs until all are far enough apart, the most crowded and thinnest first.
    void thin_runs() {
        const auto count = static_cast<std::int32_t>(document_.nodes.size());
        const Adjacency adjacent = adjacency(count, bones_);
        side_.assign(count, {-1, -1});
        for (std::int32_t i = 0; i < count; ++i)
            if (adjacent.degree(i) == 2)
                for (int k = 0; k < 2; ++k) side_[i][k] = adjacent.bones(i)[k];
        using Entry = std::pair<double, std::int32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        for (std::int32_t i = 0; i < count; ++i)
            if (adjacent.degree(i) == 2) queue.emplace(crowding(i), i);
        std::int64_t removed = 0;
        std::vector<std::int64_t> nodes;
        gone_.assign(bones_.size(), 0);
        while (!queue.empty() && queue.top().first < options_.spacing) {
            const auto [crowd, i] = queue.top();
            queue.pop();
            if (merged_[i] != i || crowd != crowding(i) || !may_remove(i, adjacent)) continue;
            const int swallowing = swallowing_side(i);
            if (swallowing < 0 && is_a_shape_of_its_own(i)) continue;
            const std::array<std::int32_t, 2> ends{other(i, 0), other(i, 1)};
            remove(i, swallowing);
            note(nodes, i);
            ++removed;
            for (const std::int32_t n : ends)
                if (side_[n][0] >= 0) queue.emplace(crowding(n), n);
        }
        keep_bones(gone_);
        warn("nodes closer than a tube's radius were thinned out", removed, std::move(nodes));
    }
    std::int32_t other(std::int32_t i, int k) const {
        const Bone& bone = bones_[side_[i][k]];
        return bone[0] == i ? bone[1] : bone[0];
    }
    /// How near a node is to the nearer of its neighbours, in radii of the larger ball; less, down to half of that,
    /// beside a ball that is larger than its own. Nodes between fat ones go first, and those that stand clear of
    /// a fat ball are not counted as beside it.
    double crowding(std::int32_t i) const {
        double least = 1e300;
        for (int k = 0; k < 2; ++k) {
            const std::int32_t n = other(i, k);
            const double large = std::max(radius(i), radius(n));
            least = std::min(least, distance(i, n) / large * (0.5 + 0.5 * radius(i) / large));
        }
        return least;
    }
    /// The radius that the tube from `a` to `b` has beside a place, without the node there.
    double radius_between(std::int32_t a, std::int32_t b, const Vec3& place) const {
        const ConeFrom cone(position(a), radius(a), position(b), radius(b));
        const double height = std::clamp((place - position(a)).dot(cone.axis), 0.0, cone.length);
        return cone.nested() ? std::max(radius(a), radius(b)) : cone.radius_at(height);
    }
    /// Whether the tube would be much wider or narrower at a node, were it not for the node.
    bool is_a_shape_of_its_own(std::int32_t i) const {
        const double without = radius_between(other(i, 0), other(i, 1), position(i));
        return without > own_shape * radius(i) || radius(i) > own_shape * without;
    }
    /// The side on which a node is within the ball of its neighbour, from which a thinner tube goes on; -1
    /// for neither.
    int swallowing_side(std::int32_t i) const {
        for (int k = 0; k < 2; ++k) {
            const std::int32_t n = other(i, k);
            if (radius(n) > own_shape * radius(i) && distance(i, n) < radius(n) &&
                radius(n) > own_shape * radius(other(i, 1 - k)))
                return k;
        }
        return -1;
    }
    /// A closed path keeps three nodes; one from a joint to itself keeps two; one beside another bone keeps
    /// one.
    bool may_remove(std::int32_t i, const Adjacency& adjacent) const {
        const std::int32_t a = other(i, 0), b = other(i, 1);
        if (a == b || coincide(a, b)) return false;
        for (const std::int32_t n : {a, b})
            if (side_[n][0] >= 0)
                for (int k = 0; k < 2; ++k)
                    if (other(n, k) == (n == a ? b : a)) return false;
        if (side_[a][0] >= 0 || side_[b][0] >= 0) {
            // Two nodes from one joint to itself: taking one out would leave a loop of two bones.
            const auto beyond = [&](std::int32_t n) { return other(n, other(n, 0) == i ? 1 : 0); };
            if (side_[a][0] >= 0 && beyond(a) == b) return false;
            if (side_[b][0] >= 0 && beyond(b) == a) return false;
            return true;
        }
        if (shortened_.count(std::minmax(a, b))) return false;
        const std::int32_t fewer = adjacent.degree(a) < adjacent.degree(b) ? a : b;
        for (const std::int32_t bone : adjacent.bones(fewer)) {
            if (gone_[bone]) continue;
            const Bone& ends = bones_[bone];
            if (std::minmax(ends[0], ends[1]) == std::minmax(a, b)) return false;
        }
        return true;
    }
    /// The bone on one side grows over the node; that on the other goes.
    /// @param swallowing  the side whose ball the node is in, where the tube keeps its foot; -1 for none
    void remove(std::int32_t i, int swallowing) {
        const std::int32_t ball = swallowing >= 0 ? other(i, swallowing) : -1;
        const std::int32_t keep = std::min(side_[i][0], side_[i][1]),
                           drop = std::max(side_[i][0], side_[i][1]);
        const std::int32_t a = other(i, 0), b = other(i, 1);
        if (side_[a][0] < 0 && side_[b][0] < 0) shortened_.insert(std::minmax(a, b));
        const int far_end = bones_[drop][0] == i ? 1 : 0;
        const std::int32_t far = bones_[drop][far_end];
        for (int k = 0; k < 2; ++k) {
            std::int32_t& end = bones_[keep][k];
            if (end == i) end = far, foot_[keep][k] = foot_[drop][far_end];
            if (ball >= 0 && end == ball) foot_[keep][k] = i;
        }
        gone_[drop] = 1;
        for (std::int32_t& bone : side_[far])
            if (bone == drop) bone = keep;
        merged_[i] = far;
    }

    CleanGraph compact() {
        CleanGraph clean;
        clean.position.reserve(document_.nodes.size());
        clean.radius.reserve(document_.nodes.size());
        clean.source_node.reserve(document_.nodes.size());
        clean.bones.reserve(bones_.size());
        std::vector<std::int32_t> index(document_.nodes.size(), -1);
        for (std::int32_t i = 0; i < std::ssize(document_.nodes); ++i) {
            if (merged_[i] != i) continue;
            index[i] = static_cast<std::int32_t>(clean.position.size());
            clean.position.push_back(position(i));
            clean.radius.push_back(radius(i));
            clean.source_node.push_back(i);
        }
        for (std::size_t b = 0; b < bones_.size(); ++b) add_bone(b, index, clean);
        clean.warnings = std::move(warnings_);
        return clean;
    }

    /// Adds a bone of the graph. Where it leaves a ball that swallowed its first node, it gets a new one where it
    /// comes out, so that a thin tube does not become a cone as wide as the ball.
    void add_bone(std::size_t b, std::span<const std::int32_t> index, CleanGraph& clean) const {
        std::array<std::int32_t, 2> ends{index[bones_[b][0]], index[bones_[b][1]]};
        std::array<std::optional<Ball>, 2> feet{foot(b, 0), foot(b, 1)};
        if (feet[0] && feet[1] &&
            (feet[1]->centre - feet[0]->centre).dot(position(bones_[b][1]) - position(bones_[b][0])) <= 0)
            feet = {};  // both balls overlap, and nothing of the tube is seen
        std::int32_t from = ends[0];
        for (int k = 0; k < 2; ++k) {
            if (!feet[k]) continue;
            const auto node = static_cast<std::int32_t>(clean.position.size());
            clean.position.push_back(feet[k]->centre);
            clean.radius.push_back(feet[k]->radius);
            clean.source_node.push_back(foot_[b][k]);
            clean.bones.push_back({from, node});
            clean.source_bone.push_back(source_[b]);
            from = node;
        }
        clean.bones.push_back({from, ends[1]});
        clean.source_bone.push_back(source_[b]);
    }

    struct Ball {
        Vec3 centre;
        double radius;
    };
    /// Where the tube of a bone comes out of the ball at one of its ends, if a node of its own was merged into
    /// that, and its radius there. None where the tube would be as wide without.
    std::optional<Ball> foot(std::size_t b, int k) const {
        const std::int32_t swallowed = foot_[b][k], ball = bones_[b][k];
        const std::int32_t beyond = foot_[b][1 - k] >= 0 ? foot_[b][1 - k] : bones_[b][1 - k];
        if (swallowed < 0 || swallowed == ball) return std::nullopt;
        const Vec3 from = position(swallowed), way = position(beyond) - from, in = from - position(ball);
        const double length = way.norm(), reach = out_of_ball * radius(ball);
        if (!(length > 0) || in.norm() >= reach) return std::nullopt;
        const double half = in.dot(way) / length,
                     along = -half + std::sqrt(half * half + reach * reach - in.squaredNorm());
        const double share = along / length, wide = (1 - share) * radius(swallowed) + share * radius(beyond);
        if (length - along < options_.spacing * std::max(wide, radius(beyond))) return std::nullopt;
        const Vec3 at = from + share * way;
        if (radius_between(ball, beyond, at) < own_shape * wide) return std::nullopt;
        return Ball{at, wide};
    }

    const Document& document_;
    ConditionOptions options_;
    std::vector<Bone> bones_;
    std::vector<std::int32_t> merged_;  // node -> node it was merged into
    std::vector<std::int32_t> source_;  // bone -> source bone
    std::vector<std::array<std::int32_t, 2>>
        foot_;  // bone, end -> the node it was drawn from, if that was merged
    std::vector<std::array<std::int32_t, 2>> side_;
    std::vector<std::uint8_t> gone_;
    std::set<std::pair<std::int32_t, std::int32_t>> shortened_;  // ends of runs that are one bone now
    Warnings warnings_;
};

}  // namespace

CleanGraph condition(const Document& document, const ConditionOptions& options) {
    return Repair(document, options).run();
}

}  // namespace sinew
