#include "new_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace {

constexpr unsigned most_names = 1000;

}  // namespace

NewFile::NewFile(std::string path) : path_(std::move(path)), target_(path_) {
    std::error_code error;
    if (std::filesystem::exists(target_, error)) {
        target_ = std::filesystem::canonical(target_, error);
        if (!std::filesystem::is_regular_file(target_, error))
            throw std::runtime_error(path_ + ": cannot be written: it is no ordinary file");
    }
    const std::string beside = target_ + ".new-" + std::to_string(::getpid()) + "-";
    for (unsigned i = 0; file_ < 0 && i < most_names; ++i) {
        name_ = beside + std::to_string(i);
        file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file_ < 0 && errno != EEXIST) break;
    }
    if (file_ < 0) fail("cannot be written");
}

NewFile::~NewFile() {
    if (file_ < 0) return;
    ::close(file_);
    ::unlink(name_.c_str());
}

void NewFile::write(std::span<const std::byte> bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t n = ::write(file_, bytes.data() + at, bytes.size() - at);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) fail("cannot be written");
        at += static_cast<std::size_t>(n);
    }
}

void NewFile::take_name() {
    if (::fsync(file_) != 0) fail("cannot be written");
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail("cannot be replaced");
    ::close(file_);
    file_ = -1;
}

void NewFile::fail(const char* what) const {
    throw std::runtime_error(path_ + ": " + what + ": " + std::strerror(errno));
}
