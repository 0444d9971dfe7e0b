#include "sinew/io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
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

/// 0, or the reason why it could not be read; EFBIG for more than `most` bytes.
int read_all(int descriptor, std::string& bytes, std::size_t expected, std::uint64_t most) {
    std::size_t used = 0;
    bytes.resize(expected +
                 1);  // one more, so that the end of a file of the expected size needs no second round
    for (;;) {
        if (used > most) return EFBIG;
        if (used == bytes.size()) bytes.resize(std::max<std::size_t>(2 * used, 1 << 16));
        ssize_t got = ::read(descriptor, bytes.data() + used, bytes.size() - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno;
        if (got == 0) break;
        used += static_cast<std::size_t>(got);
    }
    bytes.resize(used);
    return 0;
}

/// Devices go on for ever, or do something when they are read.
bool is_readable_kind(const struct stat& status, int descriptor) {
    const mode_t mode = status.st_mode;
    if (S_ISREG(mode) || S_ISDIR(mode) || S_ISFIFO(mode) || S_ISSOCK(mode))
        return true;  // a folder: read() says so
    return S_ISCHR(mode) && (::isatty(descriptor) != 0 || status.st_rdev == ::makedev(1, 3));  // or /dev/null
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
        case ENOTDIR:
            return "a part of the path is no folder; check the name";
        case ENAMETOOLONG:
            return "take a shorter name";
        case ELOOP:
            return "the links lead in a circle; name the file itself";
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
    // What has a cure is the caller's to mend; the rest is the machine's fault.
    const std::string cure = reason == ENOENT ? "make the folder first" : cure_of(reason);
    return fail_at(path == "-" ? "standard output" : path,
                   cure.empty() ? ErrorKind::program : ErrorKind::call, message, cure);
}

Result<void> write_directly(const std::string& path, int descriptor, std::string_view contents) {
    if (!write_all(descriptor, contents)) return cannot_write(path, errno, false);
    return {};
}

/// The number of an open file that a path such as /dev/fd/3 or /proc/self/fd/3 stands for; -1 for other paths.
int open_file_of(std::string_view path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    const std::string own = fmt::format("/proc/{}/fd/", ::getpid());
    for (const std::string_view folder : {std::string_view("/dev/fd/"), std::string_view("/proc/self/fd/"),
                                          std::string_view("/proc/thread-self/fd/"), std::string_view(own)}) {
        if (!path.starts_with(folder)) continue;
        int number = -1;
        const char* end = path.data() + path.size();
        const auto [stop, code] = std::from_chars(path.data() + folder.size(), end, number);
        if (code == std::errc{} && stop == end) return number;
    }
    return -1;
}

/// Where bytes for a path end up.
struct Target {
    std::string path;    ///< behind all symbolic links, also behind one that points to a file not made yet
    int open_file = -1;  ///< an open file that the path stands for
    int reason = 0;      ///< why there is no such place
};

Target target_of(const std::string& path) {
    Target target{path};
    for (int links = 0; links < 40; ++links) {
        target.open_file = open_file_of(target.path);
        if (target.open_file >= 0) return target;
        char buffer[PATH_MAX];
        ssize_t length = ::readlink(target.path.c_str(), buffer, sizeof buffer);
        if (length <= 0) return target;
        if (length == sizeof buffer) return target.reason = ENAMETOOLONG, target;
        std::string next(buffer, static_cast<std::size_t>(length));
        std::size_t slash = target.path.rfind('/');
        target.path =
            next[0] == '/' || slash == std::string::npos ? next : target.path.substr(0, slash + 1) + next;
    }
    target.reason = ELOOP;
    return target;
}

/// The hidden file in the target's folder. Calls that write the same target at the same time take one number each.
std::string name_beside(const std::string& target, int number) {
    std::size_t start = target.rfind('/') + 1;
    std::string name =
        target.substr(start, 100);  // a long name must not grow beyond what the file system takes
    return fmt::format("{}.{}{}.part", target.substr(0, start), name,
                       number > 0 ? fmt::format(".{}", number) : "");
}

/// Removes a hidden file that nobody is writing any more: who does holds a lock on it. It is ours and plain, or it
/// stays.
void remove_stale(const std::string& temporary) {
    Descriptor file(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    struct stat status {};
    if (file.value < 0 || ::fstat(file.value, &status) != 0 || !S_ISREG(status.st_mode) ||
        status.st_uid != ::geteuid() || ::flock(file.value, LOCK_EX | LOCK_NB) != 0)
        return;
    ::unlink(temporary.c_str());
}

/// Makes a hidden file and locks it. A value of -1: errno says why.
int make_hidden(const std::string& target, mode_t mode, std::string& temporary) {
    constexpr int most_at_once = 1000;
    for (int number = 0; number < most_at_once; ++number) {
        temporary = name_beside(target, number);
        remove_stale(temporary);
        const int made = ::open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (made < 0 && errno == EEXIST) continue;
        if (made < 0) return made;
        // Between the two lines above somebody may have taken it for a stale one.
        struct stat ours {
        }, named{};
        ::flock(made, LOCK_EX | LOCK_NB);
        if (::fstat(made, &ours) == 0 && ::lstat(temporary.c_str(), &named) == 0 &&
            ours.st_ino == named.st_ino && ours.st_dev == named.st_dev)
            return made;
        ::close(made);
    }
    errno = EEXIST;
    return -1;
}

/// The rights that a file keeps: never those to run as its owner or group.
mode_t kept_mode(const struct stat& status) { return status.st_mode & 0777; }

/// Writes over a file that other names lead to. The room is taken first, so that a full disk leaves the old bytes.
int write_over(const std::string& target, const struct stat& status, std::string_view contents) {
    Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW));
    if (file.value < 0) return errno;
    const auto size = static_cast<off_t>(contents.size());
    if (size > status.st_size) {
        if (const int reason = ::posix_fallocate(file.value, 0, size); reason != 0) {
            [[maybe_unused]] const int undone = ::ftruncate(file.value, status.st_size);
            return reason;
        }
    }
    if (!write_all(file.value, contents) || ::ftruncate(file.value, size) != 0) return errno;
    if ((status.st_mode & 07000) != 0 && ::fchmod(file.value, kept_mode(status)) != 0) return errno;
    return ::fsync(file.value) == 0 && file.close() ? 0 : errno;
}

