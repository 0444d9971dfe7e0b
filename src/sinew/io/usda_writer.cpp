#include "sinew/io/usda_writer.h"

#include <algorithm>
#include <functional>

#include "sinew/io/text_numbers.h"

namespace sinew {
namespace {

constexpr float infinitely_sharp_in_usd = 10;

/// Appends `declaration = [item, item, ...]`, each item written by `put_item(i, at)` in at most `room`
/// characters.
template <class PutItem>
void append_array(std::string& text, std::string_view declaration, std::size_t count, std::size_t room,
                  const PutItem& put_item) {
    text.append("    ").append(declaration).append(" = [");
    append_items(
        text, count, [&](std::size_t begin, std::size_t end) { return (end - begin) * (room + 2); },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t i = begin; i < end; ++i) {
                if (i > 0) at = put(at, ", ");
                at = put_item(i, at);
            }
            return at;
        });
    text += "]\n";
}

void append_indices(std::string& text, std::string_view declaration, std::size_t count,
                    const std::function<std::uint32_t(std::size_t)>& index) {
    append_array(text, declaration, count, index_room,
                 [&](std::size_t i, char* at) { return put(at, index(i)); });
}

void append_floats(std::string& text, std::string_view declaration, std::size_t count,
                   const std::function<float(std::size_t)>& value) {
    append_array(text, declaration, count, float_room,
                 [&](std::size_t i, char* at) { return put(at, value(i)); });
}

void append_points(std::string& text, std::string_view declaration, std::span<const Vec3f> points) {
    append_array(text, declaration, points.size(), 3 * float_room + 6, [&](std::size_t i, char* at) {
        for (int k = 0; k < 3; ++k) at = put(put(at, k == 0 ? "(" : ", "), points[i][k]);
        return put(at, ")");
    });
}

void append_extent(const QuadMesh& mesh, std::string& text) {
    if (mesh.positions.empty()) return;
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : mesh.positions) box.extend(p);
    append_points(text, "float3[] extent", std::array{box.min(), box.max()});
}

void append_sharp_parts(const Features& features, std::string& text) {
    const std::vector<Crease>& creases = features.creases;
    if (!creases.empty()) {
        append_indices(text, "int[] creaseIndices", 2 * creases.size(),
                       [&](std::size_t i) { return creases[i / 2].edge[i % 2]; });
        append_indices(text, "int[] creaseLengths", creases.size(), [](std::size_t) { return 2u; });
        append_floats(text, "float[] creaseSharpnesses", creases.size(),
                      [&](std::size_t i) { return std::min(creases[i].sharpness, infinitely_sharp_in_usd); });
    }
    const std::vector<std::uint32_t>& corners = features.corners;
    if (!corners.empty()) {
        append_indices(text, "int[] cornerIndices", corners.size(),
                       [&](std::size_t i) { return corners[i]; });
        append_floats(text, "float[] cornerSharpnesses", corners.size(),
                      [](std::size_t) { return infinitely_sharp_in_usd; });
    }
}

std::string double_text(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

}  // namespace

std::string usda_text(const QuadMesh& mesh, double metres_a_unit) {
    std::string text =
        "#usda 1.0\n(\n    defaultPrim = \"sinew\"\n    metersPerUnit = " + double_text(metres_a_unit) +
        "\n    upAxis = \"Z\"\n)\n\ndef Mesh \"sinew\"\n{\n";
    append_extent(mesh, text);
    append_indices(text, "int[] faceVertexCounts", mesh.face_count(),
                   [&](std::size_t f) { return static_cast<std::uint32_t>(mesh.face(f).size()); });
    append_indices(text, "int[] faceVertexIndices", mesh.corners.size(),
                   [&](std::size_t i) { return mesh.corners[i]; });
    append_points(text, "point3f[] points", mesh.positions);
    append_sharp_parts(mesh.features, text);
    text += "    uniform token orientation = \"rightHanded\"\n";
    text += "    uniform token subdivisionScheme = \"catmullClark\"\n}\n";
    return text;
}

}  // namespace sinew
