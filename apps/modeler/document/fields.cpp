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

bool always(const Node&, std::int32_t) { return true; }
bool is_cube(const Node& node, std::int32_t) { return node.type == NodeType::cube; }
bool has_section(const Node& node, std::int32_t) { return node.type != NodeType::cube; }
bool has_depth(const Node& node, std::int32_t degree) {
    return node.type == NodeType::ball || (node.type != NodeType::cube && degree == 0);
}
bool can_turn(const Node& node, std::int32_t degree) {
    const bool solid = node.type == NodeType::cube || node.type == NodeType::ball;
    return solid && (node.parent < 0 || degree > 2);
}

Vec3 position_of(const Node& n) { return n.position; }
void set_position(Node& n, const Vec3& position) { n.position = position; }
Vec3 scale_of(const Node& n) { return {n.scale[0], n.scale[1], n.scale[2]}; }
void set_scale(Node& n, const Vec3& scale) { n.scale = {scale.x(), scale.y(), scale.z()}; }
Vec3 size_of(const Node& n) { return n.size ? *n.size : Vec3(Vec3::Constant(2 * n.radius)); }
void set_size(Node& n, const Vec3& size) { n.size = size; }
void set_angles(Node& n, const Vec3& degrees) { n.rotation = from_angles(degrees); }

/// What a node has three of, and which nodes have it.
struct Triple {
    Vec3 (*read)(const Node&);
    void (*write)(Node&, const Vec3&);
    Unit unit;
    double least, most;
    bool (*relevant)(const Node&, std::int32_t degree);
};
constexpr Triple position{position_of, set_position, Unit::length, -any, any, always};
constexpr Triple section{scale_of, set_scale, Unit::factor, tiny, any, has_section};
constexpr Triple solid{scale_of, set_scale, Unit::factor, tiny, any, has_depth};
constexpr Triple extents{size_of, set_size, Unit::length, tiny, any, is_cube};
constexpr Triple angles{angles_of, set_angles, Unit::degrees, -360, 360, can_turn};

/// The field of one of the three.
template <const Triple& triple, int axis>
constexpr Field part(const char* id, const char* group, const char* label, const char* tip) {
    return {id,
            group,
            label,
            tip,
            triple.unit,
            triple.least,
            triple.most,
            [](const Document& d, std::int32_t i) -> double { return triple.read(node(d, i))[axis]; },
            [](Document& d, std::int32_t i, double value) {
                Vec3 all = triple.read(node(d, i));
                all[axis] = value;
                triple.write(node(d, i), all);
            },
            triple.relevant};
}

const Field table[] = {
    part<position, 0>("x", "Position", "X", "Where the node is"),
    part<position, 1>("y", "Position", "Y", "Where the node is"),
    part<position, 2>("z", "Position", "Z", "Where the node is"),
    {"radius", "Radius", "", "Half the thickness of the tube here", Unit::length, tiny, any,
     [](const Document& d, std::int32_t i) { return node(d, i).radius; },
     [](Document& d, std::int32_t i, double v) { node(d, i).radius = v; }, always},
    part<section, 0>("width", "Section", "width", "Width of the section, as a factor of the radius"),
    part<section, 1>("height", "Section", "height", "Height of the section, as a factor of the radius"),
    part<solid, 2>("depth", "Section", "depth", "Third axis of an ellipsoid, as a factor of the radius"),
    part<extents, 0>("size_x", "Size", "X", "Extent of the box"),
    part<extents, 1>("size_y", "Size", "Y", "Extent of the box"),
    part<extents, 2>("size_z", "Size", "Z", "Extent of the box"),
    {"roll", "Roll", "", "Turn about the bone", Unit::degrees, -360, 360,
     [](const Document& d, std::int32_t i) { return node(d, i).roll; },
     [](Document& d, std::int32_t i, double v) { node(d, i).roll = v; }, always},
    part<angles, 0>("turn_x", "Rotation", "X", "Turn about the world's axes, x first"),
    part<angles, 1>("turn_y", "Rotation", "Y", "Turn about the world's axes, x first"),
    part<angles, 2>("turn_z", "Rotation", "Z", "Turn about the world's axes, x first"),
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
    const Adjacency around = adjacency(document);
    return std::all_of(nodes.begin(), nodes.end(),
                       [&](std::int32_t i) { return field.relevant(document.nodes[i], around.degree(i)); });
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
