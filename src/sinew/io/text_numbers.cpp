#include "sinew/io/text_numbers.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace sinew {
namespace {

/// Does a number in this text, out of the range of its type, lie below that range (or above)?
bool is_tiny(std::string_view number) {
    const std::size_t exponent = number.find_first_of("eE");
    if (exponent != std::string_view::npos) return number.substr(exponent + 1).starts_with('-');
    return number.substr(0, number.find('.')).find_first_of("123456789") == std::string_view::npos;
}

template <class Number>
const char* scan(const char* at, const char* end, Number& value) {
    if (at < end && *at == '+' && at + 1 < end && at[1] != '-') ++at;
    const std::from_chars_result result = std::from_chars(at, end, value);
    if (result.ec == std::errc::invalid_argument) return nullptr;
    if (result.ec == std::errc::result_out_of_range) {
        const bool tiny = is_tiny({at, static_cast<std::size_t>(result.ptr - at)});
        value = tiny ? Number{0} : std::numeric_limits<Number>::infinity();
        if (*at == '-') value = -value;
    }
    return result.ptr;
}

constexpr std::size_t items_of_block = 1 << 14;

struct Block {
    std::unique_ptr<char[]> characters;
    std::size_t size = 0;
};

}  // namespace

const char* scan_float(const char* at, const char* end, float& value) { return scan(at, end, value); }
const char* scan_double(const char* at, const char* end, double& value) { return scan(at, end, value); }

const char* scan_integer(const char* at, const char* end, std::int64_t& value) {
    if (at < end && *at == '+' && at + 1 < end && at[1] != '-') ++at;
    const std::from_chars_result result = std::from_chars(at, end, value);
    return result.ec == std::errc() ? result.ptr : nullptr;
}

void append_items(std::string& text, std::size_t count, const RoomOfItems& room, const PutItems& put_items) {
    std::vector<Block> blocks((count + items_of_block - 1) / items_of_block);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
        const std::size_t begin = b * items_of_block, end = std::min(count, begin + items_of_block);
        blocks[b].characters.reset(new char[room(begin, end)]);  // not make_unique: nobody needs the zeros
        char* const start = blocks[b].characters.get();
        blocks[b].size = static_cast<std::size_t>(put_items(begin, end, start) - start);
    });
    std::size_t size = text.size();
    for (const Block& block : blocks) size += block.size;
    text.reserve(size);
    for (const Block& block : blocks) text.append(block.characters.get(), block.size);
}

}  // namespace sinew
