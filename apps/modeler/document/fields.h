/// @file fields.h
/// The fields of nodes that are numbers: what the properties panel shows, for one node or for many.
#pragma once

#include <optional>
#include <span>

#include "document/edits.h"

namespace sinew::modeler {

enum class Unit : std::uint8_t { length, degrees, factor };

struct Field {
    const char* id;
    const char* group;  ///< fields of one group stand together: "Position" has three
    const char* label;  ///< in its group: "X"; empty where it is the only one
    const char* tip;
    Unit unit;
    double least;  ///< inclusive
    double most;
    double (*get)(const Document&, std::int32_t node);
    void (*put)(Document&, std::int32_t node, double value);
    /// False where the field means nothing for a node of so many bones: the depth of a leaf, the extents of a
    /// ball.
    bool (*relevant)(const Node&, std::int32_t degree);
};

std::span<const Field> fields();
const Field* find_field(std::string_view id);

/// The value that all nodes share; nothing where they differ or there are none.
std::optional<double> common_value(const Document& document, std::span<const std::int32_t> nodes,
                                   const Field& field);

/// True if the field means something for all of them.
bool relevant_to_all(const Document& document, std::span<const std::int32_t> nodes, const Field& field);

/// The value, kept within the field's limits, for all nodes.
Document with_value(Document document, std::span<const std::int32_t> nodes, const Field& field, double value);

/// The node's rotation as angles about x, y and z in degrees, applied in this order.
Vec3 angles_of(const Node& node);
Quat from_angles(const Vec3& degrees);

}  // namespace sinew::modeler
