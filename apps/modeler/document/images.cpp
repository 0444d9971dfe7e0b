#include "document/images.h"

#include <fmt/format.h>

#include "sinew/skeleton/symmetry.h"

namespace sinew::modeler {

std::vector<Mat3> images_of(const Symmetry& symmetry) {
    const int count = symmetry.kind == Symmetry::Kind::none     ? 1
                      : symmetry.kind == Symmetry::Kind::mirror ? 2
                                                                : symmetry.count;
    std::vector<Mat3> images;
    images.reserve(count);
    for (int i = 0; i < count; ++i) images.push_back(symmetry_transform(symmetry, i));
    return images;
}

Vec3 onto_symmetry(const Symmetry& symmetry, const Vec3& point) {
    Vec3 result = point;
    if (symmetry.kind == Symmetry::Kind::mirror) result[symmetry.axis] = 0;
    if (symmetry.kind == Symmetry::Kind::radial) result = point[symmetry.axis] * Vec3::Unit(symmetry.axis);
    return result;
}

bool is_own_twin(const Symmetry& symmetry, const Vec3& point, double size) {
    return (onto_symmetry(symmetry, point) - point).norm() <= 1e-9 * size;
}

std::string describe(const Symmetry& symmetry) {
    const char axis = static_cast<char>('x' + symmetry.axis);
    switch (symmetry.kind) {
        case Symmetry::Kind::mirror:
            return fmt::format("mirror {}", axis);
        case Symmetry::Kind::radial:
            return fmt::format("radial {}, {}", axis, symmetry.count);
        default:
            return "no symmetry";
    }
}

}  // namespace sinew::modeler
