#include "sinew/sqm/surface/dents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sinew/base/portable_math.h"
#include "sinew/extend/frames.h"

namespace sinew::sqm {
namespace {

constexpr double nearest_to_centre = 0.02;  // of the surface's distance: no dent reaches further
constexpr double least_dent = 1e-5;         // the same: what is less deep lies on the surface
constexpr double touching = 1e-3;           // of a dent's size
constexpr double whole_groove = 0.2;  // overlap, of the narrower dent's reach, from which a groove is whole
constexpr double groove_step = 0.1;   // between the dents of a groove, of the narrower one's half width
constexpr int longest_groove = 20;    // in such steps

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

/// From the middle to the border, in a unit direction.
double reach(const PitShape& pit, const Vec3& way) { return 1 / pit.local(way).norm(); }

/// How much of a groove two dents make: 0 if they do not overlap, 1 if it is whole.
double overlap(const PitShape& a, const PitShape& b) {
    const Vec3 way = b.middle - a.middle;
    const double distance = way.norm();
    if (!(distance > 0)) return 0;
    const double of_a = reach(a, way / distance), of_b = reach(b, way / distance);
    const double share = (of_a + of_b - distance) / (whole_groove * std::min(of_a, of_b));
    return std::clamp(share, 0.0, 1.0);
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

/// A dent part of the way from one to another, on the surface between them.
PitShape between(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
                 const PitShape& a, const PitShape& b, double share, double whole) {
    const Vec3 way = a.middle + share * (b.middle - a.middle) - centre;
    PitShape pit;
    pit.z = way.norm() > 0 ? Vec3(way.normalized()) : a.z;
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
        for (std::int32_t a = first; a < own; ++a)
            for (std::int32_t b = a + 1; b < own; ++b)
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
    for (bool moved = true; moved;) {  // until no order of the dents would take away more
        moved = false;
        for (std::int32_t i = surfaces.pit_first[joint]; i < surfaces.pit_first[joint + 1]; ++i) {
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
    return distance < (1 - least_dent) * exit_without_dents(n, surfaces, joint, (place - centre) / distance);
}

bool leads_into_dent(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
                     const Vec3& ray) {
    const double surface = exit_without_dents(n, surfaces, joint, ray);
    return press_dents(surfaces, joint, centre, ray, surface) < (1 - least_dent) * surface;
}

Vec3 rim_towards(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const PitShape& pit,
                 const Vec3& centre, const Vec3& ray) {
    constexpr double behind = 3;  // radians
    constexpr int halvings = 30;
    const Vec3 side = (ray - ray.dot(pit.z) * pit.z).normalized();
    const auto at = [&](double angle) -> Vec3 {
        const auto [sine, cosine] = portable::sine_cosine(angle);
        return cosine * pit.z + sine * side;
    };
    const double step = portable::angle_of(pit.half.head<2>().minCoeff(), (pit.middle - centre).norm()) / 4;
    double inside = 0, outside = step;
    while (outside < behind && leads_into_dent(n, surfaces, joint, centre, at(outside)))
        inside = outside, outside += step;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (inside + outside);
        (leads_into_dent(n, surfaces, joint, centre, at(middle)) ? inside : outside) = middle;
    }
    return at(outside);
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
