#include "sinew/extend/plain.h"

#include <algorithm>

namespace sinew {
namespace {

std::vector<Bone> sorted(std::vector<Bone> bones) {
    for (Bone& b : bones)
        if (b[0] > b[1]) std::swap(b[0], b[1]);
    std::sort(bones.begin(), bones.end());
    return bones;
}

}  // namespace

Vec3 stretched(const Form& form, const Vec3& direction, const Vec3& by) {
    return (direction.dot(form.x) * by.x() * form.x + direction.dot(form.y) * by.y() * form.y +
            direction.dot(form.z) * by.z() * form.z)
        .normalized();
}

bool bones_follow(const Plain& skeleton, const std::vector<std::int32_t>& image) {
    std::vector<Bone> images;
    for (const Bone& b : skeleton.bones) images.push_back({image[b[0]], image[b[1]]});
    return sorted(skeleton.bones) == sorted(std::move(images));
}

}  // namespace sinew
