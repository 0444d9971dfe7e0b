#include "sinew/io/obj.h"

#include <fmt/format.h>

#include <cmath>

#include "sinew/io/text_numbers.h"
#include "sinew/mesh/topology.h"

namespace sinew {
namespace {

/// Reads a whole file, line by line.
class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& name)
        : at_(text.data()), end_(text.data() + text.size()), name_(name) {}

    Result<QuadMesh> read() {
        while (at_ < end_) {
            if (auto done = read_line(); !done) return tl::unexpected(done.error());
        }
        for (const Ahead& ahead : ahead_)
            if (mesh_.corners[ahead.corner] >= mesh_.positions.size())
                return no_vertex(std::int64_t{mesh_.corners[ahead.corner]} + 1, ahead.line);
        if (mesh_.face_count() == 0) return wrong("there is no face in it", "is this a mesh?", 0);
        return std::move(mesh_);
    }

  private:
    /// A corner that names a vertex which comes later in the file, if it comes.
    struct Ahead {
        std::size_t corner;
        std::int64_t line;
    };

    tl::unexpected<Error> wrong(std::string message, std::string cure, std::int64_t line) const {
        const std::int64_t column = line == line_ ? at_ - line_start_ + 1 : 0;
        return fail(Error{.message = std::move(message),
                          .cure = std::move(cure),
                          .file = name_,
                          .line = line,
                          .column = column});
    }
    tl::unexpected<Error> no_vertex(std::int64_t index, std::int64_t line) const {
        return wrong(
            fmt::format("the face names vertex {}, but the file has {}", index, mesh_.positions.size()),
            "is the file cut off?", line);
    }

    Result<void> read_line() {
        skip_blanks();
        const char* const word = at_;
        while (at_ < end_ && !is_blank(*at_) && !at_line_end()) ++at_;
        const std::string_view keyword(word, static_cast<std::size_t>(at_ - word));
        Result<void> done;
        if (keyword == "v") done = read_vertex();
        if (keyword == "f") done = read_face();
        if (done) skip_line();
        return done;
    }

    Result<void> read_vertex() {
        Vec3f position;
        for (float& value : position) {
            skip_blanks();
            const char* const next = scan_float(at_, end_, value);
            if (!next || !ends_word(next))
                return wrong("a vertex needs three numbers", "write v x y z", line_);
            if (!std::isfinite(value)) return wrong("a coordinate is not finite", "", line_);
            at_ = next;
        }
        mesh_.positions.push_back(position);
        return {};
    }

    Result<void> read_face() {
        std::size_t corners = 0;
        for (skip_blanks(); at_ < end_ && !at_line_end() && *at_ != '#'; skip_blanks(), ++corners)
            if (auto done = read_corner(); !done) return done;
        if (corners < 3)
            return wrong(fmt::format("a face of {} corners", corners), "three are the least", line_);
        if (mesh_.corners.size() >= no_index) return wrong("more corners than 32 bits can count", "", line_);
        mesh_.face_offsets.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
        return {};
    }

    Result<void> read_corner() {
        std::int64_t index = 0;
        const char* next = scan_integer(at_, end_, index);
        if (next) next = skip_attributes(next);
        if (!next || !ends_word(next))
            return wrong("a corner of a face is no vertex number", "write v, v/t, v//n or v/t/n", line_);
        const std::int64_t count = std::ssize(mesh_.positions);
        const std::int64_t vertex = index < 0 ? count + index : index - 1;
        if (index == 0) return wrong("the face names vertex 0", "vertices are counted from 1", line_);
        if (vertex < 0 || vertex >= no_index) return no_vertex(index, line_);
        if (vertex >= count) ahead_.push_back({mesh_.corners.size(), line_});
        mesh_.corners.push_back(static_cast<std::uint32_t>(vertex));
        at_ = next;
        return {};
    }

    /// Passes over /t, //n and /t/n.
    const char* skip_attributes(const char* at) const {
        std::int64_t unused = 0;
        for (int i = 0; i < 2 && at < end_ && *at == '/'; ++i) {
            ++at;
            if (const char* next = scan_integer(at, end_, unused)) at = next;
        }
        return at;
    }

    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    bool at_line_end() const { return *at_ == '\n' || *at_ == '\r' || continues(at_) > 0; }
    bool ends_word(const char* at) const {
        return at == end_ || is_blank(*at) || *at == '\n' || *at == '\r' || *at == '#' || continues(at) > 0;
    }

    /// Length of a backslash with the end of the line behind it; 0 where there is none.
    int continues(const char* at) const {
        if (*at != '\\' || at + 1 == end_) return 0;
        if (at[1] == '\r') return at + 2 < end_ && at[2] == '\n' ? 3 : 2;
        return at[1] == '\n' ? 2 : 0;
    }

    void skip_blanks() {
        while (at_ < end_) {
            const int continued = continues(at_);
            if (!continued && !is_blank(*at_)) return;
            at_ += continued ? continued : 1;
            if (continued) start_line();
        }
    }

    void skip_line() {
        while (at_ < end_ && *at_ != '\n' && *at_ != '\r') {
            const int continued = continues(at_);
            at_ += continued ? continued : 1;
            if (continued) start_line();
        }
        if (at_ < end_) at_ += *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n' ? 2 : 1;
        start_line();
    }

    void start_line() {
        ++line_;
        line_start_ = at_;
    }

    const char* at_;
    const char* end_;
    const char* line_start_ = at_;
    const std::string& name_;
    std::int64_t line_ = 1;
    QuadMesh mesh_;
    std::vector<Ahead> ahead_;
};

}  // namespace

Result<QuadMesh> parse_obj(std::string_view text, const std::string& name) {
    return ObjReader(text, name).read();
}

std::string obj_text(const QuadMesh& mesh) {
    std::string text =
        fmt::format("# Sinew: {} vertices, {} faces\n", mesh.vertex_count(), mesh.face_count());
    append_items(
        text, mesh.vertex_count(),
        [](std::size_t begin, std::size_t end) { return (end - begin) * (3 * (float_room + 1) + 2); },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t v = begin; v < end; ++v) {
                *at++ = 'v';
                for (const float value : mesh.positions[v]) *at++ = ' ', at = put(at, value);
                *at++ = '\n';
            }
            return at;
        });
    append_items(
        text, mesh.face_count(),
        [&](std::size_t begin, std::size_t end) {
            return (mesh.face_offsets[end] - mesh.face_offsets[begin]) * (index_room + 1) + (end - begin) * 2;
        },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t f = begin; f < end; ++f) {
                *at++ = 'f';
                for (const std::uint32_t v : mesh.face(f)) *at++ = ' ', at = put(at, v + 1);
                *at++ = '\n';
            }
            return at;
        });
    return text;
}

}  // namespace sinew
