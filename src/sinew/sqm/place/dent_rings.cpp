#include "sinew/sqm/place/dent_rings.h"

#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/rings/path_frame.h"
#include "sinew/sqm/surface/dents.h"
#include "sinew/sqm/surface/joint_reach.h"

namespace sinew::sqm {
namespace {

/// Depth, of the middle's distance from the joint's centre, from which a dent's vertices are placed straight
/// below its opening: the floor of a deeper one is so near to the centre that rays from there meet its wall
/// nearly along it, and vertices on them would gather at the bottom.
constexpr double deep = 0.8;
/// Where a column ends in a groove, its widest vertex is on the floor, this far from the dent's axis (0) to
/// the cell's border (1), if there is no rim beside it to tell: beyond the border the groove goes on into the
/// next cell, whose columns do the same from the other side.
constexpr double on_floor = 0.6;
/// How far the line of such vertices follows the rim's vertices beside it away from the border: at 1 it would
/// join them straight, at 0 lie on the border.
constexpr double bulge = 0.4;
/// Of the part of a rim that lies in a cell. The length of a half circle of so many chords is wrong by
/// (pi / 48)^2 / 24 = 0.02 %.
constexpr int rim_samples = 48;
constexpr int surface_steps = 6;  // to find the surface over an opening, see on_wall

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
        if (crowded) find_widest();
        for (std::int32_t i = s.first[path_]; i < s.first[path_ + 1]; ++i) {
            const Station& ring = s.stations[i];
            if (ring.shape != RingShape::pit) continue;
            Vec3f* at = &out_.mesh.positions[first_of_ring(d_, out_, path_, i)];
            for (std::int32_t k = 0; k < sides; ++k)
                at[k] =
                    (crowded ? in_column(k, ring.share) : on_wall(rim(ring, k), ring.share)).cast<float>();
        }
    }

