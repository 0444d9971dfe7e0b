#include "sinew/sqm/cells/polyhedra.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/chunks.h"

namespace sinew::sqm {
namespace {

constexpr std::int32_t joints_a_task = 512;  // joints whose cells one task finds

double angle_between(const Vec3& a, const Vec3& b) { return portable::angle_of(a.cross(b).norm(), a.dot(b)); }

/// Part of a great circle, by its length.
class GreatArc {
  public:
    GreatArc(const Vec3& from, const Vec3& to) : from_(from) {
        const double cosine = from.dot(to);
        across_ = to - cosine * from;
        const double sine = across_.norm();
        if (sine > 0) across_ /= sine;
        length_ = portable::angle_of(sine, cosine);
    }
    Vec3 at(double share) const {
        const auto [sine, cosine] = portable::sine_cosine(share * length_);
        return cosine * from_ + sine * across_;
    }

  private:
    Vec3 from_, across_;
    double length_;
};

/// The point half way, for arcs of more than a right angle. Between nearly opposite ends only the cells can
/// tell which of all great circles it is: the one in the plane between their two sites.
Vec3 middle_of(const Polyhedra& p, const CellArc& arc) {
    return (p.sites[arc.left] - p.sites[arc.right])
        .cross(p.vertices[arc.from] - p.vertices[arc.to])
        .normalized();
}
bool is_long(const Polyhedra& p, const CellArc& arc) {
    return p.vertices[arc.from].dot(p.vertices[arc.to]) < 0;
}

/// Normal of the face through which a direction leaves a box: bones of a box joint have its faces for cells.
Vec3 face_normal(const Form& box, const Vec3& direction) {
    const std::array<Vec3, 3> axes{box.x, box.y, box.z};
    int face = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(direction.dot(axes[k])) / box.half[k] >
            std::abs(direction.dot(axes[face])) / box.half[face])
            face = k;
    return direction.dot(axes[face]) < 0 ? Vec3(-axes[face]) : axes[face];
}

void append_shifted(const std::vector<std::int32_t>& from, std::int32_t by, std::vector<std::int32_t>& to) {
    std::for_each(from.begin() + 1, from.end(), [&](std::int32_t i) { to.push_back(i + by); });
}
/// Appends cells with their vertices, arcs and sides, but not which joints they belong to.
/// @param from  SphericalCells, or other Polyhedra
template <class Cells>
void append_cells(const Cells& from, Polyhedra& to) {
    const std::int32_t cell = to.cell_count(), vertex = static_cast<std::int32_t>(to.vertices.size()),
                       arc = static_cast<std::int32_t>(to.arcs.size());
    append_shifted(from.side_first, static_cast<std::int32_t>(to.sides.size()), to.side_first);
    to.sites.insert(to.sites.end(), from.sites.begin(), from.sites.end());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (const CellArc& a : from.arcs)
        to.arcs.push_back({a.from + vertex, a.to + vertex, a.left + cell, a.right + cell});
    for (const CellSide& s : from.sides) to.sides.push_back({s.arc + arc, s.reversed});
}
/// Marks the arcs of one joint that have both ends in common with another one.
void mark_doubled(const std::vector<CellArc>& arcs, std::vector<std::uint8_t>& doubled) {
    const std::size_t first = doubled.size();
    std::vector<std::array<std::int32_t, 3>> by_ends;
    for (const CellArc& a : arcs)
        by_ends.push_back(
            {std::min(a.from, a.to), std::max(a.from, a.to), static_cast<std::int32_t>(by_ends.size())});
    std::sort(by_ends.begin(), by_ends.end());
    doubled.resize(first + arcs.size(), 0);
    for (std::size_t i = 1; i < by_ends.size(); ++i)
        if (by_ends[i][0] == by_ends[i - 1][0] && by_ends[i][1] == by_ends[i - 1][1])
            doubled[first + by_ends[i][2]] = doubled[first + by_ends[i - 1][2]] = 1;
}
/// Appends the cells of one joint.
void append(const SphericalCells& cells, Polyhedra& out) {
    append_cells(cells, out);
    mark_doubled(cells.arcs, out.arc_doubled);
    out.cell_first.push_back(out.cell_count());
    out.vertex_first.push_back(static_cast<std::int32_t>(out.vertices.size()));
    out.arc_first.push_back(static_cast<std::int32_t>(out.arcs.size()));
}
/// Appends the cells of many joints.
void append(const Polyhedra& from, Polyhedra& to) {
    append_shifted(from.cell_first, to.cell_first.back(), to.cell_first);
    append_shifted(from.vertex_first, to.vertex_first.back(), to.vertex_first);
    append_shifted(from.arc_first, to.arc_first.back(), to.arc_first);
    append_cells(from, to);
    to.arc_doubled.insert(to.arc_doubled.end(), from.arc_doubled.begin(), from.arc_doubled.end());
}

void clear(Polyhedra& p) {
    p.cell_first = p.vertex_first = p.arc_first = p.side_first = {0};
    p.sites.clear(), p.vertices.clear(), p.arcs.clear(), p.arc_doubled.clear(), p.sides.clear();
}

void find_cells(const Plain& skeleton, const Network& network, std::int32_t begin, std::int32_t end,
                Polyhedra& out) {
    clear(out);
    SphericalCells cells;
    std::vector<Vec3> directions;
    for (std::int32_t j = begin; j < end; ++j) {
        directions.clear();
        const Form* form = skeleton.form(network.joint_node[j]);
        for (std::int32_t s = 0; s < network.degree(j); ++s) {
            const Vec3 direction = slot_direction(skeleton, network, j, s);
            directions.push_back(form && form->kind == Form::Kind::box ? face_normal(*form, direction)
                                                                       : to_ball_space(form, direction));
        }
        find_spherical_cells(directions, cells);
        for (Vec3& site : cells.sites) site = from_ball_space(form, site);
        append(cells, out);
    }
}

/// Room for all joints, if no cells are added.
void reserve(Polyhedra& p, const Network& n) {
    const std::size_t joints = n.joint_count(), cells = n.slot_path.size(), over = cells - 2 * joints;
    for (std::vector<std::int32_t>* array : {&p.cell_first, &p.vertex_first, &p.arc_first})
        array->reserve(joints + 1);
    p.sites.reserve(cells);
    p.side_first.reserve(cells + 1);
    p.vertices.reserve(2 * over);
    p.arcs.reserve(3 * over);
    p.arc_doubled.reserve(3 * over);
    p.sides.reserve(6 * over);
}

}  // namespace

