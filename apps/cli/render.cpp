#include "sinew/render/render.h"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "sinew/io/files.h"
#include "sinew/smooth/smooth_skin.h"

namespace sinew::cli {
namespace {

constexpr const char* render_examples = R"(Examples:
  sinew render hand.obj -o hand.png --wire
  sinew render hand.sinew -o hand.png --skeleton --view front    skinned, with the bones seen inside
  sinew render hand.obj -o hand.png --bones hand.sinew           a mesh and the skeleton it came from
  sinew render examples/*.sinew -o sheet.png --sheet 4           all in one picture, four in a row

Needs no display and no graphics card: it draws through EGL, with Mesa's software driver where there is no other.)";

struct RenderCommand {
    FileOptions files;
    std::string bones;
    std::string size = "1280x960";
    std::string view = "iso";
    std::string shading = "lit";
    std::string background = "EEEFF1";
    bool wire = false, skeleton = false, irregular = false, creases = false;
    double opacity = -1;
    int levels = 0;
    int sheet = 0;

    RenderOptions options() const;
    Result<QuadMesh> mesh(Session& session, const Job& job, Scene& scene) const;
    Result<Scene> scene(Session& session, const Job& job) const;
    Result<Picture> picture(Session& session, const Job& job) const;
    Result<Outcome> work(Session& session, const Job& job) const;
    void run(Session& session) const;
    void run_sheet(Session& session) const;
};

struct Size {
    int width = 0, height = 0;
};

/// "640x480"
std::optional<Size> parse_size(const std::string& text) {
    const std::size_t by = text.find('x');
    Size size;
    if (by == std::string::npos || !CLI::detail::lexical_cast(text.substr(0, by), size.width) ||
        !CLI::detail::lexical_cast(text.substr(by + 1), size.height) || size.width < 1 || size.height < 1)
        return std::nullopt;
    return size;
}

/// "transparent" or six hexadecimal digits
std::optional<Colour> parse_colour(const std::string& text) {
    if (text == "transparent") return transparent;
    if (text.size() != 6 || text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
        return std::nullopt;
    const unsigned long rgb = std::stoul(text, nullptr, 16);
    const auto byte = [&](int shift) { return static_cast<std::uint8_t>(rgb >> shift & 0xff); };
    return Colour{byte(16), byte(8), byte(0), 255};
}

View view_of(const std::string& name) {
    return name == "front"  ? View::front
           : name == "side" ? View::side
           : name == "top"  ? View::top
                            : View::iso;
}

Shading shading_of(const std::string& name) {
    return name == "flat" ? Shading::flat : name == "matcap" ? Shading::matcap : Shading::lit;
}

RenderOptions RenderCommand::options() const {
    const Size pixels = *parse_size(size);
    RenderOptions options{.width = pixels.width, .height = pixels.height, .view = view_of(view)};
    options.background = *parse_colour(background);
    options.draw.shading = shading_of(shading);
    options.draw.wire = wire;
    options.draw.irregular = irregular;
    options.draw.creases = creases;
    const bool see_inside = skeleton || !bones.empty();
    options.draw.opacity = static_cast<float>(opacity >= 0 ? opacity : see_inside ? 0.4 : 1.0);
    return options;
}

/// The mesh to draw, subdivided if wanted: that of the file, or what `sinew skin` makes of the skeleton in it,
/// whose bones go into the scene if wanted.
Result<QuadMesh> RenderCommand::mesh(Session& session, const Job& job, Scene& scene) const {
    const auto kind = is_mesh(job, files);
    if (!kind) return fail(kind.error());
    if (*kind) {
        auto control = read_input_mesh(job, files);
        if (!control || levels == 0) return control;
        return subdivide(*control, {.levels = levels, .detect_poles = true}, session.progress(0, 0.6));
    }
    const auto read = read_input_skeleton(session, job, files);
    if (!read) return fail(read.error());
    auto made =
        smooth_skin(read->document, {.levels = levels, .repair = read->measured}, session.progress(0, 0.6));
    if (!made) return fail(made.error());
    if (skeleton) scene.glyphs = make_glyphs(read->document, slender_glyphs);
    return std::move(made->skin.mesh);
}

Result<Scene> RenderCommand::scene(Session& session, const Job& job) const {
    Scene scene;
    const auto drawn = mesh(session, job, scene);
    if (!drawn) return fail(drawn.error());
    scene.mesh = mesh_buffers(*drawn);
    if (!bones.empty()) {
        const auto read = interruptibly([&] { return read_skeleton(bones); });
        if (!read) return fail(read.error());
        scene.glyphs = make_glyphs(read->document, slender_glyphs);
    }
    return scene;
}

Result<Picture> RenderCommand::picture(Session& session, const Job& job) const {
    const auto drawn = scene(session, job);
    if (!drawn) return fail(drawn.error());
    session.progress()(0.6, "render");
    return render(*drawn, options());
}

/// Fails, as the call's fault, for a name that is not one of a PNG file.
Result<void> check_picture_name(const std::string& path) {
    if (path == "-" || extension_of(path) == ".png") return {};
    return fail(Error{.kind = ErrorKind::call,
                      .message = "pictures are written as PNG only",
                      .cure = "give the file the extension .png",
                      .file = path});
}

Result<void> write_picture(const Picture& picture, const std::string& path) {
    const auto bytes = encode_png(picture);
    if (!bytes) return fail(bytes.error());
    if (auto on = heed_interrupt(); !on) return on;
    return unless_waiting(path, [&] { return write_file(path, *bytes); });
}

Outcome describe(const Picture& picture, const std::string& path) {
    return {.text = fmt::format("{}: {} x {} pixels\n", path, picture.width, picture.height),
            .json = {{"width", picture.width}, {"height", picture.height}}};
}

Result<Outcome> RenderCommand::work(Session& session, const Job& job) const {
    if (const auto able = check_picture_name(job.output); !able) return fail(able.error());
    const auto made = picture(session, job);
    if (!made) return fail(made.error());
    if (const auto written = write_picture(*made, job.output); !written) return fail(written.error());
    return describe(*made, job.output);
}

/// All pictures first, then one file.
void RenderCommand::run_sheet(Session& session) const {
    if (const auto able = check_picture_name(files.output); !able) return session.error(able.error());
    std::vector<Picture> pictures;
    FileOptions reading = files;
    reading.output.clear();
    session.run(reading, "", [&](const Job& job) -> Result<Outcome> {
        auto made = picture(session, job);
        if (!made) return fail(made.error());
        pictures.push_back(std::move(*made));
        return Outcome{};
    });
    if (session.status != 0) return;
    const Picture whole = contact_sheet(pictures, sheet, 0, *parse_colour(background));
    if (const auto written = write_picture(whole, files.output); !written)
        return session.error(written.error());
    if (!session.json && !session.quiet && files.output != "-")
        session.put(describe(whole, files.output).text);
}

void RenderCommand::run(Session& session) const {
    if (sheet > 0) return run_sheet(session);
    session.run(files, ".png", [&](const Job& job) { return work(session, job); });
}

std::string wrong_size(const std::string& text) {
    return parse_size(text) ? "" : fmt::format("'{}' is not WIDTHxHEIGHT", text);
}

std::string wrong_colour(const std::string& text) {
    return parse_colour(text) ? "" : fmt::format("'{}' is neither RRGGBB nor transparent", text);
}

void add_drawing_options(CLI::App& app, RenderCommand& command) {
    app.add_option("--size", command.size, "Pixels of the picture (1280x960)")
        ->type_name("WxH")
        ->check(CLI::Validator(wrong_size, ""));
    app.add_option("--view", command.view, "front, side, top or iso (unless told)")
        ->type_name("NAME")
        ->check(one_of({"front", "side", "top", "iso"}));
    app.add_option("--shading", command.shading, "lit (unless told), matcap or flat")
        ->type_name("NAME")
        ->check(one_of({"lit", "matcap", "flat"}));
    app.add_option("--background", command.background, "RRGGBB or transparent (EEEFF1)")
        ->type_name("COLOUR")
        ->check(CLI::Validator(wrong_colour, ""));
    app.add_option("--opacity", command.opacity, "Of the mesh, 0 to 1 (1; 0.4 where bones are drawn)")
        ->type_name("X")
        ->check(CLI::Validator(CLI::Range(0.0, 1.0)).description(""));
    app.add_option("--subdivide", command.levels, "Subdivide the mesh so often")
        ->type_name("N")
        ->check(at_least(0, 8));
    app.add_flag("--wire", command.wire, "Draw the edges of the faces");
    app.add_flag("--irregular", command.irregular, "Mark vertices of a valence other than 4");
    app.add_flag("--creases", command.creases, "Mark creases");
}

}  // namespace

void add_render(CLI::App& program, Session& session) {
    auto command = std::make_shared<RenderCommand>();
    CLI::App& app =
        *program.add_subcommand("render", "Draw a mesh, or a skeleton and its mesh, into a picture");
    app.footer(render_examples);
    add_inputs(app, command->files, "Meshes or skeletons");
    app.add_option("-o,--output", command->files.output,
                   "The picture, PNG; - is standard output; a folder for several inputs")
        ->required()
        ->type_name("FILE");
    app.add_flag("--skeleton", command->skeleton, "Draw the skeleton inside its mesh");
    app.add_option("--bones", command->bones, "Draw the skeleton of this file inside the mesh")
        ->type_name("FILE");
    app.add_option("--sheet", command->sheet, "Put all pictures into one, so many in a row")
        ->type_name("COLUMNS")
        ->check(at_least(1, 1000));
    add_drawing_options(app, *command);
    add_strict(app, session);
    add_reporting(app, session);
    app.callback([command, &session] { command->run(session); });
}

}  // namespace sinew::cli
