#include "sinew/grow/turtle_symbols.h"

#include <algorithm>
#include <array>

namespace sinew::lsystem {
namespace {

constexpr std::array<TurtleSymbol, 27> symbols{{
    {"F", Command::draw, 0, 1},
    {"f", Command::move, 0, 1},
    {".", Command::node, 0, 0},
    {"+", Command::turn_left, 0, 1},
    {"-", Command::turn_right, 0, 1},
    {"&", Command::pitch_down, 0, 1},
    {"^", Command::pitch_up, 0, 1},
    {"\\", Command::roll_left, 0, 1},
    {"/", Command::roll_right, 0, 1},
    {"|", Command::turn_around, 0, 0},
    {"$", Command::level, 0, 0},
    {"!", Command::radius, 0, 1},
    {"[", Command::push, 0, 0},
    {"]", Command::pop, 0, 0},
    {"%", Command::cut, 0, 0},
    {"@round", Command::round, 0, 0},
    {"@rectangular", Command::rectangular, 0, 0},
    {"@scale", Command::scale, 2, 3},
    {"@tropism", Command::tropism, 1, 4},
    {"@sphere", Command::sphere, 0, 0},
    {"@cone", Command::cone, 0, 0},
    {"@hemisphere", Command::hemisphere, 0, 0},
    {"@cube", Command::cube, 0, 3},
    {"@negative", Command::negative, 0, 0},
    {"@ball", Command::ball, 0, 0},
    {"@joint", Command::joint, 1, 1},
    {"@sharp", Command::sharp, 0, 0},
}};

}  // namespace

std::span<const TurtleSymbol> turtle_symbols() { return symbols; }

const TurtleSymbol* find_turtle_symbol(std::string_view symbol) {
    const auto all = turtle_symbols();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const TurtleSymbol& s) { return s.symbol == symbol; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace sinew::lsystem
