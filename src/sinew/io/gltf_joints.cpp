// Of all that a glTF file holds only the tree of nodes and the lists of joints matter here, so that a JSON
// parser does and no buffer, image or extension needs to be there or be sound.
#include "sinew/io/gltf_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "sinew/io/gltf_nodes.h"
#include "sinew/io/gltf_text.h"
#include "sinew/io/measured.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

struct GltfNodes {
    GltfTree tree;
    std::vector<std::string> name;
    std::vector<char> is_joint;
};

/// `count` numbers of a key; `fallback` where there is no such key.
Result<std::array<double, 16>> numbers(const Json& node, const char* key, std::size_t count,
                                       const std::string& pointer, std::array<double, 16> fallback) {
    const Json* values = find(node, key);
    if (!values) return fallback;
    const std::string place = fmt::format("{}/{}", pointer, key);
    if (!values->is_array() || values->size() != count)
        return gltf_fault(place, fmt::format("the {} must be an array of {} numbers", key, count),
                          "export the file again");
    std::array<double, 16> result{};
    for (std::size_t k = 0; k < count; ++k) {
        if (!(*values)[k].is_number())
            return gltf_fault(place, fmt::format("the {} must be numbers", key), "export the file again");
        result[k] = (*values)[k].get<double>();
    }
    return result;
}

Result<Eigen::Affine3d> transform_of(const Json& node, const std::string& pointer) {
    if (find(node, "matrix")) {
        const auto matrix = numbers(node, "matrix", 16, pointer, {});
        if (!matrix) return fail(matrix.error());
        return gltf_transform(*matrix);
    }
    const auto translation = numbers(node, "translation", 3, pointer, {0, 0, 0});
    if (!translation) return fail(translation.error());
    const auto rotation = numbers(node, "rotation", 4, pointer, {0, 0, 0, 1});
    if (!rotation) return fail(rotation.error());
    const auto scale = numbers(node, "scale", 3, pointer, {1, 1, 1});
    if (!scale) return fail(scale.error());
    return gltf_transform(Eigen::Map<const Vec3>(translation->data()),
                          Quat(Eigen::Map<const Eigen::Vector4d>(rotation->data())),
                          Eigen::Map<const Vec3>(scale->data()));
}

/// An entry of an array of node numbers.
Result<std::int32_t> node_number(const Json& value, std::size_t count, const std::string& pointer) {
    const std::optional<std::int64_t> number = integer_in(value);
    if (!number || *number < 0 || *number >= static_cast<std::int64_t>(count))
        return gltf_fault(pointer, "this is no number of a node of the file", "export the file again");
    return static_cast<std::int32_t>(*number);
}

Result<GltfNodes> read_nodes(const Json& root) {
    const Json& list = array_in(root, "nodes");
    GltfNodes nodes{.is_joint = std::vector<char>(list.size(), 0)};
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string pointer = fmt::format("/nodes/{}", i);
        const Result<Eigen::Affine3d> transform = transform_of(list[i], pointer);
        if (!transform) return fail(transform.error());
        nodes.tree.to_parent.push_back(*transform);
        const Json* name = find(list[i], "name");
        nodes.name.push_back(name && name->is_string() ? name->get<std::string>() : "");
        const Json& children = array_in(list[i], "children");
        std::vector<std::int32_t>& numbers = nodes.tree.children.emplace_back();
        for (std::size_t k = 0; k < children.size(); ++k) {
            const auto child =
                node_number(children[k], list.size(), fmt::format("{}/children/{}", pointer, k));
            if (!child) return fail(child.error());
            numbers.push_back(*child);
        }
    }
    const Result<void> found = find_parents(nodes.tree);
    if (!found) return fail(found.error());
    return nodes;
}

Result<void> mark_joints_of_skins(const Json& root, GltfNodes& nodes) {
    const Json& skins = array_in(root, "skins");
    for (std::size_t s = 0; s < skins.size(); ++s) {
        const Json& joints = array_in(skins[s], "joints");
        for (std::size_t k = 0; k < joints.size(); ++k) {
            const auto joint =
                node_number(joints[k], nodes.is_joint.size(), fmt::format("/skins/{}/joints/{}", s, k));
            if (!joint) return fail(joint.error());
            nodes.is_joint[*joint] = 1;
        }
    }
    return {};
}

