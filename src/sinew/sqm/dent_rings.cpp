#include "sinew/sqm/dent_rings.h"

#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/dents.h"
#include "sinew/sqm/path_frame.h"

namespace sinew::sqm {
namespace {

constexpr double straight_down = 0.8;  // of the way to the joint's centre: deeper walls do not lead there
constexpr double widest_floor = 0.7;   // of the way to a cell's border, where the groove goes on beyond it
constexpr double widest_rim = 0.93;    // the same, of a rim that leaves room for the surface beside it

/// One dent, at one end of a path.
class DentRings {
  public:
    DentRings(const Parts& parts, std::int32_t path, int end, Bridge& bridge)
        : d_(parts),
          n_(parts.network),
          path_(path),
          joint_(n_.path_end[path][end].joint),
          slot_(n_.slot_first[joint_] + n_.path_end[path][end].slot),
          pit_(parts.points.pits[parts.points.extra[slot_]]),
          centre_(parts.skeleton.position[n_.joint_node[joint_]]),
          out_(bridge) {
        joint_ring_of_path(parts, path, end, border_);
    }

    void place() {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[path_];
        const bool crowded = is_crowded();
        for (std::int32_t k = 0; crowded && k < sides; ++k) room_.push_back(room_towards(way_to(k)));
        for (std::int32_t i = s.first[path_]; i < s.first[path_ + 1]; ++i) {
            const Station& ring = s.stations[i];
            if (ring.shape != RingShape::pit) continue;
            Vec3f* at = &out_.mesh.positions[out_.path_vertex[path_] + (i - s.first[path_]) * sides];
            for (std::int32_t k = 0; k < sides; ++k)
                at[k] = (crowded ? on_way(k, ring.share) : on_wall(rim(ring, k), ring.share)).cast<float>();
        }
    }

  private:
    /// Whether other dents overlap this one, or others leave no room for its rim.
    bool is_crowded() const {
        for (std::int32_t other = n_.slot_first[joint_]; other < n_.slot_first[joint_ + 1]; ++other)
            if (other != slot_ && dents_overlap(d_.skeleton, n_, joint_, slot_, other)) return true;
        for (const std::uint32_t v : border_) {
            const Vec3 way = (d_.points.position[v] - centre_).normalized();
            const double lean = way.dot(pit_.z);
            if (lean <= 0) continue;
            const Vec3 over = (pit_.middle - centre_).dot(pit_.z) / lean * way + centre_ - pit_.middle;
            if (Vec2(over.dot(pit_.x) / pit_.half.x(), over.dot(pit_.y) / pit_.half.y()).norm() <
                1 / widest_rim)
                return true;
        }
        return false;
    }

    /// Column k on the rim, from the middle of the opening.
    Vec3 rim(const Station& ring, std::int32_t k) const {
        const double angle = d_.stations.angle[d_.stations.angle_first[path_] + k] + ring.turn;
        const auto [sine, cosine] = portable::sine_cosine(angle);
        const Vec3 ray = cosine * ring.x + sine * ring.tangent.cross(ring.x);
        return pit_.half.x() * ray.dot(pit_.x) * pit_.x + pit_.half.y() * ray.dot(pit_.y) * pit_.y;
    }
    double depth_of(const Vec3& ray) const { return exit_of_joint(n_, d_.points, joint_, centre_, ray); }
    double surface_of(const Vec3& ray) const { return exit_without_dents(n_, d_.points, joint_, ray); }

    /// A vertex on the wall, which is half an ellipsoid: from over it, on the joint's surface, towards the
    /// joint's centre, as the joint's own vertices are; or straight down where the dent goes past that.
    Vec3 on_wall(const Vec3& rim, double share) const {
        Vec3 over = pit_.middle + share * rim;
        for (int i = 0; i < 6; ++i) {  // the surface is nearly flat there: this settles fast
            const Vec3 ray = (over - centre_).normalized();
            over += (centre_ + surface_of(ray) * ray - over).dot(pit_.z) * pit_.z;
        }
        if (pit_.half.z() < straight_down * (pit_.middle - centre_).norm()) {
            const Vec3 ray = (over - centre_).normalized();
            return centre_ + press_dents(d_.points, joint_, centre_, ray, (over - centre_).norm()) * ray;
        }
        return over - pit_.half.z() * std::sqrt(std::max(0.0, 1 - share * share)) * pit_.z;
    }

    /// A vertex part of the way from the dent's axis to the border's vertex of its column. Where the rim
    /// turns down into a groove, subdivision pulls it in from two sides: there it stands a bit outside.
    Vec3 on_way(std::int32_t k, double share) const {
        const auto columns = static_cast<std::int32_t>(border_.size());
        const double room = room_[k];
        const bool on_rim = share == 1 && room < 1;
        const bool turns = room_[(k + 1) % columns] == 1 || room_[(k + columns - 1) % columns] == 1;
        const double widest = room == 1 ? widest_floor : on_rim && turns ? room + 0.25 * (1 - room) : room;
        const Vec3 ray = ray_towards(way_to(k), share * widest);
        return centre_ + (on_rim ? surface_of(ray) : depth_of(ray)) * ray;
    }
    Vec3 way_to(std::int32_t k) const { return (d_.points.position[border_[k]] - centre_).normalized(); }
    Vec3 ray_towards(const Vec3& to, double share) const {
        const GreatCircle way(pit_.z, to);
        return way.sine > 1e-9 ? way.at(share) : pit_.z;
    }
    /// How much of the way to a direction the groove goes: 1 where it goes on beyond that.
    double room_towards(const Vec3& to) const {
        constexpr int steps = 40, halvings = 24;
        const auto in_dent = [&](double share) {
            const Vec3 ray = ray_towards(to, share);
            return depth_of(ray) < (1 - 1e-9) * surface_of(ray);
        };
        int step = 1;
        while (step <= steps && in_dent(double(step) / steps)) ++step;
        if (step > steps) return 1;
        double inside = double(step - 1) / steps, outside = double(step) / steps;
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (inside + outside);
            (in_dent(middle) ? inside : outside) = middle;
        }
        return inside;
    }

    const Parts& d_;
    const Network& n_;
    std::int32_t path_, joint_, slot_;
    const PitShape& pit_;
    const Vec3 centre_;
    std::vector<std::uint32_t> border_;  ///< the joint's vertex that each column ends in
    std::vector<double> room_;           ///< of each column, where dents are crowded
    Bridge& out_;
};

}  // namespace

void place_dent_rings(const Parts& parts, std::int32_t path, Bridge& bridge) {
    for (int end = 0; end < 2; ++end) {
        const PathEnd& e = parts.network.path_end[path][end];
        if (!e.at_joint()) continue;
        const std::int32_t slot = parts.network.slot_first[e.joint] + e.slot;
        if (parts.points.kind[slot] == SlotKind::pit) DentRings(parts, path, end, bridge).place();
    }
}

Vec3 bottom_of_dent(const Parts& parts, const PathEnd& joint) {
    const Vec3& centre = parts.skeleton.position[parts.network.joint_node[joint.joint]];
    const std::int32_t slot = parts.network.slot_first[joint.joint] + joint.slot;
    const PitShape& pit = parts.points.pits[parts.points.extra[slot]];
    const Vec3 bottom = pit.middle - pit.half.z() * pit.z;
    const double distance = (bottom - centre).norm();
    if (distance <= 0 || (bottom - centre).dot(pit.z) < 0) return bottom;
    const Vec3 ray = (bottom - centre) / distance;
    return centre + press_dents(parts.points, joint.joint, centre, ray, distance) * ray;
}

}  // namespace sinew::sqm
