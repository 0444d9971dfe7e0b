/// @file skeleton_file.h
/// What the readers and writers of skeletons share: options and results.
#pragma once

#include <string>

#include "sinew/base/result.h"
#include "sinew/skeleton/document.h"

namespace sinew {

struct ReadOptions {
    std::string format;   ///< a name of the table of formats; empty: the one of the file's extension
    bool strict = false;  ///< the first warning becomes an error
    bool validate =
        true;  ///< false: a native document may make no sense yet (for an editor that shows what is wrong)
};

struct ReadSkeleton {
    Document document;
    Warnings warnings;      ///< what was repaired or guessed, one a kind
    bool measured = false;  ///< the format is one of instruments: condition the document before skinning
};

struct WrittenSkeleton {
    std::string text;
    Warnings warnings;  ///< what the format could not carry, one a kind
};

}  // namespace sinew
