// Made by gliftc from fold.glift. Changes are lost when it is made again.
#pragma once

#include "fold.glift.types.hpp"

#include <glift/glift.h>
#include <glift/structure.h>

static_assert(GLIFT_VERSION_MAJOR == 0 && GLIFT_VERSION_MINOR == 1,
              "gliftc 0.1 made this, and the Glift headers found are of another version: "
              "run the gliftc that belongs to them, or compile with the headers and library of "
              "Glift 0.1");

/// A translator of one's own, and a structure over it, in an image.

namespace fold {

#ifndef GLIFT_fold_HAS_Field
#define GLIFT_fold_HAS_Field
/// Field, fold.glift:26.
class Field : public glift::Structure<Field, glift::uint3, float> {
public:
    static constexpr const char* type_name = "Field";

    Field() = default;
    Field(const glift::Commands& commands, glift::uint3 extent);
    /// Makes the structure with the given memory.
    Field(const glift::Commands& commands, glift::uint3 extent, glift::Memory data);

    glift::uint3 domain() const;
    glift::uint3 extent() const { return extent_; }
    const glift::Memory& data() const { return data_; }
    glift::uint2 data_extent() const { return data_extent_; }
    bool same_state(const Field& other) const;

    void fill(float value);
    void fill(float value, const glift::Range<Field>& range);
    void copy_out(const glift::Commands& commands, const glift::Range<Field>& range, const glift::Memory& box) const;
    void copy_in(const glift::Commands& commands, const glift::Range<Field>& range, const glift::Memory& box) const;

    template <class See> void describe(See&& see) const {
        see.value("extent", extent_);
        see.memory("data", data());
    }
    using Arguments = glift::Types<glift::uint3>;
    static constexpr std::uint64_t state_key = 12810457827268542214u;
    template <class Visit> void visit_state(Visit&& visit) {
        visit.argument("extent", extent_);
        visit.image("data", data_, data_extent_);
    }

private:
    glift::uint3 extent_{};
    glift::uint2 data_extent_{};
    glift::Memory data_;
};
#endif

void twice(const glift::Commands& commands, const glift::Range<Field>& f);

}  // namespace fold
