// What the transformations give that let an invocation of a shader take several elements.
#pragma once

#include "lower/context.h"

#include <array>
#include <vector>

namespace gliftc::lower {

/// A body for several elements an invocation, which tests itself which elements are in the range. If it has barriers,
/// all invocations of a workgroup must run it.
struct SeveralElements {
    std::vector<StmtId> body;
    std::vector<StmtId> host_body;  ///< for one element, on the host device; empty: the kernel's own is as good
    std::array<std::uint32_t, 3> elements = {1, 1, 1};  ///< of an invocation along each axis
    std::array<std::uint32_t, 3> group = {1, 1, 1};     ///< the workgroup's size
};

}  // namespace gliftc::lower
