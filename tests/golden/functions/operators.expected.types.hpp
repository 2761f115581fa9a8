// Made by gliftc from operators.glift. Changes are lost when it is made again.
#pragma once

#include <glift/vector.h>

#include <cstddef>
#include <optional>

namespace operators {

#ifndef GLIFT_operators_HAS_Max
#define GLIFT_operators_HAS_Max
struct Max {
    bool operator==(const Max&) const = default;
};
#endif

#ifndef GLIFT_operators_HAS_Affine
#define GLIFT_operators_HAS_Affine
struct Affine {
    glift::uint modulus{};
    Max inner{};
    bool operator==(const Affine&) const = default;
    template <class See> void describe(See&& see) const {
        see.value("modulus", modulus);
        see.value("inner", inner);
    }
};
#endif

}  // namespace operators
