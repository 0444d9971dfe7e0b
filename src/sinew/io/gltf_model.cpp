#include "sinew/io/gltf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "sinew/io/files.h"
#include "sinew/io/gltf_nodes.h"
#include "sinew/io/gltf_text.h"
#include "sinew/io/named_files.h"

namespace sinew {
namespace {

/// Buffers in files of their own, in their order, which is that in which tinygltf asks for them, before any image.
/// They are all that it ever sees of the disk: what read_named_file() let in.
struct BufferFiles {
    std::vector<std::string> bytes;
    std::size_t next = 0;
};

bool is_buffer_file(const std::string&, void* data) {
    const auto& files = *static_cast<const BufferFiles*>(data);
    return files.next < files.bytes.size();
}

bool read_buffer_file(std::vector<unsigned char>* out, std::string*, const std::string&, void* data) {
    auto& files = *static_cast<BufferFiles*>(data);
    const std::string bytes = std::move(files.bytes.at(files.next++));
    out->assign(bytes.begin(), bytes.end());
    return true;
}

std::string keep_path(const std::string& path, void*) { return path; }
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

bool pass_over_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*,
                     int, void*) {
    return true;
}

/// The first line of what tinygltf has to say, which may be long.
std::string first_line(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    return line.substr(0, 200);
}

tl::unexpected<Error> wrong(const std::string& name, std::string message, std::string path = {}) {
    return fail(broken_gltf(Error{.message = std::move(message), .file = name, .path = std::move(path)}));
}

Result<void> read_buffers(const Json& root, bool binary, const std::string& name, BufferFiles& files) {
    const Json& buffers = array_in(root, "buffers");
    std::uint64_t room = largest_input;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string pointer = fmt::format("/buffers/{}", i);
        const std::int64_t length = integer_in(*find(buffers[i], "byteLength")).value_or(-1);
        if (length < 0) return wrong(name, "this must be a count of bytes", pointer + "/byteLength");
        const Json* uri = find(buffers[i], "uri");
        // A buffer without one is the binary part of the file, which only the first may be: each is a copy.
        if (!uri && binary && i == 0) continue;
        if (!uri) return wrong(name, "the buffer has no uri", pointer);
        if (!uri->is_string()) return wrong(name, "this must be text", pointer + "/uri");
        const std::string& reference = uri->get_ref<const std::string&>();
        if (reference.starts_with("data:")) continue;
        Result<std::string> bytes = read_named_file(name, reference, room);
        if (!bytes) {
            bytes.error().path = pointer + "/uri";
            return tl::unexpected(std::move(bytes.error()));
        }
        if (bytes->size() < static_cast<std::uint64_t>(length))
            return wrong(name, "the file that it names ends too early", pointer + "/uri");
        bytes->resize(static_cast<std::size_t>(length));
        room -= bytes->size();
        files.bytes.push_back(std::move(*bytes));
    }
    return {};
}

/// Looks the text over and reads the buffers, so that the library behind meets nothing that it could fall over.
Result<void> prepare(std::string_view bytes, const std::string& name, BufferFiles& files) {
    const Result<Json> json = parse_gltf_text(bytes);
    if (!json) {
        Error error = json.error();
        error.file = name;
        return fail(std::move(error));
    }
    return read_buffers(*json, bytes.starts_with("glTF"), name, files);
}

Result<tinygltf::Model> load(std::string_view bytes, const std::string& name) {
    BufferFiles files;
    if (auto prepared = prepare(bytes, name, files); !prepared) return tl::unexpected(prepared.error());
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(pass_over_image, nullptr);
    loader.SetFsCallbacks({is_buffer_file, keep_path, read_buffer_file, write_nothing, &files});
    tinygltf::Model model;
    std::string error, warning;
    const unsigned size = static_cast<unsigned>(bytes.size());
    const bool loaded =
        bytes.starts_with("glTF")
            ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                          reinterpret_cast<const unsigned char*>(bytes.data()), size, "")
            : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
    if (!loaded) return wrong(name, first_line(error));
    return model;
}

template <class List>
bool exists(const List& list, int index) {
    return index >= 0 && index < static_cast<int>(list.size());
}

/// Items in a buffer: where the first one is, and how far it is from one to the next.
struct Items {
    const unsigned char* first = nullptr;
    std::size_t stride = 0;
};

/// Finds `count` items of `size` bytes, if they all lie in the buffer view.
Result<Items> find_items(const tinygltf::Model& model, int view_index, std::size_t offset, std::size_t count,
                         std::size_t size, const std::string& name) {
    if (!exists(model.bufferViews, view_index))
        return wrong(name, "there is no buffer view", fmt::format("/bufferViews/{}", view_index));
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
    auto outside = [&] {
        return wrong(name, "the data lead out of the buffer", fmt::format("/bufferViews/{}", view_index));
    };
    if (!exists(model.buffers, view.buffer)) return outside();
    const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) return outside();
    const std::size_t stride = view.byteStride ? view.byteStride : size;
    if (offset > view.byteLength) return outside();
    const std::size_t room = view.byteLength - offset;
    if (count > 0 && (size > room || (count - 1) > (room - size) / stride)) return outside();
    return Items{data.data() + view.byteOffset + offset, stride};
}

template <class Number>
double number_at(const unsigned char* at, bool normalized) {
    Number number;
    std::memcpy(&number, at, sizeof number);
    const double value = static_cast<double>(number);
    if (!normalized || !std::numeric_limits<Number>::is_integer) return value;
    return std::max(value / static_cast<double>(std::numeric_limits<Number>::max()), -1.0);
}

