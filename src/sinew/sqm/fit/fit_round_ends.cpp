#include "sinew/sqm/fit/fit_round_ends.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sinew/sqm/fit/round_end.h"

namespace sinew::sqm {
namespace {

class RoundEnds {
  public:
    RoundEnds(const Parts& parts, const Bridge& bridge, std::int32_t path, std::span<Vec3> points)
        : d_(parts), b_(bridge), points_(points), path_(path) {}

    std::array<bool, 2> run(double held) {
        RoundEnd ends[2] = {find(0), find(1)};
        const bool meet = ends[0].rings() > 0 && ends[1].rings() > 0 &&
                          ring_count() - ends[0].rings() - ends[1].rings() < 2;
        for (int pass = 0; pass < (meet ? 4 : 1); ++pass)
            for (int side = 0; side < 2; ++side) {
                const std::vector<ProfileRow> before = ends[side].fitted;
                fit(side, ends[side], ends[1 - side]);
                if (pass > 0) meet_halfway(before, ends[side].fitted);
            }
        for (int side = 0; side < 2; ++side)
            if (ends[side].rings() > 0) move(side, held, ends[side]);
        return {ends[0].rings() > 0, ends[1].rings() > 0};
    }

  private:
    /// The ring that is i-th from an end of a path.
    const Station& ring_from(int side, std::int32_t i) const {
        const Stations& s = d_.stations;
        return s.stations[side == 0 ? s.first[path_] + i : s.first[path_ + 1] - 1 - i];
    }
    std::int32_t ring_count() const { return d_.stations.first[path_ + 1] - d_.stations.first[path_]; }

    /// A round end of a path: where it stands, and its profile as placed and as fitted.
    struct RoundEnd {
        Vec3 centre, outward;
        double radius = 1, width = 1;  // the radius, and the half extent that stands for it in a ring
        double sine = 0;               // of the cone's slope, see fit_round_end
        std::vector<ProfileRow> placed, fitted;  // the pole first; empty if the end is not round
        std::int32_t rings() const { return static_cast<std::int32_t>(placed.size()) - 1; }
    };
    RoundEnd find(int side) const {
        RoundEnd end;
        const Plain& s = d_.skeleton;
        const auto nodes = d_.network.nodes(path_);
        const std::int32_t leaf = side == 0 ? nodes.front() : nodes.back();
        if (b_.path_pole[path_][side] == no_vertex || s.cap[leaf] != Cap::round) return end;
        std::int32_t rings = 0;
        while (rings < ring_count() && ring_from(side, rings).fit == RingFit::cap &&
               ring_from(side, rings).node == leaf)
            ++rings;
        if (rings == 0) return end;
        const std::int32_t other = side == 0 ? nodes[1] : nodes[nodes.size() - 2];
        const Vec3 along = s.position[leaf] - s.position[other];
        end.centre = s.position[leaf];
        end.outward = along.normalized();
        const auto width = [&](std::int32_t node) {
            return s.form(node) ? s.form(node)->half.x() : s.radius[node];
        };
        end.radius = s.radius[leaf];
        end.width = width(leaf);
        const double narrowing = (width(other) / end.width - 1) * end.radius / along.norm();
        if (along.norm() > 0) end.sine = std::clamp(narrowing, -0.9, 0.9);
        end.placed.push_back({1, 0});
        for (std::int32_t i = 0; i < rings; ++i)
            end.placed.push_back(row_of(end, ring_from(side, i).centre, ring_from(side, i).half.x()));
        end.fitted = end.placed;
        return end;
    }
    static ProfileRow row_of(const RoundEnd& end, const Vec3& centre, double half) {
        return {(centre - end.centre).dot(end.outward) / end.radius, half / end.width};
    }

    /// The first two rings below a round end; some of them may be those of the other end, and where there is
    /// none the cone goes on.
    void fit(int side, RoundEnd& end, const RoundEnd& other) const {
        const std::int32_t rings = end.rings(), count = ring_count();
        if (rings < 1 || rings > static_cast<std::int32_t>(most_round_rings)) return;
        ProfileRow below[2];
        for (std::int32_t i = 0; i < 2; ++i) {
            const ProfileRow& above = i == 0 ? end.placed[rings] : below[0];
            below[i] = {above.height - std::sqrt(1 - end.sine * end.sine), above.radius + end.sine};
            if (rings + i >= count) continue;
            const Station& ring = ring_from(side, rings + i);
            const std::int32_t in_other = count - (rings + i);  // counted from the other pole
            if (in_other <= other.rings()) {
                const ProfileRow& row = other.fitted[in_other];
                below[i] = row_of(end, other.centre + row.height * other.radius * other.outward,
                                  row.radius * other.width);
            } else if (ring.shape == RingShape::circle || ring.shape == RingShape::node) {
                below[i] = row_of(end, ring.centre, ring.half.x());
            }
        }
        end.fitted = end.placed;
        fit_round_end(end.sine, end.fitted, below);
    }

    /// Ends that meet would else overshoot each other in turn.
    static void meet_halfway(const std::vector<ProfileRow>& before, std::vector<ProfileRow>& fitted) {
        for (std::size_t i = 0; i < fitted.size(); ++i)
            fitted[i] = {(before[i].height + fitted[i].height) / 2,
                         (before[i].radius + fitted[i].radius) / 2};
    }
    void move(int side, double held, const RoundEnd& end) {
        const std::int32_t sides = d_.refinement.path_sides[path_];
        const auto put = [&](std::uint32_t vertex, std::int32_t i) {
            const ProfileRow &from = end.placed[i], &to = end.fitted[i];
            const Vec3 height = end.radius * end.outward, middle = end.centre + from.height * height;
            const double wider = i == 0 ? 1 : from.radius > 0 ? held * to.radius / from.radius : held;
            points_[vertex] =
                middle + (to.height - from.height) * height + wider * (points_[vertex] - middle);
        };
        const std::uint32_t pole = b_.path_pole[path_][side];
        put(pole, 0);
        for (std::int32_t i = 0; i < end.rings(); ++i) {
            const std::int32_t ring = side == 0 ? i : ring_count() - 1 - i;
            for (std::int32_t k = 0; k < sides; ++k) put(b_.path_vertex[path_] + ring * sides + k, i + 1);
        }
    }

    const Parts& d_;
    const Bridge& b_;
    std::span<Vec3> points_;
    std::int32_t path_;
};

}  // namespace

std::array<bool, 2> fit_round_ends(const Parts& parts, const Bridge& bridge, std::int32_t path, double held,
                                   std::span<Vec3> points) {
    return RoundEnds(parts, bridge, path, points).run(held);
}

}  // namespace sinew::sqm
