// Reads a structure from an HDF5 file.
#pragma once

#include "dataset.h"
#include "match.h"

#include <functional>
#include <map>
#include <optional>

namespace glift::files {

class StructureReader {
public:
    /// `progress` is called with the bytes of memory that were restored since its last call.
    StructureReader(hid_t file, std::string file_name, Pieces& pieces, const Commands& commands,
                    std::function<void(std::uint64_t)> progress)
        : file_(file), file_name_(std::move(file_name)), pieces_(pieces), commands_(commands),
          progress_(std::move(progress)) {}

    /// Restores all parts. The file fits (match.h).
    void read_all(const FiledPart& filed, const Part& part);
    /// Writes the elements to their addresses; elements that the file does not have become 0.
    void read_by_address(const FiledPart& filed, const Part& part);

private:
    /// The datasets of a memory, each read chunk by chunk. A field that the file does not have has none.
    struct FieldReader {
        const Field* field;
        std::optional<StoredDataset> dataset;
    };

    /// Whether one field, which the file has, is all of an element.
    static bool is_covered(const ElementType& type, std::span<const FieldReader> readers);
    void read_memory(const FiledMemory& filed, const StoredMemory& memory);
    /// Gives the plane a memory of the size that the file says, if it has another one.
    void resize(const FiledMemory& filed, const Plane& plane);
    void read_buffers(const FiledMemory& filed, const StoredMemory& memory);
    /// Reads a batch of elements of each plane.
    void read_batch(const StoredMemory& memory, std::vector<FieldReader>& readers, const Batch& batch,
                    std::vector<std::vector<std::byte>>& planes);
    void read_image(const FiledMemory& filed, const Memory& image);
    FieldReader open_field(const FiledMemory& filed, const Field& field);
    /// Reads the field of a batch of elements into these elements.
    void read_field(FieldReader& reader, const Batch& batch, std::uint32_t element_bytes,
                    std::span<std::byte> elements);

    hid_t file_;
    std::string file_name_;
    Pieces& pieces_;
    const Commands& commands_;
    std::function<void(std::uint64_t)> progress_;
    std::map<const void*, std::pair<Memory, Memory>> replaced_;  ///< by the old one: the old and the new one
    AddressShift shift_;
    std::map<const void*, bool> is_read_;
    std::vector<std::byte> packed_;
};

}  // namespace glift::files
