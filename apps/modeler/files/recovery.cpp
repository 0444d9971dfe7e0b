#include "files/recovery.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>

#include "sinew/io/files.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::modeler {
namespace {

namespace fs = std::filesystem;

bool is_running(long process) { return kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM; }

/// The process that a copy belongs to; 0 for files that are no copies.
long process_of(const fs::path& copy) {
    const std::string name = copy.filename().string();
    if (copy.extension() != ".sinew") return 0;
    long process = 0;
    std::from_chars(name.data(), name.data() + name.size(), process);
    return process;
}

fs::path note_beside(fs::path copy) { return copy.replace_extension(".name"); }

}  // namespace

Recovery::Recovery(fs::path folder) : folder_(std::move(folder)) {
    static std::atomic<int> count{0};
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    copy_ = folder_ / fmt::format("{}-{}.sinew", getpid(), count++);
}

Result<void> Recovery::keep(const Document& document, const std::string& original) {
    if (auto written = write_file(note_beside(copy_).string(), original); !written) return written;
    auto written = write_skeleton(document, copy_.string());
    if (!written) return fail(written.error());
    return {};
}

void Recovery::drop() {
    std::error_code ignored;
    fs::remove(copy_, ignored);
    fs::remove(note_beside(copy_), ignored);
}

std::vector<Leftover> Recovery::leftovers() const {
    std::vector<Leftover> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const long process = process_of(entry.path());
        if (process <= 0 || process == getpid() || is_running(process)) continue;
        std::error_code ignored;
        Leftover leftover{entry.path(), {}, entry.last_write_time(ignored)};
        if (auto original = read_file(note_beside(entry.path()).string())) leftover.original = *original;
        found.push_back(std::move(leftover));
    }
    std::sort(found.begin(), found.end(),
              [](const Leftover& a, const Leftover& b) { return a.when > b.when; });
    return found;
}

void Recovery::discard(const Leftover& leftover) {
    std::error_code ignored;
    fs::remove(leftover.copy, ignored);
    fs::remove(note_beside(leftover.copy), ignored);
}

}  // namespace sinew::modeler
