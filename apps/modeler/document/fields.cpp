#include "document/fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sinew/skeleton/graph.h"

namespace sinew::modeler {
namespace {

constexpr double any = 1e9;
constexpr double tiny = 1e-6;
constexpr double degree = std::numbers::pi / 180;

const Node& node(const Document& d, std::int32_t i) { return d.nodes[i]; }
Node& node(Document& d, std::int32_t i) { return d.nodes[i]; }

bool always(const Document&, std::int32_t) { return true; }
bool is_cube(const Document& d, std::int32_t i) { return node(d, i).type == NodeType::cube; }
bool has_section(const Document& d, std::int32_t i) { return !is_cube(d, i); }

/// Bones at a node; the documents that people edit by hand are small.
int degree_of(const Document& d, std::int32_t i) {
    int count = node(d, i).parent >= 0;
    for (const Node& other : d.nodes) count += other.parent == i;
    for (const auto& link : d.links) count += (link[0] == i) + (link[1] == i);
    return count;
}
bool has_depth(const Document& d, std::int32_t i) {
    return node(d, i).type == NodeType::ball || (has_section(d, i) && degree_of(d, i) == 0);
}
bool can_turn(const Document& d, std::int32_t i) {
    const bool solid = is_cube(d, i) || node(d, i).type == NodeType::ball;
    return solid && (node(d, i).parent < 0 || degree_of(d, i) > 2);
}

template <int axis>
double get_position(const Document& d, std::int32_t i) {
    return node(d, i).position[axis];
}
template <int axis>
void put_position(Document& d, std::int32_t i, double value) {
    node(d, i).position[axis] = value;
}
template <int axis>
double get_scale(const Document& d, std::int32_t i) {
    return node(d, i).scale[axis];
}
template <int axis>
void put_scale(Document& d, std::int32_t i, double value) {
    node(d, i).scale[axis] = value;
}
Vec3 size_of(const Node& n) { return n.size ? *n.size : Vec3(Vec3::Constant(2 * n.radius)); }
template <int axis>
double get_size(const Document& d, std::int32_t i) {
    return size_of(node(d, i))[axis];
}
template <int axis>
void put_size(Document& d, std::int32_t i, double value) {
    Vec3 size = size_of(node(d, i));
    size[axis] = value;
    node(d, i).size = size;
}
template <int axis>
double get_angle(const Document& d, std::int32_t i) {
    return angles_of(node(d, i))[axis];
}
template <int axis>
void put_angle(Document& d, std::int32_t i, double value) {
    Vec3 angles = angles_of(node(d, i));
    angles[axis] = value;
    node(d, i).rotation = from_angles(angles);
}

const Field table[] = {
    {"x", "Position", "X", "Where the node is", Unit::length, -any, any, get_position<0>, put_position<0>,
     always},
    {"y", "Position", "Y", "Where the node is", Unit::length, -any, any, get_position<1>, put_position<1>,
     always},
    {"z", "Position", "Z", "Where the node is", Unit::length, -any, any, get_position<2>, put_position<2>,
     always},
    {"radius", "Radius", "", "Half the thickness of the tube here", Unit::length, tiny, any,
     [](const Document& d, std::int32_t i) { return node(d, i).radius; },
     [](Document& d, std::int32_t i, double v) { node(d, i).radius = v; }, always},
    {"width", "Section", "W", "Width of the section, as a factor of the radius", Unit::factor, tiny, any,
     get_scale<0>, put_scale<0>, has_section},
    {"height", "Section", "H", "Height of the section, as a factor of the radius", Unit::factor, tiny, any,
     get_scale<1>, put_scale<1>, has_section},
    {"depth", "Section", "D", "Third axis of an ellipsoid, as a factor of the radius", Unit::factor, tiny,
     any, get_scale<2>, put_scale<2>, has_depth},
    {"size_x", "Size", "X", "Extent of the box", Unit::length, tiny, any, get_size<0>, put_size<0>, is_cube},
    {"size_y", "Size", "Y", "Extent of the box", Unit::length, tiny, any, get_size<1>, put_size<1>, is_cube},
    {"size_z", "Size", "Z", "Extent of the box", Unit::length, tiny, any, get_size<2>, put_size<2>, is_cube},
    {"roll", "Roll", "", "Turn about the bone", Unit::degrees, -360, 360,
     [](const Document& d, std::int32_t i) { return node(d, i).roll; },
     [](Document& d, std::int32_t i, double v) { node(d, i).roll = v; }, always},
    {"turn_x", "Rotation", "X", "Turn about the world's axes, x first", Unit::degrees, -360, 360,
     get_angle<0>, put_angle<0>, can_turn},
    {"turn_y", "Rotation", "Y", "Turn about the world's axes, x first", Unit::degrees, -360, 360,
     get_angle<1>, put_angle<1>, can_turn},
    {"turn_z", "Rotation", "Z", "Turn about the world's axes, x first", Unit::degrees, -360, 360,
     get_angle<2>, put_angle<2>, can_turn},
    {"joint", "Joint", "", "Sharpness of the ring here: 0 smooth, 10 and above a sharp edge at any level",
     Unit::factor, 0, 10, [](const Document& d, std::int32_t i) { return std::min(node(d, i).joint, 10.0); },
     [](Document& d, std::int32_t i, double v) { node(d, i).joint = v >= 10 ? infinitely_sharp : v; },
     always},
};

}  // namespace

std::span<const Field> fields() { return table; }

const Field* find_field(std::string_view id) {
    for (const Field& field : table)
        if (field.id == id) return &field;
    return nullptr;
}

std::optional<double> common_value(const Document& document, std::span<const std::int32_t> nodes,
                                   const Field& field) {
    if (nodes.empty()) return std::nullopt;
    const double value = field.get(document, nodes.front());
    for (std::int32_t i : nodes)
        if (field.get(document, i) != value) return std::nullopt;
    return value;
}

bool relevant_to_all(const Document& document, std::span<const std::int32_t> nodes, const Field& field) {
    return std::all_of(nodes.begin(), nodes.end(),
                       [&](std::int32_t i) { return field.relevant(document, i); });
}

Document with_value(Document document, std::span<const std::int32_t> nodes, const Field& field,
                    double value) {
    for (std::int32_t i : nodes) field.put(document, i, std::clamp(value, field.least, field.most));
    return document;
}

Vec3 angles_of(const Node& node) {
    if (!node.rotation) return Vec3::Zero();
    const Mat3 m = node.rotation->normalized().toRotationMatrix();
    const double y = std::asin(std::clamp(-m(2, 0), -1.0, 1.0));
    const bool locked = std::abs(m(2, 0)) > 1 - 1e-12;
    const double x = locked ? 0 : std::atan2(m(2, 1), m(2, 2));
    const double z = locked ? std::atan2(-m(0, 1), m(1, 1)) : std::atan2(m(1, 0), m(0, 0));
    return Vec3(x, y, z) / degree;
}

Quat from_angles(const Vec3& degrees) {
    const Vec3 a = degrees * degree;
    return Eigen::AngleAxisd(a.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(a.y(), Vec3::UnitY()) *
           Eigen::AngleAxisd(a.x(), Vec3::UnitX());
}

}  // namespace sinew::modeler
