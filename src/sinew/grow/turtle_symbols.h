/// @file turtle_symbols.h
/// What the turtle does at each symbol: the one table that the parser, the turtle and the docs go by.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace sinew::lsystem {

enum class Command : std::uint8_t {
    none,  ///< a letter that only grows
    draw,
    move,
    node,
    turn_left,
    turn_right,
    pitch_down,
    pitch_up,
    roll_left,
    roll_right,
    turn_around,
    level,
    radius,
    push,
    pop,
    cut,
    round,
    rectangular,
    scale,
    tropism,
    sphere,
    cone,
    hemisphere,
    cube,
    negative,
    ball,
    joint,
    sharp,
};

struct TurtleSymbol {
    std::string_view symbol;
    Command command = Command::none;
    int least = 0,
        most = 0;  ///< how many arguments; a module of one character may carry more, which the turtle ignores
};

std::span<const TurtleSymbol> turtle_symbols();
/// Null where the turtle does nothing.
const TurtleSymbol* find_turtle_symbol(std::string_view symbol);

}  // namespace sinew::lsystem
