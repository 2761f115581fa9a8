// What a structure consists of, without its C++ type: what the library stores and restores.
#pragma once

#include <glift/commands.h>
#include <glift/extent.h>
#include <glift/files/element_type.h>
#include <glift/structure.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glift::files {

/// An argument of a constructor, or a value that a container keeps on the host.
struct Value {
    std::string name;
    bool is_argument = true;
    void* data = nullptr;
    ElementType type;
};

/// The extent of a memory, which its structure keeps beside the handle.
struct ExtentField {
    void* data = nullptr;
    unsigned axes = 1;
    bool is_wide = false;  ///< 64 bits: the number of a buffer's elements

    std::array<std::uint64_t, 3> get() const;
    void set(const std::array<std::uint64_t, 3>& extent) const;
};

/// A buffer that holds elements, or one field of them, or an image.
struct Plane {
    Memory* memory = nullptr;
    ExtentField extent;
    ElementType type;  ///< of an image: empty
};

/// A memory as it is declared. Buffers whose layout is apart have a plane for each field.
struct StoredMemory {
    std::string name;
    bool is_image = false;
    std::vector<Plane> planes;
};

/// The elements of a structure all of which are resident, by address.
struct Elements {
    unsigned rank = 1;
    bool is_row_major = false;  ///< whether the structure's buffers hold the elements in row-major order
    ElementType type;
    std::function<Extent()> domain;
    std::function<void(const Extent& origin, const Extent& size, std::vector<std::byte>& to)> read;
    std::function<void(const Extent& origin, const Extent& size, std::span<const std::byte> from)> write;
};

enum class Role : std::uint8_t { root, member, base, given };

/// A structure, and what it consists of. Refers to the structure, which must outlive it.
struct Part {
    std::string name, type;
    std::uint64_t key = 0;  ///< state_key of its class
    Role role = Role::root;
    std::vector<Value> values;
    std::vector<StoredMemory> memories;
    std::optional<Elements> elements;
    std::vector<Part> parts;
};

}  // namespace glift::files
