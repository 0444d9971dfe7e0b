#include "sinew/io/gltf_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "sinew/io/gltf_model.h"
#include "sinew/io/gltf_nodes.h"
#include "sinew/io/gltf_text.h"
#include "sinew/io/ngon_encoding.h"
#include "sinew/mesh/topology.h"
#include "sinew/mesh/weld.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

/// Vertices and corners that may come of each byte of a file; and how many may come of a small one.
constexpr int largest_expansion = 16;
constexpr double least_numbers = 4'000'000;

/// Strips and fans as plain triangles.
std::vector<Triangle> triangles_of(const std::vector<Index>& v, int mode) {
    std::vector<Triangle> triangles;
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for (std::size_t i = 0; i + 2 < v.size(); i += step) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            triangles.push_back({v[0], v[i + 1], v[i + 2]});
        else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1)
            triangles.push_back({v[i + 1], v[i], v[i + 2]});
        else
            triangles.push_back({v[i], v[i + 1], v[i + 2]});
    }
    return triangles;
}

bool has_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

bool says_shared(const tinygltf::Primitive& primitive) {
    if (!primitive.extras.IsObject() || !primitive.extras.Has("shared_vertices")) return false;
    const tinygltf::Value& shared = primitive.extras.Get("shared_vertices");
    return shared.IsBool() && shared.Get<bool>();
}

class MeshReader {
  public:
    /// @param size  bytes of the file and of those that it names
    MeshReader(const tinygltf::Model& model, const std::string& name, std::uint64_t size)
        : model_(model), name_(name), size_(size) {}

    Result<QuadMesh> read() {
        const Result<std::vector<PlacedNode>> nodes = place_nodes(model_, name_);
        if (!nodes) return tl::unexpected(nodes.error());
        if (auto bounded = check_expansion(*nodes); !bounded) return tl::unexpected(bounded.error());
        for (const PlacedNode& placed : *nodes)
            if (auto done = read_node(placed); !done) return tl::unexpected(done.error());
        if (!shared_) mesh_ = welded(mesh_);  // which drops triangles of a single point or line
        if (mesh_.face_count() == 0)
            return cannot("there are no triangles in it", "export it with its meshes");
        return std::move(mesh_);
    }

  private:
    tl::unexpected<Error> wrong(std::string message, std::string path) const {
        return fail(
            broken_gltf(Error{.message = std::move(message), .file = name_, .path = std::move(path)}));
    }
    tl::unexpected<Error> cannot(std::string message, std::string cure, std::string path = {}) const {
        return fail(Error{
            .message = std::move(message), .cure = std::move(cure), .file = name_, .path = std::move(path)});
    }

    /// Nodes may show one mesh any number of times, and primitives share their data: what comes of a file is
    /// counted before any of it is made.
    Result<void> check_expansion(const std::vector<PlacedNode>& nodes) const {
        std::vector<double> cost;
        for (const tinygltf::Mesh& mesh : model_.meshes) {
            double sum = 1;
            for (const tinygltf::Primitive& primitive : mesh.primitives) sum += cost_of(primitive);
            cost.push_back(sum);
        }
        const double most = std::max(least_numbers, double(largest_expansion) * double(size_));
        double made = 0;
        for (const PlacedNode& placed : nodes) {
            const int mesh = model_.nodes[static_cast<std::size_t>(placed.node)].mesh;
            if (mesh < 0 || mesh >= static_cast<int>(cost.size())) continue;
            made += cost[static_cast<std::size_t>(mesh)];
            if (made > most)
                return cannot(fmt::format("meshes that are shown again and again come to more than {:.0f} "
                                          "vertices and corners, too many for {} bytes of file and data",
                                          most, size_),
                              "export fewer instances", fmt::format("/nodes/{}", placed.node));
        }
        return {};
    }

    /// Vertices and corners of a primitive, as the file has them.
    double cost_of(const tinygltf::Primitive& primitive) const {
        const auto count = [&](int accessor) {
            const bool exists = accessor >= 0 && accessor < static_cast<int>(model_.accessors.size());
            return exists ? double(model_.accessors[static_cast<std::size_t>(accessor)].count) : 0.0;
        };
        const auto position = primitive.attributes.find("POSITION");
        const double vertices = position == primitive.attributes.end() ? 0 : count(position->second);
        const double corners = primitive.indices < 0 ? vertices : count(primitive.indices);
        return 1 + vertices + (primitive.mode == TINYGLTF_MODE_TRIANGLES ? 1 : 3) * corners;
    }

