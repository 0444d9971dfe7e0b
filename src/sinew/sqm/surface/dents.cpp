#include "sinew/sqm/surface/dents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sinew/base/portable_math.h"
#include "sinew/extend/frames.h"
#include "sinew/sqm/surface/bisect.h"

namespace sinew::sqm {
namespace {

/// How near to the joint's centre a floor may come, of the surface's distance there. At the centre itself a
/// vertex would have no direction from it, by which joints are kept from folding.
constexpr double nearest_to_centre = 0.02;
/// What lies less deep, of the surface's distance, is on the surface. Places are those of vertices too, which
/// single precision rounds to 6e-8: this is a hundred times as much.
constexpr double least_dent = 1e-5;
/// How far from a wall, of the dent's size, is still on it: least_dent again, of a dent a hundredth as wide
/// as its joint.
constexpr double touching = 1e-3;
/// The overlap of two dents from which their groove is whole, of the smaller of their half widths. Nothing
/// asks for just this much; without it a groove would appear at once when a dent is moved.
constexpr double whole_groove = 0.2;
/// Between the dents that a groove is made of, of the narrower one's half width w: the scallops between two
/// of them stand 1 - sqrt(1 - 0.05^2) = 0.0013 w out of the wall.
constexpr double groove_step = 0.1;
/// In such steps: dents of one width w that overlap are less than 2 w apart.
constexpr int longest_groove = 20;

/// Pairs of dents of one joint that may become grooves. More of them leave nothing of the surface between
/// that a groove would be seen in, and cost the square of their number at every place that is asked about.
constexpr std::size_t most_grooves = 128;

/// Whether a place at this distance from the joint's centre is below its surface: in a dent.
bool is_sunk(double distance, double surface) { return distance < (1 - least_dent) * surface; }

/// @param leaf  the node above the dent
PitShape pit_of(const Plain& s, const Vec3& centre, std::int32_t leaf) {
    const Form& form = *s.form(leaf);
    const double distance = (s.position[leaf] - centre).norm();
    const Vec3 z = (s.position[leaf] - centre) / distance;
    const Frame frame = turn_frame({form.x, form.y, form.z.dot(z) < 0 ? Vec3(-form.z) : form.z}, z);
    return {centre + (distance - s.pit_depth[leaf]) * z,
            frame.x,
            z.cross(frame.x),
            z,
            {form.half.x(), form.half.y(), s.pit_depth[leaf]}};
}

/// The half extent of a dent in a unit direction: from its middle to the border of the ellipsoid.
double half_extent(const PitShape& pit, const Vec3& direction) { return 1 / pit.local(direction).norm(); }

/// How much of a groove two dents make: 0 if they do not overlap, 1 if it is whole.
double overlap(const PitShape& a, const PitShape& b) {
    const Vec3 between = b.middle - a.middle;
    const double distance = between.norm();
    if (!(distance > 0)) return 0;
    const double of_a = half_extent(a, between / distance), of_b = half_extent(b, between / distance);
    const double part = (of_a + of_b - distance) / (whole_groove * std::min(of_a, of_b));
    return std::clamp(part, 0.0, 1.0);
}

/// The same dent with its x and y turned by quarters until they lie as near as may be to those of another.
PitShape aligned(const PitShape& pit, const PitShape& to) {
    PitShape turned = pit;
    if (std::abs(pit.y.dot(to.x)) > std::abs(pit.x.dot(to.x)) + 1e-9) {
        turned.x = pit.y, turned.y = -pit.x;
        std::swap(turned.half.x(), turned.half.y());
    }
    if (turned.x.dot(to.x) < 0) turned.x = -turned.x, turned.y = -turned.y;
    return turned;
}

/// One of the dents of a groove, on the surface between the two that overlap.
/// @param share  where it is between both, 0 at a and 1 at b
/// @param whole  how much of a groove they make: a groove that is not whole narrows towards its middle, by a
///               parabola, to that part of its width and depth
PitShape between(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
                 const PitShape& a, const PitShape& b, double share, double whole) {
    const Vec3 out = a.middle + share * (b.middle - a.middle) - centre;
    PitShape pit;
    pit.z = out.norm() > 0 ? Vec3(out.normalized()) : a.z;
    pit.middle = centre + exit_without_dents(n, surfaces, joint, pit.z) * pit.z;
    const Vec3 x = a.x + share * (b.x - a.x);
    pit.x = (x - x.dot(pit.z) * pit.z).normalized();
    pit.y = pit.z.cross(pit.x);
    const double narrowed = 1 - (1 - whole) * 4 * share * (1 - share);
    pit.half = narrowed * (a.half + share * (b.half - a.half));
    return pit;
}

void add_groove(const Network& n, JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre, PitShape a,
                PitShape b) {
    const double whole = overlap(a, b);
    if (whole == 0) return;
    b = aligned(b, a);
    const double narrow = std::min(a.half.head<2>().minCoeff(), b.half.head<2>().minCoeff());
    const double distance = (b.middle - a.middle).norm();
    const int steps =
        std::clamp(static_cast<int>(std::lround(distance / (groove_step * narrow))), 2, longest_groove);
    for (int i = 1; i < steps; ++i)
        surfaces.pits.push_back(between(n, surfaces, joint, centre, a, b, double(i) / steps, whole));
}

/// The pairs of dents, of those from `first` to before `end`, that overlap; none if they are too many.
std::vector<std::array<std::int32_t, 2>> overlapping(const JointSurfaces& surfaces, std::int32_t first,
                                                     std::int32_t end) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (std::int32_t a = first; a < end; ++a)
        for (std::int32_t b = a + 1; b < end; ++b) {
            if (overlap(surfaces.pits[a], surfaces.pits[b]) == 0) continue;
            if (pairs.size() == most_grooves) return {};
            pairs.push_back({a, b});
        }
    return pairs;
}

}  // namespace

