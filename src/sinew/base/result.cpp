#include "sinew/base/result.h"

#include <fmt/format.h>

namespace sinew {

std::string Error::text() const {
    std::string place = file;
    if (line > 0) place += fmt::format(":{}", line);
    if (line > 0 && column > 0) place += fmt::format(":{}", column);
    if (!place.empty()) place += ": ";
    if (!path.empty()) place += path + ": ";
    if (node) place += fmt::format("node {}: ", *node);
    return place + message + (cure.empty() ? "" : "; " + cure);
}

}  // namespace sinew
