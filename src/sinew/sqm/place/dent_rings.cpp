#include "sinew/sqm/place/dent_rings.h"

#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/rings/path_frame.h"
#include "sinew/sqm/surface/dents.h"
#include "sinew/sqm/surface/joint_reach.h"

namespace sinew::sqm {
namespace {

constexpr double straight_down = 0.8;  // of the way to the joint's centre: deeper walls do not lead there
constexpr double halfway = 0.6;        // of the way to a cell's border, where the groove goes on beyond it
constexpr double nearest_way = 0.3;    // the same, at least
constexpr double bulge = 0.4;          // of the way from there back to the rim's vertices beside it
constexpr int rim_samples = 48;        // of the part of a rim that lies in a cell

/// One dent, at one end of a path.
class DentRings {
  public:
    DentRings(const Parts& parts, std::int32_t path, int end, Bridge& bridge)
        : d_(parts),
          n_(parts.network),
          path_(path),
          joint_(n_.path_end[path][end].joint),
          slot_(n_.slot_first[joint_] + n_.path_end[path][end].slot),
          pit_(parts.surfaces.pits[parts.surfaces.extra[slot_]]),
          centre_(parts.skeleton.position[n_.joint_node[joint_]]),
          out_(bridge) {
        joint_ring_of_path(parts, path, end, border_);
    }

    void place() {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[path_];
        const bool crowded = is_crowded();
        if (crowded) find_ways();
        for (std::int32_t i = s.first[path_]; i < s.first[path_ + 1]; ++i) {
            const Station& ring = s.stations[i];
            if (ring.shape != RingShape::pit) continue;
            Vec3f* at = &out_.mesh.positions[first_of_ring(d_, out_, path_, i)];
            for (std::int32_t k = 0; k < sides; ++k)
                at[k] = (crowded ? on_way(k, ring.share) : on_wall(rim(ring, k), ring.share)).cast<float>();
        }
    }

  private:
    /// Whether other dents overlap this one, or others leave no room for its rim.
    bool is_crowded() const {
        if (merges(d_.surfaces, joint_, slot_)) return true;
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
    double depth_of(const Vec3& ray) const { return exit_of_joint(n_, d_.surfaces, joint_, centre_, ray); }
    double surface_of(const Vec3& ray) const { return exit_without_dents(n_, d_.surfaces, joint_, ray); }

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
            return centre_ + press_dents(d_.surfaces, joint_, centre_, ray, (over - centre_).norm()) * ray;
        }
        return over - pit_.half.z() * std::sqrt(std::max(0.0, 1 - share * share)) * pit_.z;
    }

    /// A vertex part of the way from the dent's axis to the widest of its column.
    Vec3 on_way(std::int32_t k, double share) const {
        const Vec3 ray = ray_towards(way_[k], share);
        return centre_ + (share == 1 && !inside_[k] ? surface_of(ray) : depth_of(ray)) * ray;
    }
    Vec3 way_to(std::int32_t k) const { return (d_.points.position[border_[k]] - centre_).normalized(); }
    Vec3 ray_towards(const Vec3& to, double share) const {
        const GreatCircle way(pit_.z, to);
        return way.sine > 1e-9 ? way.at(share) : pit_.z;
    }
    double angle_to(const Vec3& ray) const {
        return portable::angle_of(pit_.z.cross(ray).norm(), pit_.z.dot(ray));
    }

    Vec3 rim_at(double azimuth) const {
        const auto [sine, cosine] = portable::sine_cosine(azimuth);
        return rim_towards(n_, d_.surfaces, joint_, pit_, centre_, cosine * pit_.x + sine * pit_.y);
    }

