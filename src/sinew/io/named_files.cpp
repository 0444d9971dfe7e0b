#include "sinew/io/named_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <exception>
#include <filesystem>
#include <optional>

#include "sinew/io/files.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_shown = 80;

tl::unexpected<Error> refuse(const std::string& naming_file, std::string_view reference,
                             std::string_view why) {
    const std::string_view shown = reference.substr(0, longest_shown);
    return fail(Error{.message = fmt::format("names the file '{}{}', {}", shown,
                                             shown.size() < reference.size() ? "..." : "", why),
                      .cure = "put it beside the file that names it, or export with the data in the file",
                      .file = naming_file});
}

/// "%20" to " "; nothing for what is no escape.
std::optional<std::string> decoded(std::string_view reference) {
    std::string text;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (reference[i] != '%') {
            text += reference[i];
            continue;
        }
        unsigned char byte = 0;
        const char* digits = reference.data() + i + 1;
        if (reference.size() - i < 3 || std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2)
            return std::nullopt;
        text += static_cast<char>(byte);
        i += 2;
    }
    return text;
}

/// "http:", "file:", "C:": a letter, then letters, digits and the like up to a colon.
bool has_scheme(std::string_view text) {
    const std::size_t colon = text.find(':');
    return colon != std::string_view::npos && colon > 0 &&
           std::isalpha(static_cast<unsigned char>(text[0])) &&
           std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon),
                       [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

/// Why a reference is none to a file below a folder, before anything is looked up; empty where it is one.
std::string_view wrong_with(std::string_view path) {
    if (path.empty()) return "which is no name";
    if (std::any_of(path.begin(), path.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
        return "which holds control characters";
    if (has_scheme(path)) return "which is an address: only names of files beside it are followed";
    if (path[0] == '/' || path[0] == '\\')
        return "which is an absolute path: only relative ones are followed";
    const fs::path steps(path);
    if (std::find(steps.begin(), steps.end(), "..") != steps.end())
        return "which leads out of its folder by '..'";
    return {};
}

/// The path behind all links, if it is below the folder of the naming file.
std::optional<fs::path> inside_folder(const std::string& naming_file, const std::string& path) {
    std::error_code missing;
    const fs::path named_folder = fs::path(naming_file).parent_path();
    const fs::path folder = fs::canonical(named_folder.empty() ? fs::path(".") : named_folder, missing);
    if (missing) return std::nullopt;
    const fs::path file = fs::canonical(folder / path, missing);
    if (missing) return std::nullopt;
    const auto [end_of_folder, step] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    if (end_of_folder != folder.end() || step == file.end()) return std::nullopt;
    return file;
}

}  // namespace

Result<std::string> read_named_file(const std::string& naming_file, std::string_view reference,
                                    std::uint64_t most) try {
    if (naming_file.empty() || naming_file == "-" || naming_file == input_name("-"))
        return refuse(naming_file, reference, "and what comes from standard input may name none");
    const std::optional<std::string> path = decoded(reference);
    if (!path) return refuse(naming_file, reference, "which has a % that is no escape");
    if (const std::string_view why = wrong_with(*path); !why.empty())
        return refuse(naming_file, reference, why);

    // One answer for what does not exist and for what a link leads out to, so that nobody learns which it is.
    constexpr std::string_view not_there = "which is not in its folder, or is a link that leads out of it";
    const std::optional<fs::path> file = inside_folder(naming_file, *path);
    if (!file) return refuse(naming_file, reference, not_there);
    // Nothing waits for the other end of a pipe, and no link that was put there meanwhile is followed.
    const int descriptor = ::open(file->c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
        return refuse(naming_file, reference,
                      errno == EACCES ? "which may not be read" : "which cannot be opened");
    struct stat status {};
    const bool regular = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    const bool small = regular && static_cast<std::uint64_t>(status.st_size) <= most;
    std::optional<std::string> bytes;
    if (small) bytes = read_descriptor(descriptor, most);
    ::close(descriptor);
    if (!regular) return refuse(naming_file, reference, "which is no regular file");
    if (!small) return refuse(naming_file, reference, fmt::format("which has more than {} bytes", most));
    if (!bytes) return refuse(naming_file, reference, "which cannot be read");
    return *std::move(bytes);
} catch (const std::exception&) {  // bad_alloc, and what the file system's library may throw
    return refuse(naming_file, reference, "which cannot be read");
}

}  // namespace sinew
