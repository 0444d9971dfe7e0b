#include <cstdint>

#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    if (!sinew::check_round_trip(bytes, "a.sinew", "a.sinew")) return 0;
    auto saved = [](std::string_view text) {
        return sinew::print_skeleton(sinew::parse_skeleton(text, "a.sinew")->document, "a.sinew")->text;
    };
    const std::string once = saved(bytes);
    sinew::must(saved(once) == once, "saving twice gives the same bytes", once);
    return 0;
}
