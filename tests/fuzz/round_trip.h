// What holds of every reader of skeletons: whatever the bytes, it gives an error with a message or a sound
// document, and what is written of that document reads back as the same skeleton.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "sinew/io/skeleton_formats.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"

namespace sinew {

inline void must(bool holds, const char* what, const std::string& detail = {}) {
    if (holds) return;
    std::cerr << "does not hold: " << what << ' ' << detail << '\n';
    std::abort();
}

/// The bones, each from its lower node to its higher one.
inline std::vector<Bone> undirected(const Document& document) {
    std::vector<Bone> bones = bones_of(document);
    for (Bone& bone : bones) std::ranges::sort(bone);
    std::ranges::sort(bones);
    return bones;
}

inline bool same_skeleton(const Document& a, const Document& b) {
    auto same = [](const Node& p, const Node& q) { return p.position == q.position && p.radius == q.radius; };
    return std::ranges::equal(a.nodes, b.nodes, same) && undirected(a) == undirected(b);
}

/// @param input, output  file names with the extension of the format
/// @returns false where the bytes are refused
inline bool check_round_trip(std::string_view bytes, const char* input, const char* output) {
    Result<ReadSkeleton> read = parse_skeleton(bytes, input);
    if (!read) {
        must(!read.error().message.empty() && read.error().kind == ErrorKind::input,
             "an error says what is wrong");
        return false;
    }
    Result<void> valid = validate(read->document);
    must(valid.has_value(), "what is read is valid", valid ? "" : valid.error().text());
    Result<WrittenSkeleton> written = print_skeleton(read->document, output);
    must(written.has_value(), "what is read can be written", written ? "" : written.error().text());
    Result<ReadSkeleton> again = parse_skeleton(written->text, output);
    must(again.has_value(), "what is written can be read", again ? "" : again.error().text());
    must(same_skeleton(read->document, again->document), "it is the same skeleton", written->text);
    return true;
}

}  // namespace sinew
