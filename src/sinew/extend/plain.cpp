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

bool is_ellipsoid(const Form* form) {
    return form && form->kind == Form::Kind::ball &&
           !(form->half.x() == form->half.y() && form->half.y() == form->half.z());
}

/// The direction with its parts along the form's axes scaled.
Vec3 stretched(const Form& form, const Vec3& direction, const Vec3& by) {
    return (direction.dot(form.x) * by.x() * form.x + direction.dot(form.y) * by.y() * form.y +
            direction.dot(form.z) * by.z() * form.z)
        .normalized();
}

}  // namespace

Vec3 from_ball_space(const Form* form, const Vec3& direction) {
    return is_ellipsoid(form) ? stretched(*form, direction, form->half) : direction;
}
Vec3 to_ball_space(const Form* form, const Vec3& direction) {
    return is_ellipsoid(form) ? stretched(*form, direction, form->half.cwiseInverse()) : direction;
}

bool bones_follow(const Plain& skeleton, const std::vector<std::int32_t>& image) {
    std::vector<Bone> images;
    for (const Bone& b : skeleton.bones) images.push_back({image[b[0]], image[b[1]]});
    return sorted(skeleton.bones) == sorted(std::move(images));
}

}  // namespace sinew
