#include "sinew/sqm/cells/spherical_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/cells/count_problem.h"
#include "sinew/sqm/cells/near_directions.h"
#include "sinew/sqm/cells/sphere_hull.h"

namespace sinew::sqm {
namespace {

/// Radians between two directions: closer ones are pushed apart, or the tubes would have no cells to leave
/// by. Each is then moved by up to half of it, out of its bone's axis. Of 1,500 random stars of 3 to 8 bones,
/// up to three of them within 0.25 of each other, 15 meshes cross themselves with 0.03, 13 with 0.06, 14 with
/// 0.12, and 49 with 0.24.
constexpr double least_separation = 0.12;
/// Radians; the ends of shorter arcs are merged to a point: one irregular vertex stands for two. Of
/// 1,500 random stars of 3 to 12 bones 26 have a folded quad with 0.06, 22 with 0.12, and 35 with 0.24.
constexpr double shortest_arc = 0.12;
/// Radians. The hull rounds directions to a grid of 2^-18, or 4e-6; where four of them lie on one circle that
/// leaves an arc of about as much, times how flat the triangles are that they make.
constexpr double no_length = 1e-4;
/// Minus the cosine from which two vertices count as opposite, the ends of a lune. It parts two kinds that
/// differ much: merging moves a vertex by half an arc, 0.06, at a time, and sides that are no lune's end at
/// another corner of the cell.
constexpr double opposite = 0.9;
constexpr int most_sides = 6;  // cells round a vertex, so that its valence is at most 12

// Pushing directions apart:
/// The nearest of a sunflower's seeds at the distances c, c sqrt 2, c sqrt 3, ... have about sqrt(pi) c
/// between them, as each takes the area pi c^2: this makes it the least separation.
constexpr double seed_spacing = 0.6;
/// Each of two directions goes half of what lacks between them, and a little more, so that it ends.
constexpr double golden = 2.399963229728653;  // radians: pi (3 - sqrt 5)
constexpr double own_half = 0.51;
constexpr double near_enough = 0.98;  // of the squared separation
constexpr double longest_push = 0.5;  // of the separation: many neighbours push too hard together
constexpr int most_pushes = 64;       // 16 do for all of the stars above
constexpr int most_pushes_of_crowd = 16;
constexpr double by_more_than_rounding = 1 + 1e-9;

Vec3 any_normal_to(const Vec3& v) {
    int least = 0;
    v.cwiseAbs().minCoeff(&least);
    return v.cross(Vec3::Unit(least)).normalized();
}

/// Lays equal directions out on a small disc, as a sunflower does its seeds, so that all are apart.
void part_equal(std::vector<Vec3>& sites, double spacing) {
    const std::vector<Vec3> drawn = sites;
    for (std::size_t i = 1; i < sites.size(); ++i) {
        const auto equal = [&](const Vec3& other) { return (drawn[i] - other).squaredNorm() <= 1e-12; };
        const auto twins = static_cast<double>(std::count_if(drawn.begin(), drawn.begin() + i, equal));
        if (twins == 0) continue;
        const Vec3 x = any_normal_to(drawn[i]), y = drawn[i].cross(x);
        const double angle = golden * twins, out = spacing * std::sqrt(twins);
        const auto [sine, cosine] = portable::sine_cosine(angle);
        sites[i] = (drawn[i] + out * (cosine * x + sine * y)).normalized();
    }
}

/// The same for a crowd: directions nearer than a quarter of the least separation count as equal, so that no
/// place is left with more than some of them.
void part_crowd(std::vector<Vec3>& sites, double least) {
    const double near = 0.25 * least;
    NearDirections places(near, sites.size());
    std::vector<Vec3> place;
    std::vector<std::int32_t> twins;
    for (Vec3& site : sites) {
        std::int32_t found = -1;
        places.for_near(site, [&](std::int32_t i) {
            if (found < 0 && (place[i] - site).squaredNorm() < near * near) found = i;
        });
        if (found < 0) {
            places.add(site);
            place.push_back(site);
            twins.push_back(0);
            continue;
        }
        const Vec3 middle = place[found], x = any_normal_to(middle), y = middle.cross(x);
        const double count = ++twins[found], out = seed_spacing * least * std::sqrt(count);
        const auto [sine, cosine] = portable::sine_cosine(std::fmod(golden * count, 2 * M_PI));
        site = (middle + out * (cosine * x + sine * y)).normalized();
    }
}

/// The square of the least distance between two of the directions, of a crowd only up to that of `reach`.
double least_square(std::span<const Vec3> sites, double reach) {
    if (std::ssize(sites) > crowd) {
        double nearest = reach * reach;
        NearDirections before(reach, sites.size());
        for (std::size_t i = 0; i < sites.size() && nearest > 0; ++i) {
            before.for_near(sites[i], [&](std::int32_t j) {
                nearest = std::min(nearest, (sites[i] - sites[j]).squaredNorm());
            });
            before.add(sites[i]);
        }
        return nearest;
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < sites.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, (sites[i] - sites[j]).squaredNorm());
    return least;
}

/// What one direction is pushed by another.
Vec3 push_by(const Vec3& site, const Vec3& other, double least) {
    const Vec3 apart = site - other;
    const double distance = apart.norm();
    if (distance >= least || distance == 0) return Vec3::Zero();
    return apart * (own_half * (least - distance) / distance);
}

/// Pushes directions apart once, all pairs at once so that their order does not matter.
void push_apart(std::vector<Vec3>& sites, double least, std::vector<Vec3>& push) {
    push.assign(sites.size(), Vec3::Zero());
    if (std::ssize(sites) > crowd) {
        const NearDirections all(least, sites);
        for (std::size_t i = 0; i < sites.size(); ++i)
            all.for_near(sites[i], [&](std::int32_t j) { push[i] += push_by(sites[i], sites[j], least); });
    } else {
        for (std::size_t i = 1; i < sites.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Vec3 half = push_by(sites[i], sites[j], least);
                push[i] += half;
                push[j] -= half;
            }
    }
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const double far = std::max(1.0, push[i].norm() / (longest_push * least));
        sites[i] = (sites[i] + push[i] / far).normalized();
    }
}

/// Pushes directions apart until all are, or so many times. Where there is no room, as for more than a
/// hundred in one plane, pushing makes a muddle of them: then those of the round stay, the drawn ones or
/// later ones, in which the nearest two were furthest apart.
void separate(std::vector<Vec3>& sites, std::vector<Vec3>& push) {
    const double least = std::min(least_separation, 1 / std::sqrt(static_cast<double>(sites.size())));
    const double drawn = least_square(sites, least);
    if (drawn >= least * least) return;
    // A crowd that is half as far apart as spokes in one plane can be stays as it is.
    const double spokes = M_PI / static_cast<double>(sites.size());
    if (std::ssize(sites) > crowd && drawn >= spokes * spokes) return;
    std::ssize(sites) > crowd ? part_crowd(sites, least) : part_equal(sites, seed_spacing * least);
    std::vector<Vec3> best = sites;
    double square = least_square(sites, least), best_square = square;
    const int most = std::ssize(sites) > crowd ? most_pushes_of_crowd : most_pushes;
    for (int round = 0; round < most && square < near_enough * least * least; ++round) {
        push_apart(sites, least, push);
        square = least_square(sites, least);
        if (square > best_square * by_more_than_rounding) best = sites, best_square = square;
    }
    sites = std::move(best);
}

std::int32_t before(std::span<const std::int32_t> face, std::int32_t point) {
    const auto at = std::find(face.begin(), face.end(), point) - face.begin();
    return face[at == 0 ? face.size() - 1 : at - 1];
}

Vec3 face_normal(std::span<const std::int32_t> face, std::span<const Vec3> sites) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
        sum += (sites[face[k]] - sites[face[0]]).cross(sites[face[k + 1]] - sites[face[0]]);
    return sum.normalized();
}

