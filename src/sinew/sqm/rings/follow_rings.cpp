#include "sinew/sqm/rings/follow_rings.h"

#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/surface/joint_reach.h"

namespace sinew::sqm {
namespace {

/// Rings that follow the joint's surface to the first proper ring.
class Follower {
  public:
    explicit Follower(PathWork& work) : w_(work) {}

    void run() {
        if (w_.far.any()) insert(w_.far, true);
        if (w_.near.any()) insert(w_.near, false);
    }

  private:
    /// How many rings the worst column wants; its target is the first proper ring, or the pole of a bare
    /// surface.
    int wanted(const JointSide& side, bool is_far) const {
        const bool pole = w_.rings.empty();
        if (pole && w_.s.cap[w_.node(is_far ? 0 : w_.count() - 1)] != Cap::surface) return 0;
        const Form* body = w_.surfaces.body[side.joint];
        if (pole && body && body->kind == Form::Kind::box) return 0;
        const double r = w_.s.radius[w_.n.joint_node[side.joint]];
        const bool ball = body && body->kind == Form::Kind::ball;
        if (!pole && !ball && is_near(side, is_far ? w_.rings.back() : w_.rings.front())) return 0;
        if (!pole && w_.surfaces.only_cones[side.joint])
            return !cuts_deeper(side, is_far, 0.18 * r) ? 0 : cuts_deeper(side, is_far, 0.45 * r) ? 2 : 1;
        const std::int32_t angles = w_.out.angle_first[w_.path];
        double worst = 0;
        for (std::int32_t k = 0, j = is_far ? w_.out.far_shift[w_.path] : 0; k < w_.sides; ++k, ++j) {
            if (j == w_.sides) j = 0;
            const Vec3 target = pole ? on_surface(side, w_.position(is_far ? 0 : w_.count() - 1))
                                     : on_ring(is_far, w_.out.angle[angles + k]);
            const Vec3 middle = 0.5 * (side.points[j] + (target - side.centre));
            const double distance = middle.norm();
            if (!(distance > 0)) continue;
            const double exit = reach_of_joint(w_.n, w_.surfaces, side.joint, side.centre, middle / distance);
            worst =
                std::max(worst, (exit - distance) * (ball ? r / exit : 1));  // of an ellipsoid as of a ball
        }
        return worst > 0.45 * r ? 2 : worst > (ball ? 0.02 : 0.18) * r ? 1 : 0;
    }
    /// Whether the middle between the joint's ring and the next one is so much below the joint's surface
    /// somewhere: then the point as far above it is still the joint's.
    bool cuts_deeper(const JointSide& side, bool is_far, double depth) const {
        const Station& ring = is_far ? w_.rings.back() : w_.rings.front();
        const double radius = ring.half.mean();
        const Vec3 to = ring.centre - side.centre, x = radius * ring.x, y = ring.tangent.cross(x);
        auto [sine, cosine] = portable::sine_cosine(w_.out.angle[w_.out.angle_first[w_.path]] + ring.turn);
        for (std::int32_t k = 0, j = is_far ? w_.out.far_shift[w_.path] : 0; k < w_.sides; ++k, ++j) {
            if (j == w_.sides) j = 0;
            const Vec3 middle = 0.5 * (side.points[j] + to + cosine * x + sine * y);
            if (holds(side.joint, (1 + depth / middle.norm()) * middle)) return true;
            const double turned = sine * w_.step.cosine + cosine * w_.step.sine;
            cosine = cosine * w_.step.cosine - sine * w_.step.sine;
            sine = turned;
        }
        return false;
    }
    /// Whether a point, from the joint's centre, is in one of its cones and not beyond what it may take.
    bool holds(std::int32_t joint, const Vec3& point) const {
        bool inside = false;
        for (std::int32_t slot = w_.n.slot_first[joint]; slot < w_.n.slot_first[joint + 1]; ++slot) {
            const ConeFrom& cone = w_.surfaces.cone[slot];
            if (point.dot(cone.axis) > w_.surfaces.limit[slot]) return false;
            inside = inside || cone.holds(point);
        }
        return inside;
    }
    /// Whether no column turns by more than 70 degrees, seen from the joint: a chord of that loses 0.18 of
    /// the radius.
    static bool is_near(const JointSide& side, const Station& ring) {
        const Vec3 out = ring.centre - side.centre;
        const double height = std::abs(out.dot(ring.tangent)),
                     slant = std::sqrt(height * height + ring.half.x() * ring.half.x());
        const double cosine = height / slant, sine = ring.half.x() / slant;
        const double widest = std::sqrt(std::max(0.0, 1 - side.widest * side.widest));
        return side.widest * cosine + widest * sine > 0.342;
    }
    /// Where the joint's surface is on the way to a place.
    Vec3 on_surface(const JointSide& side, const Vec3& place) const {
        const Vec3 ray = (place - side.centre).normalized();
        return side.centre + exit_of_joint(w_.n, w_.surfaces, side.joint, side.centre, ray) * ray;
    }
    Vec3 on_ring(bool is_far, double angle) const {
        const Station& ring = is_far ? w_.rings.back() : w_.rings.front();
        const Vec3 y = ring.tangent.cross(ring.x);
        const auto [sine, cosine] = portable::sine_cosine(angle + ring.turn);
        return ring.centre + ring.half.mean() * (cosine * ring.x + sine * y);
    }
    void insert(const JointSide& side, bool is_far) {
        if (w_.out.crowded[w_.path][is_far]) return;  // there its own surface is not what is seen
        const int rings = wanted(side, is_far);
        if (rings == 0) return;
        Station ring = w_.rings.empty() ? at_surface(is_far) : is_far ? w_.rings.back() : w_.rings.front();
        Station follow;
        follow.centre = ring.centre;
        follow.tangent = ring.tangent;
        follow.x = ring.x;
        follow.turn = ring.turn;
        follow.bone = ring.bone;
        follow.along = ring.along;
        follow.shape = RingShape::follow;
        follow.far = is_far;
        follow.node = w_.n.joint_node[side.joint];
        for (int i = 0; i < rings; ++i) {
            follow.share = static_cast<float>(rings - i) / static_cast<float>(rings + 1);
            w_.rings.insert(is_far ? w_.rings.end() : w_.rings.begin(), follow);
        }
    }
    Station at_surface(bool is_far) const {
        Station ring;
        ring.centre = w_.position(is_far ? 0 : w_.count() - 1);
        ring.bone = w_.bones[is_far ? 0 : w_.bone_count() - 1];
        return ring;
    }

    PathWork& w_;
};

}  // namespace

void add_follow_rings(PathWork& work) { Follower(work).run(); }

}  // namespace sinew::sqm
