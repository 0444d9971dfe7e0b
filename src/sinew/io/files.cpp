#include "sinew/io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <exception>
#include <utility>

namespace sinew {
namespace {

tl::unexpected<Error> fail_at(const std::string& file, ErrorKind kind, std::string message,
                              std::string cure = {}) {
    return fail(Error{.kind = kind, .message = std::move(message), .cure = std::move(cure), .file = file});
}

/// A file descriptor that closes itself.
struct Descriptor {
    int value = -1;
    explicit Descriptor(int v) : value(v) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    /// Some file systems report a full disk only here.
    bool close() {
        int closing = std::exchange(value, -1);
        return closing < 0 || ::close(closing) == 0;
    }
};

/// A file size limit sends SIGXFSZ, which would end the program between the temporary file and its removal.
/// While this lives the signal does not reach the thread, and write() fails with EFBIG instead.
class FileSizeSignalBlocked {
  public:
    FileSizeSignalBlocked() {
        sigemptyset(&signals_);
        sigaddset(&signals_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    }
    FileSizeSignalBlocked(const FileSizeSignalBlocked&) = delete;
    FileSizeSignalBlocked& operator=(const FileSizeSignalBlocked&) = delete;
    ~FileSizeSignalBlocked() {
        const timespec no_time{};
        while (!sigismember(&before_, SIGXFSZ) && sigtimedwait(&signals_, nullptr, &no_time) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

  private:
    sigset_t signals_{}, before_{};
};

bool read_all(int descriptor, std::string& bytes, std::size_t expected) {
    std::size_t used = 0;
    bytes.resize(expected +
                 1);  // one more, so that the end of a file of the expected size needs no second round
    for (;;) {
        if (used == bytes.size()) bytes.resize(std::max<std::size_t>(2 * used, 1 << 16));
        ssize_t got = ::read(descriptor, bytes.data() + used, bytes.size() - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return false;
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
    }
    bytes.resize(used);
    return true;
}

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(put));
    }
    return true;
}

std::string cure_of(int reason) {
    switch (reason) {
        case ENOENT:
            return "check the name";
        case EISDIR:
            return "name a file, not a folder";
        case EACCES:
        case EPERM:
        case EROFS:
            return "check the permissions";
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return "make room or choose another place";
        default:
            return {};
    }
}

tl::unexpected<Error> cannot_write(const std::string& path, int reason, bool old_stays) {
    std::string message = fmt::format("cannot be written ({})", std::strerror(reason));
    if (old_stays) message += "; the old file is as it was";
    // A wrong place is the caller's to mend; a full or failing disk is the machine's fault.
    bool callers =
        reason == ENOENT || reason == EISDIR || reason == ENOTDIR || reason == EACCES || reason == EROFS;
    return fail_at(path == "-" ? "standard output" : path, callers ? ErrorKind::call : ErrorKind::program,
                   message, reason == ENOENT ? "make the folder first" : cure_of(reason));
}

Result<void> write_directly(const std::string& path, int descriptor, std::string_view contents) {
    if (!write_all(descriptor, contents)) return cannot_write(path, errno, false);
    return {};
}

/// Where the bytes end up: behind all symbolic links, also behind one that points to a file not made yet.
std::string target_of(const std::string& path) {
    std::string target = path;
    for (int links = 0; links < 40; ++links) {
        char buffer[PATH_MAX];
        ssize_t length = ::readlink(target.c_str(), buffer, sizeof buffer);
        if (length <= 0 || length == sizeof buffer) break;
        std::string next(buffer, static_cast<std::size_t>(length));
        std::size_t slash = target.rfind('/');
        target = next[0] == '/' || slash == std::string::npos ? next : target.substr(0, slash + 1) + next;
    }
    return target;
}

/// A name in the target's folder that no other call, thread or process uses.
std::string name_beside(const std::string& target) {
    static std::atomic<unsigned> count = 0;
    std::size_t start = target.rfind('/') + 1;
    std::string name =
        target.substr(start, 100);  // a long name must not grow beyond what the file system takes
    return fmt::format("{}.{}.{}-{}.part", target.substr(0, start), name, ::getpid(), ++count);
}

/// Writes `temporary` whole and gives it the target's name; 0, or the reason why it could not.
int replace(const std::string& temporary, const std::string& target, mode_t mode, bool keep_mode,
            std::string_view contents) {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (file.value < 0) return errno;
    if (keep_mode && ::fchmod(file.value, mode) != 0) return errno;
    if (!write_all(file.value, contents) || ::fsync(file.value) != 0 || !file.close()) return errno;
    return ::rename(temporary.c_str(), target.c_str()) == 0 ? 0 : errno;
}

}  // namespace

Result<std::string> read_file(const std::string& path) try {
    const std::string name = input_name(path);
    Descriptor opened(path == "-" ? -1 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    const int descriptor = path == "-" ? STDIN_FILENO : opened.value;
    if (descriptor < 0) {
        const int reason = errno;
        return fail_at(name, ErrorKind::input, fmt::format("cannot be opened ({})", std::strerror(reason)),
                       cure_of(reason));
    }
    struct stat status {};
    const bool sized = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    std::string bytes;
    if (!read_all(descriptor, bytes, sized ? static_cast<std::size_t>(status.st_size) : 0)) {
        const int reason = errno;
        return fail_at(name, ErrorKind::input, fmt::format("cannot be read ({})", std::strerror(reason)),
                       cure_of(reason));
    }
    return bytes;
} catch (const std::exception&) {  // bad_alloc, length_error
    return fail_at(input_name(path), ErrorKind::input, "is too large for the memory");
}

Result<void> write_file(const std::string& path, std::string_view contents) {
    FileSizeSignalBlocked blocked;
    if (path == "-") return write_directly(path, STDOUT_FILENO, contents);

    const std::string target = target_of(path);
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) return cannot_write(path, EISDIR, false);
    if (exists && !S_ISREG(status.st_mode)) {
        Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
        if (file.value < 0) return cannot_write(path, errno, false);
        return write_directly(path, file.value, contents);
    }
    // Renaming needs no right to write the old file; a user who took that right away means it.
    if (exists && ::access(target.c_str(), W_OK) != 0) return cannot_write(path, errno, true);

    const std::string temporary = name_beside(target);
    const int reason = replace(temporary, target, exists ? status.st_mode & 07777 : 0666, exists, contents);
    if (reason == 0) return {};
    if (reason != EEXIST) ::unlink(temporary.c_str());
    return cannot_write(path, reason, exists);
}

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string extension_of(std::string_view path) {
    std::size_t dot = path.rfind('.'), slash = path.rfind('/');
    if (dot == std::string_view::npos || (slash != std::string_view::npos && dot < slash)) return {};
    std::string extension(path.substr(dot));
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace sinew
