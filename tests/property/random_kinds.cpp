#include "property/random_kinds.h"

#include <algorithm>
#include <numeric>

namespace sinew::property {
namespace {

/// A document while it is drawn: all bones are links, so that any graph can be said.
class Sketch {
  public:
    Sketch(Random& source, Document& document) : random(source), document_(document) {}

    int node(const Vec3& position, double radius) {
        Node node;
        node.id = std::ssize(document_.nodes);
        node.position = position;
        node.radius = radius;
        document_.nodes.push_back(node);
        return static_cast<int>(node.id);
    }
    void bone(int a, int b) { document_.links.push_back({a, b}); }
    int child(int parent, const Vec3& offset, double radius) {
        const int added = node(at(parent) + offset, radius);
        bone(parent, added);
        return added;
    }
    int any() { return random.below(static_cast<int>(document_.nodes.size())); }
    int count() const { return static_cast<int>(document_.nodes.size()); }
    Vec3& at(int i) { return document_.nodes[i].position; }
    double& radius(int i) { return document_.nodes[i].radius; }
    Document& document() { return document_; }

    Random& random;

  private:
    Document& document_;
};

double some_radius(Random& r) { return r.chance(0.1) ? r.between(0.01, 2) : r.between(0.05, 0.4); }

void tree(Sketch& s) {
    const int count = s.random.whole(2, 30);
    s.node(s.random.in_cube(1), some_radius(s.random));
    while (s.count() < count)
        s.child(s.any(), s.random.between(0.3, 2) * s.random.direction(), some_radius(s.random));
}

/// Children continue their parent's direction more or less, as in plants.
void plant(Sketch& s) {
    std::vector<Vec3> heading{Vec3::UnitZ()};
    s.node(Vec3::Zero(), 0.3);
    const int count = s.random.whole(5, 60);
    while (s.count() < count) {
        const int parent = s.random.whole(std::max(0, s.count() - 8), s.count() - 1);
        heading.push_back((heading[parent] + s.random.between(0.2, 1) * s.random.direction()).normalized());
        s.child(parent, s.random.between(0.5, 1.5) * heading.back(),
                s.radius(parent) * s.random.between(0.6, 1));
    }
}

void some_cycles(Sketch& s, int count) {
    for (int i = 0; i < count; ++i)
        if (const int a = s.any(), b = s.any(); a != b) s.bone(a, b);
}
void graph(Sketch& s) {
    tree(s);
    some_cycles(s, s.random.whole(1, 12));
}

void coincident(Sketch& s) {
    s.random.chance(0.5) ? tree(s) : graph(s);
    for (int i = 0; i < 4; ++i) {
        const int a = s.any(), b = s.any();
        s.at(a) = s.at(b);
        if (a != b && s.random.chance(0.5)) s.bone(a, b);
    }
}

void collinear(Sketch& s) {
    const Vec3 axis = s.random.chance(0.5) ? Vec3(Vec3::Unit(s.random.below(3))) : s.random.direction();
    s.random.chance(0.5) ? tree(s) : graph(s);
    for (int i = 0; i < s.count(); ++i) s.at(i) = s.at(i).dot(axis) * axis;
}

/// Every bone goes back along the last one, straight or nearly.
void folded(Sketch& s) {
    const Vec3 axis = s.random.direction();
    s.node(Vec3::Zero(), some_radius(s.random));
    const int count = s.random.whole(3, 15);
    const double bend = s.random.chance(0.5) ? 0 : 1e-3;
    for (int i = 1; i < count; ++i) {
        const int parent = s.random.chance(0.7) ? s.count() - 1 : s.any();
        s.child(parent, (i % 2 ? 1 : -1) * s.random.between(0.3, 1) * axis + bend * s.random.direction(),
                some_radius(s.random));
    }
}

/// Bones that are there twice, or join a node to itself: these must be refused.
void refused(Sketch& s) {
    s.random.chance(0.5) ? tree(s) : graph(s);
    auto& links = s.document().links;
    for (int i = 0; i < 5; ++i) {
        auto [a, b] = links[s.random.below(static_cast<int>(links.size()))];
        if (s.random.chance(0.3)) b = a;
        links.push_back(s.random.chance(0.5) ? std::array{a, b} : std::array{b, a});
    }
}

/// Bones that become the same one when the two nodes of a bone of no length are merged.
void duplicated(Sketch& s) {
    s.random.chance(0.5) ? tree(s) : graph(s);
    for (int i = 0; i < 3; ++i) {
        const int a = s.any(), twin = s.node(s.at(a), s.radius(a) * s.random.between(0.5, 2));
        const auto links = s.document().links;
        for (const auto& [u, v] : links)
            if (u == a || v == a) s.bone(twin, u == a ? v : u);
        s.bone(a, twin);
    }
}

void planar(Sketch& s) {
    s.random.chance(0.5) ? tree(s) : graph(s);
    const Vec3 normal = s.random.chance(0.5) ? Vec3(Vec3::Unit(s.random.below(3))) : s.random.direction();
    for (int i = 0; i < s.count(); ++i) s.at(i) -= s.at(i).dot(normal) * normal;
}

Vec3 star_direction(Random& r, int shape, int i, int count, const Vec3& axis) {
    const double turn = 2 * M_PI * i / count;
    const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
    const Vec3 round = std::cos(turn) * x + std::sin(turn) * y;
    switch (shape) {
        case 0:
            return r.direction();
        case 1:
            return round;  // a planar star
        case 2:
            return (round + 1.5 * axis).normalized();  // cocircular, on one side
        case 3:
            return (axis + r.between(0, 0.3) * r.direction()).normalized();  // a narrow bundle
        case 4: {                                                            // a half-space
            const Vec3 d = r.direction();
            return d.dot(axis) < 0 ? Vec3(-d) : d;
        }
        case 5:
            return axis;  // all the same
        case 6:
            return i % 2 ? axis : Vec3(-axis);  // all the same or opposite
        case 7:
            return i < count / 2 ? round : Vec3((round + axis).normalized());  // two circles
        default:
            return (round + 0.02 * r.direction()).normalized();  // nearly planar
    }
}

void star(Sketch& s) {
    const int count = s.random.chance(0.3) ? s.random.whole(3, 40) : s.random.whole(3, 12);
    const int shape = s.random.below(9);
    const Vec3 axis = s.random.chance(0.5) ? Vec3(Vec3::Unit(s.random.below(3))) : s.random.direction();
    const int centre = s.node(Vec3::Zero(), some_radius(s.random));
    const double length = s.random.between(0.3, 2);
    for (int i = 0; i < count; ++i) {
        const double reach = s.random.chance(0.7) ? length : s.random.between(0.1, 3);
        s.child(centre, reach * star_direction(s.random, shape, i, count, axis), some_radius(s.random));
    }
    if (s.random.chance(0.3)) some_cycles(s, 3);
}

void lone(Sketch& s) {
    const int count = s.random.whole(1, 5);
    for (int i = 0; i < count; ++i) s.node(s.random.in_cube(2), some_radius(s.random));
}

void components(Sketch& s) {
    for (int i = s.random.whole(2, 4); i > 0; --i) {
        const int first = s.count();
        s.node(s.random.in_cube(4), some_radius(s.random));
        for (int k = s.random.below(8); k > 0; --k)
            s.child(s.random.whole(first, s.count() - 1), s.random.direction(), some_radius(s.random));
    }
}

/// Balls inside each other, bones far shorter than their radii.
void nested(Sketch& s) {
    s.random.chance(0.5) ? tree(s) : graph(s);
    const double crowding = s.random.between(0.02, 0.6);
    for (int i = 0; i < s.count(); ++i) {
        s.at(i) *= crowding;
        s.radius(i) = s.random.chance(0.2) ? s.random.between(0.5, 2) : s.random.between(0.05, 0.6);
    }
}

void steep(Sketch& s) {
    s.random.chance(0.5) ? tree(s) : graph(s);
    for (int i = 0; i < s.count(); ++i) s.radius(i) = std::exp(s.random.between(-5, 0.5));
}

/// Several paths between two joints, some straight, and paths from a joint to itself.
void parallel_paths(Sketch& s) {
    const int a = s.node(Vec3::Zero(), 0.2), b = s.node({s.random.between(0.5, 3), 0, 0}, 0.2);
    const auto path = [&](int from, int to, int between) {
        int last = from;
        for (int i = 0; i < between; ++i)
            last =
                s.child(last, s.random.between(0.3, 1) * s.random.direction(), s.random.between(0.05, 0.3));
        s.bone(last, to);
    };
    if (s.random.chance(0.5)) s.bone(a, b);
    for (int i = s.random.whole(0, 5); i > 0; --i) path(a, b, s.random.whole(1, 4));
    for (int i = s.random.whole(0, 3); i > 0; --i) path(a, a, s.random.whole(2, 5));
    if (s.random.chance(0.5)) s.child(b, s.random.direction(), 0.1);
}

void closed_path(Sketch& s) {
    const int count = s.random.whole(3, 12);
    const double wave = s.random.chance(0.5) ? 0 : 0.5;
    for (int i = 0; i < count; ++i) {
        const double turn = 2 * M_PI * i / count;
        s.node(Vec3(std::cos(turn), std::sin(turn), wave * std::sin(3 * turn)), s.random.between(0.05, 0.3));
        s.bone(i, (i + 1) % count);
    }
}

/// A piece of a square, cubic or body-centred lattice.
void lattice(Sketch& s) {
    const int side = s.random.whole(2, 3), depth = s.random.chance(0.3) ? 1 : side, shape = s.random.below(3);
    const double radius = s.random.between(0.05, 0.3), drop = s.random.chance(0.5) ? 0 : 0.3;
    const auto index = [&](int x, int y, int z) { return (z * side + y) * side + x; };
    for (int z = 0; z < depth; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) s.node(Vec3(x, y, z), radius);
    const auto offer = [&](int a, int b) {
        if (!s.random.chance(drop)) s.bone(a, b);
    };
    for (int z = 0; z < depth; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                if (shape == 2) {
                    const int centre = s.node(Vec3(x + 0.5, y + 0.5, z + 0.5), radius);
                    for (int k = 0; k < 8; ++k)
                        if (const int u = x + k % 2, v = y + k / 2 % 2, w = z + k / 4;
                            u < side && v < side && w < depth)
                            offer(centre, index(u, v, w));
                    continue;
                }
                if (x + 1 < side) offer(index(x, y, z), index(x + 1, y, z));
                if (y + 1 < side) offer(index(x, y, z), index(x, y + 1, z));
                if (z + 1 < depth) offer(index(x, y, z), index(x, y, z + 1));
                if (shape == 1 && x + 1 < side && y + 1 < side) offer(index(x, y, z), index(x + 1, y + 1, z));
            }
}

void chain(Sketch& s) {
    s.node(Vec3::Zero(), some_radius(s.random));
    Vec3 heading = s.random.direction();
    const double bend = s.random.between(0, 1.5), step = s.random.between(0.05, 1);
    for (int i = s.random.whole(1, 30); i > 0; --i) {
        heading = (heading + bend * s.random.direction()).normalized();
        s.child(s.count() - 1, step * heading, s.random.between(0.05, 0.5));
    }
}

/// One half as drawn, the other its image; what lies in the plane is its own.
void mirrored(Sketch& s) {
    const int axis = s.random.below(3);
    s.random.chance(0.6) ? tree(s) : graph(s);
    const int half = s.count();
    std::vector<int> image(half);
    for (int i = 0; i < half; ++i) {
        double& x = s.at(i)[axis];
        x = std::abs(x);
        if (i == 0 || s.random.chance(0.3)) x = 0;
    }
    for (int i = 0; i < half; ++i) {
        image[i] = i;
        if (s.at(i)[axis] == 0) continue;
        image[i] = s.node(s.at(i), s.radius(i));
        s.at(image[i])[axis] *= -1;
    }
    auto& links = s.document().links;
    const auto bones = static_cast<int>(links.size());
    for (int b = 0; b < bones; ++b) {
        const auto [u, v] = links[b];
        if (image[u] != u || image[v] != v) links.push_back({image[u], image[v]});
    }
}

void tiny(Sketch& s) {
    graph(s);
    for (int i = 0; i < s.count(); ++i) s.at(i) *= 1e-6, s.radius(i) *= 1e-6;
}
void huge(Sketch& s) {
    graph(s);
    for (int i = 0; i < s.count(); ++i) s.at(i) *= 1e6, s.radius(i) *= 1e6;
}
/// Small beside its distance from the origin.
void far_away(Sketch& s) {
    tree(s);
    const Vec3 shift = 1e3 * s.random.direction();
    for (int i = 0; i < s.count(); ++i) s.at(i) += shift;
}

/// Half of something, or one sector of it; some nodes are in the plane or on the axis.
void with_symmetry(Sketch& s) {
    s.random.chance(0.7) ? tree(s) : graph(s);
    Symmetry& symmetry = s.document().symmetry;
    symmetry.axis = s.random.below(3);
    const bool radial = s.random.chance(0.4);
    symmetry.kind = radial ? Symmetry::Kind::radial : Symmetry::Kind::mirror;
    symmetry.count = radial ? s.random.whole(2, 8) : 2;
    for (int i = 0; i < s.count(); ++i) {
        if (i > 0 && s.random.chance(0.7)) continue;
        if (radial)
            s.at(i) = s.at(i)[symmetry.axis] * Vec3::Unit(symmetry.axis);
        else
            s.at(i)[symmetry.axis] = 0;
    }
}

struct Kind {
    const char* name;
    void (*draw)(Sketch&);
};
constexpr Kind kinds[] = {{"tree", tree},
                          {"plant", plant},
                          {"graph", graph},
                          {"coincident", coincident},
                          {"collinear", collinear},
                          {"folded", folded},
                          {"refused", refused},
                          {"duplicated", duplicated},
                          {"planar", planar},
                          {"star", star},
                          {"star", star},
                          {"lone", lone},
                          {"components", components},
                          {"nested", nested},
                          {"steep", steep},
                          {"parallel", parallel_paths},
                          {"closed", closed_path},
                          {"lattice", lattice},
                          {"chain", chain},
                          {"mirrored", mirrored},
                          {"mirrored", mirrored},
                          {"symmetry", with_symmetry},
                          {"tiny", tiny},
                          {"huge", huge},
                          {"far", far_away}};

}  // namespace

std::string draw_random_kind(Random& random, std::uint64_t seed, Document& document) {
    const Kind& kind = kinds[seed % std::size(kinds)];
    Sketch sketch(random, document);
    kind.draw(sketch);
    return kind.name;
}

}  // namespace sinew::property
