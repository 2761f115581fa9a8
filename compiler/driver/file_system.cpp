#include "driver/file_system.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace gliftc {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

/// A file descriptor that is closed by its destructor, unless it is standard input.
struct Descriptor {
    int number;
    ~Descriptor() {
        if (number > 0) close(number);
    }
};

ReadResult read_from_disk(const std::string& path) {
    Descriptor file{path == "-" ? 0 : open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.number < 0) return {{}, std::strerror(errno)};
    struct stat info {};
    if (fstat(file.number, &info) != 0) return {{}, std::strerror(errno)};
    if (S_ISDIR(info.st_mode)) return {{}, "it is a folder"};
    std::string text;
    std::size_t filled = 0;
    text.resize(static_cast<std::size_t>(std::max<off_t>(info.st_size, 0)) + 1);
    while (true) {
        if (filled == text.size()) text.resize(text.size() * 2 + 4096);
        ssize_t got = ::read(file.number, text.data() + filled, text.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return {{}, std::strerror(errno)};
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
        if (filled > largest_file) return {{}, "it is larger than 1 GiB"};
    }
    text.resize(filled);
    return {std::move(text), {}};
}

/// Whether the file's contents are these bytes. Compares in pieces, so that a large file is never in memory as a whole.
bool holds(const std::string& path, std::string_view bytes) {
    struct stat info {};
    if (stat(path.c_str(), &info) != 0 || static_cast<std::size_t>(info.st_size) != bytes.size()) return false;
    Descriptor file{open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.number < 0) return false;
    char piece[1 << 14];
    while (!bytes.empty()) {
        const ssize_t got = ::read(file.number, piece, sizeof piece);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0 || !bytes.starts_with(std::string_view(piece, static_cast<std::size_t>(got)))) return false;
        bytes.remove_prefix(static_cast<std::size_t>(got));
    }
    return true;
}

bool is_file(const std::string& path) {
    struct stat info {};
    return stat(path.c_str(), &info) == 0 && !S_ISDIR(info.st_mode);
}

std::string identity_on_disk(const std::string& path) {
    struct stat info {};
    if (path == "-" || stat(path.c_str(), &info) != 0) return path;
    return std::to_string(info.st_dev) + ":" + std::to_string(info.st_ino);
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

FileSystem disk() { return {read_from_disk, is_file, names_in, identity_on_disk}; }

FileSystem only_text(std::string text) {
    const std::string name = "input.glift";
    return {[text = std::move(text), name](const std::string& path) {
                return path == name ? ReadResult{text, {}} : ReadResult{{}, "there is no such file"};
            },
            [name](const std::string& path) { return path == name; },
            [](const std::string&) { return std::vector<std::string>{}; },
            [](const std::string& path) { return path; }};
}

std::optional<std::string> write_if_changed(const std::string& path, const std::string& bytes) {
    if (holds(path, bytes)) return std::nullopt;
    std::error_code error;
    if (fs::path parent = fs::path(path).parent_path(); !parent.empty()) fs::create_directories(parent, error);
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) return std::strerror(errno);
    bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    written = std::fclose(file) == 0 && written;
    if (!written) return std::strerror(errno);
    return std::nullopt;
}

namespace {

/// Writes all bytes and waits until they are on the disk. Sets errno if it fails.
bool write_through(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return fsync(file) == 0;
}

}  // namespace

std::optional<std::string> replace_file(const std::string& path, const std::string& bytes) {
    std::error_code error;
    const std::string target = fs::canonical(path, error).string();  // a symbolic link stays one
    if (error) return error.message();
    struct stat info {};
    if (stat(target.c_str(), &info) != 0) return std::strerror(errno);
    if (!S_ISREG(info.st_mode)) return "it is not a regular file";
    if (access(target.c_str(), W_OK) != 0) return std::strerror(errno);
    std::string beside = target + ".XXXXXX";
    Descriptor file{mkostemp(beside.data(), O_CLOEXEC)};
    if (file.number < 0) return std::strerror(errno);
    const bool owned = fchown(file.number, info.st_uid, info.st_gid) == 0;
    // Without the owner's rights the file keeps its permissions, but neither set-user-ID nor set-group-ID.
    const bool done = fchmod(file.number, info.st_mode & (owned ? 07777 : 0777)) == 0 &&
                      write_through(file.number, bytes) && std::rename(beside.c_str(), target.c_str()) == 0;
    if (done) return std::nullopt;
    const int cause = errno;
    unlink(beside.c_str());
    return std::strerror(cause);
}

namespace {

std::string shared_beside_executable(const char* folder) {
    char path[4096];
    ssize_t length = readlink("/proc/self/exe", path, sizeof path);
    if (length <= 0) return {};
    fs::path executable(std::string(path, static_cast<std::size_t>(length)));
    return (executable.parent_path().parent_path() / "share/glift" / folder).string();
}

}  // namespace

std::string library_beside_executable() { return shared_beside_executable("stdlib"); }
std::string diagnostics_beside_executable() { return shared_beside_executable("diagnostics"); }

}  // namespace gliftc
