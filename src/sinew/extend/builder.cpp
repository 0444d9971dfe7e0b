#include "sinew/extend/builder.h"

#include <fmt/format.h>

#include "sinew/skeleton/frames.h"

namespace sinew {
namespace {

// Of the radius: nodes at distance zero are put that far apart, so that bones have directions. Those that
// were drawn a thousandth of that apart, which is near to what double precision can tell, count as such.
constexpr double hair = 1e-6, no_distance = 1e-3 * hair;

}  // namespace

PlainBuilder::PlainBuilder(const Document& document, const CleanGraph& graph, Warnings& warnings)
    : document_(document),
      graph_(graph),
      warnings_(warnings),
      adjacency_(adjacency(static_cast<std::int32_t>(graph.position.size()), graph.bones)),
      position_(graph.position),
      attached_(graph.bones),
      attached_kind_(graph.bones.size(), BoneKind::tube) {
    part_coincident();
    plain_.position = position_;
    plain_.radius = graph.radius;
    plain_.source_node = graph.source_node;
    plain_.cap.assign(position_.size(), Cap::round);
    plain_.form_of.assign(position_.size(), -1);
    plain_.pit_depth.assign(position_.size(), 0);
}

void PlainBuilder::part_coincident() {
    for (const Bone& bone : graph_.bones) {
        const auto [a, b] = bone;
        if ((position_[a] - position_[b]).norm() > no_distance * std::max(radius(a), radius(b))) continue;
        Vec3 along = Vec3::UnitZ();  // on from the bone before, if there is one
        for (const std::int32_t before : adjacency_.bones(a)) {
            const Vec3 v = position_[a] - position_[other(before, a)];
            if (v.norm() > hair * radius(a)) along = v.normalized();
        }
        position_[b] = position_[a] + hair * radius(b) * along;
    }
}

bool PlainBuilder::is_plain_ball(std::int32_t i) const {
    const Node& n = drawn(i);
    return n.type == NodeType::sphere && n.section == Section::round &&
           n.scale == std::array<double, 3>{1, 1, 1} && n.joint == 0;
}

bool PlainBuilder::is_pit(std::int32_t i) const {
    if (type(i) != NodeType::negative || degree(i) != 1) return false;
    const std::int32_t on = other(bones(i)[0], i);
    return type(on) != NodeType::negative || degree(on) > 1 || on < i;
}

std::int32_t PlainBuilder::other(std::int32_t bone, std::int32_t i) const {
    const Bone& ends = graph_.bones[bone];
    return ends[0] == i ? ends[1] : ends[0];
}

Vec3 PlainBuilder::direction(std::int32_t from, std::int32_t to) const {
    return (position_[to] - position_[from]).normalized();
}

std::int32_t PlainBuilder::first_bone(std::int32_t i) const {
    for (const std::int32_t bone : bones(i))
        if (graph_.source_node[other(bone, i)] == drawn(i).parent) return bone;
    return bones(i)[0];
}

Frame PlainBuilder::frame(std::int32_t i) const {
    Surroundings around{.degree = degree(i)};
    if (around.degree > 0) {
        const std::int32_t bone = first_bone(i);
        const double sense = drawn(i).parent < 0 ? 1 : -1;
        around.first = around.second = sense * direction(i, other(bone, i));
        for (const std::int32_t b : bones(i))
            if (b != bone) around.second = -sense * direction(i, other(b, i));
    }
    const Mat3 m = local_frame(drawn(i), around);
    return {m.col(0), m.col(1), m.col(2)};
}

std::int32_t PlainBuilder::add_node(const Vec3& position, double radius, std::int32_t of) {
    return plain_.add_node(position, radius, graph_.source_node[of]);
}

void PlainBuilder::add_bone(std::int32_t a, std::int32_t b, BoneKind kind) {
    plain_.add_bone(a, b, kind, -1);
}

void PlainBuilder::set_form(std::int32_t node, const Form& form) {
    plain_.form_of[node] = static_cast<std::int32_t>(plain_.forms.size());
    plain_.forms.push_back(form);
}

void PlainBuilder::attach(std::int32_t bone, std::int32_t i, std::int32_t plain_node) {
    attached_[bone][graph_.bones[bone][0] == i ? 0 : 1] = plain_node;
}

void PlainBuilder::warn(std::int32_t i, std::string_view what) {
    warnings_.push_back({fmt::format("node {}: {}", drawn(i).id, what), 1, {drawn(i).id}});
}

Plain PlainBuilder::finish() {
    std::vector<Bone> bones = std::move(plain_.bones);
    std::vector<BoneKind> kinds = std::move(plain_.bone_kind);
    std::vector<std::int32_t> sources = std::move(plain_.source_bone);
    plain_.bones.assign(attached_.begin(), attached_.end());
    plain_.bones.insert(plain_.bones.end(), bones.begin(), bones.end());
    plain_.bone_kind = attached_kind_;
    plain_.bone_kind.insert(plain_.bone_kind.end(), kinds.begin(), kinds.end());
    plain_.source_bone = graph_.source_bone;
    plain_.source_bone.insert(plain_.source_bone.end(), sources.begin(), sources.end());
    return std::move(plain_);
}

}  // namespace sinew
