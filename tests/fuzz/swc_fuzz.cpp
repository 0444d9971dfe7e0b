#include <cstdint>

#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    sinew::check_round_trip({reinterpret_cast<const char*>(data), size}, "a.swc", "a.swc");
    return 0;
}
