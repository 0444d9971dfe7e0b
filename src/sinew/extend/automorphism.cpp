#include "sinew/extend/automorphism.h"

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

bool bones_follow(std::vector<Bone> bones, const std::vector<std::int32_t>& image) {
    std::vector<Bone> images;
    for (const Bone& b : bones) images.push_back({image[b[0]], image[b[1]]});
    return sorted(std::move(bones)) == sorted(std::move(images));
}

}  // namespace sinew
