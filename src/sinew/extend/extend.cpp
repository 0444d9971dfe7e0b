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
        const std::int32_t middle =
            plain.add_node(0.5 * (plain.position[from] + plain.position[to]),
                           0.5 * (builder.radius(from) + builder.radius(to)), plain.source_node[from]);
        plain.bones[b][1] = middle;
        plain.add_bone(middle, to, BoneKind::tube, plain.source_bone[b]);
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
