#include "sinew/mesh/rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

/// A point as seen from a circle.
struct Polar {
    double height;   ///< above the circle's plane, along the axis
    double radius;   ///< distance from the axis
    Vec3 direction;  ///< unit, from the axis; zero on the axis
};

Polar polar_of(const Circle& circle, const Vec3& point) {
    const Vec3 axis = circle.axis.cast<double>();
    const Vec3 from_centre = point - circle.centre.cast<double>();
    const double height = axis.dot(from_centre);
    const Vec3 outward = from_centre - height * axis;
    const double radius = outward.norm();
    if (radius <= 1e-9 * circle.radius) return {height, 0, Vec3::Zero()};
    return {height, radius, outward / radius};
}

Result<void> check_circle(const Circle& circle, std::size_t number) {
    if (circle.radius > 0 && std::abs(circle.axis.norm() - 1) < 1e-3f && circle.centre.allFinite()) return {};
    return fail(ErrorKind::input, fmt::format("circle {} of the mesh has no radius or no unit axis", number));
}

struct OnCircle {
    Index vertex, circle, neighbour, edge;
    auto operator<=>(const OnCircle&) const = default;
};

/// One vertex from all its places on circles, which are of one circle and two, or else its own control.
CircleVertex join(std::span<const OnCircle> places) {
    CircleVertex joined{places[0].vertex, places[0].circle};
    if (places.size() == 2 && places[0].circle == places[1].circle) {
        joined.before = places[0].neighbour;
        joined.after = places[1].neighbour;
        joined.before_edge = places[0].edge;
        joined.after_edge = places[1].edge;
    }
    return joined;
}

/// A corner, and a vertex that another crease runs into, is its own control point.
bool is_crossed(const Sharpness& sharpness, const CircleVertex& place) {
    const Index sharp = find_sharp_vertex(sharpness, place.vertex);
    if (sharp == no_index) return false;
    const auto spokes = sharpness.spokes_of(sharp);
    return sharpness.corner[sharp] || std::any_of(spokes.begin(), spokes.end(), [&](const SharpSpoke& spoke) {
               return spoke.end != place.before && spoke.end != place.after;
           });
}

std::vector<CircleVertex> join_vertices(std::vector<OnCircle> places, const Sharpness& sharpness) {
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<CircleVertex> vertices;
    for (std::size_t begin = 0, end; begin < places.size(); begin = end) {
        for (end = begin; end < places.size() && places[end].vertex == places[begin].vertex;) ++end;
        CircleVertex joined = join(std::span(places).subspan(begin, end - begin));
        if (is_crossed(sharpness, joined)) joined.before = joined.after = no_index;
        vertices.push_back(joined);
    }
    return vertices;
}

/// Grows a cone from the fan of a fixed pole outwards to the circle that bounds it.
class ConeFinder {
  public:
    ConeFinder(const QuadMesh& mesh, const Topology& topology, std::span<const CircleVertex> on_circles)
        : mesh_(mesh), topology_(topology), on_circles_(on_circles), seen_(mesh.face_count(), 0) {}

    /// The cone of a fan; one without faces where there is none.
    Cone find(Index pole, std::span<const Index> faces) {
        Cone cone{.tip = pole, .circle = circle_of_spoke(pole)};
        if (cone.circle == no_index || !is_on_axis(cone)) return {};
        cone.faces.assign(faces.begin(), faces.end());
        const bool sound = grow(cone);
        for (const Index face : cone.faces) seen_[face] = 0;
        if (!sound) return {};
        std::sort(cone.faces.begin(), cone.faces.end());
        return cone;
    }

  private:
    Vec3 position(Index vertex) const { return mesh_.positions[vertex].cast<double>(); }
    Index next(Index h) const { return next_half_edge(mesh_, topology_, h); }

    Index circle_of(Index vertex) const {
        const auto found =
            std::lower_bound(on_circles_.begin(), on_circles_.end(), vertex,
                             [](const CircleVertex& place, Index v) { return place.vertex < v; });
        return found != on_circles_.end() && found->vertex == vertex ? found->circle : no_index;
    }

    /// Walks straight along one spoke, as long as it is straight and leads away, to the first vertex on a
    /// circle.
    Index circle_of_spoke(Index pole) const {
        Index h = topology_.ring(pole)[0];
        const Vec3 tip = position(pole), way = (position(mesh_.corners[next(h)]) - tip).normalized();
        for (double reached = 0;;) {  // where all vertices are in one place, edges can go round for ever
            const Index vertex = mesh_.corners[next(h)];
            if (const Index circle = circle_of(vertex); circle != no_index) return circle;
            const Vec3 from_tip = position(vertex) - tip;
            const double along = way.dot(from_tip);
            if (!(along > reached)) return no_index;
            if (!((from_tip - along * way).norm() <= 1e-4 * from_tip.norm())) return no_index;
            reached = along;
            if (topology_.ring(vertex).size() != 4 || topology_.twin[next(h)] == no_index) return no_index;
            h = next(topology_.twin[next(h)]);
            if (mesh_.corners[h] != vertex) return no_index;
        }
    }

