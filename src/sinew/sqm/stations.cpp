#include "sinew/sqm/stations.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sinew/sqm/path_frame.h"

namespace sinew::sqm {
namespace {

constexpr std::int32_t chunk_size = 256;  // paths that one task takes
constexpr double steep = 0.45;  // sine of a cone's slope from which its round parts get rings of their own
constexpr double very_steep = 0.85;

/// What a joint takes of the path that leaves it.
struct JointSide {
    std::int32_t joint = -1, cell = -1;
    std::vector<std::uint32_t> ring;  // its points, counter-clockwise in the path's sense
    double reach = 0;                 // how far they go along the bone
    double farthest = 0;              // and from the joint's centre

    bool any() const { return joint >= 0; }
};

class PathBuilder {
  public:
    PathBuilder(const Plain& s, const Network& n, const Polyhedra& p, const Refinement& r,
                const JointPoints& points, Stations& out)
        : s_(s), n_(n), p_(p), r_(r), points_(points), out_(out) {}

    /// @param least_rings  rings that the path must have, so that no two paths share an edge
    void build(std::int32_t path, std::int32_t least_rings) {
        path_ = path;
        nodes_ = n_.nodes(path);
        bones_ = n_.bones(path);
        closed_ = n_.path_closed[path];
        sides_ = r_.path_sides[path];
        take_joint(near_, n_.path_end[path][0], false);
        take_joint(far_, n_.path_end[path][1], true);
        leave_out_nodes();
        place_rings();
        if (std::ssize(rings_) < least_rings) {
            std::fill(kept_.begin(), kept_.end(), 1);
            place_rings();
        }
        turn_frames();
        find_angles();
        add_follow_rings();
        finish();
    }

  private:
    std::int32_t count() const { return static_cast<std::int32_t>(nodes_.size()); }
    std::int32_t bone_count() const { return closed_ ? count() : count() - 1; }
    std::int32_t node(std::int32_t i) const { return nodes_[(i + count()) % count()]; }
    const Vec3& position(std::int32_t i) const { return s_.position[node(i)]; }
    double radius(std::int32_t i) const { return s_.radius[node(i)]; }
    Vec3 direction(std::int32_t bone) const { return (position(bone + 1) - position(bone)).normalized(); }
    double edge(double radius) const { return 2 * std::sin(M_PI / sides_) * radius; }

    void take_joint(JointSide& side, const PathEnd& end, bool is_far) {
        side.ring.clear();
        side.joint = end.joint;
        side.reach = side.farthest = 0;
        if (!end.at_joint()) return;
        side.cell = p_.cell_first[end.joint] + end.slot;
        append_ring(p_, r_, points_, end.joint, side.cell, side.ring);
        if (is_far) std::reverse(side.ring.begin(), side.ring.end());
        const Vec3& centre = s_.position[n_.joint_node[end.joint]];
        const Vec3& axis = points_.cone[n_.slot_first[end.joint] + end.slot].axis;
        for (const std::uint32_t i : side.ring) {
            const Vec3 from = points_.position[i] - centre;
            side.reach = std::max(side.reach, from.dot(axis));
            side.farthest = std::max(side.farthest, from.norm());
        }
    }

    /// How far the ring at a node leans over its bones, on the inner side of the bend.
    double lean(std::int32_t i) const {
        const double cosine = std::clamp(direction(i - 1).dot(direction(i)), -1.0, 1.0);
        return radius(i) * std::min(1.0, std::sqrt((1 - cosine) / (1 + cosine + 1e-12)));
    }

