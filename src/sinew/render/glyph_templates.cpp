#include "sinew/render/glyph_templates.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace sinew::gl {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// A grid of rows by (segments + 1) vertices, counter-clockwise seen from the side that rows x columns points
/// to.
void add_grid_indices(std::vector<std::uint32_t>& indices, std::uint32_t first, std::uint32_t rows,
                      std::uint32_t segments) {
    const std::uint32_t columns = segments + 1;
    for (std::uint32_t r = 0; r + 1 < rows; ++r)
        for (std::uint32_t c = 0; c < segments; ++c) {
            const std::uint32_t a = first + r * columns + c, b = a + 1, d = a + columns, e = d + 1;
            indices.insert(indices.end(), {a, b, e, a, e, d});
        }
}

/// A point of a profile that is turned about z: distance from the axis, height, and the normal likewise.
struct Profile {
    float radius, height, normal_radius, normal_height;
};

class Turner {
  public:
    Turner(ShapeTemplates& out, int segments) : out_(out), segments_(segments) {}

    /// The profile runs from the bottom up, the outside on its right.
    void turn(const std::vector<Profile>& profile) {
        const auto first = static_cast<std::uint32_t>(out_.vertices.size());
        for (const Profile& p : profile)
            for (int s = 0; s <= segments_; ++s) {
                const float angle =
                    2 * pi * static_cast<float>(s % segments_) / static_cast<float>(segments_);
                const float x = std::cos(angle), y = std::sin(angle);
                out_.vertices.push_back({{p.radius * x, p.radius * y, p.height},
                                         {p.normal_radius * x, p.normal_radius * y, p.normal_height}});
            }
        add_grid_indices(out_.indices, first, static_cast<std::uint32_t>(profile.size()),
                         static_cast<std::uint32_t>(segments_));
    }

  private:
    ShapeTemplates& out_;
    int segments_;
};

std::vector<Profile> arc(float from, float to, int steps) {
    std::vector<Profile> profile;
    for (int i = 0; i <= steps; ++i) {
        const float a = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps);
        profile.push_back({std::cos(a), std::sin(a), std::cos(a), std::sin(a)});
    }
    return profile;
}

void add_box(ShapeTemplates& out) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.f, 1.f}) {
            const auto first = static_cast<std::uint32_t>(out.vertices.size());
            for (const auto& [u, v] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}}) {
                TemplateVertex vertex{};
                vertex.position[axis] = vertex.normal[axis] = side;
                vertex.position[(axis + 1) % 3] = u * side;
                vertex.position[(axis + 2) % 3] = v;
                out.vertices.push_back(vertex);
            }
            out.indices.insert(out.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
}

}  // namespace

ShapeTemplates shape_templates(int segments) {
    ShapeTemplates out;
    Turner turner(out, segments);
    const float slope = std::sqrt(5.f);
    const auto range = [&](GlyphShape shape, const std::function<void()>& add) {
        IndexRange& r = out.ranges[static_cast<std::size_t>(shape)];
        r.first = static_cast<std::uint32_t>(out.indices.size());
        add();
        r.count = static_cast<std::uint32_t>(out.indices.size()) - r.first;
    };
    range(GlyphShape::sphere, [&] { turner.turn(arc(-pi / 2, pi / 2, segments / 2)); });
    range(GlyphShape::half_sphere, [&] {
        turner.turn(arc(-pi / 2, 0, segments / 4 + 1));
        turner.turn({{1, 0, 0, 1}, {0, 0, 0, 1}});
    });
    range(GlyphShape::cone, [&] {
        turner.turn({{0, -2, 0, -1}, {1, -2, 0, -1}});
        turner.turn({{1, -2, 2 / slope, 1 / slope}, {0, 0, 2 / slope, 1 / slope}});
    });
    range(GlyphShape::box, [&] { add_box(out); });
    return out;
}

BoneTemplate bone_template(int segments) {
    BoneTemplate out;
    const auto columns = static_cast<std::uint32_t>(segments);
    for (int part = 0; part < 3; ++part) {
        const int steps = part == 1 ? 1 : segments / 4 + 1;
        const auto first = static_cast<std::uint32_t>(out.vertices.size());
        for (int i = 0; i <= steps; ++i)
            for (int s = 0; s <= segments; ++s) {
                const float angle = 2 * pi * static_cast<float>(s % segments) / static_cast<float>(segments);
                out.vertices.push_back({std::cos(angle), std::sin(angle), static_cast<float>(part),
                                        static_cast<float>(i) / static_cast<float>(steps)});
            }
        add_grid_indices(out.indices, first, static_cast<std::uint32_t>(steps + 1), columns);
    }
    return out;
}

}  // namespace sinew::gl
