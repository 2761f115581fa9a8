#include "descriptor.h"

#include "error.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace glift::files {

Descriptor::Descriptor(std::string path, int flags) : path_(std::move(path)) {
    number_ = ::open(path_.c_str(), flags | O_CLOEXEC, 0666);
    if (number_ < 0) throw_system("open", path_);
}

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

std::uint64_t Descriptor::size() const {
    struct stat status {};
    if (::fstat(number_, &status) != 0) throw_system("fstat", path_);
    return static_cast<std::uint64_t>(status.st_size);
}

std::size_t Descriptor::read(std::uint64_t offset, std::span<std::byte> to) const {
    std::size_t done = 0;
    while (done < to.size()) {
        const ssize_t n = ::pread(number_, to.data() + done, to.size() - done, static_cast<off_t>(offset + done));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw_system("read", path_);
        if (n == 0) break;
        done += static_cast<std::size_t>(n);
    }
    return done;
}

void Descriptor::write(std::uint64_t offset, std::span<const std::byte> from) const {
    std::size_t done = 0;
    while (done < from.size()) {
        const ssize_t n = ::pwrite(number_, from.data() + done, from.size() - done, static_cast<off_t>(offset + done));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) throw_system("write", path_);
        done += static_cast<std::size_t>(n);
    }
}

void Descriptor::sync() const {
    if (::fsync(number_) != 0) throw_system("fsync", path_);
}

void Descriptor::resize(std::uint64_t bytes) const {
    if (::ftruncate(number_, static_cast<off_t>(bytes)) != 0) throw_system("ftruncate", path_);
}

}  // namespace glift::files