    const Circle& circle(const Cone& cone) const { return mesh_.features.circles[cone.circle]; }

    bool is_on_axis(const Cone& cone) const {
        return polar_of(circle(cone), position(cone.tip)).radius <= 1e-4 * circle(cone).radius;
    }

    /// Does the vertex lie on the cone, up to its circle?
    bool fits(const Cone& cone, Index vertex) const {
        const double radius = circle(cone).radius;
        const Polar tip = polar_of(circle(cone), position(cone.tip));
        const Polar polar = polar_of(circle(cone), position(vertex));
        const double along = polar.radius / radius;
        return along < 1 && std::abs(polar.height - (1 - along) * tip.height) <= 1e-4 * radius;
    }

    bool grow(Cone& cone) {
        for (const Index face : cone.faces) seen_[face] = 1;
        for (std::size_t i = 0; i < cone.faces.size(); ++i) {
            const Index face = cone.faces[i];
            for (Index h = mesh_.face_offsets[face]; h < mesh_.face_offsets[face + 1]; ++h)
                if (!step_over(h, cone)) return false;
        }
        return true;
    }

    /// Takes the face beyond a half-edge into the cone, unless the circle runs between them.
    bool step_over(Index h, Cone& cone) {
        const Index from = mesh_.corners[h], to = mesh_.corners[next(h)];
        const bool on = circle_of(from) == cone.circle;
        if (on && circle_of(to) == cone.circle) return true;
        if (!on && (circle_of(from) != no_index || !fits(cone, from))) return false;
        if (topology_.twin[h] == no_index) return false;
        const Index beyond = topology_.half_edge_face[topology_.twin[h]];
        if (!seen_[beyond]) cone.faces.push_back(beyond);
        seen_[beyond] = 1;
        return true;
    }

    const QuadMesh& mesh_;
    const Topology& topology_;
    std::span<const CircleVertex> on_circles_;
    std::vector<char> seen_;
};

}  // namespace

Result<Rounds> resolve_rounds(const QuadMesh& mesh, const Topology& topology, const Sharpness& sharpness,
                              const Fans& fans) {
    Rounds rounds;
    std::vector<OnCircle> places;
    for (Index c = 0; c < mesh.features.circles.size(); ++c) {
        if (auto sound = check_circle(mesh.features.circles[c], c); !sound) return fail(sound.error());
        for (const auto& [a, b] : mesh.features.circles[c].edges) {
            const Index edge = find_edge(topology, {a, b});
            if (edge == no_index)
                return fail(ErrorKind::input,
                            fmt::format("circle {} has an edge {} - {} that the mesh has not", c, a, b));
            rounds.edges.push_back({edge, c});
            places.push_back({a, c, b, edge});
            places.push_back({b, c, a, edge});
        }
    }
    if (rounds.edges.empty()) return rounds;
    rounds.vertices = join_vertices(std::move(places), sharpness);
    ConeFinder finder(mesh, topology, rounds.vertices);
    for (const PoleFan& fan : fans.fans)
        if (fan.fixed)
            if (Cone cone = finder.find(fan.pole, fans.faces_of(fan)); !cone.faces.empty())
                rounds.cones.push_back(std::move(cone));
    return rounds;
}

Vec3 nearest_on_circle(const Circle& circle, const Vec3& point) {
    const Polar polar = polar_of(circle, point);
    const Vec3 direction =
        polar.radius > 0 ? polar.direction : Vec3(circle.axis.cast<double>().unitOrthogonal());
    return circle.centre.cast<double>() + double{circle.radius} * direction;
}

double spline_radius(double angle) {
    const auto cosine = [](double a) { return portable::sine_cosine(a).cosine; };
    const double beside = (4 + 2 * cosine(angle)) / 6;
    const double between = (46 * cosine(angle / 2) + 2 * cosine(3 * angle / 2)) / 48;
    return (beside + between) / 2;
}

Vec3 circle_control(const Circle& circle, const Vec3& point, const Vec3& before, const Vec3& after) {
    const Vec3 direction = polar_of(circle, point).direction;
    const auto angle_to = [&](const Vec3& other) {
        const double cosine = std::clamp(direction.dot(polar_of(circle, other).direction), -0.5, 1.0);
        return portable::angle_of(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
    };
    const double angle = (angle_to(before) + angle_to(after)) / 2;
    const Vec3 centre = circle.centre.cast<double>();
    return centre + (point - centre) / spline_radius(angle);
}

void ConeMean::add(const Vec3& point) {
    const Polar polar = polar_of(circle_, point);
    ++count_;
    radius_ += polar.radius;
    direction_ += polar.direction;
}

Vec3 ConeMean::mean() const {
    if (!(direction_.norm() > 0)) return tip_;
    const double radius = radius_ / count_;
    const Vec3 foot = tip_ + radius / circle_.radius * (circle_.centre.cast<double>() - tip_);
    return foot + radius * direction_.normalized();
}

}  // namespace sinew