/// Where there is no skin: the scene's nodes and all below them.
Result<void> mark_scene(const Json& root, GltfNodes& nodes) {
    const Json& scenes = array_in(root, "scenes");
    const Json* chosen = find(root, "scene");
    const std::int64_t number = chosen ? integer_in(*chosen).value_or(-1) : 0;
    if (scenes.empty()) {
        std::ranges::fill(nodes.is_joint, 1);
        return {};
    }
    if (number < 0 || number >= static_cast<std::int64_t>(scenes.size()))
        return gltf_fault("/scene", "there is no such scene", "export the file again");
    const Json& list = array_in(scenes[number], "nodes");
    std::vector<std::int32_t> roots;
    for (std::size_t k = 0; k < list.size(); ++k) {
        const auto node =
            node_number(list[k], nodes.is_joint.size(), fmt::format("/scenes/{}/nodes/{}", number, k));
        if (!node) return fail(node.error());
        roots.push_back(*node);
    }
    for (const std::int32_t i : parents_first(nodes.tree, roots)) nodes.is_joint[i] = 1;
    return {};
}

Result<Document> joints(const GltfNodes& nodes) {
    const std::vector<std::int32_t>& parent = nodes.tree.parent;
    const std::vector<Eigen::Affine3d> world = to_world(nodes.tree);
    std::vector<std::int32_t> joint_above(parent.size(),
                                          -1);  // the node itself, or its nearest ancestor that is a joint
    for (const std::int32_t i : parents_first(nodes.tree, roots_of(nodes.tree)))
        joint_above[i] = nodes.is_joint[i] ? i : parent[i] < 0 ? -1 : joint_above[parent[i]];
    Document document{.unit = "m"};
    std::vector<std::int32_t> index(parent.size(), -1);
    for (std::int32_t i = 0; i < std::ssize(index); ++i) {
        if (!nodes.is_joint[i]) continue;
        index[i] = static_cast<std::int32_t>(document.nodes.size());
        const Vec3 position = gltf_to_z_up() * world[i].translation();
        if (!(position.cwiseAbs().maxCoeff() <= largest_length))
            return gltf_fault(fmt::format("/nodes/{}", i),
                              "the transforms lead to a position that is no finite number",
                              "export the file again");
        document.nodes.push_back({.id = i, .position = position});
        document.names.push_back(nodes.name[i]);
    }
    for (Node& node : document.nodes) {
        const std::int32_t above = parent[node.id] < 0 ? -1 : joint_above[parent[node.id]];
        node.parent = above < 0 ? -1 : index[above];
    }
    if (std::ranges::all_of(document.nodes, [](const Node& node) { return node.parent < 0; }))
        return fail(ErrorKind::input, "the file has no skeleton: no skin, and no node below another",
                    "export it with its armature");
    return document;
}

Result<Document> skeleton_in(const Json& root) {
    Result<GltfNodes> nodes = read_nodes(root);
    if (!nodes) return fail(std::move(nodes.error()));
    const bool has_skin = !array_in(root, "skins").empty();
    const Result<void> marked = has_skin ? mark_joints_of_skins(root, *nodes) : mark_scene(root, *nodes);
    if (!marked) return fail(marked.error());
    return joints(*nodes);
}

}  // namespace

Result<ReadSkeleton> parse_gltf(std::string_view bytes, const ReadOptions& options) try {
    const Result<Json> json = parse_gltf_text(bytes);
    if (!json) return fail(json.error());
    Result<Document> document = skeleton_in(*json);
    // A file without a skeleton is none that is broken, and the only one that is refused without a place.
    if (!document && document.error().path.empty()) return fail(std::move(document.error()));
    if (!document) return fail(broken_gltf(std::move(document.error()), bytes));
    ReadSkeleton read{.document = std::move(*document), .measured = true};
    const std::vector<double> radii = guess_radii(read.document);
    Remarks remarks;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        read.document.nodes[i].radius = radii[i];
        remarks.note(
            "node",
            "without a radius, which glTF does not know: guessed, a fifth of the mean length of the bones",
            read.document.nodes[i].id);
    }
    note_zero_lengths(read.document, {}, remarks);
    Result<Warnings> warnings = remarks.take(options.strict);
    if (!warnings) return fail(std::move(warnings.error()));
    read.warnings = std::move(*warnings);
    return read;
} catch (const std::exception& exception) {  // bad_alloc
    return fail(ErrorKind::program, fmt::format("the glTF file cannot be taken in ({})", exception.what()));
}

}  // namespace sinew
