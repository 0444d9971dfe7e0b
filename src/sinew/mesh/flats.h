/// @file flats.h
/// Planes as subdivision meets them. Inside a plane subdivision keeps to it by itself; what needs care is its
/// rim, where faces of the plane meet others: the vertices there are put back into the plane, or into all the
/// planes they are on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/mesh/topology.h"

namespace sinew {

struct Flats {
    struct Entry {
        std::uint32_t item = 0;  ///< a vertex or an edge
        std::uint32_t plane = 0;
        auto operator<=>(const Entry&) const = default;
    };
    std::vector<Entry> vertices;  ///< of the planes' rims; all planes of a vertex stand together
    std::vector<Entry> edges;     ///< likewise
};

/// Calls body(item, its entries) for each vertex or edge of a list.
template <class Body>
void for_each_item(std::span<const Flats::Entry> entries, const Body& body) {
    for (std::size_t begin = 0, end; begin < entries.size(); begin = end) {
        for (end = begin + 1; end < entries.size() && entries[end].item == entries[begin].item;) ++end;
        body(entries[begin].item, entries.subspan(begin, end - begin));
    }
}

/// Fails for a plane without a normal or with a face that the mesh has not.
Result<Flats> resolve_flats(const QuadMesh& mesh, const Topology& topology);

/// The nearest point that lies in all the planes; a plane nearly parallel to those before it is left out.
/// @param entries  of one vertex
Vec3 nearest_in_planes(std::span<const Plane> planes, std::span<const Flats::Entry> entries, Vec3 point);

}  // namespace sinew
