// What holds of every reader of skeletons: whatever the bytes, it gives an error with a message or a sound
// document, and what is written of that document reads back as the same text.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string_view>

#include "sinew/io/skeleton_formats.h"
#include "sinew/skeleton/validate.h"

namespace sinew {

inline void must(bool holds, const char* what, const std::string& detail = {}) {
    if (holds) return;
    std::cerr << "does not hold: " << what << ' ' << detail << '\n';
    std::abort();
}

/// @param input, output  file names with the extension of the format
inline void check_round_trip(std::string_view bytes, const char* input, const char* output) {
    Result<ReadSkeleton> read = parse_skeleton(bytes, input);
    if (!read)
        return must(!read.error().message.empty() && read.error().kind == ErrorKind::input,
                    "an error says what is wrong");
    Result<void> valid = validate(read->document);
    must(valid.has_value(), "what is read is valid", valid ? "" : valid.error().text());
    Result<WrittenSkeleton> written = print_skeleton(read->document, output);
    must(written.has_value(), "what is read can be written", written ? "" : written.error().text());
    Result<ReadSkeleton> again = parse_skeleton(written->text, output);
    must(again.has_value(), "what is written can be read", again ? "" : again.error().text());
    must(print_skeleton(again->document, output)->text == written->text, "a second round changes nothing",
         written->text);
}

}  // namespace sinew
