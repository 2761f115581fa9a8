// Made by gliftc from composed.glift. Changes are lost when it is made again.
#pragma once

#include "composed.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// Translators in a chain: a transposed address, then a row-major one, in a buffer.

namespace composed {

#ifndef GLIFT_composed_HAS_Turned
#define GLIFT_composed_HAS_Turned
/// Turned, composed.glift:19.
class Turned : public glift::Structure<Turned, glift::uint2, float> {
public:
    static constexpr const char* type_name = "Turned";

    Turned() = default;
    Turned(const glift::Commands& commands, glift::uint2 extent);
    /// Makes the structure with the given memory.
    Turned(const glift::Commands& commands, glift::uint2 extent, glift::Memory data);

    glift::uint2 domain() const;
    glift::uint2 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    std::uint64_t data_extent() const { return data_extent_; }
    bool same_state(const Turned& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Turned>& range);
    std::uint64_t index_of(glift::uint2 address) const;
    const glift::Memory& index_memory() const { return data_; }
    void copy_out(const glift::Commands& commands, const glift::Range<Turned>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Turned>& range, const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint2>;
    static constexpr std::uint64_t state_key = 1730627862864790391u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.buffer("data", data_, data_extent_, float{});
    }

private:
    glift::uint2 extent_{};
    std::uint64_t data_extent_{};
    glift::Memory data_;
};
#endif

void copy(const glift::Commands& commands, const glift::Range<Turned>& f, const glift::Range<Turned>& g);

}  // namespace composed