    /// Rings inside a joint's own part are left out.
    void leave_out_nodes() {
        kept_.assign(count(), 1);
        if (closed_) return;
        const auto inside = [&](const JointSide& side, std::int32_t i, const Vec3& axis) {
            const Vec3 from = position(i) - s_.position[n_.joint_node[side.joint]];
            return from.dot(axis) - lean(i) < side.reach + 0.1 * radius(i) &&
                   from.norm() < side.farthest + 0.1 * radius(i);
        };
        if (near_.any())
            for (std::int32_t i = 1; i + 1 < count() && inside(near_, i, direction(0)); ++i) kept_[i] = 0;
        if (far_.any())
            for (std::int32_t i = count() - 2; i > 0 && inside(far_, i, -direction(count() - 2)); --i)
                kept_[i] = 0;
    }

    void place_rings() {
        rings_.clear();
        if (!closed_ && !near_.any()) add_cap(false);
        for (std::int32_t i = 0; i < count(); ++i) {
            if ((closed_ || (i > 0 && i + 1 < count())) && kept_[i]) add_node_ring(i);
            if (i < bone_count()) add_bone_rings(i);
        }
        if (!closed_ && !far_.any()) add_cap(true);
    }

    Station& add(const Vec3& centre, const Vec3& tangent, double radius, std::int32_t bone, double along) {
        Station ring;
        ring.centre = centre;
        ring.tangent = tangent;
        ring.radius = radius;
        ring.bone = bones_[bone];
        const bool forward = s_.bones[ring.bone][0] == node(bone);
        ring.along = static_cast<float>(std::clamp(forward ? along : 1 - along, 0.0, 1.0));
        ring.node = node(along > 0.5 ? bone + 1 : bone);
        return rings_.emplace_back(ring);
    }
    void add_on_bone(std::int32_t bone, const ConeFrom& cone, double height) {
        add(position(bone) + height * cone.axis, cone.axis, cone.radius_at(height), bone,
            height / cone.length);
    }

    void add_node_ring(std::int32_t i) {
        const Vec3 in = direction(i - 1), out = direction(i), sum = in + out;
        Station& ring =
            add(position(i), sum.norm() > 1e-6 ? sum.normalized() : in, radius(i), i % bone_count(), 0);
        if (i > 0 && i == bone_count()) ring.bone = bones_[i - 1];
        ring.node = node(i);
        ring.before = node(i - 1);
        ring.after = node(i + 1);
        ring.shape = RingShape::node;
    }

    /// Rings of a round end: from where the cone touches the ball to just before the pole.
    void add_cap(bool at_end) {
        const std::int32_t leaf = at_end ? count() - 1 : 0, other = at_end ? leaf - 1 : 1;
        if (s_.cap[node(leaf)] != Cap::round) return;
        const Vec3 outward = (position(leaf) - position(other)).normalized();
        const double length = (position(leaf) - position(other)).norm(), r = radius(leaf);
        const double begin = std::asin(std::clamp((radius(other) - r) / length, -0.9, 0.9));
        const int rings =
            std::max(1, static_cast<int>(std::lround(sides_ * (M_PI / 2 - begin) / (2 * M_PI))));
        for (int i = 0; i < rings; ++i) {
            const int step = at_end ? i : rings - 1 - i;
            const double angle = begin + (M_PI / 2 - begin) * step / rings;
            const Vec3 centre = position(leaf) + r * std::sin(angle) * outward;
            if (at_end && near_.any() && count() == 2 &&
                length + r * std::sin(angle) < near_.reach + 0.15 * r)
                continue;
            Station& ring = add(centre, at_end ? outward : Vec3(-outward), r * std::cos(angle),
                                at_end ? leaf - 1 : 0, at_end);
            ring.node = node(leaf);
        }
    }

    /// Part of a bone that is free for rings, as heights above its first node.
    std::pair<double, double> free_part(std::int32_t bone, const ConeFrom& cone) const {
        const auto end = [&](std::int32_t i, const JointSide& side, bool last) {
            if (!closed_ && (last ? i == count() - 1 : i == 0)) {
                if (side.any()) return side.reach;
                return last ? cone.length - cone.side_end() : cone.side_begin();
            }
            return kept_[i % count()] ? std::min(lean(i), 0.5 * cone.length) : cone.length;
        };
        return {end(bone, near_, false), cone.length - end(bone + 1, far_, true)};
    }

