#include "sinew/extend/extend.h"

#include "sinew/extend/bodies.h"
#include "sinew/extend/builder.h"
#include "sinew/extend/cubes.h"
#include "sinew/extend/sections.h"

namespace sinew {
namespace {

/// Two cones that look at each other have no tube to stand on: a ring of the mean of their radii goes
/// between.
void part_double_cones(PlainBuilder& builder, Plain& plain) {
    for (std::int32_t b = 0; b < static_cast<std::int32_t>(plain.bones.size()); ++b) {
        const auto [from, to] = plain.bones[b];
        if (plain.cap[from] != Cap::point || plain.cap[to] != Cap::point) continue;
        const std::int32_t middle = plain.node_count();
        plain.position.push_back(0.5 * (plain.position[from] + plain.position[to]));
        plain.radius.push_back(0.5 * (builder.radius(from) + builder.radius(to)));
        plain.cap.push_back(Cap::round);
        plain.form_of.push_back(-1);
        plain.pit_depth.push_back(0);
        plain.source_node.push_back(plain.source_node[from]);
        plain.bones[b][1] = middle;
        plain.bones.push_back({middle, to});
        plain.bone_kind.push_back(BoneKind::tube);
        plain.source_bone.push_back(plain.source_bone[b]);
    }
}

}  // namespace

Plain extend(const Document& document, const CleanGraph& graph, Warnings& warnings) {
    PlainBuilder builder(document, graph, warnings);
    for (std::int32_t i = 0; i < builder.node_count(); ++i) {
        if (builder.is_plain_ball(i)) continue;
        if (builder.type(i) == NodeType::cube)
            add_cube(builder, i);
        else if (builder.type(i) == NodeType::ball)
            add_ball(builder, i);
        else
            add_section(builder, i);
    }
    for (std::int32_t i = 0; i < builder.node_count(); ++i)
        if (builder.is_pit(i)) add_pit(builder, i);
    Plain plain = builder.finish();
    part_double_cones(builder, plain);
    return plain;
}

}  // namespace sinew
