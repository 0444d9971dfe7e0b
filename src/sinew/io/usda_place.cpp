#include "sinew/io/usda_place.h"

#include <numbers>
#include <string_view>

namespace sinew {
namespace {

using Numbers = std::vector<double>;

Mat3 turn_about(int axis, double degrees) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::Unit(axis)).toRotationMatrix();
}

/// rotateX, rotateXYZ and the like: the first letter is turned about first.
std::optional<Mat3> turns(std::string_view axes, const Numbers& degrees) {
    const bool single = axes.size() == 1;
    if ((!single && axes.size() != 3) || degrees.size() != axes.size()) return std::nullopt;
    Mat3 result = Mat3::Identity();
    for (const char letter : axes) {
        if (letter < 'X' || letter > 'Z') return std::nullopt;
        const int axis = letter - 'X';
        result = turn_about(axis, degrees[single ? 0 : static_cast<std::size_t>(axis)]) * result;
    }
    return result;
}

std::optional<Eigen::Matrix4d> operation(std::string_view kind, const Numbers& n) {
    Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
    if (kind == "translate" && n.size() == 3) {
        matrix.translate(Vec3(n[0], n[1], n[2]));
    } else if (kind == "scale" && n.size() == 3) {
        matrix.scale(Vec3(n[0], n[1], n[2]));
    } else if (kind == "orient" && n.size() == 4) {
        const Quat turn(n[0], n[1], n[2], n[3]);
        if (!(turn.norm() > 0)) return std::nullopt;
        matrix.rotate(turn.normalized());
    } else if (kind == "transform" && n.size() == 16) {
        // USD writes rows, and multiplies them by vectors from the left: Eigen's columns.
        return Eigen::Map<const Eigen::Matrix4d>(n.data());
    } else if (kind.starts_with("rotate")) {
        const std::optional<Mat3> turn = turns(kind.substr(6), n);
        if (!turn) return std::nullopt;
        matrix.rotate(*turn);
    } else {
        return std::nullopt;
    }
    return matrix.matrix();
}

/// xformOp:translate and xformOp:translate:pivot are both of the kind translate.
std::string_view kind_of(std::string_view name) {
    const std::string_view rest = name.substr(name.find(':') + 1);
    return rest.substr(0, rest.find(':'));
}

}  // namespace

std::optional<Eigen::Matrix4d> matrix_of(const UsdaPlace& place, bool& resets) {
    constexpr std::string_view invert = "!invert!";
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (const std::string_view entry : place.order) {
        if (entry == "!resetXformStack!") {
            resets = true;
            continue;
        }
        const bool inverse = entry.starts_with(invert);
        const std::string_view name = inverse ? entry.substr(invert.size()) : entry;
        const auto found = place.operations.find(name);
        if (found == place.operations.end()) return std::nullopt;
        std::optional<Eigen::Matrix4d> step = operation(kind_of(name), found->second);
        if (!step) return std::nullopt;
        if (inverse) *step = Eigen::Matrix4d(step->inverse());
        matrix = matrix * *step;
    }
    return matrix;
}

}  // namespace sinew