/// Writes the hidden file whole and gives it the target's name; 0, or the reason why it could not.
/// @param old  of the file that is replaced; null where there is none
int replace(const std::string& target, const struct stat* old, std::string_view contents) {
    std::string temporary;
    Descriptor file(make_hidden(target, old ? kept_mode(*old) & 0700 : 0666, temporary));
    if (file.value < 0) return errno;
    int reason = 0;
    if (!write_all(file.value, contents)) reason = errno;
    if (reason == 0 && old) {
        // Whose it was it stays, where that is allowed. Rights after that: giving a file away takes some.
        [[maybe_unused]] const int given = ::fchown(file.value, old->st_uid, old->st_gid);
        if (::fchmod(file.value, kept_mode(*old)) != 0) reason = errno;
    }
    if (reason == 0 && ::fsync(file.value) != 0) reason = errno;
    const bool links = old && old->st_nlink > 1;
    if (reason == 0 && links) reason = write_over(target, *old, contents);
    if (reason == 0 && !links && ::rename(temporary.c_str(), target.c_str()) != 0) reason = errno;
    if (reason != 0 || links) ::unlink(temporary.c_str());
    return reason;
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
    const bool known = ::fstat(descriptor, &status) == 0;
    if (known && !is_readable_kind(status, descriptor))
        return fail_at(name, ErrorKind::input, "is a device, not a file", "name a file or a pipe");
    std::optional<std::string> bytes = read_descriptor(descriptor, largest_input);
    if (bytes) return *std::move(bytes);
    const int reason = errno;
    if (reason == EFBIG)
        return fail_at(name, ErrorKind::input, fmt::format("has more than {} bytes", largest_input),
                       "take less of it at a time");
    return fail_at(name, ErrorKind::input, fmt::format("cannot be read ({})", std::strerror(reason)),
                   cure_of(reason));
} catch (const std::exception&) {  // bad_alloc, length_error
    return fail_at(input_name(path), ErrorKind::input, "is too large for the memory");
}

Result<void> write_file(const std::string& path, std::string_view contents) {
    FileSizeSignalBlocked blocked;
    if (path == "-") return write_directly(path, STDOUT_FILENO, contents);

    const Target target = target_of(path);
    if (target.reason != 0) return cannot_write(path, target.reason, false);
    if (target.open_file >= 0) return write_directly(path, target.open_file, contents);
    struct stat status {};
    const bool exists = ::stat(target.path.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) return cannot_write(path, EISDIR, false);
    if (exists && !S_ISREG(status.st_mode)) {
        Descriptor file(::open(target.path.c_str(), O_WRONLY | O_CLOEXEC));
        if (file.value < 0) return cannot_write(path, errno, false);
        return write_directly(path, file.value, contents);
    }
    // Renaming needs no right to write the old file; a user who took that right away means it.
    if (exists && ::access(target.path.c_str(), W_OK) != 0) return cannot_write(path, errno, true);
    const int reason = replace(target.path, exists ? &status : nullptr, contents);
    if (reason == 0) return {};
    return cannot_write(path, reason, exists);
}

bool writes_directly(const std::string& path) {
    if (path == "-") return true;
    const Target target = target_of(path);
    struct stat status {};
    return target.open_file >= 0 || (::stat(target.path.c_str(), &status) == 0 && !S_ISREG(status.st_mode));
}

std::optional<std::string> read_descriptor(int descriptor, std::uint64_t most) {
    struct stat status {};
    const bool sized = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    const std::uint64_t size = sized ? static_cast<std::uint64_t>(status.st_size) : 0;
    std::string bytes;
    const int reason =
        size > most ? EFBIG : read_all(descriptor, bytes, static_cast<std::size_t>(size), most);
    if (reason == 0) return bytes;
    errno = reason;
    return std::nullopt;
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