/// The corner before a point in a face of the hull; of two opposite polygons, by where each point is.
class CornersBefore {
  public:
    explicit CornersBefore(const SphericalCells& cells) : hull_(cells.hull) {
        if (hull_.face_count() != 2) return;
        place_.resize(cells.sites.size());
        for (int f = 0; f < 2; ++f)
            for (std::size_t k = 0; k < hull_.face(f).size(); ++k)
                place_[hull_.face(f)[k]][f] = static_cast<std::int32_t>(k);
    }
    std::int32_t operator()(std::int32_t face, std::int32_t point) const {
        const auto corners = hull_.face(face);
        if (place_.empty()) return before(corners, point);
        const std::int32_t at = place_[point][face];
        return corners[at == 0 ? corners.size() - 1 : at - 1];
    }

  private:
    const SphereHull& hull_;
    std::vector<std::array<std::int32_t, 2>> place_;
};

/// Which arc is between two cells, by the edges of the hull: those that leave its lower end come in order.
class ArcsOfEdges {
  public:
    explicit ArcsOfEdges(SphericalCells& cells) : hull_(cells.hull), arc_of_(cells.arc_of) {
        cells.arcs.clear();
        arc_of_.assign(hull_.edges.size(), -1);
        for (std::int32_t i = 0; i < cells.cell_count(); ++i)
            for (std::int32_t e = hull_.edge_first[i]; e < hull_.edge_first[i + 1]; ++e) {
                const std::int32_t k = hull_.edges[e].to;
                if (k < i) continue;
                arc_of_[e] = static_cast<std::int32_t>(cells.arcs.size());
                cells.arcs.push_back({hull_.face_of(k, i), hull_.edges[e].face, i, k});
            }
    }
    std::int32_t operator()(std::int32_t a, std::int32_t b) const {
        const std::int32_t low = std::min(a, b), high = std::max(a, b);
        const auto begin = hull_.edges.begin() + hull_.edge_first[low],
                   end = hull_.edges.begin() + hull_.edge_first[low + 1];
        const auto at = std::lower_bound(begin, end, high,
                                         [](const SphereHull::Edge& e, std::int32_t k) { return e.to < k; });
        return arc_of_[at - hull_.edges.begin()];
    }