bool dents_overlap(const JointSurfaces& surfaces, std::int32_t slot, std::int32_t other) {
    if (surfaces.kind[slot] != SlotKind::pit || surfaces.kind[other] != SlotKind::pit) return false;
    return overlap(surfaces.pits[surfaces.extra[slot]], surfaces.pits[surfaces.extra[other]]) > 0;
}

bool merges(const JointSurfaces& surfaces, std::int32_t joint, std::int32_t slot) {
    const std::int32_t own = surfaces.extra[slot];
    for (std::int32_t other = surfaces.pit_first[joint]; other < surfaces.groove_first[joint]; ++other)
        if (other != own && overlap(surfaces.pits[own], surfaces.pits[other]) > 0) return true;
    return false;
}

void find_dents(const Plain& s, const Network& n, JointSurfaces& surfaces) {
    surfaces.pit_first.assign(n.joint_count() + 1, 0);
    surfaces.groove_first.assign(n.joint_count(), 0);
    for (std::int32_t j = 0; j < n.joint_count(); ++j) {
        const Vec3& centre = s.position[n.joint_node[j]];
        const auto first = surfaces.pit_first[j] = static_cast<std::int32_t>(surfaces.pits.size());
        for (std::int32_t slot = n.slot_first[j]; slot < n.slot_first[j + 1]; ++slot)
            if (surfaces.kind[slot] == SlotKind::pit) {
                surfaces.extra[slot] = static_cast<std::int32_t>(surfaces.pits.size());
                surfaces.pits.push_back(pit_of(s, centre, n.next_node(slot)));
            }
        const auto own = surfaces.groove_first[j] = static_cast<std::int32_t>(surfaces.pits.size());
        for (const auto& [a, b] : overlapping(surfaces, first, own))
            add_groove(n, surfaces, j, centre, surfaces.pits[a], surfaces.pits[b]);
    }
    surfaces.pit_first.back() = static_cast<std::int32_t>(surfaces.pits.size());
}

