// An open file of the system.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace glift::files {

class Descriptor {
public:
    Descriptor() = default;
    Descriptor(std::string path, int flags);
    Descriptor(Descriptor&& other) noexcept
        : path_(std::move(other.path_)), number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(path_, other.path_), std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor();
    /// A name under which this process can open the file again.
    std::string name_in_process() const { return "/proc/self/fd/" + std::to_string(number_); }

    const std::string& path() const { return path_; }
    int number() const { return number_; }
    std::uint64_t size() const;
    /// Reads as many bytes as there are from `offset` on, and returns their number.
    std::size_t read(std::uint64_t offset, std::span<std::byte> to) const;
    void write(std::uint64_t offset, std::span<const std::byte> from) const;
    void sync() const;
    void resize(std::uint64_t bytes) const;

private:
    std::string path_;
    int number_ = -1;
};

}  // namespace glift::files
