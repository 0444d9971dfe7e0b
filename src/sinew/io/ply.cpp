#include "sinew/io/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sinew/io/byte_order.h"
#include "sinew/io/text_numbers.h"
#include "sinew/mesh/topology.h"

namespace sinew {
namespace {

std::endian order_of(PlyEncoding encoding) {
    return encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little;
}

/// The data behind the header, number by number. Numbers come as double, which holds all eight types exactly.
class Source {
  public:
    Source(std::string_view bytes, const PlyHeader& header)
        : at_(bytes.data() + header.size),
          end_(bytes.data() + bytes.size()),
          line_(header.lines + 1),
          encoding_(header.encoding) {}

    std::int64_t line() const { return encoding_ == PlyEncoding::ascii ? line_ : 0; }
    bool ended() const { return ended_; }  ///< did the last next() fail because nothing is left?
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

    /// False where there is no such number, or nothing at all, here.
    bool next(PlyType type, double& value) {
        return encoding_ == PlyEncoding::ascii ? next_word(type, value) : next_bytes(type, value);
    }

  private:
    bool next_word(PlyType type, double& value) {
        for (; at_ < end_ && is_blank(*at_); ++at_) line_ += *at_ == '\n';
        ended_ = at_ == end_;
        float single = 0;
        std::int64_t integer = 0;
        const char* next = nullptr;
        if (is_integer(type)) {
            next = scan_integer(at_, end_, integer);
            value = static_cast<double>(integer);
        } else if (type == PlyType::float32) {
            next = scan_float(at_, end_, single);  // not by way of double, which would round twice
            value = single;
        } else {
            next = scan_double(at_, end_, value);
        }
        if (!next || (next < end_ && !is_blank(*next))) return false;
        at_ = next;
        return true;
    }

    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

    bool next_bytes(PlyType type, double& value) {
        switch (type) {
            case PlyType::int8:
                return next_as<std::int8_t>(value);
            case PlyType::uint8:
                return next_as<std::uint8_t>(value);
            case PlyType::int16:
                return next_as<std::int16_t>(value);
            case PlyType::uint16:
                return next_as<std::uint16_t>(value);
            case PlyType::int32:
                return next_as<std::int32_t>(value);
            case PlyType::uint32:
                return next_as<std::uint32_t>(value);
            case PlyType::float32:
                return next_as<float>(value);
            case PlyType::float64:
                return next_as<double>(value);
        }
        return false;
    }

    template <class Number>
    bool next_as(double& value) {
        if (bytes_left() < sizeof(Number)) {
            ended_ = true;
            return false;
        }
        value = static_cast<double>(get_bytes<Number>(at_, order_of(encoding_)));
        at_ += sizeof(Number);
        return true;
    }

    const char* at_;
    const char* end_;
    std::int64_t line_;
    PlyEncoding encoding_;
    bool ended_ = false;
};

class PlyReader {
  public:
    PlyReader(std::string_view bytes, const PlyHeader& header, const std::string& name)
        : header_(header), source_(bytes, header), name_(name) {}

    Result<QuadMesh> read() {
        for (const PlyElement& element : header_.elements)
            if (auto done = read_element(element); !done) return tl::unexpected(done.error());
        if (mesh_.face_count() == 0)
            return fail(Error{.message = "there is no face in it", .cure = "is this a mesh?", .file = name_});
        for (std::size_t f = 0; f < mesh_.face_count(); ++f)
            for (const std::uint32_t v : mesh_.face(f))
                if (v >= mesh_.vertex_count())
                    return fail(Error{.message = fmt::format("face {} names vertex {}, but the file has {}",
                                                             f, v, mesh_.vertex_count()),
                                      .cure = "vertices are counted from 0",
                                      .file = name_});
        return std::move(mesh_);
    }

  private:
    /// What a property of the element at hand is to us.
    enum class Role : std::uint8_t { none, x, y, z, corners };

    tl::unexpected<Error> wrong(const PlyElement& element, std::int64_t index, std::string message) const {
        std::string place = fmt::format("{} {} of {}: ", element.name, index, element.count);
        if (source_.ended()) message = "the file ends here";
        return fail(Error{.message = place + message,
                          .cure = source_.ended() ? "is it cut off?" : "",
                          .file = name_,
                          .line = source_.line()});
    }

    static Role role_of(const PlyElement& element, const PlyProperty& property) {
        if (element.name == "vertex" && !property.is_list) {
            if (property.name == "x") return Role::x;
            if (property.name == "y") return Role::y;
            if (property.name == "z") return Role::z;
        }
        const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
        return element.name == "face" && corners && property.is_list ? Role::corners : Role::none;
    }

    Result<void> read_element(const PlyElement& element) {
        if (element.properties.empty()) return {};
        std::vector<Role> roles;
        for (const PlyProperty& property : element.properties) roles.push_back(role_of(element, property));
        auto lacks = [&](Role role) { return std::count(roles.begin(), roles.end(), role) != 1; };
        const bool vertices = element.name == "vertex", faces = element.name == "face";
        if (vertices && (lacks(Role::x) || lacks(Role::y) || lacks(Role::z)))
            return fail(
                Error{.message = "the element vertex needs the properties x, y and z", .file = name_});
        if (faces && lacks(Role::corners))
            return fail(
                Error{.message = "the element face needs the property list vertex_indices", .file = name_});
        reserve(element, vertices, faces);
        for (std::int64_t i = 0; i < element.count; ++i)
            if (auto done = read_item(element, roles, i); !done) return done;
        return {};
    }