  private:
    /// Whether other dents overlap this one, or others leave no room for its rim.
    bool is_crowded() const {
        if (merges(d_.surfaces, joint_, slot_)) return true;
        for (const std::uint32_t v : border_) {
            const Vec3 ray = (d_.points.position[v] - centre_).normalized();
            const double lean = ray.dot(pit_.z);
            if (lean <= 0) continue;
            const Vec3 over = (pit_.middle - centre_).dot(pit_.z) / lean * ray + centre_ - pit_.middle;
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
        // On a ball each step leaves of the error the square of the sine at which the place is seen from the
        // dent's axis: at 30 degrees a quarter.
        for (int i = 0; i < surface_steps; ++i) {
            const Vec3 ray = (over - centre_).normalized();
            over += (centre_ + surface_of(ray) * ray - over).dot(pit_.z) * pit_.z;
        }
        if (pit_.half.z() < deep * (pit_.middle - centre_).norm()) {
            const Vec3 ray = (over - centre_).normalized();
            return centre_ + press_dents(d_.surfaces, joint_, centre_, ray, (over - centre_).norm()) * ray;
        }
        return over - pit_.half.z() * std::sqrt(std::max(0.0, 1 - share * share)) * pit_.z;
    }

    /// A vertex between the dent's axis and the widest of its column, which is on the surface itself if the
    /// column ends outside of the groove.
    Vec3 in_column(std::int32_t k, double share) const {
        const Vec3 ray = ray_towards(widest_[k], share);
        return centre_ + (share == 1 && !inside_[k] ? surface_of(ray) : depth_of(ray)) * ray;
    }
    Vec3 ray_to_border(std::int32_t k) const {
        return (d_.points.position[border_[k]] - centre_).normalized();
    }
    /// Between the dent's axis, 0, and a ray, 1.
    Vec3 ray_towards(const Vec3& to, double share) const {
        const GreatCircle arc(pit_.z, to);
        return arc.sine > 1e-9 ? arc.at(share) : pit_.z;
    }
    double angle_to(const Vec3& ray) const {
        return portable::angle_of(pit_.z.cross(ray).norm(), pit_.z.dot(ray));
    }

    Vec3 rim_at(double azimuth) const {
        const auto [sine, cosine] = portable::sine_cosine(azimuth);
        return rim_towards(n_, d_.surfaces, joint_, pit_, centre_, cosine * pit_.x + sine * pit_.y);
    }

    /// Neighbouring columns that all end in the groove, or all outside of it.
    struct Run {
        std::int32_t begin, count;  ///< it may go on from the last column to the first
        bool inside;
    };
    std::int32_t columns() const { return static_cast<std::int32_t>(border_.size()); }
    std::int32_t wrapped(std::int32_t k) const { return k % columns(); }

    /// All runs, beginning with one outside; none if all columns are alike.
    std::vector<Run> find_runs() const {
        std::int32_t first = -1;
        for (std::int32_t k = 0; k < columns(); ++k)
            if (!inside_[k] && inside_[wrapped(k + columns() - 1)]) first = k;
        std::vector<Run> runs;
        for (std::int32_t k = first; first >= 0 && k < first + columns(); k += runs.back().count) {
            Run run{k, 1, inside_[wrapped(k)] != 0};
            while (inside_[wrapped(k + run.count)] == inside_[wrapped(k)]) ++run.count;
            runs.push_back(run);
        }
        return runs;
    }

    /// Columns that end outside of the groove are spread evenly along the part of its rim that lies in the
    /// cell, so that edges go all along the rim. Between two such runs the others cross it, as the arc does
    /// that they end in.
    void find_widest() {
        inside_.resize(columns()), widest_.resize(columns());
        for (std::int32_t k = 0; k < columns(); ++k)
            inside_[k] = in_dent(n_, d_.surfaces, joint_, centre_, d_.points.position[border_[k]]);
        const std::vector<Run> runs = find_runs();
        for (const Run& run : runs)
            if (!run.inside) along_rim(run);
        for (const Run& run : runs)
            if (run.inside) across_groove(run);
        if (!runs.empty()) return;
        for (std::int32_t k = 0; k < columns(); ++k)
            widest_[k] = inside_[k] ? ray_towards(ray_to_border(k), on_floor) : rim_of(k);
    }
    /// The rim towards the place where a column ends, with room for the surface beyond it.
    Vec3 rim_of(std::int32_t k) const {
        const Vec3 to = ray_to_border(k), rim = rim_towards(n_, d_.surfaces, joint_, pit_, centre_, to);
        return angle_to(rim) < widest_rim * angle_to(to) ? rim : ray_towards(to, widest_rim);
    }
    void along_rim(const Run& run) {
        if (run.count == 1) {
            widest_[wrapped(run.begin)] = rim_of(wrapped(run.begin));
            return;
        }
        const auto azimuth = [&](std::int32_t k) {
            return angle_round(ray_to_border(wrapped(k)), pit_.x, pit_.y);
        };
        const double from = azimuth(run.begin);
        double turn = 0;
        for (std::int32_t k = run.begin + 1; k < run.begin + run.count; ++k)
            turn += std::remainder(azimuth(k) - azimuth(k - 1), 2 * M_PI);
        std::vector<Vec3> rim(rim_samples + 1);
        std::vector<double> length(rim_samples + 1, 0.0);
        for (int i = 0; i <= rim_samples; ++i) {
            rim[i] = rim_at(from + turn * i / rim_samples);
            rim[i] *= surface_of(rim[i]);
            if (i > 0) length[i] = length[i - 1] + (rim[i] - rim[i - 1]).norm();
        }
        int at = 1;
        for (std::int32_t k = 0; k < run.count; ++k) {
            const double wanted = length.back() * (k + 1) / (run.count + 1);
            while (at < rim_samples && length[at] < wanted) ++at;
            const double share = (wanted - length[at - 1]) / (length[at] - length[at - 1]);
            widest_[wrapped(run.begin + k)] = rim_at(from + turn * (at - 1 + share) / rim_samples);
        }
    }
    /// From the rim's vertex before the run to that after it, along the border of the cell: how far both are
    /// from the border fades from the one to the other.
    void across_groove(const Run& run) {
        const std::int32_t before = wrapped(run.begin + columns() - 1),
                           after = wrapped(run.begin + run.count);
        const Vec3 from = bulge * (widest_[before] - ray_to_border(before)),
                   to = bulge * (widest_[after] - ray_to_border(after));
        for (std::int32_t i = 0; i < run.count; ++i) {
            const std::int32_t k = wrapped(run.begin + i);
            const double share = double(i + 1) / (run.count + 1);
            widest_[k] = (ray_to_border(k) + from + share * (to - from)).normalized();
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
    std::vector<Vec3> widest_;  ///< column -> the ray to its widest vertex
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
