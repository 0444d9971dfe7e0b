#include "sinew/subdivide/room.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace sinew {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

/// The number after a key in a file such as /proc/meminfo; with an empty key the first word of the file.
std::uint64_t read_number(const char* file, const std::string& key, std::uint64_t otherwise) {
    std::ifstream in(file);
    for (std::string word; in >> word;) {
        std::uint64_t number = 0;
        if (key.empty()) {
            const bool digits = word.find_first_not_of("0123456789") == std::string::npos && word.size() < 19;
            return digits ? std::stoull(word) : otherwise;
        }
        if (word == key && in >> number) return number;
    }
    return otherwise;
}

std::uint64_t left_of(std::uint64_t limit, std::uint64_t used) { return limit > used ? limit - used : 0; }

std::uint64_t left_of_machine() {
    const std::uint64_t kibibytes = read_number("/proc/meminfo", "MemAvailable:", unlimited / 1024);
    return kibibytes * 1024;
}

std::uint64_t left_of_process() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    return left_of(limit.rlim_cur, read_number("/proc/self/status", "VmSize:", 0) * 1024);
}

std::uint64_t left_of_group() {
    const std::uint64_t limit = read_number("/sys/fs/cgroup/memory.max", "", unlimited);
    if (limit == unlimited) return unlimited;
    const std::uint64_t used = read_number("/sys/fs/cgroup/memory.current", "", 0);
    return left_of(limit, left_of(used, read_number("/sys/fs/cgroup/memory.stat", "inactive_file", 0)));
}

std::string size_text(std::uint64_t bytes) {
    return fmt::format("{:.1f} GiB", static_cast<double>(bytes) / (1 << 30));
}

}  // namespace

LevelCounts counts_after(const Level& control, int splits) {
    LevelCounts counts{control.vertices, control.edge_count(), control.faces, control.slot_count()};
    for (int split = 0; split < splits && counts.slots < std::uint64_t{1} << 60; ++split)
        counts = {counts.vertices + counts.edges + counts.faces, 2 * counts.edges + counts.slots,
                  counts.slots, 4 * counts.slots};
    return counts;
}

std::uint64_t bytes_needed(const Level& control, int splits, bool limit, std::uint64_t origins) {
    constexpr std::uint64_t position = sizeof(Vec3f), index = sizeof(std::uint32_t);
    std::uint64_t bytes = 0;
    for (int split = 0; split < splits; ++split) {
        const LevelCounts counts = counts_after(control, split);
        bytes += counts.vertices * position + 2 * index * (counts.slots + counts.edges);
    }
    const LevelCounts finest = counts_after(control, splits);
    bytes += finest.vertices * (position + origins) + index * (finest.faces + finest.slots);
    return bytes + (limit ? finest.vertices * position : 0);
}

std::uint64_t bytes_available() { return std::min({left_of_machine(), left_of_process(), left_of_group()}); }

Result<void> check_room(const Level& control, int splits, bool limit, std::uint64_t origins,
                        std::uint64_t available) {
    const LevelCounts finest = counts_after(control, splits);
    const auto refuse = [&](const std::string& why) {
        return fail(ErrorKind::call,
                    fmt::format("level {} would have {}{} faces, {}", splits,
                                finest.slots >> 60 ? "more than " : "", finest.faces, why),
                    "take fewer levels");
    };
    if (std::max(finest.slots, finest.vertices) >= no_index) return refuse("more than a mesh can number");
    const std::uint64_t needed = bytes_needed(control, splits, limit, origins);
    if (needed > available)
        return refuse(fmt::format("which take {} of memory where {} are left", size_text(needed),
                                  size_text(available)));
    return {};
}

}  // namespace sinew