    /// Believes the count of a header only as far as there are bytes for it.
    void reserve(const PlyElement& element, bool vertices, bool faces) {
        const std::size_t likely =
            std::min(static_cast<std::size_t>(element.count), source_.bytes_left() / 4);
        if (vertices) mesh_.positions.reserve(likely);
        if (faces) mesh_.face_offsets.reserve(likely + 1);
        if (faces) mesh_.corners.reserve(std::min(4 * likely, source_.bytes_left()));
    }

    Result<void> read_item(const PlyElement& element, const std::vector<Role>& roles, std::int64_t index) {
        Vec3f position = Vec3f::Zero();
        for (std::size_t p = 0; p < roles.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            double value = 0;
            if (property.is_list) {
                if (auto done = read_list(element, property, roles[p], index); !done) return done;
                continue;
            }
            if (!source_.next(property.type, value))
                return wrong(element, index, property.name + " is no number");
            if (roles[p] == Role::none) continue;
            position[static_cast<int>(roles[p]) - static_cast<int>(Role::x)] = static_cast<float>(value);
        }
        if (!position.allFinite()) return not_finite(element, index);
        if (element.name == "vertex") mesh_.positions.push_back(position);
        return {};
    }

    Result<void> not_finite(const PlyElement& element, std::int64_t index) const {
        return fail(Error{.message = fmt::format("{} {} of {}: a coordinate is not finite", element.name,
                                                 index, element.count),
                          .file = name_,
                          .line = source_.line()});
    }

    Result<void> read_list(const PlyElement& element, const PlyProperty& property, Role role,
                           std::int64_t index) {
        double count = 0, value = 0;
        if (!source_.next(property.count_type, count) || count < 0)
            return wrong(element, index, property.name + " has no count");
        const bool corners = role == Role::corners;
        for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
            if (!source_.next(property.type, value))
                return wrong(element, index, property.name + " is no list of numbers");
            if (!corners) continue;
            if (!is_integer(property.type) || value < 0 || value >= no_index)
                return wrong(element, index, fmt::format("{} is no vertex", value));
            mesh_.corners.push_back(static_cast<std::uint32_t>(value));
        }
        if (!corners) return {};
        if (count < 3)
            return wrong(element, index, fmt::format("a face of {} corners; three are the least", count));
        if (mesh_.corners.size() >= no_index)
            return wrong(element, index, "more corners than 32 bits can count");
        mesh_.face_offsets.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
        return {};
    }

    const PlyHeader& header_;
    Source source_;
    const std::string& name_;
    QuadMesh mesh_;
};

std::string header_text(const QuadMesh& mesh, PlyEncoding encoding, bool large_faces) {
    constexpr std::array<std::string_view, 3> names{"ascii", "binary_little_endian", "binary_big_endian"};
    return fmt::format(
        "ply\nformat {} 1.0\ncomment Sinew\nelement vertex {}\nproperty float x\nproperty float y\nproperty "
        "float z\n"
        "element face {}\nproperty list {} int vertex_indices\nend_header\n",
        names[static_cast<std::size_t>(encoding)], mesh.vertex_count(), mesh.face_count(),
        large_faces ? "uint" : "uchar");
}

void append_text(const QuadMesh& mesh, std::string& text) {
    append_items(
        text, mesh.vertex_count(),
        [](std::size_t begin, std::size_t end) { return (end - begin) * 3 * (float_room + 1); },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t v = begin; v < end; ++v)
                for (int k = 0; k < 3; ++k) at = put(at, mesh.positions[v][k]), *at++ = k < 2 ? ' ' : '\n';
            return at;
        });
    append_items(
        text, mesh.face_count(),
        [&](std::size_t begin, std::size_t end) {
            return (mesh.face_offsets[end] - mesh.face_offsets[begin] + end - begin) * (index_room + 1);
        },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t f = begin; f < end; ++f) {
                at = put(at, static_cast<std::uint32_t>(mesh.face(f).size()));
                for (const std::uint32_t v : mesh.face(f)) *at++ = ' ', at = put(at, v);
                *at++ = '\n';
            }
            return at;
        });
}

void append_binary(const QuadMesh& mesh, std::endian order, bool large_faces, std::string& bytes) {
    append_items(
        bytes, mesh.vertex_count(), [](std::size_t begin, std::size_t end) { return (end - begin) * 12; },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t v = begin; v < end; ++v)
                for (const float value : mesh.positions[v]) at = put_bytes(at, value, order);
            return at;
        });
    append_items(
        bytes, mesh.face_count(),
        [&](std::size_t begin, std::size_t end) {
            return (mesh.face_offsets[end] - mesh.face_offsets[begin] + end - begin) * 4;
        },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t f = begin; f < end; ++f) {
                const std::size_t size = mesh.face(f).size();
                at = large_faces ? put_bytes(at, static_cast<std::uint32_t>(size), order)
                                 : put_bytes(at, static_cast<std::uint8_t>(size), order);
                for (const std::uint32_t v : mesh.face(f)) at = put_bytes(at, v, order);
            }
            return at;
        });
}

}  // namespace

Result<QuadMesh> parse_ply(std::string_view bytes, const std::string& name) {
    const Result<PlyHeader> header = parse_ply_header(bytes, name);
    if (!header) return tl::unexpected(header.error());
    return PlyReader(bytes, *header, name).read();
}

std::string ply_bytes(const QuadMesh& mesh, PlyEncoding encoding) {
    bool large_faces = false;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) large_faces |= mesh.face(f).size() > 255;
    std::string bytes = header_text(mesh, encoding, large_faces);
    if (encoding == PlyEncoding::ascii)
        append_text(mesh, bytes);
    else
        append_binary(mesh, order_of(encoding), large_faces, bytes);
    return bytes;
}

}  // namespace sinew
