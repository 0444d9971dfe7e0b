#include "sinew/sqm/rings/path_angles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sinew/sqm/rings/path_frame.h"

namespace sinew::sqm {
namespace {

class AngleFinder {
  public:
    explicit AngleFinder(PathWork& work)
        : w_(work),
          step_(2 * M_PI / work.sides),
          distance_(work.distance),
          near_angles_(work.near_angles),
          far_angles_(work.far_angles),
          anchors_(work.anchors) {}

    void run() {
        turn_frames();
        choose_phase();
        turn_to_corners();
        reach_far_end();
        spread_turns();
        write();
    }

  private:
    const Station& first() const { return w_.rings.front(); }

    /// Frames from ring to ring; those of the joints at both ends are kept beside.
    void turn_frames() {
        const bool none = w_.rings.empty();
        near_tangent_ = w_.near.any() ? w_.p.sites[w_.near.cell] : none ? w_.direction(0) : first().tangent;
        far_tangent_ = w_.far.any() ? Vec3(-w_.p.sites[w_.far.cell])
                       : w_.closed  ? first().tangent
                       : none       ? w_.direction(w_.bone_count() - 1)
                                    : w_.rings.back().tangent;
        Vec3 at = w_.closed ? first().centre : w_.position(0), tangent = near_tangent_;
        Vec3 x = near_x_ = frame_about(near_tangent_).col(0);
        distance_.clear();
        length_ = 0;
        for (Station& ring : w_.rings) {
            x = ring.x = carry_frame(x, at, tangent, ring.centre, ring.tangent);
            length_ += (ring.centre - at).norm();
            distance_.push_back(length_);
            at = ring.centre;
            tangent = ring.tangent;
        }
        const Vec3& end = w_.closed ? first().centre : w_.position(w_.count() - 1);
        far_x_ = carry_frame(x, at, tangent, end, far_tangent_);
        length_ += (end - at).norm();
    }

    void joint_angles(const JointSide& side, const Vec3& tangent, const Vec3& x,
                      std::vector<double>& angles) const {
        angles.resize(side.points.size());
        const Vec3 y = tangent.cross(x);
        for (std::size_t k = 0; k < angles.size(); ++k) angles[k] = angle_round(side.points[k], x, y);
        unwrap(angles);
    }
    bool is_box(const JointSide& side) const {
        const Form* body = side.any() ? w_.surfaces.body[side.joint] : nullptr;
        return body && body->kind == Form::Kind::box;
    }
    /// Angle of the outline's first corner in the frame that was carried along.
    double corner_angle(const Station& ring) const {
        return angle_round(ring.form_x, ring.x, ring.tangent.cross(ring.x)) + M_PI / 4;
    }

    /// Where column 0 stands: as the near joint's ring has it; else by the first outline's corners; else by
    /// the world's axes at the middle, so that both ends are alike.
    void choose_phase() {
        corner_ = -1;
        phase_ = 0;
        if (w_.near.any()) {
            joint_angles(w_.near, near_tangent_, near_x_, near_angles_);
            phase_ = even_phase(near_angles_);
            if (is_box(w_.near)) corner_ = 0;
            return;
        }
        for (const Station& ring : w_.rings)
            if (ring.shape == RingShape::outline) {
                phase_ = corner_angle(ring);
                corner_ = 0;
                return;
            }
        if (w_.rings.empty()) return;
        const Station& middle = w_.rings[w_.rings.size() / 2];
        phase_ = angle_round(upright(middle), middle.x, middle.tangent.cross(middle.x));
    }

