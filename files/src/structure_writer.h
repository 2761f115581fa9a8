// Writes a structure into an HDF5 file.
#pragma once

#include "dataset.h"
#include "schema.h"

#include <glift/files/part.h>

#include <exception>
#include <functional>
#include <map>

namespace glift::files {

class StructureWriter {
public:
    /// `progress` is called with the bytes of memory that were stored since its last call.
    StructureWriter(hid_t file, const Commands& commands, DataMap* data, std::function<void(std::uint64_t)> progress)
        : file_(file), commands_(commands), data_(data), progress_(std::move(progress)) {}

    /// Ranks of a world call the device alike, and one of them writes. It does so on even after its file failed, which
    /// error() then says, since the device may need it to send elements to the others.
    void write_for_all(bool is_writer) { defers_ = true, has_file_ = is_writer; }
    const std::exception_ptr& error() const { return error_; }

    /// Writes the structure as the group `root.name`.
    void write(const Part& root);

private:
    /// Runs what changes the file.
    template <class Run> void on_file(Run run) {
        if (!has_file_ || error_) return;
        if (!defers_) return run();
        try {
            run();
        } catch (...) {
            error_ = std::current_exception();
        }
    }
    std::vector<NewDataset> make_datasets(const FiledMemory& filed, const Tiling& tiling);
    FiledPart write_part(const Part& part, const std::string& path, bool has_group);
    FiledMemory write_memory(const Part& part, const StoredMemory& memory, const std::string& path);
    void write_buffers(const StoredMemory& memory, const FiledMemory& filed);
    void write_elements(const Elements& elements, const FiledMemory& filed);
    void write_image(const Memory& image, const std::string& path);

    hid_t file_;
    const Commands& commands_;
    DataMap* data_;  ///< null: of a rank that does not write
    std::function<void(std::uint64_t)> progress_;
    std::map<const void*, std::string> paths_;  ///< where memories are that were written
    bool has_file_ = true, defers_ = false;
    std::exception_ptr error_;
};

/// How many elements of a memory are moved at a time: chunks of a field have at most 4 MiB.
std::uint64_t elements_at_a_time(const std::vector<Field>& fields);
/// The dataset of a field of a memory.
std::string path_of(const FiledMemory& memory, const Field& field);
/// The path of a level of an image.
std::string path_of_level(const std::string& path, std::uint32_t mips, std::uint32_t mip);
/// Which axes of a level's grid (images.h) its dataset has.
std::vector<bool> shown_axes(MemoryKind kind);
/// A batch as a box of addresses: lists of a batch begin with the slowest axis.
Extent address_extent(const std::vector<std::uint64_t>& lengths);

}  // namespace glift::files