    /// Rings along a bone: one beside each joint, so that the tube keeps its radius from there on, and some
    /// where a steep cone touches the balls at its ends.
    void add_bone_rings(std::int32_t bone) {
        const ConeFrom cone(position(bone), radius(bone), position(bone + 1), radius(bone + 1));
        if (cone.nested()) return;
        const std::pair<double, double> free = free_part(bone, cone);
        const double low = free.first, high = free.second;  // clang 14: a lambda takes no structured binding
        const bool at_near = near_.any() && bone == 0, at_far = far_.any() && bone == bone_count() - 1;
        const double low_edge = edge(cone.radius_at(low)), high_edge = edge(cone.radius_at(high)),
                     room = high - low;
        heights_.clear();
        if (at_near && at_far && room <= 0.75 * (low_edge + high_edge)) {
            if (room > 0.4 * (low_edge + high_edge)) heights_.push_back((low + high) / 2);
        } else {
            if (at_near && room > 1.25 * low_edge) heights_.push_back(low + 0.4 * low_edge);
            if (at_far && room > 1.25 * high_edge) heights_.push_back(high - 0.4 * high_edge);
        }
        const double slope = std::asin(cone.sine);
        const auto offer = [&](double height) {
            const double gap = 0.3 * edge(cone.radius_at(height));
            if (height < low + gap || height > high - gap) return;
            for (const double h : heights_)
                if (std::abs(h - height) < gap) return;
            heights_.push_back(height);
        };
        if (cone.sine > steep && (bone > 0 || near_.any() || closed_)) offer(cone.side_begin());
        if (cone.sine > very_steep) offer(cone.near * std::sin(slope / 2));
        if (cone.sine < -steep && (bone + 1 < bone_count() || far_.any() || closed_)) offer(cone.side_end());
        if (cone.sine < -very_steep) offer(cone.length + cone.far * std::sin(slope / 2));
        std::sort(heights_.begin(), heights_.end());
        for (const double height : heights_) add_on_bone(bone, cone, height);
    }

    /// Frames from ring to ring; those of the joints at both ends are kept beside.
    void turn_frames() {
        near_tangent_ = near_.any()      ? p_.sites[near_.cell]
                        : rings_.empty() ? direction(0)
                                         : rings_.front().tangent;
        far_tangent_ = far_.any()       ? Vec3(-p_.sites[far_.cell])
                       : rings_.empty() ? direction(bone_count() - 1)
                                        : rings_.back().tangent;
        const Vec3& start = closed_ ? rings_.front().centre : position(0);
        Vec3 x = frame_x(near_tangent_);
        near_x_ = x;
        const Vec3* at = &start;
        const Vec3* tangent = &near_tangent_;
        length_ = 0;
        for (Station& ring : rings_) {
            x = carry_frame(x, *at, *tangent, ring.centre, ring.tangent);
            length_ += (ring.centre - *at).norm();
            ring.x = x;
            ring.y = ring.tangent.cross(x);
            ring.turn = length_;  // for now; becomes an angle once the twist is known
            at = &ring.centre;
            tangent = &ring.tangent;
        }
        const Vec3& end = closed_ ? rings_.front().centre : position(count() - 1);
        if (closed_) far_tangent_ = rings_.front().tangent;
        far_x_ = carry_frame(x, *at, *tangent, end, far_tangent_);
        length_ += (end - *at).norm();
    }

    void joint_angles(const JointSide& side, const Vec3& tangent, const Vec3& x,
                      std::vector<double>& angles) const {
        angles.clear();
        const Vec3 y = tangent.cross(x);
        const Vec3& centre = s_.position[n_.joint_node[side.joint]];
        for (const std::uint32_t i : side.ring)
            angles.push_back(angle_round(points_.position[i] - centre, x, y));
        unwrap(angles);
    }

