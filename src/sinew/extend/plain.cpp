#include "sinew/extend/plain.h"

namespace sinew {

std::int32_t Plain::add_node(const Vec3& at, double ball, std::int32_t source) {
    position.push_back(at);
    radius.push_back(ball);
    cap.push_back(Cap::round);
    form_of.push_back(-1);
    pit_depth.push_back(0);
    source_node.push_back(source);
    return node_count() - 1;
}

void Plain::add_bone(std::int32_t a, std::int32_t b, BoneKind kind, std::int32_t source) {
    bones.push_back({a, b});
    bone_kind.push_back(kind);
    source_bone.push_back(source);
}

}  // namespace sinew
