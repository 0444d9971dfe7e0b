#include "sinew/io/usda_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "sinew/io/usda_mesh.h"
#include "sinew/io/usda_place.h"
#include "sinew/io/usda_scanner.h"

namespace sinew {
namespace {

constexpr int deepest = 200;  ///< prims in prims: each is a call

/// Maps a world whose y is up to one whose z is.
Eigen::Matrix4d y_to_z_up() {
    Eigen::Matrix4d turn;
    turn << 1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1;
    return turn;
}

class UsdaReader {
  public:
    UsdaReader(std::string_view text, const std::string& name) : scanner_(text), name_(name) {}

    Result<QuadMesh> read() {
        if (auto done = read_layer(); !done) return tl::unexpected(done.error());
        find_places();
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (!place(parts_[i], i + 1 < parts_.size() ? parts_[i + 1]
                                                        : Part{mesh_.vertex_count(), mesh_.face_count()}))
                return fail(
                    Error{.message = "a transform moves points out of the range of floats", .file = name_});
        if (mesh_.face_count() == 0)
            return fail(Error{.message = "there is no mesh in it",
                              .cure = "references to other files are not followed",
                              .file = name_});
        return std::move(mesh_);
    }

  private:
    /// What is known of a prim while its body is read.
    struct Prim {
        bool is_mesh = false;
        UsdaPlace place;
        UsdaMesh mesh;
    };

    /// Where a prim stands: in the one round it, which comes before it, or in the world. Known once the prim ends,
    /// since its properties may follow the prims in it.
    struct Frame {
        std::size_t parent = no_frame;
        Eigen::Matrix4d matrix =
            Eigen::Matrix4d::Identity();  ///< to the parent; after find_places() to the world
    };
    static constexpr std::size_t no_frame = SIZE_MAX;

    /// One Mesh prim in the mesh.
    struct Part {
        std::size_t first_vertex = 0;
        std::size_t first_face = 0;
        std::size_t frame = no_frame;
    };

    /// Parents come first, so that time is linear however deep prims stand in one another.
    void find_places() {
        for (Frame& frame : frames_)
            if (frame.parent != no_frame)
                frame.matrix = Eigen::Matrix4d(frames_[frame.parent].matrix * frame.matrix);
    }

    tl::unexpected<Error> wrong(std::string message, std::string cure = {}) const {
        return fail(Error{.message = std::move(message),
                          .cure = std::move(cure),
                          .file = name_,
                          .line = scanner_.line(),
                          .column = scanner_.column()});
    }
    tl::unexpected<Error> no_value() const {
        if (scanner_.broken()) return wrong("this cannot be read as USD text");
        if (scanner_.kind() != UsdaToken::end) return wrong("a bracket that closes nothing");
        return wrong("the file ends too early", "is it cut off?");
    }

    Result<void> read_layer() {
        if (scanner_.is('(')) {
            scanner_.next();
            if (!read_layer_metadata()) return no_value();
        }
        while (scanner_.kind() != UsdaToken::end)
            if (auto done = read_statement(nullptr, 0); !done) return done;
        return scanner_.broken() ? no_value() : Result<void>{};
    }

    /// Up to the closing parenthesis. Only which way is up matters.
    bool read_layer_metadata() {
        while (!scanner_.is(')')) {
            const bool up = scanner_.token() == "upAxis" && scanner_.kind() == UsdaToken::word;
            if (!scanner_.skip_value()) return false;
            if (!up || !scanner_.is('=')) continue;
            scanner_.next();
            if (scanner_.token() == "Z") to_z_up_ = Eigen::Matrix4d::Identity();
        }
        scanner_.next();
        return true;
    }

    static bool starts_prim(std::string_view word) {
        return word == "def" || word == "over" || word == "class";
    }

    /// A nested prim, a property, or a piece of one (types and qualifiers are passed over word by word).
    Result<void> read_statement(Prim* prim, int depth) {
        if (scanner_.kind() == UsdaToken::word && starts_prim(scanner_.token())) return read_prim(depth);
        const std::string word(scanner_.kind() == UsdaToken::word ? scanner_.token() : "");
        if (!scanner_.skip_value()) return no_value();
        if (!scanner_.is('=')) return {};
        scanner_.next();
        if (prim && !word.empty()) return read_property(word, *prim);
        return scanner_.skip_value() ? Result<void>{} : no_value();
    }

    Result<void> read_prim(int depth) {
        if (depth > deepest) return wrong("prims are nested too deeply");
        bool skipped = scanner_.token() == "class";
        scanner_.next();
        Prim prim;
        if (scanner_.kind() == UsdaToken::word) {
            prim.is_mesh = scanner_.token() == "Mesh";
            scanner_.next();
        }
        if (scanner_.kind() != UsdaToken::text)
            return scanner_.kind() == UsdaToken::end ? no_value() : wrong("a prim has no name");
        scanner_.next();
        if (scanner_.is('(') && !read_prim_metadata(skipped)) return no_value();
        if (!scanner_.is('{'))
            return scanner_.kind() == UsdaToken::end ? no_value() : wrong("a prim has no body");
        if (skipped) return scanner_.skip_value() ? Result<void>{} : no_value();
        scanner_.next();
        return read_body(prim, depth);
    }