Vec3 slot_direction(const Plain& skeleton, const Network& network, std::int32_t joint, std::int32_t slot) {
    const std::int32_t next = network.next_node(network.slot_first[joint] + slot);
    return (skeleton.position[next] - skeleton.position[network.joint_node[joint]]).normalized();
}

Result<Polyhedra> make_polyhedra(const Plain& skeleton, const Network& network, const Progress& progress) {
    Polyhedra all;
    clear(all);
    reserve(all, network);
    for_chunks<Polyhedra>(
        network.joint_count(), joints_a_task,
        [&](Polyhedra& part, std::int32_t begin, std::int32_t end) {
            if (!progress.cancelled()) find_cells(skeleton, network, begin, end, part);
        },
        [&](const Polyhedra& part) {
            if (!progress.cancelled()) append(part, all);
        });
    if (progress.cancelled()) return Progress::stopped();
    return all;
}

void divide_arc(const Polyhedra& p, const CellArc& arc, std::int32_t pieces, Vec3* points) {
    if (pieces < 2) return;
    const Vec3 &from = p.vertices[arc.from], &to = p.vertices[arc.to];
    if (!is_long(p, arc)) {
        const GreatArc whole(from, to);
        for (std::int32_t i = 1; i < pieces; ++i) *points++ = whole.at(double(i) / pieces);
        return;
    }
    const Vec3 middle = middle_of(p, arc);
    if (pieces == 2) {
        *points = middle;
        return;
    }
    const GreatArc first(from, middle), second(middle, to);
    for (std::int32_t i = 1; i < pieces; ++i)
        *points++ = 2 * i < pieces ? first.at(2.0 * i / pieces) : second.at(2.0 * i / pieces - 1);
}

double arc_length(const Polyhedra& p, const CellArc& arc) {
    const Vec3 &from = p.vertices[arc.from], &to = p.vertices[arc.to];
    if (!is_long(p, arc)) return angle_between(from, to);
    const Vec3 middle = middle_of(p, arc);
    return angle_between(from, middle) + angle_between(middle, to);
}

}  // namespace sinew::sqm
