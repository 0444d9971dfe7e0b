/// @file ply_header.h
/// The header of a PLY file: how its bytes are laid out.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"

namespace sinew {

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t size_of(PlyType type);
inline bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  ///< of a list: an integer
};

struct PlyElement {
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;    ///< bytes of the header, up to where the data start
    std::int64_t lines = 0;  ///< lines of the header
};

/// Reads the header at the start of a file. Fails, with the line, for what is no PLY 1.0 header.
Result<PlyHeader> parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace sinew