  private:
    const SphereHull& hull_;
    std::vector<std::int32_t>& arc_of_;
};

/// The dual of the hull: a vertex a face, an arc an edge, a cell a point. Every point is a corner of the
/// hull, so that the walk round each is a ring of its faces.
void dualise(SphericalCells& cells) {
    const SphereHull& hull = cells.hull;
    const std::int32_t count = cells.cell_count();
    cells.vertices.clear();
    for (std::int32_t f = 0; f < hull.face_count(); ++f)
        cells.vertices.push_back(face_normal(hull.face(f), cells.sites));
    const ArcsOfEdges arc_of(cells);
    const CornersBefore corner_before(cells);
    std::vector<std::int32_t>& any_face = cells.any_face;
    any_face.assign(count, -1);
    for (std::int32_t f = 0; f < hull.face_count(); ++f)
        for (const std::int32_t i : hull.face(f)) any_face[i] = f;
    cells.side_first = {0};
    cells.sides.clear();
    for (std::int32_t i = 0; i < count; ++i) {
        std::int32_t f = any_face[i];
        do {
            const std::int32_t k = corner_before(f, i);
            cells.sides.push_back({arc_of(i, k), i > k});
            f = hull.face_of(i, k);
        } while (f != any_face[i]);
        cells.side_first.push_back(static_cast<std::int32_t>(cells.sides.size()));
    }
}