    /// What a tube without joints is turned by: the world's axes or, where a symmetry turns those, the way
    /// from its axis.
    Vec3 upright(const Station& ring) const {
        const Mat3& turn = w_.s.symmetry.generator;
        const Vec3 axis(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
        const Vec3 world = frame_about(ring.tangent).col(0);
        if (w_.s.symmetry.order < 3 || axis.isZero()) return world;
        Vec3 out = ring.centre - ring.centre.dot(axis) / axis.squaredNorm() * axis;
        out -= out.dot(ring.tangent) * ring.tangent;
        return out.norm() > 1e-6 * ring.half.x() ? out : world;
    }
    double column_angle(std::int32_t column) const { return phase_ + step_ * column; }
    /// Of two turns that are as near, the images of a path under a rotation take the same one.
    double nearest_turn(double wanted, double near, double period) const {
        const Automorphism& symmetry = w_.s.symmetry;
        const double hair = symmetry.order > 1 && symmetry.generator.determinant() > 0 ? 1e-6 : 0;
        return wanted + period * std::round((near - wanted) / period - hair);
    }

    /// Outlines are anchors: their corners stand at the corner columns, whichever quarter turn is nearest.
    void turn_to_corners() {
        anchors_.assign(1, {0, 0});
        for (std::size_t i = 0; i < w_.rings.size(); ++i) {
            Station& ring = w_.rings[i];
            if (ring.shape != RingShape::outline) continue;
            const double wanted = corner_angle(ring), turn = anchors_.back().second;
            if (corner_ < 0) {
                const auto column = std::lround((wanted - phase_ - turn) / step_);
                corner_ = static_cast<std::int32_t>(((column % w_.sides) + w_.sides) % w_.sides);
            }
            const double at = column_angle(corner_), nearest = nearest_turn(wanted - at, turn, M_PI / 2);
            const auto quarter = std::lround((at + nearest - wanted) / (M_PI / 2));
            ring.corner = static_cast<std::uint8_t>(((quarter % 4) + 4) % 4);
            anchors_.emplace_back(distance_[i], nearest);
        }
    }

    /// The cyclic shift with the least twist to the far joint's ring, or to the first ring of a closed path.
    void reach_far_end() {
        shift_ = 0;
        if (!w_.far.any() && !w_.closed) return;
        const double turn = anchors_.back().second;
        if (w_.closed) {  // the first ring again, as seen from the frame that was carried round
            far_phase_ = phase_ - angle_round(far_x_, first().x, first().tangent.cross(first().x));
            const double period = corner_ >= 0 && w_.sides % 4 == 0 ? M_PI / 2 : step_;
            const double reached = nearest_turn(far_phase_ - phase_, turn, period);
            set_shift(reached);
        } else {
            joint_angles(w_.far, far_tangent_, far_x_, far_angles_);
            far_phase_ = even_phase(far_angles_);
            double reached = nearest_turn(far_phase_ - phase_, turn, step_);
            if (is_box(w_.far) && corner_ >= 0) reached = turn_to_box_corner(turn);
            set_shift(reached);
        }
    }
    void set_shift(double reached) {
        const auto shift = std::lround((phase_ + reached - far_phase_) / step_);
        shift_ = static_cast<std::int32_t>(((shift % w_.sides) + w_.sides) % w_.sides);
        anchors_.emplace_back(length_, reached);
    }
    double turn_to_box_corner(double turn) const {
        double best = 1e300;
        const auto first_point = w_.points.first[w_.far.joint];
        const auto corners =
            static_cast<std::uint32_t>(w_.p.vertex_first[w_.far.joint + 1] - w_.p.vertex_first[w_.far.joint]);
        for (std::int32_t j = 0; j < w_.sides; ++j) {
            if (w_.far.ring[j] - first_point >= corners) continue;
            const double reached = nearest_turn(far_phase_ + step_ * (j - corner_) - phase_, turn, 2 * M_PI);
            if (std::abs(reached - turn) < std::abs(best - turn)) best = reached;
        }
        return best;
    }

    /// What twist there is, is spread evenly between the anchors.
    void spread_turns() {
        std::size_t next = 1;
        for (std::size_t i = 0; i < w_.rings.size(); ++i) {
            while (next < anchors_.size() && anchors_[next].first < distance_[i]) ++next;
            if (next == anchors_.size()) {
                w_.rings[i].turn = anchors_.back().second;
                continue;
            }
            const auto [d0, t0] = anchors_[next - 1];
            const auto [d1, t1] = anchors_[next];
            w_.rings[i].turn = d1 > d0 ? t0 + (t1 - t0) * (distance_[i] - d0) / (d1 - d0) : t1;
        }
        share_spacing();
    }
    /// The rings next to a joint have some of its ring's spacing left: all of it where they fill its cell,
    /// and so much that no column between them turns by more than a little.
    void share_spacing() {
        constexpr std::array<float, 2> roomy{0.45f, 0.15f}, crowded{1.0f, 0.3f};
        constexpr double turned = 0.2;  // radians
        const auto share = [&](bool full, double uneven, std::size_t i) {
            if (full) return crowded[i];
            const float a = static_cast<float>(1 - turned / std::max(uneven, turned));
            return std::max(roomy[i], i == 0 ? a : 0.3f * a);
        };
        const auto [near, far] = w_.out.crowded[w_.path];
        const double near_uneven = w_.near.any() ? most_uneven(near_angles_, phase_) : 0,
                     far_uneven = w_.far.any() ? most_uneven(far_angles_, far_phase_) : 0;
        for (std::size_t i = 0; i < std::min<std::size_t>(2, w_.rings.size()); ++i) {
            if (w_.near.any()) w_.rings[i].near_share = share(near, near_uneven, i);
            if (w_.far.any()) w_.rings[w_.rings.size() - 1 - i].far_share = share(far, far_uneven, i);
        }
        const float near_most = w_.near.any() ? most_share(near_angles_) : 1,
                    far_most = w_.far.any() ? most_share(far_angles_) : 1;
        for (Station& ring : w_.rings) {
            ring.near_share = std::min(ring.near_share, near_most);
            ring.far_share = std::min(ring.far_share, far_most);
        }
        for (Station& ring : w_.rings)
            if (const float sum = ring.near_share + ring.far_share; sum > 1) {
                ring.near_share /= sum;
                ring.far_share /= sum;
            }
    }

    /// How much of a joint's spacing a ring may keep so that no chord of it spans more than a right angle.
    float most_share(const std::vector<double>& angles) const {
        constexpr double widest_chord = 1.6;  // radians
        double widest = angles.front() + 2 * M_PI - angles.back();
        for (std::size_t k = 1; k < angles.size(); ++k) widest = std::max(widest, angles[k] - angles[k - 1]);
        const double limit = std::max(widest_chord, step_);
        return widest > limit ? static_cast<float>((limit - step_) / (widest - step_)) : 1;
    }

    /// How far a joint's points are from an even spacing.
    double most_uneven(const std::vector<double>& angles, double phase) const {
        double most = 0;
        for (std::int32_t k = 0; k < w_.sides; ++k)
            most = std::max(most, std::abs(angles[k] - (phase + step_ * k)));
        return most;
    }

    void write() {
        Stations& out = w_.out;
        out.far_shift[w_.path] = shift_;
        out.corner[w_.path] = corner_;
        const std::int32_t first = out.angle_first[w_.path];
        for (std::int32_t k = 0; k < w_.sides; ++k) out.angle[first + k] = column_angle(k);
        if (w_.near.any())
            for (std::int32_t k = 0; k < w_.sides; ++k)
                out.near_uneven[first + k] = near_angles_[k] - column_angle(k);
        if (!w_.far.any()) return;
        for (std::int32_t k = 0, j = shift_; k < w_.sides; ++k, ++j) {
            if (j == w_.sides) j = 0;
            out.far_uneven[first + k] = far_angles_[j] - (far_phase_ + step_ * j);
        }
    }

    PathWork& w_;
    double step_, phase_ = 0, far_phase_ = 0, length_ = 0;
    std::int32_t corner_ = -1, shift_ = 0;
    Vec3 near_tangent_, far_tangent_, near_x_, far_x_;
    std::vector<double>&distance_, &near_angles_, &far_angles_;
    std::vector<std::pair<double, double>>& anchors_;  // distance along the path, turn there
};

}  // namespace

void find_angles(PathWork& work) { AngleFinder(work).run(); }

}  // namespace sinew::sqm
