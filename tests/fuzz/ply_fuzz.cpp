#include "mesh_round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return sinew::check_mesh_reader(data, size, sinew::FormatName::ply);
}