/// Directions spread over the sphere as a sunflower's seeds: all are corners of their hull.
void spread_evenly(std::vector<Vec3>& sites) {
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(sites.size());
        const auto [sine, cosine] = portable::sine_cosine(std::fmod(golden * double(i), 2 * M_PI));
        sites[i] = Vec3(std::sqrt(1 - z * z) * cosine, std::sqrt(1 - z * z) * sine, z).normalized();
    }
}

bool has_all_points(const SphereHull& hull) {
    for (std::size_t i = 0; i + 1 < hull.edge_first.size(); ++i)
        if (hull.edge_first[i] == hull.edge_first[i + 1]) return false;
    return true;
}

/// The hull and its dual. Directions too near each other for the grid are not all corners of their hull: such
/// a joint has cells all the same, though not where its bones are.
void find_dual(SphericalCells& cells) {
    find_sphere_hull(cells.sites, cells.hull);
    if (!has_all_points(cells.hull)) {
        spread_evenly(cells.sites);
        find_sphere_hull(cells.sites, cells.hull);
    }
    dualise(cells);
}

/// Three cells are lunes between two opposite vertices, wherever the directions are.
void make_three_lunes(SphericalCells& cells) {
    const std::array<std::int32_t, 3> face{0, 1, 2};
    const Vec3 normal = face_normal(face, cells.sites);
    cells.vertices = {normal, -normal};
    cells.arcs = {{1, 0, 0, 1}, {0, 1, 0, 2}, {1, 0, 1, 2}};
    cells.side_first = {0, 2, 4, 6};
    cells.sides = {{0, false}, {1, false}, {2, false}, {0, true}, {1, true}, {2, true}};
}

std::vector<int> cells_round_vertices(const SphericalCells& cells) {
    std::vector<int> count(cells.vertices.size(), 0);
    for (const CellArc& arc : cells.arcs) ++count[arc.from], ++count[arc.to];
    return count;
}

/// Merges the ends of short arcs, shortest first, wherever the cells stay discs of at least two sides.
class MergeShortArcs {
  public:
    MergeShortArcs(SphericalCells& cells, double limit, int most)
        : cells_(cells),
          limit_(limit),
          most_(most),
          root_(cells.vertices.size()),
          gone_(cells.arcs.size(), false) {
        std::iota(root_.begin(), root_.end(), 0);
        sum_ = cells.vertices;
        meet_ = cells_round_vertices(cells);
    }
    void run() {
        const std::vector<Short> shortest = short_arcs();
        side_count_.resize(cells_.cell_count());
        for (std::int32_t c = 0; c < cells_.cell_count(); ++c)
            side_count_[c] = static_cast<int>(cells_.cell(c).size());
        for (std::size_t begin = 0, end = 0; begin < shortest.size(); begin = end) {
            while (end < shortest.size() && shortest[end].first < shortest[begin].first + 1e-9) ++end;
            merge_alike({shortest.data() + begin, shortest.data() + end});
        }
        rewrite();
    }

  private:
    using Short = std::pair<double, std::int32_t>;

    /// Arcs of one length may be images of each other: all of them are merged or none, so that no order
    /// shows.
    void merge_alike(std::span<const Short> arcs) {
        const auto before = std::tuple(root_, sum_, gone_, side_count_, meet_);
        bool all = true;
        for (const auto& [length, arc] : arcs) {
            const bool may = may_merge(cells_.arcs[arc]);
            if (may) merge(arc);
            all = all && may;
        }
        if (!all && arcs.size() > 1 && arcs[0].first > no_length)
            std::tie(root_, sum_, gone_, side_count_, meet_) = before;
    }

