/// @file turtle.h
/// The turtle of chapter 1.5 of "The Algorithmic Beauty of Plants": it walks in space and leaves a skeleton
/// behind.
///
/// H, L, U are its heading, left and up; at the start +z, -x, -y. Pen (radius, section, scale, tropism) and
/// place are saved by [ and restored by ]; type, size and joint belong to the next node only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/base/vec.h"
#include "sinew/grow/program.h"
#include "sinew/skeleton/document.h"

namespace sinew::lsystem {

class Turtle {
  public:
    /// @param limit  nodes beyond it are counted, but not made
    /// @param room   nodes to reserve memory for
    Turtle(const TurtleDefaults& defaults, std::int64_t limit, std::int64_t room = 0);

    /// Obeys one module. False when it cannot: see wrong(). % is for who reads the modules, here it does
    /// nothing.
    bool obey(Command command, const double* arguments, int count);
    std::int64_t node_count() const { return count_; }
    const std::string& wrong() const { return wrong_; }

    /// The skeleton: leaf types only at leaves, the turtle's frame as rotation or roll where a node shows it.
    Document finish();

  private:
    struct Next {  ///< what the next node will be
        NodeType type = NodeType::sphere;
        std::optional<Vec3> size;
        double joint = 0;
    };
    struct State {
        Vec3 position = Vec3::Zero(), heading = Vec3(0, 0, 1), left = Vec3(-1, 0, 0), up = Vec3(0, -1, 0);
        std::int32_t node =
            0;  ///< at this position; below 0: -1 - k, and places_[k] tells if it was made meanwhile
        double radius = 1;
        Section section = Section::round;
        std::array<double, 3> scale{1, 1, 1};
        Vec3 tropism;
        double bending = 0;
        Next next;
    };
    struct Frame {
        std::int32_t node;
        Vec3 left, up, heading;
    };

    bool push();
    bool draw(double length);
    bool move(double length);
    bool put_node();
    std::int32_t add_node(std::int32_t parent, const Next& next);
    bool set_radius(double radius);
    bool set_scale(const double* arguments, int count);
    bool set_cube(const double* arguments, int count);
    void set_tropism(const double* arguments, int count);
    bool set_joint(double sharpness);
    void bend();
    void make_level();
    void keep_leaf_types();
    void write_frames();
    bool fail(std::string what);

    TurtleDefaults defaults_;
    State state_;
    std::vector<State> stack_;
    std::vector<std::int32_t> places_;  ///< node made at each place that had none when the turtle came, or -1
    std::vector<Frame> frames_;         ///< of nodes that are not the same all round
    Document document_;
    std::int64_t count_ = 0, limit_;
    std::string wrong_;
};

}  // namespace sinew::lsystem
