/// @file gltf_text.h
/// The JSON of a glTF 2.0 file, looked over before anybody relies on it. For the sources of this folder only.
#pragma once

#include <string>
#include <string_view>

#include "sinew/base/result.h"
#include "sinew/io/json_text.h"

namespace sinew {

/// The JSON of a .gltf or a .glb (the bytes tell which): an object of version 2, whose lists are lists of objects
/// that have what the specification requires of them. Fails for anything else: the file is broken, with line or
/// JSON pointer and what to do. Nesting is bounded (deepest_json), so that others may walk it by calls.
Result<Json> parse_gltf_text(std::string_view bytes);

/// The error that something at a JSON pointer of a glTF file is wrong.
tl::unexpected<Error> gltf_fault(std::string pointer, std::string message,
                                 std::string cure = "export the file again");

/// Marks an error as one of a broken glTF file, says what to do, and adds the line of its pointer where the bytes
/// are text that people can look into.
Error broken_gltf(Error error, std::string_view bytes = {});

/// Does the file have a mesh that could be read: triangles that are not packed? Fails as parse_gltf_text() does.
Result<bool> gltf_holds_mesh(std::string_view bytes);

/// An array of an object's key; an empty one where there is none.
const Json& array_in(const Json& object, const char* key);

}  // namespace sinew
