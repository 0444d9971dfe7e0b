#include "sinew/io/stl.h"

#include "sinew/io/byte_order.h"
#include "sinew/io/text_numbers.h"
#include "sinew/mesh/triangulate.h"

namespace sinew {
namespace {

Vec3f unit_normal(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3 origin = a.cast<double>();
    const Vec3 normal = (b.cast<double>() - origin).cross(c.cast<double>() - origin);
    const double length = normal.norm();
    return length > 0 ? Vec3f((normal / length).cast<float>()) : Vec3f::Zero();
}

char* put_vector(char* at, const Vec3f& v) {
    for (const float value : v) at = put_little_endian(at, value);
    return at;
}

}  // namespace

std::string stl_bytes(const QuadMesh& mesh) {
    const Triangles cut = triangulate(mesh);
    std::string bytes = "binary STL, Sinew";  // must not start with "solid", which would mean text
    bytes.resize(84);
    put_little_endian(bytes.data() + 80, static_cast<std::uint32_t>(cut.triangles.size()));
    append_items(
        bytes, cut.triangles.size(), [](std::size_t begin, std::size_t end) { return 50 * (end - begin); },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t t = begin; t < end; ++t) {
                const auto& [a, b, c] = cut.triangles[t];
                at = put_vector(at, unit_normal(mesh.positions[a], mesh.positions[b], mesh.positions[c]));
                for (const std::uint32_t v : cut.triangles[t]) at = put_vector(at, mesh.positions[v]);
                at = put_little_endian(at, std::uint16_t{0});
            }
            return at;
        });
    return bytes;
}

}  // namespace sinew