double number_at(const unsigned char* at, int component, bool normalized) {
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return number_at<std::int8_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return number_at<std::uint8_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return number_at<std::int16_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return number_at<std::uint16_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return number_at<std::uint32_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return number_at<float>(at, false);
        default:
            return 0;
    }
}

class AccessorReader {
  public:
    AccessorReader(const tinygltf::Model& model, int index, int components, const std::string& name)
        : model_(model), index_(index), components_(static_cast<std::size_t>(components)), name_(name) {}

    Result<std::vector<double>> read() {
        if (!exists(model_.accessors, index_)) return bad("there is no such accessor");
        const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index_)];
        const int width = tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(accessor.componentType));
        const int components = tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type));
        if (width <= 0 || accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE)
            return bad("a type of number that glTF does not have");
        if (components != static_cast<int>(components_))
            return bad(fmt::format("{} numbers an item, not {}", components, components_));
        width_ = static_cast<std::size_t>(width);
        if (accessor.bufferView < 0) return bad("an accessor without data of its own cannot be read");
        auto items = find_items(model_, accessor.bufferView, accessor.byteOffset, accessor.count,
                                components_ * width_, name_);
        if (!items) return tl::unexpected(items.error());
        std::vector<double> numbers(accessor.count * components_);
        for (std::size_t i = 0; i < accessor.count; ++i) copy(accessor, *items, i, i, numbers);
        if (auto done = replace_sparse(accessor, numbers); !done) return tl::unexpected(done.error());
        return numbers;
    }

  private:
    tl::unexpected<Error> bad(std::string message) const {
        return wrong(name_, std::move(message), fmt::format("/accessors/{}", index_));
    }

    void copy(const tinygltf::Accessor& accessor, const Items& items, std::size_t from, std::size_t to,
              std::vector<double>& numbers) const {
        for (std::size_t k = 0; k < components_; ++k)
            numbers[to * components_ + k] = number_at(items.first + from * items.stride + k * width_,
                                                      accessor.componentType, accessor.normalized);
    }

    Result<void> replace_sparse(const tinygltf::Accessor& accessor, std::vector<double>& numbers) const {
        const auto& sparse = accessor.sparse;
        if (!sparse.isSparse) return {};
        const int component = sparse.indices.componentType;
        const int width = tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(component));
        if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 || width <= 0 ||
            width > 4)
            return bad("sparse values that make no sense");
        const std::size_t count = static_cast<std::size_t>(sparse.count);
        const auto places =
            find_items(model_, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                       count, static_cast<std::size_t>(width), name_);
        if (!places) return tl::unexpected(places.error());
        const auto values =
            find_items(model_, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                       count, components_ * width_, name_);
        if (!values) return tl::unexpected(values.error());
        for (std::size_t i = 0; i < count; ++i) {
            const double place = number_at(places->first + i * places->stride, component, false);
            if (!(place >= 0 && place < static_cast<double>(accessor.count)))
                return bad("a sparse value of no item");
            copy(accessor, *values, i, static_cast<std::size_t>(place), numbers);
        }
        return {};
    }

    const tinygltf::Model& model_;
    int index_;
    std::size_t components_;
    const std::string& name_;
    std::size_t width_ = 0;
};

Eigen::Affine3d transform_of(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return gltf_transform(std::span<const double, 16>(node.matrix));
    const auto all = [](const std::vector<double>& numbers, auto none) {
        if (numbers.size() == std::size_t(none.size()))
            none = Eigen::Map<const decltype(none)>(numbers.data());
        return none;
    };
    return gltf_transform(all(node.translation, Vec3(0, 0, 0)),
                          Quat(all(node.rotation, Eigen::Vector4d(0, 0, 0, 1))),
                          all(node.scale, Vec3(1, 1, 1)));
}

/// The nodes that the file shows, without those below them.
Result<std::vector<std::int32_t>> roots_of_scene(const tinygltf::Model& model, const GltfTree& tree,
                                                 const std::string& name) {
    const int scene = model.defaultScene >= 0 ? model.defaultScene : 0;
    if (!exists(model.scenes, scene)) return roots_of(tree);
    const std::vector<int>& roots = model.scenes[static_cast<std::size_t>(scene)].nodes;
    for (const int node : roots)
        if (!exists(model.nodes, node))
            return wrong(name, "there is no such node", fmt::format("/nodes/{}", node));
    return roots;
}

}  // namespace

Result<tinygltf::Model> load_gltf(std::string_view bytes, const std::string& name) try {
    if (bytes.size() > std::numeric_limits<std::int32_t>::max())
        return fail(Error{.message = "a glTF file of more than 2 GiB cannot be read", .file = name});
    return load(bytes, name);
} catch (const std::exception& error) {
    return wrong(name, first_line(error.what()));
}

Result<std::vector<double>> read_accessor(const tinygltf::Model& model, int accessor, int components,
                                          const std::string& name) {
    return AccessorReader(model, accessor, components, name).read();
}

Result<std::vector<PlacedNode>> place_nodes(const tinygltf::Model& model, const std::string& name) {
    GltfTree tree;
    for (const tinygltf::Node& node : model.nodes) {
        tree.children.push_back(node.children);
        tree.to_parent.push_back(transform_of(node));
    }
    if (const Result<void> found = find_parents(tree); !found) {
        Error error = broken_gltf(found.error());
        error.file = name;
        return fail(std::move(error));
    }
    const Result<std::vector<std::int32_t>> roots = roots_of_scene(model, tree, name);
    if (!roots) return tl::unexpected(roots.error());
    const std::vector<Eigen::Affine3d> world = to_world(tree);
    std::vector<PlacedNode> placed;
    for (const std::int32_t node : parents_first(tree, *roots)) placed.push_back({node, world[node]});
    return placed;
}

}  // namespace sinew
