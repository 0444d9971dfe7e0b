/// @file document.h
/// The skeleton as a person drew it or an instrument measured it: nodes with types, bones, links and
/// symmetry.
///
/// Plain data. Nothing here is checked: validate.h says whether a document makes sense, condition.h repairs a
/// measured one, extend turns it into what the mesher takes. Lengths are in the document's own unit, angles
/// in degrees.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sinew/base/vec.h"

namespace sinew {

/// What a node makes of the surface around it.
enum class NodeType : std::uint8_t { sphere, cone, hemisphere, cube, negative, ball };

/// Only leaves may be of these types.
constexpr bool is_tip(NodeType type) {
    return type == NodeType::cone || type == NodeType::hemisphere || type == NodeType::negative;
}

/// What looks best on the skeletons that it was tried on: crotches are soft, and limbs keep their lengths.
inline constexpr double default_blend = 0.25;

/// The outline across a bone.
enum class Section : std::uint8_t { round, rectangular };

/// `joint` at and above this value is infinitely sharp; "sharp" in a file.
inline constexpr double infinitely_sharp = std::numeric_limits<double>::infinity();

/// Keys that a file spelled out although their value is the default, and how. Saving repeats them, so that a
/// document goes through load and save unchanged; nothing else depends on them.
struct GivenKeys {
    bool name : 1 = false;
    bool type : 1 = false;
    bool section : 1 = false;
    bool scale : 1 = false;
    bool scale_of_three : 1 = false;  ///< scale had its third entry
    bool roll : 1 = false;
    bool joint : 1 = false;
    bool joint_in_words : 1 = false;  ///< "smooth", not 0
};

struct Node {
    std::int64_t id = 0;       ///< unique and non-negative in its document
    std::int32_t parent = -1;  ///< index (not id) of the parent in Document::nodes; -1 for a root
    Vec3 position = Vec3::Zero();
    double radius = 1;  ///< > 0
    NodeType type = NodeType::sphere;
    Section section = Section::round;
    /// Width and height of the section as factors of the radius; the third is used by balls and lone nodes
    /// only.
    std::array<double, 3> scale{1, 1, 1};
    std::optional<Vec3> size;  ///< full extents of a cube; default: twice the radius each
    double roll = 0;           ///< degrees about the bone
    /// For a root, and for a cube or a ball at a branch. As given: normalise before use.
    std::optional<Quat> rotation;
    double joint = 0;             ///< sharpness of the ring here: 0 smooth; >= 10 infinitely sharp
    std::optional<double> blend;  ///< of the joint here, in radii; unless given, the document's
    GivenKeys given;
};

/// The symmetry that is expanded when the document is skinned: the nodes drawn stand for their images too.
struct Symmetry {
    enum class Kind : std::uint8_t { none, mirror, radial };
    Kind kind = Kind::none;
    /// 0, 1, 2 for x, y, z: the normal of the mirror plane (through the origin), or the axis of rotation.
    int axis = 0;
    int count = 1;  ///< radial: how many images, the drawn one included; >= 2

    bool operator==(const Symmetry&) const = default;
};

/// How dense the quads of tubes are, beyond what the shape asks for. 0: not asked for.
struct Density {
    double aspect = 0;       ///< no quad of a tube is longer than so many times its width
    double edge_length = 0;  ///< nor than this, in the document's unit

    bool operator==(const Density&) const = default;
};

struct Document {
    std::string unit;  ///< "m", "mm", "um" ...; empty where it is unknown
    /// Radius of the ball that rolls outside round the joints, in radii of each: the larger, the softer the crotches.
    /// 0: round cones that meet in creases. Unless given, default_blend.
    std::optional<double> blend;
    Density density;
    Symmetry symmetry;
    std::vector<Node> nodes;
    /// More bones, as pairs of node indices: they close cycles.
    std::vector<std::array<std::int32_t, 2>> links;

    // Side tables: empty, or one entry a node.
    std::vector<std::string> names;
    /// Keys of the node that this version does not know, as JSON object text: {"colour":"red"}.
    std::vector<std::string> extras;

    /// The same for the document itself; those inside `symmetry` stand in a "symmetry" of it.
    std::string extra;
    bool unit_given = false;   ///< the file has the key "unit", though empty
    bool links_given = false;  ///< the file has the key "links", though empty
};

}  // namespace sinew