    /// Columns that end outside of the groove are spread evenly along the part of its rim that lies in the
    /// cell, so that edges go all along the rim. Between two such runs the others cross it, as the arc does
    /// that they end in.
    void find_ways() {
        const auto columns = static_cast<std::int32_t>(border_.size());
        inside_.resize(columns), way_.resize(columns);
        std::int32_t first = -1;  // of a run that ends outside
        for (std::int32_t k = 0; k < columns; ++k)
            inside_[k] = in_dent(n_, d_.surfaces, joint_, centre_, d_.points.position[border_[k]]);
        for (std::int32_t k = 0; k < columns; ++k)
            if (!inside_[k] && inside_[(k + columns - 1) % columns]) first = k;
        if (first < 0) {
            for (std::int32_t k = 0; k < columns; ++k)
                way_[k] = inside_[k] ? ray_towards(way_to(k), halfway) : rim_of(k);
            return;
        }
        const auto for_runs = [&](bool inside, auto visit) {
            for (std::int32_t k = first; k < first + columns;) {
                std::int32_t count = 1;
                while (inside_[(k + count) % columns] == inside_[k % columns]) ++count;
                if ((inside_[k % columns] != 0) == inside) visit(k, count);
                k += count;
            }
        };
        for_runs(false, [&](std::int32_t begin, std::int32_t count) { along_rim(begin, count); });
        for_runs(true, [&](std::int32_t begin, std::int32_t count) { across_groove(begin, count); });
    }
    /// The rim on the way to the border, with room for the surface beyond it.
    Vec3 rim_of(std::int32_t k) const {
        const Vec3 to = way_to(k), rim = rim_towards(n_, d_.surfaces, joint_, pit_, centre_, to);
        return angle_to(rim) < widest_rim * angle_to(to) ? rim : ray_towards(to, widest_rim);
    }
    void along_rim(std::int32_t begin, std::int32_t count) {
        const auto columns = static_cast<std::int32_t>(border_.size());
        if (count == 1) {
            way_[begin % columns] = rim_of(begin % columns);
            return;
        }
        const auto azimuth = [&](std::int32_t k) { return angle_round(way_to(k % columns), pit_.x, pit_.y); };
        const double from = azimuth(begin);
        double turn = 0;
        for (std::int32_t k = begin + 1; k < begin + count; ++k)
            turn += std::remainder(azimuth(k) - azimuth(k - 1), 2 * M_PI);
        std::vector<Vec3> rim(rim_samples + 1);
        std::vector<double> length(rim_samples + 1, 0.0);
        for (int i = 0; i <= rim_samples; ++i) {
            rim[i] = rim_at(from + turn * i / rim_samples);
            rim[i] *= surface_of(rim[i]);
            if (i > 0) length[i] = length[i - 1] + (rim[i] - rim[i - 1]).norm();
        }
        int at = 1;
        for (std::int32_t k = 0; k < count; ++k) {
            const double wanted = length.back() * (k + 1) / (count + 1);
            while (at < rim_samples && length[at] < wanted) ++at;
            const double share = (wanted - length[at - 1]) / (length[at] - length[at - 1]);
            way_[(begin + k) % columns] = rim_at(from + turn * (at - 1 + share) / rim_samples);
        }
    }
    void across_groove(std::int32_t begin, std::int32_t count) {
        const auto columns = static_cast<std::int32_t>(border_.size());
        const std::int32_t before = (begin + columns - 1) % columns, after = (begin + count) % columns;
        const Vec3 from = bulge * (way_[before] - way_to(before)), to = bulge * (way_[after] - way_to(after));
        for (std::int32_t i = 0; i < count; ++i) {
            const std::int32_t k = (begin + i) % columns;
            const double share = double(i + 1) / (count + 1);
            const Vec3 border = way_to(k), way = (border + from + share * (to - from)).normalized();
            const double part = angle_to(way) / angle_to(border);
            const bool fits = way.dot(border) > pit_.z.dot(border) && part > nearest_way && part < 1;
            way_[k] = fits ? way : ray_towards(border, halfway);
        }
    }

    const Parts& d_;
    const Network& n_;
    std::int32_t path_, joint_, slot_;
    const PitShape& pit_;
    const Vec3 centre_;
    std::vector<std::uint32_t> border_;  ///< the joint's vertex that each column ends in
    // Where dents are crowded:
    std::vector<char> inside_;  ///< column -> whether it ends in the groove
    std::vector<Vec3> way_;     ///< column -> the ray to its widest vertex
    Bridge& out_;
};

}  // namespace

void place_dent_rings(const Parts& parts, std::int32_t path, Bridge& bridge) {
    for (int end = 0; end < 2; ++end) {
        const PathEnd& e = parts.network.path_end[path][end];
        if (!e.at_joint()) continue;
        const std::int32_t slot = parts.network.slot_first[e.joint] + e.slot;
        if (parts.surfaces.kind[slot] == SlotKind::pit) DentRings(parts, path, end, bridge).place();
    }
}

Vec3 bottom_of_dent(const Parts& parts, const PathEnd& joint) {
    const Vec3& centre = parts.skeleton.position[parts.network.joint_node[joint.joint]];
    const std::int32_t slot = parts.network.slot_first[joint.joint] + joint.slot;
    const PitShape& pit = parts.surfaces.pits[parts.surfaces.extra[slot]];
    const Vec3 bottom = pit.middle - pit.half.z() * pit.z;
    const double distance = (bottom - centre).norm();
    if (distance <= 0 || (bottom - centre).dot(pit.z) < 0) return bottom;
    const Vec3 ray = (bottom - centre) / distance;
    return centre + press_dents(parts.surfaces, joint.joint, centre, ray, distance) * ray;
}

}  // namespace sinew::sqm
