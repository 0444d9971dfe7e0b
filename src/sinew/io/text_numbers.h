/// @file text_numbers.h
/// Numbers as text, whatever the locale, and large texts written in blocks side by side.
#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace sinew {

/// Reads a number at the start of [at, end) and returns where it ends; null where there is none. A leading
/// '+' is fine. What is too small for a float becomes 0, what is too large becomes infinite; "nan" and "inf"
/// are numbers here.
const char* scan_float(const char* at, const char* end, float& value);
const char* scan_double(const char* at, const char* end, double& value);
/// The same for an integer; null also for what does not fit.
const char* scan_integer(const char* at, const char* end, std::int64_t& value);

/// Most characters that the functions below write.
inline constexpr std::size_t float_room = 16;
inline constexpr std::size_t index_room = 10;

/// Writes the shortest text that reads back as the same number, and returns its end.
inline char* put(char* at, float value) { return std::to_chars(at, at + float_room, value).ptr; }
inline char* put(char* at, std::uint32_t value) { return std::to_chars(at, at + index_room, value).ptr; }
inline char* put(char* at, std::string_view text) {
    text.copy(at, text.size());
    return at + text.size();
}

/// Writes the items [begin, end) at `at`, where there is room enough, and returns the end of what it wrote.
using PutItems = std::function<char*(std::size_t begin, std::size_t end, char* at)>;
/// An upper bound for the characters of the items [begin, end).
using RoomOfItems = std::function<std::size_t(std::size_t begin, std::size_t end)>;

/// Appends `count` items to a text, block by block on all cores. The same text on any number of them.
void append_items(std::string& text, std::size_t count, const RoomOfItems& room, const PutItems& put_items);

}  // namespace sinew