    std::vector<Short> short_arcs() const {
        std::vector<Short> result;
        for (std::size_t a = 0; a < cells_.arcs.size(); ++a) {
            const CellArc& arc = cells_.arcs[a];
            const double chord = (cells_.vertices[arc.from] - cells_.vertices[arc.to]).norm();
            if (chord < limit_) result.emplace_back(chord, static_cast<std::int32_t>(a));
        }
        std::sort(result.begin(), result.end());
        return result;
    }
    std::int32_t root(std::int32_t v) const {
        while (root_[v] != v) v = root_[v];
        return v;
    }
    bool touches(std::int32_t cell, std::int32_t vertex) const {
        for (const CellSide& side : cells_.cell(cell)) {
            if (gone_[side.arc]) continue;
            const CellArc& arc = cells_.arcs[side.arc];
            if (root(arc.from) == vertex || root(arc.to) == vertex) return true;
        }
        return false;
    }
    bool may_merge(const CellArc& arc) const {
        const std::int32_t u = root(arc.from), v = root(arc.to);
        if (u == v || side_count_[arc.left] < 3 || side_count_[arc.right] < 3) return false;
        if (meet_[u] + meet_[v] - 2 > most_) return false;
        if (would_close(arc.left, u, v) || would_close(arc.right, u, v)) return false;
        for (std::int32_t c = 0; c < cells_.cell_count(); ++c)  // a cell that has both ends would be pinched
            if (c != arc.left && c != arc.right && touches(c, u) && touches(c, v)) return false;
        return true;
    }
    /// Whether merging u and v would leave a cell between two arcs of one great circle, of no width: two
    /// sides make a lune only from a vertex to the opposite one.
    bool would_close(std::int32_t cell, std::int32_t u, std::int32_t v) const {
        if (side_count_[cell] > 3) return false;
        const Vec3 merged = sum_[u] + sum_[v];
        for (const CellSide& side : cells_.cell(cell)) {
            if (gone_[side.arc]) continue;
            const std::int32_t from = root(cells_.arcs[side.arc].from);
            const std::int32_t to = root(cells_.arcs[side.arc].to);
            for (const std::int32_t end : {from, to})
                if (end != u && end != v &&
                    merged.dot(sum_[end]) > -opposite * merged.norm() * sum_[end].norm())
                    return true;
        }
        return false;
    }
    void merge(std::int32_t a) {
        const CellArc& arc = cells_.arcs[a];
        const std::int32_t u = root(arc.from), v = root(arc.to);
        root_[std::max(u, v)] = std::min(u, v);
        sum_[std::min(u, v)] += sum_[std::max(u, v)];
        meet_[std::min(u, v)] += meet_[std::max(u, v)] - 2;
        gone_[a] = true;
        --side_count_[arc.left];
        --side_count_[arc.right];
    }
    void rewrite() {
        std::vector<std::int32_t> new_vertex(cells_.vertices.size(), -1), new_arc(cells_.arcs.size(), -1);
        std::vector<Vec3> vertices;
        for (std::size_t v = 0; v < root_.size(); ++v)
            if (root_[v] == static_cast<std::int32_t>(v)) {
                new_vertex[v] = static_cast<std::int32_t>(vertices.size());
                vertices.push_back(sum_[v].normalized());
            }
        std::int32_t arcs = 0;
        for (std::size_t a = 0; a < gone_.size(); ++a) {
            if (gone_[a]) continue;
            CellArc arc = cells_.arcs[a];
            arc.from = new_vertex[root(arc.from)];
            arc.to = new_vertex[root(arc.to)];
            new_arc[a] = arcs;
            cells_.arcs[arcs++] = arc;
        }
        cells_.arcs.resize(arcs);
        std::size_t to = 0;
        for (std::int32_t c = 0, begin = 0; c < cells_.cell_count(); ++c) {
            const std::int32_t end = cells_.side_first[c + 1];
            for (std::int32_t s = begin; s < end; ++s)
                if (new_arc[cells_.sides[s].arc] >= 0)
                    cells_.sides[to++] = {new_arc[cells_.sides[s].arc], cells_.sides[s].reversed};
            begin = end;
            cells_.side_first[c + 1] = static_cast<std::int32_t>(to);
        }
        cells_.sides.resize(to);
        cells_.vertices = std::move(vertices);
    }

