#include "sinew/io/units.h"

#include <utility>

namespace sinew {
namespace {

constexpr std::pair<std::string_view, double> units[] = {
    {"m", 1},         {"metre", 1},         {"meter", 1},
    {"mm", 1e-3},     {"millimetre", 1e-3}, {"millimeter", 1e-3},
    {"um", 1e-6},     {"µm", 1e-6},         {"μm", 1e-6},
    {"micron", 1e-6}, {"micrometre", 1e-6}, {"micrometer", 1e-6},
    {"nm", 1e-9},     {"nanometre", 1e-9},  {"nanometer", 1e-9},
    {"cm", 1e-2},     {"centimetre", 1e-2}, {"centimeter", 1e-2},
    {"dm", 1e-1},     {"km", 1e3},          {"in", 0.0254},
    {"inch", 0.0254}, {"ft", 0.3048},       {"foot", 0.3048},
};

}  // namespace

std::optional<double> metres_in(std::string_view unit) {
    for (const auto& [name, metres] : units)
        if (name == unit) return metres;
    return std::nullopt;
}

}  // namespace sinew
