// HDF5's handles, with errors as exceptions. HDF5 is not safe for several threads: whoever uses it holds `Hdf5Lock`.
#pragma once

#include <glift/files/element_type.h>

#include <hdf5.h>

#include <mutex>
#include <string>
#include <vector>

namespace glift::files {

class Hdf5Lock {
public:
    Hdf5Lock();
    void release() { lock_.unlock(); }

private:
    std::unique_lock<std::recursive_mutex> lock_;
};

/// Throws glift::Error with what HDF5 noted last.
[[noreturn]] void throw_hdf5(const char* call);
inline void check(herr_t result, const char* call) {
    if (result < 0) throw_hdf5(call);
}

/// A handle, closed with the object.
class Id {
public:
    Id() = default;
    Id(hid_t id, const char* call) : id_(id) {
        if (id < 0) throw_hdf5(call);
    }
    Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    Id& operator=(Id&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Id() { close(); }
    operator hid_t() const { return id_; }
    /// What closing a file returns says whether all of it was written.
    herr_t close() { return id_ < 0 ? 0 : static_cast<herr_t>(H5Idec_ref(std::exchange(id_, -1)) < 0 ? -1 : 0); }

private:
    hid_t id_ = -1;
};

/// The type of a number in a file. Bools are the enum that h5py makes a bool of: one byte, FALSE or TRUE.
Id file_type(Scalar scalar);
/// The bytes of a number in a file.
std::size_t file_bytes(Scalar scalar);
Id simple_space(const std::vector<hsize_t>& extent);

/// Writes a small attribute.
void write_attribute(hid_t object, const std::string& name, Scalar scalar, const std::vector<hsize_t>& extent,
                     const void* numbers);
void write_attribute(hid_t object, const std::string& name, const std::string& text);
std::string read_text_attribute(hid_t object, const std::string& name);

}  // namespace glift::files
