#include "sinew/io/formats.h"

#include <fmt/format.h>

#include "sinew/io/files.h"

namespace sinew {
namespace {

constexpr Format all_formats[] = {
    {.id = FormatName::sinew,
     .name = "sinew",
     .extension = ".sinew",
     .about = "Sinew document (JSON)",
     .reads_skeleton = true,
     .writes_skeleton = true,
     .carries = {.radii = true,
                 .node_types = true,
                 .cycles = true,
                 .symmetry = true,
                 .names = true,
                 .unknown_keys = true,
                 .units = true}},
    {.id = FormatName::graph,
     .name = "graph",
     .extension = ".graph",
     .about = "plain graph, lines of n and c",
     .reads_skeleton = true,
     .writes_skeleton = true,
     .measured = true,
     .carries = {.radii = true, .cycles = true}},
    {.id = FormatName::swc,
     .name = "swc",
     .extension = ".swc",
     .about = "neuron morphology (INCF)",
     .reads_skeleton = true,
     .writes_skeleton = true,
     .measured = true,
     .carries = {.radii = true}},
    {.id = FormatName::gltf,
     .name = "gltf",
     .extension = ".gltf",
     .about = "glTF 2.0 (JSON)",
     .reads_skeleton = true,
     .reads_mesh = true,
     .writes_mesh = true,
     .measured = true,
     .carries = {.names = true, .quads = true, .shared_vertices = true, .units = true}},
    {.id = FormatName::glb,
     .name = "glb",
     .extension = ".glb",
     .about = "glTF 2.0 (binary)",
     .reads_skeleton = true,
     .reads_mesh = true,
     .writes_mesh = true,
     .measured = true,
     .carries = {.names = true, .quads = true, .shared_vertices = true, .units = true}},
    {.id = FormatName::obj,
     .name = "obj",
     .extension = ".obj",
     .about = "Wavefront OBJ",
     .reads_mesh = true,
     .writes_mesh = true,
     .carries = {.quads = true, .shared_vertices = true}},
    {.id = FormatName::ply,
     .name = "ply",
     .extension = ".ply",
     .about = "Stanford PLY (binary)",
     .reads_mesh = true,
     .writes_mesh = true,
     .carries = {.quads = true, .shared_vertices = true}},
    {.id = FormatName::stl, .name = "stl", .extension = ".stl", .about = "STL (binary)", .writes_mesh = true},
    {.id = FormatName::usda,
     .name = "usda",
     .extension = ".usda",
     .about = "USD (text)",
     .reads_mesh = true,
     .writes_mesh = true,
     .carries = {.quads = true, .creases = true, .shared_vertices = true, .units = true}},
};

std::string_view words(FormatUse use) {
    switch (use) {
        case FormatUse::read_skeleton:
            return "read as a skeleton";
        case FormatUse::write_skeleton:
            return "written as a skeleton";
        case FormatUse::read_mesh:
            return "read as a mesh";
        case FormatUse::write_mesh:
            return "written as a mesh";
    }
    return {};
}

std::string names_for(FormatUse use) {
    std::string names;
    for (const Format& format : all_formats)
        if (supports(format, use)) names += (names.empty() ? "" : ", ") + std::string(format.name);
    return names;
}

std::string carried(const Carries& c) {
    const std::pair<bool, std::string_view> all[] = {
        {c.radii, "radii"},       {c.node_types, "node types"}, {c.cycles, "cycles"},
        {c.symmetry, "symmetry"}, {c.names, "names"},           {c.unknown_keys, "unknown keys"},
        {c.quads, "quads"},       {c.creases, "creases"},       {c.shared_vertices, "shared vertices"},
        {c.units, "units"}};
    std::string text;
    for (const auto& [has, word] : all)
        if (has) text += (text.empty() ? "" : ", ") + std::string(word);
    return text.empty() ? "triangles" : text;
}

std::string_view read_write(bool reads, bool writes) {
    return reads && writes ? "read, write" : reads ? "read" : writes ? "write" : "-";
}

}  // namespace

std::span<const Format> formats() { return all_formats; }

const Format* find_format(std::string_view name) {
    for (const Format& format : all_formats)
        if (format.name == name) return &format;
    return nullptr;
}

bool supports(const Format& format, FormatUse use) {
    switch (use) {
        case FormatUse::read_skeleton:
            return format.reads_skeleton;
        case FormatUse::write_skeleton:
            return format.writes_skeleton;
        case FormatUse::read_mesh:
            return format.reads_mesh;
        case FormatUse::write_mesh:
            return format.writes_mesh;
    }
    return false;
}

Result<const Format*> choose_format(const std::string& path, std::string_view name, FormatUse use) {
    auto wrong = [&](std::string message, std::string cure) {
        return fail(Error{
            .kind = ErrorKind::call, .message = std::move(message), .cure = std::move(cure), .file = path});
    };
    const std::string choices = fmt::format("formats that can be {}: {}", words(use), names_for(use));
    const Format* format = find_format(name);
    if (!name.empty() && !format) return wrong(fmt::format("there is no format '{}'", name), choices);
    if (!format) {
        const std::string extension = extension_of(path);
        if (extension.empty())
            return wrong("the name does not say which format is meant", "name one; " + choices);
        for (const Format& each : all_formats)
            if (each.extension == extension) format = &each;
        if (!format)
            return wrong(fmt::format("the extension '{}' is of no known format", extension), choices);
    }
    if (!supports(*format, use))
        return wrong(fmt::format("the format '{}' cannot be {}", format->name, words(use)), choices);
    return format;
}

std::string formats_text() {
    std::string text = fmt::format("{:<7} {:<8} {:<32} {:<12} {:<12} {}\n", "format", "files", "what it is",
                                   "skeleton", "mesh", "carries");
    for (const Format& f : all_formats)
        text += fmt::format("{:<7} {:<8} {:<32} {:<12} {:<12} {}\n", f.name, f.extension, f.about,
                            read_write(f.reads_skeleton, f.writes_skeleton),
                            read_write(f.reads_mesh, f.writes_mesh), carried(f.carries));
    return text;
}

}  // namespace sinew
