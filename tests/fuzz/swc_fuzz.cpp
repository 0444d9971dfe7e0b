#include <cstdint>

#include "round_trip.h"

// Not the whole round trip: the order of the samples may change, and with repaired radii a soma may turn out
// to be one of those that stand for a sphere.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sinew;
    const Result<ReadSkeleton> read = parse_skeleton({reinterpret_cast<const char*>(data), size}, "a.swc");
    if (!read) return 0;
    must(validate(read->document).has_value(), "what is read is valid");
    const Result<ReadSkeleton> again =
        parse_skeleton(print_skeleton(read->document, "a.swc").value().text, "a.swc");
    must(again.has_value(), "what is written can be read", again ? "" : again.error().text());
    must(again->document.nodes.size() <= read->document.nodes.size(), "nothing is added");
    return 0;
}