    bool read_prim_metadata(bool& inactive) {
        scanner_.next();
        while (!scanner_.is(')')) {
            const bool active = scanner_.kind() == UsdaToken::word && scanner_.token() == "active";
            if (!scanner_.skip_value()) return false;
            if (!active || !scanner_.is('=')) continue;
            scanner_.next();
            inactive |= scanner_.token() == "false" || scanner_.token() == "0";
        }
        scanner_.next();
        return true;
    }

    Result<void> read_body(Prim& prim, int depth) {
        const std::size_t number = frames_.size();
        frames_.push_back({.parent = open_frame_});
        open_frame_ = number;
        while (!scanner_.is('}')) {
            if (scanner_.kind() == UsdaToken::end) return no_value();
            if (auto done = read_statement(&prim, depth + 1); !done) return done;
        }
        if (prim.is_mesh) {
            parts_.push_back({mesh_.vertex_count(), mesh_.face_count(), number});
            if (auto problem = append_usda_mesh(prim.mesh, mesh_))
                return wrong("in the mesh that ends here: " + *problem);
        }
        bool resets = false;
        const std::optional<Eigen::Matrix4d> step = matrix_of(prim.place, resets);
        if (!step) return wrong("the prim that ends here has a transform that cannot be read");
        open_frame_ = frames_[number].parent;
        frames_[number].matrix = *step;
        if (resets) frames_[number].parent = no_frame;
        scanner_.next();
        return {};
    }

    /// Moves the vertices of a part; `next` is where the part after it starts.
    bool place(const Part& part, const Part& next) {
        const Eigen::Matrix4d to_world = to_z_up_ * frames_[part.frame].matrix;
        if (to_world == Eigen::Matrix4d::Identity()) return true;
        for (std::size_t v = part.first_vertex; v < next.first_vertex; ++v) {
            Vec3f& p = mesh_.positions[v];
            p = (to_world * p.cast<double>().homogeneous()).head<3>().cast<float>();
            if (!p.allFinite()) return false;
        }
        if (to_world.topLeftCorner<3, 3>().determinant() < 0)
            for (std::size_t f = part.first_face; f < next.first_face; ++f)
                std::reverse(mesh_.corners.begin() + mesh_.face_offsets[f],
                             mesh_.corners.begin() + mesh_.face_offsets[f + 1]);
        return true;
    }

    Result<void> read_property(std::string_view name, Prim& prim) {
        // Of time samples the first one: the braces hold time, colon, value, and what follows is for others.
        constexpr std::string_view samples = ".timeSamples";
        const bool sampled = name.ends_with(samples) && scanner_.is('{');
        if (sampled) {
            name.remove_suffix(samples.size());
            scanner_.next();
            if (scanner_.kind() == UsdaToken::number) scanner_.next();
            if (scanner_.is(':')) scanner_.next();
        }
        if (auto done = read_value(name, prim); !done) return done;
        while (sampled && !scanner_.is('}'))
            if (!scanner_.skip_value()) return no_value();
        if (sampled) scanner_.next();
        return {};
    }

    Result<void> read_value(std::string_view name, Prim& prim) {
        UsdaMesh& mesh = prim.mesh;
        if (name == "points") return read_numbers(mesh.points);
        if (name == "faceVertexCounts") return read_numbers(mesh.counts);
        if (name == "faceVertexIndices") return read_numbers(mesh.indices);
        if (name == "creaseIndices") return read_numbers(mesh.crease_indices);
        if (name == "creaseLengths") return read_numbers(mesh.crease_lengths);
        if (name == "creaseSharpnesses") return read_numbers(mesh.crease_sharpnesses);
        if (name == "cornerIndices") return read_numbers(mesh.corner_indices);
        if (name == "cornerSharpnesses") return read_numbers(mesh.corner_sharpnesses);
        if (name == "orientation") mesh.left_handed = scanner_.token() == "leftHanded";
        if (name.starts_with("xformOp:")) return read_numbers(prim.place.operations[std::string(name)]);
        if (name == "xformOpOrder" && scanner_.is('[')) return read_order(prim.place.order);
        return scanner_.skip_value() ? Result<void>{} : no_value();
    }

    template <class Number>
    Result<void> read_numbers(std::vector<Number>& numbers) {
        numbers.clear();
        if (scanner_.read_numbers(numbers)) return {};
        return scanner_.kind() == UsdaToken::end ? no_value() : wrong("this is no number that fits here");
    }

    Result<void> read_order(std::vector<std::string>& order) {
        for (order.clear(); !scanner_.is(']'); scanner_.next()) {
            if (scanner_.kind() == UsdaToken::end) return no_value();
            if (scanner_.kind() == UsdaToken::text) order.emplace_back(scanner_.token());
        }
        scanner_.next();
        return {};
    }

    UsdaScanner scanner_;
    const std::string& name_;
    Eigen::Matrix4d to_z_up_ = y_to_z_up();  ///< y is up where a file does not say otherwise
    QuadMesh mesh_;
    std::vector<Part> parts_;
    std::vector<Frame> frames_;          ///< of all prims
    std::size_t open_frame_ = no_frame;  ///< of the prim that is being read
};

}  // namespace

Result<QuadMesh> parse_usda(std::string_view text, const std::string& name) {
    if (!text.starts_with("#usda"))
        return fail(Error{.message = "this is no USD text: it does not start with #usda",
                          .cure = text.starts_with("PXR-USDC") ? "turn it into text with usdcat" : "",
                          .file = name,
                          .line = 1});
    return UsdaReader(text, name).read();
}

}  // namespace sinew
