/// @file formats.h
/// The table of file formats: which are read and written, and what each can carry.
///
/// The functions that read and write are in skeleton_formats.h and mesh_formats.h; both look their format up
/// here.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew {

enum class FormatName : std::uint8_t { sinew, graph, swc, gltf, glb, obj, ply, stl, usda };

/// What survives a way through a file of the format.
struct Carries {
    // skeletons
    bool radii = false;       ///< one a node
    bool node_types = false;  ///< types, sections, sizes, rolls, joints
    bool cycles = false;      ///< links
    bool symmetry = false;    ///< undrawn images
    bool names = false;       ///< of nodes
    bool unknown_keys = false;
    // meshes
    bool quads = false;            ///< polygons stay whole; otherwise they are split into triangles
    bool creases = false;          ///< sharp edges and corners for subdivision
    bool shared_vertices = false;  ///< false: each face brings its own
    // both
    bool units = false;  ///< the file says how long one unit is
};

struct Format {
    FormatName id;
    std::string_view name;       ///< what a user writes after --format
    std::string_view extension;  ///< lower case, with the dot
    std::string_view about;      ///< a few words
    bool reads_skeleton = false;
    bool writes_skeleton = false;
    bool reads_mesh = false;
    bool writes_mesh = false;
    /// Its skeletons were not drawn for meshing, but measured or made for a rig: they are repaired on reading
    /// and conditioned before skinning.
    bool measured = false;
    Carries carries;
};

/// All formats, the native one first.
std::span<const Format> formats();

/// The format with this name; null where there is none.
const Format* find_format(std::string_view name);

/// What a file is to be used for.
enum class FormatUse : std::uint8_t { read_skeleton, write_skeleton, read_mesh, write_mesh };
bool supports(const Format& format, FormatUse use);

/// The format of a file: the one named explicitly or, where `name` is empty, the one of the path's extension.
/// Fails with the list of the formats that would do where there is none ("-" without a name, an unknown
/// extension) or where the format is not for this use; the fault is the call's.
Result<const Format*> choose_format(const std::string& path, std::string_view name, FormatUse use);

/// The table as text for people: a line a format, columns aligned.
std::string formats_text();

}  // namespace sinew