    /// Where the columns of the path stand: evenly round it, as near as can be to the vertices of the joints'
    /// rings.
    void find_angles() {
        const double step = 2 * M_PI / sides_;
        double phase = 0, far_phase = 0, twist = 0;
        std::int32_t shift = 0;
        if (near_.any()) {
            joint_angles(near_, near_tangent_, near_x_, near_angles_);
            phase = even_phase(near_angles_);
        } else if (!rings_.empty()) {  // nothing to go by but the world's axes, at the middle, so that both
                                       // ends are alike
            const Station& middle = rings_[rings_.size() / 2];
            phase = angle_round(frame_x(middle.tangent), middle.x, middle.y);
        }
        if (far_.any()) {
            joint_angles(far_, far_tangent_, far_x_, far_angles_);
            far_phase = even_phase(far_angles_);
        } else if (closed_) {  // the first ring again, as seen from the frame that was carried round
            far_phase = phase - angle_round(far_x_, rings_.front().x, rings_.front().y);
        }
        if (far_.any() || closed_) {
            shift = static_cast<std::int32_t>(std::lround((phase - far_phase) / step));
            twist = far_phase + shift * step - phase;
        }
        shift = ((shift % sides_) + sides_) % sides_;
        out_.far_shift.push_back(shift);
        for (std::int32_t k = 0; k < sides_; ++k) {
            out_.angle.push_back(phase + step * k);
            out_.near_uneven.push_back(near_.any() ? near_angles_[k] - (phase + step * k) : 0);
            const std::int32_t j = (k + shift) % sides_;
            out_.far_uneven.push_back(far_.any() ? far_angles_[j] - (far_phase + step * j) : 0);
        }
        for (Station& ring : rings_) ring.turn = length_ > 0 ? twist * ring.turn / length_ : 0;
        constexpr double left[] = {0.45, 0.15};  // of the joint's spacing, on the rings next to it
        for (std::size_t i = 0; i < std::min<std::size_t>(2, rings_.size()); ++i) {
            if (near_.any()) rings_[i].near_share = left[i];
            if (far_.any()) rings_[rings_.size() - 1 - i].far_share = left[i];
        }
    }

    /// Where the faces between a joint and the first ring would cut off much of the joint's ball, rings
    /// follow the ball.
    void add_follow_rings() {
        if (rings_.empty()) return;
        if (far_.any()) insert_follow(far_, true, follow_rings(far_, rings_.back(), true));
        if (near_.any()) insert_follow(near_, false, follow_rings(near_, rings_.front(), false));
    }
    int follow_rings(const JointSide& side, const Station& ring, bool is_far) const {
        const Vec3& centre = s_.position[n_.joint_node[side.joint]];
        const double r = s_.radius[n_.joint_node[side.joint]];
        const std::size_t angles = out_.angle.size() - sides_;
        double worst = 0;
        for (std::int32_t k = 0; k < sides_; ++k) {
            const std::int32_t j = is_far ? (k + out_.far_shift.back()) % sides_ : k;
            const double angle = out_.angle[angles + k] + ring.turn;
            const Vec3 on_ring =
                ring.centre + ring.radius * (std::cos(angle) * ring.x + std::sin(angle) * ring.y);
            const Vec3 middle = 0.5 * (points_.position[side.ring[j]] + on_ring) - centre;
            const double distance = middle.norm();
            if (distance > 0)
                worst = std::max(worst, exit_of_joint(n_, points_, side.joint, middle / distance) - distance);
        }
        return worst > 0.45 * r ? 2 : worst > 0.18 * r ? 1 : 0;
    }
    void insert_follow(const JointSide& side, bool is_far, int rings) {
        for (int i = 0; i < rings; ++i) {
            Station ring = is_far ? rings_.back() : rings_.front();
            ring.shape = RingShape::follow;
            ring.far = is_far;
            ring.share = static_cast<double>(rings - i) / (rings + 1);
            ring.node = n_.joint_node[side.joint];
            if (is_far) {
                ring.share = static_cast<double>(rings - i) / (rings + 1);
                rings_.push_back(ring);
            } else {
                rings_.insert(rings_.begin(), ring);
            }
        }
    }