bool has_dents(const JointSurfaces& surfaces, std::int32_t joint) {
    return !surfaces.pits.empty() && surfaces.pit_first[joint] < surfaces.pit_first[joint + 1];
}

bool has_groove(const JointSurfaces& surfaces, std::int32_t joint) {
    return !surfaces.pits.empty() && surfaces.groove_first[joint] < surfaces.pit_first[joint + 1];
}

double press_dents(const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre, const Vec3& ray,
                   double distance) {
    if (surfaces.pits.empty()) return distance;
    const double least = nearest_to_centre * distance;
    const std::int32_t first = surfaces.pit_first[joint], end = surfaces.pit_first[joint + 1];
    bool moved = true;
    // Until no order of the dents would take away more. A ray leaves each dent, which is convex, but once: so
    // there are no more rounds than dents.
    for (std::int32_t round = first; moved && round < end; ++round) {
        moved = false;
        for (std::int32_t i = first; i < end; ++i) {
            const double pressed = surfaces.pits[i].press(centre, ray, distance);
            moved = moved || pressed < distance;
            distance = pressed;
        }
    }
    return std::max(distance, least);
}

bool in_dent(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
             const Vec3& place) {
    const double distance = (place - centre).norm();
    return is_sunk(distance, exit_without_dents(n, surfaces, joint, (place - centre) / distance));
}

bool leads_into_dent(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
                     const Vec3& ray) {
    const double surface = exit_without_dents(n, surfaces, joint, ray);
    return is_sunk(press_dents(surfaces, joint, centre, ray, surface), surface);
}

Vec3 rim_towards(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const PitShape& pit,
                 const Vec3& centre, const Vec3& ray) {
    constexpr double behind = 3;  // radians: nearly opposite to the dent, where `side` leads nowhere any more
    constexpr int halvings = 30;  // of a step: to 1e-9 of it
    constexpr int steps_a_dent = 4;  // of the angle that the narrowest half width is seen at
    constexpr int most_steps = 256;  // to what is behind, however narrow the dent is
    const Vec3 side = (ray - ray.dot(pit.z) * pit.z).normalized();
    const auto at = [&](double angle) -> Vec3 {
        const auto [sine, cosine] = portable::sine_cosine(angle);
        return cosine * pit.z + sine * side;
    };
    const double narrow = portable::angle_of(pit.half.head<2>().minCoeff(), (pit.middle - centre).norm());
    const double step = std::max(narrow / steps_a_dent, behind / most_steps);
    double inside = 0, outside = step;
    while (outside < behind && leads_into_dent(n, surfaces, joint, centre, at(outside)))
        inside = outside, outside += step;
    const auto in_dents = [&](double angle) {
        return leads_into_dent(n, surfaces, joint, centre, at(angle));
    };
    return at(bisect(inside, outside, halvings, in_dents).second);
}

DentWall nearest_wall(const JointSurfaces& surfaces, std::int32_t joint, const Vec3& place) {
    DentWall wall{Vec3::UnitZ()};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int32_t i = surfaces.pit_first[joint]; i < surfaces.pit_first[joint + 1]; ++i) {
        const PitShape& pit = surfaces.pits[i];
        const Vec3 local = pit.local(place - pit.middle);
        if (const double off = std::abs(local.norm() - 1); off < nearest) {
            nearest = off;
            wall.normal = local.x() / pit.half.x() * pit.x + local.y() / pit.half.y() * pit.y +
                          local.z() / pit.half.z() * pit.z;
        }
    }
    wall.normal = -wall.normal.normalized();
    wall.touches = nearest < touching;
    return wall;
}

bool on_rim(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
            const Vec3& place) {
    return !in_dent(n, surfaces, joint, centre, place) && nearest_wall(surfaces, joint, place).touches;
}

}  // namespace sinew::sqm
