/// @file recovery.h
/// Copies of what is being edited, for the case that the program does not come to its end.
///
/// Each window keeps one copy in a common folder, named after its process. A copy whose process is gone is
/// what a crash has left behind. Where nothing is to be saved there is no copy.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// What a crash has left.
struct Leftover {
    std::filesystem::path copy;  ///< a sinew document
    std::string original;        ///< the file that it was; empty for a document that never had one
    std::filesystem::file_time_type when;
};

class Recovery {
  public:
    /// Makes the folder if need be; nothing else happens before the first keep().
    explicit Recovery(std::filesystem::path folder);
    ~Recovery() { drop(); }
    Recovery(const Recovery&) = delete;

    /// Replaces the copy of this process.
    Result<void> keep(const Document& document, const std::string& original);
    /// Everything is saved, or was given up: no copy.
    void drop();

    /// Newest first; copies of processes that still run are not among them.
    std::vector<Leftover> leftovers() const;
    static void discard(const Leftover& leftover);

    const std::filesystem::path& copy() const { return copy_; }

  private:
    std::filesystem::path folder_, copy_;
};

}  // namespace sinew::modeler