    Result<void> read_node(const PlacedNode& placed) {
        const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(placed.node)];
        if (node.mesh < 0) return {};
        if (node.mesh >= static_cast<int>(model_.meshes.size()))
            return wrong("there is no such mesh", fmt::format("/meshes/{}", node.mesh));
        // A skin places its mesh itself: the node's own place has no say, as the specification puts it.
        Eigen::Affine3d to_world = gltf_to_z_up();
        if (node.skin < 0) to_world = to_world * placed.to_world;
        const std::vector<tinygltf::Primitive>& primitives =
            model_.meshes[static_cast<std::size_t>(node.mesh)].primitives;
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            path_ = fmt::format("/meshes/{}/primitives/{}", node.mesh, p);
            if (!has_triangles(primitives[p])) continue;
            if (auto done = read_primitive(primitives[p], to_world); !done) return done;
        }
        return {};
    }

    Result<void> read_primitive(const tinygltf::Primitive& primitive, const Eigen::Affine3d& to_world) {
        for (const char* packed : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
            if (primitive.extensions.count(packed))
                return cannot(fmt::format("its data are packed with {}", packed), "export it without", path_);
        const std::size_t base = mesh_.vertex_count();
        if (auto done = read_positions(primitive, to_world); !done) return done;
        Result<std::vector<Index>> indices = read_indices(primitive, mesh_.vertex_count() - base);
        if (!indices) return tl::unexpected(indices.error());
        if (mesh_.vertex_count() + mesh_.corners.size() + 3 * indices->size() >= no_index)
            return cannot("more vertices or corners than 32 bits can count", "export less of it", path_);
        for (Index& v : *indices) v += static_cast<Index>(base);
        append_faces(primitive, *indices, to_world.linear().determinant() < 0);
        shared_ &= says_shared(primitive);
        return {};
    }

    Result<void> read_positions(const tinygltf::Primitive& primitive, const Eigen::Affine3d& to_world) {
        const auto attribute = primitive.attributes.find("POSITION");
        if (attribute == primitive.attributes.end()) return wrong("it has no positions", path_);
        const Result<std::vector<double>> numbers = read_accessor(model_, attribute->second, 3, name_);
        if (!numbers) return tl::unexpected(numbers.error());
        const bool stays = to_world.matrix() == Eigen::Matrix4d::Identity();
        for (std::size_t i = 0; i < numbers->size(); i += 3) {
            Vec3 position((*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]);
            if (!stays) position = to_world * position;
            mesh_.positions.push_back(position.cast<float>());
            if (!mesh_.positions.back().allFinite())
                return wrong(fmt::format("vertex {} is not finite", i / 3), path_);
        }
        return {};
    }

    Result<std::vector<Index>> read_indices(const tinygltf::Primitive& primitive,
                                            std::size_t vertices) const {
        std::vector<Index> indices;
        if (primitive.indices < 0) {
            for (std::size_t i = 0; i < vertices; ++i) indices.push_back(static_cast<Index>(i));
            return indices;
        }
        const Result<std::vector<double>> numbers = read_accessor(model_, primitive.indices, 1, name_);
        if (!numbers) return tl::unexpected(numbers.error());
        indices.reserve(numbers->size());
        for (const double number : *numbers) {
            if (!(number >= 0 && number < static_cast<double>(vertices)))
                return wrong(fmt::format("a triangle names vertex {}, but there are {}", number, vertices),
                             path_);
            indices.push_back(static_cast<Index>(number));
        }
        return indices;
    }

    void append_faces(const tinygltf::Primitive& primitive, const std::vector<Index>& indices,
                      bool mirrored) {
        const std::size_t first_face = mesh_.face_count();
        const std::vector<Triangle> triangles = triangles_of(indices, primitive.mode);
        if (primitive.mode == TINYGLTF_MODE_TRIANGLES &&
            primitive.extensions.count(std::string(ngon_extension)))
            decode_ngons(triangles, mesh_);
        else
            for (const Triangle& triangle : triangles) mesh_.add_face(triangle);
        for (std::size_t f = first_face; mirrored && f < mesh_.face_count(); ++f)
            std::reverse(mesh_.corners.begin() + mesh_.face_offsets[f],
                         mesh_.corners.begin() + mesh_.face_offsets[f + 1]);
    }

    const tinygltf::Model& model_;
    const std::string& name_;
    std::uint64_t size_;
    std::string path_;
    QuadMesh mesh_;
    bool shared_ = true;
};

}  // namespace

Result<QuadMesh> parse_gltf_mesh(std::string_view bytes, const std::string& name) {
    const Result<tinygltf::Model> model = load_gltf(bytes, name);
    if (!model) return tl::unexpected(model.error());
    std::uint64_t size = bytes.size();
    for (const tinygltf::Buffer& buffer : model->buffers) size += buffer.data.size();
    return MeshReader(*model, name, size).read();
}

}  // namespace sinew