    SphericalCells& cells_;
    double limit_;
    int most_;  // cells that may meet at a vertex
    std::vector<std::int32_t> root_;
    std::vector<bool> gone_;
    std::vector<Vec3> sum_;
    std::vector<int> side_count_;
    std::vector<int> meet_;  // cells that meet at each vertex
};

/// Whether all cells can have the same number of vertices round them, as paths on cycles want it. A
/// triangulation of points on a sphere always can; merging arcs can spoil it (four cells, of which two do not
/// touch).
bool is_balanced(const SphericalCells& cells) {
    CountProblem problem;
    for (const CellArc& arc : cells.arcs) problem.arcs.push_back({arc.left, arc.right});
    std::int32_t most = 4;
    for (std::int32_t c = 0; c < cells.cell_count(); ++c)
        most = std::max(most, static_cast<std::int32_t>(cells.cell(c).size()));
    for (std::int32_t count = (most + 1) / 2 * 2, tries = 0; tries < 6; count += 2, ++tries) {
        problem.cells.assign(cells.cell_count(), {count, true, false});
        if (problem.solve()) return true;
    }
    return false;
}

bool has_short_arc(const SphericalCells& cells, double limit) {
    return std::any_of(cells.arcs.begin(), cells.arcs.end(), [&](const CellArc& arc) {
        return (cells.vertices[arc.from] - cells.vertices[arc.to]).norm() < limit;
    });
}

/// Merges what is short, or, where that leaves cells that cannot be balanced, what has no length at all, or
/// nothing.
void merge_short_arcs(SphericalCells& cells, int most) {
    if (cells.cell_count() > crowd) return;  // all its arcs are short, and no edge of it is seen
    for (const double limit : {shortest_arc, no_length}) {
        if (!has_short_arc(cells, limit)) return;
        SphericalCells merged = cells;
        MergeShortArcs(merged, limit, most).run();
        if (!is_balanced(merged)) continue;
        cells = std::move(merged);
        return;
    }
}

bool is_crowded(const SphericalCells& cells) {
    if (cells.cell_count() <= most_sides) return false;
    const std::vector<int> meet = cells_round_vertices(cells);
    return std::any_of(meet.begin(), meet.end(), [](int count) { return count > most_sides; });
}

/// Adds a site in the middle of each vertex of too many sides, if it is free. False if none was added.
bool part_crowded_vertices(SphericalCells& cells) {
    constexpr double near = 0.25 * least_separation * least_separation;
    const std::size_t before = cells.sites.size();
    const auto is_free = [&](const Vec3& place) {
        return std::none_of(cells.sites.begin(), cells.sites.end(),
                            [&](const Vec3& site) { return (site - place).squaredNorm() < near; });
    };
    const std::vector<int> meet = cells_round_vertices(cells);
    for (std::size_t v = 0; v < meet.size(); ++v)
        if (meet[v] > most_sides && is_free(cells.vertices[v])) cells.sites.push_back(cells.vertices[v]);
    cells.added += static_cast<std::int32_t>(cells.sites.size() - before);
    return cells.sites.size() > before;
}

}  // namespace

void find_spherical_cells(std::span<const Vec3> directions, SphericalCells& cells) {
    cells.sites.assign(directions.begin(), directions.end());
    cells.added = 0;
    separate(cells.sites, cells.vertices);
    if (cells.cell_count() == 3) return make_three_lunes(cells);
    for (int round = 0; round < 4; ++round) {
        find_dual(cells);
        merge_short_arcs(cells, std::numeric_limits<int>::max());
        if (!is_crowded(cells)) return;
        if (!part_crowded_vertices(cells)) break;
    }
    // There is no room for more: rather short arcs than crowded vertices.
    find_dual(cells);
    merge_short_arcs(cells, most_sides);
}

}  // namespace sinew::sqm