    void finish() {
        out_.stations.insert(out_.stations.end(), rings_.begin(), rings_.end());
        out_.first.push_back(static_cast<std::int32_t>(out_.stations.size()));
        out_.angle_first.push_back(static_cast<std::int32_t>(out_.angle.size()));
    }

    const Plain& s_;
    const Network& n_;
    const Polyhedra& p_;
    const Refinement& r_;
    const JointPoints& points_;
    Stations& out_;

    std::int32_t path_ = 0, sides_ = 4;
    std::span<const std::int32_t> nodes_, bones_;
    bool closed_ = false;
    JointSide near_, far_;
    std::vector<std::uint8_t> kept_;
    std::vector<Station> rings_;
    std::vector<double> heights_, near_angles_, far_angles_;
    Vec3 near_tangent_, far_tangent_, near_x_, far_x_;
    double length_ = 0;
};

/// Rings that each path must have: two on a path from a joint to itself, one on each of several between the
/// same two joints that has nodes to carry it; all others may do with none.
std::vector<std::uint8_t> least_rings(const Network& n) {
    std::vector<std::uint8_t> least(n.path_count(), 0);
    std::vector<std::array<std::int32_t, 3>> pairs;
    for (std::int32_t p = 0; p < n.path_count(); ++p) {
        const auto [a, b] = std::minmax(n.path_end[p][0].joint, n.path_end[p][1].joint);
        if (a == b && a >= 0) least[p] = 2;
        if (a != b && a >= 0) pairs.push_back({a, b, p});
    }
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto same = [&](std::size_t j) {
            return j < pairs.size() && pairs[j][0] == pairs[i][0] && pairs[j][1] == pairs[i][1];
        };
        const std::int32_t path = pairs[i][2];
        if (n.nodes(path).size() > 2 && (same(i + 1) || (i > 0 && same(i - 1)))) least[path] = 1;
    }
    return least;
}

Stations empty_stations() {
    Stations s;
    s.first = s.angle_first = {0};
    return s;
}

void concatenate(Stations& to, const Stations& from) {
    const std::int32_t ring = to.first.back(), angle = to.angle_first.back();
    for (std::size_t i = 1; i < from.first.size(); ++i) {
        to.first.push_back(from.first[i] + ring);
        to.angle_first.push_back(from.angle_first[i] + angle);
    }
    const auto append = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
    append(to.stations, from.stations);
    append(to.angle, from.angle);
    append(to.near_uneven, from.near_uneven);
    append(to.far_uneven, from.far_uneven);
    append(to.far_shift, from.far_shift);
}

}  // namespace

Stations make_stations(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                       const Refinement& refinement, const JointPoints& points) {
    const std::vector<std::uint8_t> least = least_rings(network);
    const std::int32_t paths = network.path_count(), chunks = (paths + chunk_size - 1) / chunk_size;
    std::vector<Stations> parts(chunks);
    tbb::parallel_for(std::int32_t{0}, chunks, [&](std::int32_t chunk) {
        parts[chunk] = empty_stations();
        PathBuilder builder(skeleton, network, polyhedra, refinement, points, parts[chunk]);
        for (std::int32_t p = chunk * chunk_size; p < std::min(paths, (chunk + 1) * chunk_size); ++p)
            builder.build(p, least[p]);
    });
    if (chunks == 1) return std::move(parts[0]);
    Stations all = empty_stations();
    for (const Stations& part : parts) concatenate(all, part);
    return all;
}

}  // namespace sinew::sqm
