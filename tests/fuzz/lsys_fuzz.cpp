// Whatever stands in a .lsys file, it grows into a sound document or is refused with a place; in bounded
// time.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sinew/grow/grow.h"
#include "sinew/skeleton/validate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto grammar = sinew::parse_grammar({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!grammar) {
        if (grammar.error().line < 1 || grammar.error().message.empty()) std::abort();
        return 0;
    }
    const auto document = sinew::grow(*grammar, {.limit = 500});
    if (document && (!sinew::validate(*document) || document->nodes.size() > 500)) std::abort();
    return 0;
}
