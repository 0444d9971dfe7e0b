// Where the data is that is not the project's to redistribute; empty where there is none, and then tests
// skip.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace sinew {

inline std::filesystem::path shared_data() {
    const char* given = std::getenv("SINEW_SHARED");
    for (std::filesystem::path folder :
         {std::filesystem::path(given ? given : ""), std::filesystem::path(SINEW_SOURCE_FOLDER "/../shared")})
        if (!folder.empty() && std::filesystem::is_directory(folder / "data")) return folder / "data";
    return {};
}

}  // namespace sinew
