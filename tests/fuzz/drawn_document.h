// Documents out of bytes: eight a node, so that what a fuzzer changes is a skeleton and not its spelling.
#pragma once

#include <cstdint>
#include <span>

#include "sinew/skeleton/document.h"

namespace sinew {

/// Steps of an eighth in a small cube, where nodes meet and swallow each other often; one in 32 further out.
inline double drawn_number(std::uint8_t byte) {
    const int step = static_cast<std::int8_t>(byte);
    return byte % 32 == 31 ? step * 1e3 : step / 8.0;
}

/// The node of number `index`: parent, three coordinates, radius, type, section with scale, turns.
inline Node drawn_node(std::span<const std::uint8_t, 8> bytes, std::int32_t index) {
    Node node{.id = index, .parent = bytes[0] % 16 == 15 ? -1 : index - 1 - bytes[0] % 16};
    if (node.parent < -1) node.parent = index - 1;
    node.position = {drawn_number(bytes[1]), drawn_number(bytes[2]), drawn_number(bytes[3])};
    node.radius = bytes[4] % 64 == 63 ? 1e-6 : (1 + bytes[4] % 64) / 16.0;
    node.type = static_cast<NodeType>(bytes[5] % 8 < 6 ? bytes[5] % 8 : 0);
    node.joint = bytes[5] & 128 ? 10 : 0;
    node.section = bytes[6] & 1 ? Section::rectangular : Section::round;
    if (bytes[6] & 2) node.scale[0] = (1 + (bytes[6] >> 4)) / 4.0;
    if (bytes[6] & 4) node.scale[1] = (1 + (bytes[6] >> 5)) / 3.0;
    if (bytes[6] & 8) node.size = Vec3(1 + bytes[6] % 5, 1, 1 + bytes[7] % 3);
    node.roll = bytes[7] & 1 ? 15.0 * (bytes[7] >> 4) : 0;
    if (bytes[7] & 2) node.rotation = Quat(1 + (bytes[7] >> 4), bytes[7] & 4, bytes[7] & 8, 0);
    return node;
}

/// The first byte says of which symmetry; what is left after 24 nodes are links.
inline Document drawn_document(std::span<const std::uint8_t> bytes) {
    Document document;
    if (bytes.empty()) return document;
    const std::uint8_t kind = bytes[0];
    if (kind % 4 == 1) document.symmetry = {Symmetry::Kind::mirror, kind / 4 % 3, 2};
    if (kind % 4 == 2) document.symmetry = {Symmetry::Kind::radial, kind / 4 % 3, 2 + kind / 12 % 5};
    bytes = bytes.subspan(1);
    while (bytes.size() >= 8 && document.nodes.size() < 24) {
        document.nodes.push_back(
            drawn_node(bytes.first<8>(), static_cast<std::int32_t>(document.nodes.size())));
        bytes = bytes.subspan(8);
    }
    for (; bytes.size() >= 2 && document.links.size() < 8; bytes = bytes.subspan(2))
        document.links.push_back({bytes[0] % 24, bytes[1] % 24});
    return document;
}

}  // namespace sinew
